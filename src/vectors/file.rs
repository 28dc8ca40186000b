//! Files of test vectors, `stabline-vectors/1`.
//!
//! The text is canonical: one test a line, keys in a fixed order, so that the same vectors are the
//! same bytes. All numbers are JSON integers below 2^53 or strings, so that any JSON reader keeps
//! them exactly.

use super::{Answer, Case, Class, Kind, LineCount};
use crate::formats::blake3;
use crate::formats::json::{exact, exact_if_any};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};

/// Test vectors for implementations of exact visibility.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "stabline-vectors/1")]
pub struct VectorsFile {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-vectors/1$"))]
    pub format: String,
    /// What the file is called, without its ending.
    pub name: String,
    /// What its cases ask.
    pub about: String,
    /// The number of its tests, in all groups.
    #[serde(rename = "numberOfTests")]
    pub number_of_tests: u32,
    /// Every flag that a test has, by its name.
    pub notes: BTreeMap<String, Note>,
    /// The tests.
    pub groups: Vec<Group>,
}

/// What a flag means.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Note {
    /// What is degenerate.
    pub about: String,
    /// The known defect of public programs that it recalls.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub recalls: Option<String>,
}

/// Tests of one kind, on one scene where they share it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Group {
    /// What is asked.
    pub kind: Kind,
    /// What the tests have in common.
    pub about: String,
    /// The scene that all tests of the group ask about; sequences and lines have none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<SceneOfGroup>,
    /// The tests.
    pub tests: Vec<Test>,
}

/// A scene, with its hash.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SceneOfGroup {
    /// What the scene is called.
    pub name: String,
    /// The BLAKE3 hash of `input` as compact JSON with sorted keys.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    pub blake3: String,
    /// The scene, a `stabline-scene/1`.
    #[serde(deserialize_with = "exact")]
    pub input: Value,
}

/// One case, and what is true of it.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Test {
    /// The number of the test in its file, from 1.
    #[serde(rename = "tcId")]
    pub tc_id: u32,
    /// What the case is about, and why the answer is what it is.
    pub comment: String,
    /// What is degenerate; `notes` explains each.
    pub flags: Vec<String>,
    /// The sequence (`stabline-sequence/1`) or the lines (`stabline-lines/1`); of an eye, where it
    /// is and how it looks (`at`, `cell`, `look`, `up`, `half_tangents`).
    #[serde(default, deserialize_with = "exact_if_any", skip_serializing_if = "Option::is_none")]
    pub input: Option<Value>,
    /// The cell, or view cell, from which is looked.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<String>,
    /// The cell, or view cell, that is looked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<String>,
    /// Of a sequence, or of two cells: the verdict.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub class: Option<Class>,
    /// Of four lines: how many lines at a finite place meet them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub transversals: Option<LineCount>,
    /// Of an eye: the cells that it sees, in ascending order.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cells: Option<Vec<String>>,
    /// Of an eye: cells that it does not see, but that a ray from it touches.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub grazing: Vec<String>,
    /// Of what is open: two points of a line, in its direction; of an eye, for each cell but its
    /// own a point that it sees strictly inside the last portal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub witness: Option<Value>,
    /// Of two open cells of a graph: the portals that the witness crosses, by number.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub portals: Option<Vec<u32>>,
    /// Of what is grazing: two points of a line that meets every closed portal, of numbers a + b√d.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub touching_line: Option<Value>,
    /// Of what is not open: why. Of four lines: the lines and families that meet them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub certificate: Option<Value>,
}

/// What is true of a case.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Expected {
    /// A verdict.
    Class(Class),
    /// How many lines.
    Lines(LineCount),
    /// Cells that an eye sees, and those that it only touches.
    Cells {
        /// Those seen, in ascending order.
        seen: Vec<String>,
        /// Those touched.
        touched: Vec<String>,
    },
}

impl Expected {
    /// The answer that says exactly this.
    pub fn answer(&self) -> Answer {
        match self {
            Expected::Class(class) => Answer::Class(*class),
            Expected::Lines(count) => Answer::Lines(*count),
            Expected::Cells { seen, .. } => Answer::of_cells(seen.clone()),
        }
    }
}

/// Why a text is no file of test vectors.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum VectorsError {
    /// Not the JSON that the format asks for.
    #[error("{0}")]
    Json(String),
    /// Another format, or another version.
    #[error("format: expected `{expected}`, got `{0}`", expected = VectorsFile::FORMAT)]
    Format(String),
    /// A rule of the format is broken.
    #[error("{place}: {what}")]
    Rule {
        /// Where.
        place: String,
        /// The rule.
        what: String,
    },
}

impl SceneOfGroup {
    /// A scene with its hash.
    pub fn new(name: &str, input: Value) -> SceneOfGroup {
        let blake3 = blake3::hex(input.to_string().as_bytes());
        SceneOfGroup { name: name.to_owned(), blake3, input }
    }
}

impl Test {
    /// What is true of the case; `None` if not exactly one is stated.
    pub fn expected(&self) -> Option<Expected> {
        match (self.class, self.transversals, &self.cells) {
            (Some(class), None, None) => Some(Expected::Class(class)),
            (None, Some(count), None) => Some(Expected::Lines(count)),
            (None, None, Some(cells)) => {
                Some(Expected::Cells { seen: cells.clone(), touched: self.grazing.clone() })
            }
            _ => None,
        }
    }
}

impl Group {
    /// The question of one of the group's tests.
    pub fn case(&self, test: &Test) -> Case {
        let scene = self.scene.as_ref().map(|scene| &scene.input);
        let input = match (scene, &test.input) {
            (Some(scene), Some(Value::Object(eye))) => {
                let mut input = eye.clone();
                input.insert("scene".to_owned(), scene.clone());
                Value::Object(input)
            }
            (Some(scene), _) => scene.clone(),
            (None, input) => input.clone().unwrap_or_default(),
        };
        Case {
            tc_id: test.tc_id,
            kind: self.kind,
            input,
            from: test.from.clone(),
            to: test.to.clone(),
            comment: test.comment.clone(),
            flags: test.flags.clone(),
        }
    }

    /// What a test of this kind states, by name, and whether it does.
    fn check(&self, test: &Test) -> Result<(), String> {
        let needs = |what: &str, is: bool| match is {
            true => Ok(()),
            false => Err(format!("expected `{what}` of a test of kind {}", self.kind.name())),
        };
        let has_scene = matches!(self.kind, Kind::Graph | Kind::Scene | Kind::Eye);
        let is_pair = matches!(self.kind, Kind::Graph | Kind::Scene);
        if has_scene != self.scene.is_some() {
            return Err("a scene is stated for graphs, scenes and eyes, and for these only".into());
        }
        if is_pair == test.input.is_some() {
            return Err("an `input` is stated for all kinds but graph and scene".into());
        }
        if is_pair != (test.from.is_some() && test.to.is_some()) {
            return Err("`from` and `to` are stated for graphs and scenes only".into());
        }
        match (self.kind, test.expected()) {
            (Kind::Sequence | Kind::Graph | Kind::Scene, Some(Expected::Class(_)))
            | (Kind::Transversals, Some(Expected::Lines(_)))
            | (Kind::Eye, Some(Expected::Cells { .. })) => {}
            (Kind::Sequence | Kind::Graph | Kind::Scene, _) => needs("class", false)?,
            (Kind::Transversals, _) => needs("transversals", false)?,
            (Kind::Eye, _) => needs("cells", false)?,
        }
        needs("witness", test.class != Some(Class::Open) || test.witness.is_some())?;
        let touches = test.class == Some(Class::Grazing);
        needs("touching_line", !touches || test.touching_line.is_some())?;
        needs("certificate", test.class != Some(Class::Blocked) || test.certificate.is_some())
    }
}

impl VectorsFile {
    /// The name of the format.
    pub const FORMAT: &str = "stabline-vectors/1";

    /// Reads and checks a file.
    ///
    /// # Errors
    /// [`VectorsError`] names the place and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<VectorsFile, VectorsError> {
        let file: VectorsFile =
            serde_json::from_slice(bytes).map_err(|error| VectorsError::Json(error.to_string()))?;
        file.check()?;
        Ok(file)
    }

    /// Every test with its group, in the order of the file.
    pub fn tests(&self) -> impl Iterator<Item = (&Group, &Test)> {
        self.groups.iter().flat_map(|group| group.tests.iter().map(move |test| (group, test)))
    }

    /// Checks what the types do not say.
    ///
    /// # Errors
    /// [`VectorsError`] names the place and the rule broken.
    pub fn check(&self) -> Result<(), VectorsError> {
        if self.format != VectorsFile::FORMAT {
            return Err(VectorsError::Format(self.format.clone()));
        }
        let rule = |place: String, what: String| Err(VectorsError::Rule { place, what });
        let mut unused: BTreeSet<&String> = self.notes.keys().collect();
        let mut number = 0;
        for (index, group) in self.groups.iter().enumerate() {
            if let Some(scene) = &group.scene {
                let place = format!("groups[{index}].scene");
                if SceneOfGroup::new(&scene.name, scene.input.clone()).blake3 != scene.blake3 {
                    return rule(place, "the hash is not that of `input`".to_owned());
                }
                no_floats(&scene.input).or_else(|what| rule(place, what))?;
            }
            for test in &group.tests {
                number += 1;
                let place = format!("test {}", test.tc_id);
                if test.tc_id != number {
                    return rule(place, format!("expected tcId {number}"));
                }
                for flag in &test.flags {
                    unused.remove(flag);
                    if !self.notes.contains_key(flag) {
                        return rule(place, format!("no note explains the flag `{flag}`"));
                    }
                }
                let input = test.input.as_ref().map_or(Ok(()), no_floats);
                input.and_then(|()| group.check(test)).or_else(|what| rule(place, what))?;
            }
        }
        if let Some(flag) = unused.first() {
            return rule("notes".to_owned(), format!("no test has the flag `{flag}`"));
        }
        if number != self.number_of_tests {
            return rule("numberOfTests".to_owned(), format!("expected {number}"));
        }
        Ok(())
    }

    /// The canonical text.
    ///
    /// # Panics
    /// Never: all keys are strings.
    pub fn to_text(&self) -> String {
        fn json(value: &impl Serialize) -> String {
            serde_json::to_string(value).expect("all keys are strings")
        }
        let mut text = format!(
            "{{\"format\": {},\n\"name\": {},\n\"about\": {},\n\"numberOfTests\": {},\n",
            json(&self.format),
            json(&self.name),
            json(&self.about),
            self.number_of_tests
        );
        let notes = self.notes.iter().map(|(flag, note)| format!("{}: {}", json(flag), json(note)));
        text.push_str(&format!("\"notes\": {{\n{}}},\n", notes.collect::<Vec<_>>().join(",\n")));
        let group = |group: &Group| {
            let mut text =
                format!("{{\"kind\": {},\n\"about\": {},\n", json(&group.kind), json(&group.about));
            if let Some(scene) = &group.scene {
                text.push_str(&format!("\"scene\": {},\n", json(scene)));
            }
            let tests = group.tests.iter().map(json).collect::<Vec<_>>().join(",\n");
            format!("{text}\"tests\": [\n{tests}]}}")
        };
        let groups = self.groups.iter().map(group).collect::<Vec<_>>().join(",\n");
        format!("{text}\"groups\": [\n{groups}]}}\n")
    }

    /// The JSON schema of the format.
    pub fn schema() -> Value {
        schemars::schema_for!(VectorsFile).to_value()
    }
}

/// Refuses numbers that a reader of JSON may round.
fn no_floats(value: &Value) -> Result<(), String> {
    match value {
        Value::Number(number) => match number.as_i64() {
            Some(whole) if whole.unsigned_abs() < 1 << 53 => Ok(()),
            Some(_) | None => Err(format!("{number}: expected a string, or an integer below 2^53")),
        },
        Value::Array(list) => list.iter().try_for_each(no_floats),
        Value::Object(fields) => fields.values().try_for_each(no_floats),
        Value::Null | Value::Bool(_) | Value::String(_) => Ok(()),
    }
}
