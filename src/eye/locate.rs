//! Which cells an eye belongs to, as far as portals tell.
//!
//! A portal graph has no walls: a cell is known by its portals only, and lies in the closed inner
//! half-space of each of their planes. That is necessary for being in the cell, not sufficient. So
//! 1. an eye in a closed portal belongs to both of its cells;
//! 2. otherwise it belongs to the cell whose half-spaces hold it, if there is just one;
//! 3. otherwise the caller has to name the cell, and is believed unless the half-spaces refute it.
//!
//! In cells that are not exactly convex, only planes that have all portals of the cell on their
//! inner side count. An eye in solid space cannot be told from one in a cell.

use super::view::View;
use crate::scene::CellId;

/// Why it is not known which cell an eye is in.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LocateError {
    /// The planes of no cell's portals leave room for the eye.
    #[error("the eye is in no cell: it is behind a portal's plane of each")]
    Nowhere,
    /// The portals do not tell.
    #[error(
        "the portals leave {} cells in which the eye may be: name one of {}",
        names.len(), listed(names)
    )]
    Ambiguous {
        /// The names of the cells.
        names: Vec<String>,
    },
    /// The cell that was named does not hold the eye.
    #[error("the eye is not in cell `{name}`: it is outside the plane of portal {portal}")]
    NotInCell {
        /// The cell's name.
        name: String,
        /// The portal, by its number in the input.
        portal: u32,
    },
}

/// The first names of a list.
fn listed(names: &[String]) -> String {
    let mut text = names.iter().take(8).map(String::as_str).collect::<Vec<_>>().join(", ");
    if names.len() > 8 {
        text.push_str(", …");
    }
    text
}

/// The cells that the eye belongs to, in ascending order.
pub(super) fn cells_of_eye(view: &View, named: Option<CellId>) -> Result<Vec<CellId>, LocateError> {
    let graph = view.graph.graph;
    let name = |cell: CellId| graph.cells[cell.0 as usize].clone();
    let mut cells = Vec::new();
    if let Some(cell) = named {
        if let Some(portal) = refuted_by(view, cell) {
            let portal = graph.portals[portal].source;
            return Err(LocateError::NotInCell { name: name(cell), portal });
        }
        cells.push(cell);
    } else {
        let touched = (0..graph.portals.len()).filter(|&portal| view.is_in_portal(portal));
        cells.extend(touched.flat_map(|portal| {
            let portal = &graph.portals[portal];
            [portal.from, portal.to]
        }));
    }
    if cells.is_empty() {
        let all = (0..graph.cells.len() as u32).map(CellId);
        cells.extend(all.filter(|&cell| refuted_by(view, cell).is_none()));
        match cells.as_slice() {
            [] => return Err(LocateError::Nowhere),
            [_] => {}
            several => {
                let names = several.iter().map(|&cell| name(cell)).collect();
                return Err(LocateError::Ambiguous { names });
            }
        }
    }
    Ok(closure(view, cells))
}

/// A portal whose plane bounds the cell and has the eye strictly outside.
fn refuted_by(view: &View, cell: CellId) -> Option<usize> {
    let portals = &view.graph.portals_of[cell.0 as usize];
    portals
        .iter()
        .copied()
        .find(|&portal| view.is_outside(portal, cell) && view.graph.bounds(portal, cell))
}

/// These cells, and those that the eye belongs to as well because it is in a closed portal.
fn closure(view: &View, mut cells: Vec<CellId>) -> Vec<CellId> {
    cells.sort_unstable();
    cells.dedup();
    let mut next = 0;
    while let Some(&cell) = cells.get(next) {
        for &portal in &view.graph.portals_of[cell.0 as usize] {
            let beyond = view.graph.beyond(portal, cell);
            if !cells.contains(&beyond) && view.is_in_portal(portal) {
                cells.push(beyond);
            }
        }
        next += 1;
    }
    cells.sort_unstable();
    cells
}
