//! `stabline move`: every scene against its snapshot, and what is refused.

mod support;

use support::{assert_fails, root, scenes, stabline, stdout};

/// The moves that each scene is asked for.
const MOVES: &[(&str, &[&str])] = &[
    (
        "pillars_shared_edge",
        &[
            // Between the pillars, and round them in either direction of the edge.
            "--from 32,112,32 --to 160,-16,32",
            "--from 32,112,32 --to 160,112,32",
            // From the edge itself, along a pillar and away from both.
            "--from 96,64,32 --to 160,64,32",
            "--from 96,64,32 --to 160,0,32",
            // Up the edge, and into a pillar from it.
            "--from 96,64,32 --to 96,64,128",
            "--from 96,64,32 --to 97,65,32",
            "--from 32,112,32 --to 160,-16,32 --box 1/1000,1/1000,1",
        ],
    ),
    (
        "rooms_door_exact_fit",
        &[
            "--from 32,64,28 --to 240,64,28 --box 16,16,28",
            "--from 32,64,28 --to 240,64,28 --box 16,16.00000000000000000001,28",
            "--from 32,64,24 --to 160,64,24 --box -16,-16,-24..16,16,32.00000000000000000001",
            // Along the floor and the door's corner, then into its frame.
            "--from 32,48,0 --to 160,48,0",
            "--from 32,48,0 --to 240,47,0",
            // Up the ramp, over its upper edge, into its sharp edge.
            "--from 200,24,0 --to 232,24,32",
            "--from 216,24,16 --to 248,24,48",
            "--from 160,24,16 --to 250,24,16 --box 16,16,16",
            "--from 184,24,40 --to 216,24,8 --box 4,4,4",
            // A corner of the box against a face of the pillar, and past its edge.
            "--from 180,80,16 --to 220,120,16 --box 4,4,4",
            "--from 160,104,16 --to 250,104,16 --box 4,4,16",
            "--from 160,84,16 --to 250,84,16 --box 4,4,16",
            // Resting on the floor: along it and up is free, down is not.
            "--from 32,64,16 --to 32,64,0 --box 16,16,16",
            "--from 32,64,16 --to 100,20,16 --box 16,16,16",
            "--from 32,64,16 --to 32,64,112 --box 16,16,16",
            "--from 32,64,16 --to 32,64,16 --box 16,16,16",
        ],
    ),
    (
        "wall_two_brushes_crack",
        &[
            "--from 32,64,32 --to 160,64,32",
            "--from 88,64,32 --to 160,64,32",
            "--from 88,64,32 --to 0,64,32",
            "--from 88,0,32 --to 88,128,96",
            "--from 32,64,96 --to 160,64,96",
            "--from 32,80,96 --to 160,80,95",
            "--from 32,96,112 --to 160,96,112 --box 16,16,16",
        ],
    ),
];

#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/motion"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let paths = scenes("scenes/motion");
    assert_eq!(paths.len(), MOVES.len());
    for (path, (name, moves)) in paths.iter().zip(MOVES) {
        assert_eq!(path.file_stem().unwrap(), *name);
        let mut text = String::new();
        for options in *moves {
            let mut arguments = vec!["move", path.to_str().unwrap()];
            arguments.extend(options.split(' '));
            let output = stabline(root(), &arguments);
            assert_eq!(output.status.code(), Some(0), "{options}: {output:?}");
            text.push_str(&format!("$ {options}\n{}\n", stdout(&output)));
        }
        settings.bind(|| insta::assert_snapshot!(*name, text));
    }
}

#[test]
fn the_json_says_what_the_text_says() {
    let scene = "scenes/motion/rooms_door_exact_fit.map";
    let fixed = ["move", scene, "--from", "160,24,16", "--to", "250,24,16", "--box", "16,16,16"];
    let text = stdout(&stabline(root(), &fixed));
    let json = stabline(root(), &[&fixed[..], &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["format"], "stabline-move/1");
    assert_eq!((&json["contact"], &json["time"]), (&true.into(), &"4/15".into()));
    assert_eq!(json["box"]["low"], serde_json::json!(["-16", "-16", "-16"]));
    assert_eq!(json["hits"][1]["normal"], serde_json::json!([-1, 0, 1]));
    assert_eq!(json["hits"][1]["touch"], "face");
    assert!(text.contains("contact at 4/15, (184 24 16)\n"), "{text}");
    let hits = text.lines().filter(|line| line.starts_with("hit ")).count();
    assert_eq!(json["hits"].as_array().unwrap().len(), hits);
}

#[test]
fn bad_moves_are_refused() {
    let go = |scene: &str, options: &str| {
        let path = format!("scenes/{scene}");
        let mut arguments = vec!["move", path.as_str()];
        arguments.extend(options.split(' '));
        stabline(root(), &arguments)
    };
    let crack = |options: &str| go("motion/wall_two_brushes_crack.map", options);
    let in_wall = crack("--from 90,32,32 --to 0,0,0");
    assert_fails(
        &in_wall,
        3,
        "(90 32 32): it is in no cell, but in a solid: line 52: `worldspawn`",
    );
    // On the crack, within the wall: no cell is there.
    let in_crack = crack("--from 96,64,32 --to 0,0,0");
    assert_fails(&in_crack, 3, "(96 64 32): it is in no cell, but in a solid");
    let outside = crack("--from 1000,64,32 --to 0,0,0");
    assert_fails(&outside, 3, "it is in no cell, but out of reach or out of bounds");
    let overlap = crack("--from 80,32,32 --to 0,32,32 --box 16,16,16");
    assert_fails(&overlap, 3, "the box overlaps something at the start: line 52: `worldspawn`");
    let flat = crack("--from 32,32,32 --to 64,32,32 --box 16,0,16");
    assert_fails(&flat, 2, "--box: the box has no volume");
    let inverted = crack("--from 32,32,32 --to 64,32,32 --box 1,1,1..-1,-1,-1");
    assert_fails(&inverted, 2, "--box: the box has no volume");
    assert_fails(&crack("--from 32,32 --to 64,32,32"), 2, "--from: expected 3 numbers");
    assert_fails(&crack("--from 32,32,1e --to 64,32,32"), 2, "--from: `1e`");
    let graph = go("pvs/room_alone.json", "--from 0,0,0 --to 1,1,1");
    assert_fails(&graph, 3, "a portal graph has no walls to meet, expected a world");
}
