//! Tables.

use super::Phrase;

/// Rows of cells; columns are as wide as their widest cell.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Table {
    /// Blanks before each line.
    pub indent: usize,
    /// The columns; a row may have fewer cells.
    pub columns: Vec<Column>,
    /// Whether the first row says what the columns are.
    pub headed: bool,
    /// The rows.
    pub rows: Vec<Vec<Phrase>>,
}

/// How a column is set.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Column {
    /// On which side its cells are filled with blanks.
    pub align: Align,
    /// Characters at least.
    pub width: usize,
    /// Blanks before it.
    pub gap: usize,
}

/// How the cells of a column stand below each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Align {
    /// By their beginnings.
    Left,
    /// By their ends.
    Right,
    /// Decimals, by their points.
    Point,
}

impl Column {
    /// A column of cells that begin below each other.
    pub fn left(gap: usize) -> Self {
        Column { align: Align::Left, width: 0, gap }
    }

    /// A column of cells that end below each other.
    pub fn right(gap: usize) -> Self {
        Column { align: Align::Right, width: 0, gap }
    }

    /// A column of decimals.
    pub fn point(gap: usize) -> Self {
        Column { align: Align::Point, width: 0, gap }
    }

    /// At least so wide.
    #[must_use]
    pub fn at_least(self, width: usize) -> Self {
        Column { width, ..self }
    }
}

impl Table {
    /// A table without rows. The gap of the first column is not used.
    pub fn new(indent: usize, columns: impl Into<Vec<Column>>) -> Self {
        Table { indent, columns: columns.into(), headed: false, rows: Vec::new() }
    }

    /// With names of the columns.
    #[must_use]
    pub fn headed<P: Into<Phrase>>(mut self, names: impl IntoIterator<Item = P>) -> Self {
        self.headed = true;
        self.row(names);
        self
    }

    /// Then a row.
    pub fn row<P: Into<Phrase>>(&mut self, cells: impl IntoIterator<Item = P>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }
}
