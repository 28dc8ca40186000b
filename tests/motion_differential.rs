//! Moves in random worlds against their twins, which know neither cells nor portals.

mod support;

use num_traits::{One, Zero};
use stabline::geom::{AxialBox, BigPlane, RationalPoint3};
use stabline::motion::{Move, MoveError, Obstacle, Space, Touch, Walk};
use stabline::num::{Int, Rational};
use stabline::oracle::{Random, first_contact, overlap};
use stabline::portal::cells_of_world;
use stabline::scene::{LevelOptions, World, read_level};
use stabline::subdivision::Options;
use std::time::Instant;
use support::obstacles::{end_of_world, point, polygon_planes, random_polygon, random_world};

/// So tight a box around the solids that moves often leave it.
fn tight() -> Options {
    Options { margin: Int::one(), ..Options::default() }
}

/// A point on a small grid, so that it often lies on planes, edges and vertices.
fn place(random: &mut Random) -> RationalPoint3 {
    let denominator = [1, 1, 2, 3][random.between(0, 3) as usize];
    let coordinate = |random: &mut Random| random.between(-2 * denominator, 10 * denominator);
    point([coordinate(random), coordinate(random), coordinate(random)], denominator)
}

/// Half of the moves along an axis or in an axial plane.
fn target(random: &mut Random, from: &RationalPoint3) -> RationalPoint3 {
    let to = place(random);
    let (start, mut end) = (from.coordinates(), to.coordinates());
    for axis in 0..3 {
        if random.one_in(3) {
            end[axis] = start[axis].clone();
        }
    }
    RationalPoint3::from(&end)
}

fn planes(world: &World) -> Vec<Vec<BigPlane>> {
    world.solids.iter().map(|solid| solid.planes.clone()).collect()
}

/// What must hold of every walk.
fn check(walk: &Walk, motion: &Move) {
    let (start, end) = (motion.from.coordinates(), motion.to.coordinates());
    let at: [Rational; 3] = std::array::from_fn(|i| &start[i] + (&end[i] - &start[i]) * &walk.time);
    assert_eq!(walk.point, RationalPoint3::from(&at));
    assert_eq!(walk.hits.is_empty(), walk.time.is_one());
    for hit in &walk.hits {
        let along: Rational = (0..3).map(|i| (&end[i] - &start[i]) * &hit.normal[i]).sum();
        assert!(along < Rational::zero(), "{hit:?} is hit from behind");
        if motion.body.is_none() {
            let height: Rational = (0..3).map(|i| &at[i] * &hit.normal[i]).sum();
            assert_eq!(height, hit.offset);
        }
    }
    assert!(walk.stays.iter().any(|stay| stay.enter.is_zero()));
    assert!(motion.body.is_some() || walk.stays.iter().any(|stay| stay.leave == walk.time));
    assert!(walk.stays.iter().all(|stay| stay.enter <= stay.leave && stay.leave <= walk.time));
}

#[test]
fn a_point_gets_as_far_as_its_twin() {
    let (mut free, mut stopped, mut at_once, mut buried) = (0, 0, 0, 0);
    for seed in 1..50 {
        let random = &mut Random::new(seed);
        let mut world = random_world(random, 6);
        world.polygons = (0..seed % 3).map(|_| random_polygon(random)).collect();
        let polygons: Vec<_> = world.polygons.iter().map(|p| p.vertices.clone()).collect();
        let cells = cells_of_world(&world, &tight()).unwrap();
        let space = Space::new(&world, &cells);
        let mut solids = planes(&world);
        solids.extend(end_of_world(&cells));
        for _ in 0..60 {
            let from = place(random);
            let motion = Move { to: target(random, &from), from, body: None };
            let twin = first_contact(&solids, &polygons, &motion.from, &motion.to);
            match space.first_contact(&motion) {
                Ok(walk) => {
                    assert_eq!(Some(&walk.time), twin.as_ref(), "seed {seed}: {motion:?}");
                    check(&walk, &motion);
                    let count = if walk.time.is_one() {
                        &mut free
                    } else if walk.time.is_zero() {
                        &mut at_once
                    } else {
                        &mut stopped
                    };
                    *count += 1;
                }
                Err(error) => {
                    assert!(matches!(error, MoveError::Nowhere { .. }), "{error}");
                    assert_eq!(twin, None, "seed {seed}: {motion:?}");
                    buried += 1;
                }
            }
        }
    }
    println!("{free} free, {stopped} stopped, {at_once} at once, {buried} buried");
    assert!(free > 300 && stopped > 300 && at_once > 30 && buried > 30);
}

fn random_box(random: &mut Random) -> AxialBox {
    let low = [(); 3].map(|()| Rational::new(Int::from(-random.between(0, 3)), Int::from(2)));
    let high = low.each_ref().map(|low| low + Rational::new(random.between(1, 4).into(), 2.into()));
    AxialBox { low, high }
}

#[test]
fn a_box_stops_at_the_first_of_all_obstacles() {
    let (mut free, mut stopped, mut overlapping, mut crosswise) = (0, 0, 0, 0);
    for seed in 1..60 {
        let random = &mut Random::new(seed);
        let mut world = random_world(random, 6);
        world.polygons = (0..2).map(|_| random_polygon(random)).collect();
        let cells = cells_of_world(&world, &tight()).unwrap();
        let space = Space::new(&world, &cells);
        for _ in 0..60 {
            let from = place(random);
            let body = Some(random_box(random));
            let motion = Move { to: target(random, &from), from, body };
            let all = space.overlaps(&motion);
            match space.first_contact(&motion) {
                Ok(walk) => {
                    check(&walk, &motion);
                    let all = all.unwrap();
                    let first = all.iter().map(|(time, _)| time).min().cloned();
                    assert_eq!(walk.time, first.clone().unwrap_or_else(Rational::one));
                    let hit: Vec<Obstacle> = all
                        .into_iter()
                        .filter(|(time, _)| Some(time) == first.as_ref())
                        .map(|(_, obstacle)| obstacle)
                        .collect();
                    let mut named: Vec<_> = walk.hits.iter().map(|hit| hit.obstacle).collect();
                    named.dedup();
                    let edges = walk.hits.iter().filter(|hit| hit.touch == Touch::Edges);
                    crosswise += edges.count();
                    assert_eq!(named, hit, "seed {seed}: {motion:?}");
                    if walk.time.is_one() { free += 1 } else { stopped += 1 }
                }
                Err(MoveError::Overlap { .. }) => {
                    assert!(matches!(all, Err(MoveError::Overlap { .. })), "seed {seed}");
                    overlapping += 1;
                }
                Err(MoveError::Nowhere { .. }) => {}
                Err(MoveError::NoVolume) => panic!("the box has volume"),
            }
        }
    }
    println!("{free} free, {stopped} stopped ({crosswise} edges), {overlapping} overlapping");
    assert!(free > 100 && stopped > 200 && crosswise > 0 && overlapping > 200);
}

/// The time at which each obstacle alone is entered, against the linear program in space and time.
#[test]
fn a_box_enters_each_obstacle_when_its_twin_does() {
    let (mut entered, mut missed, mut overlapped) = (0, 0, 0);
    for seed in 1..20 {
        let random = &mut Random::new(seed);
        let mut world = random_world(random, 1);
        world.polygons = vec![random_polygon(random)];
        let cells = cells_of_world(&world, &tight()).unwrap();
        let space = Space::new(&world, &cells);
        let mut bodies: Vec<(Obstacle, Vec<BigPlane>)> =
            planes(&world).into_iter().enumerate().map(|(i, p)| (Obstacle::Solid(i), p)).collect();
        bodies.push((Obstacle::Polygon(0), polygon_planes(&world.polygons[0].vertices)));
        for round in 0..8 {
            let (from, body) = (place(random), random_box(random));
            // Half of the moves towards the solid that is always there.
            let aimed = [random.between(6, 8), random.between(6, 10), random.between(1, 6)];
            let to = if round % 2 == 0 { point(aimed, 2) } else { target(random, &from) };
            if from == to {
                continue;
            }
            let corners = [&body.low, &body.high].map(RationalPoint3::from);
            let motion = Move { from, to, body: Some(body) };
            let all = space.overlaps(&motion);
            let mut inside = false;
            for (obstacle, planes) in &bodies {
                let twin = overlap(planes, &motion.from, &motion.to, &corners);
                let twin = twin.filter(|[a, b]| *a < Rational::one() && *b > Rational::zero());
                let Some([first, _]) = twin else {
                    missed += 1;
                    assert!(all.iter().flatten().all(|(_, hit)| hit != obstacle), "seed {seed}");
                    continue;
                };
                if first < Rational::zero() {
                    inside = true;
                    continue;
                }
                entered += 1;
                if let Ok(all) = &all {
                    assert!(all.contains(&(first, *obstacle)), "seed {seed}: {motion:?}");
                }
            }
            if inside {
                overlapped += 1;
                assert!(matches!(all, Err(MoveError::Overlap { .. })), "seed {seed}: {motion:?}");
            }
        }
    }
    println!("{entered} entered, {missed} missed, {overlapped} overlapped");
    assert!(entered > 40 && missed > 80 && overlapped > 0);
}

/// In a mirrored or moved world the first contact keeps its time.
#[test]
fn contacts_keep_their_times_in_images_of_the_world() {
    // x -> sign·x + shift on each axis.
    let images: [([i64; 3], [i64; 3]); 3] =
        [([-1, 1, 1], [0, 0, 0]), ([1, -1, -1], [3, -5, 7]), ([1, 1, 1], [1 << 40, 1, 0])];
    for seed in 100..110 {
        let random = &mut Random::new(seed);
        let world = random_world(random, 5);
        let cells = cells_of_world(&world, &tight()).unwrap();
        let space = Space::new(&world, &cells);
        for (sign, shift) in images {
            let mut image = world.clone();
            for plane in image.solids.iter_mut().flat_map(|solid| &mut solid.planes) {
                for axis in 0..3 {
                    plane.normal[axis] *= sign[axis];
                    plane.offset += &plane.normal[axis] * shift[axis];
                }
            }
            let of_point = |point: &RationalPoint3| {
                let c = point.coordinates();
                RationalPoint3::from(
                    &[0, 1, 2].map(|i| &c[i] * Int::from(sign[i]) + Int::from(shift[i])),
                )
            };
            let other_cells = cells_of_world(&image, &tight()).unwrap();
            let other = Space::new(&image, &other_cells);
            for round in 0..20 {
                let from = place(random);
                let to = target(random, &from);
                let body = (round % 2 == 0).then(|| random_box(random));
                let mirrored = body.as_ref().map(|AxialBox { low, high }| {
                    let corners = [low, high].map(|c| {
                        RationalPoint3::from(&[0, 1, 2].map(|i| &c[i] * Int::from(sign[i])))
                    });
                    AxialBox::around(&corners).unwrap()
                });
                let motion = Move { from: of_point(&from), to: of_point(&to), body: mirrored };
                let walk = space.first_contact(&Move { from, to, body });
                let time = |walk: Result<Walk, MoveError>| walk.ok().map(|walk| walk.time);
                assert_eq!(
                    time(walk),
                    time(other.first_contact(&motion)),
                    "seed {seed}: {motion:?}"
                );
            }
        }
    }
}

/// What is free is free backwards, and half of it is free; one more solid never helps.
#[test]
fn free_moves_stay_free_and_more_solids_stop_no_later() {
    let (mut walked, mut sooner) = (0, 0);
    for seed in 200..215 {
        let random = &mut Random::new(seed);
        let world = random_world(random, 4);
        let mut crowded = world.clone();
        crowded.solids.extend(random_world(random, 3).solids.drain(..3));
        let (cells, fewer) =
            [&crowded, &world].map(|w| cells_of_world(w, &tight()).unwrap()).into();
        let (narrow, wide) = (Space::new(&crowded, &cells), Space::new(&world, &fewer));
        for round in 0..160 {
            let from = place(random);
            let to = target(random, &from);
            let body = (round % 2 == 0).then(|| random_box(random));
            let motion = Move { from, to, body };
            let Ok(walk) = narrow.first_contact(&motion) else { continue };
            let (from, to) = (motion.from.clone(), motion.to.clone());
            let body = motion.body.clone();
            // Up to the contact all is free, and so it is on the way back.
            let back = Move { from: walk.point.clone(), to: from.clone(), body: body.clone() };
            assert!(narrow.first_contact(&back).unwrap().time.is_one(), "seed {seed}: {back:?}");
            let part = Move { from, to: walk.point.clone(), body };
            assert!(narrow.first_contact(&part).unwrap().time.is_one(), "seed {seed}: {part:?}");
            if let Ok(other) = wide.first_contact(&motion) {
                // The larger world may end later.
                if other.hits.iter().any(|hit| hit.obstacle == Obstacle::Bounds) {
                    continue;
                }
                assert!(walk.time <= other.time, "seed {seed}: {motion:?} {to:?}");
                sooner += usize::from(walk.time < other.time);
            }
            walked += 1;
        }
    }
    println!("{walked} moves, {sooner} of them stopped sooner");
    assert!(walked > 200 && sooner > 10);
}

/// Random moves in a public level: points against the twin among all solids, boxes against all
/// solids. Prints how many moves a second are answered.
#[test]
fn moves_in_a_public_level() {
    let Some(maps) = support::maps() else { return };
    let bytes = std::fs::read(maps.join("lq_e0m1/lq_e0m1.map")).unwrap();
    let level = read_level("lq_e0m1.map", &bytes, LevelOptions::default()).unwrap();
    let world = World::of_level(&level);
    let start = Instant::now();
    let cells = cells_of_world(&world, &Options::default()).unwrap();
    let divided = start.elapsed();
    let space = Space::new(&world, &cells);
    let (count, prepared) = (cells.leaves.len() as i64, start.elapsed() - divided);
    println!("{count} cells in {divided:?}, prepared in {prepared:?}");
    let random = &mut Random::new(1);
    let mut inside = || {
        let leaf = cells.leaves[random.between(0, count - 1) as usize];
        let middle = cells.subdivision.leaf(leaf).cell.inner_point();
        // To a sixteenth of a unit, as an editor or a game would put it.
        let sixteenths = |i: usize| &middle.numerators()[i] * 16 / middle.denominator();
        RationalPoint3::new([0, 1, 2].map(sixteenths), Int::from(16))
    };
    let moves: Vec<Move> =
        (0..3000).map(|_| Move { from: inside(), to: inside(), body: None }).collect();
    let timed = |what: &str, moves: &[Move]| {
        let start = Instant::now();
        let walks: Vec<_> = moves.iter().map(|motion| space.first_contact(motion)).collect();
        let rate = moves.len() as f64 / start.elapsed().as_secs_f64();
        let walked = || walks.iter().flatten();
        let free = walked().filter(|walk| walk.time.is_one()).count();
        let stays: usize = walked().map(|walk| walk.stays.len()).sum();
        println!(
            "{what}: {rate:.0} moves/s, {} of {} walk, {free} free, {stays} cells",
            walked().count(),
            walks.len()
        );
        walks
    };
    let walks = timed("points", &moves);
    let mut solids = planes(&world);
    solids.extend(end_of_world(&cells));
    let mut compared = 0;
    for (motion, walk) in moves.iter().zip(&walks).step_by(8) {
        let Ok(walk) = walk else { continue };
        check(walk, motion);
        let twin = first_contact(&solids, &[], &motion.from, &motion.to);
        assert_eq!(Some(&walk.time), twin.as_ref(), "{motion:?}");
        compared += 1;
    }
    let half = |size: [i64; 3]| size.map(|h| Rational::from(Int::from(h)));
    let player = AxialBox { low: half([-16, -16, -24]), high: half([16, 16, 32]) };
    let moves: Vec<Move> =
        moves.into_iter().map(|motion| Move { body: Some(player.clone()), ..motion }).collect();
    let walks = timed("boxes", &moves);
    let mut boxes = 0;
    for (motion, walk) in moves.iter().zip(&walks).step_by(5) {
        let Ok(walk) = walk else { continue };
        check(walk, motion);
        let first = space.overlaps(motion).unwrap().into_iter().map(|(time, _)| time).min();
        assert_eq!(walk.time, first.unwrap_or_else(Rational::one), "{motion:?}");
        boxes += 1;
    }
    println!("{compared} points and {boxes} boxes compared");
    assert!(compared > 300 && boxes > 100);
}
