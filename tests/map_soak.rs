//! Odd levels' sources from text to visibility: slivers, nearly collinear points, far coordinates,
//! long decimals, brushes that lie flush, nest, overlap, repeat, have no volume or no end, and
//! entities on walls.
//!
//! Whatever the text, the result is a level with warnings and cells, or an error; leaves tile the
//! box, portals lie between their leaves and in no solid, and sightlines miss every solid.
//!
//! `STABLINE_WORLDS=N` sets the number of levels, `STABLINE_SEED=S` the first seed.

mod support;

use stabline::geom::RationalPoint3;
use stabline::num::Rational;
use stabline::oracle::{Occluders, Random};
use stabline::portal::{WorldCells, WorldError, cells_of_world};
use stabline::pvs;
use stabline::report::Silent;
use stabline::scene::{LevelOptions, World, read_level};
use stabline::subdivision;
use std::fmt::Write;
use support::graphs::integer;

/// Coordinates in ten-thousandths of a unit.
type Point = [i64; 3];
const UNIT: i64 = 10_000;
/// The most cells whose visibility is computed.
const MOST_CELLS: usize = 60;

/// A level's source in the making.
struct Source {
    random: Random,
    text: String,
    /// The middle of everything.
    place: Point,
    /// Boxes made so far.
    boxes: Vec<[Point; 2]>,
}

impl Source {
    fn level(seed: u64) -> String {
        let mut random = Random::new(seed);
        let far = [0, 0, 1 << 20, -(1 << 20)][random.between(0, 3) as usize];
        let place = [far, [0, far][random.between(0, 1) as usize], 0].map(|c| c * UNIT);
        let text = "{\n\"classname\" \"worldspawn\"\n".to_owned();
        let mut source = Source { random, text, place, boxes: Vec::new() };
        if !source.random.one_in(4) {
            source.room();
        }
        for _ in 0..source.random.between(1, 9) {
            source.brush();
        }
        source.text.push_str("}\n");
        source.entities();
        source.text
    }

    /// A closed room, 256 units wide.
    fn room(&mut self) {
        for axis in 0..3 {
            for (low, high) in [(-144, -128), (128, 144)] {
                let mut ends = [[-144; 3], [144; 3]];
                (ends[0][axis], ends[1][axis]) = (low, high);
                let ends = ends.map(|end| [0, 1, 2].map(|i| self.place[i] + end[i] * UNIT));
                self.cuboid(ends, "wall");
            }
        }
    }

    fn entities(&mut self) {
        for _ in 0..self.random.between(1, 3) {
            // On a grid of 16 units, so that some stand on walls and some in them.
            let origin = [0, 1, 2].map(|i| self.place[i] + self.random.between(-9, 9) * 16 * UNIT);
            let origin = origin.map(decimal).join(" ");
            let class = ["info_player_start", "light"][self.random.between(0, 1) as usize];
            writeln!(self.text, "{{\n\"classname\" \"{class}\"\n\"origin\" \"{origin}\"\n}}")
                .unwrap();
        }
        if self.random.one_in(2) {
            let class =
                ["func_detail", "func_wall", "func_group"][self.random.between(0, 2) as usize];
            writeln!(self.text, "{{\n\"classname\" \"{class}\"").unwrap();
            self.brush();
            self.text.push_str("}\n");
        }
    }

    fn texture(&mut self) -> &'static str {
        const SELDOM: [&str; 6] = ["clip", "hint", "skip", "sky1", "*water", "trigger"];
        match self.random.one_in(6) {
            true => SELDOM[self.random.between(0, 5) as usize],
            false => "wall",
        }
    }

    fn brush(&mut self) {
        let texture = self.texture();
        match self.random.between(0, 9) {
            0..=2 => {
                let ends = self.ends();
                self.cuboid(ends, texture);
            }
            3 => {
                // Flush with a box, nested in it, or the same again.
                let of = self.random.between(0, self.boxes.len().max(1) as i64 - 1) as usize;
                let Some(&[low, high]) = self.boxes.get(of) else { return };
                let axis = self.random.between(0, 2) as usize;
                let (mut near, mut far) = (low, high);
                match self.random.between(0, 2) {
                    0 => (near[axis], far[axis]) = (high[axis], 2 * high[axis] - low[axis]),
                    1 => far[axis] = low[axis] + (high[axis] - low[axis]) / 3,
                    _ => {}
                }
                self.cuboid([near, far], texture);
            }
            4 => {
                // A sheet, down to a thousandth of a unit, or without volume.
                let mut ends = self.ends();
                let axis = self.random.between(0, 2) as usize;
                ends[1][axis] = ends[0][axis] + [0, 1, 10, 333][self.random.between(0, 3) as usize];
                self.cuboid(ends, texture);
            }
            5..=6 => self.cut(texture, 1),
            7..=8 => self.cut(texture, 3000),
            _ => self.odd(texture),
        }
    }

    /// Two corners of a box in or about the room.
    fn ends(&mut self) -> [Point; 2] {
        let step = [16 * UNIT, UNIT, 1][self.random.between(0, 2) as usize];
        let reach = 128 * UNIT / step;
        let spans = self.place.map(|place| {
            let low = self.random.between(-reach, reach);
            let high = low + self.random.between(1, 1 + reach);
            [low, high].map(|end| place + end * step)
        });
        [0, 1].map(|end| spans.map(|span| span[end]))
    }

    fn cuboid(&mut self, [low, high]: [Point; 2], texture: &str) {
        self.boxes.push([low, high]);
        let faces = box_faces([low, high]);
        self.write(&faces, texture);
    }

    /// A box less what is beyond planes through points of it, `step` apart or more.
    fn cut(&mut self, texture: &str, step: i64) {
        let ends = self.ends();
        let middle = [0, 1, 2].map(|i| (ends[0][i] + ends[1][i]) / 2);
        let mut faces = box_faces(ends);
        for _ in 0..self.random.between(1, 5) {
            let mut corner = || -> Point {
                std::array::from_fn(|i| {
                    let steps = (ends[1][i] - ends[0][i]) / step;
                    ends[0][i] + step * self.random.between(0, steps)
                })
            };
            let mut face = [corner(), corner(), corner()];
            if self.random.one_in(3) {
                // Nearly collinear.
                let [p, q, _] = face;
                face[2] = [0, 1, 2].map(|i| 2 * q[i] - p[i]);
                face[2][self.random.between(0, 2) as usize] += 1;
            }
            if height(&face, &middle) > 0 {
                face.swap(0, 2);
            }
            faces.push(face);
        }
        self.write(&faces, texture);
    }

    /// Faces missing, turned over, repeated or without a plane.
    fn odd(&mut self, texture: &str) {
        let mut faces = box_faces(self.ends());
        let at = self.random.between(0, 5) as usize;
        match self.random.between(0, 4) {
            0 => drop(faces.remove(at)),
            1 => faces.truncate(3),
            2 => faces[at].swap(0, 2),
            3 => faces.push(faces[at]),
            _ => faces[at][1] = faces[at][0],
        }
        self.write(&faces, texture);
    }

    fn write(&mut self, faces: &[[Point; 3]], texture: &str) {
        self.text.push_str("{\n");
        let long = self.random.one_in(8);
        for face in faces {
            for point in face {
                let mut coordinates = point.map(decimal);
                if long && coordinates[0].contains('.') {
                    coordinates[0].push_str("000000000001");
                }
                write!(self.text, "( {} ) ", coordinates.join(" ")).unwrap();
            }
            writeln!(self.text, "{texture} 0 0 0 1 1").unwrap();
        }
        self.text.push_str("}\n");
    }
}

/// Ten-thousandths as a decimal.
fn decimal(value: i64) -> String {
    let (whole, rest) = (value.abs() / UNIT, value.abs() % UNIT);
    let sign = if value < 0 { "-" } else { "" };
    match rest {
        0 => format!("{sign}{whole}"),
        _ => format!("{sign}{whole}.{rest:04}"),
    }
}

/// Three points on each side of a box, clockwise as seen from outside.
fn box_faces([low, high]: [Point; 2]) -> Vec<[Point; 3]> {
    let face = |axis: usize, at: i64, turned: bool| {
        let mut points = [low; 3];
        points[1][(axis + 2) % 3] = high[(axis + 2) % 3];
        points[2][(axis + 1) % 3] = high[(axis + 1) % 3];
        points.iter_mut().for_each(|point| point[axis] = at);
        if turned {
            points.swap(1, 2);
        }
        points
    };
    (0..3).flat_map(|axis| [face(axis, low[axis], true), face(axis, high[axis], false)]).collect()
}

/// How far a point is beyond a face, in units of the face's own.
fn height([p, q, r]: &[Point; 3], point: &Point) -> i128 {
    let [a, b, c] = [p, r, point].map(|x| [0, 1, 2].map(|i| i128::from(x[i] - q[i])));
    c[0] * (a[1] * b[2] - a[2] * b[1])
        + c[1] * (a[2] * b[0] - a[0] * b[2])
        + c[2] * (a[0] * b[1] - a[1] * b[0])
}

/// Tells which case panicked.
struct Case(u64);

impl Drop for Case {
    fn drop(&mut self) {
        if std::thread::panicking() {
            eprintln!("seed {}:\n{}", self.0, Source::level(self.0));
        }
    }
}

/// What came of the levels.
#[derive(Debug, Default)]
struct Outcome {
    cells: usize,
    leaks: usize,
    refused: usize,
    warnings: usize,
    sightlines: usize,
}

fn check(text: &str, outcome: &mut Outcome) {
    let level = read_level("soak", text.as_bytes(), LevelOptions::default()).unwrap();
    outcome.warnings += level.warnings.len();
    let world = World::of_level(&level);
    let cells = match cells_of_world(&world, &subdivision::Options::default()) {
        Ok(cells) => cells,
        Err(WorldError::Leak { leak, .. }) => {
            assert_eq!(leak.path.len(), leak.leaves.len() + 1);
            outcome.leaks += 1;
            return;
        }
        Err(WorldError::AllBuried(_) | WorldError::Division(_)) => {
            outcome.refused += 1;
            return;
        }
        Err(error) => panic!("{error}"),
    };
    outcome.cells += cells.leaves.len();
    let mut occluders = Occluders::default();
    world.solids.iter().for_each(|solid| occluders.add_solid(&solid.planes));
    check_division(&cells, &occluders);
    if cells.leaves.len() <= MOST_CELLS {
        outcome.sightlines += check_sightlines(&cells, &occluders);
    }
}

fn check_division(cells: &WorldCells, occluders: &Occluders) {
    let division = &cells.subdivision;
    assert!(division.flat.is_empty(), "a level's brushes have volume");
    let volume: Rational = division.leaves.iter().map(|leaf| leaf.cell.volume()).sum();
    assert_eq!(volume, division.bounds.polyhedron(&division.planes).volume());
    for &leaf in &cells.leaves {
        let inner = division.leaf(leaf).cell.inner_point();
        assert_eq!(division.locate(&inner), [leaf]);
        assert!(occluders.leaves_free(&inner), "{leaf:?} is empty, and its middle is not");
    }
    for portal in &cells.graph.portals {
        let corners: Vec<[Rational; 3]> =
            cells.graph.corners(portal).map(RationalPoint3::coordinates).collect();
        let count = integer(corners.len() as i64);
        let mean = |i: usize| corners.iter().map(|corner| &corner[i]).sum::<Rational>() / &count;
        let middle = RationalPoint3::from(&[0, 1, 2].map(mean));
        let mut between = [portal.from, portal.to].map(|cell| cells.leaves[cell.0 as usize]);
        between.sort_unstable();
        assert_eq!(division.locate(&middle), between, "a portal lies between its cells");
        assert!(occluders.leaves_free(&middle), "a portal's middle is in a solid");
    }
}

/// Every sightline misses every solid between its first and its last portal.
fn check_sightlines(cells: &WorldCells, occluders: &Occluders) -> usize {
    let options = pvs::Options { budget: Some(500), ..pvs::Options::default() };
    let finished = pvs::compute(&cells.graph, &options, Vec::new(), &|_| {}, &Silent);
    let witnesses = pvs::witnesses(&finished.rows);
    for found in &witnesses {
        let line = found.line.in_space().each_ref().map(|p| p.each_ref().map(|c| c.to_rational()));
        let [p, q] = line.map(|point| RationalPoint3::from(&point));
        let ends = [found.from, found.to].map(|cell| {
            let division = &cells.subdivision;
            let faces = division.leaf(cells.leaves[cell as usize]).cell.faces();
            let planes: Vec<_> =
                faces.iter().map(|face| division.planes.plane(face.support()).clone()).collect();
            stabline::oracle::middle_within([&p, &q], &planes).expect("it passes through its cells")
        });
        assert!(occluders.let_see(&ends[0], &ends[1]), "{found:?}");
    }
    witnesses.len()
}

#[test]
fn odd_levels_give_cells_and_sightlines_or_an_error() {
    let setting = |name: &str, default: u64| {
        std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(default)
    };
    let (first, count) = (setting("STABLINE_SEED", 0), setting("STABLINE_WORLDS", 120));
    let mut outcome = Outcome::default();
    // In level 2302 a hint ends where the box ends.
    for seed in (first..first + count).chain([2302]) {
        let case = Case(seed);
        check(&Source::level(seed), &mut outcome);
        drop(case);
    }
    println!("{outcome:?}");
    // Every kind of outcome occurs, or the levels are not odd enough.
    let Outcome { cells, leaks, refused, warnings, sightlines } = outcome;
    assert!(cells > 100 && leaks > 5 && refused > 0 && warnings > 10 && sightlines > 500);
}
