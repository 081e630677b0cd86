//! `expand`.

use serde::Serialize;

use crate::commands::{Expanded, Verdict};
use crate::document::Document;
use crate::exact::Limit;
use crate::expand::Basis;
use crate::report::expansion::expansion;
use crate::report::json::{CoefficientData, StatementData, listed, statement};
use crate::report::page::Page;

/// The coefficients that are not zero, as data.
#[derive(Debug, Serialize)]
pub struct ExpandedData {
    name: String,
    statement: StatementData,
    basis: &'static str,
    coefficients: Option<Vec<CoefficientData>>,
}

impl Page for Expanded {
    type Data = ExpandedData;

    fn verdict(&self) -> Verdict {
        Verdict::Shown
    }

    fn document(&self) -> Result<Document, Limit> {
        Ok(expansion(&self.source.statement, self.basis, self.coefficients.as_deref()))
    }

    fn data(&self) -> Result<ExpandedData, Limit> {
        let of = &self.source.statement;
        Ok(ExpandedData {
            name: self.source.name.clone(),
            statement: statement(of),
            basis: match self.basis {
                Basis::Bernstein => "bernstein",
                Basis::Monomial => "monomial",
            },
            coefficients: self.coefficients.clone().map(|list| listed(of, list)),
        })
    }
}
