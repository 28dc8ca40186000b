//! glTF 2.0 (`.gltf`, `.glb`): the triangles of its meshes where the nodes of its scene put them.
//!
//! Coordinates are 32-bit floats, and each is the dyadic rational that it stands for; nothing is
//! computed in floats. The container and the JSON are read by the `gltf` crate; offsets, strides
//! and counts are checked here against the bytes that are there. Linear in the size of the
//! triangles that come out, of which [`MAX_TRIANGLES`] are allowed: a small file can put one mesh
//! at many places.

mod accessor;
mod buffer;
mod transform;

use crate::geom::RationalPoint3;
use accessor::Accessors;
use gltf::json::mesh::{Mode, Primitive, Semantic};
use gltf::json::validation::Checked;
use gltf::json::{Index, Root};
use transform::Affine;

/// What a glTF file puts into space.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct GltfFile {
    /// The primitives of triangles, in the order of the scene's nodes, parents first.
    pub parts: Vec<GltfPart>,
    /// How many primitives are points or lines, and left out.
    pub other_primitives: usize,
    /// How many meshes have a skin or morph targets; they are taken at rest.
    pub deformed: usize,
}

/// A primitive of triangles.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GltfPart {
    /// The name of its node, else of its mesh, else the node's index.
    pub name: String,
    /// The vertices, in world units.
    pub vertices: Vec<RationalPoint3>,
    /// Indices into the vertices.
    pub triangles: Vec<[u32; 3]>,
}

/// Why bytes are not a glTF file, and where.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {kind}")]
pub struct GltfError {
    /// The element, such as `accessors[3]`.
    pub place: String,
    /// The rule broken.
    pub kind: GltfErrorKind,
}

/// The rules of glTF files.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum GltfErrorKind {
    /// The container or the JSON is broken.
    #[error("{0}")]
    Syntax(String),
    /// The file states no scene.
    #[error("the file has no scene, expected one or more")]
    NoScene,
    /// A buffer whose bytes are not at hand.
    #[error("the buffer's bytes are not at hand: {0}")]
    NoBytes(String),
    /// Less data than is stated.
    #[error("{got} bytes are there, expected {expected} or more")]
    Short {
        /// The bytes there.
        got: usize,
        /// The bytes stated.
        expected: u64,
    },
    /// Something that is legal and not read.
    #[error("{0}")]
    Unsupported(&'static str),
    /// A number that is infinite or none.
    #[error("coordinate {coordinate} of element {element} is infinite or not a number")]
    NotFinite {
        /// The element, counted from 0.
        element: usize,
        /// The coordinate, counted from 0.
        coordinate: usize,
    },
    /// A transform that has no meaning.
    #[error("{0}")]
    Transform(&'static str),
    /// An index that names no vertex.
    #[error("index {got} names no vertex, of {vertices}")]
    MissingVertex {
        /// The index.
        got: u32,
        /// The number of vertices.
        vertices: usize,
    },
    /// A node that is met a second time.
    #[error("the node has two parents, or is its own descendant")]
    NotATree,
    /// More triangles than are taken.
    #[error("more than {MAX_TRIANGLES} triangles")]
    TooLarge,
}

/// The most triangles that are read from one file.
pub const MAX_TRIANGLES: usize = 1 << 22;

/// What gives the bytes of a file beside the input, by the name that the input states, or says why
/// it does not.
pub type Files<'a> = &'a mut dyn FnMut(&str) -> Result<Vec<u8>, String>;

/// Reads a `.gltf` or a `.glb`, with `files` for buffers that are files of their own.
///
/// # Errors
/// [`GltfError`] names the element and the rule broken.
pub fn read(bytes: &[u8], files: Files) -> Result<GltfFile, GltfError> {
    let file = parse(bytes)?;
    let root = file.document.into_json();
    let buffers = buffer::all(&root, file.blob, files)?;
    let mut walk = Walk {
        accessors: Accessors { root: &root, buffers: &buffers },
        root: &root,
        met: vec![false; root.nodes.len()],
        triangles: 0,
        file: GltfFile::default(),
    };
    let scene = root.scene.map_or(0, |scene| scene.value());
    let Some(scene) = root.scenes.get(scene) else {
        return Err(error("scenes".to_owned(), GltfErrorKind::NoScene));
    };
    // Parents before children, each in the file's order.
    let mut open: Vec<(usize, Affine)> =
        scene.nodes.iter().rev().map(|node| (node.value(), Affine::identity())).collect();
    while let Some((node, parent)) = open.pop() {
        let here = walk.node(node, &parent)?;
        let children = root.nodes[node].children.iter().flatten().rev();
        open.extend(children.map(|child| (child.value(), here.clone())));
    }
    Ok(walk.file)
}

fn error(place: String, kind: GltfErrorKind) -> GltfError {
    GltfError { place, kind }
}

/// The container and the JSON, validated: all indices name something.
fn parse(bytes: &[u8]) -> Result<gltf::Gltf, GltfError> {
    let syntax = |place: &str, what: String| error(place.to_owned(), GltfErrorKind::Syntax(what));
    if bytes.starts_with(b"glTF") {
        let stated = bytes.get(8..12).map(|length| u32::from_le_bytes(length.try_into().unwrap()));
        match stated {
            Some(stated @ 20..) if stated as usize <= bytes.len() => {}
            Some(stated) => {
                let what = format!("states {stated} bytes, but the file has {}", bytes.len());
                return Err(syntax("header", what));
            }
            None => return Err(syntax("header", "12 bytes expected".to_owned())),
        }
    }
    let broken = |found: gltf::Error| match found {
        gltf::Error::Binary(what) => syntax("container", what.to_string()),
        gltf::Error::Deserialize(what) => syntax("JSON", what.to_string()),
        gltf::Error::Validation(all) => match all.first() {
            Some((path, what)) => syntax(path.as_str(), what.to_string()),
            None => syntax("JSON", "invalid".to_owned()),
        },
        other => syntax("file", other.to_string()),
    };
    let read = gltf::Gltf::from_slice_without_validation(bytes).map_err(broken)?;
    let root = read.document.into_json();
    if let Some(place) = stray_attribute(&root) {
        return Err(syntax(&place, "Index out of bounds".to_owned()));
    }
    let document = gltf::Document::from_json(root).map_err(broken)?;
    Ok(gltf::Gltf { document, blob: read.blob })
}

/// The place of an attribute whose accessor is not there: the crate's own validation looks
/// positions up before it checks that they are.
fn stray_attribute(root: &Root) -> Option<String> {
    let meshes = root.meshes.iter().enumerate();
    let primitives = meshes.flat_map(|(mesh, stated)| {
        stated.primitives.iter().enumerate().map(move |(number, one)| (mesh, number, one))
    });
    primitives
        .filter(|(_, _, primitive)| {
            primitive.attributes.values().any(|accessor| accessor.value() >= root.accessors.len())
        })
        .map(|(mesh, number, _)| format!("meshes[{mesh}].primitives[{number}].attributes"))
        .next()
}

struct Walk<'a> {
    root: &'a Root,
    accessors: Accessors<'a>,
    /// Whether a node has been met.
    met: Vec<bool>,
    triangles: usize,
    file: GltfFile,
}

impl Walk<'_> {
    /// Adds a node's mesh, and returns the node's transform.
    fn node(&mut self, index: usize, parent: &Affine) -> Result<Affine, GltfError> {
        let place = || format!("nodes[{index}]");
        if std::mem::replace(&mut self.met[index], true) {
            return Err(error(place(), GltfErrorKind::NotATree));
        }
        let node = &self.root.nodes[index];
        let here = Affine::of_node(node).and_then(|own| parent.after(&own));
        let here = here.map_err(|what| error(place(), GltfErrorKind::Transform(what)))?;
        let Some(mesh_index) = node.mesh.map(|mesh| mesh.value()) else { return Ok(here) };
        let mesh = &self.root.meshes[mesh_index];
        let name = node.name.clone().or_else(|| mesh.name.clone()).unwrap_or_else(place);
        let is_morphed = mesh.primitives.iter().any(|primitive| primitive.targets.is_some());
        self.file.deformed += usize::from(node.skin.is_some() || is_morphed);
        for (number, primitive) in mesh.primitives.iter().enumerate() {
            let Some(turn) = turns(primitive) else {
                self.file.other_primitives += 1;
                continue;
            };
            let place = || format!("meshes[{mesh_index}].primitives[{number}]");
            let (vertices, corners) = self.primitive(primitive, place)?;
            let triangles = turn(&corners);
            self.triangles += triangles.len();
            if self.triangles > MAX_TRIANGLES {
                return Err(error(place(), GltfErrorKind::TooLarge));
            }
            let vertices = vertices.iter().map(|vertex| here.apply(vertex)).collect();
            self.file.parts.push(GltfPart { name: name.clone(), vertices, triangles });
        }
        Ok(here)
    }

    /// The vertices of a primitive, and the indices of its corners in a row.
    fn primitive(
        &self,
        primitive: &Primitive,
        place: impl Fn() -> String,
    ) -> Result<(Vec<RationalPoint3>, Vec<u32>), GltfError> {
        let positions = primitive.attributes.get(&Checked::Valid(Semantic::Positions));
        let Some(positions) = positions.map(Index::value) else {
            let kind = GltfErrorKind::Unsupported("without positions, which an extension may hold");
            return Err(error(place(), kind));
        };
        let vertices = self.accessors.points(positions)?;
        let corners = match primitive.indices.map(|indices| indices.value()) {
            Some(indices) => self.accessors.indices(indices)?,
            None => (0..vertices.len() as u32).collect(),
        };
        match corners.iter().find(|&&corner| corner as usize >= vertices.len()) {
            None => Ok((vertices, corners)),
            Some(&got) => {
                let vertices = vertices.len();
                Err(error(place(), GltfErrorKind::MissingVertex { got, vertices }))
            }
        }
    }
}

/// Makes triangles of corners in a row.
type Turn = fn(&[u32]) -> Vec<[u32; 3]>;

/// How the corners of a primitive become triangles; `None` for points and lines.
fn turns(primitive: &Primitive) -> Option<Turn> {
    match primitive.mode {
        Checked::Valid(Mode::Triangles) => {
            Some(|corners| corners.chunks_exact(3).map(|t| [t[0], t[1], t[2]]).collect())
        }
        // Every second one runs the other way.
        Checked::Valid(Mode::TriangleStrip) => Some(|corners| {
            let windows = corners.windows(3).enumerate();
            windows
                .map(|(i, t)| if i % 2 == 0 { [t[0], t[1], t[2]] } else { [t[1], t[0], t[2]] })
                .collect()
        }),
        Checked::Valid(Mode::TriangleFan) => Some(|corners| {
            let rim = corners.get(1..).unwrap_or_default();
            rim.windows(2).map(|pair| [corners[0], pair[0], pair[1]]).collect()
        }),
        Checked::Valid(Mode::Points | Mode::Lines | Mode::LineLoop | Mode::LineStrip)
        | Checked::Invalid => None,
    }
}

#[cfg(test)]
mod tests;
