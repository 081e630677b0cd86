//! How good bounds are said to be: the best, or next to it, for each end by itself.

use std::fs;

use num_bigint::BigInt;
use num_rational::BigRational;
use prove_cap::certificate::{Argument, Bounds, Certificate, End, Quantity};
use prove_cap::checker::{
    BoundsRejection, CheckError, Claim, Rejection, SubdivisionRejection, check, check_read,
};
use prove_cap::statement::Statement;

/// x = y = 0 and z from 1 at (0,0) and (1,0) to 3 at (0,1) and (1,1): r = 1 + 2v.
fn segment(surface: &str) -> Statement {
    Statement::read(&format!(
        "title = \"t\"\nradicands = []\nunknowns = []\nconvention = \"homogeneous\"\nbidegree = [1, 1]\n\
         surface = \"{surface}\"\nnet = [[[0, 0, 1, 1], [0, 0, 3, 1]], [[0, 0, 1, 1], [0, 0, 3, 1]]]\n"
    ))
    .unwrap()
}

const SPHERE: &str = "X^2 + Y^2 + Z^2 - W^2";

fn end(bound: i64, v: (i64, i64)) -> End {
    let at = [BigRational::from_integer(0.into()), BigRational::new(v.0.into(), v.1.into())];
    End { bound: BigInt::from(bound), at, tree: vec![false] }
}

/// What the checker says of bounds with these places.
fn judged(
    statement: &Statement,
    quantity: Quantity,
    places: u32,
    lower: End,
    upper: End,
) -> Result<([bool; 2], String), Rejection> {
    let odds = [BigRational::from_integer(1.into()), BigRational::from_integer(1.into())];
    let bounds = Bounds { values: vec![], quantity, places, odds, denominator: vec![false], lower, upper };
    let certificate = Certificate { statement: statement.hash(), argument: Argument::Bounds(bounds) };
    match check_read(statement, &certificate) {
        Ok(theorem) => match theorem.claim() {
            Claim::Bounds(bounded) => Ok((bounded.best, theorem.sentence())),
            other => panic!("{other:?}"),
        },
        Err(CheckError::Rejected(rejection)) => Err(rejection),
        Err(other) => panic!("{other}"),
    }
}

fn not_reached(end: &'static str) -> Rejection {
    Rejection::Bounds(BoundsRejection::NotReached { end })
}

#[test]
fn the_sentence_says_best_where_the_point_is_strictly_inside_the_next_decimal() {
    let radius = |lower, upper| judged(&segment(SPHERE), Quantity::Radius, 1, lower, upper);
    let start = "As it stands the denominator W is positive on the whole square, and there ";
    let best = radius(end(10, (0, 1)), end(30, (1, 1))).unwrap();
    assert_eq!(best.0, [true, true]);
    assert_eq!(
        best.1,
        format!(
            "{start}1.0 ≤ √(x² + y² + z²) ≤ 3.0. Both bounds are the best with 1 decimals: the quantity comes within \
             one unit of the last place at (u, v) = (0, 0) and (0, 1)."
        )
    );
    // r = 1.1 at v = 1/20, and 2.9 at v = 19/20: of 1.0 and 3.0 that shows no more than that nothing but these and
    // 1.1 and 2.9 can be the best.
    let next = radius(end(10, (1, 20)), end(30, (19, 20))).unwrap();
    assert_eq!(next.0, [false, false]);
    assert_eq!(
        next.1,
        format!(
            "{start}1.0 ≤ √(x² + y² + z²) ≤ 3.0. Both bounds are the best with 1 decimals, or next to it: the quantity \
             is one unit of the last place from them at (u, v) = (0, 1/20) and (0, 19/20)."
        )
    );
    // Each end by itself.
    let low = radius(end(10, (1, 21)), end(30, (19, 20))).unwrap();
    assert_eq!(low.0, [true, false]);
    assert_eq!(
        low.1,
        format!(
            "{start}1.0 ≤ √(x² + y² + z²) ≤ 3.0. The lower bound is the best with 1 decimals: the quantity comes within \
             one unit of the last place of it at (u, v) = (0, 1/21). The upper bound is the best with 1 decimals, or \
             next to it: the quantity is one unit of the last place from it at (u, v) = (0, 19/20)."
        )
    );
    let high = radius(end(9, (0, 1)), end(30, (20, 21))).unwrap();
    assert_eq!(high.0, [false, true]);
    assert_eq!(
        high.1,
        format!(
            "{start}0.9 ≤ √(x² + y² + z²) ≤ 3.0. The lower bound is the best with 1 decimals, or next to it: the \
             quantity is one unit of the last place from it at (u, v) = (0, 0). The upper bound is the best with 1 \
             decimals: the quantity comes within one unit of the last place of it at (u, v) = (0, 20/21)."
        )
    );
}

#[test]
fn what_is_beyond_the_next_decimal_is_rejected() {
    let radius = |lower, upper| judged(&segment(SPHERE), Quantity::Radius, 1, lower, upper);
    assert_eq!(radius(end(10, (1, 19)), end(30, (1, 1))).unwrap_err(), not_reached("lower"));
    assert_eq!(radius(end(8, (0, 1)), end(30, (1, 1))).unwrap_err(), not_reached("lower"));
    assert_eq!(radius(end(10, (0, 1)), end(30, (18, 19))).unwrap_err(), not_reached("upper"));
    assert_eq!(radius(end(10, (0, 1)), end(32, (1, 1))).unwrap_err(), not_reached("upper"));
}

/// The same for a quotient, whose name has its number: Z + 5W has degree 1, and Z⁹ … at most 8.
#[test]
fn quotients_are_named_with_their_degree() {
    let ratio =
        |surface: &str, lower, upper| judged(&segment(surface), Quantity::Ratio, 0, lower, upper).unwrap();
    let (best, sentence) = ratio("Z - 3*W", end(-2, (0, 1)), end(0, (1, 1)));
    assert_eq!(best, [true, true]);
    assert!(sentence.contains("there −2 ≤ F/W ≤ 0, for F = Z − 3·W."), "{sentence}");
    let (best, sentence) = ratio("Z - 3*W", end(-3, (0, 1)), end(1, (1, 1)));
    assert_eq!(best, [false, false]);
    assert!(sentence.contains("there −3 ≤ F/W ≤ 1, for F = Z − 3·W."), "{sentence}");
    let (_, sentence) = ratio("Z^8", end(1, (0, 1)), end(6561, (1, 1)));
    assert!(sentence.contains("there 1 ≤ F/W⁸ ≤ 6561, for F = Z⁸."), "{sentence}");
}

/// x = y = 0, z = 3v − 1: r = |3v − 1|, which is 0 at v = 1/3 only. No box shows r² ≥ 0 there, and none need.
#[test]
fn no_radius_is_negative() {
    let statement = |z: [&str; 2]| {
        let [a, b] = z;
        Statement::read(&format!(
            "title = \"t\"\nradicands = []\nunknowns = []\nconvention = \"homogeneous\"\nbidegree = [1, 1]\n\
             net = [[[0, 0, \"{a}\", 1], [0, 0, \"{b}\", 1]], [[0, 0, \"{a}\", 1], [0, 0, \"{b}\", 1]]]\n"
        ))
        .unwrap()
    };
    let through = statement(["-1", "2"]);
    let radius = |lower, upper| judged(&through, Quantity::Radius, 3, lower, upper);
    assert_eq!(radius(end(0, (1, 3)), end(2000, (1, 1))).unwrap().0, [true, true]);
    assert_eq!(radius(end(0, (0, 1)), end(2000, (1, 1))).unwrap_err(), not_reached("lower"));
    // Of any other bound the boxes are asked for.
    let sign = |tree| Rejection::Bounds(SubdivisionRejection::Sign { tree, node: 1 }.into());
    assert_eq!(radius(end(1, (1, 3)), end(2000, (1, 1))).unwrap_err(), sign("lower"));
    assert_eq!(radius(end(0, (1, 3)), end(0, (1, 3))).unwrap_err(), sign("upper"));
    // r = 0 everywhere: 0 is the best bound from above too, there is no decimal below it.
    let point = statement(["0", "0"]);
    let (best, sentence) = judged(&point, Quantity::Radius, 3, end(0, (0, 1)), end(0, (0, 1))).unwrap();
    assert_eq!(best, [true, true]);
    assert!(sentence.contains("0.000 ≤ √(x² + y² + z²) ≤ 0.000."), "{sentence}");
    assert_eq!(judged(&point, Quantity::Radius, 3, end(0, (0, 1)), end(1, (0, 1))).unwrap().0, [true, false]);
}

/// Certificates that were once said to be the best: Cobb's patch has r = 1, so that 0 and 2, and 0.999999999999, are not.
#[test]
fn next_to_the_best_is_not_the_best() {
    let statement = fs::read("proofs/cobb/statement.toml").unwrap();
    let sentence = |places: &str| {
        let certificate = fs::read(format!("tests/data/accept/next_to_best-{places}.txt")).unwrap();
        check(&statement, &certificate).unwrap().sentence()
    };
    for (places, between) in
        [("0", "0 ≤ √(x² + y² + z²) ≤ 2"), ("12", "0.999999999999 ≤ √(x² + y² + z²) ≤ 1.000000000001")]
    {
        let sentence = sentence(places);
        let how = format!("Both bounds are the best with {places} decimals, or next to it: ");
        assert!(sentence.contains(between) && sentence.contains(&how), "{sentence}");
    }
}

/// r = 1 + 2v once more, in parameters with other odds: v = λv′/(1 − v′ + λv′).
#[test]
fn boxes_may_be_those_of_other_parameters() {
    let statement = segment(SPHERE);
    let judged = |odds: [(i64, i64); 2], upper: (i64, i64)| {
        let odds = odds.map(|(p, q)| BigRational::new(p.into(), q.into()));
        let (values, denominator) = (vec![], vec![false]);
        let (lower, upper) = (end(10, (1, 21)), end(30, upper));
        let bounds =
            Bounds { values, quantity: Quantity::Radius, places: 1, odds, denominator, lower, upper };
        let certificate = Certificate { statement: statement.hash(), argument: Argument::Bounds(bounds) };
        (certificate.write(&statement.ring()), check_read(&statement, &certificate))
    };
    for odds in [[(1, 1), (1, 1024)], [(7, 3), (5, 1)], [(1_000_000, 1), (1, 1)]] {
        // The points are those of u and v whatever the boxes are: 2.9 at v = 19/20.
        for (point, best) in [((20, 21), [true, true]), ((19, 20), [true, false])] {
            let (text, result) = judged(odds, point);
            assert!(text.starts_with("prove-cap certificate 2\n"), "{text}");
            let theorem = result.unwrap();
            let Claim::Bounds(bounded) = theorem.claim() else { panic!("{theorem}") };
            assert_eq!(bounded.best, best, "{odds:?}");
        }
        let (_, refused) = judged(odds, (18, 19));
        assert_eq!(refused.unwrap_err(), CheckError::Rejected(not_reached("upper")), "{odds:?}");
    }
    let (text, result) = judged([(1, 1), (1, 1)], (20, 21));
    assert!(
        text.starts_with("prove-cap certificate 1\n") && !text.contains("odds") && result.is_ok(),
        "{text}"
    );
}
