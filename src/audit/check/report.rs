//! The fields of `stabline-check/1`.

use super::Tally;
use schemars::JsonSchema;
use serde::Serialize;

/// The score of a candidate PVS.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(title = "stabline-check/1")]
pub struct CheckReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-check/1$"))]
    pub format: String,
    /// The name of the golden result's file.
    pub golden: String,
    /// The name of the candidate's file.
    pub candidate: String,
    /// What the candidate is: `npy`, the format of a level, or the program of a result.
    pub candidate_kind: String,
    /// `open`, or `closed` where missing grazing pairs are holes.
    #[schemars(regex(pattern = "^(open|closed)$"))]
    pub policy: String,
    /// Whether the golden result tells grazing pairs from blocked ones.
    pub grazing_classified: bool,
    /// The number of cells.
    pub cells: u64,
    /// The number of ordered pairs that the candidate has, the diagonal included.
    pub present: u64,
    /// The open pairs.
    pub open: TallyFields,
    /// The grazing pairs.
    pub grazing: TallyFields,
    /// The pairs that the golden result leaves undecided.
    pub undecided: TallyFields,
    /// Unordered pairs that the candidate has in one direction only.
    pub asymmetric: u64,
    /// Pairs of cells of which a level has some but not all pairs of leafs.
    pub split_pairs: u64,
    /// Leafs of a level without a row of their own, which see everything.
    pub rows_missing: u64,
    /// Every hole.
    pub holes: Vec<Hole>,
    /// Every pair that the candidate has though it is not open.
    pub waste: Vec<PairNames>,
}

/// How many pairs of a kind the candidate has and lacks.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub struct TallyFields {
    /// Pairs that it has.
    pub present: u64,
    /// Pairs that it lacks.
    pub missing: u64,
}

impl From<Tally> for TallyFields {
    fn from(Tally { present, missing }: Tally) -> TallyFields {
        TallyFields { present, missing }
    }
}

/// An ordered pair of cells by index and by name.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct PairNames {
    /// The source cell.
    pub from: u64,
    /// The target cell.
    pub to: u64,
    /// The source cell's name.
    pub from_name: String,
    /// The target cell's name.
    pub to_name: String,
}

/// A pair that must be present and is not.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Hole {
    /// The pair.
    #[serde(flatten)]
    pub pair: PairNames,
    /// Whether the pair is grazing, a hole under the policy `closed` only.
    pub grazing: bool,
    /// The sightline that the candidate overlooks, where the golden result has witnesses.
    pub witness: Option<Sightline>,
}

/// A sightline in the direction of its pair.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Sightline {
    /// The portals that it crosses, in this order: indices into the input file's portals.
    pub portals: Vec<u32>,
    /// Two distinct points of it, in world coordinates: three each, or two in a floorplan.
    #[schemars(inner(length(min = 2, max = 3)))]
    pub line: [Vec<String>; 2],
}
