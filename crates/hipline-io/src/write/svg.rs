//! Pictures as SVG: one group for each layer, every size relative to the whole.

use std::io::{self, Write};

use hipline::{
    Skeleton,
    skeleton::ArcKind,
    topology::{ArcId, EdgeId, FaceId, NodeId},
};

use super::{
    number::Rounded,
    palette,
    picture::Picture,
    window::{Window, is_same, place, trace},
};

/// The longer side of the canvas, in SVG units. Coordinates are printed to 1/1000 of one.
const CANVAS: f64 = 1000.0;

impl Picture<'_> {
    /// Draws the picture as SVG.
    ///
    /// The groups `faces`, `arcs` (with `ghost`, `crease`, `valley`, `ridge`), `offsets`, `input`,
    /// `nodes` and `labels` can be switched by their ids.
    ///
    /// # Errors
    /// Those of `w`.
    pub fn svg(&self, mut w: impl Write) -> io::Result<()> {
        let canvas = Canvas::new(self);
        let (width, height) = canvas.size();
        let (width, height) = (Rounded(width), Rounded(height));
        write!(
            w,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" "
        )?;
        writeln!(
            w,
            "width=\"{width}\" height=\"{height}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">"
        )?;
        writeln!(
            w,
            "<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>",
            palette::BACKGROUND
        )?;
        let layers = self.layers;
        if layers.faces {
            self.layer(
                &mut w,
                "faces",
                &format!("stroke-width=\"{}\"", Rounded(canvas.pen * 0.3)),
                |w, s| canvas.faces(w, s),
            )?;
        }
        if layers.arcs {
            writeln!(w, "<g id=\"arcs\">")?;
            for (kind, name, width, dash) in [
                (ArcKind::Ghost, "ghost", 0.6, Some(3.0)),
                (ArcKind::Crease, "crease", 0.8, None),
                (ArcKind::Valley, "valley", 1.0, None),
                (ArcKind::Ridge, "ridge", 1.0, None),
            ] {
                if kind == ArcKind::Ghost && !layers.ghosts {
                    continue;
                }
                let mut style = canvas.line_style(palette::arc(kind), width);
                if let Some(dash) = dash {
                    style += &format!(" stroke-dasharray=\"{0} {0}\"", Rounded(dash * canvas.pen));
                }
                self.layer(&mut w, name, &style, |w, s| canvas.arcs(w, s, kind))?;
            }
            writeln!(w, "</g>")?;
        }
        if !self.lines.is_empty() {
            writeln!(
                w,
                "<g id=\"offsets\" {}>",
                canvas.line_style(palette::OFFSET, 1.2)
            )?;
            for line in &self.lines {
                canvas.line(&mut w, &line.points, line.is_closed)?;
            }
            writeln!(w, "</g>")?;
        }
        if layers.input {
            let style = canvas.line_style(palette::INPUT, 1.8);
            self.layer(&mut w, "input", &style, |w, s| canvas.input(w, s))?;
        }
        if layers.nodes {
            let style = format!("fill=\"{}\"", palette::NODE);
            self.layer(&mut w, "nodes", &style, |w, s| canvas.nodes(w, s))?;
        }
        if layers.labels {
            let size = Rounded(canvas.pen * 7.0);
            let style = format!(
                "fill=\"{}\" font-family=\"sans-serif\" font-size=\"{size}\" text-anchor=\"middle\" dominant-baseline=\"central\"",
                palette::LABEL
            );
            self.layer(&mut w, "labels", &style, |w, s| canvas.labels(w, s))?;
        }
        writeln!(w, "</svg>")
    }

    fn layer<W: Write>(
        &self,
        w: &mut W,
        id: &str,
        style: &str,
        draw: impl Fn(&mut W, &Skeleton) -> io::Result<()>,
    ) -> io::Result<()> {
        writeln!(w, "<g id=\"{id}\" {style}>")?;
        for skeleton in &self.skeletons {
            draw(w, skeleton)?;
        }
        writeln!(w, "</g>")
    }
}

/// Where things come to lie, and how wide a usual stroke is.
struct Canvas {
    window: Window,
    scale: f64,
    pen: f64,
}

impl Canvas {
    fn new(picture: &Picture) -> Self {
        let window = picture.visible();
        // The more there is to see, the finer: four arcs get 2 units, fifty thousand 0.5.
        let arcs: usize = picture.skeletons.iter().map(|s| s.arcs().len()).sum();
        let pen = (7.5 / (arcs.max(1) as f64).powf(0.25)).clamp(0.3, 2.0);
        Self {
            window,
            scale: CANVAS / window.longest_side(),
            pen,
        }
    }

    fn size(&self) -> (f64, f64) {
        // A hair's breadth at least, so that no viewer divides by zero.
        (
            (self.window.width() * self.scale).max(1.0),
            (self.window.height() * self.scale).max(1.0),
        )
    }

    /// To the canvas, y down.
    fn at(&self, p: [f64; 2]) -> [Rounded; 2] {
        [
            Rounded((p[0] - self.window.min[0]) * self.scale),
            Rounded((self.window.max[1] - p[1]) * self.scale),
        ]
    }

    fn line_style(&self, colour: &str, width: f64) -> String {
        format!(
            "fill=\"none\" stroke=\"{colour}\" stroke-width=\"{}\"",
            Rounded(self.pen * width)
        )
    }

    /// The `M x y L x y ...` of a path.
    fn path(&self, w: &mut impl Write, points: &[[f64; 2]], close: bool) -> io::Result<()> {
        for (i, p) in points.iter().enumerate() {
            let [x, y] = self.at(*p);
            write!(w, "{}{x} {y}", if i == 0 { "M" } else { "L" })?;
        }
        w.write_all(if close { b"Z" } else { b"" })
    }

    fn faces(&self, w: &mut impl Write, skeleton: &Skeleton) -> io::Result<()> {
        for (i, face) in skeleton.faces().iter().enumerate() {
            let outline = self
                .window
                .clip_face(skeleton, skeleton.boundary(FaceId::new(i)));
            // Faces that stand upright are not seen from above.
            if outline.len() < 3 || trace(&outline).is_some() {
                continue;
            }
            // A stroke of the same colour closes the hairlines between neighbours.
            let colour = palette::hex(palette::hill_shade(palette::downhill(skeleton, face)));
            write!(
                w,
                "<path fill=\"{colour}\" stroke=\"{colour}\" fill-rule=\"evenodd\" d=\""
            )?;
            self.path(w, &outline, true)?;
            for hole in skeleton.holes(FaceId::new(i)) {
                let hole: Vec<_> = hole.iter().map(|&n| place(skeleton.node(n))).collect();
                self.path(w, &self.window.clip_polygon(&hole), true)?;
            }
            writeln!(w, "\"/>")?;
        }
        Ok(())
    }

    fn arcs(&self, w: &mut impl Write, skeleton: &Skeleton, kind: ArcKind) -> io::Result<()> {
        let mut is_open = false;
        for arc in skeleton.arcs().iter().filter(|a| a.kind == kind) {
            let ends = self.window.clip_arc(skeleton, arc);
            // An arc that stands upright is a node.
            if let Some(ends) = ends.map(flat).filter(|[p, q]| !is_same(*p, *q)) {
                self.piece(w, &mut is_open, &ends)?;
            }
        }
        close(w, is_open)
    }

    fn input(&self, w: &mut impl Write, skeleton: &Skeleton) -> io::Result<()> {
        let mut is_open = false;
        for i in 0..skeleton.input().edges.len() {
            for piece in self
                .window
                .clip_chain(&palette::ends(skeleton, EdgeId::new(i)))
            {
                self.piece(w, &mut is_open, &piece)?;
            }
        }
        close(w, is_open)
    }

    /// Adds to the path that is open, or opens one.
    fn piece(&self, w: &mut impl Write, is_open: &mut bool, points: &[[f64; 2]]) -> io::Result<()> {
        if !*is_open {
            w.write_all(b"<path d=\"")?;
            *is_open = true;
        }
        self.path(w, points, false)
    }

    fn line(&self, w: &mut impl Write, points: &[[f64; 2]], closed: bool) -> io::Result<()> {
        let is_whole = points.iter().all(|&p| self.window.contains(p));
        let mut points = points.to_vec();
        if closed && !is_whole {
            points.extend(points.first().copied());
        }
        let pieces = if is_whole {
            vec![points]
        } else {
            self.window.clip_chain(&points)
        };
        for piece in pieces.iter().filter(|p| !p.is_empty()) {
            w.write_all(b"<path d=\"")?;
            self.path(w, piece, closed && is_whole)?;
            writeln!(w, "\"/>")?;
        }
        Ok(())
    }

    fn nodes(&self, w: &mut impl Write, skeleton: &Skeleton) -> io::Result<()> {
        let vertices = skeleton.input().vertices;
        for (i, node) in skeleton.nodes().iter().enumerate() {
            if node.time.is_finite() && self.window.contains(place(node)) {
                let [x, y] = self.at(place(node));
                let radius = Rounded(self.pen * if i < vertices { 1.6 } else { 1.2 });
                writeln!(w, "<circle cx=\"{x}\" cy=\"{y}\" r=\"{radius}\"/>")?;
            }
        }
        Ok(())
    }

    fn labels(&self, w: &mut impl Write, skeleton: &Skeleton) -> io::Result<()> {
        let mut label = |p: [f64; 2], text: String| {
            let [x, y] = self.at(p);
            writeln!(w, "<text x=\"{x}\" y=\"{y}\">{text}</text>")
        };
        // Beside the node, not on it.
        let beside = self.pen * 6.0 / self.scale;
        for (i, node) in skeleton.nodes().iter().enumerate() {
            let [x, y] = place(node);
            if node.time.is_finite() && self.window.contains([x, y]) {
                label([x + beside, y + beside], NodeId::new(i).to_string())?;
            }
        }
        for (i, arc) in skeleton.arcs().iter().enumerate() {
            if let Some([p, q]) = self.window.clip_arc(skeleton, arc) {
                label(
                    [f64::midpoint(p[0], q[0]), f64::midpoint(p[1], q[1])],
                    ArcId::new(i).to_string(),
                )?;
            }
        }
        for i in 0..skeleton.input().edges.len() {
            if let [piece, ..] = self
                .window
                .clip_chain(&palette::ends(skeleton, EdgeId::new(i)))
                .as_slice()
            {
                let [p, q] = [piece[0], piece[piece.len() - 1]];
                label(
                    [f64::midpoint(p[0], q[0]), f64::midpoint(p[1], q[1])],
                    EdgeId::new(i).to_string(),
                )?;
            }
        }
        for i in 0..skeleton.faces().len() {
            let outline = self
                .window
                .clip_face(skeleton, skeleton.boundary(FaceId::new(i)));
            if !outline.is_empty() {
                let sum = outline
                    .iter()
                    .fold([0.0, 0.0], |s, p| [s[0] + p[0], s[1] + p[1]]);
                label(
                    sum.map(|c| c / outline.len() as f64),
                    FaceId::new(i).to_string(),
                )?;
            }
        }
        Ok(())
    }
}

fn flat(ends: [[f64; 3]; 2]) -> [[f64; 2]; 2] {
    ends.map(|[x, y, _]| [x, y])
}

fn close(w: &mut impl Write, is_open: bool) -> io::Result<()> {
    if is_open { writeln!(w, "\"/>") } else { Ok(()) }
}
