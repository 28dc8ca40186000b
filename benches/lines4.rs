//! What exactness costs on four and five lines: each predicate against its own formula in plain
//! floats, and against its fixed-width stages alone.
//!
//! |coordinates| <= 2^20. Random lines; edges of axial boxes on six levels an axis, where two of
//! any four are parallel and most discriminants are squares or zero. `-- --table` prints ratios to
//! plain floats: least times over rounds in which the variants take turns.

use criterion::Criterion;
use stabline::geom::{Line, Point3};
use stabline::oracle::Random;
use stabline::predicates::{Budget, side_of_transversals, transversal_count};
use std::hint::black_box;
use std::time::{Duration, Instant};

const BITS: u32 = 20;
const POOL: usize = 256;
const QUERIES: usize = 1 << 12;

/// Direction and moment in plain floats.
type FloatLine = [[f64; 3]; 2];

struct Data {
    name: &'static str,
    lines: Vec<Line>,
    floats: Vec<FloatLine>,
    queries: Vec<[usize; 5]>,
}

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
    let queries = (0..QUERIES)
        .map(|_| [(); 5].map(|()| random.between(0, POOL as i64 - 1) as usize))
        .collect();
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

/// One pass of a variant over the queries; the result keeps the work alive.
type Variant = (&'static str, fn(&Data, &Budget) -> i32);

const VARIANTS: [Variant; 6] = [
    ("count, plain f64", |data, _| {
        data.queries.iter().map(|q| plain_count([0, 1, 2, 3].map(|i| &data.floats[q[i]]))).sum()
    }),
    ("count", count),
    ("count, no filter", |data, budget| count(data, &budget.without_filters())),
    ("fifth line, plain f64", |data, _| {
        data.queries.iter().map(|q| plain_side(q.map(|i| &data.floats[i]))).sum()
    }),
    ("fifth line", side),
    ("fifth line, no filter", |data, budget| side(data, &budget.without_filters())),
];

fn count(data: &Data, budget: &Budget) -> i32 {
    let one =
        |q: &[usize; 5]| transversal_count([0, 1, 2, 3].map(|i| &data.lines[q[i]]), budget) as i32;
    data.queries.iter().map(one).sum()
}

fn side(data: &Data, budget: &Budget) -> i32 {
    let one = |q: &[usize; 5]| {
        let [a, b, c, d, e] = q.map(|i| &data.lines[i]);
        side_of_transversals([a, b, c, d], e, budget) as i32
    };
    data.queries.iter().map(one).sum()
}

fn table() {
    let budget = Budget::for_bits(BITS);
    for data in [data(false), data(true)] {
        let mut least = [Duration::MAX; VARIANTS.len()];
        for _ in 0..40 {
            for (time, (_, variant)) in least.iter_mut().zip(VARIANTS) {
                let start = Instant::now();
                black_box(variant(black_box(&data), black_box(&budget)));
                *time = start.elapsed().min(*time);
            }
        }
        for (i, (name, _)) in VARIANTS.iter().enumerate() {
            let plain = least[i / 3 * 3].as_secs_f64();
            let each = least[i].as_secs_f64() * 1e9 / QUERIES as f64;
            let ratio = least[i].as_secs_f64() / plain;
            println!("{:<7} {name:<22} {each:>8.1} ns  {ratio:>6.2} x", data.name);
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
        for (name, variant) in VARIANTS {
            criterion.bench_function(&format!("{}, {name}", data.name), |bencher| {
                bencher.iter(|| black_box(variant(black_box(&data), black_box(&budget))));
            });
        }
    }
    criterion.final_summary();
}
