//! One file for each way to be wrong, and the exact complaint about it.
//!
//! `tests/data/reject/statement/VARIANT-detail.toml` must be refused with that variant, `tests/data/reject/certificate/` likewise
//! (held against `statement.toml` there, or against a file of its own name). The complaint in full stands beside each
//! file in `.expected`; `PROVE_CAP_UPDATE=1 cargo test` writes it anew. A variant without a file fails the suite.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use prove_cap::checker::{CheckError, check};
use prove_cap::exact::Work;
use prove_cap::statement::Statement;

fn corpus(folder: &str, extension: &str) -> Vec<PathBuf> {
    let entries =
        fs::read_dir(Path::new("tests/data/reject").join(folder)).unwrap().map(|entry| entry.unwrap().path());
    let mut files: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|e| e == extension)).collect();
    files.sort();
    assert!(files.len() > 5, "the corpus in {folder} is found");
    files
}

/// The variant that a file's name promises.
fn promised(file: &Path) -> String {
    let stem = file.file_stem().unwrap().to_str().unwrap();
    stem.split('-').next().unwrap().to_owned()
}

fn variant(debug: &str) -> String {
    debug.chars().take_while(char::is_ascii_alphanumeric).collect()
}

/// `Bounds(Subdivision(Sign { … }))` without what wraps it.
fn innermost(debug: &str) -> String {
    match debug.split_once('(') {
        Some((wrapper, inner)) if wrapper.chars().all(|c| c.is_ascii_alphanumeric()) => innermost(inner),
        _ => debug.trim_end_matches(')').to_owned(),
    }
}

/// Compares a complaint with the one on file.
fn compare(file: &Path, complaint: &str) {
    let expected = file.with_extension("expected");
    if std::env::var_os("PROVE_CAP_UPDATE").is_some() {
        fs::write(&expected, format!("{complaint}\n")).unwrap();
    }
    let text = fs::read_to_string(&expected).unwrap_or_else(|_| panic!("{} is missing", expected.display()));
    assert_eq!(format!("{complaint}\n"), text, "{}", file.display());
}

/// The variants of an error enum, read from its source.
fn variants(source: &str, name: &str) -> BTreeSet<String> {
    let text = fs::read_to_string(source).unwrap();
    let body = text.split(&format!("pub enum {name} {{")).nth(1).unwrap().split("\n}").next().unwrap();
    let lines = body.lines().filter_map(|line| line.strip_prefix("    "));
    lines.filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase())).map(variant).collect()
}

#[test]
fn wrong_statements_are_refused_with_the_exact_complaint() {
    let mut seen = BTreeSet::new();
    for file in corpus("statement", "toml") {
        let error = Statement::read_bytes(&fs::read(&file).unwrap(), &mut Work::full())
            .expect_err(&file.display().to_string());
        assert_eq!(variant(&format!("{:?}", error.fault)), promised(&file), "{}: {error}", file.display());
        compare(&file, &error.to_string());
        seen.insert(promised(&file));
    }
    assert_eq!(
        seen,
        variants("src/kernel/statement/error.rs", "StatementFault"),
        "one file at least for each variant"
    );
}

/// Listings are held against `statement.toml` there, the paper's patch with a second name for nothing.
#[test]
fn wrong_listings_are_refused_with_the_exact_complaint() {
    use prove_cap::audit::{Audit, AuditError};
    use prove_cap::formats::listing::{Listing, Notation};

    let mut seen = BTreeSet::new();
    let files = ["tex", "txt", "toml"].map(|extension| corpus("listing", extension)).concat();
    for file in files.iter().filter(|file| !file.ends_with("statement.toml")) {
        let text = fs::read_to_string(file).unwrap();
        let listing = match file.extension().unwrap().to_str().unwrap() {
            "tex" => Listing::from_formulas("", &text, Notation::Latex),
            "txt" => Listing::from_formulas("", &text, Notation::Plain),
            _ => Listing::from_toml(&text),
        };
        let statement =
            Statement::read(&fs::read_to_string("tests/data/reject/listing/statement.toml").unwrap());
        let audit = listing.map_err(AuditError::from).and_then(|listing| {
            Audit::of(&listing, &statement.unwrap(), &prove_cap::control::Control::default())
        });
        let Err(AuditError::Listing(error)) = audit else { panic!("{}: {audit:?}", file.display()) };
        assert_eq!(variant(&format!("{:?}", error.fault)), promised(file), "{}: {error}", file.display());
        compare(file, &error.to_string());
        seen.insert(promised(file));
    }
    assert_eq!(
        seen,
        variants("src/formats/listing/error.rs", "ListingFault"),
        "one file at least for each variant"
    );
}

#[test]
fn wrong_certificates_are_refused_with_the_exact_complaint() {
    let mut seen = BTreeSet::new();
    for file in corpus("certificate", "txt") {
        let own = file.with_extension("toml");
        let statement = if own.exists() { own } else { file.with_file_name("statement.toml") };
        let result = check(&fs::read(statement).unwrap(), &fs::read(&file).unwrap());
        let error = result.expect_err(&file.display().to_string());
        let inner = match &error {
            CheckError::Certificate(error) => format!("{:?}", error.fault),
            CheckError::Rejected(rejection) => innermost(&format!("{rejection:?}")),
            other => panic!("{}: {other:?}", file.display()),
        };
        assert_eq!(variant(&inner), promised(&file), "{}: {error}", file.display());
        compare(&file, &error.to_string());
        seen.insert(promised(&file));
    }
    let mut all = variants("src/kernel/text/error.rs", "CertificateFault");
    all.insert("OtherStatement".into());
    for folder in fs::read_dir("src/kernel/claims").unwrap().map(|entry| entry.unwrap().path()) {
        if folder.is_dir() {
            all.append(&mut variants(folder.join("mod.rs").to_str().unwrap(), "Rejection"));
        }
    }
    // These wrap another's.
    all.remove("Subdivision");
    all.remove("Exact");
    // The reader's last resort: no file is known that gets that far.
    all.remove("NotCanonical");
    assert_eq!(seen, all, "one file at least for each variant");
}

#[test]
fn the_corpus_is_wrong_in_one_way_only() {
    let statement = fs::read("tests/data/reject/certificate/statement.toml").unwrap();
    let good = fs::read("tests/data/accept/two_steps.txt").unwrap();
    check(&statement, &good).expect("the certificate that most of them are made from is right");
}
