//! The best approximation does not depend on what a patch is measured in, where it lies, or how its unknowns are called.

#[path = "scale/patch.rs"]
mod patch;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use patch::{AS_IT_IS, CAP, CAP_IN_PLACE, CENTRE, Disguise, Family, PARABOLOID, TORUS};
use prove_cap::approximation::{
    Approximation, ApproximationError, Objective, Search, approximate, error_of, exclude,
};
use prove_cap::catalogue;
use prove_cap::certificate::{
    Argument, Certificate, CertificateError, CertificateFault, Quantity, Unreachable, decimal_value,
};
use prove_cap::checker::{CheckError, Rejection, UnreachableRejection, check_read};
use prove_cap::control::{Control, Why};
use prove_cap::exact::{Polynomial, Work};
use prove_cap::statement::Statement;

fn found(statement: &Statement, objective: Objective) -> Approximation {
    let search = Search { objective, points: 21, pass: vec![], places: None, seed: 1 };
    approximate(statement, &search, &Control::default()).unwrap()
}

fn doubles(values: &[Polynomial]) -> Vec<f64> {
    values.iter().map(|value| value.as_rational().unwrap().to_f64().unwrap()).collect()
}

/// The proved ends of F/Wᵉ or of r − 1.
fn ends(found: &Approximation) -> [f64; 2] {
    let bounds = &found.enclosure.bounds;
    let centre =
        if bounds.quantity == Quantity::Radius { BigInt::from(10).pow(bounds.places) } else { 0.into() };
    [&bounds.lower.bound, &bounds.upper.bound]
        .map(|end| decimal_value(&(end - &centre), bounds.places).to_f64().unwrap())
}

const MILLIMETRES: Disguise = Disguise { scale: "1000", ..AS_IT_IS };
const RADIUS_500: Disguise = Disguise { scale: "500", ..AS_IT_IS };
const MEGAMETRES: Disguise = Disguise { scale: "1/10^6", turned: true, ..AS_IT_IS };
const FAR_AWAY: Disguise =
    Disguise { scale: "500", turned: true, shift: ["10^6", "-5", "10^7"], axes: [2, 0, 1], ..AS_IT_IS };
/// For CAP_IN_PLACE.
const IN_PLACE: Disguise = Disguise { scale: "500", shift: ["0", "0", "10^4"], factor: "1/1000", ..AS_IT_IS };
const SMALL_WEIGHTS: Disguise = Disguise { factor: "1/10^3", scale: "2", ..AS_IT_IS };
const IRRATIONAL: Disguise =
    Disguise { factor: "(sqrt(2)-1)^20", scale: "3", shift: ["1", "2", "3"], ..AS_IT_IS };
const OTHER_UNITS: Disguise =
    Disguise { units: Some(["1000", "1/77", "5000", "1/3"]), axes: [1, 2, 0], scale: "7", ..AS_IT_IS };
const PREMULTIPLIED: Disguise =
    Disguise { homogeneous: true, factor: "10^6", scale: "1/1000", shift: ["1", "0", "-1"], ..AS_IT_IS };

/// F is written in the coordinates before the motion, so that F/Wᵉ does not change; only the digits of the bounds do not say so.
fn alike(family: &Family, objective: Objective, disguises: &[&Disguise], tolerance: f64, of_values: f64) {
    let plain = Disguise { scale: "2", ..AS_IT_IS };
    let expected = found(&family.statement(&plain), objective);
    let values = doubles(&expected.found.values);
    let places = expected.enclosure.bounds.places;
    let size = decimal_value(&error_of(&expected.enclosure), places).to_f64().unwrap();
    for (number, disguise) in disguises.iter().enumerate() {
        let other = found(&family.statement(disguise), objective);
        for (a, b) in ends(&expected).iter().zip(ends(&other)) {
            assert!((a - b).abs() < tolerance * size, "disguise {number}: {a} {b}");
        }
        let undone = family.undone(disguise, &doubles(&other.found.values));
        for (a, b) in values.iter().zip(&undone) {
            assert!((a - b).abs() < of_values, "disguise {number}: {values:?} {undone:?}");
        }
    }
}

#[test]
fn the_best_cap_is_the_same_in_every_disguise() {
    let all =
        [&RADIUS_500, &MEGAMETRES, &FAR_AWAY, &SMALL_WEIGHTS, &IRRATIONAL, &OTHER_UNITS, &PREMULTIPLIED];
    alike(&CAP, Objective::Minimax, &all, 1e-7, 1e-9);
}

#[test]
fn so_are_those_of_the_other_objectives() {
    let some = [&MILLIMETRES, &FAR_AWAY, &OTHER_UNITS];
    alike(&CAP, Objective::Outer, &some, 1e-7, 1e-9);
    alike(&CAP, Objective::Inner, &some, 1e-7, 1e-9);
    alike(&CAP, Objective::LeastSquares, &some, 1e-7, 1e-9);
    // The width is flat at its smallest: the values are known less well than it is.
    alike(&CAP, Objective::Width, &some, 1e-2, 1e-5);
}

#[test]
fn so_is_that_with_a_middle_anywhere() {
    alike(&CENTRE, Objective::Minimax, &[&FAR_AWAY, &OTHER_UNITS, &SMALL_WEIGHTS], 1e-6, 1e-8);
}

#[test]
fn so_are_patches_near_other_surfaces() {
    let some = [&MILLIMETRES, &FAR_AWAY, &SMALL_WEIGHTS, &OTHER_UNITS];
    alike(&PARABOLOID, Objective::LeastSquares, &some, 1e-6, 1e-7);
    alike(&TORUS, Objective::LeastSquares, &some, 1e-6, 1e-7);
}

#[test]
fn an_unknown_in_the_coordinates_of_a_place_far_away_is_found_there() {
    let near = found(&CAP.statement(&Disguise { scale: "2", ..AS_IT_IS }), Objective::Minimax);
    let far = found(&CAP_IN_PLACE.statement(&IN_PLACE), Objective::Minimax);
    let [values, there] = [&near, &far].map(|one| doubles(&one.found.values));
    assert!((there[0] - values[0]).abs() < 1e-9, "{there:?}");
    assert!((there[1] - (1e4 + 500.0 * values[1])).abs() < 1e-6, "{there:?}");
    for (a, b) in ends(&near).iter().zip(ends(&far)) {
        assert!((a - b).abs() < 1e-11, "{a} {b}");
    }
}

/// The unit sphere's minimax is of r − 1, another sphere's of F/W² = r² − R²: nearly twice the same.
#[test]
fn a_cap_in_millimetres_is_as_good_as_one_of_radius_1() {
    let one = found(&CAP.statement(&AS_IT_IS), Objective::Minimax);
    let [low, high] = ends(&one);
    assert!(one.enclosure.bounds.quantity == Quantity::Radius && (high - 6.0217819e-5).abs() < 1e-12);
    // F itself times R².
    let text = "title = \"t\"\nradicands = [2, 3]\nunknowns = [\"w\", \"z\"]\nconvention = \"cartesian\"\nbidegree = [2, 2]\n\
                surface = \"X^2 + Y^2 + Z^2 - 250000*W^2\"\n\
                net = [\n  [[\"-a\", \"-a\", \"a\", \"1\"], [\"0\", \"-b\", \"b\", \"q\"], [\"a\", \"-a\", \"a\", \"1\"]],\n  \
                [[\"-b\", \"0\", \"b\", \"q\"], [\"0\", \"0\", \"z\", \"w\"], [\"b\", \"0\", \"b\", \"q\"]],\n  \
                [[\"-a\", \"a\", \"a\", \"1\"], [\"0\", \"b\", \"b\", \"q\"], [\"a\", \"a\", \"a\", \"1\"]],\n]\n\
                [define]\na = \"500*sqrt(3)/3\"\nb = \"500*sqrt(3)/2\"\nq = \"sqrt(6)/3\"\n";
    let large = found(&Statement::read(text).unwrap(), Objective::Minimax);
    let values = doubles(&large.found.values);
    assert!((values[0] - 0.471493577853732).abs() < 1e-6, "{values:?}");
    assert!((values[1] - 500.0 * 2.360816574922191).abs() < 1e-3, "{values:?}");
    for (r, ratio) in [low, high].into_iter().zip(ends(&large)) {
        assert!((ratio / (500000.0 * r) - 1.0).abs() < 1e-4, "{r} {ratio}");
    }
    assert_eq!(large.enclosure.bounds.places, 7, "as many digits as 12 decimals of r are");
}

/// The optima of THEOREMS.md, found by another program.
#[test]
fn the_families_of_the_catalogue_reach_their_optima() {
    let expected =
        [("cap-2x2-centre", 6.0217818e-5), ("cap-2x2-free", 3.1038034e-5), ("cap-3x3-d4", 3.640863e-6)];
    for (name, best) in expected {
        let statement = Statement::read(&catalogue::find(name).unwrap().statement()).unwrap();
        let enclosure = found(&statement, Objective::Minimax).enclosure;
        let error = error_of(&enclosure).to_f64().unwrap() / 10f64.powi(enclosure.bounds.places as i32);
        assert!((error / best - 1.0).abs() < 1e-6, "{name}: {error:e}");
    }
}

#[test]
fn exact_values_are_recognised_in_any_unit() {
    for disguise in [AS_IT_IS, RADIUS_500, FAR_AWAY, IRRATIONAL, OTHER_UNITS] {
        let outer = found(&CAP.statement(&disguise), Objective::Outer);
        assert!(outer.recognised, "{} {:?}", disguise.scale, doubles(&outer.found.values));
        // 0 is attained, exactly.
        assert!(outer.enclosure.attained[0]);
        assert_eq!(ends(&outer)[0], 0.0);
    }
    assert!(!found(&CAP.statement(&RADIUS_500), Objective::Minimax).recognised);
}

/// Bounds a little tighter than what was found, in units of so many places.
fn barrier(
    statement: &Statement,
    part: f64,
) -> Result<Unreachable, prove_cap::approximation::UnreachableError> {
    let best = found(statement, Objective::Minimax);
    let error = best.extremes.iter().map(|place| place.value.abs()).fold(0.0, f64::max);
    let places = 24;
    let size = BigInt::from((error * part * 1e24) as i128);
    let centre = match best.enclosure.bounds.quantity {
        Quantity::Radius => BigInt::from(10).pow(places),
        Quantity::Ratio => 0.into(),
    };
    let between = [&centre - &size, &centre + &size];
    exclude(statement, between, places, &best.extremes, &Control::default()).map(|barrier| {
        match barrier.proof.certificate().argument.clone() {
            Argument::Unreachable(argument) => argument,
            other => panic!("{other:?}"),
        }
    })
}

#[test]
fn that_nothing_is_better_is_proved_in_every_disguise() {
    let disguises = [
        (CAP, RADIUS_500, false),
        (CAP, FAR_AWAY, false),
        (CAP, OTHER_UNITS, true),
        (CAP, PREMULTIPLIED, false),
        (CAP_IN_PLACE, IN_PLACE, true),
    ];
    for (family, disguise, is_put) in disguises {
        let statement = family.statement(&disguise);
        let argument = barrier(&statement, 0.9999).unwrap();
        // Where the unknowns' own units or places are others, something is put for them.
        assert_eq!(argument.forms.is_empty(), !is_put, "{}", disguise.scale);
        // About as many boxes as without a disguise (352 at a millionth).
        let boxes = argument.charts.iter().flatten().count();
        assert!(boxes < 1000, "{boxes}");
    }
    // As it is, nothing is put for the unknowns.
    assert!(barrier(&CAP.statement(&AS_IT_IS), 0.9999).unwrap().forms.is_empty());
}

fn verdict(statement: &Statement, argument: &Unreachable) -> Result<(), CheckError> {
    let certificate =
        Certificate { statement: statement.hash(), argument: Argument::Unreachable(argument.clone()) };
    check_read(statement, &certificate).map(|_| ())
}

#[test]
fn forms_that_are_changed_prove_nothing() {
    let statement = CAP_IN_PLACE.statement(&IN_PLACE);
    let argument = barrier(&statement, 0.99).unwrap();
    verdict(&statement, &argument).unwrap();
    let ring = statement.ring();
    let changed = |change: &dyn Fn(&mut Unreachable)| {
        let mut other = argument.clone();
        change(&mut other);
        verdict(&statement, &other).unwrap_err()
    };
    let rejected = |error: CheckError| {
        assert!(
            matches!(
                error,
                CheckError::Rejected(Rejection::Unreachable(UnreachableRejection::NotExcluded { .. }))
            ),
            "{error}"
        );
    };
    rejected(changed(&|a| a.forms.clear()));
    // All weights a thousand times smaller, all heights thrown about.
    for text in ["1/1000*z", "-4000*w + 512*z"] {
        rejected(changed(&|a| a.forms.last_mut().unwrap().1 = form(&statement, text)));
    }
    // The reader: what is no form, or would leave values out.
    for (name, text) in [(1, "z^2"), (1, "w"), (1, "3"), (1, "w*z"), (1, "sqrt(2)*z"), (1, "0"), (0, "w")] {
        let error = changed(&|a| a.forms = vec![(name, form(&statement, text))]);
        let CheckError::Certificate(CertificateError {
            fault: CertificateFault::Line { expected, .. }, ..
        }) = &error
        else {
            panic!("{text}: {error}")
        };
        assert!(expected.starts_with("`put`, a later unknown than before"), "{expected}");
    }
    let twice = form(&statement, "2*z");
    for order in
        [vec![(1, twice.clone()), (1, twice.clone())], vec![(1, twice.clone()), (0, form(&statement, "2*w"))]]
    {
        let error = changed(&|a| a.forms = order.clone());
        assert!(matches!(error, CheckError::Certificate(_)), "{error}");
    }
    // Spelled as it is read.
    let text = Certificate { statement: statement.hash(), argument: Argument::Unreachable(argument.clone()) }
        .write(&ring);
    assert!(text.contains("\nput "), "{text}");
}

fn form(statement: &Statement, text: &str) -> Polynomial {
    statement.ring().read(text, &mut Work::full()).unwrap()
}

/// An observer that stops the work when it sees something.
fn stopped_at(
    statement: &Statement,
    when: impl Fn(&str) -> bool + Send + Sync + 'static,
) -> ApproximationError {
    let stopper = Control::default();
    let control = stopper.clone().observed(move |progress| {
        if when(&progress.to_string()) {
            stopper.stop(Why::Interrupt);
        }
    });
    let search = Search { objective: Objective::Minimax, points: 21, pass: vec![], places: None, seed: 1 };
    approximate(statement, &search, &control).unwrap_err()
}

#[test]
fn what_was_found_before_an_interruption_is_kept() {
    let statement = CAP.statement(&RADIUS_500);
    let nothing = stopped_at(&statement, |progress| progress.starts_with("least squares: start"));
    assert!(matches!(&nothing, ApproximationError::Interrupted(_, None)), "{nothing:?}");
    assert_eq!(nothing.to_string(), "interrupted");
    let early = stopped_at(&statement, |progress| progress.starts_with("least squares: start 3 of"));
    let late = stopped_at(&statement, |progress| progress.starts_with("linear programs: round 4,"));
    for error in [early, late] {
        let ApproximationError::Interrupted(_, Some(best)) = error else { panic!("{error:?}") };
        let values = doubles(&best.values.values);
        assert!((values[0] - 0.4715).abs() < 0.01 && (values[1] - 2.3608).abs() < 0.01, "{values:?}");
        let [least, greatest] = best.measured;
        assert!((-3e-4..0.0).contains(&least) && (0.0..3e-4).contains(&greatest), "{least} {greatest}");
    }
}

#[test]
fn rounded_bounds_stay_bounds() {
    use prove_cap::report::rounding::{Towards, rounded};
    let value = |text: &str| -> f64 {
        let plain = text.replace('−', "-");
        let (mantissa, power) = plain.split_once("·10").unwrap_or((&plain, ""));
        let digits: String = power
            .chars()
            .map(|c| {
                if c == '⁻' {
                    '-'
                } else {
                    char::from_digit("⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|d| d == c).unwrap() as u32, 10).unwrap()
                }
            })
            .collect();
        format!("{mantissa}e{}", if digits.is_empty() { "0" } else { &digits }).parse().unwrap()
    };
    let mut random = 12345u64;
    for _ in 0..500 {
        random = random.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let exact = BigRational::new(
            BigInt::from((random >> 20) as i64 - (1i64 << 43)),
            BigInt::from((random & 0xfffff) + 1),
        );
        let (near, digits) = (exact.to_f64().unwrap(), (random % 7) as u32);
        let [below, above] =
            [Towards::Below, Towards::Above].map(|towards| value(&rounded(&exact, digits, towards)));
        let slack = near.abs() * 1e-15;
        assert!(below <= near + slack && near <= above + slack, "{below} {near} {above}");
        assert!(above - below <= near.abs() * 10f64.powi(-(digits as i32)) * 1.001, "{below} {near} {above}");
    }
}
