//! `prove-cap audit [FILE]`: a printed listing, or a printed net, against the truth.

use super::arguments::AuditOptions;
use super::control::under_control;
use super::files::read_limited;
use super::outcome::{Format, Outcome};
use super::source::{beside, find};
use crate::commands::{self, Failure, FileKind, Printed, Source};
use crate::control::Control;
use crate::formats::listing::Listing;
use crate::formats::net::Convention;

pub(super) fn run(options: &AuditOptions, format: Format) -> Result<Outcome, Failure> {
    let place = options.file.as_deref().map(|file| file.display().to_string());
    let place = place.unwrap_or_else(|| "the paper's listing".to_owned());
    under_control(&options.limits, (&place, format), |control| match options.printed(control)? {
        Printed::Listing(listing, own) => {
            options.fit_a_listing()?;
            let listing = commands::mapped(*listing, &options.names, &options.labels)?;
            let source = options.against(&listing, own, control)?;
            let audited = commands::audit_listing(&place, listing, source, control)?;
            Ok(Outcome::of(&audited, format)?)
        }
        Printed::Net(net) => {
            options.fit_a_net()?;
            let audited = commands::audit_net(&place, net, options.surface.as_deref(), control)?;
            Ok(Outcome::of(&audited, format)?)
        }
    })
}

impl AuditOptions {
    /// What is to be audited.
    fn printed(&self, control: &Control) -> Result<Printed, Failure> {
        let Some(file) = &self.file else { return Printed::paper() };
        let stated = self.convention.map(Convention::from);
        if !file.exists() {
            return Printed::net_of(&file.display().to_string(), &find(file, control)?, stated);
        }
        let kind = self.kind.map_or_else(|| FileKind::of(file), |kind| Ok(kind.into()))?;
        Printed::read(file, kind, &read_limited(file, kind.bytes())?, stated, control)
    }

    /// The statement that a listing is held against.
    fn against(
        &self,
        listing: &Listing,
        own: Option<Box<Source>>,
        control: &Control,
    ) -> Result<Source, Failure> {
        let beside = |name: &String| beside(self.file.as_deref(), name);
        let named = self.statement.clone().or_else(|| listing.statement.as_ref().map(beside));
        let ask = "what is the listing to be held against? name a statement with --statement (see `list`)";
        match named {
            Some(named) => find(&named, control),
            None => own.map(|own| *own).ok_or_else(|| Failure::new(ask)),
        }
    }
}
