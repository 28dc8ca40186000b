//! Worlds of solids and polygons: cells, portals and visibility against segments through the
//! occluders themselves, and what must not change them.
//!
//! A point on the common boundary of cells counts for each of them: where it is free and sees
//! another point, so does all that is near it, and each of the cells has some of that.
//!
//! `STABLINE_WORLDS=N` sets the number of worlds a family, `STABLINE_SEED=S` the first seed.

mod support;

use stabline::geom::{AxialBox, BigPlane, RationalPoint3};
use stabline::num::Rational;
use stabline::oracle::{Occluders, Random, middle_within};
use stabline::portal::{WorldCells, WorldError, cells_of_world};
use stabline::pvs;
use stabline::report::{Matrix, Silent, Verdict};
use stabline::subdivision;
use support::worlds::{
    Affine, Case, Family, half_space, of_family, random_mean, random_point, random_polygon,
};

/// A world's cells, which see which, and for each pair that does two inner points that do.
struct Seen {
    cells: WorldCells,
    matrix: Matrix,
    pairs: Vec<Pair>,
}

struct Pair {
    cells: [usize; 2],
    points: [RationalPoint3; 2],
}

impl Seen {
    fn of(case: &Case) -> Option<Seen> {
        match cells_of_world(&case.world(), &subdivision::Options::default()) {
            Ok(cells) => Some(Seen::of_cells(cells)),
            Err(WorldError::AllBuried(_)) => None,
            Err(error) => panic!("{error}: {case:?}"),
        }
    }

    fn of_cells(cells: WorldCells) -> Seen {
        let options = pvs::Options::default();
        let finished = pvs::compute(&cells.graph, &options, Vec::new(), &|_| {}, &Silent);
        let matrix = pvs::assemble(&cells.graph, &finished.rows);
        let mut seen = Seen { cells, matrix, pairs: Vec::new() };
        for witness in pvs::witnesses(&finished.rows) {
            let cells = [witness.from, witness.to].map(|cell| cell as usize);
            let line = witness
                .line
                .in_space()
                .clone()
                .map(|p| RationalPoint3::from(&p.map(|c| c.to_rational())));
            let middle = |cell: usize| middle_within([&line[0], &line[1]], &seen.planes(cell));
            let points = cells.map(|cell| middle(cell).expect("the line passes through the cell"));
            seen.pairs.push(Pair { cells, points });
        }
        seen
    }

    /// The planes around a cell, outward.
    fn planes(&self, cell: usize) -> Vec<BigPlane> {
        let subdivision = &self.cells.subdivision;
        let faces = subdivision.leaf(self.cells.leaves[cell]).cell.faces();
        faces.iter().map(|face| subdivision.planes.plane(face.support()).clone()).collect()
    }

    fn corners(&self, cell: usize) -> Vec<RationalPoint3> {
        let leaf = self.cells.subdivision.leaf(self.cells.leaves[cell]);
        leaf.cell.faces().iter().flat_map(|face| face.points()).collect()
    }

    /// The cells whose closure has the point; `None` if none has, or if it is also in a solid leaf
    /// or in an empty one that is no cell.
    fn locate(&self, point: &RationalPoint3) -> Option<Vec<usize>> {
        let leaves = self.cells.subdivision.locate(point);
        let cells: Option<Vec<usize>> =
            leaves.iter().map(|leaf| self.cells.leaves.binary_search(leaf).ok()).collect();
        cells.filter(|cells| !cells.is_empty())
    }

    fn sees(&self, a: usize, b: usize) -> bool {
        self.matrix.get(a, b) == Verdict::Open
    }

    /// Asserts that all cells of one point see all of the other, since the points do.
    fn must_see(&self, points: [&RationalPoint3; 2], name: &str) {
        let [from, to] = points.map(|point| self.locate(point));
        let (Some(from), Some(to)) = (from, to) else {
            panic!("{name}: {points:?} are free, and not in cells only");
        };
        for (&a, &b) in from.iter().flat_map(|a| to.iter().map(move |b| (a, b))) {
            assert!(self.sees(a, b), "{name}: cell {a} does not see {b}, but {points:?} do");
        }
    }

    fn free_volume(&self) -> Rational {
        let subdivision = &self.cells.subdivision;
        self.cells.leaves.iter().map(|&leaf| subdivision.leaf(leaf).cell.volume()).sum()
    }
}

fn setting(name: &str, default: u64) -> u64 {
    std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(default)
}

/// Names and seeds of `count` worlds a family.
fn cases(count: u64) -> impl Iterator<Item = (String, Family, u64)> {
    let first = setting("STABLINE_SEED", 0);
    let count = setting("STABLINE_WORLDS", count);
    Family::ALL.into_iter().flat_map(move |family| {
        (first..first + count).map(move |seed| (format!("{family:?} {seed}"), family, seed))
    })
}

/// Free points in cells: anywhere in the room, in every cell, on its boundary and near its corners.
fn sample(
    random: &mut Random,
    seen: &Seen,
    occluders: &Occluders,
    may_be_cut_off: bool,
) -> Vec<RationalPoint3> {
    let mut points: Vec<RationalPoint3> =
        (0..16).map(|i| random_point(random, [1, 2, 7, 1000][i % 4])).collect();
    for cell in 0..seen.cells.leaves.len().min(24) {
        let corners = seen.corners(cell);
        points.push(random_mean(random, &corners));
        let inner = middle_of(&corners);
        let corner = &corners[random.between(0, corners.len() as i64 - 1) as usize];
        points.push(between(corner, &inner, 1000));
    }
    points.retain(|point| occluders.leaves_free(point));
    points.retain(|point| {
        let leaves = seen.cells.subdivision.locate(point);
        let cells = leaves.iter().filter(|leaf| seen.cells.leaves.contains(leaf)).count();
        // Where no mark leads, nothing is a cell.
        let is_cut_off = may_be_cut_off && cells == 0;
        assert!(is_cut_off || cells == leaves.len(), "{point:?} is free, and not in cells only");
        !is_cut_off
    });
    points
}

fn middle_of(points: &[RationalPoint3]) -> RationalPoint3 {
    let count = support::graphs::integer(points.len() as i64);
    let points: Vec<_> = points.iter().map(RationalPoint3::coordinates).collect();
    let mean = |i: usize| points.iter().map(|point| &point[i]).sum::<Rational>() / &count;
    RationalPoint3::from(&[0, 1, 2].map(mean))
}

/// A point one `share`-th of the way from `p` to `q`.
fn between(p: &RationalPoint3, q: &RationalPoint3, share: i64) -> RationalPoint3 {
    let (p, q) = (p.coordinates(), q.coordinates());
    let share = support::graphs::integer(share);
    RationalPoint3::from(&[0, 1, 2].map(|i| &p[i] + (&q[i] - &p[i]) / &share))
}

/// Every pair of cells that is open has two inner points that see each other.
fn check_sightlines(seen: &Seen, occluders: &Occluders, name: &str) {
    for Pair { cells, points } in &seen.pairs {
        let located = points.each_ref().map(|point| seen.locate(point));
        assert_eq!(located, cells.map(|cell| Some(vec![cell])), "{name}");
        let stopped = occluders.between(&points[0], &points[1]);
        assert_eq!(stopped, None, "{name}: occluder {stopped:?} stops the sightline of {cells:?}");
    }
    let size = seen.matrix.size();
    let open = seen.matrix.counts().open as usize;
    assert_eq!(open, size + 2 * seen.pairs.len(), "{name}: pairs without a sightline");
}

/// Every pair of sampled points that see each other is open.
fn check_segments(random: &mut Random, case: &Case, seen: &Seen, name: &str) -> usize {
    let occluders = case.occluders();
    let points = sample(random, seen, &occluders, !case.marks.is_empty());
    let mut count = 0;
    for (index, p) in points.iter().enumerate() {
        for q in points[..index].iter().filter(|q| occluders.let_see(p, q)) {
            seen.must_see([p, q], name);
            count += 1;
        }
    }
    count
}

#[test]
fn points_that_see_each_other_are_in_cells_that_do() {
    let mut seeing = 0;
    for (name, family, seed) in cases(3) {
        for case in [Case::closed(family, seed), Case::open(family, seed)] {
            let seen = Seen::of(&case).expect("a mark is free");
            check_sightlines(&seen, &case.occluders(), &name);
            seeing += check_segments(&mut Random::new(seed), &case, &seen, &name);
        }
    }
    assert!(seeing > 3_000, "only {seeing} pairs of points see each other");
}

/// Of two divisions of the same free space, or of one that is part of the other's, what is seen in
/// `part` is seen in `whole`; points of the first are mapped.
fn implies(part: &Seen, whole: &Seen, map: &Affine, name: &str) {
    for pair in &part.pairs {
        let [p, q] = pair.points.each_ref().map(|point| map.of_point(point));
        whole.must_see([&p, &q], name);
    }
}

fn same(case: &Case, other: &Case, map: &Affine, name: &str) {
    let (Some(seen), Some(changed)) = (Seen::of(case), Seen::of(other)) else {
        panic!("{name}: no cells");
    };
    let grown = &map.scale * &map.scale * &map.scale;
    assert_eq!(seen.free_volume() * grown, changed.free_volume(), "{name}");
    check_sightlines(&changed, &other.occluders(), name);
    implies(&seen, &changed, map, name);
    let back: Vec<Pair> = changed.pairs;
    let preimage = |point: &RationalPoint3| map.inverse(point);
    for Pair { points, .. } in &back {
        let [p, q] = points.each_ref().map(preimage);
        seen.must_see([&p, &q], name);
    }
}

#[test]
fn the_order_of_the_solids_does_not_matter() {
    for (name, family, seed) in cases(3) {
        let case = Case::closed(family, seed);
        let mut random = Random::new(seed);
        let mut other = case.clone();
        for i in (1..other.solids.len()).rev() {
            other.solids.swap(i, random.between(0, i as i64) as usize);
        }
        other.polygons.reverse();
        for polygon in &mut other.polygons {
            polygon.rotate_left(1);
            if random.one_in(2) {
                polygon.reverse();
            }
        }
        for solid in &mut other.solids {
            let faces = solid.len() as i64;
            solid.rotate_left(random.between(0, faces - 1) as usize);
        }
        same(&case, &other, &Affine::identity(), &name);
    }
}

#[test]
fn affine_maps_do_not_matter() {
    for (name, family, seed) in cases(3) {
        let case = Case::closed(family, seed);
        let map = Affine::random(&mut Random::new(seed));
        same(&case, &case.mapped(&map), &map, &format!("{name} {map:?}"));
    }
}

#[test]
fn occluders_in_two_parts_or_with_more_planes_are_the_same() {
    for (name, family, seed) in cases(3) {
        let case = Case::closed(family, seed);
        let mut random = Random::new(seed);
        let mut other = case.clone();
        let index = random.between(0, other.solids.len() as i64 - 1) as usize;
        let normal = [random.between(-2, 2), random.between(-2, 2), random.between(1, 2)];
        let at = random.between(0, 6);
        let solid = other.solids.remove(index);
        for sign in [1, -1] {
            let mut part = solid.clone();
            part.push(half_space(normal.map(|c| sign * c), sign * at));
            other.solids.push(part);
        }
        // Planes far away, and a face twice.
        let last = other.solids.len() - 1;
        let again = other.solids[last][0].clone();
        other.solids[last].extend([half_space(normal, 99), again]);
        // Polygons of four corners as two triangles.
        for polygon in case.polygons.iter().filter(|polygon| polygon.len() == 4) {
            let [a, b, c, d] = [0, 1, 2, 3].map(|i| polygon[i].clone());
            other.polygons.retain(|other| other != polygon);
            other.polygons.extend([vec![a.clone(), b, c.clone()], vec![a, c, d]]);
        }
        same(&case, &other, &Affine::identity(), &name);
    }
}

#[test]
fn adding_an_occluder_opens_nothing() {
    let mut closed = 0;
    for (name, family, seed) in cases(3) {
        let case = Case::closed(family, seed);
        let mut more = case.clone();
        let mut random = Random::new(seed ^ 0xadd);
        match family {
            Family::Polygons => more.polygons.push(random_polygon(&mut random)),
            _ => more.solids.extend(of_family(&mut random, family)),
        }
        let Some(seen) = Seen::of(&case) else { panic!("{name}: no cells") };
        // A solid that buries all marks leaves nothing to compare.
        let Some(with) = Seen::of(&more) else { continue };
        assert!(with.free_volume() <= seen.free_volume(), "{name}");
        check_sightlines(&with, &more.occluders(), &name);
        implies(&with, &seen, &Affine::identity(), &name);
        // Cells of the one that lie in a cell of the other see no more than that.
        let within: Vec<Option<usize>> =
            (0..with.cells.leaves.len()).map(|cell| holder(&with, cell, &seen)).collect();
        for (a, outer_a) in within.iter().enumerate() {
            for (b, outer_b) in within.iter().enumerate() {
                if let (Some(outer_a), Some(outer_b)) = (*outer_a, *outer_b) {
                    let opened = with.sees(a, b) && !seen.sees(outer_a, outer_b);
                    assert!(!opened, "{name}: {a} sees {b} only with more solids");
                    closed += usize::from(!with.sees(a, b) && seen.sees(outer_a, outer_b));
                }
            }
        }
    }
    assert!(closed > 0, "no solid ever hid anything");
}

#[test]
fn a_view_cuts_off_what_is_outside_and_nothing_else() {
    let mut outside = 0;
    for (name, family, seed) in cases(3) {
        let case = Case::open(family, seed);
        let mut part = case.clone();
        // Every other view lies flush with faces.
        let unit = [1, 4][(seed % 2) as usize];
        let over = |numbers: [i64; 3]| numbers.map(|n| Rational::new(n.into(), unit.into()));
        let (low, high) =
            if unit == 1 { ([0, 1, -1], [5, 6, 4]) } else { ([1, 4, -6], [19, 24, 17]) };
        let view = AxialBox { low: over(low), high: over(high) };
        part.view = Some(view.clone());
        let (Some(whole), Some(seen)) = (Seen::of(&case), Seen::of(&part)) else {
            panic!("{name}: no cells")
        };
        check_sightlines(&seen, &part.occluders(), &name);
        implies(&seen, &whole, &Affine::identity(), &name);
        for Pair { points, .. } in &whole.pairs {
            let within = |point: &RationalPoint3| {
                let at = point.coordinates();
                (0..3).all(|i| view.low[i] <= at[i] && at[i] <= view.high[i])
            };
            match points.iter().all(within) {
                true => seen.must_see([&points[0], &points[1]], &name),
                false => outside += 1,
            }
        }
        let solid = seen.cells.subdivision.leaves.iter().filter(|leaf| leaf.solid);
        let volume = solid.map(|leaf| leaf.cell.volume()).sum::<Rational>() + seen.free_volume();
        let size = (0..3).map(|i| &view.high[i] - &view.low[i]);
        assert_eq!(volume, size.product::<Rational>(), "{name}");
    }
    assert!(outside > 0, "no view cut anything off");
}

/// The cell of `whole` that holds all of a cell of `part`, if one does.
fn holder(part: &Seen, cell: usize, whole: &Seen) -> Option<usize> {
    let corners = part.corners(cell);
    let at = whole.locate(&middle_of(&corners))?;
    let holds = |outer: usize| {
        corners.iter().all(|corner| {
            whole.cells.subdivision.locate(corner).contains(&whole.cells.leaves[outer])
        })
    };
    at.into_iter().find(|&outer| holds(outer))
}

#[test]
fn hints_refine_cells_and_nothing_else() {
    let mut finer = 0;
    for (name, family, seed) in cases(3) {
        let case = Case::closed(family, seed);
        let mut hinted = case.clone();
        hinted.hints.extend(of_family(&mut Random::new(seed ^ 0x417), Family::Cut));
        let (Some(seen), Some(fine)) = (Seen::of(&case), Seen::of(&hinted)) else {
            panic!("{name}: no cells")
        };
        assert_eq!(seen.free_volume(), fine.free_volume(), "{name}");
        check_sightlines(&fine, &hinted.occluders(), &name);
        let cells = fine.cells.leaves.len();
        let outer: Vec<usize> = (0..cells)
            .map(|cell| holder(&fine, cell, &seen).expect("a hint splits cells"))
            .collect();
        let size = seen.cells.leaves.len();
        finer += cells - size;
        // A cell sees another iff some part of it sees some part of the other.
        let mut open = vec![vec![false; size]; size];
        for a in 0..cells {
            for b in 0..cells {
                open[outer[a]][outer[b]] |= fine.sees(a, b);
            }
        }
        for (a, row) in open.iter().enumerate() {
            for (b, &open) in row.iter().enumerate() {
                assert_eq!(open, seen.sees(a, b), "{name}: {a} and {b}");
            }
        }
    }
    assert!(finer > 0, "no hint ever split a cell");
}
