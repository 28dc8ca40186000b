//! The engine's quadric certificates in the words of the check.

use crate::forge::check::{Form, Refutation};
use crate::num::Int;
use crate::stab::{Condition, Factor, Product, QuadricProof};

/// The same proof; `None` if it names an order of portals, which is not asked of a bare sequence.
pub(super) fn proof_of(proof: &QuadricProof) -> Option<Refutation> {
    Some(match proof {
        QuadricProof::Identity { multiple, products } => {
            let product = |Product { factors: [a, b], weight }: &Product| {
                Some(([form_of(a)?, form_of(b)?], weight.clone()))
            };
            let products = products.iter().map(product).collect::<Option<Vec<_>>>()?;
            Refutation::Identity { multiple: multiple.clone(), products }
        }
        QuadricProof::Linear { terms } => {
            let term = |(factor, weight): &(Factor, Int)| Some((form_of(factor)?, weight.clone()));
            Refutation::Linear { terms: terms.iter().map(term).collect::<Option<Vec<_>>>()? }
        }
        QuadricProof::Split { plane, positive, negative } => Refutation::Split {
            plane: plane.clone(),
            halves: Box::new([proof_of(positive)?, proof_of(negative)?]),
        },
    })
}

fn form_of(factor: &Factor) -> Option<Form> {
    match factor {
        Factor::Condition(Condition::Edge(name)) => Some(Form::Edge(name.portal, name.edge)),
        Factor::Condition(Condition::Order { .. }) => None,
        Factor::Split(depth) => Some(Form::Split(*depth)),
    }
}
