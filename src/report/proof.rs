//! Proofs of a potentially visible set: what a checker that trusts nothing needs, as text.
//!
//! The format, `stabline-proof/1`, is described in `docs/formats/proof.md`: the portal graph, a
//! claim for every pair of cells, a line for every open and every grazing pair, and for each cell
//! a tree of portal sequences that leaves no way to the cells that it does not see.

use super::{InputId, Matrix};
use crate::geom::RationalPoint3;
use crate::geom::vector::cross;
use crate::num::{Int, Rational};
use crate::scene::{CellId, PortalGraph};
use crate::stab::{Certificate, Condition, Factor, Product, QuadricProof};
use num_integer::Integer;
use sha2::{Digest, Sha256};
use std::fmt::Write;
use std::io;

/// The name of the format, its first line.
pub const FORMAT: &str = "stabline-proof/1";

/// A portal with a direction of crossing: twice its index in the graph, and one more where it is
/// crossed from its cell `to` into its cell `from`.
pub type DirectedPortal = u32;

/// The sequences from one cell to those that it does not see.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProofTree {
    /// The cell.
    pub source: CellId,
    /// The nodes, each after its parent, in the order of a depth-first walk.
    pub nodes: Vec<ProofNode>,
}

/// A portal sequence that had to be looked at.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProofNode {
    /// The number of its portals; that of its parent is one less.
    pub depth: u32,
    /// The last of them.
    pub portal: DirectedPortal,
    /// Why no line passes it; without, the node's children go on.
    pub refutation: Option<Refutation>,
    /// Portals that no line meets after the sequence.
    pub cuts: Vec<Cut>,
}

/// Portals that no line through a sequence crosses after it, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cut {
    /// Why.
    pub reason: CutReason,
    /// Which, in ascending order.
    pub portals: Vec<DirectedPortal>,
}

/// Why portals cannot be crossed after a sequence.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum CutReason {
    /// They are wholly behind the plane of this portal of the sequence, or it is wholly in front
    /// of theirs.
    Behind {
        /// Its position, from 0.
        position: u32,
    },
    /// They are wholly behind a plane that has one portal of the sequence behind it and a later
    /// one in front.
    Separated {
        /// The positions of the two.
        positions: [u32; 2],
        /// Three vertices of the plane; its front sees them counter-clockwise.
        through: [u32; 3],
    },
}

/// Why no line passes a sequence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refutation {
    /// Its last two portals lie in one plane, so no line crosses the one before the other.
    Flush,
    /// Of its conditions.
    Certificate {
        /// On a grid.
        certificate: Box<Certificate>,
        /// Units of the grid in one world unit.
        units: Int,
    },
}

/// What a proof says of its origin.
#[derive(Clone, Copy, Debug)]
pub struct ProofHead<'a> {
    /// The program and its version.
    pub program: &'a str,
    /// What was read.
    pub input: &'a InputId,
}

/// A cell that another sees, by a line through directed portals.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProvedOpen {
    /// The cell seen.
    pub target: CellId,
    /// The portals crossed on the way.
    pub portals: Vec<DirectedPortal>,
    /// Two points of the line, in its direction.
    pub line: [RationalPoint3; 2],
}

/// A pair of cells joined by a touching line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProvedGrazing {
    /// The cell where the sequence begins.
    pub source: CellId,
    /// The cell where it ends.
    pub target: CellId,
    /// The portals touched.
    pub portals: Vec<DirectedPortal>,
    /// The line's vector, direction and moment in world units up to a positive factor: its rational
    /// part and the factor of the root.
    pub line: [[Int; 6]; 2],
    /// What the root is of.
    pub radicand: Int,
}

/// A proof that is being written, part after part.
///
/// The first error of the writer ends the writing; [`ProofText::finish`] tells of it.
pub struct ProofText<'a, W> {
    out: W,
    graph: &'a PortalGraph,
    hash: Sha256,
    error: Option<io::Error>,
}

impl<'a, W: io::Write> ProofText<'a, W> {
    /// Begins with the head, the graph and the claims of `matrix`.
    pub fn new(
        out: W,
        head: &ProofHead,
        graph: &'a PortalGraph,
        matrix: &Matrix,
    ) -> ProofText<'a, W> {
        let mut text = ProofText { out, graph, hash: Sha256::new(), error: None };
        let InputId { name, blake3 } = head.input;
        text.write(&format!("{FORMAT}\nprogram {}\n", head.program));
        text.write(&format!("input {blake3} {}\n", name.escape_debug()));
        text.write(&graph_text(graph));
        text.write("claims\n");
        for cell in 0..graph.cells.len() {
            let digits = matrix.row(cell).iter().map(|verdict| char::from(b'0' + *verdict as u8));
            text.write(&digits.chain(['\n']).collect::<String>());
        }
        text
    }

    /// Adds the proof of an open pair.
    pub fn open(&mut self, source: CellId, pair: &ProvedOpen) {
        let mut text = format!("open {} {}", source.0, pair.target.0);
        for point in &pair.line {
            let [x, y, z] = point.numerators();
            push(&mut text, format_args!(" {x} {y} {z} {}", point.denominator()));
        }
        pair.portals.iter().for_each(|portal| push(&mut text, format_args!(" {portal}")));
        text.push('\n');
        self.write(&text);
    }

    /// Adds the proof of a grazing pair.
    pub fn grazing(&mut self, pair: &ProvedGrazing) {
        let mut text = format!("grazing {} {} {}", pair.source.0, pair.target.0, pair.radicand);
        pair.line.iter().flatten().for_each(|c| push(&mut text, format_args!(" {c}")));
        pair.portals.iter().for_each(|portal| push(&mut text, format_args!(" {portal}")));
        text.push('\n');
        self.write(&text);
    }

    /// Adds the tree of a cell.
    pub fn tree(&mut self, tree: &ProofTree) {
        self.write(&tree.text(self.graph));
    }

    /// Ends with the hash of all that was written.
    ///
    /// # Errors
    /// The first error of the writer.
    pub fn finish(mut self) -> io::Result<W> {
        let digest = std::mem::take(&mut self.hash).finalize();
        let digits: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
        self.write(&format!("sha256 {digits}\n"));
        match self.error {
            Some(error) => Err(error),
            None => Ok(self.out),
        }
    }

    fn write(&mut self, text: &str) {
        self.hash.update(text);
        if self.error.is_none() {
            self.error = self.out.write_all(text.as_bytes()).err();
        }
    }
}

/// The part of a proof that states its portal graph.
pub fn graph_text(graph: &PortalGraph) -> String {
    let mut text = String::new();
    let mut line = |args: std::fmt::Arguments| {
        text.write_fmt(args).expect("a string takes any text");
        text.push('\n');
    };
    line(format_args!("cells {}", graph.cells.len()));
    for name in &graph.cells {
        // A name is one line whatever is in it.
        line(format_args!("{}", name.escape_debug()));
    }
    line(format_args!("vertices {}", graph.vertices.len()));
    for vertex in &graph.vertices {
        let [x, y, z] = vertex.numerators();
        line(format_args!("{x} {y} {z} {}", vertex.denominator()));
    }
    line(format_args!("portals {}", graph.portals.len()));
    for portal in &graph.portals {
        let corners: String = portal.vertices.iter().map(|vertex| format!(" {vertex}")).collect();
        line(format_args!("{} {} {}{corners}", portal.from.0, portal.to.0, portal.source));
    }
    text
}

impl ProofTree {
    /// The tree as text.
    fn text(&self, graph: &PortalGraph) -> String {
        let mut text = format!("source {}\n", self.source.0);
        let mut path: Vec<DirectedPortal> = Vec::new();
        for node in &self.nodes {
            path.truncate(node.depth as usize - 1);
            path.push(node.portal);
            push(&mut text, format_args!("{} {}", node.depth, node.portal));
            for cut in &node.cuts {
                push_cut(&mut text, cut);
            }
            match &node.refutation {
                None => {}
                Some(Refutation::Flush) => {
                    push(&mut text, format_args!(" l 1 o{} 1", path.len() - 1));
                }
                Some(Refutation::Certificate { certificate, units }) => {
                    let portals = path.iter().map(|&portal| corners(graph, portal)).collect();
                    let scale = Scale { portals, units };
                    push_certificate(&mut text, &scale, certificate);
                }
            }
            text.push('\n');
        }
        text
    }
}

fn push(text: &mut String, args: std::fmt::Arguments) {
    text.write_fmt(args).expect("a string takes any text");
}

fn push_cut(text: &mut String, cut: &Cut) {
    match cut.reason {
        CutReason::Behind { position } => push(text, format_args!(" b {position}")),
        CutReason::Separated { positions: [i, j], through: [u, v, w] } => {
            push(text, format_args!(" p {i} {j} {u} {v} {w}"));
        }
    }
    cut.portals.iter().for_each(|portal| push(text, format_args!(" {portal}")));
}

/// A certificate as a refutation of the format. `portals` are the sequence's, by their vertices in
/// world units, of which `units` grid units are one.
pub fn refutation_text(
    certificate: &Certificate,
    portals: Vec<Vec<&RationalPoint3>>,
    units: &Int,
) -> String {
    let mut text = String::new();
    push_certificate(&mut text, &Scale { portals, units }, certificate);
    text.trim_start().to_owned()
}

fn push_certificate(text: &mut String, scale: &Scale, certificate: &Certificate) {
    match certificate {
        Certificate::Gordan(terms) => {
            let terms = terms.iter().map(|t| (Factor::Condition(t.condition), &t.weight));
            push_linear(text, scale, terms.collect());
        }
        Certificate::Quadric(proof) => push_quadric(text, scale, proof),
    }
}

fn push_linear(text: &mut String, scale: &Scale, terms: Vec<(Factor, &Int)>) {
    push(text, format_args!(" l {}", terms.len()));
    let weights = whole(terms.iter().map(|(factor, weight)| scale.of(factor) * *weight).collect());
    for ((factor, _), weight) in terms.iter().zip(weights) {
        push(text, format_args!(" {} {weight}", factor_text(factor)));
    }
}

fn push_quadric(text: &mut String, scale: &Scale, proof: &QuadricProof) {
    match proof {
        QuadricProof::Identity { multiple, products } => {
            let mut numbers: Vec<Rational> = products
                .iter()
                .map(|Product { factors: [f, g], weight }| scale.of(f) * scale.of(g) * weight)
                .collect();
            numbers.push(scale.of_quadric() * multiple);
            let mut numbers = whole(numbers);
            let multiple = numbers.pop().expect("the multiple was pushed");
            push(text, format_args!(" i {multiple} {}", products.len()));
            for (Product { factors: [f, g], .. }, weight) in products.iter().zip(numbers) {
                push(text, format_args!(" {} {} {weight}", factor_text(f), factor_text(g)));
            }
        }
        QuadricProof::Linear { terms } => {
            push_linear(
                text,
                scale,
                terms.iter().map(|(factor, weight)| (*factor, weight)).collect(),
            );
        }
        QuadricProof::Split { plane, positive, negative } => {
            text.push_str(" s");
            scale.split(plane).iter().for_each(|c| push(text, format_args!(" {c}")));
            push_quadric(text, scale, positive);
            push_quadric(text, scale, negative);
        }
    }
}

fn factor_text(factor: &Factor) -> String {
    match factor {
        Factor::Condition(Condition::Edge(name)) => format!("{}.{}", name.portal, name.edge),
        Factor::Condition(Condition::Order { portal }) => format!("o{portal}"),
        Factor::Split(split) => format!("h{split}"),
    }
}

/// Integers without a common factor in the proportions of some fractions.
fn whole(fractions: Vec<Rational>) -> Vec<Int> {
    let common = fractions.iter().fold(Int::from(1), |c, f| c.lcm(f.denom()));
    let scaled: Vec<Int> = fractions.iter().map(|f| f.numer() * (&common / f.denom())).collect();
    let content = scaled.iter().fold(Int::ZERO, |g, n| g.gcd(n));
    scaled.into_iter().map(|n| n / &content).collect()
}

/// From the vectors that a certificate speaks of to those of the text: a certificate's are in grid
/// units with primitive normals, the text's follow from the vertices' homogeneous coordinates.
///
/// With D grid units in a world unit, the vector (d, m) of world units is (D d, D² m) on the grid,
/// and the sides and the quadric of two such are D³ those in world units.
struct Scale<'a> {
    /// The vertices of each portal of the sequence.
    portals: Vec<Vec<&'a RationalPoint3>>,
    /// Grid units in one world unit.
    units: &'a Int,
}

impl Scale<'_> {
    /// The certificate's vector of a factor, taken to world units, as a multiple of the text's.
    fn of(&self, factor: &Factor) -> Rational {
        let one = Int::from(1);
        match factor {
            Factor::Condition(Condition::Edge(name)) => {
                let corners = &self.portals[name.portal];
                let next = (name.edge + 1) % corners.len();
                Rational::new(one, corners[name.edge].denominator() * corners[next].denominator())
            }
            Factor::Condition(Condition::Order { portal }) => {
                let [first, second] = [portal - 1, *portal].map(|i| self.normal_scale(i));
                Rational::new(one, self.units.clone()) / (first * second)
            }
            Factor::Split(_) => Rational::new(one, self.units * self.units),
        }
    }

    /// What a multiple of the quadric becomes, where a product's weight stays what it is: D³ for
    /// each of its two sides, D³ for the quadric.
    fn of_quadric(&self) -> Rational {
        Rational::new(Int::from(1), self.units * self.units * self.units)
    }

    /// The text's vector of a split: D² times that in world units.
    fn split(&self, [a, b, c, d, e, f]: &[Int; 6]) -> [Int; 6] {
        let direction = [a, b, c].map(|x| x * self.units);
        let [a, b, c] = direction;
        [a, b, c, d.clone(), e.clone(), f.clone()]
    }

    /// The normal of the text's plane of a portal as a multiple of the primitive one.
    fn normal_scale(&self, position: usize) -> Rational {
        let corners = &self.portals[position];
        let [a, b, c] = [corners[0], corners[1], corners[2]].map(RationalPoint3::numerators);
        let [d, e, f] = [0, 1, 2].map(|i| corners[i].denominator());
        let (bc, ca, ab) = (cross(b, c), cross(c, a), cross(a, b));
        let normal: [Int; 3] = std::array::from_fn(|i| d * &bc[i] + e * &ca[i] + f * &ab[i]);
        Rational::from(normal.iter().fold(Int::ZERO, |g, n| g.gcd(n)))
    }
}

/// The vertices of a directed portal, counter-clockwise as seen from the cell that it enters.
fn corners(graph: &PortalGraph, portal: DirectedPortal) -> Vec<&RationalPoint3> {
    let mut corners: Vec<_> = graph.corners(&graph.portals[portal as usize / 2]).collect();
    if portal % 2 == 1 {
        corners.reverse();
    }
    corners
}
