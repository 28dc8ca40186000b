use super::*;
use crate::num::{Int, parse_decimal};

fn point(coordinates: [&str; 3]) -> RationalPoint3 {
    RationalPoint3::from(&coordinates.map(|text| parse_decimal(text).unwrap()))
}

/// A wedge with thirds in it, a lone triangle, and nothing.
fn groups() -> Vec<MeshGroup> {
    let square = [["0", "0", "0"], ["1", "0", "0.125"], ["1", "1/3", "0.125"], ["0", "1/3", "0"]];
    let side = [["0", "0", "0"], ["1", "0", "-2"], ["1", "0", "0.125"]];
    let far = [["100000000.5", "0", "0"], ["0", "16777217", "0"], ["0", "0", "0.1"]];
    let polygon = |points: &[[&str; 3]]| points.iter().map(|&p| point(p)).collect::<Vec<_>>();
    vec![
        MeshGroup { name: "a wedge".into(), polygons: vec![polygon(&square), polygon(&side)] },
        MeshGroup { name: "far\n\"away\"".into(), polygons: vec![polygon(&far)] },
        MeshGroup { name: String::new(), polygons: Vec::new() },
    ]
}

#[test]
fn an_obj_reads_back_equal_but_for_thirds() {
    let mut bytes = Vec::new();
    let largest = write_obj(&groups(), &mut bytes).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    let third = Rational::new(Int::from(1), Int::from(3));
    let near = Rational::from_float(1.0 / 3.0).unwrap();
    assert_eq!(largest, (&third - &near).abs());
    assert!(text.starts_with("# 2 of 24 coordinates have no finite decimal"), "{text}");
    let lines = |start: &str| -> Vec<Vec<String>> {
        let found = text.lines().filter_map(|line| line.strip_prefix(start));
        found.map(|rest| rest.split(' ').map(str::to_owned).collect()).collect()
    };
    // The origin and the corner of both polygons are there once; the third is the shortest text.
    let vertices = lines("v ");
    assert_eq!(vertices.len(), 8);
    assert_eq!(vertices[2], ["1", "0.3333333333333333", "0.125"]);
    assert_eq!(lines("f "), [vec!["1", "2", "3", "4"], vec!["1", "5", "2"], vec!["6", "7", "8"]]);
    assert_eq!(lines("o "), [["a_wedge"], ["far_\"away\""], ["_"]]);
    let exact: Vec<Vec<Rational>> = (vertices[4..].iter())
        .map(|line| line.iter().map(|text| parse_decimal(text).unwrap()).collect())
        .collect();
    assert_eq!(exact[0], point(["1", "0", "-2"]).coordinates());
    assert_eq!(exact[1], point(["100000000.5", "0", "0"]).coordinates());
}

#[test]
fn an_obj_of_decimals_is_exact() {
    let mut groups = groups();
    groups.remove(0);
    let mut bytes = Vec::new();
    assert!(write_obj(&groups, &mut bytes).unwrap().is_zero());
    assert!(bytes.starts_with(b"# Coordinates are exact.\nv 100000000.5 0 0\n"));
}

/// The document and the binary part of a GLB file, its layout checked.
fn parts(bytes: &[u8]) -> (Value, &[u8]) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!(&bytes[..4], b"glTF");
    assert_eq!([word(4), word(8)], [2, bytes.len()]);
    let text = word(12);
    assert_eq!((&bytes[16..20], text % 4), (b"JSON".as_slice(), 0));
    let document = serde_json::from_slice(&bytes[20..20 + text]).unwrap();
    let rest = 20 + text;
    if rest == bytes.len() {
        return (document, &[]);
    }
    assert_eq!(&bytes[rest + 4..rest + 8], b"BIN\0");
    let binary = &bytes[rest + 8..];
    assert_eq!((word(rest), binary.len() % 4), (binary.len(), 0));
    (document, binary)
}

/// An accessor's words.
fn words(document: &Value, binary: &[u8], accessor: &Value) -> (Value, Vec<[u8; 4]>) {
    let accessor = document["accessors"][accessor.as_u64().unwrap() as usize].clone();
    let view = &document["bufferViews"][accessor["bufferView"].as_u64().unwrap() as usize];
    let start = view["byteOffset"].as_u64().unwrap() as usize;
    let end = start + view["byteLength"].as_u64().unwrap() as usize;
    (accessor, binary[start..end].chunks(4).map(|word| word.try_into().unwrap()).collect())
}

#[test]
fn a_glb_reads_back_to_the_nearest_floats() {
    let groups = groups();
    let mut bytes = Vec::new();
    let largest = write_glb(&groups, &mut bytes).unwrap();
    // 16777217 lies between two floats, one off each; 100000000.5 is half off a multiple of 8.
    assert_eq!(largest, Rational::from(Int::from(1)));
    let (document, binary) = parts(&bytes);
    assert_eq!(document["buffers"][0]["byteLength"], binary.len());
    assert_eq!(document["scenes"][0]["nodes"], json!([0, 1, 2]));
    assert_eq!(document["nodes"][1], json!({"name": "far\n\"away\"", "mesh": 1}));
    assert_eq!(document["nodes"][2], json!({"name": ""}));
    for (group, mesh) in groups.iter().zip(document["meshes"].as_array().unwrap()) {
        let primitive = &mesh["primitives"][0];
        let position = &primitive["attributes"]["POSITION"];
        let (accessor, floats) = words(&document, binary, position);
        assert_eq!(accessor["componentType"], 5126);
        assert_eq!(accessor["type"], "VEC3");
        let floats: Vec<f32> = floats.into_iter().map(f32::from_le_bytes).collect();
        let points: Vec<&[f32]> = floats.chunks(3).collect();
        assert_eq!(accessor["count"], points.len());
        for axis in 0..3 {
            let all = || points.iter().map(|p| p[axis]);
            let stated = |name: &str| accessor[name][axis].as_f64().unwrap();
            assert_eq!(stated("min"), f64::from(all().fold(f32::INFINITY, f32::min)));
            assert_eq!(stated("max"), f64::from(all().fold(f32::NEG_INFINITY, f32::max)));
        }
        let (accessor, indices) = words(&document, binary, &primitive["indices"]);
        assert_eq!(accessor["componentType"], 5125);
        let fans: Vec<&RationalPoint3> = (group.polygons.iter())
            .flat_map(|p| (2..p.len()).flat_map(|i| [&p[0], &p[i - 1], &p[i]]))
            .collect();
        assert_eq!(accessor["count"], fans.len());
        for (exact, index) in fans.iter().zip(indices) {
            let near = points[u32::from_le_bytes(index) as usize];
            for (exact, near) in exact.coordinates().iter().zip(near) {
                let distance = |near: f32| off(exact, f64::from(near)).unwrap();
                assert!(distance(*near) <= distance(near.next_up()));
                assert!(distance(*near) <= distance(near.next_down()));
            }
        }
    }
}

#[test]
fn rounding_twice_is_not_nearest() {
    // Just above the middle of two floats: the nearest double is the middle, whose nearest float
    // is the even one below.
    let exact =
        Rational::from(Int::from(16_777_217)) + Rational::new(1.into(), Int::from(10).pow(30));
    assert_eq!(exact.to_f64().unwrap() as f32, 16_777_216.0);
    assert_eq!(Glb::default().single(&exact).unwrap(), 16_777_218.0);
}

#[test]
fn a_glb_of_nothing_has_no_empty_lists() {
    let mut bytes = Vec::new();
    assert!(write_glb(&[], &mut bytes).unwrap().is_zero());
    let (document, binary) = parts(&bytes);
    assert!(binary.is_empty());
    let mut names: Vec<&String> = document.as_object().unwrap().keys().collect();
    names.sort();
    assert_eq!(names, ["asset", "scene", "scenes"]);
    assert_eq!(document["scenes"], json!([{}]));
}

#[test]
fn what_no_float_holds_is_refused() {
    let triangle = vec![point(["1e39", "0", "0"]), point(["0", "1", "0"]), point(["0", "0", "1"])];
    let group = MeshGroup { name: "huge".into(), polygons: vec![triangle] };
    let error = write_glb(std::slice::from_ref(&group), &mut Vec::new()).unwrap_err();
    assert!(error.to_string().contains("too large"), "{error}");
    assert!(write_obj(&[group], &mut Vec::new()).unwrap().is_zero());
}
