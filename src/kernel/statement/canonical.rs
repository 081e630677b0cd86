//! The canonical text of a statement and its SHA-256.

use std::fmt::{self, Write};

use sha2::{Digest, Sha256};

use super::model::{COORDINATES, Statement, Subject};
use crate::exact::{Limit, Ring, Work};

impl Statement {
    /// The canonical text: everything a proof depends on, in one spelling. The title is not in it.
    pub fn canonical(&self) -> String {
        let mut text = String::new();
        // Writing to a String cannot fail.
        let _ = self.write_canonical(&mut text);
        text
    }

    /// The SHA-256 of [`Statement::canonical`], 64 lower-case hexadecimal digits.
    pub fn hash(&self) -> String {
        self.hash.clone()
    }

    /// With its hash: the text is never there as a whole.
    pub(super) fn hashed(mut self, work: &mut Work) -> Result<Self, Limit> {
        for polynomial in self.polynomials() {
            Ring::charge_spelling(polynomial, work)?;
        }
        let mut hasher = Hasher(Sha256::new());
        // Nor can hashing.
        let _ = self.write_canonical(&mut hasher);
        self.hash = hasher.0.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
        Ok(self)
    }

    fn write_canonical(&self, to: &mut impl Write) -> fmt::Result {
        let ring = self.ring();
        to.write_str("prove-cap statement 1\nradicands")?;
        for value in self.field.values() {
            write!(to, " {value}")?;
        }
        to.write_str("\nunknowns")?;
        for name in &self.unknowns {
            write!(to, " {name}")?;
        }
        to.write_str("\n")?;
        for assumed in &self.nonzero {
            to.write_str("nonzero ")?;
            ring.write(assumed, to)?;
            to.write_str("\n")?;
        }
        match &self.subject {
            Subject::System(polynomials) => {
                for polynomial in polynomials {
                    to.write_str("zero ")?;
                    ring.write(polynomial, to)?;
                    to.write_str("\n")?;
                }
            }
            Subject::Patch(patch) => {
                to.write_str("surface ")?;
                self.coordinate_ring().write(&patch.surface, to)?;
                writeln!(to, "\nbidegree {} {}", patch.bidegree.0, patch.bidegree.1)?;
                for (i, row) in patch.net.iter().enumerate() {
                    for (j, point) in row.iter().enumerate() {
                        for (name, entry) in COORDINATES.iter().zip(point) {
                            write!(to, "{name}[{i},{j}] ")?;
                            ring.write(entry, to)?;
                            to.write_str("\n")?;
                        }
                    }
                }
            }
        }
        to.write_str("end\n")
    }
}

/// Text on its way into a hash.
struct Hasher(Sha256);

impl Write for Hasher {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        self.0.update(text);
        Ok(())
    }
}
