//! `stabline draw`: pictures as bytes, as pixels, and their text.

#[path = "support/pictures.rs"]
mod pictures;
mod support;

use pictures::{Picture, assert_readable, labels};
use stabline::draw::{Floor, Frame, Sheet, SheetOptions, TreeNode, draw_tree_graph};
use stabline::formats::wad::{Archive, MapForm};
use stabline::num::{Int, Rational};
use stabline::portal::plan::{PlanCells, cells_of_plan};
use stabline::predicates::PlanPoint;
use stabline::pvs::plan::plan_stab_trees;
use stabline::report::Silent;
use stabline::scene::CellId;
use stabline::scene::plan::{Plan, PlanInput, read_plan};
use stabline::subdivision::plan::{PlanMethod, divide};
use support::wads::{divided, two_rooms};
use support::{assert_fails, root, scenes, stabline, stderr, stdout};

const OFFICE: &str = "scenes/draw/office_corridor_doors.json";
const FAR: &str = "scenes/draw/two_rooms_slanted_far.json";
const GRAPH: &str = "scenes/draw/three_cells_graph.json";

const WALL: &str = "#000000";
const CELL: &str = "#ffffff";
const PORTAL: &str = "#d55e00";
const SPLIT: &str = "#f2ae72";
const SOURCE: &str = "#08306b";
const VISIBLE: &str = "#9ecae1";
const LEFT: &str = "#6ba6d8";
const CULLED: &str = "#b7e2a8";
const SEEN: &str = "#007c78";
const SIGHT: &str = "#b84800";
const HINT: &str = "#969696";
const OUTSIDE: &str = "#e4e4e4";
const LINE: &str = "#c8102e";

/// A floorplan and where a picture of it puts things.
struct Drawn {
    plan: Plan,
    cells: PlanCells,
    sheet: Sheet,
    floor: Floor,
}

impl Drawn {
    fn of(scene: &str) -> Drawn {
        let options = SheetOptions { title: scene.to_owned(), width: 960 };
        let bytes = std::fs::read(root().join(scene)).unwrap();
        let PlanInput::Plan(plan) = read_plan(scene, &bytes).unwrap() else {
            panic!("{scene} is a floorplan");
        };
        let tree = divide(&plan, &PlanMethod::default(), &Silent).unwrap();
        let cells = cells_of_plan(&plan, tree, false).unwrap();
        let (sheet, floor) = Floor::of_plan(&plan, &cells, &options);
        Drawn { plan: *plan, cells, sheet, floor }
    }

    fn frame(&self) -> &Frame {
        &self.sheet.frame
    }

    /// The name of the cell around a point.
    fn cell_at(&self, point: [i64; 2]) -> String {
        let cell = self.cells.locate(&PlanPoint::integer(point.map(Int::from))).unwrap();
        self.cells.graph.cells[cell.0 as usize].clone()
    }

    /// Asserts that faces are black all along: lines are drawn over them.
    fn assert_no_line_crosses_a_face(&self, picture: &Picture) {
        for face in &self.plan.segments {
            let [a, b] = face.ends.map(|end| self.plan.points.get(end).small_integers().unwrap());
            let length = (b[0] - a[0]).abs().max((b[1] - a[1]).abs());
            for at in 1..length {
                let halves = [0, 1].map(|i| 2 * (a[i] * (length - at) + b[i] * at) / length);
                assert_eq!(picture.at_halves(self.frame(), halves), WALL, "{halves:?}");
            }
        }
    }

    /// Whether a segment between two points, in halves of units, misses all faces: by the signs of
    /// four areas, for points that are in line with no end of a face.
    fn is_clear(&self, p: [i64; 2], q: [i64; 2]) -> bool {
        let area = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| {
            ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
        };
        self.plan.segments.iter().all(|face| {
            let [a, b] = face
                .ends
                .map(|end| self.plan.points.get(end).small_integers().unwrap().map(|c| 2 * c));
            area(p, q, a) * area(p, q, b) > 0 || area(a, b, p) * area(a, b, q) > 0
        })
    }
}

/// What the command writes, its text checked.
fn drawn(scene: &str, options: &[&str]) -> String {
    let run = stabline(root(), &[&["draw", scene], options].concat());
    assert_eq!(run.status.code(), Some(0), "{}", stderr(&run));
    assert_eq!(stderr(&run), "");
    let picture = stdout(&run);
    assert_readable(&picture);
    assert!(Picture::render(&picture).has_a_margin(), "{scene} {options:?}");
    picture
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
        assert_eq!(drawn(scene, &[]), drawn(scene, &["--what", "cells"]), "{scene}");
    }
}

#[test]
fn small_pictures_are_the_ones_that_are_kept() {
    let of = |scene: &str, what: &str, options: &[&str]| {
        assert_kept(scene, what, &drawn(scene, &[&["--what", what], options].concat()));
    };
    of(FAR, "cells", &[]);
    of(FAR, "splits", &[]);
    of(FAR, "visibility", &["--from", "0"]);
    of(
        FAR,
        "eye",
        &["--at", "100000000000000000000.5,3", "--look", "1,0", "--half-tangent", "1/2"],
    );
    of(GRAPH, "cells", &[]);
    of(GRAPH, "visibility", &["--from", "hall"]);
}

#[test]
fn faces_portals_and_the_graph_are_where_they_belong() {
    let office = Drawn::of(OFFICE);
    let picture = Picture::render(&drawn(OFFICE, &[]));
    // A face, a door in it, a part of a room, and the walls of the house.
    for (point, colour) in
        [([5, 30], WALL), ([12, 30], PORTAL), ([35, 5], CELL), ([120, 40], WALL), ([60, 0], WALL)]
    {
        let halves = point.map(|c| 2 * c);
        assert_eq!(picture.at_halves(office.frame(), halves), colour, "{point:?}");
    }
    // An edge of the graph: half way from the middle of a cell to that of a portal.
    for (portal, sides) in office.floor.portals.iter().zip(&office.floor.sides) {
        let middle = office.floor.middles[sides[0].0 as usize];
        let half = [0, 1].map(|i| (portal[0][i] + portal[1][i]) / 4.0 + middle[i] / 2.0);
        let near = [-1.0, 0.0, 1.0].map(|dx| [-1.0, 0.0, 1.0].map(|dy| [dx, dy]));
        let near =
            near.into_iter().flatten().map(|[dx, dy]| picture.at([half[0] + dx, half[1] + dy]));
        assert!(near.into_iter().any(|colour| colour != CELL), "{sides:?}");
    }
}

#[test]
fn what_a_cell_sees_is_light_and_its_lines_cross_no_face() {
    let office = Drawn::of(OFFICE);
    let from = office.cell_at([10, 10]);
    let svg = drawn(OFFICE, &["--what", "visibility", "--from", &from]);
    let picture = Picture::render(&svg);
    for (point, colour) in [
        ([35, 25], SOURCE),
        ([45, 5], VISIBLE),
        ([65, 45], VISIBLE),
        ([5, 75], VISIBLE),
        ([100, 10], CELL),
        ([100, 75], CELL),
        ([80, 75], CELL),
    ] {
        let halves = point.map(|c| 2 * c);
        assert_eq!(picture.at_halves(office.frame(), halves), colour, "{point:?}");
    }
    office.assert_no_line_crosses_a_face(&picture);
}

#[test]
fn stab_trees_run_through_their_portals() {
    let office = Drawn::of(OFFICE);
    let from = office.cell_at([10, 10]);
    let graph = &office.cells.graph;
    let source = CellId(from.parse().unwrap());
    let trees = plan_stab_trees(graph, &graph.crossings(), &[source], false, &Silent).unwrap();
    let nodes = &trees[0].nodes;
    assert!(nodes.len() > 8, "{nodes:?}");

    let svg = drawn(OFFICE, &["--what", "stab-tree", "--from", &from]);
    assert!(svg.contains(&format!("stab tree, {} nodes", nodes.len() + 1)), "{svg}");
    let picture = Picture::render(&svg);
    office.assert_no_line_crosses_a_face(&picture);
    for node in nodes {
        let [a, b] = office.floor.portals[node.portal as usize];
        let middle = [0, 1].map(|i| (a[i] + b[i]) / 2.0);
        assert_eq!(picture.at(middle), SIGHT, "{node:?}");
    }

    let svg = drawn(OFFICE, &["--what", "stab-tree-graph", "--from", &from]);
    // A node each, the root, and that of the legend.
    assert_eq!(svg.matches("<circle").count(), nodes.len() + 2, "{svg}");
    let texts: Vec<String> = labels(&svg).into_iter().map(|label| label.text).collect();
    for node in nodes {
        let name = &graph.cells[node.cell.0 as usize];
        assert!(texts.contains(name) && texts.contains(&node.portal.to_string()), "{node:?}");
    }
    let picture = Picture::render(&svg);
    assert!(picture.count(SOURCE) > 200 && picture.count(VISIBLE) > 200 * nodes.len());
}

/// Names and numbers of a tree keep off each other, or are left out.
#[test]
fn wide_and_deep_trees_stay_readable() {
    let names: Vec<String> = (0..2000).map(|cell| cell.to_string()).collect();
    for (leaves, chain) in [(1, 0), (7, 3), (24, 0), (60, 2), (1500, 40)] {
        let mut nodes = vec![TreeNode { cell: CellId(1999), before: None }];
        for leaf in 0..leaves {
            nodes.push(TreeNode { cell: CellId(leaf), before: Some((0, 123_456)) });
        }
        for link in 0..chain {
            let before = nodes.len() as u32 - 1;
            nodes.push(TreeNode { cell: CellId(1000 + link), before: Some((before, link)) });
        }
        let options = SheetOptions { title: "tree".to_owned(), width: 960 };
        let svg = draw_tree_graph(&names, &nodes, &options);
        assert_readable(&svg);
        assert_eq!(svg.matches("<circle").count(), nodes.len() + 1);
        let picture = Picture::render(&svg);
        assert!(picture.has_a_margin() && picture.count(VISIBLE) > 20, "{leaves} {chain}");
    }
}

/// Two rooms with an open line between them, and a third one that nothing joins to them.
#[test]
fn levels_are_drawn_with_their_lines_and_what_a_sector_sees() {
    let mut level = two_rooms();
    level.path(&[[300, 0], [300, 128], [400, 128], [400, 0], [300, 0]], 2, None);
    let bytes = level.archive("MAP01", MapForm::Doom);
    let (doom, cells, _) = divided(&Archive::read(&bytes).unwrap().map("MAP01").unwrap());
    let options = SheetOptions { title: String::new(), width: 960 };
    let frame = Floor::of_plan(&doom.plan, &cells, &options).0.frame;
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("three.wad"), bytes).unwrap();
    let at = |options: &[&str]| {
        stabline(folder.path(), &[&["draw", "three.wad:MAP01"][..], options].concat())
    };
    let lines = [([64, 0], WALL), ([128, 64], HINT), ([400, 64], WALL), ([278, 60], OUTSIDE)];
    let plain = [([30, 30], CELL), ([200, 90], CELL), ([350, 30], CELL)];
    let shaded = [([30, 30], SOURCE), ([200, 90], VISIBLE), ([350, 30], CELL)];
    let cells = (at(&["--what", "cells"]), plain, "lines and leaves");
    let sectors = (at(&["--what", "sectors", "--from", "0"]), shaded, "sees 1 of 2 others");
    for (run, areas, text) in [cells, sectors] {
        let svg = stdout(&run);
        assert!(svg.contains(text), "{svg}");
        assert_readable(&svg);
        let picture = Picture::render(&svg);
        for (point, colour) in lines.into_iter().chain(areas) {
            assert_eq!(picture.at_halves(&frame, point.map(|c| 2 * c)), colour, "{point:?}");
        }
    }
    assert_fails(&at(&["--what", "sectors", "--from", "3"]), 2, "expected a number below 3");
    assert_fails(&at(&["--what", "sectors"]), 2, "--what sectors needs --from");
}

#[test]
fn the_pictures_of_the_documentation_are_up_to_date() {
    let visibility = ["--what", "visibility", "--from", "13"];
    let eye = ["--what", "eye", "--at", "110,40", "--look", "-3,-1", "--half-tangent", "2/3"];
    for (name, options) in [("draw-visibility.svg", &visibility[..]), ("draw-eye.svg", &eye[..])] {
        let path = root().join("docs").join(name);
        let kept = std::fs::read_to_string(&path).unwrap();
        assert_eq!(
            kept,
            drawn(OFFICE, options),
            "stabline draw {OFFICE} {options:?} -o docs/{name}"
        );
    }
}

/// Every point is blue-green exactly if the segment to the eye is clear and, with a cone, in it.
#[test]
fn the_visible_area_is_what_no_face_hides() {
    let office = Drawn::of(OFFICE);
    let eye = [31, 29];
    let whole = ["--what", "eye", "--at", "31/2,29/2"];
    for cone in [None, Some("1")] {
        let restricted = ["--look", "1,3", "--half-tangent", cone.unwrap_or_default()];
        let options = [&whole[..], if cone.is_some() { &restricted } else { &[] }].concat();
        let picture = Picture::render(&drawn(OFFICE, &options));
        let mut compared = 0;
        for x in 0..120 {
            for y in 0..80 {
                let point = [2 * x + 1, 2 * y + 1];
                let Some(colour) = picture.around_halves(office.frame(), point) else { continue };
                if colour == LINE {
                    // The dot of the eye itself.
                    continue;
                }
                let [dx, dy] = [point[0] - eye[0], point[1] - eye[1]];
                // Between (4, 2) and (-2, 4): (1, 3) turned by half a right angle either way.
                let is_in_cone = cone.is_none() || (2 * dy > dx && dy > -2 * dx);
                let is_seen = office.is_clear(eye, point) && is_in_cone;
                assert_eq!(colour == SEEN, is_seen, "{point:?} {cone:?} {colour}");
                compared += 1;
            }
        }
        assert!(compared > 8000, "{compared}");
    }
}

#[test]
fn coarser_culls_leave_more() {
    let options = ["--what", "eye", "--at", "15,15", "--look", "1,2", "--half-tangent", "1/2"];
    let mut areas = Vec::new();
    for cull in ["none", "disjoint", "component", "portals", "exact"] {
        let picture = Picture::render(&drawn(OFFICE, &[&options[..], &["--cull", cull]].concat()));
        areas.push([LEFT, CULLED, SEEN].map(|colour| picture.count(colour)));
    }
    assert!(areas.windows(2).all(|pair| pair[0][0] >= pair[1][0]), "{areas:?}");
    assert!(areas.windows(2).all(|pair| pair[0][1] <= pair[1][1]), "{areas:?}");
    assert!(areas.iter().all(|area| area[2] == areas[0][2] && area[2] > 1000), "{areas:?}");
    assert_eq!(areas[0][1], 0);
    assert!(areas[1][0] > areas[4][0], "{areas:?}");
}

#[test]
fn splits_run_under_the_faces() {
    let office = Drawn::of(OFFICE);
    let picture = Picture::render(&drawn(OFFICE, &["--what", "splits"]));
    // Doors are gaps in walls that lie on one line; a wall on it; a room.
    for (point, colour) in [([12, 30], SPLIT), ([98, 30], SPLIT), ([3, 30], WALL), ([20, 10], CELL)]
    {
        let halves = point.map(|c| 2 * c);
        assert_eq!(picture.at_halves(office.frame(), halves), colour, "{point:?}");
    }
}

#[test]
fn sequences_are_drawn_with_their_lines() {
    for (name, title, has_line) in [
        ("plane_gates_open", "plane_gates_open.json: open", true),
        ("plane_gates_grazing", "plane_gates_grazing.json: grazing", true),
        ("plane_gates_blocked", "plane_gates_blocked.json: blocked", false),
    ] {
        let svg = drawn(&format!("scenes/stab/{name}.json"), &[]);
        assert!(svg.contains(&format!("<title>{title}</title>")), "{svg}");
        let picture = Picture::render(&svg);
        assert_eq!(picture.count(LINE) > 200, has_line, "{name}");
        assert!(picture.count(WALL) > 200, "{name}");
    }
}

#[test]
fn a_plan_far_from_the_origin_is_drawn_sharp() {
    let far = Drawn::of(FAR);
    let [low, high] = far.sheet.drawing();
    // 3 by 1 units, as wide as the sheet between its margins.
    assert_eq!([high[0] - low[0], high[1] - low[1]], [912.0, 304.0]);
    assert_eq!(far.floor.faces[0], [[low[0], high[1]], [high[0], high[1]]]);
    let picture = Picture::render(&drawn(FAR, &[]));
    let [from, to] = far.floor.faces[4];
    assert_eq!(picture.at([0, 1].map(|i| (from[i] + to[i]) / 2.0)), WALL);
    assert_eq!(picture.at([low[0] + 30.0, low[1] + 30.0]), CELL);
    let one = Rational::from_integer(1.into());
    let corner = far.plan.points.get(far.plan.bounds[0]).coordinates();
    let next = far.frame().place(&[&corner[0] + &one, corner[1].clone()]);
    assert!(next[0] > low[0], "{next:?}");
}

#[test]
fn pictures_scale_to_their_width() {
    for width in ["240", "500", "4000"] {
        let picture = drawn(OFFICE, &["--width", width]);
        assert!(picture.contains(&format!(" width=\"{width}\" ")), "{picture}");
    }
}

#[test]
fn what_cannot_be_drawn_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let at = |arguments: &[&str]| stabline(root(), &[&["draw"], arguments].concat());
    assert_fails(&at(&["scenes/pvs/room_alone.json"]), 3, "the scene lies in space");
    assert_fails(&at(&["scenes/stab/half_wall.json"]), 3, "the sequence lies in space");
    assert_fails(&at(&[OFFICE, "--width", "3"]), 2, "240..=20000");
    assert_fails(&at(&[OFFICE, "--what", "music"]), 2, "invalid value 'music'");
    assert_fails(&at(&[OFFICE, "--what", "visibility"]), 2, "--what visibility needs --from");
    assert_fails(&at(&[OFFICE, "--from", "0"]), 2, "--what cells has no use for --from");
    let visibility = [OFFICE, "--what", "visibility", "--from", "99"];
    assert_fails(&at(&visibility), 2, "no cell \"99\"");
    assert_fails(&at(&[OFFICE, "--what", "eye"]), 2, "--what eye needs --at");
    let eye = |at: &'static str| [OFFICE, "--what", "eye", "--at", at];
    assert_fails(&at(&eye("1,2,3")), 2, "--at: expected 2 numbers");
    assert_fails(&at(&eye("5,30")), 3, "the eye is on a wall");
    assert_fails(&at(&eye("-5,30")), 3, "the eye is outside");
    let look = [&eye("5,5")[..], &["--look", "0,0", "--half-tangent", "1"]].concat();
    assert_fails(&at(&look), 2, "--look");
    assert_fails(&at(&[&look[..look.len() - 2]].concat()), 2, "--half-tangent");
    assert_fails(&at(&[OFFICE, "--what", "sectors", "--from", "0"]), 3, "has no sectors");
    assert_fails(&at(&[OFFICE, "--cull", "none"]), 2, "--what cells has no use for --cull");
    assert_fails(&at(&[GRAPH, "--what", "splits"]), 3, "this picture needs a floorplan");
    assert_fails(&at(&["nowhere.json"]), 3, "cannot read");
    let out = folder.path().join("no/folder.svg");
    assert_fails(&at(&[OFFICE, "-o", out.to_str().unwrap()]), 3, "cannot write");
}
