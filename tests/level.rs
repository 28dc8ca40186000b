//! Levels: every scene of `scenes/level` against its snapshot, and the public maps where they are.

mod support;

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
    for brush in &level.brushes {
        let class = &level.entities[brush.entity].class;
        writeln!(text, "line {}: {:?} brush of `{class}`", brush.line, brush.role).unwrap();
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
            level.inside_points().count(),
            level.warnings.len(),
        );
        for warning in &level.warnings {
            println!("  {warning}");
        }
        let stated = file.entities.iter().flat_map(|entity| &entity.brushes);
        assert_eq!(stated.map(|brush| brush.faces.len()).sum::<usize>(), faces, "{name}");
    }
}
