//! Documents for people at a terminal.

use super::mathematics::Notation;
use crate::document::{Align, Block, Column, Document, Equations, Item, Listed, Phrase, Piece, Step, Table};

/// Characters of a formula on one line.
pub(super) const LINE: usize = 110;

/// A document as lines.
pub(super) fn print(document: &Document) -> String {
    let printer = Printer { notation: Notation::new(document.ring.clone()) };
    document.blocks.iter().map(|block| printer.block(block)).collect()
}

/// A sentence for a terminal.
pub(super) fn phrase_text(notation: &Notation, phrase: &Phrase) -> String {
    let piece = |piece: &Piece| match piece {
        Piece::Words(words) => words.clone(),
        Piece::Formula(polynomial) => notation.polynomial(polynomial),
        Piece::Shortened(polynomial, characters) => notation.shortened(polynomial, *characters),
        Piece::Factor(polynomial) => notation.factor(polynomial),
        Piece::Label(label) => label.clone(),
    };
    phrase.0.iter().map(piece).collect()
}

struct Printer {
    notation: Notation,
}

impl Printer {
    fn phrase(&self, phrase: &Phrase) -> String {
        phrase_text(&self.notation, phrase)
    }

    fn block(&self, block: &Block) -> String {
        match block {
            Block::Headline { word, sentence } => format!("{word}  {}\n", self.phrase(sentence)),
            Block::Heading(title) => format!("{}\n", self.phrase(title)),
            Block::Comment(phrase) => format!("# {}\n", self.phrase(phrase)),
            Block::Line { indent, phrase } => indented(*indent, &self.phrase(phrase)),
            Block::Paragraph { indent, phrase } => wrapped_at(&self.phrase(phrase), *indent) + "\n",
            Block::Equations(equations) => self.equations(equations),
            Block::Table(table) => self.table(table),
            Block::Step(step) => self.step(step),
            Block::Listed(rows) => self.listed(rows),
            Block::Item(item) => self.item(item),
            Block::Field { name, width, phrase } => format!("{name:<width$}{}\n", self.phrase(phrase)),
            Block::Files { statement, certificates } => {
                let named = statement.iter().map(|file| ("Statement", file));
                let named = named.chain(certificates.iter().map(|file| ("Certificate", file)));
                named.map(|(name, file)| format!("{name:<13}{}\n", file.display())).collect()
            }
            Block::Figure(file) => format!("{:<13}{}\n", "Picture", file.display()),
            Block::Source { indent: 0, text } => text.clone(),
            Block::Source { indent, text } => indented(*indent, text),
            Block::Gap => "\n".to_owned(),
        }
    }

    fn equations(&self, Equations { indent, width, rows }: &Equations) -> String {
        let rows = rows.iter().map(|(left, right, remark)| {
            let remark = if remark.is_empty() { String::new() } else { format!("   ({remark})") };
            format!("{:indent$}{:<width$} = {}{remark}\n", "", self.phrase(left), self.phrase(right))
        });
        rows.collect()
    }

    fn step(&self, Step { number, conclusion, combination, so }: &Step) -> String {
        let label = format!("   ({number})");
        let mut text = format!("{label:<8} {} =\n", self.phrase(conclusion));
        for (k, (multiplier, premise)) in combination.iter().enumerate() {
            let sign = if k == 0 { " " } else { "+" };
            text += &format!("          {sign} {} · {}\n", self.phrase(multiplier), self.phrase(premise));
        }
        if let Some(so) = so {
            text += &format!("         so {}\n", self.phrase(so));
        }
        text
    }

    fn listed(&self, rows: &[Listed]) -> String {
        let columns =
            [Column::left(0), Column::left(2).at_least(2), Column::left(2).at_least(7), Column::left(2)];
        let mut table = Table::new(3, columns);
        for Listed { label, of, agrees, truth } in rows {
            let (word, formula) = match agrees {
                true => ("AGREES", self.notation.shortened(truth, LINE)),
                false => ("DIFFERS", String::new()),
            };
            table.row([label.clone(), of.clone(), word.to_owned(), formula]);
        }
        self.table(&table)
    }

    fn item(&self, Item { mark, place, says, evidence }: &Item) -> String {
        let mut text = format!("   {mark:<11}  {place:<14} {says}\n");
        for phrase in evidence {
            text += &wrapped_at(&self.phrase(phrase), 33);
            text.push('\n');
        }
        text
    }

    fn table(&self, table: &Table) -> String {
        let cells: Vec<Vec<String>> =
            table.rows.iter().map(|row| row.iter().map(|cell| self.phrase(cell)).collect()).collect();
        let column = |k: usize| cells.iter().filter_map(move |row| row.get(k));
        let most = |k: usize, of: fn(&str) -> usize| column(k).map(|cell| of(cell)).max().unwrap_or(0);
        let widths: Vec<(usize, usize)> =
            (0..table.columns.len()).map(|k| (most(k, characters), most(k, before_point))).collect();
        let mut text = String::new();
        for row in &cells {
            let mut line = " ".repeat(table.indent);
            for (k, ((cell, column), (width, point))) in
                row.iter().zip(&table.columns).zip(&widths).enumerate()
            {
                let gap = if k == 0 { 0 } else { column.gap };
                let width = *width.max(&column.width);
                let blank = width - characters(cell);
                let (before, after) = match column.align {
                    Align::Left => (0, blank),
                    Align::Right => (blank, 0),
                    Align::Point => (point - before_point(cell), 0),
                };
                line += &format!("{:gap$}{:before$}{cell}{:after$}", "", "", "");
            }
            text += line.trim_end();
            text.push('\n');
        }
        text
    }
}

fn characters(text: &str) -> usize {
    text.chars().count()
}

/// How many characters stand before the point.
fn before_point(decimal: &str) -> usize {
    decimal.chars().take_while(|c| *c != '.').count()
}

/// Lines with so many blanks before each.
fn indented(indent: usize, text: &str) -> String {
    text.lines().map(|line| format!("{:indent$}{line}\n", "")).collect()
}

/// A paragraph, broken at spaces and indented by so many blanks.
pub(super) fn wrapped_at(paragraph: &str, indent: usize) -> String {
    let mut lines: Vec<String> = vec![String::new()];
    for word in paragraph.split(' ') {
        let line = lines.last_mut().expect("never empty");
        if !line.is_empty() && indent + line.chars().count() + word.chars().count() >= LINE + 3 {
            lines.push(word.to_owned());
        } else {
            line.push_str(if line.is_empty() { "" } else { " " });
            line.push_str(word);
        }
    }
    let margin = " ".repeat(indent);
    format!("{margin}{}", lines.join(&format!("\n{margin}")))
}
