//! Eye queries on random portal graphs against a brute-force twin, and their laws.
//!
//! The twin walks over all sequences without pruning and asks of each whether the half-spaces of
//! all its planes have a direction in common: the rays of the closed cone are among the meets of
//! all pairs of planes, and their sum is strictly inside if anything is.

mod support;

use num_traits::{Signed, Zero};
use stabline::eye::{Answer, Cull, EyeGraph, Frustum, Query};
use stabline::geom::RationalPoint3;
use stabline::num::{Int, Rational};
use stabline::oracle::Random;
use stabline::pvs;
use stabline::report::{Silent, Verdict};
use stabline::scene::{CellId, PortalGraph};
use support::graphs::{Family, Graph, Point, integer};

const FAMILIES: [Family; 3] = [Family::Rooms, Family::Convex, Family::Skew];

/// A portal's vertices in world coordinates.
fn polygon(graph: &PortalGraph, portal: usize) -> Vec<Point> {
    let place = |&vertex: &u32| {
        let vertex = &graph.vertices[vertex as usize];
        let ratio = |c: &Int| Rational::new(c.clone(), vertex.denominator().clone());
        vertex.numerators().each_ref().map(ratio)
    };
    graph.portals[portal].vertices.iter().map(place).collect()
}

fn point(p: &Point) -> RationalPoint3 {
    let common = p.iter().fold(Int::from(1), |c, x| c * x.denom());
    RationalPoint3::new(p.each_ref().map(|c| c.numer() * (&common / c.denom())), common)
}

fn minus(a: &Point, b: &Point) -> Point {
    [0, 1, 2].map(|i| &a[i] - &b[i])
}

fn dot(a: &Point, b: &Point) -> Rational {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Point, b: &Point) -> Point {
    [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &a[i] * &b[j] - &a[j] * &b[i])
}

/// Whether some direction is strictly on the positive side of all planes, whose closed half-spaces
/// have no line in common.
fn feasible(planes: &[Point]) -> bool {
    let mut sum = [0, 0, 0].map(integer);
    for (i, a) in planes.iter().enumerate() {
        for b in &planes[..i] {
            let ray = cross(a, b);
            for ray in [ray.clone(), ray.map(|c| -c)] {
                if planes.iter().all(|n| !dot(n, &ray).is_negative()) {
                    sum = [0, 1, 2].map(|i| &sum[i] + &ray[i]);
                }
            }
        }
    }
    planes.iter().all(|n| dot(n, &sum).is_positive())
}

/// A map of space.
type Move = fn(&Point) -> Point;

/// The twin: the polygons of a graph, an eye, and the planes of a frustum.
struct Twin<'a> {
    graph: &'a PortalGraph,
    polygons: Vec<Vec<Point>>,
    eye: Point,
    frustum: Vec<Point>,
}

impl Twin<'_> {
    fn of(&self, cell: u32) -> Vec<(usize, bool, u32)> {
        let portals = self.graph.portals.iter().enumerate();
        let near = portals.filter_map(|(index, portal)| {
            let (from, to) = (portal.from.0, portal.to.0);
            let far = if from == cell { to } else { from };
            (from == cell || to == cell).then_some((index, from == cell, far))
        });
        near.collect()
    }

    /// The normal that leaves the cell through the portal, and n·(p - eye).
    fn forward(&self, portal: usize, along: bool) -> (Point, Rational) {
        let [a, b, c] = [0, 1, 2].map(|i| &self.polygons[portal][i]);
        let normal = cross(&minus(b, a), &minus(c, a));
        let normal = if along { normal } else { normal.map(|c| -c) };
        let depth = dot(&normal, &minus(a, &self.eye));
        (normal, depth)
    }

    fn bounds(&self, cell: u32, portal: usize, along: bool) -> bool {
        let (normal, depth) = self.forward(portal, along);
        let mut vertices = self.of(cell).into_iter().flat_map(|(i, ..)| &self.polygons[i]);
        vertices.all(|v| dot(&normal, &minus(v, &self.eye)) <= depth)
    }

    fn is_outside(&self, cell: u32) -> bool {
        let mut portals = self.of(cell).into_iter();
        portals.any(|(portal, along, _)| {
            self.forward(portal, along).1.is_negative() && self.bounds(cell, portal, along)
        })
    }

    fn is_in_portal(&self, portal: usize) -> bool {
        let (normal, depth) = self.forward(portal, true);
        let polygon = &self.polygons[portal];
        depth.is_zero()
            && polygon.iter().zip(polygon.iter().cycle().skip(1)).all(|(a, b)| {
                !dot(&normal, &cross(&minus(b, a), &minus(&self.eye, a))).is_negative()
            })
    }

    fn eye_cells(&self, cell: u32) -> Vec<u32> {
        let mut cells = vec![cell];
        let mut next = 0;
        while next < cells.len() {
            for (portal, _, far) in self.of(cells[next]) {
                if self.is_in_portal(portal) && !cells.contains(&far) {
                    cells.push(far);
                }
            }
            next += 1;
        }
        cells
    }

    fn limits(&self, cell: u32) -> Vec<Point> {
        let mut planes = self.frustum.clone();
        for (portal, along, _) in self.of(cell) {
            let (normal, depth) = self.forward(portal, along);
            if depth.is_zero() && self.bounds(cell, portal, along) {
                planes.push(normal.map(|c| -c));
            }
        }
        planes
    }

    /// For each cell whether it is seen, and how many sequences are.
    fn seen(&self, cell: u32) -> (Vec<bool>, u64) {
        let mut seen = vec![false; self.graph.cells.len()];
        let mut sequences = 0;
        for start in self.eye_cells(cell) {
            let limits = self.limits(start);
            // An octant at a time, so that no line is left.
            let sees_start = (0..8).any(|octant| {
                let mut planes = limits.clone();
                for i in 0..3 {
                    let sign = if octant >> i & 1 == 0 { 1 } else { -1 };
                    planes.push([0, 1, 2].map(|k| integer(if i == k { sign } else { 0 })));
                }
                feasible(&planes)
            });
            if sees_start {
                seen[start as usize] = true;
                self.walk(&mut vec![start], None, &limits, &mut seen, &mut sequences);
            }
        }
        (seen, sequences)
    }

    fn walk(
        &self,
        path: &mut Vec<u32>,
        last: Option<(Point, Rational)>,
        planes: &[Point],
        seen: &mut [bool],
        sequences: &mut u64,
    ) {
        for (portal, along, far) in self.of(path[path.len() - 1]) {
            let (normal, depth) = self.forward(portal, along);
            if path.contains(&far) || !depth.is_positive() {
                continue;
            }
            let mut planes = planes.to_vec();
            let polygon = &self.polygons[portal];
            for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
                let plane = cross(&minus(a, &self.eye), &minus(b, &self.eye));
                planes.push(if along { plane } else { plane.map(|c| -c) });
            }
            if let Some((n, h)) = &last {
                let order = [0, 1, 2].map(|i| &depth * &n[i] - h * &normal[i]);
                // Portals of one plane have no order.
                if order.iter().any(|c| !c.is_zero()) {
                    planes.push(order);
                }
            }
            let open = feasible(&planes);
            if open {
                seen[far as usize] = true;
                *sequences += 1;
            }
            // No pruning while graphs are small: dead ends are walked into as well.
            if open || path.len() < 3 {
                path.push(far);
                self.walk(path, Some((normal, depth)), &planes, seen, sequences);
                path.pop();
            }
        }
    }
}

/// An eye somewhere: in the middle of the graph's box, at a vertex, on an edge, in a portal, or on
/// a portal's plane.
fn random_eye(random: &mut Random, polygons: &[Vec<Point>]) -> Point {
    let mut pick = |count: usize| random.between(0, count as i64 - 1) as usize;
    let polygon = &polygons[pick(polygons.len())];
    let first = pick(polygon.len());
    let [a, b] = [first, first + 1].map(|i| &polygon[i % polygon.len()]);
    let other = &polygons[pick(polygons.len())][0];
    let middle = |p: &Point, q: &Point| [0, 1, 2].map(|i| (&p[i] + &q[i]) / Int::from(2));
    let opposite = &polygon[(first + 2) % polygon.len()];
    match pick(6) {
        0 => a.clone(),
        1 => middle(a, b),
        2 => middle(&middle(a, b), opposite),
        // In the plane, maybe outside of the portal.
        3 => [0, 1, 2].map(|i| &a[i] + (&b[i] - &opposite[i]) * integer(2)),
        _ => {
            let shift = [0; 3].map(|_| Rational::new(pick(9).into(), 7.into()));
            let between = middle(&middle(a, opposite), other);
            [0, 1, 2].map(|i| &between[i] + &shift[i])
        }
    }
}

fn random_frustum(random: &mut Random) -> Option<Frustum> {
    if random.one_in(2) {
        return None;
    }
    let mut vector = || [0; 3].map(|_| integer(random.between(-3, 3)));
    let (look, up) = (vector(), vector());
    let tangent = Rational::new(random.between(1, 9).into(), 4.into());
    Frustum::new(&look, &up, &[tangent, integer(1)]).ok()
}

fn cells(answer: &Answer) -> Vec<u32> {
    answer.cells.iter().map(|reached| reached.cell.0).collect()
}

fn is_subset(a: &Answer, b: &Answer) -> bool {
    let b = cells(b);
    cells(a).iter().all(|cell| b.contains(cell))
}

/// Calls `check` with many graphs, each with eyes in the cells that may hold them.
fn each_case(mut check: impl FnMut(&str, &Graph, &Query, &Twin, Answer)) {
    let count = std::env::var("STABLINE_GRAPHS").ok().and_then(|n| n.parse().ok()).unwrap_or(40);
    for family in FAMILIES {
        for seed in 0..count {
            let raw = Graph::random(family, 31_000 + seed);
            let graph = raw.validated();
            if graph.portals.is_empty() {
                continue;
            }
            let polygons: Vec<_> = (0..graph.portals.len()).map(|p| polygon(&graph, p)).collect();
            let mut random = Random::new(seed);
            let eyes = EyeGraph::new(&graph);
            for _ in 0..6 {
                let eye = random_eye(&mut random, &polygons);
                let frustum = random_frustum(&mut random);
                let cell = random.between(0, graph.cells.len() as i64 - 1) as u32;
                let at = point(&eye);
                let planes = frustum.as_ref().map(|f| f.planes().to_vec()).unwrap_or_default();
                let frustum_planes = planes.into_iter().map(|n| n.map(Rational::from)).collect();
                let twin = Twin {
                    graph: &graph,
                    polygons: polygons.clone(),
                    eye: eye.clone(),
                    frustum: frustum_planes,
                };
                let name = format!("{family:?} {seed}: {eye:?} in {cell}");
                let query = Query {
                    eye: &at,
                    frustum: frustum.as_ref(),
                    cell: Some(CellId(cell)),
                    regions: true,
                };
                match eyes.look(&query, Cull::Exact) {
                    Ok(answer) => check(&name, &raw, &query, &twin, answer),
                    Err(_) => assert!(twin.is_outside(cell), "{name}"),
                }
            }
        }
    }
}

#[test]
fn cells_seen_are_those_of_the_twin() {
    let (mut cases, mut total) = (0, 0);
    each_case(|name, _, query, twin, answer| {
        let cell = query.cell.unwrap().0;
        assert!(!twin.is_outside(cell), "{name}");
        let (seen, sequences) = twin.seen(cell);
        let expected: Vec<u32> = (0..).zip(&seen).filter(|(_, s)| **s).map(|(c, _)| c).collect();
        assert_eq!(cells(&answer), expected, "{name}");
        assert_eq!(answer.sequences, sequences, "{name}");
        cases += 1;
        total += sequences;
    });
    assert!(cases > 200 && total > 400, "{cases} cases, {total} sequences");
}

#[test]
fn witnesses_and_regions_are_inside() {
    each_case(|name, _, _, twin, answer| {
        let strictly_through = |portal: usize, v: &Point, strict: bool| {
            let polygon = &twin.polygons[portal];
            let turned = twin.forward(portal, true).1.is_negative();
            polygon.iter().zip(polygon.iter().cycle().skip(1)).all(|(a, b)| {
                let plane = cross(&minus(a, &twin.eye), &minus(b, &twin.eye));
                let side = if turned { -dot(&plane, v) } else { dot(&plane, v) };
                side.is_positive() || (!strict && side.is_zero())
            })
        };
        for reached in &answer.cells {
            let v = reached.direction.clone().unwrap().map(Rational::from);
            assert!(twin.frustum.iter().all(|n| dot(n, &v).is_positive()), "{name}");
            let mut portals = reached.portals.iter().map(|p| p.0 as usize);
            assert!(portals.all(|portal| strictly_through(portal, &v, true)), "{name}");
        }
        assert_eq!(answer.regions.len() as u64, answer.sequences);
        for region in &answer.regions {
            assert!(region.doubled_area_squared.is_positive(), "{name}");
            let last = region.portals[region.portals.len() - 1].0 as usize;
            let (normal, depth) = twin.forward(last, true);
            for vertex in &region.polygon {
                let d = vertex.denominator();
                let place = vertex.numerators().clone().map(|c| Rational::new(c, d.clone()));
                let v = minus(&place, &twin.eye);
                assert_eq!(dot(&normal, &v), depth, "{name}");
                let mut portals = region.portals.iter().map(|p| p.0 as usize);
                assert!(portals.all(|portal| strictly_through(portal, &v, false)), "{name}");
            }
        }
    });
}

#[test]
fn culls_never_miss_a_cell() {
    each_case(|name, raw, query, _, exact| {
        let graph = raw.validated();
        let eyes = EyeGraph::new(&graph);
        let cull = |cull| eyes.look(query, cull).unwrap();
        let [flood, portals, float] = [Cull::Flood, Cull::Portals, Cull::Float].map(cull);
        for (one, other) in
            [(&exact, &float), (&exact, &portals), (&portals, &flood), (&float, &flood)]
        {
            assert!(is_subset(one, other), "{name}: {:?} {:?}", cells(one), cells(other));
        }
    });
}

#[test]
fn an_eye_sees_no_more_than_its_cell() {
    each_case(|name, raw, query, twin, answer| {
        let graph = raw.validated();
        if twin.eye_cells(query.cell.unwrap().0).len() > 1 {
            return;
        }
        let finished = pvs::compute(&graph, &Default::default(), Vec::new(), &|_| {}, &Silent);
        let matrix = pvs::assemble(&graph, &finished.rows);
        for cell in cells(&answer) {
            let verdict = matrix.get(query.cell.unwrap().0 as usize, cell as usize);
            assert_eq!(verdict, Verdict::Open, "{name}: {cell}");
        }
    });
}

#[test]
fn moving_scaling_and_mirroring_change_no_answer() {
    each_case(|name, raw, query, twin, answer| {
        if query.frustum.is_some() {
            return;
        }
        let maps: [(bool, Move); 2] = [
            (false, |p| {
                [0, 1, 2].map(|i| &p[i] * Rational::new(7.into(), 3.into()) + integer(i as i64 - 5))
            }),
            (true, |[x, y, z]| [-x.clone(), y.clone(), z.clone()]),
        ];
        for (mirrors, map) in maps {
            let graph = raw.mapped(mirrors, map).validated();
            let eye = point(&map(&twin.eye));
            let query = Query { eye: &eye, regions: false, ..*query };
            // Skew portals that are turned over are cut into other triangles.
            if mirrors && graph.skew_portals + graph.repairs.dented_portals > 0 {
                continue;
            }
            let moved = EyeGraph::new(&graph).look(&query, Cull::Exact).unwrap();
            assert_eq!(cells(&moved), cells(&answer), "{name}");
            assert_eq!(moved.sequences, answer.sequences, "{name}");
        }
    });
}
