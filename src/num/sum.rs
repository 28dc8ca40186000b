//! Long sums of ratios.

use super::Rational;
use num_traits::Zero;

/// The sum of ratios.
///
/// Neighbours are added first, then their sums: where denominators differ, so that the sum's has
/// about as many digits as all of them together, each number takes part in as many additions as
/// the logarithm of their count, not in all that come after it.
pub fn sum(terms: impl IntoIterator<Item = Rational>) -> Rational {
    let mut terms: Vec<Rational> = terms.into_iter().collect();
    while terms.len() > 1 {
        let pair = |pair: &[Rational]| match pair {
            [a, b] => a + b,
            rest => rest.iter().sum(),
        };
        terms = terms.chunks(2).map(pair).collect();
    }
    terms.pop().unwrap_or_else(Rational::zero)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_in_order() {
        for count in 0..20 {
            let terms: Vec<_> =
                (0..count).map(|i| Rational::new(i.into(), (i + 7).into())).collect();
            assert_eq!(sum(terms.clone()), terms.iter().sum());
        }
    }
}
