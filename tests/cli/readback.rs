//! What the program prints it reads back as the same thing.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use prove_cap::audit::Audit;
use prove_cap::audit::net::NetAudit;
use prove_cap::catalogue;
use prove_cap::commands::{Expanded, Source, expand};
use prove_cap::control::Control;
use prove_cap::exact::{Monomial, Polynomial, Radicands};
use prove_cap::expand::Basis;
use prove_cap::formats::listing::{Listing, Notation, is_expansion, read_constant};
use prove_cap::formats::net::{Convention, from_json, statement_from_json};
use prove_cap::report::{self, bounds::value_text, json};
use prove_cap::statement::Statement;
use serde_json::{Value, json as object};

/// What `expand` prints of a statement, as text and as JSON, read back.
fn listings(statement: &Statement) -> Vec<Listing> {
    let mut listings = Vec::new();
    for basis in [Basis::Bernstein, Basis::Monomial] {
        let expanded = expanded(statement, basis);
        let text = report::text(&expanded).unwrap();
        listings.push(Listing::from_formulas("", &text, Notation::Plain).unwrap_or_else(|e| panic!("{e}")));
        let text = report::latex(&expanded).unwrap();
        // Without displays there is no listing in LaTeX, not even an empty one.
        if text.contains("\\begin{align*}") {
            let listing = Listing::from_formulas("", &text, Notation::Latex);
            listings.push(listing.unwrap_or_else(|e| panic!("{e}")));
        }
        let text = report::json(&expanded).unwrap();
        assert!(is_expansion(&text));
        listings.push(Listing::from_json(&text).unwrap_or_else(|e| panic!("{e}")));
    }
    listings
}

fn expanded(statement: &Statement, basis: Basis) -> Expanded {
    let (name, text) = ("it".to_owned(), String::new());
    expand(Source { name, text, statement: statement.clone(), cap: false }, basis).unwrap()
}

fn audit(listing: &Listing, statement: &Statement) -> Audit {
    Audit::of(listing, statement, &Control::default()).unwrap_or_else(|error| panic!("{error}"))
}

/// The statement as JSON, and the same with the keys of an answer about it.
fn documents(statement: &Statement) -> Vec<String> {
    let data = json::statement(statement);
    let answer = object!({ "verdict": "UNDECIDED", "name": "x", "statement": data, "files": null });
    vec![serde_json::to_string(&answer).unwrap(), serde_json::to_string_pretty(&answer).unwrap()]
}

fn is_read_back(statement: &Statement) {
    for listing in listings(statement) {
        let audit = audit(&listing, statement);
        assert!(audit.agrees() && audit.unlisted.is_empty(), "{}", statement.title());
    }
    for document in documents(statement) {
        let text = statement_from_json(&document).unwrap_or_else(|error| panic!("{error}"));
        let read = Statement::read(&text).unwrap();
        assert_eq!((read.hash(), read.title()), (statement.hash(), statement.title()));
    }
}

#[test]
fn built_in_statements_are_read_back() {
    for entry in catalogue::ENTRIES.iter().filter(|entry| !entry.name.contains("4x4")) {
        is_read_back(&Statement::read(&entry.statement()).unwrap());
    }
}

fn system(polynomials: &str) -> Statement {
    let head = "title = \"A \\\"system\\\", with \\\\\"\nradicands = [3, 2]\nunknowns = [\"x_1\", \"y\"]";
    Statement::read(&format!("{head}\nnonzero = [\"x_1\", \"sqrt(2)*y + 1\"]\npolynomials = [{polynomials}]"))
        .unwrap()
}

#[test]
fn systems_are_read_back() {
    is_read_back(&system("\"x_1^2 - sqrt(17 + 12*sqrt(2))\", \"(sqrt(2) - sqrt(3))*x_1*y - 1/7\""));
    is_read_back(&system("\"0\", \"y\""));
}

/// A patch all of whose coefficients are zero has nothing to list; nothing is no listing of any other.
#[test]
fn an_empty_listing_is_that_of_a_patch_on_its_surface() {
    let cobb = Statement::read(&catalogue::find("cobb").unwrap().statement()).unwrap();
    is_read_back(&cobb);
    let cap = Statement::read(&catalogue::find("cap-2x2").unwrap().statement()).unwrap();
    for listing in listings(&cobb) {
        assert!(listing.formulas.is_empty());
        let error = Audit::of(&listing, &cap, &Control::default()).expect_err("no formula");
        assert!(
            error.to_string().starts_with("1:1: no formula here, expected `label = expression`"),
            "{error}"
        );
    }
}

/// One number of an expansion changed: the coefficient it is in is named, with the line it stands in.
#[test]
fn a_changed_expansion_differs_where_it_was_changed() {
    let cap = Statement::read(&catalogue::find("cap-2x2").unwrap().statement()).unwrap();
    let text = report::json(&expanded(&cap, Basis::Bernstein)).unwrap();
    let changed = text.replacen("8/3*sqrt(3)*w*z - 8*w - 4/3", "8/3*sqrt(3)*w*z - 9*w - 4/3", 1);
    let listing = Listing::from_json(&changed).unwrap();
    let audit = audit(&listing, &cap);
    let wrong: Vec<_> = audit.findings.iter().filter(|finding| !finding.agrees()).collect();
    assert_eq!(wrong.len(), 1);
    let line = changed.lines().nth(wrong[0].place.line - 1).unwrap();
    assert!(line.contains("\"c[1,1]\""), "{line}");
    assert_eq!(wrong[0].corrections.len(), 1);
    let line = changed.lines().nth(wrong[0].corrections[0].place.line - 1).unwrap();
    assert!(line.contains("9*w"), "{line}");
}

#[test]
fn what_is_no_expansion_is_refused_with_its_place() {
    for (text, expected) in [
        ("{\"basis\": \"bernstein\",\n \"coefficients\": [3]}", "2:20: not an expansion in JSON:"),
        (
            "{\"statement\": {\"title\": \"t\"}, \"basis\": \"power\", \"coefficients\": []}",
            "1:1: `basis`: expected \"bernstein\" or \"monomial\"",
        ),
        (
            "{\"statement\": {\"title\": \"t\"}, \"coefficients\": [{\"name\": \"c[0,0]\",\n \"value\": 3}]}",
            "2:11: expected a formula in quotes, without escapes, found `3`",
        ),
        (
            "{\"statement\": {\"title\": \"t\"}, \"coefficients\": [{\"name\": \"c[0,0]\",\n \"value\": \"1/2w\"}]}",
            "2:15: ambiguous:",
        ),
    ] {
        let error = Listing::from_json(text).expect_err(text).to_string();
        assert!(error.starts_with(expected), "{error}");
    }
}

#[test]
fn a_changed_statement_is_refused() {
    let cap = Statement::read(&catalogue::find("cap-2x2").unwrap().statement()).unwrap();
    let document = &documents(&cap)[0];
    let changed = document.replacen("\"w\"]", "\"2*w\"]", 1);
    assert_ne!(*document, changed);
    let error = statement_from_json(&changed).expect_err("another hash").to_string();
    assert!(error.starts_with("statement.sha256: this is the hash of another statement"), "{error}");
    let silent = document.replacen("\"convention\":\"homogeneous\",", "", 1);
    assert_ne!(*document, silent);
    let error = statement_from_json(&silent).expect_err("no convention").to_string();
    assert!(error.starts_with("statement: `convention` is missing"), "{error}");
}

fn element(radicands: &'static [u32]) -> impl Strategy<Value = (Radicands, Polynomial)> {
    let numbers = prop::collection::vec((-10_000i64..=10_000, 1i64..=1000), 1 << radicands.len());
    (numbers, 0usize..4).prop_map(move |(numbers, kind)| {
        let field = Radicands::new(radicands.to_vec()).unwrap();
        let rational = |(n, d): (i64, i64)| match kind {
            0 => BigRational::new(BigInt::from(n), BigInt::from(10).pow(15)),
            1 => BigRational::from_integer(BigInt::from(n)),
            _ => BigRational::new(BigInt::from(n), BigInt::from(d)),
        };
        let masks = field.masks().zip(numbers).take(if kind == 0 { 1 } else { 16 });
        let value = Polynomial::from_terms(masks.map(|(m, number)| (Monomial::radical(m), rational(number))));
        (field, value)
    })
}

fn number_is_read_back(field: &Radicands, value: &Polynomial) {
    let head = format!("title = \"t\"\nradicands = {:?}\nunknowns = []\npolynomials = []", field.values());
    let printed = value_text(&Statement::read(&head).unwrap(), value);
    let read = read_constant(&printed, field).unwrap_or_else(|error| panic!("{printed}: {error}"));
    assert_eq!(read, *value, "{printed}");
}

proptest! {
    #[test]
    fn numbers_are_read_back_as_they_are_printed(
        rational in element(&[]), quadratic in element(&[7]), biquadratic in element(&[2, 3]), large in element(&[2, 3, 5, 7]),
    ) {
        for (field, value) in [rational, quadratic, biquadratic, large] {
            number_is_read_back(&field, &value);
        }
    }

    /// Patches of bidegree (1,1) and (2,1) with numbers and unknowns anywhere, on planes, quadrics and a cubic.
    #[test]
    fn patches_are_read_back(
        entries in prop::collection::vec(0usize..10, 24), rows in 2usize..=3, surface in 0usize..4, cartesian in any::<bool>(),
    ) {
        const ENTRIES: [&str; 10] = [
            "1", "0", "w", "-w*z_2 + 1/3", "sqrt(2)/2", "(1 - sqrt(6))*w", "2.25", "z_2^2", "-7/12*sqrt(3) + w", "sqrt(5 + 2*sqrt(6))",
        ];
        const SURFACES: [&str; 4] = ["X^2 + Y^2 + Z^2 - W^2", "X - sqrt(3)*Z + W", "X*Y - (1 + sqrt(2))*Z*W", "X^3 - Y*Z*W"];
        let point = |k: usize| {
            let numbers: Vec<String> = (0..4).map(|e| format!("\"{}\"", ENTRIES[entries[4 * k + e]])).collect();
            format!("[{}]", numbers.join(", "))
        };
        let net: Vec<String> = (0..rows).map(|i| format!("[{}, {}]", point(2 * i), point(2 * i + 1))).collect();
        let convention = if cartesian { "cartesian" } else { "homogeneous" };
        let text = format!(
            "title = \"A patch, of many\"\nradicands = [2, 3]\nunknowns = [\"w\", \"z_2\"]\nconvention = \"{convention}\"\n\
             bidegree = [{}, 1]\nsurface = \"{}\"\nnet = [{}]\n", rows - 1, SURFACES[surface], net.join(", ")
        );
        // All weights may be zero.
        if let Ok(statement) = Statement::read(&text) {
            is_read_back(&statement);
        }
    }
}

fn run(directory: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output =
        Command::cargo_bin("prove-cap").unwrap().current_dir(directory).args(arguments).output().unwrap();
    let text = [output.stdout, output.stderr].concat();
    (output.status.code(), String::from_utf8(text).unwrap())
}

fn saved(directory: &Path, name: &str, arguments: &[&str]) -> Value {
    let (code, text) = run(directory, &[arguments, &["--format", "json"]].concat());
    assert_eq!(code, Some(0), "{text}");
    fs::write(directory.join(name), &text).unwrap();
    serde_json::from_str(&text).unwrap()
}

/// Every object that has a net says how its points are given.
fn says_its_convention(data: &Value) -> usize {
    let (inside, own) = match data {
        Value::Object(map) => {
            if map.contains_key("net") {
                assert_eq!(map.get("convention"), Some(&Value::from("homogeneous")));
            }
            (map.values().map(says_its_convention).sum(), usize::from(map.contains_key("net")))
        }
        Value::Array(list) => (list.iter().map(says_its_convention).sum(), 0),
        _ => (0, 0),
    };
    inside + own
}

#[test]
fn constructed_nets_are_audited_proved_and_bounded() {
    let directory = tempfile::tempdir().unwrap();
    let at = directory.path();
    for (polygon, m, n) in [("cube", "4", "2"), ("rhombic-dodecahedron", "2", "4"), ("octant", "4", "2")] {
        let data = saved(at, "net.json", &["construct", polygon, "--bidegree", m, n]);
        assert_eq!(says_its_convention(&data), 2);
        let hash = data["statement"]["sha256"].as_str().unwrap();
        let text = statement_from_json(&fs::read_to_string(at.join("net.json")).unwrap()).unwrap();
        assert_eq!(Statement::read(&text).unwrap().hash(), hash);
        let (code, text) = run(at, &["audit", "net.json"]);
        assert_eq!(code, Some(0), "{text}");
        assert!(text.starts_with("AGREES  the net lies on the unit sphere"), "{text}");
        let (code, text) = run(at, &["prove", "net.json", "-o", "proof"]);
        assert_eq!(code, Some(0), "{text}");
        assert!(text.starts_with("EXACT  net: this patch lies on the unit sphere"), "{text}");
        let (code, text) = run(at, &["bound", "net.json", "-o", "bounds", "--tolerance", "1e-6"]);
        assert_eq!(code, Some(0), "{text}");
        assert!(text.starts_with("PROVED  net: 1.000000 ≤ r ≤ 1.000000"), "{text}");
    }
}

/// The net that `bound` evaluates has the same bounds when it is read back, and values may be given as they are printed.
#[test]
fn evaluated_nets_have_the_bounds_of_the_patch() {
    let directory = tempfile::tempdir().unwrap();
    let at = directory.path();
    let set = ["bound", "cap-2x2", "--tolerance", "1e-4", "-o", "a"];
    let ascii = saved(
        at,
        "a.json",
        &[&set[..], &["--set", "w=sqrt(2)/2 + sqrt(3)/3 - sqrt(6)/3", "--set", "z=-2"]].concat(),
    );
    let printed =
        saved(at, "b.json", &[&set[..], &["--set", "w=√2/2 + √3/3 − √6/3", "--set", "z=−2"]].concat());
    assert_eq!(ascii["values"], printed["values"]);
    let again = saved(at, "c.json", &["bound", "a.json", "--tolerance", "1e-4", "-o", "c"]);
    for end in ["lower", "upper"] {
        assert_eq!(ascii[end]["bound"], again[end]["bound"]);
    }
    assert_eq!(says_its_convention(&ascii), 3);
    let decimals = ascii["decimals"]["net"][1][1][3].as_str().unwrap();
    assert_eq!(decimals, "0.46796046944844725");
}

/// A net with a decimal of three places in the wrong convention, and one that is far from its surface in both.
#[test]
fn each_convention_is_said_to_leave_what_it_leaves() {
    let net = |numbers: &str, z: &str| {
        format!(
            "{{\"title\": \"t\", \"convention\": \"homogeneous\", \"radicands\": [], \"surface\": \"X^2 + Y^2 - W^2\", \"net\": [\
             [[0, -1, 0, 1], [0, -1, 1, 1]], [[{numbers}], [{z}]], [[-1, 0, 0, 1], [-1, 0, 1, 1]]]}}"
        )
    };
    let audited = |text: &str| NetAudit::of(&from_json(text).unwrap(), &Control::default()).unwrap();
    let audit = audited(&net("-1, -1, 0, \"0.707\"", "-1, -1, 1, \"0.707\""));
    assert!(audit.corrections.is_empty());
    let said: Vec<_> = audit.readings.iter().map(|r| (r.convention, r.decimals, r.printed)).collect();
    assert_eq!(said, [(Convention::Homogeneous, None, Some(3)), (Convention::Cartesian, Some(3), Some(3))]);
    let audit = audited(&net("-1, -1, 0, \"0.807\"", "-1, -1, 1, \"0.707\""));
    let said: Vec<_> = audit.readings.iter().map(|r| r.decimals).collect();
    assert_eq!(said, [None, Some(1)]);
}

/// However a net on its surface is rounded, the bound for so many decimals is kept.
#[test]
fn rounded_nets_keep_their_bound() {
    let cobb = fs::read_to_string("tests/data/nets/cobb-4x4.json").unwrap();
    let net = from_json(&cobb).unwrap();
    for convention in [Convention::Homogeneous, Convention::Cartesian] {
        let statement = Statement::read(&net.statement()).unwrap();
        let net = prove_cap::formats::net::PrintedNet::from_statement(&statement, convention).unwrap();
        for places in [2u32, 7, 15] {
            let mut rounded = net.clone();
            for entry in rounded.points.iter_mut().flatten().flatten() {
                // Cut off one decimal later: nearer than by rounding.
                let digits = prove_cap::audit::decimal(entry, places + 1, &net.field).unwrap();
                *entry = read_constant(&digits, &net.field).unwrap();
            }
            let audit = NetAudit::of(&rounded, &Control::default()).unwrap();
            let reading = audit.readings.iter().find(|reading| reading.convention == convention).unwrap();
            assert!(
                reading.decimals.is_some_and(|decimals| decimals >= places),
                "{places}: {:?}",
                reading.decimals
            );
        }
    }
}

/// Claims need no formulas beside them.
#[test]
fn claims_are_judged_without_a_formula() {
    let file = |formulas: &str| {
        format!(
            "title = \"t\"\nstatement = \"cap-2x2\"\nnotation = \"plain\"\n{formulas}\n[[claim]]\nwhere = \"1\"\nsays = \"r\"\n\
             decimal = \"0.4680\"\nof = \"sqrt(2)/2*(sqrt(2/3)+1) - sqrt(2/3)\"\n\n[[claim]]\nwhere = \"2\"\nsays = \"s\"\n\
             decimal = \"0.4690\"\nof = \"sqrt(2)/2*(sqrt(2/3)+1) - sqrt(2/3)\"\n"
        )
    };
    let cap = Statement::read(&catalogue::find("cap-2x2").unwrap().statement()).unwrap();
    let judged = |formulas: &str| {
        let listing = Listing::from_toml(&file(formulas)).unwrap_or_else(|error| panic!("{error}"));
        let audit = audit(&listing, &cap);
        (audit.agrees(), audit.claims.iter().map(|claim| claim.judgement).collect::<Vec<_>>())
    };
    let with = judged("formulas = '''\nc[1,1] = (8*sqrt(3)/3)*w*z - 8*w - 4/3\n'''");
    for without in ["", "formulas = ''", "formulas = '''\n\n'''", "formulas = '''\n# none\n'''"] {
        assert_eq!(judged(without), with, "{without}");
    }
    let error = Listing::from_toml("title = \"t\"\nnotation = \"plain\"\n").expect_err("neither").to_string();
    assert!(error.starts_with("1:1: `formulas` is missing"), "{error}");
}
