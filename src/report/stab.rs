//! The verdict of a portal sequence, as canonical text and as `stabline-stab/1`.
//!
//! All coordinates are those of the input file: grid units divided by the denominator.

mod certificate;

use crate::geom::BigPoint2;
use crate::num::{Int, Rational, Surd};
use crate::stab::hourglass::PlaneVerdict;
use crate::stab::{Certificate, ExtremalLine, StabLine, Verdict, Witness};
use certificate::CertificateReport;
use num_traits::ToPrimitive;
use schemars::JsonSchema;
use serde::Serialize;

/// What is true of a portal sequence.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "stabline-stab/1")]
pub struct StabReport {
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-stab/1$"))]
    format: &'static str,
    verdict: VerdictName,
    /// Two points of a line strictly inside every portal, in its direction, where there is one.
    witness: Option<[Vec<Ratio>; 2]>,
    /// Two points of a line that meets every closed portal, for a grazing sequence.
    touching_line: Option<[Vec<Number>; 2]>,
    /// Why the sequence is not open.
    certificate: Option<CertificateReport>,
    /// How many extremal stabbing lines there are; not counted in the plane.
    extremal_lines: Option<usize>,
    /// The extremal stabbing lines, where they were asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    lines: Option<Vec<LineReport>>,
}

/// One of the three verdicts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
enum VerdictName {
    Open,
    Grazing,
    Blocked,
}

/// A rational number `p` or `p/q` in lowest terms with q > 1.
#[derive(Serialize, JsonSchema)]
#[serde(transparent)]
struct Ratio(#[schemars(regex(pattern = "^-?[0-9]+(/[1-9][0-9]*)?$"))] String);

/// The number a + b√d; b and d are zero for a rational number.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Surd")]
struct Number {
    a: Ratio,
    b: Ratio,
    #[schemars(regex(pattern = "^[0-9]+$"))]
    d: String,
}

/// An integer: as a string where it does not fit in 53 bits.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
enum Integer {
    Small(i64),
    Large(#[schemars(regex(pattern = "^-?[0-9]+$"))] String),
}

/// An extremal stabbing line.
#[derive(Serialize, JsonSchema)]
struct LineReport {
    /// The edges whose supporting lines it meets.
    edges: Vec<EdgeReport>,
    /// Two of its points, in its direction.
    points: [Vec<Number>; 2],
}

/// An edge: it runs from this vertex of the portal to the next.
#[derive(Serialize, JsonSchema)]
struct EdgeReport {
    portal: usize,
    edge: usize,
}

impl StabReport {
    /// The report of a sequence in space on a grid of this denominator. `list` asks for the lines
    /// themselves, not only for their number.
    pub fn new(
        verdict: &Verdict,
        lines: &[ExtremalLine],
        denominator: &Int,
        list: bool,
    ) -> StabReport {
        let certificate = |c: &Certificate| Some(CertificateReport::new(c, denominator));
        let (name, witness, touching_line, certificate) = match verdict {
            Verdict::Open { witness } => (VerdictName::Open, Some(witness), None, None),
            Verdict::Grazing { touching_line, certificate: c } => {
                (VerdictName::Grazing, None, Some(touching_line), certificate(c))
            }
            Verdict::Blocked { certificate: c } => {
                (VerdictName::Blocked, None, None, certificate(c))
            }
        };
        StabReport {
            format: "stabline-stab/1",
            verdict: name,
            witness: witness.map(|w| world_ratios(w, denominator)),
            touching_line: touching_line.map(|line| world_numbers(line, denominator)),
            certificate,
            extremal_lines: Some(lines.len()),
            lines: list.then(|| lines.iter().map(|line| line_report(line, denominator)).collect()),
        }
    }

    /// The report of a sequence of segments in the plane.
    pub fn of_plane(verdict: &PlaneVerdict, denominator: &Int) -> StabReport {
        let ratio = |c: &Rational| Ratio((c / denominator).to_string());
        let number = |c: &Int| number(&Surd::from(Rational::new(c.clone(), denominator.clone())));
        let line = |points: &[BigPoint2; 2]| {
            points.each_ref().map(|p| p.coordinates.iter().map(number).collect())
        };
        let terms = CertificateReport::of_plane;
        let (verdict, witness, touching_line, certificate) = match verdict {
            PlaneVerdict::Open(witness) => {
                let points = witness.points.each_ref().map(|p| p.iter().map(ratio).collect());
                (VerdictName::Open, Some(points), None, None)
            }
            PlaneVerdict::Grazing { touching_line, certificate } => {
                (VerdictName::Grazing, None, Some(line(touching_line)), Some(terms(certificate)))
            }
            PlaneVerdict::Blocked { certificate } => {
                (VerdictName::Blocked, None, None, Some(terms(certificate)))
            }
        };
        StabReport {
            format: "stabline-stab/1",
            verdict,
            witness,
            touching_line,
            certificate,
            extremal_lines: None,
            lines: None,
        }
    }

    /// The canonical JSON text.
    ///
    /// # Panics
    /// Never: all keys are strings and all values finite.
    pub fn to_json(&self) -> String {
        let text = serde_json::to_string_pretty(self).expect("strings and small integers only");
        format!("{text}\n")
    }

    /// The canonical text: one fact a line.
    pub fn to_text(&self) -> String {
        let mut text = String::new();
        text.push_str(match self.verdict {
            VerdictName::Open => "open\n",
            VerdictName::Grazing => "grazing\n",
            VerdictName::Blocked => "blocked\n",
        });
        if let Some([p, q]) = &self.witness {
            text.push_str(&format!("witness {} -> {}\n", ratios_text(p), ratios_text(q)));
        }
        if let Some(points) = &self.touching_line {
            text.push_str(&format!("touching line {}\n", points_text(points)));
        }
        if let Some(certificate) = &self.certificate {
            text.push_str(&certificate.text());
        }
        if let Some(count) = self.extremal_lines {
            text.push_str(&format!("extremal lines {count}\n"));
        }
        for line in self.lines.iter().flatten() {
            let edges = line.edges.iter().map(|e| format!("{}.{}", e.portal, e.edge));
            let edges = edges.collect::<Vec<_>>().join(" ");
            text.push_str(&format!("line {} touches {edges}\n", points_text(&line.points)));
        }
        text
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(StabReport).to_value()
    }
}

fn world_ratios(witness: &Witness, denominator: &Int) -> [Vec<Ratio>; 2] {
    let ratio = |c: &Rational| Ratio((c / denominator).to_string());
    witness.points.each_ref().map(|point| point.iter().map(ratio).collect())
}

fn world_numbers(line: &StabLine, denominator: &Int) -> [Vec<Number>; 2] {
    let unit = Surd::from(denominator.clone());
    line.points.each_ref().map(|point| point.iter().map(|c| number(&(c / &unit))).collect())
}

fn number(value: &Surd) -> Number {
    Number {
        a: Ratio(value.rational_part().to_string()),
        b: Ratio(value.root_part().to_string()),
        d: value.radicand().to_string(),
    }
}

/// The number a + b√d in JSON, as `stabline-stab/1` has it.
///
/// # Panics
/// Never: it is three strings.
pub fn surd_value(value: &Surd) -> serde_json::Value {
    serde_json::to_value(number(value)).expect("three strings")
}

fn integer(value: &Int) -> Integer {
    match value.to_i64() {
        Some(small) if small.unsigned_abs() < 1 << 53 => Integer::Small(small),
        _ => Integer::Large(value.to_string()),
    }
}

fn line_report(line: &ExtremalLine, denominator: &Int) -> LineReport {
    let edges = line.edges.iter().map(|e| EdgeReport { portal: e.portal, edge: e.edge });
    LineReport { edges: edges.collect(), points: world_numbers(&line.line, denominator) }
}

fn ratios_text(point: &[Ratio]) -> String {
    let coordinates: Vec<&str> = point.iter().map(|c| c.0.as_str()).collect();
    format!("({})", coordinates.join(", "))
}

fn points_text([p, q]: &[Vec<Number>; 2]) -> String {
    let coordinate = |c: &Number| match (c.a.0.as_str(), c.b.0.as_str()) {
        (a, "0") => a.to_owned(),
        ("0", b) => format!("{b}√{}", c.d),
        (a, b) if b.starts_with('-') => format!("{a} - {}√{}", &b[1..], c.d),
        (a, b) => format!("{a} + {b}√{}", c.d),
    };
    let point = |p: &[Number]| p.iter().map(coordinate).collect::<Vec<_>>().join(", ");
    format!("({}) -> ({})", point(p), point(q))
}
