//! Symmetric interiors: which inner control points determine the others.

/// A linear map (x, y) ↦ (xx·x + xy·y, yx·x + yy·y) of the square to itself.
type Motion = [[i32; 2]; 2];

/// The rotations by 0°, 90°, 180°, 270°.
pub(super) const ROTATIONS: [Motion; 4] =
    [[[1, 0], [0, 1]], [[0, -1], [1, 0]], [[-1, 0], [0, -1]], [[0, 1], [-1, 0]]];

/// The rotations and reflections of the square.
pub(super) const ALL: [Motion; 8] = [
    ROTATIONS[0],
    ROTATIONS[1],
    ROTATIONS[2],
    ROTATIONS[3],
    [[1, 0], [0, -1]],
    [[-1, 0], [0, 1]],
    [[0, 1], [1, 0]],
    [[0, -1], [-1, 0]],
];

/// A coordinate: a sign and the unknown's letter, or 0.
type Signed = Option<(i32, char)>;

/// The control point at (i, j) of an (m+1)×(m+1) net that is mapped to itself by `group`: the place (i, j) of the
/// representative of its orbit, and its X and Y in terms of the representative's (its Z and W are the same).
pub(super) fn orbit(m: u32, group: &[Motion], i: u32, j: u32) -> ((u32, u32), [Signed; 2]) {
    // x grows with j and y with i; twice the distance from the middle is an integer.
    let place = |[x, y]: [i32; 2]| (((y + m as i32) / 2) as u32, ((x + m as i32) / 2) as u32);
    let here = [2 * j as i32 - m as i32, 2 * i as i32 - m as i32];
    let representative =
        group.iter().map(|motion| place(apply(motion, here))).min().expect("a group has an identity");
    let start = [2 * representative.1 as i32 - m as i32, 2 * representative.0 as i32 - m as i32];

    // What the motions that fix the representative's place make of its coordinates.
    let (mut x, mut y): (Signed, Signed) = (Some((1, 'X')), Some((1, 'Y')));
    for [[xx, xy], [yx, yy]] in group.iter().filter(|motion| apply(motion, start) == start) {
        if *xx == -1 {
            x = None;
        }
        if *yy == -1 {
            y = None;
        }
        if *xy != 0 {
            // X = ±Y and Y = ±X: equal up to the sign, and zero if the signs disagree.
            y = if xy == yx { x.map(|(sign, letter)| (sign * yx, letter)) } else { None };
            x = if xy == yx { x } else { None };
        }
    }
    let motion = group.iter().find(|motion| apply(motion, start) == here).expect("one orbit");
    let combine = |[a, b]: [i32; 2]| match (a, b) {
        (0, sign) => y.map(|(s, letter)| (s * sign, letter)),
        (sign, _) => x.map(|(s, letter)| (s * sign, letter)),
    };
    (representative, [combine(motion[0]), combine(motion[1])])
}

fn apply(motion: &Motion, [x, y]: [i32; 2]) -> [i32; 2] {
    [motion[0][0] * x + motion[0][1] * y, motion[1][0] * x + motion[1][1] * y]
}
