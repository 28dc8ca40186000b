//! Eyes before a row of openings across the last axis.
//!
//! Rays are told by their slopes, so an opening is an interval of slopes on each axis, and a room
//! is seen iff the intervals of all openings before it share an inner point; touched if they share
//! any.

use super::book::Book;
use super::number::{Point, Polygon, Q, power, q, ratio, tenth, value, values};
use serde_json::{Map, Value, json};
use stabline::vectors::{Kind, Test, VectorsFile};

/// A row of openings, each an interval on every axis but the last, and an eye before them.
#[derive(Clone)]
struct View {
    comment: String,
    flags: Vec<&'static str>,
    eye: Point,
    openings: Vec<(Vec<[Q; 2]>, Q)>,
    /// Half the width of the frustum, as a slope, on each axis.
    tangents: Option<Vec<Q>>,
}

/// All cases.
pub fn file() -> VectorsFile {
    let mut book =
        Book::new("eyes", "Which rooms does an eye see, through openings one behind another?");
    for view in views() {
        add(&mut book, &view);
    }
    book.finish()
}

fn views() -> Vec<View> {
    let mut all = Vec::new();
    let units = [
        (q(1), "1"),
        (ratio(1, 20), "0.05"),
        (tenth(3), "1e-3"),
        (tenth(9), "1e-9"),
        (tenth(17), "1e-17"),
    ];
    for ex in [1, 2, 3] {
        for (unit, name) in &units {
            for sign in [1, 0, -1] {
                let left = q(8 - ex) - unit * q(sign);
                let openings = vec![
                    (vec![[q(0), q(4)]], q(10)),
                    (vec![[left.clone(), &left + q(4)]], q(20)),
                    (vec![[q(0), q(32)]], q(30)),
                ];
                let how = match sign {
                    1 => "one unit is left",
                    0 => "a ray touches both edges and no more",
                    _ => "one unit is lacking",
                };
                let comment = format!("The eye sees past two edges, to {name}: {how}.");
                let flag = if sign == 0 { "Flush" } else { "OneUnit" };
                let (eye, tangents) = (vec![q(ex), q(0)], None);
                let view = View { comment, flags: vec![flag], eye, openings, tangents };
                if ex == 2 {
                    all.extend([view.far(40), view.scaled(&ratio(127, 5000)), view.far(20)]);
                }
                all.push(view.framed(&q(1)));
                if ex == 1 {
                    // The frame's edge is the critical one.
                    let slope = ratio(8 - ex - ex, 20) + unit * ratio(sign, 100);
                    all.push(View {
                        comment: format!(
                            "The frame's side is almost the door's edge. {}",
                            view.comment
                        ),
                        ..view.framed(&slope)
                    });
                }
                all.push(view.mirrored());
                all.push(view);
            }
        }
    }
    for k in (2..=20).step_by(2) {
        let width = tenth(k);
        let openings = (1..=3).map(|i| (vec![[q(0), width.clone()]], q(10 * i))).collect();
        let comment =
            format!("Slits of width 1e-{k} in line, looked through from half their width.");
        let eye = vec![&width / q(2), q(0)];
        let view = View { comment, flags: vec!["Slit"], eye, openings, tangents: None };
        all.push(view.scaled(&ratio(127, 5000)));
        all.push(view);
    }
    all
}

impl View {
    fn far(&self, bits: u32) -> View {
        let (by, up) = (power(bits), power(bits - 1));
        let mut view = self.clone();
        view.eye = vec![&self.eye[0] + &by, &self.eye[1] + &up];
        for (intervals, at) in &mut view.openings {
            *at += &up;
            intervals.iter_mut().flatten().for_each(|c| *c += &by);
        }
        view.told(&format!("2^{bits} units away"), "FarFromOrigin")
    }

    fn scaled(&self, by: &Q) -> View {
        let mut view = self.clone();
        view.eye.iter_mut().for_each(|c| *c *= by);
        for (intervals, at) in &mut view.openings {
            *at *= by;
            intervals.iter_mut().flatten().for_each(|c| *c *= by);
        }
        view.told("Scaled by 0.0254", "UnitScale")
    }

    fn mirrored(&self) -> View {
        let mut view = self.clone();
        view.eye[0] = -&self.eye[0];
        for (intervals, _) in &mut view.openings {
            let [a, b] = intervals[0].clone();
            intervals[0] = [-b, -a];
        }
        view.told("In a mirror", "Mirrored")
    }

    fn framed(&self, tangent: &Q) -> View {
        let view = View { tangents: Some(vec![tangent.clone()]), ..self.clone() };
        view.told("Through a frame", "Frustum")
    }

    fn told(mut self, how: &str, flag: &'static str) -> View {
        self.comment = format!("{how}: {}", self.comment);
        self.flags.push(flag);
        self
    }

    /// The same with a height: openings from -2 to 3 with the eye at 1/2.
    fn in_space(&self) -> View {
        let mut view = self.clone();
        view.eye.insert(1, ratio(1, 2));
        view.openings.iter_mut().for_each(|(intervals, _)| intervals.push([q(-2), q(3)]));
        view.tangents.iter_mut().for_each(|tangents| tangents.push(q(1)));
        view.comment = format!("In space: {}", view.comment);
        view
    }

    fn polygon(&self, (intervals, at): &(Vec<[Q; 2]>, Q)) -> Polygon {
        match intervals.as_slice() {
            [[a, b], [c, d]] => {
                let corners = [[a, c], [b, c], [b, d], [a, d]];
                corners.map(|[x, y]| vec![x.clone(), y.clone(), at.clone()]).to_vec()
            }
            other => other[0].iter().map(|x| vec![x.clone(), at.clone()]).collect(),
        }
    }

    /// What is left of the slopes on each axis: the greatest lower end and the least upper one,
    /// with the numbers of the openings that they are of; the frame is none.
    fn beam(&self, count: usize) -> Vec<[(Q, Option<usize>); 2]> {
        let depth = self.eye.last().expect("coordinates");
        let axes = 0..self.eye.len() - 1;
        let of = |axis: usize| {
            let frame =
                self.tangents.as_ref().map(|t| [(-&t[axis], None), (t[axis].clone(), None)]);
            let openings = self.openings[..count].iter().enumerate().map(|(i, (intervals, at))| {
                let slope = |c: &Q| ((c - &self.eye[axis]) / (at - depth), Some(i));
                intervals[axis].each_ref().map(slope)
            });
            let all: Vec<_> = frame.into_iter().chain(openings).collect();
            let low = all.iter().map(|[low, _]| low).max_by(|a, b| a.0.cmp(&b.0));
            let high = all.iter().map(|[_, high]| high).min_by(|a, b| a.0.cmp(&b.0));
            [low.expect("an opening").clone(), high.expect("an opening").clone()]
        };
        axes.map(of).collect()
    }
}

fn add(book: &mut Book, view: &View) {
    for view in [view.clone(), view.in_space()] {
        // A graph of the plane is looked at all around.
        let is_plane = view.eye.len() == 2;
        if is_plane && view.tangents.is_some() {
            continue;
        }
        let rooms: Vec<String> =
            (0..=view.openings.len()).map(|room| format!("room {room}")).collect();
        let shape = if is_plane { "segment" } else { "polygon" };
        let doors = view.openings.iter().enumerate().map(|(i, opening)| {
            let polygon = values(&view.polygon(opening));
            json!({ "from": rooms[i], "to": rooms[i + 1], shape: polygon })
        });
        let doors: Vec<Value> = doors.collect();
        let scene = json!({ "format": "stabline-scene/1", "cells": rooms, "portals": doors });
        let name = format!("openings {}", book.count());
        book.scene(Kind::Eye, "Openings one behind another.", &name, scene);
        let test = look(&view, &rooms);
        book.test(&view.comment, &view.flags, test);
    }
}

fn look(view: &View, rooms: &[String]) -> Test {
    let mut input = json!({ "at": values(std::slice::from_ref(&view.eye))[0], "cell": rooms[0] });
    if let (Some(tangents), Value::Object(fields)) = (&view.tangents, &mut input) {
        fields.insert("look".to_owned(), json!([0, 0, 1]));
        fields.insert("up".to_owned(), json!([0, 1, 0]));
        fields.insert("half_tangents".to_owned(), tangents.iter().map(value).collect());
    }
    let (mut seen, mut touched) = (vec![rooms[0].clone()], Vec::new());
    let (mut points, mut unseen) = (Map::new(), Map::new());
    for (count, room) in rooms.iter().enumerate().skip(1) {
        let beam = view.beam(count);
        let depth = &view.openings[count - 1].1 - view.eye.last().expect("coordinates");
        if beam.iter().all(|[low, high]| low.0 < high.0) {
            let middle = beam
                .iter()
                .zip(&view.eye)
                .map(|([low, high], eye)| eye + (&low.0 + &high.0) / q(2) * &depth);
            let mut point: Point = middle.collect();
            point.push(view.openings[count - 1].1.clone());
            points.insert(room.clone(), values(&[point])[0].clone());
            seen.push(room.clone());
            continue;
        }
        if beam.iter().all(|[low, high]| low.0 <= high.0) {
            touched.push(room.clone());
        }
        let axis = beam.iter().position(|[low, high]| low.0 >= high.0).expect("one is empty");
        let end = |(slope, opening): &(Q, Option<usize>)| json!({ "opening": opening, "slope": value(slope) });
        let [low, high] = &beam[axis];
        unseen.insert(room.clone(), json!({ "axis": axis, "low": end(low), "high": end(high) }));
    }
    Test {
        input: Some(input),
        cells: Some(seen),
        grazing: touched,
        witness: (!points.is_empty()).then_some(Value::Object(points)),
        certificate: (!unseen.is_empty()).then(|| json!({ "unseen": unseen })),
        ..Test::default()
    }
}
