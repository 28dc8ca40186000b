//! How programs do: one mark a case, and the marks added up.

use super::{Answer, Class, Expected, Kind};
use schemars::JsonSchema;
use serde::Serialize;
use serde_json::Value;
use std::collections::BTreeMap;

/// What a program declares about grazing pairs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Policy {
    /// Its portals are open sets: what only touches is not seen.
    Open,
    /// Its portals are closed sets: what touches is seen.
    Closed,
    /// It promises neither.
    #[default]
    Any,
}

/// How a program failed to answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Mishap {
    /// It ended with a failure or without an answer, and this is what is known about it.
    Crash(String),
    /// It gave no answer in the time that it had.
    Hang,
    /// It gave something that is no answer.
    Unreadable(String),
}

/// How one case came out.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum Mark {
    /// The answer that is expected.
    Exact,
    /// Another one that the policy allows.
    Allowed,
    /// Something is said to be seen that is not: no defect, but work for whoever uses it.
    Waste,
    /// Something is seen and the program does not say so.
    Hole,
    /// Another number of lines.
    Wrong,
    /// The line shown for an `open` is not inside every portal.
    #[serde(rename = "wrong-witness")]
    WrongWitness,
    /// The program broke down.
    Crash,
    /// The program did not end in time.
    Hang,
    /// What the program printed is no answer.
    Unreadable,
    /// The program does not answer cases of this kind.
    Skipped,
}

impl Mark {
    /// Every mark, the best first.
    pub const ALL: [Mark; 10] = [
        Mark::Exact,
        Mark::Allowed,
        Mark::Waste,
        Mark::Hole,
        Mark::Wrong,
        Mark::WrongWitness,
        Mark::Crash,
        Mark::Hang,
        Mark::Unreadable,
        Mark::Skipped,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Mark::Exact => "exact",
            Mark::Allowed => "allowed",
            Mark::Waste => "waste",
            Mark::Hole => "hole",
            Mark::Wrong => "wrong",
            Mark::WrongWitness => "wrong-witness",
            Mark::Crash => "crash",
            Mark::Hang => "hang",
            Mark::Unreadable => "unreadable",
            Mark::Skipped => "skipped",
        }
    }

    /// Whether a program with this mark fails the suite.
    pub fn fails(self) -> bool {
        match self {
            Mark::Exact | Mark::Allowed | Mark::Waste | Mark::Skipped => false,
            Mark::Hole | Mark::Wrong | Mark::WrongWitness => true,
            Mark::Crash | Mark::Hang | Mark::Unreadable => true,
        }
    }
}

/// The mark of an answer, or of its lack.
pub fn judge(expected: &Expected, got: &Result<Answer, Mishap>, policy: Policy) -> Mark {
    match (expected, got) {
        (_, Err(Mishap::Crash(_))) => Mark::Crash,
        (_, Err(Mishap::Hang)) => Mark::Hang,
        (_, Err(Mishap::Unreadable(_))) => Mark::Unreadable,
        (_, Ok(Answer::Skip(_))) => Mark::Skipped,
        (Expected::Class(truth), Ok(Answer::Class(said))) => judge_class(*truth, *said, policy),
        (Expected::Lines(truth), Ok(Answer::Lines(said))) => match truth == said {
            true => Mark::Exact,
            false => Mark::Wrong,
        },
        (Expected::Cells { seen, touched }, Ok(Answer::Cells(said))) => {
            judge_cells(seen, touched, said, policy)
        }
        // An answer is read for its kind, so none of another kind comes here.
        (_, Ok(_)) => Mark::Unreadable,
    }
}

fn judge_class(truth: Class, said: Class, policy: Policy) -> Mark {
    if truth == said {
        return Mark::Exact;
    }
    let is_seen = match said {
        Class::Open => true,
        // Who says three things means what the policy makes of the second.
        Class::Grazing => policy == Policy::Closed,
        Class::Blocked => false,
    };
    match (truth, is_seen, policy) {
        (Class::Open, true, _) | (Class::Blocked, false, _) => Mark::Allowed,
        (Class::Open, false, _) | (Class::Grazing, false, Policy::Closed) => Mark::Hole,
        (Class::Blocked, true, _) | (Class::Grazing, true, Policy::Open) => Mark::Waste,
        (Class::Grazing, _, _) => Mark::Allowed,
    }
}

fn judge_cells(seen: &[String], touched: &[String], said: &[String], policy: Policy) -> Mark {
    let lacks = |cells: &[String]| cells.iter().any(|cell| !said.contains(cell));
    let is_known =
        |cell: &String| seen.contains(cell) || (policy != Policy::Open && touched.contains(cell));
    if lacks(seen) || (policy == Policy::Closed && lacks(touched)) {
        Mark::Hole
    } else if !said.iter().all(is_known) {
        Mark::Waste
    } else if said.len() == seen.len() {
        Mark::Exact
    } else {
        Mark::Allowed
    }
}

/// How many cases have each mark.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Marks {
    /// The number of cases.
    pub cases: u32,
    /// How many of them have a mark; marks that no case has are left out.
    #[serde(flatten)]
    pub of: BTreeMap<Mark, u32>,
}

impl Marks {
    /// Counts one case.
    pub fn add(&mut self, mark: Mark) {
        self.cases += 1;
        *self.of.entry(mark).or_default() += 1;
    }

    /// How many cases have this mark.
    pub fn count(&self, mark: Mark) -> u32 {
        self.of.get(&mark).copied().unwrap_or(0)
    }

    /// How many cases fail.
    pub fn failures(&self) -> u32 {
        Mark::ALL.into_iter().filter(|mark| mark.fails()).map(|mark| self.count(mark)).sum()
    }
}

/// The marks of all cases, by kind and by flag.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Of all.
    pub all: Marks,
    /// Of each kind.
    pub by_kind: BTreeMap<&'static str, Marks>,
    /// Of each flag.
    pub by_flag: BTreeMap<String, Marks>,
}

impl Tally {
    /// Counts one case.
    pub fn add(&mut self, kind: Kind, flags: &[String], mark: Mark) {
        self.all.add(mark);
        self.by_kind.entry(kind.name()).or_default().add(mark);
        for flag in flags {
            self.by_flag.entry(flag.clone()).or_default().add(mark);
        }
    }
}

/// A program's score.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(title = "stabline-vectors-score/1")]
pub struct ScoreReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-vectors-score/1$"))]
    pub format: &'static str,
    /// The program and its arguments.
    pub program: Vec<String>,
    /// What it declares about grazing.
    pub policy: Policy,
    /// The files of vectors.
    pub files: Vec<ScoredFile>,
    /// The marks of all cases.
    pub all: Marks,
    /// The marks of the cases of each kind.
    pub by_kind: BTreeMap<&'static str, Marks>,
    /// The marks of the cases with each flag.
    pub by_flag: BTreeMap<String, Marks>,
    /// Every case that fails, and every waste.
    pub listed: Vec<Failing>,
}

/// A file of vectors.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct ScoredFile {
    /// Its name, without folders.
    pub name: String,
    /// The BLAKE3 hash of its bytes.
    pub blake3: String,
}

/// A case that did not come out well.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Failing {
    /// The file's name.
    pub file: String,
    /// The number of the test in it.
    #[serde(rename = "tcId")]
    pub tc_id: u32,
    /// How it came out.
    pub mark: Mark,
    /// The answer that is expected.
    pub expected: Value,
    /// The answer, or what happened in its place.
    pub got: Value,
    /// What the case is about.
    pub comment: String,
    /// What is degenerate about it.
    pub flags: Vec<String>,
}

impl ScoreReport {
    /// The name of the format.
    pub const FORMAT: &str = "stabline-vectors-score/1";

    /// The JSON schema of the format.
    pub fn schema() -> Value {
        schemars::schema_for!(ScoreReport).to_value()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Class::{Blocked, Grazing, Open};

    #[test]
    fn the_policy_decides_about_grazing_and_about_nothing_else() {
        let marks = |truth, said| {
            [Policy::Open, Policy::Closed, Policy::Any]
                .map(|policy| judge(&Expected::Class(truth), &Ok(Answer::Class(said)), policy))
        };
        use Mark::{Allowed, Exact, Hole, Waste};
        for class in [Open, Grazing, Blocked] {
            assert_eq!(marks(class, class), [Exact; 3]);
        }
        assert_eq!(marks(Open, Blocked), [Hole; 3]);
        assert_eq!(marks(Open, Grazing), [Hole, Allowed, Hole]);
        assert_eq!(marks(Grazing, Open), [Waste, Allowed, Allowed]);
        assert_eq!(marks(Grazing, Blocked), [Allowed, Hole, Allowed]);
        assert_eq!(marks(Blocked, Open), [Waste; 3]);
        assert_eq!(marks(Blocked, Grazing), [Allowed, Waste, Allowed]);
    }

    #[test]
    fn a_missing_cell_is_a_hole_and_one_too_many_is_waste() {
        let names = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let expected = Expected::Cells { seen: names("a b"), touched: names("c") };
        let mark =
            |said: &str, policy| judge(&expected, &Ok(Answer::of_cells(names(said))), policy);
        assert_eq!(mark("b a", Policy::Any), Mark::Exact);
        assert_eq!(mark("a b c", Policy::Any), Mark::Allowed);
        assert_eq!(mark("a b c", Policy::Open), Mark::Waste);
        assert_eq!(mark("a b", Policy::Closed), Mark::Hole);
        assert_eq!(mark("a d", Policy::Any), Mark::Hole);
        assert_eq!(mark("a b d", Policy::Any), Mark::Waste);
    }

    #[test]
    fn marks_add_up_by_kind_and_flag() {
        let mut tally = Tally::default();
        let flags = ["Slit", "Far"].map(str::to_owned);
        tally.add(Kind::Sequence, &flags, Mark::Hole);
        tally.add(Kind::Graph, &flags[..1], Mark::Exact);
        assert_eq!((tally.all.cases, tally.all.failures()), (2, 1));
        assert_eq!(tally.by_flag["Slit"].cases, 2);
        assert_eq!(tally.by_flag["Far"].count(Mark::Hole), 1);
        assert_eq!(tally.by_kind["graph"].failures(), 0);
    }
}
