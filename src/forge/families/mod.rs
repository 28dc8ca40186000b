//! The table of families.

mod faces;
mod graphs;
mod lines;
mod perturbed;
mod places;
mod plane;
mod rooms;
mod scenes;
mod thin;

pub use perturbed::graph_of;

use super::input::{Graph, Input};
use crate::num::Random;
use crate::vectors::Kind;

/// A way of being degenerate.
#[derive(Clone, Copy, Debug)]
pub struct Family {
    /// Its name.
    pub name: &'static str,
    /// The kind of its cases.
    pub kind: Kind,
    /// What it is for.
    pub purpose: &'static str,
    /// Whether its cases are made from a map, which [`Family::settings`] takes.
    pub from_map: bool,
    /// What may be set.
    pub parameters: &'static [Parameter],
    make: fn(&mut Random, &Settings) -> Input,
}

/// A number that a family takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Parameter {
    /// Its name.
    pub name: &'static str,
    /// What it does.
    pub purpose: &'static str,
    /// What it is if nothing is said.
    pub default: i64,
    /// The least and the greatest value.
    pub range: [i64; 2],
}

/// What a family's cases are made from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Settings {
    values: Vec<(&'static str, i64)>,
    /// The map, with one portal at least, of a family that takes one.
    map: Option<Graph>,
}

/// Why parameters cannot be set so.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SettingsError {
    /// No such parameter.
    #[error("the family `{family}` has no parameter `{name}`; it has {known}")]
    Unknown {
        /// The family.
        family: &'static str,
        /// The name given.
        name: String,
        /// The names that there are.
        known: String,
    },
    /// A value out of its range.
    #[error("`{name}`: expected {} to {}, got {got}", range[0], range[1])]
    Range {
        /// The parameter.
        name: &'static str,
        /// Its range.
        range: [i64; 2],
        /// What was given.
        got: i64,
    },
    /// A family that is made from a map, without one.
    #[error("the family `{0}` is made from a map: name a file")]
    NoMap(&'static str),
    /// A map for a family that is made from nothing.
    #[error("the family `{0}` is not made from a map")]
    NeedsNoMap(&'static str),
    /// A map in which nothing can be moved.
    #[error("the map has no portal")]
    NoPortal,
}

impl Settings {
    /// A value.
    ///
    /// # Panics
    /// If the family has no such parameter.
    fn get(&self, name: &str) -> i64 {
        let found = self.values.iter().find(|(known, _)| *known == name);
        found.unwrap_or_else(|| panic!("no parameter `{name}`")).1
    }
}

const PORTALS: Parameter = Parameter {
    name: "portals",
    purpose: "the most portals of a sequence",
    default: 3,
    range: [1, 12],
};

/// Every family, sequences first, and last the one that is made from a map.
pub const FAMILIES: &[Family] = &[
    faces::COPLANAR,
    faces::COLLINEAR,
    faces::SHARED,
    faces::TOUCH,
    faces::DUPLICATE,
    thin::SLIVER,
    thin::SLIT,
    lines::PENCIL,
    lines::REGULUS,
    places::PARALLEL,
    places::MAGNITUDE,
    places::NEAR,
    plane::GATES,
    lines::TRANSVERSALS,
    graphs::ROW,
    graphs::WILD,
    graphs::FLOOR,
    rooms::ROOMS,
    scenes::WALLS,
    scenes::BLOCKS,
    scenes::PLAN,
    perturbed::PERTURBED,
];

impl Family {
    /// The family of this name.
    pub fn named(name: &str) -> Option<&'static Family> {
        FAMILIES.iter().find(|family| family.name == name)
    }

    /// The parameters' values, those given and the defaults of the others, and the map.
    ///
    /// # Errors
    /// [`SettingsError`].
    pub fn settings(
        &self,
        given: &[(String, i64)],
        map: Option<Graph>,
    ) -> Result<Settings, SettingsError> {
        match &map {
            None if self.from_map => return Err(SettingsError::NoMap(self.name)),
            Some(_) if !self.from_map => return Err(SettingsError::NeedsNoMap(self.name)),
            Some(map) if map.doors.is_empty() => return Err(SettingsError::NoPortal),
            Some(_) | None => {}
        }
        let value = |parameter: &Parameter| (parameter.name, parameter.default);
        let mut values: Vec<(&str, i64)> = self.parameters.iter().map(value).collect();
        for (name, got) in given {
            let Some(index) = self.parameters.iter().position(|p| p.name == name) else {
                let known: Vec<&str> = self.parameters.iter().map(|p| p.name).collect();
                let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
                return Err(SettingsError::Unknown {
                    family: self.name,
                    name: name.clone(),
                    known,
                });
            };
            let Parameter { name, range, .. } = self.parameters[index];
            if *got < range[0] || *got > range[1] {
                return Err(SettingsError::Range { name, range, got: *got });
            }
            values[index].1 = *got;
        }
        Ok(Settings { values, map })
    }

    /// The input of this number.
    pub fn input(&self, settings: &Settings, seed: u64, number: u64) -> Input {
        (self.make)(&mut self.random(seed, number), settings)
    }

    /// The numbers from which the input of this number is made.
    fn random(&self, seed: u64, number: u64) -> Random {
        // FNV-1a of the name keeps families apart; a step of SplitMix64 mixes each part in.
        let hash = self.name.bytes().fold(0xcbf2_9ce4_8422_2325u64, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3)
        });
        let mixed = Random::new(hash ^ Random::new(seed).bits()).bits();
        Random::new(mixed ^ Random::new(number.wrapping_mul(0x9e37_79b9)).bits())
    }
}
