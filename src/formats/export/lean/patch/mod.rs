//! A patch on a surface: the definitions, the equations `c[r,s]` from them, and the theorem.
//!
//! With the rows of the net as curves in v, a point of the patch is a point of a curve in u whose control values are points of these.
//! `F_r` is the coefficient of pʳq^(M−r) in the surface along *any* curve, `G_r` what it is for the rows: polynomials in v,
//! whose coefficients are `c[r,s]`. So `ring` never has to expand the whole patch at once.

mod exact;
mod impossible;

use std::fmt::Write;

use super::super::case::{Case, ExportError, Reasoning};
use super::super::flat::lift;
use super::argument::assumptions;
use super::forms::Forms;
use super::names::{Names, reals, spaced};
use super::vanish;
use crate::statement::{COORDINATES, Patch};

const SQUARE: &str = "∀ u v : ℝ, 0 ≤ u → u ≤ 1 → 0 ≤ v → v ≤ 1 →";

pub(super) fn write(case: &Case, names: &Names, patch: &Patch) -> Result<String, ExportError> {
    let writer = Writer::new(case, names, patch)?;
    let mut text = writer.definitions()?;
    if let Reasoning::Impossible(_) = case.argument {
        text += &assumptions(case, names)?;
    }
    text += &writer.along_u();
    text += &match &case.argument {
        Reasoning::Impossible(_) => writer.impossible()?,
        Reasoning::Exact(_) => writer.exact()?,
    };
    Ok(text)
}

struct Writer<'a> {
    case: &'a Case,
    names: &'a Names,
    patch: &'a Patch,
    forms: Forms,
    /// The roots that the surface contains, among the arguments of what is defined from it.
    surface_roots: Vec<usize>,
}

impl<'a> Writer<'a> {
    fn new(case: &'a Case, names: &'a Names, patch: &'a Patch) -> Result<Self, ExportError> {
        let surface_roots =
            (0..names.roots.len()).filter(|bit| patch.surface.mask() >> bit & 1 == 1).collect();
        Ok(Writer { case, names, patch, forms: Forms::new(case, patch)?, surface_roots })
    }

    /// The surface, the net and the coordinates of a point: what the theorem is about.
    fn definitions(&self) -> Result<String, ExportError> {
        let (m, n) = self.patch.bidegree;
        let mut text = format!(
            "/-- The surface is where this vanishes. -/\ndef surface{} : ℝ := {}\n\n",
            reals(&(self.roots_of_surface() + " X Y Z W")),
            self.names.spell(&self.forms.surface)
        );
        for degree in if m == n { vec![m] } else { vec![m, n] } {
            let _ = writeln!(
                text,
                "/-- A curve of degree {degree} in the Bernstein basis, for p and q = 1 - p. -/\n\
                 def curve{degree}{} : ℝ := {}\n",
                reals(&(values(&["a"], degree) + " p q")),
                self.names.spell(&self.forms.curve(0, degree)?)
            );
        }
        let arguments = self.names.arguments();
        for (k, coordinate) in COORDINATES.iter().enumerate() {
            let _ =
                writeln!(text, "/-! The rows of the net, {coordinate}: one line for each i, along v. -/\n");
            for (i, row) in self.patch.net.iter().enumerate() {
                let mut entries = String::new();
                for point in row {
                    entries += &format!(" ({})", self.names.spell(&lift(self.case, &point[k])?));
                }
                let parameters = reals(&format!("{arguments} p q"));
                let _ = writeln!(text, "def {coordinate}{i}{parameters} : ℝ := curve{n}{entries} p q\n");
            }
            let rows = (0..=m).map(|i| format!("({coordinate}{i}{arguments} v (1 - v))"));
            let _ = writeln!(
                text,
                "def {coordinate}{} : ℝ := curve{m}{} u (1 - u)\n",
                reals(&format!("{arguments} u v")),
                spaced(rows)
            );
        }
        Ok(text)
    }

    /// The surface along a curve, then along the curves u of the patch.
    fn along_u(&self) -> String {
        let (m, _) = self.patch.bidegree;
        let (roots, arguments) = (self.roots_of_surface(), self.names.arguments());
        let all = values(&["a", "b", "c", "d"], m);
        let mut text = String::from("/-! The coefficients of the surface along any curve. -/\n\n");
        for (r, form) in self.forms.along_curve.iter().enumerate() {
            let parameters = reals(&(roots.clone() + &all));
            let _ = writeln!(text, "def F{r}{parameters} : ℝ := {}\n", self.names.spell(form));
        }
        let count = self.forms.along_curve.len();
        let each =
            |letter: char, of: &str| (0..count).map(|r| format!("{letter}{r}{of}")).collect::<Vec<_>>();
        let curves = ["a", "b", "c", "d"].map(|letter| format!("(curve{m}{} p q)", values(&[letter], m)));
        let _ = writeln!(
            text,
            "theorem surface_curve{} :\n    surface{roots}{} =\n      {} := by\n  simp only [surface, curve{m}, {}]\n  ring\n",
            reals(&(roots.clone() + &all + " p q")),
            spaced(curves),
            vanish::sum(&each('F', &(roots.clone() + &all)), "p", "q"),
            each('F', "").join(", "),
        );
        let rows = |p: &str, q: &str| {
            let row = |coordinate| {
                (0..=m).map(move |i| {
                    format!("({coordinate}{i}{arguments} {p} {q})", arguments = self.names.arguments())
                })
            };
            spaced(COORDINATES.iter().flat_map(row))
        };
        text += "/-! The same for the rows of the net. -/\n\n";
        for r in 0..count {
            let parameters = reals(&format!("{arguments} p q"));
            let _ = writeln!(text, "def G{r}{parameters} : ℝ := F{r}{roots}{}\n", rows("p", "q"));
        }
        let _ = writeln!(
            text,
            "theorem surface_patch{} :\n    {} =\n      {} :=\n  surface_curve{roots}{} u (1 - u)\n",
            reals(&format!("{arguments} u v")),
            self.on_patch(&self.names.roots),
            vanish::sum(&each('G', &format!("{arguments} v (1 - v)")), "u", "(1 - u)"),
            rows("v", "(1 - v)"),
        );
        text
    }

    /// `surface (X r2 x1 u v) (Y …) (Z …) (W …)`, with roots that are given.
    fn on_patch(&self, roots: &[String]) -> String {
        let of_surface = spaced(self.surface_roots.iter().map(|&root| roots[root].clone()));
        let arguments = spaced(roots) + &spaced(&self.names.unknowns);
        format!("surface{of_surface}{}", spaced(COORDINATES.map(|name| format!("({name}{arguments} u v)"))))
    }

    fn roots_of_surface(&self) -> String {
        spaced(self.surface_roots.iter().map(|&root| self.names.roots[root].clone()))
    }
}

fn true_roots(names: &Names) -> Vec<String> {
    names.radicands.iter().map(|radicand| format!("(Real.sqrt {radicand})")).collect()
}

/// ` a0 a1 a2 b0 …`: the control values of curves of this degree.
fn values(letters: &[&str], degree: u32) -> String {
    spaced(letters.iter().flat_map(|letter| (0..=degree).map(move |i| format!("{letter}{i}"))))
}

/// `X0, X1, …, W2, `: the definitions that `simp only` unfolds.
fn row_names(m: u32) -> String {
    let names = COORDINATES.iter().flat_map(|coordinate| (0..=m).map(move |i| format!("{coordinate}{i}, ")));
    names.collect()
}
