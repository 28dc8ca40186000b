//! `stabline draw`: pictures as bytes, and as pixels.

#[path = "support/pictures.rs"]
mod pictures;
mod support;

use pictures::Picture;
use stabline::draw::{self, Floor, Sheet, SheetOptions};
use stabline::portal::plan::cells_of_plan;
use stabline::report::Silent;
use stabline::scene::plan::{PlanInput, read_plan};
use stabline::subdivision::plan::{PlanMethod, divide};
use support::{assert_fails, root, scenes, stabline, stderr, stdout};

const OFFICE: &str = "scenes/draw/office_corridor_doors.json";
const FAR: &str = "scenes/draw/two_rooms_slanted_far.json";

const GRAPH: &str = "scenes/draw/three_cells_graph.json";

/// A scene's floor on a sheet.
fn floor(scene: &str) -> (Sheet, Floor) {
    let options = SheetOptions { title: scene.to_owned(), width: 960 };
    let bytes = std::fs::read(root().join(scene)).unwrap();
    match read_plan(scene, &bytes).unwrap() {
        PlanInput::Graph(graph) => Floor::of_graph(&graph, &options),
        PlanInput::Plan(plan) => {
            let tree = divide(&plan, &PlanMethod::default(), &Silent).unwrap();
            Floor::of_plan(&plan, &cells_of_plan(&plan, tree, false).unwrap(), &options)
        }
    }
}

/// What the command writes.
fn drawn(scene: &str, options: &[&str]) -> String {
    let run = stabline(root(), &[&["draw", scene], options].concat());
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    assert_eq!(stderr(&run), "");
    stdout(&run)
}

/// Asserts that a picture is the one kept for the scene.
fn assert_kept(scene: &str, what: &str, picture: &str) {
    assert!(picture.lines().count() <= 60, "{scene} {what}: too long to be read");
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/draw"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.set_snapshot_suffix(what);
    let name = std::path::Path::new(scene).file_stem().unwrap().to_str().unwrap();
    settings.bind(|| insta::assert_snapshot!(name, picture));
}

#[test]
fn every_scene_is_drawn_within_its_picture_and_twice_the_same() {
    for scene in scenes("scenes/draw") {
        let scene = scene.to_str().unwrap();
        let picture = drawn(scene, &[]);
        assert_eq!(picture, drawn(scene, &["--what", "cells"]));
        assert!(Picture::render(&picture).has_a_margin(), "{scene}");
    }
}

#[test]
fn small_pictures_are_the_ones_that_are_kept() {
    for scene in [FAR, GRAPH] {
        assert_kept(scene, "cells", &drawn(scene, &["--what", "cells"]));
    }
}

#[test]
fn faces_portals_and_the_graph_are_where_they_belong() {
    let (sheet, floor) = floor(OFFICE);
    let frame = sheet.frame.clone();
    let middles = floor.middles.clone();
    let picture = Picture::render(&draw::draw_cells(sheet, &floor));
    // A face, a door in it, the middle of the room, and the wall of the house.
    for (point, colour) in [
        ([5, 30], "#000000"),
        ([12, 30], "#d55e00"),
        ([35, 5], "#ffffff"),
        ([120, 40], "#000000"),
        ([60, 0], "#000000"),
    ] {
        assert_eq!(picture.at_point(&frame, point), colour, "{point:?}");
    }
    // An edge of the graph, between the names of its cells: half way from a middle to a portal.
    for (portal, sides) in floor.portals.iter().zip(&floor.sides) {
        let middle = middles[sides[0].0 as usize];
        let half = [0, 1].map(|i| (portal[0][i] + portal[1][i]) / 4.0 + middle[i] / 2.0);
        let near: Vec<String> = [-1.0, 0.0, 1.0]
            .iter()
            .flat_map(|dx| [-1.0, 0.0, 1.0].map(|dy| picture.at([half[0] + dx, half[1] + dy])))
            .collect();
        assert!(near.iter().any(|colour| colour != "#ffffff"), "{sides:?} {near:?}");
    }
}

#[test]
fn a_plan_far_from_the_origin_is_drawn_sharp() {
    let (sheet, floor) = floor(FAR);
    let [low, high] = sheet.drawing();
    // 3 by 1 units, as wide as the sheet between its margins.
    assert_eq!([high[0] - low[0], high[1] - low[1]], [912.0, 304.0]);
    assert_eq!(floor.faces[0], [[low[0], high[1]], [high[0], high[1]]]);
    let picture = Picture::render(&draw::draw_cells(sheet, &floor));
    let [from, to] = floor.faces[4];
    assert_eq!(picture.at([0, 1].map(|i| (from[i] + to[i]) / 2.0)), "#000000");
    assert_eq!(picture.at([low[0] + 30.0, low[1] + 30.0]), "#ffffff");
}

#[test]
fn pictures_scale_to_their_width() {
    for width in ["240", "500", "4000"] {
        let picture = drawn(OFFICE, &["--width", width]);
        assert!(picture.contains(&format!(" width=\"{width}\" ")), "{picture}");
        let rendered = Picture::render(&picture);
        assert!(rendered.has_a_margin(), "{width}");
    }
}

#[test]
fn what_cannot_be_drawn_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let at = |arguments: &[&str]| stabline(root(), arguments);
    assert_fails(&at(&["draw", "scenes/pvs/room_alone.json"]), 3, "the scene lies in space");
    assert_fails(&at(&["draw", OFFICE, "--width", "3"]), 2, "240..=20000");
    assert_fails(&at(&["draw", OFFICE, "--what", "music"]), 2, "invalid value 'music'");
    assert_fails(&at(&["draw", "nowhere.json"]), 3, "cannot read");
    let out = folder.path().join("no/folder.svg");
    assert_fails(&at(&["draw", OFFICE, "-o", out.to_str().unwrap()]), 3, "cannot write");
}
