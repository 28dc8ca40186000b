//! `stabline generate`: inputs that are made up.

use super::exit::{Exit, Failure};
use super::files;
use crate::formats::json::SCENE_FORMAT;
use crate::scene::plan::{FloorplanOptions, RawPlan, generate_floorplan};
use std::io::{self, Write};
use std::path::PathBuf;

/// Make up an input: the same options give the same file everywhere
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    #[command(subcommand)]
    what: What,
}

#[derive(Debug, clap::Subcommand)]
enum What {
    Floorplan(FloorplanArgs),
}

/// A building of halls, corridors and rooms with doors and windows (`stabline-scene/1`)
#[derive(Debug, clap::Args)]
struct FloorplanArgs {
    /// How many segments to make
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(16..=10_000_000))]
    faces: u32,
    /// Another number is another building
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Walls of any direction: some oblique, and the whole turned
    #[arg(long)]
    general: bool,
    /// Write to this file, and not to standard output
    #[arg(short, long, value_name = "OUT.json")]
    output: Option<PathBuf>,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let What::Floorplan(args) = args.what;
    files::check_outputs([&args.output])?;
    let FloorplanArgs { faces, seed, general, output } = args;
    let options = FloorplanOptions { faces: faces as usize, seed, is_general: general };
    let plan = generate_floorplan(&options);
    let kind = if general { " --general" } else { "" };
    let about =
        format!("Made by `stabline generate floorplan --faces {faces} --seed {seed}{kind}`");
    files::write(output.as_deref(), |out| write(out, &plan, &about))?;
    Ok(Exit::Done)
}

/// Writes a plan of whole coordinates, one segment a line.
fn write(out: &mut dyn Write, plan: &RawPlan, about: &str) -> io::Result<()> {
    write!(out, "{{\"format\":\"{SCENE_FORMAT}\",\"about\":\"{about}\",\"segments\":[")?;
    for (i, segment) in plan.segments.iter().enumerate() {
        let [[a, b], [c, d]] = &segment.ends;
        write!(out, "{}\n[[{a},{b}],[{c},{d}]]", if i == 0 { "" } else { "," })?;
    }
    writeln!(out, "\n]}}")
}
