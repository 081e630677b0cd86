//! The order of the modules in lib.rs is the architecture: each may use those above it, none below.

use std::fs;
use std::path::{Path, PathBuf};

/// The modules in the order of lib.rs.
fn layers() -> Vec<String> {
    let text = fs::read_to_string("src/lib.rs").unwrap();
    let modules = text.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';'));
    modules.map(String::from).collect()
}

fn files(under: &Path) -> Vec<PathBuf> {
    if under.is_file() {
        return vec![under.to_owned()];
    }
    let entries = fs::read_dir(under).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| files(&path)).filter(|path| path.extension().is_some_and(|e| e == "rs")).collect()
}

/// The modules that a source text names after `crate::`.
fn used(text: &str) -> Vec<String> {
    let mentions = text.split("crate::").skip(1).flat_map(|rest| match rest.strip_prefix('{') {
        // use crate::{a::b, c};
        Some(list) => {
            let list = list.split('}').next().unwrap_or("");
            list.split(',').map(|item| item.trim().to_owned()).collect::<Vec<_>>()
        }
        None => vec![rest.to_owned()],
    });
    let word = |text: String| text.chars().take_while(|c| c.is_ascii_alphanumeric() || *c == '_').collect();
    mentions.map(word).collect()
}

#[test]
fn arrows_point_up() {
    let layers = layers();
    assert_eq!(layers[..4], ["exact", "statement", "certificate", "checker"], "the trusted part comes first");
    for (position, layer) in layers.iter().enumerate() {
        let folder = Path::new("src").join(layer);
        let place = if folder.is_dir() { folder } else { folder.with_extension("rs") };
        for file in files(&place) {
            for other in used(&fs::read_to_string(&file).unwrap()) {
                let below = layers.iter().position(|name| *name == other).is_some_and(|p| p > position);
                assert!(!below, "{} uses {other}, a lower layer than its own, {layer}", file.display());
            }
        }
    }
}

#[test]
fn the_reader_of_imports_sees_every_form() {
    let text = "use crate::algebra::Integer;\nuse crate::{prove::prove, report};\nlet x = crate::cli::run();";
    assert_eq!(used(text), ["algebra", "prove", "report", "cli"]);
}

#[test]
fn files_stay_small() {
    for file in files(Path::new("src")) {
        let lines = fs::read_to_string(&file).unwrap().lines().count();
        assert!(lines <= 400, "{} has {lines} lines", file.display());
    }
}
