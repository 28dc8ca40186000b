//! Every scene of an eye against its snapshot, and the command that answers.

mod support;

use support::{assert_fails, root, scenes, stabline, stdout};

/// The options with which each scene is asked.
const QUERIES: &[(&str, &[&str])] = &[
    (
        "door_between_rooms_eye_in_it",
        &[
            "--at 0,1,1 --regions",
            "--at 0,2,1",
            "--at 0,0,0",
            "--at 0,3,1 --cell west",
            "--at 0,1,1 --look 1,0,0 --half-tangents 1,1",
            "--at 0,1,1 --look 0,1,0 --half-tangents 1/100,1/100",
        ],
    ),
    (
        "doors_in_row_posts_aligned",
        &[
            "--at 0,2,1",
            "--at 0,1999999999999999999999/1000000000000000000000,1 --regions",
            "--at 0,1,1 --look 1,0,0 --up 0,1/7,1 --fov 60,47.5",
            "--at 0,1,1 --look -1,0,0 --fov 90,90",
            "--at 0,2,1 --cull float",
            "--at 0,2,1 --cull portals",
            "--at 0,2,1 --cull flood",
        ],
    ),
    (
        "four_rooms_shared_edge",
        &["--at 0,0,1", "--at 1,1,1 --regions", "--at 0,1,1", "--at 0,0,5 --cell c"],
    ),
    (
        "two_rooms_block_on_floor",
        &[
            // On the line that four cells have in common, and on the floor there.
            "--at 11,4,2",
            "--at 11,4,0 --look -1,0,0 --half-tangents 1/8,1/8",
            // Against a wall, with its back and with its face to it.
            "--at 0,6,3 --look 4,-3,0 --half-tangents 1/16,1/16 --regions",
            "--at 0,6,3 --look -1,0,0 --half-tangents 1/4,1/4 --regions",
            // In the door's edge, in a corner of the block, in a corner of the room.
            "--at 8,3,2 --look 0,1,0 --half-tangents 1/3,1/3",
            "--at 3,3,2 --objects --look 1,0,0 --half-tangents 1,1/2",
            "--at 0,0,0 --objects",
        ],
    ),
];

#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/eye"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let paths = scenes("scenes/eye");
    assert_eq!(paths.len(), QUERIES.len());
    for (path, (name, queries)) in paths.iter().zip(QUERIES) {
        assert_eq!(path.file_stem().unwrap(), *name);
        let mut text = String::new();
        for query in *queries {
            let mut arguments = vec!["eye", path.to_str().unwrap()];
            arguments.extend(query.split(' '));
            let output = stabline(root(), &arguments);
            assert_eq!(output.status.code(), Some(0), "{query}: {output:?}");
            text.push_str(&format!("$ {query}\n{}\n", stdout(&output)));
        }
        settings.bind(|| insta::assert_snapshot!(*name, text));
    }
}

#[test]
fn the_json_says_what_the_text_says() {
    let scene = "scenes/eye/doors_in_row_posts_aligned.json";
    let fixed = ["eye", scene, "--at", "0,1,1", "--look", "1,0,0", "--fov", "90,60", "--regions"];
    let text = stdout(&stabline(root(), &fixed));
    let json = stabline(root(), &[&fixed[..], &["--json"]].concat());
    let json: serde_json::Value = serde_json::from_slice(&json.stdout).unwrap();
    assert_eq!(json["format"], "stabline-eye/1");
    assert_eq!(json["eye_cells"][0], "first");
    assert_eq!(json["frustum"]["half_tangents"][0], "1");
    let cells = json["cells"].as_array().unwrap();
    assert!(text.contains(&format!("exact: {} cells", cells.len())), "{text}");
    assert_eq!(json["regions"].as_array().unwrap().len() as u64, json["sequences"]);
}

#[test]
fn bad_queries_are_refused() {
    let scene = "scenes/eye/doors_in_row_posts_aligned.json";
    let at = |place: &str, more: &[&str]| {
        stabline(root(), &[&["eye", scene, "--at", place][..], more].concat())
    };
    let look = |axes: [&str; 2], tangents: &str| {
        at("0,1,1", &["--look", axes[0], "--up", axes[1], "--half-tangents", tangents])
    };
    assert_fails(&at("0,1", &[]), 2, "--at: expected 3 numbers between commas, got 2");
    assert_fails(&at("0,nan,1", &[]), 2, "--at: `nan`: not a decimal number");
    assert_fails(&at("0,1,1", &["--cell", "fourth"]), 2, "no cell \"fourth\"");
    assert_fails(&at("0,1,1", &["--cell", "third"]), 2, "the eye is not in cell `third`");
    assert_fails(&at("0,1,1", &["--look", "1,0,0"]), 2, "--look needs --half-tangents or --fov");
    assert_fails(&at("0,1,1", &["--fov", "90,90"]), 2, "--look");
    assert_fails(&look(["0,0,0", "0,0,1"], "1,1"), 2, "look is the zero vector");
    assert_fails(&look(["0,0,2", "0,0,1"], "1,1"), 2, "up is parallel to look");
    assert_fails(&look(["1,0,0", "0,0,1"], "1,0"), 2, "must be positive, got 0");
    let wide = at("0,1,1", &["--look", "1,0,0", "--fov", "180,90"]);
    assert_fails(&wide, 2, "above 0 and below 180 degrees, got 180");
    for option in ["--regions", "--objects"] {
        assert_fails(&at("0,1,1", &["--cull", "flood", option]), 2, "need the exact cull");
    }
    assert_fails(&at("0,1,1", &["--objects"]), 2, "a portal graph has none");
    assert_fails(&stabline(root(), &["eye", "no/file", "--at", "0,0,0"]), 3, "no/file");
}

#[test]
fn an_eye_that_the_portals_do_not_place_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rooms.prt");
    std::fs::write(&path, support::THREE_ROOMS).unwrap();
    let rooms = path.to_str().unwrap();
    assert_eq!(stabline(root(), &["eye", rooms, "--at", "-1,1,1"]).status.code(), Some(0));
    let stairs = ["eye", "scenes/pvs/stairs_floor_to_floor.json", "--at", "100,100,1"];
    let output = stabline(root(), &stairs);
    let expected = "2 cells in which the eye may be: name one of stairwell below, upper room with";
    assert_fails(&output, 2, expected);
    let output = stabline(root(), &[&stairs[..], &["--cell", "upper room"]].concat());
    assert_eq!(output.status.code(), Some(0));
}

const LEVEL: &str = "scenes/eye/two_rooms_block_on_floor.map";

#[test]
fn an_eye_in_no_cell_of_a_level_is_refused() {
    let at = |place: &str| stabline(root(), &["eye", LEVEL, "--at", place]);
    let solid = "the eye is in or on a solid and in no cell: line";
    // In the block, in a wall, on the outer side of one.
    for place in ["4,4,1", "-1/2,1,1", "-1,1,1"] {
        assert_fails(&at(place), 3, solid);
    }
    assert_fails(&at("4,4,1"), 3, "line 71: `worldspawn`");
    assert_fails(&at("-2,4,1"), 3, "the eye is outside of the level");
    assert_fails(&at("0,0,100000"), 3, "outside of the box around the level");
    let named = stabline(root(), &["eye", LEVEL, "--at", "1,1,1", "--cell", "0"]);
    assert_fails(&named, 2, "--cell is for portal graphs");
}

#[test]
fn what_is_seen_of_a_level_is_written_for_viewers() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).to_str().unwrap().to_owned();
    let (obj, glb) = (path("seen.obj"), path("seen.glb"));
    let fixed = ["eye", LEVEL, "--at", "1,1,3", "--json", "--regions", "--objects"];
    let output = stabline(root(), &[&fixed[..], &["--obj", &obj, "--glb", &glb]].concat());
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let regions = json["space"]["regions"].as_array().unwrap();
    let faces: usize = regions.iter().map(|r| r["faces"].as_array().unwrap().len()).sum();
    let text = std::fs::read_to_string(&obj).unwrap();
    let lines = |start: &str| text.lines().filter(|line| line.starts_with(start)).count();
    assert_eq!((lines("o "), lines("f ")), (regions.len(), faces));
    assert!(std::fs::read(&glb).unwrap().starts_with(b"glTF"));
    let objects = json["objects"].as_array().unwrap();
    assert!(objects.iter().all(|object| object["name"] == "func_detail"), "{objects:?}");
    // The same for a portal graph, whose regions are polygons.
    let graph = "scenes/eye/door_between_rooms_eye_in_it.json";
    let output = stabline(root(), &["eye", graph, "--at", "0,1,1", "--obj", &obj]);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    assert!(std::fs::read_to_string(&obj).unwrap().contains("o east_closet_through_2"));
}
