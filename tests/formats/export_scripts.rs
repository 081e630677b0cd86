//! Scripts for computer-algebra systems: what they may contain, and, where a system is installed, what it says of right and wrong proofs.
//!
//! A system that is not installed is `not run`, which is printed. `scripts/outside` runs all proofs and can require systems.

use std::fs;
use std::process::{Command, Stdio};

use crate::support::{committed, damaged, negated, not_run, proved};
use prove_cap::catalogue::ENTRIES;
use prove_cap::certificate::{Argument, Certificate, Premise, Step};
use prove_cap::checker::check_read;
use prove_cap::exact::Polynomial;
use prove_cap::formats::export::{Case, Target, export, text::harmless};
use prove_cap::statement::Statement;

const TARGETS: [Target; 5] =
    [Target::Singular, Target::Macaulay2, Target::Pari, Target::Sympy, Target::Maxima];

/// Names that mean something to one of the systems, or to the scripts themselves.
const HOSTILE: [&str; 22] = [
    "Theorem", "I", "E", "quit", "ring", "x1", "r2", "O", "D", "Pi", "S", "t1", "p", "q", "K", "F", "G",
    "add", "import", "reject", "exit", "conclude",
];

const TITLE: &str =
    r##"' " */ quit(0) (* *) \ $ ` -- // \\ # """ ''' $(exit 0) ?bye(0) }; {- Qed. <!-- é √"##;

fn claimed(text: &str, argument: Argument) -> (Statement, Certificate) {
    let statement = Statement::read(text).unwrap();
    let certificate = Certificate { statement: statement.hash(), argument };
    (statement, certificate)
}

fn script(statement: &Statement, certificate: &Certificate, target: Target) -> String {
    export(&Case::new(statement, certificate).unwrap(), target).unwrap()
}

fn is_comment(line: &str, target: Target) -> bool {
    match target {
        Target::Singular => line.starts_with("//"),
        Target::Macaulay2 => line.starts_with("--"),
        Target::Pari => line.starts_with("\\\\"),
        Target::Sympy => line.starts_with('#'),
        Target::Maxima => line.starts_with("/*") && line.ends_with("*/"),
        other => panic!("{other:?} is no script"),
    }
}

fn code(script: &str, target: Target) -> String {
    script.lines().filter(|line| !is_comment(line, target)).collect::<Vec<_>>().join("\n")
}

#[test]
fn names_and_titles_stand_in_comments_only() {
    for entry in ENTRIES {
        let (statement, certificate) = committed(entry.name);
        let plain = Case::new(&statement, &certificate).unwrap();
        let mut hostile = plain.clone();
        hostile.title = harmless(TITLE);
        let names = HOSTILE.iter().cycle().take(plain.unknowns.len());
        hostile.unknowns = names.map(|name| (*name).to_owned()).collect();
        for target in TARGETS {
            let [plain, hostile] = [&plain, &hostile].map(|case| export(case, target).unwrap());
            assert_eq!(code(&plain, target), code(&hostile, target), "{}, {target:?}", entry.name);
            assert!(plain.is_ascii() && hostile.is_ascii(), "{}, {target:?}", entry.name);
            assert!(
                !code(&plain, target).contains(&harmless(statement.title())),
                "{}, {target:?}",
                entry.name
            );
            let longest = plain.lines().map(str::len).max().unwrap();
            assert!(longest < 2500, "{}, {target:?}: a line of {longest} bytes", entry.name);
        }
    }
}

/// Python takes an encoding from the first two lines, whoever wrote them.
#[test]
fn no_title_declares_an_encoding() {
    let (statement, certificate) = committed("cap-2x2");
    let mut case = Case::new(&statement, &certificate).unwrap();
    case.title = harmless("Study of colour coding: none");
    let text = export(&case, Target::Sympy).unwrap();
    assert!(
        text.starts_with("#!/usr/bin/env python3\n# -*- coding: ascii -*-\n# Study of colour coding: none\n")
    );
    if let Some(said) = verdict(Target::Sympy, &text) {
        assert!(said.starts_with("VERIFIED"), "{said}");
    }
}

/// What is derived from the statement is not handed over: no coefficient is spelled where only its name may stand.
#[test]
fn coefficients_are_not_data() {
    let (statement, certificate) = committed("cap-2x2");
    for target in TARGETS {
        let text = script(&statement, &certificate, target);
        assert!(text.contains("add(c(1, 1), "), "{target:?}");
        assert!(!text.contains("8/3*r3*x1*x2"), "{target:?} is told c[1,1]");
        let calls = |of: &str| text.lines().filter(|line| line.starts_with(of)).count();
        assert_eq!((0..3).map(|i| calls(&format!("point({i}, "))).sum::<usize>(), 9, "{target:?}");
        assert_eq!((1..4).map(|k| calls(&format!("conclude({k}, "))).sum::<usize>(), 3, "{target:?}");
    }
}

fn hostile_statement(names: [&str; 10], title: &str) -> String {
    let [a, b, c, d, e, f, g, h, i, j] = names;
    format!(
        "title = {title:?}\nradicands = [2, 5]\nunknowns = {names:?}\nnonzero = [\"{a} + {b}\"]\npolynomials = [\
         \"{a}*{b} - sqrt(10)\", \"{a} - {c}\", \"{c}*{d}\", \"{d} - 1\", \"{e} + {f}*{g} + {h}^2 - {i}/3 + {j} - sqrt(2)\"]\n"
    )
}

fn hostile_names() -> [&'static str; 10] {
    std::array::from_fn(|k| HOSTILE[k])
}

#[test]
fn a_hostile_statement_gives_the_code_of_a_plain_one() {
    let names = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j"];
    let (plain, of_plain) = proved(&hostile_statement(names, "plain"));
    let (hostile, of_hostile) = proved(&hostile_statement(hostile_names(), TITLE));
    for target in TARGETS {
        let [plain, hostile] =
            [(&plain, &of_plain), (&hostile, &of_hostile)].map(|(s, c)| script(s, c, target));
        assert_eq!(code(&plain, target), code(&hostile, target), "{target:?}");
        assert_ne!(plain, hostile);
        assert!(hostile.contains("x1 stands for the unknown Theorem"), "{target:?}");
    }
}

/// Runs a script; the first line it prints without the version, or `None` if the system is not installed.
fn verdict(target: Target, script: &str) -> Option<String> {
    let (program, options, version): (_, &[&str], _) = match target {
        Target::Singular => ("Singular", &["-q"], " (Singular "),
        Target::Macaulay2 => ("M2", &["--script"], " (Macaulay2 "),
        Target::Pari => ("gp", &["-q"], " (PARI/GP "),
        Target::Sympy => ("python3", &[], " (SymPy "),
        Target::Maxima => ("maxima", &["--very-quiet"], " (Maxima "),
        other => panic!("{other:?} is no script"),
    };
    if target == Target::Sympy {
        let there = Command::new(program).args(["-c", "import sympy"]).stderr(Stdio::null()).status();
        there.ok().filter(std::process::ExitStatus::success)?;
    }
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("script");
    fs::write(&file, script).unwrap();
    let place = file.display();
    let file = if target == Target::Maxima { format!("--init-mac={place}") } else { place.to_string() };
    let output = Command::new(program).args(options).arg(file).stdin(Stdio::null()).output().ok()?;
    let [stdout, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    let line = stdout.lines().next().unwrap_or_else(|| panic!("{target:?} says nothing: {stderr}"));
    let (verdict, said) =
        line.rsplit_once(version).unwrap_or_else(|| panic!("{target:?}: {stdout}\n{stderr}"));
    assert!(said.starts_with(|c: char| c.is_ascii_digit()) && said.ends_with(')'), "{target:?}: {line}");
    let right = verdict.starts_with("VERIFIED  ");
    assert_eq!(output.status.code(), Some(i32::from(!right)), "{target:?}: {stdout}\n{stderr}");
    // Singular adds `halt 1` when it is terminated.
    let rest: Vec<&str> = stdout.lines().skip(1).collect();
    assert!(
        rest.is_empty() || !right && target == Target::Singular && rest == ["", "halt 1"],
        "{target:?}: {stdout}"
    );
    assert_eq!(stderr, "", "{target:?}");
    Some(verdict.to_owned())
}

/// Proofs and what any system must say of them, word for word.
fn judgements() -> Vec<(Statement, Certificate, &'static str)> {
    let mut all = Vec::new();
    let (cap, good) = committed("cap-2x2");
    let mut refute = |say: &'static str, damage: fn(&mut Vec<Step>)| {
        all.push((cap.clone(), damaged(&good, damage), say));
    };
    refute("VERIFIED  impossible: 1 is a combination of the equations, 3 steps", |_| ());
    refute("REJECTED  step 1: the sum is not the stated conclusion", |steps| {
        steps[0].combination[0].1 = negated(&steps[0].combination[0].1);
    });
    refute("REJECTED  step 2: the sum is not the stated conclusion", |steps| {
        steps[1].conclusion = steps[0].conclusion.clone();
    });
    refute("REJECTED  step 3: the sum is not the stated conclusion", |steps| {
        steps[2].combination[0].1 = Polynomial::integer(7);
    });
    refute("REJECTED  step 1: the sum is not the stated conclusion", |steps| {
        steps[0].combination[0].0 = Premise::Coefficient(0, 0);
    });
    refute("REJECTED  step 3: the sum is not the stated conclusion", |steps| {
        steps[2].combination.remove(1);
    });
    refute("REJECTED  step 2: there is no premise step 2 before it", |steps| drop(steps.remove(1)));
    refute("REJECTED  step 1: there is no premise step 1 before it", |steps| steps.swap(0, 2));
    refute("REJECTED  step 2: there is no premise step 3 before it", |steps| {
        steps[1].combination[1].0 = Premise::Step(3);
    });
    refute("REJECTED  step 2: there is no premise step 0 before it", |steps| {
        steps[1].combination[1].0 = Premise::Step(0);
    });
    refute("REJECTED  step 1: there is no premise c[1,5]", |steps| {
        steps[0].combination[1].0 = Premise::Coefficient(1, 5);
    });
    refute("REJECTED  step 1: there is no premise nonzero[1]", |steps| {
        steps[0].combination[1].0 = Premise::Nonzero(1);
    });
    refute("REJECTED  step 1: there is no premise of this kind", |steps| {
        steps[0].combination[1].0 = Premise::Equation(1);
    });
    refute("REJECTED  the last conclusion is not 1", |steps| drop(steps.pop()));
    refute("REJECTED  the last conclusion is not 1", Vec::clear);
    // The same certificate for another net, with one corner on the other side.
    let net = fs::read_to_string("proofs/cap-2x2/statement.toml").unwrap();
    let other = net.replacen("\"-sqrt(3)/3\"", "\"sqrt(3)/3\"", 1);
    assert_ne!(net, other);
    all.push((
        Statement::read(&other).unwrap(),
        good.clone(),
        "REJECTED  step 1: the sum is not the stated conclusion",
    ));

    let (system, closing) = committed("degrees-cube/closing");
    let four = "VERIFIED  impossible: 1 is a combination of the equations, 4 steps";
    all.push((system.clone(), closing.clone(), four));
    let foreign = damaged(&closing, |steps| steps[0].combination[0].0 = Premise::Coefficient(1, 1));
    all.push((system.clone(), foreign, "REJECTED  step 1: there is no premise of this kind"));
    let beyond = damaged(&closing, |steps| steps[0].combination[0].0 = Premise::Equation(9));
    all.push((system, beyond, "REJECTED  step 1: there is no premise f[9]"));

    let (hostile, proof) = proved(&hostile_statement(hostile_names(), TITLE));
    all.push((hostile, proof, "VERIFIED  impossible: 1 is a combination of the equations, 3 steps"));
    all
}

/// Exact claims, long sums and long numbers, fields without roots, statements without unknowns.
fn more_judgements() -> Vec<(Statement, Certificate, &'static str)> {
    let (octant, values) = committed("octant");
    let mut wrong = values.clone();
    let Argument::Exact(of_wrong) = &mut wrong.argument else { panic!("a net") };
    of_wrong[0] = Polynomial::integer(7);
    let head = "title = \"t\"\nunknowns = [\"a\"]\nradicands = [3]\n";
    let zero = || Argument::Exact(vec![Polynomial::integer(0)]);
    let net = format!(
        "{head}convention = \"homogeneous\"\nbidegree = [1, 1]\nnet = [[[\"a\", \"0\", \"0\", \"a\"], [\"a\", \"0\", \"0\", \"a\"]], \
         [[\"a\", \"0\", \"0\", \"a\"], [\"0\", \"a*sqrt(3)\", \"0\", \"a*sqrt(3)\"]]]\n"
    );
    let bare = "title = \"t\"\nunknowns = []\nradicands = []\n";
    let claims = [
        (
            claimed(&format!("{head}polynomials = [\"a\", \"a^2\"]\n"), zero()),
            "VERIFIED  exact: all 2 equations vanish",
        ),
        (
            claimed(&format!("{head}polynomials = [\"a\", \"a^2 - sqrt(3)\"]\n"), zero()),
            "REJECTED  f[2] is not zero",
        ),
        (
            claimed(&format!("{head}nonzero = [\"1\", \"a\"]\npolynomials = [\"a\"]\n"), zero()),
            "REJECTED  assumption 2 is zero",
        ),
        (claimed(&net, zero()), "REJECTED  all weights are zero"),
        (
            claimed(&format!("{bare}polynomials = [\"0\"]\n"), Argument::Exact(Vec::new())),
            "VERIFIED  exact: all 1 equations vanish",
        ),
        (
            claimed(&format!("{bare}polynomials = [\"0\", \"2/3\"]\n"), Argument::Exact(Vec::new())),
            "REJECTED  f[2] is not zero",
        ),
        (
            proved(&format!("{bare}polynomials = [\"2/3\"]\n")),
            "VERIFIED  impossible: 1 is a combination of the equations, 1 step",
        ),
        (
            proved(&format!(
                "{head}polynomials = [\"(a + sqrt(3) + 1/7)^40\", \"(a + sqrt(3) + 1/7)^40 - 1\"]\n"
            )),
            "VERIFIED  impossible: 1 is a combination of the equations, 1 step",
        ),
        (
            proved(&format!("{head}polynomials = [\"3^900/11^700*a - 1\", \"a\"]\n")),
            "VERIFIED  impossible: 1 is a combination of the equations, 1 step",
        ),
        ((octant.clone(), values), "VERIFIED  exact: all 25 coefficients vanish"),
        ((octant, wrong), "REJECTED  c[1,2] is not zero"),
    ];
    claims.into_iter().map(|((statement, certificate), say)| (statement, certificate, say)).collect()
}

/// Our own checker says the same, so that the words above are about the proofs and not about the scripts.
#[test]
fn the_checker_agrees() {
    for (statement, certificate, say) in judgements().into_iter().chain(more_judgements()) {
        let verdict = check_read(&statement, &certificate);
        assert_eq!(verdict.is_ok(), say.starts_with("VERIFIED"), "{say}: {verdict:?}");
    }
}

/// One judgement in so many is asked of a system: some take half a second to start.
fn judges(target: Target, one_in: usize) {
    let mut wrong = Vec::new();
    for (statement, certificate, say) in judgements().into_iter().chain(more_judgements()).step_by(one_in) {
        let Some(said) = verdict(target, &script(&statement, &certificate, target)) else {
            return not_run(&format!("{target:?}").to_lowercase());
        };
        if said != say {
            wrong.push(format!("{said}\n   instead of {say}: {}", statement.title()));
        }
    }
    assert!(wrong.is_empty(), "{target:?}:\n{}", wrong.join("\n"));
}

#[test]
fn singular_judges() {
    judges(Target::Singular, 1);
}

#[test]
fn pari_judges() {
    judges(Target::Pari, 1);
}

#[test]
fn maxima_judges() {
    judges(Target::Maxima, 2);
}

#[test]
fn macaulay2_judges() {
    judges(Target::Macaulay2, 8);
}

#[test]
fn sympy_judges() {
    judges(Target::Sympy, 8);
}

#[test]
#[ignore = "half a minute, mostly of starting programs"]
fn all_judge_everything() {
    for target in TARGETS {
        judges(target, 1);
    }
}
