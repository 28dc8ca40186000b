//! Eyes in floorplans, exactly, beside an angular sweep in floats over all walls.
//!
//! `cargo bench --bench eye_plan` prints for plans of growing size how many eyes a second each way
//! answers: the cells that are seen, the same with the polygons seen of each, with their exact area
//! as well, and the area by the sweep, which knows no cells. Both areas are compared at every eye.
//! `-- WALLS` sets about how many walls the largest plan has.
//!
//! A plan is a square grid of rooms; of the walls between two rooms most have a door, some are
//! closed and some are missing. Only walls' ends touch, as the sweep needs.

use num_traits::ToPrimitive;
use stabline::eye::plan::{EyePlan, PlanPlace, ViewCone};
use stabline::num::{Int, Number, Rational};
use stabline::oracle::Random;
use stabline::portal::plan::{PlanCells, cells_of_plan};
use stabline::predicates::PlanPoint;
use stabline::report::Silent;
use stabline::scene::plan::{Plan, RawPlan, RawSegment};
use stabline::subdivision::plan::{PlanMethod, divide};
use std::f64::consts::{PI, TAU};
use std::time::Instant;

const ROOM: i64 = 64;
const EYES: usize = 1000;

type Wall = [[i64; 2]; 2];

fn main() {
    let largest = std::env::args().skip(1).find_map(|argument| argument.parse().ok());
    let largest: i64 = largest.unwrap_or(10_000);
    println!("{EYES} eyes; thousands of eyes a second");
    println!("                          ------ all around ------  ------ 60 degrees -------");
    println!(
        "  walls    cells    sweep    cells  regions     area    cells  regions     area  seen"
    );
    let mut walls = 100;
    while walls <= largest {
        compare(walls);
        walls *= 10;
    }
}

/// One row of the table: a plan of about so many walls.
fn compare(about: i64) {
    let mut random = Random::new(1);
    // A side of s rooms has 2s(s - 1) places for walls inside, with 1.7 walls each on average.
    let side = (2..).find(|s| 2 * s * (s - 1) * 17 / 10 >= about).unwrap();
    let walls = rooms(side, &mut random);
    let (plan, cells) = divided(&walls);
    let eyes = EyePlan::new(&plan, &cells);
    let mut points = Vec::new();
    let mut places: Vec<PlanPlace> = Vec::new();
    while places.len() < EYES {
        let point = [(); 2].map(|()| random.between(1, side * ROOM - 1));
        if let Ok(place) = eyes.place(PlanPoint::integer(point.map(Int::from))) {
            points.push(point.map(|c| c as f64));
            places.push(place);
        }
    }
    let cones: Vec<ViewCone> = places
        .iter()
        .map(|_| {
            let look = [(); 2].map(|()| Rational::from(Int::from(random.between(1, 9))));
            ViewCone::new(&look, &Rational::new(15.into(), 26.into())).unwrap()
        })
        .collect();
    let sweep = Sweep::new(&walls);
    let mut swept = Vec::new();
    let of_sweep = rate(|i| swept.push(sweep.area(points[i])));
    let mut seen = 0;
    let mut of_exact = |cones: Option<&[ViewCone]>| -> ([f64; 3], Vec<f64>) {
        let cone = |i: usize| cones.map(|cones| &cones[i]);
        let of_cells = rate(|i| {
            let view = eyes.view(&places[i], cone(i));
            seen += view.seen_cells(&view.sequences()).len();
        });
        let mut corners = 0;
        let of_regions = rate(|i| {
            let view = eyes.view(&places[i], cone(i));
            let regions = view.regions(&view.sequences());
            corners += regions.iter().map(|region| region.polygon.len()).sum::<usize>();
        });
        let mut areas = Vec::new();
        let of_area = rate(|i| {
            let view = eyes.view(&places[i], cone(i));
            areas.push(view.doubled_area(&view.sequences()));
        });
        let areas = areas.iter().map(|area| area.to_f64().unwrap() / 2.0).collect();
        ([of_cells, of_regions, of_area], areas)
    };
    let (around, areas) = of_exact(None);
    let (in_cone, _) = of_exact(Some(&cones));
    for ((exact, swept), point) in areas.iter().zip(&swept).zip(&points) {
        assert!((exact - swept).abs() <= 1e-6 * exact, "{exact} and {swept} from {point:?}");
    }
    let columns: Vec<String> =
        around.iter().chain(&in_cone).map(|rate| format!("{rate:8.2}")).collect();
    println!(
        "{:>7} {:>8} {of_sweep:8.2} {} {:5.1}",
        walls.len(),
        cells.graph.cells.len(),
        columns.join(" "),
        seen as f64 / (2 * EYES) as f64,
    );
}

/// Thousands of eyes a second.
fn rate(mut look: impl FnMut(usize)) -> f64 {
    let start = Instant::now();
    (0..EYES).for_each(&mut look);
    EYES as f64 / start.elapsed().as_secs_f64() / 1000.0
}

fn rooms(side: i64, random: &mut Random) -> Vec<Wall> {
    let end = side * ROOM;
    let mut walls = vec![
        [[0, 0], [end, 0]],
        [[end, 0], [end, end]],
        [[end, end], [0, end]],
        [[0, end], [0, 0]],
    ];
    for i in 1..side {
        for j in 0..side {
            for upright in [false, true] {
                let at = |along: i64| {
                    let point = [j * ROOM + along, i * ROOM];
                    if upright { [point[1], point[0]] } else { point }
                };
                match random.between(1, 10) {
                    1 => {}
                    2 => walls.push([at(0), at(ROOM)]),
                    _ => {
                        let door = random.between(8, ROOM - 20);
                        walls.extend([[at(0), at(door)], [at(door + 12), at(ROOM)]]);
                    }
                }
            }
        }
    }
    walls
}

fn divided(walls: &[Wall]) -> (Plan, PlanCells) {
    let segment = |ends: &Wall| RawSegment {
        ends: ends.map(|end| end.map(|c| Number::Small(c, 1))),
        is_opaque: true,
    };
    let segments = walls.iter().map(segment).collect();
    let plan = Plan::from_raw(&RawPlan { segments, ..RawPlan::default() }).unwrap();
    let tree = divide(&plan, &PlanMethod::default(), &Silent).unwrap();
    let cells = cells_of_plan(&plan, tree, false).unwrap();
    (plan, cells)
}

type Point = [f64; 2];

/// Walls that touch at most at their ends.
struct Sweep {
    walls: Vec<[Point; 2]>,
}

/// An end of a wall on the way around.
struct Event {
    angle: f64,
    wall: usize,
    starts: bool,
}

impl Sweep {
    fn new(walls: &[Wall]) -> Sweep {
        Sweep { walls: walls.iter().map(|ends| ends.map(|end| end.map(|c| c as f64))).collect() }
    }

    /// The area seen from a point: the ends of walls are visited by angle, the walls in the ray's
    /// way are kept from near to far, and the nearest one makes a triangle wherever it changes.
    fn area(&self, eye: Point) -> f64 {
        let mut events = Vec::with_capacity(2 * self.walls.len());
        let mut active: Vec<usize> = Vec::new();
        for (wall, [a, b]) in self.walls.iter().enumerate() {
            let [from, to] = [a, b].map(|p| (p[1] - eye[1]).atan2(p[0] - eye[0]));
            let turn = (to - from).rem_euclid(TAU);
            if turn == 0.0 || turn == PI {
                continue;
            }
            let (first, last) = if turn < PI { (from, to) } else { (to, from) };
            events.push(Event { angle: first, wall, starts: true });
            events.push(Event { angle: last, wall, starts: false });
            if first > last && last > -PI {
                active.push(wall);
            }
        }
        events.sort_by(|a, b| a.angle.total_cmp(&b.angle).then(a.starts.cmp(&b.starts)));
        let ahead = 1e-7;
        let ray = |angle: f64| [angle.cos(), angle.sin()];
        let first = ray(-PI + ahead);
        let distance = |wall: &usize| self.distance(eye, first, *wall);
        active.sort_by(|a, b| distance(a).total_cmp(&distance(b)));
        let (mut area, mut since) = (0.0, -PI);
        for Event { angle, wall, starts } in events {
            let before = active.first().copied();
            if starts {
                let ray = ray(angle + ahead);
                let distance = self.distance(eye, ray, wall);
                let at = active.partition_point(|&near| self.distance(eye, ray, near) < distance);
                active.insert(at, wall);
            } else if let Some(at) = active.iter().position(|other| *other == wall) {
                active.remove(at);
            }
            if let (Some(before), true) = (before, before != active.first().copied()) {
                area += self.triangle(eye, before, since, angle);
                since = angle;
            } else if before.is_none() {
                since = angle;
            }
        }
        area + active.first().map_or(0.0, |&last| self.triangle(eye, last, since, PI))
    }

    fn distance(&self, eye: Point, ray: Point, wall: usize) -> f64 {
        let [a, b] = self.walls[wall];
        let along = [b[0] - a[0], b[1] - a[1]];
        let apart = [a[0] - eye[0], a[1] - eye[1]];
        (apart[0] * along[1] - apart[1] * along[0]) / (ray[0] * along[1] - ray[1] * along[0])
    }

    fn triangle(&self, eye: Point, wall: usize, from: f64, to: f64) -> f64 {
        let reach = |angle: f64| self.distance(eye, [angle.cos(), angle.sin()], wall);
        if to > from { reach(from) * reach(to) * (to - from).sin() / 2.0 } else { 0.0 }
    }
}
