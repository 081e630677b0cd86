//! Killed while it writes, the program leaves the old file or the new one; runs at once into one directory do not mix their files.
#![cfg(unix)]

use std::fs;
use std::process::{Command, Stdio};
use std::time::Duration;

const OLD: &str = "old bytes\n";

fn killed_at_random_moments(times: u32) {
    let folder = tempfile::tempdir().unwrap();
    let statement = folder.path().join("statement.toml");
    let certificate = folder.path().join("certificate.txt");
    let new_statement = fs::read_to_string("proofs/cap-2x2/statement.toml").unwrap();
    let new_certificate = fs::read_to_string("proofs/cap-2x2/certificate.txt").unwrap();
    let (mut old, mut new) = (0, 0);
    for k in 0..times {
        fs::write(&statement, OLD).unwrap();
        fs::write(&certificate, OLD).unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_prove-cap"))
            .args(["prove", "cap-2x2", "-o"])
            .arg(folder.path())
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        // A sweep over the few milliseconds that a run takes.
        std::thread::sleep(Duration::from_micros(u64::from(k) * 37 % 12_000));
        child.kill().unwrap();
        child.wait().unwrap();
        for (file, new_text) in [(&statement, &new_statement), (&certificate, &new_certificate)] {
            let found = fs::read_to_string(file).unwrap();
            assert!(found == OLD || found == *new_text, "{}: torn: {found:?}", file.display());
            if found == OLD { old += 1 } else { new += 1 }
        }
    }
    println!("{old} old, {new} new");
}

#[test]
fn killed_at_two_hundred_moments() {
    killed_at_random_moments(200);
}

#[test]
#[ignore = "a thousand and more runs"]
fn killed_at_two_thousand_moments() {
    killed_at_random_moments(2000);
}

/// The pair in a directory is of one run, each run has verified its own, and nothing else is left behind.
#[test]
fn runs_at_once_into_one_directory() {
    let folder = tempfile::tempdir().unwrap();
    let program = env!("CARGO_BIN_EXE_prove-cap");
    for round in 0..4 {
        let children: Vec<_> = ["cap-2x2", "cap-3x2", "cobb", "cap-2x2", "octant", "cap-3x2"]
            .map(|name| {
                let mut command = Command::new(program);
                command.args(["prove", name, "-o"]).arg(folder.path()).stdout(Stdio::piped()).spawn().unwrap()
            })
            .into();
        for child in children {
            let output = child.wait_with_output().unwrap();
            let said = String::from_utf8(output.stdout).unwrap();
            assert_eq!(output.status.code(), Some(0), "round {round}: {said}");
        }
        let files = ["statement.toml", "certificate.txt"].map(|name| folder.path().join(name));
        let check = Command::new(program).arg("check").args(&files).output().unwrap();
        assert_eq!(check.status.code(), Some(0), "{}", String::from_utf8(check.stdout).unwrap());
        let mut left: Vec<_> = fs::read_dir(folder.path()).unwrap().map(|x| x.unwrap().file_name()).collect();
        left.sort();
        assert_eq!(left, ["certificate.txt", "statement.toml"]);
    }
}
