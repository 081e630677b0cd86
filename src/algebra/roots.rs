//! All roots in K of a polynomial in one variable, of any degree.
//!
//! A root α in K has an image in the p-adic numbers for every prime p modulo which the radicands are squares: a root
//! of the image of f. Those are found modulo p and lifted by Newton's iteration (Hensel), and α is recognised in its
//! image: a short relation b·α = Σ a_S·√ΠS is a short vector of a lattice. What is recognised is verified over K; and from
//! a certain precision on, which [`enough`] derives, a root that was not recognised is none in K. So the search is complete.

use super::field::{FieldElement, MultiquadraticField};
use super::integer::Integer;
use super::lattice::short_vector;
use super::prime_field::{PrimeField, splitting_primes};
use super::residue_polynomial::ResiduePolynomial;
use super::univariate::Univariate;

/// Primes that are looked at. Modulo one of them a polynomial without roots in K has in general no root either.
const PRIMES: usize = 24;

/// Primes that may spoil simple roots before multiple ones are suspected.
const UNLUCKY: usize = 3;

impl Univariate {
    /// The distinct roots in K, all of them, simple ones first; none for a constant.
    ///
    /// `check` is asked in every loop. The work is polynomial in the degree and the length of the coefficients.
    ///
    /// # Errors
    /// What `check` says.
    pub fn roots_in_field<E>(
        &self,
        mut check: impl FnMut() -> Result<(), E>,
    ) -> Result<Vec<FieldElement>, E> {
        let mut rest = if self.seems_squarefree() { self.clone() } else { self.squarefree(&mut check)? };
        let mut roots = Vec::new();
        while rest.degree() > 2 {
            match find(&rest, &mut check)? {
                Some(root) => {
                    rest = rest.without_root(&root);
                    roots.push(root);
                }
                None => break,
            }
        }
        roots.sort_by_cached_key(|root| (height(root), root.numerators().to_vec()));
        if rest.degree() <= 2 {
            roots.extend(rest.quadratic_roots());
        }
        Ok(roots)
    }

    /// Whether the roots are simple modulo some prime, which proves it.
    fn seems_squarefree(&self) -> bool {
        let integral = integral(self);
        splitting_primes(self.field()).take(UNLUCKY).any(|prime| image(&integral, &prime).is_some())
    }
}

/// The bits of all coordinates.
fn height(value: &FieldElement) -> u64 {
    value.numerators().iter().chain([value.denominator()]).map(Integer::bits).sum()
}

/// The coefficients times the positive integer that makes their coordinates integers without a common divisor.
fn integral(polynomial: &Univariate) -> Vec<Vec<Integer>> {
    let of = polynomial.coefficients();
    let multiple = of.iter().fold(Integer::one(), |lcm, c| lcm.lcm(c.denominator()));
    let scaled = |c: &FieldElement| -> Vec<Integer> {
        let factor = multiple.exact_quotient(c.denominator());
        c.numerators().iter().map(|numerator| numerator * &factor).collect()
    };
    let scaled: Vec<Vec<Integer>> = of.iter().map(scaled).collect();
    let divisor = scaled.iter().flatten().fold(Integer::zero(), |gcd, n| gcd.gcd(n));
    let reduced = |c: &Vec<Integer>| c.iter().map(|n| n.exact_quotient(&divisor)).collect();
    if divisor.is_zero() { scaled } else { scaled.iter().map(reduced).collect() }
}

/// The image modulo p, if it has the same degree and simple roots only.
fn image<'a>(integral: &[Vec<Integer>], prime: &'a PrimeField) -> Option<ResiduePolynomial<'a>> {
    let residues = integral.iter().map(|c| prime.combine(c)).collect();
    let image = ResiduePolynomial::new(prime, residues);
    (image.degree() + 1 == integral.len() && image.is_squarefree()).then_some(image)
}

/// A root in K of a squarefree polynomial that is not constant, or `None` if there is none.
fn find<E>(f: &Univariate, check: &mut impl FnMut() -> Result<(), E>) -> Result<Option<FieldElement>, E> {
    let integral = integral(f);
    // Of several primes the one with the fewest roots; if one has none, there is none in K.
    let mut best: Option<(PrimeField, Vec<u64>)> = None;
    let mut looked_at = 0;
    for prime in splitting_primes(f.field()) {
        check()?;
        let Some(image) = image(&integral, &prime) else { continue };
        let roots = image.roots();
        if roots.is_empty() {
            return Ok(None);
        }
        looked_at += 1;
        if best.as_ref().is_none_or(|(_, fewest)| roots.len() < fewest.len()) {
            best = Some((prime, roots));
        }
        if looked_at >= PRIMES {
            break;
        }
    }
    let Some((prime, roots)) = best else { return Ok(None) };
    let mut lifted: Vec<Lifted> =
        roots.iter().map(|&root| Lifted::new(&integral, &prime, f.field(), root)).collect();
    let enough = enough(&integral, f.field());
    // Shortest precision first: the roots that people plant are short.
    while !lifted.is_empty() {
        for root in &mut lifted {
            let candidate = root.recognise(check)?;
            if let Some(candidate) = candidate.filter(|value| f.evaluate(value).is_zero()) {
                return Ok(Some(candidate));
            }
        }
        lifted.retain(|root| root.modulus.bits() <= enough);
        for root in &mut lifted {
            check()?;
            root.double();
        }
    }
    Ok(None)
}

/// Bits of a power of p that suffice to recognise every root in K of f = ℓxᵈ + …, whose coefficients are integral.
///
/// Let n be the degree of K, D the product of the radicands, and H at least 1 and at least every conjugate of every
/// coefficient. The norm N of ℓ is an integer, at most Hⁿ, and Nα is an algebraic integer; its traces with the √ΠS
/// show that c = n·D·N times α has integer coordinates. A conjugate of ℓ is at least H¹⁻ⁿ, so those of α are at most
/// R = 2Hⁿ (Cauchy's bound), and so are its coordinates. The lattice of all (b, a) with b·α ≡ Σ a_S·√ΠS contains
/// (c, cα), of length at most B = c·R·(n + 1); the vector found is at most 2^(n/2)·B long. Then c·(bα − Σ a_S·√ΠS) is an
/// algebraic integer with conjugates up to G = c·2^(n/2)·B·(R + Σ√ΠS), and divisible by pᵐ in one embedding. If pᵐ > Gⁿ,
/// its norm and it itself are 0, and b ≠ 0: the vector gives α.
fn enough(integral: &[Vec<Integer>], field: MultiquadraticField) -> u64 {
    let n = field.degree() as u64;
    let root_bound = |subset: usize| &field.under_root(subset).floor_sqrt() + &Integer::one();
    let roots: Vec<Integer> = (0..field.degree()).map(root_bound).collect();
    let conjugate = |c: &Vec<Integer>| {
        c.iter().zip(&roots).fold(Integer::one(), |sum, (a, root)| &sum + &(&a.abs() * root)).bits()
    };
    let h = integral.iter().map(conjugate).max().unwrap_or(1);
    let c = n.ilog2() as u64 + 1 + field.under_root(field.degree() - 1).bits() + n * h;
    let r = 1 + n * h;
    let b = c + r + (n + 1).ilog2() as u64 + 1;
    let sum_of_roots = roots.iter().fold(Integer::zero(), |sum, root| &sum + root).bits();
    let g = c + n / 2 + 1 + b + r + sum_of_roots + 1;
    n * g + 1
}

/// A root of the image of f modulo a power of p.
struct Lifted<'a> {
    /// The coordinates of the coefficients of f.
    integral: &'a [Vec<Integer>],
    field: MultiquadraticField,
    /// A power of p.
    modulus: Integer,
    /// The root.
    root: Integer,
    /// 1/f′(root).
    inverse: Integer,
    /// For each radicand d the root √d, and 1/2√d.
    radicals: Vec<(Integer, Integer)>,
}

impl<'a> Lifted<'a> {
    fn new(integral: &'a [Vec<Integer>], prime: &PrimeField, field: MultiquadraticField, root: u64) -> Self {
        let integer = |residue: u64| Integer::from(i128::from(residue));
        let radicals = (0..field.radicands().len()).map(|bit| {
            let of_d = prime.root(1 << bit);
            (integer(of_d), integer(prime.inverse(prime.remainder(2 * of_d))))
        });
        let mut lifted = Lifted {
            integral,
            field,
            modulus: integer(prime.modulus()),
            root: integer(root),
            inverse: Integer::zero(),
            radicals: radicals.collect(),
        };
        let slope = lifted.value_and_slope().1.residue(prime.modulus());
        lifted.inverse = integer(prime.inverse(slope));
        lifted
    }

    /// The image of √ΠS, by subset.
    fn basis(&self) -> Vec<Integer> {
        let mut basis = vec![Integer::one()];
        for (root, _) in &self.radicals {
            let doubled: Vec<Integer> =
                basis.iter().map(|product| (product * root).modulo(&self.modulus)).collect();
            basis.extend(doubled);
        }
        basis
    }

    fn value_and_slope(&self) -> (Integer, Integer) {
        let basis = self.basis();
        let mut value = Integer::zero();
        let mut slope = Integer::zero();
        for c in self.integral.iter().rev() {
            let image = c.iter().zip(&basis).fold(Integer::zero(), |sum, (a, root)| &sum + &(a * root));
            slope = (&(&slope * &self.root) + &value).modulo(&self.modulus);
            value = (&(&value * &self.root) + &image).modulo(&self.modulus);
        }
        (value, slope)
    }

    /// Twice as many digits.
    fn double(&mut self) {
        self.modulus = &self.modulus * &self.modulus;
        let modulus = self.modulus.clone();
        let two = Integer::from(2u32);
        // Newton for 1/a is x(2 − ax), and with it Newton for the root itself.
        let better = |x: &Integer, a: &Integer| (x * &(&two - &(a * x).modulo(&modulus))).modulo(&modulus);
        for ((root, inverse), &d) in self.radicals.iter_mut().zip(self.field.radicands()) {
            let square = &(&*root * &*root) - &Integer::from(d);
            *root = (&*root - &(&square * &*inverse)).modulo(&modulus);
            *inverse = better(inverse, &root.times(2));
        }
        let (value, _) = self.value_and_slope();
        self.root = (&self.root - &(&value * &self.inverse)).modulo(&modulus);
        let (_, slope) = self.value_and_slope();
        self.inverse = better(&self.inverse, &slope);
    }

    /// The element of K that a short relation gives.
    fn recognise<E>(&self, check: &mut impl FnMut() -> Result<(), E>) -> Result<Option<FieldElement>, E> {
        // (b, a₀, a₁, …) with b·root ≡ Σ a_S·√ΠS; √Π∅ = 1.
        let basis = self.basis();
        let size = basis.len() + 1;
        let unit = |k: usize| -> Vec<Integer> {
            (0..size).map(|j| if j == k { Integer::one() } else { Integer::zero() }).collect()
        };
        let mut lattice = vec![unit(1).iter().map(|entry| entry * &self.modulus).collect::<Vec<_>>()];
        for (k, image) in (2..).zip(&basis[1..]) {
            let mut vector = unit(k);
            vector[1] = -image;
            lattice.push(vector);
        }
        let mut vector = unit(0);
        vector[1] = self.root.clone();
        lattice.push(vector);
        let short = short_vector(lattice, check)?;
        let Some((b, a)) = short.split_first().filter(|(b, _)| !b.is_zero()) else { return Ok(None) };
        Ok(Some(self.field.element(a.to_vec(), b.clone())))
    }
}
