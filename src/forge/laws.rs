//! Laws: what must not change an answer, and what may change it in one direction only.
//!
//! A [`Law`] makes other inputs of an input, and says how the answers to them must stand to the
//! answer to it ([`Relation`]); `docs/forge.md` has the table with the reasons. A law needs no
//! answer that is known to be right, so it holds another program as well as ours.

mod affine;
mod graphs;
mod parts;

use super::input::Input;
use crate::num::Random;
use crate::vectors::{Answer, Class, Kind};

/// How answers must stand to each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Each other answer is the same.
    Same,
    /// Each other answer is open if and only if this one is.
    SameOpen,
    /// The greatest other answer is the same; blocked is less than grazing, and that than open.
    Greatest,
    /// No other answer is greater.
    AtMost,
    /// No other answer is less.
    AtLeast,
    /// If another answer is open, so is this one.
    OpensNothing,
    /// If this answer is open, so is each other.
    KeepsOpen,
}

/// A way of changing an input.
#[derive(Clone, Copy, Debug)]
pub struct Law {
    /// Its name.
    pub name: &'static str,
    /// The kinds of input that it applies to.
    pub kinds: &'static [Kind],
    /// How the answers must stand to each other.
    pub relation: Relation,
    /// The other inputs; none where there is nothing to change.
    derive: fn(&Input, &mut Random) -> Vec<Input>,
}

const BUT_SCENES: &[Kind] = &[Kind::Sequence, Kind::Transversals, Kind::Graph];

const fn law(
    name: &'static str,
    kinds: &'static [Kind],
    relation: Relation,
    derive: fn(&Input, &mut Random) -> Vec<Input>,
) -> Law {
    Law { name, kinds, relation, derive }
}

/// Every law.
pub const LAWS: &[Law] = &[
    law("translate", BUT_SCENES, Relation::Same, affine::translated),
    law("scale", BUT_SCENES, Relation::Same, affine::scaled),
    law("mirror", BUT_SCENES, Relation::Same, affine::mirrored),
    law("turn", BUT_SCENES, Relation::Same, affine::turned),
    law("shear", BUT_SCENES, Relation::Same, affine::sheared),
    // A division is another one, so what touches may be told from what does not in another way.
    law("translate", &[Kind::Scene], Relation::SameOpen, affine::translated),
    law("scale", &[Kind::Scene], Relation::SameOpen, affine::scaled),
    law("mirror", &[Kind::Scene], Relation::SameOpen, affine::mirrored),
    law("turn", &[Kind::Scene], Relation::SameOpen, affine::turned),
    law("permute", BUT_SCENES, Relation::Same, parts::permuted),
    law("permute", &[Kind::Scene], Relation::SameOpen, parts::permuted),
    law("rotate-vertices", &[Kind::Sequence, Kind::Graph], Relation::Same, parts::rotated),
    law("reverse", BUT_SCENES, Relation::Same, parts::reversed),
    law("reverse", &[Kind::Scene], Relation::SameOpen, parts::reversed),
    law("double", &[Kind::Sequence, Kind::Graph], Relation::Same, parts::doubled),
    law("double", &[Kind::Scene], Relation::SameOpen, parts::doubled),
    law("slide-points", &[Kind::Transversals], Relation::Same, parts::slid),
    law("split-portal", &[Kind::Sequence], Relation::Greatest, parts::split),
    law("split-portal", &[Kind::Graph], Relation::Same, parts::split),
    law("split-occluder", &[Kind::Scene], Relation::SameOpen, parts::split),
    // A touching line need not meet portals in their order, so it may run through the halves the
    // wrong way.
    law("split-cell", &[Kind::Graph], Relation::SameOpen, graphs::split_cell),
    law("renumber", &[Kind::Graph], Relation::Same, graphs::renumbered),
    law("write-turned", &[Kind::Graph], Relation::Same, graphs::written_turned),
    law("remove-portal", &[Kind::Sequence], Relation::AtLeast, parts::removed),
    law("close-portal", &[Kind::Graph], Relation::AtMost, parts::removed),
    law("remove-occluder", &[Kind::Scene], Relation::KeepsOpen, parts::removed),
    law("add-occluder", &[Kind::Scene], Relation::OpensNothing, parts::occluder_added),
    law("shrink-portal", &[Kind::Sequence, Kind::Graph], Relation::AtMost, parts::shrunk),
];

impl Law {
    /// Whether it says something of inputs of this kind.
    pub fn applies_to(&self, kind: Kind) -> bool {
        self.kinds.contains(&kind)
    }

    /// The other inputs; none where there is nothing to change.
    pub fn derive(&self, input: &Input, random: &mut Random) -> Vec<Input> {
        (self.derive)(input, random)
    }
}

impl Relation {
    /// Whether the other answers stand to this one as they must.
    pub fn holds(self, answer: &Answer, others: &[Answer]) -> bool {
        let is_open = |answer: &Answer| *answer == Answer::Class(Class::Open);
        match self {
            Relation::Same => others.iter().all(|other| other == answer),
            Relation::SameOpen => others.iter().all(|other| is_open(other) == is_open(answer)),
            Relation::Greatest => rank(answer) == others.iter().map(rank).max().unwrap_or_default(),
            Relation::AtMost => others.iter().all(|other| rank(other) <= rank(answer)),
            Relation::AtLeast => others.iter().all(|other| rank(other) >= rank(answer)),
            Relation::OpensNothing => is_open(answer) || !others.iter().any(is_open),
            Relation::KeepsOpen => !is_open(answer) || others.iter().all(is_open),
        }
    }

    /// In words, after "the other answers must be".
    pub fn words(self) -> &'static str {
        match self {
            Relation::Same => "the same",
            Relation::SameOpen => "open if and only if this one is",
            Relation::Greatest => "at the greatest the same",
            Relation::AtMost => "no greater",
            Relation::AtLeast => "no less",
            Relation::OpensNothing => "open only if this one is",
            Relation::KeepsOpen => "open if this one is",
        }
    }
}

fn rank(answer: &Answer) -> u8 {
    match answer {
        Answer::Class(Class::Open) => 3,
        Answer::Class(Class::Grazing) => 2,
        Answer::Class(Class::Blocked) => 1,
        Answer::Lines(_) | Answer::Cells(_) | Answer::Skip(_) => 0,
    }
}
