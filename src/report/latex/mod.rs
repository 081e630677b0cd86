//! Documents in LaTeX.
//!
//! The displays of an audit and of an expansion are coefficients in the form that the listing reader reads: all else is
//! inline or prose. Nothing but `amsmath` and `longtable` is needed.

mod formula;
mod prose;

use std::fmt::Write as _;

pub use formula::formula;
pub use prose::prose;

use formula::{display, factor, label, shortened};
use prose::code;

use crate::document::{Align, Block, Document, Equations, Item, Listed, Phrase, Piece, Step, Table};
use crate::exact::Ring;

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
