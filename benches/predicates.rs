//! What exactness costs: every predicate against the same formula in plain floats, against the
//! `robust` crate, its own fixed-width stage alone, and big rationals.
//!
//! The inputs are pools of points, lines and planes that fit the first cache, asked about in a
//! random order too long for a branch predictor to learn. After criterion's own report (or alone,
//! with `cargo bench --bench predicates -- --table`) a table of ratios to plain floats is
//! printed: of each variant's least time over a hundred rounds in which the variants take turns,
//! so that what else runs on the machine disturbs the least. |coordinates| <= 2^20 unless said
//! otherwise.

use criterion::Criterion;
use stabline::geom::{Line, Plane, Point2, Point3};
use stabline::num::{Int, Rational, Sign};
use stabline::predicates::filtered::{Approx3, Bound, FilteredLine, FilteredPlane};
use stabline::predicates::*;
use std::hint::black_box;
use std::time::Instant;

const BITS: u32 = 20;
const POOL: usize = 256;
const QUERIES: usize = 1 << 14;

/// Repeatable numbers (Steele, Lea and Flood, SplitMix, 2014).
struct Random(u64);

impl Random {
    fn below(&mut self, n: i64) -> i64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % n as u64) as i64
    }

    fn within(&mut self, c: i64) -> i64 {
        self.below(2 * c + 1) - c
    }
}

#[derive(Clone, Copy)]
enum Data {
    /// Anywhere in the box.
    Random,
    /// The corners of axial boxes on six levels an axis.
    Aligned,
    /// Within a unit of one oblique plane.
    NearlyDegenerate,
}

/// Pairs of points, the end points of edges.
fn edges(data: Data, bits: u32) -> Vec<[Point3; 2]> {
    let (mut random, c) = (Random(1), 1i64 << bits);
    let levels = [(); 3].map(|()| [(); 6].map(|()| random.within(c)));
    let mut axial = || [0, 1, 2].map(|k: usize| levels[k][random.below(6) as usize]);
    let mut edges: Vec<[[i64; 3]; 2]> = Vec::new();
    for i in 0..POOL {
        let mut edge = [axial(), axial()];
        // Edges of boxes: the end points differ along one axis.
        while edge[0][i % 3] == edge[1][i % 3] {
            edge[1] = axial();
        }
        edge[1] = std::array::from_fn(|k| edge[usize::from(k == i % 3)][k]);
        edges.push(edge);
    }
    let mut random = Random(2);
    for edge in edges.as_flattened_mut() {
        match data {
            Data::Aligned => {}
            Data::Random => *edge = [(); 3].map(|()| random.within(c)),
            Data::NearlyDegenerate => {
                let (x, y) = (random.within(c / 4), random.within(c / 4));
                *edge = [x + 2 * y, x - y, y - 2 * x + random.within(1)];
            }
        }
    }
    let point = |[x, y, z]: [i64; 3]| Point3::new(x, y, z).expect("within the range");
    edges.into_iter().map(|[p, q]| [point(p), point(q)]).collect()
}

/// Four different places of the pool.
type Query = [u16; 4];

/// Queries enough that no branch predictor learns their answers.
fn queries() -> Vec<Query> {
    let mut random = Random(3);
    let mut query = || {
        let mut places = [0u16; 4];
        for i in 0..4 {
            while places[i] == 0 || places[..i].contains(&places[i]) {
                places[i] = 1 + random.below(POOL as i64 - 1) as u16;
            }
        }
        places
    };
    (0..QUERIES).map(|_| query()).collect()
}

/// Answers queries; the sum of the signs.
type Run<'a> = Box<dyn Fn(&[Query]) -> i64 + 'a>;

/// One way to answer all queries; slow ones answer only the first few.
struct Variant<'a> {
    name: &'static str,
    queries: usize,
    run: Run<'a>,
}

/// A variant whose answer is an expression in the four places of a query.
macro_rules! variant {
    (
        $list:ident, $name:expr, $queries:expr,
        |$a:ident, $b:ident, $c:ident, $d:ident| $answer:expr
    ) => {
        $list.push(Variant {
            name: $name,
            queries: $queries,
            run: Box::new(|queries| {
                let mut sum = 0;
                for query in queries {
                    #[allow(unused_variables)]
                    let [$a, $b, $c, $d] = query.map(usize::from);
                    sum += $answer as i64;
                }
                sum
            }),
        })
    };
}

/// Criterion's report of one group, and the ratios to its first variant.
fn report(criterion: &mut Option<Criterion>, group: &str, variants: &[Variant]) {
    let queries = queries();
    if let Some(criterion) = criterion {
        let mut group = criterion.benchmark_group(group);
        for variant in variants {
            let queries = &queries[..variant.queries];
            group.throughput(criterion::Throughput::Elements(queries.len() as u64));
            group.bench_function(variant.name, |b| b.iter(|| (variant.run)(black_box(queries))));
        }
        group.finish();
        return;
    }
    let mut least = vec![f64::INFINITY; variants.len()];
    for _ in 0..101 {
        for (least, variant) in least.iter_mut().zip(variants) {
            let start = Instant::now();
            black_box((variant.run)(black_box(&queries[..variant.queries])));
            *least = least.min(start.elapsed().as_nanos() as f64 / variant.queries as f64);
        }
    }
    print!("{group:34} plain {:.2} ns |", least[0]);
    for (variant, time) in variants.iter().zip(&least).skip(1) {
        print!(" {} {:.2} |", variant.name, time / least[0]);
    }
    println!();
}

fn sub<T: Copy + std::ops::Sub<Output = T>>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// det[b-a, c-a, d-a] in big rationals.
fn rational_determinant(points: [&[Rational; 3]; 4]) -> Sign {
    let [a, b, c, d] = points;
    let minus = |x: &[Rational; 3]| -> [Rational; 3] { std::array::from_fn(|i| &x[i] - &a[i]) };
    let (u, v, w) = (minus(b), minus(c), minus(d));
    let minor = |i: usize, j: usize| &u[i] * &v[j] - &u[j] * &v[i];
    Sign::of(&(minor(1, 2) * &w[0] + minor(2, 0) * &w[1] + minor(0, 1) * &w[2]))
}

fn bench_points(criterion: &mut Option<Criterion>, name: &str, data: Data, bits: u32) {
    let budget = black_box(Budget::for_bits(bits));
    let wide = black_box(Budget::for_bits(33));
    let points: Vec<Point3> = edges(data, bits).into_iter().map(|[p, _]| p).collect();
    let floats: Vec<[f64; 3]> = points.iter().map(Point3::floats).collect();
    let rationals: Vec<[Rational; 3]> =
        points.iter().map(|p| p.integers().map(|c| Rational::from(Int::from(c)))).collect();
    let theirs: Vec<robust::Coord3D<f64>> =
        floats.iter().map(|&[x, y, z]| robust::Coord3D { x, y, z }).collect();
    let (p, f) = (&points, &floats);

    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, c, d| {
        let n = cross(sub(f[b], f[a]), sub(f[c], f[a]));
        Sign::of(&dot(n, sub(f[d], f[a])))
    });
    variant!(list, "ours", QUERIES, |a, b, c, d| orient3d(&p[a], &p[b], &p[c], &p[d], &budget));
    variant!(list, "ours, 33 bits", QUERIES, |a, b, c, d| {
        orient3d(&p[a], &p[b], &p[c], &p[d], &wide)
    });
    variant!(list, "fixed, 33 bits", QUERIES, |a, b, c, d| {
        orient3d_exact(&p[a], &p[b], &p[c], &p[d], &wide)
    });
    variant!(list, "robust", QUERIES, |a, b, c, d| {
        Sign::of(&-robust::orient3d(theirs[a], theirs[b], theirs[c], theirs[d]))
    });
    variant!(list, "rational", 32, |a, b, c, d| {
        rational_determinant([&rationals[a], &rationals[b], &rationals[c], &rationals[d]])
    });
    report(criterion, &format!("orient3d/{name}"), &list);

    let flat: Vec<Point2> = points
        .iter()
        .map(|p| Point2::new(p.integers()[0], p.integers()[1]).expect("within the range"))
        .collect();
    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, c, _d| {
        let (u, v) = (sub(f[b], f[a]), sub(f[c], f[a]));
        Sign::of(&(u[0] * v[1] - u[1] * v[0]))
    });
    variant!(list, "ours", QUERIES, |a, b, c, _d| orient2d(&flat[a], &flat[b], &flat[c]));
    variant!(list, "robust", QUERIES, |a, b, c, _d| {
        let [s, t, u] = [a, b, c].map(|i| robust::Coord { x: f[i][0], y: f[i][1] });
        Sign::of(&robust::orient2d(s, t, u))
    });
    report(criterion, &format!("orient2d/{name}"), &list);

    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, c, d| {
        Sign::of(&dot(sub(f[b], f[a]), sub(f[d], f[c])))
    });
    variant!(list, "ours", QUERIES, |a, b, c, d| {
        compare_along_line(&p[a], &p[b], &p[c], &p[d])
    });
    report(criterion, &format!("compare_along_line/{name}"), &list);
}

fn bench_lines(criterion: &mut Option<Criterion>, name: &str, data: Data, bits: u32) {
    let budget = black_box(Budget::for_bits(bits));
    let (off, wide) = (budget.without_filters(), black_box(Budget::for_bits(33)));
    let edges = edges(data, bits);
    let lines: Vec<Line> =
        edges.iter().map(|[p, q]| Line::through(p, q).expect("within the range")).collect();
    let floats: Vec<([f64; 3], [f64; 3])> = lines
        .iter()
        .map(|line| (line.paired_direction().map(|[d, _]| d), line.moment().map(|m| m as f64)))
        .collect();
    let theirs: Vec<[robust::Coord3D<f64>; 2]> = edges
        .iter()
        .map(|edge| edge.map(|p| p.floats()).map(|[x, y, z]| robust::Coord3D { x, y, z }))
        .collect();
    let (l, f) = (&lines, &floats);
    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, _c, _d| {
        Sign::of(&(dot(f[a].0, f[b].1) + dot(f[a].1, f[b].0)))
    });
    variant!(list, "ours", QUERIES, |a, b, _c, _d| side_of_lines(&l[a], &l[b], &budget));
    variant!(list, "ours, 33 bits", QUERIES, |a, b, _c, _d| side_of_lines(&l[a], &l[b], &wide));
    variant!(list, "fixed", QUERIES, |a, b, _c, _d| side_of_lines(&l[a], &l[b], &off));
    variant!(list, "robust", QUERIES, |a, b, _c, _d| {
        let ([p, q], [r, s]) = (theirs[a], theirs[b]);
        Sign::of(&-robust::orient3d(p, q, r, s))
    });
    report(criterion, &format!("side_of_lines/{name}"), &list);
}

fn bench_planes(criterion: &mut Option<Criterion>, name: &str, data: Data, bits: u32) {
    let budget = black_box(Budget::for_bits(bits));
    let off = budget.without_filters();
    let edges = edges(data, bits);
    let points: Vec<Point3> = edges.iter().map(|[p, _]| *p).collect();
    let planes: Vec<Plane> = edges
        .iter()
        .zip(points.iter().rev())
        .map(|([p, q], r)| Plane::through(p, q, r).expect("within the range"))
        .collect();
    let floats: Vec<[f64; 3]> = points.iter().map(Point3::floats).collect();
    let coefficients: Vec<([f64; 3], f64)> = planes.iter().map(|plane| *plane.floats()).collect();
    let (p, l, f, g) = (&points, &planes, &floats, &coefficients);
    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, _c, _d| Sign::of(&(dot(g[a].0, f[b]) - g[a].1)));
    variant!(list, "ours", QUERIES, |a, b, _c, _d| side_of_plane(&l[a], &p[b], &budget));
    report(criterion, &format!("side_of_plane/{name}"), &list);

    let meet = |a: usize, b: usize| {
        let ((n, o), (m, q)) = (g[a], g[b]);
        (cross(n, m), sub(n.map(|n| n * q), m.map(|m| m * o)))
    };
    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, c, d| {
        let (x, y) = (meet(a, b), meet(c, d));
        Sign::of(&(dot(x.0, y.1) + dot(x.1, y.0)))
    });
    variant!(list, "ours", QUERIES, |a, b, c, d| {
        side_of_meets([&l[a], &l[b]], [&l[c], &l[d]], &budget)
    });
    variant!(list, "fixed", QUERIES, |a, b, c, d| {
        side_of_meets([&l[a], &l[b]], [&l[c], &l[d]], &off)
    });
    report(criterion, &format!("side_of_meets/{name}"), &list);

    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, c, d| {
        let (x, y) = (meet(a, b), meet(c, d));
        let spanned = Sign::of(&dot(x.0, g[c].0));
        -Sign::of(&(dot(x.0, y.1) + dot(x.1, y.0))) * spanned
    });
    variant!(list, "ours", QUERIES, |a, b, c, d| {
        vertex_side_of_plane([&l[a], &l[b], &l[c]], &l[d], &budget).map_or(0, |sign| sign as i64)
    });
    report(criterion, &format!("vertex_side_of_plane/{name}"), &list);

    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, c, d| {
        let direction = sub(f[b], f[a]);
        let crossing = |i: usize| (g[i].1 - dot(g[i].0, f[a]), dot(g[i].0, direction));
        let ((s, t), (u, v)) = (crossing(c), crossing(d));
        Sign::of(&(u * t - s * v)) * Sign::of(&t) * Sign::of(&v)
    });
    variant!(list, "ours", QUERIES, |a, b, c, d| {
        compare_crossings(&p[a], &p[b], &l[c], &l[d], &budget).map_or(0, |sign| sign as i64)
    });
    report(criterion, &format!("compare_crossings/{name}"), &list);
}

/// World coordinates up to 4096: the same edges, scaled, as integers or as decimals.
fn bench_filtered(criterion: &mut Option<Criterion>, name: &str, data: Data, integers: bool) {
    let world = |p: &Point3| {
        let scaled = p.floats().map(|c| c / 256.0);
        if integers { Approx3::exact(scaled.map(f64::floor)) } else { Approx3::rounded(scaled) }
    };
    let points: Vec<[Approx3; 2]> =
        edges(data, BITS).iter().map(|[p, q]| [world(p), world(q)]).collect();
    let bound = Bound::of(points.as_flattened());
    let lines: Vec<FilteredLine> =
        points.iter().map(|[p, q]| FilteredLine::through(p, q, bound)).collect();
    let planes: Vec<FilteredPlane> = points
        .iter()
        .zip(points.iter().rev())
        .map(|([p, q], [r, _])| FilteredPlane::through(p, q, r, bound))
        .collect();
    let floats: Vec<[f64; 3]> = points.iter().map(|[p, _]| p.floats()).collect();
    let coefficients: Vec<([f64; 3], f64)> = planes
        .iter()
        .zip(&points)
        .map(|(plane, [p, _])| (plane.normal(), dot(plane.normal(), p.floats())))
        .collect();
    let plucker: Vec<([f64; 3], [f64; 3])> = lines.iter().map(FilteredLine::coordinates).collect();
    let (f, g, h) = (&floats, &coefficients, &plucker);
    let sign = |sign: Option<Sign>| sign.map_or(2, |sign| sign as i64);
    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, _c, _d| Sign::of(&(dot(g[a].0, f[b]) - g[a].1)));
    variant!(list, "filtered", QUERIES, |a, b, _c, _d| sign(planes[a].side(&points[b][0])));
    report(criterion, &format!("filtered plane/{name}"), &list);
    let mut list = Vec::new();
    variant!(list, "plain", QUERIES, |a, b, _c, _d| {
        Sign::of(&(dot(h[a].0, h[b].1) + dot(h[a].1, h[b].0)))
    });
    variant!(list, "filtered", QUERIES, |a, b, _c, _d| sign(lines[a].side_of_edge(&lines[b])));
    report(criterion, &format!("filtered line/{name}"), &list);
}

fn main() {
    let table_only = std::env::args().any(|argument| argument == "--table");
    let criterion = || Criterion::default().configure_from_args();
    let passes = if table_only { vec![None] } else { vec![Some(criterion()), None] };
    for mut criterion in passes {
        let data = [
            ("random", Data::Random, BITS),
            ("aligned", Data::Aligned, BITS),
            ("near-degenerate", Data::NearlyDegenerate, BITS),
            ("random, 16 bits", Data::Random, 16),
            ("aligned, 16 bits", Data::Aligned, 16),
        ];
        for (name, data, bits) in data {
            bench_points(&mut criterion, name, data, bits);
            bench_lines(&mut criterion, name, data, bits);
            bench_planes(&mut criterion, name, data, bits);
        }
        bench_filtered(&mut criterion, "random integers", Data::Random, true);
        bench_filtered(&mut criterion, "aligned integers", Data::Aligned, true);
        bench_filtered(&mut criterion, "random decimals", Data::Random, false);
        if let Some(criterion) = &criterion {
            criterion.final_summary();
        }
    }
}
