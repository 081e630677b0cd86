//! Arguments over all values of the unknowns that are long to follow.

use prove_cap_kernel::exact::limits;

use super::attack::{ALL, Attack, End, FEW, OUT_OF_MEMORY, OUT_OF_WORK, ends, long_number, names, statement};

/// A bilinear patch in the plane X = 0 but for one number.
fn bilinear(unknowns: usize, x: &str) -> String {
    let lines = format!(
        "surface = \"X\"\nconvention = \"homogeneous\"\nbidegree = [1, 1]\n\
         net = [[[\"{x}\", 0, 0, 1], [0, 0, 0, 1]], [[0, 0, 0, 1], [0, 0, 0, 1]]]"
    );
    statement("", &names(unknowns), &lines)
}

struct Argument {
    before: Vec<String>,
    range: String,
    samples: Vec<String>,
    first: Vec<String>,
    others: String,
}

impl Argument {
    fn new(first: Vec<String>) -> Self {
        let samples = ["0 0", "1 1"].map(String::from).to_vec();
        let others = "exclude 1*lower[1]".to_owned();
        Argument { before: vec![], range: "1".to_owned(), samples, first, others }
    }

    fn attack(self, statement: String, unknowns: usize) -> Attack {
        let version = if self.before.iter().any(|line| line.starts_with("put")) { 2 } else { 1 };
        let mut lines = ["claim unreachable", "quantity ratio 0", "between 0 1"].map(String::from).to_vec();
        lines.extend(self.before);
        lines.push(format!("range {}", self.range));
        lines.extend((1..).zip(self.samples).map(|(k, odds)| format!("sample {k} at {odds}")));
        lines.push("chart 1".to_owned());
        lines.extend(self.first);
        for chart in 2..=2 * unknowns + 1 {
            lines.extend([format!("chart {chart}"), self.others.clone()]);
        }
        let boxes = lines.iter().filter(|line| line.starts_with("exclude")).count();
        Attack::sealed(version, statement, &lines, boxes)
    }
}

fn sum(names: &[String], power: usize) -> String {
    names.iter().map(|name| format!("-{name}^{power}")).collect::<String>()
}

/// 370 bytes that once took 106 seconds: what is put on an interval has the square of the degree of entries.
#[test]
fn a_power_of_one_unknown() {
    let first = || ["halve", "exclude 1*lower[1]", "exclude 1*lower[1]"].map(String::from).to_vec();
    ends("x^n", &[2, 100, 1000], ALL, &End::Verified, |n| {
        Argument::new(first()).attack(bilinear(1, &format!("-x0^{n}")), 1)
    });
}

/// 1,024 intervals for a box, and as many exponents for a term, once came to 3.3 GB.
#[test]
fn many_unknowns() {
    ends("boxes of n unknowns", &[1, 32, 1024], FEW, &End::Rejected("chart 1: on box"), |n| {
        let halvings = 4 * n;
        let mut first = vec!["halve".to_owned(); halvings];
        first.extend(vec!["exclude 1*lower[1]".to_owned(); halvings + 1]);
        Argument::new(first).attack(bilinear(n, "-x0"), n)
    });
    ends("samples of n unknowns", &[1, 32, 1024], FEW, &OUT_OF_WORK, |n| {
        let terms: Vec<String> = (1..=200).map(|k| format!("1*lower[{k}]")).collect();
        let mut argument = Argument::new(vec![format!("exclude {}", terms.join(" + "))]);
        argument.samples = (1..=200).map(|k| format!("{k} 1")).collect();
        argument.attack(bilinear(n, &sum(&names(n), 1)), n)
    });
    ends("samples of many terms", &[10, 100, 8000], ALL, &OUT_OF_MEMORY, |n| {
        let terms: Vec<String> = (1..=n).map(|k| format!("1*lower[{k}]")).collect();
        let mut argument = Argument::new(vec![format!("exclude {}", terms.join(" + "))]);
        argument.samples = (1..=n).map(|k| format!("{k} 1")).collect();
        argument.attack(bilinear(2, "-(x0 + x1 + 1)^40"), 2)
    });
}

/// Forms are dense: a number for each combination of exponents.
#[test]
fn dense_forms() {
    let exclude = || vec!["exclude 1*lower[1]".to_owned()];
    ends("squares of n unknowns", &[1, 4, 20], FEW, &OUT_OF_WORK, |n| {
        Argument::new(exclude()).attack(bilinear(n, &sum(&names(n), 2)), n)
    });
    ends("two unknowns of degree n", &[2, 30, 400], ALL, &End::Rejected("chart 1: on box 1"), |n| {
        Argument::new(exclude()).attack(bilinear(2, &format!("-x0^{n}-x1^100")), 2)
    });
    ends("three unknowns of degree n", &[2, 30, 300], ALL, &OUT_OF_MEMORY, |n| {
        Argument::new(exclude()).attack(bilinear(3, &format!("-x0^{n}-x1^{n}-x2^{n}")), 3)
    });
}

#[test]
fn many_boxes() {
    ends("a tree of n boxes", &[2, 100, 400_000], FEW, &OUT_OF_WORK, |n| {
        let mut first = vec!["halve".to_owned(); n];
        first.extend(vec!["exclude 1*lower[1]".to_owned(); n + 1]);
        Argument::new(first).attack(bilinear(1, "-x0^2"), 1)
    });
    ends("halves of halves", &[2, 100, 600_000], ALL, &OUT_OF_MEMORY, |n| {
        // The numbers of an interval grow with its depth: no box is ever excluded.
        let mut first = vec!["halve".to_owned(); n];
        first.extend(vec!["exclude 1*lower[2]".to_owned(); n + 1]);
        Argument::new(first).attack(bilinear(1, "-x0^2"), 1)
    });
}

#[test]
fn long_numbers() {
    let exclude = || vec!["exclude 1*lower[1]".to_owned()];
    ends("a long range", &[1, 100, 4000], FEW, &End::Limit(limits::BITS), |digits| {
        let mut argument = Argument::new(exclude());
        argument.range = long_number(digits, 1);
        argument.attack(bilinear(1, "-x0^100"), 1)
    });
    ends("long odds", &[1, 100, 4000], FEW, &End::Rejected("chart 1: on box 1"), |digits| {
        let mut argument = Argument::new(exclude());
        argument.samples[0] = format!("1/{} 1/{}*h", long_number(digits, 1), long_number(digits, 2));
        argument.others = "exclude 1*lower[1] + 1*lower[2]".to_owned();
        argument.attack(bilinear(1, "-x0^2"), 1)
    });
    ends("many long factors", &[1, 10, 100], ALL, &End::Verified, |n| {
        let terms: Vec<String> = (1..=n).map(|k| format!("{}*lower[{k}]", long_number(4000, k))).collect();
        let exclude = format!("exclude {}", terms.join(" + "));
        let mut argument = Argument::new(vec!["halve".to_owned(), exclude.clone(), exclude]);
        argument.samples = (0..n).map(|_| "0 0".to_owned()).collect();
        argument.attack(bilinear(1, "-x0^2"), 1)
    });
}

#[test]
fn many_products_and_forms() {
    ends("n products", &[2, 32, 1000], FEW, &End::Rejected("the equations are not polynomials"), |n| {
        let mut argument = Argument::new(vec!["exclude 1*lower[1]".to_owned()]);
        argument.before = (0..n).map(|_| "product x0*x1".to_owned()).collect();
        argument.attack(bilinear(n, &sum(&names(n), 1)), n)
    });
    ends("n forms", &[2, 32, 1000], FEW, &End::Verified, |n| {
        let mut argument = Argument::new(vec!["exclude 1*lower[1]".to_owned()]);
        argument.before = (0..n).map(|k| format!("put x{k} = 2*x{k}")).collect();
        argument.attack(bilinear(n, "-1"), n)
    });
    ends("forms of n unknowns", &[2, 32, 1000], FEW, &OUT_OF_WORK, |n| {
        let mut argument = Argument::new(vec!["exclude 1*lower[1]".to_owned()]);
        argument.before = (0..n).map(|k| format!("put x{k} = 2*{}", names(n)[k..].join(" + "))).collect();
        argument.attack(bilinear(n, "-x0^3"), n)
    });
}
