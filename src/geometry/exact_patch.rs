//! Exact patches of spherical polygons, from spinors whose edges run along great circles.
//!
//! A real combination of two spinors p and q with ⟨p,q⟩ > 0 runs through the shorter arc between their points. Carried around
//! a quadrilateral in this way, corner by corner, the phase comes back changed by half the solid angle. A linear complex factor
//! along an edge makes up for it and moves no point: δ(f·s) = |f|²·δ(s).

use super::complex::{Complex, positive_root};
use super::cube_face::dot;
use super::polygon::Polygon;
use super::spinor::{Spinor, SpinorForm};
use crate::algebra::{FieldElement, Integer};

/// What is free in the construction.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Moduli {
    /// Which corner of the polygon is at u = v = 0: an odd number exchanges the pairs of edges.
    pub rotation: usize,
    /// Which of the edges v = 0 and v = 1 makes up for the phase.
    pub split: Split,
    /// Factors of the corner spinors, in the order of the corners.
    pub scales: Vec<FieldElement>,
}

/// Where the phase goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Split {
    /// One half to each edge.
    Even,
    /// All to v = 0.
    Low,
    /// All to v = 1.
    High,
}

impl Moduli {
    /// All scales 1, the phase split evenly.
    pub fn standard(polygon: &Polygon) -> Self {
        let one = polygon.field().one();
        Moduli { rotation: 0, split: Split::Even, scales: vec![one; polygon.corners().len()] }
    }
}

/// The corner spinors one after the other, each carried from its neighbour.
struct Carrier {
    polygon: Polygon,
    spinors: Vec<Spinor>,
    scales: Vec<FieldElement>,
}

impl Carrier {
    fn new(polygon: &Polygon, moduli: &Moduli) -> Self {
        let polygon = polygon.rotated(moduli.rotation);
        let mut scales = moduli.scales.clone();
        scales.rotate_left(moduli.rotation);
        Carrier { spinors: polygon.spinors(), polygon, scales }
    }

    fn start(&self) -> Spinor {
        self.spinors[0].scaled(&Complex::real(self.scales[0].clone()))
    }

    /// The spinor at corner `to` in phase with `spinor` at corner `from`, their lengths in the ratio of the scales.
    ///
    /// ⟨p, ⟨q,p⟩·q⟩ = |⟨p,q⟩|² > 0, and the length of ⟨q,p⟩·q is |p|·|q|²·√κ, κ = (1 + P·Q)/2. Where √κ is not in K, a
    /// rational near it stands for it; from even to odd corners on one side, from odd to even on the other, so that both
    /// directions of an edge agree.
    fn carried(&self, spinor: &Spinor, from: usize, to: usize) -> Option<Spinor> {
        let corners = self.polygon.corners();
        let field = self.polygon.field();
        let half = field.rational(Integer::one(), Integer::from(2u32));
        let kappa = &(&field.one() + &dot(&corners[from], &corners[to])) * &half;
        let other = &self.spinors[to];
        let root = match positive_root(&kappa) {
            Some(root) => root,
            None => {
                let near = near(&kappa);
                if from.is_multiple_of(2) { near } else { &kappa * &near.inverse()? }
            }
        };
        let ratio = &self.scales[to] * &self.scales[from].inverse()?;
        let factor = &ratio * &(&other.norm() * &root).inverse()?;
        Some(other.scaled(&other.product(spinor).scaled(&factor)))
    }
}

/// A rational near √x, with few digits, x in K positive and not small.
fn near(x: &FieldElement) -> FieldElement {
    let field = x.field();
    let scale = 64i64;
    // ⌊√x·64⌋ by bisection with exact signs.
    let (mut low, mut high) = (1i64, scale * 4);
    while high - low > 1 {
        let middle = (low + high) / 2;
        let trial = field.rational(Integer::from(middle), Integer::from(scale));
        match (x - &(&trial * &trial)).sign() {
            crate::algebra::Sign::Negative => high = middle,
            _ => low = middle,
        }
    }
    field.rational(Integer::from(low), Integer::from(scale))
}

/// f with spinors f·t = s.
fn ratio(s: &Spinor, t: &Spinor) -> Option<Complex> {
    let Spinor([a, b]) = t;
    match a.is_zero() {
        false => Some(s.0[0].times(&a.inverse()?)),
        true => Some(s.0[1].times(&b.inverse()?)),
    }
}

/// A positive multiple of √f, of length near |√f|: the bisector of 1 and f/|f|.
fn half(f: &Complex) -> Option<Complex> {
    let field = f.re.field();
    let one = Complex::real(field.one());
    let length = positive_root(&f.norm());
    let length = length.unwrap_or_else(|| near(&f.norm()));
    let sum = Complex::real(length).plus(f);
    if sum.is_zero() {
        return Some(Complex { re: field.zero(), im: one.re });
    }
    sum.direction().or_else(|| Some(sum.scaled(&near(&sum.norm()).inverse()?)))
}

/// ((1−u) + u·f)·((1−u)·p + u·q): Bernstein coefficients.
fn with_factor(f: &Complex, p: &Spinor, q: &Spinor) -> [Spinor; 3] {
    let field = f.re.field();
    let half = Complex::real(field.rational(Integer::one(), Integer::from(2u32)));
    [p.clone(), p.scaled(f).plus(q).scaled(&half), q.scaled(f)]
}

/// A spinor of bidegree (2,1) for a quadrilateral: its image has bidegree (4,2). The corners are at (u,v) = (0,0), (1,0), (1,1),
/// (0,1), from the one that the moduli say.
pub fn quadrilateral(polygon: &Polygon, moduli: &Moduli) -> Option<SpinorForm> {
    let carrier = Carrier::new(polygon, moduli);
    let start = carrier.start();
    let far = carrier.carried(&start, 0, 1)?;
    let side = carrier.carried(&start, 0, 3)?;
    let end = carrier.carried(&side, 3, 2)?;
    // f₁/f₀, so that f₀·far and f₁·end are in phase.
    let phase = ratio(&carrier.carried(&far, 1, 2)?, &end)?;
    let one = Complex::real(polygon.field().one());
    let (low, high) = match moduli.split {
        Split::Even => {
            let half = half(&phase)?;
            (half.conjugate(), phase.times(&half.conjugate()))
        }
        Split::Low => (phase.inverse()?, one),
        Split::High => (one, phase),
    };
    let rows = [with_factor(&low, &start, &far), with_factor(&high, &side, &end)];
    Some(SpinorForm((0..3).map(|i| rows.iter().map(|row| row[i].clone()).collect()).collect()))
}

/// A bilinear spinor for a quadrilateral around which no phase is left, and whether its edges are the shorter arcs: where the
/// phase is reversed, one of them is the longer one. `None` where there is a phase.
pub fn without_phase(polygon: &Polygon, moduli: &Moduli) -> Option<(SpinorForm, bool)> {
    let carrier = Carrier::new(polygon, moduli);
    let start = carrier.start();
    let far = carrier.carried(&start, 0, 1)?;
    let side = carrier.carried(&start, 0, 3)?;
    let end = carrier.carried(&side, 3, 2)?;
    let phase = ratio(&carrier.carried(&far, 1, 2)?, &end)?;
    let shorter = phase.re.sign() == crate::algebra::Sign::Positive;
    phase.im.is_zero().then(|| (SpinorForm(vec![vec![start, side], vec![far, end]]), shorter))
}

/// A bilinear spinor for a triangle: the edge u = 1 is one point, and its phase changes along it.
pub fn triangle(polygon: &Polygon, moduli: &Moduli) -> Option<SpinorForm> {
    let carrier = Carrier::new(polygon, moduli);
    let start = carrier.start();
    let side = carrier.carried(&start, 0, 2)?;
    let [low, high] = [carrier.carried(&start, 0, 1)?, carrier.carried(&side, 2, 1)?];
    Some(SpinorForm(vec![vec![start, side], vec![low, high]]))
}

/// A spinor of bidegree (2,2) for a quadrilateral that turns into itself when its corners are exchanged in a circle, all its edges
/// alike, about the axis through (0, 0, 1): the phase is split evenly among all four. The spinor at the centre is that of
/// the pole, in phase with the middles of the edges, times a number that is free.
pub fn biquartic(polygon: &Polygon, centre: &FieldElement) -> Option<SpinorForm> {
    let carrier = Carrier::new(polygon, &Moduli::standard(polygon));
    let start = carrier.start();
    let mut around = start.clone();
    for k in 0..4 {
        around = carrier.carried(&around, k, (k + 1) % 4)?;
    }
    // The fourth root of the phase that is missing.
    let factor = half(&half(&ratio(&start, &around)?)?)?;
    let mut corner = start;
    let mut edges = Vec::with_capacity(4);
    for k in 0..4 {
        let next = carrier.carried(&corner, k, (k + 1) % 4)?;
        let edge = with_factor(&factor, &corner, &next);
        corner = edge[2].clone();
        edges.push(edge);
    }
    if corner != edges[0][0] {
        return None;
    }
    let zero = Complex::real(centre.field().zero());
    let south = polygon.corners()[0][2].sign() == crate::algebra::Sign::Negative;
    let mut middle = [zero.clone(), zero];
    let pole = usize::from(south);
    middle[pole] = edges[0][1].0[pole].scaled(centre);
    let middle = Spinor(middle);
    let [bottom, right, top, left] = <[[Spinor; 3]; 4]>::try_from(edges).ok()?;
    // u along the first edge, v along the last one backwards.
    let row = |a: &Spinor, b: &Spinor, c: &Spinor| vec![a.clone(), b.clone(), c.clone()];
    Some(SpinorForm(vec![
        row(&bottom[0], &left[1], &left[0]),
        row(&bottom[1], &middle, &top[1]),
        row(&bottom[2], &right[1], &right[2]),
    ]))
}
