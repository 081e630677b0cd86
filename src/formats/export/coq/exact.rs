//! Patches that lie on their surface.

use std::cmp::Ordering;

use itertools::Itertools;

use super::edges::{Edge, planes};
use super::spell::{self, integer};
use super::unknowns::Unknowns;
use super::{EXACT, POSITIVE, Parts, SYSTEM, Theorem, data, impossible, names};
use crate::exact::{Polynomial, Work, sign};
use crate::formats::export::case::{Case, Reasoning};
use crate::formats::export::integral::common_denominator;
use crate::statement::{COORDINATES, Patch};

pub(super) fn parts(case: &Case, patch: &Patch) -> Parts {
    let constant = Unknowns::of(&Case { unknowns: Vec::new(), assumptions: Vec::new(), ..case.clone() });
    let common = integer(&common_denominator(patch.net.iter().flatten().flatten()));
    let of_surface = format!("{} {}", patch.surface.degree(), integer(&common_denominator([&patch.surface])));
    let edges = planes(&case.field, patch);
    let in_planes: Vec<(&Edge, &Polynomial)> =
        edges.iter().filter_map(|edge| Some((edge, edge.plane.as_ref()?))).collect();
    let positive = weights_positive(case, patch);

    let mut theorems = vec![on_the_surface(&common, &of_surface)];
    theorems.extend(positive.then(|| weight_is_positive(&common)));
    theorems.extend(in_planes.iter().map(|(edge, plane)| edge_in_plane(edge, plane, &common)));
    theorems.extend(nonzero_theorems(case));
    let identity = format!(
        "Lemma on_surface : identity radicands {common} net {of_surface} surface (variable 0) (variable 1) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.\n"
    );
    let of_planes = in_planes.iter().map(|(edge, plane)| data::polynomial(&edge.plane_name(), plane));
    Parts {
        summary: summary(case, &edges, positive),
        definitions: impossible::definitions(case, patch, &constant, "")
            + &in_planes.iter().map(|(edge, plane)| plane_definition(case, edge, plane)).collect::<String>(),
        replay: vec![SYSTEM, EXACT, POSITIVE],
        data: [data::net(patch), data::polynomial("surface", &patch.surface)]
            .into_iter()
            .chain(of_planes)
            .chain([nonzero_data(case), identity])
            .collect(),
        theorems,
    }
}

fn summary(case: &Case, edges: &[Edge], positive: bool) -> Vec<String> {
    let mut lines = vec![
        "Every point of this patch lies on the surface: [on_the_surface], at the end of this file.".into(),
    ];
    lines.push(match positive {
        true => {
            "W is positive on the whole square, so that the patch is defined there: [weight_is_positive]."
                .into()
        }
        false => "Not all weights are positive; that W is, is not proved here.".into(),
    });
    let (plane, other): (Vec<&Edge>, Vec<&Edge>) = edges.iter().partition(|edge| edge.plane.is_some());
    let listed = |edges: &[&Edge]| edges.iter().join(", ");
    if !plane.is_empty() {
        lines.push(format!("The edges {} lie in their planes: [edge_...].", listed(&plane)));
    }
    if !other.is_empty() {
        lines.push(format!(
            "Each of the edges {} is straight, a point, or in no plane: nothing is proved of it.",
            listed(&other)
        ));
    }
    lines.extend(values(case));
    lines
}

fn on_the_surface(common: &str, of_surface: &str) -> Theorem {
    Theorem {
        comment: "Every point of the patch lies on the surface".into(),
        name: "on_the_surface".into(),
        proposition: " forall u v : R, patch W net u v <> 0 -> lies_on surface net u v".into(),
        proof: vec![
            "intros u v.".into(),
            format!("exact (Replay.on_the_surface Data.radicands eq_refl {common} Data.net {of_surface} Data.surface"),
            "         (Replay.variable 0) (Replay.variable 1) Data.on_surface [u; v] u v".into(),
            "         (Replay.at_variable _ 0 _) (Replay.at_variable _ 1 _) net eq_refl surface (fun _ _ _ _ => eq_refl)).".into(),
        ],
    }
}

fn weight_is_positive(common: &str) -> Theorem {
    Theorem {
        comment: "On the square W is positive".into(),
        name: "weight_is_positive".into(),
        proposition: " forall u v : R, 0 <= u <= 1 -> 0 <= v <= 1 -> 0 < patch W net u v".into(),
        proof: vec![
            "intros u v.".into(),
            format!(
                "apply (Replay.weight_positive Data.radicands eq_refl {common} Data.net); [vm_compute; reflexivity | reflexivity]."
            ),
        ],
    }
}

fn plane_definition(case: &Case, edge: &Edge, plane: &Polynomial) -> String {
    format!(
        "
(** The plane of the edge {edge}: where this is zero. *)
Definition {} (X Y Z W : R) : R := {}.
",
        edge.plane_name(),
        spell::expression(plane, &case.field, &COORDINATES.map(String::from))
    )
}

/// The plane is a surface of degree 1; one parameter is constant.
fn edge_in_plane(edge: &Edge, plane: &Polynomial, common: &str) -> Theorem {
    let name = edge.plane_name();
    let of_plane = integer(&common_denominator([plane]));
    let constant =
        (format!("(Replay.constant (Replay.Int {}))", edge.at), "(Replay.at_int _ _ _)".to_owned());
    let variable = ("(Replay.variable 0)".to_owned(), "(Replay.at_variable _ 0 _)".to_owned());
    let (running, place, u, v) = match edge.fixed {
        "u" => ("v", format!("{} v", edge.at), constant, variable),
        _ => ("u", format!("u {}", edge.at), variable, constant),
    };
    Theorem {
        comment: format!("The edge {edge} lies in its plane"),
        name: format!("edge_{}{}", edge.fixed, edge.at),
        proposition: format!(" forall {running} : R, patch W net {place} <> 0 -> lies_on {name} net {place}"),
        proof: vec![
            format!("intros {running}."),
            format!(
                "refine (Replay.on_the_surface Data.radicands eq_refl {common} Data.net 1 {of_plane} Data.{name}"
            ),
            format!("          {} {} _ [{running}] {place}", u.0, v.0),
            format!("          {} {} net eq_refl {name} (fun _ _ _ _ => eq_refl)).", u.1, v.1),
            "vm_cast_no_check (eq_refl true).".into(),
        ],
    }
}

fn weights_positive(case: &Case, patch: &Patch) -> bool {
    let mut work = Work::full();
    let mut positive =
        |weight: &Polynomial| matches!(sign(weight, &case.field, &mut work), Ok(Some(Ordering::Greater)));
    patch.net.iter().flatten().all(|point| positive(&point[3]))
}

/// The values of the unknowns, in words.
pub(super) fn values(case: &Case) -> Vec<String> {
    let Reasoning::Exact(values) = &case.argument else {
        return Vec::new();
    };
    let spelled = values.iter().map(|value| spell::expression(value, &case.field, &[]));
    let named = case
        .unknowns
        .iter()
        .zip(spelled)
        .map(|(unknown, value)| format!("{} is {value}", names::name(unknown)));
    let list = named.collect::<Vec<_>>().join("; ");
    if list.is_empty() {
        Vec::new()
    } else {
        vec![format!(
            "The unknowns of the statement have these values, put in by prove-cap before Coq reads the file: {list}."
        )]
    }
}

pub(super) fn nonzero_data(case: &Case) -> String {
    let numbered = (1..).zip(&case.assumptions);
    numbered.map(|(k, assumed): (usize, _)| data::polynomial(&format!("nonzero_{k}"), assumed)).collect()
}

/// That what is assumed not to vanish does not, at the values.
pub(super) fn nonzero_theorems(case: &Case) -> Vec<Theorem> {
    let theorem = |(k, assumed): (usize, &Polynomial)| Theorem {
        comment: "What is assumed not to vanish does not".into(),
        name: format!("nonzero_{k}"),
        proposition: format!(" {} <> 0", spell::expression(assumed, &case.field, &[])),
        proof: vec![
            format!(
                "apply (Replay.not_zero Data.radicands eq_refl {} Data.nonzero_{k});",
                integer(&common_denominator([assumed]))
            ),
            "  [vm_compute; reflexivity | reflexivity].".into(),
        ],
    };
    (1..).zip(&case.assumptions).map(theorem).collect()
}
