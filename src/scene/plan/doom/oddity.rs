//! What is in real levels and should not be, and what is made of it.

use std::fmt;

/// Something in a level that should not be. Lines are linedefs; all by number.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum DoomOddity {
    /// A line with one end: left out.
    ZeroLength {
        /// The line.
        line: u32,
    },
    /// A line without a sidedef on its right: a wall; one on its left counts.
    NoFront {
        /// The line.
        line: u32,
    },
    /// A line whose flags say something else about its sides than its sidedefs: these count.
    Flag {
        /// The line.
        line: u32,
        /// Whether the flags say that it has two sides.
        says_two_sided: bool,
    },
    /// A line with one sector on both sides: claims for that sector only what nothing else does.
    SelfReferencing {
        /// The line.
        line: u32,
        /// The sector.
        sector: u32,
    },
    /// Two lines that have more than a point in common: a wall where one of them is.
    Overlap {
        /// The lines.
        lines: [u32; 2],
    },
    /// Two lines that cross: divided there.
    Crossing {
        /// The lines.
        lines: [u32; 2],
    },
    /// A line that begins or ends within another: the other is divided there.
    Touching {
        /// The other, and the line.
        lines: [u32; 2],
    },
    /// An area, what can be reached without crossing a line, that several sectors claim, or
    /// sectors and the void: part of each of these sectors.
    Unclosed {
        /// Who claims it, in ascending order.
        claims: Vec<AreaClaim>,
    },
    /// A sector that no area is part of: sees nothing but itself.
    NoArea {
        /// The sector.
        sector: u32,
    },
}

/// What the side of a linedef says about the area that it faces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct AreaClaim {
    /// The sector; none for the void.
    pub sector: Option<u32>,
    /// The first line that says so.
    pub line: u32,
}

impl DoomOddity {
    /// The kind, in a word or two.
    pub fn kind(&self) -> &'static str {
        match self {
            DoomOddity::ZeroLength { .. } => "zero-length",
            DoomOddity::NoFront { .. } => "no front",
            DoomOddity::Flag { .. } => "flag",
            DoomOddity::SelfReferencing { .. } => "self-referencing",
            DoomOddity::Overlap { .. } => "overlapping",
            DoomOddity::Crossing { .. } => "crossing",
            DoomOddity::Touching { .. } => "touching",
            DoomOddity::Unclosed { .. } => "unclosed",
            DoomOddity::NoArea { .. } => "no area",
        }
    }

    /// What is wrong, in general: the same text for all oddities of a kind.
    pub fn rule(&self) -> &'static str {
        match self {
            DoomOddity::ZeroLength { .. } => "lines of no length, left out",
            DoomOddity::NoFront { .. } => "lines without a front, walls",
            DoomOddity::Flag { .. } => "lines with a flag that their sides contradict",
            DoomOddity::SelfReferencing { .. } => "lines with one sector on both sides",
            DoomOddity::Overlap { .. } => "pairs of lines that overlap",
            DoomOddity::Crossing { .. } => "pairs of lines that cross, divided there",
            DoomOddity::Touching { .. } => "lines that end within another, divided there",
            DoomOddity::Unclosed { .. } => "areas that more than one sector or the void claims",
            DoomOddity::NoArea { .. } => "sectors without an area",
        }
    }

    /// The linedefs that it is about, as a map numbers them.
    pub fn lines(&self) -> Vec<u32> {
        match self {
            DoomOddity::ZeroLength { line }
            | DoomOddity::NoFront { line }
            | DoomOddity::Flag { line, .. }
            | DoomOddity::SelfReferencing { line, .. } => vec![*line],
            DoomOddity::Overlap { lines }
            | DoomOddity::Crossing { lines }
            | DoomOddity::Touching { lines } => lines.to_vec(),
            DoomOddity::Unclosed { claims } => claims.iter().map(|claim| claim.line).collect(),
            DoomOddity::NoArea { .. } => Vec::new(),
        }
    }

    /// The sectors that it is about.
    pub fn sectors(&self) -> Vec<u32> {
        match self {
            DoomOddity::SelfReferencing { sector, .. } | DoomOddity::NoArea { sector } => {
                vec![*sector]
            }
            DoomOddity::Unclosed { claims } => {
                claims.iter().filter_map(|claim| claim.sector).collect()
            }
            DoomOddity::ZeroLength { .. }
            | DoomOddity::NoFront { .. }
            | DoomOddity::Flag { .. }
            | DoomOddity::Overlap { .. }
            | DoomOddity::Crossing { .. }
            | DoomOddity::Touching { .. } => Vec::new(),
        }
    }
}

impl fmt::Display for DoomOddity {
    /// One line, with the numbers of linedefs and sectors.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            DoomOddity::ZeroLength { line } => write!(f, "line {line} has no length"),
            DoomOddity::NoFront { line } => write!(f, "line {line} has no front"),
            DoomOddity::Flag { line, says_two_sided: true } => {
                write!(f, "line {line} is flagged two-sided and has one side")
            }
            DoomOddity::Flag { line, says_two_sided: false } => {
                write!(f, "line {line} has two sides and is not flagged two-sided")
            }
            DoomOddity::SelfReferencing { line, sector } => {
                write!(f, "line {line} has sector {sector} on both sides")
            }
            DoomOddity::Overlap { lines: [a, b] } => write!(f, "lines {a} and {b} overlap"),
            DoomOddity::Crossing { lines: [a, b] } => write!(f, "lines {a} and {b} cross"),
            DoomOddity::Touching { lines: [a, b] } => write!(f, "line {b} ends within line {a}"),
            DoomOddity::Unclosed { claims } => {
                f.write_str("an area is claimed by")?;
                for (index, AreaClaim { sector, line }) in claims.iter().enumerate() {
                    f.write_str(if index == 0 { " " } else { ", " })?;
                    match sector {
                        Some(sector) => write!(f, "sector {sector} (line {line})")?,
                        None => write!(f, "the void (line {line})")?,
                    }
                }
                Ok(())
            }
            DoomOddity::NoArea { sector } => write!(f, "sector {sector} has no area"),
        }
    }
}
