//! A part of a sequence's cone, between the planes of some splits.

use super::{Condition, Factor};
use crate::num::{Int, Sign};
use crate::stab::cone::{Push, dot};
use crate::stab::engine::{Engine, Range};
use crate::stab::mask::Mask;
use crate::stab::quadric::{Vector, side};
use crate::stab::sequence::Frame;

/// A pointed cone of full dimension on which the Klein form keeps one weak sign.
#[derive(Clone, Debug)]
pub(super) struct Part {
    frame: Frame,
    cone: Engine,
    range: Range,
    /// The half-spaces that the cone keeps.
    rows: Vec<Row>,
}

/// A half-space `form · x >= 0`.
#[derive(Clone, Debug)]
pub(super) struct Row {
    pub(super) factor: Factor,
    /// In the part's frame, primitive.
    pub(super) form: Vector,
    /// The factor is this many times the form.
    pub(super) content: Int,
}

/// A part by its facets and rays.
pub(super) struct Shape<'a> {
    pub(super) facets: Vec<&'a Row>,
    /// The extreme rays, in the part's frame.
    pub(super) rays: Vec<Vector>,
    /// By facet and ray; not negative.
    pub(super) values: Vec<Vec<Int>>,
    /// The weak sign of the Klein form.
    pub(super) sign: Sign,
    /// The side product of two rays, the later one first, times the sign.
    pub(super) sides: Vec<Vec<Int>>,
}

impl Part {
    /// The whole cone of some conditions, in which nothing shall be open; `None` where nothing is
    /// strictly inside.
    pub(super) fn whole(conditions: &[(Condition, Vector)], frame: &Frame) -> Option<Part> {
        let rows: Vec<Row> = conditions
            .iter()
            .map(|(condition, vector)| {
                let (form, content) = frame.form(vector);
                Row { factor: Factor::Condition(*condition), form, content }
            })
            .collect();
        let range = Range::default().with(rows.iter().map(|row| &row.form));
        let cone = Engine::everything().widened_for(range);
        let mut part = Part { frame: frame.clone(), cone, range, rows: Vec::new() };
        rows.into_iter().all(|row| part.push(row) == Push::Strict).then_some(part)
    }

    /// One half of the part: that on the given side of a plane, which splits at this depth.
    pub(super) fn half(&self, plane: &Vector, depth: usize, positive: bool) -> Part {
        let (form, content) = self.frame.form(plane);
        let form = if positive { form } else { form.map(|c| -c) };
        let range = self.range.with(std::iter::once(&form));
        let mut half = self.clone();
        half.cone = half.cone.widened_for(range);
        half.range = range;
        half.push(Row { factor: Factor::Split(depth), form, content });
        half
    }

    fn push(&mut self, row: Row) -> Push {
        let push = self.cone.push(&row.form);
        if self.cone.row_count() > self.rows.len() {
            self.rows.push(row);
        }
        push
    }

    /// What the part's vectors are measured in.
    pub(super) fn frame(&self) -> &Frame {
        &self.frame
    }

    /// Facets, rays and their side products.
    pub(super) fn shape(&self) -> Shape<'_> {
        let rays = self.cone.rays();
        let facets: Vec<&Row> = self.facets().into_iter().map(|row| &self.rows[row]).collect();
        let value = |row: &&Row| rays.iter().map(|ray| dot::<Int>(ray, &row.form)).collect();
        let mut sides: Vec<Vec<Int>> =
            (0..rays.len()).map(|k| (0..=k).map(|l| side(&rays[k], &rays[l])).collect()).collect();
        // Twice Q on the rays, and where it vanishes on all, on the sums of two.
        let mut on_rays = sides.iter().enumerate().map(|(k, of)| &of[k]);
        let mut between = sides.iter().flatten();
        let is_decided = |value: &&Int| Sign::of(*value) != Sign::Zero;
        let deciding = on_rays.find(is_decided).or_else(|| between.find(is_decided));
        let sign = deciding.map_or(Sign::Zero, Sign::of);
        if sign == Sign::Negative {
            sides.iter_mut().flatten().for_each(|value| *value = -&*value);
        }
        Shape { values: facets.iter().map(value).collect(), facets, rays, sign, sides }
    }

    /// The rows that meet the cone in a face of five dimensions, each such face once: its rays are
    /// not a part of another row's.
    fn facets(&self) -> Vec<usize> {
        let mut on_row = vec![Mask::default(); self.rows.len()];
        for (ray, tight) in self.cone.tight_rows().iter().enumerate() {
            tight.members().for_each(|row| on_row[row].insert(ray));
        }
        let is_facet = |&row: &usize| {
            on_row[row].len() >= 5
                && (0..on_row.len()).all(|other| {
                    let within = on_row[row].is_subset_of(&on_row[other]);
                    other == row || !within || (on_row[row] == on_row[other] && row < other)
                })
        };
        (0..self.rows.len()).filter(is_facet).collect()
    }
}
