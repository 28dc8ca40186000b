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
    [
        "Backwards",
        "The same portals crossed in the other direction, in reverse order.",
        "Programs whose tests lean to one side find a pair in one direction only.",
    ],
    [
        "Mirrored",
        "The same in a mirror: left and right change places.",
        "A wrong sign for one handedness stays unseen in symmetric maps.",
    ],
    [
        "Posts",
        "Three posts in line, passed on alternate sides.",
        "A side product that is a rounded zero decides.",
    ],
    [
        "Needle",
        "A polygon or a gate much longer than wide.",
        "Normals of slivers are short before they are normalised; separating planes with short cross products are skipped by public vis programs.",
    ],
    [
        "ThinLeaf",
        "A leaf of 0.1 units or less between two rooms.",
        "A 0.01-unit leaf between two rooms loses visible pairs in a public vis program: both its portals are within the tolerance of each other's plane.",
    ],
    ["LongNumbers", "Coordinates of more than 40 bits.", "Doubles hold no product of two of them."],
    [
        "SmallOverlap",
        "Windows that overlap by 0.05 or 0.1 units.",
        "A window overlap of 0.05 units reads as not visible in all full-quality vis programs measured, which keep 0.1 units of tolerance.",
    ],
    [
        "SmallClearance",
        "Clearances of 0.001 to 0.03 units.",
        "Vis programs miss true pairs with clearances of 0.005 to 0.03 units on real maps.",
    ],
    [
        "ShortEdge",
        "Portals with edges of 0.2 units or less.",
        "Portals with edges shorter than 0.2 are dropped by public vis programs.",
    ],
    [
        "TouchInPoint",
        "Portals that touch in a point, or overlap there by little.",
        "The clipped winding has no area, and is dropped or kept by chance.",
    ],
    [
        "HalfWall",
        "Facing squares with half a wall between them.",
        "A published exact library answers hidden, with doubles and with rationals; the truth is visible.",
    ],
    [
        "NearRegulus",
        "Four lines of one regulus, or one unit off it.",
        "Pairs of lines in such a place are where the discriminant of four lines is zero; its sign is wrong in 8 to 25 % of tests with doubles.",
    ],
    [
        "Quadric",
        "The half-spaces of the edges leave room and the lines do not: no weighted sum of sides \
         refutes the sequence, products of sides do; or a neighbour of such a case.",
        "Classic vis clips by planes through an edge and a vertex, which shuts some of these part \
         by part and leaves others visible: waste.",
    ],
    [
        "ManyVertices",
        "A portal of 25 vertices or more.",
        "Windings over 24 points are not clipped by public vis programs.",
    ],
    [
        "StraightSide",
        "Vertices in the middle of straight sides.",
        "Side tests of such an edge's corners are zeros.",
    ],
    [
        "AtInfinity",
        "Some of the lines that answer are at infinity, and do not count.",
        "The quadratic equation loses its first coefficient, and solvers divide by it.",
    ],
    [
        "DoubleTransversal",
        "Four lines that one line meets twice.",
        "The discriminant is exactly zero; in doubles it is none or two.",
    ],
    [
        "SpecialLines",
        "Lines that cross, coincide, are parallel, or share a plane.",
        "Solvers in general position divide by zero, or report two lines where there are families.",
    ],
    ["TwoWays", "Two ways from one cell to the other, of which the better one decides.", ""],
    [
        "SplitPortal",
        "A portal in two parts, side by side, which changes nothing.",
        "Each part alone is narrower, and tolerances eat from both.",
    ],
    [
        "TJunction",
        "Edges that end in the middle of others.",
        "Sides that should be in line differ by rounding, and light leaks between them.",
    ],
    ["Pinwheel", "Four pieces around an opening, each ending at the next one's side.", ""],
    [
        "Overlap",
        "Pieces of a wall that overlap in one plane.",
        "Coplanar faces split each other into slivers in tree builders with tolerances.",
    ],
    ["Solids", "What hides is solid, convex blocks, and not thin polygons.", ""],
    [
        "CoincidentFaces",
        "Faces of two solids lie in one plane and cover each other; what is between them has no width.",
        "A scene whose blocks touch face to face gets a crack of the tolerance's width, or \
         z-fights itself into slivers.",
    ],
    [
        "SharedEdge",
        "Two solids have an edge in common, and no gap.",
        "A tree builder that drops short or thin windings leaks through the common edge.",
    ],
    [
        "CornerTouch",
        "Solids have a corner in common.",
        "The corner point is seen through, or the cells around it overlap.",
    ],
    [
        "EdgeOnFace",
        "The edge of a solid lies on another's face.",
        "Rounded, it pierces the face or hovers over it.",
    ],
    ["Nested", "Solids within another solid, which change nothing.", ""],
    [
        "OffGrid",
        "Solids whose planes and corners are rationals on no common grid of the scene.",
        "Corners computed from planes are rounded, and faces that coincide no longer do.",
    ],
    ["Frustum", "The eye looks through a frame: what is outside of it does not count.", ""],
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
