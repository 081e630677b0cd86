//! A polynomial of degree n with n + 1 zeros is 0: the lemma that turns "on the whole square" into equations.
//!
//! In the basis tʳ(1−t)^(n−r): with ℓ_k the Lagrange polynomials for the points k/n, f = Σ f(k/n)·ℓ_k, and the coefficient of ℓ_k at
//! tʳ(1−t)^(n−r) is that of pʳq^(n−r) in Π (((n−l)p − lq)/(k−l)) over all l ≠ k, since (n−l)t − l(1−t) = nt − l.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// The name of the lemma for degree n.
pub(super) fn name(n: usize) -> String {
    format!("vanish{n}")
}

/// `e0 * (t ^ 0 * (1 - t) ^ 4) + …`: the polynomial with these coefficients, in the form that the lemma has.
pub(super) fn sum(coefficients: &[String], p: &str, q: &str) -> String {
    let n = coefficients.len().saturating_sub(1);
    let terms = coefficients.iter().enumerate().map(|(r, c)| format!("{c} * ({p} ^ {r} * {q} ^ {})", n - r));
    terms.collect::<Vec<_>>().join(" + ")
}

/// The lemma for degree n ≥ 1.
pub(super) fn lemma(n: usize) -> String {
    let names: Vec<String> = (0..=n).map(|r| format!("e{r}")).collect();
    let mut text = format!(
        "/-- A polynomial of degree {n} that vanishes at 0, 1/{n}, ..., 1 has no coefficients other than 0. -/\n\
         theorem {} ({} : ℝ)\n    (h : ∀ t : ℝ, 0 ≤ t → t ≤ 1 → {} = 0) :\n    {} := by\n",
        name(n),
        names.join(" "),
        sum(&names, "t", "(1 - t)"),
        names.iter().map(|e| format!("{e} = 0")).collect::<Vec<_>>().join(" ∧ "),
    );
    for k in 0..=n {
        text += &format!("  have h{k} := h ({k} / {n}) (by norm_num) (by norm_num)\n");
    }
    let lagrange: Vec<Vec<BigRational>> = (0..=n).map(|k| lagrange(n, k)).collect();
    let coefficient = |r: usize| {
        let samples = lagrange.iter().enumerate().filter(|(_, values)| !values[r].is_zero());
        let terms = samples.map(|(k, values)| format!("({}) * h{k}", values[r]));
        format!("by linear_combination {}", terms.collect::<Vec<_>>().join(" + "))
    };
    let proofs: Vec<String> = (0..names.len()).map(coefficient).collect();
    text + &format!("  exact ⟨{}⟩\n", proofs.join(",\n    "))
}

/// The coefficients of ℓ_k at pʳq^(n−r), r = 0..n.
fn lagrange(n: usize, k: usize) -> Vec<BigRational> {
    let mut product = vec![BigRational::one()];
    for l in (0..=n).filter(|&l| l != k) {
        let divisor = BigInt::from(k) - BigInt::from(l);
        let at_p = BigRational::new(BigInt::from(n - l), divisor.clone());
        let at_q = BigRational::new(-BigInt::from(l), divisor);
        let mut next = vec![BigRational::zero(); product.len() + 1];
        for (r, value) in product.iter().enumerate() {
            next[r] += value * &at_q;
            next[r + 1] += value * &at_p;
        }
        product = next;
    }
    product
}

#[cfg(test)]
mod tests {
    use super::{BigInt, BigRational, Zero, lagrange};

    /// ℓ_k is 1 at k/n and 0 at the other points.
    #[test]
    fn each_sample_has_its_polynomial() {
        for n in 1..9usize {
            for k in 0..=n {
                let coefficients = lagrange(n, k);
                for point in 0..=n {
                    let t = BigRational::new(point.into(), n.into());
                    let one_less = BigRational::new((n - point).into(), n.into());
                    let power = |base: &BigRational, e: usize| {
                        (0..e).fold(BigInt::from(1).into(), |x: BigRational, _| x * base)
                    };
                    let terms = coefficients.iter().enumerate();
                    let value = terms.fold(BigRational::zero(), |sum, (r, c)| {
                        sum + c * power(&t, r) * power(&one_less, coefficients.len() - 1 - r)
                    });
                    assert_eq!(value, BigInt::from(i32::from(point == k)).into(), "{n}, {k}, {point}");
                }
            }
        }
    }
}
