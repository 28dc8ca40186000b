//! Expressions from their JSON form: names resolved, shapes cut from planes, maps applied.

use super::brush::{BrushError, cuboid, cylinder, prism, pyramid, sphere, wedge};
use super::expression::{Expression, Half, Transform};
use super::hull::hull;
use crate::formats::csg::{Axis, CsgFile, Definition, Matrix, Node, PlaneNode, Reflection, Turn};
use crate::formats::json::Coordinate;
use crate::geom::vector::{cross, difference, dot};
use crate::num::{Int, Rational};
use num_traits::Zero;

/// An expression whose brushes know where they are stated.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Placed {
    /// The expression.
    pub expression: Expression,
    /// Where each brush is stated, in the order of the expression: `union[2].difference[0].box`.
    pub places: Vec<String>,
    /// Shapes without volume, left out of the expression.
    pub flat: Vec<String>,
}

/// What is wrong with a node, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {what}")]
pub struct NodeError {
    /// The keys and indices that lead to the node: `union[2].difference[0]`.
    pub place: String,
    /// The rule broken.
    pub what: NodeRule,
}

/// A rule that a node breaks.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NodeRule {
    /// An operator over nothing.
    #[error("expected one part at least, got none")]
    NoParts,
    /// A name that no definition before this place gives.
    #[error("no definition of `{0}` before this one")]
    UnknownName(String),
    /// A name that two definitions give.
    #[error("`{0}` is defined twice")]
    NameTwice(String),
    /// A plane in neither or in both of its forms.
    #[error("plane {0}: expected `normal` and `offset`, or `points`")]
    PlaneForm(usize),
    /// A plane without a direction.
    #[error("plane {0}: the normal is zero, or the points are on one line")]
    NoNormal(usize),
    /// A map that cannot be undone.
    #[error("the map is singular")]
    Singular,
    /// A shape that is none.
    #[error(transparent)]
    Shape(#[from] BrushError),
    /// Definitions that use each other too deeply.
    #[error("nested deeper than {MAX_DEPTH} levels")]
    TooDeep,
    /// Definitions that multiply.
    #[error("more than {MAX_BRUSHES} brushes")]
    TooManyBrushes,
}

/// How deep nodes may nest, with definitions put in where they are used.
pub const MAX_DEPTH: usize = 512;

/// How many brushes an expression may have, with definitions put in where they are used.
pub const MAX_BRUSHES: usize = 100_000;

impl TryFrom<&Node> for Expression {
    type Error = NodeError;

    /// The expression of a node that uses no definitions.
    fn try_from(node: &Node) -> Result<Expression, NodeError> {
        Ok(Placed::new(node, &[])?.expression)
    }
}

impl TryFrom<&CsgFile> for Placed {
    type Error = NodeError;

    fn try_from(file: &CsgFile) -> Result<Placed, NodeError> {
        Placed::new(&file.body, &file.define)
    }
}

impl Placed {
    /// The expression of a node, and of the definitions that it uses. Linear in the nodes, each
    /// counted as often as it is used, but for the hulls.
    ///
    /// # Errors
    /// [`NodeError`] names the place and the rule broken. Definitions that are not used are not
    /// looked into.
    pub fn new(node: &Node, define: &[Definition]) -> Result<Placed, NodeError> {
        for (i, definition) in define.iter().enumerate() {
            if define[..i].iter().any(|other| other.name == definition.name) {
                let place = format!("define[{i}]");
                let what = NodeRule::NameTwice(definition.name.clone());
                return Err(NodeError { place, what });
            }
        }
        let mut reader = Reader { path: Vec::new(), places: Vec::new(), flat: Vec::new() };
        let expression = reader.node(node, &Transform::identity(), define);
        let expression = expression.map_err(|what| NodeError { place: reader.place(), what })?;
        Ok(Placed { expression, places: reader.places, flat: reader.flat })
    }
}

/// Reads nodes. After an error, the path leads to where it is.
struct Reader {
    path: Vec<String>,
    places: Vec<String>,
    flat: Vec<String>,
}

impl Reader {
    /// The path; of a long one the beginning.
    fn place(&self) -> String {
        const LONG: usize = 32;
        match self.path.len() {
            0..=LONG => self.path.join("."),
            _ => format!("{}…", self.path[..LONG].join(".")),
        }
    }

    /// A node under a map, with the definitions that it may use.
    fn node(
        &mut self,
        node: &Node,
        map: &Transform,
        define: &[Definition],
    ) -> Result<Expression, NodeRule> {
        if self.path.len() >= MAX_DEPTH {
            return Err(NodeRule::TooDeep);
        }
        match node {
            Node::Union(of) => Ok(Expression::Union(self.parts("union", of, map, define)?)),
            Node::Intersection(of) => {
                Ok(Expression::Intersection(self.parts("intersection", of, map, define)?))
            }
            Node::Difference(of) => {
                let mut parts = self.parts("difference", of, map, define)?.into_iter();
                let from = parts.next().ok_or(NodeRule::NoParts)?;
                Ok(Expression::Difference(Box::new(from), parts.collect()))
            }
            Node::Complement(of) => {
                let of = self.step("complement".into(), |this| this.node(of, map, define))?;
                Ok(Expression::Complement(Box::new(of)))
            }
            Node::Use(name) => self.step(format!("use({name})"), |this| {
                let known = define.iter().position(|definition| definition.name == *name);
                let index = known.ok_or_else(|| NodeRule::UnknownName(name.clone()))?;
                this.node(&define[index].body, map, &define[..index])
            }),
            Node::Translate(vector) => {
                let shift = numbers(&vector.by);
                let inner = Transform { shift, ..Transform::identity() };
                self.mapped("translate", &inner, &vector.of, map, define)
            }
            Node::Scale(vector) => {
                let mut inner = Transform::identity();
                for (i, by) in numbers(&vector.by).into_iter().enumerate() {
                    inner.matrix[i][i] = by;
                }
                self.mapped("scale", &inner, &vector.of, map, define)
            }
            Node::Rotate90(turn) => {
                self.mapped("rotate90", &quarter_turns(turn), &turn.of, map, define)
            }
            Node::Mirror(Reflection { axis, of }) => {
                let mut inner = Transform::identity();
                let i = index(*axis);
                inner.matrix[i][i] = -&inner.matrix[i][i];
                self.mapped("mirror", &inner, of, map, define)
            }
            Node::Matrix(Matrix { rows, shift, of }) => {
                let matrix = rows.each_ref().map(numbers);
                let none = || [(); 3].map(|()| Rational::zero());
                let inner = Transform { matrix, shift: shift.as_ref().map_or_else(none, numbers) };
                self.mapped("matrix", &inner, of, map, define)
            }
            brush => {
                let (name, halves) = shape(brush);
                self.step(name.into(), |this| this.brush(halves, map))
            }
        }
    }

    /// Goes down by one step, and back up unless there is an error.
    fn step<T>(
        &mut self,
        step: String,
        inside: impl FnOnce(&mut Reader) -> Result<T, NodeRule>,
    ) -> Result<T, NodeRule> {
        self.path.push(step);
        let result = inside(self)?;
        self.path.pop();
        Ok(result)
    }

    fn parts(
        &mut self,
        name: &str,
        of: &[Node],
        map: &Transform,
        define: &[Definition],
    ) -> Result<Vec<Expression>, NodeRule> {
        if of.is_empty() {
            return self.step(name.into(), |_| Err(NodeRule::NoParts));
        }
        let mut parts = Vec::with_capacity(of.len());
        for (i, node) in of.iter().enumerate() {
            parts.push(self.step(format!("{name}[{i}]"), |this| this.node(node, map, define))?);
        }
        Ok(parts)
    }

    fn mapped(
        &mut self,
        name: &str,
        inner: &Transform,
        of: &Node,
        map: &Transform,
        define: &[Definition],
    ) -> Result<Expression, NodeRule> {
        self.step(name.into(), |this| match inner.is_invertible() {
            true => this.node(of, &map.after(inner), define),
            false => Err(NodeRule::Singular),
        })
    }

    fn brush(
        &mut self,
        halves: Result<Vec<Half>, NodeRule>,
        map: &Transform,
    ) -> Result<Expression, NodeRule> {
        if self.places.len() >= MAX_BRUSHES {
            return Err(NodeRule::TooManyBrushes);
        }
        match halves {
            Ok(halves) => {
                self.places.push(self.place());
                Ok(Expression::Brush(halves.iter().map(|half| map.image(half)).collect()))
            }
            Err(NodeRule::Shape(BrushError::Flat)) => {
                self.flat.push(self.place());
                // It holds nothing.
                Ok(Expression::Union(Vec::new()))
            }
            Err(rule) => Err(rule),
        }
    }
}

/// A brush's key and half-spaces.
///
/// # Panics
/// If the node is no brush.
fn shape(node: &Node) -> (&'static str, Result<Vec<Half>, NodeRule>) {
    let (name, halves) = match node {
        Node::Box(of) => ("box", cuboid(&numbers(&of.low), &numbers(&of.high))),
        Node::Wedge(of) => ("wedge", wedge(&numbers(&of.low), &numbers(&of.high))),
        Node::Prism(of) => ("prism", prism(&polygon(&of.polygon), &numbers(&of.heights))),
        Node::Pyramid(of) => {
            let height = of.height.0.to_rational();
            ("pyramid", pyramid(&polygon(&of.polygon), &height, &numbers(&of.apex)))
        }
        Node::Cylinder(of) => {
            let (center, heights) = (numbers(&of.center), numbers(&of.heights));
            let radius = of.radius.0.to_rational();
            ("cylinder", cylinder(&center, &radius, &heights, of.sides, &of.grid.0))
        }
        Node::Sphere(of) => {
            let radius = of.radius.0.to_rational();
            ("sphere", sphere(&numbers(&of.center), &radius, of.sides, &of.grid.0))
        }
        Node::Points(of) => {
            ("points", hull(&of.iter().map(numbers).collect::<Vec<[Rational; 3]>>()))
        }
        Node::Planes(of) => return ("planes", planes(of)),
        _ => unreachable!("an operator is no brush"),
    };
    (name, halves.map_err(NodeRule::Shape))
}

fn planes(of: &[PlaneNode]) -> Result<Vec<Half>, NodeRule> {
    let half = |(i, plane): (usize, &PlaneNode)| {
        let half = match (&plane.normal, &plane.offset, &plane.points) {
            (Some(normal), Some(offset), None) => {
                Half { normal: numbers(normal), offset: offset.0.to_rational() }
            }
            (None, None, Some(points)) => {
                let [a, b, c] = points.each_ref().map(numbers);
                let normal = cross(&difference(&b, &a), &difference(&c, &a));
                let offset = dot(&normal, &a);
                Half { normal, offset }
            }
            _ => return Err(NodeRule::PlaneForm(i)),
        };
        match half.normal.iter().all(Rational::is_zero) {
            true => Err(NodeRule::NoNormal(i)),
            false => Ok(half),
        }
    };
    of.iter().enumerate().map(half).collect()
}

fn quarter_turns(turn: &Turn) -> Transform {
    let mut map = Transform::identity();
    let axis = index(turn.axis);
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let (cosine, sine) = [(1, 0), (0, 1), (-1, 0), (0, -1)][turn.turns.rem_euclid(4) as usize];
    for (row, column, value) in [(i, i, cosine), (i, j, -sine), (j, i, sine), (j, j, cosine)] {
        map.matrix[row][column] = Rational::from(Int::from(value));
    }
    map
}

fn index(axis: Axis) -> usize {
    match axis {
        Axis::X => 0,
        Axis::Y => 1,
        Axis::Z => 2,
    }
}

fn numbers<const N: usize>(coordinates: &[Coordinate; N]) -> [Rational; N] {
    coordinates.each_ref().map(|coordinate| coordinate.0.to_rational())
}

fn polygon(vertices: &[[Coordinate; 2]]) -> Vec<[Rational; 2]> {
    vertices.iter().map(numbers).collect()
}
