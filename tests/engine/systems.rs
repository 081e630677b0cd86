//! Standard systems of computer algebra, whose answers are known from elsewhere.
//!
//! - katsura-n: 2ⁿ zeros; eco-n: 2ⁿ⁻² zeros; noon-n: 3ⁿ − 2n zeros; cyclic-5 and -6: 70 and 156 zeros, cyclic-4: a curve.
//!   Definitions and numbers: J. Verschelde, the database of polynomial systems, and the papers it names
//!   (Katsura 1987; Morgan 1987; Noonburg, SIAM J. Appl. Math. 49 (1989); Björck and Fröberg, J. Symb. Comp. 12 (1991)).
//! - 3-colourings of a graph as zeros of x³ − 1 for each vertex, x² + xy + y² for each edge: De Loera, Lee, Malkin,
//!   Margulies, ISSAC 2008, doi:10.1145/1390768.1390797. Graphs that cannot be coloured give certificates; in the others the
//!   zeros are counted and compared with the colourings, which are counted one by one.
//! - random dense quadratics, more than unknowns: without common zeros.

use itertools::Itertools;
use prove_cap::control::Control;
use prove_cap::elimination::{Outcome, Undecided, eliminate};
use prove_cap::problem::Problem;
use prove_cap::prove::{Attempt, prove};
use prove_cap::statement::Statement;

/// Polynomials in x0, x1, …
struct System {
    unknowns: usize,
    polynomials: Vec<String>,
}

#[derive(Debug, PartialEq)]
enum Answer {
    Impossible,
    /// Dimension and number of zeros.
    Consistent(usize, Option<usize>),
}

impl System {
    fn with(mut self, polynomial: &str) -> Self {
        self.polynomials.push(polynomial.to_owned());
        self
    }

    fn answer(&self) -> Answer {
        let names: Vec<String> = (0..self.unknowns).map(|k| format!("x{k}")).collect();
        let text = format!(
            "title = \"a system\"\nradicands = []\nunknowns = {names:?}\npolynomials = {:?}\n",
            self.polynomials
        );
        let statement = Statement::read(&text).unwrap_or_else(|error| panic!("{error}"));
        match eliminate(&Problem::of(&statement).system(&Control::default()).unwrap(), &Control::default()).1
        {
            Outcome::Unit(_) => match prove(&statement, &Control::default()).unwrap() {
                Attempt::Proved { proof, .. } if proof.theorem().kind() == "impossible" => Answer::Impossible,
                other => panic!("{other:?}"),
            },
            Outcome::Open(Undecided::Consistent(closure)) => {
                assert!(closure.verified, "a basis that is reported was verified over K");
                Answer::Consistent(closure.dimension, closure.zeros)
            }
            other => panic!("{other:?}"),
        }
    }
}

/// Magnetism: x0 + 2·(x1 + … + xn) = 1, Σ x|l|·x|m−l| = xm for m < n.
fn katsura(n: i32) -> System {
    let sum: String = (1..=n).map(|k| format!(" + 2*x{k}")).collect();
    let mut polynomials = vec![format!("x0{sum} - 1")];
    for m in 0..n {
        let terms =
            (-n..=n).filter(|l| (m - l).abs() <= n).map(|l| format!("x{}*x{}", l.abs(), (m - l).abs()));
        polynomials.push(format!("{} - x{m}", terms.collect::<Vec<_>>().join(" + ")));
    }
    System { unknowns: n as usize + 1, polynomials }
}

/// Cyclic n-roots: the sums of products of d neighbours, and the product of all less 1.
fn cyclic(n: usize) -> System {
    let product = |from: usize, count: usize| (from..from + count).map(|k| format!("x{}", k % n)).join("*");
    let mut polynomials: Vec<String> = (1..n).map(|d| (0..n).map(|k| product(k, d)).join(" + ")).collect();
    polynomials.push(format!("{} - 1", product(0, n)));
    System { unknowns: n, polynomials }
}

/// A neural network: Σ_{j≠i} xi·xj² − 1.1·xi + 1, times 10.
fn noon(n: usize) -> System {
    let of = |i: usize| {
        let squares = (0..n).filter(|&j| j != i).map(|j| format!("10*x{i}*x{j}^2")).join(" + ");
        format!("{squares} - 11*x{i} + 10")
    };
    System { unknowns: n, polynomials: (0..n).map(of).collect() }
}

/// Economics: xₙ·(x_k + Σ x_i·x_{i+k}) = k, Σ x_i = −1; the unknowns x0, … stand for x₁, ….
fn eco(n: usize) -> System {
    let mut polynomials: Vec<String> = (1..n)
        .map(|k| {
            let products: String = (1..n - k).map(|i| format!(" + x{}*x{}", i - 1, i + k - 1)).collect();
            format!("x{}*(x{}{products}) - {k}", n - 1, k - 1)
        })
        .collect();
    polynomials.push(format!("{} + 1", (0..n - 1).map(|k| format!("x{k}")).join(" + ")));
    System { unknowns: n, polynomials }
}

/// Vertices 0..count, edges.
struct Graph {
    count: usize,
    edges: Vec<(usize, usize)>,
}

impl Graph {
    fn complete(count: usize) -> Self {
        Graph { count, edges: (0..count).array_combinations().map(|[a, b]| (a, b)).collect() }
    }

    fn cycle(count: usize) -> Self {
        Graph { count, edges: (0..count).map(|k| (k, (k + 1) % count)).collect() }
    }

    /// A cycle and a hub joined to all of it: three colours do for an even cycle only.
    fn wheel(rim: usize) -> Self {
        let mut graph = Graph::cycle(rim);
        graph.edges.extend((0..rim).map(|k| (k, rim)));
        Graph { count: rim + 1, ..graph }
    }

    /// Mycielski's construction: one colour more, no new triangle. From the cycle of 5 it makes Grötzsch's graph.
    fn mycielskian(&self) -> Self {
        let n = self.count;
        let mut edges = self.edges.clone();
        edges.extend(self.edges.iter().flat_map(|&(a, b)| [(a, b + n), (b, a + n)]));
        edges.extend((0..n).map(|k| (k + n, 2 * n)));
        Graph { count: 2 * n + 1, edges }
    }

    /// Two rhombi with a common tip, their other tips joined (Moser and Moser 1961): four colours.
    fn spindle() -> Self {
        let edges = [(0, 1), (0, 2), (1, 2), (1, 3), (2, 3), (0, 4), (0, 5), (4, 5), (4, 6), (5, 6), (3, 6)];
        Graph { count: 7, edges: edges.to_vec() }
    }

    fn colourings(&self) -> usize {
        let all = (0..self.count).map(|_| 0..3).multi_cartesian_product();
        all.filter(|colours| self.edges.iter().all(|&(a, b)| colours[a] != colours[b])).count()
    }

    fn system(&self) -> System {
        let vertices = (0..self.count).map(|k| format!("x{k}^3 - 1"));
        let edges = self.edges.iter().map(|(a, b)| format!("x{a}^2 + x{a}*x{b} + x{b}^2"));
        System { unknowns: self.count, polynomials: vertices.chain(edges).collect() }
    }
}

/// Quadratics with coefficients from a linear congruential generator (Knuth, TAOCP 2, section 3.3.4).
fn random_quadratics(unknowns: usize, count: usize) -> System {
    let mut state = 1u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) % 19 + 1
    };
    let polynomials = (0..count).map(|_| {
        let squares = (0..unknowns).combinations_with_replacement(2);
        let terms: Vec<String> =
            squares.map(|pair| format!("{}*x{}*x{}", next(), pair[0], pair[1])).collect();
        let linear: Vec<String> = (0..unknowns).map(|k| format!("{}*x{k}", next())).collect();
        format!("{} - {} - {}", terms.join(" + "), linear.join(" - "), next())
    });
    let polynomials = polynomials.collect();
    System { unknowns, polynomials }
}

#[test]
fn consistent_systems_have_as_many_zeros_as_published() {
    let finite = |zeros: usize| Answer::Consistent(0, Some(zeros));
    assert_eq!(katsura(3).answer(), finite(1 << 3));
    assert_eq!(katsura(4).answer(), finite(1 << 4));
    assert_eq!(cyclic(5).answer(), finite(70));
    assert_eq!(noon(3).answer(), finite(27 - 6));
    assert_eq!(eco(4).answer(), finite(1 << 2));
    assert_eq!(eco(5).answer(), finite(1 << 3));
    assert_eq!(cyclic(4).answer(), Answer::Consistent(1, None));
}

#[test]
#[ignore = "long"]
fn larger_consistent_systems_have_as_many_zeros_as_published() {
    assert_eq!(cyclic(6).answer(), Answer::Consistent(0, Some(156)));
    assert_eq!(noon(4).answer(), Answer::Consistent(0, Some(81 - 8)));
    assert_eq!(eco(6).answer(), Answer::Consistent(0, Some(1 << 4)));
}

#[test]
fn one_equation_more_makes_them_inconsistent() {
    assert_eq!(katsura(4).with("x0*x4 - 2").answer(), Answer::Impossible);
    assert_eq!(cyclic(5).with("x0^2 - 2*x1").answer(), Answer::Impossible);
    assert_eq!(noon(3).with("x0 + x1 - 3").answer(), Answer::Impossible);
    assert_eq!(eco(6).with("x0*x1 - 7").answer(), Answer::Impossible);
    // but not every equation does
    assert_eq!(cyclic(4).with("x0^2 - 2*x1").answer(), Answer::Consistent(0, Some(6)));
}

#[test]
#[ignore = "long"]
fn one_equation_more_makes_larger_ones_inconsistent() {
    assert_eq!(katsura(6).with("x0*x6 - 2").answer(), Answer::Impossible);
    assert_eq!(cyclic(6).with("x0^2 - 2*x1").answer(), Answer::Impossible);
}

#[test]
fn graphs_that_need_four_colours_are_refuted() {
    for graph in [Graph::complete(4), Graph::wheel(5), Graph::wheel(7), Graph::spindle()] {
        assert_eq!(graph.colourings(), 0);
        assert_eq!(graph.system().answer(), Answer::Impossible);
    }
    let groetzsch = Graph::cycle(5).mycielskian();
    assert_eq!((groetzsch.count, groetzsch.edges.len(), groetzsch.colourings()), (11, 20, 0));
    assert_eq!(groetzsch.system().answer(), Answer::Impossible);
}

#[test]
fn graphs_that_need_three_are_not_and_their_colourings_are_counted() {
    for graph in [Graph::complete(3), Graph::cycle(5), Graph::wheel(4), Graph::complete(2).mycielskian()] {
        let colourings = graph.colourings();
        assert!(colourings > 0);
        assert_eq!(graph.system().answer(), Answer::Consistent(0, Some(colourings)));
    }
}

#[test]
fn random_quadratics_in_excess_are_refuted() {
    for (unknowns, count) in [(3, 5), (4, 6), (5, 8), (6, 10)] {
        assert_eq!(random_quadratics(unknowns, count).answer(), Answer::Impossible);
    }
    // As many as unknowns have 2ⁿ zeros (Bézout).
    assert_eq!(random_quadratics(3, 3).answer(), Answer::Consistent(0, Some(8)));
}

#[test]
#[ignore = "long"]
fn more_random_quadratics_in_excess_are_refuted() {
    for (unknowns, count) in [(7, 12), (8, 14)] {
        assert_eq!(random_quadratics(unknowns, count).answer(), Answer::Impossible);
    }
}
