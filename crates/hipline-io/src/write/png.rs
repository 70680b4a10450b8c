//! Pictures as PNG: the SVG, rasterised by resvg.

use std::io::{self, Write};

use resvg::{tiny_skia, usvg};

use super::picture::Picture;

/// The longer side of a picture, in pixels, unless another is asked for.
pub const DEFAULT_SIZE: u32 = 1600;

/// The largest side: such a picture takes 1 GiB.
pub(super) const LARGEST: u32 = 1 << 14;

/// Why there is no PNG.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The size is 0 or too large.
    #[error("a picture has between 1 and {LARGEST} pixels to a side, not {0}")]
    Size(u32),
    /// The rasteriser or the compressor failed.
    #[error("the picture cannot be made: {0}")]
    Raster(String),
    /// The picture could not be written.
    #[error(transparent)]
    Io(#[from] io::Error),
}

impl Picture<'_> {
    /// Draws the picture as PNG whose longer side has `size` pixels. Labels are left out.
    ///
    /// # Errors
    /// A size of 0 or beyond 16384, and the errors of `w`.
    pub fn png(&self, w: impl Write, size: u32) -> Result<(), PictureError> {
        let mut svg = Vec::new();
        self.svg(&mut svg)?;
        rasterise(&svg, w, size)
    }
}

/// Draws an SVG as PNG whose longer side has `size` pixels.
pub(super) fn rasterise(svg: &[u8], mut w: impl Write, size: u32) -> Result<(), PictureError> {
    if !(1..=LARGEST).contains(&size) {
        return Err(PictureError::Size(size));
    }
    let tree = usvg::Tree::from_data(svg, &usvg::Options::default()).map_err(raster)?;
    let scale = size as f32 / tree.size().width().max(tree.size().height());
    let [width, height] =
        [tree.size().width(), tree.size().height()].map(|s| ((s * scale).round() as u32).max(1));
    let mut pixels = tiny_skia::Pixmap::new(width, height).ok_or(PictureError::Size(size))?;
    resvg::render(
        &tree,
        tiny_skia::Transform::from_scale(scale, scale),
        &mut pixels.as_mut(),
    );
    w.write_all(&pixels.encode_png().map_err(raster)?)?;
    Ok(())
}

pub(super) fn raster(e: impl std::fmt::Display) -> PictureError {
    PictureError::Raster(e.to_string())
}
