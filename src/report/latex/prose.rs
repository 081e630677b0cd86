//! Words in LaTeX.

use std::fmt::Write as _;

/// Words for TeX: its special characters escaped, mathematical ones put into mathematics.
pub fn prose(words: &str) -> String {
    let mut text = String::new();
    for c in words.chars() {
        match (c, escaped(c), mathematical(c)) {
            ('"', ..) => text.push_str("''"),
            (_, Some(command), _) => text.push_str(command),
            (_, _, Some(command)) => {
                let _ = write!(text, "\\({command}\\)");
            }
            // A line break is for terminals.
            ('\n', ..) => text.push(' '),
            // Latin letters with accents, which the font has.
            (' '..='~' | 'À'..='ÿ', ..) => text.push(c),
            (other, ..) => {
                let _ = write!(text, "[U+{:04X}]", u32::from(other));
            }
        }
    }
    text
}

/// The same for text in which every blank and every quotation mark counts.
pub(super) fn code(line: &str) -> String {
    line.split(' ')
        .map(|word| word.split('"').map(prose).collect::<Vec<_>>().join("\\char34{}"))
        .collect::<Vec<_>>()
        .join("\\ ")
}

/// What TeX would take for a command.
fn escaped(c: char) -> Option<&'static str> {
    Some(match c {
        '\\' => "\\textbackslash{}",
        '^' => "\\textasciicircum{}",
        '~' => "\\textasciitilde{}",
        '<' => "\\textless{}",
        '>' => "\\textgreater{}",
        '|' => "\\textbar{}",
        '{' => "\\{",
        '}' => "\\}",
        '$' => "\\$",
        '%' => "\\%",
        '&' => "\\&",
        '#' => "\\#",
        '_' => "\\_",
        '…' => "\\ldots{}",
        '–' => "--",
        _ => return None,
    })
}

/// What stands in mathematics only.
fn mathematical(c: char) -> Option<&'static str> {
    Some(match c {
        '√' => "\\surd",
        '−' => "-",
        '·' => "\\cdot",
        '×' => "\\times",
        '±' => "\\pm",
        '→' => "\\to",
        '↦' => "\\mapsto",
        '≅' => "\\cong",
        '≠' => "\\ne",
        '≤' => "\\le",
        '≥' => "\\ge",
        '∞' => "\\infty",
        '°' => "^\\circ",
        '⟨' => "\\langle",
        '⟩' => "\\rangle",
        'α' => "\\alpha",
        'ᾱ' => "\\bar\\alpha",
        'β' => "\\beta",
        'δ' => "\\delta",
        'κ' => "\\kappa",
        'λ' => "\\lambda",
        'ξ' => "\\xi",
        'η' => "\\eta",
        'Π' => "\\Pi",
        'Σ' => "\\Sigma",
        '⁻' => "^-",
        '⁰' => "^0",
        '¹' => "^1",
        '²' => "^2",
        '³' => "^3",
        '⁴' => "^4",
        '⁵' => "^5",
        '⁶' => "^6",
        '⁷' => "^7",
        '⁸' => "^8",
        '⁹' => "^9",
        'ᵉ' => "^e",
        'ʳ' => "^r",
        'ˢ' => "^s",
        'ⁱ' => "^i",
        'ʲ' => "^j",
        '₁' => "_1",
        '₂' => "_2",
        '₃' => "_3",
        '₄' => "_4",
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::{code, prose};

    #[test]
    fn prose_cannot_become_a_command() {
        assert_eq!(prose("\\input{x} 100% $"), "\\textbackslash{}input\\{x\\} 100\\% \\$");
        assert_eq!(prose("√2 ≤ ∞ ☃"), "\\(\\surd\\)2 \\(\\le\\) \\(\\infty\\) [U+2603]");
    }

    #[test]
    fn in_a_file_every_character_counts() {
        assert_eq!(code("a  \"b\""), "a\\ \\ \\char34{}b\\char34{}");
    }
}
