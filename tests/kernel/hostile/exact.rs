//! Values that are long to try.

use prove_cap_kernel::exact::limits;

use super::attack::{Attack, End, FEW, OUT_OF_WORK, ends, long_number, names, statement};

fn attack(statement: String, values: &[String]) -> Attack {
    let mut lines = vec!["claim exact".to_owned()];
    lines.extend((0..).zip(values).map(|(k, value)| format!("value x{k} = {value}")));
    lines.push(format!("end {}", values.len()));
    Attack::new(statement, &lines)
}

#[test]
fn high_powers() {
    let power = |digits: usize, exponent: usize| {
        let lines = format!("polynomials = [\"x0^{exponent} - x0^{}\"]", exponent - 1);
        attack(statement("", &names(1), &lines), &[long_number(digits, 1)])
    };
    ends("a power of 1 digit", &[2, 10, 1000], FEW, &End::Rejected("f[1] does not vanish"), |n| power(2, n));
    ends("a power of a long number", &[2, 10, 1000], FEW, &End::Limit(limits::BITS), |n| power(400, n));
}

/// Every term with all roots of the largest field.
#[test]
fn roots() {
    let value = |digits: usize| {
        let roots =
            ["", "*sqrt(2)", "*sqrt(3)", "*sqrt(6)", "*sqrt(5)", "*sqrt(10)", "*sqrt(15)", "*sqrt(30)"];
        let terms = roots.iter().enumerate().map(|(k, root)| format!("{}{root}", long_number(digits, k)));
        terms.collect::<Vec<_>>().join(" + ")
    };
    ends("numbers with all roots", &[1, 10, 400], FEW, &OUT_OF_WORK, |n| {
        let polynomials: Vec<String> = (0..n).map(|k| format!("\"(x0 + {k})^20*x1\"")).collect();
        let lines = format!("polynomials = [{}]", polynomials.join(", "));
        attack(statement("2, 3, 5", &names(2), &lines), &["1".replace('1', &value(100)), "0".to_owned()])
    });
    // All weights are compared with 0, exactly.
    ends("signs of numbers with all roots", &[1, 10, 300], FEW, &End::Verified, |n| {
        let point = format!("[0, 0, 0, \"{}\"]", value(n));
        let lines = format!(
            "surface = \"Z\"\nconvention = \"homogeneous\"\nbidegree = [1, 1]\nnet = [[{point}, {point}], [{point}, {point}]]"
        );
        attack(statement("2, 3, 5", &[], &lines), &[])
    });
}

#[test]
fn many_unknowns_and_equations() {
    ends("a long product", &[2, 20, 1000], FEW, &End::Rejected("f[1] does not vanish"), |n| {
        let product = names(n).join("*");
        attack(statement("", &names(n), &format!("polynomials = [\"{product}\"]")), &vec!["2".to_owned(); n])
    });
    ends("many equations", &[2, 20, 500], FEW, &End::Verified, |n| {
        let polynomials = vec!["\"x0^20 - x0\""; n].join(", ");
        attack(statement("", &names(1), &format!("polynomials = [{polynomials}]")), &["1".to_owned()])
    });
}
