//! What the program says is so: the sentences of docs/trust.md, word for word, and what is not said.

use std::fs;
use std::path::Path;

use tempfile::TempDir;

/// The exit status and the text of a run in a folder, on standard output and standard error, with its lines joined.
fn run(folder: &TempDir, arguments: &[&str]) -> (i32, String) {
    let mut command = assert_cmd::Command::cargo_bin("prove-cap").unwrap();
    let output = command.current_dir(folder.path()).args(arguments).output().unwrap();
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).unwrap()).concat();
    (output.status.code().unwrap(), text)
}

/// Lines broken at blanks, joined again.
fn joined(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// A folder with one file, `it.toml`.
fn with(text: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("it.toml"), text).unwrap();
    folder
}

/// A bilinear patch in the plane z = 1 with weights 1; its middle height is an expression.
fn sheet(unknowns: &str, more: &str, height: &str) -> String {
    format!(
        "title = \"A quarter of a cylinder\"\nradicands = []\nunknowns = [{unknowns}]\n{more}\
         convention = \"cartesian\"\nbidegree = [1, 1]\n\
         net = [[[0, 0, \"{height}\", 1], [0, 1, 1, 1]], [[1, 0, 1, 1], [1, 1, 1, 1]]]\n"
    )
}

const DEFAULT: &str = "(the file names none: the unit sphere)";

#[test]
fn a_surface_that_is_left_out_is_said_to_be() {
    let folder = with(&sheet("", "", "1"));
    let (status, text) = run(&folder, &["prove", "it.toml", "-o", "out"]);
    assert_eq!(status, 0);
    let first = text.lines().next().unwrap();
    assert_eq!(
        first,
        format!(
            "PROVED  it: this patch does not lie on the surface X² + Y² + Z² − W² = 0 {DEFAULT}; \
             how far: `prove-cap bound it.toml`"
        )
    );
    let (_, text) = run(&folder, &["check", "out/statement.toml", "out/certificate.txt"]);
    assert!(text.contains("\nsurface    the file names none: the unit sphere\n"), "{text}");
    let (status, text) = run(&folder, &["bound", "it.toml", "-o", "out", "--tolerance", "0.1"]);
    assert_eq!(status, 0);
    assert_eq!(text.lines().nth(1).unwrap(), format!("Surface: X² + Y² + Z² − W² = 0 {DEFAULT}"));
    let (status, text) = run(&folder, &["audit", "it.toml"]);
    assert_eq!(status, 1);
    assert!(text.lines().next().unwrap().contains(DEFAULT), "{text}");
    let (_, text) = run(&folder, &["prove", "it.toml", "-o", "out", "--format", "json"]);
    assert!(text.contains("\"surface_named\": false"), "{text}");
}

/// The same surface named: nothing is left out, and nothing is said to be.
#[test]
fn the_surface_is_named() {
    for (surface, phrase) in [
        ("X^2 + Y^2 + Z^2 - W^2", "the unit sphere X² + Y² + Z² − W² = 0"),
        ("W^2 - X^2 - Y^2 - Z^2", "the surface −X² − Y² − Z² + W² = 0"),
        ("4*X^2 + 4*Y^2 + 4*Z^2 - W^2", "the surface 4·X² + 4·Y² + 4·Z² − W² = 0"),
        ("X^2 + Y^2 - 9*W^2", "the surface X² + Y² − 9·W² = 0"),
    ] {
        let folder = with(&sheet("\"a\"", &format!("surface = \"{surface}\"\n"), "a"));
        let (status, text) = run(&folder, &["prove", "it.toml", "-o", "out"]);
        assert_eq!(status, 0, "{text}");
        let headline = format!("PROVED  it: no such patch lies on {phrase}, for any value of a\n");
        assert!(text.starts_with(&headline), "{text}");
        assert!(!text.contains("names none"), "{text}");
        let (_, checked) = run(&folder, &["check", "out/statement.toml", "out/certificate.txt"]);
        assert!(checked.contains(&format!(" lie on {phrase}: its 9 coefficients")), "{checked}");
        assert!(!checked.contains("names none"), "{checked}");
    }
    // An exact patch: the plane it lies in.
    let folder = with(&sheet("\"a\"", "surface = \"Z - W\"\n", "a"));
    let (_, text) = run(&folder, &["prove", "it.toml", "-o", "out"]);
    assert!(
        text.starts_with("EXACT  it: at the values below the patch lies on the surface Z − W = 0\n"),
        "{text}"
    );
    let checked = "At the stated values every point of the patch whose denominator is not zero lies on the surface Z − \
                   W = 0. Every weight is positive, so the patch is defined on the whole square.";
    assert!(joined(&text).contains(checked), "{text}");
    let (status, text) = run(&folder, &["audit", "it.toml"]);
    assert_eq!(status, 2, "{text}");
    let folder = with(&sheet("", "surface = \"Z - W\"\n", "1"));
    let (status, text) = run(&folder, &["audit", "it.toml"]);
    assert_eq!(status, 0);
    assert!(
        text.starts_with(
            "AGREES  the net lies on the surface Z − W = 0: verified by the independent checker\n"
        ),
        "{text}"
    );
}

#[test]
fn sentences_without_unknowns() {
    let folder = with(&sheet("", "", "1"));
    let (_, text) = run(&folder, &["prove", "it.toml", "-o", "out"]);
    assert!(
        joined(&text).contains(
            "VERIFIED. This rational Bézier patch of bidegree (1,1) does not lie on the unit sphere X² + Y² + Z² − W² = 0: \
             its 9 coefficients c[r,s] are not all zero."
        ),
        "{text}"
    );
    assert!(text.contains("4 control points, no unknowns.\n"), "{text}");
    for nonsense in ["unknowns .", "values of the unknowns", "stated values", "no common zero"] {
        assert!(!text.contains(nonsense), "{nonsense}: {text}");
    }
    let system = |polynomials: &str| {
        with(&format!("title = \"t\"\nradicands = []\nunknowns = []\npolynomials = [{polynomials}]\n"))
    };
    let (_, text) = run(&system("0, 1"), &["prove", "it.toml", "-o", "out"]);
    assert!(text.starts_with("PROVED  it: the equations of the system do not all hold\n"), "{text}");
    assert!(
        text.contains("VERIFIED. The polynomials of the system, all constants, are not all zero.\n"),
        "{text}"
    );
    let (_, text) = run(&system("0, \"1 - 1\""), &["prove", "it.toml", "-o", "out"]);
    assert!(text.starts_with("EXACT  it: the equations of the system hold\n"), "{text}");
    assert!(text.contains("VERIFIED. Every polynomial of the system is zero.\n"), "{text}");
    // The sphere is not reached, and no value is stated.
    let (_, text) = run(&folder, &["bound", "it.toml", "-o", "out", "--tolerance", "0.1"]);
    assert!(
        joined(&text).contains(
            "VERIFIED. As it stands the denominator W is positive on the whole square, and there 1.0 ≤ √(x² + y² + z²) ≤ 1.8."
        ),
        "{text}"
    );
}

#[test]
fn sentences_with_one_unknown() {
    let system = |polynomials: &str| {
        with(&format!("title = \"t\"\nradicands = []\nunknowns = [\"p\"]\npolynomials = [{polynomials}]\n"))
    };
    let (_, text) = run(&system("\"p\", \"p - 1\""), &["prove", "it.toml", "-o", "out"]);
    assert!(text.starts_with("PROVED  it: no common zero, for any value of p\n"), "{text}");
    let folder = with(&sheet("\"a\"", "", "a"));
    let (_, text) = run(&folder, &["prove", "it.toml", "-o", "out"]);
    assert!(text.contains("4 control points, unknown a.\n"), "{text}");
    assert!(
        joined(&text).contains("VERIFIED. For no value of a, real or complex, does this rational"),
        "{text}"
    );
    assert!(!text.contains("unknowns"), "{text}");
}

#[test]
fn assumptions_are_said_where_they_are_checked() {
    let folder = with(&sheet("\"a\", \"b\"", "nonzero = [\"a - 1\", \"2\"]\n", "a"));
    let (_, text) = run(&folder, &["prove", "it.toml", "-o", "out"]);
    assert!(text.lines().next().unwrap().ends_with(", for any values of a, b with a − 1 ≠ 0"), "{text}");
    assert!(
        joined(&text).contains("For no values of a, b with a − 1 ≠ 0, real or complex, does this"),
        "{text}"
    );
    // Bounds do not ask: at a = 1 the assumption fails.
    let set = ["--set", "a=1", "--set", "b=0", "--tolerance", "0.1", "-o", "out"];
    let (status, text) = run(&folder, &[&["bound", "it.toml"], &set[..]].concat());
    assert_eq!(status, 0, "{text}");
    assert!(joined(&text).contains("That a − 1 ≠ 0 at these values is not checked."), "{text}");
    // Where nothing is assumed, nothing is said.
    let folder = with(&sheet("\"a\"", "", "a"));
    let (_, text) = run(&folder, &["bound", "it.toml", "--set", "a=1", "--tolerance", "0.1", "-o", "out"]);
    assert!(!text.contains("not checked"), "{text}");
    // What lies on the surface at values, and an assumption that holds there: checked, and said.
    let folder = with(&sheet("\"a\"", "surface = \"Z - W\"\nnonzero = [\"a + 1\"]\n", "a"));
    let (_, text) = run(&folder, &["prove", "it.toml", "-o", "out"]);
    assert!(joined(&text).contains("VERIFIED. At the stated values, where a + 1 ≠ 0, every point"), "{text}");
    // One that fails there: there is no such patch.
    let folder = with(&sheet("\"a\"", "surface = \"Z - W\"\nnonzero = [\"a - 1\"]\n", "a"));
    let (_, text) = run(&folder, &["prove", "it.toml", "-o", "out"]);
    assert!(text.starts_with(
        "PROVED  it: no such patch lies on the surface Z − W = 0, for any value of a with a − 1 ≠ 0\n"
    ));
}

#[test]
fn a_degenerate_octant_is_not_called_regular_at_its_corner() {
    let folder = TempDir::new().unwrap();
    let (_, text) = run(&folder, &["construct", "octant", "--bidegree", "2", "2", "-o", "out"]);
    let headline = "EXACT  octant: a patch of bidegree (2,2) on the unit sphere covers the polygon once, and regularly but \
                    for the edge u = 1, which is one corner\n";
    assert!(text.starts_with(headline), "{text}");
    let checked = "it maps the square onto the convex spherical triangle between its corners, whose sides are the shorter \
                   arcs of great circles: the edge u = 1 to one corner, and all else one to one and regularly onto the rest.";
    assert!(joined(&text).contains(checked), "{text}");
    assert!(!joined(&text).contains("maps the square one to one"), "{text}");
    let (_, text) =
        run(&folder, &["construct", "octant", "--bidegree", "2", "2", "--tiling", "-o", "tiling"]);
    assert!(
        text.contains("8 of 8 cover their polygons, once and regularly but for an edge that is one corner"),
        "{text}"
    );
    // A quadrilateral is regular throughout, and no edge is excepted.
    let (_, text) = run(&folder, &["construct", "cube", "--bidegree", "4", "2", "-o", "cube"]);
    assert!(text.starts_with(
        "EXACT  cube: a patch of bidegree (4,2) on the unit sphere covers the polygon, once and regularly\n"
    ));
    assert!(
        joined(&text)
            .contains("it maps the square one to one and regularly onto the convex spherical quadrilateral")
    );
    assert!(!text.contains("but for"), "{text}");
    // With the edge called an arc the checker refuses: the sentence cannot be had otherwise.
    let cover = folder.path().join("out/cover.txt");
    let damaged = fs::read_to_string(&cover).unwrap().replace("edge u=1 point", "edge u=1 arc .");
    let damaged = sealed(&folder, "out/statement.toml", &damaged, 6);
    fs::write(&cover, damaged).unwrap();
    let (status, text) = run(&folder, &["check", "out/statement.toml", "out/cover.txt"]);
    assert_eq!(
        (status, text.as_str()),
        (1, "REJECTED  out/cover.txt: edge u=1: it is not an arc of a great circle\n")
    );
}

#[test]
fn a_barrier_without_unknowns_and_one_that_needs_no_assumption() {
    for (unknowns, more, sentence) in [
        (
            "",
            "",
            "It is not so that the denominator W is positive on the whole square and 2 < √(x² + y² + z²) < 3 everywhere on it.",
        ),
        (
            "\"a\"",
            "",
            "For no real value of a is the denominator W positive on the whole square and 2 < √(x² + y² + z²) < 3 everywhere on it.",
        ),
        (
            "\"a\"",
            "nonzero = [\"a\"]\n",
            "For no real value of a, whether a ≠ 0 or not, is the denominator W positive on the whole square and 2 < √(x² + y² + z²) \
             < 3 everywhere on it.",
        ),
    ] {
        let folder = with(&sheet(unknowns, more, "1"));
        let (_, text) = run(&folder, &["prove", "it.toml", "-o", "out"]);
        assert!(text.starts_with("PROVED"), "{text}");
        let (_, text) = run(&folder, &["check", "out/statement.toml", "out/certificate.txt"]);
        let hash = text.split("statement  sha256 ").nth(1).unwrap().lines().next().unwrap();
        let charts = if unknowns.is_empty() { 1 } else { 3 };
        // At the corner (0, 0) the radius is 1, whatever the unknown.
        let barrier = |low: u32| {
            let charts: String =
                (1..=charts).map(|chart| format!("chart {chart}\nexclude 1*lower[1]\n")).collect();
            format!(
                "prove-cap certificate 1\nstatement sha256 {hash}\nclaim unreachable\nquantity radius 0\nbetween {low} 3\n\
                 range 1\nsample 1 at 0 0\n{charts}"
            )
        };
        let file = folder.path().join("barrier.txt");
        fs::write(&file, sealed(&folder, "out/statement.toml", &barrier(2), charts)).unwrap();
        let (status, text) = run(&folder, &["check", "out/statement.toml", "barrier.txt"]);
        assert_eq!(status, 0, "{text}");
        assert!(text.contains(&format!("\n{sentence}\n")), "{text}");
        // Below 1 there is something.
        fs::write(&file, sealed(&folder, "out/statement.toml", &barrier(0), charts)).unwrap();
        let (status, text) = run(&folder, &["check", "out/statement.toml", "barrier.txt"]);
        assert_eq!(status, 1, "{text}");
        assert!(text.contains("the sum is not shown to be nowhere positive"), "{text}");
    }
}

/// The same certificate with the last line that belongs to it: what the reader says it expects.
fn sealed(folder: &TempDir, statement: &str, certificate: &str, count: usize) -> String {
    let body: String = certificate
        .lines()
        .filter(|line| !line.starts_with("end "))
        .map(|line| format!("{line}\n"))
        .collect();
    let file = folder.path().join("unsealed.txt");
    fs::write(&file, format!("{body}end {count} {}\n", "0".repeat(64))).unwrap();
    let (status, text) = run(folder, &["check", statement, "unsealed.txt"]);
    let expected = text.split("expected `").nth(1).and_then(|rest| rest.split('`').next());
    let expected = expected.unwrap_or_else(|| panic!("{status}: {text}"));
    format!("{body}{expected}\n")
}

#[test]
fn places_are_fractions_and_decimals_have_true_minus_signs() {
    // Four corners of which one is reflex: the Jacobian determinant turns over there.
    let folder = TempDir::new().unwrap();
    let corners = "1,0,0; 0,1,0; 2/7,3/7,6/7; 0,0,1";
    let (status, text) =
        run(&folder, &["construct", "--bidegree", "4", "2", "--corners", corners, "-o", "out"]);
    assert_eq!(status, 0);
    assert!(
        text.starts_with("EXACT  polygon: a patch of bidegree (4,2) lies on the unit sphere; that it covers"),
        "{text}"
    );
    let reason = text.lines().nth(1).unwrap().trim();
    let place = reason.strip_prefix(
        "the Jacobian determinant is not positive on the whole square: it is negative at (u, v) = (",
    );
    let place = place.and_then(|rest| rest.strip_suffix(')')).unwrap_or_else(|| panic!("{reason}"));
    assert!(place.chars().all(|c| c.is_ascii_digit() || "/, ".contains(c)), "{place}");
    let folder = with(&sheet("\"a\"", "surface = \"Z - 2*W\"\n", "a"));
    let (_, text) = run(&folder, &["bound", "it.toml", "--set", "a=1", "--tolerance", "0.1", "-o", "out"]);
    assert!(text.starts_with("PROVED  it: −1.0 ≤ F/W ≤ −1.0 on the whole patch\n"), "{text}");
    assert!(joined(&text).contains("and there −1.0 ≤ F/W ≤ −1.0, for F = Z − 2·W."), "{text}");
    let (_, checked) = run(&folder, &["check", "out/statement.toml", &bounds_file(&folder)]);
    assert!(checked.contains("−1.0 ≤ F/W ≤ −1.0"), "{checked}");
    assert!(!checked.contains("-1.0"), "{checked}");
}

fn bounds_file(folder: &TempDir) -> String {
    let names = fs::read_dir(folder.path().join("out")).unwrap().map(|entry| entry.unwrap().file_name());
    let mut names = names.map(|name| name.into_string().unwrap());
    format!("out/{}", names.find(|name| name.starts_with("bounds-")).unwrap())
}

#[test]
fn one_number_has_one_spelling_in_json() {
    let folder = TempDir::new().unwrap();
    let arguments = ["construct", "--bidegree", "4", "2", "-o", "out", "--format", "json"];
    let (_, text) = run(&folder, &arguments);
    let data: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(data["net"], data["statement"]["net"]);
    assert!(!text.contains("sqrt(3)/"), "{text}");
}

/// Rounded numbers in the wrong convention: no convention makes them exact, and it is said which one comes near.
#[test]
fn a_rounded_net_in_the_wrong_convention_is_not_called_beyond_help() {
    let net = |convention: &str| {
        let [weight, product] =
            ["\"0.70710678\"", if convention == "right" { "1" } else { "\"0.70710678\"" }];
        with(&format!(
            "title = \"t\"\nradicands = []\nunknowns = []\nconvention = \"cartesian\"\nbidegree = [2, 1]\n\
             surface = \"X^2 + Y^2 - W^2\"\nnet = [[[1, 0, 0, 1], [1, 0, 1, 1]],\n\
             [[{product}, {product}, 0, {weight}], [{product}, {product}, {product}, {weight}]],\n\
             [[0, 1, 0, 1], [0, 1, 1, 1]]]\n"
        ))
    };
    let (status, text) = run(&net("wrong"), &["audit", "it.toml"]);
    assert_eq!(status, 1);
    assert!(text.contains("   read as premultiplied: the largest is c["), "{text}");
    assert!(
        text.contains("and the other convention does not put it there. What each convention leaves:\n"),
        "{text}"
    );
    // In the right one there is nothing better to say.
    let (status, text) = run(&net("right"), &["audit", "it.toml"]);
    assert_eq!(status, 1);
    assert!(!text.contains("With the whole net"), "{text}");
}

/// A value for each product is not yet a value for each unknown.
#[test]
fn the_only_solution_is_the_only_one() {
    let judged = |polynomials: &str, formula: &str, variables: &str, solution: &str| {
        let folder = TempDir::new().unwrap();
        let system = format!(
            "title = \"t\"\nradicands = []\nunknowns = [\"w\", \"z\"]\npolynomials = [{polynomials}]\n"
        );
        fs::write(folder.path().join("system.toml"), system).unwrap();
        let listing = format!(
            "title = \"t\"\nstatement = \"system.toml\"\nnotation = \"plain\"\nformulas = '{formula}'\n[[claim]]\nwhere = \"1\"\n\
             says = \"it has one solution\"\nsolve = [\"f1\"]\nvariables = [{variables}]\nsolution = {solution}\n"
        );
        fs::write(folder.path().join("it.toml"), listing).unwrap();
        run(&folder, &["audit", "it.toml"]).1
    };
    let text = judged("\"w - 2\"", "f1 = w - 2", "\"w\"", "{ w = \"2\", z = \"0\" }");
    assert!(text.contains("HOLDS") && text.contains("the only solution has w = 2\n"), "{text}");
    let text = judged("\"w^2 - 4\"", "f1 = w^2 - 4", "\"w^2\"", "{ w = \"2\", z = \"0\" }");
    assert!(text.contains("FAILS") && text.contains("they hold if and only if w² = 4\n"), "{text}");
    assert!(text.contains("which is also so with w = −2\n"), "{text}");
    let text = judged("\"w*z - 4\"", "f1 = w*z - 4", "\"w*z\"", "{ w = \"2\", z = \"2\" }");
    assert!(text.contains("NOT CHECKED") && !text.contains("the only solution"), "{text}");
}

/// Every check and every test that the page names exists.
#[test]
fn the_page_of_trust_names_what_there_is() {
    let page = fs::read_to_string("docs/trust.md").unwrap();
    let (mut tests, mut sources) = (String::new(), String::new());
    gather(Path::new("tests"), &mut tests);
    gather(Path::new("src"), &mut sources);
    let mut named = 0;
    for row in page.lines().filter(|line| line.starts_with("| ") && !line.starts_with("|---")) {
        let cells: Vec<&str> = row.split(" | ").collect();
        assert!(cells.len() >= 3, "{row}");
        let words = |cell: &str| cell.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
        for test in words(cells[cells.len() - 1]) {
            assert!(tests.contains(&format!("fn {test}(")), "no test {test}");
            named += 1;
        }
        for check in words(cells[1]).iter().filter(|word| word.starts_with(|c: char| c.is_ascii_uppercase()))
        {
            assert!(sources.contains(check.as_str()), "no check {check}");
        }
    }
    assert!(named > 40, "{named} tests are named");
}

fn gather(folder: &Path, text: &mut String) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            gather(&path, text);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            text.push_str(&fs::read_to_string(path).unwrap());
        }
    }
}
