//! The kernel stands on these crates and no others, and the prover is a library without its program.

use std::collections::BTreeSet;
use std::process::Command;

/// Integers and rationals; SHA-256; a TOML reader; and what those bring along.
const ALLOWED: &[&str] = &[
    "prove-cap-kernel",
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

/// The names of the crates in the tree that `cargo tree` prints.
fn tree(selection: &[&str]) -> BTreeSet<String> {
    let cargo = std::env::var("CARGO").unwrap_or("cargo".into());
    let arguments = ["tree", "--edges", "normal,build", "--prefix", "none", "--offline"];
    let output = Command::new(cargo).args(arguments).args(selection).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    text.lines().filter_map(|line| line.split_whitespace().next()).map(String::from).collect()
}

#[test]
fn the_kernel_needs_numbers_a_hash_and_a_toml_reader() {
    let found = tree(&["-p", "prove-cap-kernel"]);
    let strangers: Vec<_> = found.iter().filter(|name| !ALLOWED.contains(&name.as_str())).collect();
    assert!(strangers.is_empty(), "the kernel depends on {strangers:?}");
    assert!(
        found.contains("num-bigint") && found.contains("toml"),
        "the list is that of the kernel: {found:?}"
    );
}

#[test]
fn users_of_the_library_do_not_get_a_command_line_or_fonts() {
    let library = tree(&["-p", "prove-cap", "--no-default-features"]);
    let program = tree(&["-p", "prove-cap"]);
    for name in ["clap", "ctrlc", "resvg", "dejavu"] {
        assert!(!library.contains(name), "the library depends on {name}");
        assert!(program.contains(name), "the program depends on {name}");
    }
}
