//! Values and polynomials in the place of variables.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use super::arithmetic::Arithmetic;
use super::limits::{self, Limit};
use super::polynomial::Polynomial;

impl Arithmetic<'_> {
    /// The value at `variable k = values[k]`; variables beyond the list stay.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn substitute(&mut self, a: &Polynomial, values: &[Polynomial]) -> Result<Polynomial, Limit> {
        self.put(a, |variable| values.get(usize::from(variable)))
    }

    /// What `value` has for a variable is put for it; variables for which it has nothing stay.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn put<'v>(
        &mut self,
        a: &Polynomial,
        value: impl Fn(u16) -> Option<&'v Polynomial>,
    ) -> Result<Polynomial, Limit> {
        self.alone(|this| this.put_all(a, value))
    }

    fn put_all<'v>(
        &mut self,
        a: &Polynomial,
        value: impl Fn(u16) -> Option<&'v Polynomial>,
    ) -> Result<Polynomial, Limit> {
        self.charge_copy(a)?;
        let mut powers = Powers::default();
        let mut products = Vec::with_capacity(a.term_count());
        for (monomial, coefficient) in a.terms() {
            let stay = monomial.kept(|variable| value(variable).is_none());
            let mut product = Polynomial::term(coefficient.clone(), stay);
            for &(variable, exponent) in monomial.powers() {
                if let Some(base) = value(variable) {
                    let power = powers.get(variable, base, exponent, self)?;
                    product = self.product(&product, power)?;
                }
            }
            products.push(product);
        }
        self.sum(&products)
    }
}

/// Powers of what is put for the variables, each the one before it times the first.
#[derive(Default)]
struct Powers {
    of: BTreeMap<u16, Vec<Polynomial>>,
}

impl Powers {
    fn get(
        &mut self,
        variable: u16,
        base: &Polynomial,
        exponent: u32,
        arithmetic: &mut Arithmetic<'_>,
    ) -> Result<&Polynomial, Limit> {
        let powers = match self.of.entry(variable) {
            Entry::Occupied(entry) => entry.into_mut(),
            Entry::Vacant(entry) => {
                arithmetic.work.keep(256)?;
                entry.insert(vec![Polynomial::integer(1)])
            }
        };
        let wanted = usize::try_from(exponent).unwrap_or(usize::MAX);
        while powers.len() <= wanted {
            let last = powers.last().ok_or(limits::EXPONENT)?;
            let next = arithmetic.product(last, base)?;
            arithmetic.work.keep(64)?;
            powers.push(next);
        }
        powers.get(wanted).ok_or(limits::EXPONENT)
    }
}
