use super::*;

fn int(value: i64) -> Int {
    Int::from(value)
}

fn surd(a: (i64, i64), b: (i64, i64), d: i64) -> Surd {
    Surd::new(Rational::new(int(a.0), int(a.1)), Rational::new(int(b.0), int(b.1)), int(d))
}

#[test]
fn signs_with_one_radicand_follow_their_laws() {
    for a in -6i64..=6 {
        for b in -4i64..=4 {
            for d in 0i64..=9 {
                let sign = sign_of_surd(&int(a), &int(b), &int(d));
                let sum = a as f64 + b as f64 * (d as f64).sqrt();
                // On these small numbers a float errs by far less than 1e-9, and a value that is
                // not zero is at least 1/40 away from it.
                let expected = if sum.abs() < 1e-9 { Sign::Zero } else { Sign::of(&sum) };
                assert_eq!(sign, expected, "{a} + {b}√{d}");
                assert_eq!(sign_of_surd(&int(-a), &int(-b), &int(d)), -sign);
                assert_eq!(sign_of_surd(&int(3 * a), &int(3 * b), &int(d)), sign);
                assert_eq!(sign_of_surd(&int(a), &int(b), &int(d)), sign);
                assert_eq!(sign_of_surd(&int(2 * a), &int(b), &int(4 * d)), sign);
            }
        }
    }
}

#[test]
fn signs_with_two_radicands_follow_their_laws() {
    for a in -5i64..=5 {
        for b in -2i64..=2 {
            for c in -2i64..=2 {
                for (d, e) in [(2, 3), (2, 8), (0, 5), (7, 7), (4, 9), (5, 6)] {
                    let sign = |s: i64, k: i64| {
                        sign_of_two_surds(
                            &int(s * k * a),
                            &int(s * k * b),
                            &int(d),
                            &int(s * k * c),
                            &int(e),
                        )
                    };
                    let sum =
                        a as f64 + b as f64 * (d as f64).sqrt() + c as f64 * (e as f64).sqrt();
                    let expected = if sum.abs() < 1e-9 { Sign::Zero } else { Sign::of(&sum) };
                    assert_eq!(sign(1, 1), expected, "{a} + {b}√{d} + {c}√{e}");
                    assert_eq!(sign(-1, 1), -expected);
                    assert_eq!(sign(1, 7), expected);
                    assert_eq!(
                        sign_of_two_surds(&int(a), &int(c), &int(e), &int(b), &int(d)),
                        expected
                    );
                }
            }
        }
    }
}

#[test]
fn near_ties_are_told_apart() {
    // √2 + √3 against its 40-digit decimal, off by less than 1e-39: only exact arithmetic sees it.
    let digits: Int = "31462643699419723423291350657155704455124".parse().unwrap();
    let scale = Int::from(10).pow(40);
    let below = sign_of_two_surds(&-&digits, &scale, &int(2), &scale, &int(3));
    let next: Int = digits + 1;
    let above = sign_of_two_surds(&-next, &scale, &int(2), &scale, &int(3));
    assert_eq!((below, above), (Sign::Positive, Sign::Negative));
}

#[test]
fn the_canonical_form_takes_squares_out() {
    assert!(surd((1, 2), (3, 1), 49).is_rational());
    assert_eq!(surd((1, 2), (3, 1), 49), surd((43, 2), (0, 1), 0));
    assert_eq!(surd((0, 1), (1, 1), 72).radicand(), &int(2));
    assert_eq!(surd((0, 1), (1, 1), 72).root_part(), &Rational::from(int(6)));
    // 101² is beyond the small primes: the parts differ, the numbers do not.
    let large = surd((0, 1), (1, 1), 101 * 101 * 2);
    assert_eq!(large, surd((0, 1), (101, 1), 2));
    assert!((&large - &surd((0, 1), (101, 1), 2)).is_zero());
    assert!(large.shares_field_with(&surd((1, 1), (1, 1), 2)));
    assert!(!large.shares_field_with(&surd((1, 1), (1, 1), 3)));
}

#[test]
fn arithmetic_obeys_the_laws_of_a_field() {
    let samples = [
        surd((1, 2), (1, 3), 5),
        surd((-7, 3), (2, 1), 5),
        surd((0, 1), (-1, 1), 20),
        surd((4, 1), (0, 1), 0),
    ];
    for x in &samples {
        for y in &samples {
            assert_eq!(&(x + y) - y, *x);
            assert_eq!(&(x * y) / y, *x);
            assert_eq!(x * y, y * x);
            assert_eq!((x - y).sign(), Sign::from(x.cmp(y)));
            for z in &samples {
                assert_eq!(&(x + y) * z, &(x * z) + &(y * z));
            }
        }
    }
}

#[test]
#[should_panic(expected = "different fields")]
fn arithmetic_across_fields_is_refused() {
    let _ = &surd((0, 1), (1, 1), 2) + &surd((0, 1), (1, 1), 3);
}

#[test]
fn floors_and_rationals_between() {
    assert_eq!(surd((0, 1), (1, 1), 2).floor(), int(1));
    assert_eq!(surd((0, 1), (-1, 1), 2).floor(), int(-2));
    assert_eq!(surd((7, 2), (-5, 3), 11).floor(), int(-3));
    assert_eq!(surd((-7, 2), (0, 1), 0).floor(), int(-4));
    let between = Surd::rational_between(&surd((0, 1), (1, 1), 2), &surd((0, 1), (1, 1), 3));
    assert_eq!(between, Rational::new(int(3), int(2)));
    let close =
        Surd::rational_between(&surd((0, 1), (1, 1), 1_000_000), &surd((0, 1), (1, 1), 1_000_001));
    assert!(Surd::from(close.clone()) > surd((1000, 1), (0, 1), 0));
    assert!(Surd::from(close) < surd((0, 1), (1, 1), 1_000_001));
}

#[test]
fn quadratics_have_their_roots_in_order() {
    let roots = |c0, c1, c2| Surd::roots_of_quadratic(&int(c0), &int(c1), &int(c2));
    assert_eq!(roots(6, -5, 1), Some([Surd::from(int(2)), Surd::from(int(3))]));
    assert_eq!(roots(-6, 5, -1), Some([Surd::from(int(2)), Surd::from(int(3))]));
    assert_eq!(roots(1, 2, 1), Some([Surd::from(int(-1)), Surd::from(int(-1))]));
    assert_eq!(roots(1, 0, 1), None);
    for [c0, c1, c2] in [[-2, 1, 3], [-3, 7, -1], [2, -8, 5]] {
        let [low, high] = roots(c0, c1, c2).unwrap();
        assert!(low < high);
        for x in [low, high] {
            let value = &(&(&x * &x) * &Surd::from(int(c2))) + &(&x * &Surd::from(int(c1)));
            assert_eq!(value, Surd::from(int(-c0)));
        }
    }
}

#[test]
fn text_shows_the_parts() {
    assert_eq!(surd((1, 2), (-3, 4), 7).to_string(), "1/2 - 3/4·√7");
    assert_eq!(surd((0, 1), (1, 1), 7).to_string(), "√7");
    assert_eq!(surd((5, 1), (1, 1), 4).to_string(), "7");
    assert!((surd((1, 1), (-1, 1), 2).approximate() + 0.414_213_562_373_095).abs() < 1e-14);
    assert_eq!(surd((0, 1), (0, 1), 0).approximate(), 0.0);
}
