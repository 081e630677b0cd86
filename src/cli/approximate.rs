//! `prove-cap approximate NAME|FILE`: the best values of the unknowns that are found, enclosed, and if asked for proved best.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::arguments::{Format, to_json};
use super::bound::{degree_of, undecided};
use super::control::{Limits, controlled};
use super::files::{Unchecked, sealed_name, write_and_check};
use super::outcome::{Failure, Outcome};
use super::plot::PlotOptions;
use super::source::Source;
use super::values::{point, tolerance};
use crate::approximation::{
    Approximation, ApproximationError, Barrier, BestSoFar, Objective, Search, UnreachableError, approximate,
    error_of, exclude,
};
use crate::certificate::Quantity;
use crate::commands::Verdict;
use crate::control::{Control, Interrupted};
use crate::report::Files;
use crate::report::bounds::{
    Gap, barrier_text, checked_text, enclosure_data, enclosure_details, enclosure_text, error_value, symbol,
};
use crate::report::rounding::{Towards, rounded};
use crate::report::stopped::{best_so_far_data, best_so_far_text, decimals_data, stopped_by};

/// How near to the best the proof that nothing is better must come.
const WITHIN: f64 = 1e-6;
/// Places of the bounds that no values reach: relative to the error, this many digits.
const DIGITS: u32 = 9;

#[derive(Debug, Args)]
pub(super) struct ApproximateOptions {
    /// A built-in statement (see `list`) or a statement file.
    #[arg(value_name = "NAME|FILE")]
    source: PathBuf,
    /// What is to be smallest.
    #[arg(long, value_enum, default_value_t = ObjectiveName::Minimax)]
    objective: ObjectiveName,
    /// For least squares: sample points each way.
    #[arg(long, value_name = "N", default_value_t = 101, value_parser = clap::value_parser!(u16).range(2..=1001))]
    points: u16,
    /// For least squares: a point of the square where the patch is to lie on the surface; may be repeated.
    #[arg(long, value_name = "U,V", value_parser = point)]
    pass: Vec<(f64, f64)>,
    /// How near the bounds are to the true extremes [default: 1e-12 for the radius; as many digits of F/Wᵉ].
    #[arg(long, value_name = "SIZE", value_parser = tolerance)]
    tolerance: Option<u32>,
    /// For minimax: prove that no values of the unknowns do better, up to a millionth of the error.
    #[arg(long)]
    prove_best: bool,
    /// Where the random starts of the search begin; the result hardly ever depends on it.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Where statement.toml and the certificates are written [default: proofs/NAME].
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    #[command(flatten)]
    plot: PlotOptions,
    #[command(flatten)]
    limits: Limits,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum ObjectiveName {
    /// The sum of (r² − 1)² over the sample points (the paper's Eq. 17).
    LeastSquares,
    /// The largest |r − 1|.
    Minimax,
    /// The largest r, with r ≥ 1 everywhere.
    Outer,
    /// The largest 1 − r, with r ≤ 1 everywhere.
    Inner,
    /// The largest r minus the smallest.
    Width,
}

impl From<ObjectiveName> for Objective {
    fn from(name: ObjectiveName) -> Self {
        match name {
            ObjectiveName::LeastSquares => Objective::LeastSquares,
            ObjectiveName::Minimax => Objective::Minimax,
            ObjectiveName::Outer => Objective::Outer,
            ObjectiveName::Inner => Objective::Inner,
            ObjectiveName::Width => Objective::Width,
        }
    }
}

pub(super) fn run(options: &ApproximateOptions, format: Format) -> Result<Outcome, Failure> {
    let source = Source::find(&options.source)?;
    let degree = degree_of(&source.statement)?;
    let objective = Objective::from(options.objective);
    if options.prove_best && objective != Objective::Minimax {
        return Err(Failure("--prove-best is for --objective minimax".to_owned()));
    }
    let squares = objective == Objective::LeastSquares;
    if !options.pass.is_empty() && !squares {
        return Err(Failure("--pass is for --objective least-squares".to_owned()));
    }
    let search = Search {
        objective,
        points: usize::from(options.points),
        pass: options.pass.clone(),
        places: options.tolerance,
        seed: options.seed,
    };
    let found = controlled(&options.limits, |control| {
        let found = approximate(&source.statement, &search, control)?;
        let barrier = options.prove_best.then(|| barrier(&source, &found, control));
        Ok::<_, ApproximationError>((found, barrier))
    })?;
    let (found, barrier) = match found {
        Ok(found) => found,
        Err(ApproximationError::Enclosure(error)) => return undecided(&source.name, &error, format),
        Err(ApproximationError::Interrupted(why, best)) => {
            return stopped(&source, why, best.as_deref(), format);
        }
        Err(error) => return Err(Failure(format!("{}: {error}", source.name))),
    };
    let (barrier, open) = match barrier {
        None => (None, None),
        Some(Ok(barrier)) => (Some(barrier), None),
        Some(Err(UnreachableError::Refused(error))) => return Err(Failure::of(error)),
        Some(Err(error)) => (None, Some(error)),
    };
    let write = |kind: &str, certificate: &crate::certificate::Certificate| {
        let text = certificate.write(&source.statement.ring());
        let name = sealed_name(kind, &text);
        match write_and_check(&source, options.output.as_deref(), (&text, &name), &Control::default()) {
            Ok(files) => Ok(files),
            Err(Unchecked::Failure(failure)) => Err(failure),
            Err(Unchecked::Stopped(why, _)) => Err(Failure::of(why)),
        }
    };
    let files = write("bounds", &found.enclosure.certificate)?;
    let symbol = symbol(found.enclosure.bounds.quantity, degree);
    let about = match &barrier {
        Some(barrier) => {
            let within = rounded(&gap(&found, barrier).relative(), 1, Towards::Above);
            format!("{}, proved up to {within}", options.goal(&symbol))
        }
        None => format!("best found for: {}", options.goal(&symbol)),
    };
    let picture = options.plot.draw(&source, degree, &found.enclosure, Some(&about), &Control::default())?;
    let barrier =
        barrier.map(|barrier| Ok((write("unreachable", &barrier.certificate)?, barrier))).transpose()?;
    let answer = Answer { source: &source, options, degree, found, files, barrier, open, picture };
    let text = match format {
        Format::Json => to_json(&answer.data())?,
        Format::Text | Format::Latex => answer.text(),
    };
    Ok(Outcome { text, verdict: answer.verdict() })
}

/// The search was stopped before anything was proved: what it had.
fn stopped(
    source: &Source,
    why: Interrupted,
    best: Option<&BestSoFar>,
    format: Format,
) -> Result<Outcome, Failure> {
    let (name, statement) = (&source.name, &source.statement);
    let text = match format {
        Format::Json => to_json(&serde_json::json!({
            "verdict": "UNDECIDED",
            "name": name,
            "reason": why.to_string(),
            "stopped": stopped_by(why.why),
            "best_found": best.map(|best| best_so_far_data(statement, best)),
        }))?,
        _ => {
            let best = best.map(|best| format!("\n{}", best_so_far_text(statement, best)));
            format!("UNDECIDED  {name}: {why}\n{}", best.unwrap_or_default())
        }
    };
    Ok(Outcome { text, verdict: Verdict::Undecided })
}

impl ApproximateOptions {
    /// What is to be as small or large as can be.
    fn goal(&self, symbol: &str) -> String {
        match self.objective {
            ObjectiveName::LeastSquares => {
                let (n, symbol) = (self.points, if symbol == "r" { "r² − 1" } else { symbol });
                format!("least squares of {symbol} over {n} × {n} points")
            }
            ObjectiveName::Minimax if symbol == "r" => "smallest max |r − 1|".to_owned(),
            ObjectiveName::Minimax => format!("smallest max |{symbol}|"),
            ObjectiveName::Outer if symbol == "r" => "smallest max r with r ≥ 1".to_owned(),
            ObjectiveName::Outer => format!("smallest max {symbol} with {symbol} ≥ 0"),
            ObjectiveName::Inner if symbol == "r" => "largest min r with r ≤ 1".to_owned(),
            ObjectiveName::Inner => format!("largest min {symbol} with {symbol} ≤ 0"),
            ObjectiveName::Width => format!("smallest max {symbol} − min {symbol}"),
        }
    }
}

/// Bounds a millionth tighter than what was found, which no values reach.
fn barrier(source: &Source, found: &Approximation, control: &Control) -> Result<Barrier, UnreachableError> {
    let error = found.extremes.iter().map(|place| place.value.abs()).fold(0.0, f64::max);
    let places = (-error.log10()).ceil().max(0.0) as u32 + DIGITS;
    let unit = BigInt::from(10).pow(places);
    let size = BigInt::from((error * (1.0 - WITHIN) * unit.to_f64().unwrap_or(f64::INFINITY)) as i128);
    let centre = match found.enclosure.bounds.quantity {
        Quantity::Radius => unit,
        Quantity::Ratio => BigInt::ZERO,
    };
    let worst: Vec<_> =
        found.extremes.iter().filter(|place| place.value.abs() > 0.5 * error).copied().collect();
    exclude(&source.statement, [&centre - &size, &centre + &size], places, &worst, control)
}

/// max |r − 1| as the bounds have it.
fn reached(found: &Approximation) -> BigRational {
    error_value(&error_of(&found.enclosure), found.enclosure.bounds.places)
}

/// What is reached, and what the checker found that no values do better than.
fn gap(found: &Approximation, barrier: &Barrier) -> Gap {
    Gap { reached: reached(found), unreached: barrier.half_width.clone() }
}

struct Answer<'a> {
    source: &'a Source,
    options: &'a ApproximateOptions,
    degree: u32,
    found: Approximation,
    files: Files,
    barrier: Option<(Files, Barrier)>,
    /// Why it is not proved that nothing is better.
    open: Option<UnreachableError>,
    /// The line that tells of a picture.
    picture: String,
}

impl Answer<'_> {
    fn verdict(&self) -> Verdict {
        if self.open.is_some() { Verdict::Undecided } else { Verdict::Enclosed }
    }

    fn text(&self) -> String {
        let (enclosure, statement) = (&self.found.enclosure, &self.source.statement);
        let goal = self.options.goal(&symbol(enclosure.bounds.quantity, self.degree));
        let bounds = enclosure_text(&enclosure.bounds, self.degree);
        let mut text = match &self.open {
            None => format!("{}  {}: {bounds} on the whole patch\n\n", self.verdict(), self.source.name),
            Some(why) => format!(
                "UNDECIDED  {}: that no values do better than {} is not proved: {why}\n\n\
                 Proved: {bounds} on the whole patch\n",
                self.source.name,
                rounded(&reached(&self.found), 4, Towards::Above)
            ),
        };
        text += &format!("{}\n", statement.title());
        text += &match &self.barrier {
            Some((_, barrier)) => {
                let within = rounded(&gap(&self.found, barrier).relative(), 1, Towards::Above);
                format!("{goal}, proved up to {within} of it\n")
            }
            None => format!("best found for: {goal}; found by search, not proved best\n"),
        };
        text += &format!("at {}\n\n", self.taken());
        text += &enclosure_details(statement, enclosure, self.degree);
        if let Some((_, barrier)) = &self.barrier {
            text += &barrier_text(barrier, &gap(&self.found, barrier));
        }
        text += &checked_text(&enclosure.theorem, &self.files);
        if let Some((files, barrier)) = &self.barrier {
            text += &checked_text(&barrier.theorem, files);
        }
        text += &self.picture;
        text
    }

    /// Which values were taken.
    fn taken(&self) -> String {
        if self.found.recognised {
            return "exact values recognised near those found; that they are the best is a guess, the bounds are proved"
                .to_owned();
        }
        let places = &self.found.found.places;
        match (places.iter().min(), places.iter().max()) {
            (Some(least), Some(most)) if least == most && *least > 0 => {
                format!("values rounded to {least} decimals")
            }
            _ => "values rounded to as many digits as the search has".to_owned(),
        }
    }

    fn data(&self) -> serde_json::Value {
        let about = (self.verdict(), self.source.name.as_str());
        let statement = &self.source.statement;
        let mut data = enclosure_data(about, statement, &self.found.enclosure, &self.files);
        data["objective"] =
            self.options.objective.to_possible_value().map(|value| value.get_name().to_owned()).into();
        data["recognised"] = self.found.recognised.into();
        data["found"] = decimals_data(statement, &self.found.found);
        data["best"] = match &self.barrier {
            Some((files, barrier)) => {
                let gap = gap(&self.found, barrier);
                serde_json::json!({
                    "proved": true,
                    "none_better_than": gap.unreached.to_string(),
                    "within": gap.relative().to_string(),
                    "boxes": barrier.boxes,
                    "theorem": barrier.theorem.sentence(),
                    "certificate": files.certificate.display().to_string(),
                })
            }
            None => serde_json::json!({ "proved": false, "how": "best found by search" }),
        };
        if let Some(why) = &self.open {
            data["open"] = why.to_string().into();
            if let UnreachableError::Interrupted(why) = why {
                data["stopped"] = stopped_by(why.why).into();
            }
        }
        data
    }
}
