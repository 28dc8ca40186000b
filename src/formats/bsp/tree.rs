//! The tree that divides a level's world, which tells the leaf of a point.
//!
//! ```text
//! lump 1   planes   normal (3 floats), distance (float), type: 20 bytes
//! lump 5   nodes    plane, front and back child, box, faces: 24 bytes in Quake and GoldSrc,
//!                   44 in BSP2, 32 in 2PSB
//! lump 10  leafs    contents in the first 4 bytes
//! lump 14  models   the world's first node at byte 36 of the first record
//! ```
//!
//! A child of -1 - i is leaf i. Floats of 32 bits are binary fractions and are kept exactly.

use super::layout::{Level, Lump, QUAKE_MODELS};
use super::{BspError, BspErrorKind, BspFormat};
use crate::geom::BigPlane;
use crate::num::Int;
use num_integer::Integer;
use num_traits::One;

const PLANES: Lump = Lump(1, "planes");
const NODES: Lump = Lump(5, "nodes");
const PLANE: usize = 20;
/// Where a model's record has its first node.
const MODEL_NODE: usize = 36;

/// The tree of a level's world.
///
/// Invariant: a node's children come after it, so every way down ends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LevelTree {
    /// Where every way down begins.
    pub root: LevelChild,
    /// The inner nodes.
    pub nodes: Vec<LevelNode>,
    /// What each leaf is filled with; -1 is nothing, -2 rock.
    pub contents: Vec<i32>,
}

/// A part of space that is cut in two.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LevelNode {
    /// The plane, its coefficients without a common factor.
    pub plane: BigPlane,
    /// The part on the plane's positive side.
    pub front: LevelChild,
    /// The part on its negative side.
    pub back: LevelChild,
}

/// A node or a leaf, by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LevelChild {
    /// An index into [`LevelTree::nodes`].
    Node(u32),
    /// A leaf; its row of visibility, if it has one, is the one before its number.
    Leaf(u32),
}

/// How a format keeps its nodes.
struct Layout {
    record: usize,
    /// Whether children have 4 bytes, else 2.
    is_wide: bool,
}

impl LevelTree {
    /// Reads the tree of a level of Quake, in any of its formats, or GoldSrc. Linear in the file.
    ///
    /// # Errors
    /// [`BspError`] names the byte and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<LevelTree, BspError> {
        let level = Level::new(bytes)?;
        let layout = match level.format {
            BspFormat::Quake29 | BspFormat::GoldSrc30 => Layout { record: 24, is_wide: false },
            BspFormat::Bsp2 => Layout { record: 44, is_wide: true },
            BspFormat::Psb2 => Layout { record: 32, is_wide: true },
            BspFormat::Quake2 | BspFormat::Quake3 => {
                return Err(BspError { offset: 0, kind: BspErrorKind::NoTree(level.format) });
            }
        };
        let (_, leafs) = level.quake_leafs()?;
        let contents: Vec<i32> =
            leafs.step_by(level.leaf_record()).map(|at| level.int(at)).collect();
        let planes = planes(level)?;
        let place = level.lump(NODES)?;
        let count = whole(&place, NODES.1, layout.record)?;
        let sizes = Sizes { nodes: count, leafs: contents.len() };
        let mut nodes = Vec::with_capacity(count);
        for (node, at) in place.step_by(layout.record).enumerate() {
            let wrong = |offset| move |kind| BspError { offset, kind };
            let number = level.int(at);
            let plane = usize::try_from(number).ok().and_then(|plane| planes.get(plane));
            let plane = plane.cloned().ok_or(BspErrorKind::NodePlane { node, plane: number });
            let child = |at: usize| {
                let child = if layout.is_wide { level.int(at) } else { short(bytes, at) };
                sizes.child(child, Some(node)).map_err(wrong(at))
            };
            nodes.push(LevelNode {
                plane: plane.map_err(wrong(at))?,
                front: child(at + 4)?,
                back: child(at + if layout.is_wide { 8 } else { 6 })?,
            });
        }
        let root = level.lump(QUAKE_MODELS)?.start + MODEL_NODE;
        let wrong = |kind| BspError { offset: root, kind };
        let root = sizes.child(level.int(root), None).map_err(wrong)?;
        Ok(LevelTree { root, nodes, contents })
    }
}

/// What children may be.
struct Sizes {
    nodes: usize,
    leafs: usize,
}

impl Sizes {
    fn child(&self, child: i32, parent: Option<usize>) -> Result<LevelChild, BspErrorKind> {
        let first = parent.map_or(0, |parent| parent + 1);
        // -1 - i is the complement of i.
        let (number, range) = match child < 0 {
            true => (!child as u32, 0..self.leafs),
            false => (child as u32, first..self.nodes),
        };
        match (range.contains(&(number as usize)), child < 0) {
            (true, true) => Ok(LevelChild::Leaf(number)),
            (true, false) => Ok(LevelChild::Node(number)),
            (false, _) => Err(BspErrorKind::NodeChild { child, first, nodes: self.nodes }),
        }
    }
}

/// The planes that a node may use; one that is no plane spoils nothing unless it is used.
fn planes(level: Level<'_>) -> Result<Vec<BigPlane>, BspError> {
    let place = level.lump(PLANES)?;
    whole(&place, PLANES.1, PLANE)?;
    place
        .step_by(PLANE)
        .map(|at| {
            let numbers = [0, 4, 8, 12].map(|field| exact(level.int(at + field).cast_unsigned()));
            let [Some(x), Some(y), Some(z), Some(offset)] = numbers else {
                return Err(BspError { offset: at, kind: BspErrorKind::NotFinite });
            };
            let divisor = [&x, &y, &z].into_iter().fold(offset.clone(), |g, c| g.gcd(c));
            let divisor = divisor.max(Int::one());
            let normal = [x, y, z].map(|c| c / &divisor);
            Ok(BigPlane { normal, offset: offset / divisor })
        })
        .collect()
}

/// The number of records in a lump.
fn whole(
    place: &std::ops::Range<usize>,
    what: &'static str,
    record: usize,
) -> Result<usize, BspError> {
    if !place.len().is_multiple_of(record) {
        let expected = format!("{record} a record");
        let kind = BspErrorKind::LumpLength { what, got: place.len(), expected };
        return Err(BspError { offset: place.start, kind });
    }
    Ok(place.len() / record)
}

/// The value of a float of 32 bits in units of 2^-149, the least of them; `None` for what is no
/// number.
fn exact(bits: u32) -> Option<Int> {
    let (exponent, fraction) = (bits >> 23 & 0xff, bits & 0x7f_ffff);
    let size = match exponent {
        0xff => return None,
        0 => Int::from(fraction),
        _ => Int::from(fraction | 0x80_0000) << (exponent - 1),
    };
    Some(if bits >> 31 == 1 { -size } else { size })
}

fn short(bytes: &[u8], at: usize) -> i32 {
    i16::from_le_bytes([bytes[at], bytes[at + 1]]).into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_are_exact() {
        let unit = Int::one() << 149u32;
        for (float, number, denominator) in [(1.0f32, 1, 1), (-0.375, -3, 8), (4096.5, 8193, 2)] {
            let expected = Int::from(number) * &unit / Int::from(denominator);
            assert_eq!(exact(float.to_bits()), Some(expected));
        }
        assert_eq!(exact(1), Some(Int::one()));
        assert_eq!(exact(0x80_0000), Some(Int::one() << 23u32), "the least that is normal");
        assert_eq!(exact((-0.0f32).to_bits()), Some(Int::ZERO));
        for none in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
            assert_eq!(exact(none.to_bits()), None);
        }
    }
}
