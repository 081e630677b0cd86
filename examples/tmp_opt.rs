use prove_cap::{approximation::*, catalogue, elimination::Control, statement::Statement};
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let text = catalogue::find(&name)
        .map(|e| e.statement())
        .unwrap_or_else(|| catalogue::cap(&name).unwrap().unwrap().statement());
    let st = Statement::read(&text).unwrap();
    let m = Model::of(&st).unwrap();

    let (_, d, e) = tmp(&m, Objective::Minimax, 1, &Control::default()).unwrap().unwrap();
    let far = e.iter().map(|p| p.value.abs()).fold(0., f64::max);
    println!("{d:?} {far:e}");
    let worst: Vec<_> = e.iter().copied().filter(|p| p.value.abs() > 0.5 * far).collect();
    let f: f64 = std::env::args().nth(2).unwrap().parse().unwrap();
    let eps = (far * f * 1e12).round() as i64;
    let one = 1_000_000_000_000i64;
    let t = std::time::Instant::now();
    match exclude(&st, [(one - eps).into(), (one + eps).into()], 12, &worst, &Control::default()) {
        Ok(b) => {
            println!("{} {} {:?}", b.theorem, b.boxes, t.elapsed());
            let text = b.certificate.write(&st.ring());
            println!("{}", text.len());
            std::fs::write("/work/scratch/t/u.txt", text).unwrap();
            let t = std::time::Instant::now();
            prove_cap::checker::check_read(&st, &b.certificate).unwrap();
            println!("check {:?}", t.elapsed());
        }
        Err(e) => println!("{e} {:?}", t.elapsed()),
    }
}
