//! Covers that are long to follow: patches on the sphere of any degree, with numbers of any length.

use super::attack::{ALL, Attack, End, FEW, ends, statement};

/// A polynomial in one parameter, by exponents.
type Univariate = Vec<i128>;

fn times(a: &[i128], b: &[i128]) -> Univariate {
    let mut product = vec![0; a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            product[i + j] += x * y;
        }
    }
    product
}

fn binomial(n: usize, k: usize) -> i128 {
    (0..k).fold(1, |product, i| product * (n - i) as i128 / (i + 1) as i128)
}

/// (2p, 2q, p² + q² − 1, p² + q² + 1) for p(t) and q(s) of degree d, bidegree (2d, 2d): all on the sphere.
fn stereographic(degree: usize, entry: &dyn Fn(usize) -> i128) -> String {
    let p: Univariate = (0..=degree).map(entry).collect();
    let square = times(&p, &p);
    let m = 2 * degree;
    let at = |list: &[i128], k: usize| list.get(k).copied().unwrap_or(0);
    // A homogeneous polynomial in t and s: Σ C(m,i) C(m,j) X_ij tⁱ sʲ. Degrees are raised by powers of (1 +
    // t), (1 + s): none here.
    let coordinate = |i: usize, j: usize, k: usize| -> i128 {
        let (of_t, of_s) = (if j == 0 { at(&p, i) } else { 0 }, if i == 0 { at(&p, j) } else { 0 });
        let squares = if j == 0 { at(&square, i) } else { 0 } + if i == 0 { at(&square, j) } else { 0 };
        let one = i128::from(i == 0 && j == 0);
        [2 * of_t, 2 * of_s, squares - one, squares + one][k]
    };
    let point = |i: usize, j: usize| {
        let entries: Vec<String> = (0..4)
            .map(|k| format!("\"{}/{}\"", coordinate(i, j, k), binomial(m, i) * binomial(m, j)))
            .collect();
        format!("[{}]", entries.join(", "))
    };
    let row = |i: usize| (0..=m).map(|j| point(i, j)).collect::<Vec<_>>().join(", ");
    let rows: Vec<String> = (0..=m).map(|i| format!("[{}]", row(i))).collect();
    let lines = format!("convention = \"homogeneous\"\nbidegree = [{m}, {m}]\nnet = [{}]", rows.join(",\n"));
    statement("", &[], &lines)
}

fn attack(statement: String, tree: &str) -> Attack {
    let lines = [
        "claim cover".to_owned(),
        format!("denominator {tree}"),
        "edge u=0 arc .".to_owned(),
        "edge u=1 arc .".to_owned(),
        "edge v=0 arc .".to_owned(),
        "edge v=1 arc .".to_owned(),
        "regular outward .".to_owned(),
    ];
    Attack::sealed(1, statement, &lines, tree.matches('.').count() + 5)
}

#[test]
fn patches_of_large_degrees() {
    ends("a patch of degree 2d", &[1, 4, 8], FEW, &End::Rejected("denominator: on box 1"), |degree| {
        attack(stereographic(degree, &|k| 1 - 2 * (k as i128 % 2)), ".")
    });
    ends("a patch of degree 32", &[16], ALL, &End::Rejected("denominator: on box 1"), |degree| {
        attack(stereographic(degree, &|k| 1_000_003 + 7 * k as i128), ".")
    });
}

#[test]
fn deep_trees() {
    let deep = |depth: usize| "h".repeat(depth) + &".".repeat(depth + 1);
    ends(
        "a deep tree",
        &[2, 100, 400_000],
        FEW,
        &End::Rejected("denominator: box 3 of the tree is halved"),
        |depth| attack(stereographic(2, &|k| 1 - 2 * (k as i128 % 2)), &deep(depth)),
    );
}
