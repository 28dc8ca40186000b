//! A score as text and as `stabline-check/1`.

use super::Candidate;
use crate::audit::check::report::{CheckReport, Hole, PairNames, Sightline};
use crate::audit::check::{Pair, Policy, Score, Tally};
use crate::num::Number;
use crate::report::{Counts, PvsReport, Verdict};
use std::fmt::{self, Write};

/// Everything that is shown.
pub(super) struct Shown<'a> {
    pub golden: &'a str,
    pub candidate: &'a str,
    pub report: &'a PvsReport,
    pub read: &'a Candidate,
    pub policy: Policy,
    pub score: &'a Score,
}

impl Shown<'_> {
    /// One JSON object with every pair.
    pub(super) fn json(&self) -> String {
        let report = CheckReport {
            format: "stabline-check/1".to_owned(),
            golden: self.golden.to_owned(),
            candidate: self.candidate.to_owned(),
            candidate_kind: self.read.kind.clone(),
            policy: match self.policy {
                Policy::Open => "open".to_owned(),
                Policy::Closed => "closed".to_owned(),
            },
            grazing_classified: self.report.grazing_classified,
            cells: self.report.cells.len() as u64,
            present: self.score.present,
            open: self.score.open.into(),
            grazing: self.score.grazing.into(),
            undecided: self.score.undecided.into(),
            asymmetric: self.score.asymmetric,
            split_pairs: self.read.presence.split_pairs,
            rows_missing: self.read.rows_missing as u64,
            holes: self.score.holes.iter().map(|&pair| self.hole(pair)).collect(),
            waste: self.score.waste.iter().map(|&pair| self.names(pair)).collect(),
        };
        format!("{}\n", serde_json::json!(report))
    }

    fn names(&self, [from, to]: Pair) -> PairNames {
        let cells = &self.report.cells;
        PairNames {
            from: from as u64,
            to: to as u64,
            from_name: cells[from].clone(),
            to_name: cells[to].clone(),
        }
    }

    fn hole(&self, pair: Pair) -> Hole {
        let grazing = self.report.matrix.get(pair[0], pair[1]) == Verdict::Grazing;
        Hole { pair: self.names(pair), grazing, witness: self.witness(pair) }
    }

    /// The witness of a pair in its direction: the kept one, or its reverse.
    fn witness(&self, [from, to]: Pair) -> Option<Sightline> {
        let witness = self.report.witness(from, to)?;
        let mut portals = witness.portals.clone();
        let text = |point: &[Number]| point.iter().map(Number::to_string).collect();
        let mut line: [Vec<String>; 2] = witness.line.points().map(text);
        if from > to {
            portals.reverse();
            line.reverse();
        }
        Some(Sightline { portals, line })
    }

    /// A summary, and the first `limit` pairs of each kind.
    pub(super) fn text(&self, limit: usize) -> String {
        let mut text = String::new();
        // Writing to a string cannot fail.
        let _ = self.write_text(&mut text, limit);
        text
    }

    fn write_text(&self, text: &mut String, limit: usize) -> fmt::Result {
        let Counts { open, grazing, undecided, .. } = self.report.matrix.counts();
        let Score { present, asymmetric, .. } = *self.score;
        let cells = self.report.cells.len();
        write!(text, "golden     {}: {cells} cells, {open} open pairs, ", self.golden)?;
        match self.report.grazing_classified {
            true => writeln!(text, "{grazing} grazing, {undecided} undecided")?,
            false => writeln!(text, "{undecided} undecided, grazing not classified")?,
        }
        writeln!(text, "candidate  {} ({}): {present} pairs", self.candidate, self.read.kind)?;
        let (holes, waste) = (&self.score.holes, &self.score.waste);
        let due = match self.policy {
            Policy::Open => "open pairs",
            Policy::Closed => "open or grazing pairs",
        };
        writeln!(text, "holes      {} {due} that the candidate lacks", holes.len())?;
        for &pair in holes.iter().take(limit) {
            self.write_hole(text, pair)?;
        }
        write_rest(text, holes.len(), limit)?;
        let not_open = match self.report.grazing_classified {
            true => "blocked pairs",
            false => "pairs that are not open",
        };
        writeln!(text, "waste      {} {not_open} that the candidate has", waste.len())?;
        for &[from, to] in waste.iter().take(limit) {
            let cells = &self.report.cells;
            writeln!(text, "  {} -> {}", cells[from], cells[to])?;
        }
        write_rest(text, waste.len(), limit)?;
        for (kind, Tally { present, missing }) in
            [("grazing  ", self.score.grazing), ("undecided", self.score.undecided)]
        {
            writeln!(text, "{kind}  {present} present, {missing} missing")?;
        }
        writeln!(text, "asymmetry  {asymmetric} pairs present in one direction only")?;
        let split = self.read.presence.split_pairs;
        if split > 0 {
            writeln!(text, "split      {split} pairs of cells present for some leafs only")?;
        }
        if self.read.rows_missing > 0 {
            let rows = self.read.rows_missing;
            writeln!(text, "no row     {rows} leafs without a row of their own see everything")?;
        }
        Ok(())
    }

    fn write_hole(&self, text: &mut String, pair: Pair) -> fmt::Result {
        let Hole { pair, grazing, witness } = self.hole(pair);
        write!(text, "  {} -> {}", pair.from_name, pair.to_name)?;
        if grazing {
            text.write_str(" (grazing)")?;
        }
        if let Some(Sightline { portals, line: [p, q] }) = witness {
            let portals: Vec<String> = portals.iter().map(u32::to_string).collect();
            let (p, q, portals) = (p.join(", "), q.join(", "), portals.join(", "));
            write!(text, ": the line from ({p}) to ({q}) through portals {portals}")?;
        }
        text.write_char('\n')
    }
}

fn write_rest(text: &mut String, count: usize, limit: usize) -> fmt::Result {
    match count.checked_sub(limit) {
        Some(rest) if rest > 0 => writeln!(text, "  and {rest} more (--list N, --json for all)"),
        _ => Ok(()),
    }
}
