use prove_cap::{approximation::enclose, catalogue, elimination::Control, exact::Work, statement::Statement};
fn main() {
    let text = catalogue::find("cap-2x2").unwrap().statement();
    let st = Statement::read(&text).unwrap();
    let places: u32 = std::env::args().nth(1).unwrap().parse().unwrap();
    let ring = st.ring();
    let vals: Vec<_> = std::env::args().skip(2).map(|s| ring.read(&s, &mut Work::full()).unwrap()).collect();
    let t = std::time::Instant::now();
    match enclose(&st, &vals, places, &Control::default()) {
        Ok(e) => {
            println!("{}\n{:?}", e.theorem, t.elapsed());
            let text = e.certificate.write(&ring);
            println!("{}", text.len());
            let t = std::time::Instant::now();
            prove_cap::checker::check_read(&st, &e.certificate).unwrap();
            println!("check {:?}", t.elapsed());
            std::fs::write("/work/scratch/t/b.txt", text).unwrap();
        }
        Err(e) => println!("{e}"),
    }
}
