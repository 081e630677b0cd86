//! Every engine stops where it is asked to, whatever it is at: the clock is a counter of how often it was looked at.

use std::fmt::Debug;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use prove_cap::approximation::{
    ApproximationError, EnclosureError, Objective, Search, UnreachableError, approximate, enclose, exclude,
};
use prove_cap::catalogue;
use prove_cap::construction::{Refusal, construct, tile};
use prove_cap::control::{Control, Interrupted, Why};
use prove_cap::elimination::Undecided;
use prove_cap::geometry::NamedPolygon;
use prove_cap::prove::{Attempt, Reason, prove};
use prove_cap::statement::Statement;

/// A control that stops at the n-th look, and the number of looks.
pub(crate) fn stopping_at(n: usize) -> (Control, Arc<AtomicUsize>) {
    let looks = Arc::new(AtomicUsize::new(0));
    let counted = looks.clone();
    let control =
        Control::watched(move || (counted.fetch_add(1, Ordering::Relaxed) + 1 >= n).then_some(Why::Time));
    (control, looks)
}

/// Stops the work at the first look, at the last, and at some in between; it says that it was stopped, and by whom.
fn stops_everywhere<T: Debug>(work: impl Fn(&Control) -> Result<T, Interrupted>) {
    let (control, looks) = stopping_at(usize::MAX);
    work(&control).unwrap_or_else(|stopped| panic!("{stopped:?} by nobody"));
    let all = looks.load(Ordering::Relaxed);
    assert!(all > 2, "it is asked now and then: {all}");
    let places = (0..12).map(|k| all - all * k / 12).chain([1, 2, all - 1]);
    for n in places {
        let (control, _) = stopping_at(n);
        match work(&control) {
            Err(stopped) => assert_eq!(stopped.why, Why::Time, "at {n} of {all}"),
            // With several threads the same work is not always the same number of looks.
            Ok(found) => assert!(n + all / 10 > all, "at {n} of {all}: {found:?}"),
        }
    }
}

fn built_in(name: &str) -> Statement {
    Statement::read(&catalogue::find(name).unwrap().statement()).unwrap()
}

fn proving(text: &str, control: &Control) -> Result<String, Interrupted> {
    match prove(&Statement::read(text).unwrap(), control).unwrap() {
        Attempt::Undecided(Reason::Elimination(Undecided::Interrupted(why))) => Err(why),
        other => Ok(format!("{other:?}").chars().take(200).collect()),
    }
}

fn system(unknowns: &str, equations: &[&str]) -> String {
    let names: Vec<&str> = unknowns.split(' ').collect();
    format!("title = \"t\"\nradicands = []\nunknowns = {names:?}\npolynomials = {equations:?}\n")
}

#[test]
fn refutations_stop() {
    stops_everywhere(|control| proving(&catalogue::find("cap-3x3").unwrap().statement(), control));
}

/// Real roots are counted after the last phase of elimination.
#[test]
fn zeros_without_a_root_in_the_field_stop() {
    let cubics = ["x^3 + y*z - 7", "y^3 + x*z + 5", "z^3 - x*y + 11*x - 3"];
    stops_everywhere(|control| proving(&system("x y z", &cubics), control));
}

#[test]
fn zeros_that_are_found_and_choices_stop() {
    stops_everywhere(|control| proving(&system("x y", &["x^5 - x - 30", "y^3 - 3*y + x - 20"]), control));
    stops_everywhere(|control| proving(&system("x y z", &["x*y - 2*z^2", "x^3 - 4*z^3 - 4"]), control));
}

#[test]
fn bounds_stop() {
    let statement = built_in("cap-2x2");
    let values: Vec<_> = ["0.467959158138040", "2.370695072453977"]
        .map(|text| {
            Statement::read_constant(text, statement.field(), &mut prove_cap::exact::Work::full()).unwrap()
        })
        .into();
    stops_everywhere(|control| match enclose(&statement, &values, 12, control) {
        Err(EnclosureError::Interrupted(why)) => Err(why),
        other => Ok(other.unwrap().proof),
    });
}

#[test]
fn searches_for_the_best_stop() {
    let statement = built_in("cap-2x2");
    let search =
        Search { objective: Objective::Minimax, points: 9, pass: Vec::new(), places: Some(8), seed: 1 };
    stops_everywhere(|control| match approximate(&statement, &search, control) {
        Err(ApproximationError::Interrupted(why, _)) => Err(why),
        other => Ok(other.unwrap().found),
    });
    let found = approximate(&statement, &search, &Control::default()).unwrap();
    let apart = [999_990, 1_000_010].map(num_bigint::BigInt::from);
    stops_everywhere(|control| match exclude(&statement, apart.clone(), 6, &found.extremes, control) {
        Err(UnreachableError::Interrupted(why)) => Err(why),
        other => Ok(other.unwrap().boxes),
    });
}

#[test]
fn constructions_stop() {
    let octant = NamedPolygon::find("octant").unwrap();
    stops_everywhere(|control| match tile(octant, (4, 4), control) {
        Err(Refusal::Interrupted(why)) => Err(why),
        other => Ok(other.unwrap().seams.len()),
    });
    stops_everywhere(|control| match construct(&octant.polygon(), "t", (4, 4), None, control) {
        Err(Refusal::Interrupted(why)) => Err(why),
        other => Ok(other.unwrap().exact),
    });
}
