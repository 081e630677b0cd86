//! Coq files: reproduced to the byte, and, where Coq is installed, accepted with no axioms but those of the real numbers, or refused.
//!
//! `PROVE_CAP_UPDATE=1 cargo test --test formats` writes the committed files anew. `scripts/outside` has Coq read all of
//! them, and that of the largest proof, a megabyte that is not committed.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::support::{LARGEST, committed, damaged, folders, negated, not_run, parsed, proved, refutations};
use prove_cap::certificate::{Argument, Certificate, Premise, Step};
use prove_cap::exact::Polynomial;
use prove_cap::formats::export::{Case, ExportError, Target, export};
use prove_cap::statement::Statement;

const AXIOMS: [&str; 3] = [
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
];

fn written(statement: &Statement, certificate: &Certificate) -> String {
    export(&Case::new(statement, certificate).unwrap(), Target::Coq).unwrap()
}

/// What Coq says of a file: the axioms it lists, or its error; `None` if it is not installed.
fn coq(text: &str) -> Option<Result<Vec<String>, String>> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("theorem.v"), text).unwrap();
    let output = Command::new("coqc").arg("theorem.v").current_dir(folder.path()).output();
    let Ok(output) = output else {
        not_run("coq");
        return None;
    };
    let [stdout, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    if !output.status.success() {
        assert!(!stdout.contains("Axioms:"), "the theorem was reached: {stdout}");
        return Some(Err(stderr));
    }
    assert_eq!(stderr, "");
    let lines = stdout.lines().filter(|line| !line.starts_with(' ') && *line != "Axioms:");
    Some(Ok(lines.map(|line| line.split(' ').next().unwrap().to_owned()).collect()))
}

fn accepted(text: &str) {
    if let Some(answer) = coq(text) {
        assert_eq!(answer.unwrap(), AXIOMS);
    }
}

/// Refused, at this line of the file, with this in the message.
fn refused(text: &str, line: &str, message: &str) {
    let Some(answer) = coq(text) else { return };
    let error = answer.unwrap_err();
    let number: usize =
        error.split("line ").nth(1).and_then(|rest| rest.split(',').next()).unwrap().parse().unwrap();
    let before = text.lines().take(number).collect::<Vec<_>>();
    let place = before.iter().rev().find(|line| line.starts_with("Lemma") || line.starts_with("Theorem"));
    assert!(place.is_some_and(|place| place.contains(line)), "at {place:?}: {error}");
    assert!(error.contains(message), "{error}");
}

#[test]
fn committed_files_are_reproduced() {
    for folder in folders() {
        let (statement, certificate) = committed(&folder);
        let text = written(&statement, &certificate);
        let file = Path::new("proofs").join(&folder).join("theorem.v");
        if std::env::var_os("PROVE_CAP_UPDATE").is_some() {
            fs::write(&file, &text).unwrap();
        }
        let present = fs::read_to_string(&file).unwrap_or_default();
        assert!(present == text, "{}: PROVE_CAP_UPDATE=1 cargo test --test formats", file.display());
    }
}

/// The page about the proofs names every folder that holds one, with the Coq file it is said to hold, and counts them.
#[test]
fn the_page_of_proofs_has_them_all() {
    let page = fs::read_to_string("proofs/README.md").unwrap();
    let mut folders = folders();
    for folder in &folders {
        assert!(page.contains(&format!("`{folder}`")), "{folder}");
        assert!(Path::new("proofs").join(folder).join("theorem.v").is_file(), "{folder}");
    }
    folders.push(LARGEST.to_owned());
    assert!(page.contains(&format!("`{LARGEST}`")));
    let count = folders.len();
    assert_eq!(page.matches(&format!("| {count} of {count}")).count(), 7, "{count} proofs");
    let refutations = refutations().len() + 1;
    assert!(
        page.contains(&format!("| {refutations} of {refutations}, by hand |")),
        "{refutations} refutations"
    );
    for named in page.split('`').skip(1).step_by(2).filter(|name| name.starts_with("degrees-")) {
        assert!(folders.iter().any(|folder| folder == named), "{named} is not there");
    }
}

/// The readable part of the paper's theorem, word for word.
#[test]
fn the_theorem_is_the_geometric_statement() {
    let (statement, certificate) = committed("cap-2x2");
    let text = written(&statement, &certificate);
    for sentence in [
        "Definition bernstein (n i : nat) (t : R) : R :=\n  IZR (binomial n i) * t ^ i * (1 - t) ^ (n - i).",
        "Definition surface (X Y Z W : R) : R := X ^ 2 + Y ^ 2 + Z ^ 2 - W ^ 2.",
        "Definition net (w z : R) : list (list point) :=\n  \
         [[Point (-(sqrt 3 / 3)) (-(sqrt 3 / 3)) (sqrt 3 / 3) 1;\n    \
         Point 0 (-(sqrt 2 / 2)) (sqrt 2 / 2) (sqrt 6 / 3);",
        "    Point 0 0 (w * z) w;\n",
        "Theorem misses_the_surface : forall w z : R,\n  \
         exists u v : R, 0 <= u <= 1 /\\ 0 <= v <= 1 /\\\n    \
         patch W (net w z) u v <> 0 /\\ ~ lies_on surface (net w z) u v.",
        "Theorem never_on_the_surface : forall w z : R,\n  \
         ~ (forall u v : R, 0 <= u <= 1 -> 0 <= v <= 1 ->\n       \
         patch W (net w z) u v <> 0 -> lies_on surface (net w z) u v).",
        "Definition theorems := (misses_the_surface, never_on_the_surface).\n\nPrint Assumptions theorems.\n",
    ] {
        assert!(text.contains(sentence), "{sentence}");
    }
    for word in ["Axiom", "Parameter", "Conjecture", "Admitted", "admit", "Abort"] {
        assert!(!text.split(|c: char| !c.is_alphanumeric()).any(|found| found == word), "{word}");
    }
    accepted(&text);
}

#[test]
fn an_exact_net_is_on_the_surface_with_its_edges_in_planes() {
    let (statement, certificate) = committed("cobb");
    let text = written(&statement, &certificate);
    for sentence in [
        "Theorem on_the_surface : forall u v : R, patch W net u v <> 0 -> lies_on surface net u v.",
        "Theorem weight_is_positive : forall u v : R, 0 <= u <= 1 -> 0 <= v <= 1 -> 0 < patch W net u v.",
        "Definition plane_v1 (X Y Z W : R) : R := X + Z.",
        "Theorem edge_v1 : forall u : R, patch W net u 1 <> 0 -> lies_on plane_v1 net u 1.",
        "(on_the_surface, weight_is_positive, edge_u0, edge_u1, edge_v0, edge_v1)",
    ] {
        assert!(text.contains(sentence), "{sentence}");
    }
    accepted(&text);
    // The planes are computed from the net; a wrong one is refused.
    let wrong = text.replace("plane_v1 (X Y Z W : R) : R := X + Z.", "plane_v1 (X Y Z W : R) : R := X - Z.");
    refused(&wrong, "Theorem edge_v1", "plane_v1");
}

/// A net whose data are wrong, a weight that is not positive.
#[test]
fn nets_that_are_not_exact_are_refused() {
    let (statement, _) = committed("octant");
    let values = [7, 0, 0, 1].map(Polynomial::integer).to_vec();
    let wrong = Certificate { statement: statement.hash(), argument: Argument::Exact(values) };
    refused(&written(&statement, &wrong), "Lemma on_surface", "identity");
}

const HEAD: &str = "title = \"t\"\nradicands = [2, 5]\n";

/// Everything a statement can have: an assumption with a root and fractions, weights that may all vanish, another surface, a field without roots.
#[test]
fn statements_of_every_kind_are_proved() {
    let assumption = format!(
        "{HEAD}unknowns = [\"a\", \"b\"]\nnonzero = [\"a/2 - sqrt(10)/3\", \"b\"]\npolynomials = [\"(a/2 - sqrt(10)/3)*b*a\", \"a - 1/7\"]\n"
    );
    let (statement, certificate) = proved(&assumption);
    let text = written(&statement, &certificate);
    assert!(
        text.contains("forall a b : R,\n  1 / 2 * a - sqrt 10 / 3 <> 0 ->\n  b <> 0 ->\n  Exists"),
        "{text}"
    );
    accepted(&text);

    // No weight is a constant: that there is one has to be assumed. The surface is z² = 2xw.
    let open = format!(
        "{HEAD}unknowns = [\"a\", \"b\"]\nconvention = \"homogeneous\"\nbidegree = [1, 1]\nsurface = \"Z^2 - 2*X*W\"\nnet = [\
         [[\"a\", \"0\", \"a\", \"b\"], [\"1\", \"a\", \"0\", \"b\"]], [[\"0\", \"1\", \"1\", \"a\"], [\"b\", \"0\", \"sqrt(2)\", \"a\"]]]\n"
    );
    let (statement, certificate) = proved(&open);
    let text = written(&statement, &certificate);
    assert!(text.contains("forall a b : R,\n  some_weight (net a b) ->\n  exists u v : R"), "{text}");
    accepted(&text);
}

/// Long numbers are written in groups, also where a theorem names a common denominator.
#[test]
fn long_denominators_are_read() {
    let text = format!(
        "{HEAD}unknowns = [\"a\"]\nnonzero = [\"a/13^40 + 1\"]\npolynomials = [\"a/7^60 - 1\", \"a\"]\n"
    );
    let (statement, certificate) = proved(&text);
    let text = written(&statement, &certificate);
    assert!(text.split_once("(** * 4.").unwrap().1.contains("(Replay.long ["), "{text}");
    accepted(&text);
}

#[test]
fn solutions_of_systems_are_theorems_too() {
    let text = format!(
        "{HEAD}unknowns = [\"a\"]\nnonzero = [\"1 - a\"]\npolynomials = [\"a^2 - 2\", \"a*sqrt(5) - sqrt(10)\"]\n"
    );
    let statement = Statement::read(&text).unwrap();
    let root = parsed(
        &statement,
        &format!(
            "prove-cap certificate 1\nstatement sha256 {}\nclaim exact\nvalue a = sqrt(2)\nend 1\n",
            statement.hash()
        ),
    );
    let text = written(&statement, &root);
    assert!(text.contains("Theorem nonzero_1 : 1 - sqrt 2 <> 0."), "{text}");
    accepted(&text);
    let wrong = Argument::Exact(vec![Polynomial::integer(1)]);
    let text = written(&statement, &Certificate { statement: statement.hash(), argument: wrong });
    refused(&text, "Theorem all_hold", "Unable to unify");
}

fn refutes(damage: fn(&mut Vec<Step>)) {
    let (statement, certificate) = committed("cap-2x2");
    refused(&written(&statement, &damaged(&certificate, damage)), "Lemma refuted", "refuted");
}

#[test]
fn a_wrong_multiplier_is_refused() {
    refutes(|steps| steps[0].combination[0].1 = negated(&steps[0].combination[0].1));
}

#[test]
fn a_proof_without_its_end_is_refused() {
    refutes(|steps| drop(steps.pop()));
}

#[test]
#[ignore = "half a minute of Coq"]
fn damaged_proofs_are_refused() {
    refutes(|steps| steps[1].conclusion = steps[0].conclusion.clone());
    refutes(|steps| steps[2].combination[0].1 = Polynomial::integer(7));
    refutes(|steps| steps[0].combination[0].0 = Premise::Coefficient(0, 0));
    refutes(|steps| steps[0].combination[0].0 = Premise::Coefficient(9, 9));
    refutes(|steps| steps[0].combination[0].0 = Premise::Nonzero(1));
    refutes(|steps| steps[0].combination[0].0 = Premise::Equation(1));
    refutes(|steps| drop(steps[2].combination.remove(1)));
    refutes(|steps| drop(steps.remove(1)));
    refutes(|steps| steps.swap(0, 2));
    refutes(|steps| steps[1].combination[1].0 = Premise::Step(3));
    refutes(|steps| steps[1].combination[1].0 = Premise::Step(0));
    refutes(Vec::clear);
}

/// What people read and what is computed with are held against each other: neither can be changed alone.
#[test]
#[ignore = "half a minute of Coq"]
fn the_readable_part_cannot_be_changed_alone() {
    let (statement, certificate) = committed("cap-2x2");
    let text = written(&statement, &certificate);
    let unread = "Theorem misses_the_surface";
    for (part, other, message) in [
        ("Point 0 0 (w * z) w", "Point 0 0 (w * z) (w * w)", "net"),
        ("Point 0 (-(sqrt 2 / 2))", "Point 0 (sqrt 2 / 2)", "net"),
        ("X ^ 2 + Y ^ 2 + Z ^ 2 - W ^ 2.", "X ^ 2 + Y ^ 2 + Z ^ 2 + W ^ 2.", "surface"),
        ("sqrt 6 / 3", "sqrt 5 / 3", "net"),
        ("exists u v : R, 0 <= u <= 1", "exists u v : R, 1 <= u <= 1", ""),
    ] {
        assert!(text.contains(part));
        refused(&text.replacen(part, other, 1), unread, message);
    }
    // The data alone: the net's data are not what is read, or the certificate is not one for them.
    refused(
        &text.replacen("[Term 1 1 [] [(0, 1); (1, 1)]]", "[Term 1 1 [] [(0, 1)]]", 1),
        "Lemma refuted",
        "refuted",
    );
}

const HOSTILE: [&str; 10] = ["Theorem", "forall", "u", "R", "net", "IZR", "exists2", "x_net", "H_1", "c"];
const TITLE: &str = r#"' " *) Axiom f : False. (* " \ (*) é √ end Qed."#;

fn statement_with(names: [&str; 10], title: &str) -> String {
    let [a, b, c, d, e, f, g, h, i, j] = names;
    format!(
        "title = {title:?}\nradicands = [2, 5]\nunknowns = {names:?}\nnonzero = [\"{a} + {b}\"]\npolynomials = [\
         \"{a}*{b} - sqrt(10)\", \"{a} - {c}\", \"{c}*{d}\", \"{d} - 1\", \"{e} + {f}*{g} + {h}^2 - {i}/3 + {j} - sqrt(2)\"]\n"
    )
}

#[test]
fn hostile_names_and_titles_change_nothing_but_names_and_comments() {
    let (statement, certificate) = proved(&statement_with(HOSTILE, TITLE));
    let hostile = written(&statement, &certificate);
    let plain_names = ["a1", "a2", "a3", "a4", "a5", "a6", "a7", "a8", "a9", "a10"];
    let (statement, certificate) = proved(&statement_with(plain_names, "plain"));
    let plain = written(&statement, &certificate);

    let (comment, code) = hostile.split_once("*)").unwrap();
    assert!(comment.starts_with("(** ? ? ?) Axiom f : False. (? ? ? (?) ? ? end Qed."), "{comment}");
    assert!(comment.contains("x_Theorem for Theorem, x_forall for forall"), "{comment}");
    assert!(!comment[3..].contains("(*") && !comment.contains('"'), "{comment}");
    let plain = plain.split_once("*)").unwrap().1;
    // Only the part with the unknowns in it: the replay has names of its own.
    let (definitions, rest) = code.split_once("(** * 2.").unwrap();
    let (theirs, of_plain) = plain.split_once("(** * 2.").unwrap();
    let names: Vec<String> =
        HOSTILE.iter().map(|n| if *n == "c" { "c".into() } else { format!("x_{n}") }).collect();
    assert_eq!(unknowns_in(theirs, &plain_names.map(String::from)), unknowns_in(definitions, &names));
    let theorem = |text: &str| text.split_once("(** * 4.").unwrap().1.to_owned();
    assert_eq!(
        unknowns_in(&theorem(of_plain), &plain_names.map(String::from)),
        unknowns_in(&theorem(rest), &names)
    );
    accepted(&hostile);
}

/// A text with each of these words replaced by its number.
fn unknowns_in(text: &str, names: &[String]) -> String {
    let mut numbered = String::new();
    let mut word = String::new();
    for c in text.chars().chain([' ']) {
        if c.is_alphanumeric() || c == '_' {
            word.push(c);
            continue;
        }
        match names.iter().position(|name| *name == word) {
            Some(number) => numbered.push_str(&format!("<{number}>")),
            None => numbered.push_str(&word),
        }
        word.clear();
        numbered.push(c);
    }
    numbered
}

/// The statement language has no such names; an exporter that is handed one writes no code with it.
#[test]
fn names_that_no_statement_has_do_no_harm() {
    let (statement, certificate) = committed("cap-2x2");
    let mut case = Case::new(&statement, &certificate).unwrap();
    case.unknowns = vec!["w'".into(), "z. Axiom f : False. (*".into()];
    let text = export(&case, Target::Coq).unwrap();
    assert!(text.contains("forall x_w_ x_z__Axiom_f___False____ : R,"));
    accepted(&text);
    let text = "title = \"t\"\nradicands = []\nunknowns = [\"w'\"]\npolynomials = [\"1\"]\n";
    assert!(Statement::read(text).unwrap_err().to_string().contains("w'"));
}

#[test]
fn arguments_by_subdivision_are_not_exported() {
    let statement =
        Statement::read(&fs::read_to_string("proofs/construct-cube-4x4/statement.toml").unwrap()).unwrap();
    let cover = parsed(&statement, &fs::read_to_string("proofs/construct-cube-4x4/cover.txt").unwrap());
    let error = Case::new(&statement, &cover).unwrap_err();
    assert!(matches!(error, ExportError::Claim("cover")), "{error}");
    assert_eq!(error.to_string(), "only refutations and exact solutions are exported, not `claim cover`");
}
