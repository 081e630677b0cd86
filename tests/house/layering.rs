//! The order of the modules in lib.rs is the architecture: each may use those above it, none below.
//!
//! (That the kernel uses nothing else the compiler sees to; its own modules are layers too.) Paths are read
//! as tokens, so that comments and strings are no uses and every way to write a path is: nested groups,
//! `super`, renaming.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};

/// The modules in the order of lib.rs, public or not.
fn layers() -> Vec<String> {
    let text = fs::read_to_string("src/lib.rs").unwrap();
    let declared = |line: &str| {
        Some(line.trim_start_matches("pub ").strip_prefix("mod ")?.strip_suffix(';')?.to_owned())
    };
    text.lines().filter_map(declared).collect()
}

fn files(under: &Path) -> Vec<PathBuf> {
    if under.is_file() {
        return vec![under.to_owned()];
    }
    let entries = fs::read_dir(under).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| files(&path)).filter(|path| path.extension().is_some_and(|e| e == "rs")).collect()
}

/// The module that a file below src is.
fn module_of(file: &Path) -> Vec<String> {
    let inner = file.strip_prefix("src").unwrap().with_extension("");
    let names = inner.iter().map(|name| name.to_str().unwrap().to_owned());
    names.filter(|name| name != "mod").collect()
}

/// Every module that the tokens name, from the root of the crate; `crate` itself, renamed, is the empty path.
fn used(module: &[String], tokens: TokenStream) -> Vec<Vec<String>> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        match token {
            TokenTree::Ident(word) if word == "mod" => {
                // An inner module, in this file.
                if let (Some(TokenTree::Ident(name)), Some(TokenTree::Group(body))) =
                    (tokens.get(at), tokens.get(at + 1))
                {
                    let inner = [module, &[name.to_string()]].concat();
                    found.append(&mut used(&inner, body.stream()));
                    at += 2;
                }
            }
            TokenTree::Ident(word) if ["crate", "super", "self"].iter().any(|root| word == root) => {
                let start = match word.to_string().as_str() {
                    "crate" => Vec::new(),
                    "super" => module[..module.len().saturating_sub(1)].to_vec(),
                    _ => module.to_vec(),
                };
                // `pub(crate)` and the receiver `self` are no paths, and `super` within one was followed with it.
                let within = at >= 2 && is(&tokens, at - 2, ':');
                let renamed = tokens.get(at).is_some_and(|token| token.to_string() == "as");
                let is_path = !within && (renamed || is(&tokens, at, ':'));
                if is_path {
                    let rest = &tokens[at..];
                    follow(&start, rest, &mut found);
                }
            }
            // The group of a path was followed with it.
            TokenTree::Group(_) if at >= 2 && is(&tokens, at - 2, ':') => {}
            TokenTree::Group(group) => found.append(&mut used(module, group.stream())),
            _ => {}
        }
    }
    found
}

fn is(tokens: &[TokenTree], at: usize, sign: char) -> bool {
    matches!(tokens.get(at), Some(TokenTree::Punct(punct)) if punct.as_char() == sign)
}

/// Follows what stands behind a piece of a path: `::name…`, `::{…, …}`, `::*`, or nothing.
fn follow(path: &[String], rest: &[TokenTree], found: &mut Vec<Vec<String>>) {
    if !(is(rest, 0, ':') && is(rest, 1, ':')) {
        return found.push(path.to_vec());
    }
    match rest.get(2) {
        Some(TokenTree::Ident(word)) => follow(&step(path, &word.to_string()), &rest[3..], found),
        Some(TokenTree::Group(group)) => {
            let inner: Vec<TokenTree> = group.stream().into_iter().collect();
            for item in
                inner.split(|token| matches!(token, TokenTree::Punct(comma) if comma.as_char() == ','))
            {
                if let Some((TokenTree::Ident(word), rest)) = item.split_first() {
                    follow(&step(path, &word.to_string()), rest, found);
                }
            }
        }
        _ => found.push(path.to_vec()),
    }
}

fn step(path: &[String], word: &str) -> Vec<String> {
    match word {
        "self" => path.to_vec(),
        "super" => path[..path.len().saturating_sub(1)].to_vec(),
        _ => [path, &[word.to_owned()]].concat(),
    }
}

#[test]
fn arrows_point_up() {
    let layers = layers();
    assert!(layers.len() > 10, "the layers are found: {layers:?}");
    for (position, layer) in layers.iter().enumerate() {
        let folder = Path::new("src").join(layer);
        let place = if folder.is_dir() { folder } else { folder.with_extension("rs") };
        for file in files(&place) {
            let text = fs::read_to_string(&file).unwrap();
            for path in used(&module_of(&file), text.parse().unwrap()) {
                let Some(other) = path.first() else {
                    panic!("{} names the whole crate: say which module is meant", file.display());
                };
                let below = layers.iter().position(|name| name == other).is_some_and(|p| p > position);
                assert!(!below, "{} uses {other}, a lower layer than its own, {layer}", file.display());
            }
        }
    }
}

/// What a command does is in `commands`, what it prints in `report`: the files of the command line only bring them together.
#[test]
fn the_command_line_is_thin() {
    let mut commands = 0;
    for file in files(Path::new("src/cli")) {
        let text = fs::read_to_string(&file).unwrap();
        let subcommand = text.lines().next().is_some_and(|line| line.starts_with("//! `prove-cap "));
        commands += usize::from(subcommand);
        assert!(!subcommand || text.lines().count() <= 60, "{}", file.display());
        assert!(!text.contains("json!"), "{}", file.display());
    }
    assert_eq!(commands, 11, "all subcommands begin with how they are called (canonical is with check)");
    for file in files(Path::new("src/commands")) {
        let text = fs::read_to_string(&file).unwrap();
        for word in ["clap", "std::fs", "println", "json!", "process::"] {
            assert!(!text.contains(word), "{} has {word}", file.display());
        }
    }
}

/// The modules that a file declares, in its order.
fn declared(file: &Path) -> Vec<String> {
    let text = fs::read_to_string(file).unwrap_or_default();
    let lines = text.lines().filter(|line| !line.starts_with(' '));
    let name = |line: &str| {
        let line = line
            .trim_start_matches("pub(crate) ")
            .trim_start_matches("pub(super) ")
            .trim_start_matches("pub ");
        Some(line.strip_prefix("mod ")?.strip_suffix(';')?.to_owned())
    };
    lines.filter_map(name).collect()
}

/// In the kernel each module uses those above it only, within every folder too; in `exact` and `statement`
/// nothing uses what its own folder's `mod.rs` puts together.
#[test]
fn the_kernel_has_no_circles() {
    let root = Path::new("src/kernel");
    let mut compared = 0;
    for file in files(root).iter().filter(|file| !file.ends_with("main.rs") && !file.ends_with("lib.rs")) {
        let module = module_of(file)[1..].to_vec();
        let text = fs::read_to_string(file).unwrap();
        for path in used(&module, text.parse().unwrap()) {
            let shared = module.iter().zip(&path).take_while(|(a, b)| a == b).count();
            let (Some(own), Some(other)) = (module.get(shared), path.get(shared)) else { continue };
            let parent = module[..shared].iter().fold(root.to_owned(), |folder, name| folder.join(name));
            let layers = declared(&parent.join(if shared == 0 { "lib.rs" } else { "mod.rs" }));
            let place = |name: &String| layers.iter().position(|layer| layer == name);
            match (place(own), place(other)) {
                (Some(own_place), Some(other_place)) => {
                    compared += 1;
                    assert!(other_place < own_place, "{}: {own} uses {other}, a lower layer", file.display());
                }
                (_, None) => assert!(
                    !["exact", "statement"].contains(&module[0].as_str()),
                    "{}: {other} is put together in its own folder's mod.rs",
                    file.display()
                ),
                (None, _) => panic!("{}: {own} is declared nowhere", file.display()),
            }
        }
    }
    assert!(compared > 50, "paths are found: {compared}");
}

/// Long numbers are calculated with in one file of the kernel: the lints are lifted nowhere else.
#[test]
fn arithmetic_is_in_one_place() {
    let lifts = |file: &&PathBuf| {
        let text = fs::read_to_string(file).unwrap();
        ["arithmetic_side_effects", "disallowed_methods"].iter().any(|lint| text.contains(lint))
    };
    let found = files(Path::new("src/kernel"));
    let found: Vec<&PathBuf> = found.iter().filter(lifts).collect();
    assert_eq!(found, [Path::new("src/kernel/exact/numbers.rs")]);
    let clippy = fs::read_to_string("clippy.toml").unwrap();
    assert!(!clippy.contains("arithmetic-side-effects-allowed"), "no type is excepted");
    let manifest = fs::read_to_string("src/kernel/Cargo.toml").unwrap();
    for lint in ["arithmetic_side_effects", "disallowed_methods"] {
        assert!(manifest.contains(&format!("{lint} = \"deny\"")), "{lint}");
    }
}

#[test]
fn the_reader_of_paths_sees_every_form() {
    let module = ["audit".to_owned(), "net".to_owned()];
    for (text, paths) in [
        ("use crate::algebra::Integer;", vec!["algebra::Integer"]),
        ("use crate::{a::{b, c}, prove};", vec!["a::b", "a::c", "prove"]),
        ("use crate::{a::{self, b}, prove as p};", vec!["a", "a::b", "prove"]),
        ("use super::super::prove::prove;", vec!["prove::prove"]),
        ("use super::{super::prove, span};", vec!["prove", "audit::span"]),
        ("use crate as c;", vec![""]),
        ("let x = crate::cli::run();", vec!["cli::run"]),
        ("format!(\"{}\", crate::report::x)", vec!["report::x"]),
        ("mod tests { use super::super::super::cli; }", vec!["cli"]),
        ("use self::printed::Convention;", vec!["audit::net::printed::Convention"]),
        ("pub(crate) fn f(&self) -> u8 { self.x } // crate::cli\nlet s = \"crate::cli\";", vec![]),
    ] {
        let found: Vec<String> =
            used(&module, text.parse().unwrap()).iter().map(|path| path.join("::")).collect();
        assert_eq!(found, paths, "{text}");
    }
}
