//! Meshes for other programs: OBJ (text) and binary glTF 2.0 (GLB), written only.
//!
//! Groups of convex polygons become named objects. Vertices are shared where they are equal
//! exactly. OBJ keeps polygons, and coordinates with a finite decimal exactly; GLB holds triangles
//! (fans of the polygons) and single floats. A coordinate that the file cannot hold goes to the
//! nearest that it can, and the writers return the largest displacement. Linear in the vertices,
//! up to the lookup of equal ones.

use crate::geom::RationalPoint3;
use crate::num::{Rational, format_decimal};
use num_traits::{Signed, ToPrimitive, Zero};
use rustc_hash::FxHashMap;
use serde_json::{Value, json};
use std::io::{self, Write};

#[cfg(test)]
mod tests;

/// What becomes one object of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshGroup {
    /// Its name.
    pub name: String,
    /// Convex polygons, counter-clockwise as seen from outside.
    pub polygons: Vec<Vec<RationalPoint3>>,
}

/// Writes an OBJ file: an object for each group, a face for each polygon. Returns the largest
/// displacement of a coordinate, in world units.
///
/// # Errors
/// A failure of the output, or a coordinate that has no finite decimal and exceeds every double.
pub fn write_obj(groups: &[MeshGroup], out: &mut dyn Write) -> io::Result<Rational> {
    let mut vertices = Shared::default();
    let faces: Vec<Vec<Vec<usize>>> = groups.iter().map(|group| vertices.polygons(group)).collect();
    let (mut largest, mut rounded) = (Rational::zero(), 0usize);
    let mut lines = Vec::with_capacity(vertices.points.len());
    for point in &vertices.points {
        let mut line = String::from("v");
        for exact in point.coordinates() {
            let text = match format_decimal(&exact) {
                Some(text) => text,
                None => {
                    let near = nearest_double(&exact)?;
                    rounded += 1;
                    largest = largest.max(off(&exact, near)?);
                    near.to_string()
                }
            };
            line.push(' ');
            line.push_str(&text);
        }
        lines.push(line);
    }
    match rounded {
        0 => writeln!(out, "# Coordinates are exact.")?,
        _ => writeln!(
            out,
            "# {rounded} of {} coordinates have no finite decimal and are the nearest doubles;\n\
             # the others are exact. The largest displacement is {largest}.",
            3 * lines.len()
        )?,
    }
    for line in lines {
        writeln!(out, "{line}")?;
    }
    for (group, faces) in groups.iter().zip(faces) {
        writeln!(out, "o {}", object_name(&group.name))?;
        for face in faces {
            let corners: Vec<String> = face.iter().map(|index| format!(" {}", index + 1)).collect();
            writeln!(out, "f{}", corners.concat())?;
        }
    }
    Ok(largest)
}

/// Writes a GLB file: a mesh and a node for each group, an empty node for a group without
/// polygons. Returns the largest displacement of a coordinate, in world units. Axes are kept as
/// they are: x, y, z of the file are those of the world.
///
/// # Errors
/// A failure of the output, a coordinate that exceeds every single float, or more bytes than the
/// format can count (4 GiB).
pub fn write_glb(groups: &[MeshGroup], out: &mut dyn Write) -> io::Result<Rational> {
    let mut glb = Glb::default();
    for group in groups {
        glb.push(group)?;
    }
    let mut text = glb.document().to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    // Each piece of the binary part has a length that four divides.
    let binary = glb.binary;
    let binary_chunk = if binary.is_empty() { 0 } else { 8 + binary.len() };
    out.write_all(b"glTF")?;
    out.write_all(&2u32.to_le_bytes())?;
    out.write_all(&length(12 + 8 + text.len() + binary_chunk)?)?;
    out.write_all(&length(text.len())?)?;
    out.write_all(b"JSON")?;
    out.write_all(&text)?;
    if !binary.is_empty() {
        out.write_all(&length(binary.len())?)?;
        out.write_all(b"BIN\0")?;
        out.write_all(&binary)?;
    }
    Ok(glb.largest)
}

/// Points by number, equal ones once, in the order of their first use.
#[derive(Default)]
struct Shared<'a> {
    points: Vec<&'a RationalPoint3>,
    numbers: FxHashMap<&'a RationalPoint3, usize>,
}

impl<'a> Shared<'a> {
    fn polygons(&mut self, group: &'a MeshGroup) -> Vec<Vec<usize>> {
        let mut number = |point: &'a RationalPoint3| {
            *self.numbers.entry(point).or_insert_with(|| {
                self.points.push(point);
                self.points.len() - 1
            })
        };
        group.polygons.iter().map(|polygon| polygon.iter().map(&mut number).collect()).collect()
    }
}

/// The parts of a GLB file.
#[derive(Default)]
struct Glb {
    binary: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    meshes: Vec<Value>,
    nodes: Vec<Value>,
    largest: Rational,
}

/// The numbers that the specification gives to what is in a buffer.
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;

impl Glb {
    fn push(&mut self, group: &MeshGroup) -> io::Result<()> {
        let mut vertices = Shared::default();
        let polygons = vertices.polygons(group);
        let fan = |polygon: &Vec<usize>| -> Vec<usize> {
            let pairs = polygon.windows(2).skip(1);
            pairs.flat_map(|pair| [polygon[0], pair[0], pair[1]]).collect()
        };
        let indices: Vec<usize> = polygons.iter().flat_map(fan).collect();
        if indices.is_empty() {
            self.nodes.push(json!({"name": group.name}));
            return Ok(());
        }
        let mut positions = Vec::with_capacity(vertices.points.len());
        for point in &vertices.points {
            let [x, y, z] = point.coordinates();
            positions.push([self.single(&x)?, self.single(&y)?, self.single(&z)?]);
        }
        let extreme = |pick: fn(f32, f32) -> f32| -> Vec<f64> {
            let first = positions[0];
            let all = positions.iter().fold(first, |m, p| [0, 1, 2].map(|i| pick(m[i], p[i])));
            // As doubles, whose text is read back as the same number.
            all.map(f64::from).to_vec()
        };
        let view = self.view(ARRAY_BUFFER, positions.iter().flatten().map(|c| c.to_le_bytes()));
        let position = self.accessor(json!({
            "bufferView": view, "componentType": FLOAT, "type": "VEC3",
            "count": positions.len(), "min": extreme(f32::min), "max": extreme(f32::max),
        }));
        let numbers = indices.iter().map(|&index| (index as u32).to_le_bytes());
        let view = self.view(ELEMENT_ARRAY_BUFFER, numbers);
        let index = self.accessor(json!({
            "bufferView": view, "componentType": UNSIGNED_INT, "type": "SCALAR",
            "count": indices.len(),
        }));
        self.nodes.push(json!({"name": group.name, "mesh": self.meshes.len()}));
        let primitive = json!({"attributes": {"POSITION": position}, "indices": index});
        self.meshes.push(json!({"name": group.name, "primitives": [primitive]}));
        Ok(())
    }

    /// The float nearest to a coordinate.
    fn single(&mut self, exact: &Rational) -> io::Result<f32> {
        // The nearest double's nearest single is the right one or next to it.
        let guess = nearest_double(exact)? as f32;
        let mut best: Option<(Rational, f32)> = None;
        for near in [guess, guess.next_down(), guess.next_up()] {
            let Ok(off) = off(exact, f64::from(near)) else { continue };
            if best.as_ref().is_none_or(|(least, _)| off < *least) {
                best = Some((off, near));
            }
        }
        let (off, near) = best.filter(|_| guess.is_finite()).ok_or_else(|| too_large(exact))?;
        if off > self.largest {
            self.largest = off;
        }
        Ok(near)
    }

    fn view(&mut self, target: u32, words: impl Iterator<Item = [u8; 4]>) -> usize {
        let start = self.binary.len();
        self.binary.extend(words.flatten());
        self.views.push(json!({
            "buffer": 0, "byteOffset": start, "byteLength": self.binary.len() - start,
            "target": target,
        }));
        self.views.len() - 1
    }

    fn accessor(&mut self, accessor: Value) -> usize {
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// The JSON part; lists that the specification wants to have elements are left out if empty.
    fn document(&mut self) -> Value {
        let mut document = json!({"asset": {"version": "2.0", "generator": "stabline"}});
        let mut scene = json!({});
        if !self.nodes.is_empty() {
            scene["nodes"] = (0..self.nodes.len()).collect();
        }
        document["scene"] = json!(0);
        document["scenes"] = json!([scene]);
        let buffers = match self.binary.len() {
            0 => Vec::new(),
            bytes => vec![json!({"byteLength": bytes})],
        };
        for (name, list) in [
            ("nodes", std::mem::take(&mut self.nodes)),
            ("meshes", std::mem::take(&mut self.meshes)),
            ("accessors", std::mem::take(&mut self.accessors)),
            ("bufferViews", std::mem::take(&mut self.views)),
            ("buffers", buffers),
        ] {
            if !list.is_empty() {
                document[name] = Value::from(list);
            }
        }
        document
    }
}

/// The name on one line and without blanks, which some readers end a name at.
fn object_name(name: &str) -> String {
    let name = name.replace(|c: char| c.is_whitespace() || c.is_control(), "_");
    if name.is_empty() { "_".to_owned() } else { name }
}

fn nearest_double(exact: &Rational) -> io::Result<f64> {
    exact.to_f64().filter(|near| near.is_finite()).ok_or_else(|| too_large(exact))
}

/// How far a float is from what it stands for.
fn off(exact: &Rational, near: f64) -> io::Result<Rational> {
    let near = Rational::from_float(near).ok_or_else(|| too_large(exact))?;
    Ok((exact - near).abs())
}

fn too_large(exact: &Rational) -> io::Error {
    let size = exact.abs().to_integer().bits();
    let what = format!("a coordinate of {size} bits is too large for the file's floats");
    io::Error::new(io::ErrorKind::InvalidData, what)
}

fn length(bytes: usize) -> io::Result<[u8; 4]> {
    let what = "a GLB file holds at most 4 GiB";
    let bytes = u32::try_from(bytes);
    Ok(bytes.map_err(|_| io::Error::new(io::ErrorKind::InvalidData, what))?.to_le_bytes())
}
