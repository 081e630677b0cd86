//! A control net as it was printed.

use super::NetError;
use crate::exact::{Polynomial, Radicands, Ring, Work};
use crate::formats::statement_file::{Draft, DraftSubject, Layout};
use crate::statement::{Convention, Statement, Subject};

/// Four numbers for each control point, constants of K, as printed.
#[derive(Debug, Clone)]
pub struct PrintedNet {
    /// What it is from.
    pub title: String,
    /// K.
    pub field: Radicands,
    /// How points are given.
    pub convention: Convention,
    /// The surface, in the language of statements; `None` where the net names none and the unit sphere is meant.
    pub surface: Option<String>,
    /// `points[i][j]` belongs to Bᵢᵐ(u)·Bⱼⁿ(v); at least two rows of at least two points, all of one length.
    pub points: Vec<Vec<[Polynomial; 4]>>,
}

impl PrintedNet {
    /// The net of a statement without unknowns, as its convention has it.
    ///
    /// # Errors
    /// Where the statement has unknowns, or no net.
    pub fn from_statement(statement: &Statement, convention: Convention) -> Result<Self, NetError> {
        let Subject::Patch(patch) = statement.subject() else {
            return Err(NetError::Net("a system of equations has no net to be audited".to_owned()));
        };
        if !statement.unknowns().is_empty() {
            let names = statement.unknowns().join(", ");
            return Err(NetError::Net(format!(
                "the net has unknowns, {names}: a printed net has none; `prove` looks for their values"
            )));
        }
        let mut work = Work::full();
        let mut points = Vec::new();
        for row in &patch.net {
            let mut printed = Vec::new();
            for point in row {
                printed.push(match convention {
                    Convention::Homogeneous => point.clone(),
                    Convention::Cartesian => divided(point, statement.field(), &mut work)?,
                });
            }
            points.push(printed);
        }
        Ok(PrintedNet {
            title: statement.title().to_owned(),
            field: statement.field().clone(),
            convention,
            surface: statement.names_surface().then(|| statement.coordinate_ring().spell(&patch.surface)),
            points,
        })
    }

    /// The homogeneous points.
    ///
    /// # Errors
    /// Where a number exceeds what the formats allow.
    pub fn homogeneous(&self) -> Result<Vec<Vec<[Polynomial; 4]>>, NetError> {
        let mut work = Work::full();
        let mut rows = Vec::new();
        for row in &self.points {
            let mut points = Vec::new();
            for point in row {
                points.push(premultiplied(point, self.convention, &self.field, &mut work)?);
            }
            rows.push(points);
        }
        Ok(rows)
    }

    /// (m, n).
    pub fn bidegree(&self) -> (usize, usize) {
        (self.points.len() - 1, self.points.first().map_or(1, Vec::len) - 1)
    }

    /// The statement that the net lies on the surface, as a file.
    pub fn statement(&self) -> String {
        let ring = Ring { field: self.field.clone(), variables: Vec::new() };
        let points = |row: &Vec<[Polynomial; 4]>| {
            row.iter().map(|point| point.each_ref().map(|x| ring.spell(x))).collect()
        };
        let subject = DraftSubject::Patch {
            convention: self.convention,
            surface: self.surface.clone(),
            net: self.points.iter().map(points).collect(),
            layout: Layout::Rows,
        };
        let draft = Draft {
            remark: Vec::new(),
            title: self.title.chars().filter(|c| !c.is_control()).take(200).collect(),
            radicands: self.field.values().to_vec(),
            unknowns: Vec::new(),
            nonzero: Vec::new(),
            subject,
            define: Vec::new(),
        };
        draft.text()
    }
}

/// (wx, wy, wz, w).
pub fn premultiplied(
    point: &[Polynomial; 4],
    convention: Convention,
    field: &Radicands,
    work: &mut Work,
) -> Result<[Polynomial; 4], NetError> {
    let mut homogeneous = point.clone();
    if convention == Convention::Cartesian {
        for coordinate in &mut homogeneous[..3] {
            *coordinate = coordinate.multiply(&point[3], field, work)?;
        }
    }
    Ok(homogeneous)
}

/// (X/W, Y/W, Z/W, W); zeros where W is zero, as in a Cartesian net nothing else can be.
fn divided(point: &[Polynomial; 4], field: &Radicands, work: &mut Work) -> Result<[Polynomial; 4], NetError> {
    let inverse = point[3].inverse(field, work)?.unwrap_or_default();
    let mut cartesian = point.clone();
    for coordinate in &mut cartesian[..3] {
        *coordinate = coordinate.multiply(&inverse, field, work)?;
    }
    Ok(cartesian)
}
