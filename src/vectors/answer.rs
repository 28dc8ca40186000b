//! What a program says.

use super::Kind;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};

/// The three verdicts of `docs/semantics.md`.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema,
)]
#[serde(rename_all = "lowercase")]
pub enum Class {
    /// Neither of the others.
    Blocked,
    /// Not open, but a line meets every closed portal.
    Grazing,
    /// Some line passes strictly inside every portal.
    Open,
}

impl Class {
    /// Its name in an answer.
    pub fn name(self) -> &'static str {
        match self {
            Class::Blocked => "blocked",
            Class::Grazing => "grazing",
            Class::Open => "open",
        }
    }
}

/// How many lines at a finite place meet four lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
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
    /// To a sequence, or to two cells: `{"class": "open"}`.
    Class(Class),
    /// To four lines: `{"kind": "two"}`.
    Lines(LineCount),
    /// To an eye: `{"cells": ["hall", "garden"]}`, in ascending order here, each once.
    Cells(Vec<String>),
    /// The program does not answer such cases, and says why: `{"skip": "space"}`.
    Skip(String),
}

/// Why a text is no answer.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum AnswerError {
    /// No JSON.
    #[error("not one JSON object: {0}")]
    Json(String),
    /// An object without the field that the kind of case asks for.
    #[error("no field `{0}`, nor `skip`")]
    NoField(&'static str),
    /// A field with another value than one of those that are answers.
    #[error("`{field}` is {got}, expected {expected}")]
    Value {
        /// The field.
        field: &'static str,
        /// What it holds.
        got: String,
        /// What it may hold.
        expected: &'static str,
    },
}

impl Answer {
    /// Reads an answer to a case of this kind. Other fields are left alone; [`super::Witness`] is
    /// one.
    ///
    /// # Errors
    /// [`AnswerError`] names the rule broken.
    pub fn read(kind: Kind, text: &str) -> Result<Answer, AnswerError> {
        let value: Value =
            serde_json::from_str(text).map_err(|error| AnswerError::Json(error.to_string()))?;
        let Value::Object(fields) = &value else {
            return Err(AnswerError::Json("it is another value".to_owned()));
        };
        let (field, expected) = match kind {
            Kind::Sequence | Kind::Graph | Kind::Scene => {
                ("class", "\"open\", \"grazing\" or \"blocked\"")
            }
            Kind::Transversals => ("kind", "\"none\", \"one\", \"two\" or \"family\""),
            Kind::Eye => ("cells", "a list of names"),
        };
        let Some(got) = fields.get(field) else {
            return match fields.get("skip") {
                Some(Value::String(why)) => Ok(Answer::Skip(why.clone())),
                Some(_) | None => Err(AnswerError::NoField(field)),
            };
        };
        let answer = match kind {
            Kind::Sequence | Kind::Graph | Kind::Scene => {
                Class::deserialize(got).map(Answer::Class)
            }
            Kind::Transversals => LineCount::deserialize(got).map(Answer::Lines),
            Kind::Eye => Vec::<String>::deserialize(got).map(Answer::of_cells),
        };
        answer.map_err(|_| AnswerError::Value { field, got: got.to_string(), expected })
    }

    /// The answer that lists these cells.
    pub fn of_cells(mut cells: Vec<String>) -> Answer {
        cells.sort_unstable();
        cells.dedup();
        Answer::Cells(cells)
    }

    /// The JSON object that says it.
    pub fn to_value(&self) -> Value {
        match self {
            Answer::Class(class) => json!({ "class": class }),
            Answer::Lines(count) => json!({ "kind": count }),
            Answer::Cells(cells) => json!({ "cells": cells }),
            Answer::Skip(why) => json!({ "skip": why }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_read_for_their_kind_and_nothing_else_is() {
        let read = |kind, text| Answer::read(kind, text);
        let open = Ok(Answer::Class(Class::Open));
        assert_eq!(read(Kind::Graph, r#"{"class": "open", "witness": [[1], [2]]}"#), open);
        assert_eq!(
            read(Kind::Transversals, r#"{"kind": "family"}"#),
            Ok(Answer::Lines(LineCount::Family))
        );
        let cells = Answer::Cells(vec!["a".to_owned(), "b".to_owned()]);
        assert_eq!(read(Kind::Eye, r#"{"cells": ["b", "a", "b"]}"#), Ok(cells));
        let skipped = Ok(Answer::Skip("no".to_owned()));
        assert_eq!(read(Kind::Scene, r#"{"skip": "no"}"#), skipped);
        for bad in ["", "[]", "open", "{}", r#"{"class": "visible"}"#, r#"{"kind": "two"}"#] {
            assert!(read(Kind::Sequence, bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn what_is_written_is_read() {
        let all = [
            (Kind::Sequence, Answer::Class(Class::Grazing)),
            (Kind::Transversals, Answer::Lines(LineCount::None)),
            (Kind::Eye, Answer::of_cells(vec!["z".to_owned(), "a".to_owned()])),
            (Kind::Eye, Answer::Skip("eyes".to_owned())),
        ];
        for (kind, answer) in all {
            assert_eq!(Answer::read(kind, &answer.to_value().to_string()), Ok(answer));
        }
    }
}
