//! Zeros in K are found wherever there are finitely many: random systems with a planted zero, and roots in one variable.

use std::convert::Infallible;

use prove_cap::algebra::{FieldElement, Integer, MultiquadraticField, Univariate};
use prove_cap::control::Control;
use prove_cap::prove::{Attempt, prove};
use prove_cap::statement::Statement;

/// A linear congruential generator (Knuth, TAOCP 2, section 3.3.4).
struct Generator(u64);

impl Generator {
    /// An integer from −size to size.
    fn next(&mut self, size: i64) -> i64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as i64 % (2 * size + 1) - size
    }

    /// A number of K of small height.
    fn number(&mut self, radicands: &[u32]) -> String {
        let mut text = format!("{}/{}", self.next(4), self.next(1) + 2);
        for d in radicands {
            text += &format!(" + ({}/{})*sqrt({d})", self.next(2), self.next(1) + 2);
        }
        text
    }

    /// A polynomial of this degree, in x0, x1, …, less its value where they are `zero`.
    fn polynomial(&mut self, zero: &[String], degree: u32) -> String {
        let mut terms = Vec::new();
        for k in 0..zero.len() {
            terms.push((self.next(3) * 2 + 1, format!("x{k}^{degree}")));
        }
        for _ in 0..3 {
            let factors: Vec<String> = (0..degree)
                .map(|_| format!("x{}", self.next(60).unsigned_abs() as usize % zero.len()))
                .collect();
            let count = 1 + self.next(60).unsigned_abs() as usize % factors.len();
            terms.push((self.next(5), factors[..count].join("*")));
        }
        let polynomial: String = terms.iter().map(|(c, monomial)| format!(" + ({c})*{monomial}")).collect();
        let value = (0..zero.len())
            .fold(polynomial.clone(), |text, k| text.replace(&format!("x{k}"), &format!("({})", zero[k])));
        format!("0{polynomial} - (0{value})")
    }
}

#[test]
fn a_planted_zero_is_found() {
    let mut generator = Generator(1);
    let mut undecided = Vec::new();
    for radicands in [vec![], vec![2], vec![5], vec![2, 3]] {
        for (unknowns, degree) in [(1, 3), (1, 5), (1, 6), (2, 2), (2, 3), (3, 2), (4, 2)] {
            for equations in [unknowns, unknowns + 1, unknowns + 2] {
                let zero: Vec<String> = (0..unknowns).map(|_| generator.number(&radicands)).collect();
                let polynomials: Vec<String> =
                    (0..equations).map(|_| generator.polynomial(&zero, degree)).collect();
                let names: Vec<String> = (0..unknowns).map(|k| format!("x{k}")).collect();
                let text = format!(
                    "title = \"planted\"\nradicands = {radicands:?}\nunknowns = {names:?}\npolynomials = {polynomials:?}\n"
                );
                let statement = Statement::read(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
                match prove(&statement, &Control::default()).unwrap() {
                    Attempt::Proved { proof, .. } => assert_eq!(proof.theorem().kind(), "solution"),
                    Attempt::Undecided(_) => undecided.push(text),
                }
            }
        }
    }
    assert!(undecided.is_empty(), "{} undecided: {}", undecided.len(), undecided[0]);
}

/// The product of polynomials given by their integral coefficients, c₀ first.
fn product(field: MultiquadraticField, factors: &[&[i64]]) -> Univariate {
    let mut product = vec![field.one()];
    for factor in factors {
        let mut next = vec![field.zero(); product.len() + factor.len() - 1];
        for (i, a) in product.iter().enumerate() {
            for (j, &b) in factor.iter().enumerate() {
                next[i + j] = &next[i + j] + &(a * &field.integer(b));
            }
        }
        product = next;
    }
    Univariate::new(field, product)
}

fn roots(f: &Univariate) -> Vec<FieldElement> {
    let Ok(roots) = f.roots_in_field(|| Ok::<(), Infallible>(()));
    for root in &roots {
        assert!(f.evaluate(root).is_zero());
    }
    roots
}

#[test]
fn roots_modulo_every_prime_are_no_roots() {
    // One of 2, 3 and 6 is a square modulo every prime, and x⁴ + 1 is reducible modulo every prime.
    let factors: &[&[i64]] = &[&[-2, 0, 1], &[-3, 0, 1], &[-6, 0, 1]];
    let count = |radicands: &[u32]| roots(&product(MultiquadraticField::new(radicands), factors)).len();
    assert_eq!((count(&[]), count(&[5]), count(&[2]), count(&[2, 3])), (0, 0, 2, 6));
    let q = MultiquadraticField::new(&[]);
    assert_eq!(roots(&product(q, &[&[1, 0, 0, 0, 1]])), []);
    // √2 + √3 and its conjugates need both.
    let minimal: &[i64] = &[1, 0, -10, 0, 1];
    let count = |radicands: &[u32]| roots(&product(MultiquadraticField::new(radicands), &[minimal])).len();
    assert_eq!((count(&[]), count(&[2]), count(&[3]), count(&[2, 3]), count(&[2, 3, 5])), (0, 0, 0, 4, 4));
    assert_eq!(roots(&product(q, &[&[7]])), []);
    assert_eq!(roots(&product(q, &[])), []);
}

#[test]
fn long_and_multiple_roots_are_found() {
    let k = MultiquadraticField::new(&[2, 5]);
    let long = |text: i64| Integer::from(text).power(12);
    let planted = k.element(vec![long(-97), long(11), Integer::from(3u32), long(89)], long(101));
    // (x − planted)·(x³ − 5)·x²
    let times = |f: Vec<FieldElement>, root: &FieldElement| {
        let mut next = vec![k.zero(); f.len() + 1];
        for (i, c) in f.iter().enumerate() {
            next[i + 1] = &next[i + 1] + c;
            next[i] = &next[i] - &(c * root);
        }
        next
    };
    let cubic = vec![k.integer(-5), k.zero(), k.zero(), k.one()];
    let all = [&planted, &k.zero(), &k.zero()].into_iter().fold(cubic, times);
    assert_eq!(roots(&Univariate::new(k, all)), [k.zero(), planted]);
}

#[test]
fn a_search_for_roots_stops_when_asked() {
    let f = product(MultiquadraticField::new(&[]), &[&[-4, -2, 0, 1]]);
    assert_eq!(f.roots_in_field(|| Err("stop")), Err("stop"));
}
