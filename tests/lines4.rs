//! The predicates on four and five lines against the transversals themselves, over Q(√d).

use stabline::geom::{BigLine, Line, Point3};
use stabline::num::{Int, Sign, Surd};
use stabline::oracle::Random;
use stabline::predicates::{
    Budget, FourLines, Sides, TransversalCount, side_of_transversals, side_of_transversals_big,
    transversal_count, transversal_count_big,
};
use stabline::stab::transversals::{IsolatedLine, Transversals, transversals};

fn line(random: &mut Random, reach: i64) -> Line {
    loop {
        let [p, q] = [(); 2].map(|()| [(); 3].map(|()| random.between(-reach, reach)));
        if p != q {
            let point = |[x, y, z]: [i64; 3]| Point3::new(x, y, z).unwrap();
            return Line::through(&point(p), &point(q)).unwrap();
        }
    }
}

fn expected(result: &Transversals) -> TransversalCount {
    let at_infinity = result.at_infinity.iter().map(|line| line.multiplicity);
    let finite = result.isolated.iter().map(|line| line.multiplicity);
    let multiplicities: Vec<u8> = finite.chain(at_infinity).collect();
    match (result.families.is_empty(), multiplicities.as_slice()) {
        (false, _) => TransversalCount::Family,
        (true, []) => TransversalCount::None,
        (true, [2]) => TransversalCount::One,
        (true, [1, 1]) => TransversalCount::Two,
        (true, other) => panic!("multiplicities {other:?}"),
    }
}

/// The grids: everything degenerate, nothing degenerate, and the ends of the fixed widths.
const REACHES: [i64; 7] = [1, 2, 1000, 1 << 20, 1 << 24, 1 << 32, 1 << 38];

#[test]
fn the_count_is_that_of_the_lines_themselves() {
    let mut random = Random::new(3);
    let mut seen = [0; 4];
    for reach in REACHES {
        for _ in 0..if reach <= 2 { 3000 } else { 150 } {
            let lines = [(); 4].map(|()| line(&mut random, reach));
            let big = lines.map(BigLine::from);
            let truth = expected(&transversals(&big));
            let [a, b, c, d] = &lines;
            let budget = Budget::for_bits(u64::BITS - (reach as u64 - 1).leading_zeros());
            for budget in [budget, budget.without_filters(), Budget::FULL] {
                assert_eq!(transversal_count([a, b, c, d], &budget), truth, "{lines:?}");
                assert_eq!(transversal_count([c, a, d, b], &budget), truth, "{lines:?}");
            }
            assert_eq!(transversal_count_big(big), truth, "{lines:?}");
            seen[truth as usize] += 1;
        }
    }
    assert!(seen.iter().all(|&n| n > 20), "{seen:?}");
}

fn surd_side(x: &IsolatedLine, direction: &[Int; 3], moment: &[Int; 3]) -> Surd {
    let term = |a: &Surd, b: &Int| a * &Surd::from(b.clone());
    (0..3).fold(Surd::from(Int::from(0)), |sum, i| {
        &(&sum + &term(&x.direction[i], &moment[i])) + &term(&x.moment[i], &direction[i])
    })
}

#[test]
fn the_fifth_line_is_where_both_transversals_say() {
    let mut random = Random::new(4);
    let mut seen = [0; 3];
    for reach in REACHES {
        for _ in 0..if reach <= 2 { 1500 } else { 60 } {
            let lines = [(); 4].map(|()| line(&mut random, reach));
            let fifth = line(&mut random, reach);
            let [a, b, c, d] = &lines;
            let result = transversals(&lines.map(BigLine::from));
            let budget = Budget::for_bits(u64::BITS - (reach as u64 - 1).leading_zeros());
            let sign = side_of_transversals([a, b, c, d], &fifth, &budget);
            let plain = side_of_transversals([b, d, c, a], &fifth, &budget.without_filters());
            assert_eq!(sign, plain);
            assert_eq!(side_of_transversals([a, b, c, &fifth], d, &Budget::FULL), sign);
            let [e, f, g, h] = lines.map(BigLine::from);
            assert_eq!(side_of_transversals_big([e, f, g, h, fifth.into()]), sign);
            if let [l, m] = result.isolated.as_slice() {
                let fifth = BigLine::from(fifth);
                let [x, y] = [l, m].map(|t| surd_side(t, &fifth.direction, &fifth.moment));
                let across = (0..3).fold(Surd::from(Int::from(0)), |sum, i| {
                    let there = &l.direction[i] * &m.moment[i];
                    let back = &l.moment[i] * &m.direction[i];
                    &(&sum + &there) + &back
                });
                assert_eq!(sign, x.sign() * y.sign() * across.sign(), "{lines:?} {fifth:?}");
                seen[(sign as i8 + 1) as usize] += 1;
            }
        }
    }
    assert!(seen.iter().all(|&n| n > 100), "{seen:?}");
}

#[test]
fn zero_means_that_a_transversal_is_met() {
    // A fifth line equal to one of the four is met by both transversals.
    let mut random = Random::new(8);
    for _ in 0..200 {
        let lines = [(); 4].map(|()| line(&mut random, 1 << 20));
        let [a, b, c, d] = &lines;
        assert_eq!(side_of_transversals([a, b, c, d], b, &Budget::FULL), Sign::Zero);
    }
}

/// A transversal as six numbers, directed as `FourLines` says.
fn directed(direction: &[Surd; 3], moment: &[Surd; 3]) -> Vec<Surd> {
    let line: Vec<Surd> = direction.iter().chain(moment).cloned().collect();
    match line.iter().map(Surd::sign).find(|&sign| sign != Sign::Zero) {
        Some(Sign::Negative) => line.iter().map(|x| -x).collect(),
        Some(Sign::Positive | Sign::Zero) | None => line,
    }
}

fn product(x: &[Surd], y: &[Surd]) -> Surd {
    (0..6).fold(Surd::from(Int::from(0)), |sum, i| &sum + &(&x[i] * &y[(i + 3) % 6]))
}

fn determinant(rows: &[Vec<Surd>]) -> Surd {
    let Some((first, rest)) = rows.split_first() else {
        return Surd::from(Int::from(1));
    };
    let mut sum = Surd::from(Int::from(0));
    for (k, x) in first.iter().enumerate() {
        if x.is_zero() {
            continue;
        }
        let minor: Vec<Vec<Surd>> = rest
            .iter()
            .map(|row| row[..k].iter().chain(&row[k + 1..]).cloned().collect())
            .collect();
        let term = x * &determinant(&minor);
        sum = if k % 2 == 0 { &sum + &term } else { &sum - &term };
    }
    sum
}

/// What `FourLines` should say, from the transversals themselves.
fn expected_sides(lines: &[Line; 4], fifths: &[Line]) -> Vec<Sides> {
    let big = lines.map(BigLine::from);
    let result = transversals(&big);
    let zero = || [(); 3].map(|()| Surd::from(Int::from(0)));
    let finite = result.isolated.iter().map(|l| directed(&l.direction, &l.moment));
    let infinite = result.at_infinity.iter().map(|l| directed(&zero(), &l.normal));
    let mut found: Vec<Vec<Surd>> = finite.chain(infinite).collect();
    let whole = |line: &BigLine| -> Vec<Surd> {
        line.direction.iter().chain(&line.moment).map(|x| Surd::from(x.clone())).collect()
    };
    if let [first, second] = found.as_slice() {
        let mut rows: Vec<Vec<Surd>> = vec![first.clone(), second.clone()];
        rows.extend(big.iter().map(whole));
        // Two rows past four others: an even permutation.
        let order = determinant(&rows).sign() * product(first, second).sign();
        assert_ne!(order, Sign::Zero);
        if order == Sign::Negative {
            found.reverse();
        }
    }
    let sides = |fifth: &Line| {
        let fifth = whole(&BigLine::from(*fifth));
        match found.as_slice() {
            _ if !result.families.is_empty() => Sides::Family,
            [] => Sides::None,
            [only] => Sides::One(product(only, &fifth).sign()),
            [first, second] => Sides::Two([first, second].map(|l| product(l, &fifth).sign())),
            more => panic!("{} transversals", more.len()),
        }
    };
    fifths.iter().map(sides).collect()
}

/// How the lines of a test lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Anywhere,
    /// Parallel to the axes, on few levels.
    Axial,
    /// Through few points.
    SharedVertices,
    /// In few directions.
    Parallel,
    /// In few planes.
    Coplanar,
    /// On few reguli: of z = xy, scaled.
    Ruled,
    /// Between corners and face centres of the box.
    Extreme,
}

const KINDS: [Kind; 7] = [
    Kind::Anywhere,
    Kind::Axial,
    Kind::SharedVertices,
    Kind::Parallel,
    Kind::Coplanar,
    Kind::Ruled,
    Kind::Extreme,
];

fn pool(kind: Kind, reach: i64, random: &mut Random) -> Vec<Line> {
    let few = |random: &mut Random, reach: i64| -> Vec<[i64; 3]> {
        (0..3).map(|_| [(); 3].map(|()| random.between(-reach, reach))).collect()
    };
    let (levels, far) = (few(random, reach), few(random, reach));
    let near = few(random, (reach / 4).max(1));
    let mut lines = Vec::new();
    while lines.len() < 9 {
        let place = |random: &mut Random| random.between(0, 2) as usize;
        let anywhere = |random: &mut Random| [(); 3].map(|()| random.between(-reach, reach));
        let (p, q) = match kind {
            Kind::Anywhere => (anywhere(random), anywhere(random)),
            Kind::Axial => {
                let p = [0, 1, 2].map(|axis| levels[place(random)][axis]);
                let (axis, mut q) = (place(random), p);
                q[axis] = random.between(-reach, reach);
                (p, q)
            }
            Kind::SharedVertices => (far[place(random)], anywhere(random)),
            Kind::Parallel => {
                let p = [(); 3].map(|()| random.between(-reach / 2, reach / 2));
                let step = near[place(random)];
                (p, [0, 1, 2].map(|k| p[k] + step[k]))
            }
            Kind::Coplanar => {
                // In a plane through the origin, spanned by two of few vectors.
                let (u, v) = (near[place(random)], near[place(random)]);
                let mut point = || {
                    let [s, t] = [(); 2].map(|()| random.between(-2, 2));
                    [0, 1, 2].map(|k| s * u[k] + t * v[k])
                };
                let (p, q) = (point(), point());
                (p, q)
            }
            Kind::Ruled => {
                // Both families of z = xy, and lines off it.
                let root = (reach as f64).sqrt() as i64;
                let [x, y] = [(); 2].map(|()| random.between(-root, root));
                let other = random.between(-root, root);
                match place(random) {
                    0 => ([x, y, x * y], [x, other, x * other]),
                    1 => ([x, y, x * y], [other, y, other * y]),
                    _ => ([x, y, x * y], anywhere(random)),
                }
            }
            Kind::Extreme => {
                let mut corner =
                    || [(); 3].map(|()| [-reach, reach, reach, 0][random.between(0, 3) as usize]);
                let (p, q) = (corner(), corner());
                (p, q)
            }
        };
        let inside = |p: [i64; 3]| p.iter().all(|c| c.abs() <= reach);
        if p != q && inside(p) && inside(q) {
            let point = |[x, y, z]: [i64; 3]| Point3::new(x, y, z).unwrap();
            lines.push(Line::through(&point(p), &point(q)).unwrap());
        }
    }
    lines
}

#[test]
fn each_transversal_passes_lines_as_the_lines_themselves_say() {
    let mut random = Random::new(11);
    let mut seen = [0; 4];
    for kind in KINDS {
        for reach in [2, 8, 1000, 1 << 20, 1 << 23, 1 << 24, 1 << 27, 1 << 33, 1 << 38] {
            for _ in 0..if reach <= 8 { 80 } else { 12 } {
                let lines = pool(kind, reach, &mut random);
                let (four, _) = lines.split_first_chunk::<4>().unwrap();
                let expected = expected_sides(four, &lines);
                let budget = Budget::for_bits(u64::BITS - (reach as u64 - 1).leading_zeros());
                for budget in [budget, budget.without_filters(), Budget::FULL] {
                    let solved = FourLines::new(four.each_ref(), &budget);
                    assert_eq!(solved.count(), transversal_count(four.each_ref(), &budget));
                    for (line, sides) in lines.iter().zip(&expected) {
                        assert_eq!(
                            solved.sides_of_each(line),
                            *sides,
                            "{kind:?} {reach} {budget:?} {lines:?}"
                        );
                    }
                }
                let kind = match expected[0] {
                    Sides::None => 0,
                    Sides::One(_) => 1,
                    Sides::Two(_) => 2,
                    Sides::Family => 3,
                };
                seen[kind] += 1;
            }
        }
    }
    assert!(seen.iter().all(|&n| n > 20), "{seen:?}");
}
