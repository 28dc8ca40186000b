//! §2.3 of Teller and Séquin 1991, sentence by sentence, in quadratic time a node.

use super::Ends;
use crate::subdivision::plan::{AxialFace, Extents, FaceClass, classify};

/// A tree of boxes.
#[derive(Debug)]
pub(super) enum Tree {
    /// A cell, and the faces that are left inside, by their index.
    Leaf { extents: [[i64; 2]; 2], left_inside: Vec<usize> },
    /// A split: its dimension and abscissa; the low and the high child.
    Split { dimension: usize, at: i64, children: Box<[Tree; 2]> },
}

/// A face as its dimension, its abscissa and its span.
type Face = (usize, i64, [i64; 2]);

fn face(ends: &Ends) -> Face {
    let [p, q] = *ends;
    let dimension = usize::from(p[0] != q[0]);
    let span = [p[1 - dimension], q[1 - dimension]];
    (dimension, p[dimension], [span[0].min(span[1]), span[0].max(span[1])])
}

/// Divides a box with the faces of `segments` in it.
pub(super) fn tree(segments: &[Ends], extents: [[i64; 2]; 2], threshold: i64) -> Tree {
    let faces: Vec<(usize, Face)> = segments.iter().map(face).enumerate().collect();
    divide(&faces, extents, threshold)
}

fn divide(faces: &[(usize, Face)], extents: [[i64; 2]; 2], threshold: i64) -> Tree {
    let class = |&(_, (dimension, at, span)): &(usize, Face)| {
        classify(&AxialFace { dimension, at, span }, &Extents(extents))
    };
    // All but the disjoint faces are stored.
    let stored: Vec<_> =
        faces.iter().filter(|face| class(face) != FaceClass::Disjoint).copied().collect();
    let of_class = |wanted: FaceClass| -> Vec<(usize, Face)> {
        stored.iter().filter(|face| class(face) == wanted).copied().collect()
    };
    let spanning = of_class(FaceClass::Spanning);
    let inside = [spanning.clone(), of_class(FaceClass::Incident)].concat();
    let cut = spanning_cut(&spanning).or_else(|| cleaving_cut(&inside, extents, threshold));
    let Some((dimension, at)) = cut else {
        let mut left_inside: Vec<usize> = inside.iter().map(|&(index, _)| index).collect();
        left_inside.sort_unstable();
        return Tree::Leaf { extents, left_inside };
    };
    let (mut low, mut high) = (extents, extents);
    low[dimension][1] = at;
    high[dimension][0] = at;
    let children = Box::new([low, high].map(|extents| divide(&stored, extents, threshold)));
    Tree::Split { dimension, at, children }
}

fn abscissae(faces: &[(usize, Face)], dimension: usize) -> Vec<i64> {
    let of = faces.iter().filter(|(_, face)| face.0 == dimension);
    let mut all: Vec<i64> = of.map(|(_, face)| face.1).collect();
    all.sort_unstable();
    all
}

fn median(sorted: &[i64]) -> i64 {
    sorted[(sorted.len() - 1) / 2]
}

fn spanning_cut(spanning: &[(usize, Face)]) -> Option<(usize, i64)> {
    let [x, y] = [0, 1].map(|d| abscissae(spanning, d));
    match (x.len(), y.len()) {
        (0, 0) => None,
        (x_count, y_count) if x_count >= y_count => Some((0, median(&x))),
        _ => Some((1, median(&y))),
    }
}

fn cleaving_cut(
    inside: &[(usize, Face)],
    extents: [[i64; 2]; 2],
    threshold: i64,
) -> Option<(usize, i64)> {
    let mut best: Option<Rated> = None;
    for dimension in [0, 1] {
        let all = abscissae(inside, dimension);
        let [low, high] = extents[1 - dimension];
        for &at in &all {
            let on = inside.iter().filter(|(_, face)| (face.0, face.1) == (dimension, at));
            let length: i64 = on.map(|(_, face)| face.2[1].min(high) - face.2[0].max(low)).sum();
            if length <= threshold {
                continue;
            }
            let is_cleaved = |face: &Face| face.0 != dimension && face.2[0] < at && at < face.2[1];
            let cleaved = inside.iter().filter(|(_, face)| is_cleaved(face)).count();
            let distance = (at - median(&all)).abs();
            let rank = (cleaved, distance, dimension, at);
            if best.is_none_or(|(known, _)| rank < known) {
                best = Some((rank, (dimension, at)));
            }
        }
    }
    best.map(|(_, cut)| cut)
}

/// How good a split is (least first), and its dimension and abscissa.
type Rated = ((usize, i64, usize, i64), (usize, i64));
