//! Random floorplans with every kind of degeneracy, and points to look from.

use num_traits::Zero;
use stabline::eye::plan::ViewCone;
use stabline::num::{Number, Rational};
use stabline::oracle::Random;
use stabline::portal::plan::{PlanCells, cells_of_plan};
use stabline::report::Silent;
use stabline::scene::plan::{Plan, RawPlan, RawSegment};
use stabline::subdivision::plan::{PlanMethod, divide};

pub type Point = [Rational; 2];

/// What is special about a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Axial walls on a small grid, overlapping and touching by themselves.
    Axial,
    /// Walls of any direction on a small grid.
    Oblique,
    /// Many walls that end at one of two points, or pass through them.
    Star,
    /// Walls on few lines, which overlap, touch and leave gaps.
    Gaps,
    /// Walls trillions of units long that are all but parallel.
    Sliver,
    /// Ends in thirds and sevenths.
    Ratios,
}

impl Kind {
    pub const ALL: [Kind; 6] =
        [Kind::Axial, Kind::Oblique, Kind::Star, Kind::Gaps, Kind::Sliver, Kind::Ratios];
}

/// How many units of a plan of this kind are one step of its lattice.
fn unit(kind: Kind) -> i64 {
    if kind == Kind::Sliver { 1_099_511_627_791 } else { 1 }
}

/// The walls of a plan, 12 steps wide.
pub fn walls(kind: Kind, random: &mut Random) -> Vec<[Point; 2]> {
    let count = random.between(1, 12);
    let step = |random: &mut Random| ratio(random.between(0, 12) * unit(kind), 1);
    let mut walls = Vec::new();
    for _ in 0..count {
        let a = [step(random), step(random)];
        let b = [step(random), step(random)];
        walls.push(match kind {
            Kind::Axial if random.one_in(2) => [a.clone(), [a[0].clone(), b[1].clone()]],
            Kind::Axial => [a.clone(), [b[0].clone(), a[1].clone()]],
            Kind::Oblique => [a, b],
            Kind::Star => {
                let [x, y] = if random.one_in(2) { [5, 5] } else { [8, 4] };
                let hub = [ratio(x, 1), ratio(y, 1)];
                let opposite = [0, 1].map(|i| &hub[i] * ratio(2, 1) - &a[i]);
                let to = if random.one_in(2) { hub } else { opposite };
                [a, to]
            }
            Kind::Gaps => {
                let along = ratio(random.between(1, 3) * 3, 1);
                match random.between(1, 3) {
                    1 => [[a[0].clone(), along.clone()], [b[0].clone(), along]],
                    2 => [[along.clone(), a[1].clone()], [along, b[1].clone()]],
                    _ => [[a[0].clone(), a[0].clone()], [b[0].clone(), b[0].clone()]],
                }
            }
            Kind::Sliver => {
                let shift = |random: &mut Random| ratio(random.between(-1, 1), 1);
                let end = [&a[0] + ratio(6 * unit(kind), 1), &a[1] + shift(random)];
                [[&a[0] + shift(random), a[1].clone()], end]
            }
            Kind::Ratios => {
                let part = |random: &mut Random| ratio(random.between(0, 36), 3);
                let seventh = |random: &mut Random| ratio(random.between(0, 84), 7);
                [[part(random), seventh(random)], [seventh(random), part(random)]]
            }
        });
    }
    // One of no length hides nothing.
    walls.retain(|[a, b]| a != b);
    walls
}

/// A plan of these walls in a box around them, or in one that cuts them, with its cells.
pub fn plan(kind: Kind, walls: &[[Point; 2]], random: &mut Random) -> Option<(Plan, PlanCells)> {
    let corner = |x: i64| [ratio(x * unit(kind), 1), ratio(x * unit(kind), 1)];
    let view = match random.between(1, 3) {
        1 => None,
        2 => Some([corner(-1), corner(14)]),
        _ => Some([corner(2), corner(11)]),
    };
    let method = match kind {
        Kind::Axial if random.one_in(2) => PlanMethod::Kd { threshold: ratio(0, 1) },
        _ => PlanMethod::Bsp,
    };
    (!walls.is_empty()).then(|| divided(walls, view, &method))
}

/// A plan of these walls, with its cells.
pub fn divided(
    walls: &[[Point; 2]],
    view: Option<[Point; 2]>,
    method: &PlanMethod,
) -> (Plan, PlanCells) {
    let number = |point: &Point| point.clone().map(Number::from);
    let opaque =
        |ends: &[Point; 2]| RawSegment { ends: ends.each_ref().map(number), is_opaque: true };
    let raw = RawPlan {
        segments: walls.iter().map(opaque).collect(),
        view: view.map(|view| view.each_ref().map(number)),
        ..RawPlan::default()
    };
    let plan = Plan::from_raw(&raw).unwrap();
    let tree = divide(&plan, method, &Silent).unwrap();
    let cells = cells_of_plan(&plan, tree, false).unwrap();
    (plan, cells)
}

/// A point to look from: on the lattice, off it, or on a portal of the plan.
pub fn eye(kind: Kind, plan: &Plan, cells: &PlanCells, random: &mut Random) -> Point {
    let grid = Rational::from(plan.grid.clone());
    let graph = &cells.graph;
    let end = |point: u32| graph.points.get(point).coordinates().map(|c| c / &grid);
    match random.between(1, 5) {
        1 | 2 => [(); 2].map(|()| ratio(random.between(0, 26) * unit(kind), 2)),
        3 => [(); 2].map(|()| ratio(random.between(0, 13 * 97) * unit(kind), 97)),
        // On a portal: at an end, or part of the way.
        _ if !graph.portals.is_empty() => {
            let last = graph.portals.len() as i64 - 1;
            let portal = graph.portals[random.between(0, last) as usize];
            let [a, b] = [end(portal.left), end(portal.right)];
            let t = ratio(random.between(0, 3), 3);
            [0, 1].map(|i| &a[i] + &t * (&b[i] - &a[i]))
        }
        _ => [ratio(6 * unit(kind), 1), ratio(5 * unit(kind), 1)],
    }
}

/// A view cone of some direction and angle.
pub fn cone(random: &mut Random) -> ViewCone {
    let look = loop {
        let look = [(); 2].map(|()| ratio(random.between(-3, 3), 1));
        if !look.iter().all(Zero::is_zero) {
            break look;
        }
    };
    let halves = [ratio(1, 1), ratio(1, 3), ratio(5, 2), ratio(1, 50), ratio(1000, 7)];
    ViewCone::new(&look, &halves[random.between(0, 4) as usize]).unwrap()
}

pub fn ratio(p: i64, q: i64) -> Rational {
    Rational::new(p.into(), q.into())
}
