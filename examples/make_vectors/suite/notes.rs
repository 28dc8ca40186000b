//! The flags: what is degenerate, and which known defect it recalls.

use stabline::vectors::Note;

/// Name, what is degenerate, and the defect of public programs that it recalls (or nothing).
const NOTES: &[[&str; 3]] = &[
    ["Plain", "Nothing is degenerate: an implementation that fails here fails everywhere.", ""],
    [
        "Slit",
        "A passage of a width from 1e-1 down to 1e-20, beside walls of ordinary size.",
        "Programs with a tolerance of 0.1 or 0.01 units on every plane test close it; with doubles \
         it vanishes below 1e-16.",
    ],
    [
        "Flush",
        "Two edges are exactly in line, so that a line only touches: the case is grazing.",
        "Where doubles decide, flush edges come out either way, and differently in each direction.",
    ],
    [
        "OneUnit",
        "One grid unit away from being critical, on either side of it.",
        "A tolerance treats the case as it treats its critical neighbour.",
    ],
    [
        "FarFromOrigin",
        "Coordinates about 2^20 or 2^40 away from the origin, with details of one unit.",
        "Products of coordinates lose the details in doubles (and in floats at 2^20 already).",
    ],
    [
        "UnitScale",
        "A scene in inches, scaled by 0.0254 to metres: the same visibility.",
        "A public vis program that keeps 0.1 units of tolerance loses tens to hundreds of truly \
         visible pairs of a level scaled so.",
    ],
    [
        "SharedVertex",
        "Portals have a vertex in common.",
        "A separating plane through the common vertex is skipped, or taken with the wrong sign.",
    ],
    [
        "Coplanar",
        "Several portals lie in one plane (in the plane: on one line).",
        "Side products are exact zeros; programs that test weak signs accept lines in the plane \
         that miss the portals.",
    ],
    [
        "CommonLine",
        "The edges of many portals lie on one line, which alone can pass.",
        "The closed portals have one line in common and the open ones none, and rounding decides.",
    ],
    [
        "Duplicate",
        "A portal is there twice, or twice with opposite directions.",
        "Edges that are equal give systems without full rank, which solvers in general position \
         divide by.",
    ],
    [
        "TurnAround",
        "The portals' directions have no common forward direction, or just one.",
        "Tests of weak signs accept lines at infinity.",
    ],
    [
        "LongChain",
        "Many portals in a row.",
        "Errors of repeated clipping add up; tables of fixed size overflow.",
    ],
];

/// The notes on these flags.
///
/// # Panics
/// If a flag has no note.
pub fn note(flag: &str) -> Note {
    let found = NOTES.iter().find(|[name, ..]| *name == flag);
    let [_, about, recalls] = found.unwrap_or_else(|| panic!("no note on {flag}"));
    let recalls = (!recalls.is_empty()).then(|| (*recalls).to_owned());
    Note { about: (*about).to_owned(), recalls }
}
