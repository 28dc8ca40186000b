//! Inputs by their coordinates, and the cases that ask about them.
//!
//! All coordinates are rationals, and points have two or three of them: what a law or the reducer
//! does to coordinates it does to every kind of case alike.

use crate::formats::json::{
    BrushShape, Coordinate, GeometryFile, PlanFile, PlanFilePortal, PlanGraphFile, SceneBrush,
    SceneFile, SceneKind, ScenePortal,
};
use crate::formats::lines::LinesFile;
use crate::formats::sequence::SequenceFile;
use crate::num::{Number, Rational};
use crate::vectors::{Case, Kind};
use num_traits::One;
use serde_json::{Value, json};

/// Two or three coordinates, in world units.
pub type Point = Vec<Rational>;

/// Points in order: three or more in space; a segment's two ends in the plane.
pub type Polygon = Vec<Point>;

/// What is asked about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Input {
    /// A portal sequence (`stabline-sequence/1`): open, grazing or blocked?
    Sequence(Vec<Polygon>),
    /// Four lines, two points each (`stabline-lines/1`): how many lines meet all?
    Lines(Vec<Polygon>),
    /// A portal graph (`stabline-scene/1`): does one cell see the other?
    Graph(Graph),
    /// What occludes (`stabline-scene/1`): does one convex region see the other?
    Scene(Scene),
}

/// A portal graph and a pair of its cells.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graph {
    /// How many cells; each is named by its number.
    pub cells: usize,
    /// The portals.
    pub doors: Vec<Door>,
    /// The cell that looks.
    pub from: usize,
    /// The cell looked for.
    pub to: usize,
}

/// A portal of a graph.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Door {
    /// The cell that the right-hand normal leaves, and the one that it enters.
    pub cells: [usize; 2],
    /// Counter-clockwise as seen from the second cell; in the plane the left end and the right one.
    pub polygon: Polygon,
}

/// Occluders, and two convex regions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Scene {
    /// Thin occluders: polygons in space, segments in the plane.
    pub polygons: Vec<Polygon>,
    /// Convex solids, each the hull of its points; none in the plane.
    pub brushes: Vec<Polygon>,
    /// The region that looks: a box by two of its opposite corners; in the plane a convex polygon.
    pub from: Polygon,
    /// The region looked for.
    pub to: Polygon,
}

/// Why a case cannot be taken apart.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum CaseError {
    /// The input is not of its format.
    #[error("input: {0}")]
    Input(String),
    /// A cell or a region that is named and is not there.
    #[error("{field}: there is no `{name}` in the input")]
    Unknown {
        /// `from`, `to`, or the portal's.
        field: &'static str,
        /// The name.
        name: String,
    },
    /// A case of two cells without one of them.
    #[error("{0}: missing")]
    Missing(&'static str),
    /// A kind, or a form of input, that the forge does not make.
    #[error("{0}")]
    Kind(&'static str),
}

impl Input {
    /// Its kind in the protocol.
    pub fn kind(&self) -> Kind {
        match self {
            Input::Sequence(_) => Kind::Sequence,
            Input::Lines(_) => Kind::Transversals,
            Input::Graph(_) => Kind::Graph,
            Input::Scene(_) => Kind::Scene,
        }
    }

    /// Everything that has coordinates.
    pub fn polygons(&self) -> Vec<&Polygon> {
        match self {
            Input::Sequence(polygons) | Input::Lines(polygons) => polygons.iter().collect(),
            Input::Graph(graph) => graph.doors.iter().map(|door| &door.polygon).collect(),
            Input::Scene(scene) => {
                let occluders = scene.polygons.iter().chain(&scene.brushes);
                occluders.chain([&scene.from, &scene.to]).collect()
            }
        }
    }

    /// Everything that has coordinates, to be changed; in the order of [`Input::polygons`].
    pub fn polygons_mut(&mut self) -> Vec<&mut Polygon> {
        match self {
            Input::Sequence(polygons) | Input::Lines(polygons) => polygons.iter_mut().collect(),
            Input::Graph(graph) => graph.doors.iter_mut().map(|door| &mut door.polygon).collect(),
            Input::Scene(scene) => {
                let occluders = scene.polygons.iter_mut().chain(&mut scene.brushes);
                occluders.chain([&mut scene.from, &mut scene.to]).collect()
            }
        }
    }

    /// How many coordinates its points have: 2 or 3, and 3 where there is no point.
    pub fn dimension(&self) -> usize {
        let point = self.polygons().into_iter().flatten().next();
        point.map_or(3, Vec::len)
    }

    /// The same with every point mapped.
    pub fn mapped(&self, map: impl Fn(&Point) -> Point) -> Input {
        let mut input = self.clone();
        for point in input.polygons_mut().into_iter().flatten() {
            *point = map(point);
        }
        input
    }

    /// The input as the document of its format.
    pub fn document(&self) -> Value {
        match self {
            Input::Sequence(polygons) => {
                json!({"format": "stabline-sequence/1", "portals": polygons_json(polygons)})
            }
            Input::Lines(lines) => {
                json!({"format": "stabline-lines/1", "lines": polygons_json(lines)})
            }
            Input::Graph(graph) => {
                let shape = if self.dimension() == 2 { "segment" } else { "polygon" };
                let door = |door: &Door| {
                    let [from, to] = door.cells.map(|cell| cell.to_string());
                    json!({"from": from, "to": to, shape: polygon_json(&door.polygon)})
                };
                let cells: Vec<String> = (0..graph.cells).map(|cell| cell.to_string()).collect();
                let doors: Vec<Value> = graph.doors.iter().map(door).collect();
                json!({"about": "", "format": "stabline-scene/1", "cells": cells, "portals": doors})
            }
            Input::Scene(scene) if self.dimension() == 2 => {
                let object =
                    |name, polygon| json!({"name": name, "polygon": polygon_json(polygon)});
                json!({"about": "", "format": "stabline-scene/1", "view": self.view(),
                    "segments": polygons_json(&scene.polygons),
                    "objects": [object("from", &scene.from), object("to", &scene.to)]})
            }
            Input::Scene(scene) => {
                let polygon = |polygon: &Polygon| json!({"polygon": polygon_json(polygon)});
                let brush = |points: &Polygon| json!({"points": polygon_json(points)});
                let object = |name, corners| json!({"name": name, "box": polygon_json(&sorted_box(corners))});
                let polygons: Vec<Value> = scene.polygons.iter().map(polygon).collect();
                let brushes: Vec<Value> = scene.brushes.iter().map(brush).collect();
                json!({"about": "", "format": "stabline-scene/1", "view": self.view(),
                    "polygons": polygons, "brushes": brushes,
                    "objects": [object("from", &scene.from), object("to", &scene.to)]})
            }
        }
    }

    /// The box around everything, and a unit more: without it a scene reaches a stated number of
    /// units past what occludes, and a region beyond is seen from nowhere.
    fn view(&self) -> Value {
        let points = || self.polygons().into_iter().flatten();
        let reach = |axis: usize| -> Option<[Rational; 2]> {
            let low = points().map(|p| &p[axis]).min()? - Rational::one();
            Some([low, points().map(|p| &p[axis]).max()? + Rational::one()])
        };
        let axes: Vec<[Rational; 2]> = (0..self.dimension()).filter_map(reach).collect();
        let corner = |end: usize| axes.iter().map(|axis| axis[end].clone()).collect();
        polygon_json(&vec![corner(0), corner(1)])
    }

    /// The case that asks about it.
    pub fn case(&self, id: u32, comment: &str, flags: &[&str]) -> Case {
        let (from, to) = match self {
            Input::Sequence(_) | Input::Lines(_) => (None, None),
            Input::Graph(graph) => (Some(graph.from.to_string()), Some(graph.to.to_string())),
            Input::Scene(_) => (Some("from".to_owned()), Some("to".to_owned())),
        };
        Case {
            tc_id: id,
            kind: self.kind(),
            input: self.document(),
            from,
            to,
            comment: comment.to_owned(),
            flags: flags.iter().map(|flag| (*flag).to_owned()).collect(),
        }
    }

    /// The input of a case.
    ///
    /// # Errors
    /// [`CaseError`] names what is wrong.
    pub fn of_case(case: &Case) -> Result<Input, CaseError> {
        let text = case.input.to_string();
        let bytes = text.as_bytes();
        let ends = || {
            let from = case.from.as_deref().ok_or(CaseError::Missing("from"))?;
            Ok::<_, CaseError>([from, case.to.as_deref().ok_or(CaseError::Missing("to"))?])
        };
        match case.kind {
            Kind::Sequence => {
                let file = SequenceFile::read(bytes).map_err(wrong)?;
                file.points().map_err(wrong)?;
                Ok(Input::Sequence(file.portals.iter().map(|p| polygon_of(p)).collect()))
            }
            Kind::Transversals => {
                let file = LinesFile::read(bytes).map_err(wrong)?;
                file.lines().map_err(wrong)?;
                Ok(Input::Lines(file.lines.iter().map(|line| polygon_of(line)).collect()))
            }
            Kind::Graph => graph_of(bytes, ends()?),
            Kind::Scene => scene_of(bytes, ends()?),
            Kind::Eye => Err(CaseError::Kind("kind: the forge makes no cases of eyes")),
        }
    }
}

fn wrong(error: impl std::fmt::Display) -> CaseError {
    CaseError::Input(error.to_string())
}

fn polygon_of<P: AsRef<[Coordinate]>>(points: &[P]) -> Polygon {
    let point = |p: &P| p.as_ref().iter().map(|c| c.0.to_rational()).collect();
    points.iter().map(point).collect()
}

fn graph_of(bytes: &[u8], [from, to]: [&str; 2]) -> Result<Input, CaseError> {
    let (cells, doors): (Vec<String>, Vec<(String, String, Polygon)>) =
        match SceneKind::of(bytes).map_err(wrong)? {
            SceneKind::Graph => {
                let file = SceneFile::read(bytes).map_err(wrong)?;
                let door = |p: ScenePortal| (p.from, p.to, polygon_of(&p.polygon));
                (file.cells, file.portals.into_iter().map(door).collect())
            }
            SceneKind::PlanGraph => {
                let file = PlanGraphFile::read(bytes).map_err(wrong)?;
                let door = |p: PlanFilePortal| (p.from, p.to, polygon_of(&p.segment));
                (file.cells, file.portals.into_iter().map(door).collect())
            }
            SceneKind::Geometry | SceneKind::Plan => {
                return Err(CaseError::Kind("input: expected cells and portals"));
            }
        };
    let number = |field, name: &str| {
        let unknown = || CaseError::Unknown { field, name: name.to_owned() };
        cells.iter().position(|cell| cell == name).ok_or_else(unknown)
    };
    let door = |(from, to, polygon): (String, String, Polygon)| {
        let cells = [number("portals", &from)?, number("portals", &to)?];
        Ok(Door { cells, polygon })
    };
    let doors = doors.into_iter().map(door).collect::<Result<Vec<Door>, CaseError>>()?;
    let (from, to) = (number("from", from)?, number("to", to)?);
    Ok(Input::Graph(Graph { cells: cells.len(), doors, from, to }))
}

fn scene_of(bytes: &[u8], [from, to]: [&str; 2]) -> Result<Input, CaseError> {
    type Named = Vec<(Option<String>, Polygon)>;
    let region = |objects: &Named, field, name: &str| {
        let found = objects.iter().find(|(given, _)| given.as_deref() == Some(name));
        let unknown = || CaseError::Unknown { field, name: name.to_owned() };
        found.map(|(_, polygon)| polygon.clone()).ok_or_else(unknown)
    };
    match SceneKind::of(bytes).map_err(wrong)? {
        SceneKind::Plan => {
            let file = PlanFile::read(bytes).map_err(wrong)?;
            let objects: Named =
                file.objects.into_iter().map(|o| (o.name, polygon_of(&o.polygon))).collect();
            Ok(Input::Scene(Scene {
                polygons: file.segments.iter().map(|ends| polygon_of(ends)).collect(),
                brushes: Vec::new(),
                from: region(&objects, "from", from)?,
                to: region(&objects, "to", to)?,
            }))
        }
        SceneKind::Geometry => {
            let file = GeometryFile::read(bytes).map_err(wrong)?;
            let objects: Named =
                file.objects.into_iter().map(|o| (o.name, polygon_of(&o.bounds))).collect();
            let brush = |brush: &SceneBrush| match &brush.shape {
                BrushShape::Points(points) => Ok(polygon_of(points)),
                BrushShape::Box([low, high]) => Ok(box_corners(&polygon_of(&[low, high]))),
                BrushShape::Planes(_) => {
                    Err(CaseError::Kind("input: the forge takes no brushes of planes"))
                }
            };
            Ok(Input::Scene(Scene {
                polygons: file.polygons.iter().map(|p| polygon_of(&p.polygon)).collect(),
                brushes: file.brushes.iter().map(brush).collect::<Result<_, CaseError>>()?,
                from: region(&objects, "from", from)?,
                to: region(&objects, "to", to)?,
            }))
        }
        SceneKind::Graph | SceneKind::PlanGraph => {
            Err(CaseError::Kind("input: expected what occludes, and objects"))
        }
    }
}

/// A box by its corners of least and of greatest coordinates.
pub(super) fn sorted_box(corners: &Polygon) -> Polygon {
    let pick = |choose: fn(Rational, Rational) -> Rational| -> Point {
        corners[0].iter().zip(&corners[1]).map(|(a, b)| choose(a.clone(), b.clone())).collect()
    };
    vec![pick(Ord::min), pick(Ord::max)]
}

/// The eight corners of a box that is given by two opposite ones.
pub(super) fn box_corners(corners: &Polygon) -> Polygon {
    let corner = |bits: usize| (0..3).map(|i| corners[bits >> i & 1][i].clone()).collect();
    (0..8).map(corner).collect()
}

pub(super) fn polygons_json(polygons: &[Polygon]) -> Value {
    polygons.iter().map(polygon_json).collect()
}

fn polygon_json(polygon: &Polygon) -> Value {
    let point = |point: &Point| -> Value { point.iter().map(coordinate_json).collect() };
    polygon.iter().map(point).collect()
}

/// A JSON integer while it fits in 53 bits, else a string.
fn coordinate_json(coordinate: &Rational) -> Value {
    match Number::from(coordinate.clone()) {
        Number::Small(integer, 1) if integer.unsigned_abs() < 1 << 53 => integer.into(),
        number => number.to_string().into(),
    }
}
