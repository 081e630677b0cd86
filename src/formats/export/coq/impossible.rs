//! Patches that never lie on their surface.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::spell::{self, integer};
use super::unknowns::Unknowns;
use super::{Parts, Theorem, data};
use crate::certificate::Premise;
use crate::exact::Work;
use crate::formats::export::case::Case;
use crate::formats::export::integral::{common_denominator, scaled};
use crate::statement::{COORDINATES, HomogeneousPoint, Patch};

/// A patch without weights is no patch; where that is not excluded by a constant weight, it is assumed.
const SOME_WEIGHT: &str = "
(** Some control point has a weight. *)
Definition some_weight (net : list (list point)) : Prop := Exists (Exists (fun p => W p <> 0)) net.
";

pub(super) fn parts(case: &Case, patch: &Patch) -> Parts {
    let unknowns = Unknowns::of(case);
    let (m, n) = patch.bidegree;
    let degree = patch.surface.degree();
    let common = common_denominator(patch.net.iter().flatten().flatten());
    let common_surface = common_denominator([&patch.surface]);
    let common_assumptions = common_denominator(&case.assumptions);
    let of_coefficient = &common_surface * common.pow(degree);
    let scale = |premise| match premise {
        Premise::Coefficient(..) => of_coefficient.clone(),
        Premise::Nonzero(_) => common_assumptions.clone(),
        _ => BigInt::one(),
    };
    let shape = format!("{m} {n} {} {}", case.variable_count(), integer(&common));
    let surface = format!("{degree} {}", integer(&common_surface));
    let weight = known_weight(case, patch, &common);
    let assumed = if weight.is_some() { "" } else { SOME_WEIGHT };
    let mut data = vec![
        data::net(patch),
        data::polynomial("surface", &patch.surface),
        data::assumptions(case),
        data::certificate(case, &unknowns, scale),
        format!(
            "Lemma refuted : refuted radicands {shape} net {surface} surface {} assumptions certificate = true.
Proof. vm_cast_no_check (eq_refl true). Qed.\n",
            integer(&common_assumptions)
        ),
    ];
    data.extend(weight.as_ref().map(|weight| weight.lemma(&shape)));
    let unless = if weight.is_some() { "" } else { ", unless all weights are zero," };
    Parts {
        summary: vec![
            format!(
                "{}{} the patch has a point (W is not zero there)",
                unknowns.for_all().trim_end(),
                unless
            ),
            "that is not on the surface: [misses_the_surface], at the end of this file.".into(),
            format!("Hence it never lies on the surface: [never_on_the_surface].{}", unknowns.renamed(case)),
        ],
        definitions: definitions(case, patch, &unknowns, assumed),
        replay: Vec::new(),
        data: data.concat(),
        theorems: theorems(&unknowns, weight.is_some(), &shape, &surface, &integer(&common_assumptions)),
    }
}

/// What is proved, from the pieces that the data have been given under.
fn theorems(
    unknowns: &Unknowns,
    weight_known: bool,
    shape: &str,
    surface: &str,
    assumed: &str,
) -> Vec<Theorem> {
    let net = unknowns.applied("net");
    let (condition, some) = match weight_known {
        true => (String::new(), ""),
        false => (format!("\n  some_weight {net} ->"), "some"),
    };
    let weight = match weight_known {
        true => {
            "- exact (Replay.weight_is_known Data.radicands eq_refl _ _ _ _ _ _ _ _ _ _ Data.weight).".into()
        }
        false => format!(
            "- exact (Replay.weight_is_assumed Data.radicands eq_refl _ _ _ _ _ _ _ _ _ _ _ Data.refuted
             {} eq_refl {net} eq_refl some).",
            unknowns.values
        ),
    };
    let missed = format!(
        "exists u v : R, 0 <= u <= 1 /\\ 0 <= v <= 1 /\\\n    patch W {net} u v <> 0 /\\ ~ lies_on surface {net} u v"
    );
    let quantified = format!("{}{condition}", unknowns.quantified);
    vec![
        Theorem {
            comment: format!("{}a point of the patch misses the surface", unknowns.for_all()),
            name: "misses_the_surface".into(),
            proposition: format!("{quantified}\n  {missed}"),
            proof: vec![
                unknowns.intros(some),
                format!(
                    "refine (Replay.misses_the_surface Data.radicands eq_refl {shape} Data.net {surface} Data.surface"
                ),
                format!("          {assumed} Data.assumptions Data.certificate Data.refuted"),
                format!(
                    "          {} eq_refl _ {net} eq_refl surface (fun _ _ _ _ => eq_refl) _).",
                    unknowns.values
                ),
                format!("- {}.", unknowns.inverses),
                weight,
            ],
        },
        Theorem {
            comment: "So it is not the case that every point of the patch lies on the surface".into(),
            name: "never_on_the_surface".into(),
            proposition: format!(
                "{quantified}
  ~ (forall u v : R, 0 <= u <= 1 -> 0 <= v <= 1 ->
       patch W {net} u v <> 0 -> lies_on surface {net} u v)"
            ),
            proof: vec![
                unknowns.intros(&format!("{some} always")),
                format!("assert (missed : {missed})"),
                "  by (eapply misses_the_surface; eassumption).".into(),
                "destruct missed as [u [v [in_u [in_v [defined missing]]]]].".into(),
                "exact (missing (always u v in_u in_v defined)).".into(),
            ],
        },
    ]
}

/// The net and the surface for readers.
pub(super) fn definitions(case: &Case, patch: &Patch, unknowns: &Unknowns, assumed: &str) -> String {
    let (m, n) = patch.bidegree;
    let point = |point: &HomogeneousPoint| {
        let entries = point.each_ref().map(|entry| spell::argument(entry, &case.field, &unknowns.names));
        format!("Point {}", entries.join(" "))
    };
    format!(
        "(** The control net: rows 0 to {m} along u, in each the points 0 to {n} along v. *)
Definition net{} : list (list point) :=
  {}.
{assumed}
(** The surface: where this is zero. *)
Definition surface (X Y Z W : R) : R := {}.
",
        unknowns.parameters,
        spell::rows(patch.net.iter().map(|row| row.iter().map(point).collect())),
        spell::expression(&patch.surface, &case.field, &COORDINATES.map(String::from))
    )
}

/// A constant weight other than zero, and what makes it an integer.
struct Weight {
    place: (u32, u32),
    /// A sum of terms.
    multiplier: String,
    /// Multiplier times weight times binomial coefficients and common denominator.
    product: BigInt,
}

impl Weight {
    fn lemma(&self, shape: &str) -> String {
        let (i, j) = self.place;
        format!(
            "
(** The weight in row {i}, place {j} is a constant, and not zero. *)
Lemma weight : weight_known radicands {shape} net {i} {j} {} {} = true.
Proof. vm_cast_no_check (eq_refl true). Qed.\n",
            self.multiplier,
            integer(&self.product)
        )
    }
}

fn known_weight(case: &Case, patch: &Patch, common: &BigInt) -> Option<Weight> {
    let rows = (0u32..).zip(&patch.net);
    let weights = rows.flat_map(|(i, row)| (0u32..).zip(row).map(move |(j, point)| ((i, j), &point[3])));
    let constants = weights.filter(|(_, weight)| weight.is_constant() && !weight.is_zero());
    // A rational one, if there is one.
    let (place, weight) = constants.min_by_key(|(_, weight)| weight.as_rational().is_none())?;
    let inverse = weight.inverse(&case.field, &mut Work::full()).ok()??;
    let denominator = common_denominator([&inverse]);
    let multiplier = spell::terms(&scaled(&inverse, &BigRational::from_integer(denominator.clone())));
    let binomial = |n: u32, k: u32| (0..k).fold(BigInt::one(), |c, i| c * (n - i) / (i + 1));
    let (m, n) = patch.bidegree;
    let product = common * binomial(m, place.0) * binomial(n, place.1) * denominator;
    Some(Weight { place, multiplier, product })
}
