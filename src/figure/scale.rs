//! Colours, ticks and units.

use super::canvas::{Anchor, Canvas};

/// Colours of growing lightness from blue to yellow, also for eyes that do not tell red from green, and in grey (after the
/// colour map cividis of Nuñez, Anderton & Renslow 2018, doi:10.1371/journal.pone.0199239).
const COLOURS: [(f64, f64, f64); 9] = [
    (0.0, 32.0, 81.0),
    (17.0, 54.0, 108.0),
    (60.0, 77.0, 110.0),
    (98.0, 100.0, 111.0),
    (127.0, 124.0, 117.0),
    (154.0, 148.0, 120.0),
    (187.0, 175.0, 113.0),
    (226.0, 203.0, 92.0),
    (253.0, 234.0, 69.0),
];

/// Shades that are told apart.
const SHADES: f64 = 96.0;

/// What differs by less, in proportion, is called constant.
const CONSTANT: f64 = 1e-12;

/// From the smallest to the largest value, in a unit that is a power of ten.
#[derive(Debug, Clone)]
pub(super) struct Scale {
    low: f64,
    high: f64,
    /// The values are multiples of 10^exponent.
    exponent: i32,
}

impl Scale {
    pub(super) fn of(values: impl Iterator<Item = f64>) -> Self {
        let finite = values.filter(|value| value.is_finite());
        let (low, high) =
            finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)));
        // In proportion: a picture in metres shows what one in millimetres does.
        if !low.is_finite() || high - low <= CONSTANT * low.abs().max(high.abs()) {
            let at = if low.is_finite() { low } else { 0.0 };
            return Scale { low: at, high: at, exponent: 0 };
        }
        let size = low.abs().max(high.abs());
        // Three digits before the point at most.
        Scale { low, high, exponent: 3 * ((size.log10() / 3.0).floor() as i32) }
    }

    pub(super) fn constant(&self) -> bool {
        self.low == self.high
    }

    /// 0 for the smallest, 1 for the largest.
    pub(super) fn position(&self, value: f64) -> f64 {
        if self.constant() || !value.is_finite() { 0.5 } else { (value - self.low) / (self.high - self.low) }
    }

    pub(super) fn colour(&self, value: f64) -> String {
        let at =
            (self.position(value).clamp(0.0, 1.0) * SHADES).round() / SHADES * (COLOURS.len() - 1) as f64;
        let below = (at.floor() as usize).min(COLOURS.len() - 2);
        let part = at - below as f64;
        let (a, b) = (COLOURS[below], COLOURS[below + 1]);
        let mix = |a: f64, b: f64| (a + (b - a) * part).round() as u8;
        format!("#{:02x}{:02x}{:02x}", mix(a.0, b.0), mix(a.1, b.1), mix(a.2, b.2))
    }

    /// Round values between the ends: steps of 1, 2 or 5 times a power of ten.
    pub(super) fn ticks(&self, about: f64) -> Vec<f64> {
        if self.constant() {
            return vec![self.low];
        }
        let raw = (self.high - self.low) / about;
        let power = 10f64.powf(raw.log10().floor());
        let step =
            [1.0, 2.0, 5.0, 10.0].into_iter().map(|k| k * power).find(|step| *step >= raw).unwrap_or(raw);
        let (first, last) = ((self.low / step).ceil() as i64, (self.high / step).floor() as i64);
        (first..=last).map(|k| k as f64 * step).collect()
    }

    /// A value in the unit.
    pub(super) fn spell(&self, value: f64, decimals: usize) -> String {
        let text = format!("{:.decimals$}", value / 10f64.powi(self.exponent));
        let trimmed =
            if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { &text };
        if trimmed == "-0" { "0".to_owned() } else { trimmed.replace('-', "−") }
    }

    /// The largest value, rounded up, or the smallest, rounded down.
    fn spell_end(&self, value: f64, largest: bool) -> String {
        let units = value / 10f64.powi(self.exponent) * 1e4;
        let rounded = if largest { units.ceil() } else { units.floor() };
        self.spell(rounded / 1e4 * 10f64.powi(self.exponent), 4)
    }

    /// `r − 1, in 10⁻⁶`.
    pub(super) fn unit(&self, symbol: &str) -> String {
        let raised: String = self.exponent.to_string().chars().map(superscript).collect();
        if self.exponent == 0 { symbol.to_owned() } else { format!("{symbol}, in 10{raised}") }
    }

    /// The bar with its ticks, right of a picture.
    pub(super) fn bar(&self, canvas: &mut Canvas, symbol: &str, ends: Option<(f64, f64)>) {
        let (x, top, height, width) = (760.0, 90.0, 540.0, 22.0);
        if self.constant() {
            canvas.text((x, top + 20.0), 15.0, Anchor::Start, false, "constant");
            canvas.text((x, top + 42.0), 15.0, Anchor::Start, false, &self.spell(self.low, 6));
            return;
        }
        let steps = SHADES as usize;
        for k in 0..steps {
            let value = self.low + (self.high - self.low) * (k as f64 + 0.5) / SHADES;
            let y = top + height * (1.0 - (k + 1) as f64 / SHADES);
            canvas.rectangle((x, y), (width, height / SHADES + 0.5), &self.colour(value));
        }
        let corners = [(x, top), (x + width, top), (x + width, top + height), (x, top + height)];
        canvas.polygon(&corners, "none", "black", 1.0);
        for tick in self.ticks(8.0) {
            let y = top + height * (1.0 - self.position(tick));
            canvas.polyline(&[(x + width, y), (x + width + 6.0, y)], "black", 1.0);
            canvas.text((x + width + 10.0, y + 5.0), 14.0, Anchor::Start, false, &self.spell(tick, 3));
        }
        canvas.text((x + 88.0, top + height / 2.0), 16.0, Anchor::Middle, true, &self.unit(symbol));
        if let Some((low, high)) = ends {
            canvas.marker((x + 8.0, top - 22.0), true);
            canvas.text((x + 22.0, top - 17.0), 14.0, Anchor::Start, false, &self.spell_end(high, true));
            canvas.marker((x + 8.0, top + height + 22.0), false);
            canvas.text(
                (x + 22.0, top + height + 27.0),
                14.0,
                Anchor::Start,
                false,
                &self.spell_end(low, false),
            );
        }
    }
}

fn superscript(c: char) -> char {
    if c == '-' {
        '⁻'
    } else {
        "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(c as usize - '0' as usize).unwrap_or(c)
    }
}
