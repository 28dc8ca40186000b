//! Scenes of walls with openings, and a view cell at either end.
//!
//! The view cells fill the rooms before the first wall and behind the last, so every line from one
//! to the other passes the openings in their order: the answer is that of their sequence.

use super::book::{Book, of_portals};
use super::family::{Family, Seq};
use super::number::{Polygon, Q, q, values};
use super::solids;
use serde_json::{Value, json};
use stabline::vectors::{Kind, Test, VectorsFile};

/// How the pieces of a wall are laid around an opening.
const LAYOUTS: [(&str, &str); 3] = [
    ("TJunction", "The walls' pieces meet in T-junctions"),
    ("Pinwheel", "The walls' pieces go round their opening"),
    ("Overlap", "The walls' pieces overlap in their plane"),
];

/// Walls of segments.
pub fn in_plane(families: &[Family]) -> VectorsFile {
    let about = "Do two view cells of a floorplan see each other, between segments?";
    let mut book = Book::new("scenes_2d", about);
    for (family, index, case) in rows(families, 2) {
        let (low, high) = extents(case);
        let walls = case.portals.iter().flat_map(|gate| {
            let y = &gate[0][1];
            let at = |x: &Q| vec![x.clone(), y.clone()];
            [[at(&low[0]), at(&gate[0][0])], [at(&gate[1][0]), at(&high[0])]]
        });
        let walls: Vec<Value> = walls.map(|wall| values(&wall)).collect();
        let room = |a: &Q, b: &Q| {
            let corners = [[&low[0], a], [&high[0], a], [&high[0], b], [&low[0], b]];
            values(&corners.map(|corner| corner.map(Q::clone).to_vec()))
        };
        let scene = json!({
            "format": "stabline-scene/1",
            "view": values(&[low.clone(), high.clone()]),
            "segments": walls,
            "objects": [
                { "name": "near", "polygon": room(&low[1], &ends(case)[0]) },
                { "name": "far", "polygon": room(&ends(case)[1], &high[1]) },
            ],
        });
        book.scene(Kind::Scene, family.about, &format!("walls {index}"), scene);
        both_ways(&mut book, case);
    }
    book.finish()
}

/// Walls of polygons, and scenes of solids.
pub fn in_space(families: &[Family]) -> VectorsFile {
    let about = "Do two view cells of a scene of polygons or solids see each other?";
    let mut book = Book::new("scenes_3d", about);
    for (family, index, case) in rows(families, 3) {
        let (low, high) = extents(case);
        let (flag, how) = LAYOUTS[index % 3];
        let pieces = case
            .portals
            .iter()
            .flat_map(|opening| wall(opening, [&low[0], &high[0]], [&low[1], &high[1]], flag));
        let pieces: Vec<Value> = pieces.map(|piece| json!({ "polygon": values(&piece) })).collect();
        let room = |a: &Q, b: &Q| {
            let corner = |p: &[Q], z: &Q| vec![p[0].clone(), p[1].clone(), z.clone()];
            values(&[corner(&low, a), corner(&high, b)])
        };
        let scene = json!({
            "format": "stabline-scene/1",
            "view": values(&[low.clone(), high.clone()]),
            "polygons": pieces,
            "objects": [
                { "name": "near", "box": room(&low[2], &ends(case)[0]) },
                { "name": "far", "box": room(&ends(case)[1], &high[2]) },
            ],
        });
        book.scene(Kind::Scene, family.about, &format!("walls {index}"), scene);
        let mut case = case.clone();
        case.flags.push(flag);
        case.comment = format!("{how}. {}", case.comment);
        both_ways(&mut book, &case);
    }
    solids::add(&mut book);
    book.finish()
}

/// The cases of some families whose openings are axial and lie in walls across the last axis.
fn rows(families: &[Family], axes: usize) -> impl Iterator<Item = (&Family, usize, &Seq)> {
    let is_right = move |case: &Seq| {
        let level = |polygon: &Polygon| polygon.iter().all(|p| p[axes - 1] == polygon[0][axes - 1]);
        let axial =
            |p: &Polygon| axes == 2 || p.len() == 4 && (p[0][1] == p[1][1] && p[1][0] == p[2][0]);
        let rising =
            case.portals.windows(2).all(|pair| pair[0][0][axes - 1] < pair[1][0][axes - 1]);
        let forward = |p: &Polygon| p[0][0] < p[1][0];
        (2..=5).contains(&case.portals.len())
            && rising
            && case.portals.iter().all(|p| p[0].len() == axes && level(p) && axial(p) && forward(p))
    };
    let rows = families.iter().filter(|family| family.is_row);
    rows.flat_map(move |family| {
        let cases = family.cases.iter().filter(move |case| is_right(case)).enumerate();
        // Every other one of many.
        let many = family.cases.len() > 60;
        let kept = cases.filter(move |(index, _)| !many || index % 5 < 3);
        kept.map(move |(index, case)| (family, index, case))
    })
}

/// A box around the openings with one unit to spare.
fn extents(case: &Seq) -> (Vec<Q>, Vec<Q>) {
    let points = || case.portals.iter().flatten();
    let axes = 0..case.portals[0][0].len();
    let of = |axis: usize| points().map(move |p| p[axis].clone());
    let low = axes.clone().map(|axis| of(axis).min().expect("a point") - q(1));
    let high = axes.map(|axis| of(axis).max().expect("a point") + q(1));
    (low.collect(), high.collect())
}

/// Where the first wall is, and the last.
fn ends(case: &Seq) -> [Q; 2] {
    let level = |polygon: &Polygon| polygon[0].last().expect("coordinates").clone();
    [level(&case.portals[0]), level(&case.portals[case.portals.len() - 1])]
}

/// The pieces of a wall around a rectangular opening.
fn wall(opening: &Polygon, [x0, x1]: [&Q; 2], [y0, y1]: [&Q; 2], layout: &str) -> Vec<Polygon> {
    let [a, b, c, d] = [&opening[0][0], &opening[1][0], &opening[0][1], &opening[2][1]];
    let piece = |x: [&Q; 2], y: [&Q; 2]| {
        let corners = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
        corners.map(|[x, y]| vec![x.clone(), y.clone(), opening[0][2].clone()]).to_vec()
    };
    let pieces = match layout {
        "TJunction" => {
            [([x0, a], [y0, y1]), ([b, x1], [y0, y1]), ([a, b], [y0, c]), ([a, b], [d, y1])]
        }
        "Pinwheel" => {
            [([x0, b], [y0, c]), ([b, x1], [y0, d]), ([a, x1], [d, y1]), ([x0, a], [c, y1])]
        }
        _ => [([x0, a], [y0, y1]), ([b, x1], [y0, y1]), ([x0, x1], [y0, c]), ([x0, x1], [d, y1])],
    };
    pieces.map(|(x, y)| piece(x, y)).to_vec()
}

fn both_ways(book: &mut Book, case: &Seq) {
    for (case, [from, to]) in [(case.clone(), ["near", "far"]), (case.back(), ["far", "near"])] {
        let test = of_portals(&case.portals);
        let openings: Vec<Value> = case.portals.iter().map(|portal| values(portal)).collect();
        let mut certificate = json!({ "openings": openings });
        if let Some(reason) = &test.certificate {
            certificate["reason"] = reason.clone();
        }
        let test = Test {
            from: Some(from.to_owned()),
            to: Some(to.to_owned()),
            certificate: Some(certificate),
            ..test
        };
        book.judged(&case, test);
    }
}
