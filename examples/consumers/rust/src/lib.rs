//! Loads test vectors (`stabline-vectors/1`). Replace `sees` in `tests/vectors.rs` by your own.

use serde_json::Value;

/// A case of kind `sequence`.
pub struct Sequence {
    /// Its number in the file.
    pub tc_id: u64,
    /// What it is about.
    pub comment: String,
    /// What is degenerate.
    pub flags: Vec<String>,
    /// Its portals, by their vertices. Nearest doubles; the texts are exact.
    pub portals: Vec<Vec<Vec<f64>>>,
    /// `open`, `grazing` or `blocked`.
    pub class: String,
}

/// A coordinate: an integer, or a string such as `"7/3"`.
pub fn number(value: &Value) -> f64 {
    let text = value.as_str().map_or_else(|| value.to_string(), str::to_owned);
    let (p, q) = text.split_once('/').unwrap_or((&text, "1"));
    p.parse::<f64>().expect("a number") / q.parse::<f64>().expect("a number")
}

/// The sequences of a file.
pub fn sequences(text: &str) -> Vec<Sequence> {
    let file: Value = serde_json::from_str(text).expect("JSON");
    assert_eq!(file["format"], "stabline-vectors/1");
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let words = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let groups = list(&file["groups"]);
    let groups = groups.iter().filter(|group| group["kind"] == "sequence");
    let tests = groups.flat_map(|group| list(&group["tests"]));
    tests
        .map(|test| Sequence {
            tc_id: test["tcId"].as_u64().unwrap_or_default(),
            comment: words(&test["comment"]),
            flags: list(&test["flags"]).iter().map(words).collect(),
            portals: list(&test["input"]["portals"])
                .iter()
                .map(|portal| {
                    let points = list(portal);
                    points.iter().map(|p| list(p).iter().map(number).collect()).collect()
                })
                .collect(),
            class: words(&test["class"]),
        })
        .collect()
}
