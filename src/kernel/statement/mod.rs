//! What is claimed: a field, unknowns, and equations in them, given as a patch on a surface or as a list.
//!
//! A statement is pure data. [`Statement::read`] reads the TOML that people write, with every expression
//! evaluated exactly; [`Statement::canonical`] writes the one canonical text of its mathematical content,
//! whose SHA-256 a certificate names. Grammar and meaning: `proofs/FORMAT.md`.

mod canonical;
mod document;
mod error;
mod expression;
mod patch;
mod source;

use num_rational::BigRational;

use crate::exact::{Monomial, Polynomial, Radicands, Ring};

pub use error::{StatementError, StatementFault};
pub use patch::{Convention, UNIT_SPHERE};
pub use source::Place;

/// The names of the surface's coordinates, in the order of [`HomogeneousPoint`].
pub const COORDINATES: [&str; 4] = ["X", "Y", "Z", "W"];

/// A homogeneous control point (X, Y, Z, W) = (w·x, w·y, w·z, w).
pub type HomogeneousPoint = [Polynomial; 4];

/// A claim that awaits a proof: these equations have, or do not have, a common zero.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    title: String,
    field: Radicands,
    unknowns: Vec<String>,
    nonzero: Vec<Polynomial>,
    subject: Subject,
    names_surface: bool,
}

/// Where the equations come from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Subject {
    /// The patch lies on the surface: every coefficient `c[r,s]` vanishes.
    Patch(Patch),
    /// Every listed polynomial vanishes.
    System(Vec<Polynomial>),
}

/// A rational tensor-product Bézier patch and the surface it is to lie on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Patch {
    /// (m, n): the degrees in u and v.
    pub bidegree: (u32, u32),
    /// A homogeneous polynomial in X, Y, Z, W (variables 0 to 3) with coefficients in K.
    pub surface: Polynomial,
    /// m + 1 rows of n + 1 points: `net[i][j]` belongs to Bᵢᵐ(u)·Bⱼⁿ(v).
    pub net: Vec<Vec<HomogeneousPoint>>,
}

impl Patch {
    /// Whether the surface is the unit sphere, X² + Y² + Z² − W² = 0.
    pub fn is_on_unit_sphere(&self) -> bool {
        let signs = (0u16..).zip([1, 1, 1, -1]);
        let squares = signs.map(|(k, sign)| (Monomial::square(k), BigRational::from_integer(sign.into())));
        self.surface == Polynomial::from_terms(squares)
    }
}

impl Statement {
    /// The title, for people only: not part of the claim.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// K.
    pub fn field(&self) -> &Radicands {
        &self.field
    }

    /// The unknowns' names; variable k of every polynomial is the k-th.
    pub fn unknowns(&self) -> &[String] {
        &self.unknowns
    }

    /// The polynomials assumed not to vanish.
    pub fn nonzero(&self) -> &[Polynomial] {
        &self.nonzero
    }

    /// The equations.
    pub fn subject(&self) -> &Subject {
        &self.subject
    }

    /// Whether the file says which surface is meant; if a patch's does not, it is the unit sphere. For people only, like
    /// the title.
    pub fn names_surface(&self) -> bool {
        self.names_surface
    }

    /// The bits of all numbers in it.
    fn bit_count(&self) -> u64 {
        let of_subject: Vec<&Polynomial> = match &self.subject {
            Subject::Patch(patch) => patch.net.iter().flatten().flatten().chain([&patch.surface]).collect(),
            Subject::System(polynomials) => polynomials.iter().collect(),
        };
        let all = of_subject.into_iter().chain(&self.nonzero);
        all.fold(0, |sum, polynomial| polynomial.bit_count().saturating_add(sum))
    }

    /// The unknowns followed by the Rabinowitsch variables `t[1]`, `t[2]`, …, one for each assumption.
    pub fn ring(&self) -> Ring {
        let rabinowitsch = (1..=self.nonzero.len()).map(|number| format!("t[{number}]"));
        Ring {
            field: self.field.clone(),
            variables: self.unknowns.iter().cloned().chain(rabinowitsch).collect(),
        }
    }

    /// The ring of the surface: X, Y, Z, W.
    pub fn coordinate_ring(&self) -> Ring {
        Ring { field: self.field.clone(), variables: COORDINATES.map(String::from).to_vec() }
    }
}
