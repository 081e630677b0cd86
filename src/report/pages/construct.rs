//! `construct`, of one patch and of a tiling.

use std::path::Path;

use serde::Serialize;

use crate::commands::{Constructed, Tiled, Verdict};
use crate::document::Document;
use crate::exact::Limit;
use crate::report::attempt::Files;
use crate::report::construction::{constructed, tiling};
use crate::report::json::{CONVENTION, StatementData, net, statement};
use crate::report::page::Page;
use crate::statement::Subject;

/// A patch, and where its certificates are.
#[derive(Debug)]
pub struct Constructing<'a> {
    /// The patch.
    pub constructed: &'a Constructed,
    /// That it lies on the sphere, and if it is shown that it covers the polygon.
    pub files: Vec<Files>,
}

/// The same as data.
#[derive(Debug, Serialize)]
pub struct ConstructedData {
    name: String,
    bidegree: (usize, usize),
    convention: &'static str,
    net: Option<Vec<Vec<[String; 4]>>>,
    covers: bool,
    reason: Option<String>,
    theorem: String,
    files: Vec<String>,
    statement: StatementData,
}

impl Page for Constructing<'_> {
    type Data = ConstructedData;

    fn verdict(&self) -> Verdict {
        Verdict::Exact
    }

    fn document(&self) -> Result<Document, Limit> {
        constructed(self.constructed, &self.files)
    }

    fn data(&self) -> Result<ConstructedData, Limit> {
        let Constructed { shape, made } = self.constructed;
        let theorem = made.cover.as_ref().unwrap_or(&made.exact).theorem();
        Ok(ConstructedData {
            name: shape.name.clone(),
            bidegree: (made.net.len() - 1, made.net[0].len() - 1),
            convention: CONVENTION,
            net: match made.statement.subject() {
                Subject::Patch(patch) => Some(net(&made.statement, &patch.net)),
                Subject::System(_) => None,
            },
            covers: made.cover.is_ok(),
            reason: made.cover.as_ref().err().map(ToString::to_string),
            theorem: theorem.sentence(),
            files: self.files.iter().map(|files| files.certificate.display().to_string()).collect(),
            statement: statement(&made.statement),
        })
    }
}

/// A tiling, and the folder of its certificates.
#[derive(Debug)]
pub struct Tiling<'a> {
    /// The patches.
    pub tiled: &'a Tiled,
    /// The folder.
    pub directory: &'a Path,
}

/// The same as data.
#[derive(Debug, Serialize)]
pub struct TiledData {
    name: String,
    bidegree: (u32, u32),
    faces: usize,
    covering: usize,
    seams: Vec<SeamData>,
    directory: String,
}

#[derive(Debug, Serialize)]
struct SeamData {
    faces: [usize; 2],
    meets: bool,
}

impl Page for Tiling<'_> {
    type Data = TiledData;

    fn verdict(&self) -> Verdict {
        self.tiled.verdict()
    }

    fn document(&self) -> Result<Document, Limit> {
        Ok(tiling(self.tiled, self.directory))
    }

    fn data(&self) -> Result<TiledData, Limit> {
        let Tiled { shape, bidegree, tiled } = self.tiled;
        let seams = tiled.seams.iter();
        Ok(TiledData {
            name: shape.name.clone(),
            bidegree: *bidegree,
            faces: tiled.faces.len(),
            covering: tiled.faces.iter().filter(|face| face.cover.is_ok()).count(),
            seams: seams.map(|seam| SeamData { faces: seam.faces, meets: seam.meets }).collect(),
            directory: self.directory.display().to_string(),
        })
    }
}
