//! Short vectors of lattices of integers.

use super::integer::Integer;

/// A vector of the lattice with this basis whose square length is at most 2ⁿ⁻¹ times that of the shortest one that
/// is not 0, n ≥ 1 being the number of basis vectors, which must be linearly independent.
///
/// Lenstra, Lenstra and Lovász 1982, in integers only (Cohen, A Course in Computational Algebraic Number Theory,
/// algorithm 2.6.7). `check` is asked before every exchange.
pub(super) fn short_vector<E>(
    basis: Vec<Vec<Integer>>,
    check: &mut impl FnMut() -> Result<(), E>,
) -> Result<Vec<Integer>, E> {
    let size = basis.len();
    let mut lattice = Lattice::new(basis);
    let mut k = 1;
    while k < size {
        check()?;
        lattice.reduce(k, k - 1);
        if lattice.is_ordered(k) {
            for l in (0..k - 1).rev() {
                lattice.reduce(k, l);
            }
            k += 1;
        } else {
            lattice.exchange(k);
            k = k.saturating_sub(1).max(1);
        }
    }
    Ok(lattice.basis.swap_remove(0))
}

struct Lattice {
    basis: Vec<Vec<Integer>>,
    /// Gram determinants: of no vector, of the first, of the first two, ….
    determinants: Vec<Integer>,
    /// Below the diagonal: the Gram–Schmidt coefficients (k, j), times the determinant of the first j + 1 vectors.
    coefficients: Vec<Vec<Integer>>,
}

impl Lattice {
    fn new(basis: Vec<Vec<Integer>>) -> Self {
        let size = basis.len();
        let mut determinants = vec![Integer::one()];
        let mut coefficients = vec![vec![Integer::zero(); size]; size];
        for k in 0..size {
            for j in 0..=k {
                let product = |sum: Integer, (a, b): (&Integer, &Integer)| &sum + &(a * b);
                let mut u = basis[k].iter().zip(&basis[j]).fold(Integer::zero(), product);
                for i in 0..j {
                    let crossed = &coefficients[k][i] * &coefficients[j][i];
                    u = (&(&determinants[i + 1] * &u) - &crossed).exact_quotient(&determinants[i]);
                }
                if j < k {
                    coefficients[k][j] = u;
                } else {
                    determinants.push(u);
                }
            }
        }
        Lattice { basis, determinants, coefficients }
    }

    /// Subtracts the multiple of vector l from vector k that makes their coefficient at most ½.
    fn reduce(&mut self, k: usize, l: usize) {
        let determinant = &self.determinants[l + 1];
        let twice = self.coefficients[k][l].times(2);
        if twice.abs() <= *determinant {
            return;
        }
        // The nearest integer to λ/d is ⌊(2λ + d)/2d⌋.
        let (shifted, divisor) = (&twice + determinant, determinant.times(2));
        let q = (&shifted - &shifted.modulo(&divisor)).exact_quotient(&divisor);
        self.coefficients[k][l] -= &(&q * determinant);
        let (below, above) = self.basis.split_at_mut(k);
        for (entry, subtract) in above[0].iter_mut().zip(&below[l]) {
            *entry -= &(&q * subtract);
        }
        let (below, above) = self.coefficients.split_at_mut(k);
        for (entry, subtract) in above[0][..l].iter_mut().zip(&below[l]) {
            *entry -= &(&q * subtract);
        }
    }

    /// Lovász' condition, with ¾, for vectors k − 1 and k.
    fn is_ordered(&self, k: usize) -> bool {
        let (d, lambda) = (&self.determinants, &self.coefficients[k][k - 1]);
        let left = (&(&d[k + 1] * &d[k - 1]) + &(lambda * lambda)).times(4);
        left >= (&d[k] * &d[k]).times(3)
    }

    /// Exchanges vectors k − 1 and k.
    fn exchange(&mut self, k: usize) {
        self.basis.swap(k - 1, k);
        let (below, above) = self.coefficients.split_at_mut(k);
        for (a, b) in below[k - 1][..k - 1].iter_mut().zip(&mut above[0]) {
            std::mem::swap(a, b);
        }
        let lambda = self.coefficients[k][k - 1].clone();
        let (d, after) = (self.determinants[k].clone(), self.determinants[k + 1].clone());
        let between = (&(&self.determinants[k - 1] * &after) + &(&lambda * &lambda)).exact_quotient(&d);
        for row in &mut self.coefficients[k + 1..] {
            let t = row[k].clone();
            row[k] = (&(&after * &row[k - 1]) - &(&lambda * &t)).exact_quotient(&d);
            row[k - 1] = (&(&between * &t) + &(&lambda * &row[k])).exact_quotient(&after);
        }
        self.determinants[k] = between;
    }
}
