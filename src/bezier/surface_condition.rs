//! F(X(u,v), Y(u,v), Z(u,v), W(u,v)) in the scaled Bernstein basis.

use super::bernstein::BernsteinForm;
use crate::algebra::{FieldElement, Monomial, MultiquadraticField, polynomial_from_exact};
use crate::control::{Control, Interrupted};
use crate::statement::Patch;

/// The condition that a patch of bidegree (m,n) lies on its surface of degree e: a form of bidegree (em,en),
/// all of whose coefficients must vanish.
///
/// For the sphere, `c[r,s]` = Σ C(m,i)C(n,j)C(m,r−i)C(n,s−j)⟨H_ij, H_(r−i,s−j)⟩ with ⟨A,B⟩ = AxBx + AyBy + AzBz − AwBw.
pub fn surface_condition(field: MultiquadraticField, patch: &Patch) -> BernsteinForm {
    surface_condition_within(field, patch, &Control::default()).expect("nobody stops it")
}

/// The same, where it may be stopped.
///
/// # Errors
/// [`Control::check`]
pub fn surface_condition_within(
    field: MultiquadraticField,
    patch: &Patch,
    control: &Control,
) -> Result<BernsteinForm, Interrupted> {
    let coordinates: [BernsteinForm; 4] = std::array::from_fn(|k| {
        let entry = |i: usize, j: usize| polynomial_from_exact(field, &patch.net[i][j][k]);
        BernsteinForm::from_bernstein(field, patch.bidegree, entry)
    });
    let surface = polynomial_from_exact(field, &patch.surface);
    let product = |(monomial, value): &(Monomial, FieldElement)| {
        let mut factors = monomial
            .powers()
            .iter()
            .flat_map(|&(k, exponent)| std::iter::repeat_n(&coordinates[usize::from(k)], exponent as usize));
        factors.try_fold(BernsteinForm::constant(value.clone()), |product, factor| {
            product.multiply_within(factor, control)
        })
    };
    let mut products = surface.terms().iter().map(product);
    let first = products.next().expect("a surface has at least one term")?;
    products.try_fold(first, |sum, next| {
        control.check()?;
        Ok(sum.add(&next?))
    })
}
