//! Convex bodies as a moving point or box meets them.
//!
//! A box with corners -h, h (as seen from the point that carries it) meets a convex body K with
//! its inside iff the point is inside the Minkowski sum of K and the box mirrored in the point.
//! A facet of such a sum is a facet of K, or a facet of the box, or is spanned by an edge of K
//! and an edge of the box: its normal is a face's, or along an axis, or the cross product of an
//! edge and an axis (Gottschalk, Lin and Manocha, OBBTree, 1996, derive the same list as possible
//! separating axes). So the half-spaces that support K in these directions, each moved outwards by
//! the box's extent in its direction, bound the sum; they do not depend on the box.
//!
//! A polygon is a body without volume: both directions of its plane are faces, and the rest is
//! the same. Cost for v vertices and e edges: O(e·v).

use super::{Obstacle, Touch};
use crate::construct::{PlaneId, PlaneSet, Polyhedron};
use crate::geom::vector::{cross, difference, dot};
use crate::geom::{AxialBox, BigPlane, RationalPoint3};
use crate::num::{Int, Rational};
use num_integer::Integer;
use num_traits::Zero;
use rustc_hash::FxHashSet;

/// Something that blocks.
#[derive(Clone, Debug)]
pub(super) struct Body {
    pub(super) obstacle: Obstacle,
    /// The planes of its faces, outward.
    pub(super) faces: Vec<PlaneId>,
    /// Supporting half-spaces in all directions in which its sum with an axial box has facets.
    pub(super) sides: Vec<Side>,
}

/// A half-space that contains a body and touches it.
#[derive(Clone, Debug)]
pub(super) struct Side {
    pub(super) plane: BigPlane,
    /// What of a box touches what of the body there.
    pub(super) touch: Touch,
}

impl Body {
    /// A solid.
    pub(super) fn of_solid(planes: &PlaneSet, index: usize, solid: &Polyhedron) -> Body {
        let faces: Vec<PlaneId> = solid.faces().iter().map(|face| face.support()).collect();
        let loops: Vec<Vec<RationalPoint3>> = solid.faces().iter().map(|f| f.points()).collect();
        let sides = sides(faces.iter().map(|&face| planes.plane(face)), &loops);
        Body { obstacle: Obstacle::Solid(index), faces, sides }
    }

    /// A polygon.
    pub(super) fn of_polygon(
        planes: &mut PlaneSet,
        index: usize,
        vertices: &[RationalPoint3],
    ) -> Body {
        let plane = plane_through(vertices);
        let front = planes.intern(&plane).expect("three vertices of a polygon span a plane");
        let faces = vec![front, front.flipped()];
        let sides = sides(faces.iter().map(|&face| planes.plane(face)), &[vertices.to_vec()]);
        Body { obstacle: Obstacle::Polygon(index), faces, sides }
    }

    /// What is beyond a plane that bounds the world, outward.
    pub(super) fn beyond(planes: &PlaneSet, plane: PlaneId) -> Body {
        let face = plane.flipped();
        let sides = vec![Side { plane: planes.plane(face).clone(), touch: Touch::Face }];
        Body { obstacle: Obstacle::Bounds, faces: vec![face], sides }
    }

    /// The half-spaces whose intersection it is, and more that contain it.
    pub(super) fn half_spaces(&self) -> impl Iterator<Item = &BigPlane> {
        self.sides.iter().map(|side| &side.plane)
    }
}

/// The plane of a strictly convex polygon, positive where its vertices run counter-clockwise as
/// seen from.
pub(super) fn plane_through(vertices: &[RationalPoint3]) -> BigPlane {
    let grid = RationalPoint3::common_denominator(&vertices[..3]);
    let [a, b, c] = [0, 1, 2].map(|i: usize| vertices[i].on_grid(&grid));
    let BigPlane { normal, offset } = BigPlane::through(&a, &b, &c);
    BigPlane { normal: normal.map(|n| n * &grid), offset }
}

/// The half-spaces of a box, those of low coordinates first.
pub(super) fn planes_of_box(around: &AxialBox) -> Vec<BigPlane> {
    let low = (0..3).map(|i| axial(i, -1, &-&around.low[i]));
    low.chain((0..3).map(|i| axial(i, 1, &around.high[i]))).collect()
}

/// sign · x <= offset, for the coordinate x of an axis.
fn axial(axis: usize, sign: i32, offset: &Rational) -> BigPlane {
    let mut normal = [Int::ZERO, Int::ZERO, Int::ZERO];
    normal[axis] = sign * offset.denom();
    BigPlane { normal, offset: offset.numer().clone() }
}

/// The half-spaces of a body with these faces, whose edges are those of the loops. The axial ones
/// come first: they tell most bodies apart from a move.
fn sides<'a>(
    faces: impl Iterator<Item = &'a BigPlane>,
    loops: &[Vec<RationalPoint3>],
) -> Vec<Side> {
    let mut known: FxHashSet<[Int; 3]> = FxHashSet::default();
    let mut sides = Vec::new();
    let mut add = |plane: BigPlane, touch: Touch| {
        if known.insert(direction(&plane.normal)) {
            sides.push(Side { plane, touch });
        }
    };
    faces.for_each(|plane| add(plane.clone(), Touch::Face));
    let around = AxialBox::around(loops.iter().flatten()).expect("a body has vertices");
    planes_of_box(&around).into_iter().for_each(|plane| add(plane, Touch::BoxFace));
    let mut vertices: Vec<&RationalPoint3> = loops.iter().flatten().collect();
    vertices.sort_unstable();
    vertices.dedup();
    // Over one denominator, so that integers tell which vertices are extreme.
    let grid = RationalPoint3::common_denominator(vertices.iter().copied());
    let on_grid = |point: &RationalPoint3| point.on_grid(&grid).coordinates;
    let vertices: Vec<[Int; 3]> = vertices.into_iter().map(on_grid).collect();
    for corners in loops {
        for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let (a, b) = (on_grid(a), on_grid(b));
            let edge = direction(&difference(&b, &a));
            for axis in 0..3 {
                let along = std::array::from_fn(|i| Int::from(u8::from(i == axis)));
                let normal = cross(&edge, &along);
                for normal in [normal.each_ref().map(|c| -c), normal] {
                    let height = dot(&normal, &a);
                    let extreme = vertices.iter().all(|vertex| dot(&normal, vertex) <= height);
                    if extreme && normal.iter().any(|c| !c.is_zero()) {
                        let normal = normal.map(|c| c * &grid);
                        add(BigPlane { normal, offset: height }, Touch::Edges);
                    }
                }
            }
        }
    }
    let axial = |side: &Side| side.plane.normal.iter().filter(|c| c.is_zero()).count() == 2;
    sides.sort_by_key(|side| !axial(side));
    sides
}

/// The vector without common divisor in the same direction; of zero, zero.
pub(super) fn direction(vector: &[Int; 3]) -> [Int; 3] {
    let divisor = vector.iter().fold(Int::ZERO, |divisor, c| divisor.gcd(c));
    if divisor.is_zero() {
        return vector.clone();
    }
    vector.each_ref().map(|c| c / &divisor)
}
