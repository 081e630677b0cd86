//! The closing condition as a system of equations, and its refutation.
//!
//! The spinor of a patch of bidegree (2,2) at corner k is c_k·s_k, where s_k is a spinor of the corner and c_k ≠ 0 complex. An edge that
//! lies in the great circle through two corners makes ⟨c_k s_k, c_l s_l⟩ real. Multiplied around the quadrilateral, that is
//! Π|c_k|²·Im Z = 0.

use crate::algebra::{FieldElement, Polynomial, polynomial_to_exact, spell};
use crate::certificate::{Argument, Premise, Step};
use crate::exact::Limit;
use crate::formats::statement_file::{Draft, DraftSubject};
use crate::geometry::{Complex, Polygon};

/// a_k, b_k with c_k = a_k + i·b_k.
const UNKNOWNS: [&str; 8] = ["a1", "b1", "a2", "b2", "a3", "b3", "a4", "b4"];

/// The statement file: Im(c̄_k·c_l·⟨s_k, s_l⟩) = 0 around the quadrilateral, no c_k zero.
pub fn closing_statement(polygon: &Polygon, title: &str) -> String {
    let spinors = polygon.spinors();
    let polynomials = (1..=4).map(|k| {
        let l = k % 4 + 1;
        // c̄_k·c_l = (a_k a_l + b_k b_l) + i(a_k b_l − b_k a_l).
        format!("p{k}*(a{k}*b{l} - b{k}*a{l}) + q{k}*(a{k}*a{l} + b{k}*b{l})")
    });
    let products = (0..4).flat_map(|k| {
        let Complex { re, im } = spinors[k].product(&spinors[(k + 1) % 4]);
        [(format!("p{}", k + 1), spell(&re)), (format!("q{}", k + 1), spell(&im))]
    });
    let remark = [
        "The closing condition of a quadrilateral: c_k = a_k + i*b_k times a spinor of corner k is the spinor of a patch there.",
        "An edge in a great circle makes the product of those at its ends real: g_k = p_k + i*q_k is that of corners k and k + 1.",
    ];
    let draft = Draft {
        remark: remark.map(str::to_owned).into(),
        title: title.to_owned(),
        radicands: polygon.field().radicands().to_vec(),
        unknowns: UNKNOWNS.map(str::to_owned).into(),
        nonzero: (1..=4).map(|k| format!("a{k}^2 + b{k}^2")).collect(),
        subject: DraftSubject::System(polynomials.collect()),
        define: products.collect(),
    };
    draft.text()
}

/// A complex number whose parts are polynomials.
struct Parts {
    re: Polynomial,
    im: Polynomial,
}

impl Parts {
    fn times(&self, other: &Parts) -> Parts {
        let minus = self.re.field().integer(-1);
        Parts {
            re: self.re.multiply(&other.re).add_scaled(&minus, &self.im.multiply(&other.im)),
            im: self.re.multiply(&other.im).add(&self.im.multiply(&other.re)),
        }
    }

    fn scaled(&self, by: &Complex) -> Parts {
        let minus = -&by.im;
        Parts {
            re: self.re.scaled(&by.re).add_scaled(&minus, &self.im),
            im: self.re.scaled(&by.im).add_scaled(&by.re, &self.im),
        }
    }
}

/// The refutation, for a quadrilateral whose Z is not real: the equations multiplied around it.
///
/// # Errors
/// Where the numbers exceed what the format allows.
pub fn closing_argument(polygon: &Polygon) -> Result<Option<Argument>, Limit> {
    let Some(inverse) = polygon.holonomy().im.inverse() else { return Ok(None) };
    let field = polygon.field();
    let spinors = polygon.spinors();
    let variable = |index: usize| Polynomial::variable(field, index as u16);
    let one = || Polynomial::constant(field.one());
    // c̄_k·c_l·g for any g.
    let product = |k: usize, l: usize, g: &Complex| {
        let conjugate = Parts { re: variable(2 * k), im: variable(2 * k + 1).scaled(&field.integer(-1)) };
        conjugate.times(&Parts { re: variable(2 * l), im: variable(2 * l + 1) }).scaled(g)
    };
    let g: Vec<Complex> = (0..4).map(|k| spinors[k].product(&spinors[(k + 1) % 4])).collect();
    let z: Vec<Parts> = (0..4).map(|k| product(k, (k + 1) % 4, &g[k])).collect();
    let norm = |k: usize| {
        variable(2 * k).multiply(&variable(2 * k)).add(&variable(2 * k + 1).multiply(&variable(2 * k + 1)))
    };
    let t = |k: usize| variable(8 + k);
    let negative = |polynomial: &Polynomial| polynomial.scaled(&field.integer(-1));

    let mut steps = Vec::new();
    let mut step = |combination: Vec<(Premise, Polynomial)>, conclusion: Polynomial| -> Result<(), Limit> {
        let mut written = Vec::new();
        for (premise, multiplier) in combination.into_iter().filter(|(_, multiplier)| !multiplier.is_zero()) {
            written.push((premise, polynomial_to_exact(&multiplier)?));
        }
        steps.push(Step { combination: written, conclusion: polynomial_to_exact(&conclusion)? });
        Ok(())
    };
    // Im z₁z₂ = |c₂|²·Im(c̄₁c₃g₁g₂), and |c₂|²·t₂ = 1; the other half likewise.
    let near = product(0, 2, &g[0].times(&g[1]));
    let far = product(2, 0, &g[2].times(&g[3]));
    for (first, passed, half) in [(0usize, 1usize, &near), (2, 3, &far)] {
        let equation = |k: usize| Premise::Equation(k as u32 + 1);
        let assumption = Premise::Nonzero(passed as u32 + 1);
        let combination = vec![
            (equation(first), z[first + 1].re.multiply(&t(passed))),
            (equation(first + 1), z[first].re.multiply(&t(passed))),
            (assumption, negative(&half.im)),
        ];
        step(combination, half.im.clone())?;
    }
    // Im of the product of both halves is |c₁|²|c₃|²·Im Z.
    let both = norm(0).multiply(&norm(2));
    step(
        vec![(Premise::Step(1), far.re.scaled(&inverse)), (Premise::Step(2), near.re.scaled(&inverse))],
        both.clone(),
    )?;
    // |c₁|²t₁ = 1 and |c₃|²t₃ = 1: 1 = |c₁|²|c₃|²t₁t₃ − (|c₃|²t₃)(|c₁|²t₁ − 1) − (|c₃|²t₃ − 1).
    let last = vec![
        (Premise::Nonzero(1), negative(&norm(2).multiply(&t(2)))),
        (Premise::Nonzero(3), negative(&one())),
        (Premise::Step(3), t(0).multiply(&t(2))),
    ];
    step(last, one())?;
    Ok(Some(Argument::Impossible(steps)))
}

/// Values of the unknowns that solve the system of a quadrilateral whose Z is real.
pub fn closing_values(polygon: &Polygon) -> Option<Vec<FieldElement>> {
    let spinors = polygon.spinors();
    let mut values = vec![Complex::real(polygon.field().one())];
    for k in 0..3 {
        // c̄_k·c_l·g real: c_l = c_k·ḡ.
        let g = spinors[k].product(&spinors[k + 1]);
        values.push(values[k].times(&g.conjugate()));
    }
    polygon.holonomy().im.is_zero().then(|| values.into_iter().flat_map(|c| [c.re, c.im]).collect())
}
