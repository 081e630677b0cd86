//! The reader of printed formulas: what it reads, and that it reads back what we print.

use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use prove_cap::exact::{Monomial, Polynomial, Radicands, Ring, Work};
use prove_cap::formats::listing::{Listing, Notation, Scope};
use prove_cap::report::latex::{formula, prose};
use prove_cap::report::{self};

fn ring() -> Ring {
    let field = Radicands::new(vec![2, 3]).unwrap();
    Ring { field, variables: ["w", "z", "w11", "x_1"].map(String::from).to_vec() }
}

/// The value of a formula without its label.
fn value(notation: Notation, text: &str) -> Result<Polynomial, String> {
    let ring = ring();
    let text = format!("a_{{1}} = {text}");
    let formulas = notation.read(&text).map_err(|error| error.to_string())?;
    assert_eq!(formulas.len(), 1, "{text}");
    let scope = Scope::of(&ring.field, &ring.variables);
    formulas[0].expression.value(&text, &scope, &mut Work::full()).map_err(|error| error.to_string())
}

/// What a spelling means, in the canonical spelling.
fn meaning(notation: Notation, text: &str) -> String {
    ring().spell(&value(notation, text).unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn latex_means_what_it_prints() {
    for (printed, meant) in [
        (r"\frac12 w", "1/2*w"),
        (r"\frac{80}{3}\sqrt{6}w_{11}", "80/3*sqrt(6)*w11"),
        (r"\tfrac1{2}w", "1/2*w"),
        (r"\dfrac{\sqrt6}{3}", "1/3*sqrt(6)"),
        (r"\sqrt{\frac{2}{3}}", "1/3*sqrt(6)"),
        (r"w_{11}z^2", "z^2*w11"),
        (r"(w_{11}z)^{2}", "z^2*w11^2"),
        (r"-w^2", "-w^2"),
        (r"+32w^2 - 4", "32*w^2 - 4"),
        (r"w_{ 11 }^2 z", "z*w11^2"),
        (r"w z", "w*z"),
        (r"wz", "w*z"),
        (r"2 \cdot 3 w", "6*w"),
        (r"2\times w * z", "2*w*z"),
        (r"w(z+1)", "w*z + w"),
        (r"\left[ 2 - \left( w + 1 \right) \right] z", "-w*z + z"),
        (r"\Bigl\{ w \Bigr\} / 2", "1/2*w"),
        (r"(160\sqrt{6})/3", "160/3*sqrt(6)"),
        (r"128/3 - w", "-w + 128/3"),
        (r"2w/3", "2/3*w"),
        (r"(w)/3 \cdot z", "1/3*w*z"),
        (r"0.25 w", "1/4*w"),
        (r"{w}^2", "w^2"),
        (r"\mathrm{w11}", "w11"),
        (r"\mathrm{x\_1}", "x_1"),
        (r"w~\, z \quad \square", "w*z"),
        (r"w + 1 . ", "w + 1"),
        ("w % + 5\n + 2", "w + 2"),
        (r"w \tag{7}", "w"),
        (r"w \quad (A-3)", "w"),
        (r"w \quad (3.2a)", "w"),
        (r"\sqrt{2}\sqrt{3} w", "sqrt(6)*w"),
        (r"\frac{w + \sqrt{2}}{2 - \sqrt{3}}", "2*w + sqrt(3)*w + 2*sqrt(2) + sqrt(6)"),
    ] {
        let ring = ring();
        let canonical = ring.spell(&value(Notation::Plain, meant).unwrap());
        assert_eq!(meaning(Notation::Latex, printed), canonical, "{printed}");
    }
}

#[test]
fn plain_text_means_what_programs_print() {
    for (printed, meant) in [
        ("-16*w^2 + (80/3)*sqrt(6)*w", r"-16w^2 + \frac{80}{3}\sqrt{6}w"),
        ("−16·w² + 80√6/3·w", r"-16w^2 + \frac{80}{3}\sqrt{6}w"),
        ("2**3 * w**2", "8w^2"),
        ("w11 * w_11 * w_{11}", "w_{11}^3"),
        ("2w × z", "2wz"),
        ("1/2*w", r"\frac12 w"),
        ("√(2/3)", r"\sqrt{2/3}"),
        ("w   # a remark", "w"),
        ("sqrt(2)*sqrt(3)", r"\sqrt6"),
        ("w - \n 2", "w - 2"),
    ] {
        assert_eq!(meaning(Notation::Plain, printed), meaning(Notation::Latex, meant), "{printed}");
    }
}

/// The labels of a text, formula by formula.
fn labels(notation: Notation, text: &str) -> Vec<Vec<String>> {
    let formulas = notation.read(text).unwrap_or_else(|error| panic!("{error}"));
    let names = |formula: &prove_cap::formats::listing::Formula| {
        formula.labels.iter().map(|(label, _)| label.to_string()).collect()
    };
    formulas.iter().map(names).collect()
}

#[test]
fn rows_and_commas_separate_formulas() {
    let one = r"\begin{aligned} a_1 &= w \\ &\quad + 2 \\[2pt] a_2 &= a_{3} = 4, & a_{4} &= -5; \end{aligned} \quad (11)";
    assert_eq!(labels(Notation::Latex, one), [vec!["a1"], vec!["a2", "a3"], vec!["a4"]]);
    assert_eq!(labels(Notation::Plain, "a1 = w\n  + 2\n\na2 = 3, a[4,1] = 5\n"), [["a1"], ["a2"], ["a4,1"]]);
}

#[test]
fn in_a_document_only_displays_are_read() {
    let text = r"\documentclass{article} \begin{document}
        Let $w = 1/2z$ be given, 50\% of it \$\$ (see a/b/c). % $$ a_9 = ( $$
        \[ a_{1} = w \]
        and then \\[2pt] $$a_2 = z.$$
        \begin{align*} a_3 &= 1 \\ a_4 &= 2 \end{align*}
        \begin{alignat}{2} a_5 &= 1 \end{alignat}
        \end{document}";
    assert_eq!(labels(Notation::Latex, text), [["a1"], ["a2"], ["a3"], ["a4"], ["a5"]]);
}

/// A random polynomial over Q(√2,√3).
fn polynomial() -> impl Strategy<Value = Polynomial> {
    let term = (0u8..4, prop::collection::btree_map(0u16..4, 1u32..4, 0..3), -99i64..100, 1i64..30);
    prop::collection::vec(term, 0..8).prop_map(|terms| {
        let mut sum = std::collections::BTreeMap::new();
        for (mask, powers, n, d) in terms {
            let monomial = Monomial::new(mask, powers.into_iter().collect()).unwrap().unwrap();
            sum.insert(monomial, BigRational::new(BigInt::from(n), BigInt::from(d)));
        }
        Polynomial::from_terms(sum)
    })
}

proptest! {
    #[test]
    fn what_is_printed_in_latex_is_read_back(polynomial in polynomial()) {
        let printed = formula(&ring(), &polynomial);
        prop_assert_eq!(value(Notation::Latex, &printed), Ok(polynomial), "{}", printed);
    }

    #[test]
    fn what_is_printed_for_people_is_read_back(polynomial in polynomial()) {
        let printed = report::Notation::new(ring()).polynomial(&polynomial);
        prop_assert_eq!(value(Notation::Plain, &printed), Ok(polynomial), "{}", printed);
    }

    #[test]
    fn the_canonical_spelling_is_read_back(polynomial in polynomial()) {
        let printed = ring().spell(&polynomial);
        prop_assert_eq!(value(Notation::Plain, &printed), Ok(polynomial), "{}", printed);
    }

    /// Whatever the pieces: an answer or an error with a place in the text, no panic.
    #[test]
    fn no_text_makes_the_reader_panic(pieces in prop::collection::vec(prop::sample::select(PIECES), 0..40)) {
        let text = pieces.concat();
        for notation in [Notation::Latex, Notation::Plain] {
            if let Err(error) = notation.read(&text) {
                prop_assert!(error.place.line <= text.matches('\n').count() + 1, "{}", error);
            }
        }
        let _ = Listing::from_toml(&text);
    }

    #[test]
    fn no_characters_make_the_reader_panic(text in "\\PC{0,60}") {
        for notation in [Notation::Latex, Notation::Plain] {
            let _ = notation.read(&text).map_err(|error| error.to_string());
        }
        // Prose stays prose, whatever it is.
        let document = format!("\\[ a_1 = 1 \\] {}", prose(&text));
        prop_assert_eq!(labels(Notation::Latex, &document), [["a1"]], "{}", document);
    }
}

const PIECES: &[&str] = &[
    "a_1",
    "a_{14}",
    "=",
    "&=",
    "\\\\",
    "\n",
    "+",
    "-",
    "2",
    "80",
    "3.5",
    "\\frac",
    "{",
    "}",
    "\\sqrt",
    "(",
    ")",
    "[",
    "]",
    "\\{",
    "\\left",
    "\\right",
    "w",
    "w_{11}",
    "_",
    "^",
    "^2",
    "^{",
    "\\cdot",
    "/",
    ",",
    ";",
    ".",
    "$$",
    "\\[",
    "\\]",
    "\\begin{aligned}",
    "\\end{aligned}",
    "\\begin{align}",
    "\\end{align}",
    "\\begin",
    "\\quad",
    "(11)",
    "%",
    "\\square",
    "\\mathrm{",
    "√",
    "²",
    "é",
    "−",
    "·",
    "'''",
    "\"",
    "#",
    "title = ",
    "[[claim]]",
    " ",
    "\\tag{",
    "\\",
];
