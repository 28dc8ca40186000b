//! Sets of cells that may overlap, such as the sectors of a Doom level of which one is not closed.
//!
//! The sweep asks about groups, and a cell is in one group or in none. So the cells that are in the
//! same several sets are a group of their own, and what is found for it holds for each of the sets.

use super::{Groups, PlanSight};
use crate::num::{Number, Rational};
use crate::report::{Matrix, Verdict};
use crate::scene::CellId;
use crate::scene::plan::PlanGraph;
use rustc_hash::FxHashMap;

/// Sets of cells.
#[derive(Clone, Debug)]
pub struct Cover {
    sets: usize,
    groups: Groups,
    /// The sets that each group is a part of: of the first groups its own, of the rest several.
    sets_of_group: Vec<Vec<u32>>,
}

impl Cover {
    /// `count` sets, and for each cell those that it is in.
    ///
    /// # Panics
    /// If a cell names a set beyond them.
    pub fn new<'a>(count: usize, of_cell: impl IntoIterator<Item = &'a [u32]>) -> Cover {
        let mut sets_of_group: Vec<Vec<u32>> = (0..count as u32).map(|set| vec![set]).collect();
        let mut numbers: FxHashMap<&[u32], u32> = FxHashMap::default();
        let group_of = |sets: &'a [u32]| match sets {
            [] => None,
            &[set] => Some(set),
            several => Some(*numbers.entry(several).or_insert_with(|| {
                sets_of_group.push(several.to_vec());
                sets_of_group.len() as u32 - 1
            })),
        };
        let of_cell: Vec<Option<u32>> = of_cell.into_iter().map(group_of).collect();
        Cover { sets: count, groups: Groups::new(sets_of_group.len(), of_cell), sets_of_group }
    }

    /// Each cell a set of its own.
    pub fn cells(count: usize) -> Cover {
        let sets_of_group = (0..count as u32).map(|cell| vec![cell]).collect();
        Cover { sets: count, groups: Groups::cells(count), sets_of_group }
    }

    /// The groups that the sweep is to ask about.
    pub fn groups(&self) -> &Groups {
        &self.groups
    }

    /// Whether a pair of groups tells of a pair of sets.
    pub fn tells_of(&self, [g, h]: [u32; 2], [from, to]: [u32; 2]) -> bool {
        let [g, h] = [g, h].map(|group| &self.sets_of_group[group as usize]);
        (g.contains(&from) && h.contains(&to)) || (g.contains(&to) && h.contains(&from))
    }

    /// The sets that all cells of a group are in, ascending.
    ///
    /// # Panics
    /// If there is no such group.
    pub fn sets_of(&self, group: u32) -> &[u32] {
        &self.sets_of_group[group as usize]
    }

    /// The verdict of each pair of sets from those of the groups: a pair is open if any of its
    /// groups are.
    ///
    /// # Panics
    /// If the matrix is not of the groups.
    pub fn matrix(&self, of_groups: Matrix) -> Matrix {
        assert_eq!(of_groups.size(), self.groups.count(), "a matrix of these groups");
        if self.sets_of_group.len() == self.sets {
            return of_groups;
        }
        let mut matrix = Matrix::new(self.sets, Verdict::NotOpen);
        for (row, from) in self.sets_of_group.iter().enumerate() {
            for (column, to) in self.sets_of_group.iter().enumerate() {
                let verdict = of_groups.get(row, column);
                let pairs = from.iter().flat_map(|&from| to.iter().map(move |&to| (from, to)));
                for (from, to) in pairs.map(|(from, to)| (from as usize, to as usize)) {
                    matrix.set(from, to, matrix.get(from, to).max(verdict));
                }
            }
        }
        matrix
    }

    /// The line of each pair of sets from those of the groups: the first that shows it, ascending.
    pub fn sights(&self, graph: &PlanGraph, of_groups: Vec<PlanSight>) -> Vec<PlanSight> {
        if self.sets_of_group.len() == self.sets {
            return of_groups;
        }
        let mut sights = Vec::with_capacity(of_groups.len());
        for sight in of_groups {
            for &from in &self.sets_of_group[sight.from as usize] {
                for &to in &self.sets_of_group[sight.to as usize] {
                    match from.cmp(&to) {
                        std::cmp::Ordering::Less => {
                            sights.push(PlanSight { from, to, ..sight.clone() })
                        }
                        std::cmp::Ordering::Equal => {}
                        std::cmp::Ordering::Greater => sights.push(reversed(&sight, to, from)),
                    }
                }
            }
        }
        sights.extend(self.shared_cells(graph));
        sights.sort_by_key(|sight| (sight.from, sight.to));
        sights.dedup_by_key(|sight| (sight.from, sight.to));
        sights
    }

    /// Lines inside cells that two sets share.
    fn shared_cells<'a>(&'a self, graph: &'a PlanGraph) -> impl Iterator<Item = PlanSight> + 'a {
        (self.sets..self.sets_of_group.len()).flat_map(move |group| {
            let cells = 0..graph.cells.len() as u32;
            let mut inside =
                cells.filter(move |&cell| self.groups.of(CellId(cell)) == Some(group as u32));
            let line = inside.next().map(|cell| line_inside(graph, &graph.polygons[cell as usize]));
            let sets = &self.sets_of_group[group];
            line.into_iter().flat_map(move |line| {
                let pairs = sets.iter().enumerate().flat_map(move |(index, &from)| {
                    sets[index + 1..].iter().map(move |&to| (from, to))
                });
                pairs.map(move |(from, to)| PlanSight {
                    from,
                    to,
                    portals: Vec::new(),
                    line: line.clone(),
                })
            })
        })
    }
}

fn reversed(sight: &PlanSight, from: u32, to: u32) -> PlanSight {
    let [p, q] = sight.line.clone();
    let portals = sight.portals.iter().rev().copied().collect();
    PlanSight { from, to, portals, line: [q, p] }
}

/// Two points inside a convex polygon: the middle of its first triangle, and halfway from there to
/// its first corner.
fn line_inside(graph: &PlanGraph, polygon: &[u32]) -> [[Number; 2]; 2] {
    let corners = [0, 1, 2].map(|index| graph.world(polygon[index]).map(|c| c.to_rational()));
    let [a, b, c] = &corners;
    let third = Rational::new(1.into(), 3.into());
    let half = Rational::new(1.into(), 2.into());
    let middle = [0, 1].map(|axis| (&a[axis] + &b[axis] + &c[axis]) * &third);
    let beside = [0, 1].map(|axis| (&middle[axis] + &a[axis]) * &half);
    [middle, beside].map(|point| point.map(Number::from))
}
