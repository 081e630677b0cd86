//! Infinitely many zeros: unknowns are given values one after another, until finitely many zeros are left.

use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::ops::ControlFlow;
use std::rc::Rc;

use super::closure::Closure;
use super::derivation::Derivation;
use super::points::points_in_field;
use super::strategy::Strategy;
use super::system::System;
use super::{Outcome, Undecided, run};
use crate::algebra::{FieldElement, Integer, Polynomial};
use crate::control::{Control, Interrupted};

/// The values that are tried, in this order: (numerator, denominator).
pub const VALUES: [(i64, u32); 5] = [(1, 1), (0, 1), (-1, 1), (2, 1), (1, 2)];

/// Systems that are solved at most.
const ATTEMPTS: usize = 100;

/// A zero, and the values that were chosen before it was isolated.
#[derive(Debug, Clone)]
pub struct ChosenZero {
    /// What was chosen, in the order of choice.
    pub chosen: Vec<(u16, FieldElement)>,
    /// The zero, by variable.
    pub zero: Vec<FieldElement>,
}

/// What was tried.
#[derive(Debug, Clone, Default)]
pub struct Tried {
    /// The unknowns that were given values, increasing.
    pub unknowns: Vec<u16>,
    /// Choices for which the rest was solved.
    pub choices: usize,
    /// The first choice that leaves finitely many zeros, none of them in K.
    pub isolated: Option<Isolated>,
}

/// A system that a choice of values has left with finitely many zeros.
#[derive(Debug, Clone)]
pub struct Isolated {
    /// What was chosen, in the order of choice.
    pub chosen: Vec<(u16, FieldElement)>,
    /// The system with these values.
    pub system: System,
    /// What it is equivalent to.
    pub closure: Closure,
}

/// Zeros of a system that has infinitely many: to the variables in `order`, those that are not determined, values are
/// given, and the rest is solved. `visit` is shown each zero and ends the search when it is content.
///
/// Choices are tried in the order of how far they are from "1 for all": each step to the next value, and each
/// variable left out, counts one. So the order depends on the system alone.
///
/// # Errors
/// When interrupted; what was shown before remains true.
pub fn choose(
    system: &System,
    closure: &Closure,
    order: &[u16],
    control: &Control,
    visit: &mut dyn FnMut(ChosenZero) -> ControlFlow<()>,
) -> Result<Tried, Interrupted> {
    let field = system.field();
    let mut tried = Tried::default();
    let mut queue = Queue::default();
    queue.open(0, Rc::new(Open::new(system, closure, Vec::new())), 0);
    while let Some(task) = queue.next() {
        control.check()?;
        let (open, at, value) = (&task.open, task.at, task.value);
        let Some(&variable) = order.get(at) else { continue };
        let Some(value) = value else {
            if open.determined.contains(&variable) {
                queue.open(task.cost, Rc::clone(open), at + 1);
                continue;
            }
            for (cost, (numerator, denominator)) in (task.cost..).zip(VALUES) {
                let value = field.rational(Integer::from(numerator), Integer::from(denominator));
                queue.push(cost, Rc::clone(open), at, Some(value));
            }
            queue.open(task.cost + 1, Rc::clone(open), at + 1);
            continue;
        };
        if tried.choices >= ATTEMPTS {
            break;
        }
        tried.choices += 1;
        tried.unknowns.push(variable);
        let difference = Polynomial::variable(field, variable).add(&Polynomial::constant(-&value));
        let smaller = open.system.with_equation(difference);
        let chosen: Vec<_> = open.chosen.iter().cloned().chain([(variable, value)]).collect();
        let zeros = match run(&mut Derivation::new(&smaller), Strategy::Thorough, control)? {
            Outcome::Point(zero) => vec![zero],
            Outcome::Open(Undecided::Consistent(closure)) if closure.dimension == 0 => {
                let zeros = points_in_field(&smaller, &closure, control)?;
                if zeros.is_empty() && tried.isolated.is_none() {
                    tried.isolated = Some(Isolated { chosen: chosen.clone(), system: smaller, closure });
                }
                zeros
            }
            Outcome::Open(Undecided::Consistent(closure)) => {
                queue.open(task.cost, Rc::new(Open::new(&smaller, &closure, chosen.clone())), at + 1);
                Vec::new()
            }
            Outcome::Unit(_) | Outcome::Open(_) => Vec::new(),
        };
        for zero in zeros {
            if visit(ChosenZero { chosen: chosen.clone(), zero }).is_break() {
                return Ok(tried);
            }
        }
    }
    tried.unknowns.sort_unstable();
    tried.unknowns.dedup();
    Ok(tried)
}

/// A system with infinitely many zeros.
struct Open {
    system: System,
    chosen: Vec<(u16, FieldElement)>,
    /// Variables that satisfy an equation without others.
    determined: Vec<u16>,
}

impl Open {
    fn new(system: &System, closure: &Closure, chosen: Vec<(u16, FieldElement)>) -> Self {
        let equations = || closure.linear.iter().chain(&closure.basis);
        let alone = |polynomial: &Polynomial| match polynomial.variables()[..] {
            [variable] => Some(variable),
            _ => None,
        };
        // A verified basis has the same zeros, and is the shorter way to what follows.
        let system =
            if closure.verified { system.with_equations(equations().cloned()) } else { system.clone() };
        Open { system, chosen, determined: equations().filter_map(alone).collect() }
    }
}

/// To give the variable at this place of the order its value, or to look which values to give it.
struct Task {
    cost: u32,
    open: Rc<Open>,
    at: usize,
    value: Option<FieldElement>,
}

/// Tasks by cost; of the same cost those that are further on first, then the older ones.
#[derive(Default)]
struct Queue {
    order: BinaryHeap<Reverse<(u32, Reverse<usize>, usize)>>,
    tasks: Vec<Option<Task>>,
}

impl Queue {
    fn open(&mut self, cost: u32, open: Rc<Open>, at: usize) {
        self.push(cost, open, at, None);
    }

    fn push(&mut self, cost: u32, open: Rc<Open>, at: usize, value: Option<FieldElement>) {
        self.order.push(Reverse((cost, Reverse(open.chosen.len()), self.tasks.len())));
        self.tasks.push(Some(Task { cost, open, at, value }));
    }

    fn next(&mut self) -> Option<Task> {
        let Reverse((_, _, number)) = self.order.pop()?;
        self.tasks.get_mut(number)?.take()
    }
}
