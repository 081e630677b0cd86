//! The command line, word for word: `tests/data/sessions/session.trycmd` and the commands of the README and of proofs/STRUCTURE.md.
//!
//! `TRYCMD=overwrite cargo test --test cli` writes the outputs anew; read them before you commit them.

#[test]
fn commands_print_what_is_on_file() {
    let cases = trycmd::TestCases::new();
    cases.case("tests/data/sessions/*.trycmd");
    for page in ["README.md", "proofs/STRUCTURE.md"] {
        if std::path::Path::new(page).exists() {
            cases.case(page);
        }
    }
}
