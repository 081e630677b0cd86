//! Refutations that are long to replay.

use super::attack::{ALL, Attack, End, FEW, OUT_OF_WORK, ends, long_number, names, statement};

fn system(unknowns: usize, polynomials: &[String]) -> String {
    let quoted: Vec<String> = polynomials.iter().map(|polynomial| format!("\"{polynomial}\"")).collect();
    statement("", &names(unknowns), &format!("polynomials = [{}]", quoted.join(", ")))
}

fn attack(statement: String, steps: &[String]) -> Attack {
    let mut lines = vec!["claim impossible".to_owned()];
    lines.extend((1..).zip(steps).map(|(number, step)| format!("step {number}\n{step}")));
    lines.push(format!("end {}", steps.len()));
    Attack::new(statement, &lines)
}

/// x1^n·x0^m + …, in canonical order, all times a power of x0.
fn long_line(terms: usize, raised: usize) -> String {
    let mut all: Vec<(usize, usize)> = (0..terms).map(|k| (k % 40 + raised, k / 40)).collect();
    all.sort_by_key(|(a, b)| std::cmp::Reverse((a + b, *a)));
    let power = |name: &str, exponent: usize| match exponent {
        0 => String::new(),
        1 => name.to_owned(),
        _ => format!("{name}^{exponent}"),
    };
    let term = |(a, b): (usize, usize)| match (power("x0", a), power("x1", b)) {
        (one, none) if none.is_empty() => {
            if one.is_empty() {
                "1".to_owned()
            } else {
                one
            }
        }
        (none, one) if none.is_empty() => one,
        (one, other) => format!("{one}*{other}"),
    };
    all.into_iter().map(term).collect::<Vec<_>>().join(" + ")
}

#[test]
fn products_of_long_polynomials() {
    ends("a square of a long polynomial", &[10, 1000, 30_000], FEW, &OUT_OF_WORK, |terms| {
        let (long, longer) = (long_line(terms, 0), long_line(terms, 1));
        let first = format!("add f[1] times {long}\nconclude {longer}");
        attack(system(2, &["x0".to_owned()]), &[first, format!("add step 1 times {long}\nconclude 1")])
    });
}

/// Every premise is looked up among all that there are.
#[test]
fn many_premises() {
    ends(
        "a sum over all equations",
        &[10, 100, 1000],
        FEW,
        &End::Rejected("step 1: the conclusion is wrong"),
        |n| {
            let polynomials: Vec<String> = (1..=n).map(|k| format!("x0 + x1^2 + {k}")).collect();
            let adds: Vec<String> = (1..=n).map(|k| format!("add f[{k}] times {}*x1", k + 1)).collect();
            attack(system(2, &polynomials), &[format!("{}\nconclude 1", adds.join("\n"))])
        },
    );
    ends(
        "many short steps",
        &[10, 1000, 100_000],
        ALL,
        &End::Rejected("step 1: no later step uses it"),
        |n| {
            let mut steps: Vec<String> = (1..=n)
                .map(|k| format!("add f[1] times {}\nconclude {}", multiple(k, "x1"), multiple(k, "x0*x1")))
                .collect();
            steps[n - 1] = "add f[2] times 1\nconclude 1".to_owned();
            attack(system(2, &["x0".to_owned(), "1".to_owned()]), &steps)
        },
    );
}

fn multiple(k: usize, product: &str) -> String {
    if k == 1 { product.to_owned() } else { format!("{k}*{product}") }
}

#[test]
fn long_numbers() {
    ends("long multipliers", &[10, 100, 2000], FEW, &End::Rejected("step 1: the conclusion is wrong"), |n| {
        let adds = |k| format!("add f[{k}] times {}*x0", long_number(n.min(4000), k));
        let polynomials: Vec<String> = (1..=20).map(|k| format!("x0 + {k}")).collect();
        attack(
            system(1, &polynomials),
            &[format!("{}\nconclude 1", (1..=20).map(adds).collect::<Vec<_>>().join("\n"))],
        )
    });
    ends("denominators without common factors", &[2, 20, 400], FEW, &OUT_OF_WORK, |n| {
        let adds = |k| format!("add f[{k}] times 1/{}", long_number(4000, k));
        let polynomials: Vec<String> = (1..=n).map(|k| format!("x0 + {k}")).collect();
        attack(
            system(1, &polynomials),
            &[format!("{}\nconclude 1", (1..=n).map(adds).collect::<Vec<_>>().join("\n"))],
        )
    });
}

/// Ten megabytes of terms, and of numbers.
#[test]
fn long_files() {
    ends("many long lines", &[1, 4, 12], ALL, &End::Rejected("step 1: the conclusion is wrong"), |n| {
        let long = long_line(30_000, 0);
        let step = format!("add f[1] times {long}\nconclude {long}");
        attack(system(2, &["x0".to_owned()]), &vec![step; n])
    });
    ends("many short terms", &[1, 10, 60], ALL, &End::Rejected("step 1: the conclusion is wrong"), |n| {
        let letters: Vec<String> = ('a'..='z').chain('A'..='N').map(String::from).collect();
        let triples =
            (0..40).flat_map(|i| (i + 1..40).flat_map(move |j| (j + 1..40).map(move |k| [i, j, k])));
        let short = triples
            .map(|triple| triple.map(|k| letters[k].as_str()).join("*"))
            .collect::<Vec<_>>()
            .join(" + ");
        let step = format!("add f[1] times {short}\nconclude {short}");
        attack(statement("", &letters, "polynomials = [\"a\"]"), &vec![step; n])
    });
    ends("many long numbers", &[10, 100, 400], ALL, &End::Rejected("step 1: the conclusion is wrong"), |n| {
        let step = |k| {
            format!("add f[1] times {}*x0\nconclude {}*x0", long_number(4000, k), long_number(4000, k + 1))
        };
        attack(system(1, &["x0".to_owned()]), &(1..=n).map(step).collect::<Vec<_>>())
    });
    ends("many long fractions", &[10, 100, 1200], FEW, &OUT_OF_WORK, |n| {
        let step = |k| format!("add f[1] times 1/{}\nconclude x0", long_number(4000, k));
        attack(system(1, &["x0".to_owned()]), &(1..=n).map(step).collect::<Vec<_>>())
    });
}
