//! What searches for proofs, nets and best values: laws, known answers, and twins that must fail.

mod algebra;
mod bounds;
mod choices;
mod construction;
mod expansion;
mod families;
mod lifting;
mod refutation;
mod roots;
mod scale;
mod scaling;
mod stopping;
mod systems;
mod zeros;
