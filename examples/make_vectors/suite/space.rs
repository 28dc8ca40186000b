//! Families in space. Lines run towards positive z where nothing else is said; a polygon is
//! counter-clockwise as seen from above.

use super::family::{Family, Seq, TRIPLE};
use super::number::{Point, Polygon, Q, q, ratio, tenth};
use super::{plane, quadric};
use stabline::vectors::Class::{Blocked, Grazing, Open};

/// The rectangle at height z.
pub(super) fn square(z: &Q, [a, b]: [Q; 2], [c, d]: [Q; 2]) -> Polygon {
    let at = |x: &Q, y: &Q| vec![x.clone(), y.clone(), z.clone()];
    vec![at(&a, &c), at(&b, &c), at(&b, &d), at(&a, &d)]
}

/// Whole numbers as coordinates of a rectangle.
pub(super) fn whole(z: i64, x: [i64; 2], y: [i64; 2]) -> Polygon {
    square(&q(z), x.map(q), y.map(q))
}

/// The polygon with its axes changed round: x to y, y to z, z to x.
fn turned(polygons: &[Polygon]) -> Vec<Polygon> {
    let turn = |p: &Point| vec![p[2].clone(), p[0].clone(), p[1].clone()];
    super::number::each(polygons, turn)
}

/// All families.
pub fn families() -> Vec<Family> {
    let mut families = vec![
        half_walls(),
        reguli(),
        half_planes(),
        many_vertices(),
        corners(),
        needles(),
        thin_leaves(),
        short_edges(),
        twice(),
        in_one_plane(),
        opposed(),
        straight_sides(),
        quadric::rows(),
        quadric::loose(),
    ];
    families.extend(plane::families().into_iter().map(upright));
    families
}

/// The plane's family with a height, for the share of its cases that no other covers.
fn upright(family: Family) -> Family {
    let mut cases = Vec::new();
    for (index, case) in family.cases.iter().enumerate() {
        if index % 3 != 0 && family.cases.len() > 60 {
            continue;
        }
        let mut case = case.upright(3);
        // A line that stands upright in the post lies in the planes of all gates.
        let has_post = case.flags.contains(&"SharedVertex") && case.flags.contains(&"TurnAround");
        if has_post && case.portals.len() == 4 && case.class == Blocked {
            case.class = Grazing;
            case.comment.push_str(" But upright, along the post, one does.");
        }
        case.comment = format!("With a height of 3: {}", case.comment);
        if index % 4 == 2 {
            case = case.sheared();
        }
        cases.push(case);
    }
    Family { about: family.about, cases, is_row: family.is_row }
}

/// The case of which a published exact library says that it is blocked.
fn half_walls() -> Family {
    let mut cases = Vec::new();
    for (unit, name) in [(q(1), "1"), (tenth(1), "0.1"), (tenth(3), "1e-3"), (tenth(12), "1e-12")] {
        for critical in TRIPLE {
            let edge = q(1) - &unit * q(critical.0);
            let portals = vec![
                whole(0, [-1, 1], [-1, 1]),
                square(&q(2), [edge, q(4)], [q(-4), q(4)]),
                whole(4, [-1, 1], [-1, 1]),
            ];
            let comment = format!(
                "Facing squares [-1, 1] at z = 0 and 4, and between them what a wall leaves: its \
                 edge is {name} inside the squares' edge, in line with it, or outside."
            );
            let case = Seq::critical(comment, &["HalfWall"], portals, critical);
            let back = case.back();
            let on_axes = Seq { portals: turned(&case.portals), ..case.clone() };
            cases.extend([case.far(40), case.metres(), case.sheared(), back, on_axes, case]);
        }
    }
    Family::row("Half a wall between facing squares.", cases)
}

/// Integer normals m_i with Σ m_i = 0 and Σ i m_i = 0: then Σ m_i · P_i = 0 for the points P_i in
/// which any line crosses the planes z = i.
fn normals() -> Vec<Vec<[i64; 2]>> {
    let of = |m2: [i64; 2], m3: [i64; 2]| {
        let sum = |a: i64, b: i64| [a * m2[0] + b * m3[0], a * m2[1] + b * m3[1]];
        vec![sum(1, 2), sum(-2, -3), m2, m3]
    };
    vec![
        of([1, 0], [0, 1]),
        of([1, 0], [-1, 1]),
        of([2, 1], [-1, 1]),
        of([1, 1], [-1, 0]),
        of([3, -1], [-2, 2]),
        of([-5, 2], [3, -4]),
    ]
}

/// The part of the plane z = i where low <= m · P <= high, up to `length` away from the middle.
fn strip(i: i64, m: [i64; 2], low: &Q, high: &Q, length: i64) -> Polygon {
    let [a, b] = m.map(q);
    let square_of_m = &a * &a + &b * &b;
    let at = |level: &Q, along: i64| {
        let (u, v) = (level * &a / &square_of_m, level * &b / &square_of_m);
        vec![u - &b * q(along), v + &a * q(along), q(i)]
    };
    // (m, the direction along, up) are right-handed.
    vec![at(low, -length), at(high, -length), at(high, length), at(low, length)]
}

/// Four strips whose middle lines lie on one regulus.
fn reguli() -> Family {
    let mut cases = Vec::new();
    for (index, normals) in normals().into_iter().enumerate() {
        for (unit, name) in [(q(1), "1"), (tenth(4), "1e-4"), (tenth(15), "1e-15")] {
            for critical in TRIPLE {
                let strips = normals.iter().zip(0..).map(|(&m, i)| {
                    let high = if i == 0 { &unit * q(critical.0) } else { q(0) };
                    strip(i, m, &q(-30), &high, 40)
                });
                let comment = format!(
                    "Strips at z = 0, 1, 2, 3. The edges m_i . P <= 0 lie on one regulus (Σ m_i = \
                     Σ i m_i = 0), so Σ m_i . P_i = 0 on every line; the first strip is moved by \
                     {name}, or not."
                );
                let case = Seq::critical(comment, &["NearRegulus"], strips.collect(), critical);
                match index % 3 {
                    0 => cases.extend([case.far(20), case.sheared()]),
                    1 => cases.extend([case.back(), case.metres()]),
                    _ => cases.push(case.mirrored()),
                }
                cases.push(case);
            }
        }
    }
    Family::row("Four edges of one regulus, and one unit off it.", cases)
}

/// As [`reguli`], but the portals are large, and only one line is left of them.
fn half_planes() -> Family {
    let mut cases = Vec::new();
    for (index, normals) in normals().into_iter().enumerate() {
        for critical in TRIPLE {
            let portals = normals.iter().zip(0..).map(|(&m, i)| {
                let low = -ratio(critical.0, 1000);
                strip(i, m, &low, &q(50), 50)
            });
            let comment = "Portals at z = 0, 1, 2, 3, each with an edge that meets the z axis but \
                           for 1/1000: Σ m_i . P_i = 0 on every line, and all terms have one sign.";
            let case =
                Seq::critical(comment, &["CommonLine", "NearRegulus"], portals.collect(), critical);
            cases.push(if index % 2 == 0 { case.far(40) } else { case.sheared() });
            cases.push(case);
        }
    }
    Family::row("Large portals whose edges meet in one line.", cases)
}

/// Polygons of more vertices than tables of fixed size hold.
fn many_vertices() -> Family {
    let mut cases = Vec::new();
    for half in [12, 13, 16, 24, 32] {
        let count = 2 * half + 1;
        let polygon: Polygon = (-half..=half).map(|i| vec![q(i), q(i * i), q(0)]).collect();
        for (at, name) in [(half, "last"), (-half, "first"), (0, "middle")] {
            for critical in TRIPLE {
                // A small square at the vertex, in line on both sides: only what of the polygon is
                // behind it lets lines pass.
                let (x, y) = (q(at), q(at * at));
                let over = tenth(2) * q(critical.0);
                let (u, v) = match at.signum() {
                    1 => ([&x - &over, &x + q(1)], [&y - &over, &y + q(1)]),
                    -1 => ([&x - q(1), &x + &over], [&y - &over, &y + q(1)]),
                    _ => ([&x - tenth(3), &x + tenth(3)], [&y - q(1), &y + &over]),
                };
                let portals = vec![
                    square(&q(-10), u.clone(), v.clone()),
                    polygon.clone(),
                    square(&q(10), u, v),
                ];
                // The corner at the ends is sharp: the square's corner is inside the polygon or
                // not, according to the slopes there.
                let inside = critical.0 > 0;
                let class = match (inside, critical.0) {
                    (true, _) => Open,
                    (false, 0) => Grazing,
                    _ => Blocked,
                };
                let comment = format!(
                    "A portal of {count} vertices, (i, i²); two small windows in line see only \
                     what they share with it at its {name} vertex, to 1/100."
                );
                cases.push(Seq::critical(
                    comment,
                    &["ManyVertices"],
                    portals,
                    (critical.0, class, critical.2),
                ));
            }
        }
    }
    Family::row("Portals of 25 to 65 vertices.", cases)
}

/// Portals of one plane that touch in a corner, and one behind them.
fn corners() -> Family {
    let mut cases = Vec::new();
    for (unit, name) in [(q(1), "1"), (ratio(1, 20), "0.05"), (tenth(10), "1e-10")] {
        for critical in TRIPLE {
            let low = q(4) - &unit * q(critical.0);
            let upper = |z: i64| square(&q(z), [low.clone(), q(8)], [low.clone(), q(8)]);
            let flat = vec![whole(0, [0, 4], [0, 4]), upper(0), whole(9, [0, 8], [0, 8])];
            let comment = format!(
                "Two squares of one plane, and a third behind them. The two overlap by {name} at a \
                 corner, touch in it, or miss each other."
            );
            let flags = &["TouchInPoint", "Coplanar"];
            let case = Seq::critical(comment, flags, flat, critical);
            cases.extend([case.far(40), case.sheared(), case.back(), case]);
            let row = vec![whole(0, [0, 4], [0, 4]), upper(5), whole(10, [0, 4], [0, 4])];
            let comment = format!(
                "Squares of three walls, the middle one and the others overlap by {name} at a \
                 corner only, touch in it, or miss each other."
            );
            let case = Seq::critical(comment, &["TouchInPoint"], row, critical);
            cases.extend([case.far(20), case.metres(), case.mirrored(), case]);
        }
    }
    Family::loose("Portals that touch in a point.", cases)
}

fn needles() -> Family {
    let mut cases = Vec::new();
    for (length, width) in [(1000, 1), (1_000_000, 1), (64, 1), (1_000_000_000, 3)] {
        for critical in TRIPLE {
            // A needle from (0, 0) along x; the window's right edge is about its tip.
            let needle = vec![
                vec![q(0), q(0), q(5)],
                vec![q(length), q(-width), q(5)],
                vec![q(length), q(width), q(5)],
            ];
            let edge = tenth(3) * q(critical.0);
            let window = |z: i64| square(&q(z), [q(-10), edge.clone()], [q(-10), q(10)]);
            let portals = vec![window(0), needle, window(10)];
            let comment = format!(
                "A needle {length} long and {} wide, between two windows in line that reach over \
                 its tip by a thousandth.",
                2 * width
            );
            let case = Seq::critical(comment, &["Needle"], portals, critical);
            cases.extend([case.metres(), case.sheared(), case]);
        }
    }
    Family::row("Long thin triangles, of which lines pass the tip only.", cases)
}

fn thin_leaves() -> Family {
    let mut cases = Vec::new();
    for (thickness, name) in [
        (ratio(1, 10), "0.1"),
        (ratio(1, 20), "0.05"),
        (ratio(1, 100), "0.01"),
        (tenth(6), "1e-6"),
        (tenth(16), "1e-16"),
    ] {
        let near = |z: &Q, x: [i64; 2]| square(z, x.map(q), [0, 56].map(q));
        let portals = vec![near(&q(0), [0, 32]), near(&thickness, [0, 32]), near(&q(64), [0, 32])];
        let comment =
            format!("A leaf {name} thick between two rooms, with the same door on both its sides.");
        let case = Seq::new(comment, &["ThinLeaf"], portals, Open);
        cases.extend([case.metres(), case.far(20), case.far(40), case.back(), case]);
        for critical in TRIPLE {
            let over = &thickness * ratio(critical.0, 10);
            // Lines from x > 0 at z = 0 to x < over at the leaf's other side, then to x > 10 …
            let portals = vec![
                near(&q(0), [0, 32]),
                square(&thickness, [q(-32), over.clone()], [0, 56].map(q)),
                square(&(&thickness * q(2)), [q(0), q(32)], [0, 56].map(q)),
            ];
            let comment = format!(
                "Two leaves {name} thick, one after the other; their doors are offset so that three \
                 posts are in line, to a tenth of that."
            );
            let case = Seq::critical(comment, &["ThinLeaf"], portals, critical);
            cases.extend([case.metres(), case.mirrored(), case]);
        }
    }
    Family::row("Leaves of 0.1 and less between two rooms.", cases)
}

fn short_edges() -> Family {
    let mut cases = Vec::new();
    for (n, d) in [(1, 5), (1, 10), (1, 20), (1, 100), (1, 1000)] {
        let size = ratio(n, d);
        for critical in TRIPLE {
            let hatch = square(&q(32), [q(10), q(10) + &size], [q(10), q(10) + &size]);
            let low = q(10) + &size - &size * ratio(critical.0, 4);
            let window = |z: i64| square(&q(z), [low.clone(), q(60)], [q(0), q(60)]);
            let portals = vec![window(0), hatch.clone(), window(64)];
            let comment = format!(
                "A hatch {n}/{d} wide, between windows in line that overlap it by a quarter of \
                 that, are flush with its edge, or miss it."
            );
            let case = Seq::critical(comment, &["ShortEdge"], portals, critical);
            cases.extend([case.metres(), case.back(), case]);
        }
        let triangle = vec![
            vec![q(10), q(10), q(32)],
            vec![q(10) + &size, q(10), q(32)],
            vec![q(10), q(10) + &size, q(32)],
        ];
        let portals = vec![whole(0, [0, 60], [0, 60]), triangle, whole(64, [0, 60], [0, 60])];
        let comment = format!("A triangle with sides of {n}/{d} between two large windows.");
        let case = Seq::new(comment, &["ShortEdge"], portals, Open);
        cases.extend([case.metres(), case.far(40), case]);
    }
    Family::row("Portals with edges of 0.2 and less.", cases)
}

fn twice() -> Family {
    let mut cases = Vec::new();
    let door = whole(0, [0, 3], [0, 5]);
    let back: Polygon = door.iter().rev().cloned().collect();
    for count in [2, 3, 9] {
        let comment = format!("One portal, {count} times.");
        let portals = vec![door.clone(); count];
        cases.push(Seq::new(comment, &["Duplicate", "Coplanar"], portals, Open));
    }
    let flags = &["Duplicate", "Coplanar", "TurnAround"];
    let comment = "Out through a portal and back: only lines in its plane touch both.";
    cases.push(Seq::new(comment, flags, vec![door.clone(), back.clone()], Grazing));
    let third = |x: i64| {
        vec![
            vec![q(x), q(-1), q(-1)],
            vec![q(x), q(6), q(-1)],
            vec![q(x), q(6), q(1)],
            vec![q(x), q(-1), q(1)],
        ]
    };
    let comment = "Out through a portal, back, and through one across, which lines in the plane of \
                   the first pass.";
    cases.push(Seq::new(comment, flags, vec![door.clone(), back.clone(), third(9)], Grazing));
    let comment = "Out through a portal, back, and through one in front that lines in the plane of \
                   the first miss.";
    cases.push(Seq::new(comment, flags, vec![door, back, whole(4, [0, 3], [0, 5])], Blocked));
    Family::loose("The same portal more than once.", cases)
}

fn in_one_plane() -> Family {
    let mut cases = Vec::new();
    for gap in [1, 5, 1000] {
        let doors = vec![whole(0, [0, 2], [0, 4]), whole(0, [2 + gap, 4 + gap], [0, 4])];
        let comment = format!("Two doors of one wall, {gap} apart, crossed the same way.");
        cases.push(Seq::new(comment, &["Coplanar"], doors.clone(), Grazing));
        let mut turned_doors = doors;
        turned_doors[1].reverse();
        let comment = format!("Out through one door of a wall and back by another, {gap} apart.");
        let case = Seq::new(comment, &["Coplanar", "TurnAround"], turned_doors, Grazing);
        cases.extend([case.far(40), case.sheared(), case]);
    }
    for size in [1, 1000] {
        let s = size;
        let cube = vec![
            whole(s, [0, s], [0, s]),
            vec![[s, 0, 0], [s, s, 0], [s, s, s], [s, 0, s]]
                .into_iter()
                .map(|p| p.map(q).to_vec())
                .collect(),
            vec![[0, 0, 0], [s, 0, 0], [s, 0, s], [0, 0, s]]
                .into_iter()
                .map(|p| p.map(q).to_vec())
                .collect(),
            vec![[0, 0, 0], [0, s, 0], [s, s, 0], [s, 0, 0]]
                .into_iter()
                .map(|p| p.map(q).to_vec())
                .collect(),
        ];
        let comment =
            format!("Out through four faces of a cube of size {size}, top and bottom among them.");
        let two = "Out through two neighbouring faces of a cube, which only their edge belongs to.";
        cases.push(Seq::new(two, &["TurnAround", "SharedVertex"], cube[..2].to_vec(), Grazing));
        let three = "Out through three faces of a cube: only lines at their corner touch all.";
        cases.push(Seq::new(three, &["SharedVertex"], cube[..3].to_vec(), Grazing));
        cases.push(Seq::new(comment, &["TurnAround", "SharedVertex"], cube, Blocked));
    }
    Family::loose("Portals of one plane, and of a cube.", cases)
}

/// Weak signs are right for lines at infinity only.
fn opposed() -> Family {
    let mut cases = Vec::new();
    for size in [1, 10, 1000] {
        let s = size;
        let of = |points: [[i64; 3]; 3]| points.map(|p| p.map(q).to_vec()).to_vec();
        let portals =
            vec![of([[0, 0, 0], [s, 0, 0], [0, s, 0]]), of([[0, 0, s], [0, s, s], [s, 0, s]])];
        let comment = format!(
            "Facing triangles {s} apart, crossed in opposite directions: all sides are weakly right \
             for lines at infinity, and for no other."
        );
        let case = Seq::new(comment, &["TurnAround", "AtInfinity"], portals, Blocked);
        cases.extend([case.sheared(), case.far(40), case.mirrored(), case]);
    }
    Family::loose("Lines at infinity.", cases)
}

fn straight_sides() -> Family {
    let mut cases = Vec::new();
    for critical in TRIPLE {
        let side: Polygon =
            [[0, 0], [1, 0], [2, 0], [4, 0], [4, 1], [4, 4], [3, 4], [0, 4], [0, 1]]
                .map(|[x, y]| vec![q(x), q(y), q(0)])
                .to_vec();
        let edge = q(4) - tenth(5) * q(critical.0);
        let portals = vec![
            side.clone(),
            square(&q(7), [edge, q(9)], [q(0), q(4)]),
            side.iter().map(|p| vec![p[0].clone(), p[1].clone(), q(14)]).collect(),
        ];
        let comment = "Squares with vertices in the middle of their straight sides, flush with a \
                       third but for 1e-5.";
        let case = Seq::critical(comment, &["StraightSide"], portals, critical);
        cases.extend([case.far(40), case.sheared(), case.back(), case]);
    }
    Family::row("Vertices in the middle of straight sides.", cases)
}
