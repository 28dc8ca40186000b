//! The rounds of volume and aspect: empty leaves that no face enters are split further (Teller
//! 1992, section 5.2.1).
//!
//! A leaf is split along an axis, at a coordinate of a vertex of the occluders that bound it if
//! that gives the least greatest aspect of the parts, else in the middle of its longest extent. A
//! part whose longest extent is no longer than the shortest one of the leaf that it came from is
//! not split for its aspect, so the rounds end.

use super::choose::{aspect, free_cut};
use super::{Child, DivisionError, Leaf, LeafFace, LeafId, Node, Options, Subdivision};
use crate::construct::{Polygon, Polyhedron};
use crate::geom::{AxialBox, RationalPoint3};
use crate::num::Rational;
use crate::report::Progress;
use std::array::from_fn;

/// The node whose child a leaf is, and whether on the positive side; `None` for the root.
type Parent = Option<(usize, bool)>;

impl Subdivision {
    /// Splits the empty leaves that are too large or too long, and numbers the leaves anew in the
    /// tree's order.
    pub(super) fn split_free_cells(
        &mut self,
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<(), DivisionError> {
        if options.largest_volume.is_none() && options.largest_aspect.is_none() {
            return Ok(());
        }
        let whole = self.bounds.polyhedron(&self.planes).volume();
        let largest = options.largest_volume.as_ref().map(|share| share * &whole);
        let faces = self.faces_of_leaves();
        let mut parents = self.parents();
        progress.begin("free cells", faces.len() as u64);
        for (leaf, faces) in faces.iter().enumerate() {
            progress.advance(1);
            if self.leaves[leaf].solid {
                continue;
            }
            let offsets = coordinates(faces);
            let shortest = extents(&around(&self.leaves[leaf].cell)).into_iter().min();
            let mut stack = vec![leaf];
            while let Some(leaf) = stack.pop() {
                if progress.is_interrupted() {
                    return Err(DivisionError::Interrupted);
                }
                let cell = &self.leaves[leaf].cell;
                let around = around(cell);
                let extents = extents(&around);
                let too_large = largest.as_ref().is_some_and(|largest| cell.volume() > *largest);
                let too_long = options.largest_aspect.as_ref().is_some_and(|greatest| {
                    extents.iter().max() > shortest.as_ref() && aspect(&extents) > *greatest
                });
                if too_large || too_long {
                    let (axis, at) = free_cut(&around.low, &around.high, &offsets);
                    let plane = self.planes.axial(axis, &at);
                    let section = self.leaves[leaf].cell.section(&self.planes, &self.bounds, plane);
                    stack.extend([self.leaves.len(), leaf]);
                    self.split_leaf(&mut parents, leaf, section);
                }
            }
        }
        self.renumber_leaves();
        Ok(())
    }

    fn parents(&self) -> Vec<Parent> {
        let mut parents = vec![None; self.leaves.len()];
        for (number, node) in self.nodes.iter().enumerate() {
            for (child, side) in [(node.front, true), (node.back, false)] {
                if let Child::Leaf(leaf) = child {
                    parents[leaf.0 as usize] = Some((number, side));
                }
            }
        }
        parents
    }

    /// A leaf becomes a node: its front part keeps the number, its back part is the last leaf.
    fn split_leaf(&mut self, parents: &mut Vec<Parent>, leaf: usize, section: Polygon) {
        let number = self.nodes.len();
        match parents[leaf] {
            None => self.root = Child::Node(number as u32),
            Some((parent, true)) => self.nodes[parent].front = Child::Node(number as u32),
            Some((parent, false)) => self.nodes[parent].back = Child::Node(number as u32),
        }
        parents[leaf] = Some((number, true));
        parents.push(Some((number, false)));
        let [front, back] = self.leaves[leaf].cell.split(&self.planes, &section);
        let child = |leaf: usize| Child::Leaf(LeafId(leaf as u32));
        let (kept, last) = (child(leaf), child(self.leaves.len()));
        self.nodes.push(Node { section, faces: Vec::new(), front: kept, back: last });
        self.leaves[leaf] = Leaf { solid: false, cell: front };
        self.leaves.push(Leaf { solid: false, cell: back });
    }

    /// Numbers the leaves as a walk meets them that goes to the front first.
    fn renumber_leaves(&mut self) {
        let mut old: Vec<Option<Leaf>> = self.leaves.drain(..).map(Some).collect();
        let mut renumbered = |leaves: &mut Vec<Leaf>, child: &mut Child| {
            if let Child::Leaf(leaf) = child {
                leaves.push(old[leaf.0 as usize].take().expect("a leaf has one parent"));
                *leaf = LeafId(leaves.len() as u32 - 1);
            }
        };
        let mut stack = vec![(None, true)];
        while let Some((parent, side)) = stack.pop() {
            let child: &mut Child = match (parent, side) {
                (None, _) => &mut self.root,
                (Some(parent), true) => &mut self.nodes[parent as usize].front,
                (Some(parent), false) => &mut self.nodes[parent as usize].back,
            };
            renumbered(&mut self.leaves, child);
            if let Child::Node(node) = *child {
                stack.extend([(Some(node), false), (Some(node), true)]);
            }
        }
    }
}

/// The coordinates of the faces' vertices along each axis, ascending.
fn coordinates(faces: &[LeafFace]) -> [Vec<Rational>; 3] {
    let points = faces.iter().flat_map(|face| face.polygon.points());
    let points: Vec<_> = points.map(|point| point.coordinates()).collect();
    from_fn(|i| {
        let mut offsets: Vec<Rational> = points.iter().map(|point| point[i].clone()).collect();
        offsets.sort();
        offsets.dedup();
        offsets
    })
}

fn around(cell: &Polyhedron) -> AxialBox {
    let points: Vec<RationalPoint3> = cell.faces().iter().flat_map(Polygon::points).collect();
    AxialBox::around(&points).expect("a cell has vertices")
}

fn extents(around: &AxialBox) -> [Rational; 3] {
    from_fn(|i| &around.high[i] - &around.low[i])
}
