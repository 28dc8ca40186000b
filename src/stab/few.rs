//! Whether a few directed edges already let no line through.
//!
//! A portal sequence is not open if some of its edges are not passed by any line; mostly six or
//! seven out of fifty are enough, and a cone of few half-spaces is small.

use super::cone::{Push, dot};
use super::engine::{Engine, Range, in_range};
use super::quadric::{Vector, signs_behind_triples};
use super::ring::Ring;
use super::sequence::{Frame, Portal3};
use super::wedge::Wedge;
use crate::num::{Int, Sign};

/// An edge of a portal: from this vertex to the next.
pub type PortalEdge<'a> = (&'a Portal3, usize);

/// The `x` of R^6 on the positive side of some edges, which may grow in number.
#[derive(Clone, Debug)]
pub struct EdgeCone {
    frame: Frame,
    /// Marked as half-spaces that belong to no polygon: rule 5 looks behind every triple of them.
    rows: Vec<(Vector, bool)>,
    range: Range,
    cone: Engine,
    strict: bool,
}

/// What is known of the lines on the positive side of some edges.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EdgeLines {
    /// There are none, which is proved.
    None,
    /// The cone has these points on both sides of the Klein quadric, so it may have lines.
    Between(Box<[Vector6; 2]>),
    /// The cone has a point and its opposite: nothing is decided.
    Lineality,
}

/// A vector of R^6, scaled at will: direction and moment in [`EdgeCone::frame`].
pub type Vector6 = [Int; 6];

impl EdgeCone {
    /// The whole of R^6; a frame near the edges to come keeps their numbers small.
    pub fn new(frame: Frame) -> EdgeCone {
        EdgeCone {
            frame,
            rows: Vec::new(),
            range: Range::default(),
            cone: Engine::everything(),
            strict: true,
        }
    }

    /// What vectors are measured in.
    pub fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Adds an edge.
    pub fn push(&mut self, (portal, edge): PortalEdge<'_>) {
        let row = portal.edge_row_in(edge, &self.frame);
        self.range = self.range.with(std::iter::once(&row));
        if self.strict {
            self.cone = self.cone.widened_for(self.range);
            self.strict = self.cone.push(&row) == Push::Strict;
        }
        self.rows.push((row, true));
    }

    /// Which lines pass on the positive side of all edges so far.
    pub fn lines(&self) -> EdgeLines {
        if !self.strict {
            return EdgeLines::None;
        }
        if self.cone.has_lineality() {
            return EdgeLines::Lineality;
        }
        let mut signs = self.cone.signs();
        if !signs.found() {
            signs_behind_triples(&mut signs, &self.cone.ray_sides(), &self.rows);
        }
        match (signs.positive, signs.negative) {
            (Some(positive), Some(negative)) => EdgeLines::Between(Box::new([positive, negative])),
            _ => EdgeLines::None,
        }
    }

    /// The extreme rays of the cone, modulo its lineality; their sum is strictly inside.
    pub fn rays(&self) -> Vec<Vector6> {
        self.cone.rays()
    }
}

/// Whether the Klein form is, or its negative, a combination with weights `>= 0` of the pairwise
/// products of the sides of six edges. Then no line is on the positive side of all.
///
/// Let x have the sides t_i = a_i · x with the edges' rows a_i, which shall be independent, and let
/// r_i be the solution of a_i · r_i = 1, a_j · r_i = 0. Then x = Σ t_i r_i and
/// 2 Q(x) = Σ side(r_i, r_j) t_i t_j. Where no two side(r_i, r_j) have opposite signs, Q(x) is not
/// zero for t > 0: not all of them vanish, as the form has full rank.
///
/// The frame, near the edges, keeps their numbers small.
///
/// Exact. The r_i are taken by Cramer's rule, five rows each (`ring` has the ranges).
pub fn six_edges_exclude_lines(edges: [PortalEdge<'_>; 6], frame: &Frame) -> bool {
    let rows = edges.map(|(portal, edge)| portal.edge_row_in(edge, frame));
    let range = Range::default().with(rows.iter());
    in_range!(range, R => sides_agree::<R>(&rows))
}

fn sides_agree<R: Ring>(rows: &[Vector; 6]) -> bool {
    let narrow = |c: &Int| R::narrow(c).expect("the rows are in the range of the arithmetic");
    let rows = rows.each_ref().map(|row| row.each_ref().map(narrow));
    let Some(rays) = dual_basis::<R>(&rows) else { return false };
    let mut seen = [false; 2];
    for (i, (ray, sign)) in rays.iter().enumerate() {
        for (other, other_sign) in &rays[..=i] {
            match R::sign_of(&R::side(ray, other)) * *sign * *other_sign {
                Sign::Positive => seen[0] = true,
                Sign::Negative => seen[1] = true,
                // The two rays meet: their product does not occur in the combination.
                Sign::Zero => {}
            }
        }
        if seen == [true; 2] {
            return false;
        }
    }
    true
}

/// For each row the vector that the other five vanish on, and the sign that the row has on it;
/// `None` if the rows are dependent.
fn dual_basis<R: Ring>(rows: &[[R::Narrow; 6]; 6]) -> Option<Vec<([R; 6], Sign)>> {
    let mut before = Wedge::<R>::empty();
    let mut rays = Vec::with_capacity(6);
    for (i, row) in rows.iter().enumerate() {
        let others = rows[i + 1..].iter().try_fold(before.clone(), |w, row| w.extended(row))?;
        let ray = others.orthogonal();
        let sign = dot(&ray, row).sign();
        if sign == Sign::Zero {
            return None;
        }
        rays.push((ray, sign));
        if i < 5 {
            before = before.extended(row)?;
        }
    }
    Some(rays)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geom::BigPoint3;
    use crate::oracle::Random;

    fn triangle(random: &mut Random, reach: i64) -> Portal3 {
        loop {
            let point = |random: &mut Random| BigPoint3 {
                coordinates: [(); 3].map(|()| Int::from(random.between(-reach, reach))),
            };
            let points = [(); 3].map(|()| point(random));
            if let Ok(portal) = Portal3::new(&points) {
                return portal;
            }
        }
    }

    /// On tiny grids, where edges meet and are parallel, and on large ones: six edges, each in both
    /// directions, excluded by their products have no line in their cone either; and a cone
    /// without lines has none with one edge more.
    #[test]
    fn six_edges_exclude_only_what_their_cone_excludes() {
        let mut random = Random::new(6);
        let mut excluded = 0;
        for reach in [2i64, 3, 1 << 8, 1 << 20, 1 << 40] {
            for _ in 0..60 {
                let portals = [(); 6].map(|()| triangle(&mut random, reach));
                let reversed = portals.each_ref().map(Portal3::reversed);
                for turned in 0u32..64 {
                    // Edge 0 of a triangle is edge 1 of its reverse.
                    let edges = std::array::from_fn(|i| match turned >> i & 1 {
                        0 => (&portals[i], 0),
                        _ => (&reversed[i], 1),
                    });
                    let corner = &portals[0].vertices()[0].coordinates;
                    let excludes = six_edges_exclude_lines(edges, &Frame::about(corner));
                    let coarse = Frame::near(corner, &Int::from(6));
                    assert_eq!(excludes, six_edges_exclude_lines(edges, &coarse), "{edges:?}");
                    if excludes {
                        excluded += 1;
                        let mut cone = EdgeCone::new(coarse);
                        edges.iter().for_each(|&edge| cone.push(edge));
                        assert_eq!(cone.lines(), EdgeLines::None, "{edges:?}");
                        cone.push((&triangle(&mut random, reach), 0));
                        assert_eq!(cone.lines(), EdgeLines::None, "{edges:?}");
                    }
                }
            }
        }
        assert!(excluded > 40, "{excluded} cases say little");
    }
}
