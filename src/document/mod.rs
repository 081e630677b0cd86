//! A document: blocks of phrases, formulas and tables that say nothing of how they are printed.
//!
//! Where people read in a terminal, blanks and empty lines matter: a block says how far it is indented, and [`Block::Gap`] is
//! an empty line. Other printers do as they like.

mod phrase;
mod table;

use std::path::PathBuf;

pub use phrase::{Phrase, Piece};
pub use table::{Align, Column, Table};

use crate::exact::{Polynomial, Radicands, Ring};

/// Blocks, in the order in which they are read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Document {
    /// The ring of the polynomials in its phrases.
    pub ring: Ring,
    /// The blocks.
    pub blocks: Vec<Block>,
}

/// A part of a document.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Block {
    /// The verdict's word and the rest of its line.
    Headline {
        /// The word.
        word: &'static str,
        /// The rest.
        sentence: Phrase,
    },
    /// What the blocks below are about.
    Heading(Phrase),
    /// A line that explains formulas, and that whoever reads them skips.
    Comment(Phrase),
    /// A sentence that stands on its own lines: where it has a line break, it is meant.
    Line {
        /// Blanks before each line.
        indent: usize,
        /// The sentence.
        phrase: Phrase,
    },
    /// Sentences that are broken into lines where the page ends.
    Paragraph {
        /// Blanks before each line.
        indent: usize,
        /// The sentences.
        phrase: Phrase,
    },
    /// Equations below each other.
    Equations(Equations),
    /// A table.
    Table(Table),
    /// One step of an argument.
    Step(Step),
    /// A printed formula with its place in a statement, and whether it is right.
    Listed(Vec<Listed>),
    /// Something that is judged, with the evidence.
    Item(Item),
    /// What something is called and what it is.
    Field {
        /// The name.
        name: String,
        /// Up to where it is padded.
        width: usize,
        /// What it is.
        phrase: Phrase,
    },
    /// Files that were written.
    Files {
        /// The statement.
        statement: Option<PathBuf>,
        /// What is proved of it.
        certificates: Vec<PathBuf>,
    },
    /// A picture that was drawn.
    Figure(PathBuf),
    /// Lines as they stand, of a file or in another language.
    Source {
        /// Blanks before each line.
        indent: usize,
        /// The lines.
        text: String,
    },
    /// An empty line.
    Gap,
}

/// `left = right   (remark)`, the signs of equality below each other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Equations {
    /// Blanks before each line.
    pub indent: usize,
    /// The least width of the left sides; they are all as wide as the widest, where that is asked for.
    pub width: usize,
    /// Left side, right side, remark.
    pub rows: Vec<(Phrase, Phrase, String)>,
}

/// `(number) conclusion = multiplier · premise + …`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Step {
    /// The number.
    pub number: usize,
    /// The conclusion.
    pub conclusion: Phrase,
    /// Multipliers with the names of what they multiply.
    pub combination: Vec<(Phrase, Phrase)>,
    /// What follows at once: `w = 1/2`.
    pub so: Option<Phrase>,
}

/// One printed coefficient.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Listed {
    /// Its label.
    pub label: String,
    /// What it is the coefficient of.
    pub of: String,
    /// Whether it is printed as it is.
    pub agrees: bool,
    /// What it is.
    pub truth: Polynomial,
}

/// A judgement, what it is of, and what it rests on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Item {
    /// The judgement.
    pub mark: &'static str,
    /// Where it is claimed.
    pub place: String,
    /// What is claimed.
    pub says: String,
    /// The evidence.
    pub evidence: Vec<Phrase>,
}

impl Document {
    /// An empty document about a ring.
    pub fn new(ring: Ring) -> Self {
        Document { ring, blocks: Vec::new() }
    }

    /// An empty document without formulas.
    pub fn of_words() -> Self {
        let field = Radicands::new(Vec::new()).expect("the rationals");
        Document::new(Ring { field, variables: Vec::new() })
    }

    /// Then a block.
    pub fn push(&mut self, block: Block) {
        self.blocks.push(block);
    }

    /// Then what is in another document about the same ring.
    pub fn append(&mut self, other: Document) {
        self.blocks.extend(other.blocks);
    }

    /// Then the verdict.
    pub fn headline(&mut self, word: Option<&'static str>, sentence: impl Into<Phrase>) {
        self.push(Block::Headline { word: word.unwrap_or_default(), sentence: sentence.into() });
    }

    /// Then a heading.
    pub fn heading(&mut self, title: impl Into<Phrase>) {
        self.push(Block::Heading(title.into()));
    }

    /// Then a line.
    pub fn line(&mut self, indent: usize, phrase: impl Into<Phrase>) {
        self.push(Block::Line { indent, phrase: phrase.into() });
    }

    /// Then a paragraph.
    pub fn paragraph(&mut self, indent: usize, phrase: impl Into<Phrase>) {
        self.push(Block::Paragraph { indent, phrase: phrase.into() });
    }

    /// Then a name with what it stands for.
    pub fn field(&mut self, name: &str, width: usize, phrase: impl Into<Phrase>) {
        self.push(Block::Field { name: name.to_owned(), width, phrase: phrase.into() });
    }

    /// Then lines as they stand.
    pub fn source(&mut self, indent: usize, text: impl Into<String>) {
        self.push(Block::Source { indent, text: text.into() });
    }

    /// Then an empty line.
    pub fn gap(&mut self) {
        self.push(Block::Gap);
    }
}
