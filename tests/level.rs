//! Levels: every scene of `scenes/level` against its snapshot, and the public maps where they are.

mod support;

use proptest::prelude::*;
use stabline::formats::map;
use stabline::scene::level::Role;
use stabline::scene::{Level, LevelOptions, read_level};
use std::fmt::Write;
use std::path::Path;
use support::{maps, root, scenes};

const ROLES: [Role; 5] = [Role::Solid, Role::Detail, Role::Hint, Role::Liquid, Role::Ignored];

fn read(path: &Path, options: LevelOptions) -> Level {
    read_level(&path.to_string_lossy(), &std::fs::read(path).unwrap(), options).unwrap()
}

/// The comments that a scene opens with.
fn about(path: &Path) -> String {
    let text = std::fs::read_to_string(path).unwrap();
    let lines = text.lines().map_while(|line| line.strip_prefix("// "));
    lines.collect::<Vec<_>>().join(" ")
}

/// One line a brush, face, entity and warning.
fn describe(level: &Level) -> String {
    let mut text = String::new();
    for entity in &level.entities {
        let origin = entity.origin.as_ref().map_or(String::new(), |origin| {
            let [x, y, z] = origin.numerators();
            format!(", origin ({x}, {y}, {z})/{}", origin.denominator())
        });
        let place = if entity.is_point { ", a point" } else { "" };
        writeln!(text, "entity `{}`{place}{origin}", entity.class).unwrap();
    }
    let mut before: Vec<_> = Vec::new();
    for brush in &level.brushes {
        let class = &level.entities[brush.entity].class;
        write!(text, "line {}: {:?} brush of `{class}`", brush.line, brush.role).unwrap();
        let faces: Vec<_> = brush.faces.iter().map(|face| (&face.plane, face.splits)).collect();
        if faces == before {
            text.push_str(", its faces as before\n");
            continue;
        }
        before = faces;
        text.push('\n');
        for face in &brush.faces {
            let [x, y, z] = &face.plane.normal;
            let splits = if face.splits { "" } else { ", no split" };
            writeln!(text, "  ({x}, {y}, {z}) <= {}{splits}", face.plane.offset).unwrap();
        }
    }
    for warning in &level.warnings {
        writeln!(text, "{warning}").unwrap();
    }
    text
}

#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/level"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let scenes = scenes("scenes/level");
    assert!(!scenes.is_empty());
    for path in scenes {
        let text = describe(&read(&path, LevelOptions::default()));
        settings.set_description(about(&path));
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        settings.bind(|| insta::assert_snapshot!(name, text));
    }
}

#[test]
fn every_public_map_is_read() {
    let Some(maps) = maps() else { return };
    // Faces as counted by `grep -c '^( '`.
    let expected = [
        ("lq_e0m1", 5095),
        ("lqdm1", 4752),
        ("lqdm6", 8849),
        ("lq_e1m2", 11408),
        ("lq_e0m8", 8432),
        ("lq_e1m5", 25764),
    ];
    for (name, faces) in expected {
        let bytes = std::fs::read(maps.join(name).join(format!("{name}.map"))).unwrap();
        let start = std::time::Instant::now();
        let file = map::read(&bytes).unwrap();
        let parsed = start.elapsed();
        let level = Level::from_map(&file, LevelOptions::default());
        let built = start.elapsed() - parsed;
        let count = |role: Role| level.brushes.iter().filter(|brush| brush.role == role).count();
        println!(
            "{name}: {} brushes, {:?}, {} faces, {} entities, {} places, {} warnings, \
             parsed in {parsed:?}, built in {built:?}",
            level.brushes.len(),
            ROLES.map(|role| (role, count(role))),
            level.brushes.iter().map(|brush| brush.faces.len()).sum::<usize>(),
            level.entities.len(),
            stabline::scene::World::of_level(&level).marks().len(),
            level.warnings.len(),
        );
        for warning in &level.warnings {
            println!("  {warning}");
        }
        let stated = file.entities.iter().flat_map(|entity| &entity.brushes);
        assert_eq!(stated.map(|brush| brush.faces.len()).sum::<usize>(), faces, "{name}");
    }
}

/// A box of the side 8, its faces in the order of the axes.
const BOX: [&str; 6] = [
    "( 0 0 0 ) ( 0 1 0 ) ( 0 0 1 ) wall 0 0 0 1 1",
    "( 8 0 0 ) ( 8 0 1 ) ( 8 1 0 ) wall 0 0 0 1 1",
    "( 0 0 0 ) ( 0 0 1 ) ( 1 0 0 ) wall 0 0 0 1 1",
    "( 0 8 0 ) ( 1 8 0 ) ( 0 8 1 ) wall 0 0 0 1 1",
    "( 0 0 0 ) ( 1 0 0 ) ( 0 1 0 ) wall 0 0 0 1 1",
    "( 0 0 8 ) ( 0 1 8 ) ( 1 0 8 ) wall 0 0 0 1 1",
];

fn world(brush: &str) -> String {
    format!("{{\n\"classname\" \"worldspawn\"\n{{\n{brush}\n}}\n}}\n")
}

fn level(text: &str) -> Level {
    read_level("x.map", text.as_bytes(), LevelOptions::default()).unwrap()
}

#[test]
fn errors_name_the_file_the_line_and_the_rule() {
    let face = BOX[0];
    let with = |old: &str, new: &str| world(&face.replacen(old, new, 1));
    let pairs = "{\n\"classname\" \"worldspawn\"\n";
    let cases = [
        (String::new(), "x.map:1: no entity, expected `{`"),
        ("// nothing\n".to_owned(), "x.map:2: no entity, expected `{`"),
        ("worldspawn".to_owned(), "x.map:1: expected `{` of an entity, got `worldspawn`"),
        (format!("{pairs}}}\n}}"), "x.map:4: expected `{` of an entity, got `}`"),
        (
            pairs.to_owned(),
            "x.map:3: the file ends in the entity that line 1 opens, expected a key in quotes, \
             `{` or `}`",
        ),
        (
            format!("{pairs}{{\n{face}"),
            "x.map:4: the file ends in the brush that line 3 opens, expected `(` of a face, or `}`",
        ),
        (format!("{pairs}wad"), "x.map:3: expected a key in quotes, `{` or `}`, got `wad`"),
        (
            format!("{pairs}\"wad\" 7"),
            "x.map:3: expected the value of a key in quotation marks, got `7`",
        ),
        (
            format!("{pairs}\"wad\" \"a\n\"}}"),
            "x.map:3: a text in quotation marks does not end on its line, expected `\"`",
        ),
        (
            with("1 0", "nan 0"),
            "x.map:4: point 2 of a face: coordinate `nan`: not a decimal number or a ratio of \
             integers",
        ),
        (with("1 0 )", "1 )"), "x.map:4: expected a coordinate, got `)`"),
        (with("1 0 )", "1 0 0 )"), "x.map:4: expected `)` after three coordinates, got `0`"),
        (with("( 0 0 1 ) ", ""), "x.map:4: expected `(` of the third point, got `wall`"),
        (with("wall 0", "0"), "x.map:5: expected a number of the texture's alignment, got `}`"),
        (
            with("wall 0 0", "wall [ 1 0 0 ] 0"),
            "x.map:4: expected a number of a texture axis, got `]`",
        ),
        (with("1 1", "1 x"), "x.map:4: expected a number of the texture's alignment, got `x`"),
        (
            world("brushDef\n{\n}"),
            "x.map:4: `brushDef` is not read, expected a brush in the standard or the Valve 220 \
             form",
        ),
        (world("mesh"), "x.map:4: expected `(` of a face, `}` or the name of a patch, got `mesh`"),
        (world(&[face; 1025].join("\n")), "x.map:1028: a brush of more than 1024 faces"),
    ];
    for (text, expected) in cases {
        let error = read_level("x.map", text.as_bytes(), LevelOptions::default()).unwrap_err();
        assert_eq!(error.to_string(), expected, "{text}");
    }
}

#[test]
fn what_does_not_matter_to_geometry_is_read_over() {
    let plain = level(&world(&BOX.join("\n")));
    assert_eq!((plain.brushes.len(), plain.warnings.len()), (1, 0));
    for (old, new) in [
        ("0 0 0 1 1", "[ 1 0 0 nan ] [ 0 -1 0 0.5 ] 0 1 -1e-3"),
        ("0 0 0 1 1", "0 0 0 1 1 -1"),
        ("0 0 0 1 1", "0 0 0 1 1 0 0 0 // a comment {"),
        ("wall", "\"wall with a blank\""),
        ("wall", "+0button"),
        ("( 0 0", "(0 0"),
        ("8", "8.000"),
        ("8", "+80e-1"),
        ("\n", "\r\n"),
    ] {
        let text = world(&BOX.join("\n")).replace(old, new);
        assert_eq!(level(&text), plain, "{text}");
    }
    let with_path = "{\n\"classname\" \"worldspawn\"\n\"wad\" \"c:\\maps\\\"\n\"_x\" \"\u{e4}\"\n}";
    assert!(level(with_path).warnings.is_empty());
}

#[test]
fn options_change_the_roles_of_liquids_and_of_what_is_not_drawn() {
    let opaque = LevelOptions { opaque_liquids: true, ..LevelOptions::default() };
    let through = LevelOptions { see_through_skip: true, ..LevelOptions::default() };
    for (texture, options, role) in [
        ("*water0", LevelOptions::default(), Role::Liquid),
        ("*water0", opaque, Role::Solid),
        ("skip", LevelOptions::default(), Role::Solid),
        ("skip", through, Role::Ignored),
        ("hintskip", LevelOptions::default(), Role::Ignored),
    ] {
        let text = world(&BOX.join("\n").replace("wall", texture));
        let level = read_level("x", text.as_bytes(), options).unwrap();
        assert_eq!(level.brushes[0].role, role, "{texture}");
    }
}

#[test]
fn the_order_of_faces_changes_no_face() {
    // A box with a cut corner, a cut that misses and one that only touches an edge.
    let more = [
        "( 8 8 4 ) ( 8 4 8 ) ( 4 8 8 ) wall 0 0 0 1 1",
        "( 9 8 8 ) ( 8 8 9 ) ( 8 9 8 ) wall 0 0 0 1 1",
        "( 8 0 0 ) ( 8 0 1 ) ( 9 1 0 ) wall 0 0 0 1 1",
    ];
    let mut faces: Vec<&str> = BOX.iter().chain(&more).copied().collect();
    for cut in [1, -1] {
        for _ in 0..faces.len() {
            faces.rotate_left(1);
            let level = level(&world(&faces.join("\n")));
            let [brush] = level.brushes.as_slice() else { panic!("{:?}", level.warnings) };
            let mut planes: Vec<String> =
                brush.faces.iter().map(|face| format!("{:?}", face.plane)).collect();
            planes.sort();
            planes.dedup();
            assert_eq!((planes.len(), level.warnings.len()), (7, 2), "{cut}: {faces:?}");
        }
        faces.reverse();
    }
}

/// A half-space n·x <= o as [n, o].
type HalfSpace = [i128; 4];

fn determinant(a: [i128; 3], b: [i128; 3], c: [i128; 3]) -> i128 {
    a[0] * (b[1] * c[2] - b[2] * c[1])
        + a[1] * (b[2] * c[0] - b[0] * c[2])
        + a[2] * (b[0] * c[1] - b[1] * c[0])
}

/// The planes that hold a face of what the half-spaces enclose, by trying all triples of planes;
/// none where it has no volume. What they enclose must be bounded.
fn twin(planes: &[HalfSpace]) -> Vec<HalfSpace> {
    let normal = |p: HalfSpace| [p[0], p[1], p[2]];
    // Homogeneous corners (x, y, z, w) with w > 0.
    let mut corners: Vec<[i128; 4]> = Vec::new();
    let excess =
        |p: &HalfSpace, v: &[i128; 4]| p[0] * v[0] + p[1] * v[1] + p[2] * v[2] - p[3] * v[3];
    for (i, &p) in planes.iter().enumerate() {
        for (j, &q) in planes.iter().enumerate().take(i) {
            for &r in &planes[..j] {
                let w = determinant(normal(p), normal(q), normal(r));
                if w == 0 {
                    continue;
                }
                let column = |axis: usize| {
                    let replaced = [p, q, r].map(|plane| {
                        let mut row = normal(plane);
                        row[axis] = plane[3];
                        row
                    });
                    determinant(replaced[0], replaced[1], replaced[2]) * w.signum()
                };
                let corner = [column(0), column(1), column(2), w.abs()];
                if planes.iter().all(|plane| excess(plane, &corner) <= 0) {
                    corners.push(corner);
                }
            }
        }
    }
    // The corners' mean is inside strictly iff each plane is missed by some corner.
    if !planes.iter().all(|plane| corners.iter().any(|corner| excess(plane, corner) < 0)) {
        return Vec::new();
    }
    let holds_face = |plane: &&HalfSpace| {
        let on: Vec<_> = corners.iter().filter(|corner| excess(plane, corner) == 0).collect();
        let Some(first) = on.first() else { return false };
        let from_first = |v: &[i128; 4]| [0, 1, 2].map(|i| v[i] * first[3] - first[i] * v[3]);
        on.iter().any(|a| {
            let a = from_first(a);
            on.iter().any(|b| {
                let b = from_first(b);
                (0..3).any(|i| a[i] * b[(i + 1) % 3] != a[(i + 1) % 3] * b[i])
            })
        })
    };
    planes.iter().filter(holds_face).copied().collect()
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 1000,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    /// Random faces in a box, many of them degenerate, against the twin.
    #[test]
    fn the_faces_kept_are_those_of_the_twin(
        cuts in prop::collection::vec(prop::array::uniform3(prop::array::uniform3(0i128..5)), 1..6),
    ) {
        let mut faces: Vec<String> = BOX.iter().map(|face| (*face).to_owned()).collect();
        let mut planes: Vec<HalfSpace> = (0..3)
            .flat_map(|axis| {
                let unit = |n: i128| [0, 1, 2].map(|i| if i == axis { n } else { 0 });
                let ([a, b, c], [d, e, f]) = (unit(-1), unit(1));
                [[a, b, c, 0], [d, e, f, 8]]
            })
            .collect();
        for [a, b, c] in cuts {
            let point = |p: [i128; 3]| format!("( {} {} {} )", p[0], p[1], p[2]);
            faces.push(format!("{} {} {} wall 0 0 0 1 1", point(a), point(b), point(c)));
            let (p, q) = ([0, 1, 2].map(|i| c[i] - a[i]), [0, 1, 2].map(|i| b[i] - a[i]));
            let minor = |i: usize, j: usize| p[i] * q[j] - p[j] * q[i];
            let n = [minor(1, 2), minor(2, 0), minor(0, 1)];
            let offset = n[0] * a[0] + n[1] * a[1] + n[2] * a[2];
            let divisor = [n[0], n[1], n[2], offset].into_iter().fold(0, num_integer::gcd);
            let reduced = |c: i128| c.checked_div(divisor).unwrap_or(0);
            let plane = [n[0], n[1], n[2], offset].map(reduced);
            if n != [0; 3] && !planes.contains(&plane) {
                planes.push(plane);
            }
        }
        let level = level(&world(&faces.join("\n")));
        let kept = level.brushes.iter().flat_map(|brush| &brush.faces).map(|face| {
            let plane = &face.plane;
            let [x, y, z] = &plane.normal;
            [x, y, z, &plane.offset].map(|c| i128::try_from(c.clone()).unwrap())
        });
        prop_assert_eq!(kept.collect::<Vec<_>>(), twin(&planes));
    }
}
