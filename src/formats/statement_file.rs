//! The one writer of statement files: what a statement says, spelled as TOML.

use std::fmt::Write as _;

use itertools::Itertools;

use crate::statement::Convention;

/// How the rows of a net are laid out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// A line for each row.
    Rows,
    /// A line for each control point.
    Points,
    /// Likewise, the coordinates below one another.
    Columns,
}

/// What the equations are of.
#[derive(Debug, Clone)]
pub enum DraftSubject {
    /// A patch and its surface.
    Patch {
        /// How the four numbers of a control point are meant.
        convention: Convention,
        /// The surface; without one it is the unit sphere.
        surface: Option<String>,
        /// Four expressions for each control point: `net[i][j]` belongs to Bᵢᵐ(u)·Bⱼⁿ(v).
        net: Vec<Vec<[String; 4]>>,
        /// How the net is laid out.
        layout: Layout,
    },
    /// Polynomials that are to vanish.
    System(Vec<String>),
}

/// A statement before it is a file. Nothing in it is checked: reading the file does that.
#[derive(Debug, Clone)]
pub struct Draft {
    /// Lines of a comment above it.
    pub remark: Vec<String>,
    /// The title.
    pub title: String,
    /// The radicands of K.
    pub radicands: Vec<u32>,
    /// The unknowns.
    pub unknowns: Vec<String>,
    /// What is assumed not to vanish.
    pub nonzero: Vec<String>,
    /// The patch or the system.
    pub subject: DraftSubject,
    /// Abbreviations: names and what they stand for.
    pub define: Vec<(String, String)>,
}

impl Draft {
    /// The text of the file.
    pub fn text(&self) -> String {
        let mut text = String::new();
        for line in &self.remark {
            let _ = writeln!(text, "# {line}");
        }
        let _ = writeln!(text, "title = {}", quoted(&self.title));
        let _ = writeln!(text, "radicands = {:?}", self.radicands);
        let _ = writeln!(text, "unknowns = {}", list(&self.unknowns));
        if !self.nonzero.is_empty() {
            let _ = writeln!(text, "nonzero = {}", list(&self.nonzero));
        }
        match &self.subject {
            DraftSubject::Patch { convention, surface, net, layout } => {
                let _ = writeln!(text, "convention = {}", quoted(convention.word()));
                let columns = net.first().map_or(0, Vec::len);
                let _ = writeln!(
                    text,
                    "bidegree = [{}, {}]",
                    net.len().saturating_sub(1),
                    columns.saturating_sub(1)
                );
                if let Some(surface) = surface {
                    let _ = writeln!(text, "surface = {}", quoted(surface));
                }
                if *layout != Layout::Rows {
                    text.push('\n');
                }
                text += &net_text(net, *layout);
            }
            DraftSubject::System(polynomials) => {
                let line = |polynomial: &String| format!("  {},\n", quoted(polynomial));
                let _ = writeln!(text, "polynomials = [\n{}]", polynomials.iter().map(line).join(""));
            }
        }
        if !self.define.is_empty() {
            let line = |(name, value): &(String, String)| format!("{name} = {}\n", quoted(value));
            let _ = write!(text, "\n[define]\n{}", self.define.iter().map(line).join(""));
        }
        text
    }
}

fn net_text(net: &[Vec<[String; 4]>], layout: Layout) -> String {
    let longest = |k: usize| net.iter().flatten().map(|point| point[k].len()).max().unwrap_or(0);
    let widths: [usize; 4] = std::array::from_fn(|k| if layout == Layout::Columns { longest(k) } else { 0 });
    let point = |point: &[String; 4]| {
        let entries = point.iter().zip(widths).enumerate().map(|(k, (entry, width))| {
            let comma = if k < 3 { "," } else { "" };
            // Padding stands outside the quotes.
            format!("{}{comma}{}", quoted(entry), " ".repeat(width.saturating_sub(entry.len())))
        });
        format!("[{}]", entries.collect_vec().join(" ").trim_end())
    };
    let row = |points: &Vec<[String; 4]>| match layout {
        Layout::Rows => format!("  [{}],\n", points.iter().map(point).join(", ")),
        _ => format!("  [\n    {},\n  ],\n", points.iter().map(point).join(",\n    ")),
    };
    format!("net = [\n{}]\n", net.iter().map(row).join(""))
}

/// A basic string of TOML: quotes and backslashes escaped, control characters left out.
fn quoted(text: &str) -> String {
    let printable: String = text.chars().filter(|c| !c.is_control()).collect();
    format!("\"{}\"", printable.replace('\\', "\\\\").replace('"', "\\\""))
}

fn list(items: &[String]) -> String {
    format!("[{}]", items.iter().map(|item| quoted(item)).join(", "))
}
