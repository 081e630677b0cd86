//! Square roots of elements of K: the laws they obey, what is refused and why, and that all readers agree.

use std::cmp::Ordering;

use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use prove_cap::algebra::{MultiquadraticField, polynomial_from_exact};
use prove_cap::exact::{Monomial, NoRoot, Polynomial, Radicands, Ring, Work, sign};
use prove_cap::formats::listing::{Expression, Scope};
use prove_cap::report::Notation;
use prove_cap::statement::{Statement, StatementFault};

const PRIMES: [u32; 7] = [2, 3, 5, 7, 11, 101, 999_983];

/// K with up to four radicands, and elements of it.
fn elements(count: usize) -> impl Strategy<Value = (Radicands, Vec<Polynomial>)> {
    let primes = prop::sample::subsequence(PRIMES.to_vec(), 0..=4).prop_shuffle();
    let numbers = prop::collection::vec((-9i64..=9, 1i64..=6), 16 * count);
    (primes, numbers).prop_map(move |(primes, numbers)| {
        let field = Radicands::new(primes).unwrap();
        let masks: Vec<u8> = field.masks().collect();
        let element = |numbers: &[(i64, i64)]| {
            let terms = masks.iter().zip(numbers).map(|(&mask, &(n, d))| {
                (Monomial::radical(mask), BigRational::new(BigInt::from(n), BigInt::from(d)))
            });
            Polynomial::from_terms(terms)
        };
        let all = numbers.chunks(16).map(element).collect();
        (field, all)
    })
}

fn times(a: &Polynomial, b: &Polynomial, field: &Radicands) -> Polynomial {
    a.multiply(b, field, &mut Work::full()).unwrap()
}

fn sign_of(a: &Polynomial, field: &Radicands) -> Ordering {
    sign(a, field, &mut Work::full()).unwrap().unwrap()
}

fn absolute(a: &Polynomial, field: &Radicands) -> Polynomial {
    if sign_of(a, field) == Ordering::Less { a.negate() } else { a.clone() }
}

fn root(a: &Polynomial, field: &Radicands) -> Result<Polynomial, NoRoot> {
    a.square_root(field, &mut Work::full()).unwrap()
}

fn ring(field: &Radicands) -> Ring {
    Ring { field: field.clone(), variables: vec![] }
}

/// The kernel's reader.
fn read(text: &str, field: &Radicands) -> Result<Polynomial, StatementFault> {
    Statement::read_constant(text, field, &mut Work::full()).map_err(|error| error.fault)
}

/// A prime that is not in the field.
fn foreign(field: &Radicands) -> u32 {
    *PRIMES.iter().find(|prime| !field.values().contains(prime)).unwrap()
}

proptest! {
    #[test]
    fn the_root_of_a_square_is_the_absolute_value((field, x) in elements(1)) {
        let square = times(&x[0], &x[0], &field);
        prop_assert_eq!(root(&square, &field), Ok(absolute(&x[0], &field)));
    }

    #[test]
    fn roots_multiply((field, x) in elements(2)) {
        let square = |x: &Polynomial| times(x, x, &field);
        let product = times(&square(&x[0]), &square(&x[1]), &field);
        let roots = [&x[0], &x[1]].map(|x| root(&square(x), &field).unwrap());
        prop_assert_eq!(root(&product, &field), Ok(times(&roots[0], &roots[1], &field)));
    }

    /// √(x²·n) = |x|·√n for a product n of radicands.
    #[test]
    fn radicands_have_roots((field, x) in elements(1), mask in 0u8..16) {
        let mask = mask & field.masks().last().unwrap();
        let n = Polynomial::integer(field.under_root(mask));
        let under = times(&times(&x[0], &x[0], &field), &n, &field);
        let radical = Polynomial::term(BigRational::from_integer(1.into()), Monomial::radical(mask));
        prop_assert_eq!(root(&under, &field), Ok(times(&absolute(&x[0], &field), &radical, &field)));
    }

    /// x²·p is no square in K where p is not; and it is one where p is declared, as the refusal says.
    #[test]
    fn a_foreign_prime_is_refused_and_named((field, x) in elements(1)) {
        prop_assume!(!x[0].is_zero());
        let prime = foreign(&field);
        let under = times(&times(&x[0], &x[0], &field), &Polynomial::integer(prime), &field);
        let room = field.values().len() < 4;
        let expected = if room { NoRoot::Radicands(vec![prime]) } else { NoRoot::Outside };
        // A prime is named where the factors of the number are found with little work.
        let refused = root(&under, &field).expect_err("a prime outside");
        prop_assert!(refused == expected || refused == NoRoot::Outside, "{:?}", refused);
        if room {
            let larger = Radicands::new([field.values(), &[prime]].concat()).unwrap();
            let spelled = |x: &Polynomial| ring(&field).spell(x);
            let root = read(&format!("sqrt({})", spelled(&under)), &larger).unwrap();
            let expected = read(&format!("({})*sqrt({prime})", spelled(&x[0])), &larger).unwrap();
            prop_assert_eq!(root, absolute(&expected, &larger));
        }
    }

    #[test]
    fn negative_numbers_have_none((field, x) in elements(2)) {
        for x in x {
            match sign_of(&x, &field) {
                Ordering::Less => prop_assert_eq!(root(&x, &field), Err(NoRoot::Negative)),
                Ordering::Equal => prop_assert_eq!(root(&x, &field), Ok(Polynomial::zero())),
                Ordering::Greater => prop_assert_ne!(root(&x, &field), Err(NoRoot::Negative)),
            }
        }
    }

    /// The order in which radicands are listed, and further radicands, change nothing of a root.
    #[test]
    fn the_field_may_be_listed_and_extended_as_one_likes((field, x) in elements(1)) {
        let text = format!("sqrt({})", ring(&field).spell(&times(&x[0], &x[0], &field)));
        let expected = ring(&field).spell(&absolute(&x[0], &field));
        let reversed = Radicands::new(field.values().iter().rev().copied().collect()).unwrap();
        prop_assert_eq!(ring(&reversed).spell(&read(&text, &reversed).unwrap()), expected.clone());
        if field.values().len() < 4 {
            let larger = Radicands::new([field.values(), &[foreign(&field)]].concat()).unwrap();
            prop_assert_eq!(ring(&larger).spell(&read(&text, &larger).unwrap()), expected);
        }
    }

    /// The prover's own roots, in its own arithmetic: they exist where the kernel's do, and are these up to sign. A refusal
    /// that names radicands, or none at all, is right.
    #[test]
    fn the_prover_agrees((field, x) in elements(2), factor in prop::sample::select(vec![1u32, 2, 3, 5, 6])) {
        let square = times(&x[1], &x[1], &field);
        let some = [x[0].clone(), square.clone(), times(&square, &Polynomial::integer(factor), &field)];
        let of = MultiquadraticField::new(field.values());
        for value in some.iter().flat_map(|x| [x.clone(), x.negate()]) {
            let computed = polynomial_from_exact(of, &value).as_constant().unwrap().square_root();
            match root(&value, &field) {
                Ok(root) => {
                    let root = polynomial_from_exact(of, &root).as_constant().unwrap();
                    prop_assert!(computed.as_ref() == Some(&root) || computed == Some(-&root));
                    prop_assert_eq!(sign_of(&value, &field) != Ordering::Less, true);
                }
                Err(NoRoot::Radicands(more)) => {
                    prop_assert_eq!(computed, None);
                    let larger = Radicands::new([field.values(), &more].concat()).unwrap();
                    let text = ring(&field).spell(&value);
                    let root = read(&format!("sqrt({text})"), &larger).unwrap();
                    prop_assert_eq!(times(&root, &root, &larger), read(&text, &larger).unwrap());
                }
                Err(_) => prop_assert_eq!(computed, None),
            }
        }
    }

    /// The readers of statements and of printed formulas see the same number, nested roots among others, in the spelling
    /// of certificates and as it is printed.
    #[test]
    fn all_readers_agree((field, x) in elements(2)) {
        let notation = Notation::new(ring(&field));
        let printed = |text: &str| {
            let expression = Expression::read(text, 0..text.len()).unwrap();
            expression.value(text, &Scope::of(&field, &[]), &mut Work::full()).unwrap()
        };
        let square = times(&x[1], &x[1], &field);
        for value in [&x[0], &x[1], &square] {
            let spelled = ring(&field).spell(value);
            prop_assert_eq!(&read(&spelled, &field).unwrap(), value);
            prop_assert_eq!(&printed(&spelled), value);
            prop_assert_eq!(&printed(&notation.polynomial(value)), value);
        }
        let nested = format!("1/3 - 2*sqrt({}) + sqrt(49)", ring(&field).spell(&square));
        prop_assert_eq!(read(&nested, &field).unwrap(), printed(&nested));
        let under = format!("√({})", notation.polynomial(&square));
        prop_assert_eq!(printed(&under), absolute(&x[1], &field));
    }
}

fn field(radicands: &[u32]) -> Radicands {
    Radicands::new(radicands.to_vec()).unwrap()
}

#[test]
fn known_roots() {
    for (radicands, under, expected) in [
        (&[2, 5][..], "17 + 12*sqrt(2)", "3 + 2*sqrt(2)"),
        (&[2, 5], "9 - 4*sqrt(5)", "-2 + sqrt(5)"),
        (&[2, 3], "2 + sqrt(3)", "1/2*sqrt(2) + 1/2*sqrt(6)"),
        (&[2, 3, 5], "5 + 2*sqrt(6)", "sqrt(2) + sqrt(3)"),
        (&[2, 3], "sqrt(16)*sqrt(4/9)/sqrt(2)^2", "2/3*sqrt(3)"),
        (&[2], "sqrt(17 + 12*sqrt(2))", "1 + sqrt(2)"),
        (
            &[2, 3, 5, 7],
            "(sqrt(2) + sqrt(3) - sqrt(5) - sqrt(7))^2",
            "-sqrt(2) - sqrt(3) + sqrt(5) + sqrt(7)",
        ),
        (&[], "0", "0"),
    ] {
        let field = field(radicands);
        let root = read(&format!("sqrt({under})"), &field).unwrap_or_else(|fault| panic!("{under}: {fault}"));
        assert_eq!(ring(&field).spell(&root), expected, "√({under})");
    }
}

/// What is refused, in full: each sentence is one that somebody could check by hand.
#[test]
fn refusals_say_what_is_so() {
    for (radicands, text, expected) in [
        (&[2][..], "sqrt(3)", "the square root of (3) is not in Q(√2); with 3 among the radicands it is"),
        (
            &[2],
            "sqrt(1/105)",
            "the square root of (1/105) is not in Q(√2); with 3 and 5 and 7 among the radicands it is",
        ),
        (&[2, 3], "sqrt(1/1155)", "the square root of (1/1155) is not in Q(√2,√3)"),
        (
            &[3],
            "sqrt(2 + sqrt(3))",
            "the square root of (2 + sqrt(3)) is not in Q(√3); with 2 among the radicands it is",
        ),
        (
            &[2],
            "sqrt(1 + sqrt(2))",
            "the square root of (1 + sqrt(2)) is not in Q(√2), nor in any field of square roots of rationals",
        ),
        (
            &[2],
            "sqrt(sqrt(2))",
            "the square root of (sqrt(2)) is not in Q(√2), nor in any field of square roots of rationals",
        ),
        (
            &[2],
            "sqrt(1 - sqrt(2))",
            "the square root of (1 - sqrt(2)) is not in Q(√2): the number is negative",
        ),
        (&[], "sqrt(0 - 4)", "the square root of (0 - 4) is not in Q: the number is negative"),
        (&[], "sqrt(1000000000039)", "the square root of (1000000000039) is not in Q"),
        (
            &[],
            "sqrt(1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1)",
            "the square root of (1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 + 1 +… is not in Q; with 13 among the radicands it is",
        ),
    ] {
        let fault = read(text, &field(radicands)).expect_err(text);
        assert_eq!(fault.to_string(), expected);
    }
    let system = "title = \"t\"\nradicands = []\nunknowns = [\"x\"]\npolynomials = [\"sqrt(x^2)\"]\n";
    let fault = Statement::read(system).expect_err("a root of an unknown").fault;
    assert_eq!(fault.to_string(), "the square root of (x^2) is not in Q: one takes roots of constants only");
}

/// A root spelled out and the same root left to the reader are one statement, with one hash.
#[test]
fn nested_roots_leave_no_trace_in_the_canonical_text() {
    let statement = |number: &str| {
        let text = format!(
            "title = \"t\"\nradicands = [2, 5]\nunknowns = [\"x\"]\npolynomials = [\"x - {number}\"]\n"
        );
        Statement::read(&text).unwrap()
    };
    let nested = statement("sqrt(17 + 12*sqrt(2))*sqrt(9 - 4*sqrt(5))");
    assert_eq!(nested.hash(), statement("(3 + 2*sqrt(2))*(sqrt(5) - 2)").hash());
}

/// Long numbers under roots are limits, or roots, in bounded time.
#[test]
fn roots_that_would_take_long_are_stopped() {
    let field = field(&[2, 3, 5, 7]);
    let digits = |n: usize| "7".repeat(n);
    let masks = [1, 2, 3, 5, 7, 6, 10, 14, 15, 21, 35, 30, 42, 70, 105, 210];
    for length in [40, 400, 4000] {
        let sum: Vec<String> =
            masks.iter().map(|n| format!("{}/{}*sqrt({n})", digits(length), n + 12)).collect();
        let text = format!("sqrt(({})^2)", sum.join(" + "));
        match read(&text, &field) {
            Ok(root) => assert_eq!(root, read(&sum.join(" + "), &field).unwrap()),
            Err(fault) => assert!(matches!(fault, StatementFault::Limit(_)), "{fault}"),
        }
    }
    // Each root halves the digits; the limit on digits holds for what comes out.
    let tower = format!("{}(1 + sqrt(2))^64{}", "sqrt(".repeat(6), ")".repeat(6));
    assert_eq!(ring(&field).spell(&read(&tower, &field).unwrap()), "1 + sqrt(2)");
    let many = vec!["sqrt(17 + 12*sqrt(2))"; 40_000].join(" + ");
    match read(&many, &field) {
        Ok(sum) => assert_eq!(ring(&field).spell(&sum), "120000 + 80000*sqrt(2)"),
        Err(fault) => assert!(matches!(fault, StatementFault::Limit(_)), "{fault}"),
    }
}
