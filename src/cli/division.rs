//! The options that say how space is divided, for every command that divides it.

use super::exit::Failure;
use crate::num::{Int, Rational, parse_decimal};
use crate::subdivision::{Options, PortalShape, Weights};

/// How to divide space, to be flattened into a subcommand's `Args`.
#[derive(Clone, Debug, clap::Args)]
#[command(next_help_heading = "Division")]
pub(super) struct DivisionArgs {
    /// How far the box reaches past the occluders, where the input states no view: whole units,
    /// at least 1
    #[arg(long, value_name = "UNITS", default_value_t = 64, value_parser = clap::value_parser!(u32).range(1..))]
    margin: u32,
    /// First split by planes whose faces cover at least this share of a cell's section (a decimal
    /// or ratio, at most 1), most covered first
    #[arg(long, value_name = "SHARE")]
    obscuration: Option<String>,
    /// The score of a plane: reward for each face in it
    #[arg(long, value_name = "N", default_value_t = 10, allow_hyphen_values = true, value_parser = weight())]
    reward_coplanar: i64,
    /// The score of a plane: charge for each face that it cuts
    #[arg(long, value_name = "N", default_value_t = 20, allow_hyphen_values = true, value_parser = weight())]
    charge_cut: i64,
    /// The score of a plane: charge for each face that one side has more than the other
    #[arg(long, value_name = "N", default_value_t = 1, allow_hyphen_values = true, value_parser = weight())]
    charge_imbalance: i64,
    /// The score of a plane: reward if it is perpendicular to an axis
    #[arg(long, value_name = "N", default_value_t = 5, allow_hyphen_values = true, value_parser = weight())]
    reward_axial: i64,
    /// The most planes to weigh in one cell
    #[arg(long, value_name = "N", default_value_t = 64, value_parser = clap::value_parser!(u32).range(1..))]
    samples: u32,
    /// Split empty cells larger than this share of the box (a decimal or ratio, above 0)
    #[arg(long, value_name = "SHARE")]
    largest_volume: Option<String>,
    /// Split empty cells whose longest extent is more than this many times their shortest (a
    /// decimal or ratio, at least 1)
    #[arg(long, value_name = "RATIO")]
    largest_aspect: Option<String>,
    /// What becomes a portal of what two cells share, where polygons lie between them
    #[arg(long, value_enum, value_name = "SHAPE", default_value = "merged")]
    portals: Shape,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Shape {
    /// The convex pieces that are left
    Exact,
    /// The pieces, joined where the union of two is convex
    Merged,
    /// The convex hull of all pieces; conservative: it may run across occluders
    Hull,
}

/// Weights that no number of faces makes overflow.
fn weight() -> clap::builder::RangedI64ValueParser<i64> {
    clap::value_parser!(i64).range(-1_000_000..=1_000_000)
}

impl DivisionArgs {
    /// The options.
    pub(super) fn options(&self) -> Result<Options, Failure> {
        let (zero, one) = (Rational::from(Int::ZERO), Rational::from(Int::from(1)));
        let share = |name: &str, text: &Option<String>, low: &Rational, high: Option<&Rational>| {
            let Some(text) = text else { return Ok(None) };
            let value = parse_decimal(text)
                .map_err(|error| Failure::usage(format!("{name}: `{text}`: {error}")))?;
            if value < *low || value == zero || high.is_some_and(|high| value > *high) {
                let most = high.map_or(String::new(), |high| format!(" and at most {high}"));
                let least = if *low == zero { "above 0".into() } else { format!("at least {low}") };
                return Err(Failure::usage(format!("{name}: `{text}`: expected {least}{most}")));
            }
            Ok(Some(value))
        };
        Ok(Options {
            margin: Int::from(self.margin),
            obscuration: share("--obscuration", &self.obscuration, &zero, Some(&one))?,
            weights: Weights {
                coplanar: self.reward_coplanar,
                cut: self.charge_cut,
                imbalance: self.charge_imbalance,
                axial: self.reward_axial,
            },
            samples: self.samples as usize,
            largest_volume: share("--largest-volume", &self.largest_volume, &zero, Some(&one))?,
            largest_aspect: share("--largest-aspect", &self.largest_aspect, &one, None)?,
            portals: self.shape().0,
        })
    }

    /// What becomes a portal, and its name.
    pub(super) fn shape(&self) -> (PortalShape, &'static str) {
        match self.portals {
            Shape::Exact => (PortalShape::Exact, "exact"),
            Shape::Merged => (PortalShape::Merged, "merged"),
            Shape::Hull => (PortalShape::Hull, "hull"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[derive(clap::Parser)]
    struct Only {
        #[command(flatten)]
        division: DivisionArgs,
    }

    #[test]
    fn the_defaults_of_the_command_are_those_of_the_library() {
        let only = Only::parse_from(["x"]);
        assert_eq!(only.division.options(), Ok(Options::default()));
    }
}
