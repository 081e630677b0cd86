//! Names of unknowns in Coq.

/// The name of an unknown. A name that is one small letter other than u and v (the parameters of the patch), or a letter with a number and
/// possibly u and v, like `X11uv`, is kept: no keyword and nothing that the file uses is called so. Every other name is kept apart by a
/// prefix that no kept name and nothing else in the file has.
pub(super) fn name(unknown: &str) -> String {
    let mut characters = unknown.chars();
    let first = characters.next().unwrap_or(' ');
    let rest = characters.as_str();
    let after_digits = rest.trim_start_matches(|c: char| c.is_ascii_digit());
    let alone = rest.is_empty() && first.is_ascii_lowercase() && !matches!(first, 'u' | 'v');
    let numbered = first.is_ascii_alphabetic() && after_digits.len() < rest.len();
    if alone || numbered && after_digits.chars().all(|c| matches!(c, 'u' | 'v')) {
        unknown.to_owned()
    } else {
        let kept = |c: char| if c.is_ascii_alphanumeric() || c == '_' { c } else { '_' };
        format!("x_{}", unknown.chars().map(kept).collect::<String>())
    }
}

#[cfg(test)]
mod tests {
    use super::name;

    #[test]
    fn only_harmless_names_are_kept() {
        for kept in ["w", "z", "d", "X11", "X11uv", "W2v"] {
            assert_eq!(name(kept), kept);
        }
        for mangled in [
            "Theorem", "forall", "u", "v", "R", "S", "O", "net", "sqrt", "exists2", "H_1", "x_w", "IZR",
            "Qed", "X11w",
        ] {
            assert_eq!(name(mangled), format!("x_{mangled}"));
        }
        // No statement has such names; a reader that let them pass would do no harm.
        assert_eq!(name("w'"), "x_w_");
        assert_eq!(name("a. Axiom f : False"), "x_a__Axiom_f___False");
    }
}
