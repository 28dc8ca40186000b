//! `--stab-tree`: the stab trees as JSON, `stabline-stab-tree/1`.

use crate::pvs::StabTree;
use crate::report::InputId;
use std::io::{self, Write};

/// Writes the trees, one node a line.
pub(super) fn write(out: &mut dyn Write, input: &InputId, trees: &[StabTree]) -> io::Result<()> {
    let input = serde_json::json!({"name": input.name, "blake3": input.blake3});
    writeln!(out, "{{\"format\": \"stabline-stab-tree/1\",\n\"input\": {input},\n\"trees\": [")?;
    for (index, tree) in trees.iter().enumerate() {
        write!(out, "{{\"source\": {}, \"nodes\": [", tree.source.0)?;
        for (index, node) in tree.nodes.iter().enumerate() {
            let line = node.line.numbers().map(|point| point.map(|number| number.to_string()));
            let value = serde_json::json!({
                "parent": node.parent,
                "portal": node.portal,
                "cell": node.cell.0,
                "line": line,
            });
            write!(out, "{}\n{value}", if index == 0 { "" } else { "," })?;
        }
        writeln!(out, "]}}{}", if index + 1 == trees.len() { "" } else { "," })?;
    }
    writeln!(out, "]}}")
}
