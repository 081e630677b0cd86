//! The command line, word for word: `tests/data/sessions/*.trycmd`, one file for each command, and the commands of the pages.
//!
//! A session runs in a copy of the folder NAME.in, which for most is `files`; it is copied since there is a folder NAME.out.
//! `TRYCMD=overwrite cargo test --test cli` writes the outputs anew; read them before you commit them.

/// Pages with commands.
const PAGES: [&str; 6] = [
    "README.md",
    "docs/approximation.md",
    "docs/caps.md",
    "docs/exact-patches.md",
    "docs/listings.md",
    "proofs/STRUCTURE.md",
];

#[test]
fn commands_print_what_is_on_file() {
    let cases = trycmd::TestCases::new();
    cases.case("tests/data/sessions/*.trycmd");
    for page in PAGES {
        let text = std::fs::read_to_string(page).unwrap();
        assert!(text.contains("```console\n$ prove-cap"), "{page} has commands");
        cases.case(page);
    }
}

/// No other page has any.
#[test]
fn no_command_is_left_out() {
    for folder in [".", "docs", "proofs"] {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let page = path.to_str().unwrap().trim_start_matches("./").to_owned();
            if page.ends_with(".md") && !PAGES.contains(&page.as_str()) {
                assert!(!std::fs::read_to_string(&page).unwrap().contains("```console"), "{page}");
            }
        }
    }
}
