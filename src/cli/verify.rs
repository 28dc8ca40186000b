//! `stabline verify`: the independent checker of proofs.

use super::exit::{Exit, Failure};
use super::files::{self, Input};
use crate::report::graph_text;
use crate::scene::plan::{PlanInput, read_plan};
use crate::scene::world::InputKind;
use crate::scene::{self, PortalGraph};
use crate::verify::{Verified, verify};
use flate2::bufread::MultiGzDecoder;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};

/// Check a proof (`pvs --proof`) with big integers only: every line, every cut, every certificate
///
/// With INPUT, a portal file or a JSON portal graph, the proof's graph must be that of the input.
#[derive(Debug, clap::Args)]
pub(super) struct Args {
    /// The folder of the proof, or its file (`proof.txt`, `proof.txt.gz`)
    proof: PathBuf,
    /// What the proof is said to be of
    input: Option<PathBuf>,
    /// Print the counts as JSON
    #[arg(long)]
    json: bool,
}

pub(super) fn run(args: Args) -> Result<Exit, Failure> {
    let input = args.input.as_deref().map(Input::read).transpose()?;
    let path = proof_file(&args.proof);
    let name = path.display().to_string();
    let verified = verify(open(&path)?).map_err(|flaw| match flaw.0 {
        1 => Failure::file(&name, flaw),
        _ => Failure::flaw(format!("{name}: {flaw}")),
    })?;
    let matched = input.map(|input| matches(&path, &input)).transpose()?;
    files::print(&match args.json {
        true => json(&verified, matched),
        false => text(&verified),
    })?;
    Ok(Exit::Done)
}

/// The text of a proof, unpacked.
fn open(path: &Path) -> Result<Box<dyn BufRead>, Failure> {
    let unreadable = |error: std::io::Error| Failure::system("read", path, &error);
    let mut file = BufReader::new(File::open(path).map_err(unreadable)?);
    let is_packed = file.fill_buf().map_err(unreadable)?.starts_with(&[31, 139]);
    Ok(match is_packed {
        true => Box::new(BufReader::with_capacity(1 << 16, MultiGzDecoder::new(file))),
        false => Box::new(file),
    })
}

fn proof_file(path: &Path) -> PathBuf {
    let plain = path.join("proof.txt");
    match (path.is_dir(), plain.exists()) {
        (false, _) => path.to_owned(),
        (true, true) => plain,
        (true, false) => path.join("proof.txt.gz"),
    }
}

/// Whether the proof could be matched with the input, whose graph it then states; the graph of an
/// input that is geometry is of this program's making, and says nothing to who does not trust it.
fn matches(path: &Path, input: &Input) -> Result<bool, Failure> {
    let Some(graph) = stated_graph(input)? else {
        eprintln!(
            "{}: not matched: only a portal file or a JSON portal graph can be; the proof holds \
             for the portal graph that it states",
            input.name
        );
        return Ok(false);
    };
    let read = graph_text(&graph);
    let unreadable = |error: std::io::Error| Failure::system("read", path, &error);
    // The graph follows three lines of the head.
    let mut stated = open(path)?.lines().skip(3);
    for (index, read) in read.lines().enumerate() {
        let stated = stated.next().transpose().map_err(unreadable)?.unwrap_or_default();
        if read != stated {
            return Err(Failure::flaw(format!(
                "{}:{}: the proof is of another graph: {stated:?}, from {} {read:?}",
                path.display(),
                index + 4,
                input.name
            )));
        }
    }
    // As many lines of the graph follow as it states, so here it ends.
    Ok(true)
}

/// The portal graph that an input states, if it states one; one of the plane as its portals with a
/// height of 1.
fn stated_graph(input: &Input) -> Result<Option<PortalGraph>, Failure> {
    match InputKind::of(&input.name, &input.bytes) {
        Ok(InputKind::Graph) => Ok(Some(scene::read_graph(&input.name, &input.bytes)?)),
        Ok(InputKind::Plan) => match read_plan(&input.name, &input.bytes)? {
            PlanInput::Graph(graph) => Ok(Some(graph.in_space())),
            PlanInput::Plan(_) => Ok(None),
        },
        Ok(InputKind::Map | InputKind::Obj | InputKind::Gltf | InputKind::Geometry) | Err(_) => {
            Ok(None)
        }
    }
}

fn text(verified: &Verified) -> String {
    let Verified { pairs: [not_open, grazing, open, undecided], nodes } = verified;
    let [nodes, linear, quadric] = nodes;
    format!(
        "all holds; pairs of different cells: {open} open, {grazing} grazing, \
         {not_open} not open, {undecided} undecided\n\
         {nodes} nodes; refuted: {linear} by a linear combination, {quadric} by a quadric\n"
    )
}

fn json(verified: &Verified, matched: Option<bool>) -> String {
    let Verified { pairs: [not_open, grazing, open, undecided], nodes } = verified;
    let [nodes, linear, quadric] = nodes;
    let matched = matched.map_or("null".to_owned(), |matched| matched.to_string());
    format!(
        "{{\"holds\": true, \"matched\": {matched}, \"open\": {open}, \
         \"grazing\": {grazing}, \"not_open\": {not_open}, \"undecided\": {undecided}, \
         \"nodes\": {nodes}, \"linear\": {linear}, \"quadric\": {quadric}}}\n"
    )
}
