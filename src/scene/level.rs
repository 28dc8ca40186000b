//! Levels: solids made of planes, by what each means for visibility.
//!
//! [`Level::from_map`] gives every brush of a `.map` its [`Role`] by the level editors' conventions
//! (`docs/formats/map.md` lists them) and brings its faces to what later steps rely on; real levels
//! are odd, so whatever is repaired or dropped on the way has a [`LevelWarning`].
//!
//! Coordinates are world units. A plane with integer coefficients needs no common denominator, so
//! none is imposed: the plane through decimal points has the integers that its own digits need,
//! and an axial one stays as short as it is.
//!
//! Invariants of every brush: it is bounded and has volume; each face's plane is the only one that
//! holds its polygon, so no plane can be left out; coefficients are integers without a common
//! factor, the normal pointing out of the brush.

mod conventions;
pub(super) mod solid;
mod warning;

use super::input::{InputError, InputErrorKind};
use crate::formats::map::{self, MapEntity, MapFile};
use crate::geom::{BigPlane, RationalPoint3};
use crate::num::{Int, Number, Rational, parse_decimal};
use num_integer::Integer;
use num_traits::{One, Zero};
use std::borrow::Cow;

pub use warning::{LevelWarning, LevelWarningKind, NoSolid};

/// A level: its brushes and entities.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Level {
    /// The brushes of all entities, in the file's order, those without volume left out.
    pub brushes: Vec<Brush>,
    /// All entities, in the file's order, the world first.
    pub entities: Vec<Entity>,
    /// What was repaired or left out, in the file's order.
    pub warnings: Vec<LevelWarning>,
}

/// What a brush means for visibility.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// Occludes, and separates inside from outside.
    Solid,
    /// An object that never occludes.
    Detail,
    /// Splits cells along some of its faces, and is otherwise nothing.
    Hint,
    /// A liquid that is seen through.
    Liquid,
    /// Nothing that could be seen or that could hide anything.
    Ignored,
}

/// A convex solid.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Brush {
    /// What it means for visibility.
    pub role: Role,
    /// Its faces, in the file's order; four at least.
    pub faces: Vec<BrushFace>,
    /// The entity it belongs to: its index in [`Level::entities`].
    pub entity: usize,
    /// Its line in the file, counted from 1.
    pub line: usize,
}

/// A face of a brush.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BrushFace {
    /// Its plane in world units, the normal pointing out of the brush, without a common factor.
    pub plane: BigPlane,
    /// Whether cells are to be split along it: false for a face of a hint brush that is no hint.
    pub splits: bool,
    /// Its line in the file, counted from 1.
    pub line: usize,
}

/// An entity.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Entity {
    /// Its `classname`, empty where it has none.
    pub class: String,
    /// Its `origin` in world units, where it has one.
    pub origin: Option<RationalPoint3>,
    /// Whether it is only a place: the file gives it no brush.
    pub is_point: bool,
    /// Whether its brushes are what the world is built of.
    pub is_structure: bool,
    /// Its line in the file, counted from 1.
    pub line: usize,
}

/// What a reader of levels may choose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LevelOptions {
    /// Liquids are solids: they hide what is behind and within them, and no cell is in them.
    pub opaque_liquids: bool,
    /// Brushes of the world wholly of faces that are not drawn (`skip`, `trigger`) are ignored.
    /// Compilers make walls of them, and levels rely on that to be closed.
    pub see_through_skip: bool,
    /// Faces keep every digit of their points. Otherwise a coordinate with more than six decimals
    /// is taken for the multiple of 10^-6 next to it: editors write -281.59999999999997 for -281.6,
    /// and levels with such walls have cracks that nobody made.
    pub keep_digits: bool,
    /// Faces' points are rounded to this many decimals instead.
    pub snap: Option<u32>,
}

impl Level {
    /// The level that a `.map` states.
    pub fn from_map(file: &MapFile, options: LevelOptions) -> Level {
        let mut level = Level { brushes: Vec::new(), entities: Vec::new(), warnings: Vec::new() };
        let file = match (options.snap, options.keep_digits) {
            (Some(decimals), _) => level.rounded(file, decimals),
            (None, false) => level.rounded(file, USUAL_DECIMALS),
            (None, true) => Cow::Borrowed(file),
        };
        for (index, entity) in file.entities.iter().enumerate() {
            level.add_entity(index, entity, options);
        }
        level
    }

    /// The file without digits beyond the given decimal, with a warning if there were any.
    fn rounded<'f>(&mut self, file: &'f MapFile, decimals: u32) -> Cow<'f, MapFile> {
        let per_unit = Int::from(10).pow(decimals);
        let is_short = |number: &Number| is_multiple(number, &per_unit);
        let faces = file.entities.iter().flat_map(|e| &e.brushes).flat_map(|b| &b.faces);
        if faces.flat_map(|face| face.points.as_flattened()).all(is_short) {
            return Cow::Borrowed(file);
        }
        let mut file = file.clone();
        let mut first = None;
        let (mut count, mut largest) = (0, Rational::from(Int::ZERO));
        for (index, entity) in file.entities.iter_mut().enumerate() {
            for face in entity.brushes.iter_mut().flat_map(|brush| &mut brush.faces) {
                let long = face.points.as_flattened_mut().iter_mut().filter(|c| !is_short(c));
                for coordinate in long {
                    let (near, moved) = coordinate.rounded(&per_unit);
                    *coordinate = Number::from(near);
                    largest = largest.max(moved);
                    count += 1;
                    first.get_or_insert((index, face.line));
                }
            }
        }
        if let Some((entity, line)) = first {
            let class = file.entities[entity].value("classname").unwrap_or_default().to_owned();
            let kind = LevelWarningKind::Rounded { decimals, count, largest };
            self.warnings.push(LevelWarning { line, entity, class, brush: None, kind });
        }
        Cow::Owned(file)
    }

    fn add_entity(&mut self, index: usize, entity: &MapEntity, options: LevelOptions) {
        let class = entity.value("classname").unwrap_or_default().to_owned();
        let warning = |brush, line, kind| LevelWarning {
            line,
            entity: index,
            class: class.clone(),
            brush,
            kind,
        };
        if class.is_empty() {
            self.warnings.push(warning(None, entity.line, LevelWarningKind::NoClass));
        }
        let origin = match entity.value("origin").map(|text| (text, origin(text))) {
            Some((_, Some(origin))) => Some(origin),
            Some((text, None)) => {
                let kind = LevelWarningKind::Origin(text.escape_debug().take(40).collect());
                self.warnings.push(warning(None, entity.line, kind));
                None
            }
            None => None,
        };
        for (name, line) in &entity.patches {
            let kind = LevelWarningKind::Patch(name.escape_debug().take(40).collect());
            self.warnings.push(warning(None, *line, kind));
        }
        let part = conventions::part(&class);
        for (number, brush) in entity.brushes.iter().enumerate() {
            let reading = conventions::read_brush(part, brush, options);
            if let Some(kind) = reading.warning {
                self.warnings.push(warning(Some(number), brush.line, kind));
            }
            let mut warn = |line, kind| self.warnings.push(warning(Some(number), line, kind));
            let faces = solid::faces(brush, &reading.splits, &mut warn);
            if let Some(faces) = faces {
                let role = reading.role;
                self.brushes.push(Brush { role, faces, entity: index, line: brush.line });
            }
        }
        let is_point = entity.brushes.is_empty() && entity.patches.is_empty();
        let is_structure = part == conventions::Part::Structure;
        self.entities.push(Entity { class, origin, is_point, is_structure, line: entity.line });
    }
}

/// More come from computations of level editors.
const USUAL_DECIMALS: u32 = 6;

/// Whether the number is a multiple of 1 / `per_unit`.
fn is_multiple(number: &Number, per_unit: &Int) -> bool {
    match number {
        Number::Small(_, denominator) => (per_unit % denominator).is_zero(),
        Number::Big(ratio) => per_unit.is_multiple_of(ratio.denom()),
    }
}

/// Reads a level from the bytes of a `.map` file called `name`.
///
/// # Errors
/// [`InputError`] names the file, the line and the rule broken.
pub fn read_level(name: &str, bytes: &[u8], options: LevelOptions) -> Result<Level, InputError> {
    let file = map::read(bytes)
        .map_err(|error| InputError { name: name.to_owned(), kind: InputErrorKind::Map(error) })?;
    Ok(Level::from_map(&file, options))
}

/// Three decimals between blanks.
fn origin(text: &str) -> Option<RationalPoint3> {
    let mut numbers: Vec<Rational> = Vec::with_capacity(3);
    for word in text.split_ascii_whitespace() {
        if numbers.len() == 3 {
            return None;
        }
        numbers.push(parse_decimal(word).ok()?);
    }
    let [x, y, z] = numbers.try_into().ok()?;
    let denominator = [&x, &y, &z].iter().fold(Int::one(), |common, c| common.lcm(c.denom()));
    let scaled = [x, y, z].map(|c| c.numer() * (&denominator / c.denom()));
    Some(RationalPoint3::new(scaled, denominator))
}
