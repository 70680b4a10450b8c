//! What is to be drawn; how is for [`svg`](super::svg) and [`png`](super::png).

use hipline::Skeleton;

use super::window::{Window, place};

/// An offset line or another chain of points to draw or write.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OffsetLine {
    /// How far from the input, in units of time.
    pub distance: f64,
    /// Its points; if it is closed, the last does not repeat the first.
    pub points: Vec<[f64; 2]>,
    /// Whether the last point is joined to the first.
    pub is_closed: bool,
}

/// Which layers to draw. By default all but the labels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layers {
    /// The faces, filled, in hill-shade.
    pub faces: bool,
    /// The arcs, coloured by kind.
    pub arcs: bool,
    /// Also the ghost arcs.
    pub ghosts: bool,
    /// The input edges.
    pub input: bool,
    /// The nodes.
    pub nodes: bool,
    /// The ids of nodes, arcs, faces and edges. They are text, which PNG pictures lack.
    pub labels: bool,
}

impl Default for Layers {
    fn default() -> Self {
        Self {
            faces: true,
            arcs: true,
            ghosts: true,
            input: true,
            nodes: true,
            labels: false,
        }
    }
}

/// A picture of skeletons and lines, seen from above, y upwards.
///
/// ```
/// use hipline_io::write::{OffsetLine, Picture};
///
/// let mut picture = Picture::new();
/// picture.line(OffsetLine { distance: 1.0, points: vec![[0.0, 0.0], [4.0, 3.0]], is_closed: false });
/// let mut svg = Vec::new();
/// picture.svg(&mut svg)?;
/// assert!(svg.starts_with(b"<svg "));
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Picture<'a> {
    pub(super) skeletons: Vec<&'a Skeleton>,
    pub(super) lines: Vec<OffsetLine>,
    pub(super) window: Option<Window>,
    pub(super) layers: Layers,
}

impl<'a> Picture<'a> {
    /// An empty picture.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Draws a skeleton.
    pub fn skeleton(&mut self, skeleton: &'a Skeleton) -> &mut Self {
        self.skeletons.push(skeleton);
        self
    }

    /// Draws an offset line over the skeletons.
    pub fn line(&mut self, line: OffsetLine) -> &mut Self {
        self.lines.push(line);
        self
    }

    /// Shows this part of the plane. By default everything finite is seen, with a margin;
    /// but nodes very far from the input do not shrink it to a dot.
    pub const fn window(&mut self, window: Window) -> &mut Self {
        self.window = Some(window);
        self
    }

    /// Draws these layers.
    pub const fn layers(&mut self, layers: Layers) -> &mut Self {
        self.layers = layers;
        self
    }

    /// The part of the plane to show; a unit square if there is nothing.
    pub(super) fn visible(&self) -> Window {
        let lines = Window::around(self.lines.iter().flat_map(|l| l.points.iter().copied()));
        let skeletons = self
            .skeletons
            .iter()
            .filter_map(|s| Self::fitted(s))
            .reduce(Window::union);
        let all = match (skeletons, lines) {
            (Some(a), Some(b)) => Some(a.union(b)),
            (a, b) => a.or(b),
        };
        let window = self.window.or_else(|| all.map(|w| w.enlarged(0.04)));
        match window {
            // A window without a breadth shows nothing; one beyond f64 cannot be scaled.
            Some(w) if w.longest_side().is_finite() && w.width() > 0.0 && w.height() > 0.0 => w,
            Some(w) if w.longest_side().is_finite() => w.enlarged(0.5),
            _ => Window {
                min: [0.0, 0.0],
                max: [1.0, 1.0],
            },
        }
    }

    /// The window around a skeleton without its margin.
    fn fitted(skeleton: &Skeleton) -> Option<Window> {
        // Wavefronts that leave a figure can meet again very far away. The input should take
        // half of the side at least, or there is nothing to see of it.
        const FARTHEST: f64 = 0.35;
        let input = Window::around(
            skeleton
                .nodes()
                .iter()
                .take(skeleton.input().vertices)
                .map(place),
        )?;
        let has_infinite = skeleton.nodes().iter().any(|n| n.time.is_infinite());
        let near = input.enlarged(FARTHEST);
        let seen = skeleton
            .nodes()
            .iter()
            .filter(|n| n.time.is_finite())
            .map(place)
            .filter(|p| near.contains(*p));
        let window = Window::around(seen)?.union(input);
        Some(if has_infinite {
            window.enlarged(0.08)
        } else {
            window
        })
    }
}
