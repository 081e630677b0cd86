//! These values put the patch on the surface.

use std::fmt::Write;

use super::super::super::case::ExportError;
use super::super::argument::constant_is_not_zero;
use super::super::names::{reals, spaced};
use super::{Writer, row_names, true_roots};

impl Writer<'_> {
    /// Each coefficient along the rows of the net vanishes, hence the surface does.
    pub(super) fn exact(&self) -> Result<String, ExportError> {
        let (names, arguments) = (self.names, self.names.arguments());
        let (m, n) = self.patch.bidegree;
        let rows = row_names(m);
        let mut text = String::new();
        for r in 0..self.forms.along_curve.len() {
            let reductions = names.root_terms(&self.forms.along_net(r)?, '+')?;
            let proof = match reductions.strip_prefix(" + ") {
                Some(terms) => format!("linear_combination {terms}"),
                None => "ring".to_owned(),
            };
            let _ = writeln!(
                text,
                "theorem row{r}{}{} : G{r}{arguments} p q = 0 := by\n  simp only [G{r}, F{r}, {rows}curve{n}]\n  {proof}\n",
                reals(&format!("{arguments} p q")),
                names.root_hypotheses(),
            );
        }
        let hypotheses = spaced(names.radicands.iter().map(|radicand| format!("hr{radicand}")));
        let term = |r: usize| {
            let last = self.forms.along_curve.len() - 1;
            format!(" + (u ^ {r} * (1 - u) ^ {}) * row{r}{arguments} v (1 - v){hypotheses}", last - r)
        };
        let _ = writeln!(
            text,
            "theorem identity{}{} :\n    {} = 0 := by\n  linear_combination surface_patch{arguments} u v{}\n",
            reals(&format!("{arguments} u v")),
            names.root_hypotheses(),
            self.on_patch(&names.roots),
            (0..self.forms.along_curve.len()).map(term).collect::<String>(),
        );
        let _ = writeln!(
            text,
            "/-- The patch lies on the surface: for all real u and v, inside the unit square and outside. -/\n\
             theorem exact_patch (u v : ℝ) :\n    {} = 0 :=\n  identity{} u v{}\n",
            self.on_patch(&true_roots(names)),
            names.true_roots(),
            names.root_proofs(),
        );
        let points = (0..)
            .zip(&self.patch.net)
            .flat_map(|(i, row)| (0..).zip(row).map(move |(j, point)| (i, j, point)));
        let mut weights = points.map(|(i, j, [.., weight]): (u32, u32, _)| (i, j, weight));
        if let Some((i, j, weight)) = weights.find(|(.., weight)| !weight.is_zero()) {
            let _ = writeln!(text, "/-- W is not everywhere 0, since its control value ({i},{j}) is not. -/");
            text += &constant_is_not_zero(self.case, names, "some_weight", weight)?;
            text += "\n";
        }
        for (number, assumed) in (1..).zip(&self.case.assumptions) {
            text += "/-- What was assumed not to be zero is not, for these values. -/\n";
            text += &constant_is_not_zero(self.case, names, &format!("assumption{number}"), assumed)?;
            text += "\n";
        }
        Ok(text)
    }
}
