//! Proofs that were tampered with: one change of a line, a field or a digit.

use num_bigint::BigInt;
use sha2::{Digest, Sha256};
use stabline::oracle::Random;
use std::ops::Range;

/// The lines of a proof without its seal, and where its parts are.
#[derive(Clone)]
pub struct Parts {
    pub lines: Vec<String>,
    pub vertices: Range<usize>,
    pub portals: Range<usize>,
    pub claims: Range<usize>,
    /// Lines of pairs that are open or grazing.
    pub shown: Range<usize>,
    pub trees: Range<usize>,
}

impl Parts {
    pub fn of(text: &str) -> Parts {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        assert!(lines.pop().is_some_and(|seal| seal.starts_with("sha256 ")));
        let after = |word: &str| lines.iter().skip(3).position(|line| line.starts_with(word));
        let start = |word: &str| 4 + after(word).expect("a proof has this part");
        let [vertices, portals, claims] = ["vertices ", "portals ", "claims"].map(start);
        let cells = vertices - 5;
        let trees = start("source ") - 1;
        Parts {
            vertices: vertices..portals - 1,
            portals: portals..claims - 1,
            claims: claims..claims + cells,
            shown: claims + cells..trees,
            trees: trees..lines.len(),
            lines,
        }
    }

    pub fn cells(&self) -> usize {
        self.claims.len()
    }

    pub fn claim(&self, [a, b]: [usize; 2]) -> u8 {
        self.lines[self.claims.start + a].as_bytes()[b]
    }

    /// The same with another claim of two cells; `lines` are those of this proof, maybe changed.
    fn claimed(&self, [a, b]: [usize; 2], claim: &str) -> Vec<String> {
        let mut lines = self.lines.clone();
        lines[self.claims.start + a].replace_range(b..=b, claim);
        lines[self.claims.start + b].replace_range(a..=a, claim);
        lines
    }

    /// The lines of a node and of all below it.
    pub fn branch(&self, node: usize) -> Range<usize> {
        let depth = |line: &String| line.split(' ').next()?.parse::<usize>().ok();
        let own = depth(&self.lines[node]).expect("a node");
        let below = self.lines[node + 1..].iter().take_while(|line| depth(line) > Some(own));
        node..node + 1 + below.count()
    }

    /// The line along the first edge of the first portal of a node's sequence.
    pub fn first_edge(&self, node: usize) -> [BigInt; 6] {
        let field = |line: usize, at: usize| self.lines[line].split(' ').nth(at).expect("a field");
        let is_first = |&line: &usize| field(line, 0) == "1";
        let first = (self.trees.start..=node).rev().find(is_first).expect("a node of depth 1");
        let directed: usize = field(first, 1).parse().expect("a portal");
        let portal = self.portals.start + directed / 2;
        let mut corners: Vec<&str> = self.lines[portal].split(' ').skip(3).collect();
        if directed % 2 == 1 {
            corners.reverse();
        }
        let [p, q] = [0, 1].map(|at| -> Vec<BigInt> {
            let vertex = self.vertices.start + corners[at].parse::<usize>().expect("a vertex");
            self.lines[vertex].split(' ').map(|c| c.parse().expect("a number")).collect()
        });
        let direction = |i: usize| &p[3] * &q[i] - &q[3] * &p[i];
        let moment = |i: usize, j: usize| &p[i] * &q[j] - &p[j] * &q[i];
        [direction(0), direction(1), direction(2), moment(1, 2), moment(2, 0), moment(0, 1)]
    }

    pub fn nodes(&self) -> impl Iterator<Item = usize> {
        self.trees.clone().filter(|&line| !self.lines[line].starts_with("source"))
    }
}

/// Lines with the seal that belongs to them.
pub fn sealed(lines: &[String]) -> String {
    let mut text: String = lines.iter().flat_map(|line| [line, "\n"]).collect();
    let digest = Sha256::digest(text.as_bytes());
    let digits: String = digest.iter().map(|byte| format!("{byte:02x}")).collect();
    text.push_str(&format!("sha256 {digits}\n"));
    text
}

/// Lines with a seal that is not theirs.
pub fn with_seal_of(lines: &[String], original: &str) -> String {
    let seal = original.lines().last().expect("a seal");
    lines.iter().map(String::as_str).chain([seal]).flat_map(|line| [line, "\n"]).collect()
}

/// What is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// Any digit of a number becomes another one.
    Digit,
    /// Any number becomes one more or less.
    Number,
    Removed,
    Doubled,
    Swapped,
    Truncated,
    /// A claim is turned on one side only.
    LopsidedClaim,
    /// A pair that is open is claimed not to be, and its line removed.
    OpenDenied,
    /// A pair that is not open is claimed to be.
    OpenClaimed,
    /// The portals of an open line: one removed, doubled, or exchanged for another.
    Chain,
    /// A vertex of a portal with four or more of them leaves its plane.
    OffPlane,
    /// Two neighbours among the vertices of such a portal change places.
    Dented,
    Depth,
    /// A node, and all below it, is removed.
    Branch,
    /// A node is one of another portal.
    NodePortal,
    /// A portal is removed from a cut.
    Cut,
    /// A weight or multiple of a refutation.
    Weight,
    /// A factor of a refutation becomes another edge, portal, or order vector.
    Factor,
}

impl Kind {
    pub const ALL: [Kind; 18] = [
        Kind::Digit,
        Kind::Number,
        Kind::Removed,
        Kind::Doubled,
        Kind::Swapped,
        Kind::Truncated,
        Kind::LopsidedClaim,
        Kind::OpenDenied,
        Kind::OpenClaimed,
        Kind::Chain,
        Kind::OffPlane,
        Kind::Dented,
        Kind::Depth,
        Kind::Branch,
        Kind::NodePortal,
        Kind::Cut,
        Kind::Weight,
        Kind::Factor,
    ];

    /// Whether a proof in which nothing is superfluous cannot hold after such a change.
    pub fn breaks(self) -> bool {
        !matches!(self, Kind::Digit | Kind::Number | Kind::Swapped | Kind::Chain | Kind::Factor)
    }
}

/// The lines of a proof after one change of this kind; none if there is nothing to change.
pub fn mutated(parts: &Parts, kind: Kind, random: &mut Random) -> Option<Vec<String>> {
    let mut lines = parts.lines.clone();
    let body = parts.vertices.start..parts.lines.len();
    match kind {
        Kind::Digit => change_digit(&mut lines[pick(body, random)?], random)?,
        Kind::Number => {
            let line = pick(body, random)?;
            let is_number = |field: &&str| field.parse::<BigInt>().is_ok();
            let fields = lines[line].split(' ').enumerate().filter(|(_, field)| is_number(field));
            let numbers: Vec<usize> = fields.map(|(at, _)| at).collect();
            let at = numbers[pick(0..numbers.len(), random)?];
            change_field(&mut lines[line], at, |field| step(field, random));
        }
        Kind::Removed => drop(lines.remove(pick(body, random)?)),
        Kind::Doubled => {
            let line = pick(body, random)?;
            lines.insert(line, lines[line].clone());
        }
        Kind::Swapped => {
            let [a, b] = [pick(body.clone(), random)?, pick(body, random)?];
            (lines[a] != lines[b]).then(|| lines.swap(a, b))?;
        }
        Kind::Truncated => lines.truncate(pick(1..parts.lines.len(), random)?),
        Kind::LopsidedClaim => {
            let row = pick(parts.claims.clone(), random)?;
            change_digit(&mut lines[row], random)?;
        }
        Kind::OpenDenied => lines = deny(parts, random)?,
        Kind::OpenClaimed => {
            let pair = [pick(0..parts.cells(), random)?, pick(0..parts.cells(), random)?];
            (parts.claim(pair) != b'2').then_some(())?;
            lines = parts.claimed(pair, "2");
        }
        Kind::Chain => {
            let line = pick(parts.shown.clone(), random)?;
            lines[line].starts_with("open").then_some(())?;
            let at = pick(11..lines[line].split(' ').count(), random)?;
            match random.between(0, 3) {
                0 => lines[line] = without_field(&lines[line], at),
                1 => change_field(&mut lines[line], at, |field| format!("{field} {field}")),
                _ => change_field(&mut lines[line], at, |_| any_portal(parts, random)),
            }
        }
        Kind::OffPlane | Kind::Dented => deform(parts, kind, &mut lines, random)?,
        Kind::Depth => {
            let node = any_node(parts, random)?;
            change_field(&mut lines[node], 0, |field| step(field, random));
        }
        Kind::Branch => drop(lines.drain(parts.branch(any_node(parts, random)?))),
        Kind::NodePortal => {
            let node = any_node(parts, random)?;
            change_field(&mut lines[node], 1, |_| any_portal(parts, random));
        }
        Kind::Cut => {
            let node = any_node(parts, random)?;
            let all = cuts_of(&lines[node]);
            let at = all.get(pick(0..all.len(), random)?)?;
            lines[node] = without_field(&lines[node], *at);
        }
        Kind::Weight | Kind::Factor => {
            let (line, at) = refutation_field(parts, kind == Kind::Weight, random)?;
            change_field(&mut lines[line], at, |field| step_factor(field, random));
        }
    }
    (lines != parts.lines).then_some(lines)
}

fn pick(range: Range<usize>, random: &mut Random) -> Option<usize> {
    (!range.is_empty()).then(|| range.start + random.bits() as usize % range.len())
}

fn any_node(parts: &Parts, random: &mut Random) -> Option<usize> {
    let nodes: Vec<usize> = parts.nodes().collect();
    Some(nodes[pick(0..nodes.len(), random)?])
}

/// One more or less.
fn step(number: &str, random: &mut Random) -> String {
    let number: BigInt = number.parse().expect("a number");
    let change: BigInt = if random.one_in(2) { 1 } else { -1 }.into();
    (number + change).to_string()
}

/// A weight, or a number of a factor, one more or less.
fn step_factor(field: &str, random: &mut Random) -> String {
    match field.split_once('.') {
        Some((portal, edge)) if random.one_in(2) => format!("{}.{edge}", step(portal, random)),
        Some((portal, edge)) => format!("{portal}.{}", step(edge, random)),
        None if field.starts_with(['o', 'h']) => {
            format!("{}{}", &field[..1], step(&field[1..], random))
        }
        None => step(field, random),
    }
}

fn change_digit(line: &mut String, random: &mut Random) -> Option<()> {
    let digits: Vec<usize> =
        line.bytes().enumerate().filter(|(_, b)| b.is_ascii_digit()).map(|(at, _)| at).collect();
    let at = digits[pick(0..digits.len(), random)?];
    let old = line.as_bytes()[at] - b'0';
    let new = (old + random.between(1, 9) as u8) % 10;
    line.replace_range(at..=at, &new.to_string());
    Some(())
}

fn change_field(line: &mut String, at: usize, change: impl FnOnce(&str) -> String) {
    let mut fields: Vec<String> = line.split(' ').map(str::to_owned).collect();
    fields[at] = change(&fields[at]);
    *line = fields.join(" ");
}

fn any_portal(parts: &Parts, random: &mut Random) -> String {
    (random.bits() as usize % (2 * parts.portals.len())).to_string()
}

/// A pair that is open is claimed not to be, and its line is removed: the proof of a false claim.
fn deny(parts: &Parts, random: &mut Random) -> Option<Vec<String>> {
    let line = pick(parts.shown.clone(), random)?;
    let fields: Vec<&str> = parts.lines[line].split(' ').collect();
    (fields[0] == "open").then_some(())?;
    let pair = [fields[1], fields[2]].map(|cell| cell.parse().expect("a cell"));
    let mut lines = parts.claimed(pair, "0");
    lines.remove(line);
    Some(lines)
}

/// Moves a vertex off the plane of a portal with four vertices, or exchanges two of its vertices.
fn deform(parts: &Parts, kind: Kind, lines: &mut [String], random: &mut Random) -> Option<()> {
    let portal = pick(parts.portals.clone(), random)?;
    let mut fields: Vec<String> = lines[portal].split(' ').map(str::to_owned).collect();
    (fields.len() > 6).then_some(())?;
    if kind == Kind::Dented {
        fields.swap(4, 5);
        lines[portal] = fields.join(" ");
        return Some(());
    }
    let corner = |at: usize| -> Vec<i128> {
        let vertex: usize = fields[at].parse().expect("a vertex");
        let line = &parts.lines[parts.vertices.start + vertex];
        line.split(' ').filter_map(|number| number.parse().ok()).collect()
    };
    // The axis on which the other three have an area, seen along it: a step there leaves the plane.
    let [a, b, c] = [3, 4, 5].map(corner);
    (a.len() == 4 && b.len() == 4 && c.len() == 4).then_some(())?;
    let arm = |p: &[i128], i: usize| p[i].checked_mul(a[3])?.checked_sub(a[i].checked_mul(p[3])?);
    let axis = (0..3).find(|&k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        let area = || {
            let left = arm(&b, i)?.checked_mul(arm(&c, j)?)?;
            left.checked_sub(arm(&b, j)?.checked_mul(arm(&c, i)?)?)
        };
        area().is_some_and(|area| area != 0)
    })?;
    let moved: usize = fields[6].parse().expect("a vertex");
    let line = &mut lines[parts.vertices.start + moved];
    change_field(line, axis, |number| step(number, random));
    Some(())
}

/// The fields of a node's line that are portals of a cut.
pub fn cuts_of(line: &str) -> Vec<usize> {
    let fields: Vec<&str> = line.split(' ').collect();
    let (mut cuts, mut at) = (Vec::new(), 2);
    if fields.get(2).is_some_and(|field| ["l", "i", "s"].contains(field)) {
        return cuts;
    }
    while at < fields.len() {
        match fields[at] {
            "b" => at += 2,
            "p" => at += 6,
            _ => {
                cuts.push(at);
                at += 1;
            }
        }
    }
    cuts
}

/// A line without one of its fields.
pub fn without_field(line: &str, at: usize) -> String {
    let mut fields: Vec<&str> = line.split(' ').collect();
    fields.remove(at);
    fields.join(" ")
}

/// The line and the place in it of a weight or multiple, or of a factor, of some refutation.
fn refutation_field(parts: &Parts, weight: bool, random: &mut Random) -> Option<(usize, usize)> {
    let is_refuted =
        |&line: &usize| matches!(parts.lines[line].split(' ').nth(2), Some("l" | "i" | "s"));
    let lines: Vec<usize> = parts.nodes().filter(is_refuted).collect();
    let line = lines[pick(0..lines.len(), random)?];
    let fields: Vec<&str> = parts.lines[line].split(' ').collect();
    let is_factor = |at: usize| fields[at].contains('.') || fields[at].starts_with(['o', 'h']);
    let fits = |&at: &usize| match weight {
        true => fields[at - 1] == "i" || (at > 3 && is_factor(at - 1) && !is_factor(at)),
        false => is_factor(at),
    };
    let all: Vec<usize> = (3..fields.len()).filter(fits).collect();
    Some((line, all[pick(0..all.len(), random)?]))
}
