//! The choice of lines for axial segments: the k-D tree of Teller and Séquin 1991, §2.3.
//!
//! What the paper says: a cell whose inside no face meets is a leaf. If faces span it, it is split
//! on the median one of them; else on a sufficiently obscured abscissa, along a face that cleaves
//! as few faces orthogonal to it as any, that candidate which is nearest to the median face.
//!
//! What it leaves open, and what is done here:
//!
//! - Of both dimensions, that with more spanning faces is split; of as many, x. The median of k
//!   faces in the order of their abscissae, faces at the same one counted each, is number
//!   ⌊(k − 1)/2⌋ from 0.
//! - An abscissa is sufficiently obscured if the lengths of the faces on it, each within the cell,
//!   sum to more than the threshold: faces that overlap count twice. Spanning faces are split on
//!   whatever the threshold.
//! - The fewest cleaved faces are sought in both dimensions together. The median face is that of
//!   the candidate's own dimension, of all faces that meet the inside; distances are exact, in
//!   grid units. Of equal ones, x comes before y, then the lesser abscissa.
//! - A face that only touches the cell, in one point or from outside, is disjoint.
//!
//! Only the order of coordinates matters, so all of it works on ranks, but for distances and
//! lengths. Each cell keeps its faces in three orders, by abscissa and by either end, which a split
//! filters: ends that it cuts off move to the split, and so stay in order. Hence O(n lg n) to sort,
//! and O(f) for the choice and for the split of a cell with f faces. The whole is O(n lg n) where
//! splits are balanced and cleave few, as in architecture; O(n²) where each cuts off one face.

use super::PlanDivisionError;
use super::axial::{AxialFace, Extents, FaceClass, classify};
use super::build::{Builder, Contents};
use crate::num::{Int, Rational};
use crate::predicates::compare_coordinates;
use crate::scene::plan::Plan;
use num_traits::{Signed, Zero};

/// A segment of the plan, in ranks.
#[derive(Clone, Copy, Debug)]
struct Face {
    /// The plan's segment, by its index.
    segment: u32,
    /// Its line.
    line: u32,
    /// The rank of its abscissa, and of its ends in the other dimension.
    at: u32,
    span: [u32; 2],
}

/// An axial plan, in ranks.
pub(super) struct Axial {
    faces: Vec<Face>,
    /// The coordinate of each rank, by dimension, in grid units.
    coordinates: [Vec<Int>; 2],
    /// In grid units; lengths are whole.
    threshold: Int,
}

/// Faces of one dimension, by their number, in three orders.
#[derive(Clone, Debug, Default)]
struct Sorted {
    by_abscissa: Vec<u32>,
    by_start: Vec<u32>,
    by_end: Vec<u32>,
}

/// A cell of the k-D tree and the faces that meet its inside, by their dimension.
pub(super) struct AxialCell<'a> {
    axial: &'a Axial,
    extents: Extents<u32>,
    faces: [Sorted; 2],
}

/// Where to split.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Abscissa {
    dimension: usize,
    at: u32,
    line: u32,
}

impl Axial {
    /// The plan in ranks; its faces by dimension, their numbers not sorted yet.
    pub(super) fn new(
        plan: &Plan,
        of_segment: &[u32],
        threshold: &Rational,
    ) -> Result<(Axial, [Vec<u32>; 2]), PlanDivisionError> {
        let (ranks, coordinates) = ranks(plan);
        let mut faces = Vec::with_capacity(plan.segments.len());
        let mut by_dimension = [Vec::new(), Vec::new()];
        for (index, (segment, &line)) in plan.segments.iter().zip(of_segment).enumerate() {
            let rank = |d: usize| segment.ends.map(|end| ranks[d][end as usize]);
            let [x, y] = [rank(0), rank(1)];
            let (dimension, at, [p, q]) = match (x[0] == x[1], y[0] == y[1]) {
                (true, _) => (0, x[0], y),
                (false, true) => (1, y[0], x),
                (false, false) => {
                    return Err(PlanDivisionError::NotAxial { segment: segment.source });
                }
            };
            by_dimension[dimension].push(faces.len() as u32);
            let span = [p.min(q), p.max(q)];
            faces.push(Face { segment: index as u32, line, at, span });
        }
        let threshold = (threshold * &plan.grid).floor().to_integer();
        Ok((Axial { faces, coordinates, threshold }, by_dimension))
    }

    /// The box of the plan, with the faces that meet its inside.
    pub(super) fn cell_of_box(&self, plan: &Plan, all: [Vec<u32>; 2]) -> AxialCell<'_> {
        let corner = |i: usize| plan.points.get(plan.bounds[i]).coordinates();
        let (low, high) = (corner(0), corner(2));
        let rank = |d: usize, c: &Rational| {
            // The corners of the box are among the plan's points.
            self.coordinates[d].partition_point(|known| known < &c.to_integer()) as u32
        };
        let extents = Extents([0, 1].map(|d| [rank(d, &low[d]), rank(d, &high[d])]));
        let mut dimension = 0;
        let faces = all.map(|mut faces| {
            faces.retain(|&face| match self.class(dimension, face, &extents) {
                FaceClass::Spanning | FaceClass::Incident => true,
                FaceClass::Disjoint | FaceClass::Covering => false,
            });
            dimension += 1;
            self.sorted(faces)
        });
        AxialCell { axial: self, extents, faces }
    }

    fn sorted(&self, faces: Vec<u32>) -> Sorted {
        let by = |key: &dyn Fn(&Face) -> u32| {
            let mut order = faces.clone();
            order.sort_by_key(|&face| key(self.face(face)));
            order
        };
        Sorted {
            by_abscissa: by(&|face| face.at),
            by_start: by(&|face| face.span[0]),
            by_end: by(&|face| face.span[1]),
        }
    }

    #[inline]
    fn face(&self, number: u32) -> &Face {
        &self.faces[number as usize]
    }

    fn class(&self, dimension: usize, face: u32, extents: &Extents<u32>) -> FaceClass {
        let Face { at, span, .. } = *self.face(face);
        classify(&AxialFace { dimension, at, span }, extents)
    }

    /// How far apart two abscissae of a dimension are.
    fn distance(&self, dimension: usize, p: u32, q: u32) -> Int {
        let [p, q] = [p, q].map(|rank| &self.coordinates[dimension][rank as usize]);
        (p - q).abs()
    }
}

/// For each dimension the rank of each point, and the coordinate of each rank.
fn ranks(plan: &Plan) -> ([Vec<u32>; 2], [Vec<Int>; 2]) {
    let mut coordinates = [Vec::new(), Vec::new()];
    let ranks = [0, 1].map(|d| {
        let mut order: Vec<u32> = (0..plan.points.len() as u32).collect();
        let compare =
            |p: u32, q: u32| compare_coordinates(d, plan.points.get(p), plan.points.get(q));
        order.sort_by(|&p, &q| compare(p, q));
        let mut ranks = vec![0; order.len()];
        for (i, &point) in order.iter().enumerate() {
            if i == 0 || compare(order[i - 1], point).is_lt() {
                // Points of a plan lie on its grid.
                coordinates[d].push(plan.points.get(point).coordinates()[d].to_integer());
            }
            ranks[point as usize] = coordinates[d].len() as u32 - 1;
        }
        ranks
    });
    (ranks, coordinates)
}

impl AxialCell<'_> {
    /// The median face of those that span the cell, in the dimension that has more of them.
    fn median_spanning(&self) -> Option<Abscissa> {
        let spanning = [0, 1].map(|d| -> Vec<u32> {
            let spans =
                |&&face: &&u32| self.axial.class(d, face, &self.extents) == FaceClass::Spanning;
            self.faces[d].by_abscissa.iter().filter(spans).copied().collect()
        });
        let dimension = usize::from(spanning[1].len() > spanning[0].len());
        let spanning = &spanning[dimension];
        let median = spanning.get(spanning.len().saturating_sub(1) / 2)?;
        let Face { at, line, .. } = *self.axial.face(*median);
        Some(Abscissa { dimension, at, line })
    }

    /// The sufficiently obscured abscissa that cleaves fewest faces, nearest to the median face.
    fn min_cleaving(&self) -> Option<Abscissa> {
        let candidates = [0, 1].map(|d| self.candidates(d));
        let fewest = candidates.iter().filter_map(|(fewest, _)| *fewest).min()?;
        let minimal = candidates.iter().filter(|(cleaved, _)| *cleaved == Some(fewest));
        let beside = minimal.flat_map(|(_, beside)| beside.iter().flatten().copied());
        // Of equal distances the first one is taken.
        beside.min_by_key(|candidate| {
            let d = candidate.dimension;
            self.axial.distance(d, candidate.at, self.median(d))
        })
    }

    /// The abscissa of the median face of a dimension that has any.
    fn median(&self, dimension: usize) -> u32 {
        let all = &self.faces[dimension].by_abscissa;
        self.axial.face(all[(all.len() - 1) / 2]).at
    }

    /// The fewest faces that a sufficiently obscured abscissa of a dimension cleaves; and of those
    /// abscissae the last at or before the median face and the first after it.
    fn candidates(&self, dimension: usize) -> (Option<usize>, [Option<Abscissa>; 2]) {
        let axial = self.axial;
        let across = &self.faces[1 - dimension];
        let (mut started, mut ended) = (0, 0);
        let mut fewest = None;
        let mut beside = [None, None];
        let faces = &self.faces[dimension].by_abscissa;
        for faces in faces.chunk_by(|&p, &q| axial.face(p).at == axial.face(q).at) {
            let Face { at, line, .. } = *axial.face(faces[0]);
            if !self.is_obscured(dimension, faces) {
                continue;
            }
            let before = |order: &[u32], is_before: &dyn Fn(&Face) -> bool| {
                order.iter().take_while(|&&face| is_before(axial.face(face))).count()
            };
            started += before(&across.by_start[started..], &|face| face.span[0] < at);
            ended += before(&across.by_end[ended..], &|face| face.span[1] <= at);
            let cleaved = started - ended;
            if fewest.is_none_or(|fewest| cleaved < fewest) {
                (fewest, beside) = (Some(cleaved), [None, None]);
            }
            if fewest == Some(cleaved) {
                let found = Some(Abscissa { dimension, at, line });
                if at <= self.median(dimension) {
                    beside[0] = found;
                } else if beside[1].is_none() {
                    beside[1] = found;
                }
            }
        }
        (fewest, beside)
    }

    /// Whether the lengths of faces at one abscissa, within the cell, sum to more than the
    /// threshold.
    fn is_obscured(&self, dimension: usize, faces: &[u32]) -> bool {
        if self.axial.threshold.is_zero() {
            return true;
        }
        let [low, high] = self.extents.0[1 - dimension];
        let length = |&face: &u32| {
            let [start, end] = self.axial.face(face).span;
            self.axial.distance(1 - dimension, start.max(low), end.min(high))
        };
        faces.iter().map(length).sum::<Int>() > self.axial.threshold
    }

    /// The part of the cell on one side of an abscissa.
    fn part(&self, cut: Abscissa, is_high: bool) -> Self {
        let mut extents = self.extents;
        extents.0[cut.dimension][usize::from(!is_high)] = cut.at;
        let is_in = |d: usize, face: &Face| match (d == cut.dimension, is_high) {
            (true, true) => face.at > cut.at,
            (true, false) => face.at < cut.at,
            (false, true) => face.span[1] > cut.at,
            (false, false) => face.span[0] < cut.at,
        };
        let faces = [0, 1].map(|d| {
            let keep = |order: &[u32]| {
                order.iter().copied().filter(|&face| is_in(d, self.axial.face(face))).collect()
            };
            let Sorted { by_abscissa, by_start, by_end } = &self.faces[d];
            Sorted {
                by_abscissa: keep(by_abscissa),
                by_start: keep(by_start),
                by_end: keep(by_end),
            }
        });
        AxialCell { axial: self.axial, extents, faces }
    }
}

impl Contents for AxialCell<'_> {
    type Cut = Abscissa;

    fn len(&self) -> usize {
        self.faces.iter().map(|sorted| sorted.by_abscissa.len()).sum()
    }

    fn choose(&self, _builder: &Builder) -> Option<(Abscissa, u32)> {
        let cut = self.median_spanning().or_else(|| self.min_cleaving())?;
        Some((cut, cut.line))
    }

    fn split(self, cut: Abscissa, _builder: &mut Builder) -> [Self; 2] {
        // Axial lines are directed so that the greater coordinates are to their left.
        [self.part(cut, true), self.part(cut, false)]
    }

    fn segments(&self) -> impl Iterator<Item = u32> {
        let all = self.faces.iter().flat_map(|sorted| &sorted.by_abscissa);
        all.map(|&face| self.axial.face(face).segment)
    }
}
