//! Compares the visibility that a level's source has, exactly, with what compiled levels of it say.
//!
//! Points are rational and random, in the cells that the source falls into. Two of them see each
//! other iff the segment between them misses every brush that occludes, which is decided straight
//! from the brushes (`oracle::Occluders`). Of two points that do, the cells must see each other:
//! ours without exception, and in a compiled level the leafs that its own tree puts them into.
//!
//! Pairs of points are of three kinds: in any two cells (`any`), in two cells a few portals apart
//! (`near`), and on the sightline of any open pair of cells (`sightline`), which always see each
//! other and are what a narrow view leaves.
//!
//! Brushes of details (`func_detail` and other entities) hide nothing here. A compiler may find a
//! leaf that they fill, and takes it for a wall; so of the pairs that a level has lost those are
//! counted apart that see each other past all details too.
//!
//! A point counts in a compiled level only if no plane on the way down its tree is nearer than
//! 1/8 of a unit (compilers round planes), and the leaf has a row of visibility.
//!
//! ```text
//! cargo run --release --example compare_levels -- LEVEL.map [LEVEL.bsp ...] COUNT SEED
//! ```
//!
//! The exit code is 1 if points see each other in cells that ours calls not open.

use num_traits::{Signed, ToPrimitive};
use stabline::formats::bsp::{BitMatrix, LevelChild, LevelTree, Visibility};
use stabline::geom::{BigPlane, RationalPoint3};
use stabline::num::{Int, Rational};
use stabline::oracle::{Occluders, Random, middle_within};
use stabline::portal::{WorldCells, cells_of_world};
use stabline::pvs;
use stabline::report::{Matrix, PairWitness, Silent, Verdict};
use stabline::scene::level::Role;
use stabline::scene::{Level, LevelOptions, World, read_level};
use stabline::subdivision;
use std::error::Error;
use std::process::ExitCode;

/// A plane of a compiled level nearer to a point than 1 / this leaves its leaf in doubt.
const CLEARANCE: i64 = 8;
/// The most examples to show of each kind of finding.
const SHOWN: usize = 3;

/// The cells of a level's source and which see each other.
struct Source {
    occluders: Occluders,
    /// Brushes that a game draws and a compiler may take for walls, and that we look through.
    details: Occluders,
    cells: WorldCells,
    matrix: Matrix,
    witnesses: Vec<PairWitness>,
    /// The other ends of each cell's portals.
    neighbours: Vec<Vec<usize>>,
}

impl Source {
    fn new(level: &Level) -> Result<Source, Box<dyn Error>> {
        let world = World::of_level(level);
        let cells = cells_of_world(&world, &subdivision::Options::default())?;
        let mut occluders = Occluders::default();
        for (index, solid) in world.solids.iter().enumerate() {
            // What has no volume occludes nothing.
            if !cells.subdivision.flat.contains(&index) {
                occluders.add_solid(&solid.planes);
            }
        }
        let mut details = Occluders::default();
        for brush in level.brushes.iter().filter(|brush| brush.role == Role::Detail) {
            let planes: Vec<BigPlane> = brush.faces.iter().map(|f| f.plane.clone()).collect();
            details.add_solid(&planes);
        }
        let options = pvs::Options::default();
        let finished = pvs::compute(&cells.graph, &options, Vec::new(), &|_| {}, &Silent);
        let matrix = pvs::assemble(&cells.graph, &finished.rows);
        let witnesses = pvs::witnesses(&finished.rows);
        let mut neighbours = vec![Vec::new(); cells.leaves.len()];
        for portal in &cells.graph.portals {
            let [from, to] = [portal.from, portal.to].map(|cell| cell.0 as usize);
            neighbours[from].push(to);
            neighbours[to].push(from);
        }
        Ok(Source { occluders, details, cells, matrix, witnesses, neighbours })
    }

    fn random_cell(&self, random: &mut Random) -> usize {
        random.between(0, self.cells.leaves.len() as i64 - 1) as usize
    }

    /// A random mean of the cell's corners.
    fn point_in(&self, cell: usize, random: &mut Random) -> RationalPoint3 {
        let leaf = self.cells.subdivision.leaf(self.cells.leaves[cell]);
        let corners = leaf.cell.faces().iter().flat_map(|face| face.points());
        let (mut sum, mut total) = ([(); 3].map(|()| Rational::from(Int::ZERO)), 0);
        for corner in corners {
            let weight = random.between(1, 100);
            let corner = corner.coordinates();
            sum = [0, 1, 2].map(|i| &sum[i] + &corner[i] * Int::from(weight));
            total += weight;
        }
        RationalPoint3::from(&sum.map(|c| c / Int::from(total)))
    }

    fn pair(&self, kind: Kind, random: &mut Random) -> [RationalPoint3; 2] {
        let from = self.random_cell(random);
        let to = match kind {
            Kind::Any => self.random_cell(random),
            Kind::Near => (0..random.between(1, 10)).fold(from, |cell, _| {
                let next = &self.neighbours[cell];
                match next.len() as i64 {
                    0 => cell,
                    count => next[random.between(0, count - 1) as usize],
                }
            }),
            Kind::Sightline if self.witnesses.is_empty() => from,
            Kind::Sightline => {
                let index = random.between(0, self.witnesses.len() as i64 - 1) as usize;
                return self.on_sightline(&self.witnesses[index]);
            }
        };
        [from, to].map(|cell| self.point_in(cell, random))
    }

    /// The middles of a sightline's parts in its two cells.
    fn on_sightline(&self, witness: &PairWitness) -> [RationalPoint3; 2] {
        let exact = |point: &[_; 3]| {
            RationalPoint3::from(&point.each_ref().map(stabline::num::Number::to_rational))
        };
        let [p, q] = witness.line.in_space().each_ref().map(exact);
        [witness.from, witness.to].map(|cell| {
            let subdivision = &self.cells.subdivision;
            let leaf = subdivision.leaf(self.cells.leaves[cell as usize]);
            let supports = leaf.cell.faces().iter().map(|face| face.support());
            let planes: Vec<BigPlane> =
                supports.map(|plane| subdivision.planes.plane(plane).clone()).collect();
            middle_within([&p, &q], &planes).expect("a sightline passes through its cells")
        })
    }

    /// Whether all cells of one point see all of the other's, and both have some.
    fn has(&self, points: &[RationalPoint3; 2]) -> bool {
        let [from, to] = points.each_ref().map(|point| {
            let leaves = self.cells.subdivision.locate(point);
            let cells = leaves.iter().map(|leaf| self.cells.leaves.binary_search(leaf).ok());
            cells.collect::<Option<Vec<usize>>>().unwrap_or_default()
        });
        let open = |a: usize, b: usize| self.matrix.get(a, b) == Verdict::Open;
        let all = from.iter().all(|&a| to.iter().all(|&b| open(a, b)));
        all && !from.is_empty() && !to.is_empty()
    }
}

/// Which pairs of points.
#[derive(Clone, Copy, Debug)]
enum Kind {
    Any,
    Near,
    Sightline,
}

impl Kind {
    const ALL: [(Kind, &str); 3] =
        [(Kind::Any, "any"), (Kind::Near, "near"), (Kind::Sightline, "sightline")];
}

/// A compiled level.
struct Peer {
    name: String,
    tree: LevelTree,
    rows: BitMatrix,
}

impl Peer {
    fn read(path: &str) -> Result<Peer, Box<dyn Error>> {
        let bytes = std::fs::read(path).map_err(|error| format!("{path}: {error}"))?;
        let in_file = |error| format!("{path}: {error}");
        let tree = LevelTree::read(&bytes).map_err(in_file)?;
        let rows = Visibility::read(&bytes).map_err(in_file)?.matrix;
        Ok(Peer { name: file_name(path).to_owned(), tree, rows })
    }

    /// The row of the leaf that has the point; `None` where the leaf is in doubt or has no row.
    fn row(&self, point: &RationalPoint3) -> Option<usize> {
        let mut child = self.tree.root;
        let leaf = loop {
            let node = match child {
                LevelChild::Leaf(leaf) => break leaf as usize,
                LevelChild::Node(node) => &self.tree.nodes[node as usize],
            };
            let BigPlane { normal, offset } = &node.plane;
            let sum: Int = normal.iter().zip(point.numerators()).map(|(n, x)| n * x).sum();
            let height = sum - offset * point.denominator();
            // Of the nearest points of the plane, how far one is along the axes.
            let reach: Int = normal.iter().map(Int::abs).sum();
            if height.abs() * Int::from(CLEARANCE) <= reach * point.denominator() {
                return None;
            }
            child = if height.is_positive() { node.front } else { node.back };
        };
        let row = leaf.checked_sub(1)?;
        (row < self.rows.size()).then_some(row)
    }
}

/// How often a program has pairs that see each other, and pairs that do not.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Score {
    seeing: usize,
    seeing_had: usize,
    /// Of those that see each other and are not had, how many see each other past all details too.
    lost_past_details: usize,
    hidden: usize,
    hidden_had: usize,
    not_located: usize,
    /// Pairs that see each other past all details and are not had.
    examples: Vec<[RationalPoint3; 2]>,
}

impl Score {
    fn add(&mut self, source: &Source, sees: bool, has: bool, points: &[RationalPoint3; 2]) {
        if !sees {
            self.hidden += 1;
            self.hidden_had += usize::from(has);
            return;
        }
        self.seeing += 1;
        self.seeing_had += usize::from(has);
        if !has && source.details.let_see(&points[0], &points[1]) {
            self.lost_past_details += 1;
            if self.examples.len() < SHOWN {
                self.examples.push(points.clone());
            }
        }
    }

    fn line(&self, kind: &str, program: &str) -> String {
        let lost = self.seeing - self.seeing_had;
        let percent = |part: usize, whole: usize| 100.0 * part as f64 / whole.max(1) as f64;
        format!(
            "{kind:<10} {program:<22} {:>8} {lost:>7} {:>8.4} {:>8} {:>8} {:>7.2} {:>8}",
            self.seeing,
            percent(lost, self.seeing),
            self.lost_past_details,
            self.hidden,
            percent(self.hidden_had, self.hidden),
            self.not_located,
        )
    }
}

/// The scores of `count` pairs of a kind: ours, then each peer's.
fn scores(source: &Source, peers: &[Peer], kind: Kind, count: usize, seed: u64) -> Vec<Score> {
    let mut random = Random::new(seed);
    let mut scores = vec![Score::default(); peers.len() + 1];
    for _ in 0..count {
        let points = source.pair(kind, &mut random);
        let sees = source.occluders.let_see(&points[0], &points[1]);
        scores[0].add(source, sees, source.has(&points), &points);
        for (peer, score) in peers.iter().zip(&mut scores[1..]) {
            let [Some(from), Some(to)] = points.each_ref().map(|point| peer.row(point)) else {
                score.not_located += 1;
                continue;
            };
            score.add(source, sees, peer.rows.get(from, to), &points);
        }
    }
    scores
}

fn file_name(path: &str) -> &str {
    path.rsplit('/').next().unwrap_or(path)
}

fn show(point: &RationalPoint3) -> String {
    let decimals = point.coordinates().map(|c| format!("{:.3}", c.to_f64().unwrap_or(f64::NAN)));
    format!("({})", decimals.join(" "))
}

/// Whether ours has every pair of points that see each other.
fn compare(source: &Source, peers: &[Peer], count: usize, seed: u64) -> bool {
    println!(
        "{:<10} {:<22} {:>8} {:>7} {:>8} {:>8} {:>8} {:>7} {:>8}",
        "pairs", "program", "see", "lost", "lost %", "of them*", "hidden", "had %", "left out"
    );
    let mut findings = Vec::new();
    let mut holds = true;
    for (kind, name) in Kind::ALL {
        let scores = scores(source, peers, kind, count, seed);
        holds &= scores[0].seeing == scores[0].seeing_had;
        let programs = ["stabline"].into_iter().chain(peers.iter().map(|peer| peer.name.as_str()));
        for (program, score) in programs.zip(&scores) {
            println!("{}", score.line(name, program));
            findings.extend(score.examples.iter().map(|points| {
                let [p, q] = points.each_ref().map(show);
                format!("{program} lacks {p} -> {q} ({name})")
            }));
        }
    }
    println!("* that miss the brushes of details as well, which some compilers take for walls");
    findings.iter().for_each(|finding| println!("{finding}"));
    holds
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [map, levels @ .., count, seed] = &arguments[..] else {
        return Err("usage: compare_levels LEVEL.map [LEVEL.bsp ...] COUNT SEED".into());
    };
    let (count, seed) = (count.parse()?, seed.parse()?);
    let bytes = std::fs::read(map).map_err(|error| format!("{map}: {error}"))?;
    let level = read_level(file_name(map), &bytes, LevelOptions::default())?;
    let source = Source::new(&level)?;
    let peers = levels.iter().map(|path| Peer::read(path)).collect::<Result<Vec<_>, _>>()?;
    let open = source.matrix.counts().open;
    println!("{}: {} cells, {open} open pairs", file_name(map), source.cells.leaves.len());
    let holds = compare(&source, &peers, count, seed);
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

#[cfg(test)]
mod tests {
    use super::*;
    use stabline::formats::bsp::LevelNode;
    use stabline::subdivision::Child;

    const LEVEL: &[u8] = include_bytes!("../scenes/bsp/two_rooms_door_slab.map");

    fn source() -> Source {
        let level = read_level("rooms", LEVEL, LevelOptions::default()).unwrap();
        Source::new(&level).unwrap()
    }

    /// Our own tree as a compiled level, in which the first `blind` cells see nothing.
    fn as_peer(source: &Source, blind: usize) -> Peer {
        let (division, cells) = (&source.cells.subdivision, &source.cells.leaves);
        let child = |child: Child| match child {
            Child::Node(node) => LevelChild::Node(node),
            Child::Leaf(leaf) => {
                let row = cells.binary_search(&leaf).map_or(0, |cell| cell as u32 + 1);
                LevelChild::Leaf(row)
            }
        };
        let nodes = division.nodes.iter().map(|node| LevelNode {
            plane: division.planes.plane(node.section.support()).clone(),
            front: child(node.front),
            back: child(node.back),
        });
        let contents = vec![-1; cells.len() + 1];
        let tree = LevelTree { root: child(division.root), nodes: nodes.collect(), contents };
        let mut rows = BitMatrix::new(cells.len());
        for from in blind..cells.len() {
            (0..cells.len()).for_each(|to| rows.set(from, to));
        }
        Peer { name: "peer".to_owned(), tree, rows }
    }

    #[test]
    fn ours_has_all_pairs_and_a_blind_program_lacks_some() {
        let source = source();
        let peers = [0, 2].map(|blind| as_peer(&source, blind));
        for (kind, name) in Kind::ALL {
            let [ours, all, blind] = &scores(&source, &peers, kind, 300, 5)[..] else {
                panic!("three programs");
            };
            assert_eq!(ours.seeing, ours.seeing_had, "{name}");
            assert_eq!(ours.seeing + ours.hidden, 300, "{name}");
            assert_eq!((all.seeing, all.hidden), (all.seeing_had, all.hidden_had), "{name}");
            assert!(all.not_located < 100 && blind.seeing_had < blind.seeing, "{name}: {blind:?}");
            assert_eq!(blind.examples.len(), SHOWN, "{name}");
            match kind {
                Kind::Any | Kind::Near => assert!(ours.hidden > 0, "{name}"),
                Kind::Sightline => assert_eq!(ours.hidden, 0, "a sightline is blocked"),
            }
        }
    }

    #[test]
    fn a_table_without_open_pairs_is_found_out() {
        let mut source = source();
        assert!(compare(&source, &[], 100, 1));
        source.matrix = Matrix::new(source.matrix.size(), Verdict::NotOpen);
        assert!(!compare(&source, &[], 100, 1));
    }
}
