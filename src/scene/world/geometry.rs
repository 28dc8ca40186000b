//! JSON scenes that state geometry, to worlds.

use super::polygons::{Collector, Source};
use super::snap::Snap;
use super::warning::{Repair, Repairs};
use super::{Inside, Mark, Object, Place, World, WorldHint, WorldSolid, WorldWarning};
use crate::csg::{self, CsgError, NodeError, Placed};
use crate::formats::json::{
    BrushShape, GeometryFile, SceneBrush, ScenePlane, ScenePoint, SceneSolid,
};
use crate::geom::{AxialBox, BigPlane, RationalPoint3};
use crate::num::{Int, Number, Rational};
use crate::scene::SceneErrorKind;
use crate::scene::level::NoSolid;
use crate::scene::level::solid::{bounding, outward_plane};
use num_integer::Integer;
use num_traits::{One, Zero};
use rustc_hash::{FxHashMap, FxHashSet};

/// Which statement of a scene breaks a rule.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {kind}")]
pub struct StatementError {
    /// The statement, such as `brushes[3]`, or `line 7`, with its name if it has one.
    pub place: String,
    /// Its line, where that is known.
    pub line: Option<usize>,
    /// The rule broken.
    pub kind: StatementErrorKind,
}

/// The rules of geometry.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum StatementErrorKind {
    /// Nothing that occludes.
    #[error("nothing occludes, expected polygons or solids")]
    Nothing,
    /// Nothing marks the inside, though something is to.
    #[error("expected one point or more; without the field all empty space is asked about")]
    NoMark,
    /// A name that something else has.
    #[error("`{}` is the name of {first} too", .name.escape_debug())]
    NameTwice {
        /// The name.
        name: String,
        /// What has it already.
        first: String,
    },
    /// A coordinate that is not a multiple of the declared grid unit.
    #[error("coordinate {got} is not a multiple of the declared grid unit 1/{grid}")]
    OffGrid {
        /// The coordinate.
        got: Number,
        /// The declared number of grid units in one world unit.
        grid: Int,
    },
    /// A polygon that breaks a rule.
    #[error("{0}")]
    Polygon(SceneErrorKind),
    /// A box whose first corner is not below its second on every axis.
    #[error("the first corner of a box must be below the second on every axis")]
    Box,
    /// A plane without a direction.
    #[error("plane {plane}: {what}")]
    Plane {
        /// The plane, counted from 0.
        plane: usize,
        /// Why it has none.
        what: &'static str,
    },
    /// Planes that enclose nothing.
    #[error("{0}")]
    NoSolid(NoSolid),
    /// An expression that is malformed.
    #[error("{0}")]
    Expression(NodeError),
    /// An expression without a value.
    #[error("{0}")]
    NoValue(CsgError),
    /// Points whose hull is flat.
    #[error("its points lie in one plane, expected some with volume between them")]
    FlatHull,
}

type Result<T> = std::result::Result<T, StatementError>;

fn error(place: impl Into<String>, kind: StatementErrorKind) -> StatementError {
    StatementError { place: place.into(), line: None, kind }
}

/// The world that a scene states.
pub(super) fn world_of(
    file: &GeometryFile,
    snap: Option<u32>,
) -> Result<(World, Vec<WorldWarning>)> {
    check_names(file)?;
    check_grid(file)?;
    if file.polygons.is_empty() && file.brushes.is_empty() && file.solids.is_empty() {
        return Err(error("scene", StatementErrorKind::Nothing));
    }
    let mut reader = Reader { snap: snap.map(Snap::new), repairs: Repairs::default() };
    let mut solids = Vec::with_capacity(file.brushes.len());
    for (index, brush) in file.brushes.iter().enumerate() {
        let place = place("brushes", index, brush.name.as_ref());
        let planes = reader.solid(brush, &label("brushes", index), &place)?;
        solids.extend(planes.map(|planes| WorldSolid { planes, place }));
    }
    for (index, solid) in file.solids.iter().enumerate() {
        solids.extend(reader.expression(solid, index)?);
    }
    let mut hints = Vec::with_capacity(file.hints.len());
    for (index, hint) in file.hints.iter().enumerate() {
        let place = place("hints", index, hint.name.as_ref());
        let planes = reader.solid(hint, &label("hints", index), &place)?;
        let hint = |planes: Vec<_>| WorldHint { splits: vec![true; planes.len()], planes };
        hints.extend(planes.map(hint));
    }
    let mut objects = Vec::with_capacity(file.objects.len());
    for (index, object) in file.objects.iter().enumerate() {
        let place = place("objects", index, object.name.as_ref());
        let bounds = reader.bounds(&object.bounds, &label("objects", index), &place)?;
        objects.extend(bounds.map(|bounds| Object { bounds, place }));
    }
    let view = match &file.view {
        Some(view) => reader.bounds(view, "view", &Place { name: "view".into(), line: None })?,
        None => None,
    };
    let inside = match &file.inside {
        None => Inside::Everywhere,
        Some(marks) if marks.is_empty() => return Err(error("inside", StatementErrorKind::NoMark)),
        Some(marks) => Inside::Reached(
            marks.iter().enumerate().map(|(index, at)| reader.mark(index, at)).collect(),
        ),
    };
    let polygons = reader.polygons(file)?;
    let Reader { snap, repairs } = reader;
    let warnings = repairs.into_warnings().chain(snap.map(Snap::warning)).collect();
    Ok((World { solids, polygons, hints, objects, inside, view }, warnings))
}

/// Where something of a list stands in the file.
fn label(list: &str, index: usize) -> String {
    format!("{list}[{index}]")
}

/// Its own name, or where it stands.
fn place(list: &str, index: usize, name: Option<&String>) -> Place {
    Place { name: name.cloned().unwrap_or_else(|| label(list, index)), line: None }
}

fn check_names(file: &GeometryFile) -> Result<()> {
    let polygons = file.polygons.iter().map(|polygon| &polygon.name).enumerate();
    let brushes = file.brushes.iter().map(|brush| &brush.name).enumerate();
    let solids = file.solids.iter().map(|solid| &solid.name).enumerate();
    let objects = file.objects.iter().map(|object| &object.name).enumerate();
    let hints = file.hints.iter().map(|hint| &hint.name).enumerate();
    let all = polygons
        .map(|named| ("polygons", named))
        .chain(brushes.map(|named| ("brushes", named)))
        .chain(solids.map(|named| ("solids", named)))
        .chain(objects.map(|named| ("objects", named)))
        .chain(hints.map(|named| ("hints", named)));
    let mut known: FxHashMap<&str, String> = FxHashMap::default();
    for (list, (index, name)) in all {
        let Some(name) = name else { continue };
        let here = label(list, index);
        if let Some(first) = known.insert(name, here.clone()) {
            let kind = StatementErrorKind::NameTwice { name: name.clone(), first };
            return Err(error(format!("{here}.name"), kind));
        }
    }
    Ok(())
}

/// Whether all points are on the declared grid, if there is one.
fn check_grid(file: &GeometryFile) -> Result<()> {
    let Some(grid) = &file.grid else { return Ok(()) };
    let check = |place: &dyn Fn() -> String, points: &[ScenePoint]| -> Result<()> {
        for (index, coordinate) in points.as_flattened().iter().enumerate() {
            if !grid.0.is_multiple_of(coordinate.0.to_rational().denom()) {
                let (got, grid) = (coordinate.0.clone(), grid.0.clone());
                let place = format!("{}[{}]", place(), index / 3);
                return Err(error(place, StatementErrorKind::OffGrid { got, grid }));
            }
        }
        Ok(())
    };
    for (index, polygon) in file.polygons.iter().enumerate() {
        check(&|| format!("polygons[{index}].polygon"), &polygon.polygon)?;
    }
    for (list, brushes) in [("brushes", &file.brushes), ("hints", &file.hints)] {
        for (index, brush) in brushes.iter().enumerate() {
            let here = label(list, index);
            match &brush.shape {
                BrushShape::Points(points) => check(&|| format!("{here}.points"), points)?,
                BrushShape::Box(corners) => check(&|| format!("{here}.box"), corners)?,
                BrushShape::Planes(planes) => {
                    for (number, plane) in planes.iter().enumerate() {
                        if let ScenePlane::Points(points) = plane {
                            check(&|| format!("{here}.planes[{number}].points"), points)?;
                        }
                    }
                }
            }
        }
    }
    for (index, object) in file.objects.iter().enumerate() {
        check(&|| format!("objects[{index}].box"), &object.bounds)?;
    }
    check(&|| "inside".to_owned(), file.inside.as_deref().unwrap_or_default())?;
    check(&|| "view".to_owned(), file.view.as_ref().map_or(&[][..], |view| view))
}

struct Reader {
    snap: Option<Snap>,
    repairs: Repairs,
}

impl Reader {
    fn point(&mut self, point: &ScenePoint) -> RationalPoint3 {
        let exact = exact_point(point);
        self.snap.as_mut().map_or(exact.clone(), |snap| snap.point(&exact))
    }

    fn mark(&mut self, index: usize, at: &ScenePoint) -> Mark {
        Mark { point: self.point(at), place: place("inside", index, None) }
    }

    /// A box; `None` where rounding leaves it no volume.
    fn bounds(
        &mut self,
        corners: &[ScenePoint; 2],
        label: &str,
        place: &Place,
    ) -> Result<Option<AxialBox>> {
        let exact = corners.each_ref().map(exact_point);
        let Some(bounds) = axial_box(&exact) else {
            return Err(error(label, StatementErrorKind::Box));
        };
        let Some(snap) = &mut self.snap else { return Ok(Some(bounds)) };
        let rounded = axial_box(&exact.each_ref().map(|corner| snap.point(corner)));
        self.repairs.add(Repair::FlattenedSolid, usize::from(rounded.is_none()), Some(place));
        Ok(rounded)
    }

    /// The planes of a brush; `None` where rounding leaves it no volume.
    fn solid(
        &mut self,
        brush: &SceneBrush,
        label: &str,
        place: &Place,
    ) -> Result<Option<Vec<BigPlane>>> {
        let keep = |point: &[Number; 3]| point.clone();
        let solid = planes_of(&brush.shape, keep).map_err(|kind| error(label, kind))?;
        let solid = match &mut self.snap {
            None => solid,
            Some(snap) => {
                let Ok(rounded) = planes_of(&brush.shape, |point| snap.numbers(point)) else {
                    self.repairs.add(Repair::FlattenedSolid, 1, Some(place));
                    return Ok(None);
                };
                rounded
            }
        };
        self.repairs.add(Repair::RedundantPlane, solid.redundant, Some(place));
        Ok(Some(solid.planes))
    }

    /// The convex pieces of an expression.
    fn expression(&mut self, solid: &SceneSolid, index: usize) -> Result<Vec<WorldSolid>> {
        let place = place("solids", index, solid.name.as_ref());
        let broken = |kind| error(label("solids", index), kind);
        let placed = Placed::new(&solid.solid, &[])
            .map_err(|e| broken(StatementErrorKind::Expression(e)))?;
        let body = csg::evaluate(&placed.expression)
            .map_err(|e| broken(StatementErrorKind::NoValue(e)))?;
        let flat = placed.flat.len() + body.flat.len();
        self.repairs.add(Repair::FlatShape, flat, Some(&place));
        let pieces = body.cells.iter().map(|cell| {
            let faces = cell.faces().iter();
            let planes = faces.map(|face| body.planes.plane(face.support()).clone()).collect();
            WorldSolid { planes, place: place.clone() }
        });
        Ok(pieces.collect())
    }

    fn polygons(&mut self, file: &GeometryFile) -> Result<Vec<super::WorldPolygon>> {
        let mut collector = Collector::new(Source::Stated, self.snap.as_mut());
        for (index, polygon) in file.polygons.iter().enumerate() {
            let outline: Vec<_> = polygon.polygon.iter().map(exact_point).collect();
            let place = place("polygons", index, polygon.name.as_ref());
            collector.add(&outline, &place, &mut self.repairs).map_err(|kind| {
                error(label("polygons", index), StatementErrorKind::Polygon(kind))
            })?;
        }
        Ok(collector.polygons)
    }
}

fn numbers(point: &ScenePoint) -> [Number; 3] {
    point.each_ref().map(|coordinate| coordinate.0.clone())
}

fn rational(point: &[Number; 3]) -> RationalPoint3 {
    RationalPoint3::from(&point.each_ref().map(Number::to_rational))
}

fn exact_point(point: &ScenePoint) -> RationalPoint3 {
    rational(&numbers(point))
}

/// The box between two corners, where it has volume.
fn axial_box([low, high]: &[RationalPoint3; 2]) -> Option<AxialBox> {
    let bounds = AxialBox { low: low.coordinates(), high: high.coordinates() };
    bounds.has_volume().then_some(bounds)
}

/// The planes that bound a brush.
struct Solid {
    planes: Vec<BigPlane>,
    /// How many more were stated.
    redundant: usize,
}

/// The planes that bound a brush whose points are first passed through `point`.
fn planes_of(
    shape: &BrushShape,
    mut point: impl FnMut(&[Number; 3]) -> [Number; 3],
) -> std::result::Result<Solid, StatementErrorKind> {
    let all = |planes| Solid { planes, redundant: 0 };
    match shape {
        BrushShape::Box(corners) => {
            let corners = corners.each_ref().map(|corner| rational(&point(&numbers(corner))));
            axial_box(&corners).map(|b| all(box_planes(&b))).ok_or(StatementErrorKind::Box)
        }
        BrushShape::Points(points) => {
            let point = |p: &ScenePoint| point(&numbers(p)).map(|number| number.to_rational());
            let points: Vec<[Rational; 3]> = points.iter().map(point).collect();
            let halves = csg::hull(&points).map_err(|_| StatementErrorKind::FlatHull)?;
            Ok(all(halves.iter().filter_map(|h| equation(&h.normal, &h.offset)).collect()))
        }
        BrushShape::Planes(planes) => {
            let mut known = FxHashSet::default();
            let mut distinct = Vec::with_capacity(planes.len());
            for (number, plane) in planes.iter().enumerate() {
                let broken = |what| StatementErrorKind::Plane { plane: number, what };
                let plane = match plane {
                    ScenePlane::Equation { normal, offset } => {
                        equation(&numbers(normal).map(|n| n.to_rational()), &offset.0.to_rational())
                            .ok_or_else(|| broken("the normal is zero"))?
                    }
                    ScenePlane::Points(points) => {
                        // Stated counter-clockwise, where the planes of a `.map` run clockwise.
                        let [a, b, c] = points.each_ref().map(|p| point(&numbers(p)));
                        outward_plane(&[a, c, b])
                            .ok_or_else(|| broken("its three points are on one line"))?
                    }
                };
                if known.insert(plane.clone()) {
                    distinct.push(plane);
                }
            }
            let holds_face = bounding(&distinct.iter().collect::<Vec<_>>());
            let holds_face = holds_face.map_err(StatementErrorKind::NoSolid)?;
            let kept = distinct.into_iter().zip(holds_face);
            let kept: Vec<_> = kept.filter_map(|(plane, holds)| holds.then_some(plane)).collect();
            Ok(Solid { redundant: planes.len() - kept.len(), planes: kept })
        }
    }
}

/// The plane normal · x = offset, its coefficients without a common factor.
fn equation(normal: &[Rational; 3], offset: &Rational) -> Option<BigPlane> {
    let [x, y, z] = normal.clone();
    let all = [x, y, z, offset.clone()];
    let common = all.iter().fold(Int::one(), |common, c| common.lcm(c.denom()));
    let [x, y, z, offset] = all.map(|c: Rational| c.numer() * (&common / c.denom()));
    let normal = [x, y, z];
    if normal.iter().all(Zero::is_zero) {
        return None;
    }
    let divisor = normal.iter().fold(offset.clone(), |divisor, c| divisor.gcd(c));
    Some(BigPlane { normal: normal.map(|c| c / &divisor), offset: offset / &divisor })
}

/// The six planes of a box, outward.
fn box_planes(bounds: &AxialBox) -> Vec<BigPlane> {
    let side = |axis: usize, at: &Rational, sign: i32| {
        let mut normal = [Int::ZERO, Int::ZERO, Int::ZERO];
        normal[axis] = at.denom() * sign;
        BigPlane { normal, offset: at.numer() * sign }
    };
    let low = (0..3).map(|axis| side(axis, &bounds.low[axis], -1));
    low.chain((0..3).map(|axis| side(axis, &bounds.high[axis], 1))).collect()
}
