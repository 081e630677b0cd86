//! The built-in statements, by name.
//!
//! The caps are *derived*: their files are written from the geometry each time they are asked for, so that no
//! control point of theirs is typed in. The positive controls are files.

mod cap;
mod exact;
mod family;
mod parts;
mod symmetry;
mod weighted;

pub use crate::algebra::spell;
pub use cap::{Cap, Interior, Symmetry};
pub use exact::{net_statement, normalised};
pub use family::{FAMILY, cap};

/// A built-in statement.
#[derive(Debug, Clone, Copy)]
pub struct Entry {
    /// The name on the command line.
    pub name: &'static str,
    /// One line about it.
    pub summary: &'static str,
    kind: Kind,
}

#[derive(Debug, Clone, Copy)]
enum Kind {
    Cap(Cap),
    File(&'static str),
    Exact,
}

const fn free(name: &'static str, summary: &'static str, m: u32, n: u32, symmetry: Symmetry) -> Entry {
    let interior = Interior::Free(symmetry);
    Entry { name, summary, kind: Kind::Cap(Cap { bidegree: (m, n), interior, corner_weight: false }) }
}

/// All built-in statements.
pub const ENTRIES: &[Entry] = &[
    Entry {
        name: "cap-2x2",
        summary: "the paper's patch: biquadratic, centre on the axis",
        kind: Kind::Cap(Cap { bidegree: (2, 2), interior: Interior::OnAxis, corner_weight: false }),
    },
    free("cap-2x2-centre", "biquadratic, centre anywhere (without the paper's Eq. 9)", 2, 2, Symmetry::None),
    Entry {
        name: "cap-2x2-weights",
        summary: "biquadratic, centre and corner weights free: every biquadratic patch with these edges, W ≠ 0 there",
        kind: Kind::Cap(Cap {
            bidegree: (2, 2),
            interior: Interior::Free(Symmetry::None),
            corner_weight: true,
        }),
    },
    free("cap-3x3-d4", "bicubic with the symmetry of the square, standard edges", 3, 3, Symmetry::D4),
    free("cap-3x3-c4", "bicubic with the rotations of the square, standard edges", 3, 3, Symmetry::C4),
    free("cap-3x2", "bidegree (3,2), no symmetry, standard edges", 3, 2, Symmetry::None),
    free("cap-3x3", "bicubic, no symmetry, standard edges", 3, 3, Symmetry::None),
    free("cap-4x2", "bidegree (4,2), no symmetry, standard edges", 4, 2, Symmetry::None),
    free("cap-4x3", "bidegree (4,3), no symmetry, standard edges", 4, 3, Symmetry::None),
    free("cap-4x4-d4", "biquartic with the symmetry of the square, standard edges", 4, 4, Symmetry::D4),
    Entry {
        name: "cap-2x2-free",
        summary: "biquadratic with the symmetry of the square, edges free in the planes between the faces",
        kind: Kind::File(include_str!("statements/cap-2x2-free.toml")),
    },
    Entry {
        name: "cap-2x2-polynomial",
        summary: "polynomial biquadratic with the symmetry of the square, corners on the sphere",
        kind: Kind::File(include_str!("statements/cap-2x2-polynomial.toml")),
    },
    Entry {
        name: "cap-4x2-exact",
        summary: "positive control: bidegree (4,2), the cap exactly, its edges parametrised otherwise",
        kind: Kind::Exact,
    },
    Entry {
        name: "cobb",
        summary: "positive control: Cobb's biquartic patch of the cap, its edges parametrised otherwise",
        kind: Kind::File(include_str!("statements/cobb.toml")),
    },
    Entry {
        name: "octant",
        summary: "positive control: degenerate octant, biquadratic, centre unknown",
        kind: Kind::File(include_str!("statements/octant.toml")),
    },
    Entry {
        name: "stereographic",
        summary: "positive control: cap bounded by four small circles, biquadratic, centre unknown",
        kind: Kind::File(include_str!("statements/stereographic.toml")),
    },
];

impl Entry {
    /// The statement file.
    pub fn statement(&self) -> String {
        match self.kind {
            Kind::Cap(cap) => cap.statement(),
            Kind::File(text) => text.to_owned(),
            Kind::Exact => exact::statement(),
        }
    }

    /// Whether the patch is to cover the cap over the cube face, bounded by the paper's four arcs.
    pub fn is_cap(&self) -> bool {
        matches!(self.kind, Kind::Cap(_))
    }
}

/// The built-in statement with this name.
pub fn find(name: &str) -> Option<&'static Entry> {
    ENTRIES.iter().find(|entry| entry.name == name)
}
