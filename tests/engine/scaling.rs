//! Enclosures do not depend on the scale of homogeneous coordinates, nor on how the square is parametrised; and they are found
//! wherever an extreme lies.

use num_bigint::BigInt;
use num_rational::BigRational;
use prove_cap::approximation::{Enclosure, EnclosureError, enclose};
use prove_cap::catalogue;
use prove_cap::certificate::{Bounds, spell_decimal};
use prove_cap::control::Control;
use prove_cap::exact::{Arithmetic, Polynomial, Work};
use prove_cap::statement::{Statement, Subject};

/// Positive elements of Q(√2), tiny, huge, and units.
const FACTORS: [&str; 7] = [
    "1/10^40",
    "10^40",
    "(sqrt(2) - 1)^200",
    "(sqrt(2) + 1)^200",
    "(sqrt(2) - 1)^60/7^50",
    "17/3",
    "(3 - 2*sqrt(2))/10^9",
];

/// The statement with row i of its net multiplied by `row`^i and everything by `all`, homogeneous, at these values.
fn multiplied(statement: &Statement, values: &[Polynomial], all: &str, row: &str) -> Statement {
    let Subject::Patch(patch) = statement.subject() else { panic!("a patch") };
    let ring = statement.ring();
    let entry = |i: usize, entry: &Polynomial| {
        let value = Arithmetic::new(statement.field(), &mut Work::full()).substitute(entry, values).unwrap();
        format!("\"({})*({all})*({row})^{i}\"", ring.spell(&value))
    };
    let rows: Vec<String> = (0..)
        .zip(&patch.net)
        .map(|(i, points)| {
            let points =
                points.iter().map(|point| format!("[{}]", point.each_ref().map(|x| entry(i, x)).join(", ")));
            format!("[{}]", points.collect::<Vec<_>>().join(", "))
        })
        .collect();
    let radicands: Vec<String> = statement.field().values().iter().map(u32::to_string).collect();
    let (m, n) = patch.bidegree;
    Statement::read(&format!(
        "title = \"t\"\nradicands = [{}]\nunknowns = []\nconvention = \"homogeneous\"\nbidegree = [{m}, {n}]\n\
         surface = \"{}\"\nnet = [{}]\n",
        radicands.join(", "),
        statement.coordinate_ring().spell(&patch.surface),
        rows.join(",\n")
    ))
    .unwrap_or_else(|error| panic!("{error}"))
}

fn enclosed(statement: &Statement, values: &[Polynomial], places: u32) -> Enclosure {
    enclose(statement, values, places, &Control::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn spelled(bounds: &Bounds) -> [String; 2] {
    [&bounds.lower, &bounds.upper].map(|end| spell_decimal(&end.bound, bounds.places))
}

/// Patches of several kinds, over Q(√2) at least, with values for their unknowns.
fn patches() -> Vec<(Statement, Vec<Polynomial>)> {
    let built_in = |name: &str, values: &[&str]| {
        let statement = Statement::read(&catalogue::find(name).unwrap().statement()).unwrap();
        let constant =
            |text: &&str| Statement::read_constant(text, statement.field(), &mut Work::full()).unwrap();
        let values = values.iter().map(constant).collect();
        (statement, values)
    };
    let own = |text: &str| (Statement::read(text).unwrap(), vec![]);
    vec![
        built_in("cap-2x2", &["1/2", "4*sqrt(3)/3"]),
        built_in("cap-2x2", &["sqrt(3)/3 + sqrt(2)/2 - sqrt(6)/3", "2"]),
        built_in("cap-4x2-exact", &[]),
        own(&bilinear("(X^2 + Y^2 + Z^2 - W^2)^4", ["0", "0", "1"], "1")),
        own(&bilinear("X + 2*Y - W/3", ["1/3", "2/3", "2/3"], "sqrt(2)/1000")),
    ]
}

/// Three corners on the axes, the fourth with this place and weight.
fn bilinear(surface: &str, [x, y, z]: [&str; 3], weight: &str) -> String {
    format!(
        "title = \"t\"\nradicands = [2]\nunknowns = []\nconvention = \"cartesian\"\nbidegree = [1, 1]\n\
         surface = \"{surface}\"\nnet = [[[1, 0, 0, 1], [0, 1, 0, 1]], [[0, 0, 1, 1], [\"{x}\", \"{y}\", \"{z}\", \"{weight}\"]]]\n"
    )
}

#[test]
fn a_factor_of_all_coordinates_changes_nothing() {
    for (statement, values) in patches() {
        let plain = enclosed(&multiplied(&statement, &values, "1", "1"), &[], 12);
        for factor in FACTORS {
            let scaled = enclosed(&multiplied(&statement, &values, factor, "1"), &[], 12);
            // Bounds, places and trees.
            assert_eq!(scaled.bounds, plain.bounds, "{}: {factor}", statement.title());
            assert_eq!(scaled.attained, plain.attained);
        }
    }
}

#[test]
fn a_factor_that_is_too_long_to_be_divided_out_changes_no_bound() {
    let (statement, values) = patches().swap_remove(0);
    let plain = enclosed(&multiplied(&statement, &values, "1", "1"), &[], 12);
    let scaled =
        enclosed(&multiplied(&statement, &values, "(7*sqrt(2) + 11*sqrt(3) - 5)^1000", "1"), &[], 12);
    assert_eq!(spelled(&scaled.bounds), spelled(&plain.bounds));
}

#[test]
fn another_parameter_of_the_square_changes_no_bound() {
    for (statement, values) in patches() {
        let plain = enclosed(&multiplied(&statement, &values, "1", "1"), &[], 12);
        // u ↦ λu/(1 − u + λu) multiplies row i by λⁱ.
        for factor in ["1/1000", "3", "(sqrt(2) - 1)^4"] {
            let other = enclosed(&multiplied(&statement, &values, "1", factor), &[], 12);
            for (own, plain) in [
                (&other.bounds.lower.bound, &plain.bounds.lower.bound),
                (&other.bounds.upper.bound, &plain.bounds.upper.bound),
            ] {
                let difference = own - plain;
                assert!(
                    difference >= BigInt::from(-1) && difference <= BigInt::from(1),
                    "{}: {factor}: {:?}",
                    statement.title(),
                    spelled(&other.bounds)
                );
            }
        }
    }
}

#[test]
fn weights_of_any_size_are_positive() {
    let at = |weight: &str| {
        let text = bilinear("X^2 + Y^2 + Z^2 - W^2", ["1/3", "2/3", "2/3"], weight);
        enclose(&Statement::read(&text).unwrap(), &[], 12, &Control::default())
            .map(|found| spelled(&found.bounds))
    };
    for weight in ["1/10^40", "(sqrt(2) - 1)^200", "(3 - 2*sqrt(2))^150", "1/10^300"] {
        match at(weight) {
            // As the weight tends to 0, the least r tends to √3/3 = 0.57735026918962576…
            Ok(bounds) => assert_eq!(bounds, ["0.577350269189", "1.000000000000"], "{weight}"),
            // No halving gets that near to a corner: that is said, and nothing of a sign.
            Err(error) => assert!(matches!(error, EnclosureError::TooFine(_)), "{weight}: {error}"),
        }
    }
    for weight in ["10^40", "(sqrt(2) + 1)^200"] {
        match at(weight) {
            Ok([_, greatest]) => assert_eq!(greatest, "1.000000000000", "{weight}"),
            Err(error) => assert!(matches!(error, EnclosureError::TooFine(_)), "{weight}: {error}"),
        }
    }
}

#[test]
fn weights_that_are_not_positive_are_refused_at_a_place_where_that_is_so() {
    let error = |weight: &str| {
        let text = bilinear("X^2 + Y^2 + Z^2 - W^2", ["1/3", "2/3", "2/3"], weight);
        enclose(&Statement::read(&text).unwrap(), &[], 12, &Control::default()).unwrap_err().to_string()
    };
    let start = "the denominator W of the patch is";
    let vanishes = "; it is positive at u = v = 0, so that it vanishes in between";
    for weight in ["-1/10^40", "-(sqrt(2) - 1)^200", "7*sqrt(2) - 10"] {
        assert_eq!(
            error(weight),
            format!("{start} negative at u = 1, v = 1, expected positive on the whole square{vanishes}")
        );
    }
    assert_eq!(error("0"), format!("{start} 0 at u = 1, v = 1, expected positive on the whole square"));
}

/// Weights of 0 between positive ones: W = ((1 − u)² + u²)((1 − v)² + v²).
#[test]
fn a_weight_of_zero_is_no_zero_of_the_denominator() {
    let weights = ["1", "0", "1"];
    let rows = weights.map(|a| {
        let points = weights.map(|b| format!("[\"{a}\", \"{b}\", \"1\", \"{a}*{b}\"]"));
        format!("[{}]", points.join(", "))
    });
    let text = format!(
        "title = \"t\"\nradicands = []\nunknowns = []\nconvention = \"homogeneous\"\nbidegree = [2, 2]\nnet = [{}]\n",
        rows.join(", ")
    );
    let enclosure = enclosed(&Statement::read(&text).unwrap(), &[], 12);
    // At (1/2, 1/2) X = Y = 1/2, Z = 1 and W = 1/4: r = 2√6.
    assert_eq!(spelled(&enclosure.bounds), ["1.732050807568", "4.898979485567"]);
}

/// W = (3u − 1)² + (7v − 2)² + c, biquadratic.
fn well(c: &str) -> Statement {
    let (of_u, of_v) = (["1", "-2", "4"], ["4", "-10", "25"]);
    let rows = of_u.map(|a| {
        let points = of_v.map(|b| format!("[\"{a}\", \"{b}\", \"1\", \"({a}) + ({b}) + ({c})\"]"));
        format!("[{}]", points.join(", "))
    });
    Statement::read(&format!(
        "title = \"t\"\nradicands = [2]\nunknowns = []\nconvention = \"homogeneous\"\nbidegree = [2, 2]\nnet = [{}]\n",
        rows.join(", ")
    ))
    .unwrap()
}

#[test]
fn a_denominator_that_touches_zero_between_the_grid_lines_is_told_from_one_that_does_not() {
    let error = |c: &str| enclose(&well(c), &[], 3, &Control::default()).unwrap_err().to_string();
    assert_eq!(
        error("0"),
        "the denominator W of the patch is 0 at u = 1/3, v = 2/7, expected positive on the whole square"
    );
    assert!(
        error("-(sqrt(2) - 1)^200").contains("is negative at u = 1/3, v = 2/7"),
        "{}",
        error("-(sqrt(2) - 1)^200")
    );
    // Where it is positive, its enclosure is about something, or the boxes are too many; it is not refused.
    let positive = enclose(&well("(sqrt(2) - 1)^30"), &[], 1, &Control::default());
    assert!(!matches!(positive, Err(EnclosureError::Denominator { .. })), "{positive:?}");
}

/// x = y = 0, z = a + b·(3u − 1)² + b·(3v − 1)².
fn bowl(a: i64, b: i64) -> Statement {
    let square = [1, -2, 4];
    let rows = square.map(|s| {
        let points = square.map(|t| format!("[0, 0, \"{}\", 1]", a + b * (s + t)));
        format!("[{}]", points.join(", "))
    });
    Statement::read(&format!(
        "title = \"t\"\nradicands = []\nunknowns = []\nconvention = \"homogeneous\"\nbidegree = [2, 2]\nnet = [{}]\n",
        rows.join(", ")
    ))
    .unwrap()
}

#[test]
fn an_extreme_that_is_a_decimal_attained_inside_is_bounded_by_the_next_one() {
    let third = || BigRational::new(1.into(), 3.into());
    for places in [1, 2, 5, 12, 30] {
        let below = enclosed(&bowl(1, 1), &[], places);
        let one = BigInt::from(10).pow(places);
        assert_eq!(below.bounds.lower.bound, &one - 1, "{places}");
        assert_eq!(below.bounds.lower.at, [third(), third()]);
        assert_eq!((below.best, below.attained), ([false, true], [false, true]), "{places}");
        let above = enclosed(&bowl(9, -1), &[], places);
        assert_eq!(above.bounds.upper.bound, &one * 9 + 1, "{places}");
        assert_eq!(above.best, [true, false]);
    }
}

#[test]
fn a_flat_square_that_touches_the_sphere_is_bounded() {
    let square = |low: &str, high: &str| {
        Statement::read(&format!(
            "title = \"t\"\nradicands = [2]\nunknowns = []\nconvention = \"cartesian\"\nbidegree = [1, 1]\n\
             net = [[[\"{low}\", \"{low}\", 1, 1], [\"{low}\", \"{high}\", 1, 1]], [[\"{high}\", \"{low}\", 1, 1], \
             [\"{high}\", \"{high}\", 1, 1]]]\n"
        ))
        .unwrap()
    };
    for places in [1, 3, 12] {
        let enclosure = enclosed(&square("-1", "2"), &[], places);
        let [low, high] = spelled(&enclosure.bounds);
        assert_eq!(low, format!("0.{}", "9".repeat(places as usize)));
        assert_eq!(high, format!("3.{}", "0".repeat(places as usize)));
    }
    // However long the coordinates of the contact are.
    for (low, high) in
        [("-0.987131", "1.013313"), ("-1.2345678", "2.567"), ("-1/10^15", "1"), ("-10^9", "1/3")]
    {
        let enclosure = enclosed(&square(low, high), &[], 12);
        assert_eq!(spelled(&enclosure.bounds)[0], "0.999999999999", "{low} {high}");
        let strip = square(low, high);
        for factor in ["123457/1000003", "1/10^9", "10^15", "17/5"] {
            let again = enclosed(&multiplied(&strip, &[], "1", factor), &[], 6);
            assert_eq!(spelled(&again.bounds)[0], "0.999999", "{low} {high} {factor}");
        }
    }
    // At u = v = 1 − √2/2 no point that a certificate can name comes that near: undecided, in so many words.
    let error = enclose(&square("1 - sqrt(2)", "1"), &[], 6, &Control::default()).unwrap_err();
    assert!(matches!(error, EnclosureError::Unsettled { .. }), "{error}");
    assert_eq!(
        error.to_string(),
        "whether the least value lies beyond 1.000000 was not decided: it comes too near to it, around (u, v) = \
         (0.292893, 0.292893)"
    );
}

#[test]
fn a_patch_through_the_centre_of_the_sphere_comes_as_near_as_it_does() {
    for places in [1, 12] {
        let enclosure = enclosed(&bowl(0, 1), &[], places);
        assert_eq!(enclosure.bounds.lower.bound, BigInt::from(0), "{places}");
        assert!(enclosure.best[0], "{places}");
    }
    // Everything at the centre.
    let enclosure = enclosed(&bowl(0, 0), &[], 12);
    assert_eq!(spelled(&enclosure.bounds), ["0.000000000000", "0.000000000000"]);
}

#[test]
fn what_the_checker_cannot_expand_is_not_bounded() {
    let point = |i: usize, j: usize| format!("[\"{i}\", \"{j}\", \"{}\", \"1\"]", i * j + 1);
    let row = |i: usize| format!("[{}]", (0..33).map(|j| point(i, j)).collect::<Vec<_>>().join(", "));
    let net = (0..33).map(row).collect::<Vec<_>>().join(",\n");
    let text = format!(
        "title = \"large\"\nradicands = []\nunknowns = []\nconvention = \"homogeneous\"\nbidegree = [32, 32]\n\
         surface = \"X^8 + Y^8 + Z^8 - W^8\"\nnet = [{net}]\n"
    );
    let error = enclose(&Statement::read(&text).unwrap(), &[], 12, &Control::default()).unwrap_err();
    assert!(matches!(error, EnclosureError::Limit(_)), "{error}");
}
