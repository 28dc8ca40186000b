use super::accessor::dyadic;
use super::*;
use crate::num::{Int, Number, Rational};

/// A file of one triangle at `node`'s place, its vertices (0 0 0), (1 0 0), (0 0.5 -2), as two
/// containers: with the buffer embedded, and as `.glb`.
fn files(node: &str, accessor: &str) -> [Vec<u8>; 2] {
    let floats = [0f32, 0., 0., 1., 0., 0., 0., 0.5, -2.];
    let mut data: Vec<u8> = floats.iter().flat_map(|float| float.to_le_bytes()).collect();
    data.extend([0, 1, 2, 0]);
    let json = |buffer: &str| {
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0]}}], "nodes": [{node}],
"meshes": [{{"name": "wall", "primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1}}]}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3,
"min": [0, 0, -2], "max": [1, 0.5, 0]{accessor}}},
{{"bufferView": 1, "componentType": 5121, "type": "SCALAR", "count": 3}}],
"bufferViews": [{{"buffer": 0, "byteLength": 36}}, {{"buffer": 0, "byteOffset": 36, "byteLength": 3}}],
"buffers": [{{"byteLength": 39{buffer}}}]}}"#
        )
    };
    let embedded =
        json(&format!(r#", "uri": "data:application/octet-stream;base64,{}""#, base64(&data)));
    [embedded.into_bytes(), glb(&json(""), &data)]
}

fn base64(bytes: &[u8]) -> String {
    let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for three in bytes.chunks(3) {
        let word = three.iter().fold(0u32, |word, &byte| word << 8 | u32::from(byte));
        let word = word << (8 * (3 - three.len()));
        for place in 0..=three.len() {
            text.push(char::from(digits[(word >> (18 - 6 * place)) as usize & 63]));
        }
    }
    text
}

fn glb(json: &str, data: &[u8]) -> Vec<u8> {
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let word = |value: usize| (value as u32).to_le_bytes();
    let length = 28 + json.len() + data.len();
    let start = [&b"glTF"[..], &word(2), &word(length), &word(json.len()), b"JSON"].concat();
    [&start[..], &json, &word(data.len()), b"BIN\0", data].concat()
}

fn none(name: &str) -> Result<Vec<u8>, String> {
    Err(format!("`{name}` was not asked for"))
}

fn read_whole(bytes: &[u8]) -> Result<GltfFile, GltfError> {
    read(bytes, &mut none)
}

fn corners(node: &str) -> Vec<[Number; 3]> {
    let [embedded, glb] = files(node, "").map(|file| read_whole(&file).unwrap());
    assert_eq!(embedded, glb);
    assert_eq!(glb.parts[0].triangles, [[0, 1, 2]]);
    glb.parts[0].vertices.iter().map(<[Number; 3]>::from).collect()
}

fn numbers(points: [[&str; 3]; 3]) -> Vec<[Number; 3]> {
    points.map(|point| point.map(|text| Number::parse(text).unwrap())).to_vec()
}

#[test]
fn floats_are_the_dyadics_that_they_stand_for() {
    for float in [0f32, 1., -0.1, 0.5, f32::MAX, f32::MIN_POSITIVE, f32::from_bits(1), -1e10] {
        let exact = dyadic(float.to_bits()).unwrap();
        // Display is exact in this many digits.
        let text = format!("{float:.160}");
        assert_eq!(exact, crate::num::parse_decimal(&text).unwrap(), "{float}");
    }
    assert_eq!(dyadic(f32::INFINITY.to_bits()), None);
    assert_eq!(dyadic(f32::NAN.to_bits()), None);
}

#[test]
fn nodes_put_meshes_exactly() {
    let at_rest = numbers([["0", "0", "0"], ["1", "0", "0"], ["0", "1/2", "-2"]]);
    assert_eq!(corners(r#"{"mesh": 0}"#), at_rest);
    // A third of a turn about (1 1 1), by a quaternion of length 2.
    let turned = numbers([["3", "0", "0"], ["3", "1", "0"], ["1", "0", "1/2"]]);
    let node = r#"{"mesh": 0, "rotation": [1, 1, 1, 1], "translation": [3, 0, 0]}"#;
    assert_eq!(corners(node), turned);
    // Scaled first: z by 1/4; then about x by the angle whose half has the tangent 1/2.
    let node = r#"{"mesh": 0, "rotation": [1, 0, 0, 2], "scale": [2, 1, 0.25]}"#;
    let expected = numbers([["0", "0", "0"], ["2", "0", "0"], ["0", "7/10", "1/10"]]);
    assert_eq!(corners(node), expected);
    let matrix = r#"{"mesh": 0, "matrix": [2,0,0,0, 0,1,0,0, 0,0,1,0, 5,0,0,1]}"#;
    let expected = numbers([["5", "0", "0"], ["7", "0", "0"], ["5", "1/2", "-2"]]);
    assert_eq!(corners(matrix), expected);
    let nested = r#"{"children": [1], "scale": [2, 2, 2]}, {"mesh": 0, "translation": [1, 0, 0]}"#;
    let expected = numbers([["2", "0", "0"], ["4", "0", "0"], ["2", "1", "-4"]]);
    assert_eq!(corners(nested), expected);
}

/// Rotations keep lengths, whatever the quaternion.
#[test]
fn rotations_are_rotations() {
    let node = r#"{"mesh": 0, "rotation": [0.1, -0.7, 0.3, 0.2]}"#;
    let [_, glb] = files(node, "").map(|file| read_whole(&file).unwrap());
    let square =
        |point: &RationalPoint3| -> Rational { point.coordinates().iter().map(|c| c * c).sum() };
    let lengths: Vec<Rational> = glb.parts[0].vertices.iter().map(square).collect();
    let ratio = |p: i32, q: i32| Rational::new(Int::from(p), Int::from(q));
    assert_eq!(lengths, [ratio(0, 1), ratio(1, 1), ratio(17, 4)]);
}

#[test]
fn strips_and_fans_become_triangles() {
    let with = |mode: &str, indices: &str| {
        let [file, _] = files(r#"{"mesh": 0}"#, "");
        let text = String::from_utf8(file).unwrap();
        let text = text.replace(r#""indices": 1"#, &format!(r#""indices": 1, "mode": {mode}"#));
        let text = text.replace(r#""count": 3}],"#, &format!(r#""count": {indices}}}],"#));
        let text = text.replace(r#""byteLength": 3}],"#, r#""byteLength": 4}],"#);
        read_whole(text.replace(r#""byteLength": 39"#, r#""byteLength": 40"#).as_bytes()).unwrap()
    };
    assert_eq!(with("5", "4").parts[0].triangles, [[0, 1, 2], [2, 1, 0]]);
    assert_eq!(with("6", "4").parts[0].triangles, [[0, 1, 2], [0, 2, 0]]);
    let lines = with("1", "4");
    assert_eq!((lines.parts.len(), lines.other_primitives), (0, 1));
}

#[test]
fn files_beside_the_input_are_asked_for_by_name() {
    let [file, _] = files(r#"{"mesh": 0}"#, "");
    let text = String::from_utf8(file).unwrap();
    let start = text.find("data:").unwrap();
    let end = start + text[start..].find('"').unwrap();
    let text = [&text[..start], "a%20b.bin", &text[end..]].concat();
    let error = read_whole(text.as_bytes()).unwrap_err().to_string();
    assert_eq!(
        error,
        "buffers[0]: the buffer's bytes are not at hand: `a b.bin` was not asked for"
    );
    let mut give = |name: &str| if name == "a b.bin" { Ok(vec![0; 39]) } else { Err(name.into()) };
    assert_eq!(read(text.as_bytes(), &mut give).unwrap().parts.len(), 1);
    let mut short = |_: &str| Ok(vec![0; 38]);
    let error = read(text.as_bytes(), &mut short).unwrap_err().to_string();
    assert_eq!(error, "buffers[0]: 38 bytes are there, expected 39 or more");
}

#[test]
fn errors_name_the_element_and_the_rule() {
    let node = r#"{"mesh": 0}"#;
    let [embedded, glb] = files(node, "");
    let text = String::from_utf8(embedded).unwrap();
    let message = |bytes: &[u8]| read_whole(bytes).unwrap_err().to_string();
    for (from, to, expected) in [
        (r#""count": 3,"#, r#""count": 4,"#, "accessors[0]: 36 bytes are there, expected 48"),
        (r#""count": 3}"#, r#""count": 4}"#, "accessors[1]: 3 bytes are there, expected 4"),
        (r#""byteLength": 36"#, r#""byteLength": 99"#, "bufferViews[0]: 40 bytes are there"),
        ("VEC3", "VEC2", "accessors[0]: positions that are not three 32-bit floats"),
        ("5121", "5126", "accessors[1]: indices that are not unsigned integers"),
        (r#""indices": 1"#, r#""indices": 7"#, "meshes[0].primitives[0].indices: "),
        (r#""POSITION": 0"#, r#""POSITION": 5"#, "meshes[0].primitives[0].attributes: "),
        (r#"{"nodes": [0]}"#, "", "scenes: the file has no scene"),
        (r#"[{"mesh": 0}]"#, r#"[{"mesh": 0, "children": [0]}]"#, "nodes[0]: the node has two"),
        (r#"{"mesh": 0}"#, r#"{"mesh": 0, "rotation": [0,0,0,0]}"#, "nodes[0]: the rotation's"),
        ("AAAAAA", "/////w", "accessors[0]: coordinate 0 of element 0"),
        (";base64", "", "buffers[0]: the buffer's bytes are not at hand: its data URI is not"),
    ] {
        assert!(text.contains(from), "{from}");
        let got = message(text.replacen(from, to, 1).as_bytes());
        assert!(got.contains(expected) && !got.contains('\n'), "{got}");
    }
    for end in 0..glb.len() {
        assert!(!message(&glb[..end]).is_empty(), "{end}");
    }
    let [sparse, _] = files(
        node,
        r#", "sparse": {"count": 1, "indices": {"bufferView": 0, "componentType": 5121},
        "values": {"bufferView": 0}}"#,
    );
    assert_eq!(message(&sparse), "accessors[0]: sparse accessors are not read");
}
