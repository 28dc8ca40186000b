//! Colours: apart for all common kinds of colour vision, and apart in grey, from dark to light in
//! the order of what matters most.

/// Faces: the opaque segments. Lightness (CIE L*) 0.
pub const WALL: &str = "#000000";
/// The cell one looks from. L* 21.
pub const SOURCE: &str = "#08306b";
/// What an eye sees exactly: blue-green. L* 47.
pub const SEEN: &str = "#007c78";
/// Cells that an eye sees, or may see under a weaker cull. L* 66.
pub const VISIBLE_NOW: &str = "#6ba6d8";
/// Cells that are visible from a cell. L* 79.
pub const VISIBLE: &str = "#9ecae1";
/// Cells visible from the eye's cell and culled for the eye. L* 86.
pub const CULLED: &str = "#b7e2a8";
/// Cells that nothing is said about.
pub const CELL: &str = "#ffffff";
/// What lies in the box and is no cell.
pub const OUTSIDE: &str = "#e4e4e4";
/// Edges of cells where neither a face nor a portal is: thin and light.
pub const EDGE: &str = "#b0b0b0";
/// Segments that hide nothing. L* 62.
pub const HINT: &str = "#969696";
/// Portals. L* 54.
pub const PORTAL: &str = "#d55e00";
/// Splits, under the faces on them. L* 76.
pub const SPLIT: &str = "#f2ae72";
/// The adjacency graph. L* 46.
pub const GRAPH: &str = "#0072b2";
/// Lines of sight and trees over pale cells: a dark orange. L* 45.
pub const SIGHT: &str = "#b84800";
/// The eye and its cone.
pub const EYE: &str = "#c8102e";
/// Text.
pub const TEXT: &str = "#202020";

#[cfg(test)]
mod tests {
    use super::*;

    /// CIE L* of a colour.
    fn lightness(colour: &str) -> f64 {
        let channel = |at: usize| {
            let value = u8::from_str_radix(&colour[at..at + 2], 16).unwrap();
            let value = f64::from(value) / 255.0;
            if value <= 0.04045 { value / 12.92 } else { ((value + 0.055) / 1.055).powf(2.4) }
        };
        let y = 0.2126 * channel(1) + 0.7152 * channel(3) + 0.0722 * channel(5);
        if y > 0.008856 { 116.0 * y.cbrt() - 16.0 } else { 903.3 * y }
    }

    #[test]
    fn areas_of_one_picture_are_apart_in_grey() {
        for areas in [
            [WALL, SOURCE, VISIBLE, OUTSIDE, CELL].as_slice(),
            &[WALL, SEEN, VISIBLE_NOW, CULLED, CELL],
            &[WALL, SIGHT, VISIBLE],
            &[SOURCE, SIGHT],
            &[PORTAL, SPLIT, CELL],
        ] {
            for pair in areas.windows(2) {
                let apart = lightness(pair[1]) - lightness(pair[0]);
                assert!(apart > 8.0, "{pair:?}: {apart}");
            }
        }
    }
}
