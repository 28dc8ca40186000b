//! Portals and portal sequences, validated.
//!
//! A portal is a planar convex polygon, its vertices counter-clockwise as seen from the side to
//! which a line leaves through it. Vertices in the middle of a straight side are accepted: the two
//! edges beside them have one and the same supporting line, so they bound the same half-space and
//! change no verdict; certificates and lists of touched edges may name either. What is refused
//! is what would make the sides' signs mean something else: fewer than three vertices, a vertex
//! given twice, zero area, vertices off the plane, a reflex corner or a second turn.

use crate::geom::BigPoint3;
use crate::geom::vector::{cross, difference, dot};
use crate::num::{Int, Sign};
use num_integer::Integer;

/// Why a polygon is not a portal.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum PortalError {
    /// A polygon needs three vertices.
    #[error("has {count} vertices; a portal has at least three")]
    TooFewVertices {
        /// How many there are.
        count: usize,
    },
    /// Two vertices are the same point.
    #[error("vertex {second} is the same point as vertex {first}")]
    RepeatedVertex {
        /// The earlier vertex.
        first: usize,
        /// The later one.
        second: usize,
    },
    /// The vertices lie on one line, or their area vector cancels.
    #[error("has no area")]
    NoArea,
    /// A vertex lies off the plane of the others.
    #[error("vertex {vertex} is not in the plane through vertex 0 along the polygon's area")]
    NotPlanar {
        /// The first such vertex.
        vertex: usize,
    },
    /// A vertex lies outside an edge.
    #[error("is not convex: vertex {vertex} lies outside edge {edge}")]
    NotConvex {
        /// The edge from this vertex to the next.
        edge: usize,
        /// The vertex on the wrong side of it.
        vertex: usize,
    },
}

/// In what the vectors of lines are measured: moments about a point, in multiples of a unit.
///
/// A line's direction is in grid units. A grid that holds vertices of many denominators is fine,
/// and edges' rows are long on it; in units as coarse as the input's own each row has only the
/// digits of its edge. Signs of sides and of the quadric do not depend on the frame.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    origin: [Int; 3],
    /// Invariant: positive.
    unit: Int,
}

impl Default for Frame {
    fn default() -> Frame {
        Frame::about(&[Int::ZERO, Int::ZERO, Int::ZERO])
    }
}

impl Frame {
    /// Grid units, about a point.
    pub fn about(origin: &[Int; 3]) -> Frame {
        Frame { origin: origin.clone(), unit: Int::from(1) }
    }

    /// Multiples of `unit` grid units, about a multiple of the unit near a point.
    ///
    /// # Panics
    /// If the unit is not positive.
    pub fn near(point: &[Int; 3], unit: &Int) -> Frame {
        assert!(*unit > Int::ZERO, "a unit is positive");
        Frame { origin: point.each_ref().map(|c| c.div_floor(unit) * unit), unit: unit.clone() }
    }

    /// The point that moments are taken about, in grid units.
    pub fn origin(&self) -> &[Int; 3] {
        &self.origin
    }

    /// The unit of moments, in grid units.
    pub fn unit(&self) -> &Int {
        &self.unit
    }

    /// A multiple by a positive number of the row on vectors of this frame, where it is given on
    /// those of grid units.
    fn row(&self, row: [Int; 6]) -> [Int; 6] {
        if self.unit == Int::from(1) {
            return row;
        }
        // a·d + b·m = a·d + (unit b)·(m / unit).
        let [ax, ay, az, bx, by, bz] = row;
        let scaled = [ax, ay, az, bx * &self.unit, by * &self.unit, bz * &self.unit];
        let divisor = scaled.iter().fold(Int::ZERO, |g, c| g.gcd(c));
        if divisor == Int::ZERO { scaled } else { scaled.map(|c| c / &divisor) }
    }

    /// The form side(·, vector) on vectors of this frame, divided by its content; and the content.
    /// The vector is in grid units about the grid's origin, and not zero.
    ///
    /// For x of this frame and y the same vector in grid units, side(y, vector) is the content
    /// times form · x, and Q(y) is the unit times Q(x).
    pub(super) fn form(&self, vector: &[Int; 6]) -> ([Int; 6], Int) {
        let [dx, dy, dz, mx, my, mz] = vector;
        let direction = [dx, dy, dz].map(Clone::clone);
        let turn = cross(&self.origin, &direction);
        let [ax, ay, az]: [Int; 3] = std::array::from_fn(|i| [mx, my, mz][i] - &turn[i]);
        let [bx, by, bz] = direction.map(|c| c * &self.unit);
        let form = [ax, ay, az, bx, by, bz];
        let content = form.iter().fold(Int::ZERO, |g, c| g.gcd(c));
        (form.map(|c| c / &content), content)
    }

    /// A multiple by a positive number of a vector of this frame, in grid units.
    pub(super) fn on_grid(&self, vector: &[Int; 6]) -> [Int; 6] {
        let [dx, dy, dz, mx, my, mz] = vector.clone();
        [dx, dy, dz, mx * &self.unit, my * &self.unit, mz * &self.unit]
    }
}

/// A planar convex polygon that lines cross in the direction of its right-hand normal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Portal3 {
    /// Invariant: three or more, distinct, coplanar, convex, counter-clockwise about `normal`.
    vertices: Vec<BigPoint3>,
    /// Invariant: primitive, not zero, `normal · v = offset` for every vertex.
    normal: [Int; 3],
    offset: Int,
    /// Primitive edge directions: those from vertex `i` to vertex `i + 1`.
    directions: Vec<[Int; 3]>,
}

impl Portal3 {
    /// The portal with these vertices, in grid units.
    ///
    /// # Errors
    /// [`PortalError`] names the first rule that the polygon breaks.
    pub fn new(vertices: &[BigPoint3]) -> Result<Portal3, PortalError> {
        let count = vertices.len();
        if count < 3 {
            return Err(PortalError::TooFewVertices { count });
        }
        for second in 0..count {
            if let Some(first) = (0..second).find(|&first| vertices[first] == vertices[second]) {
                return Err(PortalError::RepeatedVertex { first, second });
            }
        }
        let edges: Vec<[Int; 3]> = (0..count)
            .map(|i| difference(&vertices[(i + 1) % count].coordinates, &vertices[i].coordinates))
            .collect();
        let normal = area_vector(vertices);
        if content(&normal) == Int::ZERO {
            return Err(PortalError::NoArea);
        }
        let (normal, _) = primitive(normal);
        let offset = dot(&normal, &vertices[0].coordinates);
        if let Some(vertex) = vertices.iter().position(|v| dot(&normal, &v.coordinates) != offset) {
            return Err(PortalError::NotPlanar { vertex });
        }
        for (edge, direction) in edges.iter().enumerate() {
            let inward = cross(&normal, direction);
            for (vertex, v) in vertices.iter().enumerate() {
                let height = dot(&inward, &difference(&v.coordinates, &vertices[edge].coordinates));
                match Sign::of(&height) {
                    // On the edge's line: one of its ends, or a vertex in a straight side.
                    Sign::Zero | Sign::Positive => {}
                    Sign::Negative => return Err(PortalError::NotConvex { edge, vertex }),
                }
            }
        }
        let directions = edges.into_iter().map(|edge| primitive(edge).0).collect();
        Ok(Portal3 { vertices: vertices.to_vec(), normal, offset, directions })
    }

    /// The vertices, in grid units, in the order given.
    pub fn vertices(&self) -> &[BigPoint3] {
        &self.vertices
    }

    /// The primitive normal: the side to which a line leaves.
    pub fn normal(&self) -> &[Int; 3] {
        &self.normal
    }

    /// `normal · v` for every vertex `v`.
    pub fn offset(&self) -> &Int {
        &self.offset
    }

    /// The same portal crossed the other way, its vertices in reverse order.
    pub fn reversed(&self) -> Portal3 {
        let vertices: Vec<_> = self.vertices.iter().rev().cloned().collect();
        let negated = |v: &[Int; 3]| v.each_ref().map(|c| -c);
        let count = vertices.len();
        // Edge i of the reverse runs from old vertex n-1-i to n-2-i: old edge n-2-i, turned.
        let old = |i: usize| (2 * count - 2 - i) % count;
        Portal3 {
            vertices,
            normal: negated(&self.normal),
            offset: -&self.offset,
            directions: (0..count).map(|i| negated(&self.directions[old(i)])).collect(),
        }
    }

    /// The row `a` with `a · x = side(x, edge) / length` for the edge's primitive direction, with
    /// the origin moved to `origin`.
    pub(super) fn edge_row(&self, edge: usize, origin: &[Int; 3]) -> [Int; 6] {
        let direction = &self.directions[edge];
        let [mx, my, mz] = cross(&difference(&self.vertices[edge].coordinates, origin), direction);
        let [dx, dy, dz] = direction.clone();
        [mx, my, mz, dx, dy, dz]
    }

    /// A positive multiple of the edge's row, on vectors of a frame.
    pub(super) fn edge_row_in(&self, edge: usize, frame: &Frame) -> [Int; 6] {
        frame.row(self.edge_row(edge, &frame.origin))
    }

    /// A positive multiple of the order row, on vectors of a frame.
    pub(super) fn order_row_in(&self, next: &Portal3, frame: &Frame) -> Option<[Int; 6]> {
        Some(frame.row(self.order_row(next, &frame.origin)?.0))
    }

    /// The row that is positive on the lines that cross this portal's plane before the plane of
    /// `next` (both in the direction of their normals), divided by its content; and the content.
    /// `None` where the planes are the same: then every line crosses both in one point.
    pub(super) fn order_row(&self, next: &Portal3, origin: &[Int; 3]) -> Option<([Int; 6], Int)> {
        // With d the direction and m = p × d the moment of a line through p, it meets the plane
        // n·x = c at p + t d, t = (c - n·p)/(n·d). So t2 - t1 has the sign of
        //   (c2 - n2·p)(n1·d) - (c1 - n1·p)(n2·d) = (c2 n1 - c1 n2)·d + (n1 × n2)·m:
        // the side product with the line (n1 × n2, c2 n1 - c1 n2), where the planes meet.
        let (first, second) = (self.height_of(origin), next.height_of(origin));
        let moment: [Int; 3] =
            std::array::from_fn(|i| &second * &self.normal[i] - &first * &next.normal[i]);
        let [mx, my, mz] = moment;
        let [dx, dy, dz] = cross(&self.normal, &next.normal);
        let row = [mx, my, mz, dx, dy, dz];
        let divisor = row.iter().fold(Int::ZERO, |g, c| g.gcd(c));
        (divisor != Int::ZERO).then(|| (row.map(|c| c / &divisor), divisor))
    }

    /// The plane's offset, seen from another origin.
    pub(super) fn height_of(&self, origin: &[Int; 3]) -> Int {
        &self.offset - dot(&self.normal, origin)
    }
}

fn content(vector: &[Int; 3]) -> Int {
    vector.iter().fold(Int::ZERO, |g, c| g.gcd(c))
}

/// A vector that is not zero, divided by its content; and the content.
fn primitive(vector: [Int; 3]) -> ([Int; 3], Int) {
    let divisor = content(&vector);
    (vector.map(|c| c / &divisor), divisor)
}

/// Twice the polygon's area, along its right-hand normal.
fn area_vector(vertices: &[BigPoint3]) -> [Int; 3] {
    let apex = &vertices[0].coordinates;
    vertices[1..].windows(2).fold([Int::ZERO, Int::ZERO, Int::ZERO], |sum, pair| {
        let part =
            cross(&difference(&pair[0].coordinates, apex), &difference(&pair[1].coordinates, apex));
        std::array::from_fn(|i| &sum[i] + &part[i])
    })
}
