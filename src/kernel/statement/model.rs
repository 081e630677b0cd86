//! A statement as data.

use num_rational::BigRational;

use crate::exact::{Limit, Monomial, Polynomial, Radicands, Ring, Work};

/// The names of the surface's coordinates, in the order of [`HomogeneousPoint`].
pub const COORDINATES: [&str; 4] = ["X", "Y", "Z", "W"];

/// A homogeneous control point (X, Y, Z, W) = (w·x, w·y, w·z, w).
pub type HomogeneousPoint = [Polynomial; 4];

/// A claim that awaits a proof: these equations have, or do not have, a common zero.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Statement {
    pub(super) title: String,
    pub(super) field: Radicands,
    pub(super) unknowns: Vec<String>,
    pub(super) nonzero: Vec<Polynomial>,
    pub(super) subject: Subject,
    pub(super) names_surface: bool,
    /// The SHA-256 of the canonical text.
    pub(super) hash: String,
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

    /// Whether the file says which surface is meant; if a patch's does not, it is the unit sphere. For people
    /// only, like the title.
    pub fn names_surface(&self) -> bool {
        self.names_surface
    }

    /// The bits of all numbers in it.
    pub(super) fn bit_count(&self) -> u64 {
        self.polynomials().fold(0, |sum, polynomial| polynomial.bit_count().saturating_add(sum))
    }

    /// All polynomials in it.
    pub(super) fn polynomials(&self) -> impl Iterator<Item = &Polynomial> {
        let (net, system) = match &self.subject {
            Subject::Patch(patch) => (Some(patch), [].as_slice()),
            Subject::System(polynomials) => (None, polynomials.as_slice()),
        };
        let of_patch =
            net.into_iter().flat_map(|patch| patch.net.iter().flatten().flatten().chain([&patch.surface]));
        of_patch.chain(system).chain(&self.nonzero)
    }

    /// A copy, paid for, and the polynomials that a sentence about it names, written out.
    pub(crate) fn charge_theorem(&self, work: &mut Work) -> Result<(), Limit> {
        let kept = self.polynomials().fold(0u64, |sum, polynomial| sum.saturating_add(polynomial.bytes()));
        work.keep(kept)?;
        let surface = match &self.subject {
            Subject::Patch(patch) => Some(&patch.surface),
            Subject::System(_) => None,
        };
        for polynomial in self.nonzero.iter().chain(surface) {
            // As text, with the characters of mathematics, in the sentence, in all that is printed.
            work.keep(Ring::text_bytes(polynomial).saturating_mul(10))?;
        }
        Ok(())
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
