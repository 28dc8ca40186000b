//! Every operation against unbounded integers, on random and on extreme numbers.

use super::*;
use num_integer::Integer;
use num_traits::Signed;
use proptest::prelude::*;

/// Limbs that are often all zeros or all ones, where carries run the whole way.
fn wide<const L: usize>() -> impl Strategy<Value = Wide<L>> {
    let limb = prop_oneof![
        any::<u64>(),
        Just(0u64),
        Just(u64::MAX),
        Just(1u64),
        Just(1u64 << 63),
        0u64..100
    ];
    (prop::array::uniform8(limb), any::<bool>()).prop_map(|(limbs, small)| {
        let number = Wide { limbs: std::array::from_fn(|i| limbs[i]) };
        if small { number.shifted(64 * (L as u32 - 1)) } else { number }
    })
}

impl<const L: usize> Wide<L> {
    /// Divided by `2^count`, through the unbounded type.
    fn shifted(&self, count: u32) -> Wide<L> {
        Wide::from_int(&(self.to_int() >> count)).unwrap()
    }
}

fn least<const L: usize>() -> Int {
    -(Int::from(1) << (64 * L - 1))
}

fn fits<const L: usize>(value: &Int) -> bool {
    *value >= least::<L>() && *value < -least::<L>()
}

fn check_pair<const L: usize>(a: &Wide<L>, b: &Wide<L>) {
    let (big_a, big_b) = (a.to_int(), b.to_int());
    assert_eq!(Wide::<L>::from_int(&big_a), Some(*a));
    assert_eq!(a.cmp(b), big_a.cmp(&big_b));
    assert_eq!(a.sign(), Sign::of(&big_a));
    assert_eq!(a.checked_add(b).map(|s| s.to_int()), Some(&big_a + &big_b).filter(fits::<L>));
    assert_eq!(a.checked_sub(b).map(|s| s.to_int()), Some(&big_a - &big_b).filter(fits::<L>));
    assert_eq!(a.checked_times(b).map(|s| s.to_int()), Some(&big_a * &big_b).filter(fits::<L>));
    assert_eq!(a.times::<L, 16>(b).to_int(), &big_a * &big_b);
    let n = a.bits();
    assert!(big_a >= -(Int::from(1) << n) && big_a < Int::from(1) << n);
    assert!(n == 0 || big_a < -(Int::from(1) << (n - 1)) || big_a >= Int::from(1) << (n - 1));
    assert_eq!(a.narrow::<2>().map(|s| s.to_int()), Some(big_a.clone()).filter(fits::<2>));
    assert_eq!(a.widen::<9>().to_int(), big_a);
    if a.to_int() > least::<L>() && b.to_int() > least::<L>() {
        let gcd = a.gcd(b);
        assert_eq!(gcd.to_int(), big_a.gcd(&big_b));
        assert_eq!(a.abs().to_int(), big_a.abs());
        if !gcd.is_zero() {
            assert_eq!(a.exact_quotient(&gcd).to_int(), big_a / gcd.to_int());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn three_limbs_agree_with_unbounded_integers(a in wide::<3>(), b in wide::<3>()) {
        check_pair(&a, &b);
    }

    #[test]
    fn four_limbs_agree_with_unbounded_integers(a in wide::<4>(), b in wide::<4>()) {
        check_pair(&a, &b);
    }

    #[test]
    fn five_limbs_agree_with_unbounded_integers(a in wide::<5>(), b in wide::<5>()) {
        check_pair(&a, &b);
    }

    #[test]
    fn eight_limbs_agree_with_unbounded_integers(a in wide::<8>(), b in wide::<8>()) {
        check_pair(&a, &b);
    }

    #[test]
    fn products_of_native_integers_are_exact(a: i128, b: i128, c: i64) {
        let product = Int256::product(a, b);
        prop_assert_eq!(product.to_int(), Int::from(a) * b);
        prop_assert_eq!(product.widen::<5>().times_i64(c).to_int(), Int::from(a) * b * c);
        prop_assert_eq!(Int256::from(c).times_i128(a).to_int(), Int::from(a) * c);
        prop_assert_eq!(Int192::from(a).to_i128(), Some(a));
        prop_assert_eq!(Int192::from(c).to_i128(), Some(i128::from(c)));
    }

    #[test]
    fn quotients_are_exact_for_every_sign(a: i128, b: i128, c: i64) {
        prop_assume!(b != 0 && c != 0);
        let product = Int320::product(a, b).times_i64(c);
        prop_assert_eq!(product.exact_quotient(&Int320::from(b)), Int320::from(a).times_i64(c));
        prop_assert_eq!(product.exact_quotient(&Int320::from(c)), Int320::product(a, b));
    }
}

#[test]
fn extremes_are_held_and_what_exceeds_them_is_refused() {
    let least = least::<4>();
    let greatest: Int = -&least - 1;
    for value in [&least, &greatest] {
        assert_eq!(Int256::from_int(value).map(|w| w.to_int()).as_ref(), Some(value));
    }
    for value in [&least - 1, &greatest + 1, &least * 4, &greatest * 1000] {
        assert_eq!(Int256::from_int(&value), None);
    }
    for (a, b) in [(i128::MIN, i128::MIN), (i128::MIN, i128::MAX), (i128::MAX, i128::MAX)] {
        assert_eq!(Int256::product(a, b).to_int(), Int::from(a) * b);
    }
    let greatest = Int256::from_int(&greatest).unwrap();
    assert_eq!(greatest.checked_add(&Int256::from(1i64)), None);
    assert_eq!((-greatest).checked_sub(&Int256::from(2i64)), None);
    assert_eq!(Int256::ZERO.gcd(&Int256::ZERO), Int256::ZERO);
    assert_eq!(Int256::ZERO.gcd(&Int256::from(-6i64)), Int256::from(6i64));
}
