//! A drawing as SVG text.

use std::fmt::Write as _;

/// Where a text is fixed.
#[derive(Debug, Clone, Copy)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// Width and height of all pictures.
pub(super) const SIZE: (f64, f64) = (900.0, 720.0);

/// Elements, in the order in which they are painted.
#[derive(Debug, Default)]
pub(super) struct Canvas {
    elements: String,
}

impl Canvas {
    pub(super) fn polygon(&mut self, points: &[(f64, f64)], fill: &str, stroke: &str, width: f64) {
        let list = spelled(points);
        let _ = writeln!(
            self.elements,
            "<polygon points=\"{list}\" fill=\"{fill}\" stroke=\"{stroke}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"/>"
        );
    }

    pub(super) fn polyline(&mut self, points: &[(f64, f64)], stroke: &str, width: f64) {
        let list = spelled(points);
        let _ = writeln!(
            self.elements,
            "<polyline points=\"{list}\" fill=\"none\" stroke=\"{stroke}\" stroke-width=\"{width}\"/>"
        );
    }

    pub(super) fn rectangle(&mut self, (x, y): (f64, f64), (width, height): (f64, f64), fill: &str) {
        let _ = writeln!(
            self.elements,
            "<rect x=\"{x:.2}\" y=\"{y:.2}\" width=\"{width:.2}\" height=\"{height:.2}\" fill=\"{fill}\" shape-rendering=\"crispEdges\"/>"
        );
    }

    pub(super) fn circle(&mut self, (x, y): (f64, f64), radius: f64, fill: &str, stroke: &str) {
        let _ = writeln!(
            self.elements,
            "<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\" fill=\"{fill}\" stroke=\"{stroke}\" stroke-width=\"1.5\"/>"
        );
    }

    pub(super) fn text(
        &mut self,
        (x, y): (f64, f64),
        size: f64,
        anchor: Anchor,
        turned: bool,
        content: &str,
    ) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let turn = if turned { format!(" transform=\"rotate(-90 {x:.2} {y:.2})\"") } else { String::new() };
        let content = content.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        let _ = writeln!(
            self.elements,
            "<text x=\"{x:.2}\" y=\"{y:.2}\" font-family=\"DejaVu Sans, sans-serif\" font-size=\"{size}\" text-anchor=\"{anchor}\"{turn}>{content}</text>"
        );
    }

    /// ▲ for a maximum, ▼ for a minimum, white with a black edge.
    pub(super) fn marker(&mut self, (x, y): (f64, f64), maximum: bool) {
        let up = if maximum { -1.0 } else { 1.0 };
        let points = [(x, y + 8.0 * up), (x - 7.0, y - 5.0 * up), (x + 7.0, y - 5.0 * up)];
        self.polygon(&points, "white", "black", 1.8);
    }

    /// The whole picture.
    pub(super) fn svg(&self, title: &str) -> String {
        let (width, height) = SIZE;
        let title = title.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;");
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\">\n\
             <title>{title}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"white\"/>\n{}</svg>\n",
            self.elements
        )
    }
}

fn spelled(points: &[(f64, f64)]) -> String {
    points.iter().map(|(x, y)| format!("{x:.2},{y:.2}")).collect::<Vec<_>>().join(" ")
}
