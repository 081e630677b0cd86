//! Patches: no such patch lies on the surface; or this one does.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::spell::{self, integer};
use super::system::{all_terms, rows, spelled_values};
use super::{EXACT, POSITIVE, Parts, SYSTEM, Unknowns, edges};
use crate::certificate::Premise;
use crate::exact::{Polynomial, Work};
use crate::export::case::{Case, Reasoning};
use crate::export::integral::{common_denominator, integral_steps, scaled};
use crate::statement::{COORDINATES, HomogeneousPoint, Patch};

pub(super) fn impossible(case: &Case, patch: &Patch) -> Parts {
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
    let count = case.variable_count();
    let (common, common_surface) = (integer(&common), integer(&common_surface));
    let common_assumptions = integer(&common_assumptions);
    let shape = format!("{m} {n} {count} {common}");
    let weight = known_weight(case, patch);
    let (condition, introduced, weighted) = match &weight {
        Some(_) => ("", "", "exact (Replay.weight_is_known Data.radicands eq_refl _ _ _ _ _ _ _ _ _ _ Data.weight)"),
        None => (
            "some_weight NET -> ",
            " some",
            "exact (Replay.weight_is_assumed Data.radicands eq_refl _ _ _ _ _ _ _ _ _ _ _ Data.refuted _ eq_refl NET eq_refl some)",
        ),
    };
    let net = unknowns.applied("net");
    let fill = |text: &str| text.replace("NET", &net);
    let (condition, weighted) = (fill(condition), fill(weighted));
    let intros = format!("{}{}", unknowns.intros.trim_end_matches('.'), introduced);
    let intros = match (intros.is_empty(), unknowns.intros.is_empty()) {
        (true, _) => String::new(),
        (false, true) => format!("intros{introduced}."),
        (false, false) => format!("{intros}."),
    };
    let known = weight.map_or(String::new(), |[i, j, multiplier, product]| {
        format!(
            "(** The weight in row {i}, place {j} is a constant, and not zero. *)
Lemma weight : weight_known radicands {shape} net {i} {j} {multiplier} {product} = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
"
        )
    });
    Parts {
        summary: format!(
            "    For all real values of the unknowns{} the patch has a point (W is not zero there) that is not on the surface:
    [misses_the_surface], at the end of this file. Hence it never lies on the surface: [never_on_the_surface].{}",
            if condition.is_empty() { "" } else { ", unless all weights are zero," },
            unknowns.renamed(case)
        ),
        definitions: definitions(case, patch, &unknowns, !condition.is_empty()),
        replay: Vec::new(),
        data: format!(
            "{net}
{surface}
{assumptions}
{certificate}
Lemma refuted : refuted radicands {shape} net {degree} {common_surface} surface {common_assumptions} assumptions certificate = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

{known}",
            net = net_data(patch),
            surface = definition("surface", "list term", &spell::terms(&patch.surface)),
            assumptions = assumptions(case),
            certificate = certificate(case, &unknowns, scale),
        ),
        theorems: format!(
            "(** {for_all}a point of the patch misses the surface. *)
Theorem misses_the_surface : {quantified}{condition}
  exists u v : R, 0 <= u <= 1 /\\ 0 <= v <= 1 /\\
    patch W {net} u v <> 0 /\\ ~ lies_on surface {net} u v.
Proof.
  {intros}
  refine (Replay.misses_the_surface Data.radicands eq_refl {shape} Data.net {degree} {common_surface} Data.surface
            {common_assumptions} Data.assumptions Data.certificate Data.refuted
            {values} eq_refl _ {net} eq_refl surface (fun _ _ _ _ => eq_refl) _).
  - {inverses}.
  - {weighted}.
Qed.

(** So it is not the case that every point of the patch lies on the surface. *)
Theorem never_on_the_surface : {quantified}{condition}
  ~ (forall u v : R, 0 <= u <= 1 -> 0 <= v <= 1 ->
       patch W {net} u v <> 0 -> lies_on surface {net} u v).
Proof.
  {intros} intros always.
  assert (missed : exists u v : R, 0 <= u <= 1 /\\ 0 <= v <= 1 /\\
    patch W {net} u v <> 0 /\\ ~ lies_on surface {net} u v)
    by (eapply misses_the_surface; eassumption).
  destruct missed as [u [v [in_u [in_v [defined missing]]]]]; exact (missing (always u v in_u in_v defined)).
Qed.

Print Assumptions never_on_the_surface.
",
            for_all = if unknowns.names.is_empty() { "" } else { "For all real values of the unknowns " },
            quantified = unknowns.quantified,
            values = unknowns.values,
            inverses = unknowns.inverses,
        ),
    }
}

pub(super) fn exact(case: &Case, patch: &Patch) -> Parts {
    let unknowns = Unknowns { names: Vec::new(), ..Unknowns::of(case) };
    let degree = patch.surface.degree();
    let common = integer(&common_denominator(patch.net.iter().flatten().flatten()));
    let common_surface = integer(&common_denominator([&patch.surface]));
    let planes = edges::planes(&case.field, patch);
    let plane = |edge: &edges::Edge| {
        edge.plane.as_ref().map(|plane| {
            format!(
                "(** The plane of the edge {} = {}. *)\nDefinition {} (X Y Z W : R) : R := {}.\n",
                edge.fixed,
                edge.at,
                edge.name(),
                spell::expression(plane, &case.field, &COORDINATES.map(String::from))
            )
        })
    };
    let positive = weights_positive(case, patch);
    let parameters = Unknowns { parameters: String::new(), arguments: String::new(), ..unknowns };
    Parts {
        summary: format!(
            "    Every point of this patch lies on the surface: [on_the_surface], at the end of this file. {} {}{}",
            if positive { "All weights are positive on the square: [weight_is_positive]." } else { "(Not all weights are positive.)" },
            "Edges lie in planes: [edge_...].",
            values(case)
        ),
        definitions: definitions(case, patch, &parameters, false) + &planes.iter().filter_map(plane).collect::<String>(),
        replay: vec![SYSTEM, EXACT, POSITIVE],
        data: format!(
            "{}\n{}\n{}{}
Lemma on_surface : identity radicands {common} net {degree} {common_surface} surface (variable 0) (variable 1) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
",
            net_data(patch),
            definition("surface", "list term", &spell::terms(&patch.surface)),
            planes.iter().filter_map(|edge| Some(definition(&edge.name(), "list term", &spell::terms(edge.plane.as_ref()?)))).collect::<String>(),
            nonzero_data(case),
        ),
        theorems: format!(
            "(** Every point of the patch lies on the surface. *)
Theorem on_the_surface : forall u v : R, patch W net u v <> 0 -> lies_on surface net u v.
Proof.
  intros u v.
  exact (Replay.on_the_surface Data.radicands eq_refl {common} Data.net {degree} {common_surface} Data.surface
           (Replay.variable 0) (Replay.variable 1) Data.on_surface [u; v] u v
           (Replay.at_variable _ 0 _) (Replay.at_variable _ 1 _) net eq_refl surface (fun _ _ _ _ => eq_refl)).
Qed.
{positive}{planes}{nonzero}
Print Assumptions on_the_surface.
",
            positive = if positive { weight_theorem(&common) } else { String::new() },
            planes = planes.iter().map(|edge| edge_theorem(edge, &common)).collect::<String>(),
            nonzero = nonzero_theorems(case),
        ),
    }
}

fn weight_theorem(common: &str) -> String {
    format!(
        "
(** On the square all weights are positive. *)
Theorem weight_is_positive : forall u v : R, 0 <= u <= 1 -> 0 <= v <= 1 -> 0 < patch W net u v.
Proof.
  intros u v; apply (Replay.weight_positive Data.radicands eq_refl {common} Data.net); [vm_compute; reflexivity | reflexivity].
Qed.
"
    )
}

fn edge_theorem(edge: &edges::Edge, common: &str) -> String {
    let name = edge.name();
    let Some(plane) = &edge.plane else {
        return format!("\n(** {}. *)\n", edge.remark());
    };
    let own = integer(&common_denominator([plane]));
    let fixed = format!("(Replay.constant (Replay.Int {}))", edge.at);
    let (running, place) =
        if edge.fixed == "u" { ("v", format!("{} v", edge.at)) } else { ("u", format!("u {}", edge.at)) };
    let variable = "(Replay.variable 0)".to_owned();
    let at_constant = "(Replay.at_int _ _ _)".to_owned();
    let at_variable = "(Replay.at_variable _ 0 _)".to_owned();
    let [in_u, in_v, reads_u, reads_v] = if edge.fixed == "u" {
        [fixed, variable, at_constant, at_variable]
    } else {
        [variable, fixed, at_variable, at_constant]
    };
    format!(
        "
(** The edge {fixed_name} = {at} lies in its plane. *)
Theorem edge_{fixed_name}{at} : forall {running} : R, patch W net {place} <> 0 -> lies_on {name} net {place}.
Proof.
  intros {running}.
  refine (Replay.on_the_surface Data.radicands eq_refl {common} Data.net 1 {own} Data.{name} {in_u} {in_v} _ [{running}] {place}
            {reads_u} {reads_v} net eq_refl {name} (fun _ _ _ _ => eq_refl)).
  vm_cast_no_check (eq_refl true).
Qed.
",
        fixed_name = edge.fixed,
        at = edge.at,
    )
}

/// `Definition NAME : TYPE := VALUE.`
pub(super) fn definition(name: &str, of: &str, value: &str) -> String {
    format!("Definition {name} : {of} :=\n  {value}.\n")
}

/// The net and the surface for readers.
fn definitions(case: &Case, patch: &Patch, unknowns: &Unknowns, weight_assumed: bool) -> String {
    let (m, n) = patch.bidegree;
    let coordinates = COORDINATES.map(String::from);
    let point = |point: &HomogeneousPoint| {
        let entries = point.each_ref().map(|entry| spell::argument(entry, &case.field, &unknowns.names));
        format!("Point {}", entries.join(" "))
    };
    let net = patch.net.iter().map(|row| row.iter().map(point).collect::<Vec<_>>());
    let assumed = if weight_assumed {
        "\n(** Some control point has a weight. *)
Definition some_weight (net : list (list point)) : Prop := Exists (Exists (fun p => W p <> 0)) net.\n"
    } else {
        ""
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
        rows(net),
        spell::expression(&patch.surface, &case.field, &coordinates)
    )
}

fn net_data(patch: &Patch) -> String {
    let net = patch.net.iter().map(|row| row.iter().map(|point| all_terms(point)).collect::<Vec<_>>());
    definition("net", "net_terms", &rows(net))
}

/// Each assumption with the number of the variable that stands for its inverse.
pub(super) fn assumptions(case: &Case) -> String {
    let entries = case.assumptions.iter().zip(case.unknowns.len()..);
    let entries = entries.map(|(assumed, variable)| format!("({}, {variable})", spell::terms(assumed)));
    definition("assumptions", "list (list term * nat)", &spell::lines(entries))
}

/// The steps, each with its conclusion in words.
pub(super) fn certificate(case: &Case, unknowns: &Unknowns, scale: impl Fn(Premise) -> BigInt) -> String {
    const SHOWN: usize = 100;
    let mut names = unknowns.names.clone();
    names.extend((1..=case.assumptions.len()).map(|k| format!("t_{k}")));
    let premise = |premise: &Premise| match premise {
        Premise::Coefficient(r, s) => format!("c {r} {s}"),
        Premise::Equation(k) => format!("f {k}"),
        Premise::Nonzero(k) => format!("nonzero {k}"),
        Premise::Step(k) => format!("step {k}"),
    };
    let steps = integral_steps(case.steps(), scale);
    let step = |(number, (step, original)): (
        usize,
        (&crate::export::integral::IntegralStep, &crate::certificate::Step),
    )| {
        let summand = |(name, multiplier): &(Premise, Polynomial)| {
            format!("({}, {})", premise(name), spell::terms(multiplier))
        };
        let shown = spell::expression(&original.conclusion, &case.field, &names);
        let shown = if shown.len() <= SHOWN { format!("{shown} = 0") } else { "...".into() };
        format!(
            "(* {number}: {shown} *) Derive\n     {}\n     {} {}",
            format!("[{}]", step.summands.iter().map(summand).collect::<Vec<_>>().join(";\n      ")),
            integer(&step.multiple),
            spell::terms(&step.conclusion)
        )
    };
    let lines = (1..).zip(steps.iter().zip(case.steps())).map(step);
    definition("certificate", "list derivation", &spell::lines(lines))
}

/// A constant weight other than zero: row, place, a multiplier, and the integer that the product in the grid comes to.
fn known_weight(case: &Case, patch: &Patch) -> Option<[String; 4]> {
    let (m, n) = patch.bidegree;
    let common = common_denominator(patch.net.iter().flatten().flatten());
    let places = (0u32..)
        .zip(&patch.net)
        .flat_map(|(i, row)| (0u32..).zip(row).map(move |(j, point)| (i, j, &point[3])));
    let constants = places.filter(|(_, _, weight)| weight.is_constant() && !weight.is_zero());
    // A rational one, if there is one.
    let (i, j, weight) = constants.min_by_key(|(_, _, weight)| weight.as_rational().is_none())?;
    let mut work = Work::full();
    let inverse = weight.inverse(&case.field, &mut work).ok()??;
    let denominator = common_denominator([&inverse]);
    let multiplier = scaled(&inverse, &BigRational::from_integer(denominator.clone()));
    let binomial = |n: u32, k: u32| (0..k).fold(BigInt::one(), |c, i| c * (n - i) / (i + 1));
    let product = common * binomial(m, i) * binomial(n, j) * denominator;
    Some([i.to_string(), j.to_string(), spell::terms(&multiplier), integer(&product)])
}

fn weights_positive(case: &Case, patch: &Patch) -> bool {
    let mut work = Work::full();
    let mut positive = |weight: &Polynomial| {
        crate::exact::sign(weight, &case.field, &mut work)
            .is_ok_and(|sign| sign == Some(std::cmp::Ordering::Greater))
    };
    patch.net.iter().flatten().all(|point| positive(&point[3]))
}

/// What the values of an exact claim are, for the summary.
pub(super) fn values(case: &Case) -> String {
    match &case.argument {
        Reasoning::Exact(values) if !values.is_empty() => {
            format!("\n    The unknowns have these values: {}.", spelled_values(case, values).join("; "))
                .replace('*', " ")
        }
        _ => String::new(),
    }
}

pub(super) fn nonzero_data(case: &Case) -> String {
    (1..)
        .zip(&case.assumptions)
        .map(|(k, assumed): (usize, _)| {
            definition(&format!("nonzero_{k}"), "list term", &spell::terms(assumed))
        })
        .collect()
}

/// That the assumptions hold at the values.
pub(super) fn nonzero_theorems(case: &Case) -> String {
    let theorem = |(k, assumed): (usize, &Polynomial)| {
        format!(
            "
(** What is assumed not to vanish does not. *)
Theorem nonzero_{k} : {} <> 0.
Proof. apply (Replay.not_zero Data.radicands eq_refl {} Data.nonzero_{k}); [vm_compute; reflexivity | reflexivity]. Qed.
",
            spell::expression(assumed, &case.field, &[]),
            integer(&common_denominator([assumed]))
        )
    };
    (1..).zip(&case.assumptions).map(theorem).collect()
}
