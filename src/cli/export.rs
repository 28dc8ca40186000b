//! `stabline export`: the exact PVS as a level's visibility data.

use super::check::PolicyArg;
use super::exit::{Exit, Failure};
use super::files::{self, Input};
use crate::audit::check::presence;
use crate::formats::bsp::{self, BitMatrix};
use crate::report::PvsReport;
use std::path::PathBuf;

/// Write the PVS of a result into a level, for a game to load
///
/// Every other byte of the level is kept. Pairs that are undecided count as visible.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The result (`stabline-pvs/1`)
    result: PathBuf,
    /// The level to read: Quake 29, BSP2, 2PSB, GoldSrc 30, Quake 2 or Quake 3
    #[arg(long, value_name = "IN.bsp")]
    bsp: PathBuf,
    /// The level to write
    #[arg(short, long, value_name = "OUT.bsp")]
    output: PathBuf,
    /// Whether grazing pairs are left out (open) or written as visible (closed)
    #[arg(long, value_enum, default_value = "open")]
    policy: PolicyArg,
    /// Print what was done as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let result = Input::read(&args.result)?.report()?;
    let level = Input::read(&args.bsp)?;
    let matrix = leaf_matrix(&result, &args);
    let written = bsp::write_visibility(&level.bytes, &matrix)
        .map_err(|error| Failure::file(&level.name, error))?;
    files::write(Some(&args.output), |out| out.write_all(&written))?;
    let leafs = matrix.size();
    if args.json {
        let done = serde_json::json!({
            "format": "stabline-export/1",
            "output": files::file_name(&args.output),
            "leafs": leafs,
            "bytes": written.len(),
        });
        files::print(&format!("{done}\n"))?;
    }
    Ok(Exit::Done)
}

/// The cells' verdicts as bits of the level's leafs.
fn leaf_matrix(result: &PvsReport, args: &Args) -> BitMatrix {
    let present = presence(&result.matrix, args.policy.into());
    let mut matrix = BitMatrix::new(result.leaf_to_cell.len());
    for (from, &a) in result.leaf_to_cell.iter().enumerate() {
        for (to, &b) in result.leaf_to_cell.iter().enumerate() {
            if present.has(a as usize, b as usize) {
                matrix.set(from, to);
            }
        }
    }
    matrix
}
