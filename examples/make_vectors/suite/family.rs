//! Families of sequences whose answers follow from their construction.

use super::number::{Polygon, Q, each, moved, power, q, ratio, reversed, scaled};
use stabline::vectors::Class;

/// A sequence, with its answer.
#[derive(Clone)]
pub struct Seq {
    /// What it is about, and why the answer is what it is.
    pub comment: String,
    /// What is degenerate.
    pub flags: Vec<&'static str>,
    /// The portals.
    pub portals: Vec<Polygon>,
    /// The answer.
    pub class: Class,
}

/// Sequences of one construction.
pub struct Family {
    /// What they have in common.
    pub about: &'static str,
    /// The sequences.
    pub cases: Vec<Seq>,
    /// Whether the portals stand one behind the other, so that they can join a row of convex cells.
    pub is_row: bool,
}

/// A critical construction in three: open, grazing, blocked; the number is what is left.
pub const TRIPLE: [(i64, Class, &str); 3] = [
    (1, Class::Open, "One unit is left, and lines pass."),
    (0, Class::Grazing, "Nothing is left, exactly: a line only touches."),
    (-1, Class::Blocked, "One unit is lacking: no line even touches."),
];

impl Seq {
    /// A sequence.
    pub fn new(
        comment: impl Into<String>,
        flags: &[&'static str],
        portals: Vec<Polygon>,
        class: Class,
    ) -> Seq {
        Seq { comment: comment.into(), flags: flags.to_vec(), portals, class }
    }

    /// A member of a [`TRIPLE`].
    pub fn critical(
        comment: impl Into<String>,
        flags: &[&'static str],
        portals: Vec<Polygon>,
        (_, class, how): (i64, Class, &str),
    ) -> Seq {
        let mut flags = flags.to_vec();
        flags.push(match class {
            Class::Grazing => "Flush",
            Class::Open | Class::Blocked => "OneUnit",
        });
        Seq { comment: format!("{} {how}", comment.into()), flags, portals, class }
    }

    fn varied(&self, how: &str, flag: Option<&'static str>, portals: Vec<Polygon>) -> Seq {
        let mut flags = self.flags.clone();
        flags.extend(flag.filter(|flag| !self.flags.contains(flag)));
        Seq { comment: format!("{how}: {}", self.comment), flags, portals, class: self.class }
    }

    /// The same far from the origin, by 2^`bits` units on the first axis and other shares on the
    /// others.
    pub fn far(&self, bits: u32) -> Seq {
        let by = [power(bits), -power(bits - 1), power(bits - 2)];
        let portals = moved(&self.portals, &by);
        self.varied(&format!("2^{bits} units away"), Some("FarFromOrigin"), portals)
    }

    /// The same in metres, if it was in inches.
    pub fn metres(&self) -> Seq {
        let portals = scaled(&self.portals, &ratio(127, 5000));
        self.varied("Scaled by 0.0254", Some("UnitScale"), portals)
    }

    /// The same from the other end.
    pub fn back(&self) -> Seq {
        self.varied("Crossed the other way", Some("Backwards"), reversed(&self.portals))
    }

    /// The same in a mirror: the first axis turned over, and with it every portal.
    pub fn mirrored(&self) -> Seq {
        let turned = each(&self.portals, |p| {
            let mut p = p.clone();
            p[0] = -p[0].clone();
            p
        });
        let turned = turned.into_iter().map(|polygon| polygon.into_iter().rev().collect());
        self.varied("In a mirror", Some("Mirrored"), turned.collect())
    }

    /// The same under an affine map that leaves no edge along an axis.
    pub fn sheared(&self) -> Seq {
        let mix = |p: &Vec<Q>| match p.as_slice() {
            [x, y] => vec![x * q(2) + y, x + y * q(3)],
            [x, y, z] => vec![x * q(2) + y + z, x + y * q(3) - z, z * q(2) - x + y],
            _ => p.clone(),
        };
        self.varied("Sheared, so that nothing is along an axis", None, each(&self.portals, mix))
    }

    /// A segment of the plane becomes an upright rectangle from z = 0 to z = `height`.
    pub fn upright(&self, height: i64) -> Seq {
        let portals = self.portals.iter().map(|gate| {
            let at = |end: usize, z: i64| vec![gate[end][0].clone(), gate[end][1].clone(), q(z)];
            vec![at(1, 0), at(0, 0), at(0, height), at(1, height)]
        });
        Seq { portals: portals.collect(), ..self.clone() }
    }
}

impl Family {
    /// A family of portals that stand one behind the other.
    pub fn row(about: &'static str, cases: Vec<Seq>) -> Family {
        Family { about, cases, is_row: true }
    }

    /// A family of any portals.
    pub fn loose(about: &'static str, cases: Vec<Seq>) -> Family {
        Family { about, cases, is_row: false }
    }
}
