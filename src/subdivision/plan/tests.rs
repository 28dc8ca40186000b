//! Laws that hold of every subdivision, and inputs to check them on.

mod bsp;
mod kd;
mod laws;
mod naive;

use super::*;
use crate::num::{Int, Number, Random, Rational};
use crate::report::Silent;
use crate::scene::plan::{Plan, RawPlan, RawSegment};

/// A segment by its ends.
type Ends = [[i64; 2]; 2];

fn plan_in(segments: &[Ends], view: Option<Ends>) -> Plan {
    let number = |point: [i64; 2]| point.map(|c| Number::Small(c, 1));
    let raw = |ends: &Ends| RawSegment { ends: ends.map(number), is_opaque: true };
    let segments = segments.iter().map(raw).collect();
    let view = view.map(|corners| corners.map(number));
    Plan::from_raw(&RawPlan { segments, view, ..RawPlan::default() }).unwrap()
}

fn plan(segments: &[Ends]) -> Plan {
    plan_in(segments, None)
}

/// A whole threshold, in world units.
fn kd(threshold: i64) -> PlanMethod {
    PlanMethod::Kd { threshold: Rational::from(Int::from(threshold)) }
}

/// Horizontal and vertical segments on a small grid: they cross, overlap, touch and coincide.
fn axial(random: &mut Random, count: i64, reach: i64) -> Vec<Ends> {
    let mut segments: Vec<Ends> = Vec::new();
    for _ in 0..count {
        if !segments.is_empty() && random.one_in(8) {
            segments.push(segments[random.between(0, segments.len() as i64 - 1) as usize]);
            continue;
        }
        let at = random.between(0, reach);
        let (mut p, mut q) = (random.between(0, reach), random.between(0, reach));
        if p == q {
            (p, q) = if p > 0 { (p - 1, p) } else { (0, 1) };
        }
        segments.push(match random.one_in(2) {
            true => [[at, p], [at, q]],
            false => [[p, at], [q, at]],
        });
    }
    segments
}
