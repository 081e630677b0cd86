//! Exact patches of spherical polygons, and which bidegrees have one.

use num_rational::BigRational;
use prove_cap::algebra::{FieldElement, Integer, MultiquadraticField, Sign, polynomial_from_exact, spell};
use prove_cap::catalogue;
use prove_cap::certificate::{Argument, Certificate, Cover, EdgeTree};
use prove_cap::checker::{
    CheckError, Claim, CoverRejection, Covered, ExactNet, ExactRejection, Rejection, SubdivisionRejection,
    Theorem, check, check_read,
};
use prove_cap::construction::{
    Cell, CoverError, How, Phase, Refusal, centre_of, classify, closing_argument, closing_statement,
    closing_values, construct, cover, elevated, tile, triple_products,
};
use prove_cap::control::Control;
use prove_cap::exact::Polynomial;
use prove_cap::geometry::{
    Complex, NamedPolygon, POLYGONS, Point, Polygon, PolygonError, Spinor, SpinorForm, Vector,
};
use prove_cap::proof::Proof;
use prove_cap::prove::{Attempt, prove};
use prove_cap::statement::{Statement, Subject};

fn control() -> Control {
    Control::default()
}

/// A point with rational coordinates p/q.
fn point(field: MultiquadraticField, [x, y, z, w]: [i64; 4]) -> Vector {
    [x, y, z].map(|x| field.rational(Integer::from(x), Integer::from(w)))
}

fn rational(points: &[[i64; 4]]) -> Result<Polygon, PolygonError> {
    let field = MultiquadraticField::new(&[]);
    Polygon::new(points.iter().map(|p| point(field, *p)).collect())
}

/// The net of a statement without unknowns.
fn net_of(statement: &Statement) -> Vec<Vec<Point>> {
    let field = prove_cap::problem::field_of(statement);
    let Subject::Patch(patch) = statement.subject() else { panic!("a patch") };
    let number = |entry: &Polynomial| polynomial_from_exact(field, entry).as_constant().unwrap();
    let row = |row: &Vec<[Polynomial; 4]>| row.iter().map(|point| point.each_ref().map(number)).collect();
    patch.net.iter().map(row).collect()
}

fn corners_of(theorem: &Theorem, field: MultiquadraticField) -> Vec<Vector> {
    let Claim::Cover(Covered { corners, .. }) = theorem.claim() else { panic!("a cover") };
    let number = |entry: &Polynomial| polynomial_from_exact(field, entry).as_constant().unwrap();
    corners.iter().map(|corner| corner.each_ref().map(number)).collect()
}

fn cube() -> Polygon {
    NamedPolygon::find("cube").unwrap().polygon()
}

/// The cover of the cube's face of bidegree (4,2), changed.
fn changed(change: impl Fn(&mut Cover)) -> Result<Theorem, CheckError> {
    let made = construct(&cube(), "cube", (4, 2), None, &control()).unwrap();
    let proof = made.cover.unwrap();
    let certificate = proof.certificate();
    let Argument::Cover(mut cover) = certificate.argument.clone() else { panic!("a cover") };
    change(&mut cover);
    check_read(&made.statement, &Certificate { argument: Argument::Cover(cover), ..certificate.clone() })
}

fn rejection(result: Result<Theorem, CheckError>) -> CoverRejection {
    match result {
        Err(CheckError::Rejected(Rejection::Cover(rejection))) => rejection,
        other => panic!("expected a rejection, found {other:?}"),
    }
}

#[test]
fn every_polygon_is_covered_where_the_theorem_says_so() {
    for named in POLYGONS {
        let polygon = named.polygon();
        for bidegree in [(2, 2), (3, 3), (4, 2), (2, 4), (3, 4), (4, 4), (5, 2)] {
            let exact = matches!(classify(Phase::of(&polygon), bidegree), Cell::Exact(_));
            match construct(&polygon, named.name, bidegree, None, &control()) {
                Ok(made) => {
                    assert!(exact, "{} {bidegree:?}", named.name);
                    let proof = made.cover.unwrap();
                    let theorem = proof.theorem();
                    let corners = corners_of(theorem, polygon.field());
                    let mut expected = polygon.corners().to_vec();
                    if polygon.is_triangle() {
                        expected.insert(2, expected[1].clone());
                    }
                    assert_eq!(corners, expected, "{} {bidegree:?}", named.name);
                }
                Err(Refusal::Impossible(cell)) => {
                    assert!(!exact);
                    assert_eq!(cell, Cell::NoClosure);
                }
                Err(other) => panic!("{} {bidegree:?}: {other}", named.name),
            }
        }
    }
}

#[test]
fn fifteen_points_are_enough_for_the_cap_and_their_jacobian_needs_no_halving() {
    let made = construct(&cube(), "cube", (4, 2), None, &control()).unwrap();
    assert_eq!(made.net.iter().map(Vec::len).sum::<usize>(), 15);
    assert!(matches!(made.how, How::Linear { tried: 0, .. }));
    let proof = made.cover.unwrap();
    let (certificate, theorem) = (proof.certificate(), proof.theorem());
    let Argument::Cover(cover) = &certificate.argument else { panic!("a cover") };
    // All 11·5 Bernstein coefficients are positive already.
    assert_eq!(cover.regular, [false]);
    assert!(!cover.inward);
    assert_eq!(theorem.kind(), "cover");
}

#[test]
fn the_checker_refuses_a_cover_that_is_not_one() {
    assert!(changed(|_| {}).is_ok());
    assert_eq!(
        rejection(changed(|cover| cover.inward = true)),
        CoverRejection::Subdivision(SubdivisionRejection::Sign { tree: "regular", node: 1 })
    );
    assert_eq!(
        rejection(changed(|cover| cover.edges[2] = EdgeTree::Point)),
        CoverRejection::Edge { edge: "v=0", expected: "a point" }
    );
    assert_eq!(
        rejection(changed(|cover| cover.denominator = vec![true, false, false])),
        CoverRejection::Subdivision(SubdivisionRejection::NeedlessHalving { tree: "denominator", node: 1 })
    );
    assert_eq!(
        rejection(changed(|cover| cover.edges[0] = EdgeTree::Arc(vec![true, false, false]))),
        CoverRejection::Subdivision(SubdivisionRejection::NeedlessHalving { tree: "u=0", node: 1 })
    );
}

/// A cover of a catalogue entry by trees without halving.
fn simple_cover(statement: &Statement, edges: [EdgeTree; 4]) -> Result<Theorem, CheckError> {
    let cover =
        Cover { values: vec![], denominator: vec![false], edges, inward: false, regular: vec![false] };
    check_read(statement, &Certificate { statement: statement.hash(), argument: Argument::Cover(cover) })
}

fn arcs() -> [EdgeTree; 4] {
    std::array::from_fn(|_| EdgeTree::Arc(vec![false]))
}

#[test]
fn edges_in_small_circles_are_refused() {
    let text = catalogue::find("stereographic").unwrap().statement();
    let statement = Statement::read(&text).unwrap();
    let Ok(Attempt::Proved { proof, .. }) = prove(&statement, &control()) else { panic!("exact") };
    let theorem = proof.theorem();
    let Claim::Exact(ExactNet { values, .. }) = theorem.claim() else { panic!("exact") };
    let cover = Cover {
        values: values.clone(),
        denominator: vec![false],
        edges: arcs(),
        inward: false,
        regular: vec![false],
    };
    let certificate = Certificate { statement: statement.hash(), argument: Argument::Cover(cover) };
    let refused = rejection(check_read(&statement, &certificate));
    assert_eq!(refused, CoverRejection::Edge { edge: "u=0", expected: "an arc of a great circle" });
}

/// Two thirds of a hemisphere: from the pole to an edge that runs through 240° of a great circle. Regular, with positive weights, but not
/// the triangle between its corners.
#[test]
fn an_edge_that_runs_the_longer_way_is_refused() {
    let field = MultiquadraticField::new(&[3]);
    let half = field.rational(Integer::from(1u32), Integer::from(2u32));
    let root = &field.integer(3).square_root().unwrap() * &half;
    let real =
        |x: &FieldElement, y: &FieldElement| Spinor([Complex::real(x.clone()), Complex::real(y.clone())]);
    let edge = [real(&field.one(), &field.zero()), real(&half, &root), real(&-&half, &root)];
    // The pole (0, 1, 0), turned along with the edge.
    let pole = Spinor([Complex::real(field.one()), Complex { re: field.zero(), im: field.one() }]);
    let turned = |Spinor([x, y]): &Spinor| pole.scaled(&Complex { re: x.re.clone(), im: -&y.re });
    let poles = edge.iter().map(turned).collect();
    let net = SpinorForm(vec![edge.to_vec(), poles]).image();
    assert!(net.iter().flatten().all(|[.., weight]| weight.sign() == Sign::Positive));
    let statement = Statement::read(&catalogue::net_statement("240 degrees", "", &net)).unwrap();
    let mut edges = arcs();
    edges[1] = EdgeTree::Point;
    assert_eq!(
        rejection(simple_cover(&statement, edges)),
        CoverRejection::Subdivision(SubdivisionRejection::Sign { tree: "u=0", node: 1 })
    );
}

#[test]
fn a_cover_of_another_surface_is_refused() {
    let text = catalogue::find("cap-4x2-exact").unwrap().statement().replace("- W^2", "- 2*W^2");
    let statement = Statement::read(&text).unwrap();
    assert!(matches!(
        rejection(simple_cover(&statement, arcs())),
        CoverRejection::Exact(ExactRejection::NotAZero { .. })
    ));
}

#[test]
fn two_edges_that_are_points_are_refused() {
    // All edges in one great circle, two of them points: a patch that is an arc.
    let row = "[[\"1\",\"0\",\"0\",\"1\"],[\"1\",\"0\",\"0\",\"1\"],[\"1\",\"0\",\"0\",\"1\"]]";
    let text = format!(
        "title = \"a point\"\nradicands = []\nunknowns = []\nconvention = \"homogeneous\"\nbidegree = [2, 2]\nnet = [{row},{row},{row}]\n"
    );
    let statement = Statement::read(&text).unwrap();
    let points = std::array::from_fn(|_| EdgeTree::Point);
    assert_eq!(rejection(simple_cover(&statement, points)), CoverRejection::Points { edge: "u=1" });
    assert_eq!(
        rejection(simple_cover(&statement, arcs())),
        CoverRejection::Edge { edge: "u=0", expected: "an arc of a great circle" }
    );
}

/// A net of the unit sphere over Q with one entry's sign turned: where the checker says it fails.
fn with_turned_sign(name: &str, from: &str) -> ExactRejection {
    let text = catalogue::find(name).unwrap().statement();
    assert!(text.contains(from), "{name}");
    let turned = from.replacen('"', "\"-", 1);
    let statement = Statement::read(&text.replacen(from, &turned, 1)).unwrap();
    let certificate = Certificate { statement: statement.hash(), argument: Argument::Exact(vec![]) };
    match check_read(&statement, &certificate) {
        Err(CheckError::Rejected(Rejection::Exact(rejection))) => rejection,
        other => panic!("expected a rejection, found {other:?}"),
    }
}

#[test]
fn one_turned_sign_in_cobbs_net_fails_at_a_named_coefficient() {
    let text = catalogue::find("cobb").unwrap().statement();
    let entry = text.split('[').filter(|point| point.starts_with("\"4")).nth(1).expect("an entry");
    let first = entry.split(',').next().unwrap().to_owned() + ",";
    let ExactRejection::NotAZero { equation, actual } = with_turned_sign("cobb", &first) else {
        panic!("no zero")
    };
    assert!(equation.to_string().starts_with("c["), "{equation}");
    assert_ne!(actual, "0");
}

#[test]
fn cobbs_net_and_the_octant_are_covers() {
    let statement = Statement::read(&catalogue::find("cobb").unwrap().statement()).unwrap();
    let net = net_of(&statement);
    let proof = cover(&statement, &net, &control()).unwrap();
    let theorem = proof.theorem();
    let Claim::Cover(Covered { corners, .. }) = theorem.claim() else { panic!("a cover") };
    assert_eq!(corners.len(), 4);
    let octant = NamedPolygon::find("octant").unwrap().polygon();
    let made = construct(&octant, "octant", (2, 2), None, &control()).unwrap();
    let Claim::Cover(Covered { point, .. }) = made.cover.unwrap().theorem().claim().clone() else {
        panic!("a cover")
    };
    assert_eq!(point, Some("u=1"));
}

#[test]
fn cobbs_net_is_a_member_of_the_symmetric_family() {
    let statement = Statement::read(&catalogue::find("cobb").unwrap().statement()).unwrap();
    let net = net_of(&statement);
    let centre = centre_of(&net).expect("Cobb's net has the symmetry of the square");
    println!("{}", spell(&centre));
    // One that is not: the patch of bidegree (4,2), its degree raised.
    let other = construct(&cube(), "cube", (4, 2), None, &control()).unwrap();
    assert_eq!(centre_of(&elevated(&other.net, (4, 4))), None);
}

#[test]
fn neighbours_meet_point_for_point() {
    for (named, count) in POLYGONS.iter().zip([(6, 12), (12, 24), (24, 48), (8, 12)]) {
        let bidegree = if named.polygon().is_triangle() { (2, 2) } else { (4, 2) };
        let tiled = tile(named, bidegree, &control()).unwrap();
        assert_eq!((tiled.faces.len(), tiled.seams.len()), count, "{}", named.name);
        assert!(tiled.seams.iter().all(|seam| seam.meets), "{}", named.name);
        assert!(tiled.faces.iter().all(|face| face.cover.is_ok()), "{}", named.name);
    }
}

#[test]
fn polygons_with_wrong_corners_are_refused() {
    let error = |points: &[[i64; 4]]| rational(points).unwrap_err();
    let [x, y, z] = [[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1]];
    assert_eq!(error(&[x, y]), PolygonError::Count(2));
    assert_eq!(error(&[x, y, z, [1, 1, 0, 1]]), PolygonError::OffSphere { corner: 4, excess: "1".into() });
    assert!(
        matches!(error(&[x, y, y, z]), PolygonError::Repeated { first: 2, second: 3, hint } if !hint.is_empty())
    );
    assert_eq!(error(&[x, y, x, z]), PolygonError::Repeated { first: 1, second: 3, hint: "" });
    assert_eq!(error(&[x, [-1, 0, 0, 1], y, z]), PolygonError::Antipodal { first: 1, second: 2 });
    let [a, b, c, d] = [[3, 4, 0, 5], [0, 3, 4, 5], [-3, 4, 0, 5], [0, 3, -4, 5]];
    assert!(rational(&[a, b, c, d]).is_ok());
    assert_eq!(error(&[a, c, b, d]), PolygonError::Crossing { first: 1, second: 3 });
    assert_eq!(error(&[a, b, d, c]), PolygonError::Crossing { first: 2, second: 4 });
}

#[test]
fn a_phase_that_closes_makes_the_answer_exact() {
    // The great circle: solid angle 2π, all corners on it.
    let circle = rational(&[[1, 0, 0, 1], [0, 1, 0, 1], [-1, 0, 0, 1], [0, -1, 0, 1]]).unwrap();
    // The four corners of a regular tetrahedron, in a circle: solid angle 2π.
    let field = MultiquadraticField::new(&[3]);
    let third = field.integer(3).square_root().unwrap().inverse().unwrap();
    let corner = |signs: [i64; 3]| signs.map(|sign| &third * &field.integer(sign));
    let tetrahedron =
        Polygon::new([[1, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]].map(corner).to_vec()).unwrap();
    for polygon in [circle, tetrahedron] {
        assert!(triple_products(&polygon).1.is_zero());
        assert_eq!(Phase::of(&polygon), Phase::Reversed);
        assert_eq!(classify(Phase::Reversed, (2, 2)), Cell::LongerWay);
        let statement = Statement::read(&closing_statement(&polygon, "closing")).unwrap();
        assert_eq!(closing_argument(&polygon).unwrap(), None);
        let values = closing_values(&polygon).unwrap();
        let values = values.into_iter().map(prove_cap::algebra::Polynomial::constant);
        let values = values.map(|value| prove_cap::algebra::polynomial_to_exact(&value).unwrap()).collect();
        let argument = Argument::Exact(values);
        let theorem = check_read(&statement, &Certificate { statement: statement.hash(), argument }).unwrap();
        assert_eq!(theorem.kind(), "solution");
        // The net is on the sphere, but it covers no polygon: an edge takes the longer way.
        let made = construct(&polygon, "closed", (2, 2), None, &control()).unwrap();
        assert_eq!(made.exact.theorem().kind(), "exact");
        let Err(CoverError::NotPositive { what, at, zero: false }) = made.cover else {
            panic!("{:?}", made.cover.map(|proof| proof.theorem().clone()));
        };
        assert_eq!(what, "an edge's side of its arc");
        // The place is on an edge.
        assert!(at.iter().any(num_rational::BigRational::is_integer), "{at:?}");
    }
}

/// A dozen convex quadrilaterals with rational corners, from rational points of the plane by stereographic projection.
fn quadrilaterals() -> Vec<Polygon> {
    let field = MultiquadraticField::new(&[]);
    let mut seed = 2u64;
    let mut next = |range: i64| {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        1 + ((seed >> 33) as i64).rem_euclid(range)
    };
    let mut found = Vec::new();
    while found.len() < 12 {
        let signs = [[-1i64, -1], [1, -1], [1, 1], [-1, 1]];
        let corners = signs.map(|[sx, sy]| {
            let (x, y, d) = (sx * next(9), sy * next(9), 3 + next(9));
            // (2dx, 2dy, d² − x² − y²)/(d² + x² + y²).
            point(field, [2 * d * x, 2 * d * y, d * d - x * x - y * y, d * d + x * x + y * y])
        });
        if let Ok(polygon) = Polygon::new(corners.to_vec())
            && polygon.is_convex()
        {
            found.push(polygon);
        }
    }
    found
}

/// Every patch of bidegree (2,2) whose corners are these and whose edges lie in great circles: three corner weights are 1 after a change
/// of parameters, the middle point of an edge is a multiple of (A + B, 1 + A·B), the centre is free.
fn biquadratic(polygon: &Polygon) -> Statement {
    let [a, b, c, d] = polygon.corners() else { panic!("a quadrilateral") };
    let corner = |p: &Vector, w: &str| {
        let [x, y, z] = p.each_ref().map(|x| format!("\"({})*{w}\"", spell(x)));
        format!("[{x}, {y}, {z}, \"{w}\"]")
    };
    let middle = |p: &Vector, q: &Vector, m: &str| {
        let one = p[0].field().one();
        let entries: Vec<FieldElement> = (0..3).map(|k| &p[k] + &q[k]).collect();
        let weight = &one + &prove_cap::geometry::dot(p, q);
        let all = entries.iter().chain([&weight]).map(|x| format!("\"({})*{m}\"", spell(x)));
        format!("[{}]", all.collect::<Vec<_>>().join(", "))
    };
    let text = format!(
        "title = \"biquadratic\"\nradicands = []\nunknowns = [\"m1\", \"m2\", \"m3\", \"m4\", \"d\", \"x\", \"y\", \"z\", \"w\"]\n\
         nonzero = [\"d\"]\nconvention = \"homogeneous\"\nbidegree = [2, 2]\nnet = [\n[{}, {}, {}],\n[{}, [\"x\", \"y\", \"z\", \"w\"], {}],\n[{}, {}, {}]\n]\n",
        corner(a, "1"),
        middle(a, d, "m1"),
        corner(d, "1"),
        middle(a, b, "m2"),
        middle(d, c, "m3"),
        corner(b, "1"),
        middle(b, c, "m4"),
        corner(c, "d"),
    );
    Statement::read(&text).unwrap()
}

#[test]
fn elimination_and_the_closing_condition_agree() {
    for polygon in quadrilaterals() {
        let closing = Statement::read(&closing_statement(&polygon, "closing")).unwrap();
        let argument = closing_argument(&polygon).unwrap().expect("convex: the phase is open");
        assert_eq!(Proof::of(&closing, argument, &control()).unwrap().theorem().kind(), "impossible");
        let statement = biquadratic(&polygon);
        match prove(&statement, &control()).unwrap() {
            Attempt::Proved { proof, .. } => assert_eq!(proof.theorem().kind(), "impossible"),
            Attempt::Undecided(reason) => panic!("{reason:?}"),
        }
        let made = construct(&polygon, "random", (4, 2), None, &control()).unwrap();
        assert!(made.cover.is_ok(), "{:?}", made.cover);
    }
}

#[test]
fn a_corner_that_is_not_convex_leaves_an_exact_patch_that_covers_nothing() {
    // The third corner lies inside the triangle of the others.
    let dart = rational(&[[1, 0, 0, 1], [0, 1, 0, 1], [2, 3, 6, 7], [0, 0, 1, 1]]);
    let dart = match dart {
        Ok(polygon) if !polygon.is_convex() => polygon,
        _ => rational(&[[1, 0, 0, 1], [0, 1, 0, 1], [6, 2, 3, 7], [0, 0, 1, 1]]).unwrap(),
    };
    assert!(!dart.is_convex());
    let made = construct(&dart, "dart", (4, 2), None, &control()).unwrap();
    assert_eq!(made.exact.theorem().kind(), "exact");
    assert!(
        matches!(made.cover, Err(CoverError::NotPositive { what: "the Jacobian determinant", .. })),
        "{:?}",
        made.cover
    );
}

#[test]
fn a_centre_is_for_the_square() {
    let field = MultiquadraticField::new(&[3]);
    let rhomb = NamedPolygon::find("rhombic-dodecahedron").unwrap().polygon();
    let refused = construct(&rhomb, "rhomb", (4, 4), Some(&field.one()), &control());
    assert!(matches!(refused, Err(Refusal::NoCentre)));
    let half = BigRational::new(1.into(), 2.into());
    let centre = prove_cap::algebra::Polynomial::constant(
        cube().field().rational(Integer::from_bigint(half.numer()), Integer::from_bigint(half.denom())),
    );
    let made = construct(&cube(), "cube", (4, 4), centre.as_constant().as_ref(), &control()).unwrap();
    assert_eq!(centre_of(&made.net), centre.as_constant());
}

#[test]
fn committed_covers_are_reproduced_to_the_byte() {
    for named in POLYGONS {
        let polygon = named.polygon();
        for (m, n) in [(2, 2), (4, 2), (2, 4)] {
            let folder = format!("proofs/degrees-{}/{m}x{n}", named.name);
            let Ok(committed) = std::fs::read_to_string(format!("{folder}/cover.txt")) else { continue };
            let made = construct(&polygon, named.name, (m, n), None, &control()).unwrap();
            assert_eq!(made.text, std::fs::read_to_string(format!("{folder}/statement.toml")).unwrap());
            let proof = made.cover.unwrap();
            let certificate = proof.certificate();
            assert_eq!(certificate.write(&made.statement.ring()), committed, "{folder}");
        }
    }
}

#[test]
fn a_cover_with_a_damaged_byte_is_no_cover() {
    let statement = std::fs::read("proofs/degrees-octant/2x2/statement.toml").unwrap();
    let text = std::fs::read("proofs/degrees-octant/2x2/cover.txt").unwrap();
    assert!(check(&statement, &text).is_ok());
    for position in 0..text.len() {
        for byte in [b'.', b'h', b'0', b'\n', b' ', text[position] ^ 1] {
            let mut damaged = text.clone();
            damaged[position] = byte;
            assert!(damaged == text || check(&statement, &damaged).is_err(), "byte {position}: {byte}");
        }
        let shorter = [&text[..position], &text[position + 1..]].concat();
        assert!(check(&statement, &shorter).is_err(), "without byte {position}");
    }
}
