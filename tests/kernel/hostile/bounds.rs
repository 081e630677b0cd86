//! Enclosures that are long to follow.

use prove_cap_kernel::exact::limits;

use super::attack::{Attack, End, FEW, OUT_OF_WORK, ends, long_number, statement};

/// x = y = 0, z the sum of the parameters' squares plus 1, bidegree (m, m), on the plane or sphere.
fn patch(m: usize, surface: &str, entry: &dyn Fn(usize) -> String) -> String {
    let point = |k: usize| format!("[0, 0, \"{}\", 1]", entry(k));
    let row = |i: usize| (0..=m).map(|j| point(i * (m + 1) + j)).collect::<Vec<_>>().join(", ");
    let rows: Vec<String> = (0..=m).map(|i| format!("[{}]", row(i))).collect();
    let lines = format!(
        "surface = \"{surface}\"\nconvention = \"homogeneous\"\nbidegree = [{m}, {m}]\nnet = [{}]",
        rows.join(",\n")
    );
    statement("", &[], &lines)
}

struct Trees {
    denominator: String,
    lower: String,
}

fn attack(statement: String, places: usize, [lower, upper]: [&str; 2], at: &str, trees: &Trees) -> Attack {
    let decimal =
        |whole: &str| if places == 0 { whole.to_owned() } else { format!("{whole}.{}", "0".repeat(places)) };
    let (lower, upper) = (decimal(lower), decimal(upper));
    let Trees { denominator, lower: tree } = trees;
    let lines = [
        "claim bounds".to_owned(),
        format!("quantity ratio {places}"),
        format!("denominator {denominator}"),
        format!("lower {lower} at {at} over {tree}"),
        format!("upper {upper} at {at} over ."),
    ];
    let boxes = [denominator, tree].iter().map(|tree| tree.matches('.').count()).sum::<usize>() + 1;
    Attack::sealed(1, statement, &lines, boxes)
}

/// Halved again and again at one corner.
fn deep(depth: usize) -> String {
    "h".repeat(depth) + &".".repeat(depth + 1)
}

/// Halved everywhere.
fn wide(depth: usize) -> String {
    if depth == 0 { ".".to_owned() } else { format!("h{}{}", wide(depth - 1), wide(depth - 1)) }
}

fn plain() -> Trees {
    Trees { denominator: ".".to_owned(), lower: ".".to_owned() }
}

/// z = −1 at a corner and 1 elsewhere: there the coefficients keep both signs, however small the box.
#[test]
fn deep_trees() {
    let corner = |m: usize| patch(m, "Z", &|k| if k == 0 { "0".to_owned() } else { k.to_string() });
    let trees = |depth| Trees { denominator: ".".to_owned(), lower: deep(depth) };
    ends(
        "a deep tree",
        &[2, 100, 400_000],
        FEW,
        &End::Rejected("lower: box 1 of the tree is halved"),
        |depth| attack(corner(2), 0, ["0", "9"], "0 0", &trees(depth)),
    );
    let negative = |m: usize| patch(m, "Z", &|k| if k == 0 { "-1".to_owned() } else { "1".to_owned() });
    ends("a deep tree at a negative corner", &[2, 100, 400_000], FEW, &OUT_OF_WORK, |depth| {
        attack(negative(2), 0, ["0", "9"], "0 0", &trees(depth))
    });
    ends("the same of large degrees", &[2, 100, 400_000], FEW, &OUT_OF_WORK, |depth| {
        attack(negative(16), 0, ["0", "9"], "0 0", &trees(depth))
    });
}

/// z = 1/3 somewhere inside: every box that is halved may have to be.
#[test]
fn wide_trees() {
    ends("a wide tree", &[1, 4, 19], FEW, &End::Rejected("lower: box 1 of the tree is halved"), |depth| {
        let trees = Trees { denominator: ".".to_owned(), lower: wide(depth.min(18)) };
        attack(patch(1, "Z", &|k| (k + 1).to_string()), 0, ["1", "9"], "0 0", &trees)
    });
}

#[test]
fn large_degrees_and_long_numbers() {
    let numbers = |m: usize, digits: usize| patch(m, "Z^8 + Z*W^7 + W^8", &|k| long_number(digits, k));
    ends("degree 256 in both parameters", &[1, 4, 32], FEW, &OUT_OF_WORK, |m| {
        attack(numbers(m, 20), 0, ["0", "1"], "1/3 1/7", &plain())
    });
    ends("many places", &[1, 100, 1000], FEW, &End::Rejected("lower: the stated point"), |places| {
        attack(numbers(2, 4), places, ["0", "1"], "1/3 1/7", &plain())
    });
    ends("a point with long numbers", &[2, 100, 4000], FEW, &End::Limit(limits::BITS), |digits| {
        let at = format!("1/{} 1/{}", long_number(digits, 1), long_number(digits, 2));
        attack(numbers(2, 4), 0, ["0", "1"], &at, &plain())
    });
}
