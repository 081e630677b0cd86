//! No values of the unknowns put the patch on the surface.

use std::fmt::Write;

use super::super::super::case::ExportError;
use super::super::super::flat::used_equations;
use super::super::argument::{Known, inverse_equations, inverse_hypotheses, name, nonzero_hypotheses, steps};
use super::super::names::{reals, spaced};
use super::super::vanish;
use super::{SQUARE, Writer, row_names, true_roots};
use crate::certificate::Premise;
use crate::exact::Polynomial;

impl Writer<'_> {
    /// The equations from the assumption that the surface vanishes on the square, the steps, the theorem.
    pub(super) fn impossible(&self) -> Result<String, ExportError> {
        let (names, arguments) = (self.names, self.names.arguments());
        let used = used_equations(self.case)?;
        let mut known: Known = used.into_iter().collect();
        let (along_u, along_v) = (self.forms.along_curve.len() - 1, self.forms.degree_in_v());
        let mut degrees = vec![along_u, along_v];
        degrees.dedup();
        let mut text: String = degrees.iter().map(|&n| vanish::lemma(n) + "\n").collect();

        let mut extraction = String::new();
        for r in 0..=along_u {
            let wanted = |s: usize| known.get_key_value(&coefficient(r, s));
            if !(0..=along_v).any(|s| wanted(s).is_some()) {
                continue;
            }
            let forms = self.forms.along_row(r)?;
            text += &self.row(r, &forms);
            let pattern: Vec<String> = (0..=along_v)
                .map(|s| if wanted(s).is_some() { format!("k_{r}_{s}") } else { "_".to_owned() })
                .collect();
            let projection = ".2".repeat(r) + if r < along_u { ".1" } else { "" };
            let _ = writeln!(
                extraction,
                "  obtain ⟨{}⟩ := row{r}{arguments} (fun v h0 h1 => (g v h0 h1){projection})",
                pattern.join(", ")
            );
            for (s, form) in forms.iter().enumerate() {
                if let Some((premise, equation)) = wanted(s) {
                    let (own, equation, reductions) =
                        (name(*premise), names.spell(equation), names.root_terms(form, '-')?);
                    let _ = writeln!(
                        extraction,
                        "  have {own} : ({equation} : ℝ) = 0 := by linear_combination k_{r}_{s}{reductions}"
                    );
                }
            }
        }
        let on = |r: usize| format!("G{r}{arguments} v (1 - v) = 0");
        let _ = writeln!(
            text,
            "theorem refutation{}{}{}\n    (h : {SQUARE}\n      {} = 0) : False := by",
            reals(&(arguments.clone() + &spaced(&names.inverses))),
            names.root_hypotheses(),
            inverse_hypotheses(names),
            self.on_patch(&names.roots),
        );
        let _ = writeln!(
            text,
            "  have g : ∀ v : ℝ, 0 ≤ v → v ≤ 1 → {} :=\n    fun v h0 h1 => {}{} (fun u h2 h3 =>\n      \
             (surface_patch{arguments} u v).symm.trans (h u v h2 h3 h0 h1))",
            (0..=along_u).map(on).collect::<Vec<_>>().join(" ∧ "),
            vanish::name(along_u),
            " _".repeat(along_u + 1),
        );
        text += &extraction;
        text += &inverse_equations(names, &known);
        text += &steps(self.case, names, &mut known)?;
        let (hypotheses, inverses, proofs) = nonzero_hypotheses(names);
        let _ = writeln!(
            text,
            "\n/-- For no values of the unknowns does the patch lie on the surface. -/\n\
             theorem impossible{}{hypotheses} :\n    ¬ {SQUARE}\n      {} = 0 :=\n  fun h => refutation{}{}{inverses}{}{proofs} h",
            reals(&spaced(&names.unknowns)),
            self.on_patch(&true_roots(names)),
            names.true_roots(),
            spaced(&names.unknowns),
            names.root_proofs(),
        );
        Ok(text)
    }

    /// What vanishes along v for one r, coefficient by coefficient; √d is not yet replaced where it met itself.
    fn row(&self, r: usize, forms: &[Polynomial]) -> String {
        let (m, n) = self.patch.bidegree;
        let arguments = self.names.arguments();
        let spelled: Vec<String> = forms.iter().map(|form| self.names.spell(form)).collect();
        let bracketed: Vec<String> = spelled.iter().map(|form| format!("({form})")).collect();
        format!(
            "theorem row{r}{}\n    (h : ∀ t : ℝ, 0 ≤ t → t ≤ 1 → G{r}{arguments} t (1 - t) = 0) :\n    {} := by\n  \
             have e : ∀ p q : ℝ, G{r}{arguments} p q =\n      {} := by\n    intro p q\n    \
             simp only [G{r}, F{r}, {}curve{n}]\n    ring\n  \
             exact {}{} (fun t h0 h1 => (e t (1 - t)).symm.trans (h t h0 h1))\n\n",
            reals(&arguments),
            spelled.iter().map(|form| format!("({form} : ℝ) = 0")).collect::<Vec<_>>().join(" ∧ "),
            vanish::sum(&bracketed, "p", "q"),
            row_names(m),
            vanish::name(forms.len() - 1),
            " _".repeat(forms.len()),
        )
    }
}

fn coefficient(r: usize, s: usize) -> Premise {
    let index = |k: usize| u32::try_from(k).unwrap_or(u32::MAX);
    Premise::Coefficient(index(r), index(s))
}
