//! What an expression of brushes comes to, as canonical text, as `stabline-body/1` and, its tree,
//! as `stabline-csg-bsp/1`.

use super::InputId;
use super::eye::{EyeInput, Integer, Ratio};
use crate::construct::{PlaneId, PlaneSet, Polygon};
use crate::csg::{Body, Child};
use crate::geom::RationalPoint3;
use crate::num::Rational;
use num_traits::ToPrimitive;
use rustc_hash::FxHashMap;
use schemars::JsonSchema;
use serde::Serialize;

/// A body: the value of an expression of brushes.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(title = "stabline-body/1")]
pub struct BodyReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-body/1$"))]
    format: &'static str,
    /// The input.
    input: EyeInput,
    /// How many brushes with volume the expression has.
    brushes: usize,
    /// Where brushes without volume are stated; they hold nothing.
    flat: Vec<String>,
    /// How many planes its tree has.
    splits: usize,
    /// The volume.
    volume: Ratio,
    /// The area of the boundary; null where it is irrational.
    surface_area: Option<Ratio>,
    /// The points that polygons name by number.
    vertices: Vec<[Ratio; 3]>,
    /// The boundary: convex polygons that overlap in edges at most.
    boundary: Vec<BodyPolygon>,
    /// Convex cells that tile the body.
    cells: Vec<BodyCell>,
}

/// A convex polygon.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
struct BodyPolygon {
    /// Its plane, whose normal points outwards.
    plane: BodyPlane,
    /// Its vertices by number, counter-clockwise as seen from outside.
    vertices: Vec<usize>,
}

/// The points x with normal · x = offset.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
struct BodyPlane {
    /// Without a common factor with the offset.
    normal: [Integer; 3],
    /// The offset along the normal.
    offset: Integer,
}

/// A convex cell.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
struct BodyCell {
    /// Its volume.
    volume: Ratio,
    /// Its faces, as the boundary's polygons.
    faces: Vec<BodyPolygon>,
}

/// The tree that divides space into a body and the rest.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(title = "stabline-csg-bsp/1")]
pub struct BodyTreeReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-csg-bsp/1$"))]
    format: &'static str,
    /// The input.
    input: EyeInput,
    /// The root.
    root: BodyChild,
    /// The inner nodes, each after its parent.
    nodes: Vec<BodyNode>,
}

/// An inner node.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
struct BodyNode {
    /// The splitting plane.
    plane: BodyPlane,
    /// What is on the side that the normal points to.
    front: BodyChild,
    /// What is on the other side.
    back: BodyChild,
}

/// An inner node by number, or a leaf.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(untagged)]
enum BodyChild {
    Node(u32),
    Leaf(BodyLeaf),
}

/// What a leaf is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum BodyLeaf {
    Inside,
    Outside,
}

impl BodyReport {
    /// The name of the format.
    pub const FORMAT: &'static str = "stabline-body/1";

    /// Describes a body of `brushes` brushes with volume, and others at `flat`.
    pub fn new(input: InputId, body: &Body, brushes: usize, flat: Vec<String>) -> BodyReport {
        let mut vertices = Vertices::default();
        let boundary = vertices.polygons(&body.planes, &body.boundary);
        let cells = body.cells.iter().map(|cell| BodyCell {
            volume: (&cell.volume()).into(),
            faces: vertices.polygons(&body.planes, cell.faces()),
        });
        let cells = cells.collect();
        BodyReport {
            format: BodyReport::FORMAT,
            input: input.into(),
            brushes,
            flat,
            splits: body.tree.nodes.len(),
            volume: (&body.volume()).into(),
            surface_area: body.surface_area().as_ref().map(Ratio::from),
            vertices: vertices.points,
            boundary,
            cells,
        }
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(BodyReport).to_value()
    }

    /// As `stabline-body/1`.
    pub fn to_json(&self) -> String {
        format!("{}\n", serde_json::json!(self))
    }
}

impl BodyTreeReport {
    /// The name of the format.
    pub const FORMAT: &'static str = "stabline-csg-bsp/1";

    /// Describes a body's tree.
    pub fn new(input: InputId, body: &Body) -> BodyTreeReport {
        let child = |child: Child| match child {
            Child::Node(node) => BodyChild::Node(node),
            Child::Inside => BodyChild::Leaf(BodyLeaf::Inside),
            Child::Outside => BodyChild::Leaf(BodyLeaf::Outside),
        };
        let nodes = body.tree.nodes.iter().map(|node| BodyNode {
            plane: plane(&body.planes, node.plane),
            front: child(node.children[0]),
            back: child(node.children[1]),
        });
        BodyTreeReport {
            format: BodyTreeReport::FORMAT,
            input: input.into(),
            root: child(body.tree.root),
            nodes: nodes.collect(),
        }
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(BodyTreeReport).to_value()
    }

    /// As `stabline-csg-bsp/1`.
    pub fn to_json(&self) -> String {
        format!("{}\n", serde_json::json!(self))
    }
}

/// A body in some lines of text.
pub fn body_text(name: &str, body: &Body, brushes: usize, flat: usize) -> String {
    let area = match body.surface_area() {
        Some(area) => shown(&area),
        None => "irrational".to_owned(),
    };
    format!(
        "{name}: {brushes} brushes, {flat} others without volume\n\
         volume        {}\n\
         surface area  {area}\n\
         {} cells, {} polygons in the boundary, {} planes in the tree\n",
        shown(&body.volume()),
        body.cells.len(),
        body.boundary.len(),
        body.tree.nodes.len(),
    )
}

/// A number as it is, or its beginning where it is long.
fn shown(value: &Rational) -> String {
    const LONG: usize = 48;
    let exact = value.to_string();
    let thousandths = (value * Rational::from_integer(1000.into())).floor().to_integer();
    match thousandths.to_i128() {
        Some(thousandths) if exact.len() > LONG && thousandths >= 0 => {
            let (whole, rest) = (thousandths / 1000, thousandths % 1000);
            format!("{whole}.{rest:03}… (exactly with --json)")
        }
        Some(_) | None => exact,
    }
}

fn plane(planes: &PlaneSet, id: PlaneId) -> BodyPlane {
    let plane = planes.plane(id);
    BodyPlane {
        normal: plane.normal.each_ref().map(Integer::from),
        offset: Integer::from(&plane.offset),
    }
}

/// Points by number, equal ones once.
#[derive(Default)]
struct Vertices {
    points: Vec<[Ratio; 3]>,
    numbers: FxHashMap<RationalPoint3, usize>,
}

impl Vertices {
    fn polygons(&mut self, planes: &PlaneSet, polygons: &[Polygon]) -> Vec<BodyPolygon> {
        let mut number = |point: RationalPoint3| {
            if let Some(&known) = self.numbers.get(&point) {
                return known;
            }
            self.points.push(point.coordinates().each_ref().map(Ratio::from));
            self.numbers.insert(point, self.points.len() - 1);
            self.points.len() - 1
        };
        let polygon = |polygon: &Polygon| BodyPolygon {
            plane: plane(planes, polygon.support()),
            vertices: polygon.points().into_iter().map(&mut number).collect(),
        };
        polygons.iter().map(polygon).collect()
    }
}
