//! Cell-to-cell visibility in the plane, exactly, by sweeping lines around vertices.
//!
//! The lines that join two cells form open sets. Move such a line until it no longer joins them:
//! it then passes through a vertex that stops it, the end of something opaque between the two, or a
//! corner of one of them; and the lines beside it, on one side of the vertex, join them still. So
//! every open pair is met by a line through a vertex, moved a little to one side, in some
//! direction between two neighbouring events. `view` finds those directions and the cells along
//! them for one vertex, `sweep` visits all vertices.
//!
//! This takes the place of a search of portal sequences, whose number has no useful bound (Teller
//! and Séquin 1991, §3.4): what is visited here is the views of the vertices, the complexity of the
//! visibility complex's boundary arcs (Pocchiola and Vegter 1996), and each pair is settled whole.
//! The search is there as well, where its trees are asked for (`stab_tree`), and has to agree.
//!
//! Complexity: O(Σ k lg k) for k events in the view of each vertex, and for each event the product
//! of the paths' lengths where they change. Vertices are independent: threads share a table in
//! which the least vertex wins, so the result does not depend on them.

mod around;
mod cover;
mod grazing;
mod groups;
mod line;
mod object;
mod propose;
mod stab_tree;
mod sweep;
#[cfg(test)]
mod tests;
mod view;
mod witness;

pub use cover::Cover;
pub use grazing::{PlanTouch, classify_plan_grazing};
pub use groups::Groups;
pub use object::{PlanObjectSight, PlanObjectSights, plan_object_sights};
pub use stab_tree::{PlanStabTree, PlanTreeSize, plan_stab_trees, plan_tree_sizes};
pub use sweep::{PlanSight, plan_matrix, plan_sights};

/// Portals as they are crossed, one after the other.
type Ways = [crate::scene::plan::Crossing];
