//! The canonical text of a statement and its SHA-256.

use sha2::{Digest, Sha256};

use super::{COORDINATES, Statement, Subject};

impl Statement {
    /// The canonical text: everything a proof depends on, in one spelling. The title is not in it.
    pub fn canonical(&self) -> String {
        let ring = self.ring();
        let mut lines = vec!["prove-cap statement 1".to_owned()];
        lines.push(listed("radicands", self.field.values().iter().map(u32::to_string)));
        lines.push(listed("unknowns", self.unknowns.iter().cloned()));
        lines.extend(self.nonzero.iter().map(|assumed| format!("nonzero {}", ring.spell(assumed))));
        match &self.subject {
            Subject::System(polynomials) => {
                lines.extend(polynomials.iter().map(|polynomial| format!("zero {}", ring.spell(polynomial))));
            }
            Subject::Patch(patch) => {
                lines.push(format!("surface {}", self.coordinate_ring().spell(&patch.surface)));
                lines.push(format!("bidegree {} {}", patch.bidegree.0, patch.bidegree.1));
                for (i, row) in patch.net.iter().enumerate() {
                    for (j, point) in row.iter().enumerate() {
                        for (name, entry) in COORDINATES.iter().zip(point) {
                            lines.push(format!("{name}[{i},{j}] {}", ring.spell(entry)));
                        }
                    }
                }
            }
        }
        lines.push("end".into());
        lines.push(String::new());
        lines.join("\n")
    }

    /// The SHA-256 of [`Statement::canonical`], 64 lower-case hexadecimal digits.
    pub fn hash(&self) -> String {
        Sha256::digest(self.canonical()).iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

fn listed(key: &str, values: impl Iterator<Item = String>) -> String {
    values.fold(key.to_owned(), |line, value| line + " " + &value)
}
