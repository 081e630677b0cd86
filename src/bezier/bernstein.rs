//! Tensor-product polynomials in the scaled Bernstein basis.

use itertools::iproduct;

use crate::algebra::{FieldElement, Integer, MultiquadraticField, Polynomial};
use crate::control::{Control, Interrupted};

/// Σ `c[r,s]` uʳ(1−u)^(m−r) vˢ(1−v)^(n−s), r = 0..m, s = 0..n, with polynomials in the unknowns for `c[r,s]`.
///
/// *Scaled* means that the binomial coefficients are part of c (Farouki & Rajan 1988,
/// doi:10.1016/0167-8396(88)90016-7, section 2.2); products are then plain convolutions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct BernsteinForm {
    field: MultiquadraticField,
    bidegree: (u32, u32),
    /// Row by row: `c[r,s]` is at r·(n+1) + s.
    scaled: Vec<Polynomial>,
}

impl BernsteinForm {
    /// From the Bernstein coefficients `b[i,j]` (without binomials), m + 1 rows of n + 1.
    pub fn from_bernstein(
        field: MultiquadraticField,
        bidegree: (u32, u32),
        b: impl Fn(usize, usize) -> Polynomial,
    ) -> Self {
        let scaled = iproduct!(0..=bidegree.0, 0..=bidegree.1)
            .map(|(i, j)| {
                let factor = &binomial(bidegree.0, i) * &binomial(bidegree.1, j);
                b(i as usize, j as usize).scaled(&field.rational(factor, Integer::one()))
            })
            .collect();
        BernsteinForm { field, bidegree, scaled }
    }

    /// A constant, of bidegree (0, 0).
    pub fn constant(value: FieldElement) -> Self {
        let field = value.field();
        BernsteinForm { field, bidegree: (0, 0), scaled: vec![Polynomial::constant(value)] }
    }

    /// K.
    pub fn field(&self) -> MultiquadraticField {
        self.field
    }

    /// (m, n).
    pub fn bidegree(&self) -> (u32, u32) {
        self.bidegree
    }

    /// `c[r,s]`; r ≤ m and s ≤ n.
    pub fn coefficient(&self, r: u32, s: u32) -> &Polynomial {
        &self.scaled[self.index(r, s)]
    }

    /// All (r, s, `c[r,s]`), row by row.
    pub fn coefficients(&self) -> impl Iterator<Item = (u32, u32, &Polynomial)> {
        iproduct!(0..=self.bidegree.0, 0..=self.bidegree.1).zip(&self.scaled).map(|((r, s), c)| (r, s, c))
    }

    fn index(&self, r: u32, s: u32) -> usize {
        (r * (self.bidegree.1 + 1) + s) as usize
    }

    /// The Bernstein coefficients, without binomial factors, row by row; those that are not constant count as 0.
    pub fn constants(&self) -> Vec<FieldElement> {
        let (m, n) = self.bidegree();
        let unscaled = self.coefficients().map(|(r, s, value)| {
            let scale = self.field().rational(Integer::one(), &binomial(m, r) * &binomial(n, s));
            value.as_constant().map_or_else(|| self.field().zero(), |value| &value * &scale)
        });
        unscaled.collect()
    }

    /// The product: `c[r,s]` = Σ `a[i,j]`·`b[r−i,s−j]`.
    pub fn multiply(&self, other: &Self) -> Self {
        self.multiply_within(other, &Control::default()).expect("nobody stops it")
    }

    /// The same, where it may be stopped.
    ///
    /// # Errors
    /// [`Control::check`]
    pub fn multiply_within(&self, other: &Self, control: &Control) -> Result<Self, Interrupted> {
        let bidegree = (self.bidegree.0 + other.bidegree.0, self.bidegree.1 + other.bidegree.1);
        let mut product = BernsteinForm { field: self.field, bidegree, scaled: Vec::new() };
        let mut pairs: Vec<Vec<(&Polynomial, &Polynomial)>> =
            vec![Vec::new(); ((bidegree.0 + 1) * (bidegree.1 + 1)) as usize];
        for (i, j, a) in self.coefficients().filter(|(_, _, a)| !a.is_zero()) {
            for (k, l, b) in other.coefficients().filter(|(_, _, b)| !b.is_zero()) {
                pairs[product.index(i + k, j + l)].push((a, b));
            }
        }
        let sums = pairs.into_iter().map(|pairs| Polynomial::sum_of_products(self.field, pairs, control));
        product.scaled = sums.collect::<Result<_, _>>()?;
        Ok(product)
    }

    /// The sum of two forms of the same bidegree.
    pub fn add(&self, other: &Self) -> Self {
        assert_eq!(self.bidegree, other.bidegree, "forms of one bidegree are added");
        let scaled = self.scaled.iter().zip(&other.scaled).map(|(a, b)| a.add(b)).collect();
        BernsteinForm { field: self.field, bidegree: self.bidegree, scaled }
    }

    /// The coefficients `a[k,l]` of uᵏvˡ, as (k, l, `a[k,l]`), row by row.
    ///
    /// uʳ(1−u)^(m−r) = Σ (−1)^(k−r) C(m−r, k−r) uᵏ, and likewise in v.
    pub fn to_monomial_basis(&self) -> Vec<(u32, u32, Polynomial)> {
        self.to_monomial_basis_within(&Control::default()).expect("nobody stops it")
    }

    /// The same, where it may be stopped.
    ///
    /// # Errors
    /// [`Control::check`]
    pub fn to_monomial_basis_within(
        &self,
        control: &Control,
    ) -> Result<Vec<(u32, u32, Polynomial)>, Interrupted> {
        let (m, n) = self.bidegree;
        let entry = |(k, l): (u32, u32)| {
            let mut terms = Vec::new();
            for (r, s) in iproduct!(0..=k, 0..=l) {
                control.check()?;
                let size = &binomial(m - r, k - r) * &binomial(n - s, l - s);
                let signed = if (k - r + l - s) % 2 == 0 { size } else { -&size };
                let factor = self.field.rational(signed, Integer::one());
                terms.extend(self.coefficient(r, s).scaled(&factor).terms().iter().cloned());
            }
            Ok((k, l, Polynomial::from_terms(self.field, terms)))
        };
        iproduct!(0..=m, 0..=n).map(entry).collect()
    }
}

/// The value of a form with constant coefficients at a point.
pub fn value_at(form: &BernsteinForm, u: &FieldElement, v: &FieldElement) -> Option<FieldElement> {
    let (m, n) = form.bidegree();
    let field = form.field();
    let powers = |x: &FieldElement, degree: u32| -> Vec<FieldElement> {
        let complement = &field.one() - x;
        let power = |base: &FieldElement, exponent: u32| {
            (0..exponent).fold(field.one(), |product, _| &product * base)
        };
        (0..=degree).map(|r| &power(x, r) * &power(&complement, degree - r)).collect()
    };
    let (of_u, of_v) = (powers(u, m), powers(v, n));
    let mut sum = field.zero();
    for (r, s, value) in form.coefficients() {
        let basis = &of_u[r as usize] * &of_v[s as usize];
        sum = &sum + &(&Polynomial::as_constant(value)? * &basis);
    }
    Some(sum)
}

/// The binomial coefficient C(n, k).
pub fn binomial(n: u32, k: u32) -> Integer {
    (0..k).fold(Integer::one(), |c, i| (&c * &Integer::from(n - i)).exact_quotient(&Integer::from(i + 1)))
}
