//! Limits on time, memory and threads, from the command line.

use std::fs;
use std::path::Path;
use std::process::Output;

use assert_cmd::Command;

fn prove(directory: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::cargo_bin("prove-cap").unwrap();
    command.arg("prove").args(arguments).arg("-o").arg(directory).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// The proof must not depend on who computes how much of it.
#[test]
fn any_number_of_threads_gives_the_same_bytes() {
    let committed = fs::read(concat!(env!("CARGO_MANIFEST_DIR"), "/proofs/cap-4x3/certificate.txt")).unwrap();
    for threads in ["1", "2", "8"] {
        let directory = tempfile::tempdir().unwrap();
        let output = prove(directory.path(), &["cap-4x3", "--threads", threads]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        let certificate = fs::read(directory.path().join("certificate.txt")).unwrap();
        assert!(certificate == committed, "{threads} threads");
    }
}

#[test]
fn too_little_memory_or_time_is_undecided_and_leaves_nothing_behind() {
    let cases = [
        (["--max-memory", "60M"], "the memory allowed is used up"),
        (["--timeout", "0"], "the time allowed is over"),
    ];
    for (limit, why) in cases {
        let directory = tempfile::tempdir().unwrap();
        let output = prove(directory.path(), &["cap-4x4", limit[0], limit[1]]);
        assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));
        let said = text(&output.stdout);
        assert!(said.starts_with("UNDECIDED  cap-4x4: stopped early\n"), "{said}");
        assert!(said.contains(&format!("Stopped: {why}. Nothing was established.")), "{said}");
        assert_eq!(fs::read_dir(directory.path()).unwrap().count(), 0);
    }
}

#[test]
fn enough_memory_and_time_change_nothing() {
    let directory = tempfile::tempdir().unwrap();
    let output = prove(directory.path(), &["cap-3x2", "--max-memory", "4G", "--timeout", "1e4"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
}

#[test]
fn verbose_tells_the_phases_on_stderr_only() {
    let directory = tempfile::tempdir().unwrap();
    let quiet = prove(directory.path(), &["cap-3x3"]);
    let verbose = prove(directory.path(), &["cap-3x3", "--verbose"]);
    assert_eq!(text(&quiet.stdout), text(&verbose.stdout));
    assert_eq!(text(&quiet.stderr), "");
    let told = text(&verbose.stderr);
    for phase in [
        "sign symmetries: 2; 25 equations in ",
        "linear equations: 12 variables eliminated, 9 equations left",
        "degree 3: 45 multiples in 35 monomials",
        "degree 3: rank 35, 1 polynomials of lower degree found",
        "that has degree 0",
        "shortening the proof",
    ] {
        assert!(told.contains(phase), "{phase} in\n{told}");
    }
}

#[test]
fn limits_that_are_refused() {
    let directory = tempfile::tempdir().unwrap();
    let cases = [
        (
            ["--max-memory", "plenty"],
            "invalid value 'plenty' for '--max-memory <SIZE>': expected a size in bytes, such as 500M or 2G",
        ),
        (["--threads", "0"], "invalid value '0' for '--threads <N>': 0 is not in 1..=65535"),
        (["--timeout", "-1"], "unexpected argument '-1' found"),
    ];
    for (limit, fault) in cases {
        let output = prove(directory.path(), &["cap-2x2", limit[0], limit[1]]);
        assert_eq!(output.status.code(), Some(2));
        let said = text(&output.stderr);
        assert!(said.starts_with(&format!("ERROR: {fault}")), "{said}");
    }
}
