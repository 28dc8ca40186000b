//! `stabline pvs --proof`: the proof of a result as a file of its own.

use super::super::exit::Failure;
use super::super::files;
use super::{Args, on_threads};
use crate::pvs::plan::{PlanSight, PlanTouch};
use crate::pvs::{Found, Row, write_proof};
use crate::report::{PairWitness, ProofHead, ProvedGrazing, PvsReport, WitnessLine};
use crate::scene::PortalGraph;
use crate::scene::plan::PlanGraph;
use flate2::write::GzEncoder;
use flate2::{Compression, GzBuilder};
use std::io::{self, Write};
use std::path::Path;

/// Proofs with more bytes than this are compressed.
const LARGEST_PLAIN: usize = 1 << 20;

/// Proves `report` and writes the proof into the folder; `false` if interrupted.
pub(super) fn write(
    args: &Args,
    folder: &Path,
    graph: &PortalGraph,
    report: &PvsReport,
    rows: &[Row],
    grazing: &[ProvedGrazing],
) -> Result<bool, Failure> {
    let failure = |error: &io::Error| Failure::system("write", folder, error);
    std::fs::create_dir_all(folder).map_err(|error| failure(&error))?;
    let head = ProofHead { program: &report.program, input: &report.input };
    let found = Found { matrix: &report.matrix, rows, grazing };
    let spool = Spool::Plain(Vec::new());
    let written = on_threads(args, |watch| write_proof(spool, &head, graph, &found, watch))?;
    let Some(spool) = written.map_err(|error| failure(&error))? else { return Ok(false) };
    let (bytes, name, other) = match spool {
        Spool::Plain(bytes) => (bytes, "proof.txt", "proof.txt.gz"),
        Spool::Packed(encoder) => {
            let bytes = encoder.finish().map_err(|error| failure(&error))?;
            (bytes, "proof.txt.gz", "proof.txt")
        }
    };
    files::write(Some(&folder.join(name)), |out| out.write_all(&bytes))?;
    // An older proof under the other name would be taken for this one's.
    match std::fs::remove_file(folder.join(other)) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(failure(&error)),
        _ => Ok(true),
    }
}

/// The same for a graph of the plane, by way of portals with a height of 1: those that a line of
/// the plane passes, or touches, are those that it does at half that height.
pub(super) fn write_of_plan(
    args: &Args,
    folder: &Path,
    graph: &PlanGraph,
    report: &PvsReport,
    touches: &[PlanTouch],
) -> Result<bool, Failure> {
    let row = |witness: &PairWitness| {
        let PairWitness { from, to, portals, line } = witness.clone();
        let WitnessLine::Plane(line) = line else { unreachable!("a line of the plane") };
        PlanSight { from, to, portals, line }.in_space()
    };
    let rows: Vec<Row> = report.witnesses.iter().map(row).collect();
    let crossings = graph.crossings();
    let grazing: Vec<ProvedGrazing> =
        touches.iter().map(|touch| touch.in_space(graph, &crossings)).collect();
    write(args, folder, &graph.in_space(), report, &rows, &grazing)
}

/// Text as it is, compressed once it is large.
enum Spool {
    Plain(Vec<u8>),
    Packed(GzEncoder<Vec<u8>>),
}

impl Write for Spool {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match self {
            Spool::Plain(text) if text.len() + bytes.len() > LARGEST_PLAIN => {
                // Neither a name nor a time: equal proofs are equal bytes.
                let mut encoder = GzBuilder::new().write(Vec::new(), Compression::default());
                encoder.write_all(text)?;
                *self = Spool::Packed(encoder);
                self.write(bytes)
            }
            Spool::Plain(text) => text.write(bytes),
            Spool::Packed(encoder) => encoder.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
