//! How long an audit takes: the paper's formulas, its claims, and a net with one wrong sign.

use divan::Bencher;
use prove_cap::audit::net::NetAudit;
use prove_cap::audit::{Audit, PAPER};
use prove_cap::catalogue;
use prove_cap::control::Control;
use prove_cap::formats::listing::Listing;
use prove_cap::formats::net::{PrintedNet, from_json};
use prove_cap::statement::Statement;

fn main() {
    divan::main();
}

fn paper() -> (Listing, Statement) {
    let statement = Statement::read(&catalogue::find("cap-2x2").unwrap().statement()).unwrap();
    (Listing::from_toml(PAPER).unwrap(), statement)
}

fn cobb() -> PrintedNet {
    from_json(include_str!("../tests/data/nets/cobb-4x4.json")).unwrap()
}

#[divan::bench]
fn read_the_papers_listing() -> Listing {
    Listing::from_toml(PAPER).unwrap()
}

#[divan::bench]
fn the_papers_formulas(bencher: Bencher) {
    let (listing, statement) = paper();
    let listing = Listing { claims: Vec::new(), ..listing };
    bencher.bench(|| Audit::of(&listing, &statement, &Control::default()).unwrap());
}

#[divan::bench]
fn the_paper_with_its_claims(bencher: Bencher) {
    let (listing, statement) = paper();
    bencher.bench(|| Audit::of(&listing, &statement, &Control::default()).unwrap());
}

#[divan::bench]
fn cobbs_net(bencher: Bencher) {
    let net = cobb();
    bencher.bench(|| NetAudit::of(&net, &Control::default()).unwrap());
}

#[divan::bench]
fn cobbs_net_with_a_wrong_sign(bencher: Bencher) {
    let mut net = cobb();
    net.points[1][2][1] = net.points[1][2][1].negate();
    bencher.bench(|| NetAudit::of(&net, &Control::default()).unwrap());
}
