//! The canonical text.

use super::{FORMAT, PairWitness, PvsReport};
use crate::num::Number;
use std::io::{self, Write};

/// Text is handed on in pieces of about this size.
const PIECE: usize = 1 << 16;

impl PvsReport {
    /// Writes the canonical text.
    ///
    /// # Errors
    /// Those of `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut text = Vec::with_capacity(PIECE + (PIECE >> 2));
        self.write_head(&mut text)?;
        for from in 0..self.matrix.size() {
            text.extend_from_slice(if from == 0 { b"\n\"" } else { b",\n\"" });
            text.extend(self.matrix.row(from).iter().map(|&verdict| b'0' + verdict as u8));
            text.push(b'"');
            hand_on(&mut text, out, PIECE)?;
        }
        text.extend_from_slice(b"],\n\"witnesses\": [");
        for (index, witness) in self.witnesses.iter().enumerate() {
            text.extend_from_slice(if index == 0 { b"\n" } else { b",\n" });
            push_witness(&mut text, witness)?;
            hand_on(&mut text, out, PIECE)?;
        }
        text.extend_from_slice(b"]}\n");
        hand_on(&mut text, out, 0)
    }

    fn write_head(&self, text: &mut Vec<u8>) -> io::Result<()> {
        let counts = self.matrix.counts();
        let classified = |count: u64| match self.grazing_classified {
            true => count.to_string(),
            false => "null".to_owned(),
        };
        write!(text, "{{\"format\": \"{FORMAT}\",\n\"program\": {},\n", quoted(&self.program)?)?;
        let (name, hash) = (quoted(&self.input.name)?, quoted(&self.input.blake3)?);
        writeln!(text, "\"input\": {{\"name\": {name}, \"blake3\": {hash}}},")?;
        let reading = match self.reading.is_empty() {
            true => String::new(),
            false => format!(", \"reading\": {}", quoted(&self.reading)?),
        };
        writeln!(text, "\"options\": {{\"grazing\": {}{reading}}},", self.grazing_classified)?;
        text.extend_from_slice(b"\"cells\": [");
        for (index, cell) in self.cells.iter().enumerate() {
            text.extend_from_slice(if index == 0 { b"" } else { b", " });
            text.extend_from_slice(quoted(cell)?.as_bytes());
        }
        text.extend_from_slice(b"],\n\"leaf_to_cell\": [");
        push_list(text, &self.leaf_to_cell);
        writeln!(text, "],\n\"skew_portals\": {},", self.skew_portals)?;
        let (grazing, blocked) = (classified(counts.grazing), classified(counts.not_open));
        writeln!(
            text,
            "\"counts\": {{\"open\": {}, \"grazing\": {grazing}, \"blocked\": {blocked}, \
             \"undecided\": {}, \"diagonal_included\": true}},",
            counts.open, counts.undecided
        )?;
        text.extend_from_slice(b"\"rows\": [");
        Ok(())
    }
}

/// Writes `text` to `out` and empties it, once it is longer than `limit`.
fn hand_on(text: &mut Vec<u8>, out: &mut dyn Write, limit: usize) -> io::Result<()> {
    if text.len() > limit {
        out.write_all(text)?;
        text.clear();
    }
    Ok(())
}

fn quoted(text: &str) -> io::Result<String> {
    Ok(serde_json::to_string(text)?)
}

fn push_witness(text: &mut Vec<u8>, witness: &PairWitness) -> io::Result<()> {
    text.extend_from_slice(b"{\"from\": ");
    push_integer(text, witness.from.into());
    text.extend_from_slice(b", \"to\": ");
    push_integer(text, witness.to.into());
    text.extend_from_slice(b", \"portals\": [");
    push_list(text, &witness.portals);
    text.extend_from_slice(b"], \"line\": [[");
    for (index, point) in witness.line.points().into_iter().enumerate() {
        text.extend_from_slice(if index == 0 { b"" } else { b"], [" });
        for (axis, coordinate) in point.iter().enumerate() {
            text.extend_from_slice(if axis == 0 { b"\"" } else { b", \"" });
            push_number(text, coordinate)?;
            text.push(b'"');
        }
    }
    text.extend_from_slice(b"]]}");
    Ok(())
}

fn push_list(text: &mut Vec<u8>, list: &[u32]) {
    for (index, &number) in list.iter().enumerate() {
        text.extend_from_slice(if index == 0 { b"" } else { b", " });
        push_integer(text, number.into());
    }
}

fn push_number(text: &mut Vec<u8>, number: &Number) -> io::Result<()> {
    match number {
        Number::Small(numerator, denominator) => {
            push_integer(text, *numerator);
            if *denominator != 1 {
                text.push(b'/');
                push_integer(text, *denominator);
            }
            Ok(())
        }
        Number::Big(ratio) => write!(text, "{ratio}"),
    }
}

/// The decimal digits; a result has millions of them, and the formatter of the standard library
/// would take most of the time of writing.
fn push_integer(text: &mut Vec<u8>, number: i64) {
    let mut digits = [0; 20];
    let mut start = digits.len();
    let mut rest = number.unsigned_abs();
    loop {
        start -= 1;
        digits[start] = b'0' + (rest % 10) as u8;
        rest /= 10;
        if rest == 0 {
            break;
        }
    }
    if number < 0 {
        text.push(b'-');
    }
    text.extend_from_slice(&digits[start..]);
}
