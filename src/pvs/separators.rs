//! The planes that separate two portals of a sequence.
//!
//! A plane through an edge of one portal and a vertex of another that has the first portal in its
//! closed back and the second in its closed front cannot be crossed back by a line that has
//! crossed both: whatever the line meets after the second portal has a part strictly in front
//! (Teller 1992, §8.3.5). No derived point is needed, so each test is one exact sign of degree 3.

use super::arena::{Arena, Directed, PairTable, Plane, PlaneKey};
use super::propose::supporting_vertex;
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
    let ends = [arena.point(u), arena.point(v)];
    let touched =
        polygon[supporting_vertex(ends, arena.points(polygon), arena.points(own), outside)?];
    let plane = arena.plane([u, v, touched]);
    let mut apart = false;
    let mut holds = |w: u32, side: Sign| {
        w == u
            || w == v
            || w == touched
            || match arena.side(&plane, w) {
                // On the plane counts for either side: a touching polygon is still separated.
                Sign::Zero => true,
                Sign::Positive => {
                    apart = true;
                    side == Sign::Positive
                }
                Sign::Negative => {
                    apart = true;
                    side == Sign::Negative
                }
            }
    };
    let separates =
        own.iter().all(|&w| holds(w, outside)) && polygon.iter().all(|&w| holds(w, -outside));
    // A plane with all of both polygons in it proves nothing.
    (separates && apart).then_some(plane)
}

/// Separating planes of pairs already met: the portals of a path meet the same portals again and
/// again as the search backtracks, and the same few planes separate most of them.
#[derive(Default)]
pub(crate) struct SeparatorCache {
    spans: PairTable<(u32, u32)>,
    /// The planes of each span, as indices of `planes`.
    members: Vec<u32>,
    planes: Vec<Plane>,
    ids: FxHashMap<PlaneKey, u32>,
    found: Vec<Plane>,
}

/// About 10 MiB a thread: a larger one is slower to look up than to make anew.
const LARGEST_CACHE: usize = 1 << 16;

impl SeparatorCache {
    /// The separating planes of the pair, by their ids.
    pub fn get(&mut self, arena: &Arena, first: Directed, second: Directed) -> &[u32] {
        let (start, end) = match self.spans.get(&(first, second)) {
            Some(&span) => span,
            None => self.add(arena, first, second),
        };
        &self.members[start as usize..end as usize]
    }

    fn add(&mut self, arena: &Arena, first: Directed, second: Directed) -> (u32, u32) {
        let start = self.members.len() as u32;
        self.found.clear();
        separators(arena, first, second, &mut self.found);
        for plane in &self.found {
            let id = *self.ids.entry(plane.key()).or_insert_with(|| {
                self.planes.push(*plane);
                self.planes.len() as u32 - 1
            });
            self.members.push(id);
        }
        let span = (start, self.members.len() as u32);
        self.spans.insert((first, second), span);
        span
    }

    /// The plane of an id.
    pub fn plane(&self, id: u32) -> &Plane {
        &self.planes[id as usize]
    }

    /// Forgets everything, if it has grown large; ids given before are void then.
    pub fn trim(&mut self) {
        if self.planes.len() > LARGEST_CACHE || self.members.len() > 8 * LARGEST_CACHE {
            *self = SeparatorCache::default();
        }
    }
}
