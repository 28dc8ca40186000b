//! Doom levels as plans: which leaves are whose, and what should not be in a level.

mod support;

use proptest::prelude::*;
use stabline::formats::wad::{Archive, DoomMap, MapForm};
use stabline::num::Int;
use stabline::predicates::PlanPoint;
use stabline::pvs::plan::{Cover, Groups, plan_matrix, plan_sights};
use stabline::report::{Matrix, Silent, Verdict};
use stabline::scene::plan::{DoomPlan, plan_of_map};
use support::sightlines::assert_joins;
use support::wads::{Level, Line, divided, faced, half_point, two_rooms};

fn map_of(level: &Level) -> DoomMap {
    let bytes = level.archive("MAP01", MapForm::Doom);
    Archive::read(&bytes).unwrap().map("MAP01").unwrap()
}

/// The oddities of a level, as text.
fn oddities(level: &Level) -> Vec<String> {
    divided(&map_of(level)).2.oddities.iter().map(ToString::to_string).collect()
}

fn point([x, y]: [i64; 2]) -> PlanPoint {
    PlanPoint::integer([x, y].map(Int::from))
}

/// The sectors of the leaf at a point.
fn sectors_at(level: &Level, at: [i64; 2]) -> Vec<u32> {
    let (_, cells, areas) = divided(&map_of(level));
    areas.sectors_of_leaf(cells.tree.locate(&point(at))).to_vec()
}

/// A closed path around a box, clockwise: its front is inside.
fn around([x0, y0]: [i16; 2], [x1, y1]: [i16; 2]) -> [[i16; 2]; 5] {
    [[x0, y0], [x0, y1], [x1, y1], [x1, y0], [x0, y0]]
}

/// One room, sector 0.
fn room() -> Level {
    let mut level = Level::default();
    level.path(&around([0, 0], [128, 128]), 0, None);
    level
}

#[test]
fn rooms_are_their_sectors_and_what_is_between_them_is_none() {
    let level = two_rooms();
    assert_eq!(sectors_at(&level, [64, 64]), [0]);
    assert_eq!(sectors_at(&level, [200, 3]), [1]);
    assert!(oddities(&level).is_empty());
    let mut level = room();
    level.path(&around([256, 32], [300, 64]), 1, None);
    assert_eq!(sectors_at(&level, [200, 40]), [0u32; 0]);
    assert_eq!(sectors_at(&level, [270, 40]), [1]);
    // A pillar: walls that face away from it.
    level.path(&[[40, 40], [60, 40], [50, 60], [40, 40]], 0, None);
    assert_eq!(sectors_at(&level, [50, 50]), [0u32; 0]);
    assert_eq!(sectors_at(&level, [40, 60]), [0]);
    assert!(oddities(&level).is_empty());
}

#[test]
fn lines_with_one_sector_on_both_sides_claim_only_what_nothing_else_does() {
    let mut level = room();
    // A square of another sector, by such lines alone; and a line across the room's own sector.
    level.path(&around([32, 32], [64, 64]), 1, Some(1));
    level.line([100, 0], [100, 128], Some(0), Some(0));
    assert_eq!(sectors_at(&level, [40, 40]), [1]);
    assert_eq!(sectors_at(&level, [80, 40]), [0]);
    assert_eq!(sectors_at(&level, [120, 40]), [0]);
    let lines = oddities(&level);
    assert_eq!(lines[0], "line 4 has sector 1 on both sides");
    assert_eq!(lines[4], "line 8 has sector 0 on both sides");
    // The line's ends are inside the room's walls.
    assert_eq!(&lines[5..], ["line 8 ends within line 1", "line 8 ends within line 3"]);
}

#[test]
fn an_area_with_several_claims_is_part_of_each() {
    // The wall between the room and what is around it has a gap.
    let mut level = Level::default();
    level.path(&[[40, 40], [40, 80], [80, 80]], 1, Some(0));
    level.path(&around([0, 0], [128, 128]), 0, None);
    assert_eq!(sectors_at(&level, [60, 60]), [0, 1]);
    assert_eq!(oddities(&level), ["an area is claimed by sector 0 (line 0), sector 1 (line 0)"]);
    let mut level = Level::default();
    level.path(&[[64, 0], [0, 0], [0, 64], [64, 64]], 0, None);
    level.path(&around([128, 0], [192, 64]), 1, None);
    level.path(&[[128, 0], [128, 64]], 1, None);
    assert_eq!(sectors_at(&level, [100, 10]), [0]);
    let found = oddities(&level);
    assert_eq!(found[0], "lines 3 and 7 overlap");
    assert_eq!(found[1], "an area is claimed by the void (line 3), sector 0 (line 0)");
}

#[test]
fn every_oddity_is_told_with_its_lines() {
    let mut level = room();
    level.line([10, 10], [10, 10], Some(0), Some(0));
    level.line([20, 20], [30, 20], None, None);
    level.line([40, 20], [50, 20], Some(0), Some(0));
    level.line([45, 10], [45, 30], Some(0), Some(0));
    level.lines[6].flags = 0;
    level.lines[3].flags = 4;
    level.sectors = 3;
    let expected = [
        "line 4 has no length",
        "line 5 has no front",
        "line 3 is flagged two-sided and has one side",
        "line 6 has two sides and is not flagged two-sided",
        "line 4 has sector 0 on both sides",
        "line 6 has sector 0 on both sides",
        "line 7 has sector 0 on both sides",
        "lines 6 and 7 cross",
        "sector 1 has no area",
        "sector 2 has no area",
    ];
    assert_eq!(oddities(&level), expected);
    let (doom, ..) = divided(&map_of(&level));
    assert!(doom.lines[5].is_wall() && !doom.lines[6].is_wall() && doom.lines[3].is_wall());
}

#[test]
fn a_line_with_a_back_alone_is_a_wall_that_faces_there() {
    let mut level = room();
    for Line { front, back, .. } in &mut level.lines {
        std::mem::swap(front, back);
    }
    for line in &mut level.lines {
        std::mem::swap(&mut line.start, &mut line.end);
    }
    assert_eq!(sectors_at(&level, [64, 64]), [0]);
    let expected: Vec<_> = (0..4).map(|line| format!("line {line} has no front")).collect();
    assert_eq!(oddities(&level), expected);
}

#[test]
fn walls_back_to_back_bound_two_sectors() {
    let mut level = room();
    level.path(&around([128, 0], [256, 128]), 1, None);
    assert_eq!(sectors_at(&level, [127, 64]), [0]);
    assert_eq!(sectors_at(&level, [129, 64]), [1]);
    assert_eq!(oddities(&level), ["lines 2 and 4 overlap"]);
}

#[test]
fn a_level_without_lines_is_an_error() {
    let mut level = Level { sectors: 1, ..Level::default() };
    let error = |level: &Level| plan_of_map(&map_of(level)).unwrap_err().to_string();
    let expected = "linedefs: no segment of positive length, expected one or more";
    assert_eq!(error(&level), expected);
    level.line([1, 1], [1, 1], Some(0), None);
    assert_eq!(error(&level), expected);
}

/// A level of rooms on the squares of a board; neighbours of one sector have no line between them.
fn board(sectors: &[[Option<u16>; 4]; 4]) -> Level {
    let mut level = Level::default();
    let at = |x: usize, y: usize| -> Option<u16> {
        *sectors.get(y.wrapping_sub(1))?.get(x.wrapping_sub(1)).unwrap_or(&None)
    };
    let mut line = |start: [usize; 2], end: [usize; 2], front: Option<u16>, back: Option<u16>| {
        let [start, end] = [start, end].map(|end| end.map(|c| c as i16 * 16 - 16));
        match (front, back) {
            (front, back) if front == back => {}
            (None, back) => level.line(end, start, back, None),
            (front, back) => level.line(start, end, front, back),
        }
    };
    for x in 1..=5 {
        for y in 1..=5 {
            line([x, y], [x, y + 1], at(x, y), at(x - 1, y));
            line([x, y], [x + 1, y], at(x, y - 1), at(x, y));
        }
    }
    level
}

proptest! {
    #[test]
    fn leaves_are_of_the_sector_that_the_next_line_faces(
        sectors in prop::array::uniform4(prop::array::uniform4(prop::option::of(0u16..3))),
    ) {
        let level = board(&sectors);
        prop_assume!(!level.lines.is_empty());
        let map = map_of(&level);
        let (doom, cells, areas) = divided(&map);
        for (x, y) in (0..4).flat_map(|x| (0..4).map(move |y| (x, y))) {
            let doubled = [32 * x as i64 + 7, 32 * y as i64 + 11];
            let at = half_point(doubled);
            let expected = sectors[y][x].map(u32::from);
            prop_assert_eq!(faced(&map, &doom, doubled), expected);
            let inside = at.coordinates().iter().zip(bounds(&doom)).all(|(c, [low, high])| {
                *c > low && *c < high
            });
            if inside {
                let leaf = cells.tree.locate(&at);
                let expected: Vec<u32> = expected.into_iter().collect();
                prop_assert_eq!(areas.sectors_of_leaf(leaf), &expected[..]);
            }
        }
        let unclosed = areas.oddities.iter().filter(|oddity| !oddity.rule().starts_with("sectors"));
        prop_assert_eq!(unclosed.count(), 0);
    }
}

/// A board of which lines are missing, so that areas have several sectors.
fn leaky(sectors: &[[Option<u16>; 4]; 4], missing: &[prop::sample::Index]) -> Level {
    let mut level = board(sectors);
    for index in missing {
        if level.lines.len() > 4 {
            level.lines.remove(index.index(level.lines.len()));
        }
    }
    level
}

proptest! {
    #[test]
    fn sectors_see_each_other_where_their_leaves_do(
        sectors in prop::array::uniform4(prop::array::uniform4(prop::option::of(0u16..5))),
        missing in prop::collection::vec(any::<prop::sample::Index>(), 0..6),
    ) {
        let level = leaky(&sectors, &missing);
        prop_assume!(!level.lines.is_empty());
        let map = map_of(&level);
        let (doom, cells, areas) = divided(&map);
        let leaves = 0..areas.of_leaf.len() as u32;
        let sectors_of = |leaf: u32| areas.sectors_of_leaf(leaf);
        let cover = Cover::new(doom.sectors, leaves.clone().map(sectors_of));
        let (graph, crossings) = (&cells.graph, cells.graph.crossings());
        let all = |_: u32, _: u32| true;
        let (matrix, sights) =
            plan_sights(graph, &crossings, cover.groups(), &all, &Silent).unwrap();
        let (matrix, sights) = (cover.matrix(matrix), cover.sights(graph, sights));
        let groups = Groups::cells(graph.cells.len());
        let finer = plan_matrix(graph, &crossings, &groups, &Silent).unwrap();
        let mut expected = Matrix::new(doom.sectors, Verdict::NotOpen);
        for (row, column) in leaves.clone().flat_map(|row| leaves.clone().map(move |c| (row, c))) {
            let verdict = finer.get(row as usize, column as usize);
            for (&from, &to) in
                sectors_of(row).iter().flat_map(|f| sectors_of(column).iter().map(move |t| (f, t)))
            {
                let known = expected.get(from as usize, to as usize);
                expected.set(from as usize, to as usize, known.max(verdict));
            }
        }
        (0..doom.sectors).for_each(|sector| expected.set(sector, sector, Verdict::Open));
        prop_assert_eq!(&matrix, &expected);
        let pairs: Vec<_> = sights.iter().map(|sight| (sight.from, sight.to)).collect();
        let verdict = |from: u32, to: u32| expected.get(from as usize, to as usize);
        let open = |&(from, to): &(u32, u32)| verdict(from, to) == Verdict::Open;
        let numbers = 0..doom.sectors as u32;
        let ascending = numbers.clone().flat_map(|from| numbers.clone().map(move |to| (from, to)));
        let expected: Vec<_> = ascending.filter(|(from, to)| from < to).filter(open).collect();
        prop_assert_eq!(pairs, expected);
        // Where areas have one sector each, the linedefs beside a line name its sectors.
        if areas.sectors.iter().all(|sectors| sectors.len() <= 1) && missing.is_empty() {
            sights.iter().for_each(|sight| assert_joins(&map, &doom, &cells, &[], sight));
        }
    }
}

/// The least and greatest x, and y, of a plan's box.
fn bounds(doom: &DoomPlan) -> [[stabline::num::Rational; 2]; 2] {
    let corner = |index: usize| doom.plan.points.get(doom.plan.bounds[index]).coordinates();
    let ([x0, y0], [x1, y1]) = (corner(0), corner(2));
    [[x0, x1], [y0, y1]]
}
