//! The checker-only build stands on these crates and no others.

use std::collections::BTreeSet;
use std::process::Command;

/// Integers and rationals; SHA-256; a TOML reader; and what those bring along.
const ALLOWED: &[&str] = &[
    "prove-cap",
    // integers and rationals
    "num-bigint",
    "num-integer",
    "num-rational",
    "num-traits",
    "autocfg",
    // SHA-256
    "sha2",
    "digest",
    "block-buffer",
    "crypto-common",
    "hybrid-array",
    "typenum",
    "cfg-if",
    "cpufeatures",
    "libc",
    // the TOML reader
    "toml",
    "toml_datetime",
    "toml_parser",
    "serde_spanned",
    "winnow",
];

#[test]
fn the_checker_needs_numbers_a_hash_and_a_toml_reader() {
    let cargo = std::env::var("CARGO").unwrap_or("cargo".into());
    let arguments =
        ["tree", "--no-default-features", "--edges", "normal,build", "--prefix", "none", "--offline"];
    let output = Command::new(cargo).args(arguments).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let found: BTreeSet<&str> = text.lines().filter_map(|line| line.split_whitespace().next()).collect();
    let strangers: Vec<_> = found.iter().filter(|name| !ALLOWED.contains(name)).collect();
    assert!(strangers.is_empty(), "the checker-only build depends on {strangers:?}");
    assert!(
        found.contains("num-bigint") && found.contains("toml"),
        "the list is that of the checker: {found:?}"
    );
}
