//! The audit of control nets: positive controls, and one wrong entry at a time.

use std::fs;

use prove_cap::audit::net::{NetAudit, NetChange};
use prove_cap::control::Control;
use prove_cap::exact::Polynomial;
use prove_cap::formats::net::{Convention, PrintedNet, from_json, from_matlab};

fn audit(net: &PrintedNet) -> NetAudit {
    NetAudit::of(net, &Control::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn cobb() -> PrintedNet {
    from_json(&fs::read_to_string("tests/data/nets/cobb-4x4.json").unwrap()).unwrap()
}

fn matlab(name: &str, convention: Convention) -> PrintedNet {
    from_matlab(&fs::read_to_string(format!("tests/data/nets/{name}.m")).unwrap(), name, convention).unwrap()
}

#[test]
fn the_positive_controls_agree() {
    for net in
        [cobb(), matlab("octant", Convention::Homogeneous), matlab("stereographic", Convention::Cartesian)]
    {
        let audit = audit(&net);
        assert!(audit.agrees, "{}", net.title);
        assert!(audit.residual.is_empty() && audit.corrections.is_empty());
    }
}

/// Flips the sign of one number and looks whether exactly that is found.
fn check_flip(net: &PrintedNet, i: usize, j: usize, k: usize) {
    let mut bad = net.clone();
    let right = net.points[i][j][k].clone();
    bad.points[i][j][k] = right.negate();
    let audit = audit(&bad);
    assert!(!audit.agrees);
    let named = audit.corrections.iter().any(|correction| {
        correction.point == Some((i, j))
            && matches!(&correction.change, NetChange::Entry { coordinate, right: found, .. }
                if *coordinate == k && *found == right)
    });
    assert!(named, "({i},{j}) {k}: {:?}", audit.corrections);
    let elsewhere = audit.corrections.iter().any(|correction| correction.point != Some((i, j)));
    assert!(!elsewhere, "({i},{j}) {k}: {:?}", audit.corrections);
}

fn entries(net: &PrintedNet) -> Vec<(usize, usize, usize)> {
    let (m, n) = net.bidegree();
    let all = (0..=m).flat_map(|i| (0..=n).flat_map(move |j| (0..4).map(move |k| (i, j, k))));
    all.filter(|&(i, j, k)| !net.points[i][j][k].is_zero()).collect()
}

#[test]
fn a_flipped_sign_is_named() {
    let net = cobb();
    for &(i, j, k) in entries(&net).iter().step_by(11) {
        check_flip(&net, i, j, k);
    }
}

#[test]
#[ignore = "every sign of Cobb's net"]
fn every_flipped_sign_is_named() {
    let net = cobb();
    for (i, j, k) in entries(&net) {
        check_flip(&net, i, j, k);
    }
}

#[test]
fn a_wrong_weight_is_named() {
    for (net, (i, j)) in [
        (cobb(), (1, 2)),
        (matlab("stereographic", Convention::Cartesian), (0, 1)),
        (matlab("octant", Convention::Homogeneous), (1, 1)),
    ] {
        let mut bad = net.clone();
        bad.points[i][j][3] = Polynomial::integer(7);
        let audit = audit(&bad);
        let weights: Vec<_> = audit
            .corrections
            .iter()
            .filter(|c| matches!(&c.change, NetChange::Entry { coordinate: 3, right, .. } if *right == net.points[i][j][3]))
            .collect();
        assert_eq!(weights.len(), 1, "{}: {:?}", net.title, audit.corrections);
        assert_eq!(weights[0].point, Some((i, j)));
    }
}

#[test]
fn a_point_in_the_wrong_convention_is_named() {
    // The middle of an edge of the octant, weight √2/2, given as the point itself.
    let mut bad = matlab("octant", Convention::Homogeneous);
    for k in 0..3 {
        bad.points[2][1][k] = match bad.points[2][1][k].is_zero() {
            true => Polynomial::zero(),
            false => Polynomial::integer(if k == 2 { -1 } else { 1 }),
        };
    }
    let audit = audit(&bad);
    let meant = NetChange::Convention { meant: Convention::Cartesian };
    assert!(
        audit.corrections.iter().any(|c| c.point == Some((2, 1)) && c.change == meant),
        "{:?}",
        audit.corrections
    );
}

#[test]
fn a_whole_net_in_the_wrong_convention_is_recognised() {
    for (name, right) in [("octant", Convention::Homogeneous), ("stereographic", Convention::Cartesian)] {
        let audit = audit(&matlab(name, right.other()));
        assert!(!audit.agrees);
        assert_eq!(audit.corrections[0].point, None);
        assert_eq!(audit.corrections[0].change, NetChange::Convention { meant: right });
    }
}

#[test]
fn two_wrong_entries_are_not_explained_away() {
    let mut bad = cobb();
    bad.points[0][0][0] = bad.points[0][0][0].negate();
    bad.points[3][3][1] = bad.points[3][3][1].negate();
    let audit = audit(&bad);
    assert!(!audit.agrees);
    assert_eq!(audit.corrections, []);
    assert!(audit.largest().is_some());
}

fn json_error(text: &str) -> String {
    from_json(text).unwrap_err().to_string()
}

#[test]
fn json_that_is_no_net_is_refused() {
    let net =
        |body: &str| format!("{{\"convention\": \"homogeneous\", \"radicands\": [2], \"net\": {body}}}");
    for (text, complaint) in [
        ("{".to_owned(), "the file: EOF while parsing an object at line 1 column 1"),
        (
            "{\"net\": []}".to_owned(),
            "convention: expected \"cartesian\" or \"homogeneous\" (premultiplied), as its first word",
        ),
        (net("3"), "net: expected a list of rows"),
        (net("[3]"), "net[0]: expected a list of points"),
        (net("[[[1,2,3]]]"), "net[0][0]: expected four numbers"),
        (net("[[[1,2,3,0.5]]]"), "net[0][0][3]: expected an exact number: put decimals into quotes"),
        (net("[[[1,2,3,\"x\"]]]"), "net[0][0][3]: `x` is none of the unknowns, expected numbers only"),
        (
            net("[[[1,2,3,\"sqrt(5)\"]]]"),
            "net[0][0][3]: this square root is not in Q(√2); with 5 among the radicands it is",
        ),
        (
            net("[[[1,2,3,\"1/2 2\"]]]"),
            "net[0][0][3]: ambiguous: is this factor part of the divisor? write brackets, 1/(2w) or (1/2)w, or \\frac",
        ),
        (net("[[[1,2,3,4]]]"), "net: 1 × 1 points, expected from 2 × 2 to 33 × 33"),
        (net("[[[1,2,3,4],[1,2,3,4]],[[1,2,3,4]]]"), "net: row 1 has 1 points, row 0 has 2"),
        (
            net("[[[1,2,3,[1,2]],[1,2,3,4]],[[1,2,3,4],[1,2,3,4]]]"),
            "net[0][0][3]: expected an expression in quotes, an integer, or one coordinate for each basis element",
        ),
        (
            net("[[[1,2,3,4],[1,2,3,4]],[[1,2,3,4],[1,2,3,4]]], \"surface\": 5"),
            "surface: expected a polynomial in X, Y, Z, W in quotes",
        ),
        (
            "{\"convention\": \"cartesian\", \"radicands\": [4], \"net\": []}".to_owned(),
            "radicands: radicand 4 is not a prime; for √6 list the primes 2 and 3",
        ),
    ] {
        assert_eq!(json_error(&text), complaint, "{text}");
    }
}

#[test]
fn matlab_blanks_separate_entries_as_in_matlab() {
    let text = "c(:,:,1) = [1 -1 7; 0 - 0, 2*1 +3; 4 - 1 2 5; (1 + 0) 1 1];\nc(:,:,2) = [1 1 1\n 0 0 0\n 0 0 0\n 1 1 1]";
    let net = from_matlab(text, "", Convention::Homogeneous).unwrap();
    let column = |i: usize| net.points[i][0].clone().map(|x| x.as_rational().unwrap().to_string());
    assert_eq!(column(0), ["1", "0", "3", "1"]);
    // `1 -1` are two entries, `0 - 0` is one, `2*1 +3` are two.
    assert_eq!(column(1), ["-1", "2", "2", "1"]);
    assert_eq!(column(2), ["7", "3", "5", "1"]);
}

#[test]
fn matlab_that_is_no_net_is_refused() {
    let error = |text: &str| from_matlab(text, "", Convention::Homogeneous).unwrap_err().to_string();
    for (text, complaint) in [
        ("x", "1:1: expected an assignment, found `x`\n    1 | x\n      | ^"),
        (
            "c(:,:,0) = [1]",
            "1:1: expected a name, NAME(:,:,j) or NAME(i,j,:), indices from 1 to 33, found `c(:,:,0)`\n    1 | c(:,:,0) = [1]\n      | ^^^^^^^^^",
        ),
        (
            "c(:,:,1) = [1 2; 3 4]",
            "1:12: expected four rows: x, y, z and w, found `[1 2; 3 4]`\n    1 | c(:,:,1) = [1 2; 3 4]\n      |            ^^^^^^^^^^",
        ),
        (
            "c(:,:,1) = [1; 2; 3; 4 5]",
            "1:12: expected four rows of one length, found `[1; 2; 3; 4 5]`\n    1 | c(:,:,1) = [1; 2; 3; 4 5]\n      |            ^^^^^^^^^^^^^^",
        ),
        (
            "c(1,1,:) = [1 2 3]",
            "1:12: expected four numbers: x, y, z and w, found `[1 2 3]`\n    1 | c(1,1,:) = [1 2 3]\n      |            ^^^^^^^",
        ),
        (
            "s = sqrt(2) * t",
            "1:15: `t` is none of the unknowns, expected numbers only\n    1 | s = sqrt(2) * t\n      |               ^",
        ),
        ("c(2,2,:) = [1 2 3 4]", "control point (1, 1) is missing"),
        ("", "0 × 0 points, expected from 2 × 2 to 33 × 33"),
    ] {
        assert_eq!(error(text), complaint, "{text}");
    }
}
