//! Certificates of sequences that are not open, as JSON and as text.

use super::{Integer, integer};
use crate::num::Int;
use crate::stab::hourglass::{End, EndTerm};
use crate::stab::{Certificate, Condition, Factor, Product, QuadricProof};
use schemars::JsonSchema;
use serde::Serialize;

/// Why a sequence is not open.
#[derive(Serialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub(super) enum CertificateReport {
    /// The weighted sum of the conditions' vectors is zero.
    Gordan { terms: Vec<TermReport> },
    /// Products of the conditions' sides add up to a multiple of the Klein form, if need be in
    /// parts.
    Quadric {
        /// All vectors are those of the coordinates times this.
        denominator: Integer,
        proof: ProofReport,
    },
}

/// A condition and its weight.
#[derive(Serialize, JsonSchema)]
pub(super) struct TermReport {
    portal: usize,
    #[serde(flatten)]
    what: ConditionReport,
    weight: Integer,
}

/// What a line has to do at a portal.
#[derive(Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum ConditionReport {
    /// Pass this edge on its positive side: it runs from this vertex to the next.
    Edge(usize),
    /// Cross this portal after that one.
    After(usize),
    /// In the plane: leave this end on its side.
    End(EndName),
}

/// One end of a segment, as the line sees it.
#[derive(Clone, Copy, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum EndName {
    Left,
    Right,
}

/// Why no line is strictly inside a sequence, or inside a part that enclosing splits leave.
#[derive(Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub(super) enum ProofReport {
    /// The weighted sum of the products is the multiple of the form.
    Identity { multiple: Integer, products: Vec<ProductReport> },
    /// The weighted sum of the vectors is zero.
    Linear { terms: Vec<WeightedReport> },
    /// The vectors on either side of a plane have a proof of their own.
    Split { plane: PlaneReport, positive: Box<ProofReport>, negative: Box<ProofReport> },
}

/// Two factors and their weight.
#[derive(Serialize, JsonSchema)]
pub(super) struct ProductReport {
    factors: [FactorReport; 2],
    weight: Integer,
}

/// A factor and its weight.
#[derive(Serialize, JsonSchema)]
pub(super) struct WeightedReport {
    factor: FactorReport,
    weight: Integer,
}

/// A vector that is not negative on the part.
#[derive(Serialize, JsonSchema)]
#[serde(untagged)]
pub(super) enum FactorReport {
    /// That of a condition.
    Condition {
        portal: usize,
        #[serde(flatten)]
        what: ConditionReport,
    },
    /// The plane of an enclosing split, the outermost being 0; its opposite in the negative part.
    Split { split: usize },
}

/// A vector h: the sides are side(x, h) >= 0 and <= 0.
#[derive(Serialize, JsonSchema)]
pub(super) struct PlaneReport {
    direction: [Integer; 3],
    moment: [Integer; 3],
}

impl CertificateReport {
    /// Of a sequence in space, on a grid of this denominator.
    pub(super) fn new(certificate: &Certificate, denominator: &Int) -> CertificateReport {
        match certificate {
            Certificate::Gordan(terms) => CertificateReport::Gordan {
                terms: terms
                    .iter()
                    .map(|term| {
                        let (portal, what) = condition(&term.condition);
                        TermReport { portal, what, weight: integer(&term.weight) }
                    })
                    .collect(),
            },
            Certificate::Quadric(proof) => CertificateReport::Quadric {
                denominator: integer(denominator),
                proof: ProofReport::new(proof),
            },
        }
    }

    /// Of a sequence in the plane.
    pub(super) fn of_plane(terms: &[EndTerm]) -> CertificateReport {
        let term = |term: &EndTerm| {
            let end = match term.end {
                End::Left => EndName::Left,
                End::Right => EndName::Right,
            };
            let what = ConditionReport::End(end);
            TermReport { portal: term.portal, what, weight: integer(&term.weight) }
        };
        CertificateReport::Gordan { terms: terms.iter().map(term).collect() }
    }

    /// One fact a line.
    pub(super) fn text(&self) -> String {
        match self {
            CertificateReport::Gordan { terms } => {
                let term = |term: &TermReport| {
                    let what = condition_text(term.portal, &term.what);
                    format!("gordan {} x {what}\n", integer_text(&term.weight))
                };
                terms.iter().map(term).collect()
            }
            CertificateReport::Quadric { denominator, proof } => {
                let mut text = String::new();
                if !matches!(denominator, Integer::Small(1)) {
                    let denominator = integer_text(denominator);
                    text.push_str(&format!("quadric of the coordinates times {denominator}\n"));
                }
                proof.push_text(&mut text);
                text
            }
        }
    }
}

impl ProofReport {
    fn new(proof: &QuadricProof) -> ProofReport {
        match proof {
            QuadricProof::Identity { multiple, products } => {
                let product = |Product { factors, weight }: &Product| ProductReport {
                    factors: factors.map(|factor| FactorReport::new(&factor)),
                    weight: integer(weight),
                };
                ProofReport::Identity {
                    multiple: integer(multiple),
                    products: products.iter().map(product).collect(),
                }
            }
            QuadricProof::Linear { terms } => {
                let term = |(factor, weight): &(Factor, Int)| WeightedReport {
                    factor: FactorReport::new(factor),
                    weight: integer(weight),
                };
                ProofReport::Linear { terms: terms.iter().map(term).collect() }
            }
            QuadricProof::Split { plane: [a, b, c, d, e, f], positive, negative } => {
                ProofReport::Split {
                    plane: PlaneReport {
                        direction: [a, b, c].map(integer),
                        moment: [d, e, f].map(integer),
                    },
                    positive: Box::new(ProofReport::new(positive)),
                    negative: Box::new(ProofReport::new(negative)),
                }
            }
        }
    }

    fn push_text(&self, text: &mut String) {
        match self {
            ProofReport::Identity { multiple, products } => {
                text.push_str(&format!("quadric {} x Q\n", integer_text(multiple)));
                for ProductReport { factors, weight } in products {
                    let [f, g] = factors.each_ref().map(FactorReport::text);
                    text.push_str(&format!("  = {} x {f} x {g}\n", integer_text(weight)));
                }
            }
            ProofReport::Linear { terms } => {
                text.push_str("linear\n");
                for WeightedReport { factor, weight } in terms {
                    text.push_str(&format!("  {} x {}\n", integer_text(weight), factor.text()));
                }
            }
            ProofReport::Split { plane, positive, negative } => {
                let list = |numbers: &[Integer; 3]| numbers.each_ref().map(integer_text).join(", ");
                let (direction, moment) = (list(&plane.direction), list(&plane.moment));
                text.push_str(&format!("split by ({direction}; {moment}), positive\n"));
                positive.push_text(text);
                text.push_str("split, negative\n");
                negative.push_text(text);
            }
        }
    }
}

impl FactorReport {
    fn new(factor: &Factor) -> FactorReport {
        match factor {
            Factor::Condition(of) => {
                let (portal, what) = condition(of);
                FactorReport::Condition { portal, what }
            }
            Factor::Split(split) => FactorReport::Split { split: *split },
        }
    }

    fn text(&self) -> String {
        match self {
            FactorReport::Condition { portal, what } => condition_text(*portal, what),
            FactorReport::Split { split } => format!("split {split}"),
        }
    }
}

fn condition(condition: &Condition) -> (usize, ConditionReport) {
    match condition {
        Condition::Edge(name) => (name.portal, ConditionReport::Edge(name.edge)),
        Condition::Order { portal } => (*portal, ConditionReport::After(portal - 1)),
    }
}

fn condition_text(portal: usize, what: &ConditionReport) -> String {
    match what {
        ConditionReport::Edge(edge) => format!("edge {portal}.{edge}"),
        ConditionReport::After(before) => format!("portal {portal} after {before}"),
        ConditionReport::End(EndName::Left) => format!("left end {portal}"),
        ConditionReport::End(EndName::Right) => format!("right end {portal}"),
    }
}

fn integer_text(value: &Integer) -> String {
    match value {
        Integer::Small(value) => value.to_string(),
        Integer::Large(value) => value.clone(),
    }
}
