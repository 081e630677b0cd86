//! Text that goes into other languages: titles in comments.

/// A title that can stand in a comment of any language: ASCII letters, digits, spaces and a few marks that open, close, escape and continue
/// nothing anywhere. Whatever else there was is a `?`, so that the reader sees that something was there.
pub fn harmless(title: &str) -> String {
    let kept = |c: char| {
        c.is_ascii_alphanumeric() || matches!(c, ' ' | '.' | ',' | ':' | '(' | ')' | '=' | '+' | '^' | '_')
    };
    title
        .chars()
        .map(|c| {
            if kept(c) {
                c
            } else if matches!(c, '-' | '−' | '–') {
                '-'
            } else {
                '?'
            }
        })
        .collect::<String>()
        .replace("--", "- -")
}

#[cfg(test)]
mod tests {
    use super::harmless;

    #[test]
    fn a_title_opens_and_closes_nothing() {
        let title = "A \"cap\" (* of *) w' /* x */ // \\ -- # $ `end`\nQed. √2 -> ;";
        assert_eq!(harmless(title), "A ?cap? (? of ?) w? ?? x ?? ?? ? - - ? ? ?end??Qed. ?2 -? ?");
    }
}
