//! What a program is asked, and what it says.

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// What is asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Is a portal sequence open, grazing or blocked?
    Sequence,
    /// How many lines meet four lines?
    Transversals,
    /// Are two cells of a portal graph open, grazing or blocked?
    Graph,
    /// Are two objects of a scene of geometry open, grazing or blocked?
    Scene,
    /// Which cells does an eye see?
    Eye,
}

impl Kind {
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

/// The three verdicts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Class {
    /// Neither of the others.
    Blocked,
    /// Not open, but a line meets every closed portal.
    Grazing,
    /// Some line passes strictly inside every portal.
    Open,
}

/// How many lines at a finite place meet four lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum LineCount {
    /// No line.
    None,
    /// One, perhaps a double one.
    One,
    /// Two.
    Two,
    /// Infinitely many.
    Family,
}

/// A program's answer to a case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Answer {
    /// To a sequence, or to two cells.
    Class(Class),
    /// To four lines.
    Lines(LineCount),
    /// The program does not answer such cases.
    Skip(String),
}

/// One question: what a program under test gets, as one JSON object.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// The number of the case.
    #[serde(rename = "tcId", default)]
    pub tc_id: u32,
    /// What is asked.
    pub kind: Kind,
    /// What it is asked about.
    pub input: Value,
    /// The cell, or region, from which is looked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// The cell, or region, that is looked for.
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
    /// The case as one line of JSON, without the line's end.
    ///
    /// # Panics
    /// Never: all keys are strings.
    pub fn to_line(&self) -> String {
        serde_json::to_string(self).expect("a case has only string keys")
    }
}

impl Answer {
    /// Reads an answer to a case of this kind.
    ///
    /// # Errors
    /// In words.
    pub fn read(kind: Kind, text: &str) -> Result<Answer, String> {
        let value: Value = serde_json::from_str(text).map_err(|error| error.to_string())?;
        if let Some(why) = value["skip"].as_str() {
            return Ok(Answer::Skip(why.to_owned()));
        }
        let field = if kind == Kind::Transversals { "kind" } else { "class" };
        let said = &value[field];
        let answer = match kind {
            Kind::Transversals => LineCount::deserialize(said).map(Answer::Lines),
            Kind::Sequence | Kind::Graph | Kind::Scene | Kind::Eye => {
                Class::deserialize(said).map(Answer::Class)
            }
        };
        answer.map_err(|_| format!("`{field}` is {said}"))
    }
}
