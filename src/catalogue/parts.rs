//! A net without symmetry, written in its symmetric and antisymmetric parts.
//!
//! The reflections of the square, u → 1−u with y → −y and v → 1−v with x → −x, map patches for the cap to patches
//! for the cap. Every net is the sum of four parts: `X11` stands for the part that both reflections keep, `X11u` and
//! `X11v` for those that change sign under the first or the second, `X11uv` for the one that changes sign under both.
//! This is a linear change of unknowns, nothing is lost; but the condition splits into four kinds of equations too,
//! which makes elimination and its certificates several times smaller.

/// One of the four parts: whether it changes sign under the reflection in u, and in v.
const PARTS: [(bool, bool, &str); 4] =
    [(false, false, ""), (true, false, "u"), (false, true, "v"), (true, true, "uv")];

/// The four numbers of the inner control point (i, j) of an (m+1)×(n+1) net, as sums of parts.
pub(super) fn entries((m, n): (u32, u32), i: u32, j: u32) -> [String; 4] {
    // The place that gives its name to all its mirror images.
    let (a, b) = (i.min(m - i), j.min(n - j));
    let index = if a < 10 && b < 10 { format!("{a}{b}") } else { format!("{a}_{b}") };
    ['X', 'Y', 'Z', 'W'].map(|letter| {
        let mut text = String::new();
        for (odd_in_u, odd_in_v, suffix) in PARTS {
            // How the number changes from a place to its mirror image: y and x turn round with their reflections.
            let (turns_in_u, turns_in_v) = (odd_in_u != (letter == 'Y'), odd_in_v != (letter == 'X'));
            // A place that is its own mirror image has no part that would have to be its own opposite.
            if (2 * i == m && turns_in_u) || (2 * j == n && turns_in_v) {
                continue;
            }
            let negative = (i != a && turns_in_u) != (j != b && turns_in_v);
            text += match (text.is_empty(), negative) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            text += &format!("{letter}{index}{suffix}");
        }
        if text.is_empty() { "0".to_owned() } else { text }
    })
}
