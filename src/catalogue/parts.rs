//! A net without symmetry, written in its symmetric and antisymmetric parts.
//!
//! The reflections of the square, u → 1−u with y → −y and v → 1−v with x → −x, map patches for the cap to patches
//! for the cap. Every net is the sum of four parts: `X11` stands for the part that both reflections keep, `X11u` and
//! `X11v` for those that change sign under the first or the second, `X11uv` for the one that changes sign under both.
//! This is a linear change of unknowns, nothing is lost; but the condition splits into four kinds of equations too,
//! which makes elimination and its certificates several times smaller.

use super::cap::Symmetry;

/// One of the four parts: whether it changes sign under the reflection in u, and in v.
const PARTS: [(bool, bool, &str); 4] =
    [(false, false, ""), (true, false, "u"), (false, true, "v"), (true, true, "uv")];

/// The four numbers of the inner control point (i, j) of an (m+1)×(n+1) net, as sums of those parts that the symmetry
/// keeps: all without symmetry, two with the half-turn, one with both reflections.
pub(super) fn entries((m, n): (u32, u32), symmetry: Symmetry, i: u32, j: u32) -> [String; 4] {
    // The place that gives its name to all its mirror images.
    let (a, b) = (i.min(m - i), j.min(n - j));
    let index = if a < 10 && b < 10 { format!("{a}{b}") } else { format!("{a}_{b}") };
    ['X', 'Y', 'Z', 'W'].map(|letter| {
        let kept = |&(odd_in_u, odd_in_v, _): &(bool, bool, &str)| match symmetry {
            Symmetry::None => true,
            Symmetry::C2 => odd_in_u == odd_in_v,
            _ => !odd_in_u && !odd_in_v,
        };
        // How the number changes from a place to its mirror image: y and x turn round with their reflections.
        let turns =
            |odd_in_u: bool, odd_in_v: bool| (odd_in_u != (letter == 'Y'), odd_in_v != (letter == 'X'));
        // A place that is its own mirror image has no part that would have to be its own opposite.
        let exists = |&(odd_in_u, odd_in_v, _): &(bool, bool, &str)| {
            let (turns_in_u, turns_in_v) = turns(odd_in_u, odd_in_v);
            !(2 * i == m && turns_in_u || 2 * j == n && turns_in_v)
        };
        let parts: Vec<_> = PARTS.iter().filter(|part| kept(part) && exists(part)).collect();
        let mut text = String::new();
        for &&(odd_in_u, odd_in_v, suffix) in &parts {
            let (turns_in_u, turns_in_v) = turns(odd_in_u, odd_in_v);
            text += match (text.is_empty(), (i != a && turns_in_u) != (j != b && turns_in_v)) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            // What has only one part needs no name for it.
            text += &format!("{letter}{index}{}", if parts.len() == 1 { "" } else { suffix });
        }
        if text.is_empty() { "0".to_owned() } else { text }
    })
}
