//! The shapes of the pictures. Text and lines have the colours of the surrounding page.

use std::fmt::Write as _;

/// Ink of text and axes, and of the grid.
pub const INK: &str = "#1d2126";
/// Fine lines.
pub const GRID: &str = "#dcded9";

/// A picture under construction.
pub struct Svg {
    width: f64,
    height: f64,
    body: String,
}

/// The anchor of a text.
#[derive(Debug, Clone, Copy)]
pub enum Anchor {
    /// At its start.
    Start,
    /// In its middle.
    Middle,
    /// At its end.
    End,
}

/// The shape of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Marker {
    /// ●
    Disk,
    /// ○
    Ring,
    /// ■
    Square,
    /// □
    Frame,
    /// ▲
    Triangle,
    /// ▽
    Funnel,
    /// ◆
    Diamond,
    /// ×
    Cross,
    /// +
    Plus,
}

impl Svg {
    /// An empty picture, px.
    pub fn new(width: f64, height: f64) -> Self {
        Svg {
            width,
            height,
            body: String::new(),
        }
    }

    /// The finished document.
    pub fn finish(self, title: &str) -> String {
        let Svg {
            width,
            height,
            body,
        } = self;
        format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
             font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\" role=\"img\">\n<title>{}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n{body}</svg>\n",
            escape(title)
        )
    }

    /// A rectangle with its upper left corner.
    pub fn rect(&mut self, [x, y]: [f64; 2], [w, h]: [f64; 2], fill: &str) {
        self.push(format_args!(
            "<rect x=\"{x:.1}\" y=\"{y:.1}\" width=\"{w:.1}\" height=\"{h:.1}\" fill=\"{fill}\"/>"
        ));
    }

    /// A straight line.
    pub fn line(&mut self, [a, b]: [f64; 2], [c, d]: [f64; 2], colour: &str, width: f64) {
        self.push(format_args!(
            "<path d=\"M{a:.1} {b:.1}L{c:.1} {d:.1}\" stroke=\"{colour}\" stroke-width=\"{width}\" fill=\"none\"/>"
        ));
    }

    /// A line through points, dashed as SVG says it (`""` for not at all).
    pub fn path(&mut self, points: &[[f64; 2]], colour: &str, width: f64, dash: &str) {
        let mut d = String::new();
        for (i, [x, y]) in points.iter().enumerate() {
            let _ = write!(d, "{}{x:.1} {y:.1}", if i == 0 { 'M' } else { 'L' });
        }
        self.push(format_args!(
            "<path d=\"{d}\" stroke=\"{colour}\" stroke-width=\"{width}\" stroke-dasharray=\"{dash}\" fill=\"none\" \
             stroke-linejoin=\"round\"/>"
        ));
    }

    /// A text on its base line.
    pub fn text(&mut self, [x, y]: [f64; 2], size: f64, anchor: Anchor, colour: &str, text: &str) {
        let anchor = anchor.name();
        let text = escape(text);
        self.push(format_args!(
            "<text x=\"{x:.1}\" y=\"{y:.1}\" font-size=\"{size}\" text-anchor=\"{anchor}\" fill=\"{colour}\">{text}</text>"
        ));
    }

    /// A vertical text, read upwards, centred at its position.
    pub fn upright(&mut self, [x, y]: [f64; 2], size: f64, text: &str) {
        let text = escape(text);
        self.push(format_args!(
            "<text transform=\"translate({x:.1} {y:.1}) rotate(-90)\" font-size=\"{size}\" text-anchor=\"middle\" \
             fill=\"{INK}\">{text}</text>"
        ));
    }

    /// A point.
    pub fn marker(&mut self, marker: Marker, [x, y]: [f64; 2], colour: &str) {
        let r = 4.5;
        let polygon = |corners: &[[f64; 2]]| {
            let corners = corners
                .iter()
                .map(|[a, b]| format!("{:.1} {:.1}", x + r * a, y + r * b));
            format!("M{}Z", corners.collect::<Vec<_>>().join("L"))
        };
        let filled = !matches!(marker, Marker::Ring | Marker::Frame | Marker::Funnel);
        let d = match marker {
            Marker::Disk | Marker::Ring => {
                format!("M{:.1} {y:.1}a{r} {r} 0 1 0 9 0a{r} {r} 0 1 0 -9 0Z", x - r)
            }
            Marker::Square | Marker::Frame => {
                polygon(&[[-0.9, -0.9], [0.9, -0.9], [0.9, 0.9], [-0.9, 0.9]])
            }
            Marker::Triangle => polygon(&[[0.0, -1.15], [1.1, 0.85], [-1.1, 0.85]]),
            Marker::Funnel => polygon(&[[0.0, 1.15], [1.1, -0.85], [-1.1, -0.85]]),
            Marker::Diamond => polygon(&[[0.0, -1.25], [1.1, 0.0], [0.0, 1.25], [-1.1, 0.0]]),
            Marker::Cross => format!("M{:.1} {:.1}l8 8m0 -8l-8 8", x - 4.0, y - 4.0),
            Marker::Plus => format!("M{:.1} {y:.1}h10m-5 -5v10", x - 5.0),
        };
        let fill = if filled { colour } else { "#fff" };
        self.push(format_args!(
            "<path d=\"{d}\" fill=\"{fill}\" stroke=\"{colour}\" stroke-width=\"1.8\"/>"
        ));
    }

    fn push(&mut self, shape: std::fmt::Arguments) {
        // Writing to a String cannot fail.
        let _ = self.body.write_fmt(shape);
        self.body.push('\n');
    }
}

impl Anchor {
    fn name(self) -> &'static str {
        match self {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        }
    }
}

/// Text inside a document of tags.
pub fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}
