//! Mathematics in LaTeX, and an audit as a document.
//!
//! The displays of the document are the true coefficients, in the form that the listing reader reads: all else is
//! inline or prose. Nothing but `amsmath` and `longtable` is needed.

use std::fmt::Write as _;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::audit::{correction_text, headline, judgement_word, relation_phrase, stopped_text, term_text};
use super::mathematics::{Notation, collected};
use crate::audit::{Audit, Finding, Phrase, Piece, Target};
use crate::exact::{Polynomial, Ring};
use crate::formats::listing::Listing;
use crate::statement::{Statement, Subject};

/// Power products on one line of a display.
const TERMS: usize = 4;

/// An audit as a LaTeX document.
pub fn audit(listing: &Listing, name: &str, statement: &Statement, audit: &Audit) -> String {
    let ring = statement.ring();
    let mut text = String::from(
        "\\documentclass[a4paper]{article}\n\\usepackage{amsmath,longtable}\n\
         \\usepackage[margin=2cm]{geometry}\n\\allowdisplaybreaks\n\\setlength{\\parindent}{0pt}\n\\renewcommand{\\arraystretch}{1.25}\n\
         \\begin{document}\n",
    );
    let source = if listing.source.is_empty() { String::new() } else { format!("{} of ", listing.source) };
    let _ = writeln!(text, "\\section*{{Audit of {}}}", prose(&format!("{source}{}", listing.title)));
    let _ = writeln!(text, "\\textbf{{{}}}\n", prose(&headline(audit)));
    if let Some(why) = &audit.stopped {
        let _ = writeln!(text, "{}\n", prose(&stopped_text(audit, why)));
    }
    let _ = writeln!(text, "Held against \\texttt{{{}}}: {}.\n", prose(name), prose(statement.title()));
    if let Subject::Patch(patch) = statement.subject() {
        let surface = formula(&statement.coordinate_ring(), &patch.surface);
        let default = if statement.names_surface() { "" } else { " (the file names none: the unit sphere)" };
        let _ = writeln!(text, "Surface: \\({surface} = 0\\){default}.\n");
    }
    text += "\\subsection*{The true coefficients}\n\\begin{align*}\n";
    let rows = audit
        .findings
        .iter()
        .map(|finding| format!("{} &= {}", label(finding.label.as_str()), display(&ring, &finding.truth)));
    text += &rows.collect::<Vec<_>>().join(" \\\\\n");
    text += "\n\\end{align*}\n";
    for finding in audit.findings.iter().filter(|finding| !finding.agrees()) {
        text += &difference(&ring, finding);
    }
    if !audit.claims.is_empty() {
        text += "\\subsection*{Other claims}\n\
                 \\begin{longtable}{@{}p{2.6cm}p{2.4cm}p{11cm}@{}}\n";
        for verdict in &audit.claims {
            let remark = match verdict.claim.remark.as_str() {
                "" => String::new(),
                remark => format!(" (Remark: {}.)", prose(remark)),
            };
            let evidence: Vec<String> =
                verdict.evidence.iter().map(|phrase| sentence(&ring, phrase)).collect();
            let _ = writeln!(
                text,
                "{} & {} & {}. {}{remark} \\\\",
                judgement_word(verdict.judgement),
                prose(&verdict.claim.place),
                prose(&verdict.claim.says),
                evidence.iter().map(|line| format!("{line}. ")).collect::<String>().trim_end()
            );
        }
        text += "\\end{longtable}\n";
    }
    text + "\\end{document}\n"
}

fn difference(ring: &Ring, finding: &Finding) -> String {
    let target = match finding.target {
        Target::Monomial(i, j) => format!("\\(u^{{{i}}}v^{{{j}}}\\)"),
        Target::Bernstein(r, s) => format!("\\(c_{{{r},{s}}}\\)"),
        Target::Equation(k) => format!("\\(f_{{{k}}}\\)"),
    };
    let mut text = format!(
        "\\subsection*{{\\({}\\), the coefficient of {target}, line {}}}\n",
        label(finding.label.as_str()),
        finding.place.line
    );
    text += "\\begin{longtable}{@{}llll@{}}\nat & printed & true & true \\(-\\) printed \\\\\n";
    let cell = |polynomial: &Polynomial| format!("\\({}\\)", formula(ring, polynomial));
    for d in &finding.differences {
        let cells = [&d.powers, &d.printed, &d.truth, &d.difference].map(cell);
        let _ = writeln!(text, "{} \\\\", cells.join(" & "));
    }
    text += "\\end{longtable}\n";
    let mut remarks: Vec<String> =
        finding.relations.iter().map(|relation| sentence(ring, &relation_phrase(relation))).collect();
    for correction in &finding.corrections {
        let (line, column) = (correction.place.line, correction.place.column);
        remarks.push(format!("{} (line {line}, column {column})", prose(&correction_text(correction))));
    }
    if finding.corrections.is_empty() {
        let notation = Notation::new(ring.clone());
        remarks.extend(finding.differences.iter().filter_map(|d| Some(prose(&term_text(&notation, d)?))));
    }
    for remark in remarks {
        let _ = writeln!(text, "{remark}.\n");
    }
    text
}

/// A formula, broken into lines after some power products.
fn display(ring: &Ring, polynomial: &Polynomial) -> String {
    let terms = terms(ring, polynomial);
    let lines: Vec<String> = terms.chunks(TERMS).map(<[String]>::concat).collect();
    lines.join(" \\\\\n&\\quad ")
}

/// A formula on one line.
pub fn formula(ring: &Ring, polynomial: &Polynomial) -> String {
    terms(ring, polynomial).concat()
}

/// The terms by power product, each with its sign.
fn terms(ring: &Ring, polynomial: &Polynomial) -> Vec<String> {
    let collected = collected(&ring.field, polynomial);
    let mut terms: Vec<String> = Vec::new();
    for (powers, coefficient) in &collected {
        let names: Vec<String> = powers
            .powers()
            .iter()
            .map(|&(variable, exponent)| {
                let name = symbol(&ring.variables[usize::from(variable)]);
                if exponent == 1 { name } else { format!("{name}^{{{exponent}}}") }
            })
            .collect();
        let powers = names.join(" ");
        let first = terms.is_empty();
        terms.push(match coefficient.as_slice() {
            [(root, value)] => {
                let number = number(root, &value.abs());
                let number = if number == "1" && !powers.is_empty() { String::new() } else { number };
                format!("{}{}", sign(first, value.is_negative()), joined(&number, &powers))
            }
            sum => {
                let mut inside = String::new();
                for (root, value) in sum {
                    inside += sign(inside.is_empty(), value.is_negative());
                    inside += &number(root, &value.abs());
                }
                let alone = powers.is_empty() && collected.len() == 1;
                let bracketed = if alone { inside } else { format!("\\left({inside}\\right)") };
                format!("{}{}", sign(first, false), joined(&bracketed, &powers))
            }
        });
    }
    if terms.is_empty() { vec!["0".to_owned()] } else { terms }
}

fn sign(first: bool, negative: bool) -> &'static str {
    match (first, negative) {
        (true, false) => "",
        (true, true) => "-",
        (false, false) => " + ",
        (false, true) => " - ",
    }
}

fn joined(number: &str, powers: &str) -> String {
    let space = if number.is_empty() || powers.is_empty() { "" } else { " " };
    format!("{number}{space}{powers}")
}

/// value·√root for a positive value.
fn number(root: &BigInt, value: &BigRational) -> String {
    let rational = match value.denom().is_one() {
        true => value.numer().to_string(),
        false => format!("\\frac{{{}}}{{{}}}", value.numer(), value.denom()),
    };
    match (root.is_one(), value.is_one()) {
        (true, _) => rational,
        (false, true) => format!("\\sqrt{{{root}}}"),
        (false, false) => format!("{rational}\\sqrt{{{root}}}"),
    }
}

/// The name of an unknown: `w11` is w with the subscript 11.
fn symbol(name: &str) -> String {
    let mut characters = name.chars();
    let letter = characters.next().unwrap_or('x');
    let rest = characters.as_str();
    match rest {
        "" => letter.to_string(),
        _ if rest.chars().all(|c| c.is_ascii_digit()) => format!("{letter}_{{{rest}}}"),
        _ => format!("\\mathrm{{{}}}", name.replace('_', "\\_")),
    }
}

/// The label of a coefficient: `a14`, `a1,4`.
fn label(name: &str) -> String {
    let letters = name.find(|c: char| c.is_ascii_digit()).unwrap_or(name.len());
    let (letters, indices) = name.split_at(letters);
    let base = if letters.len() == 1 { letters.to_owned() } else { format!("\\mathrm{{{letters}}}") };
    if indices.is_empty() { base } else { format!("{base}_{{{indices}}}") }
}

fn sentence(ring: &Ring, phrase: &Phrase) -> String {
    let piece = |piece: &Piece| match piece {
        Piece::Words(words) => prose(words),
        Piece::Formula(polynomial) => format!("\\({}\\)", formula(ring, polynomial)),
        Piece::Factor(polynomial) if polynomial.term_count() > 1 => {
            format!("\\(\\left({}\\right)\\)", formula(ring, polynomial))
        }
        Piece::Factor(polynomial) => format!("\\({}\\)", formula(ring, polynomial)),
        Piece::Label(name) => format!("\\({}\\)", label(name)),
    };
    phrase.0.iter().map(piece).collect()
}

/// Words for TeX: its special characters escaped, mathematical ones put into mathematics.
pub fn prose(words: &str) -> String {
    let mut text = String::new();
    for c in words.chars() {
        let command = match c {
            '\\' => "\\textbackslash{}",
            '^' => "\\textasciicircum{}",
            '~' => "\\textasciitilde{}",
            '<' => "\\textless{}",
            '>' => "\\textgreater{}",
            '|' => "\\textbar{}",
            '"' => "''",
            '{' => "\\{",
            '}' => "\\}",
            '$' => "\\$",
            '%' => "\\%",
            '&' => "\\&",
            '#' => "\\#",
            '_' => "\\_",
            '√' => "\\(\\surd\\)",
            '−' => "\\(-\\)",
            '·' => "\\(\\cdot\\)",
            '×' => "\\(\\times\\)",
            '≅' => "\\(\\cong\\)",
            '≤' => "\\(\\le\\)",
            '≥' => "\\(\\ge\\)",
            '²' => "\\(^2\\)",
            '³' => "\\(^3\\)",
            'α' => "\\(\\alpha\\)",
            'ξ' => "\\(\\xi\\)",
            'η' => "\\(\\eta\\)",
            '…' => "\\ldots{}",
            ' '..='~' => {
                text.push(c);
                continue;
            }
            // Latin letters with accents, which the font has.
            'À'..='ÿ' => {
                text.push(c);
                continue;
            }
            other => {
                let _ = write!(text, "[U+{:04X}]", u32::from(other));
                continue;
            }
        };
        text.push_str(command);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{prose, symbol};

    #[test]
    fn prose_cannot_become_a_command() {
        assert_eq!(prose("\\input{x} 100% $"), "\\textbackslash{}input\\{x\\} 100\\% \\$");
        assert_eq!(prose("√2 ≤ ∞"), "\\(\\surd\\)2 \\(\\le\\) [U+221E]");
    }

    #[test]
    fn names_keep_their_subscripts() {
        assert_eq!(symbol("w11"), "w_{11}");
        assert_eq!(symbol("w_1"), "\\mathrm{w\\_1}");
        assert_eq!(symbol("z"), "z");
    }
}
