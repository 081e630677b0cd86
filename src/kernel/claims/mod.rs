//! The claims that can be argued: a folder for each, with its data, its text, its rules and its sentence.
//!
//! A claim has its line in the registry below. Its folder has `read` and `write` (the lines after `claim KEYWORD`),
//! `verify` (the rules of FORMAT.md, section 6), the values that a completed check establishes, each with its `kind`,
//! `sentence` and `details`, and `Rejection`, the ways in which it can be wrong.

// Layers: each uses those above it only.
mod wording;
mod exact;
mod impossible;
mod subdivision;
mod bounds;
mod unreachable;
mod cover;

use std::fmt;

use crate::exact::{Polynomial, Ring, Work};
use crate::failure::Failure;
use crate::statement::Statement;
use crate::text::{CertificateError, Reader};

pub use bounds::{Bounded, Bounds, End, Rejection as BoundsRejection};
pub use cover::{Cover, Covered, EDGES, EdgeTree, Rejection as CoverRejection};
pub use exact::{ExactNet, Rejection as ExactRejection, Solution};
pub use impossible::{Refuted, Rejection as ImpossibleRejection, Step};
pub use subdivision::{Quantity, Rejection as SubdivisionRejection, Side, Tree, Units, spell_decimal};
pub use unreachable::{Excluded, Odds, Region, Rejection as UnreachableRejection, Unreachable};
pub use wording::written;

macro_rules! registry {
    ($($keyword:literal in $folder:ident: $(#[$doc:meta])* $variant:ident($argument:ty)
        => $($(#[$established_doc:meta])* $established:ident($value:ty)),+;)+) => {
        /// The kinds of argument.
        #[allow(clippy::large_enum_variant, reason = "one or two are alive at a time")]
        #[derive(Debug, Clone, PartialEq, Eq)]
        pub enum Argument { $($(#[$doc])* $variant($argument)),+ }

        /// What was proved.
        #[allow(clippy::large_enum_variant, reason = "one or two are alive at a time")]
        #[derive(Debug, Clone, PartialEq, Eq)]
        pub enum Claim { $($($(#[$established_doc])* $established($value)),+),+ }

        /// What is wrong with a well-formed argument.
        #[derive(Debug, Clone, PartialEq, Eq)]
        pub enum Rejection {
            /// The certificate is for a statement with another hash.
            OtherStatement {
                /// The statement's.
                expected: String,
                /// The certificate's.
                actual: String,
            },
            $(#[doc = concat!("Of claim `", $keyword, "`.")] $variant($folder::Rejection)),+
        }

        $(impl From<$folder::Rejection> for Rejection {
            fn from(rejection: $folder::Rejection) -> Self {
                Rejection::$variant(rejection)
            }
        })+

        impl Argument {
            /// Reads what follows `claim KEYWORD`; `None` for another keyword.
            pub(crate) fn read(
                keyword: &str,
                reader: &mut Reader<'_, '_>,
            ) -> Option<Result<Self, CertificateError>> {
                match keyword {
                    $($keyword => Some($folder::read(reader).map(Argument::$variant)),)+
                    _ => None,
                }
            }

            /// The whole text, after the first lines.
            pub(crate) fn write(&self, ring: &Ring, first: Vec<String>) -> String {
                let mut lines = first;
                match self {
                    $(Argument::$variant(argument) => {
                        lines.push(concat!("claim ", $keyword).into());
                        $folder::write(argument, ring, lines)
                    })+
                }
            }

            /// What the argument establishes about the statement.
            pub(crate) fn verify(
                &self,
                statement: &Statement,
                work: &mut Work,
            ) -> Result<Claim, Failure<Rejection>> {
                match self {
                    $(Argument::$variant(argument) => $folder::verify(statement, argument, work)
                        .map(Claim::from)
                        .map_err(|failure| failure.map(Rejection::from)),)+
                }
            }
        }

        $($(impl From<$value> for Claim {
            fn from(value: $value) -> Self {
                Claim::$established(value)
            }
        })+)+

        impl Claim {
            /// `impossible`, `exact`, `solution`, …
            pub(crate) fn kind(&self) -> &'static str {
                match self { $($(Claim::$established(value) => value.kind(),)+)+ }
            }

            /// What was proved about the statement, as sentences.
            pub(crate) fn sentence(&self, statement: &Statement) -> String {
                match self { $($(Claim::$established(value) => value.sentence(statement),)+)+ }
            }

            /// Lines under the sentence: what was replayed, and the values.
            pub(crate) fn details(&self, statement: &Statement) -> Vec<String> {
                match self { $($(Claim::$established(value) => value.details(statement),)+)+ }
            }
        }

        impl fmt::Display for Rejection {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    Rejection::OtherStatement { expected, actual } => write!(
                        f,
                        "the certificate is for another statement\nexpected  sha256 {expected}\nactual    sha256 {actual}"
                    ),
                    $(Rejection::$variant(rejection) => rejection.fmt(f)),+
                }
            }
        }
    };
}

/// The line that names the claim, for messages.
pub(crate) const EXPECTED: &str = "`claim ` and `impossible`, `exact`, `bounds`, `unreachable` or `cover`";

registry! {
    "impossible" in impossible:
        /// The equations have no common zero: steps that end in 1.
        Impossible(Vec<Step>) =>
        /// The equations and assumptions of the statement have no common zero over any field containing K.
        Impossible(Refuted);
    "exact" in exact:
        /// They have this one: a value in K for each unknown, in the statement's order.
        Exact(Vec<Polynomial>) =>
        /// At these values the patch lies on the surface.
        Exact(ExactNet),
        /// These values solve the system.
        Solution(Solution);
    "bounds" in bounds:
        /// At certain values the patch is this near to the surface.
        Bounds(Bounds) =>
        /// It is.
        Bounds(Bounded);
    "unreachable" in unreachable:
        /// At no values is it nearer than this.
        Unreachable(Unreachable) =>
        /// At none it is.
        Unreachable(Excluded);
    "cover" in cover:
        /// At certain values the patch covers a spherical polygon, once and regularly.
        Cover(Cover) =>
        /// It does.
        Cover(Covered);
}

impl Argument {
    /// The version of the format that has everything the argument uses.
    pub(crate) fn version(&self) -> u32 {
        match self {
            Argument::Bounds(bounds) => bounds.version(),
            Argument::Unreachable(argument) => argument.version(),
            _ => 1,
        }
    }
}

impl From<exact::Zero> for Claim {
    fn from(zero: exact::Zero) -> Self {
        match zero {
            exact::Zero::OfPatch(net) => Claim::Exact(net),
            exact::Zero::OfSystem(solution) => Claim::Solution(solution),
        }
    }
}
