//! One polygon of a file: is it planar, is it convex, and if not, which triangles replace it.
//!
//! A polygon is judged as it looks along the axis in which its vector area (half the sum of the
//! cross products of a fan) is largest, turned so that it runs counter-clockwise there. A planar
//! polygon is convex iff that view of it is: every turn to the left, and once around in all.
//! Other polygons are cut into a fan of triangles from the first vertex whose fan tiles that
//! view, and where none does (a zigzag of rounding) by cutting off ears (Meisters 1975). Only a
//! view that crosses or touches itself is refused. All tests are exact; linear in the number of
//! vertices for each apex tried, cubic for ears.

use super::{Repairs, SceneErrorKind};
use num_traits::Signed;

/// What a polygon of the file becomes.
pub(super) enum Pieces {
    /// Planar and convex, repeated and collinear vertices dropped.
    Convex(Vec<u32>),
    /// Not planar: triangles.
    Skew(Vec<[u32; 3]>),
    /// Planar but not convex: triangles.
    Dented(Vec<[u32; 3]>),
}

/// Shapes the polygon whose vertices are `corners`, indices into `vertices`.
pub(super) fn shape<T: Signed + Clone + PartialOrd>(
    vertices: &[[T; 3]],
    mut corners: Vec<u32>,
    repairs: &mut Repairs,
) -> Result<Pieces, SceneErrorKind> {
    let stated = corners.len();
    corners.dedup();
    while corners.len() > 1 && corners.first() == corners.last() {
        corners.pop();
    }
    if corners.len() < 3 {
        return Err(SceneErrorKind::TooFewVertices(corners.len()));
    }
    repairs.repeated_vertices += (stated - corners.len()) as u32;
    let polygon: Vec<&[T; 3]> = corners.iter().map(|&corner| &vertices[corner as usize]).collect();
    let view = view(&polygon).ok_or(SceneErrorKind::ZeroArea)?;
    let planar = is_planar(&polygon);
    if planar && let Some(kept) = convex_corners(&view) {
        repairs.collinear_vertices += (corners.len() - kept.len()) as u32;
        return Ok(Pieces::Convex(kept.into_iter().map(|i| corners[i]).collect()));
    }
    for apex in 0..corners.len() {
        let Some(fan) = fan(&polygon, &view, apex) else { continue };
        repairs.moved_fans += u32::from(apex > 0);
        repairs.vanished_triangles += (corners.len() - 2 - fan.len()) as u32;
        let triangles = fan.into_iter().map(|triangle| triangle.map(|i| corners[i])).collect();
        return Ok(if planar { Pieces::Dented(triangles) } else { Pieces::Skew(triangles) });
    }
    let ears = ears(&view).ok_or(SceneErrorKind::NotSimple)?;
    repairs.clipped_portals += 1;
    let triangles = ears.into_iter().map(|triangle| triangle.map(|i| corners[i])).collect();
    Ok(if planar { Pieces::Dented(triangles) } else { Pieces::Skew(triangles) })
}

pub(super) fn difference<T: Signed + Clone>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [0, 1, 2].map(|i| a[i].clone() - b[i].clone())
}

pub(super) fn cross<T: Signed + Clone>(a: &[T; 3], b: &[T; 3]) -> [T; 3] {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone())
}

pub(super) fn dot<T: Signed + Clone>(a: &[T; 3], b: &[T; 3]) -> T {
    a[0].clone() * b[0].clone() + a[1].clone() * b[1].clone() + a[2].clone() * b[2].clone()
}

/// The cross products of the fan from vertex 0.
fn fan_normals<T: Signed + Clone>(polygon: &[&[T; 3]]) -> impl Iterator<Item = [T; 3]> {
    let apex = polygon[0];
    polygon[1..]
        .windows(2)
        .map(move |pair| cross(&difference(pair[0], apex), &difference(pair[1], apex)))
}

/// The polygon along the axis of its largest vector area, counter-clockwise; `None` for zero.
fn view<T: Signed + Clone + PartialOrd>(polygon: &[&[T; 3]]) -> Option<Vec<[T; 2]>> {
    let mut area = [T::zero(), T::zero(), T::zero()];
    for normal in fan_normals(polygon) {
        for (sum, component) in area.iter_mut().zip(normal) {
            *sum = sum.clone() + component;
        }
    }
    let mut axis = 0;
    for candidate in [1, 2] {
        if area[candidate].abs() > area[axis].abs() {
            axis = candidate;
        }
    }
    let (right, up) = ((axis + 1) % 3, (axis + 2) % 3);
    if area[axis].is_positive() {
        Some(polygon.iter().map(|v| [v[right].clone(), v[up].clone()]).collect())
    } else if area[axis].is_negative() {
        Some(polygon.iter().map(|v| [v[up].clone(), v[right].clone()]).collect())
    } else {
        None
    }
}

/// Whether all vertices lie in one plane, exactly.
fn is_planar<T: Signed + Clone>(polygon: &[&[T; 3]]) -> bool {
    let Some(normal) = fan_normals(polygon).find(|n| n.iter().any(|c| !c.is_zero())) else {
        return true;
    };
    polygon[1..].iter().all(|v| dot(&normal, &difference(v, polygon[0])).is_zero())
}

fn difference2<T: Signed + Clone>(a: &[T; 2], b: &[T; 2]) -> [T; 2] {
    [a[0].clone() - b[0].clone(), a[1].clone() - b[1].clone()]
}

fn cross2<T: Signed + Clone>(a: &[T; 2], b: &[T; 2]) -> T {
    a[0].clone() * b[1].clone() - a[1].clone() * b[0].clone()
}

fn dot2<T: Signed + Clone>(a: &[T; 2], b: &[T; 2]) -> T {
    a[0].clone() * b[0].clone() + a[1].clone() * b[1].clone()
}

/// Whether a direction points into the upper half-plane, the positive x axis included.
fn is_upward<T: Signed + Clone>(direction: &[T; 2]) -> bool {
    direction[1].is_positive() || (direction[1].is_zero() && direction[0].is_positive())
}

/// The corners of a convex polygon, those between their neighbours on one line left out; `None`
/// where it is not convex. No two neighbours are equal.
fn convex_corners<T: Signed + Clone>(view: &[[T; 2]]) -> Option<Vec<usize>> {
    let n = view.len();
    let edge = |i: usize| difference2(&view[(i + 1) % n], &view[i % n]);
    let mut kept = Vec::with_capacity(n);
    let mut half_turns = 0;
    let mut before = edge(n - 1);
    for corner in 0..n {
        let after = edge(corner);
        let turn = cross2(&before, &after);
        if turn.is_positive() {
            kept.push(corner);
        } else if turn.is_negative() || dot2(&before, &after).is_negative() {
            return None;
        }
        half_turns += u32::from(is_upward(&before) != is_upward(&after));
        before = after;
    }
    // Left turns alone also describe polygons that run around twice; a convex one has each
    // direction once, so it enters the upper half-plane and leaves it once.
    (half_turns == 2).then_some(kept)
}

/// The triangles of the fan from corner `apex`, those of zero area left out; `None` where they do
/// not tile the polygon.
fn fan<T: Signed + Clone>(
    polygon: &[&[T; 3]],
    view: &[[T; 2]],
    apex: usize,
) -> Option<Vec<[usize; 3]>> {
    let n = view.len();
    let corner = |i: usize| (apex + i) % n;
    let spoke = |i: usize| difference2(&view[corner(i)], &view[apex]);
    let first = spoke(1);
    let mut triangles = Vec::with_capacity(n - 2);
    let mut half_turns = 0;
    let mut before = first.clone();
    for i in 2..n {
        let after = spoke(i);
        let turn = cross2(&before, &after);
        let [a, b, c] = [apex, corner(i - 1), corner(i)];
        if turn.is_positive() {
            triangles.push([a, b, c]);
        } else {
            let area =
                cross(&difference(polygon[b], polygon[a]), &difference(polygon[c], polygon[a]));
            let vanishes = area.iter().all(T::is_zero) && dot2(&before, &after).is_positive();
            if !vanishes {
                return None;
            }
        }
        half_turns += u32::from(is_upward(&before) != is_upward(&after));
        before = after;
    }
    // The spokes turn left throughout; together they must stay below a full turn.
    let below_full_turn =
        half_turns <= 1 || (half_turns == 2 && cross2(&first, &before).is_negative());
    below_full_turn.then_some(triangles)
}

/// The triangles that are left when ears are cut off one after another, all of positive area and
/// together using every corner; `None` for an outline that crosses or touches itself.
///
/// An ear is a corner that turns left, with no other corner in its closed triangle. What is left
/// without it is a simple polygon again, not all of it on one line, so it has an ear in turn.
fn ears<T: Signed + Clone>(view: &[[T; 2]]) -> Option<Vec<[usize; 3]>> {
    if !is_simple(view) {
        return None;
    }
    let mut rest: Vec<usize> = (0..view.len()).collect();
    let mut triangles = Vec::with_capacity(view.len() - 2);
    while rest.len() >= 3 {
        let n = rest.len();
        let around = |i: usize| [rest[(i + n - 1) % n], rest[i], rest[(i + 1) % n]];
        let is_ear = |&i: &usize| {
            let triangle = around(i);
            let corners = triangle.map(|corner| &view[corner]);
            turn(corners).is_positive()
                && !rest.iter().any(|other| {
                    !triangle.contains(other) && is_in_triangle(&view[*other], corners)
                })
        };
        let ear = (0..n).find(is_ear)?;
        triangles.push(around(ear));
        rest.remove(ear);
    }
    // Cutting the last triangle leaves two corners.
    Some(triangles)
}

/// Positive where the way from a over b to c turns left.
fn turn<T: Signed + Clone>([a, b, c]: [&[T; 2]; 3]) -> T {
    cross2(&difference2(b, a), &difference2(c, a))
}

/// Whether a point is in a triangle that turns left, or on its boundary.
fn is_in_triangle<T: Signed + Clone>(point: &[T; 2], [a, b, c]: [&[T; 2]; 3]) -> bool {
    [[a, b], [b, c], [c, a]].into_iter().all(|[u, v]| !turn([u, v, point]).is_negative())
}

/// Whether no two edges meet but neighbours in the corner between them. No two neighbouring
/// corners are equal.
fn is_simple<T: Signed + Clone>(view: &[[T; 2]]) -> bool {
    let n = view.len();
    let edge = |i: usize| [&view[i], &view[(i + 1) % n]];
    (0..n).all(|i| {
        let [a, b] = edge(i);
        let folds_back = {
            let next = &view[(i + 2) % n];
            turn([a, b, next]).is_zero()
                && dot2(&difference2(b, a), &difference2(next, b)).is_negative()
        };
        let apart = |j: usize| (i + 1) % n == j || (j + 1) % n == i || !meet([a, b], edge(j));
        !folds_back && (i + 1..n).all(apart)
    })
}

/// Whether two closed segments have a point in common.
fn meet<T: Signed + Clone>([a, b]: [&[T; 2]; 2], [c, d]: [&[T; 2]; 2]) -> bool {
    let between = |p: &[T; 2], [u, v]: [&[T; 2]; 2]| {
        !dot2(&difference2(u, p), &difference2(v, p)).is_positive()
    };
    let sides = [turn([a, b, c]), turn([a, b, d]), turn([c, d, a]), turn([c, d, b])];
    let [abc, abd, cda, cdb] = sides.each_ref().map(|side| side.signum());
    let crosses = |s: &T, t: &T| (s.clone() * t.clone()).is_negative();
    (crosses(&abc, &abd) && crosses(&cda, &cdb))
        || (abc.is_zero() && between(c, [a, b]))
        || (abd.is_zero() && between(d, [a, b]))
        || (cda.is_zero() && between(a, [c, d]))
        || (cdb.is_zero() && between(b, [c, d]))
}
