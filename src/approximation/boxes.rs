//! Boxes of the unit square with the Bernstein coefficients of some forms on them, in fixed point.

use num_rational::BigRational;

use super::exactly::dyadic;
use crate::algebra::Integer;

/// A form of bidegree (m,n): its Bernstein coefficients b[i,j], (m+1) rows of n + 1, in fixed point.
#[derive(Debug, Clone)]
pub(super) struct Coefficients {
    pub(super) bidegree: (usize, usize),
    pub(super) values: Vec<Integer>,
}

impl Coefficients {
    /// The places of the corners (0,0), (0,1), (1,0), (1,1).
    pub(super) fn corners(&self) -> [usize; 4] {
        let (m, n) = self.bidegree;
        [0, n, m * (n + 1), m * (n + 1) + n]
    }

    /// Both halves, across u or across v, by de Casteljau's algorithm (Farin, Curves and Surfaces for CAGD, section 5.3).
    fn halves(&self, across_u: bool) -> [Coefficients; 2] {
        let (m, n) = self.bidegree;
        let (lines, length, stride, step) =
            if across_u { (n + 1, m + 1, 1, n + 1) } else { (m + 1, n + 1, n + 1, 1) };
        let (mut low, mut high) = (self.values.clone(), self.values.clone());
        for line in 0..lines {
            let index = |k: usize| line * stride + k * step;
            let mut row: Vec<Integer> = (0..length).map(|k| self.values[index(k)].clone()).collect();
            for k in 0..length {
                low[index(k)] = row[0].clone();
                high[index(length - 1 - k)] = row[row.len() - 1].clone();
                row = row.windows(2).map(|pair| (&pair[0] + &pair[1]).shifted_right(1)).collect();
            }
        }
        [low, high].map(|values| Coefficients { bidegree: self.bidegree, values })
    }
}

/// A box: its lower corner is (u/2^depth₀, v/2^depth₁), its sides are 2^−depth₀ and 2^−depth₁.
#[derive(Debug, Clone)]
pub(super) struct Part<const N: usize> {
    pub(super) corner: (Integer, Integer),
    /// How often it was halved: across u first, then v, in turn, as the format of certificates has it.
    pub(super) depth: u32,
    pub(super) forms: [Coefficients; N],
}

impl<const N: usize> Part<N> {
    /// The whole square.
    pub(super) fn whole(forms: [Coefficients; N]) -> Self {
        Part { corner: (Integer::zero(), Integer::zero()), depth: 0, forms }
    }

    /// The lower and the upper half.
    pub(super) fn halves(&self) -> [Self; 2] {
        let across_u = self.depth.is_multiple_of(2);
        let mut forms = self.forms.each_ref().map(|form| form.halves(across_u).map(Some));
        let (u, v) = (&self.corner.0, &self.corner.1);
        [0usize, 1].map(|half| {
            let moved = |x: &Integer| &x.times(2) + &Integer::from(half as i64);
            let corner = if across_u { (moved(u), v.clone()) } else { (u.clone(), moved(v)) };
            let forms = forms.each_mut().map(|halves| halves[half].take().expect("each half is taken once"));
            Part { corner, depth: self.depth + 1, forms }
        })
    }

    /// How often the box was halved across u, and across v.
    pub(super) fn depths(&self) -> (u32, u32) {
        (self.depth.div_ceil(2), self.depth / 2)
    }

    /// The corner with this number in the order of [`Coefficients::corners`], as a point (u, v).
    pub(super) fn place(&self, number: usize) -> [BigRational; 2] {
        let moved = |x: &Integer, far: bool| if far { x + &Integer::one() } else { x.clone() };
        let (i, j) = self.depths();
        [dyadic(&moved(&self.corner.0, number >= 2), i), dyadic(&moved(&self.corner.1, number % 2 == 1), j)]
    }
}
