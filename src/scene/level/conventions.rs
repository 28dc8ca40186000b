//! The level editors' conventions: which role a brush has, by its entity's class, its textures and
//! its flags. `docs/formats/map.md` has the same as tables, with reasons.

use super::{LevelOptions, LevelWarningKind, Role};
use crate::formats::map::{MapBrush, MapFace, MapFlags};

/// Which part of a level an entity's brushes are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// What the world is built of.
    Structure,
    /// Objects that never occlude.
    Object,
    /// Volumes of the game that nobody sees.
    Unseen,
}

/// What a brush is by the conventions.
pub(super) struct Reading {
    pub role: Role,
    /// For each face of the file whether cells are to be split along it.
    pub splits: Vec<bool>,
    pub warning: Option<LevelWarningKind>,
}

/// What a face's texture and flags say of the brush.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Surface {
    /// Marks the axis of a turning entity.
    Origin,
    Hint,
    /// Stops players or monsters, and is otherwise nothing.
    Clip,
    /// A face of a hint brush that does not split.
    HintSkip,
    /// A face that is not drawn.
    Undrawn,
    Liquid,
    /// Seen through, or marked as detail.
    Object,
    /// Everything else, sky too.
    Wall,
}

/// The part that the brushes of an entity of this class are.
pub(super) fn part(class: &str) -> Part {
    let class = class.to_ascii_lowercase();
    match class.as_str() {
        "worldspawn" | "func_group" => Part::Structure,
        "func_areaportal" => Part::Unseen,
        _ if class.starts_with("trigger_") => Part::Unseen,
        _ => Part::Object,
    }
}

/// The role of a brush, and which of its faces split.
pub(super) fn read_brush(part: Part, brush: &MapBrush, options: LevelOptions) -> Reading {
    let surfaces: Vec<Surface> = brush.faces.iter().map(surface).collect();
    let any = |surface: Surface| surfaces.contains(&surface);
    let skipped = surfaces.iter().all(|s| *s == Surface::HintSkip);
    let undrawn = surfaces.iter().all(|s| matches!(s, Surface::Undrawn | Surface::HintSkip));
    // The marks that make a brush what they say even if only some faces have them, strongest
    // first; a brush whose other faces are drawn is odd.
    let marks = [
        (Surface::Origin, "origin"),
        (Surface::Hint, "hint"),
        (Surface::Clip, "clip"),
        (Surface::Liquid, "liquid"),
        (Surface::Object, "detail"),
    ];
    let mark = marks.into_iter().find(|&(surface, _)| any(surface));
    let role = match (part, mark.map(|(surface, _)| surface)) {
        (Part::Unseen, _) => Role::Ignored,
        (_, Some(Surface::Origin | Surface::Clip)) => Role::Ignored,
        (Part::Structure, Some(Surface::Hint)) => Role::Hint,
        (Part::Object, Some(Surface::Hint)) => Role::Ignored,
        (Part::Object, _) if undrawn => Role::Ignored,
        (Part::Structure, _) if skipped || undrawn && options.see_through_skip => Role::Ignored,
        (Part::Object, _) | (Part::Structure, Some(Surface::Object)) => Role::Detail,
        (Part::Structure, Some(Surface::Liquid)) if options.opaque_liquids => Role::Solid,
        (Part::Structure, Some(Surface::Liquid)) => Role::Liquid,
        (Part::Structure, Some(Surface::HintSkip | Surface::Undrawn | Surface::Wall) | None) => {
            Role::Solid
        }
    };
    let splits = surfaces.iter().map(|s| role != Role::Hint || *s == Surface::Hint).collect();
    let odd = mark.filter(|_| part == Part::Structure && any(Surface::Wall));
    let warning = match odd {
        Some((_, name)) => Some(LevelWarningKind::MixedFaces(name)),
        None if undrawn && !surfaces.is_empty() && role == Role::Solid => {
            Some(LevelWarningKind::UndrawnWall)
        }
        None => None,
    };
    Reading { role, splits, warning }
}

/// Bits of the flags of Quake 2, most of which Quake 3 keeps.
mod flag {
    pub const WINDOW: u32 = 1 << 1;
    pub const LIQUIDS: u32 = 1 << 3 | 1 << 4 | 1 << 5 | 1 << 6;
    pub const CLIPS: u32 = 1 << 16 | 1 << 17;
    pub const ORIGIN: u32 = 1 << 24;
    pub const DETAIL: u32 = 1 << 27;
    pub const TRANSLUCENT: u32 = 1 << 28;

    pub const SURFACE_TRANSLUCENT: u32 = 1 << 4 | 1 << 5;
    pub const SURFACE_UNDRAWN: u32 = 1 << 7 | 1 << 9;
    pub const SURFACE_HINT: u32 = 1 << 8;
}

fn surface(face: &MapFace) -> Surface {
    let named = by_name(&face.texture);
    match face.flags {
        Some(flags) if named == Surface::Wall => by_flags(flags),
        Some(_) | None => named,
    }
}

/// The name counts without its folders, in any case of letters.
fn by_name(texture: &str) -> Surface {
    let name = texture.rsplit(['/', '\\']).next().unwrap_or_default().to_ascii_lowercase();
    match name.as_str() {
        "origin" => Surface::Origin,
        "hint" => Surface::Hint,
        "clip" | "playerclip" | "monsterclip" | "weapclip" | "botclip" | "full_clip"
        | "areaportal" => Surface::Clip,
        "hintskip" => Surface::HintSkip,
        "skip" | "nodraw" | "trigger" | "aaatrigger" => Surface::Undrawn,
        _ if name.starts_with('*') => Surface::Liquid,
        _ => Surface::Wall,
    }
}

fn by_flags(MapFlags { contents, surface }: MapFlags) -> Surface {
    let is = |flags: u32, bits: u32| flags & bits != 0;
    if is(contents, flag::ORIGIN) {
        Surface::Origin
    } else if is(surface, flag::SURFACE_HINT) {
        Surface::Hint
    } else if is(contents, flag::CLIPS) {
        Surface::Clip
    } else if is(contents, flag::LIQUIDS) {
        Surface::Liquid
    } else if is(contents, flag::DETAIL | flag::WINDOW | flag::TRANSLUCENT)
        || is(surface, flag::SURFACE_TRANSLUCENT)
    {
        Surface::Object
    } else if is(surface, flag::SURFACE_UNDRAWN) {
        Surface::Undrawn
    } else {
        Surface::Wall
    }
}
