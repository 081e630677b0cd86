//! Pictures: what is in them, and what is refused.

use std::path::Path;

use prove_cap::figure::{Extreme, Figure, FigureError, Scene, draw};

const ALL: [Figure; 3] = [Figure::Contours, Figure::Surface, Figure::Cap];

fn with_scene<T>(title: &str, deviation: &dyn Fn(f64, f64) -> f64, look: impl FnOnce(&Scene<'_>) -> T) -> T {
    let net: Vec<Vec<[f64; 3]>> =
        (0..3).map(|i| (0..3).map(|j| [f64::from(j) - 1.0, f64::from(i) - 1.0, 1.0]).collect()).collect();
    let extremes = [
        Extreme { u: 0.25, v: 0.25, value: deviation(0.25, 0.25), maximum: true },
        Extreme { u: 0.75, v: 0.75, value: deviation(0.75, 0.75), maximum: false },
    ];
    look(&Scene {
        title,
        symbol: "r − 1",
        deviation,
        unit_sphere: true,
        point: &|u, v| [2.0 * v - 1.0, 2.0 * u - 1.0, 1.0],
        net: &net,
        extremes: &extremes,
    })
}

fn wave(u: f64, v: f64) -> f64 {
    4e-5 * ((u * 6.0).sin() * (v * 6.0).sin())
}

fn svg(figure: Figure, title: &str, deviation: &dyn Fn(f64, f64) -> f64) -> String {
    with_scene(title, deviation, |scene| {
        String::from_utf8(draw(figure, scene, Path::new("a.svg")).unwrap()).unwrap()
    })
}

#[test]
fn axes_units_and_extremes_are_labelled() {
    for figure in ALL {
        let text = svg(figure, "a title", &wave);
        assert!(text.starts_with("<svg ") && text.ends_with("</svg>\n"));
        assert!(text.contains(">r − 1, in 10⁻⁶<"), "{figure:?}: the unit");
        let axes: &[&str] = if figure == Figure::Cap { &["x", "y", "z"] } else { &["u", "v"] };
        for axis in axes {
            assert!(text.contains(&format!(">{axis}</text>")), "{figure:?}: {axis}");
        }
        assert!(text.contains("stroke=\"black\" stroke-width=\"1.8\""), "{figure:?}: markers");
        assert!(!text.contains("NaN") && !text.contains("inf"), "{figure:?}: numbers");
    }
}

#[test]
fn titles_are_escaped_and_pictures_are_reproduced() {
    for figure in ALL {
        let text = svg(figure, "a < b & c > d", &wave);
        assert!(text.contains("a &lt; b &amp; c &gt; d") && !text.contains("a < b"));
        assert_eq!(text, svg(figure, "a < b & c > d", &wave));
    }
}

#[test]
fn pixels_have_a_size_and_something_on_them() {
    with_scene("a title", &wave, |scene| {
        let png = draw(Figure::Contours, scene, Path::new("a.PNG")).unwrap();
        assert_eq!(png[..8], *b"\x89PNG\r\n\x1a\n");
        let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
        assert_eq!((number(16), number(20)), (1800, 1440));
        assert!(png.len() > 50_000, "not blank: {}", png.len());
        let other = with_scene("another title", &wave, |scene| {
            draw(Figure::Contours, scene, Path::new("a.png")).unwrap()
        });
        assert_ne!(png, other, "letters are drawn");
    });
}

#[test]
fn what_is_constant_or_no_number_is_drawn_and_said() {
    for figure in ALL {
        assert!(svg(figure, "t", &|_, _| 0.0).contains(">constant<"));
        let text = svg(figure, "t", &|_, _| f64::NAN);
        assert!(text.contains(">constant<") && !text.contains("NaN"));
    }
}

#[test]
fn other_endings_are_refused() {
    for (file, shown) in [("a.pdf", "a.pdf"), ("png", "png"), ("", "")] {
        let error = with_scene("t", &wave, |scene| draw(Figure::Cap, scene, Path::new(file)).unwrap_err());
        assert!(matches!(error, FigureError::Ending(_)));
        assert_eq!(error.to_string(), format!("{shown}: a picture is a file that ends in .svg or .png"));
    }
}
