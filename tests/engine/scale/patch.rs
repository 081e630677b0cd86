//! One patch in many disguises: similar, homogeneously scaled, its unknowns in other units and under other names.

use prove_cap::statement::Statement;

pub(crate) type Point = [&'static str; 4];

/// A patch as it is first written down: Cartesian points with weights, and F in x, y, z, w.
pub(crate) struct Family {
    pub(crate) radicands: &'static str,
    pub(crate) unknowns: &'static [&'static str],
    pub(crate) net: [[Point; 3]; 3],
    /// In `x`, `y`, `z` and `w`, for which the disguise puts its own coordinates.
    pub(crate) surface: &'static str,
}

/// The cap over the cube face, its middle control point on the axis.
pub(crate) const CAP: Family = Family {
    radicands: "2, 3",
    unknowns: &["w", "z"],
    net: cap(["0", "0", "z", "w"]),
    surface: "x^2 + y^2 + z^2 - w^2",
};

/// The same, 500 times as large and with its centre at (0, 0, 10000), z being measured where it lies then.
pub(crate) const CAP_IN_PLACE: Family = Family { net: cap(["0", "0", "(z-10^4)/500", "w"]), ..CAP };

/// The same with a middle control point anywhere.
pub(crate) const CENTRE: Family =
    Family { unknowns: &["w", "x", "y", "z"], net: cap(["x", "y", "z", "w"]), ..CAP };

const fn cap(middle: Point) -> [[Point; 3]; 3] {
    const A: &str = "sqrt(3)/3";
    const MA: &str = "-sqrt(3)/3";
    const B: &str = "sqrt(3)/2";
    const MB: &str = "-sqrt(3)/2";
    const Q: &str = "sqrt(6)/3";
    [
        [[MA, MA, A, "1"], ["0", MB, B, Q], [A, MA, A, "1"]],
        [[MB, "0", B, Q], middle, [B, "0", B, Q]],
        [[MA, A, A, "1"], ["0", B, B, Q], [A, A, A, "1"]],
    ]
}

/// A patch near the paraboloid z = x² + y², with a dent in two edges so that the middle decides.
pub(crate) const PARABOLOID: Family = Family {
    radicands: "",
    unknowns: &["w", "z"],
    net: [
        [["-1", "-1", "2", "1"], ["0", "-1", "0", "1"], ["1", "-1", "2", "1"]],
        [["-1", "0", "0", "1"], ["0", "0", "z", "w"], ["1", "0", "0", "1"]],
        [["-1", "1", "2", "1"], ["0", "1", "0", "2"], ["1", "1", "2", "1"]],
    ],
    surface: "z*w - x^2 - y^2",
};

/// A patch near a torus, a surface of degree 4.
pub(crate) const TORUS: Family = Family {
    radicands: "2",
    unknowns: &["w", "x", "y", "z"],
    net: [
        [["3", "0", "0", "1"], ["3", "1", "0", "9/10"], ["12/5", "9/5", "0", "1"]],
        [["3", "0", "1/2", "9/10"], ["x", "y", "z", "w"], ["12/5", "9/5", "1/2", "9/10"]],
        [["14/5", "0", "3/5", "1"], ["14/5", "14/15", "3/5", "9/10"], ["56/25", "42/25", "3/5", "1"]],
    ],
    surface: "(x^2 + y^2 + z^2 + 3*w^2)^2 - 16*w^2*(x^2 + y^2)",
};

/// What is done to a patch: x ↦ μRx + t for its points and its surface, all homogeneous coordinates times λ, the unknowns in other units
/// and in another order.
#[derive(Clone, Copy)]
pub(crate) struct Disguise {
    pub(crate) scale: &'static str,
    pub(crate) turned: bool,
    pub(crate) axes: [usize; 3],
    pub(crate) shift: [&'static str; 3],
    pub(crate) factor: &'static str,
    /// The unknown k is u_k times the one that is declared, and the last one comes first.
    pub(crate) units: Option<[&'static str; 4]>,
    pub(crate) homogeneous: bool,
}

pub(crate) const AS_IT_IS: Disguise = Disguise {
    scale: "1",
    turned: false,
    axes: [0, 1, 2],
    shift: ["0", "0", "0"],
    factor: "1",
    units: None,
    homogeneous: false,
};

/// Puts expressions for the names in an expression.
fn put(expression: &str, names: &[&str], values: &[String]) -> String {
    let mut result = String::new();
    let mut word = String::new();
    for c in expression.chars().chain([' ']) {
        if c.is_ascii_alphanumeric() {
            word.push(c);
            continue;
        }
        let found = names.iter().position(|name| *name == word);
        result += &found.map_or(word.clone(), |place| format!("({})", values[place]));
        word.clear();
        result.push(c);
    }
    result.trim_end().to_owned()
}

impl Family {
    pub(crate) fn statement(&self, disguise: &Disguise) -> Statement {
        let text = self.text(disguise);
        Statement::read(&text).unwrap_or_else(|error| panic!("{error}\n{text}"))
    }

    fn text(&self, disguise: &Disguise) -> String {
        let Disguise { scale, turned, axes, shift, factor, units, homogeneous } = *disguise;
        let count = self.unknowns.len();
        let renamed: Vec<String> = match units {
            None => self.unknowns.iter().map(|&name| name.to_owned()).collect(),
            Some(units) => (0..count).map(|k| format!("{}*q{k}", units[k])).collect(),
        };
        let declared: Vec<String> = match units {
            None => renamed.clone(),
            Some(_) => (0..count).rev().map(|k| format!("q{k}")).collect(),
        };
        let moved = |point: &Point| -> String {
            let [x, y, z, w] = point.map(|entry| put(entry, self.unknowns, &renamed));
            let turned = match turned {
                true => [format!("3/5*({x})+4/5*({z})"), y, format!("-4/5*({x})+3/5*({z})")],
                false => [x, y, z],
            };
            let places: Vec<String> = axes.iter().map(|&k| turned[k].clone()).collect();
            let coordinates = places.iter().zip(shift).map(|(x, t)| match homogeneous {
                true => format!("({factor})*({w})*(({scale})*({x})+({t}))"),
                false => format!("({scale})*({x})+({t})"),
            });
            let entries = coordinates.chain([format!("({factor})*({w})")]);
            format!("[{}]", entries.map(|entry| format!("\"{entry}\"")).collect::<Vec<_>>().join(", "))
        };
        let rows = self.net.iter().map(|row| row.iter().map(moved).collect::<Vec<_>>().join(", "));
        let rows: Vec<String> = rows.map(|row| format!("  [{row}],\n")).collect();
        // The coordinates before the motion, from those after it.
        let back: Vec<String> =
            (0..3).map(|k| format!("({}-({})*W)/({scale})", ["X", "Y", "Z"][k], shift[k])).collect();
        let place = |k: usize| back[axes.iter().position(|&axis| axis == k).unwrap()].clone();
        let [x, y, z] = [place(0), place(1), place(2)];
        let before = match turned {
            true => [format!("3/5*({x})-4/5*({z})"), y, format!("4/5*({x})+3/5*({z})")],
            false => [x, y, z],
        };
        let values = [&before[..], &["W".to_owned()]].concat();
        let surface = put(self.surface, &["x", "y", "z", "w"], &values);
        format!(
            "title = \"t\"\nradicands = [{}]\nunknowns = [{}]\nconvention = \"{}\"\nbidegree = [2, 2]\nsurface = \"{surface}\"\nnet = [\n{}]\n",
            self.radicands,
            declared.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(", "),
            if homogeneous { "homogeneous" } else { "cartesian" },
            rows.concat()
        )
    }

    /// Values of the disguised unknowns as they are for the undisguised.
    pub(crate) fn undone(&self, disguise: &Disguise, values: &[f64]) -> Vec<f64> {
        match disguise.units {
            None => values.to_vec(),
            Some(units) => {
                let size = |text: &str| -> f64 {
                    let (n, d) = text.split_once('/').unwrap_or((text, "1"));
                    n.parse::<f64>().unwrap() / d.parse::<f64>().unwrap()
                };
                values.iter().rev().enumerate().map(|(k, value)| size(units[k]) * value).collect()
            }
        }
    }
}
