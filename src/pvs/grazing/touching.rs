//! The lines that touch the sequences of a walk, on whatever grids their portals have.
//!
//! A line is found on the grid of its sequence and asked about a portal on the portal's own; where
//! the graph has a common grid both are that one, and nothing is ever converted.

use super::super::arena::{Arena, Directed};
use crate::num::Int;
use crate::stab::{ClosedPortal, TouchingLine};

/// A portal and the number of its units in one world unit.
struct GridPortal {
    portal: ClosedPortal,
    denominator: Int,
}

/// A line that touches a sequence, and the number of its units in one world unit.
#[derive(Clone)]
pub(super) struct GridLine {
    line: TouchingLine,
    denominator: Int,
}

impl GridLine {
    /// The same line in world units: its vector's rational part, the factor of the root, and the
    /// radicand.
    pub fn in_world(&self) -> ([Int; 6], [Int; 6], Int) {
        self.line.on_grid(&self.denominator, &Int::from(1)).vector()
    }
}

/// The portals of a graph as touching lines are checked against them.
pub(super) struct Touching<'a> {
    arena: &'a Arena,
    portals: Vec<GridPortal>,
}

impl<'a> Touching<'a> {
    pub fn new(arena: &'a Arena) -> Touching<'a> {
        let all: Vec<Directed> = (0..arena.directed()).collect();
        let of = |path: &[Directed]| {
            let (portals, denominator) = arena.exact_portals(path);
            portals.into_iter().map(move |portal| GridPortal {
                portal: ClosedPortal::new(&portal),
                denominator: denominator.clone(),
            })
        };
        let portals = match arena.grid().is_common() {
            true => of(&all).collect(),
            false => all.chunks(1).flat_map(of).collect(),
        };
        Touching { arena, portals }
    }

    /// Whether a line touches a portal.
    pub fn touches(&self, line: &GridLine, portal: Directed) -> bool {
        let GridPortal { portal, denominator } = &self.portals[portal as usize];
        match line.denominator == *denominator {
            true => line.line.touches(portal),
            false => line.line.on_grid(&line.denominator, denominator).touches(portal),
        }
    }

    /// A line that touches the whole path.
    pub fn line(&self, path: &[Directed]) -> Option<GridLine> {
        let on_grids = |&portal: &Directed| &self.portals[portal as usize];
        let denominator = path.first().map(on_grids)?.denominator.clone();
        if path.iter().map(on_grids).all(|portal| portal.denominator == denominator) {
            let portals: Vec<&ClosedPortal> =
                path.iter().map(on_grids).map(|portal| &portal.portal).collect();
            return TouchingLine::of(&portals).map(|line| GridLine { line, denominator });
        }
        let (portals, denominator) = self.arena.exact_portals(path);
        let portals: Vec<ClosedPortal> = portals.iter().map(|p| ClosedPortal::new(p)).collect();
        let portals: Vec<&ClosedPortal> = portals.iter().collect();
        TouchingLine::of(&portals).map(|line| GridLine { line, denominator })
    }
}
