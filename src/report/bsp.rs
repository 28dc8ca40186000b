//! What a division comes to, as text and as `stabline-bsp/1`; its cells as `stabline-cells/1`.

use super::InputId;
use super::eye::Ratio;
use schemars::JsonSchema;
use serde::Serialize;

/// What the division of a world comes to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(title = "stabline-bsp/1")]
pub struct BspReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-bsp/1$"))]
    pub format: &'static str,
    /// The input's name, without folders.
    pub input: String,
    /// The BLAKE3 hash of the input's bytes.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    pub blake3: String,
    /// Convex solids that occlude.
    pub solids: usize,
    /// Thin polygons that occlude.
    pub polygons: usize,
    /// Solids some of whose faces split cells.
    pub hints: usize,
    /// Detail objects.
    pub objects: usize,
    /// Points that mark the inside.
    pub marks: usize,
    /// What was odd in the input, and was repaired.
    pub warnings: Vec<String>,
    /// Leaves of the tree, solid ones included.
    pub leaves: usize,
    /// Those of them that are solid.
    pub solid_leaves: usize,
    /// Empty leaves that are asked about.
    pub cells: usize,
    /// Portals between cells.
    pub portals: usize,
    /// What became a portal of what two leaves share: `exact`, `merged` or `hull`.
    pub portal_shape: &'static str,
    /// Whether portals may run across occluders, as hulls do: then more is seen than there is.
    pub conservative: bool,
    /// Marks that lie in no empty leaf.
    pub buried_marks: Vec<String>,
    /// By how much a coordinate of the portal file was moved at most; null where it was not asked
    /// to be rounded.
    pub displacement: Option<Ratio>,
    /// What was checked; null without `--check`.
    pub checked: Option<BspChecked>,
    /// The seconds that each stage took, in order; empty without `--stats`.
    pub stages: Vec<BspStage>,
}

/// What was checked, and holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct BspChecked {
    /// Leaves whose volumes add up to that of the box, and whose kind agrees with the solids.
    pub leaves: usize,
    /// Portals that lie in the boundary of both their leaves and on no occluder.
    pub portals: usize,
    /// Random points that lie inside one leaf.
    pub points_inside: usize,
    /// Random points that lie between leaves.
    pub points_between: usize,
}

/// A stage of the work.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct BspStage {
    /// Its name.
    pub stage: String,
    /// How long it took, in microseconds.
    pub microseconds: u64,
}

/// Cells as polyhedra, and the portals between them.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[schemars(title = "stabline-cells/1")]
pub struct CellsReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-cells/1$"))]
    format: &'static str,
    /// The input's name, without folders.
    input: String,
    /// The BLAKE3 hash of the input's bytes.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    blake3: String,
    /// The cells.
    pub cells: Vec<CellShape>,
    /// The portals between them.
    pub portals: Vec<PortalPolygon>,
}

/// A cell: a convex polyhedron.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct CellShape {
    /// The volume.
    pub volume: Ratio,
    /// The vertices, by their coordinates.
    pub vertices: Vec<[Ratio; 3]>,
    /// The faces: indices of vertices, counter-clockwise as seen from outside.
    pub faces: Vec<Vec<u32>>,
}

/// A portal between two cells.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PortalPolygon {
    /// The cell behind it.
    pub from: u32,
    /// The cell before it, from which the vertices are seen counter-clockwise.
    pub to: u32,
    /// The vertices of a strictly convex polygon.
    pub vertices: Vec<[Ratio; 3]>,
}

impl BspReport {
    /// The name of the format, its first field.
    pub const FORMAT: &'static str = "stabline-bsp/1";

    /// As JSON.
    pub fn to_json(&self) -> String {
        format!("{:#}\n", serde_json::json!(self))
    }

    /// As text, for people.
    pub fn to_text(&self) -> String {
        let mut text = format!(
            "{}: {} solids, {} polygons, {} hints, {} objects, {} marks; {} oddities repaired\n\
             {} leaves of the tree, {} solid\n\
             {} cells inside, {} portals between them\n",
            self.input,
            self.solids,
            self.polygons,
            self.hints,
            self.objects,
            self.marks,
            self.warnings.len(),
            self.leaves,
            self.solid_leaves,
            self.cells,
            self.portals,
        );
        if self.conservative {
            text.push_str("the portals are hulls: conservative, they may run across occluders\n");
        }
        for mark in &self.buried_marks {
            text.push_str(&format!("{mark} is inside a solid\n"));
        }
        if let Some(moved) = &self.displacement {
            text.push_str(&format!("coordinates moved by {moved} at most\n"));
        }
        if let Some(checked) = &self.checked {
            text.push_str(&format!(
                "checked: {} leaves tile the box and agree with the solids, {} portals are shared \
                 and free, {} random points are in one leaf, {} between leaves\n",
                checked.leaves, checked.portals, checked.points_inside, checked.points_between
            ));
        }
        for BspStage { stage, microseconds } in &self.stages {
            let (seconds, rest) = (microseconds / 1_000_000, microseconds % 1_000_000 / 1000);
            text.push_str(&format!("{seconds:>4}.{rest:03} s {stage}\n"));
        }
        text
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(BspReport).to_value()
    }
}

impl CellsReport {
    /// The name of the format, its first field.
    pub const FORMAT: &'static str = "stabline-cells/1";

    /// The cells and portals of an input.
    pub fn new(input: InputId, cells: Vec<CellShape>, portals: Vec<PortalPolygon>) -> CellsReport {
        let InputId { name, blake3 } = input;
        CellsReport { format: CellsReport::FORMAT, input: name, blake3, cells, portals }
    }

    /// As JSON: one cell and one portal a line.
    ///
    /// # Errors
    /// Those of the sink.
    pub fn write(&self, out: &mut dyn std::io::Write) -> std::io::Result<()> {
        let CellsReport { format, input, blake3, cells, portals } = self;
        let head = serde_json::json!([format, input, blake3]);
        writeln!(
            out,
            "{{\"format\": {}, \"input\": {}, \"blake3\": {},\n\"cells\": [",
            head[0], head[1], head[2]
        )?;
        list(out, cells)?;
        writeln!(out, "],\n\"portals\": [")?;
        list(out, portals)?;
        writeln!(out, "]}}")
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(CellsReport).to_value()
    }
}

fn list<T: Serialize>(out: &mut dyn std::io::Write, items: &[T]) -> std::io::Result<()> {
    for (index, item) in items.iter().enumerate() {
        let comma = if index + 1 < items.len() { "," } else { "" };
        writeln!(out, "{}{comma}", serde_json::to_string(item)?)?;
    }
    Ok(())
}
