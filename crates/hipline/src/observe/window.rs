//! An axis-parallel rectangle.

/// A part of the plane to look at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    min: [f64; 2],
    max: [f64; 2],
}

/// Why a rectangle is no window.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum InvalidWindow {
    /// A coordinate is infinite or no number, or the difference of two overflows.
    #[error("the window from ({0}, {1}) to ({2}, {3}) is not finite")]
    NotFinite(f64, f64, f64, f64),
    /// It has no area.
    #[error(
        "the window from ({0}, {1}) to ({2}, {3}) has no area: give the lower left corner first"
    )]
    Empty(f64, f64, f64, f64),
    /// The skeleton covers nothing of it.
    #[error("the window from ({0}, {1}) to ({2}, {3}) misses the data")]
    MissesData(f64, f64, f64, f64),
    /// The rounded corners of a face bound no area that could be cut into triangles.
    #[error("rounding to 64 bits leaves no area of a face")]
    Rounding,
}

impl Window {
    /// The rectangle with a lower left and an upper right corner, in input units.
    ///
    /// # Errors
    /// The corners are not finite, or no area lies between them.
    pub fn new([x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> Result<Self, InvalidWindow> {
        let [width, height] = [x1 - x0, y1 - y0];
        if !(width.is_finite() && height.is_finite()) {
            Err(InvalidWindow::NotFinite(x0, y0, x1, y1))
        } else if width > 0.0 && height > 0.0 {
            Ok(Self {
                min: [x0, y0],
                max: [x1, y1],
            })
        } else {
            Err(InvalidWindow::Empty(x0, y0, x1, y1))
        }
    }

    /// The smallest window around points with a margin on each side, a fraction of the longer
    /// side; `None` around nothing, or if that is not finite or has no area.
    pub fn around(points: impl IntoIterator<Item = [f64; 2]>, margin: f64) -> Option<Self> {
        let mut points = points.into_iter();
        let first = points.next()?;
        let [min, max] = points.fold([first, first], |[min, max], p| {
            [
                [min[0].min(p[0]), min[1].min(p[1])],
                [max[0].max(p[0]), max[1].max(p[1])],
            ]
        });
        let margin = (max[0] - min[0]).max(max[1] - min[1]) * margin;
        Self::new(min.map(|c| c - margin), max.map(|c| c + margin)).ok()
    }

    /// The lower left corner.
    #[must_use]
    pub const fn min(&self) -> [f64; 2] {
        self.min
    }

    /// The upper right corner.
    #[must_use]
    pub const fn max(&self) -> [f64; 2] {
        self.max
    }

    /// The lengths of the sides.
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        [self.max[0] - self.min[0], self.max[1] - self.min[1]]
    }

    /// The area, in square input units.
    #[must_use]
    pub fn area(&self) -> f64 {
        let [width, height] = self.size();
        width * height
    }

    /// Whether a point is inside or on the border.
    #[must_use]
    pub fn contains(&self, p: [f64; 2]) -> bool {
        (0..2).all(|i| self.min[i] <= p[i] && p[i] <= self.max[i])
    }

    /// The corners, counterclockwise from the lower left one.
    #[must_use]
    pub const fn corners(&self) -> [[f64; 2]; 4] {
        let ([x0, y0], [x1, y1]) = (self.min, self.max);
        [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
    }

    /// That there is nothing in it.
    pub(super) const fn missed(&self) -> InvalidWindow {
        let ([x0, y0], [x1, y1]) = (self.min, self.max);
        InvalidWindow::MissesData(x0, y0, x1, y1)
    }

    /// The part of a segment inside: parameters from its start, between 0 and 1 (Liang and
    /// Barsky).
    pub(super) fn inside(&self, p: [f64; 2], q: [f64; 2]) -> Option<[f64; 2]> {
        let [mut first, mut last] = [0.0_f64, 1.0_f64];
        for i in 0..2 {
            let d = q[i] - p[i];
            if d == 0.0 {
                if p[i] < self.min[i] || p[i] > self.max[i] {
                    return None;
                }
            } else {
                let [s, t] = [(self.min[i] - p[i]) / d, (self.max[i] - p[i]) / d];
                first = first.max(s.min(t));
                last = last.min(s.max(t));
            }
        }
        (first <= last).then_some([first, last])
    }
}
