//! The surface condition: two expansions of one definition, and what it must say.

use proptest::prelude::*;
use prove_cap::algebra::{
    FieldElement, Integer, Monomial, MultiquadraticField, Polynomial, polynomial_from_exact,
};
use prove_cap::bezier::{BernsteinForm, RationalArc, binomial};
use prove_cap::certificate::Premise;
use prove_cap::checker::Equations;
use prove_cap::control::Control;
use prove_cap::exact::Work;
use prove_cap::geometry::{CubeFace, GreatCircleArc, dot};
use prove_cap::problem::{Problem, field_of};
use prove_cap::statement::{Statement, Subject};
use prove_cap::{catalogue, expand};

fn condition(statement: &Statement) -> BernsteinForm {
    let problem = Problem::of(statement);
    problem.condition(&Control::default()).unwrap().unwrap().clone()
}

/// A statement with a random net in two unknowns and a random choice of surface and convention.
fn random_statement() -> impl Strategy<Value = String> {
    let entry = prop_oneof![
        4 => (-5i32..6, 1i32..4).prop_map(|(n, d)| format!("{n}/{d}")),
        1 => (-3i32..4).prop_map(|n| format!("{n}*sqrt(2)/3 + 1")),
        2 => Just("p".to_owned()),
        1 => Just("q*p - sqrt(2)".to_owned()),
        1 => Just("q".to_owned()),
    ];
    let surface = prop_oneof![
        Just("X^2 + Y^2 + Z^2 - W^2"),
        Just("X^2 + Y^2 - W^2"),
        Just("X*W - Y*Z"),
        Just("X^3 - sqrt(2)*Y^2*W + Z*W^2"),
        Just("X - 2*W"),
    ];
    (1usize..4, 1usize..4, surface, any::<bool>()).prop_flat_map(move |(m, n, surface, cartesian)| {
        let point = prop::collection::vec(entry.clone(), 4);
        let net = prop::collection::vec(prop::collection::vec(point, n + 1), m + 1);
        net.prop_map(move |net| {
            let convention = if cartesian { "cartesian" } else { "homogeneous" };
            format!(
                "title = \"random\"\nradicands = [2]\nunknowns = [\"p\", \"q\"]\nconvention = \"{convention}\"\n\
                 bidegree = [{m}, {n}]\nsurface = \"{surface}\"\nnet = {net:?}\n"
            )
        })
    })
}

fn small(field: MultiquadraticField, n: i64, d: i64) -> FieldElement {
    field.rational(Integer::from(n), Integer::from(d))
}

/// f(u, v) by the definition of the scaled basis, as a polynomial in the unknowns.
fn value_of_form(form: &BernsteinForm, u: &FieldElement, v: &FieldElement) -> Polynomial {
    let field = u.field();
    let power = |x: &FieldElement, e: u32| (0..e).fold(field.one(), |p, _| &p * x);
    let (u1, v1) = (&field.one() - u, &field.one() - v);
    let (m, n) = form.bidegree();
    form.coefficients().fold(Polynomial::zero(field), |sum, (r, s, c)| {
        let weight = &(&power(u, r) * &power(&u1, m - r)) * &(&power(v, s) * &power(&v1, n - s));
        sum.add_scaled(&weight, c)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn prover_and_checker_expand_alike(text in random_statement()) {
        let statement = Statement::read(&text).unwrap();
        let form = condition(&statement);
        let equations = Equations::of(&statement, &mut Work::full()).unwrap();
        let mut count = 0;
        for (r, s, c) in form.coefficients() {
            let theirs = equations.get(Premise::Coefficient(r, s)).unwrap();
            prop_assert_eq!(c, &polynomial_from_exact(field_of(&statement), theirs), "c[{},{}]", r, s);
            count += 1;
        }
        prop_assert_eq!(equations.iter().count(), count);
    }

    /// F at a point, straight from the surface and the net, is Σ c[r,s]·basis there.
    #[test]
    fn the_form_is_the_surface_on_the_patch(text in random_statement(), u in 0i64..8, v in 0i64..8) {
        let statement = Statement::read(&text).unwrap();
        let field = field_of(&statement);
        let Subject::Patch(patch) = statement.subject() else { panic!("a patch") };
        let (u, v) = (small(field, u, 7), small(field, v, 5));
        let coordinates: Vec<Polynomial> = (0..4).map(|k| {
            let form = BernsteinForm::from_bernstein(field, patch.bidegree, |i, j| {
                polynomial_from_exact(field, &patch.net[i][j][k])
            });
            value_of_form(&form, &u, &v)
        }).collect();
        let surface = polynomial_from_exact(field, &patch.surface);
        let direct = surface.terms().iter().fold(Polynomial::zero(field), |sum, (monomial, c)| {
            let factors = monomial.powers().iter().flat_map(|&(k, e)| {
                std::iter::repeat_n(&coordinates[usize::from(k)], e as usize)
            });
            sum.add(&factors.fold(Polynomial::constant(c.clone()), |product, factor| product.multiply(factor)))
        });
        prop_assert_eq!(value_of_form(&condition(&statement), &u, &v), direct);
    }

    #[test]
    fn both_bases_give_the_same_function(text in random_statement(), u in -3i64..4, v in -3i64..4) {
        let statement = Statement::read(&text).unwrap();
        let field = field_of(&statement);
        let form = condition(&statement);
        let (u, v) = (small(field, u, 2), small(field, v, 3));
        let power = |x: &FieldElement, e: u32| (0..e).fold(field.one(), |p, _| &p * x);
        let by_powers = form.to_monomial_basis().iter().fold(Polynomial::zero(field), |sum, (k, l, a)| {
            sum.add_scaled(&(&power(&u, *k) * &power(&v, *l)), a)
        });
        prop_assert_eq!(by_powers, value_of_form(&form, &u, &v));
    }

    #[test]
    fn degree_elevation_keeps_the_curve(numbers in prop::collection::vec(-9i64..10, 12), t in -2i64..5) {
        let field = MultiquadraticField::new(&[]);
        let points = numbers.chunks(4).map(|p| std::array::from_fn(|k| field.integer(p[k]))).collect();
        let curve = RationalArc { points };
        let t = small(field, t, 3);
        let at = |curve: &RationalArc, k: usize| {
            let n = curve.degree();
            let power = |x: &FieldElement, e: u32| (0..e).fold(field.one(), |p, _| &p * x);
            let rest = &field.one() - &t;
            (0u32..).zip(&curve.points).fold(field.zero(), |sum, (i, point)| {
                let basis = &power(&t, i) * &power(&rest, n - i);
                &sum + &(&(&basis * &point[k]) * &field.rational(binomial(n, i), Integer::one()))
            })
        };
        for degree in [3, 6] {
            let elevated = curve.elevated_to(degree);
            prop_assert_eq!(elevated.degree(), degree);
            for k in 0..4 {
                prop_assert_eq!(at(&elevated, k), at(&curve, k));
            }
        }
    }
}

#[test]
fn the_arcs_of_the_cube_lie_on_the_sphere_and_touch_the_corners() {
    let field = MultiquadraticField::new(&[2, 3]);
    let face = CubeFace::derive(field).unwrap();
    for arc in [face.edge_along_u(0), face.edge_along_u(1), face.edge_along_v(0), face.edge_along_v(1)] {
        let arc = arc.unwrap();
        assert!(dot(&arc.start, &arc.start).is_one() && dot(&arc.end, &arc.end).is_one());
        // The tangents' intersection: P·A = P·B = 1.
        assert!(dot(&arc.tangents_meet, &arc.start).is_one() && dot(&arc.tangents_meet, &arc.end).is_one());
        let curve = arc.to_curve();
        let sphere = |a: &[FieldElement; 4], b: &[FieldElement; 4]| {
            let [x, y, z, w] = std::array::from_fn(|k| &a[k] * &b[k]);
            &(&(&x + &y) + &z) - &w
        };
        let p = &curve.points;
        let two = field.integer(2);
        // ⟨C,C⟩ = 0 for the quadratic C: five coefficients, of which the outer two are the corners'.
        assert!(sphere(&p[0], &p[1]).is_zero() && sphere(&p[1], &p[2]).is_zero());
        assert!((&(&two * &sphere(&p[1], &p[1])) + &sphere(&p[0], &p[2])).is_zero());
    }
}

#[test]
fn an_arc_whose_weight_is_outside_the_field_is_refused() {
    let field = MultiquadraticField::new(&[]);
    let [zero, one] = [field.zero(), field.one()];
    let (x, y) = ([one.clone(), zero.clone(), zero.clone()], [zero.clone(), one, zero]);
    assert_eq!(GreatCircleArc::between(&x, &y), None, "cos 45° is √2/2");
}

/// Section 3.1 of the paper: which coefficients of its polynomial F are equal.
#[test]
fn the_papers_symmetries_hold() {
    let statement = Statement::read(&catalogue::find("cap-2x2").unwrap().statement()).unwrap();
    let list = expand::coefficients(&statement, expand::Basis::Monomial).unwrap().unwrap();
    let a = |k: usize| {
        let name = format!("a{k}");
        polynomial_from_exact(field_of(&statement), &list.iter().find(|c| c.name == name).unwrap().value)
    };
    let minus_two = field_of(&statement).integer(-2);
    assert_eq!(a(2), a(5));
    assert_eq!(a(3), a(9));
    assert_eq!(a(4), a(13));
    assert_eq!(a(3), a(4).scaled(&minus_two));
    assert_eq!(a(7), a(10));
    assert_eq!(a(8), a(14));
    assert_eq!(a(12), a(15));
    assert_eq!(a(12), a(16).scaled(&minus_two));
    assert_ne!(a(1), a(2));
    // Eq. 11 prints a1 in this form.
    let (w, wz) = (Monomial::variable(0), Monomial::from_powers(vec![(0, 1), (1, 1)]));
    assert_eq!(a(1).coefficient(&w), Some(&field_of(&statement).integer(-8)));
    assert_eq!(a(1).terms().len(), 3);
    assert!(a(1).coefficient(&wz).is_some_and(|c| !c.is_rational()));
}
