use super::super::chains::Side::{Left, Right};
use super::super::chains::{Chains, Cut, Place, Run, SidedEnd};
use crate::num::{Int, Sign};
use crate::oracle::{Family, Random, classify_2d, sequence_2d};
use crate::predicates::{PlanPoint, PlanPoints};

/// The edges that are kept, by looking at each; `None` for an end that changes nothing.
fn kept_edges(chains: &Chains, ends: &PlanPoints, new: SidedEnd) -> Option<Vec<usize>> {
    let signs: Vec<Sign> = (0..chains.len()).map(|i| chains.edge(ends, i, new)).collect();
    let is_good = |i: &usize| signs[*i] == Sign::Positive;
    signs.contains(&Sign::Negative).then(|| (0..signs.len()).filter(is_good).collect())
}

fn check_search(chains: &Chains, ends: &PlanPoints, new: SidedEnd) {
    if chains.len() < 3 {
        return;
    }
    let kept = kept_edges(chains, ends, new);
    match (chains.cut(ends, new, Place::Anywhere), kept) {
        (Cut::Redundant, None) => {}
        (Cut::Closed, Some(kept)) => assert_eq!(kept, [0; 0]),
        (Cut::Shrunk(Run { first, last }), Some(mut kept)) => {
            let n = chains.len();
            let edges = (last + n - first) % n;
            // A run around the whole list has the new end between last and first.
            let edges = if edges == 0 { n } else { edges };
            let mut run: Vec<usize> = (0..edges).map(|k| (first + k) % n).collect();
            run.sort_unstable();
            kept.sort_unstable();
            assert_eq!(run, kept);
        }
        (_, kept) => panic!("{kept:?} are kept"),
    }
}

fn check_list(chains: &Chains, ends: &PlanPoints) {
    let [left, right] = [Left, Right].map(|side| chains.chain(side));
    assert_eq!(left.is_empty(), right.is_empty());
    let n = chains.len();
    if n < 3 {
        return;
    }
    for i in 0..n {
        for k in (0..n).filter(|&k| k != i && k != (i + 1) % n) {
            assert_eq!(chains.edge(ends, i, chains.at(k)), Sign::Positive, "a convex list");
        }
    }
}

/// Segments between two bent walls with many corners, the long way through, then shuffled or not.
fn bent(random: &mut Random, count: i64, shuffled: bool) -> Vec<[[i64; 2]; 2]> {
    let bend = |y: i64| (y - count / 2) * (y - count / 2);
    let mut all: Vec<[[i64; 2]; 2]> = (0..count)
        .map(|y| {
            let [left, right] = [(); 2].map(|()| 300 + random.between(0, 1) + 3 * bend(y));
            [[-left, y * 8], [right, y * 8]]
        })
        .collect();
    if shuffled {
        for i in (1..all.len()).rev() {
            all.swap(i, random.between(0, i as i64) as usize);
        }
    }
    all
}

#[test]
fn the_search_finds_what_looking_at_every_edge_finds() {
    let mut random = Random::new(3);
    let mut longest = 0;
    for round in 0..400 {
        let (mut table, mut chains) = (PlanPoints::default(), Chains::default());
        let reach = [2, 6, 40][round % 3];
        let list = match round % 4 {
            0 | 1 => bent(&mut random, 24, round % 2 == 0),
            _ => (0..12)
                .map(|_| {
                    let mut x = |side: i64| side * random.between(0, reach);
                    [[x(-1) - 1, x(1)], [x(1) + 1, x(1)]]
                })
                .collect(),
        };
        let all = list.iter().flatten().copied().collect::<Vec<_>>();
        let mut number = |p: [i64; 2]| table.insert(PlanPoint::integer(p.map(Int::from)));
        let numbers: Vec<u32> = all.iter().map(|p| number(*p)).collect();
        for pair in numbers.chunks(2) {
            for &other in &numbers {
                check_search(&chains, &table, (other, Left));
                check_search(&chains, &table, (other, Right));
            }
            let is_open = chains.push(&table, pair[0], pair[1], Place::Anywhere);
            longest = longest.max(chains.len());
            if !is_open {
                break;
            }
            check_list(&chains, &table);
        }
    }
    assert!(longest >= 20, "{longest}");
}

#[test]
fn pops_put_back_what_was_there_and_the_twin_agrees() {
    let mut random = Random::new(17);
    for family in Family::ALL {
        for seed in 0..60 {
            let pool: Vec<_> = (0..4).flat_map(|k| sequence_2d(family, 61 * seed + k)).collect();
            // Thirds and sevenths, so that no filter stage has it all.
            let (mut table, by) = (PlanPoints::default(), [1, 21][seed as usize % 2]);
            let numbers: Vec<[u32; 2]> = pool
                .iter()
                .map(|ends| {
                    ends.clone().map(|p| {
                        let [x, y] = p.coordinates;
                        table.insert(PlanPoint::new([x, y, Int::from(by)]))
                    })
                })
                .collect();
            let (mut chains, mut stack, mut seen) = (Chains::default(), Vec::new(), Vec::new());
            for _ in 0..30 {
                if !stack.is_empty() && random.one_in(3) {
                    stack.pop();
                    chains.pop();
                    let lists: [Vec<u32>; 2] = seen.pop().unwrap();
                    assert_eq!([Left, Right].map(|side| chains.chain(side).to_vec()), lists);
                } else {
                    seen.push([Left, Right].map(|side| chains.chain(side).to_vec()));
                    let pick = random.between(0, pool.len() as i64 - 1) as usize;
                    stack.push(pool[pick].clone());
                    let [left, right] = numbers[pick];
                    chains.push(&table, left, right, Place::Anywhere);
                }
                assert_eq!(chains.depth(), stack.len());
                if stack.len() < 7 {
                    let truth = classify_2d(&stack) == crate::oracle::PlaneTruth::Open;
                    assert_eq!(chains.is_open(), truth || stack.is_empty(), "{family:?} {seed}");
                }
            }
        }
    }
}
