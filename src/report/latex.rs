//! Mathematics in LaTeX, and documents.
//!
//! The displays of an audit and of an expansion are coefficients in the form that the listing reader reads: all else is
//! inline or prose. Nothing but `amsmath` and `longtable` is needed.

use std::fmt::Write as _;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed};

use super::mathematics::{Notation, collected};
use crate::document::{Align, Block, Document, Equations, Item, Listed, Phrase, Piece, Step, Table};
use crate::exact::{Polynomial, Ring};

/// Power products on one line of a display.
const TERMS: usize = 4;

const BEFORE: &str = "\\documentclass[a4paper]{article}\n\\usepackage{amsmath,longtable}\n\
    \\usepackage[margin=2cm]{geometry}\n\\allowdisplaybreaks\n\\setlength{\\parindent}{0pt}\n\
    \\renewcommand{\\arraystretch}{1.25}\n\\begin{document}\n";

/// A document that compiles by itself.
pub(super) fn print(document: &Document) -> String {
    let blocks = document.blocks.iter().map(|block| block_text(&document.ring, block));
    format!("{BEFORE}{}\\end{{document}}\n", blocks.collect::<String>())
}

fn block_text(ring: &Ring, block: &Block) -> String {
    let of = |phrase: &Phrase| sentence(ring, phrase);
    match block {
        Block::Headline { word, sentence } => format!("\\textbf{{{word}}}\\quad {}\n\n", of(sentence)),
        Block::Heading(title) => format!("\\subsection*{{{}}}\n", of(title)),
        Block::Comment(phrase) | Block::Line { phrase, .. } | Block::Paragraph { phrase, .. } => {
            format!("{}\n\n", of(phrase))
        }
        Block::Equations(equations) => equations_text(ring, equations),
        Block::Table(table) => table_text(ring, table),
        Block::Step(step) => step_text(ring, step),
        Block::Listed(rows) => listed(ring, rows),
        Block::Item(Item { mark, place, says, evidence }) => {
            let evidence: String = evidence.iter().map(|phrase| format!("{}.\n", of(phrase))).collect();
            format!("\\textbf{{{mark}}}\\quad {}: {}.\n{evidence}\n", prose(place), prose(says))
        }
        Block::Field { name, phrase, .. } => format!("\\emph{{{}}}\\quad {}\n\n", prose(name), of(phrase)),
        Block::Files { statement, certificates } => {
            let files = statement.iter().chain(certificates);
            files.map(|file| format!("\\texttt{{{}}}\n\n", code(&file.display().to_string()))).collect()
        }
        Block::Figure(file) => format!("\\texttt{{{}}}\n\n", code(&file.display().to_string())),
        Block::Source { text, .. } => {
            text.lines().map(|line| format!("\\texttt{{{}}}\\mbox{{}}\\par\n", code(line))).collect()
        }
        Block::Gap => "\\medskip\n".to_owned(),
    }
}

/// Equations below each other; none is none.
fn aligned(rows: &[String]) -> String {
    match rows {
        [] => String::new(),
        rows => format!("\\begin{{align*}}\n{}\n\\end{{align*}}\n", rows.join(" \\\\\n")),
    }
}

fn equations_text(ring: &Ring, Equations { rows, .. }: &Equations) -> String {
    let row = |(left, right, remark): &(Phrase, Phrase, String)| {
        let remark =
            if remark.is_empty() { String::new() } else { format!(" \\quad\\text{{({})}}", prose(remark)) };
        format!("{} &= {}{remark}", displayed(ring, left), displayed(ring, right))
    };
    aligned(&rows.iter().map(row).collect::<Vec<_>>())
}

fn listed(ring: &Ring, rows: &[Listed]) -> String {
    let row = |row: &Listed| format!("{} &= {}", label(&row.label), display(ring, &row.truth));
    match rows {
        [] => String::new(),
        rows => {
            let rows: Vec<String> = rows.iter().map(row).collect();
            format!("\\subsection*{{The true coefficients}}\n{}", aligned(&rows))
        }
    }
}

fn step_text(ring: &Ring, Step { number, conclusion, combination, so }: &Step) -> String {
    let of = |phrase: &Phrase| sentence(ring, phrase);
    let sum = combination
        .iter()
        .map(|(multiplier, premise)| format!("{}\\(\\,\\cdot\\,\\){}", of(multiplier), of(premise)));
    let sum = sum.collect::<Vec<_>>().join(" \\(+\\) ");
    let so = so.as_ref().map_or_else(String::new, |so| format!("; so {}", of(so)));
    format!("({number})\\quad {} \\(=\\) {sum}{so}\n\n", of(conclusion))
}

fn table_text(ring: &Ring, table: &Table) -> String {
    if table.rows.is_empty() {
        return String::new();
    }
    let columns = table.columns.iter().map(|column| if column.align == Align::Left { 'l' } else { 'r' });
    let mut text = format!("\\begin{{longtable}}{{@{{}}{}@{{}}}}\n", columns.collect::<String>());
    for (k, row) in table.rows.iter().enumerate() {
        let cells: Vec<String> = row.iter().map(|cell| sentence(ring, cell)).collect();
        // The braces: what begins with a square bracket would belong to the row before.
        let rule = if k == 0 && table.headed { " \\hline" } else { "" };
        let _ = writeln!(text, "{{}}{} \\\\{rule}", cells.join(" & "));
    }
    text + "\\end{longtable}\n"
}

/// A sentence inside a display.
fn displayed(ring: &Ring, phrase: &Phrase) -> String {
    let piece = |piece: &Piece| match piece {
        Piece::Words(words) if words.chars().all(|c| c.is_ascii_digit()) => words.clone(),
        Piece::Words(words) => format!("\\text{{{}}}", prose(words)),
        Piece::Formula(polynomial) => display(ring, polynomial),
        Piece::Shortened(polynomial, characters) => shortened(ring, polynomial, *characters),
        Piece::Factor(polynomial) => factor(ring, polynomial),
        Piece::Label(name) => label(name),
    };
    phrase.0.iter().map(piece).collect()
}

fn sentence(ring: &Ring, phrase: &Phrase) -> String {
    let piece = |piece: &Piece| match piece {
        Piece::Words(words) => prose(words),
        Piece::Formula(polynomial) => format!("\\({}\\)", formula(ring, polynomial)),
        Piece::Shortened(polynomial, characters) => {
            format!("\\({}\\)", shortened(ring, polynomial, *characters))
        }
        Piece::Factor(polynomial) => format!("\\({}\\)", factor(ring, polynomial)),
        Piece::Label(name) => format!("\\({}\\)", label(name)),
    };
    phrase.0.iter().map(piece).collect()
}

/// In brackets if it is a sum.
fn factor(ring: &Ring, polynomial: &Polynomial) -> String {
    match polynomial.term_count() > 1 {
        true => format!("\\left({}\\right)", formula(ring, polynomial)),
        false => formula(ring, polynomial),
    }
}

/// The first terms, where what is printed of them at a terminal is longer than so many characters.
fn shortened(ring: &Ring, polynomial: &Polynomial, characters: usize) -> String {
    let terms = terms(ring, polynomial);
    let long = Notation::new(ring.clone()).polynomial(polynomial).chars().count() > characters;
    if long && terms.len() > TERMS {
        let (shown, all) = (terms[..TERMS].concat(), terms.len());
        return format!("{shown} + \\ldots\\ \\text{{[{all} terms in all]}}");
    }
    terms.concat()
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

/// The label of a coefficient: `a14`, `a1,4`, `c[1,4]`.
fn label(name: &str) -> String {
    let name = name.replace(['[', ']'], "");
    let letters = name.find(|c: char| c.is_ascii_digit()).unwrap_or(name.len());
    let (letters, indices) = name.split_at(letters);
    let base = if letters.len() == 1 { letters.to_owned() } else { format!("\\mathrm{{{letters}}}") };
    if indices.is_empty() { base } else { format!("{base}_{{{indices}}}") }
}

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
fn code(line: &str) -> String {
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
    use super::{prose, symbol};

    #[test]
    fn prose_cannot_become_a_command() {
        assert_eq!(prose("\\input{x} 100% $"), "\\textbackslash{}input\\{x\\} 100\\% \\$");
        assert_eq!(prose("√2 ≤ ∞ ☃"), "\\(\\surd\\)2 \\(\\le\\) \\(\\infty\\) [U+2603]");
    }

    #[test]
    fn names_keep_their_subscripts() {
        assert_eq!(symbol("w11"), "w_{11}");
        assert_eq!(symbol("w_1"), "\\mathrm{w\\_1}");
        assert_eq!(symbol("z"), "z");
    }
}
