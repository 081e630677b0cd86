//! The audit of listings: the paper's, mutilated ones, and claims that are false.

use proptest::prelude::*;
use prove_cap::audit::{Audit, Change, Finding, Judgement, PAPER, Relation};
use prove_cap::commands::{AuditedListing, Source};
use prove_cap::control::{Control, Why};
use prove_cap::exact::Polynomial;
use prove_cap::expand::{Basis, coefficients};
use prove_cap::formats::listing::{Listing, Notation};
use prove_cap::report::latex;
use prove_cap::statement::Statement;
use prove_cap::{catalogue, report};

fn statement(name: &str) -> Statement {
    Statement::read(&catalogue::find(name).unwrap().statement()).unwrap()
}

/// An audit against cap-2x2, to be printed.
fn page(listing: &Listing, statement: &Statement, audit: &Audit) -> AuditedListing {
    let (name, text) = ("cap-2x2".to_owned(), String::new());
    let source = Source { name, text, statement: statement.clone(), cap: true };
    AuditedListing { listing: listing.clone(), source, audit: audit.clone() }
}

fn audit(listing: &Listing, statement: &Statement) -> Audit {
    Audit::of(listing, statement, &Control::default()).unwrap_or_else(|error| panic!("{error}"))
}

fn wrong(audit: &Audit) -> Vec<&str> {
    audit.findings.iter().filter(|f| !f.agrees()).map(|f| f.label.as_str()).collect()
}

/// The paper's listing without its claims.
fn paper_formulas() -> Listing {
    Listing { claims: Vec::new(), ..Listing::from_toml(PAPER).unwrap() }
}

fn spell(polynomial: &Polynomial) -> String {
    statement("cap-2x2").ring().spell(polynomial)
}

#[test]
fn the_paper_misprints_three_coefficients() {
    let audit = audit(&paper_formulas(), &statement("cap-2x2"));
    assert_eq!(audit.findings.len(), 16);
    assert_eq!(wrong(&audit), ["a14", "a15", "a16"]);
    assert!(audit.unlisted.is_empty());
    let of = |label: &str| audit.findings.iter().find(|f| f.label.as_str() == label).unwrap();
    let differences = |label: &str| -> Vec<String> {
        let differences = &of(label).differences;
        differences.iter().map(|d| format!("{}: {}", spell(&d.powers), spell(&d.difference))).collect()
    };
    assert_eq!(differences("a14"), ["1: -40/3*sqrt(6)"]);
    assert_eq!(differences("a15"), ["w*z: 64/3*sqrt(3)"]);
    assert_eq!(differences("a16"), ["w*z: -16*sqrt(3)", "w: -16/3*sqrt(6)"]);
    let numbers = |label: &str| -> Vec<String> {
        let change = |change: &Change| match change {
            Change::Number { printed, right } => format!("{printed} -> {right}"),
            other => format!("{other:?}"),
        };
        of(label).corrections.iter().map(|correction| change(&correction.change)).collect()
    };
    assert_eq!(numbers("a14"), ["80/3 -> 40/3"]);
    assert_eq!(numbers("a15"), ["2/3 -> 1/3"]);
    assert_eq!(numbers("a16"), ["80/3 -> 32/3", "80/3 -> 64/3"]);
}

#[test]
fn the_papers_claims_come_out_as_they_must() {
    let audit = audit(&Listing::from_toml(PAPER).unwrap(), &statement("cap-2x2"));
    let with = |judgement: Judgement| -> Vec<&str> {
        audit.claims.iter().filter(|c| c.judgement == judgement).map(|c| c.claim.place.as_str()).collect()
    };
    assert_eq!(with(Judgement::Fails), ["Eq. 5, 6", "3.1", "3.1", "Eq. 18", "Eq. 19"]);
    assert!(with(Judgement::NotChecked).is_empty());
}

/// The paper's formulas with the three misprints mended, as one LaTeX text.
fn mended() -> String {
    let start = PAPER.find("\\begin{aligned}").unwrap();
    let end = PAPER.find("'''\n\n[names]").unwrap();
    let mut rows: Vec<String> = PAPER[start..end].lines().map(String::from).collect();
    let mut mend = |row: usize, from: &str, to: &str| {
        let (before, after) = rows[row].rsplit_once(from).unwrap();
        rows[row] = format!("{before}{to}{after}");
    };
    mend(14, r"\frac{80}{3}\sqrt{6}", r"\frac{40}{3}\sqrt{6}");
    mend(15, r"\frac{2}{3}\sqrt{3}", r"\frac{1}{3}\sqrt{3}");
    mend(16, r"\frac{80}{3}\sqrt{3}", r"\frac{32}{3}\sqrt{3}");
    mend(16, r"\frac{80}{3}\sqrt{6}", r"\frac{64}{3}\sqrt{6}");
    rows.join("\n")
}

fn audit_latex(text: &str) -> Audit {
    let mut listing = Listing::from_formulas("mutated", text, Notation::Latex).unwrap();
    listing.map_name("w11=w").unwrap();
    listing.map_name("z11=z").unwrap();
    audit(&listing, &statement("cap-2x2"))
}

#[test]
fn mended_the_listing_agrees() {
    assert!(audit_latex(&mended()).agrees());
}

/// All places of a formula at which one character can be wrong: (start, end, replacement).
fn mutations(text: &str) -> Vec<(usize, usize, String)> {
    let bytes = text.as_bytes();
    let mut found = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let digits = bytes[at..].iter().take_while(|c| c.is_ascii_digit()).count();
        let subscript = text[..at].ends_with("_{") || text[..at].ends_with('_');
        match bytes[at] {
            b'+' => found.push((at, at + 1, "-".into())),
            b'-' => found.push((at, at + 1, "+".into())),
            b'0'..=b'9' if !subscript && text[..at].ends_with("\\sqrt{") => {
                for other in ["2", "3", "6"].into_iter().filter(|&other| other != &text[at..at + digits]) {
                    found.push((at, at + digits, other.into()));
                }
            }
            b'0'..=b'9' if !subscript && text[..at].ends_with('^') => {
                found.push((at, at + digits, "1".into()));
                found.push((at, at + digits, "3".into()));
            }
            b'0'..=b'9' if !subscript => {
                let number: u32 = text[at..at + digits].parse().unwrap();
                for other in [number + 1, number * 2, number * 10] {
                    found.push((at, at + digits, other.to_string()));
                }
            }
            _ => {}
        }
        at += digits.max(1);
    }
    found
}

/// Replaces bytes of one formula; the rest of the row stays.
fn mutated(row: &str, (start, end, replacement): &(usize, usize, String)) -> String {
    format!("{}{replacement}{}", &row[..*start], &row[*end..])
}

/// The row of a formula, in two: up to its `=`, and what follows as far as it is mathematics.
fn halves(row: &str) -> (&str, &str) {
    let cut = row.find('=').unwrap() + 1;
    row.split_at(cut)
}

/// Audits the listing with one mutated formula; it must be the one that is named, and mended by what is suggested.
fn check_mutation(rows: &[String], row: usize, mutation: &(usize, usize, String)) {
    let (label, formula) = halves(&rows[row]);
    let mut changed = rows.to_vec();
    changed[row] = format!("{label}{}", mutated(formula, mutation));
    let text = changed.join("\n");
    let audit = audit_latex(&text);
    assert_eq!(wrong(&audit), [format!("a{row}")], "{}", changed[row]);
    let finding = audit.findings.iter().find(|finding| !finding.agrees()).unwrap();
    assert_eq!(finding.corrections.len(), 1, "{}: {:?}", changed[row], finding.corrections);
    assert_eq!(finding.corrections[0].place.line, row + 1);
    assert_difference(finding);
}

/// printed + Σ difference·powers = true.
fn assert_difference(finding: &Finding) {
    let statement = statement("cap-2x2");
    let mut work = prove_cap::exact::Work::full();
    let mut sum = vec![finding.printed.clone()];
    for d in &finding.differences {
        sum.push(d.difference.multiply(&d.powers, statement.field(), &mut work).unwrap());
    }
    assert_eq!(Polynomial::sum(&sum, statement.field(), &mut work).unwrap(), finding.truth);
}

fn rows() -> Vec<String> {
    mended().lines().map(String::from).collect()
}

#[test]
fn every_mutation_of_one_formula_is_named() {
    let rows = rows();
    for mutation in mutations(halves(&rows[14]).1) {
        check_mutation(&rows, 14, &mutation);
    }
}

#[test]
#[ignore = "every mutation of every formula: seconds in release"]
fn every_mutation_of_every_formula_is_named() {
    let rows = rows();
    let mut count = 0;
    for row in 1..=16 {
        for mutation in mutations(halves(&rows[row]).1) {
            check_mutation(&rows, row, &mutation);
            count += 1;
        }
    }
    assert!(count > 700, "{count} mutations");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]
    #[test]
    fn a_random_mutation_is_named(row in 1usize..=16, choice in any::<prop::sample::Index>()) {
        let rows = rows();
        let all = mutations(halves(&rows[row]).1);
        check_mutation(&rows, row, &all[choice.index(all.len())]);
    }
}

/// `label = LaTeX` for every coefficient of a statement.
fn true_listing(statement: &Statement, basis: Basis) -> String {
    let ring = statement.ring();
    let letter = if basis == Basis::Bernstein { "c" } else { "a" };
    let list = coefficients(statement, basis).unwrap().unwrap();
    let row = |c: &prove_cap::expand::Coefficient| {
        format!("{letter}_{{{},{}}} &= {} \\\\\n", c.index.0, c.index.1, latex::formula(&ring, &c.value))
    };
    list.iter().map(row).collect()
}

#[test]
fn true_coefficients_written_in_latex_agree() {
    for name in ["cap-2x2", "cap-2x2-centre", "cap-3x3-d4", "cap-3x2", "octant"] {
        let statement = statement(name);
        for basis in [Basis::Bernstein, Basis::Monomial] {
            let text = true_listing(&statement, basis);
            let listing = Listing::from_formulas(name, &text, Notation::Latex).unwrap();
            let audit = audit(&listing, &statement);
            assert!(audit.agrees(), "{name}: {:?}", wrong(&audit));
            assert!(audit.unlisted.is_empty(), "{name}");
        }
    }
}

#[test]
fn the_latex_report_is_a_listing_of_the_truth() {
    let listing = Listing::from_toml(PAPER).unwrap();
    let statement = statement("cap-2x2");
    let document = report::latex(&page(&listing, &statement, &audit(&listing, &statement))).unwrap();
    let reread = Listing::from_formulas("report", &document, Notation::Latex).unwrap();
    let again = audit(&reread, &statement);
    assert_eq!(again.findings.len(), 16);
    assert!(again.agrees());
}

#[test]
fn a_coefficient_that_belongs_elsewhere_is_recognised() {
    let relation = |row: &str| -> Vec<Relation> {
        let listing = Listing::from_formulas("", row, Notation::Plain).unwrap();
        audit(&listing, &statement("cap-3x2")).findings[0].relations.clone()
    };
    let statement = statement("cap-3x2");
    let list = coefficients(&statement, Basis::Monomial).unwrap().unwrap();
    let value = |i: u32, j: u32| {
        let coefficient = list.iter().find(|c| c.index == (i, j)).unwrap();
        statement.ring().spell(&coefficient.value)
    };
    assert_ne!(value(1, 2), value(2, 1));
    assert_eq!(relation(&format!("a[1,2] = {}", value(2, 1))), [Relation::Exchanged]);
    let minus_three = Polynomial::integer(-3);
    assert_eq!(relation(&format!("a[1,2] = -3*({})", value(1, 2))), [Relation::Factor(minus_three)]);
    let two = format!("a[1,2] = {}\na[2,2] = {}", value(2, 2), value(2, 2));
    let listing = Listing::from_formulas("", &two, Notation::Plain).unwrap();
    let found = audit(&listing, &statement);
    assert_eq!(wrong(&found), ["a1,2"]);
    assert_eq!(
        found.findings[0].relations,
        [Relation::Other(prove_cap::formats::listing::Symbol::new("a2,2"))]
    );
}

#[test]
fn missing_and_superfluous_terms_are_told_apart() {
    let listing = |row: &str| Listing::from_formulas("", row, Notation::Plain).unwrap();
    let statement = statement("cap-2x2");
    // True: a1 = (8√3/3)·w·z − 8·w − 4/3.
    let found = audit(&listing("a1 = (8√3/3)·w·z − 4/3"), &statement);
    let text = report::text(&page(&listing("a1 = (8√3/3)·w·z − 4/3"), &statement, &found)).unwrap();
    assert!(text.contains("the term in w is missing"), "{text}");
    let found = audit(&listing("a1 = (8√3/3)·w·z − 8·w + 5·z² − 4/3"), &statement);
    let row = listing("a1 = (8√3/3)·w·z − 8·w + 5·z² − 4/3");
    let text = report::text(&page(&row, &statement, &found)).unwrap();
    assert!(text.starts_with("DIFFERS  1 of 1 printed"), "{text}");
}

/// One claim about the paper's coefficients, judged.
fn judged(claim: &str) -> (Judgement, String) {
    let text = format!(
        "title = \"t\"\nnotation = \"plain\"\nformulas = '''a1 = (8√3/3)·w·z − 8·w − 4/3'''\n\
         [[claim]]\nwhere = \"here\"\nsays = \"this\"\n{claim}\n"
    );
    let listing = Listing::from_toml(&text).unwrap_or_else(|error| panic!("{error}"));
    let statement = statement("cap-2x2");
    let audit = audit(&listing, &statement);
    let text = report::text(&page(&listing, &statement, &audit)).unwrap();
    (audit.claims[0].judgement, text)
}

#[test]
fn true_claims_hold_and_their_twins_fail() {
    let at = "at = { w = \"1/2\", z = \"4*sqrt(3)/3\" }";
    let variables = "variables = [\"w\", \"w*z\"]";
    for (true_claim, false_claim, evidence) in [
        ("relation = \"a3 = -2*a4\"", "relation = \"a3 = 2*a4\"", "the true a3 exceeds what is claimed by"),
        (
            &*format!("linear = [\"a1\"]\n{variables}"),
            &*format!("linear = [\"a1\", \"a6\"]\n{variables}"),
            "a6 is not linear in them",
        ),
        ("independent = [\"a1\", \"a2\"]", "independent = [\"a1\", \"a2\", \"a4\"]", "a4 = a1 + a2"),
        (
            &*format!(
                "solve = [\"a1\", \"a2\"]\nsolution = {{ w = \"1/2\", z = \"4*sqrt(3)/3\" }}\n{variables}"
            ),
            &*format!(
                "solve = [\"a1\", \"a2\"]\nsolution = {{ w = \"1/3\", z = \"4*sqrt(3)/3\" }}\n{variables}"
            ),
            "they hold if and only if w = 1/2, w·z = 2√3/3",
        ),
        (
            &*format!(
                "solve = [\"a1\", \"a2\"]\nsolution = {{ w = \"1/2\", z = \"4*sqrt(3)/3\" }}\n{variables}"
            ),
            &*format!(
                "solve = [\"a3\", \"a4\"]\nsolution = {{ w = \"1/2\", z = \"4*sqrt(3)/3\" }}\n{variables}"
            ),
            "a family of solutions of dimension 1",
        ),
        (
            &*format!("values = {{ a6 = \"1.3333\" }}\n{at}"),
            &*format!("values = {{ a6 = \"1.3334\" }}\n{at}"),
            "a6 is printed as 1.3334, but is 4/3 = 1.33333333…",
        ),
        (
            &*format!("values = {{ a3 = \"0\" }}\n{at}"),
            &*format!("values = {{ a6 = \"1\" }}\n{at}"),
            "a6 is printed as 1, but is 4/3",
        ),
        (
            "decimal = \"2.3094011\"\nof = \"4*sqrt(3)/3\"",
            "decimal = \"2.3094010\"\nof = \"4*sqrt(3)/3\"",
            "4√3/3 = 2.3094010767…",
        ),
        (
            &*format!("radius = [\"1\", \"1.0042\"]\n{at}"),
            &*format!("radius = [\"1\", \"1.0041\"]\n{at}"),
            "not ≤ 1.0041",
        ),
        (
            &*format!("radius = [\"1\", \"1.0043\"]\n{at}"),
            &*format!("radius = [\"1.001\", \"1.0043\"]\n{at}"),
            "not ≥ 1.001",
        ),
        (
            "proved = \"cap-2x2\"\nexpected = \"impossible\"",
            "proved = \"cap-2x2\"\nexpected = \"exact\"",
            "PROVED impossible",
        ),
        (
            "quantity = \"P01\"\nprinted = [\"0\", \"-(3*a)/4\", \"(3*a)/4\"]",
            "quantity = \"P01\"\nprinted = [\"0\", \"-a/4\", \"(3*a)/4\"]",
            "P01 = (0, −√3/2, √3/2), printed (0, −√3/6, √3/2)",
        ),
    ] {
        let (judgement, text) = judged(true_claim);
        assert_eq!(judgement, Judgement::Holds, "{text}");
        let (judgement, text) = judged(false_claim);
        assert_eq!(judgement, Judgement::Fails, "{text}");
        assert!(text.contains(evidence), "{evidence}:\n{text}");
    }
}

#[test]
fn a_radius_that_cannot_be_bounded_is_not_checked() {
    let (judgement, text) = judged("radius = [\"1\", \"2\"]\nat = { w = \"-3\", z = \"1\" }");
    assert_eq!(judgement, Judgement::NotChecked, "{text}");
    assert!(
        text.contains("not bounded: the denominator W of the patch is negative at u = 1/2, v = 1/2"),
        "{text}"
    );
}

#[test]
fn a_rival_that_is_no_better_decides_nothing() {
    let (judgement, text) =
        judged("at = { w = \"1/2\", z = \"4*sqrt(3)/3\" }\nrival = { w = \"0.47\", z = \"2.36\" }");
    // Nearer above, but below 1, where the other is not.
    assert_eq!(judgement, Judgement::NotChecked, "{text}");
    let (judgement, text) =
        judged("at = { w = \"0.48\", z = \"2.4\" }\nrival = { w = \"1/2\", z = \"4*sqrt(3)/3\" }");
    assert_eq!(judgement, Judgement::Fails, "{text}");
    assert!(text.contains("the radius stays in a smaller interval at w = 1/2, z = 4√3/3"), "{text}");
}

#[test]
fn a_formula_too_long_to_be_read_is_compared_but_not_explained() {
    let text = format!("a_1 = {}", ["w"; 20_000].join(" + "));
    let listing = Listing::from_formulas("", &text, Notation::Latex).unwrap();
    let found = audit(&listing, &statement("cap-2x2"));
    assert_eq!(wrong(&found), ["a1"]);
    assert_eq!(found.findings[0].corrections, []);
}

#[test]
fn an_audit_that_is_stopped_says_so() {
    let control = Control::default();
    control.stop(Why::Interrupt);
    let error = Audit::of(&paper_formulas(), &statement("cap-2x2"), &control).unwrap_err();
    assert!(matches!(error, prove_cap::audit::AuditError::Interrupted(_)), "{error}");
}
