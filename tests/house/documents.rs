//! What the documents say of the code is so.

use std::fs;

use prove_cap::commands::Verdict;
use prove_cap::exact::limits;

fn lines_of(folder: &str) -> (usize, usize) {
    // Of a folder within, its own row tells.
    let files =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_file());
    let text = files.map(|path| fs::read_to_string(path).unwrap()).collect::<String>();
    let is_code = |line: &&str| !line.trim().is_empty() && !line.trim().starts_with("//");
    (text.lines().count(), text.lines().filter(is_code).count())
}

/// The folder and all within.
fn folders_of(folder: &str) -> usize {
    let inner = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir());
    1 + inner.map(|path| folders_of(path.to_str().unwrap())).sum::<usize>()
}

/// The rows of the table of trusted lines. `PROVE_CAP_UPDATE=1` corrects them.
#[test]
fn the_page_on_trust_counts_the_trusted_lines() {
    let readme = fs::read_to_string("docs/trust.md").unwrap();
    let mut corrected = String::new();
    let mut rows = 0;
    for line in readme.lines() {
        let cells: Vec<&str> = line.split('|').map(str::trim).collect();
        let folder =
            cells.get(1).and_then(|cell| cell.strip_prefix("`src/")).and_then(|cell| cell.strip_suffix('`'));
        match folder {
            Some(folder) => {
                rows += 1;
                let (all, code) = lines_of(&format!("src/{folder}"));
                corrected += &format!("| `src/{folder}` | {} | {all} | {code} |\n", cells[2]);
            }
            None => corrected += &format!("{line}\n"),
        }
    }
    assert_eq!(rows, folders_of("src/kernel"), "each folder of the kernel has its row");
    if readme != corrected && std::env::var_os("PROVE_CAP_UPDATE").is_some() {
        fs::write("docs/trust.md", &corrected).unwrap();
    }
    assert_eq!(
        fs::read_to_string("docs/trust.md").unwrap(),
        corrected,
        "PROVE_CAP_UPDATE=1 cargo test --test house"
    );
    for part in ["src/kernel/checker", "src/kernel/claims/subdivision", "src/kernel/claims/unreachable"] {
        assert!(lines_of(part).0 < 1000, "{part} stays under a thousand lines");
    }
}

/// The tables of verdicts are printed from the enum. `PROVE_CAP_UPDATE=1` corrects them.
#[test]
fn the_pages_have_all_verdicts() {
    let mark = "<!-- verdicts, kept true by tests/house/documents.rs -->\n";
    for page in ["docs/command-line.md", "docs/trust.md"] {
        let text = fs::read_to_string(page).unwrap();
        let (before, rest) = text.split_once(mark).expect("the place for the table");
        let (_, after) = rest.split_once("<!-- end of verdicts -->").expect("the end of the table");
        let corrected = format!("{before}{mark}{}<!-- end of verdicts -->{after}", Verdict::table());
        if text != corrected && std::env::var_os("PROVE_CAP_UPDATE").is_some() {
            fs::write(page, &corrected).unwrap();
        }
        assert_eq!(
            fs::read_to_string(page).unwrap(),
            corrected,
            "{page}: PROVE_CAP_UPDATE=1 cargo test --test house"
        );
    }
}

#[test]
fn the_format_page_states_the_limits_in_force() {
    let page = fs::read_to_string("proofs/FORMAT.md").unwrap();
    let rows = [
        ("bytes of a statement file", limits::STATEMENT_BYTES),
        ("bytes of a certificate file", limits::CERTIFICATE_BYTES),
        ("bytes of a line of a certificate", limits::LINE_BYTES as u64),
        ("steps", limits::STEPS as u64),
        ("decimal places of a bound", limits::PLACES.into()),
        ("boxes of a tree, or of all charts", limits::BOXES as u64),
        ("samples", limits::SAMPLES as u64),
        ("decimal digits of an integer", limits::DIGITS as u64),
        ("terms of a polynomial", limits::TERMS as u64),
        ("powers of variables in all terms of a polynomial", limits::POWERS as u64),
        ("bits of a number on the way to a result (a common denominator, a product)", limits::BITS),
        ("bits of all numbers of one sum", limits::SUM_BITS),
        ("bits of all numbers of a statement", limits::STATEMENT_BITS),
        ("total degree of a power product, and any exponent", limits::DEGREE.into()),
        ("unknowns", limits::UNKNOWNS as u64),
        ("assumptions", limits::ASSUMPTIONS as u64),
        ("polynomials of a system", limits::EQUATIONS as u64),
        ("m and n", limits::BIDEGREE.into()),
        ("degree of the surface", limits::SURFACE_DEGREE.into()),
        ("nested brackets", limits::NESTING as u64),
        ("radicands", limits::RADICANDS as u64),
        ("value of a radicand", limits::RADICAND.into()),
        ("characters of a name", limits::NAME as u64),
        ("characters of a title", limits::TITLE as u64),
    ];
    for (what, limit) in rows {
        assert!(page.contains(&format!("| {what} | {limit} |")), "{what}: {limit}");
    }
    assert_eq!(limits::WORK, 4_000_000_000, "the page says 4·10⁹");
}

#[test]
fn the_format_page_shows_the_committed_proof() {
    let page = fs::read_to_string("proofs/FORMAT.md").unwrap();
    let certificate = fs::read_to_string("proofs/cap-2x2/certificate.txt").unwrap();
    assert!(page.contains(&certificate));
    let statement = fs::read_to_string("proofs/cap-2x2/statement.toml").unwrap();
    let statement = prove_cap::statement::Statement::read(&statement).unwrap();
    assert!(page.contains(&statement.canonical()));
}

#[test]
fn nothing_speaks_of_absolute_paths() {
    for file in pages().into_iter().chain(["justfile".to_owned()]) {
        let text = fs::read_to_string(&file).unwrap();
        for root in ["/home/", "/root/", "/tmp/", "/work/"] {
            assert!(!text.contains(root), "{file} names {root}");
        }
    }
}

/// All pages in Markdown.
fn pages() -> Vec<String> {
    let mut found = Vec::new();
    for folder in [".", "docs", "proofs", "checkers/python"] {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|ending| ending == "md") {
                found.push(path.to_str().unwrap().to_owned());
            }
        }
    }
    assert!(found.len() > 12, "{found:?}");
    found
}

#[test]
fn the_front_page_is_short() {
    let readme = fs::read_to_string("README.md").unwrap();
    assert!(readme.lines().count() <= 110, "{} lines", readme.lines().count());
    for line in readme.lines() {
        assert!(line.chars().count() <= 110, "{line}");
    }
}

/// A link to a file of the project leads to one.
#[test]
fn links_lead_somewhere() {
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        let folder = std::path::Path::new(&page).parent().unwrap();
        for link in text.split("](").skip(1) {
            let target = link.split([')', '#']).next().unwrap_or_default();
            if target.is_empty() || target.contains("://") || target.contains(char::is_whitespace) {
                continue;
            }
            assert!(folder.join(target).exists(), "{page}: {target}");
        }
    }
}

/// The table of the best patches is what the command prints. `PROVE_CAP_UPDATE=1` corrects it.
#[test]
#[ignore = "half a minute"]
fn the_page_on_approximation_has_the_table() {
    let command = assert_cmd::Command::cargo_bin("prove-cap").unwrap().arg("table").output().unwrap();
    assert!(command.status.success(), "{}", String::from_utf8_lossy(&command.stderr));
    let table = String::from_utf8(command.stdout).unwrap();
    let readme = fs::read_to_string("docs/approximation.md").unwrap();
    let mark = "<!-- table, kept true by tests/house/documents.rs -->\n```text\n";
    let (before, rest) = readme.split_once(mark).expect("the place for the table");
    let (_, after) = rest.split_once("```\n").unwrap();
    let corrected = format!("{before}{mark}{table}```\n{after}");
    if std::env::var_os("PROVE_CAP_UPDATE").is_some() {
        fs::write("docs/approximation.md", &corrected).unwrap();
    }
    assert_eq!(
        fs::read_to_string("docs/approximation.md").unwrap(),
        corrected,
        "PROVE_CAP_UPDATE=1 cargo test --release --test house -- --ignored"
    );
}
