//! The same world with everything that cannot be reached filled in.
//!
//! Of the boundary only what looks into a leaf that is kept still bounds anything; divided by
//! these faces alone the kept part of space falls into fewer and larger cells.

use super::{Child, Options, Subdivision, tree};
use crate::construct::{Polygon, Split};

impl Subdivision {
    /// Divides the box again, with all leaves solid that `kept` does not hold.
    ///
    /// Requires: of two empty leaves with a portal between them, both are kept or neither, as a
    /// flood leaves them.
    ///
    /// # Panics
    /// If `kept` has not one entry a leaf.
    #[must_use]
    pub fn filled(&self, kept: &[bool], options: &Options) -> Subdivision {
        assert_eq!(kept.len(), self.leaves.len(), "one entry a leaf");
        let mut boundary = Vec::new();
        for face in &self.boundary {
            boundary.append(&mut self.looking_into(face, kept));
        }
        let hints = self.hints.clone();
        let solid = boundary.is_empty() && !kept.contains(&true);
        let built =
            tree::build(&self.planes, &self.bounds, boundary.clone(), hints, solid, options);
        Subdivision {
            planes: self.planes.clone(),
            bounds: self.bounds,
            nodes: built.nodes,
            leaves: built.leaves,
            root: built.root,
            flat: self.flat.clone(),
            boundary,
            hints: self.hints.clone(),
        }
    }

    /// What of a face looks into kept leaves; in one piece where that is all of it.
    fn looking_into(&self, face: &Polygon, kept: &[bool]) -> Vec<Polygon> {
        let (mut pieces, mut whole) = (Vec::new(), true);
        let mut stack = vec![(self.root, face.clone())];
        while let Some((child, polygon)) = stack.pop() {
            let node = match child {
                Child::Leaf(leaf) if kept[leaf.0 as usize] && !self.leaf(leaf).solid => {
                    pieces.push(polygon);
                    continue;
                }
                Child::Leaf(_) => {
                    whole = false;
                    continue;
                }
                Child::Node(node) => &self.nodes[node as usize],
            };
            match polygon.split(&self.planes, node.section.support()) {
                Split::Front => stack.push((node.front, polygon)),
                Split::Back => stack.push((node.back, polygon)),
                // The leaf that it looks into is on the side that its normal points to.
                Split::On if polygon.support() == node.section.support() => {
                    stack.push((node.front, polygon));
                }
                Split::On => stack.push((node.back, polygon)),
                Split::Both(front, back) => {
                    stack.push((node.back, back));
                    stack.push((node.front, front));
                }
            }
        }
        if whole { vec![face.clone()] } else { pieces }
    }
}
