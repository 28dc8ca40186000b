//! The reader: a line at a time, each line as its tokens.

use super::{Dialect, PrtError, PrtErrorKind, PrtFile, PrtPortal};
use crate::num::Number;

/// No level comes near; a matrix of this size squared would not fit a machine.
const MAX_CELLS: u32 = 1 << 20;

/// Reads a portal file in any dialect.
///
/// # Errors
/// [`PrtError`] names the line and the rule broken.
pub fn read(bytes: &[u8]) -> Result<PrtFile, PrtError> {
    if let Some(position) = bytes.iter().position(|byte| !byte.is_ascii() || *byte == 0) {
        let line = 1 + bytes[..position].iter().filter(|&&byte| byte == b'\n').count();
        return Err(PrtError { line, kind: PrtErrorKind::NotText });
    }
    let Ok(text) = std::str::from_utf8(bytes) else {
        return Err(PrtError { line: 1, kind: PrtErrorKind::NotText });
    };
    let mut lines = Lines { rest: text, line: 0 };
    let header = read_header(&mut lines)?;
    let mut portals = Vec::new();
    for _ in 0..header.portals {
        let tokens = lines.next("another portal")?;
        portals.push(read_portal(tokens, &header)?);
    }
    let (leaf_to_cell, after) = read_tail(&mut lines, &header)?;
    if let Some(tokens) = lines.next_or_end() {
        let got = excerpt(tokens.text.trim());
        return Err(tokens.error(PrtErrorKind::Trailing { after, got }));
    }
    Ok(PrtFile { dialect: header.dialect, cells: header.cells, portals, leaf_to_cell })
}

/// What the lines before the portals say.
struct Header {
    dialect: Dialect,
    cells: u32,
    leafs: u32,
    portals: u64,
    solid_faces: u64,
    /// The number of sub-leafs of each leaf, where a headless file states it.
    sub_leafs: Vec<u32>,
}

fn read_header(lines: &mut Lines<'_>) -> Result<Header, PrtError> {
    let Some(mut first) = lines.next_or_end() else {
        return Err(PrtError { line: 1, kind: PrtErrorKind::Empty });
    };
    let magic = first.text.trim();
    let mut header = Header {
        dialect: Dialect::Prt1,
        cells: 0,
        leafs: 0,
        portals: 0,
        solid_faces: 0,
        sub_leafs: Vec::new(),
    };
    match magic {
        "PRT1" => {
            header.cells = lines.next("the number of leafs")?.lone_cells("the number of leafs")?;
            header.leafs = header.cells;
            header.portals = lines.next("the number of portals")?.lone("the number of portals")?;
            if lines.peek_is_lone() {
                header.dialect = Dialect::Quake3;
                let what = "the number of solid faces";
                header.solid_faces = lines.next(what)?.lone(what)?;
            }
        }
        "PRT2" => {
            header.dialect = Dialect::Prt2;
            header.leafs = lines.next("the number of leafs")?.lone_cells("the number of leafs")?;
            let what = "the number of clusters";
            header.cells = lines.next(what)?.lone_cells(what)?;
            header.portals = lines.next("the number of portals")?.lone("the number of portals")?;
        }
        "PRT1-AM" => {
            header.dialect = Dialect::Prt1Am;
            let what = "the number of clusters";
            header.cells = lines.next(what)?.lone_cells(what)?;
            header.portals = lines.next("the number of portals")?.lone("the number of portals")?;
            header.leafs = lines.next("the number of leafs")?.lone_cells("the number of leafs")?;
        }
        _ if magic.bytes().all(|byte| byte.is_ascii_digit()) => {
            header.dialect = Dialect::Headless;
            header.cells = first.lone_cells("the number of leafs")?;
            header.portals = lines.next("the number of portals")?.lone("the number of portals")?;
            header.leafs = header.cells;
            if header.portals > 0 && lines.peek_is_lone() {
                read_sub_leafs(lines, &mut header)?;
            }
        }
        _ => return Err(first.error(PrtErrorKind::Magic(excerpt(magic)))),
    }
    Ok(header)
}

fn read_sub_leafs(lines: &mut Lines<'_>, header: &mut Header) -> Result<(), PrtError> {
    let what = "a leaf's number of sub-leafs";
    let mut total = 0u64;
    for _ in 0..header.cells {
        let mut tokens = lines.next(what)?;
        let count = tokens.lone_cells(what)?;
        total += u64::from(count);
        if total > u64::from(MAX_CELLS) {
            let kind = PrtErrorKind::TooMany {
                what: "the number of sub-leafs",
                got: total,
                limit: MAX_CELLS,
            };
            return Err(tokens.error(kind));
        }
        header.sub_leafs.push(count);
    }
    Ok(())
}

fn read_portal(mut tokens: Tokens<'_>, header: &Header) -> Result<PrtPortal, PrtError> {
    let count = tokens.count("a portal's number of vertices")?;
    let mut cells = [0; 2];
    for cell in &mut cells {
        let got = tokens.count("a portal's cell")?;
        match u32::try_from(got) {
            Ok(id) if id < header.cells => *cell = id,
            _ => {
                let kind = PrtErrorKind::MissingCell { got, cells: header.cells };
                return Err(tokens.error(kind));
            }
        }
    }
    if header.dialect == Dialect::Quake3 {
        tokens.count("a portal's flags")?;
    }
    if count < 3 {
        return Err(tokens.error(PrtErrorKind::TooFewVertices(count)));
    }
    let vertices = tokens.vertices(count)?;
    Ok(PrtPortal { line: tokens.line, cells, vertices })
}

/// The lines after the portals; the cell of each leaf, and a name for what was read last.
fn read_tail(lines: &mut Lines<'_>, header: &Header) -> Result<(Vec<u32>, &'static str), PrtError> {
    match header.dialect {
        Dialect::Prt1 => Ok(((0..header.leafs).collect(), "the last portal")),
        Dialect::Prt2 => Ok((read_cluster_lines(lines, header)?, "the last cluster")),
        Dialect::Prt1Am => {
            let mut cells = Vec::new();
            for _ in 0..header.leafs {
                let mut tokens = lines.next("a leaf's cluster")?;
                let got = tokens.lone("a leaf's cluster")?;
                match u32::try_from(got) {
                    Ok(cell) if cell < header.cells => cells.push(cell),
                    _ => {
                        let kind = PrtErrorKind::MissingCell { got, cells: header.cells };
                        return Err(tokens.error(kind));
                    }
                }
            }
            Ok((cells, "the last leaf's cluster"))
        }
        Dialect::Quake3 => {
            for _ in 0..header.solid_faces {
                let mut tokens = lines.next("another solid face")?;
                let count = tokens.count("a solid face's number of vertices")?;
                tokens.count("a solid face's leaf")?;
                tokens.vertices(count)?;
            }
            Ok(((0..header.leafs).collect(), "the last solid face"))
        }
        Dialect::Headless if header.sub_leafs.is_empty() => {
            Ok(((0..header.leafs).collect(), "the last portal"))
        }
        Dialect::Headless => {
            let each = (0..).zip(&header.sub_leafs);
            let cells = each.flat_map(|(leaf, &n)| std::iter::repeat_n(leaf, n as usize));
            Ok((cells.collect(), "the last portal"))
        }
    }
}

fn read_cluster_lines(lines: &mut Lines<'_>, header: &Header) -> Result<Vec<u32>, PrtError> {
    let mut cells = vec![u32::MAX; header.leafs as usize];
    for cluster in 0..header.cells {
        let mut tokens = lines.next("a cluster's leafs")?;
        loop {
            match tokens.next() {
                Some("-1") => break,
                Some(token) => {
                    let got = tokens.number("a leaf", token)?;
                    let slot = usize::try_from(got).ok().and_then(|leaf| cells.get_mut(leaf));
                    let Some(slot) = slot else {
                        let kind = PrtErrorKind::MissingLeaf { got, leafs: header.leafs };
                        return Err(tokens.error(kind));
                    };
                    if *slot != u32::MAX {
                        let leaf = got as u32;
                        let (first, second) = (*slot, cluster);
                        return Err(tokens.error(PrtErrorKind::LeafTwice { leaf, first, second }));
                    }
                    *slot = cluster;
                }
                None => return Err(tokens.error(PrtErrorKind::ClusterEnd)),
            }
        }
        if tokens.next().is_some() {
            return Err(tokens.error(PrtErrorKind::ClusterEnd));
        }
    }
    match (0..).zip(&cells).find(|(_, cell)| **cell == u32::MAX) {
        Some((leaf, _)) => {
            let kind = PrtErrorKind::LeafWithoutCluster(leaf);
            Err(PrtError { line: lines.line, kind })
        }
        None => Ok(cells),
    }
}

/// The lines of a file that are not blank, with their numbers.
struct Lines<'a> {
    rest: &'a str,
    line: usize,
}

impl<'a> Lines<'a> {
    fn next_or_end(&mut self) -> Option<Tokens<'a>> {
        while !self.rest.is_empty() {
            let (text, rest) = self.rest.split_once('\n').unwrap_or((self.rest, ""));
            self.rest = rest;
            self.line += 1;
            if !text.trim_ascii().is_empty() {
                return Some(Tokens { text, rest: text, line: self.line });
            }
        }
        None
    }

    fn next(&mut self, due: &'static str) -> Result<Tokens<'a>, PrtError> {
        let end = PrtError { line: self.line + 1, kind: PrtErrorKind::Ends(due) };
        self.next_or_end().ok_or(end)
    }

    /// Whether the next line is a single token: a further number of the header.
    fn peek_is_lone(&self) -> bool {
        let mut ahead = Lines { rest: self.rest, line: self.line };
        ahead.next_or_end().is_some_and(|mut tokens| {
            tokens.next();
            tokens.next().is_none()
        })
    }
}

/// The tokens of a line: what blanks separate, and each parenthesis for itself.
struct Tokens<'a> {
    text: &'a str,
    rest: &'a str,
    line: usize,
}

impl<'a> Tokens<'a> {
    fn next(&mut self) -> Option<&'a str> {
        let rest = self.rest.trim_ascii_start();
        let end = match rest.as_bytes().first()? {
            b'(' | b')' => 1,
            _ => rest
                .bytes()
                .position(|byte| byte.is_ascii_whitespace() || byte == b'(' || byte == b')')
                .unwrap_or(rest.len()),
        };
        let (token, rest) = rest.split_at(end);
        self.rest = rest;
        Some(token)
    }

    fn error(&self, kind: PrtErrorKind) -> PrtError {
        PrtError { line: self.line, kind }
    }

    fn number(&self, what: &'static str, token: &str) -> Result<u64, PrtError> {
        let digits = token.bytes().all(|byte| byte.is_ascii_digit());
        match token.parse() {
            Ok(number) if digits => Ok(number),
            _ => Err(self.error(PrtErrorKind::NotACount { what, got: excerpt(token) })),
        }
    }

    /// The next token as a number that counts or names something.
    fn count(&mut self, what: &'static str) -> Result<u64, PrtError> {
        let token = self.next().unwrap_or("the end of the line");
        self.number(what, token)
    }

    /// The only token of the line, as a number.
    fn lone(&mut self, what: &'static str) -> Result<u64, PrtError> {
        let number = self.count(what)?;
        match self.next() {
            None => Ok(number),
            Some(_) => Err(self.error(PrtErrorKind::LoneNumber(what))),
        }
    }

    /// The only token of the line, as a number of cells or leafs.
    fn lone_cells(&mut self, what: &'static str) -> Result<u32, PrtError> {
        let got = self.lone(what)?;
        match u32::try_from(got) {
            Ok(count) if count <= MAX_CELLS => Ok(count),
            _ => Err(self.error(PrtErrorKind::TooMany { what, got, limit: MAX_CELLS })),
        }
    }

    /// The rest of the line: exactly `expected` vertices `(x y z )`.
    fn vertices(&mut self, expected: u64) -> Result<Vec<[Number; 3]>, PrtError> {
        let mut vertices = Vec::with_capacity((expected as usize).min(self.rest.len() / 6));
        while let Some(token) = self.next() {
            let vertex = vertices.len();
            if token != "(" {
                let got = excerpt(token);
                return Err(self.error(PrtErrorKind::Vertex { vertex, expected: "(", got }));
            }
            vertices.push([
                self.coordinate(vertex)?,
                self.coordinate(vertex)?,
                self.coordinate(vertex)?,
            ]);
            let close = self.next().unwrap_or("the end of the line");
            if close != ")" {
                let got = excerpt(close);
                return Err(self.error(PrtErrorKind::Vertex { vertex, expected: ")", got }));
            }
        }
        if vertices.len() as u64 != expected {
            let got = vertices.len();
            return Err(self.error(PrtErrorKind::VertexCount { expected, got }));
        }
        Ok(vertices)
    }

    fn coordinate(&mut self, vertex: usize) -> Result<Number, PrtError> {
        let Some(token) = self.next() else {
            let (expected, got) = ("x y z", "the end of the line".to_owned());
            return Err(self.error(PrtErrorKind::Vertex { vertex, expected, got }));
        };
        Number::parse(token).map_err(|source| {
            self.error(PrtErrorKind::Coordinate { vertex, got: excerpt(token), source })
        })
    }
}

/// The beginning of a text, for an error message.
fn excerpt(text: &str) -> String {
    match text.char_indices().nth(32) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
