//! The caps by name: `cap-MxN`, then the symmetry, then `-weights`.

use super::cap::{Cap, Interior, Symmetry};
use crate::exact::limits;

/// How the names of caps are made.
pub const FAMILY: &str = "cap-MxN[-c2|-d2|-c4|-d4][-weights]";

/// The cap with this name; `None` if the name is not made like that of a cap at all.
///
/// # Errors
/// What is wrong with the name.
pub fn cap(name: &str) -> Option<Result<Cap, String>> {
    let rest = name.strip_prefix("cap-")?;
    Some(read(rest).map_err(|fault| format!("`{name}`: {fault}; caps are called {FAMILY}, M and N from 2")))
}

fn read(text: &str) -> Result<Cap, String> {
    let mut words = text.split('-');
    let degrees = words.next().and_then(|word| word.split_once('x'));
    let degree = |word: &str| word.parse().ok().filter(|_| word.bytes().all(|byte| byte.is_ascii_digit()));
    let (m, n): (u32, u32) = degrees
        .and_then(|(m, n)| Some((degree(m)?, degree(n)?)))
        .ok_or("expected the bidegree, such as 4x3")?;
    if m < 2 || n < 2 {
        return Err("the edges have degree 2, the patch cannot have less".to_owned());
    }
    if !limits::BIDEGREE.allows(m) || !limits::BIDEGREE.allows(n) {
        return Err(format!("degrees above {} are too large for the checker", limits::BIDEGREE.at_most));
    }
    let mut words = words.peekable();
    let symmetry = match words.peek() {
        Some(&"c2") => Symmetry::C2,
        Some(&"d2") => Symmetry::D2,
        Some(&"c4") => Symmetry::C4,
        Some(&"d4") => Symmetry::D4,
        _ => Symmetry::None,
    };
    if symmetry != Symmetry::None {
        words.next();
    }
    let corner_weight = words.peek() == Some(&"weights");
    if corner_weight {
        words.next();
    }
    if let Some(word) = words.next() {
        return Err(format!("`{word}` is neither a symmetry nor `weights`, or out of order"));
    }
    if matches!(symmetry, Symmetry::C4 | Symmetry::D4) && m != n {
        return Err("rotations by 90° need the same degree in u and v".to_owned());
    }
    if corner_weight && !matches!(symmetry, Symmetry::None | Symmetry::C2) {
        return Err("with this symmetry all corner weights are equal".to_owned());
    }
    Ok(Cap { bidegree: (m, n), interior: Interior::Free(symmetry), corner_weight })
}
