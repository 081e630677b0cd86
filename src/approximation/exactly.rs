//! Forms with coefficients in K, and what they are on a box or at a point: exactly.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

use super::boxes::Part;
use crate::algebra::{FieldElement, Integer, MultiquadraticField};
use crate::algebra::{Magnitude, magnitude};

/// A form of bidegree (m,n) by its Bernstein coefficients, (m+1) rows of n + 1, over one denominator.
#[derive(Debug, Clone)]
pub(super) struct ExactForm {
    field: MultiquadraticField,
    pub(super) bidegree: (usize, usize),
    /// The coefficients as they are.
    pub(super) coefficients: Vec<FieldElement>,
    /// The coordinates of each, over the denominator.
    numerators: Vec<Vec<Integer>>,
    denominator: Integer,
}

impl ExactForm {
    /// From its coefficients, of which there is at least one.
    pub(super) fn new(
        field: MultiquadraticField,
        bidegree: (usize, usize),
        coefficients: Vec<FieldElement>,
    ) -> Self {
        let denominator =
            coefficients.iter().fold(Integer::one(), |common, value| common.lcm(value.denominator()));
        let over = |value: &FieldElement| -> Vec<Integer> {
            let factor = denominator.exact_quotient(value.denominator());
            value.numerators().iter().map(|numerator| numerator * &factor).collect()
        };
        let numerators = coefficients.iter().map(over).collect();
        ExactForm { field, bidegree, coefficients, numerators, denominator }
    }

    /// ∂/∂u (axis 0) or ∂/∂v (axis 1); `None` where it vanishes for its degree.
    pub(super) fn derivative(&self, axis: usize) -> Option<Self> {
        let (m, n) = self.bidegree;
        let (bidegree, step, degree) = match axis {
            0 => ((m.checked_sub(1)?, n), n + 1, m),
            _ => ((m, n.checked_sub(1)?), 1, n),
        };
        let factor = self.field.integer(degree as i64);
        let (rows, columns) = bidegree;
        let places = itertools::iproduct!(0..=rows, 0..=columns).map(|(i, j)| i * (n + 1) + j);
        let values = &self.coefficients;
        let differences = places.map(|k| &(&values[k + step] - &values[k]) * &factor).collect();
        Some(ExactForm::new(self.field, bidegree, differences))
    }

    /// The value at a point.
    pub(super) fn at(&self, point: &[BigRational; 2]) -> FieldElement {
        let (m, n) = self.bidegree;
        self.polar(&vec![&point[0]; m], &vec![&point[1]; n])
    }

    /// The Bernstein coefficient with this number on a box: its sign, exactly, and its size; `None` for 0.
    ///
    /// It is the value of the blossom at so many ends of the box's sides (Ramshaw 1989, doi:10.1016/0167-8396(89)90032-0).
    pub(super) fn on_box<const N: usize>(&self, part: &Part<N>, number: usize) -> Option<Magnitude> {
        let (m, n) = self.bidegree;
        let (i, j) = (number / (n + 1), number % (n + 1));
        let [low, high] = [part.place(0), part.place(3)];
        let arguments = |degree: usize, upper: usize, axis: usize| -> Vec<&BigRational> {
            let mut chosen = vec![&low[axis]; degree - upper];
            chosen.extend(vec![&high[axis]; upper]);
            // The ends 0 and 1 choose a coefficient and compute nothing: these first.
            chosen.sort_by_key(|x| !x.is_integer());
            chosen
        };
        magnitude(&self.polar(&arguments(m, i, 0), &arguments(n, j, 1)))
    }

    /// The blossom, by de Casteljau's algorithm with a parameter of its own in each step.
    fn polar(&self, along_u: &[&BigRational], along_v: &[&BigRational]) -> FieldElement {
        let width = self.bidegree.1 + 1;
        let mut denominator = self.denominator.clone();
        // Rows that a parameter 0 or 1 leaves out are not touched.
        let (mut first, mut rows) = (0, self.bidegree.0 + 1);
        let mut grid: Option<Vec<Vec<Integer>>> = None;
        for x in along_u {
            rows -= 1;
            if x.is_zero() || x.is_one() {
                match &mut grid {
                    None => first += usize::from(x.is_one()),
                    Some(grid) if x.is_one() => drop(grid.drain(..width)),
                    Some(_) => {}
                }
                continue;
            }
            let before = grid.as_deref().unwrap_or(&self.numerators[first * width..]);
            grid = Some((0..rows * width).map(|k| mixed(&before[k], &before[k + width], x)).collect());
            denominator = &denominator * &Integer::from_bigint(x.denom());
        }
        let mut row: Vec<Vec<Integer>> = match grid {
            Some(mut grid) => grid.drain(..width).collect(),
            None => self.numerators[first * width..(first + 1) * width].to_vec(),
        };
        for x in along_v {
            row = row.windows(2).map(|pair| mixed(&pair[0], &pair[1], x)).collect();
            if !x.is_integer() {
                denominator = &denominator * &Integer::from_bigint(x.denom());
            }
        }
        self.field.element(row.swap_remove(0), denominator)
    }
}

/// (1 − x)·a + x·b, times the denominator of x.
fn mixed(a: &[Integer], b: &[Integer], x: &BigRational) -> Vec<Integer> {
    if x.is_zero() {
        return a.to_vec();
    }
    if x.is_one() {
        return b.to_vec();
    }
    let [of_a, of_b] = [x.denom() - x.numer(), x.numer().clone()].map(|factor| Integer::from_bigint(&factor));
    a.iter().zip(b).map(|(a, b)| &(a * &of_a) + &(b * &of_b)).collect()
}

/// numerator/2^depth.
pub(super) fn dyadic(numerator: &Integer, depth: u32) -> BigRational {
    BigRational::new(numerator.to_bigint(), BigInt::one() << depth)
}
