//! Killed while it writes, the program leaves the old file or the new one.
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
