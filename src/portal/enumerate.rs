//! All portals of a subdivision.

use crate::construct::{Polygon, hull, merged, minus};
use crate::subdivision::{LeafId, PortalShape, Subdivision};

/// What two empty leaves have in common, or a part of it.
#[derive(Clone, Debug)]
pub struct Portal {
    /// The leaf on the negative side of the polygon's support.
    pub from: LeafId,
    /// The leaf on its positive side, from which the vertices are seen counter-clockwise.
    pub to: LeafId,
    /// A part of the leaves' common boundary; free of occluders, but for hulls.
    pub polygon: Polygon,
}

/// The portals between all empty leaves, ordered by `from`, then `to`.
///
/// What two leaves share is one polygon in the plane of the one node that separates them; less the
/// thin polygons in that plane it falls into pieces, which become portals as `shape` says. So a
/// pair of leaves may have several portals, all in one plane. With [`PortalShape::Hull`] it has
/// one at most, which may run across occluders; the hulls' planes are added to the subdivision's.
///
/// Cost: the pieces of each section along the tree, times the thin polygons in it.
pub fn enumerate(subdivision: &mut Subdivision, shape: PortalShape) -> Vec<Portal> {
    let mut portals: Vec<Portal> = Vec::new();
    for index in 0..subdivision.nodes.len() {
        for (from, to, shared) in shared_polygons(subdivision, index) {
            let pieces = free_parts(subdivision, index, shared);
            let polygons = match shape {
                PortalShape::Exact => pieces,
                PortalShape::Merged => merged(&subdivision.planes, pieces),
                PortalShape::Hull if pieces.is_empty() => Vec::new(),
                PortalShape::Hull => vec![hull(&mut subdivision.planes, &pieces)],
            };
            portals.extend(polygons.into_iter().map(|polygon| Portal { from, to, polygon }));
        }
    }
    // Portals of one pair stay in the order in which they were cut.
    portals.sort_by_key(|portal| (portal.from, portal.to));
    portals
}

/// What of a node's section two empty leaves share, for all pairs of them: the polygon, its
/// support the node's plane, with the leaf behind it and the leaf in front.
fn shared_polygons(subdivision: &Subdivision, node: usize) -> Vec<(LeafId, LeafId, Polygon)> {
    let node = &subdivision.nodes[node];
    let empty = |leaf: &LeafId| !subdivision.leaf(*leaf).solid;
    let mut shared = Vec::new();
    let front = subdivision.looking_into(node.front, node.section.clone());
    for (to, polygon) in front.into_iter().filter(|(leaf, _)| empty(leaf)) {
        let back = subdivision.looking_into(node.back, polygon);
        let back = back.into_iter().filter(|(leaf, _)| empty(leaf));
        shared.extend(back.map(|(from, polygon)| (from, to, polygon)));
    }
    shared
}

/// What of a polygon in a node's plane no thin polygon covers.
///
/// Faces of solids in the plane have a solid leaf on one side, so no portal is near them.
fn free_parts(subdivision: &Subdivision, node: usize, polygon: Polygon) -> Vec<Polygon> {
    let thin = subdivision.nodes[node].faces.iter().filter(|face| face.thin);
    thin.fold(vec![polygon], |pieces, face| {
        let cut = |piece| minus(&subdivision.planes, piece, &face.polygon);
        pieces.into_iter().flat_map(cut).collect()
    })
}
