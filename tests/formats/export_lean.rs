//! Lean texts: every identity that they leave to `ring` is one, and nothing that others wrote is in their code.

use std::fs;

use crate::lean::{Environment, MODULUS, Verified, add, multiply, power, verify};
use crate::support::{LARGEST, committed, damaged, folders};
use num_bigint::BigInt;
use prove_cap::certificate::{Argument, Certificate, Premise};
use prove_cap::exact::{Polynomial, Work};
use prove_cap::formats::export::{Case, ExportError, Target, export};
use prove_cap::statement::{COORDINATES, Statement, Subject};

fn written(statement: &Statement, certificate: &Certificate) -> String {
    export(&Case::new(statement, certificate).unwrap(), Target::Lean).unwrap()
}

/// A statement over Q(√2) in x and y, and a certificate, in the texts' own words.
fn small(keys: &str, argument: &str) -> (Statement, Certificate) {
    let text = format!("title = \"t\"\nradicands = [2]\nunknowns = [\"x\", \"y\"]\n{keys}\n");
    let statement = Statement::read(&text).unwrap();
    let text = format!("prove-cap certificate 1\nstatement sha256 {}\n{argument}\n", statement.hash());
    let read = Certificate::read(text.as_bytes(), &statement.ring(), 2, &mut Work::full());
    (statement, read.unwrap_or_else(|error| panic!("{error}\n{text}")))
}

#[test]
fn every_identity_of_every_committed_proof_holds() {
    for name in folders() {
        let (statement, certificate) = committed(&name);
        let verified =
            verify(&written(&statement, &certificate)).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(verified.linear_combinations > 1 && verified.definitions > 3, "{name}: {verified:?}");
        println!("{name}: {verified:?}");
    }
}

#[test]
#[ignore = "a megabyte of text"]
fn those_of_the_largest_too() {
    let (statement, certificate) = committed(LARGEST);
    verify(&written(&statement, &certificate)).unwrap();
}

/// The definitions say what the statement says: X(u,v), …, W(u,v) and the surface at random points, with any numbers as roots.
#[test]
fn the_definitions_are_the_statement() {
    for name in folders() {
        let (statement, certificate) = committed(&name);
        let case = Case::new(&statement, &certificate).unwrap();
        let Subject::Patch(patch) = &case.subject else { continue };
        let text = export(&case, Target::Lean).unwrap();
        let mut environment = Environment::random(7);
        for line in text.lines().filter(|line| line.starts_with("def ")) {
            let (head, body) = line.trim_start_matches("def ").split_once(" : ℝ := ").unwrap();
            let (own, parameters) = head.split_once(" (").unwrap();
            let parameters = parameters.trim_end_matches(" : ℝ)").split(' ').map(String::from).collect();
            environment.define(own.to_owned(), parameters, body);
        }
        let unknowns = case.variable_count().saturating_sub(case.assumptions.len());
        let roots = case.field.values().iter().map(|d| format!("r{d}"));
        let generators: Vec<String> = roots.chain((1..=unknowns).map(|k| format!("x{k}"))).collect();
        let numbers: Vec<u64> = (0..generators.len()).map(|k| power(3, 1_000_003 * (k as u64 + 1))).collect();
        for (generator, &number) in generators.iter().zip(&numbers) {
            environment.set(generator, number);
        }
        let evaluate = |polynomial: &Polynomial| {
            case.terms(polynomial).into_iter().fold(0, |sum, term| {
                let modular = |value: &BigInt| {
                    let modulus = BigInt::from(MODULUS);
                    u64::try_from(((value % &modulus) + &modulus) % &modulus).unwrap()
                };
                let inverse = power(modular(term.coefficient.denom()), MODULUS - 2);
                let value = multiply(modular(term.coefficient.numer()), inverse);
                add(
                    sum,
                    term.powers.iter().fold(value, |v, &(k, e)| multiply(v, power(numbers[k], e.into()))),
                )
            })
        };
        let (u, v) = (power(5, 12_345), power(7, 54_321));
        environment.set("u", u);
        environment.set("v", v);
        let less = |t: u64| add(1, MODULUS - t);
        let (m, n) = patch.bidegree;
        let binomial = |n: u32, k: u32| (1..=u64::from(k)).fold(1u64, |b, i| b * (u64::from(n) - i + 1) / i);
        let basis = |n: u32, k: usize, t: u64| {
            let k = u32::try_from(k).unwrap();
            multiply(binomial(n, k), multiply(power(t, k.into()), power(less(t), (n - k).into())))
        };
        for (k, coordinate) in COORDINATES.iter().enumerate() {
            let mut expected = 0;
            for (i, row) in patch.net.iter().enumerate() {
                for (j, point) in row.iter().enumerate() {
                    let weight = multiply(basis(m, i, u), basis(n, j, v));
                    expected = add(expected, multiply(weight, evaluate(&point[k])));
                }
            }
            let value = environment.value(&format!("{coordinate} {} u v", generators.join(" "))).unwrap();
            assert_eq!(value, expected, "{name}: {coordinate}");
        }
        assert!(text.contains("\ndef surface (X Y Z W : ℝ) : ℝ := X^2 + Y^2 + Z^2 - W^2\n"), "{name}");
    }
}

#[test]
fn the_theorem_is_the_geometric_one() {
    let (statement, certificate) = committed("cap-2x2");
    let text = written(&statement, &certificate);
    let point = |name: char| format!("({name} (Real.sqrt 2) (Real.sqrt 3) x1 x2 u v)");
    let theorem = format!(
        "theorem impossible (x1 x2 : ℝ) :\n    ¬ ∀ u v : ℝ, 0 ≤ u → u ≤ 1 → 0 ≤ v → v ≤ 1 →\n      surface {} {} {} {} = 0 :=\n",
        point('X'),
        point('Y'),
        point('Z'),
        point('W')
    );
    assert!(text.contains(&theorem), "{text}");
    assert!(text.contains("def W1 (r2 r3 x1 x2 p q : ℝ) : ℝ := curve2 (1/3*r2*r3) (x1) (1/3*r2*r3) p q\n"));
    assert!(text.contains("NOT COMPILED"));
    for word in ["sorry", "axiom", "admit", "native_decide", "unsafe"] {
        assert_eq!(text.matches(word).count(), usize::from(word == "sorry"), "only the comment names it");
    }

    let (statement, certificate) = committed("cap-2x2-weights");
    let text = written(&statement, &certificate);
    assert!(text.contains("theorem impossible (x1 x2 x3 x4 x5 : ℝ) (n1 : nonzero1 (Real.sqrt 2) (Real.sqrt 3) x1 x2 x3 x4 x5 ≠ 0) :"));
    assert!(text.contains("(mul_inv_cancel₀ n1)"));
}

/// A wrong step is written as it is, and is what is found wrong.
#[test]
fn damage_shows_where_it_is() {
    for name in ["cap-2x2", "cap-2x2-weights", "cap-3x3-d4", "degrees-cube/closing"] {
        let (statement, certificate) = committed(name);
        let Argument::Impossible(steps) = &certificate.argument else { panic!("{name}") };
        for (position, step) in steps.iter().enumerate() {
            let nudged = |polynomial: &Polynomial| {
                Polynomial::sum(
                    &[polynomial.clone(), Polynomial::integer(1)],
                    statement.field(),
                    &mut Work::full(),
                )
                .unwrap()
            };
            let twins = [
                damaged(&certificate, |steps| steps[position].conclusion = nudged(&step.conclusion)),
                damaged(&certificate, |steps| {
                    steps[position].combination[0].1 = nudged(&step.combination[0].1);
                }),
                damaged(&certificate, |steps| {
                    let multiplier = &mut steps[position].combination[0].1;
                    *multiplier = multiplier.negate();
                }),
            ];
            for twin in twins {
                let error = verify(&written(&statement, &twin)).unwrap_err();
                assert_eq!(error, format!("s_{}: not an identity", position + 1), "{name}");
            }
        }
        let short = damaged(&certificate, |steps| drop(steps.pop()));
        let error = verify(&written(&statement, &short)).unwrap_err();
        assert!(error.starts_with("the last line is not 1 = 0"), "{name}: {error}");
        let empty = damaged(&certificate, Vec::clear);
        assert!(verify(&written(&statement, &empty)).is_err(), "{name}");
    }
}

/// The reader of these tests has teeth: no number or sign of a proof can be changed without its noticing.
#[test]
fn the_verifier_notices_changed_texts() {
    for name in ["cap-2x2", "octant"] {
        let (statement, certificate) = committed(name);
        let text = written(&statement, &certificate);
        let start = text.find("def F0").unwrap();
        let mut tried = 0;
        for (at, c) in text[start..].char_indices().step_by(7) {
            let other = match c {
                '0'..='8' => char::from(c as u8 + 1),
                '+' => '-',
                '*' => '+',
                _ => continue,
            };
            let line = text[start + at..].find('\n').unwrap() + start + at;
            let begin = text[..start + at].rfind('\n').unwrap() + 1;
            let of = &text[begin..line];
            // Where only Lean looks: names of hypotheses, terms that are given to theorems.
            let algebra = of.contains("linear_combination") || of.starts_with("def F");
            if !algebra || of[..start + at - begin].matches(" : ℝ)").count() == 0 && of.starts_with("def") {
                continue;
            }
            let mut changed = text.clone();
            changed.replace_range(start + at..=start + at, &other.to_string());
            tried += 1;
            assert!(verify(&changed).is_err(), "{name}: {c} to {other} in {of}");
        }
        assert!(tried > 20, "{name}: {tried}");
    }
}

#[test]
fn exact_claims_end_in_a_theorem_for_all_parameters() {
    for name in ["cobb", "octant", "cap-4x2-exact"] {
        let (statement, certificate) = committed(name);
        let text = written(&statement, &certificate);
        assert!(text.contains("theorem exact_patch (u v : ℝ) :"), "{name}");
        assert!(text.contains("theorem some_weight"), "{name}");
        let Argument::Exact(values) = &certificate.argument else { panic!("{name}") };
        if values.is_empty() {
            continue;
        }
        let mut wrong = certificate.clone();
        let Argument::Exact(values) = &mut wrong.argument else { panic!("{name}") };
        values[0] = Polynomial::integer(77);
        let error = verify(&written(&statement, &wrong)).unwrap_err();
        assert!(error.ends_with("not an identity"), "{name}: {error}");
    }
}

#[test]
fn systems_and_other_surfaces_are_written_too() {
    let (statement, certificate) = small(
        r#"polynomials = ["x^2 - 2", "sqrt(2)*y - x"]
nonzero = ["x + y", "3"]"#,
        "claim exact\nvalue x = sqrt(2)\nvalue y = 1\nend 2",
    );
    let text = written(&statement, &certificate);
    let verified = verify(&text).unwrap();
    assert_eq!(verified, Verified { linear_combinations: 3, rings: 1, definitions: 2 });
    assert!(
        text.contains(
            "theorem solvable : ∃ x1 x2 : ℝ, f1 (Real.sqrt 2) x1 x2 = 0 ∧ f2 (Real.sqrt 2) x1 x2 = 0 :="
        ),
        "{text}"
    );
    let mut wrong = certificate.clone();
    wrong.argument = Argument::Exact(vec![Polynomial::integer(1), Polynomial::integer(1)]);
    assert!(verify(&written(&statement, &wrong)).is_err());

    let (statement, certificate) = small(
        r#"polynomials = ["x*y - sqrt(2)"]
nonzero = []"#,
        "claim impossible\nstep 1\nadd f[1] times 1\nconclude 1\nend 1",
    );
    assert_eq!(verify(&written(&statement, &certificate)).unwrap_err(), "s_1: not an identity");

    // A cubic with a root in it, of bidegree (1,2): along u a cubic, along v a sextic.
    let patch = r#"
convention = "homogeneous"
bidegree = [1, 2]
surface = "X^3 + sqrt(2)*Y*Z*W - W^3"
net = [
  [["1", "0", "0", "1"], ["1", "x", "0", "1"], ["1", "0", "0", "1"]],
  [["1", "0", "sqrt(2)", "1"], ["1", "0", "0", "1"], ["y", "0", "0", "1"]],
]"#;
    // c[3,6] = y³ − 1, c[2,5] = 6·(y² − 1)… and so on: a step that need not be a refutation, so that its equations are written.
    let (statement, certificate) = small(
        patch,
        "claim impossible\nstep 1\nadd c[1,1] times sqrt(2)*x\nadd c[3,6] times 1\nconclude 1\nend 1",
    );
    let error = verify(&written(&statement, &certificate)).unwrap_err();
    assert_eq!(error, "s_1: not an identity", "everything before it holds");
    assert!(written(&statement, &certificate).contains("theorem vanish6"));
    let (statement, certificate) = small(patch, "claim exact\nvalue x = 0\nvalue y = 1\nend 2");
    verify(&written(&statement, &certificate)).unwrap();
}

#[test]
fn what_there_is_not_is_an_error() {
    let (statement, certificate) = committed("cap-2x2");
    for premise in [
        Premise::Coefficient(5, 0),
        Premise::Equation(1),
        Premise::Nonzero(1),
        Premise::Step(0),
        Premise::Step(3),
    ] {
        let wrong = damaged(&certificate, |steps| steps[2].combination[0].0 = premise);
        let error = export(&Case::new(&statement, &wrong).unwrap(), Target::Lean).unwrap_err();
        assert!(matches!(error, ExportError::Premise(of) if of == premise), "{error}");
    }
}

/// The code, without the comment on top.
fn code(text: &str) -> &str {
    assert_eq!(text.matches("\n-/\nimport Mathlib\n").count(), 1);
    let (comment, code) = text.split_once("\n-/\n").unwrap();
    assert!(
        comment.starts_with("/-\n") && !comment[3..].contains("/-") && !comment.contains("-/"),
        "{comment}"
    );
    code
}

#[test]
fn hostile_titles_and_names_change_nothing_but_the_comment() {
    let text = fs::read_to_string("proofs/cap-2x2/statement.toml").unwrap();
    let (statement, certificate) = committed("cap-2x2");
    let plain = written(&statement, &certificate);
    let title = text.lines().find(|line| line.starts_with("title")).unwrap();
    for hostile in [
        r"-/ axiom a : False /-",
        r"/- /- /-",
        r"\\n-/\\nimport Evil",
        r#"\"-\/ #eval 1"#,
        "«» λ → √ -- sorry",
    ] {
        let hostile = hostile.replace('\\', "\\\\").replace('"', "\\\"");
        let renamed = Statement::read(&text.replace(title, &format!("title = \"{hostile}\""))).unwrap();
        let other = written(&renamed, &certificate);
        assert_ne!(other, plain);
        assert_eq!(code(&other), code(&plain), "{hostile}");
    }
    let keys = |x: &str, y: &str| {
        format!(
            "title = \"t\"\nradicands = [2]\nunknowns = [\"{x}\", \"{y}\"]\npolynomials = [\"{x}*{y}\", \"{x}\", \"{y} - 1\", \"{x} - 1\"]\n"
        )
    };
    let (_, certificate) = small(
        r#"polynomials = ["x*y", "x", "y - 1", "x - 1"]"#,
        "claim impossible\nstep 1\nadd f[2] times 1\nadd f[4] times -1\nconclude 1\nend 1",
    );
    let plain = written(&Statement::read(&keys("x", "y")).unwrap(), &certificate);
    verify(&plain).unwrap();
    for (x, y) in [
        ("theorem", "Type"),
        ("fun", "by"),
        ("sorry", "end"),
        ("r2", "hr2"),
        ("x2", "x1"),
        ("s_1", "f1"),
        ("Real", "one_ne_zero"),
    ] {
        let other = written(&Statement::read(&keys(x, y)).unwrap(), &certificate);
        assert_eq!(code(&other), code(&plain), "{x}, {y}");
        assert!(other.contains(&format!("x1 is the unknown {x}\n")));
    }
}
