//! Which cells see which objects.
//!
//! An object is a cell of the graph that lines enter and do not leave ([`ObjectGraph`]), so a cell
//! sees it iff some portal sequence that ends with one of its portals is open, or it has a part in
//! the cell. Bounds and search are those of cells, asked only for pairs of a cell and an object;
//! either of the two may be the source, as a line reversed is a line.
//!
//! What is known of the cells shortens the work: a line into an object crosses a cell that one of
//! its portals lies in, and no line joins two cells that are not open to each other.

use super::arena::Arena;
use super::bits::Bits;
use super::bounds::{self, Bounds, SharedBounds};
use super::run::{Finished, Options, search};
use super::sources::{Source, share_out};
use super::{OpenPair, Row};
use crate::report::{Matrix, Progress, Verdict};
use crate::scene::{CellId, ObjectGraph};
use rayon::prelude::*;

/// A cell that sees an object, and how.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ObjectSight {
    /// The object.
    pub object: u32,
    /// The cell.
    pub cell: CellId,
    /// A line from the cell; the last of its portals enters the object.
    pub pair: OpenPair,
}

/// Computes the pairs of a cell and an object that has no part in it; `known` holds the verdicts
/// of the pairs of cells.
///
/// The rows are those of cells and of the cells that stand for objects. Runs on rayon's current
/// thread pool; an interrupt through `progress` ends it with the rows finished so far.
///
/// # Panics
/// If `known` is not of as many cells.
pub fn compute_objects(
    objects: &ObjectGraph,
    known: &Matrix,
    budget: Option<u64>,
    progress: &dyn Progress,
) -> Finished {
    assert_eq!(known.size(), objects.cells as usize, "verdicts of other cells");
    let arena = Arena::with_objects(objects);
    progress.begin("upper bound of objects", bounds::STAGES);
    let Some(bounds) = Bounds::new(&arena, progress) else { return Finished::default() };
    let joined = joined(&arena, objects, known);
    let sources = share_out(&arena, |cell| {
        let mut wanted = left_by(&arena, objects, &bounds, cell);
        wanted.intersect(&joined[cell as usize]);
        wanted
    });
    let todo: Vec<&Source> = sources.iter().filter(|source| source.work() > 0).collect();
    let pairs = u64::from(objects.cells) * u64::from(objects.objects());
    let held: u64 = objects.held_by.iter().map(|cells| cells.len() as u64).sum();
    let candidates: u64 = todo.iter().map(|source| source.work()).sum();
    let shared = SharedBounds::new(bounds);
    refute_known(&arena, &shared, known);
    let options = Options { budget, ..Options::default() };
    let rows = search(&arena, &shared, &todo, &options, &|_| {}, progress);
    let mut finished = Finished {
        is_complete: rows.len() == todo.len(),
        settled_by_bound: pairs - held - candidates,
        rows,
        ..Finished::default()
    };
    finished.rows.sort_unstable_by_key(|row| row.source);
    finished.rows.iter().for_each(|row| finished.tally.add(&row.tally));
    finished
}

/// What the upper bound alone says: of each object, the cells that hold a part of it are open, all
/// that the bound does not rule out are undecided. `None` if interrupted.
///
/// The bound floods through the planes that separate two portals (Teller 1992, section 8.3.5), so
/// what it rules out is not open.
pub fn bound_objects(objects: &ObjectGraph, progress: &dyn Progress) -> Option<Vec<Vec<Verdict>>> {
    let arena = Arena::with_objects(objects);
    progress.begin("upper bound of objects", bounds::STAGES);
    let bounds = Bounds::new(&arena, progress)?;
    let mut verdicts = verdicts_held(objects);
    for (object, verdicts) in (0..).zip(&mut verdicts) {
        for cell in left_by(&arena, objects, &bounds, objects.cell_of(object).0).iter() {
            verdicts[cell as usize] = Verdict::Undecided;
        }
    }
    Some(verdicts)
}

/// The verdicts of all cells for each object, from the rows of [`compute_objects`], which must be
/// complete.
pub fn assemble_objects(objects: &ObjectGraph, rows: &[Row]) -> Vec<Vec<Verdict>> {
    let mut verdicts = verdicts_held(objects);
    for row in rows {
        let open = row.open.iter().map(|pair| (pair.target, Verdict::Open));
        let undecided = row.undecided.iter().map(|&target| (target, Verdict::Undecided));
        for (target, verdict) in open.chain(undecided) {
            let (object, cell) = object_and_cell(objects, row.source, target);
            verdicts[object as usize][cell.0 as usize] = verdict;
        }
    }
    verdicts
}

/// How the cells see the objects that have no part in them, by object, then by cell.
pub fn object_sights(objects: &ObjectGraph, rows: &[Row]) -> Vec<ObjectSight> {
    let mut sights = Vec::new();
    for row in rows {
        for pair in &row.open {
            let (object, cell) = object_and_cell(objects, row.source, pair.target);
            let pair = match row.source == cell {
                true => pair.clone(),
                false => pair.clone().reversed(row.source),
            };
            sights.push(ObjectSight { object, cell, pair });
        }
    }
    sights.sort_unstable_by_key(|sight| (sight.object, sight.cell));
    sights
}

/// The object and the cell of a pair.
fn object_and_cell(objects: &ObjectGraph, a: CellId, b: CellId) -> (u32, CellId) {
    let (cell, object) = (a.min(b), a.max(b));
    (object.0 - objects.cells, cell)
}

/// Open for cells that hold a part of an object, not open for the others.
fn verdicts_held(objects: &ObjectGraph) -> Vec<Vec<Verdict>> {
    let row = |cells: &Vec<CellId>| {
        let mut row = vec![Verdict::NotOpen; objects.cells as usize];
        cells.iter().for_each(|cell| row[cell.0 as usize] = Verdict::Open);
        row
    };
    objects.held_by.iter().map(row).collect()
}

/// The objects that the bound leaves for a cell, or the cells that it leaves for an object, without
/// those that it has a part in.
fn left_by(arena: &Arena, objects: &ObjectGraph, bounds: &Bounds, cell: u32) -> Bits {
    let mut left = bounds.cells_from(arena, cell);
    left.retain(|other| {
        let (low, high) = (cell.min(other), cell.max(other));
        let holds = |object: u32| {
            objects.held_by[(object - objects.cells) as usize].binary_search(&CellId(low)).is_ok()
        };
        !arena.is_object(low) && arena.is_object(high) && !holds(high)
    });
    left
}

/// For each cell the objects, and for each object the cells, such that the cell is not known not to
/// see any cell from which the object is entered.
fn joined(arena: &Arena, objects: &ObjectGraph, known: &Matrix) -> Vec<Bits> {
    let seen_from = |object: u32| {
        let mut cells = arena.no_cells();
        for &portal in arena.leaving(objects.cell_of(object).0) {
            for (cell, &verdict) in (0..).zip(known.row(arena.to(portal) as usize)) {
                if !is_apart(verdict) {
                    cells.insert(cell);
                }
            }
        }
        cells
    };
    let of_objects: Vec<Bits> = (0..objects.objects()).into_par_iter().map(seen_from).collect();
    let mut joined = vec![arena.no_cells(); objects.cells as usize];
    for (object, cells) in (0..).zip(&of_objects) {
        for cell in cells.iter() {
            joined[cell as usize].insert(objects.cell_of(object).0);
        }
    }
    joined.extend(of_objects);
    joined
}

/// Leaves out of the bounds what joins cells that are known not to be open.
fn refute_known(arena: &Arena, shared: &SharedBounds, known: &Matrix) {
    (0..known.size()).into_par_iter().for_each(|a| {
        for (b, &verdict) in known.row(a).iter().enumerate().take(a) {
            if is_apart(verdict) {
                shared.refute(arena, a as u32, b as u32);
            }
        }
    });
}

/// Whether a verdict says that no line joins two cells.
fn is_apart(verdict: Verdict) -> bool {
    match verdict {
        Verdict::NotOpen | Verdict::Grazing => true,
        Verdict::Open | Verdict::Undecided => false,
    }
}
