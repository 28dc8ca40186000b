//! The lines that meet four lines, as canonical text and as `stabline-transversals/1`.

use crate::geom::BigLine;
use crate::num::{Int, Rational, Surd};
use crate::stab::transversals::{
    Family, IsolatedLine, ProjectivePlane, ProjectivePoint, Transversals,
};
use num_traits::Zero;
use schemars::JsonSchema;
use serde::Serialize;

/// All lines that meet four given lines.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "stabline-transversals/1")]
pub struct TransversalsReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-transversals/1$"))]
    format: &'static str,
    /// How many lines there are at a finite place.
    kind: Kind,
    /// The rank of the given lines' Plücker vectors.
    #[schemars(range(min = 1, max = 4))]
    rank: usize,
    /// The lines that belong to no family.
    lines: Vec<Line>,
    /// Lines at infinity that belong to no family. They are not counted in `kind`.
    at_infinity: Vec<InfiniteLine>,
    /// The families.
    families: Vec<FamilyReport>,
}

/// How many lines there are at a finite place.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Kind {
    None,
    One,
    Two,
    /// Infinitely many.
    Family,
}

/// A line by two distinct points over one field Q(√d).
#[derive(Serialize, JsonSchema)]
struct Line {
    points: [[Number; 3]; 2],
    /// Two for a double root.
    #[schemars(range(min = 1, max = 2))]
    multiplicity: u8,
}

/// A line at infinity.
#[derive(Serialize, JsonSchema)]
struct InfiniteLine {
    /// The normal of the planes that contain the line.
    normal: [Number; 3],
    /// Two for a double root.
    #[schemars(range(min = 1, max = 2))]
    multiplicity: u8,
}

/// The number a + b√d; b and d are zero for a rational number.
#[derive(Serialize, JsonSchema)]
struct Number {
    a: Ratio,
    b: Ratio,
    d: Integer,
}

/// An integer `p`, or a ratio `p/q` in lowest terms with q > 1.
#[derive(Serialize, JsonSchema)]
#[serde(transparent)]
struct Ratio(#[schemars(regex(pattern = "^-?[0-9]+(/[1-9][0-9]*)?$"))] String);

/// An integer.
#[derive(Serialize, JsonSchema)]
#[serde(transparent)]
struct Integer(#[schemars(regex(pattern = "^-?[0-9]+$"))] String);

/// A line by two distinct rational points.
type RationalLine = [[Ratio; 3]; 2];

/// Infinitely many lines.
#[derive(Serialize, JsonSchema)]
struct FamilyReport {
    /// How many parameters the family has.
    #[schemars(range(min = 1, max = 3))]
    dimension: u8,
    #[serde(flatten)]
    shape: Shape,
}

/// What the lines of a family have in common.
#[derive(Serialize, JsonSchema)]
#[serde(tag = "type")]
enum Shape {
    /// The lines of a plane through one of its points.
    #[serde(rename = "plane pencil")]
    PlanePencil(Pencil),
    /// Two plane pencils with one line in common.
    #[serde(rename = "pencil pair")]
    PencilPair { pencils: [Pencil; 2] },
    /// One ruling of a quadric surface, by three of its lines.
    #[serde(rename = "regulus")]
    Regulus { surface: &'static str, lines: Vec<RationalLine> },
    /// All lines through a point.
    #[serde(rename = "bundle")]
    Bundle { center: Center },
    /// All lines of a plane.
    #[serde(rename = "plane")]
    Plane { plane: Plane },
    /// All lines that meet two skew lines.
    #[serde(rename = "linear congruence")]
    Congruence { axes: Vec<RationalLine> },
    /// All lines that meet one line.
    #[serde(rename = "line complex")]
    Complex { axis: RationalLine },
}

/// A point and a plane.
#[derive(Serialize, JsonSchema)]
struct Pencil {
    center: Center,
    plane: Plane,
}

/// Where the lines meet.
#[derive(Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum Center {
    /// At this point.
    Point([Ratio; 3]),
    /// At infinity: they are parallel to this direction.
    Direction([Integer; 3]),
}

/// The points x with `normal · x = offset`.
#[derive(Serialize, JsonSchema)]
struct Plane {
    normal: [Integer; 3],
    offset: Integer,
}

impl TransversalsReport {
    /// The report of this result.
    pub fn new(result: &Transversals) -> TransversalsReport {
        let kind = match (result.families.as_slice(), result.isolated.len()) {
            ([], 0) => Kind::None,
            ([], 1) => Kind::One,
            ([], _) => Kind::Two,
            (_, _) => Kind::Family,
        };
        let lines = result.isolated.iter().map(|line| Line {
            points: line.points().map(|p| p.map(|c| number(&c))),
            multiplicity: line.multiplicity,
        });
        let at_infinity = result.at_infinity.iter().map(|line| InfiniteLine {
            normal: [0, 1, 2].map(|i| number(&line.normal[i])),
            multiplicity: line.multiplicity,
        });
        TransversalsReport {
            format: "stabline-transversals/1",
            kind,
            rank: result.rank,
            lines: lines.collect(),
            at_infinity: at_infinity.collect(),
            families: families(&result.families),
        }
    }

    /// The canonical JSON text.
    ///
    /// # Panics
    /// Never: all keys are strings and all values finite.
    pub fn to_json(&self) -> String {
        let text = serde_json::to_string_pretty(self).expect("strings and small integers only");
        format!("{text}\n")
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(TransversalsReport).to_value()
    }
}

fn families(list: &[Family]) -> Vec<FamilyReport> {
    if let [Family::Pencil { center, plane }, Family::Pencil { center: other, plane: second }] =
        list
    {
        let pencils = [pencil(center, plane), pencil(other, second)];
        return vec![FamilyReport { dimension: 1, shape: Shape::PencilPair { pencils } }];
    }
    list.iter()
        .map(|family| FamilyReport { dimension: family.dimension(), shape: shape(family) })
        .collect()
}

fn shape(family: &Family) -> Shape {
    match family {
        Family::Pencil { center, plane } => Shape::PlanePencil(pencil(center, plane)),
        Family::Regulus { lines, paraboloid } => Shape::Regulus {
            surface: surface(*paraboloid),
            lines: lines.iter().map(rational_line).collect(),
        },
        Family::Bundle { center } => Shape::Bundle { center: point(center) },
        Family::PlaneField { plane: p } => Shape::Plane { plane: plane(p) },
        Family::Congruence { axes } => {
            Shape::Congruence { axes: axes.iter().map(rational_line).collect() }
        }
        Family::Complex { axis } => Shape::Complex { axis: rational_line(axis) },
    }
}

fn surface(paraboloid: bool) -> &'static str {
    if paraboloid { "hyperbolic paraboloid" } else { "hyperboloid of one sheet" }
}

fn pencil(center: &ProjectivePoint, p: &ProjectivePlane) -> Pencil {
    Pencil { center: point(center), plane: plane(p) }
}

fn point(center: &ProjectivePoint) -> Center {
    if center.weight.is_zero() {
        return Center::Direction([0, 1, 2].map(|i| integer(&center.position[i])));
    }
    let coordinate = |i: usize| Rational::new(center.position[i].clone(), center.weight.clone());
    Center::Point([0, 1, 2].map(|i| ratio(&coordinate(i))))
}

fn plane(plane: &ProjectivePlane) -> Plane {
    Plane { normal: [0, 1, 2].map(|i| integer(&plane.normal[i])), offset: integer(&plane.offset) }
}

fn rational_line(line: &BigLine) -> RationalLine {
    points(line).map(|p| p.map(|c| ratio(c.rational_part())))
}

/// Two points of a line at a finite place.
fn points(line: &BigLine) -> [[Surd; 3]; 2] {
    let surds = |v: &[Int; 3]| v.clone().map(Surd::from);
    let (direction, moment) = (surds(&line.direction), surds(&line.moment));
    IsolatedLine { direction, moment, multiplicity: 1 }.points()
}

fn number(value: &Surd) -> Number {
    Number {
        a: ratio(value.rational_part()),
        b: ratio(value.root_part()),
        d: integer(value.radicand()),
    }
}

fn ratio(value: &Rational) -> Ratio {
    Ratio(value.to_string())
}

fn integer(value: &Int) -> Integer {
    Integer(value.to_string())
}

/// The canonical text of a result: one fact a line.
pub fn transversals_text(result: &Transversals) -> String {
    let mut text = headline(result);
    let twice = |multiplicity: u8| if multiplicity == 2 { " (a double root)" } else { "" };
    for line in &result.isolated {
        let [p, q] = line.points();
        let (p, q) = (tuple(&p), tuple(&q));
        text.push_str(&format!("line through {p} and {q}{}\n", twice(line.multiplicity)));
    }
    for line in &result.at_infinity {
        let normal = tuple(&line.normal);
        let twice = twice(line.multiplicity);
        text.push_str(&format!("line at infinity of the planes normal to {normal}{twice}\n"));
    }
    for family in &result.families {
        text.push_str(&family_text(family));
        text.push('\n');
    }
    text
}

fn headline(result: &Transversals) -> String {
    let count = match (result.families.is_empty(), result.isolated.len()) {
        (false, _) => "infinitely many lines meet all four",
        (true, 0) => "no line meets all four",
        (true, 1) => "one line meets all four",
        (true, _) => "two lines meet all four",
    };
    let apart = match result.at_infinity.len() {
        0 => "",
        1 => ", and one line at infinity",
        _ => ", and two lines at infinity",
    };
    format!("{count}{apart}\nrank {}\n", result.rank)
}

fn family_text(family: &Family) -> String {
    let through = |line: &BigLine| {
        let [p, q] = points(line);
        format!("the line through {} and {}", tuple(&p), tuple(&q))
    };
    let center_text = |center: &ProjectivePoint| match point(center) {
        Center::Point(p) => format!("through ({}, {}, {})", p[0].0, p[1].0, p[2].0),
        Center::Direction(d) => format!("parallel to ({}, {}, {})", d[0].0, d[1].0, d[2].0),
    };
    let plane_text = |plane: &ProjectivePlane| {
        let [x, y, z] = &plane.normal;
        format!("the plane ({x}, {y}, {z})·x = {}", plane.offset)
    };
    let dimension = family.dimension();
    match family {
        Family::Pencil { center, plane } => {
            let (center, plane) = (center_text(center), plane_text(plane));
            format!("plane pencil, {dimension} parameter: the lines of {plane} {center}")
        }
        Family::Regulus { lines, paraboloid } => {
            let [a, b, c] = lines.as_ref();
            let surface = surface(*paraboloid);
            let (a, b, c) = (through(a), through(b), through(c));
            format!("regulus, {dimension} parameter: the ruling of a {surface} with {a}, {b}, {c}")
        }
        Family::Bundle { center } => {
            format!("bundle, {dimension} parameters: all lines {}", center_text(center))
        }
        Family::PlaneField { plane } => {
            format!("plane, {dimension} parameters: all lines of {}", plane_text(plane))
        }
        Family::Congruence { axes } => {
            let [a, b] = axes.as_ref();
            let (a, b) = (through(a), through(b));
            format!("linear congruence, {dimension} parameters: all lines meeting {a} and {b}")
        }
        Family::Complex { axis } => {
            format!("line complex, {dimension} parameters: all lines meeting {}", through(axis))
        }
    }
}

fn tuple([x, y, z]: &[Surd; 3]) -> String {
    format!("({x}, {y}, {z})")
}
