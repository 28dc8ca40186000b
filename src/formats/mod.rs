//! File formats: bytes to plain structs and back.
//!
//! A reader checks what a format says about its own shape (counts, syntax, lengths) and nothing
//! about geometry; `scene` makes validated scenes of what comes out. No reader trusts a count in
//! a header with an allocation.

pub mod blake3;
pub mod bsp;
pub mod csg;
pub mod gltf;
pub mod json;
pub mod lines;
pub mod map;
pub mod mesh;
pub mod npy;
pub mod obj;
pub mod prt;
pub mod sequence;
pub mod wad;
