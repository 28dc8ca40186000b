//! Cell-to-object visibility of random worlds against brute force.
//!
//! The twin knows nothing of trees and bounds: it clips boxes and cells by each other's planes, in
//! rationals, walks every sequence of cells that repeats none, and decides each sequence with each
//! face of the part of a box in the last cell by the oracle.

mod support;

use num_traits::{Signed, Zero};
use stabline::geom::{AxialBox, RationalPoint3};
use stabline::num::{Int, Rational};
use stabline::oracle::{Random, on_common_grid, open_in_order};
use stabline::portal::{Population, WorldCells, cells_of_world};
use stabline::pvs;
use stabline::report::{Silent, Verdict};
use stabline::scene::world::{Inside, Mark, Object, Place, World, WorldPolygon, WorldSolid};
use stabline::scene::{CellId, CellOrder, ObjectGraph};
use stabline::subdivision::Options;
use std::collections::BTreeSet;
use support::boxes::{
    Half, Point, axial, clip, corner, cube, half_spaces, is_free, mean, minus, oriented,
    planes_of_cell, rational, spans_volume, vertices, with_area,
};

/// Boxes that occlude, some with a cut corner, and detail boxes, on so small a grid that they
/// touch and cover each other.
fn random_world(random: &mut Random, solids: i64, objects: i64, size: i64) -> World {
    let place = || Place { name: "box".to_owned(), line: None };
    let solid = |random: &mut Random| {
        let low = [(); 3].map(|()| random.between(0, size - 2));
        let high = low.map(|low| low + random.between(1, 3));
        WorldSolid { planes: cube(low, high, random), place: place() }
    };
    let object = |random: &mut Random| {
        // Every other box has corners on the grid of the solids.
        let grid = if random.one_in(2) { 1 } else { 3 };
        let low = [(); 3].map(|()| random.between(-grid, (size - 1) * grid));
        let high = low.map(|low| low + random.between(1, 3 * grid));
        let scaled = |c: i64| Rational::new(Int::from(c), Int::from(grid));
        Object { bounds: AxialBox { low: low.map(scaled), high: high.map(scaled) }, place: place() }
    };
    World {
        solids: (0..solids).map(|_| solid(random)).collect(),
        polygons: Vec::new(),
        hints: Vec::new(),
        objects: (0..objects).map(|_| object(random)).collect(),
        inside: Inside::Everywhere,
        view: None,
    }
}

/// A closed house of three rooms in a row with offset doors, and detail boxes in rooms, doors and
/// walls. Two posts and a lintel make a wall.
fn random_house(random: &mut Random, objects: i64) -> World {
    let mut world = random_world(random, 0, objects, 4);
    let place = || Place { name: "wall".to_owned(), line: None };
    let mut add = |low: [i64; 3], high: [i64; 3]| {
        let planes = axial(low, high);
        world.solids.push(WorldSolid { planes, place: place() });
    };
    for x in [3, 6] {
        let left = random.between(1, 3);
        let right = left + random.between(1, 4 - left);
        add([x, 0, 0], [x + 1, left, 3]);
        add([x, right, 0], [x + 1, 5, 3]);
        add([x, left, random.between(1, 2)], [x + 1, right, 3]);
    }
    for (low, high) in [
        ([-1, -1, -1], [11, 6, 0]),
        ([-1, -1, 3], [11, 6, 4]),
        ([-1, -1, 0], [0, 6, 3]),
        ([10, -1, 0], [11, 6, 3]),
        ([0, -1, 0], [10, 0, 3]),
        ([0, 5, 0], [10, 6, 3]),
    ] {
        add(low, high);
    }
    for object in &mut world.objects {
        let by = random.between(0, 8);
        object.bounds.low[0] += rational(by);
        object.bounds.high[0] += rational(by);
    }
    let half = Rational::new(Int::from(1), Int::from(2));
    let point = RationalPoint3::from(&[half.clone(), half.clone(), half]);
    world.inside = Inside::Reached(vec![Mark { point, place: place() }]);
    world
}

/// A polygon that covers a part of the face of an object that looks back along the x axis.
fn flush_polygon(object: &Object) -> WorldPolygon {
    let AxialBox { low, high } = &object.bounds;
    let middle = (&low[1] + &high[1]) / Int::from(2);
    let corner = |y: &Rational, z: Rational| [low[0].clone(), y.clone(), z];
    let [below, above] = [&low[2] - rational(1), &high[2] + rational(1)];
    let vertices = [
        corner(&middle, below.clone()),
        corner(&high[1], below),
        corner(&high[1], above.clone()),
        corner(&middle, above),
    ];
    let place = Place { name: "panel".to_owned(), line: None };
    WorldPolygon { vertices: vertices.iter().map(RationalPoint3::from).collect(), place }
}

/// A world of the one kind or the other.
fn either(seed: u64, solids: i64, objects: i64, size: i64) -> World {
    let random = &mut Random::new(seed);
    match seed % 2 {
        0 => random_world(random, solids, objects, size),
        _ => random_house(random, objects),
    }
}

/// A world with its cells, its population and what sees what.
struct Answer {
    world: World,
    cells: WorldCells,
    graph: ObjectGraph,
    population: Population,
    seen: Vec<Vec<Verdict>>,
    sights: Vec<pvs::ObjectSight>,
}

impl Answer {
    fn of(world: World) -> Answer {
        let mut cells = cells_of_world(&world, &Options::default()).unwrap();
        let population = Population::of(&world.objects, &mut cells);
        let graph = population.graph(&world.objects, &cells.graph).unwrap();
        let rows =
            pvs::compute(&cells.graph, &pvs::Options::default(), Vec::new(), &|_| {}, &Silent).rows;
        let known = pvs::assemble(&cells.graph, &rows);
        let found = pvs::compute_objects(&graph, &known, None, &Silent);
        assert!(found.is_complete);
        let seen = pvs::assemble_objects(&graph, &found.rows);
        let sights = pvs::object_sights(&graph, &found.rows);
        Answer { world, cells, graph, population, seen, sights }
    }

    fn planes_of(&self, cell: CellId) -> Vec<Half> {
        planes_of_cell(&self.cells, cell)
    }
}

/// The twin of a whole world.
struct Twin<'a> {
    answer: &'a Answer,
    /// The planes of each cell, and its faces in the same order.
    cells: Vec<(Vec<Half>, Vec<Vec<Point>>)>,
    boxes: Vec<Vec<Half>>,
    path: Vec<Vec<RationalPoint3>>,
    crossed: Vec<CellId>,
    seen: Vec<bool>,
}

impl Twin<'_> {
    fn new(answer: &Answer) -> Twin<'_> {
        let cell = |index: u32| {
            let leaf = answer.cells.subdivision.leaf(answer.cells.leaves[index as usize]);
            let faces = leaf.cell.faces().iter();
            let points =
                |p: Vec<RationalPoint3>| p.iter().map(RationalPoint3::coordinates).collect();
            let faces = faces.map(|face| points(face.points())).collect();
            (answer.planes_of(CellId(index)), faces)
        };
        let boxes = answer.world.objects.iter().map(|object| half_spaces(&object.bounds));
        Twin {
            answer,
            cells: (0..answer.graph.cells).map(cell).collect(),
            boxes: boxes.collect(),
            path: Vec::new(),
            crossed: Vec::new(),
            seen: Vec::new(),
        }
    }

    /// The faces of the part of an object in a cell, counter-clockwise as seen from inside of it,
    /// and whether they lie in the cell's boundary.
    fn part(&self, object: usize, cell: CellId) -> Vec<(bool, Vec<Point>)> {
        let ((planes, faces), sides) = (&self.cells[cell.0 as usize], &self.boxes[object]);
        let of_cell = faces.iter().map(|face| (true, clip(face.clone(), sides)));
        let inside = sides.iter().filter(|side| !planes.iter().any(|plane| plane.is_same(side)));
        let bounds = &self.answer.world.objects[object].bounds;
        let of_box = inside.map(|side| (false, clip(side.face_of(bounds), planes)));
        let all: Vec<_> = of_cell.chain(of_box).filter(|(_, face)| with_area(face)).collect();
        match spans_volume(all.iter().flat_map(|(_, face)| face)) {
            false => Vec::new(),
            true => {
                let center = mean(all.iter().flat_map(|(_, face)| face));
                all.into_iter().map(|(flush, face)| (flush, oriented(face, &center))).collect()
            }
        }
    }

    fn row(&mut self, source: CellId) -> &[bool] {
        let held = |object| !self.part(object, source).is_empty();
        self.seen = (0..self.boxes.len()).map(held).collect();
        self.enter(source);
        &self.seen
    }

    fn enter(&mut self, cell: CellId) {
        self.crossed.push(cell);
        for object in 0..self.boxes.len() {
            if !self.seen[object] && !self.path.is_empty() {
                self.seen[object] =
                    self.part(object, cell).into_iter().any(|face| self.enters(face));
            }
        }
        let graph = &self.answer.cells.graph;
        for portal in &graph.portals {
            let mut polygon: Vec<_> = graph.corners(portal).cloned().collect();
            let next = match (portal.from == cell, portal.to == cell) {
                (true, _) => portal.to,
                (_, true) => portal.from,
                _ => continue,
            };
            if portal.to == cell {
                polygon.reverse();
            }
            if self.crossed.contains(&next) || self.seen.iter().all(|&seen| seen) {
                continue;
            }
            self.path.push(polygon);
            if self.is_open() {
                self.enter(next);
            }
            self.path.pop();
        }
        self.crossed.pop();
    }

    /// Whether a line through the path enters by this face of a part in the last cell. In the
    /// cell's boundary it can only be what the last portal and the face have in common.
    fn enters(&mut self, (flush, face): (bool, Vec<Point>)) -> bool {
        let before = self.path.clone();
        let mut face = face;
        if flush {
            let last: Vec<Point> =
                before[before.len() - 1].iter().map(RationalPoint3::coordinates).collect();
            let support = Half::of_polygon(&last);
            if !face.iter().all(|point| support.excess(point).is_zero()) {
                return false;
            }
            face = clip(face, &support.fences(&last));
            if !with_area(&face) {
                return false;
            }
            self.path.pop();
        }
        self.path.push(face.iter().map(RationalPoint3::from).collect());
        let open = self.is_open();
        self.path = before;
        open
    }

    fn is_open(&self) -> bool {
        let path: Vec<&[RationalPoint3]> = self.path.iter().map(Vec::as_slice).collect();
        open_in_order(&on_common_grid(&path).1).is_some()
    }
}

#[test]
fn pieces_are_the_feasible_programs_with_their_vertices() {
    let (mut pieces, mut none) = (0, 0);
    for seed in 500..508 {
        let answer = Answer::of(either(seed, 3, 4, 6));
        let mut found = answer.population.pieces.iter().peekable();
        for (object, stated) in (0..).zip(&answer.world.objects) {
            for cell in (0..answer.graph.cells).map(CellId) {
                let mut halves = answer.planes_of(cell);
                halves.extend(half_spaces(&stated.bounds));
                let expected = vertices(&halves);
                let piece = found.next_if(|piece| (piece.object, piece.cell) == (object, cell));
                assert_eq!(piece.is_some(), spans_volume(expected.iter()), "seed {seed}");
                let Some(piece) = piece else {
                    none += 1;
                    continue;
                };
                let corners = piece.solid.faces().iter().flat_map(|face| face.points());
                let corners: BTreeSet<Point> = corners.map(|point| point.coordinates()).collect();
                assert_eq!(corners, expected, "seed {seed}: {object} in {cell:?}");
                pieces += 1;
            }
        }
        assert!(found.next().is_none(), "seed {seed}");
    }
    println!("{pieces} pieces, {none} programs without a solution");
    assert!(pieces > 50 && none > pieces);
}

#[test]
fn cells_see_the_objects_that_brute_force_sees() {
    let (mut seen, mut unseen, mut held) = (0, 0, 0);
    for seed in 0..32 {
        let mut world = either(seed, 1 + (seed as i64 / 2) % 2, 3, 4);
        if seed % 3 == 0 {
            world.polygons.push(flush_polygon(&world.objects[0]));
        }
        let answer = Answer::of(world);
        if answer.graph.cells > 14 {
            continue;
        }
        let mut twin = Twin::new(&answer);
        for cell in (0..answer.graph.cells).map(CellId) {
            for object in 0..answer.world.objects.len() {
                let holds = answer.graph.held_by[object].contains(&cell);
                assert_eq!(holds, !twin.part(object, cell).is_empty(), "seed {seed}: {cell:?}");
                held += usize::from(holds);
            }
            for (object, &expected) in twin.row(cell).iter().enumerate() {
                let expected = if expected { Verdict::Open } else { Verdict::NotOpen };
                let found = answer.seen[object][cell.0 as usize];
                assert_eq!(found, expected, "seed {seed}: {cell:?}, object {object}");
                seen += usize::from(found == Verdict::Open);
                unseen += usize::from(found == Verdict::NotOpen);
            }
        }
    }
    println!("{seen} pairs seen, {held} of them inside, {unseen} not seen");
    assert!(seen > 2 * held && held > 50 && unseen > 50, "asks nothing");
}

/// A point in the cell of a sight before its first portal, and the last before the object.
fn ends(answer: &Answer, sight: &pvs::ObjectSight) -> [Point; 2] {
    let [p, q] = sight.pair.line.numbers().map(|point| point.map(|c| c.to_rational()));
    let direction = minus(&q, &p);
    let interval = |planes: &[Half]| {
        let (mut from, mut to) = (None::<Rational>, None::<Rational>);
        for plane in planes {
            let (excess, slope) = (plane.excess(&p), plane.along(&direction));
            if slope.is_zero() {
                assert!(excess.is_negative(), "a witness runs in a face");
                continue;
            }
            let at = -excess / &slope;
            if slope.is_positive() {
                to = Some(to.map_or(at.clone(), |to| to.min(at)));
            } else {
                from = Some(from.map_or(at.clone(), |from| from.max(at)));
            }
        }
        let (from, to) = (from.unwrap(), to.unwrap());
        assert!(from < to, "a witness misses its cell or its object");
        (from, to)
    };
    let (cell_in, cell_out) = interval(&answer.planes_of(sight.cell));
    let (object_in, object_out) =
        interval(&half_spaces(&answer.world.objects[sight.object as usize].bounds));
    assert!(cell_out <= object_in, "the witness of a cell that holds a part");
    let at = |t: Rational| [0, 1, 2].map(|i| &p[i] + &t * &direction[i]);
    let half = Rational::new(Int::from(1), Int::from(2));
    // Just inside the object: behind it may be a wall.
    let deep = (object_out - &object_in) / Int::from(1 << 20);
    [at((cell_in + cell_out) * half), at(object_in + deep)]
}

#[test]
fn witnesses_are_free_segments_and_free_segments_are_seen() {
    let (mut joined, mut witnesses) = (0, 0);
    for seed in 100..130 {
        let answer = Answer::of(either(seed, 3 + seed as i64 % 5, 5, 7));
        for sight in &answer.sights {
            let [from, to] = ends(&answer, sight);
            assert!(is_free(&answer.world, &from, &to), "seed {seed}: {sight:?}");
            witnesses += 1;
        }
        for (index, piece) in answer.population.pieces.iter().enumerate() {
            let end = piece.solid.inner_point().coordinates();
            for cell in
                (0..answer.graph.cells).filter(|cell| (*cell as usize + index).is_multiple_of(3))
            {
                let leaf = answer.cells.leaves[cell as usize];
                let start = &answer.cells.subdivision.leaf(leaf).cell;
                let start = mean(&corner(start, index).map(|point| point.coordinates()));
                if is_free(&answer.world, &start, &end) {
                    let verdict = answer.seen[piece.object as usize][cell as usize];
                    assert_eq!(verdict, Verdict::Open, "seed {seed}: cell {cell}, {index}");
                    joined += 1;
                }
            }
        }
    }
    println!("{joined} free segments, {witnesses} witnesses");
    assert!(joined > 500 && witnesses > 1000);
}

#[test]
fn the_bound_rules_out_nothing_that_is_seen_and_convexity_implies_the_order() {
    let (mut exact, mut bound) = (0, 0);
    for seed in 200..220 {
        let answer = Answer::of(either(seed, 7, 5, 7));
        let conservative = pvs::bound_objects(&answer.graph, &Silent).unwrap();
        for (found, left) in answer.seen.iter().flatten().zip(conservative.iter().flatten()) {
            assert!(*found != Verdict::Open || *left != Verdict::NotOpen, "seed {seed}");
            exact += u32::from(*found == Verdict::Open);
            bound += u32::from(*left != Verdict::NotOpen);
        }
        let portals = answer.cells.graph.portals.len() as u32;
        assert_eq!(answer.graph.graph.portals[..portals as usize], answer.cells.graph.portals);
        for [p, q] in CellOrder::new(&answer.graph.graph).pairs() {
            assert!(p.0 >= portals && q.0 >= portals, "seed {seed}: {p:?}, {q:?}");
        }
    }
    println!("{exact} pairs seen, {bound} left by the bound");
    assert!(exact < bound);
}

#[test]
fn a_larger_box_is_seen_from_as_many_cells_or_more() {
    for seed in 300..320 {
        let random = &mut Random::new(seed);
        let world = either(seed, 6, 4, 7);
        let mut larger = world.clone();
        for object in &mut larger.objects {
            let axis = random.between(0, 2) as usize;
            let more = Rational::new(Int::from(random.between(1, 3)), Int::from(2));
            match random.one_in(2) {
                true => object.bounds.low[axis] -= more,
                false => object.bounds.high[axis] += more,
            }
        }
        let (small, large) = (Answer::of(world), Answer::of(larger));
        for (small, large) in small.seen.iter().flatten().zip(large.seen.iter().flatten()) {
            assert!(*small != Verdict::Open || *large == Verdict::Open, "seed {seed}");
        }
    }
}

#[test]
fn another_occluder_opens_nothing() {
    let mut kept = 0;
    for seed in 400..420 {
        let after = either(seed, 5, 4, 6);
        // Of a house, the first lintel.
        let mut before = after.clone();
        before.solids.remove(2);
        let (before, after) = (Answer::of(before), Answer::of(after));
        let sees = |object: u32, point: &Point| {
            let located = before.cells.subdivision.locate(&point.into());
            located.iter().any(|leaf| {
                let cell = before.cells.leaves.binary_search(leaf);
                cell.is_ok_and(|cell| before.seen[object as usize][cell] == Verdict::Open)
            })
        };
        for sight in &after.sights {
            let [from, _] = ends(&after, sight);
            // Where the solid is gone the box to be divided may be smaller.
            if before.cells.subdivision.locate(&(&from).into()).is_empty() {
                continue;
            }
            assert!(sees(sight.object, &from), "seed {seed}: {sight:?}");
            kept += 1;
        }
        for piece in &after.population.pieces {
            let point = piece.solid.inner_point();
            if !before.cells.subdivision.locate(&point).is_empty() {
                assert!(sees(piece.object, &point.coordinates()), "seed {seed}");
            }
        }
    }
    assert!(kept > 300, "{kept}");
}

#[test]
fn a_box_flush_with_a_portal_is_seen_through_it() {
    let place = || Place { name: "x".to_owned(), line: None };
    let solid = |low, high| WorldSolid { planes: axial(low, high), place: place() };
    let object = |low: [i64; 3], high: [i64; 3]| Object {
        bounds: AxialBox { low: low.map(rational), high: high.map(rational) },
        place: place(),
    };
    // Two posts leave a door from y = 0 to 2 at x = 4; its plane divides the space.
    let world = World {
        solids: vec![
            solid([4, -4, 0], [6, 0, 4]),
            solid([4, 2, 0], [6, 8, 4]),
            solid([0, -4, -1], [10, 8, 0]),
            solid([0, -4, 4], [10, 8, 5]),
        ],
        polygons: Vec::new(),
        hints: Vec::new(),
        objects: vec![
            object([4, 0, 1], [5, 2, 2]),
            object([3, 0, 1], [4, 2, 2]),
            object([4, 0, 0], [6, 2, 4]),
            object([4, -3, 1], [5, -1, 2]),
        ],
        inside: Inside::Everywhere,
        view: None,
    };
    let answer = Answer::of(world);
    let at = |x: i64, y: i64| {
        let point = RationalPoint3::from(&[x, y, 2].map(rational));
        let leaf = answer.cells.subdivision.locate(&point)[0];
        answer.cells.leaves.binary_search(&leaf).unwrap()
    };
    let (front, back) = (at(2, 1), at(8, 1));
    for object in 0..3 {
        assert_eq!(answer.seen[object][front], Verdict::Open, "{object}");
        assert_eq!(answer.seen[object][back], Verdict::Open, "{object}");
    }
    // The last is inside a post.
    assert_eq!(answer.population.nowhere, [3]);
    assert!(answer.seen[3].iter().all(|verdict| *verdict == Verdict::NotOpen));
    // The third fills the door: each way in lies in a portal, and is entered from the next cell.
    let entries = answer.population.entries.iter().filter(|entry| entry.object == 2);
    let held = &answer.graph.held_by[2];
    assert!(entries.clone().count() > 0 && entries.clone().all(|e| !held.contains(&e.cell)));
}
