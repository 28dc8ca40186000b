//! Extremal stabbing lines: the lines of the closed portals that touch four edges or more.
//!
//! They are where the Klein quadric meets the rays and the edges of the sequence's cone (Teller
//! 1992, sections 6.4 and 7.1: crossings of the arrangement's edges with the quadric). Where the
//! cone has a lineality line l (all portals' planes share a line), each extreme ray r modulo l
//! stands for a half plane of vectors and takes the part of an edge: it holds one line, r + t l,
//! if side(r, l) ≠ 0. A cone with more lineality (all portals in one plane) has no extremal lines;
//! nor is a whole edge on the quadric listed beyond its ends. Lines at infinity, and lines in a
//! portal's plane that miss the portal, are not stabbing lines and are left out.
//!
//! The touched edges of a line are all whose supporting lines it meets. No line is listed twice:
//! the interiors of the cone's edges do not meet each other or the rays.

use super::closed::ClosedPortal;
use super::grazing::ClosedCone;
use super::line::{ExactLine, StabLine};
use super::quadric::{Vector, quadric, side};
use super::sequence::Portal3;
use crate::num::{Int, Sign};

/// An edge of a sequence: it runs from vertex `edge` of the portal to the next.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct EdgeName {
    /// The portal's place in the sequence, from 0.
    pub portal: usize,
    /// The edge's place in the portal, from 0.
    pub edge: usize,
}

/// An extremal stabbing line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ExtremalLine {
    /// The line.
    pub line: StabLine,
    /// The edges whose supporting lines it meets, in ascending order: four or more.
    pub edges: Vec<EdgeName>,
}

/// The extremal stabbing lines of the closed portals, by touched edges in ascending order.
pub(super) fn lines(portals: &[&Portal3]) -> Vec<ExtremalLine> {
    if portals.is_empty() {
        return Vec::new();
    }
    let cone = ClosedCone::new(portals);
    let candidates = match cone.lineality.as_slice() {
        [] => pointed(&cone),
        [line] => cone.rays.iter().filter_map(|ray| linear(ray, line)).collect(),
        _ => Vec::new(),
    };
    let closed: Vec<ClosedPortal> =
        portals.iter().map(|portal| ClosedPortal::new(portal)).collect();
    let closed: Vec<&ClosedPortal> = closed.iter().collect();
    let names = |(portal, p): (usize, &&Portal3)| {
        (0..p.vertices().len()).map(move |edge| EdgeName { portal, edge })
    };
    let mut found: Vec<ExtremalLine> = candidates
        .into_iter()
        .map(|line| line.moved(&cone.origin))
        .filter(|line| line.touches_all(&closed))
        .map(|line| ExtremalLine {
            line: line.points(&closed),
            edges: (portals.iter().enumerate().flat_map(names))
                .filter(|name| line.sign(&closed[name.portal].edges[name.edge]) == Sign::Zero)
                .collect(),
        })
        .collect();
    found.sort_by(|a, b| a.edges.cmp(&b.edges).then_with(|| a.line.points.cmp(&b.line.points)));
    found
}

fn pointed(cone: &ClosedCone) -> Vec<ExactLine> {
    let isotropic = cone.rays.iter().filter(|ray| quadric(ray) == Int::ZERO);
    let on_rays = isotropic.cloned().map(ExactLine::rational);
    let on_edges =
        cone.faces.iter().flat_map(|&[i, j]| ExactLine::between(&cone.rays[i], &cone.rays[j]));
    on_rays.chain(on_edges).collect()
}

/// The line r + t l, if there is exactly one.
fn linear(ray: &Vector, line: &Vector) -> Option<ExactLine> {
    let slope = side(ray, line);
    let (scale, step) = match Sign::of(&slope) {
        Sign::Positive => (slope, -quadric(ray)),
        Sign::Negative => (-slope, quadric(ray)),
        // The quadric is constant along l: no line, or a whole pencil.
        Sign::Zero => return None,
    };
    debug_assert!(scale > Int::ZERO);
    Some(ExactLine::rational(std::array::from_fn(|i| &scale * &ray[i] + &step * &line[i])))
}
