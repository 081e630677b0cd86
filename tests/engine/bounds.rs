//! Enclosures and barriers: reproduced, held against independent evaluation, and refused after changes.

use std::fs;
use std::path::{Path, PathBuf};

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use proptest::prelude::*;
use prove_cap::approximation::{
    EnclosureError, Finding, Model, Objective, Search, UnreachableError, approximate, compare_at, enclose,
    error_of, exclude, judge, local_extremes,
};
use prove_cap::catalogue;
use prove_cap::certificate::{
    Argument, Bounds, Certificate, Quantity, Region, Side, Unreachable, decimal_value, spell_decimal,
};
use prove_cap::checker::{
    BoundsRejection, CheckError, Claim, Excluded, Rejection, SubdivisionRejection, UnreachableRejection,
    check, check_read,
};
use prove_cap::control::{Control, Why};
use prove_cap::exact::{Arithmetic, Polynomial, Work};
use prove_cap::statement::{Statement, Subject};

fn built_in(name: &str) -> Statement {
    Statement::read(&catalogue::find(name).unwrap().statement()).unwrap()
}

fn constant(text: &str) -> Polynomial {
    Statement::read_constant(text, built_in("cap-2x2").field(), &mut Work::full()).unwrap()
}

/// The paper's Eq. 18.
fn paper() -> Vec<Polynomial> {
    ["0.467959158138040", "2.370695072453977"].map(constant).to_vec()
}

/// The committed arguments by subdivision of one kind, with their statements.
fn committed(kind: &str) -> Vec<(PathBuf, Statement, Certificate)> {
    let mut found = Vec::new();
    for folder in fs::read_dir("proofs").unwrap().map(|entry| entry.unwrap().path()) {
        let Ok(text) = fs::read_to_string(folder.join("statement.toml")) else { continue };
        let statement = Statement::read(&text).unwrap();
        for file in fs::read_dir(&folder).unwrap().map(|entry| entry.unwrap().path()) {
            if file.file_name().unwrap().to_string_lossy().starts_with(kind) {
                let text = fs::read(&file).unwrap();
                let unknowns = statement.unknowns().len();
                let certificate =
                    Certificate::read(&text, &statement.ring(), unknowns, &mut Work::full()).unwrap();
                found.push((file, statement.clone(), certificate));
            }
        }
    }
    found.sort_by(|a, b| a.0.cmp(&b.0));
    found
}

fn bounds_of(certificate: &Certificate) -> &Bounds {
    match &certificate.argument {
        Argument::Bounds(bounds) => bounds,
        other => panic!("no bounds: {other:?}"),
    }
}

fn barrier_of(certificate: &Certificate) -> &Unreachable {
    match &certificate.argument {
        Argument::Unreachable(argument) => argument,
        other => panic!("no barrier: {other:?}"),
    }
}

#[test]
fn committed_bounds_are_reproduced_to_the_byte() {
    let all = committed("bounds");
    assert!(all.len() >= 8, "they are found");
    for (file, statement, certificate) in all {
        let bounds = bounds_of(&certificate);
        let again = enclose(&statement, &bounds.values, bounds.places, &Control::default()).unwrap();
        assert_eq!(again.proof.text(), fs::read_to_string(&file).unwrap(), "{}", file.display());
    }
}

#[test]
fn committed_barriers_are_accepted_and_stand_a_millionth_below_committed_bounds() {
    let barriers = committed("unreachable");
    assert!(barriers.len() >= 2);
    for (file, statement, certificate) in barriers {
        let theorem = check_read(&statement, &certificate).unwrap();
        let Claim::Unreachable(Excluded { places, between, .. }) = theorem.claim() else {
            panic!("another claim")
        };
        let barrier = decimal_value(&between[1], *places) - BigRational::from_integer(1.into());
        let reached = committed("bounds").into_iter().filter(|(other, ..)| other.parent() == file.parent());
        let least = reached.map(|(_, _, certificate)| {
            let bounds = bounds_of(&certificate).clone();
            let one = BigRational::from_integer(1.into());
            let [low, high] =
                [&bounds.lower, &bounds.upper].map(|end| decimal_value(&end.bound, bounds.places));
            (&one - low).max(high - &one)
        });
        let gap = least.min().unwrap() / barrier;
        assert!(gap > BigRational::from_integer(1.into()), "{}: {gap}", file.display());
        assert!(gap < BigRational::new(1_000_002.into(), 1_000_000.into()), "{}: {gap}", file.display());
    }
}

/// Fixed point with 300 bits, of numbers of K: nothing of the program's own arithmetic.
mod fixed {
    use super::*;

    pub(crate) const BITS: u32 = 300;

    pub(crate) fn of(value: &Polynomial) -> BigInt {
        let terms = value.terms().map(|(monomial, rational)| {
            let n: u32 = [(1, 2), (2, 3)]
                .iter()
                .filter(|(bit, _)| monomial.mask() & bit != 0)
                .map(|(_, d)| d)
                .product();
            let root = (BigInt::from(n) << (2 * BITS)).sqrt();
            rational.numer() * root / rational.denom()
        });
        terms.sum()
    }

    pub(crate) fn times(a: &BigInt, b: &BigInt) -> BigInt {
        (a * b) >> BITS
    }

    /// √(x² + y² + z²) of a net at (i/n, j/n), by Bernstein's polynomials as they are defined.
    pub(crate) fn radius(net: &[Vec<[BigInt; 4]>], n: u32, i: u32, j: u32) -> BigInt {
        let basis = |degree: usize, k: u32| -> Vec<BigInt> {
            let binomial = |r: usize| (0..r).fold(1u64, |c, s| c * (degree - s) as u64 / (s as u64 + 1));
            (0..=degree)
                .map(|r| {
                    let powers = BigInt::from(k).pow(r as u32) * BigInt::from(n - k).pow((degree - r) as u32);
                    ((BigInt::from(binomial(r)) * powers) << BITS) / BigInt::from(n).pow(degree as u32)
                })
                .collect()
        };
        let (of_u, of_v) = (basis(net.len() - 1, i), basis(net[0].len() - 1, j));
        let mut sums = [(); 4].map(|()| BigInt::ZERO);
        for (row, a) in net.iter().zip(&of_u) {
            for (point, b) in row.iter().zip(&of_v) {
                let weight = times(a, b);
                sums.iter_mut().zip(point).for_each(|(sum, x)| *sum += times(&weight, x));
            }
        }
        let squares: BigInt = sums[..3].iter().map(|x| x * x).sum();
        (squares.sqrt() << BITS) / &sums[3]
    }
}

fn net_at(statement: &Statement, values: &[Polynomial]) -> Vec<Vec<[BigInt; 4]>> {
    let Subject::Patch(patch) = statement.subject() else { panic!("a patch") };
    let at = |entry: &Polynomial| {
        fixed::of(&Arithmetic::new(statement.field(), &mut Work::full()).substitute(entry, values).unwrap())
    };
    patch.net.iter().map(|row| row.iter().map(|point| point.each_ref().map(at)).collect()).collect()
}

#[test]
fn dense_samples_of_an_independent_evaluation_stay_inside_and_come_near() {
    for (file, statement, certificate) in committed("bounds") {
        let bounds = bounds_of(&certificate);
        let net = net_at(&statement, &bounds.values);
        let unit = BigInt::from(10).pow(bounds.places);
        let scaled = |bound: &BigInt| (bound << fixed::BITS) / &unit;
        let [low, high] = [&bounds.lower.bound, &bounds.upper.bound].map(scaled);
        // What rounding may do to 300 bits.
        let slack = BigInt::from(1) << 40u32;
        let mut samples: Vec<BigInt> = Vec::new();
        for (i, j) in itertools::iproduct!(0..=48, 0..=48) {
            samples.push(fixed::radius(&net, 48, i, j));
        }
        for end in [&bounds.lower, &bounds.upper] {
            // Both coordinates over one power of two.
            let n = end.at.iter().map(|x| x.denom().clone()).max().unwrap();
            let [i, j] = end.at.each_ref().map(|x| u32::try_from(x.numer() * (&n / x.denom())).unwrap());
            samples.push(fixed::radius(&net, u32::try_from(&n).unwrap(), i, j));
        }
        for sample in &samples {
            assert!(low.clone() - &slack <= *sample && *sample <= &high + &slack, "{}", file.display());
        }
        let one_unit = (BigInt::from(1) << fixed::BITS) / &unit + &slack;
        let (least, most) = (samples.iter().min().unwrap(), samples.iter().max().unwrap());
        assert!(least - &low <= one_unit && &high - most <= one_unit, "{}", file.display());
    }
}

#[test]
fn the_papers_interval_fails_above_and_holds_below() {
    let statement = built_in("cap-2x2");
    let enclosure = enclose(&statement, &paper(), 12, &Control::default()).unwrap();
    let spelled = [&enclosure.bounds.lower, &enclosure.bounds.upper].map(|end| spell_decimal(&end.bound, 12));
    // The figures of the reference document, and of the independent evaluation above.
    assert_eq!(spelled, ["0.999999994155", "1.000114866647"]);
    let claim = ["0.999999994", "1.000104146"].map(String::from);
    let verdicts = judge(&statement, &enclosure, &claim).unwrap();
    assert_eq!(verdicts[0].finding, Finding::Bound);
    let Finding::Fails { at, value } = &verdicts[1].finding else { panic!("{verdicts:?}") };
    assert!(value.starts_with("1.000114"), "{value}");
    let printed = BigRational::new(1_000_104_146.into(), 1_000_000_000.into());
    assert!(compare_at(&statement, &paper(), at, &printed).unwrap().is_gt());
    let rounded = ["0.999999994", "1.00011487"].map(String::from);
    assert!(judge(&statement, &enclosure, &rounded).unwrap().iter().all(|v| v.finding == Finding::Bound));
    let rounded = ["0.9999999942", "1.0001148666"].map(String::from);
    assert!(judge(&statement, &enclosure, &rounded).unwrap().iter().all(|v| v.finding == Finding::Rounded));
    let equal = ["0.999999994155", "1.0001148666465"].map(String::from);
    assert_eq!(judge(&statement, &enclosure, &equal).unwrap()[1].finding, Finding::Open);
}

#[test]
fn patches_on_the_surface_have_nothing_but_zero() {
    for name in ["cobb", "cap-4x2-exact"] {
        let enclosure = enclose(&built_in(name), &[], 30, &Control::default()).unwrap();
        assert_eq!(error_of(&enclosure), BigInt::ZERO, "{name}");
        assert_eq!(enclosure.attained, [true, true]);
    }
}

#[test]
fn other_surfaces_are_bounded_by_the_ratio() {
    let text = catalogue::find("cobb").unwrap().statement();
    let twice = text.replace("X^2 + Y^2 + Z^2 - W^2", "X^2 + Y^2 + Z^2 - 4*W^2");
    let twice = if twice == text {
        text.replace("bidegree = [4, 4]", "bidegree = [4, 4]\nsurface = \"X^2 + Y^2 + Z^2 - 4*W^2\"")
    } else {
        twice
    };
    let enclosure = enclose(&Statement::read(&twice).unwrap(), &[], 8, &Control::default()).unwrap();
    assert_eq!(enclosure.bounds.quantity, Quantity::Ratio);
    // 1 − 4 everywhere.
    assert_eq!(
        [&enclosure.bounds.lower.bound, &enclosure.bounds.upper.bound],
        [&BigInt::from(-300_000_000); 2]
    );
}

#[test]
fn denominators_that_vanish_are_refused_with_the_place() {
    let statement = built_in("cap-2x2");
    let at =
        |w: &str| enclose(&statement, &[constant(w), constant("2")], 12, &Control::default()).unwrap_err();
    let error = at("-3");
    assert_eq!(
        error.to_string(),
        "the denominator W of the patch is negative at u = 1/2, v = 1/2, expected positive on the whole square; it is \
         positive at u = v = 0, so that it vanishes in between"
    );
    let EnclosureError::Denominator { at: place, vanishes: true, .. } = error else { panic!("{error}") };
    let half = BigRational::new(1.into(), 2.into());
    assert_eq!(*place, [half.clone(), half]);
    // W(1/2, 1/2) = 1/4 + √6/6 + w/4 is 0.
    let touching = at("-1 - 2*sqrt(6)/3");
    assert!(
        touching.to_string().starts_with("the denominator W of the patch is 0 at u = 1/2, v = 1/2"),
        "{touching}"
    );
}

#[test]
fn what_has_no_patch_or_no_unknowns_is_refused() {
    let system =
        Statement::read("title = \"t\"\nradicands = []\nunknowns = [\"x\"]\npolynomials = [\"x\"]\n")
            .unwrap();
    let error = enclose(&system, &[Polynomial::integer(0)], 12, &Control::default()).unwrap_err();
    assert_eq!(error.to_string(), "a system of equations has no patch to bound");
    let search =
        Search { objective: Objective::Minimax, points: 11, pass: vec![], places: Some(12), seed: 1 };
    let error = approximate(&built_in("cobb"), &search, &Control::default()).unwrap_err();
    assert_eq!(error.to_string(), "there is no patch with unknowns to choose; `bound` encloses one without");
    let none = exclude(&built_in("cobb"), [0.into(), 1.into()], 0, &[], &Control::default());
    assert!(matches!(none, Err(UnreachableError::NothingToChoose)));
}

#[test]
fn a_set_flag_stops_the_work() {
    let control = Control::default();
    control.stop(Why::Interrupt);
    let error = enclose(&built_in("cap-2x2"), &paper(), 12, &control).unwrap_err();
    assert!(matches!(error, EnclosureError::Interrupted(_)), "{error}");
    let search =
        Search { objective: Objective::Minimax, points: 11, pass: vec![], places: Some(12), seed: 1 };
    assert_eq!(approximate(&built_in("cap-2x2"), &search, &control).unwrap_err().to_string(), "interrupted");
}

/// Values as doubles.
fn doubles(values: &[Polynomial]) -> Vec<f64> {
    values.iter().map(|value| value.as_rational().unwrap().to_f64().unwrap()).collect()
}

fn found(name: &str, objective: Objective, pass: &[(f64, f64)]) -> prove_cap::approximation::Approximation {
    let search = Search { objective, points: 101, pass: pass.to_vec(), places: Some(12), seed: 1 };
    approximate(&built_in(name), &search, &Control::default()).unwrap()
}

#[test]
fn the_best_outer_and_inner_patches_are_recognised() {
    let outer = found("cap-2x2", Objective::Outer, &[]);
    assert!(outer.recognised);
    let w = constant("sqrt(3)/3 + sqrt(2)/2 - sqrt(6)/3");
    assert_eq!(outer.enclosure.bounds.values[0], w);
    assert_eq!(outer.enclosure.bounds.lower.bound, BigInt::from(10).pow(12));
    let field = built_in("cap-2x2").field().clone();
    let p =
        Arithmetic::new(&field, &mut Work::full()).product(&w, &outer.enclosure.bounds.values[1]).unwrap();
    assert_eq!(p, constant("1 - sqrt(2)/2 + sqrt(6)/3"));
    let inner = found("cap-2x2", Objective::Inner, &[]);
    assert!(inner.recognised);
    assert_eq!(inner.enclosure.bounds.upper.bound, BigInt::from(10).pow(12));
    assert!(!found("cap-2x2", Objective::Minimax, &[]).recognised);
}

#[test]
fn the_minimax_patch_is_as_far_out_as_in_and_better_than_its_neighbours() {
    let statement = built_in("cap-2x2");
    let best = found("cap-2x2", Objective::Minimax, &[]);
    let worst = |values: &[f64]| -> [f64; 2] {
        let model = Model::of(&statement).unwrap();
        let extremes = local_extremes(&model.at(values), 64);
        [1.0, -1.0].map(|sign| extremes.iter().map(|place| sign * place.value).fold(f64::MIN, f64::max))
    };
    let values = doubles(&best.found.values);
    let [above, below] = worst(&values);
    // To the decimals that the values have.
    assert!((above - below).abs() < 1e-15, "{above} {below}");
    for step in [[1e-6, 0.0], [-1e-6, 0.0], [0.0, 1e-6], [0.0, -1e-6], [1e-6, -5e-6], [-1e-6, 5e-6]] {
        let [beside, below] = worst(&[values[0] + step[0], values[1] + step[1]]);
        assert!(beside.max(below) > above, "{step:?}");
    }
}

#[test]
fn least_squares_is_stationary_and_keeps_its_constraints() {
    let free = doubles(&found("cap-2x2", Objective::LeastSquares, &[]).found.values);
    // 101 × 101 points, by an independent program: 0.470786, 2.362722.
    assert!((free[0] - 0.470786).abs() < 1e-6 && (free[1] - 2.362722).abs() < 1e-6);
    let pass = doubles(&found("cap-2x2", Objective::LeastSquares, &[(0.5, 0.5)]).found.values);
    let statement = built_in("cap-2x2");
    let model = Model::of(&statement).unwrap();
    assert!(model.at(&pass).value(0.5, 0.5).abs() < 1e-13);
    assert!(model.at(&free).value(0.5, 0.5).abs() > 1e-5);
}

#[test]
fn nothing_is_excluded_that_exists() {
    // Just wider than the best patch needs: it is not to be excluded.
    let (statement, best) = (built_in("cap-2x2"), found("cap-2x2", Objective::Minimax, &[]));
    let one = 10i64.pow(12);
    let between = [one - 60_230_000, one + 60_230_000].map(BigInt::from);
    let error = exclude(&statement, between, 12, &best.extremes, &Control::default()).unwrap_err();
    assert!(matches!(error, UnreachableError::TooMany(..)), "{error}");
}

/// Whether the checker turns a changed argument down, and how.
fn verdict(statement: &Statement, argument: Argument) -> Result<(), Rejection> {
    let certificate = Certificate { statement: statement.hash(), argument };
    match check_read(statement, &certificate) {
        Ok(_) => Ok(()),
        Err(CheckError::Rejected(rejection)) => Err(rejection),
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn changed_bounds_are_rejected_though_they_are_sealed_anew() {
    for (_, statement, certificate) in committed("bounds") {
        let bounds = bounds_of(&certificate);
        let with = |change: &dyn Fn(&mut Bounds)| {
            let mut changed = bounds.clone();
            change(&mut changed);
            verdict(&statement, Argument::Bounds(changed))
        };
        assert_eq!(with(&|_| {}), Ok(()));
        let tightened = [with(&|b| b.lower.bound += 1), with(&|b| b.upper.bound -= 1)];
        for result in tightened {
            assert!(
                matches!(
                    result,
                    Err(Rejection::Bounds(
                        BoundsRejection::Subdivision(SubdivisionRejection::Sign { .. })
                            | BoundsRejection::NotReached { .. }
                    ))
                ),
                "{result:?}"
            );
        }
        for result in [with(&|b| b.lower.bound -= 2), with(&|b| b.upper.bound += 2)] {
            let expected = matches!(
                result,
                Err(Rejection::Bounds(
                    BoundsRejection::NotReached { .. }
                        | BoundsRejection::Subdivision(SubdivisionRejection::NeedlessHalving { .. })
                ))
            );
            assert!(expected, "{result:?}");
        }
        for which in ["denominator", "lower", "upper"] {
            let tree = |b: &mut Bounds, tree: &dyn Fn(&mut Vec<bool>)| match which {
                "denominator" => tree(&mut b.denominator),
                "lower" => tree(&mut b.lower.tree),
                _ => tree(&mut b.upper.tree),
            };
            let halved = with(&|b| {
                tree(b, &|t| {
                    let last = t.len() - 1;
                    t.splice(last.., [true, false, false]);
                });
            });
            assert!(
                matches!(
                    halved,
                    Err(Rejection::Bounds(BoundsRejection::Subdivision(
                        SubdivisionRejection::NeedlessHalving { .. }
                    )))
                ),
                "{which}: {halved:?}"
            );
            let pruned = with(&|b| tree(b, &|t| *t = vec![false]));
            let whole = match which {
                "denominator" => bounds.denominator.len(),
                "lower" => bounds.lower.tree.len(),
                _ => bounds.upper.tree.len(),
            } == 1;
            assert_eq!(pruned.is_ok(), whole, "{which}: {pruned:?}");
        }
        let moved = with(&|b| b.upper.at[0] = BigRational::new(1.into(), 64.into()));
        assert!(moved.is_err() || error_of_exact(bounds), "{moved:?}");
    }
}

fn error_of_exact(bounds: &Bounds) -> bool {
    // The upper bound 1 is attained on the whole boundary, or everywhere.
    bounds.upper.bound == BigInt::from(10).pow(bounds.places)
}

#[test]
fn changed_barriers_are_rejected_though_they_are_sealed_anew() {
    for (_, statement, certificate) in committed("unreachable") {
        let argument = barrier_of(&certificate);
        let with = |change: &dyn Fn(&mut Unreachable)| {
            let mut changed = argument.clone();
            change(&mut changed);
            verdict(&statement, Argument::Unreachable(changed))
        };
        assert_eq!(with(&|_| {}), Ok(()));
        // A thousandth further out there are patches: nothing may say otherwise.
        let half = (&argument.upper - &argument.lower) / 2i32;
        let wider = with(&|a| {
            a.lower -= &half / 1000i32;
            a.upper += &half / 1000i32;
        });
        assert!(
            matches!(wider, Err(Rejection::Unreachable(UnreachableRejection::NotExcluded { .. }))),
            "{wider:?}"
        );
        assert!(matches!(
            with(&|a| a.range = 1.into()),
            Err(Rejection::Unreachable(UnreachableRejection::NotExcluded { .. }))
        ));
        assert!(matches!(
            with(&|a| a.charts.swap(0, 1)),
            Err(Rejection::Unreachable(UnreachableRejection::NotExcluded { .. }))
        ));
        let moved = with(&|a| {
            for sample in &mut a.samples {
                sample[0].value = BigRational::new(1.into(), 100.into());
            }
        });
        assert!(
            matches!(moved, Err(Rejection::Unreachable(UnreachableRejection::NotExcluded { .. }))),
            "{moved:?}"
        );
        // Where no weight is unknown, samples need not move.
        if statement.unknowns().contains(&"w".to_owned()) {
            let still = with(&|a| a.samples.iter_mut().flatten().for_each(|odds| odds.shrinking = false));
            assert!(
                matches!(still, Err(Rejection::Unreachable(UnreachableRejection::NotExcluded { .. }))),
                "{still:?}"
            );
        }
        // Each box for itself: another side does not exclude it.
        let others = with(&|a| {
            for region in a.charts.iter_mut().flatten() {
                if let Region::Excluded(sum) = region {
                    let flip = |side: &mut Side| {
                        *side = if *side == Side::Lower { Side::Upper } else { Side::Lower };
                    };
                    sum.iter_mut().for_each(|(_, side, _)| flip(side));
                    sum.sort_by_key(|(_, side, sample)| (*side, *sample));
                }
            }
        });
        assert!(
            matches!(others, Err(Rejection::Unreachable(UnreachableRejection::NotExcluded { .. }))),
            "{others:?}"
        );
    }
}

/// Whether a changed text is turned down.
fn refused(statement: &[u8], text: &[u8]) -> bool {
    check(statement, text).is_err()
}

/// At so many places of each file, or at all.
fn mutants(places: usize) {
    for kind in ["bounds", "unreachable"] {
        for (file, ..) in committed(kind) {
            let statement = fs::read(Path::new(&file).with_file_name("statement.toml")).unwrap();
            let text = fs::read(&file).unwrap();
            assert!(!refused(&statement, &text));
            // A file that is longer than so many bytes would take hours.
            let places = if text.len() > 20_000 { places.min(100) } else { places };
            for at in (0..text.len()).step_by(text.len().div_ceil(places)) {
                let mut shorter = text.clone();
                shorter.remove(at);
                // Deleting one of two equal neighbours is deleting the other.
                assert!(refused(&statement, &shorter), "{} without byte {at}", file.display());
                for byte in [b'0', b'1', b'9', b'.', b'h', b' ', b'-', b'/', b'*'] {
                    let mut changed = text.clone();
                    changed[at] = byte;
                    assert!(
                        changed == text || refused(&statement, &changed),
                        "{} byte {at}: {byte}",
                        file.display()
                    );
                    let mut longer = text.clone();
                    longer.insert(at, byte);
                    assert!(refused(&statement, &longer), "{} byte {at}: {byte} inserted", file.display());
                }
            }
        }
    }
}

#[test]
fn damaged_files_are_refused() {
    mutants(24);
}

#[test]
#[ignore = "minutes: every byte of every file up to 20 kB"]
fn all_damaged_files_are_refused() {
    mutants(20_000);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Whatever the weights, every point of the patch is inside, and the denominator is refused or positive.
    #[test]
    fn every_point_is_inside(w in 1i64..3000, z in 1000i64..4000, points in prop::collection::vec((0i64..=97, 0i64..=97), 8)) {
        let statement = built_in("cap-2x2");
        let value = |n: i64| Polynomial::rational(BigRational::new(n.into(), 1000.into()));
        let values = [value(w), value(z)];
        let enclosure = enclose(&statement, &values, 6, &Control::default()).unwrap();
        let [low, high] = [&enclosure.bounds.lower, &enclosure.bounds.upper].map(|end| decimal_value(&end.bound, 6));
        for (i, j) in points {
            let at = [i, j].map(|k| BigRational::new(k.into(), 97.into()));
            prop_assert!(compare_at(&statement, &values, &at, &low).unwrap().is_ge());
            prop_assert!(compare_at(&statement, &values, &at, &high).unwrap().is_le());
        }
    }

    /// Decimals are spelled with all their places, and mean what they spell.
    #[test]
    fn decimals_are_spelled_in_full(units in -10_000_000i64..10_000_000, places in 0u32..9) {
        let text = spell_decimal(&units.into(), places);
        let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        prop_assert_eq!(decimals, places as usize);
        let read: BigInt = text.replace('.', "").parse().unwrap();
        prop_assert_eq!(read, BigInt::from(units));
    }
}
