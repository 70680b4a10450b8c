//! A raster of heights: ESRI ASCII grid and GeoTIFF.

use std::io::{self, Cursor, Write};

use hipline::observe::Grid;
use tiff::{
    TiffError,
    encoder::{TiffEncoder, colortype::Gray64Float},
    tags::Tag,
};

use super::number::Number;

/// Heights at the centres of a grid's cells.
#[derive(Debug, Clone, PartialEq)]
pub struct Heights {
    grid: Grid,
    values: Vec<Option<f64>>,
}

/// Why a raster cannot be written.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum HeightsError {
    /// The number of values is not that of the cells.
    #[error("{values} heights for {columns} columns and {rows} rows")]
    Count {
        /// How many heights there are.
        values: usize,
        /// The columns of the grid.
        columns: usize,
        /// The rows of the grid.
        rows: usize,
    },
    /// The TIFF encoder gave up.
    #[error("no TIFF can be made: {0}")]
    Tiff(String),
    /// The raster could not be written.
    #[error(transparent)]
    Io(#[from] io::Error),
}

impl From<TiffError> for HeightsError {
    fn from(error: TiffError) -> Self {
        match error {
            TiffError::IoError(error) => Self::Io(error),
            error => Self::Tiff(error.to_string()),
        }
    }
}

// The tags of the GeoTIFF standard (OGC 19-008) and of GDAL.
const MODEL_PIXEL_SCALE: Tag = Tag::Unknown(33550);
const MODEL_TIEPOINT: Tag = Tag::Unknown(33922);
const GEO_KEY_DIRECTORY: Tag = Tag::Unknown(34735);
const GDAL_NODATA: Tag = Tag::Unknown(42113);

impl Heights {
    /// Heights row by row from the south, each row from the west; `None` where there is none.
    ///
    /// # Errors
    /// There is not one value for each cell.
    pub fn new(grid: Grid, values: Vec<Option<f64>>) -> Result<Self, HeightsError> {
        let (columns, rows) = (grid.columns(), grid.rows());
        if values.len() == columns * rows {
            Ok(Self { grid, values })
        } else {
            Err(HeightsError::Count {
                values: values.len(),
                columns,
                rows,
            })
        }
    }

    /// Writes an ESRI ASCII grid. The numbers are the shortest decimals that are read back as the
    /// same f64; cells without a height have the value `NODATA_value`: -9999, or a power of ten
    /// less than -9999 that is no height.
    ///
    /// # Errors
    /// Those of `w`.
    pub fn ascii(&self, mut w: impl Write) -> io::Result<()> {
        let lowest = self.values.iter().flatten().copied();
        let lowest = lowest.fold(f64::INFINITY, f64::min);
        let mut nothing = -9999.0;
        while nothing >= lowest {
            nothing = (nothing - 1.0) * 10.0;
        }
        let [x, y] = self.grid.origin().map(Number);
        writeln!(w, "ncols {}", self.grid.columns())?;
        writeln!(w, "nrows {}", self.grid.rows())?;
        writeln!(w, "xllcorner {x}")?;
        writeln!(w, "yllcorner {y}")?;
        writeln!(w, "cellsize {}", Number(self.grid.cell()))?;
        writeln!(w, "NODATA_value {}", Number(nothing))?;
        for row in self.values.chunks(self.grid.columns()).rev() {
            for (i, value) in row.iter().enumerate() {
                let space = if i == 0 { "" } else { " " };
                write!(w, "{space}{}", Number(value.unwrap_or(nothing)))?;
            }
            writeln!(w)?;
        }
        Ok(())
    }

    /// Writes a GeoTIFF of one band of f64 without compression, rows from the north. Cells without
    /// a height are NaN, and the tag of GDAL says so. The coordinates are those of the input, in no
    /// named reference system.
    ///
    /// # Errors
    /// Those of `w`, and a raster beyond 4 GiB.
    pub fn geotiff(&self, mut w: impl Write) -> Result<(), HeightsError> {
        let mut buffer = Cursor::new(Vec::new());
        let side = |n: usize| u32::try_from(n).map_err(|e| HeightsError::Tiff(e.to_string()));
        let (columns, rows) = (side(self.grid.columns())?, side(self.grid.rows())?);
        let cell = self.grid.cell();
        let [x, y] = self.grid.origin();
        let top = f64::from(rows).mul_add(cell, y);
        let mut encoder = TiffEncoder::new(&mut buffer)?;
        let mut image = encoder.new_image::<Gray64Float>(columns, rows)?;
        let tags = image.encoder();
        tags.write_tag(MODEL_PIXEL_SCALE, &[cell, cell, 0.0][..])?;
        tags.write_tag(MODEL_TIEPOINT, &[0.0, 0.0, 0.0, x, top, 0.0][..])?;
        // Version 1.1.0 with two keys: the model is user-defined, a pixel is an area.
        let keys: [u16; 12] = [1, 1, 0, 2, 1024, 0, 1, 32767, 1025, 0, 1, 1];
        tags.write_tag(GEO_KEY_DIRECTORY, &keys[..])?;
        tags.write_tag(GDAL_NODATA, "nan")?;
        let rows = self.values.chunks(self.grid.columns()).rev();
        let values: Vec<f64> = rows
            .flatten()
            .map(|value| value.unwrap_or(f64::NAN))
            .collect();
        image.write_data(&values)?;
        w.write_all(&buffer.into_inner())?;
        Ok(())
    }
}
