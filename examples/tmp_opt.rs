use prove_cap::{approximation::*, catalogue, elimination::Control, statement::Statement};
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let text = catalogue::find(&name)
        .map(|e| e.statement())
        .unwrap_or_else(|| catalogue::cap(&name).unwrap().unwrap().statement());
    let st = Statement::read(&text).unwrap();
    let m = Model::of(&st).unwrap();
    for o in [Objective::Minimax, Objective::Outer, Objective::Inner, Objective::Width] {
        let (_, d, mut e) = tmp(&m, o, 1, &Control::default()).unwrap().unwrap();
        e.sort_by(|a, b| b.value.total_cmp(&a.value));
        println!("{o:?} {d:?}");
        let far = e.iter().map(|p| p.value.abs()).fold(0., f64::max);
        for p in &e {
            if p.u <= 0.5001 && p.v <= p.u + 1e-4 && p.value.abs() > 0.2 * far {
                println!("   {:.6} {:.6} {:e}", p.u, p.v, p.value);
            }
        }
    }
}
