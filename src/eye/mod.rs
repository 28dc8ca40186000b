//! What one point, the eye, sees of a portal graph or of a world, exactly.
//!
//! - *Eye-to-cell*: the cells into which some direction from the eye leads through the portals of a
//!   sequence, strictly inside each of them and strictly inside the frustum, if there is one.
//! - *Eye-to-region*: the part of each such sequence's last portal that is seen, as a convex
//!   polygon with rational vertices. A portal graph does not say where else a cell ends, so that
//!   part is all that can be said of the region behind. Of a world's cells, the seen part itself
//!   is given, as a convex polyhedron ([`SeenSpace`]).
//! - *Eye-to-object*: the detail objects of a world whose boxes have inner points in a region.
//!
//! The method is Teller's (Visibility computations in densely occluded polyhedral environments,
//! 1992, section 8.4): a depth-first search over portal sequences, each portal's edges spanning
//! planes with the eye. Where he asks a linear program whether the half-spaces of all planes have
//! a direction in common, the cone of these directions is kept here and clipped ([`Cone`]), so that
//! the region comes with it. In convex cells the cones of two sequences, neither of which begins
//! the other, are disjoint: the search does no more than it reports.
//!
//! **Degenerate eyes** (section 8.4.2, without its tolerance). An eye in a portal's plane sees
//! nothing through that portal. If it is in the closed portal, it belongs to both cells, and the
//! search starts from both; from each, the eye looks only to that cell's side of the portal's
//! plane. An edge, a vertex or a wall are no special case. In a world the closed polyhedra say
//! which cells an eye belongs to ([`EyeWorld`]).
//!
//! **Order.** Where cells are not exactly convex, crossing two consecutive portals in their order
//! is one more linear condition on the direction (semantics, fact 4), and clips the cone.
//!
//! Of a floorplan [`plan`] answers the same questions in the plane, with areas.
//!
//! Complexity: for s sequences visited, of k portals and n edges on average, O(s·n·k) signs.

mod cone;
mod describe;
mod frustum;
mod locate;
pub mod plan;
pub mod propose;
mod region;
mod search;
mod space;
mod view;
mod world;

pub use cone::{Cone, primitive};
pub use describe::Lens;
pub use frustum::{Frustum, FrustumError, half_tangent};
pub use locate::LocateError;
pub use region::Region;
pub use search::{Answer, Cull, Query, Reached};
pub use space::{SeenObject, SeenRegion, SeenSpace};
pub use view::EyeGraph;
pub use world::{EyeWorld, PlaceError, WorldAnswer};
