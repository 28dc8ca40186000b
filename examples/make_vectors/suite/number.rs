//! Coordinates of the suite: rationals, written so that any reader of JSON keeps them.

use serde_json::{Value, json};
use stabline::num::{Int, Rational};

/// A number.
pub type Q = Rational;

/// A point, of two or three coordinates.
pub type Point = Vec<Q>;

/// A portal, in the plane or in space.
pub type Polygon = Vec<Point>;

/// A whole number.
pub fn q(n: i64) -> Q {
    Q::from(Int::from(n))
}

/// The ratio n/d.
pub fn ratio(n: i64, d: i64) -> Q {
    Q::new(Int::from(n), Int::from(d))
}

/// 10^-k.
pub fn tenth(k: u32) -> Q {
    Q::new(Int::from(1), Int::from(10).pow(k))
}

/// 2^k.
pub fn power(k: u32) -> Q {
    Q::from(Int::from(2).pow(k))
}

/// The number in JSON: an integer below 2^53, or a string.
pub fn value(number: &Q) -> Value {
    let small = i64::try_from(number.numer()).ok().filter(|n| n.unsigned_abs() < 1 << 53);
    match small {
        Some(small) if number.is_integer() => json!(small),
        _ => json!(number.to_string()),
    }
}

/// Points in JSON.
pub fn values(points: &[Point]) -> Value {
    points.iter().map(|point| point.iter().map(value).collect::<Vec<_>>()).collect()
}

/// Each point moved by `by`.
pub fn moved(polygons: &[Polygon], by: &[Q]) -> Vec<Polygon> {
    each(polygons, |point| point.iter().zip(by).map(|(c, b)| c + b).collect())
}

/// Each point scaled about the origin.
pub fn scaled(polygons: &[Polygon], by: &Q) -> Vec<Polygon> {
    each(polygons, |point| point.iter().map(|c| c * by).collect())
}

/// The sequence crossed the other way: its reverse, each portal turned over.
pub fn reversed(polygons: &[Polygon]) -> Vec<Polygon> {
    polygons.iter().rev().map(|polygon| polygon.iter().rev().cloned().collect()).collect()
}

/// What is left when each point becomes another; `to` must not turn space over.
pub fn each(polygons: &[Polygon], to: impl Fn(&Point) -> Point) -> Vec<Polygon> {
    polygons.iter().map(|polygon| polygon.iter().map(&to).collect()).collect()
}
