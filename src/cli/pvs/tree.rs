//! `--stab-tree`: the stab trees as JSON, `stabline-stab-tree/1`.

use super::super::exit::Failure;
use super::super::files;
use super::super::plan::Planar;
use super::{Args, on_threads, summary};
use crate::num::Number;
use crate::pvs::plan::{PlanStabTree, plan_stab_trees};
use crate::pvs::{self, StabNode, StabTree};
use crate::report::InputId;
use crate::scene::{CellId, PortalGraph};
use std::io::{self, Write};
use std::path::Path;

/// Stab trees of either dimension.
pub(super) enum Trees {
    Space(Vec<StabTree>),
    /// Of a stated graph of the plane, by way of portals with a height.
    Lifted(Vec<StabTree>),
    Plane(Vec<PlanStabTree>),
}

/// The stab trees of a portal graph; `None` if interrupted.
pub(super) fn of_graph(args: &Args, graph: &PortalGraph) -> Result<Option<Trees>, Failure> {
    let sources = sources(args, graph.cells.len())?;
    let trees = on_threads(args, |watch| pvs::stab_trees(graph, &sources, watch))?;
    Ok(trees.map(Trees::Space))
}

/// Those of a floorplan, or of a graph of the plane; `None` if interrupted.
pub(super) fn of_plan(args: &Args, planar: &Planar) -> Result<Option<Trees>, Failure> {
    let graph = planar.graph();
    let sources = sources(args, graph.cells.len())?;
    on_threads(args, |watch| match planar {
        Planar::Divided { .. } => {
            let crossings = graph.crossings();
            plan_stab_trees(graph, &crossings, &sources, true, watch).map(Trees::Plane)
        }
        // Its cells need not be convex, nor lie in the plane as a whole.
        Planar::Graph(_) => pvs::stab_trees(&graph.in_space(), &sources, watch).map(Trees::Lifted),
    })
}

/// The cells of `--from`, or all.
fn sources(args: &Args, cells: usize) -> Result<Vec<CellId>, Failure> {
    let cells = cells as u32;
    if let Some(cell) = args.from.iter().find(|&&cell| cell >= cells) {
        return Err(Failure::usage(format!("--from {cell}: expected a cell below {cells}")));
    }
    Ok(match args.from.is_empty() {
        true => (0..cells).map(CellId).collect(),
        false => args.from.iter().copied().map(CellId).collect(),
    })
}

impl Trees {
    /// Writes them to a file and, if asked, tells how large they are.
    pub(super) fn write_to(
        &self,
        path: &Path,
        input: &InputId,
        tells_size: bool,
    ) -> Result<(), Failure> {
        files::write(Some(path), |out| self.write(out, input))?;
        if tells_size {
            summary::tell(&self.size());
        }
        Ok(())
    }

    /// How large they are, in words.
    fn size(&self) -> String {
        let (trees, nodes) = match self {
            Trees::Space(trees) | Trees::Lifted(trees) => {
                (trees.len(), trees.iter().map(|tree| tree.nodes.len()).sum::<usize>())
            }
            Trees::Plane(trees) => (trees.len(), trees.iter().map(|tree| tree.nodes.len()).sum()),
        };
        let mean = nodes as f64 / trees.max(1) as f64;
        format!("stab trees: {trees}, of {nodes} nodes, {mean:.1} each\n")
    }

    /// Writes the trees, one node a line.
    fn write(&self, out: &mut dyn Write, input: &InputId) -> io::Result<()> {
        let input = serde_json::json!({"name": input.name, "blake3": input.blake3});
        write!(out, "{{\"format\": \"stabline-stab-tree/1\",\n\"input\": {input},\n\"trees\": [")?;
        match self {
            Trees::Space(trees) => write_space(out, trees, 3),
            Trees::Lifted(trees) => write_space(out, trees, 2),
            Trees::Plane(trees) => {
                let trees = trees.iter().map(|tree| {
                    let nodes = tree.nodes.iter().zip(&tree.lines);
                    let nodes = nodes.map(|(node, [p, q])| Node {
                        parent: node.parent,
                        portal: node.portal,
                        cell: node.cell,
                        line: [texts(p), texts(q)],
                    });
                    (tree.source, nodes)
                });
                write_trees(out, trees)
            }
        }?;
        writeln!(out, "\n]}}")
    }
}

/// A node as it is written.
struct Node {
    parent: Option<u32>,
    portal: u32,
    cell: CellId,
    line: [Vec<String>; 2],
}

fn texts(point: &[Number]) -> Vec<String> {
    point.iter().map(Number::to_string).collect()
}

/// Trees of space, with so many of the coordinates of their lines.
fn write_space(out: &mut dyn Write, trees: &[StabTree], axes: usize) -> io::Result<()> {
    let node = move |node: &StabNode| Node {
        parent: node.parent,
        portal: node.portal,
        cell: node.cell,
        line: node.line.numbers().each_ref().map(|point| texts(&point[..axes])),
    };
    write_trees(out, trees.iter().map(|tree| (tree.source, tree.nodes.iter().map(node))))
}

fn write_trees<N: Iterator<Item = Node>>(
    out: &mut dyn Write,
    trees: impl Iterator<Item = (CellId, N)>,
) -> io::Result<()> {
    for (index, (source, nodes)) in trees.enumerate() {
        let comma = if index == 0 { "" } else { "," };
        write!(out, "{comma}\n{{\"source\": {}, \"nodes\": [", source.0)?;
        for (index, Node { parent, portal, cell, line }) in nodes.enumerate() {
            let comma = if index == 0 { "" } else { "," };
            let node = serde_json::json!({
                "parent": parent,
                "portal": portal,
                "cell": cell.0,
                "line": line,
            });
            write!(out, "{comma}\n{node}")?;
        }
        write!(out, "]}}")?;
    }
    Ok(())
}
