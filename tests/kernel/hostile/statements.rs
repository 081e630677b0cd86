//! Statements that explode when they are read.

use prove_cap_kernel::exact::limits;

use super::attack::{ALL, Attack, End, FEW, OUT_OF_MEMORY, OUT_OF_WORK, ends, long_number, names, statement};

/// A certificate of another statement, which is all that is looked at of it.
const READ: End = End::Rejected("the certificate is for another statement");

fn system(radicands: &str, unknowns: usize, expression: &str) -> Attack {
    let lines = format!("polynomials = [\"{expression}\"]");
    Attack::of_statement(statement(radicands, &names(unknowns), &lines))
}

#[test]
fn powers_of_sums() {
    ends("a power of a sum", &[3, 30, 1000], FEW, &OUT_OF_WORK, |n| {
        system("", 4, &format!("(x0 + x1 + x2 + x3)^{n}"))
    });
    ends("a power of a sum of roots", &[3, 30, 1000], FEW, &OUT_OF_WORK, |n| {
        system("2, 3, 5, 7", 1, &format!("(1 + sqrt(2) + sqrt(3) + sqrt(5) + sqrt(7) + x0)^{n}"))
    });
    ends("powers of powers", &[2, 8, 32], FEW, &OUT_OF_WORK, |n| {
        system("", 4, &format!("((x0 + x1 + x2 + x3 + 1)^{n})^{n}"))
    });
    ends("a constant to high powers", &[10, 100, 1000], FEW, &End::Limit(limits::DIGITS), |n| {
        system("", 0, &format!("(2^{n})^{n}"))
    });
}

/// No power does this: the memory is that of a product of sums, with all its powers.
#[test]
fn products_with_long_power_products() {
    let product = |n: usize| {
        let pair = |k: usize| format!("(x{} + x{})", 2 * k, 2 * k + 1);
        system("", 2 * n, &(0..n).map(pair).collect::<Vec<_>>().join("*"))
    };
    ends("a product of sums", &[4, 10, 24], ALL, &End::Limit(limits::POWERS), product);
}

#[test]
fn many_short_summands() {
    ends("a sum of one letter", &[10, 1000, 100_000], FEW, &READ, |n| {
        let sum = vec!["x"; n].join("+");
        Attack::of_statement(statement("", &["x".to_owned()], &format!("polynomials = [\"{sum}\"]")))
    });
    ends("a sum of one digit", &[10, 1000, 100_000], FEW, &READ, |n| system("", 0, &vec!["1"; n].join("+")));
}

#[test]
fn long_numbers() {
    ends("decimals", &[1, 10, 100], ALL, &READ, |n| {
        let decimal = |k| format!("0.{}", long_number(4000, k));
        system("", 0, &(0..n).map(decimal).collect::<Vec<_>>().join("*0 + "))
    });
    ends("denominators without common factors", &[2, 20, 60], FEW, &OUT_OF_WORK, |n| {
        let quotient = |k| format!("x0/{}", long_number(2000, k));
        system("", 1, &(0..n).map(quotient).collect::<Vec<_>>().join(" + "))
    });
    ends("a constant in many places", &[10, 100, 400_000], ALL, &OUT_OF_MEMORY, |n| {
        let lines = format!(
            "polynomials = [\"{}\"]\n[define]\nc = \"{}\"",
            vec!["c"; n].join("+"),
            long_number(4000, 1)
        );
        Attack::of_statement(
            statement("", &[], &lines).replace("polynomials", "nonzero = [\"c\"]\npolynomials"),
        )
    });
}

#[test]
fn many_values_of_toml() {
    ends("rows without points", &[10, 1000, 100_000], FEW, &End::Refused("the net has 100000 rows"), |n| {
        let net = vec!["[]"; n].join(",");
        let lines = format!("convention = \"homogeneous\"\nbidegree = [1, 1]\nnet = [{net}]");
        Attack::of_statement(statement("", &[], &lines))
    });
    ends("tables in tables", &[1, 100, 2500], FEW, &End::Refused("the net has 2500 rows"), |n| {
        let deep = format!("{{{}=1}}", vec!["a"; 70].join("."));
        let lines =
            format!("convention = \"homogeneous\"\nbidegree = [1, 1]\nnet = [{}]", vec![deep; n].join(","));
        Attack::of_statement(statement("", &[], &lines))
    });
    ends("constants", &[10, 1000, 50_000], ALL, &READ, |n| {
        let constants: String = (0..n).map(|k| format!("c{k} = 1\n")).collect();
        Attack::of_statement(statement("", &names(1024), &format!("polynomials = []\n[define]\n{constants}")))
    });
    ends("radicands", &[10, 1000, 100_000], FEW, &End::Refused("radicands, expected at most 4"), |n| {
        Attack::of_statement(statement(&vec!["2"; n].join(","), &[], "polynomials = []"))
    });
}

/// All that is assumed stands in the sentence: here with long names.
#[test]
fn assumptions_that_are_long_to_say() {
    let long = |n: usize| {
        let unknowns: Vec<String> = (0..5).map(|k| format!("x{k}{}", "_".repeat(30))).collect();
        let lines = format!("nonzero = [\"({})^{n}\"]\npolynomials = [\"1\"]", unknowns.join(" + "));
        let lines_of_proof = ["claim impossible", "step 1", "add f[1] times 1", "conclude 1", "end 1"];
        Attack::new(statement("", &unknowns, &lines), &lines_of_proof.map(String::from))
    };
    ends("an assumption", &[2, 8, 20], ALL, &End::Verified, long);
}

/// A net of the largest degrees on a surface of the largest degree, every number an unknown or long.
#[test]
fn large_patches() {
    let patch = |m: usize, entry: &dyn Fn(usize) -> String, unknowns: usize| {
        let point = |k: usize| {
            format!("[{}, {}, {}, {}]", entry(4 * k), entry(4 * k + 1), entry(4 * k + 2), entry(4 * k + 3))
        };
        let row = |i: usize| (0..=m).map(|j| point(i * (m + 1) + j)).collect::<Vec<_>>().join(", ");
        let rows: Vec<String> = (0..=m).map(|i| format!("[{}]", row(i))).collect();
        let lines = format!(
            "surface = \"X^8 + Y^8 + Z^8 - W^8 + X*Y*Z*W^5\"\nconvention = \"homogeneous\"\nbidegree = [{m}, {m}]\nnet = [{}]",
            rows.join(",\n")
        );
        let lines_of_proof = ["claim impossible", "step 1", "add c[0,0] times 1", "conclude 1", "end 1"];
        Attack::new(statement("", &names(unknowns), &lines), &lines_of_proof.map(String::from))
    };
    ends("a net of unknowns", &[1, 2, 8], FEW, &OUT_OF_WORK, |m| {
        patch(m, &|k| format!("\"x{k}\""), 4 * (m + 1) * (m + 1))
    });
    ends("a net of numbers", &[1, 4, 32], FEW, &OUT_OF_WORK, |m| {
        patch(m, &|k| format!("\"{}\"", long_number(60, k)), 0)
    });
}
