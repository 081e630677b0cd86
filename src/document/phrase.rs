//! Sentences with formulas in them, to be printed in any notation.

use crate::exact::Polynomial;

/// A sentence.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Phrase(pub Vec<Piece>);

/// A part of a sentence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Piece {
    /// Words.
    Words(String),
    /// A polynomial in the unknowns of the statement.
    Formula(Polynomial),
    /// The first terms of a polynomial that is longer than so many characters.
    Shortened(Polynomial, usize),
    /// A polynomial that stands as a factor: in brackets if it is a sum.
    Factor(Polynomial),
    /// The label of a coefficient: `a14`.
    Label(String),
}

impl From<String> for Phrase {
    fn from(words: String) -> Self {
        Phrase::words(words)
    }
}

impl From<&str> for Phrase {
    fn from(words: &str) -> Self {
        Phrase::words(words)
    }
}

impl Phrase {
    /// Words.
    pub fn words(words: impl Into<String>) -> Self {
        Phrase::default().and(words)
    }

    /// Then words.
    #[must_use]
    pub fn and(mut self, words: impl Into<String>) -> Self {
        self.0.push(Piece::Words(words.into()));
        self
    }

    /// Then a formula.
    #[must_use]
    pub fn formula(mut self, polynomial: &Polynomial) -> Self {
        self.0.push(Piece::Formula(polynomial.clone()));
        self
    }

    /// Then a formula, cut where it is longer than so many characters.
    #[must_use]
    pub fn shortened(mut self, polynomial: &Polynomial, characters: usize) -> Self {
        self.0.push(Piece::Shortened(polynomial.clone(), characters));
        self
    }

    /// Then another phrase.
    #[must_use]
    pub fn followed_by(mut self, other: Phrase) -> Self {
        self.0.extend(other.0);
        self
    }

    /// Then a factor.
    #[must_use]
    pub fn factor(mut self, polynomial: &Polynomial) -> Self {
        self.0.push(Piece::Factor(polynomial.clone()));
        self
    }

    /// Then a label.
    #[must_use]
    pub fn label(mut self, label: impl Into<String>) -> Self {
        self.0.push(Piece::Label(label.into()));
        self
    }
}
