//! The cost of an exact hourglass per portal, against the same code on plain floats.
//!
//! The float twin is `stab::hourglass`'s chains on points in `f64`, signs taken as they come: it
//! costs what the algorithm costs, and its answers are worth nothing where it matters. A run pushes
//! m portals that stay open and pops them again; the table shows nanoseconds per portal, the least
//! of rounds in which the variants take turns.
//!
//! `cargo bench --bench hourglass -- --table` prints the table only.

use criterion::{Criterion, criterion_group};
use stabline::num::Int;
use stabline::oracle::Random;
use stabline::predicates::{PlanPoint, PlanPoints};
use std::cmp::Ordering;
use std::hint::black_box;
use std::time::Instant;

// The module below names the library's numbers and predicates as its own crate's.
use stabline::{num, predicates};

#[path = "../src/stab/hourglass/chains.rs"]
#[allow(dead_code, unused_imports, reason = "the bench uses a part of the chains, and no tests")]
mod chains;
#[path = "../src/stab/hourglass/window.rs"]
mod window;

use chains::{Chains, Ends, Place};
use num::Sign;

/// Points in floats.
struct Floats(Vec<[f64; 2]>);

impl Ends for Floats {
    #[inline]
    fn turn(&self, a: u32, b: u32, c: u32) -> Sign {
        let [[ax, ay], [bx, by], [cx, cy]] = [a, b, c].map(|end| self.0[end as usize]);
        let turn = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        if turn > 0.0 {
            Sign::Positive
        } else if turn < 0.0 {
            Sign::Negative
        } else {
            Sign::Zero
        }
    }

    fn order(&self, a: u32, b: u32) -> Ordering {
        let [a, b] = [a, b].map(|end| self.0[end as usize]);
        a.partial_cmp(&b).unwrap_or(Ordering::Equal)
    }
}

/// A sequence of portals that is open: each `[left, right]`, in units of one over `Case::unit`.
type Sequence = Vec<[[i64; 2]; 2]>;

struct Case {
    name: &'static str,
    unit: i64,
    make: fn(&mut Random, i64) -> [[i64; 2]; 2],
}

/// Doors across a hall, square to it.
fn doors(random: &mut Random, index: i64) -> [[i64; 2]; 2] {
    let y = index * 64;
    [[-random.between(1, 40), y], [random.between(1, 40), y]]
}

/// Openings of any direction.
fn oblique(random: &mut Random, index: i64) -> [[i64; 2]; 2] {
    let mut side = |sign: i64| {
        let y = index * 4096 + random.between(-2000, 2000);
        [sign * random.between(1, 4000), y]
    };
    [side(-1), side(1)]
}

/// Walls that bend towards each other: all ends of one half lie on the hulls.
fn bent(_: &mut Random, index: i64) -> [[i64; 2]; 2] {
    let bend = (index - 32) * (index - 32);
    [[-1000 - bend, index * 64], [1000 + bend, index * 64]]
}

const CASES: [Case; 4] = [
    Case { name: "doors", unit: 1, make: doors },
    Case { name: "oblique", unit: 1, make: oblique },
    Case { name: "bent", unit: 1, make: bent },
    Case { name: "oblique/7", unit: 7, make: oblique },
];

const LENGTHS: [usize; 4] = [4, 8, 16, 64];

/// Different sequences, so that no branch is learnt by heart.
const SEQUENCES: u64 = 32;

/// The same sequences in both kinds of numbers, each portal by its ends' numbers.
struct Prepared {
    exact: PlanPoints,
    floats: Floats,
    sequences: Vec<Vec<[u32; 2]>>,
}

fn prepare(case: &Case, length: usize) -> Prepared {
    let mut prepared = Prepared {
        exact: PlanPoints::default(),
        floats: Floats(Vec::new()),
        sequences: Vec::new(),
    };
    for seed in 0..SEQUENCES {
        let mut random = Random::new(seed);
        let portals: Sequence = (0..length as i64).map(|i| (case.make)(&mut random, i)).collect();
        let mut number = |[x, y]: [i64; 2]| {
            let number = prepared.exact.insert(PlanPoint::new([x, y, case.unit].map(Int::from)));
            if number as usize == prepared.floats.0.len() {
                prepared.floats.0.push([x, y].map(|c| c as f64 / case.unit as f64));
            }
            number
        };
        prepared.sequences.push(portals.iter().map(|ends| ends.map(&mut number)).collect());
    }
    prepared
}

/// Pushes and pops every sequence.
fn run(chains: &mut Chains, ends: &impl Ends, sequences: &[Vec<[u32; 2]>], place: Place) -> usize {
    let mut open = 0;
    for sequence in sequences {
        for &[left, right] in sequence {
            open += usize::from(chains.push(ends, left, right, place));
        }
        for _ in sequence {
            chains.pop();
        }
    }
    open
}

/// The time per portal of exact ends, of floats, and of exact ends that may lie anywhere.
fn table() {
    println!(
        "{:>10} {:>3} {:>9} {:>9} {:>6} {:>13} {:>6}",
        "", "m", "exact/ns", "f64/ns", "ratio", "any order/ns", "ratio"
    );
    for case in &CASES {
        for length in LENGTHS {
            let Prepared { exact, floats, sequences } = prepare(case, length);
            let portals = length * sequences.len();
            let mut chains = Chains::default();
            for place in [Place::Beyond, Place::Anywhere] {
                let open = run(&mut chains, &exact, &sequences, place);
                assert_eq!(open, portals, "{} {length}: all stay open", case.name);
            }
            let mut least = [f64::INFINITY; 4];
            let repeats = 20_000 / portals + 1;
            for _ in 0..60 {
                let mut time = |variant: usize, chains: &mut Chains| {
                    let start = Instant::now();
                    for _ in 0..repeats {
                        black_box(match variant {
                            0 => run(chains, &exact, &sequences, Place::Beyond),
                            1 => run(chains, &floats, &sequences, Place::Beyond),
                            2 => run(chains, &exact, &sequences, Place::Anywhere),
                            _ => run(chains, &floats, &sequences, Place::Anywhere),
                        });
                    }
                    let each = start.elapsed().as_nanos() as f64 / (repeats * portals) as f64;
                    least[variant] = least[variant].min(each);
                };
                (0..4).for_each(|variant| time(variant, &mut chains));
            }
            println!(
                "{:>10} {length:>3} {:>9.1} {:>9.1} {:>6.2} {:>13.1} {:>6.2}",
                case.name,
                least[0],
                least[1],
                least[0] / least[1],
                least[2],
                least[2] / least[3],
            );
        }
    }
}

fn bench_sequences(c: &mut Criterion) {
    for case in &CASES {
        for length in LENGTHS {
            let Prepared { exact, floats, sequences } = prepare(case, length);
            let mut chains = Chains::default();
            let mut group = c.benchmark_group(format!("hourglass/{}/{length}", case.name));
            group.bench_function("exact", |b| {
                b.iter(|| black_box(run(&mut chains, &exact, &sequences, Place::Beyond)));
            });
            group.bench_function("f64", |b| {
                b.iter(|| black_box(run(&mut chains, &floats, &sequences, Place::Beyond)));
            });
        }
    }
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10)
        .warm_up_time(std::time::Duration::from_millis(200))
        .measurement_time(std::time::Duration::from_millis(600));
    targets = bench_sequences
}

fn main() {
    if std::env::args().any(|argument| argument == "--table") {
        return table();
    }
    benches();
    Criterion::default().configure_from_args().final_summary();
}
