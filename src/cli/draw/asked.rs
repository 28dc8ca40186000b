//! Which picture is asked for, with what it needs.

use super::super::exit::Failure;
use super::Args;
use super::sight::Eye;
use crate::eye::plan::PlanCull;
use clap::ValueEnum;

/// The value of `--what`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum What {
    /// Faces, cells, portals and the adjacency graph; of a Doom level its lines and leaves
    Cells,
    /// What the eye `--at` sees, and the cells that `--cull` leaves
    Eye,
    /// The sectors of a Doom level that the sector `--from` sees
    Sectors,
    /// The lines that divide a floorplan, in the order of the tree
    Splits,
    /// The stab tree of the cell `--from`, over the plan
    StabTree,
    /// The stab tree of the cell `--from` in layers: cells, and the portals between them
    StabTreeGraph,
    /// The cells that the cell `--from` sees, with a line to each
    Visibility,
}

/// The value of `--cull`: the culls of Teller and Séquin 1991, §4.1, named as in `stabline eye`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Cull {
    /// What the eye's cell sees
    None,
    /// Of it the cells that meet the view cone
    Disjoint,
    /// Those that are reached through such cells
    Component,
    /// Those that are reached through portals that meet it
    Portals,
    /// The cells that are seen
    Exact,
}

impl Cull {
    pub(super) fn method(self) -> PlanCull {
        match self {
            Cull::None => PlanCull::None,
            Cull::Disjoint => PlanCull::DisjointCell,
            Cull::Component => PlanCull::ConnectedComponent,
            Cull::Portals => PlanCull::IncidentPortals,
            Cull::Exact => PlanCull::Exact,
        }
    }
}

/// What a value is called on the command line.
fn name(value: impl ValueEnum) -> String {
    value.to_possible_value().map(|value| value.get_name().to_owned()).unwrap_or_default()
}

/// A picture, and what it needs; cells and sectors as they were named.
#[derive(Debug)]
pub(super) enum Asked {
    Cells,
    Splits,
    Visibility { from: String },
    StabTree { from: String, is_alone: bool },
    Sectors { from: String },
    Eye { eye: Box<Eye>, cull: Cull },
}

impl Asked {
    /// The picture that the options ask for.
    ///
    /// # Errors
    /// A picture that lacks an option, or has no use for one.
    pub(super) fn of(args: &Args) -> Result<Asked, Failure> {
        let what = args.what;
        let lacks = |option: &str| Failure::usage(format!("--what {} needs {option}", name(what)));
        let from = || args.from.clone().ok_or_else(|| lacks("--from"));
        let asked = match what {
            What::Cells => Asked::Cells,
            What::Splits => Asked::Splits,
            What::Visibility => Asked::Visibility { from: from()? },
            What::StabTree => Asked::StabTree { from: from()?, is_alone: false },
            What::StabTreeGraph => Asked::StabTree { from: from()?, is_alone: true },
            What::Sectors => Asked::Sectors { from: from()? },
            What::Eye => {
                let eye = Eye::of(args)?.ok_or_else(|| lacks("--at"))?;
                let cull = args.cull.unwrap_or(Cull::Exact);
                Asked::Eye { eye: Box::new(eye), cull }
            }
        };
        let (takes_from, takes_eye) = match asked {
            Asked::Cells | Asked::Splits => (false, false),
            Asked::Visibility { .. } | Asked::StabTree { .. } | Asked::Sectors { .. } => {
                (true, false)
            }
            Asked::Eye { .. } => (false, true),
        };
        let stated = [
            (args.from.is_some() && !takes_from, "--from"),
            (args.at.is_some() && !takes_eye, "--at"),
            (args.cull.is_some() && !takes_eye, "--cull"),
        ];
        match stated.iter().find(|(is_useless, _)| *is_useless) {
            Some((_, option)) => {
                Err(Failure::usage(format!("--what {} has no use for {option}", name(what))))
            }
            None => Ok(asked),
        }
    }

    /// What the title says.
    pub(super) fn about(&self, is_level: bool) -> &'static str {
        match self {
            Asked::Cells if is_level => "lines and leaves",
            Asked::Cells => "cells, portals, adjacency graph",
            Asked::Splits => "splits",
            Asked::Visibility { .. } => "cell-to-cell visibility",
            Asked::StabTree { .. } => "stab tree",
            Asked::Sectors { .. } => "sector-to-sector visibility",
            Asked::Eye { .. } => "eye-to-cell visibility",
        }
    }
}
