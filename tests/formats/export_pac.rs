//! Proofs in the practical algebraic calculus: replayed here by a strict reader of its own, and by `pacheck -e` where it is installed.

use std::fs;
use std::process::Command;

use crate::pac::{Verdict, parse, replay};
use crate::support::{LARGEST, committed, damaged, not_run, refutations};
use num_rational::BigRational;
use num_traits::Zero;
use prove_cap::certificate::{Argument, Certificate, Premise, Step};
use prove_cap::checker::Equations;
use prove_cap::exact::{Polynomial, Work};
use prove_cap::formats::export::{Case, ExportError, Target, export, pac_files};
use prove_cap::statement::Statement;

fn written(statement: &Statement, certificate: &Certificate) -> [(&'static str, String); 3] {
    pac_files(&Case::new(statement, certificate).unwrap()).unwrap()
}

fn steps(certificate: &Certificate) -> &[Step] {
    let Argument::Impossible(steps) = &certificate.argument else { panic!("a refutation") };
    steps
}

fn nudged(polynomial: &Polynomial, statement: &Statement, by: i32) -> Polynomial {
    Polynomial::sum(&[polynomial.clone(), Polynomial::integer(by)], statement.field(), &mut Work::full())
        .unwrap()
}

/// A system in x and y over Q(√2) and a certificate for it, in the texts' own words.
fn small(polynomials: &str, steps: &str) -> (Statement, Certificate) {
    let text =
        format!("title = \"t\"\nradicands = [2]\nunknowns = [\"x\", \"y\"]\npolynomials = {polynomials}\n");
    let statement = Statement::read(&text).unwrap();
    let text = format!(
        "prove-cap certificate 1\nstatement sha256 {}\nclaim impossible\n{steps}\nend {}\n",
        statement.hash(),
        steps.matches("conclude").count()
    );
    let read = Certificate::read(text.as_bytes(), &statement.ring(), 2, &mut Work::full());
    (statement, read.unwrap_or_else(|error| panic!("{error}\n{text}")))
}

#[test]
fn every_committed_refutation_replays_to_its_target() {
    for name in refutations() {
        let (statement, certificate) = committed(&name);
        assert_eq!(replay(&written(&statement, &certificate)), Verdict::Checked, "{name}");
    }
}

#[test]
#[ignore = "31 MB"]
fn the_largest_replays_too() {
    let (statement, certificate) = committed(LARGEST);
    assert_eq!(replay(&written(&statement, &certificate)), Verdict::Checked);
}

/// What is believed without proof is what the statement says: s² − d, then multiples of its equations.
#[test]
fn the_axioms_are_the_statements_equations() {
    for name in refutations() {
        let (statement, certificate) = committed(&name);
        let case = Case::new(&statement, &certificate).unwrap();
        let [(_, axioms), ..] = pac_files(&case).unwrap();
        let mut lines = axioms.lines().map(|line| line.trim_end_matches(';').split_once(' ').unwrap().1);
        for radicand in statement.field().values() {
            assert_eq!(lines.next().unwrap(), format!("s{radicand}^2-{radicand}"));
        }
        let equations = Equations::of(&statement, &mut Work::full()).unwrap();
        let roots = statement.field().values().iter().map(|d| format!("s{d}"));
        let unknowns = (1..=statement.unknowns().len()).map(|k| format!("x{k}"));
        let names: Vec<_> =
            roots.chain(unknowns).chain((1..=statement.nonzero().len()).map(|k| format!("t{k}"))).collect();
        for premise in case.premises() {
            let axiom = parse(lines.next().unwrap());
            let terms = case.terms(equations.get(premise).unwrap());
            assert_eq!(axiom.len(), terms.len(), "{name}: {premise}");
            let ratios = terms.into_iter().map(|term| {
                let mut powers: Vec<_> = term.powers.iter().map(|&(k, e)| (names[k].clone(), e)).collect();
                powers.sort();
                BigRational::from(axiom[&powers].clone()) / term.coefficient
            });
            let ratios: Vec<_> = ratios.collect();
            assert!(
                ratios.iter().all(|ratio| *ratio == ratios[0] && *ratio > BigRational::zero()),
                "{name}: {premise}"
            );
        }
        assert_eq!(lines.next(), None, "{name}");
    }
}

/// A step that is wrong is written as it stands: the line with its conclusion does not come to what it says.
#[test]
fn damaged_steps_are_refused_where_they_are_damaged() {
    for name in ["cap-2x2", "cap-2x2-weights", "cap-3x3-d4", "cap-4x2", "degrees-cube/closing"] {
        let (statement, certificate) = committed(name);
        for (step, sound) in steps(&certificate).iter().enumerate() {
            let twins = [
                damaged(&certificate, |steps| {
                    steps[step].conclusion = nudged(&sound.conclusion, &statement, 1);
                }),
                damaged(&certificate, |steps| {
                    let multiplier = &mut steps[step].combination[0].1;
                    *multiplier = nudged(multiplier, &statement, -2);
                }),
                damaged(&certificate, |steps| {
                    let multiplier = &mut steps[step].combination[0].1;
                    *multiplier = multiplier.negate();
                }),
                damaged(&certificate, |steps| {
                    if steps[step].combination.len() > 1 {
                        steps[step].combination.pop();
                    } else {
                        steps[step].conclusion = Polynomial::variable(0);
                    }
                }),
            ];
            for twin in twins {
                let verdict = replay(&written(&statement, &twin));
                assert!(matches!(verdict, Verdict::Refused(_)), "{name}, step {}: {verdict:?}", step + 1);
            }
        }
    }
}

/// Sound steps that do not end in a contradiction are no proof. (`pacheck` exits 0 on this one; its last line differs.)
#[test]
fn a_proof_that_ends_early_does_not_reach_its_target() {
    for name in ["cap-2x2", "cap-3x2", "cap-4x2"] {
        let (statement, certificate) = committed(name);
        let short = damaged(&certificate, |steps| drop(steps.pop()));
        assert_eq!(replay(&written(&statement, &short)), Verdict::NotInferred, "{name}");
        let empty = damaged(&certificate, Vec::clear);
        let files = written(&statement, &empty);
        assert_eq!(replay(&files), Verdict::NotInferred, "{name}");
        assert_eq!(files[1].1, "");
    }
    let (statement, certificate) = small(r#"["x"]"#, "step 1\nadd f[1] times 5\nconclude 5*x");
    assert_eq!(replay(&written(&statement, &certificate)), Verdict::NotInferred);
}

#[test]
fn zero_is_no_target() {
    let (statement, certificate) =
        small(r#"["x", "x"]"#, "step 1\nadd f[1] times 1\nadd f[2] times -1\nconclude 0");
    assert_eq!(replay(&written(&statement, &certificate)), Verdict::NotInferred);
}

#[test]
fn long_exponents_are_split() {
    let (statement, certificate) = small(
        r#"["x^29*y^10 - 2", "x"]"#,
        "step 1\nadd f[1] times -1/2\nadd f[2] times 1/2*x^28*y^10\nconclude 1",
    );
    let files = written(&statement, &certificate);
    assert_eq!(files[0].1, "1 s2^2-2;\n2 x1^9*x1^9*x1^9*x1^2*x2^9*x2-2;\n3 x1;\n");
    assert_eq!(replay(&files), Verdict::Checked);
}

#[test]
fn a_variable_of_multipliers_only_is_introduced() {
    let (statement, certificate) = small(
        r#"["x", "x - 1"]"#,
        "step 1\nadd f[1] times y\nconclude x*y\n\
         step 2\nadd f[1] times -y + 1\nadd f[2] times -1\nadd step 1 times 1\nconclude 1",
    );
    let files = written(&statement, &certificate);
    assert_eq!(files[0].1, "1 s2^2-2;\n2 x1;\n3 x1-1;\n4 x2-x2;\n");
    assert_eq!(replay(&files), Verdict::Checked);
}

/// √2·√2 = 2 is true because s2² − 2 is an axiom, and only because of that.
#[test]
fn roots_are_reduced_by_their_axioms() {
    let (statement, certificate) =
        small(r#"["sqrt(2)*x - 1", "x"]"#, "step 1\nadd f[1] times -1\nadd f[2] times sqrt(2)\nconclude 1");
    assert_eq!(replay(&written(&statement, &certificate)), Verdict::Checked);
    let (statement, certificate) = small(
        r#"["sqrt(2)*x - 1", "x - 1"]"#,
        "step 1\nadd f[1] times 1 + sqrt(2)\nadd f[2] times -2 - sqrt(2)\nconclude 1",
    );
    let files = written(&statement, &certificate);
    assert!(files[1].1.contains("* 1, "), "{}", files[1].1);
    assert_eq!(replay(&files), Verdict::Checked);
    let three = files.map(|(ending, text)| (ending, text.replace("s2^2-2;", "s2^2-3;")));
    assert!(matches!(replay(&three), Verdict::Refused(_)));
}

#[test]
fn what_cannot_be_said_is_an_error() {
    let (statement, certificate) = committed("octant");
    let case = Case::new(&statement, &certificate).unwrap();
    let error = pac_files(&case).unwrap_err();
    assert!(matches!(error, ExportError::Inexpressible { format: "pac", .. }), "{error}");
    assert!(export(&case, Target::Pac).is_err());

    let (statement, certificate) = committed("cap-2x2");
    for premise in [
        Premise::Coefficient(9, 9),
        Premise::Equation(1),
        Premise::Nonzero(1),
        Premise::Step(0),
        Premise::Step(3),
    ] {
        let wrong = damaged(&certificate, |steps| steps[2].combination[0].0 = premise);
        let error = pac_files(&Case::new(&statement, &wrong).unwrap()).unwrap_err();
        assert!(matches!(error, ExportError::Premise(of) if of == premise), "{error}");
    }
}

#[test]
fn names_and_titles_leave_no_trace() {
    let text = fs::read_to_string("proofs/cap-2x2-centre/statement.toml").unwrap();
    let (statement, certificate) = committed("cap-2x2-centre");
    let plain = written(&statement, &certificate);
    let title = text.lines().find(|line| line.starts_with("title")).unwrap();
    let hostile = text.replace(title, r#"title = "1 d; */ -/ \"x1\" ,;\\ x1-x1;""#);
    assert_ne!(hostile, text);
    let statement = Statement::read(&hostile).unwrap();
    assert_eq!(written(&statement, &certificate), plain);
    for (unknown, name) in ["d", "s2", "t1", "x2"].into_iter().enumerate() {
        let (system, certificate) =
            small(r#"["x", "x - 1"]"#, "step 1\nadd f[1] times 1\nadd f[2] times -1\nconclude 1");
        let renamed = format!(
            "title = \"t\"\nradicands = [2]\nunknowns = [\"{name}\", \"y{unknown}\"]\npolynomials = [\"{name}\", \"{name} - 1\"]\n"
        );
        let renamed = Statement::read(&renamed).unwrap();
        assert_eq!(written(&renamed, &certificate), written(&system, &certificate));
    }
}

#[test]
fn the_command_writes_three_files() {
    let directory = tempfile::tempdir().unwrap();
    let prefix = directory.path().join("cap.v1");
    let run = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_prove-cap"));
        command.args(["export", "--to", "pac", "proofs/cap-2x2/statement.toml"]);
        command.args(["--certificate", "proofs/cap-2x2/certificate.txt"]).args(more);
        let output = command.output().unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let (status, text) = run(&["-o", prefix.to_str().unwrap()]);
    assert_eq!(status, Some(0), "{text}");
    let (statement, certificate) = committed("cap-2x2");
    let mut shown = String::new();
    for (ending, expected) in written(&statement, &certificate) {
        let file = directory.path().join(format!("cap.v1.{ending}"));
        assert_eq!(fs::read_to_string(&file).unwrap(), expected);
        assert!(text.contains(&format!("WRITTEN  {}: {} bytes\n", file.display(), expected.len())), "{text}");
        shown += &format!("{}==> {ending} <==\n{expected}", if shown.is_empty() { "" } else { "\n" });
    }
    assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 3);
    assert_eq!(run(&[]), (Some(0), shown));
    let (status, _) = run(&["-o", directory.path().join("none/cap").to_str().unwrap()]);
    assert_eq!(status, Some(2));
}

/// The checker itself, where there is one: its line, not its exit code.
#[test]
fn pacheck_agrees() {
    if Command::new("pacheck").arg("-h").output().is_err() {
        return not_run("pacheck");
    }
    let directory = tempfile::tempdir().unwrap();
    let verdict = |files: [(&str, String); 3]| {
        let paths = files.map(|(ending, text)| {
            let path = directory.path().join(ending);
            fs::write(&path, text).unwrap();
            path
        });
        let output = Command::new("pacheck").arg("-e").args(paths).output().unwrap();
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let checked = text.lines().any(|line| line == "[pacheck] TARGET CHECKED");
        (checked, output.status.success())
    };
    for name in refutations() {
        let (statement, certificate) = committed(&name);
        assert_eq!(verdict(written(&statement, &certificate)), (true, true), "{name}");
        let last = steps(&certificate).len() - 1;
        for step in 0..=last {
            let twin = damaged(&certificate, |steps| {
                steps[step].conclusion = nudged(&steps[step].conclusion, &statement, 1);
            });
            assert_eq!(verdict(written(&statement, &twin)), (false, false), "{name}, step {}", step + 1);
        }
        let short = damaged(&certificate, |steps| drop(steps.pop()));
        assert_eq!(verdict(written(&statement, &short)), (false, true), "{name}: it exits 0 on this one");
    }
    let (statement, certificate) = small(
        r#"["x^29*y^10 - 2", "x"]"#,
        "step 1\nadd f[1] times -1/2\nadd f[2] times 1/2*x^28*y^10\nconclude 1",
    );
    assert_eq!(verdict(written(&statement, &certificate)), (true, true));
    let (statement, certificate) = small(
        r#"["x", "x - 1"]"#,
        "step 1\nadd f[1] times y\nconclude x*y\n\
         step 2\nadd f[1] times -y + 1\nadd f[2] times -1\nadd step 1 times 1\nconclude 1",
    );
    assert_eq!(verdict(written(&statement, &certificate)), (true, true));
}
