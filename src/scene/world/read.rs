//! Any file that states a world, told apart by its name and its first bytes.

use super::{World, WorldWarning, geometry, soup};
use crate::formats::gltf::Files;
use crate::formats::json::{GeometryFile, SceneKind};
use crate::formats::wad::Archive;
use crate::formats::{gltf, obj};
use crate::scene::input::{InputError, InputErrorKind};
use crate::scene::level::{LevelOptions, read_level};

/// What a reader of worlds may choose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WorldOptions {
    /// How levels' sources are read.
    pub level: LevelOptions,
    /// Round all coordinates of points to this many decimals.
    pub snap: Option<u32>,
}

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum InputKind {
    /// A level's source.
    Map,
    /// Wavefront `.obj`.
    Obj,
    /// A `.gltf` or a `.glb`.
    Gltf,
    /// A JSON scene that states geometry.
    Geometry,
    /// What states cells and portals, or is none of these.
    Graph,
    /// A JSON scene that states a floorplan, or cells of the plane; or an archive of Doom levels.
    Plan,
}

impl InputKind {
    /// By the name's ending for formats without a mark, else by the first bytes and fields.
    ///
    /// # Errors
    /// A JSON scene whose fields do not tell.
    pub fn of(name: &str, bytes: &[u8]) -> Result<InputKind, InputError> {
        let name_in_lower_case = name.to_ascii_lowercase();
        let ends = |ending| name_in_lower_case.ends_with(ending);
        if bytes.starts_with(b"glTF") || ends(".glb") || ends(".gltf") {
            return Ok(InputKind::Gltf);
        }
        if ends(".map") || looks_like_map(bytes) {
            return Ok(InputKind::Map);
        }
        if ends(".obj") {
            return Ok(InputKind::Obj);
        }
        if Archive::is_archive(bytes) {
            return Ok(InputKind::Plan);
        }
        if bytes.trim_ascii_start().first() != Some(&b'{') {
            return Ok(InputKind::Graph);
        }
        match SceneKind::of(bytes) {
            Ok(SceneKind::Graph) => Ok(InputKind::Graph),
            Ok(SceneKind::Geometry) => Ok(InputKind::Geometry),
            Ok(SceneKind::Plan | SceneKind::PlanGraph) => Ok(InputKind::Plan),
            Err(error) => {
                Err(InputError { name: name.to_owned(), kind: InputErrorKind::Json(error) })
            }
        }
    }
}

/// Whether a text without a telling name is a level's source: comments, or an entity, whose keys
/// are followed by their values and not by colons as in JSON.
fn looks_like_map(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    let Some(entity) = text.strip_prefix(b"{") else { return text.starts_with(b"//") };
    let entity = entity.trim_ascii_start();
    let Some(key) = entity.strip_prefix(b"\"") else { return entity.starts_with(b"//") };
    let end = key.iter().position(|&byte| byte == b'"');
    end.is_some_and(|end| key[end + 1..].trim_ascii_start().starts_with(b"\""))
}

/// Reads a world from the bytes of a file called `name`.
///
/// # Errors
/// [`InputError`] names the file, the place and the rule broken; a glTF file whose buffers are
/// files of their own is refused, for want of those.
pub fn read_world(
    name: &str,
    bytes: &[u8],
    options: &WorldOptions,
) -> Result<(World, Vec<WorldWarning>), InputError> {
    let mut none = |file: &str| Err(format!("`{}` is another file", file.escape_debug()));
    read_world_with(name, bytes, options, &mut none)
}

/// Reads a world from the bytes of a file called `name`, and from files beside it, which `files`
/// gives.
///
/// # Errors
/// [`InputError`] names the file, the place and the rule broken.
pub fn read_world_with(
    name: &str,
    bytes: &[u8],
    options: &WorldOptions,
    files: Files,
) -> Result<(World, Vec<WorldWarning>), InputError> {
    let error = |kind| InputError { name: name.to_owned(), kind };
    if bytes.is_empty() {
        return Err(error(InputErrorKind::Empty));
    }
    let world = match InputKind::of(name, bytes)? {
        InputKind::Map => {
            let options = LevelOptions { snap: options.snap, ..options.level };
            let level = read_level(name, bytes, options)?;
            let world = World::of_level(&level);
            Ok((world, level.warnings.into_iter().map(WorldWarning::Level).collect()))
        }
        InputKind::Obj => {
            let file = obj::read(bytes).map_err(|e| error(InputErrorKind::Obj(e)))?;
            soup::of_obj(&file, options.snap)
        }
        InputKind::Gltf => {
            let file = gltf::read(bytes, files).map_err(|e| error(InputErrorKind::Gltf(e)))?;
            soup::of_gltf(&file, options.snap)
        }
        InputKind::Geometry => {
            let file = GeometryFile::read(bytes).map_err(|e| error(InputErrorKind::Json(e)))?;
            geometry::world_of(&file, options.snap)
        }
        InputKind::Graph => return Err(error(InputErrorKind::NoGeometry)),
        InputKind::Plan => return Err(error(InputErrorKind::InThePlane)),
    };
    world.map_err(|e| error(InputErrorKind::Statement(Box::new(e))))
}
