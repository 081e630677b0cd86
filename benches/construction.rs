//! Exact patches: found and verified, verified alone, and whole tilings.

use divan::Bencher;
use prove_cap::checker::check_read;
use prove_cap::construction::{construct, tile};
use prove_cap::control::Control;
use prove_cap::geometry::{NamedPolygon, Polygon};

fn main() {
    divan::main();
}

fn cube() -> Polygon {
    NamedPolygon::find("cube").unwrap().polygon()
}

const BIDEGREES: [(u32, u32); 4] = [(4, 2), (4, 4), (6, 6), (8, 8)];

#[divan::bench(args = BIDEGREES, sample_count = 5)]
fn construct_and_verify(bidegree: (u32, u32)) {
    let made = construct(&cube(), "cube", bidegree, None, &Control::default()).unwrap();
    assert!(made.cover.is_ok());
}

#[divan::bench(args = BIDEGREES, sample_count = 5)]
fn check_of_a_cover(bencher: Bencher<'_, '_>, bidegree: (u32, u32)) {
    let made = construct(&cube(), "cube", bidegree, None, &Control::default()).unwrap();
    let proof = made.cover.unwrap();
    let certificate = proof.certificate();
    bencher.bench(|| check_read(&made.statement, certificate).unwrap());
}

#[divan::bench(args = BIDEGREES, sample_count = 5)]
fn check_of_the_identity(bencher: Bencher<'_, '_>, bidegree: (u32, u32)) {
    let made = construct(&cube(), "cube", bidegree, None, &Control::default()).unwrap();
    bencher.bench(|| check_read(&made.statement, made.exact.certificate()).unwrap());
}

#[divan::bench(args = ["cube", "rhombic-dodecahedron", "deltoidal-icositetrahedron"], sample_count = 3)]
fn tiling(name: &str) {
    let tiled = tile(NamedPolygon::find(name).unwrap(), (4, 2), &Control::default()).unwrap();
    assert!(tiled.seams.iter().all(|seam| seam.meets));
}
