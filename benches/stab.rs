//! The cost of pushing one portal at depth 4, 8 and 16, exact against plain floats.
//!
//! The float twin is the same source compiled with `f64` for its numbers, signs taken as they
//! come: it costs what the algorithm costs, and its answers are worth nothing. Both sides copy the
//! parent's cone and push the rows of one quadrilateral. `cargo bench --bench stab` prints, before
//! the times, the size of each cone and what a pushed portal keeps in memory.

use criterion::{Criterion, criterion_group, criterion_main};
use stabline::geom::BigPoint3;
use stabline::num::Int;
use stabline::oracle::Random;
use stabline::stab::{Portal3, Stabber};
use std::hint::black_box;

// The modules below name the library's numbers as their own crate's.
use stabline::num;

#[path = "../src/stab/cone.rs"]
#[allow(dead_code, unused_imports, reason = "the bench uses a part of the cone, and no tests")]
mod cone;
#[path = "../src/stab/mask.rs"]
#[allow(dead_code, unused_imports, reason = "the bench uses a part of the cone, and no tests")]
mod mask;
#[path = "../src/stab/ring.rs"]
#[allow(dead_code, unused_imports, reason = "the bench uses a part of the cone, and no tests")]
mod ring;
#[path = "../src/stab/wedge.rs"]
#[allow(dead_code, unused_imports, reason = "the bench uses a part of the cone, and no tests")]
mod wedge;

use cone::Cone;
use num::{Int256, Sign};
use num_traits::ToPrimitive;
use ring::Ring;

impl Ring for f64 {
    type Narrow = f64;
    type Product = f64;

    const BUDGET: Option<u64> = None;

    fn narrow(value: &Int) -> Option<f64> {
        value.to_f64()
    }
    fn narrow_to_int(value: &f64) -> Int {
        Int::from(*value as i64)
    }
    fn zero_or_one(one: bool) -> f64 {
        f64::from(u8::from(one))
    }
    fn narrow_is_zero(value: &f64) -> bool {
        *value == 0.0
    }
    fn zero() -> f64 {
        0.0
    }
    fn one() -> f64 {
        1.0
    }
    // Without a tolerance on ranks, floats take dependent rows for independent ones and stop.
    fn is_zero(&self) -> bool {
        self.abs() < 1e-13
    }
    fn sign(&self) -> Sign {
        Sign::of(self)
    }
    fn negated(&self) -> f64 {
        -self
    }
    fn add_product(&mut self, factor: &f64, row: &f64) {
        *self += factor * row;
    }
    fn subtract_product(&mut self, factor: &f64, row: &f64) {
        *self -= factor * row;
    }
    fn to_int(&self) -> Int {
        Int::from(*self as i64)
    }
    fn from_int(value: &Int) -> Option<f64> {
        value.to_f64()
    }
    fn side(x: &[f64; 6], y: &[f64; 6]) -> f64 {
        (0..6).map(|i| x[i] * y[(i + 3) % 6]).sum()
    }
    fn sign_of(product: &f64) -> Sign {
        Sign::of(product)
    }
    fn square_exceeds(rs: &f64, rr: &f64, ss: &f64) -> bool {
        rs * rs > rr * ss
    }
}

type Quad = [[i64; 3]; 4];

/// A quadrilateral of the plane through `middle` along u and v, corners about ±`size` with jitter.
fn quad(random: &mut Random, middle: [i64; 3], u: [i64; 3], v: [i64; 3], size: i64) -> Quad {
    [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(|[i, j]| {
        let a = i * (size + random.between(0, size / 4));
        let b = j * (size + random.between(0, size / 4));
        std::array::from_fn(|k| middle[k] + a * u[k] + b * v[k])
    })
}

/// Tilted quadrilaterals along the z axis; coordinates up to 2^20.
fn oblique(random: &mut Random, index: i64) -> Quad {
    let mut tilt = |base: i64| base + random.between(-40, 40);
    let (u, v) = ([tilt(128), tilt(0), tilt(0)], [tilt(0), tilt(128), tilt(0)]);
    let middle = [random.between(-2000, 2000), random.between(-2000, 2000), index << 16];
    quad(random, middle, u, v, 128)
}

fn rectangle(random: &mut Random, index: i64, axis: usize) -> Quad {
    let middle = [index << 16; 3];
    let mut low = || -random.between(1 << 14, 1 << 15);
    let ends = [[low(), -low()], [low(), -low()]];
    [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[i, j]: [usize; 2]| {
        let mut corner = middle;
        corner[(axis + 1) % 3] += ends[0][i];
        corner[(axis + 2) % 3] += ends[1][j];
        corner
    })
}

fn parallel(random: &mut Random, index: i64) -> Quad {
    rectangle(random, index, 2)
}

fn turning(random: &mut Random, index: i64) -> Quad {
    rectangle(random, index, index as usize % 3)
}

fn portals(make: fn(&mut Random, i64) -> Quad) -> Vec<Portal3> {
    let mut random = Random::new(7);
    (0..16)
        .map(|index| {
            let corners = make(&mut random, index);
            let points = corners.map(|c| BigPoint3 { coordinates: c.map(Int::from) });
            Portal3::new(&points).expect("a planar convex quadrilateral")
        })
        .collect()
}

/// The rows of a portal as the stabber makes them: primitive edges, seen from `origin`.
fn rows(portal: &Portal3, origin: &[Int; 3]) -> Vec<[Int; 6]> {
    let at = |i: usize| {
        let p = &portal.vertices()[i % portal.vertices().len()].coordinates;
        [0, 1, 2].map(|k| &p[k] - &origin[k])
    };
    (0..portal.vertices().len())
        .map(|i| {
            let (p, q) = (at(i), at(i + 1));
            let d = [0, 1, 2].map(|k| &q[k] - &p[k]);
            let content = d.iter().fold(Int::ZERO, |g, c| num_integer::Integer::gcd(&g, c));
            let d = d.map(|c| c / &content);
            let [a, b, c] = [(1, 2), (2, 0), (0, 1)].map(|(i, j)| &p[i] * &d[j] - &p[j] * &d[i]);
            let [x, y, z] = d;
            [a, b, c, x, y, z]
        })
        .collect()
}

/// The row in the integers of a fixed width.
fn integers<R: Ring>(row: [Int; 6]) -> [R::Narrow; 6] {
    row.map(|c| R::narrow(&c).expect("in range"))
}

/// The row in floats, of length one.
fn floats(row: [Int; 6]) -> [f64; 6] {
    // Moments in units of the corridor's length, so that both halves count.
    let scaled = row.map(|c| c.to_f64().expect("in range"));
    let scaled: [f64; 6] = std::array::from_fn(|i| scaled[i] / if i < 3 { 1048576.0 } else { 1.0 });
    let length = scaled.iter().map(|c| c * c).sum::<f64>().sqrt();
    scaled.map(|c| c / length)
}

/// The cone of the first `depth` portals, and the rows of the next.
fn prepared<R: Ring>(
    portals: &[Portal3],
    depth: usize,
    narrow: fn([Int; 6]) -> [R::Narrow; 6],
) -> (Cone<R>, Vec<[R::Narrow; 6]>) {
    let origin = &portals[0].vertices()[0].coordinates;
    let mut cone = Cone::everything();
    for portal in &portals[..depth - 1] {
        for row in rows(portal, origin) {
            cone.push(&narrow(row));
        }
    }
    (cone, rows(&portals[depth - 1], origin).into_iter().map(narrow).collect())
}

fn pushed<R: Ring>((cone, rows): &(Cone<R>, Vec<[R::Narrow; 6]>)) -> Cone<R> {
    let mut cone = cone.clone();
    for row in rows {
        cone.push(row);
    }
    cone
}

fn bench_push(c: &mut Criterion) {
    type Maker = fn(&mut Random, i64) -> Quad;
    let families: [(&str, Maker); 3] =
        [("oblique", oblique), ("parallel", parallel), ("turning", turning)];
    for (name, make) in families {
        let portals = portals(make);
        for depth in [4, 8, 16] {
            let mut stabber = Stabber::new();
            portals[..depth].iter().for_each(|portal| stabber.push(portal, false));
            let shape = stabber.shape();
            println!("{name} {depth}: {shape}, open: {}", stabber.is_open());
            let mut group = c.benchmark_group(format!("push/{name}/{depth}"));
            let plain = prepared::<f64>(&portals, depth, floats);
            let kept = pushed(&plain).rays().len();
            println!("{name} {depth}: {kept} rays in floats");
            group.bench_function("f64", |b| b.iter(|| black_box(pushed(&plain))));
            if name == "oblique" {
                let exact = prepared::<Int256>(&portals, depth, integers::<Int256>);
                group.bench_function("exact", |b| b.iter(|| black_box(pushed(&exact))));
            } else {
                let exact = prepared::<i128>(&portals, depth, integers::<i128>);
                group.bench_function("exact", |b| b.iter(|| black_box(pushed(&exact))));
            }
            let refs: Vec<&Portal3> = portals[..depth].iter().collect();
            group.bench_function("decide_open", |b| {
                b.iter(|| black_box(stabline::stab::decide_open(&refs, &[])));
            });
            group.bench_function("is_open", |b| b.iter(|| black_box(stabber.is_open())));
        }
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10)
        .warm_up_time(std::time::Duration::from_millis(200))
        .measurement_time(std::time::Duration::from_millis(600));
    targets = bench_push
}
criterion_main!(benches);
