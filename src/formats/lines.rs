//! Four lines, `stabline-lines/1`: each by two points, numbers read exactly.

use super::json::Coordinate;
use crate::geom::BigLine;
use crate::num::Rational;
use schemars::JsonSchema;

/// The name of the format.
pub const LINES_FORMAT: &str = "stabline-lines/1";

/// Four lines.
#[derive(Clone, Debug, PartialEq, Eq, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "stabline-lines/1")]
pub struct LinesFile {
    /// The point of the example: what is special about the lines, and what must come out.
    #[serde(default)]
    pub about: Option<String>,
    /// The name of the format.
    #[schemars(regex(pattern = "^stabline-lines/1$"))]
    pub format: String,
    /// The lines, each by two distinct points.
    #[schemars(length(equal = 4))]
    pub lines: Vec<[[Coordinate; 3]; 2]>,
}

/// Why a text is not four lines.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LinesFileError {
    /// Not the JSON that the format asks for.
    #[error("line {line}, column {column}: {what}")]
    Json {
        /// The line, counted from 1.
        line: usize,
        /// The column, counted from 1.
        column: usize,
        /// The rule broken.
        what: String,
    },
    /// Another format, or another version.
    #[error("format: expected `{LINES_FORMAT}`, got `{0}`")]
    Format(String),
    /// Too few or too many lines.
    #[error("lines: expected 4, got {0}")]
    Count(usize),
    /// Two points that are one.
    #[error("lines[{0}]: its two points are the same, expected two distinct ones")]
    OnePoint(usize),
}

impl LinesFile {
    /// Reads four lines.
    ///
    /// # Errors
    /// [`LinesFileError`] names the place and the rule broken.
    pub fn read(bytes: &[u8]) -> Result<LinesFile, LinesFileError> {
        let file: LinesFile = serde_json::from_slice(bytes).map_err(|error| {
            let what = error.to_string();
            // serde_json ends its message with the place, which is kept apart here.
            let what = what.split(" at line ").next().unwrap_or_default().to_owned();
            LinesFileError::Json { line: error.line(), column: error.column(), what }
        })?;
        if file.format != LINES_FORMAT {
            return Err(LinesFileError::Format(file.format));
        }
        if file.lines.len() != 4 {
            return Err(LinesFileError::Count(file.lines.len()));
        }
        Ok(file)
    }

    /// The lines by their Plücker coordinates.
    ///
    /// # Errors
    /// [`LinesFileError::OnePoint`].
    pub fn lines(&self) -> Result<Vec<BigLine>, LinesFileError> {
        let point =
            |p: &[Coordinate; 3]| -> [Rational; 3] { [0, 1, 2].map(|i| p[i].0.to_rational()) };
        self.lines
            .iter()
            .enumerate()
            .map(|(index, [p, q])| {
                BigLine::through_rational(&point(p), &point(q))
                    .ok_or(LinesFileError::OnePoint(index))
            })
            .collect()
    }

    /// The JSON schema of the format.
    pub fn schema() -> serde_json::Value {
        schemars::schema_for!(LinesFile).to_value()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::num::Int;

    fn read(lines: &str) -> Result<LinesFile, LinesFileError> {
        let text = format!(r#"{{"format": "stabline-lines/1", "lines": {lines}}}"#);
        LinesFile::read(text.as_bytes())
    }

    const LINE: &str = "[[0,0,0],[1,0,0]]";

    #[test]
    fn numbers_keep_all_their_digits() {
        let first = r#"[["1/3",0.56285683454726874605620706,-2e-3],["7",1e2,0]]"#;
        let file = read(&format!("[{first},{LINE},{LINE},{LINE}]")).unwrap();
        let [p, q] = &file.lines[0];
        let digits: Int = "56285683454726874605620706".parse().unwrap();
        assert_eq!(p[0].0.to_rational(), Rational::new(Int::from(1), Int::from(3)));
        assert_eq!(p[1].0.to_rational(), Rational::new(digits, Int::from(10).pow(26)));
        assert_eq!(p[2].0.to_rational(), Rational::new(Int::from(-1), Int::from(500)));
        assert_eq!(q[1].0.to_rational(), Rational::from(Int::from(100)));
        assert_eq!(file.lines().unwrap().len(), 4);
    }

    #[test]
    fn errors_name_the_place_and_the_rule() {
        let message =
            |lines: &str| read(lines).and_then(|file| file.lines()).unwrap_err().to_string();
        assert_eq!(message(&format!("[{LINE},{LINE}]")), "lines: expected 4, got 2");
        let same = format!("[{LINE},{LINE},[[1,2,0.5],[1,2,\"1/2\"]],{LINE}]");
        assert_eq!(
            message(&same),
            "lines[2]: its two points are the same, expected two distinct ones"
        );
        for (bad, expected) in [
            ("[[[0,0,0],[1,0]]]", "invalid length 2, expected an array of length 3"),
            ("[[[0,0,0],[1,0,null]]]", "expected a number or a ratio in quotes, got `null`"),
            ("[[[0,0,0],[1,0,\"nan\"]]]", "coordinate `nan`: not a decimal number"),
            ("[[[0,0,0],[1,0,\"1/0\"]]]", "the denominator is zero"),
            ("[[[0,0,0],[1,0,1e9999]]]", "the exponent is larger than 4096"),
            ("7", "invalid type: integer `7`"),
        ] {
            let got = message(bad);
            assert!(got.contains(expected) && got.starts_with("line 1, column "), "{got}");
        }
        let other = LinesFile::read(br#"{"format": "x/1", "lines": []}"#).unwrap_err();
        assert_eq!(other.to_string(), "format: expected `stabline-lines/1`, got `x/1`");
        assert!(LinesFile::read(b"").is_err());
    }
}
