//! The planes that separate two portals of a sequence.
//!
//! A plane through an edge of one portal and a vertex of another that has the first portal in its
//! closed back and the second in its closed front cannot be crossed back by a line that has
//! crossed both: whatever the line meets after the second portal has a part strictly in front
//! (Teller 1992, §8.3.5). No derived point is needed, so each test is one exact sign of degree 3.

use super::arena::{Arena, Directed, Plane};
use crate::num::Sign;
use rustc_hash::FxHashMap;

/// Appends to `planes` those that have `first` behind and `second` in front, at most one for each
/// edge of either.
pub(crate) fn separators(
    arena: &Arena,
    first: Directed,
    second: Directed,
    planes: &mut Vec<Plane>,
) {
    let (a, b) = (arena.vertices(first), arena.vertices(second));
    for i in 0..a.len() {
        let edge = [a[i], a[(i + 1) % a.len()]];
        planes.extend(supporting(arena, edge, b, Sign::Negative, a));
    }
    for i in 0..b.len() {
        let edge = [b[i], b[(i + 1) % b.len()]];
        planes.extend(supporting(arena, edge, a, Sign::Positive, b));
    }
}

/// The plane through `edge` and the vertex of `polygon` that no other vertex of it is beyond, on
/// the side `outside`; kept only if `own`, the edge's polygon, is wholly on that side.
fn supporting(
    arena: &Arena,
    [u, v]: [u32; 2],
    polygon: &[u32],
    outside: Sign,
    own: &[u32],
) -> Option<Plane> {
    let off_edge = |w: &&u32| **w != u && **w != v;
    let mut best: Option<(u32, Plane)> = None;
    for &w in polygon.iter().filter(off_edge) {
        if best.as_ref().is_none_or(|(_, plane)| arena.side(plane, w) == outside) {
            // A vertex on the edge's own line spans no plane with it.
            best = Some((w, arena.plane([u, v, w]))).filter(|(_, plane)| !plane.is_null());
        }
    }
    let (touched, plane) = best?;
    let holds = |w: &u32, side: Sign| match arena.side(&plane, *w) {
        // On the plane counts for either side: a touching polygon is still separated.
        Sign::Zero => true,
        sign => sign == side,
    };
    let separates = polygon.iter().filter(|&&w| w != touched).filter(off_edge).all(|w| holds(w, -outside))
        && own.iter().filter(off_edge).all(|w| holds(w, outside))
        // A plane that contains the other polygon's edge line only, or all of both, proves nothing.
        && own.iter().chain(polygon).any(|&w| arena.side(&plane, w) != Sign::Zero);
    separates.then_some(plane)
}

/// Separating planes of pairs already met: the portals of a path meet the same portals again and
/// again as the search backtracks.
#[derive(Default)]
pub(crate) struct SeparatorCache {
    spans: FxHashMap<(Directed, Directed), (u32, u32)>,
    planes: Vec<Plane>,
}

/// The most planes kept: 32 MiB a thread.
const CACHED_PLANES: usize = 1 << 19;

impl SeparatorCache {
    /// The separating planes of the pair.
    pub fn get(&mut self, arena: &Arena, first: Directed, second: Directed) -> &[Plane] {
        if self.planes.len() > CACHED_PLANES {
            self.spans.clear();
            self.planes.clear();
        }
        let planes = &mut self.planes;
        let &mut (start, end) = self.spans.entry((first, second)).or_insert_with(|| {
            let start = planes.len() as u32;
            separators(arena, first, second, planes);
            (start, planes.len() as u32)
        });
        &self.planes[start as usize..end as usize]
    }
}
