//! Families in the plane. Lines run towards positive y where nothing else is said; a gate is a
//! segment from its left end to its right end.

use super::family::{Family, Seq, TRIPLE};
use super::number::{Polygon, Q, power, q, ratio, tenth};
use stabline::vectors::Class::{Blocked, Grazing, Open};

/// The gate at height y from x = a to x = b.
fn gate(y: &Q, a: Q, b: Q) -> Polygon {
    vec![vec![a, y.clone()], vec![b, y.clone()]]
}

/// The gate between two points, the left one first.
fn between(left: [&Q; 2], right: [&Q; 2]) -> Polygon {
    [left, right].map(|point| point.map(Q::clone).to_vec()).to_vec()
}

/// All families.
pub fn families() -> Vec<Family> {
    vec![
        plain(),
        slits(),
        posts(),
        common_line(),
        around_a_post(),
        overlaps(),
        on_one_line(),
        twice(),
        no_way_forward(),
        chains(),
    ]
}

fn plain() -> Family {
    let mut cases = Vec::new();
    for (index, shift) in [0, 1, 3, 5, 8, 12].into_iter().enumerate() {
        let gates = |last: i64| {
            vec![gate(&q(0), q(0), q(4)), gate(&q(10), q(shift), q(shift + 4)), {
                gate(&q(20), q(last), q(last + 4))
            }]
        };
        cases.push(Seq::new(
            format!(
                "Three wide doors, each {shift} to the right of the one before: a straight way."
            ),
            &["Plain"],
            gates(2 * shift),
            Open,
        ));
        let class = if shift < 4 { Open } else { Blocked };
        if shift != 4 {
            cases.push(Seq::new(
                format!(
                    "Three doors of width 4, the middle one {shift} to the right of the others: \
                     halfway lines have a width of 4, so {} is left.",
                    4 - shift
                ),
                &["Plain"],
                gates(0),
                class,
            ));
        }
        let turned = Seq::new(
            format!("Door {index} alone: any line through it."),
            &["Plain"],
            vec![gate(&q(0), q(shift), q(shift + 1))],
            Open,
        );
        cases.push(turned);
    }
    Family::row("Doors of ordinary size: what anybody should get right.", cases)
}

fn slits() -> Family {
    let mut cases = Vec::new();
    for k in 1..=20 {
        let width = tenth(k);
        for critical in TRIPLE {
            let by = &width * ratio(1000 - critical.0, 1000);
            let [low, high] = [q(0), width.clone()];
            let gates = vec![
                gate(&q(0), low.clone(), high.clone()),
                gate(&q(10), by.clone(), &by + &width),
                gate(&q(20), low, high),
            ];
            let comment = format!(
                "Slits of width 1e-{k} in three walls. Halfway, lines through the outer two have \
                 this width; the middle one is moved by it, to a thousandth."
            );
            let case = Seq::critical(comment, &["Slit"], gates, critical);
            match k % 5 {
                0 => cases.extend([case.far(40), case.metres(), case.back(), case.mirrored()]),
                2 => cases.extend([case.far(20), case.sheared()]),
                _ => {}
            }
            cases.push(case);
        }
    }
    Family::row("Slits in three walls, the middle one moved by about its width.", cases)
}

/// Posts A, B, C: the line passes right of A, left of B, right of C, and B is on the line AC but
/// for one unit.
fn posts() -> Family {
    let directions: [(Q, Q, &[&'static str]); 9] = [
        (q(0), q(8), &["Posts"]),
        (q(3), q(7), &["Posts"]),
        (q(1), q(1000), &["Posts"]),
        (q(1000), q(1), &["Posts", "Needle"]),
        (q(1), ratio(1, 100), &["Posts", "ThinLeaf"]),
        (ratio(-1, 3), ratio(1, 100), &["Posts", "ThinLeaf"]),
        (q(1_000_003), q(999_983), &["Posts"]),
        (power(40) + q(1), power(40) - q(1), &["Posts", "LongNumbers"]),
        (power(62) + q(5), power(61) - q(3), &["Posts", "LongNumbers"]),
    ];
    let mut cases = Vec::new();
    for (p, r, flags) in &directions {
        for (unit, name) in
            [(q(1), "1"), (tenth(3), "1e-3"), (tenth(9), "1e-9"), (tenth(18), "1e-18")]
        {
            for critical in TRIPLE {
                let wide = p * q(2) + r * q(2) + q(8);
                let wide = if wide < q(8) { q(8) } else { wide };
                let middle = p + &unit * q(critical.0);
                let gates = vec![
                    gate(&q(0), q(0), wide.clone()),
                    gate(r, &middle - &wide, middle.clone()),
                    gate(&(r * q(2)), p * q(2), p * q(2) + &wide),
                ];
                let comment = format!(
                    "Three posts: pass right of (0, 0), left of the second, right of ({}, {}). The \
                     second is halfway on the line through the others, but for {name}.",
                    p * q(2),
                    r * q(2)
                );
                let case = Seq::critical(comment, flags, gates, critical);
                if name == "1e-3" && flags.len() == 1 {
                    cases.extend([case.far(40), case.metres(), case.mirrored(), case.back()]);
                }
                cases.push(case);
            }
        }
    }
    Family::row("Three posts in line, passed on alternate sides.", cases)
}

fn common_line() -> Family {
    let mut cases = Vec::new();
    for count in [2, 3, 4, 5, 6, 8, 12, 16, 24, 32] {
        for critical in TRIPLE {
            let gates = (0..count).map(|i| match i % 2 {
                0 => gate(&q(i), q(i), q(i + 5)),
                _ => gate(&q(i), q(i - 5), q(i) + tenth(2) * q(critical.0)),
            });
            // Two gates at different heights leave room to turn.
            let class = if count == 2 { Open } else { critical.1 };
            if count == 2 {
                let comment = "Two gates on opposite sides of a line: a line that turns passes.";
                cases.push(Seq::new(comment, &["CommonLine"], gates.collect(), class));
                continue;
            }
            let comment = format!(
                "{count} gates, alternately right and left of the line x = y. The left ones reach \
                 {}/100 over it.",
                critical.0
            );
            cases.push(Seq::critical(comment, &["CommonLine"], gates.collect(), critical));
        }
    }
    Family::row("Gates on both sides of one line, each with an end on it.", cases)
}

/// Gates from one post outwards, turning around it by about half a turn.
fn around_a_post() -> Family {
    let mut cases = Vec::new();
    let zero = q(0);
    for (length, name) in [
        (q(1), "1"),
        (q(10), "10"),
        (q(1000), "1000"),
        (q(1_000_000), "1e6"),
        (power(30), "2^30"),
        (power(50), "2^50"),
    ] {
        for critical in TRIPLE {
            let last = [-length.clone(), q(critical.0)];
            let gates = vec![
                between([&zero, &zero], [&length, &zero]),
                between([&zero, &zero], [&length, &length]),
                between([&zero, &zero], [&zero, &length]),
                between([&zero, &zero], [&last[0], &last[1]]),
            ];
            let comment = format!(
                "Gates from one post, which stays on the left: first to ({name}, 0), last to \
                 (-{name}, {}). They turn by half a turn, but for one unit; a line turns by less.",
                critical.0
            );
            let case = Seq::critical(comment, &["SharedVertex", "TurnAround"], gates, critical);
            cases.extend([case.mirrored(), case.far(20)]);
            cases.push(case);
        }
    }
    Family::loose("Gates that share a post and turn around it.", cases)
}

/// Windows that overlap by little: what tolerances of 0.1, 0.05 or 0.01 close.
fn overlaps() -> Family {
    let mut cases = Vec::new();
    let sizes = [(1, 10), (1, 20), (3, 100), (1, 50), (1, 100), (1, 200), (1, 1000)];
    for (n, d) in sizes {
        let size = ratio(n, d);
        let flags: &[&'static str] = match d {
            10 | 20 => &["SmallOverlap"],
            _ => &["SmallClearance"],
        };
        for critical in TRIPLE {
            let over = &size * q(critical.0);
            let gates = vec![
                gate(&q(0), q(0), q(64)),
                gate(&q(64), q(64) - &over, q(128)),
                gate(&q(128), q(0), q(64)),
            ];
            let comment = format!(
                "Windows of 64 units in walls 64 apart; the middle one and the others overlap by \
                 {n}/{d} of a unit, are flush, or miss each other by it."
            );
            let case = Seq::critical(comment, flags, gates, critical);
            cases.extend([case.metres(), case.far(20), case.back(), case.mirrored()]);
            cases.push(case);
            let door = ratio(n, d);
            let gates = vec![
                gate(&q(0), q(0), q(64)),
                gate(&q(64), q(40), q(40) + &door),
                gate(&q(128), q(80) - &over, q(144)),
            ];
            let comment = format!(
                "A gap of {n}/{d} of a unit between two rooms, with a wide window on each side: \
                 many lines pass."
            );
            if critical.0 == 1 {
                let case = Seq::new(comment, &["ShortEdge"], gates, Open);
                cases.extend([case.metres(), case.far(20)]);
                cases.push(case);
            }
        }
    }
    Family::row("Windows that overlap by little, are flush, or miss each other.", cases)
}

fn on_one_line() -> Family {
    let mut cases = Vec::new();
    let at = |a: Q, b: Q| gate(&q(0), a, b);
    for (unit, name) in [(q(1), "1"), (ratio(1, 20), "1/20"), (tenth(9), "1e-9")] {
        for critical in TRIPLE {
            let over = &unit * q(critical.0);
            let pair = vec![at(q(0), q(4)), at(q(4) - &over, q(8))];
            // A line along both touches them; so the gap is grazing as well.
            let class = if critical.0 > 0 { Open } else { Grazing };
            let comment = format!(
                "Two gates on one line, crossed the same way, which share {} of length {name}. A \
                 line along them touches both in any case.",
                critical.0
            );
            cases.push(Seq::new(comment, &["Coplanar"], pair.clone(), class));
            let mut three = pair;
            three.push(gate(&q(10), q(0), q(8)));
            let comment = format!(
                "Two gates on one line and one behind them. What the two share, of length {name}, \
                 is all that lines can pass; a line along them misses the third."
            );
            let case = Seq::critical(comment, &["Coplanar", "TouchInPoint"], three, critical);
            cases.extend([case.far(40), case.sheared(), case.back()]);
            cases.push(case);
        }
    }
    Family::loose("Gates on one line.", cases)
}

fn twice() -> Family {
    let mut cases = Vec::new();
    let turned = |gate: &Polygon| gate.iter().rev().cloned().collect::<Polygon>();
    for count in [2, 3, 5, 17] {
        let gates = vec![gate(&q(3), q(0), q(1)); count];
        let comment = format!("One gate, {count} times.");
        cases.push(Seq::new(comment, &["Duplicate", "Coplanar"], gates, Open));
    }
    let door = gate(&q(0), q(0), q(2));
    let comment = "Out through a gate and back: only a line along it touches both.";
    let both = vec![door.clone(), turned(&door)];
    cases.push(Seq::new(comment, &["Duplicate", "Coplanar", "TurnAround"], both.clone(), Grazing));
    let mut three = both.clone();
    three.push(gate(&q(7), q(0), q(2)));
    let comment = "Out through a gate, back, and through a third that the line along them misses.";
    cases.push(Seq::new(comment, &["Duplicate", "Coplanar", "TurnAround"], three, Blocked));
    let mut three = both;
    three.push(between([&q(5), &q(1)], [&q(5), &q(-1)]));
    let comment = "Out through a gate, back, and through a third that the line along them crosses.";
    cases.push(Seq::new(comment, &["Duplicate", "Coplanar", "TurnAround"], three, Grazing));
    for critical in TRIPLE {
        let mut gates = vec![gate(&q(0), q(0), q(1)); 2];
        gates.extend(vec![gate(&q(5), q(1) - tenth(4) * q(critical.0), q(2)); 2]);
        gates.extend(vec![gate(&q(10), q(0), q(1)); 3]);
        let comment = "Three walls, each with the same door several times, doors flush to 1e-4.";
        cases.push(Seq::critical(comment, &["Duplicate"], gates, critical));
    }
    Family::loose("The same gate more than once, in one direction or in both.", cases)
}

fn no_way_forward() -> Family {
    let mut cases = Vec::new();
    for size in [1, 100, 1_000_000] {
        let [zero, s] = [q(0), q(size)];
        let triangle = vec![
            between([&s, &zero], [&zero, &zero]),
            between([&zero, &s], [&s, &zero]),
            between([&zero, &zero], [&zero, &s]),
        ];
        let comment = format!("Out through all three sides of a triangle of size {size}.");
        let case = Seq::new(comment, &["TurnAround", "SharedVertex"], triangle, Blocked);
        cases.extend([case.far(40), case.mirrored()]);
        cases.push(case);
    }
    let turned = vec![gate(&q(0), q(0), q(4)), gate(&q(9), q(4), q(0))];
    let comment = "Up through one gate and down through another.";
    cases.push(Seq::new(comment, &["TurnAround"], turned, Blocked));
    Family::loose("Gates whose directions have nothing in common.", cases)
}

fn chains() -> Family {
    let mut cases = Vec::new();
    for count in [20, 50, 100, 200] {
        for critical in TRIPLE {
            let gates = (0..count).map(|i| match i * 10 / count {
                1 if i * 10 % count == 0 => gate(&q(i), q(0), q(1)),
                3 if i * 10 % count == 0 => gate(&q(i), q(-1), tenth(6) * q(critical.0)),
                5 if i * 10 % count == 0 => gate(&q(i), q(0), q(1)),
                _ => gate(&q(i), q(-1), q(1)),
            });
            let comment = format!(
                "{count} gates in a row, of which three decide: posts in line, passed on alternate \
                 sides, to a millionth."
            );
            cases.push(Seq::critical(comment, &["LongChain"], gates.collect(), critical));
        }
    }
    Family::row("Many gates in a row.", cases)
}
