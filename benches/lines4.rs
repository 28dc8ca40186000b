//! What exactness costs on four lines and those that pass their transversals: each predicate
//! against its own formula in plain floats, against its integer stages alone, and the transversals
//! in big rationals.
//!
//! The main figure: of four lines both transversals, and how twelve further lines pass each of
//! them. |coordinates| <= 2^20. Random lines; edges of axial boxes on six levels an axis, where two
//! of any four are parallel and discriminants are squares or zero. The lines of a query differ.
//! `-- --table` prints ratios to plain floats: least times over rounds in which the variants take
//! turns.

use criterion::Criterion;
use stabline::geom::{BigLine, Line, Point3};
use stabline::num::{Int, Sign, Surd};
use stabline::oracle::Random;
use stabline::predicates::{Budget, FourLines, Sides, side_of_transversals, transversal_count};
use stabline::stab::transversals::{IsolatedLine, transversals};
use std::hint::black_box;
use std::time::Instant;

const BITS: u32 = 20;
const POOL: usize = 256;
const QUERIES: usize = 1 << 12;
/// How many lines pass the transversals of four.
const TESTS: usize = 12;
/// As many queries are enough for big rationals.
const SLOW: usize = 1 << 6;

/// Direction and moment in plain floats.
type FloatLine = [[f64; 3]; 2];

struct Data {
    name: &'static str,
    lines: Vec<Line>,
    floats: Vec<FloatLine>,
    queries: Vec<Query>,
}

/// Four lines, and those to test against their transversals.
type Query = [usize; 4 + TESTS];

fn data(axial: bool) -> Data {
    let mut random = Random::new(u64::from(axial));
    let reach = 1i64 << BITS;
    let levels = [(); 3].map(|()| [(); 6].map(|()| random.between(-reach, reach)));
    let mut lines = Vec::new();
    while lines.len() < POOL {
        let p = if axial {
            levels.map(|level| level[random.between(0, 5) as usize])
        } else {
            [(); 3].map(|()| random.between(-reach, reach))
        };
        let q = if axial {
            let axis = random.between(0, 2) as usize;
            let mut q = p;
            q[axis] = levels[axis][random.between(0, 5) as usize];
            q
        } else {
            [(); 3].map(|()| random.between(-reach, reach))
        };
        if p != q {
            let point = |[x, y, z]: [i64; 3]| Point3::new(x, y, z).expect("within the range");
            lines.push(Line::through(&point(p), &point(q)).expect("within the range"));
        }
    }
    let floats = lines
        .iter()
        .map(|line| [line.direction().map(|d| d as f64), line.moment().map(|m| m as f64)])
        .collect();
    let mut query = || -> Query {
        let mut lines = [POOL; 4 + TESTS];
        for i in 0..lines.len() {
            while lines[i] == POOL || lines[..i].contains(&lines[i]) {
                lines[i] = random.between(0, POOL as i64 - 1) as usize;
            }
        }
        lines
    };
    let queries = (0..QUERIES).map(|_| query()).collect();
    Data { name: if axial { "axial" } else { "random" }, lines, floats, queries }
}

fn float_side([d, m]: &FloatLine, [e, n]: &FloatLine) -> f64 {
    (0..3).map(|i| d[i] * n[i] + m[i] * e[i]).sum()
}

/// The formula of `transversal_count`; as in most programs, a zero is whatever the sign says.
fn plain_count(l: [&FloatLine; 4]) -> i32 {
    let a = float_side(l[0], l[1]) * float_side(l[2], l[3]);
    let b = float_side(l[0], l[2]) * float_side(l[1], l[3]);
    let c = float_side(l[0], l[3]) * float_side(l[1], l[2]);
    let value = (a - b - c) * (a - b - c) - 4.0 * b * c;
    i32::from(value > 0.0) - i32::from(value < 0.0)
}

/// The 5x5 Gram determinant by elimination with pivots.
fn plain_side(l: [&FloatLine; 5]) -> i32 {
    let mut m: [[f64; 5]; 5] =
        std::array::from_fn(|i| std::array::from_fn(|j| float_side(l[i], l[j])));
    let mut sign = 1;
    for step in 0..5 {
        let pivot = (step..5).max_by(|&i, &j| m[i][step].abs().total_cmp(&m[j][step].abs()));
        let pivot = pivot.unwrap_or(step);
        if pivot != step {
            m.swap(pivot, step);
            sign = -sign;
        }
        if m[step][step] == 0.0 {
            return 0;
        }
        if m[step][step] < 0.0 {
            sign = -sign;
        }
        let pivot_row = m[step];
        for row in &mut m[step + 1..] {
            let factor = row[step] / pivot_row[step];
            for (entry, p) in row.iter_mut().zip(pivot_row) {
                *entry -= factor * p;
            }
        }
    }
    sign
}

/// Both transversals as H ± √D·W, with the formulas of `predicates::four_lines`: S the side
/// products, H from the adjugate of S, W from 4x4 minors.
fn plain_transversals(l: [&FloatLine; 4]) -> Option<[FloatLine; 2]> {
    let s = |i: usize, j: usize| float_side(l[i], l[j]);
    let [s12, s13, s14, s23, s24, s34] = [s(0, 1), s(0, 2), s(0, 3), s(1, 2), s(1, 3), s(2, 3)];
    let (a, b, c) = (s12 * s34, s13 * s24, s14 * s23);
    let (ta, tb, tc) = (a - b - c, b - a - c, c - a - b);
    let d = ta * ta - 4.0 * b * c;
    if d < 0.0 {
        return None;
    }
    let root = d.sqrt();
    let [f1, f2, f3, f4] = l.map(|[d, _]| d[0]);
    let (a12, a34, a13, a24, a14, a23) =
        (s34 * ta, s12 * ta, s24 * tb, s13 * tb, s23 * tc, s14 * tc);
    let h = [
        2.0 * s23 * s24 * s34 * f1 + a12 * f2 + a13 * f3 + a14 * f4,
        a12 * f1 + 2.0 * s13 * s14 * s34 * f2 + a23 * f3 + a24 * f4,
        a13 * f1 + a23 * f2 + 2.0 * s12 * s14 * s24 * f3 + a34 * f4,
        a14 * f1 + a24 * f2 + a34 * f3 + 2.0 * s12 * s13 * s23 * f4,
    ];
    let sum = |part: usize, k: usize| -> f64 { -(0..4).map(|i| h[i] * l[i][part][k]).sum::<f64>() };
    // The columns dx, dy, dz, my, mz of the four lines.
    let two = |x: &FloatLine, y: &FloatLine| {
        let ([[a, b, c], [_, d, e]], [[f, g, h], [_, i, j]]) = (x, y);
        [
            a * g - b * f,
            a * h - c * f,
            a * i - d * f,
            a * j - e * f,
            b * h - c * g,
            b * i - d * g,
            b * j - e * g,
            c * i - d * h,
            c * j - e * h,
            d * j - e * i,
        ]
    };
    let (p, q) = (two(l[0], l[1]), two(l[2], l[3]));
    let four = |i: usize, j: usize, k: usize, l: usize, m: usize, n: usize| {
        p[i] * q[j] + p[j] * q[i] - p[k] * q[l] - p[l] * q[k] + p[m] * q[n] + p[n] * q[m]
    };
    let w = [
        [0.0, four(0, 8, 1, 6, 3, 4), -four(0, 7, 1, 5, 2, 4)].map(|w| -w),
        [four(4, 9, 5, 8, 6, 7), -four(1, 9, 2, 8, 3, 7), four(0, 9, 2, 6, 3, 5)].map(|w| -w),
    ];
    let line = |root: f64| {
        let part = |p: usize| [0, 1, 2].map(|k| sum(p, k) + root * w[p][k]);
        let [direction, mut moment] = [part(0), part(1)];
        moment[0] += d;
        [direction, moment]
    };
    Some([line(root), line(-root)])
}

fn plain_each(data: &Data, query: &Query) -> i32 {
    let Some(lines) = plain_transversals([0, 1, 2, 3].map(|i| &data.floats[query[i]])) else {
        return 0;
    };
    let passes = |&fifth: &usize| {
        let [first, second] = lines.each_ref().map(|line| float_side(line, &data.floats[fifth]));
        sign_sum([Sign::of(&first), Sign::of(&second)])
    };
    query[4..].iter().map(passes).sum()
}

/// Takes part in the sum of a pass: which of both is positive must matter.
fn sign_sum([first, second]: [Sign; 2]) -> i32 {
    first as i32 + 3 * second as i32
}

fn each(data: &Data, query: &Query, budget: &Budget) -> i32 {
    let four = FourLines::new([0, 1, 2, 3].map(|i| &data.lines[query[i]]), budget);
    let passes = |&fifth: &usize| match four.sides_of_each(&data.lines[fifth]) {
        Sides::None => 0,
        Sides::One(sign) => sign as i32,
        Sides::Two(signs) => sign_sum(signs),
        Sides::Family => 1,
    };
    query[4..].iter().map(passes).sum()
}

/// The transversals with coordinates in Q(√D), and their sides.
fn rational_each(data: &Data, query: &Query) -> i32 {
    let four = [0, 1, 2, 3].map(|i| BigLine::from(data.lines[query[i]]));
    let lines = transversals(&four).isolated;
    let passes = |&fifth: &usize| -> i32 {
        let fifth = BigLine::from(data.lines[fifth]);
        let side = |line: &IsolatedLine| {
            let term = |x: &Surd, y: &Int| x * &Surd::from(y.clone());
            (0..3).fold(Surd::from(Int::from(0)), |sum, i| {
                let along = term(&line.direction[i], &fifth.moment[i]);
                &(&sum + &along) + &term(&line.moment[i], &fifth.direction[i])
            })
        };
        lines.iter().map(|line| side(line).sign() as i32).sum()
    };
    query[4..].iter().map(passes).sum()
}

/// A way to answer a query, and of how many.
struct Variant {
    name: &'static str,
    queries: usize,
    run: fn(&Data, &Query, &Budget) -> i32,
}

const fn variant(name: &'static str, run: fn(&Data, &Query, &Budget) -> i32) -> Variant {
    Variant { name, queries: QUERIES, run }
}

/// Each group begins with its plain floats.
const GROUPS: [&[Variant]; 3] = [
    &[
        variant("four lines, 24 sides, plain f64", |data, q, _| plain_each(data, q)),
        variant("four lines, 24 sides", each),
        variant("four lines, 24 sides, no filter", |data, q, budget| {
            each(data, q, &budget.without_filters())
        }),
        Variant {
            name: "four lines, 24 sides, rationals",
            queries: SLOW,
            run: |data, q, _| rational_each(data, q),
        },
    ],
    &[
        variant("count, plain f64", |data, q, _| {
            plain_count([0, 1, 2, 3].map(|i| &data.floats[q[i]]))
        }),
        variant("count", count),
        variant("count, no filter", |data, q, budget| count(data, q, &budget.without_filters())),
    ],
    &[
        variant("fifth line, plain f64", |data, q, _| {
            plain_side([0, 1, 2, 3, 4].map(|i| &data.floats[q[i]]))
        }),
        variant("fifth line", side),
        variant("fifth line, no filter", |data, q, budget| {
            side(data, q, &budget.without_filters())
        }),
    ],
];

fn count(data: &Data, query: &Query, budget: &Budget) -> i32 {
    transversal_count([0, 1, 2, 3].map(|i| &data.lines[query[i]]), budget) as i32
}

fn side(data: &Data, query: &Query, budget: &Budget) -> i32 {
    let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|i| &data.lines[query[i]]);
    side_of_transversals([a, b, c, d], e, budget) as i32
}

fn pass(variant: &Variant, data: &Data, budget: &Budget) -> i32 {
    data.queries[..variant.queries].iter().map(|query| (variant.run)(data, query, budget)).sum()
}

fn table() {
    let budget = Budget::for_bits(BITS);
    for data in [data(false), data(true)] {
        for group in GROUPS {
            let mut least = vec![f64::INFINITY; group.len()];
            for _ in 0..100 {
                for (least, variant) in least.iter_mut().zip(group) {
                    let start = Instant::now();
                    black_box(pass(variant, black_box(&data), black_box(&budget)));
                    let each = start.elapsed().as_secs_f64() / variant.queries as f64;
                    *least = least.min(each);
                }
            }
            for (variant, time) in group.iter().zip(&least) {
                let (ns, ratio) = (time * 1e9, time / least[0]);
                println!("{:<7} {:<32} {ns:>10.1} ns  {ratio:>8.2} x", data.name, variant.name);
            }
        }
    }
}

fn main() {
    if std::env::args().any(|argument| argument == "--table") {
        return table();
    }
    let mut criterion = Criterion::default().configure_from_args();
    let budget = Budget::for_bits(BITS);
    for data in [data(false), data(true)] {
        for variant in GROUPS.into_iter().flatten() {
            criterion.bench_function(&format!("{}, {}", data.name, variant.name), |bencher| {
                bencher.iter(|| black_box(pass(variant, black_box(&data), black_box(&budget))));
            });
        }
    }
    criterion.final_summary();
}
