//! JSON values in which no number has lost a digit.
//!
//! A [`Value`] keeps numbers as 64-bit integers or as floats, and other readers of JSON all of them
//! as floats. What is no integer below 2^53 becomes a string here, which every coordinate may be as
//! well.

use serde::de::Error;
use serde::{Deserialize, Deserializer};
use serde_json::value::{RawValue, Value};
use std::collections::BTreeMap;

/// Values may be nested this deep, as in `serde_json`.
const DEEPEST: usize = 128;

/// Reads a value; numbers but integers below 2^53 are strings in it, as they were written.
///
/// Complexity: the text's length times the depth.
///
/// # Errors
/// That of the syntax, and a value that is nested more than 128 deep.
pub fn read_exact(text: &str) -> serde_json::Result<Value> {
    within(serde_json::from_str(text)?, DEEPEST)
}

/// The same for a field of a type that is deserialized: `#[serde(deserialize_with)]`.
///
/// # Errors
/// As [`read_exact`].
pub fn exact<'de, D: Deserializer<'de>>(from: D) -> Result<Value, D::Error> {
    let raw = Box::<RawValue>::deserialize(from)?;
    within(&raw, DEEPEST).map_err(D::Error::custom)
}

/// The same for a field that may be missing.
///
/// # Errors
/// As [`read_exact`].
pub fn exact_if_any<'de, D: Deserializer<'de>>(from: D) -> Result<Option<Value>, D::Error> {
    let raw = Option::<Box<RawValue>>::deserialize(from)?;
    raw.map(|raw| within(&raw, DEEPEST)).transpose().map_err(D::Error::custom)
}

fn within(raw: &RawValue, depth: usize) -> serde_json::Result<Value> {
    let deeper = || depth.checked_sub(1).ok_or_else(|| Error::custom("nested too deep"));
    let text = raw.get();
    match text.as_bytes().first() {
        Some(b'{') => {
            let fields: BTreeMap<String, &RawValue> = serde_json::from_str(text)?;
            let depth = deeper()?;
            fields.into_iter().map(|(name, raw)| Ok((name, within(raw, depth)?))).collect()
        }
        Some(b'[') => {
            let items: Vec<&RawValue> = serde_json::from_str(text)?;
            let depth = deeper()?;
            items.into_iter().map(|raw| within(raw, depth)).collect()
        }
        Some(b'-' | b'0'..=b'9') => Ok(number(text)),
        _ => serde_json::from_str(text),
    }
}

fn number(text: &str) -> Value {
    match text.parse::<i64>() {
        // Of "-0" an integer would lose the sign.
        Ok(small) if small.unsigned_abs() < 1 << 53 && small.to_string() == text => small.into(),
        Ok(_) | Err(_) => text.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn numbers_keep_their_digits() {
        for (text, value) in [
            ("7", json!(7)),
            ("-18446744073709551615", json!("-18446744073709551615")),
            ("9007199254740991", json!(9_007_199_254_740_991_u64)),
            ("9007199254740992", json!("9007199254740992")),
            ("-0", json!("-0")),
            ("0.10", json!("0.10")),
            ("0.1000000000000000000001", json!("0.1000000000000000000001")),
            ("1e400", json!("1e400")),
            ("25e-2", json!("25e-2")),
        ] {
            assert_eq!(read_exact(text).unwrap(), value, "{text}");
            let nested = format!(" {{\"a\" : [ null, {text} ,\"7\"] }} ");
            assert_eq!(read_exact(&nested).unwrap(), json!({"a": [null, value, "7"]}), "{text}");
        }
        // What reads the values again finds the same.
        let again = read_exact(&read_exact("[1e400, 0.30]").unwrap().to_string()).unwrap();
        assert_eq!(again, json!(["1e400", "0.30"]));
    }

    #[test]
    fn no_value_is_an_error_and_depth_has_an_end() {
        for bad in ["", "[1", "{1: 2}", "01", "1 2", "[1,]"] {
            assert!(read_exact(bad).is_err(), "{bad}");
        }
        let nested = |depth: usize| ["[".repeat(depth), "]".repeat(depth)].concat();
        assert!(read_exact(&nested(100)).is_ok());
        assert!(read_exact(&nested(1000)).is_err());
        assert!(read_exact(&nested(100_000)).is_err());
    }
}
