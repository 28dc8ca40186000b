//! Writing portal files: PRT1, as every reader knows it.

use super::PrtPortal;
use crate::num::{Rational, format_decimal};
use std::io::{self, Write};

/// Why a portal file could not be written.
#[derive(Debug, thiserror::Error)]
pub enum PrtWriteError {
    /// A coordinate without a finite decimal.
    #[error(
        "portal {portal}, vertex {vertex}: coordinate {got} has no finite decimal, so a portal \
         file cannot hold it exactly"
    )]
    NoDecimal {
        /// The portal, counted from 0.
        portal: usize,
        /// The vertex, counted from 0.
        vertex: usize,
        /// The coordinate.
        got: Rational,
    },
    /// The output failed.
    #[error(transparent)]
    Io(#[from] io::Error),
}

/// Writes `cells` cells and the portals between them, every coordinate exactly.
///
/// # Errors
/// The first coordinate that no finite decimal is equal to, before anything is written; or a
/// failure of the output.
pub fn write(cells: u32, portals: &[PrtPortal], out: &mut dyn Write) -> Result<(), PrtWriteError> {
    let lines: Vec<String> =
        portals.iter().enumerate().map(|(index, p)| line(index, p)).collect::<Result<_, _>>()?;
    write!(out, "PRT1\n{cells}\n{}\n", portals.len())?;
    for line in lines {
        writeln!(out, "{line}")?;
    }
    Ok(())
}

fn line(
    portal: usize,
    PrtPortal { cells: [from, to], vertices, .. }: &PrtPortal,
) -> Result<String, PrtWriteError> {
    let mut line = format!("{} {from} {to}", vertices.len());
    for (vertex, point) in vertices.iter().enumerate() {
        line.push_str(" (");
        for coordinate in point {
            let value = coordinate.to_rational();
            match format_decimal(&value) {
                Some(text) => line.push_str(&format!("{text} ")),
                None => return Err(PrtWriteError::NoDecimal { portal, vertex, got: value }),
            }
        }
        line.push(')');
    }
    Ok(line)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::formats::prt;
    use crate::num::Number;

    fn number(text: &str) -> Number {
        Number::parse(text).unwrap()
    }

    #[test]
    fn what_is_written_reads_back_equal() {
        let vertices = [["0", "-0.125", "3"], ["16.5", "0.000001", "3"], ["1e3", "-20", "3.2"]];
        let vertices = vertices.map(|point| point.map(number)).to_vec();
        let portals = vec![PrtPortal { line: 4, cells: [1, 0], vertices }];
        let mut bytes = Vec::new();
        write(2, &portals, &mut bytes).unwrap();
        assert_eq!(
            String::from_utf8(bytes.clone()).unwrap(),
            "PRT1\n2\n1\n3 1 0 (0 -0.125 3 ) (16.5 0.000001 3 ) (1000 -20 3.2 )\n"
        );
        let read = prt::read(&bytes).unwrap();
        assert_eq!((read.cells, read.portals), (2, portals));
    }

    #[test]
    fn a_third_has_no_decimal() {
        let vertices = vec![[number("1"), number("2"), Number::ratio(1, 3)]];
        let portal = PrtPortal { line: 1, cells: [0, 1], vertices };
        let mut bytes = Vec::new();
        let error = write(2, &[portal], &mut bytes).unwrap_err();
        assert!(error.to_string().starts_with("portal 0, vertex 0: coordinate 1/3"), "{error}");
        assert!(bytes.is_empty());
    }
}
