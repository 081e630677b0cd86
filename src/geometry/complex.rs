//! K(i): complex numbers with both parts in K.

use crate::algebra::{FieldElement, Sign};

/// re + i·im.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Complex {
    /// The real part.
    pub re: FieldElement,
    /// The imaginary part.
    pub im: FieldElement,
}

impl Complex {
    /// A real number.
    pub fn real(re: FieldElement) -> Self {
        let im = re.field().zero();
        Complex { re, im }
    }

    /// The sum.
    pub fn plus(&self, other: &Self) -> Self {
        Complex { re: &self.re + &other.re, im: &self.im + &other.im }
    }

    /// The product.
    pub fn times(&self, other: &Self) -> Self {
        Complex {
            re: &(&self.re * &other.re) - &(&self.im * &other.im),
            im: &(&self.re * &other.im) + &(&self.im * &other.re),
        }
    }

    /// A real multiple.
    pub fn scaled(&self, factor: &FieldElement) -> Self {
        Complex { re: &self.re * factor, im: &self.im * factor }
    }

    /// re − i·im.
    pub fn conjugate(&self) -> Self {
        Complex { re: self.re.clone(), im: -&self.im }
    }

    /// |self|².
    pub fn norm(&self) -> FieldElement {
        &(&self.re * &self.re) + &(&self.im * &self.im)
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.re.is_zero() && self.im.is_zero()
    }

    /// 1/self, or `None` for 0.
    pub fn inverse(&self) -> Option<Self> {
        Some(self.conjugate().scaled(&self.norm().inverse()?))
    }

    /// self/|self|, where the absolute value is in K.
    pub fn direction(&self) -> Option<Self> {
        let inverse = positive_root(&self.norm())?.inverse()?;
        Some(self.scaled(&inverse))
    }
}

/// The positive square root, where K has one.
pub(super) fn positive_root(square: &FieldElement) -> Option<FieldElement> {
    let root = square.square_root()?;
    Some(if root.sign() == Sign::Negative { -&root } else { root })
}
