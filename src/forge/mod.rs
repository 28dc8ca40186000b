//! The degeneracy forge: families of hard cases, laws that answers must obey, and a reducer.
//!
//! A [`Family`] makes inputs from a seed, each about one way of being degenerate: a function of the
//! family, its parameters, the seed and the case's number, the same on every machine. [`find`] is
//! our own answer with its evidence held by [`check`], which knows the definitions and nothing of
//! the engine. `docs/forge.md` lists the families with their purposes.
//!
//! No program is run here: that is `cli`'s.

pub mod check;
mod families;
mod input;
mod laws;
mod own;
mod reduce;
mod shapes;
#[cfg(feature = "oracle")]
pub mod twin;

pub use families::{FAMILIES, Family, Parameter, Settings, SettingsError, graph_of};
pub use input::{CaseError, Door, Graph, Input, Point, Polygon, Scene};
pub use laws::{LAWS, Law, Relation};
pub use own::{
    Fault, Finding, accepts, classify_grazing, find, occluders_of, portal_graph, pvs_of, raised,
    regions_of, test_of,
};
pub use reduce::{Measure, Trial, measure, reduce};
