//! Laws of the two algebras, and that they agree with each other.

use std::convert::Infallible;

use num_rational::BigRational;
use proptest::prelude::*;
use prove_cap::algebra::{
    FieldElement, Integer, Monomial, MultiquadraticField, Polynomial, Univariate, polynomial_from_exact,
    polynomial_to_exact, splitting_primes,
};
use prove_cap::exact::{self, Arithmetic, Radicands, Ring, Work};

const RADICANDS: [u32; 3] = [2, 3, 5];

fn field() -> MultiquadraticField {
    MultiquadraticField::new(&RADICANDS)
}

fn radicands() -> Radicands {
    Radicands::new(RADICANDS.to_vec()).unwrap()
}

fn ring() -> Ring {
    Ring { field: radicands(), variables: ["x", "y", "z"].map(String::from).to_vec() }
}

prop_compose! {
    fn element()(numerators in prop::collection::vec(-9i64..10, 8), denominator in prop_oneof![-12i64..0, 1i64..13])
        -> FieldElement {
        field().element(numerators.into_iter().map(Integer::from).collect(), Integer::from(denominator))
    }
}

prop_compose! {
    fn monomial()(exponents in prop::collection::vec(0u32..4, 3)) -> Monomial {
        let powers = (0u16..).zip(exponents).filter(|&(_, exponent)| exponent > 0);
        Monomial::from_powers(powers.collect())
    }
}

prop_compose! {
    fn polynomial()(terms in prop::collection::vec((monomial(), element()), 0..5)) -> Polynomial {
        Polynomial::from_terms(field(), terms)
    }
}

fn constant(value: &FieldElement) -> exact::Polynomial {
    polynomial_to_exact(&Polynomial::constant(value.clone())).unwrap()
}

proptest! {
    #[test]
    fn field_axioms(a in element(), b in element(), c in element()) {
        prop_assert_eq!(&a + &b, &b + &a);
        prop_assert_eq!(&(&a + &b) + &c, &a + &(&b + &c));
        prop_assert_eq!(&a * &b, &b * &a);
        prop_assert_eq!(&(&a * &b) * &c, &a * &(&b * &c));
        prop_assert_eq!(&a * &(&b + &c), &(&a * &b) + &(&a * &c));
        prop_assert_eq!(&a + &field().zero(), a.clone());
        prop_assert_eq!(&a * &field().one(), a.clone());
        prop_assert!((&a - &a).is_zero());
        match a.inverse() {
            Some(inverse) => prop_assert!((&a * &inverse).is_one()),
            None => prop_assert!(a.is_zero()),
        }
    }

    #[test]
    fn order_axioms(a in monomial(), b in monomial(), c in monomial()) {
        prop_assert!(Monomial::one() <= a);
        prop_assert_eq!(a.cmp(&b), b.cmp(&a).reverse());
        prop_assert_eq!(a.cmp(&b), a.product(&c).cmp(&b.product(&c)));
        prop_assert_eq!(a.cmp(&b) == std::cmp::Ordering::Equal, a == b);
    }

    #[test]
    fn monomials_divide_their_products(a in monomial(), b in monomial()) {
        prop_assert_eq!(a.product(&b).quotient(&a), Some(b.clone()));
        prop_assert!(a.lcm(&b).quotient(&a).is_some() && a.lcm(&b).quotient(&b).is_some());
        prop_assert_eq!(a.lcm(&b) == a.product(&b), a.is_coprime_to(&b));
        prop_assert_eq!(a.product(&Monomial::variable(0)).product(&b).quotient(&a.product(&b).product(&Monomial::variable(1))), None);
    }

    #[test]
    fn polynomial_ring_axioms(f in polynomial(), g in polynomial(), h in polynomial()) {
        prop_assert_eq!(f.multiply(&g), g.multiply(&f));
        prop_assert_eq!(f.multiply(&g.add(&h)), f.multiply(&g).add(&f.multiply(&h)));
        prop_assert_eq!(f.multiply(&g).multiply(&h), f.multiply(&g.multiply(&h)));
        prop_assert!(f.add_scaled(&field().integer(-1), &f).is_zero());
        let leading = |p: &Polynomial| p.leading_term().map(|(m, _)| m.clone());
        if let (Some(m), Some(n)) = (leading(&f), leading(&g)) {
            prop_assert_eq!(leading(&f.multiply(&g)), Some(m.product(&n)));
        }
    }

    /// The prover's vectors of integers and the checker's sums of rationals are two ways to the same result.
    #[test]
    fn the_two_algebras_agree(f in polynomial(), g in polynomial()) {
        let (field, mut work) = (radicands(), Work::full());
        let (a, b) = (polynomial_to_exact(&f).unwrap(), polynomial_to_exact(&g).unwrap());
        let product = Arithmetic::new(&field, &mut work).product(&a, &b).unwrap();
        prop_assert_eq!(&product, &polynomial_to_exact(&f.multiply(&g)).unwrap());
        let sum = Arithmetic::new(&field, &mut work).sum(&[a, b]).unwrap();
        prop_assert_eq!(&sum, &polynomial_to_exact(&f.add(&g)).unwrap());
        prop_assert_eq!(polynomial_from_exact(f.field(), &product), f.multiply(&g));
    }

    #[test]
    fn the_two_inverses_agree(a in element()) {
        let inverse = Arithmetic::new(&radicands(), &mut Work::full()).inverse(&constant(&a)).unwrap();
        prop_assert_eq!(inverse, a.inverse().map(|inverse| constant(&inverse)));
    }

    #[test]
    fn spelling_is_read_back(f in polynomial()) {
        let exact = polynomial_to_exact(&f).unwrap();
        let text = ring().spell(&exact);
        prop_assert_eq!(ring().read(&text, &mut Work::full()).unwrap(), exact);
    }

    /// Whatever the reader accepts, it accepts in one spelling only.
    #[test]
    fn no_other_spelling_is_accepted(f in polynomial(), at in 0usize..60, byte in 32u8..127) {
        let text = ring().spell(&polynomial_to_exact(&f).unwrap());
        let mut mutant = text.into_bytes();
        let at = at % mutant.len();
        mutant[at] = byte;
        let mutant = String::from_utf8(mutant).unwrap();
        if let Ok(read) = ring().read(&mutant, &mut Work::full()) {
            prop_assert_eq!(ring().spell(&read), mutant);
        }
    }

    /// The sign against an enclosure by rational bounds of the roots.
    #[test]
    fn signs_are_those_of_an_enclosure(a in element(), b in element()) {
        // a·a − b·b·(…) gets close to zero more often than random elements do.
        for value in [a.clone(), &a - &b, &(&a * &a) - &(&b * &b)] {
            let sign = Arithmetic::new(&radicands(), &mut Work::full()).sign(&constant(&value)).unwrap().unwrap();
            let (low, high) = enclosure(&value);
            if value.is_zero() {
                prop_assert_eq!(sign, std::cmp::Ordering::Equal);
            } else {
                let zero = BigRational::from_integer(0.into());
                prop_assert!(low > zero || high < zero, "200 bits must decide such small numbers");
                prop_assert_eq!(sign == std::cmp::Ordering::Greater, low > zero);
            }
        }
    }

    /// Reduction modulo a splitting prime is a homomorphism.
    #[test]
    fn reduction_is_a_homomorphism(a in element(), b in element()) {
        let prime = splitting_primes(field()).next().unwrap();
        let image = |value: &FieldElement| prime.reduce(value).unwrap();
        prop_assert_eq!(image(&(&a * &b)), prime.multiply(image(&a), image(&b)));
        let minus = prime.modulus() - 1;
        let difference = prime.subtract_product(image(&a), prime.multiply(minus, image(&b)), 1);
        prop_assert_eq!(image(&(&a + &b)), difference);
    }
}

/// Rational bounds from integer square roots, 200 bits after the point.
fn enclosure(value: &FieldElement) -> (BigRational, BigRational) {
    use num_bigint::BigInt;
    let scale: BigInt = BigInt::from(1) << 200u32;
    let (mut low, mut high) = (BigRational::from_integer(0.into()), BigRational::from_integer(0.into()));
    for (subset, numerator) in value.numerators().iter().enumerate() {
        let square = field().under_root(subset).to_bigint();
        let scaled: BigInt = square * &scale * &scale;
        let root = scaled.sqrt();
        let bounds =
            (BigRational::new(root.clone(), scale.clone()), BigRational::new(root + 1, scale.clone()));
        let factor = BigRational::new(numerator.to_bigint(), value.denominator().to_bigint());
        let negative = numerator.is_negative();
        let (below, above) = if negative { (bounds.1, bounds.0) } else { bounds };
        low += &factor * below;
        high += &factor * above;
    }
    (low, high)
}

#[test]
fn square_roots_are_found_where_they_are() {
    let field = MultiquadraticField::new(&[2, 3]);
    let rational = |n: i64, d: i64| field.rational(Integer::from(n), Integer::from(d));
    for (n, d) in [(4, 3), (2, 3), (6, 1), (1, 12), (0, 1), (49, 50)] {
        let root = rational(n, d).square_root().unwrap();
        assert_eq!(&root * &root, rational(n, d));
    }
    for (n, d) in [(5, 1), (7, 3), (-4, 3)] {
        assert_eq!(rational(n, d).square_root(), None, "√({n}/{d})");
    }
}

#[test]
fn all_monomials_of_a_degree_are_there_once_and_in_order() {
    let found = Monomial::all_of_degree(&[0, 1, 4], 5);
    assert_eq!(found.len(), 21, "C(5+2, 2)");
    assert!(found.is_sorted_by(|a, b| a < b));
    assert!(found.iter().all(|monomial| monomial.degree() == 5));
}

#[test]
fn splitting_primes_split() {
    for prime in splitting_primes(field()).take(5) {
        assert_eq!(prime.modulus() % 4, 3);
        for radicand in RADICANDS {
            let root = field().integer(radicand.into()).square_root().unwrap();
            let image = prime.reduce(&root).unwrap();
            assert_eq!(prime.multiply(image, image), u64::from(radicand));
        }
    }
}

#[test]
fn a_denominator_of_zero_is_refused() {
    let element = std::panic::catch_unwind(|| field().rational(Integer::one(), Integer::zero()));
    assert!(element.is_err());
    assert_eq!(field().zero().inverse(), None);
}

proptest! {
    /// Squares have roots; and a root found is one.
    #[test]
    fn square_roots_of_squares(a in element()) {
        let root = (&a * &a).square_root().unwrap();
        prop_assert!(root == a || root == -&a);
        if let Some(root) = a.square_root() {
            prop_assert_eq!(&root * &root, a);
        }
    }

    /// The real roots of a product of known factors, counted once each.
    #[test]
    fn real_roots_are_counted(roots in prop::collection::vec(element(), 0..4), twice in any::<bool>(), pairs in 0usize..2) {
        let one = field().one();
        let times = |f: &[FieldElement], g: &[FieldElement]| {
            let mut product = vec![field().zero(); f.len() + g.len() - 1];
            for (i, a) in f.iter().enumerate() {
                for (j, b) in g.iter().enumerate() {
                    product[i + j] = &product[i + j] + &(a * b);
                }
            }
            product
        };
        let mut product = vec![one.clone()];
        for root in &roots {
            for _ in 0..if twice { 2 } else { 1 } {
                product = times(&product, &[-root, one.clone()]);
            }
        }
        for _ in 0..pairs {
            // x² + 2 has no real root.
            product = times(&product, &[field().integer(2), field().zero(), one.clone()]);
        }
        let polynomial = Univariate::new(field(), product);
        let distinct: std::collections::HashSet<_> = roots.iter().collect();
        prop_assert_eq!(polynomial.count_real_roots(|| Ok::<_, ()>(())), Ok(distinct.len()));
        prop_assert_eq!(polynomial.squarefree(|| Ok::<_, ()>(())).unwrap().degree(), distinct.len() + 2 * pairs.min(1));
        prop_assert!(roots.iter().all(|root| polynomial.evaluate(root).is_zero()));
        let found = polynomial.roots_in_field(|| Ok::<(), Infallible>(())).unwrap();
        prop_assert!(found.iter().all(|root| polynomial.evaluate(root).is_zero()));
        prop_assert_eq!(found.iter().collect::<std::collections::HashSet<_>>(), distinct);
    }
}

#[test]
fn square_roots_that_mix_radicals() {
    let k = MultiquadraticField::new(&[2, 3]);
    let element = |n: [i64; 4]| k.element(n.map(Integer::from).to_vec(), Integer::one());
    // (√2 + √3)² = 5 + 2√6, and 1 + √2 has no root in K.
    assert_eq!(element([5, 0, 0, 2]).square_root().map(|r| &r * &r), Some(element([5, 0, 0, 2])));
    assert_eq!(element([1, 1, 0, 0]).square_root(), None);
    assert_eq!(element([-2, 0, 0, 0]).square_root(), None);
}

/// (√2 − 1)ⁿ and other numbers that cancel to nearly nothing have the sign that the trusted part finds, and so have their negatives.
#[test]
fn signs_of_numbers_near_zero() {
    use prove_cap::algebra::Sign;
    let field = field();
    let root = |n: i64| field.integer(n).square_root().unwrap();
    let unit = &root(2) - &field.one();
    let other = &root(5) - &field.integer(2);
    let mut power = field.one();
    for n in 0..40 {
        power = &power * &if n % 2 == 0 { unit.clone() } else { other.clone() };
        assert_eq!((power.sign(), (-&power).sign()), (Sign::Positive, Sign::Negative), "{n}");
        // Not the signs of the coordinates: one of these is near zero.
        let conjugate = &power - &(&power * &root(3));
        assert_eq!(conjugate.sign(), Sign::Negative, "{n}");
        assert_eq!((&conjugate - &conjugate).sign(), Sign::Zero);
    }
}

proptest! {
    #[test]
    fn signs_are_those_of_the_trusted_part(a in element(), b in element(), c in element()) {
        use std::cmp::Ordering;
        use prove_cap::algebra::Sign;
        let value = &(&a * &b) - &(&b * &(&a + &(&c * &c)));
        let exact = polynomial_to_exact(&Polynomial::constant(value.clone())).unwrap();
        let trusted = Arithmetic::new(&radicands(), &mut Work::full()).sign(&exact).unwrap().unwrap();
        let own = match value.sign() {
            Sign::Negative => Ordering::Less,
            Sign::Zero => Ordering::Equal,
            Sign::Positive => Ordering::Greater,
        };
        prop_assert_eq!(own, trusted);
    }
}
