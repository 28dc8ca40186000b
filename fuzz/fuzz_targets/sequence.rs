//! The engine against its twins: each byte is a coordinate. The first says what is asked: triangles
//! in space, gates of the plane, or four lines.
#![no_main]

use libfuzzer_sys::fuzz_target;
use stabline::forge::{Fault, Input, accepts, find};
use stabline::geom::{BigPoint2, BigPoint3};
use stabline::num::{Int, Rational};
use stabline::oracle::{
    MeetingLines, PlaneTruth, Truth, classify, classify_2d, meeting_lines,
};
use stabline::vectors::{Answer, Class, LineCount};

/// Groups of `count` points of `D` coordinates.
fn groups<const D: usize>(bytes: &[u8], count: usize) -> Vec<Vec<[Int; D]>> {
    let point = |point: &[u8]| std::array::from_fn(|i| Int::from(point[i] as i8));
    bytes.chunks_exact(D * count).map(|group| group.chunks_exact(D).map(point).collect()).collect()
}

fn rationals<const D: usize>(groups: &[Vec<[Int; D]>]) -> Vec<Vec<Vec<Rational>>> {
    let point = |p: &[Int; D]| p.iter().cloned().map(Rational::from).collect();
    groups.iter().map(|group| group.iter().map(point).collect()).collect()
}

fn holds(input: Input, expected: impl FnOnce() -> Answer) {
    if !accepts(&input) {
        return;
    }
    match find(&input) {
        Ok(found) => assert_eq!(found.answer, expected()),
        Err(Fault::Refused(_)) => {}
        Err(fault) => panic!("{fault}"),
    }
}

fuzz_target!(|bytes: &[u8]| {
    let Some((kind, bytes)) = bytes.split_first() else { return };
    match kind % 3 {
        0 => {
            let portals = groups::<3>(&bytes[..bytes.len().min(27)], 3);
            if portals.is_empty() {
                return;
            }
            holds(Input::Sequence(rationals(&portals)), || {
                let point = |p: &[Int; 3]| BigPoint3 { coordinates: p.clone() };
                let portals: Vec<Vec<BigPoint3>> =
                    portals.iter().map(|portal| portal.iter().map(point).collect()).collect();
                Answer::Class(match classify(&portals) {
                    Truth::Open(_) => Class::Open,
                    Truth::Grazing(_) => Class::Grazing,
                    Truth::Blocked => Class::Blocked,
                })
            });
        }
        1 => {
            let gates = groups::<2>(&bytes[..bytes.len().min(24)], 2);
            if gates.is_empty() {
                return;
            }
            holds(Input::Sequence(rationals(&gates)), || {
                let end = |p: &[Int; 2]| BigPoint2 { coordinates: p.clone() };
                let gates: Vec<[BigPoint2; 2]> =
                    gates.iter().map(|gate| [end(&gate[0]), end(&gate[1])]).collect();
                Answer::Class(match classify_2d(&gates) {
                    PlaneTruth::Open => Class::Open,
                    PlaneTruth::Grazing => Class::Grazing,
                    PlaneTruth::Blocked => Class::Blocked,
                })
            });
        }
        _ => {
            let lines = rationals(&groups::<3>(bytes, 2));
            let Ok(lines) = <[_; 4]>::try_from(lines) else { return };
            let ends = lines.each_ref().map(|line: &Vec<Vec<Rational>>| {
                [0, 1].map(|end| [0, 1, 2].map(|i| line[end][i].clone()))
            });
            holds(Input::Lines(lines.to_vec()), || {
                Answer::Lines(match meeting_lines(&ends) {
                    MeetingLines::None => LineCount::None,
                    MeetingLines::One => LineCount::One,
                    MeetingLines::Two => LineCount::Two,
                    MeetingLines::Family => LineCount::Family,
                })
            });
        }
    }
});
