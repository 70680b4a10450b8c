//! One plane with everything in a file: what terrain, rain and queries are computed from.

use hipline::{
    Figure, Skeleton,
    observe::Window,
    skeleton::Side,
    topology::{EdgeId, FaceId},
};
use hipline_io::write::HeightsError;

use crate::{
    args::{ComputeArgs, Corners, PlaneArgs, SideArg},
    compute::{Computed, Watch, each, empty, skeleton},
    failure::Failure,
    input::{self, Input, Item},
};

/// The free border of a window, as a part of the longer side of what it is around.
const MARGIN: f64 = 0.05;

/// A plane with its skeleton.
pub struct Scene {
    pub document: Input,
    pub figure: Figure,
    pub computed: Vec<Computed>,
    pub watch: Watch,
}

impl Scene {
    /// Reads and computes what was asked for. Heights of vertices are those of a surface with the
    /// given slope.
    pub fn load(args: &PlaneArgs, compute: &ComputeArgs, slope: f64) -> Result<Self, Failure> {
        let mut watch = Watch::start();
        let mut document = input::document(&args.input())?;
        document.document.divide_heights(slope);
        watch.lap("read");
        let mut computed = each(&[Item::Together(&document)], |item, figure| {
            let Some(figure) = figure else {
                return Ok(empty(compute.region()));
            };
            let mut compute = *compute;
            // Where there are lines beside polygons, none of them is left out.
            if compute.side.is_none() && figure.edges().iter().any(|edge| !edge.on_ring) {
                compute.side = Some(SideArg::Both);
            }
            skeleton(item, figure, compute)
        });
        watch.lap("compute");
        let one = computed.first_mut();
        let figure = one.and_then(|c| c.figure.take());
        if let Some(Err(error)) = computed.first().map(|c| &c.result) {
            return Err(Failure::Input(error.clone()));
        }
        let Some(figure) = figure else {
            let name = input::name(&args.path);
            return Err(Failure::Input(format!("{name}: there is nothing in it")));
        };
        Ok(Self {
            document,
            figure,
            computed,
            watch,
        })
    }

    pub fn skeleton(&self) -> &Skeleton {
        let result = self.computed.first().map(|c| &c.result);
        match result {
            Some(Ok(skeleton)) => skeleton,
            _ => unreachable!("a scene has been computed"),
        }
    }

    /// The window that was asked for, or one around the input.
    pub fn window(&self, corners: Option<Corners>) -> Result<Window, Failure> {
        match corners {
            Some(Corners([x0, y0, x1, y1])) => {
                Window::new([x0, y0], [x1, y1]).map_err(|e| Failure::Input(e.to_string()))
            }
            None => {
                Window::around(self.figure.vertices().iter().copied(), MARGIN).ok_or_else(|| {
                    Failure::Input("the input is too large for a window around it".to_owned())
                })
            }
        }
    }

    /// For each part of the figure, the number of its feature.
    pub fn features(&self) -> Vec<usize> {
        let mut of_parts = Vec::new();
        for feature in &self.document.features {
            let mut builder = hipline::FigureBuilder::new();
            let parts = feature.case.add_to(&mut builder);
            of_parts.extend(std::iter::repeat_n(feature.index, parts));
        }
        of_parts
    }

    /// The edge of a face.
    pub fn edge(&self, face: FaceId) -> EdgeId {
        self.skeleton().face(face).edge
    }

    /// Prints what was done, if that was asked for.
    pub fn finish(mut self, stats: bool) {
        self.watch.lap("write");
        if stats {
            self.watch.print_stats(&self.computed);
        }
    }
}

/// How tables call a side of an edge.
pub const fn side(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
        Side::Start => "start",
        Side::End => "end",
    }
}

/// A raster's error as one of its file.
pub fn raster_error(error: HeightsError) -> std::io::Error {
    match error {
        HeightsError::Io(error) => error,
        error => std::io::Error::other(error.to_string()),
    }
}
