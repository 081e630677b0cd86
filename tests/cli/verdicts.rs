//! First words and exit statuses: one table, which the kernel's own program agrees with.

use std::path::Path;

use prove_cap::commands::Verdict;
use prove_cap_kernel::command;
use prove_cap_kernel::outcome::Status;

#[test]
fn every_verdict_is_in_the_table_once_and_statuses_tell_words_apart() {
    for (k, verdict) in Verdict::ALL.into_iter().enumerate() {
        for other in &Verdict::ALL[k + 1..] {
            assert_ne!(verdict, *other);
            assert_ne!(verdict.meaning(), other.meaning());
            assert!(verdict.status() <= other.status(), "{verdict} before {other}");
            // Of one word in one command: the status tells them apart, or the rest of the line does.
            let (commands, others) = (verdict.meaning().0, other.meaning().0);
            assert!(verdict.word() != other.word() || commands != others, "{verdict}: {commands}");
        }
    }
    assert_eq!(
        Verdict::summary(),
        "Exit status and first word: 0 VERIFIED, PROVED, EXACT, AGREES, WRITTEN; 1 REJECTED, DIFFERS; 2 ERROR; \
         3 UNDECIDED; 4 PROVED that there is none."
    );
}

/// The checker alone says the same words with the same numbers.
#[test]
fn the_kernel_agrees() {
    let sessions = Path::new("tests/data/sessions/files");
    let statement = sessions.join("small.toml");
    for (certificate, verdict, status) in
        [("good.txt", Verdict::Verified, Status::Established), ("bad.txt", Verdict::Rejected, Status::Wrong)]
    {
        let outcome = command::check(&statement, &sessions.join(certificate)).unwrap();
        assert_eq!(outcome.text.split_whitespace().next(), verdict.word());
        assert_eq!((outcome.status, status.code()), (status, verdict.status()));
    }
    assert!(command::check(&statement, &sessions.join("nothing.txt")).is_err());
    assert_eq!(Status::Failed.code(), Verdict::Failed.status());
    assert_eq!(command::canonical(&statement).unwrap().status.code(), Verdict::Shown.status());
}

/// Whoever goes on after `construct` has a net.
#[test]
fn that_there_is_no_net_is_no_success() {
    let folder = tempfile::tempdir().unwrap();
    for bidegree in [["2", "2"], ["3", "3"], ["1", "9"]] {
        for tiling in [&[][..], &["--tiling"]] {
            let mut command = assert_cmd::Command::cargo_bin("prove-cap").unwrap();
            command.current_dir(folder.path()).args(["construct", "--bidegree"]).args(bidegree).args(tiling);
            let output = command.output().unwrap();
            assert_eq!(output.status.code(), Some(4));
            let [m, n] = bidegree;
            let line = format!(
                "PROVED  cube: no patch of bidegree ({m},{n}) on the unit sphere covers the polygon exactly\n"
            );
            assert!(String::from_utf8(output.stdout).unwrap().starts_with(&line));
        }
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// Runs a command in a fresh folder that has the files of the sessions, with more files by name.
fn run(arguments: &[&str], format: Option<&str>) -> (Option<i32>, String, String) {
    let folder = tempfile::tempdir().unwrap();
    for entry in std::fs::read_dir("tests/data/sessions/files").unwrap() {
        let file = entry.unwrap().path();
        std::fs::copy(&file, folder.path().join(file.file_name().unwrap())).unwrap();
    }
    for (name, text) in [("half.json", "{"), ("system.toml", SYSTEM), ("a.txt", "f1 = x - 2\n")] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let mut command = assert_cmd::Command::cargo_bin("prove-cap").unwrap();
    command.current_dir(folder.path()).args(arguments);
    if let Some(format) = format {
        command.args(["--format", format]);
    }
    let output = command.output().unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap());
    (output.status.code(), out, err)
}

const SYSTEM: &str = "title = \"t\"\nradicands = []\nunknowns = [\"x\"]\npolynomials = [\"x - 2\"]\n";

/// Every command with every outcome it has: the same verdict as first word, as `verdict` in JSON, and as exit status.
const CASES: &[(Verdict, &[&str])] = &[
    (Verdict::Impossible, &[]),
    (Verdict::Impossible, &["prove", "small.toml"]),
    (Verdict::Exact, &["prove", "cylinder.toml"]),
    (Verdict::Exact, &["prove", "system.toml"]),
    (Verdict::Undecided, &["prove", "complex.toml"]),
    (Verdict::Undecided, &["prove", "--timeout", "0"]),
    (Verdict::Failed, &["prove", "nothing.toml"]),
    (Verdict::Failed, &["prove", "wrong.toml"]),
    (Verdict::Failed, &["prove", "half.json"]),
    (Verdict::Failed, &["prove", "small.toml", "-o", "good.txt"]),
    (Verdict::Failed, &["prove", "--timeout", "yesterday"]),
    (Verdict::Verified, &["check", "small.toml", "good.txt"]),
    (Verdict::Rejected, &["check", "small.toml", "bad.txt"]),
    (Verdict::Rejected, &["check", "cylinder.toml", "good.txt"]),
    (Verdict::Failed, &["check", "small.toml", "crlf.txt"]),
    (Verdict::Failed, &["check", "small.toml", "nothing.txt"]),
    (Verdict::Failed, &["check", "wrong.toml", "good.txt"]),
    (Verdict::Failed, &["check"]),
    (Verdict::Shown, &["canonical", "small.toml"]),
    (Verdict::Failed, &["canonical", "wrong.toml"]),
    (Verdict::Shown, &["expand", "cap-2x2"]),
    (Verdict::Shown, &["expand", "small.toml", "--basis", "monomial"]),
    (Verdict::Failed, &["expand", "wrong.toml"]),
    (Verdict::Agrees, &["audit", "cobb"]),
    (Verdict::Agrees, &["audit", "a.txt", "--statement", "system.toml"]),
    (Verdict::Differs, &["audit"]),
    (Verdict::Differs, &["audit", "listing.txt", "--statement", "cap-2x2"]),
    (Verdict::Differs, &["audit", "net.m", "--convention", "cartesian"]),
    (Verdict::Undecided, &["audit", "--timeout", "0"]),
    (Verdict::Undecided, &["audit", "cobb", "--timeout", "0"]),
    (Verdict::Failed, &["audit", "ambiguous.tex", "--statement", "cap-2x2"]),
    (Verdict::Failed, &["audit", "stereographic"]),
    (Verdict::Failed, &["audit", "net.m"]),
    (Verdict::Enclosed, &["bound", "cap-2x2", "--set", "w=1/2", "--set", "z=2"]),
    (Verdict::Enclosed, &["bound", "cobb", "--plot", "it.svg"]),
    (Verdict::Agrees, &["bound", "cobb", "--claim", "1,1"]),
    (Verdict::Differs, &["bound", "cobb", "--claim", "1.1,1.2"]),
    (Verdict::Undecided, &["bound", "cobb", "--timeout", "0"]),
    (Verdict::Failed, &["bound", "cap-2x2"]),
    (Verdict::Failed, &["bound", "small.toml"]),
    (Verdict::Enclosed, &["approximate", "cap-2x2", "--objective", "inner"]),
    (Verdict::Enclosed, &["approximate", "cap-2x2", "--prove-best"]),
    (Verdict::Undecided, &["approximate", "cap-2x2", "--timeout", "0"]),
    (Verdict::Failed, &["approximate", "cobb"]),
    (Verdict::Undecided, &["table", "--timeout", "0"]),
    (Verdict::Failed, &["table", "cube"]),
    (Verdict::Exact, &["construct", "octant", "--bidegree", "2", "2"]),
    (Verdict::Exact, &["construct", "octant", "--bidegree", "2", "2", "--tiling"]),
    (Verdict::Nonexistent, &["construct", "--bidegree", "3", "3"]),
    (Verdict::Nonexistent, &["construct", "octant", "--bidegree", "1", "1"]),
    (Verdict::Undecided, &["construct", "--bidegree", "4", "2", "--timeout", "0"]),
    (Verdict::Failed, &["construct", "dodecagon", "--bidegree", "4", "2"]),
    (Verdict::Classified, &["degrees", "--up-to", "3"]),
    (Verdict::Classified, &["degrees", "octant", "--up-to", "2"]),
    (Verdict::Classified, &["degrees", "--explain", "2", "2"]),
    (Verdict::Classified, &["degrees", "--explain", "5", "4"]),
    (Verdict::Undecided, &["degrees", "--timeout", "0"]),
    (Verdict::Failed, &["degrees", "--corners", "1,0,0"]),
    (Verdict::Shown, &["export", "--to", "coq", "small.toml"]),
    (Verdict::Written, &["export", "--to", "coq", "small.toml", "-o", "it.v"]),
    (Verdict::Written, &["export", "--to", "pac", "small.toml", "-o", "it"]),
    (Verdict::Rejected, &["export", "--to", "pari", "small.toml", "--certificate", "bad.txt"]),
    (Verdict::Undecided, &["export", "--to", "coq", "complex.toml"]),
    (Verdict::Undecided, &["export", "--to", "sympy", "small.toml", "--timeout", "0"]),
    (Verdict::Failed, &["export", "--to", "pac", "octant"]),
    (Verdict::Failed, &["export", "--to", "coq", "small.toml", "-o", "."]),
    (Verdict::Shown, &["list"]),
    (Verdict::Failed, &["list", "all"]),
    (Verdict::Failed, &["frobnicate"]),
    (Verdict::Shown, &["--help"]),
    (Verdict::Shown, &["--version"]),
];

#[test]
fn every_command_says_its_verdict_in_every_format() {
    for (verdict, arguments) in CASES {
        let status = Some(i32::from(verdict.status()));
        let (code, out, err) = run(arguments, None);
        assert_eq!(code, status, "{arguments:?}: {out}{err}");
        // A failure is told on standard error, and only there.
        let said = if *verdict == Verdict::Failed { &err } else { &out };
        let others = if *verdict == Verdict::Failed { &out } else { &err };
        assert_eq!(others, "", "{arguments:?}");
        let first = said.split([' ', ':']).next().unwrap();
        match verdict.word() {
            Some(word) => assert_eq!(first, word, "{arguments:?}"),
            None => assert!(Verdict::ALL.iter().all(|other| other.word() != Some(first)), "{said}"),
        }

        let (code, out, err) = run(arguments, Some("latex"));
        assert_eq!(code, status, "{arguments:?}: {out}{err}");
        if *verdict == Verdict::Failed {
            assert_eq!((out.as_str(), err.lines().next()), ("", said.lines().next()), "{arguments:?}");
        } else if !arguments[0..arguments.len().min(1)].iter().any(|word| word.starts_with("--")) {
            assert!(out.starts_with("\\documentclass"), "{arguments:?}: {out}");
            assert!(out.ends_with("\\end{document}\n"), "{arguments:?}: {out}");
            assert!(!out.contains("[U+"), "{arguments:?}: a character without a command: {out}");
            // The words of the checker alone are printed as they stand.
            let words =
                verdict.word().map(|word| [format!("\\textbf{{{word}}}"), format!("\\texttt{{{word}")]);
            let said = |words: [String; 2]| words.iter().any(|word| out.contains(word.as_str()));
            assert!(words.is_none_or(said), "{arguments:?}: {out}");
        }

        let (code, out, err) = run(arguments, Some("json"));
        assert_eq!((code, err.as_str()), (status, ""), "{arguments:?}: {out}");
        let data: serde_json::Value =
            serde_json::from_str(&out).unwrap_or_else(|error| panic!("{arguments:?}: {error}: {out}"));
        let data = data.as_object().unwrap_or_else(|| panic!("{arguments:?}: {out}"));
        assert_eq!(data["verdict"].as_str(), verdict.word(), "{arguments:?}");
        assert_eq!(out.matches("\n  \"verdict\"").count(), 1, "{arguments:?}: {out}");
        if arguments.contains(&"--timeout") && *verdict == Verdict::Undecided {
            assert_eq!(data["stopped"], "timeout", "{arguments:?}: {out}");
        }
        if *verdict == Verdict::Failed {
            let reason = data["reason"].as_str().unwrap();
            // Further lines about usage repeat what was typed.
            let reason = reason.lines().next().unwrap();
            assert_eq!(said.lines().next().unwrap(), format!("ERROR: {reason}"), "{arguments:?}");
        }
        if matches!(verdict, Verdict::Rejected | Verdict::Nonexistent) {
            let (_, rest) = said.split_once(": ").unwrap();
            assert!(rest.starts_with(data["reason"].as_str().unwrap()), "{said}");
        }
    }
    let all = |verdict: &Verdict| CASES.iter().any(|(other, _)| other == verdict);
    assert!(Verdict::ALL.iter().all(all), "every verdict occurs");
}

/// The place of a fault is data.
#[test]
fn errors_name_file_line_and_column() {
    for (arguments, file, place) in [
        (&["prove", "wrong.toml"][..], Some("wrong.toml"), Some(())),
        (&["check", "small.toml", "crlf.txt"], Some("crlf.txt"), Some(())),
        (&["audit", "ambiguous.tex", "--statement", "cap-2x2"], Some("ambiguous.tex"), Some(())),
        (&["check", "small.toml", "nothing.txt"], Some("nothing.txt"), None),
        (&["prove", "half.json"], Some("half.json"), None),
        (&["export", "--to", "coq", "small.toml", "-o", "."], Some("."), None),
        (&["prove", "nosuch"], None, None),
    ] {
        let (_, out, _) = run(arguments, Some("json"));
        let data: serde_json::Value = serde_json::from_str(&out).unwrap();
        assert_eq!(data.get("file").and_then(|file| file.as_str()), file, "{out}");
        let number = |key: &str| data.get(key).map(|number| number.as_u64().unwrap());
        let (line, column) = (number("line"), number("column"));
        assert_eq!((line.map(drop), column.map(drop)), (place, place), "{out}");
        if let (Some(file), Some(line), Some(column)) = (file, line, column) {
            let start = format!("{file}:{line}:{column}: ");
            assert!(data["reason"].as_str().unwrap().starts_with(&start), "{out}");
        }
    }
}

/// Data is not prose that was cut up: paragraphs are whole, and numbers in the canonical spelling.
#[test]
fn that_there_is_no_net_is_said_as_data() {
    let (_, out, _) = run(&["construct", "--bidegree", "3", "3"], Some("json"));
    let data: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(data["reason"], "no patch of bidegree (3,3) on the unit sphere covers the polygon exactly");
    assert_eq!((&data["name"], &data["lemma"]), (&"cube".into(), &"holonomy".into()));
    assert_eq!(data["holonomy"]["sum"], "16/9*sqrt(3)");
    let paragraphs = data["argument"].as_array().unwrap();
    assert!(paragraphs.len() > 2 && paragraphs.iter().all(|text| !text.as_str().unwrap().contains('\n')));
    let (_, out, _) = run(&["degrees", "--explain", "3", "3"], Some("json"));
    let explained: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(explained["argument"], data["argument"]);
    assert_eq!(explained["exact"], false);
}
