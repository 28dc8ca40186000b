//! What a program is asked.

use crate::formats::json::exact;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// What is asked.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Is a portal sequence open, grazing or blocked?
    Sequence,
    /// How many lines meet four lines?
    Transversals,
    /// Are two cells of a portal graph open, grazing or blocked?
    Graph,
    /// Are two view cells, objects of a scene of geometry, open, grazing or blocked?
    Scene,
    /// Which cells, or view cells, does an eye see?
    Eye,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Kind; 5] =
        [Kind::Sequence, Kind::Transversals, Kind::Graph, Kind::Scene, Kind::Eye];

    /// Its name in a case.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Sequence => "sequence",
            Kind::Transversals => "transversals",
            Kind::Graph => "graph",
            Kind::Scene => "scene",
            Kind::Eye => "eye",
        }
    }
}

/// One question: what a program under test gets, as one JSON object.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// The number of the case in its file.
    #[serde(rename = "tcId", default)]
    pub tc_id: u32,
    /// What is asked.
    pub kind: Kind,
    /// What it is asked about: a `stabline-sequence/1`, `stabline-lines/1` or `stabline-scene/1`;
    /// for an eye `scene`, `at`, and perhaps `cell`, `look`, `up`, `half_tangents`.
    #[serde(deserialize_with = "exact")]
    pub input: Value,
    /// The cell, or view cell, from which is looked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// The cell, or view cell, that is looked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<String>,
    /// What the case is about.
    #[serde(default)]
    pub comment: String,
    /// What is degenerate about it.
    #[serde(default)]
    pub flags: Vec<String>,
}

impl Case {
    /// Reads a case from JSON.
    ///
    /// # Errors
    /// The rule broken, with line and column.
    pub fn read(bytes: &[u8]) -> Result<Case, serde_json::Error> {
        serde_json::from_slice(bytes)
    }

    /// The case as one line of JSON, without the line's end.
    ///
    /// # Panics
    /// Never: all keys are strings.
    pub fn to_line(&self) -> String {
        serde_json::to_string(self).expect("a case has only string keys")
    }
}
