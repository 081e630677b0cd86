//! `audit`, of a listing and of a net.

use crate::commands::{AuditedListing, AuditedNet, Verdict};
use crate::document::Document;
use crate::exact::Limit;
use crate::report::audit::describe_audit;
use crate::report::audit_data::{AuditData, audit as audit_data};
use crate::report::net::{NetData, describe_net, net_data};
use crate::report::page::Page;

impl Page for AuditedListing {
    type Data = AuditData;

    fn verdict(&self) -> Verdict {
        AuditedListing::verdict(self)
    }

    fn document(&self) -> Result<Document, Limit> {
        Ok(describe_audit(self))
    }

    fn data(&self) -> Result<AuditData, Limit> {
        let source = &self.source;
        Ok(audit_data(&self.listing, &source.name, &source.statement, &self.audit))
    }
}

impl Page for AuditedNet {
    type Data = NetData;

    fn verdict(&self) -> Verdict {
        AuditedNet::verdict(self)
    }

    fn document(&self) -> Result<Document, Limit> {
        describe_net(self)
    }

    fn data(&self) -> Result<NetData, Limit> {
        Ok(net_data(&self.net, &self.audit))
    }
}
