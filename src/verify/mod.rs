//! The independent checker of proofs.
//!
//! It shares nothing with the engine that made them: no predicate, no type, no float; only
//! unbounded integers and the format's page, `docs/formats/proof.md`, which says what every line
//! means and why the whole is a proof. Linear in the text, but for a flood for each node of a tree.

mod exact;
mod text;
mod tree;

use exact::{Graph, Vector, join, order, range, side, sign_of_surd};
use num_bigint::{BigInt, Sign::Minus, Sign::NoSign, Sign::Plus};
use std::collections::BTreeSet;
use std::io::BufRead;
use text::{Checked, Fields, Reader, ensure};
use tree::Trees;

/// What does not hold in a proof: the line, counted from 1, and what is wrong there.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("line {0}: {1}")]
pub struct Flaw(pub u64, pub String);

/// What a proof that holds has proved.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Verified {
    /// Unordered pairs of different cells by their claims: not open, grazing, open, none.
    pub pairs: [usize; 4],
    /// Nodes of all trees; those refuted by a linear combination, and by a quadratic one or splits.
    pub nodes: [usize; 3],
}

/// What is claimed of each two cells: 0 not open, 1 grazing, 2 open, 3 nothing.
type Claims = Vec<Vec<u8>>;

/// Checks a whole proof.
///
/// # Errors
/// The first thing that does not hold, or cannot be read.
pub fn verify(input: impl BufRead) -> Result<Verified, Flaw> {
    let mut reader = Reader { input, line: String::new(), number: 0, hash: Default::default() };
    check(&mut reader).map_err(|what| Flaw(reader.number, what))
}

fn check(reader: &mut Reader<impl BufRead>) -> Checked<Verified> {
    ensure(reader.next()?.rest == "stabline-proof/1", "no proof: expected stabline-proof/1")?;
    reader.next()?.word("program")?;
    reader.next()?.word("input")?;
    let graph = Graph::read(reader)?;
    let cells = graph.leaving.len();
    ensure(reader.next()?.rest == "claims", "expected \"claims\"")?;
    let mut claims = Claims::new();
    for cell in 0..cells {
        let digits = reader.next()?.rest.bytes();
        let row: Vec<u8> = digits.map(|digit| digit.wrapping_sub(b'0')).collect();
        let are_claims = row.len() == cells && row.iter().all(|&claim| claim <= 3);
        let is_symmetric = (0..cell).all(|other| row.get(other) == claims[other].get(cell));
        let holds = are_claims && is_symmetric && row[cell] == 2;
        ensure(holds, "expected a digit from 0 to 3 a cell, symmetric, 2 for the cell itself")?;
        claims.push(row);
    }
    let mut verified = Verified::default();
    let mut trees = Trees::new(&graph, &claims);
    let mut shown = BTreeSet::new();
    loop {
        let mut fields = reader.next()?;
        match fields.peek() {
            kind @ ("open" | "grazing") => {
                fields.take()?;
                let [a, b] = [fields.index(cells)?, fields.index(cells)?];
                let is_claimed = a != b && claims[a][b] == 1 + u8::from(kind == "open");
                let is_new = shown.insert([a.min(b), a.max(b)]) && !trees.sources.contains(&true);
                ensure(is_claimed && is_new, "not claimed so, shown before, or after a tree")?;
                let check = if kind == "open" { check_open } else { check_grazing };
                check(&mut fields, &graph, [a, b])?;
            }
            "source" => trees.begin(&mut fields)?,
            "sha256" => break,
            _ => trees.node(&mut fields, &mut verified)?,
        }
    }
    trees.close(0)?;
    ensure(!trees.sources.contains(&false), "a cell has no tree")?;
    reader.seal()?;
    for (a, b) in (0..cells).flat_map(|b| (0..b).map(move |a| (a, b))) {
        verified.pairs[usize::from(claims[a][b])] += 1;
    }
    let has_lines = shown.len() == verified.pairs[1] + verified.pairs[2];
    ensure(has_lines, "a pair claimed open or grazing has no line").map(|()| verified)
}

fn check_open(fields: &mut Fields, graph: &Graph, pair: [usize; 2]) -> Checked<()> {
    let line = join(&fields.point()?, &fields.point()?);
    let sequence = graph.sequence(fields, pair)?;
    let is_inside = |vector: &Vector| side(&line, vector).sign() == Plus;
    let passes = sequence.iter().all(|portal| portal.edges.iter().all(is_inside));
    ensure(passes, "the line does not pass a portal")?;
    let in_order = sequence.windows(2).all(|two| is_inside(&order(&two[0].plane, &two[1].plane)));
    ensure(in_order, "the line does not cross the portals in order")
}

fn check_grazing(fields: &mut Fields, graph: &Graph, pair: [usize; 2]) -> Checked<()> {
    let radicand = fields.integer()?;
    let [x, y]: [Vector; 2] = [fields.integers()?, fields.integers()?];
    let is_line =
        (side(&x, &x) + &radicand * side(&y, &y)).sign() == NoSign && side(&x, &y).sign() == NoSign;
    ensure(is_line && radicand.sign() != Minus, "the vector is no line")?;
    let is_finite = (0..3).any(|i| sign_of_surd(&x[i], &y[i], &radicand) != NoSign);
    ensure(is_finite, "the line is at infinity")?;
    let infinity = [0, 0, 0, 1].map(BigInt::from);
    let sign = |z: &Vector| sign_of_surd(&side(&x, z), &side(&y, z), &radicand);
    for portal in graph.sequence(fields, pair)? {
        let [low, high] = range(portal.edges.iter().map(sign));
        // For a line in the plane: whether the corners are all on one side.
        let [right, left] = range(portal.normals.iter().map(sign));
        let touches = match sign(&order(&infinity, &portal.plane)) {
            Plus => low != Minus,
            NoSign => [low, high] == [NoSign; 2] && (right != left || right == NoSign),
            Minus => false,
        };
        ensure(touches, "the line does not touch a portal")?;
    }
    Ok(())
}
