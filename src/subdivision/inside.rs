//! The same world with everything that cannot be reached filled in.
//!
//! Of the occluders only what looks into a leaf that is kept still bounds anything: a solid's
//! face on one side, a thin polygon on one side, which makes it a face of what is filled, or on
//! both. Divided by these faces alone the kept part of space falls into fewer and larger cells.

use super::{DivisionError, Face, LeafId, Options, Subdivision, tree};
use crate::construct::Polygon;
use crate::report::Progress;

impl Subdivision {
    /// Divides the box again, with all leaves solid that `kept` does not hold.
    ///
    /// Requires: of two empty leaves with a portal between them, both are kept or neither, as a
    /// flood leaves them.
    ///
    /// # Errors
    /// [`DivisionError::Interrupted`] only.
    ///
    /// # Panics
    /// If `kept` has not one entry a leaf.
    pub fn filled(
        &self,
        kept: &[bool],
        options: &Options,
        progress: &dyn Progress,
    ) -> Result<Subdivision, DivisionError> {
        assert_eq!(kept.len(), self.leaves.len(), "one entry a leaf");
        let stays = |leaf: LeafId| kept[leaf.0 as usize] && !self.leaf(leaf).solid;
        let mut faces = Vec::new();
        for face in &self.faces {
            if face.thin {
                self.keep_thin(face, &stays, &mut faces);
            } else {
                let pieces = self.looking_into(self.root, face.polygon.clone());
                let kept: Vec<_> = pieces.iter().map(|(leaf, _)| stays(*leaf)).collect();
                if kept.iter().all(|kept| *kept) {
                    faces.push(face.clone());
                } else {
                    let kept = pieces.into_iter().zip(kept).filter(|(_, kept)| *kept);
                    faces.extend(kept.map(|((_, polygon), _)| Face { polygon, ..*face }));
                }
            }
        }
        let solid = faces.is_empty() && !self.leaf_ids().any(stays);
        let input = tree::Input { faces, hints: self.hints.clone(), solid };
        let flat = self.flat.clone();
        let planes = self.planes.clone();
        Subdivision::of_faces(planes, self.bounds, input, flat, options, progress)
    }

    /// What becomes of a thin polygon; in one piece where that is the same everywhere.
    fn keep_thin(&self, face: &Face, stays: &dyn Fn(LeafId) -> bool, faces: &mut Vec<Face>) {
        let mut pieces: Vec<(bool, bool, Polygon)> = Vec::new();
        for (front, piece) in self.looking_into(self.root, face.polygon.clone()) {
            for (back, part) in self.looking_into(self.root, piece.flipped()) {
                pieces.push((stays(front), stays(back), part.flipped()));
            }
        }
        let mut kept = |front: bool, back: bool, polygon: Polygon| {
            let polygon = if front { polygon } else { polygon.flipped() };
            if front || back {
                faces.push(Face { polygon, thin: front && back, ..*face });
            }
        };
        match &pieces[..] {
            [(front, back, _), rest @ ..]
                if rest.iter().all(|(f, b, _)| f == front && b == back) =>
            {
                kept(*front, *back, face.polygon.clone());
            }
            _ => pieces.into_iter().for_each(|(front, back, polygon)| kept(front, back, polygon)),
        }
    }
}
