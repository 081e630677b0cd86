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
    let sessions = Path::new("tests/data/sessions/session.in");
    let statement = sessions.join("small.toml");
    for (certificate, verdict, status) in [
        ("good.txt", Verdict::Verified, Status::Established),
        ("bad.txt", Verdict::Rejected, Status::Wrong),
    ] {
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
