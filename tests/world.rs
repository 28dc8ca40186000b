//! Every scene of `scenes/world`: its cells, portals and visibility against snapshots, with the
//! laws that hold for all of them.
//!
//! `panels_cross_turned.glb` holds one mesh that two nodes put: as it is, and turned by a
//! quaternion of length √2 and scaled; the two panels cross, and four quarters come out.

mod support;

use stabline::geom::{AxialBox, RationalPoint3};
use stabline::num::{Int, Number, Rational};
use stabline::portal::{WorldCells, WorldError, cells_of_world};
use stabline::pvs::{self, assemble};
use stabline::report::{Silent, Verdict};
use stabline::scene::world::{Place, WorldPolygon, WorldWarning};
use stabline::scene::{World, WorldOptions, read_world};
use stabline::subdivision::Options;
use std::fmt::Write;
use std::path::Path;
use support::{root, scenes};

fn read(path: &Path, snap: Option<u32>) -> (World, Vec<WorldWarning>) {
    let options = WorldOptions { snap, ..WorldOptions::default() };
    read_world(&path.to_string_lossy(), &std::fs::read(path).unwrap(), &options).unwrap()
}

fn divide(world: &World) -> Result<WorldCells, WorldError> {
    cells_of_world(world, &Options::default())
}

fn show(point: &RationalPoint3) -> String {
    let [x, y, z] = <[Number; 3]>::from(point);
    format!("({x} {y} {z})")
}

fn describe(world: &World, warnings: &[WorldWarning]) -> String {
    let mut text = format!(
        "solids {}, polygons {}, hints {}, objects {}, marks {}\n",
        world.solids.len(),
        world.polygons.len(),
        world.hints.len(),
        world.objects.len(),
        world.marks().len(),
    );
    for warning in warnings {
        writeln!(text, "{warning}").unwrap();
    }
    let cells = match divide(world) {
        Ok(cells) => cells,
        Err(error) => {
            writeln!(text, "{error}").unwrap();
            return text;
        }
    };
    for (cell, &leaf) in cells.leaves.iter().enumerate() {
        let cell_of_leaf = &cells.subdivision.leaf(leaf).cell;
        let points: Vec<_> = cell_of_leaf.faces().iter().flat_map(|face| face.points()).collect();
        let AxialBox { low, high } = AxialBox::around(&points).unwrap();
        let [low, high] = [low, high].map(|corner| show(&RationalPoint3::from(&corner)));
        let volume = cell_of_leaf.volume();
        writeln!(text, "cell {cell}: {low} to {high}, volume {volume}").unwrap();
    }
    for portal in &cells.graph.portals {
        let corners: Vec<String> = cells.graph.corners(portal).map(show).collect();
        writeln!(text, "{} -> {}: {}", portal.from.0, portal.to.0, corners.join(" ")).unwrap();
    }
    let graph = &cells.graph;
    let rows = pvs::compute(graph, &pvs::Options::default(), Vec::new(), &|_| {}, &Silent).rows;
    let matrix = assemble(graph, &rows);
    let count = graph.cells.len();
    for a in 0..count {
        let row = (0..count).map(|b| if matrix.get(a, b) == Verdict::Open { '2' } else { '0' });
        writeln!(text, "{a} sees {}", row.collect::<String>()).unwrap();
    }
    text
}

#[test]
fn scenes_match_their_snapshots() {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(root().join("snapshots/world"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    for path in scenes("scenes/world") {
        let (world, warnings) = read(&path, None);
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        settings.bind(|| insta::assert_snapshot!(name, describe(&world, &warnings)));
    }
}

/// The leaves tile the view, or hold everything that stands in the world.
#[test]
fn leaves_tile_the_box() {
    for path in scenes("scenes/world") {
        let (world, _) = read(&path, None);
        let Ok(cells) = divide(&world) else { continue };
        let leaves = &cells.subdivision.leaves;
        let volume: Rational = leaves.iter().map(|leaf| leaf.cell.volume()).sum();
        let whole = cells.subdivision.bounds.polyhedron(&cells.subdivision.planes);
        assert_eq!(volume, whole.volume(), "{}", path.display());
        if let Some(AxialBox { low, high }) = &world.view {
            let expected: Rational = low.iter().zip(high).map(|(low, high)| high - low).product();
            assert_eq!(volume, expected, "{}", path.display());
        }
    }
}

/// Polygons of a soup are each once, whichever way around, and rounding tells how far it moves.
#[test]
fn rounding_is_reported_and_drops_what_is_flat() {
    let text = "v 0 0 0\nv 4.04 0 0\nv 4.04 4 0.01\nv 0 4 0\nv 0.01 0 0\nv 0 0.02 0.0\n\
                f 1 2 3 4\nf 1 5 6\nf 2 1 4 3\n";
    let read = |snap| {
        let options = WorldOptions { snap, ..WorldOptions::default() };
        let (world, warnings) = read_world("x.obj", text.as_bytes(), &options).unwrap();
        let warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
        (world.polygons, warnings)
    };
    let (exact, warnings) = read(None);
    assert_eq!(exact.len(), 5);
    let skew = "line 7: `f`: a polygon is not planar; it is cut into triangles; 2 in all";
    assert_eq!(warnings, [skew]);
    let (snapped, warnings) = read(Some(1));
    let number = |p: i64, q: i64| Rational::new(Int::from(p), Int::from(q));
    let corner = |x| RationalPoint3::from(&[x, number(0, 1), number(0, 1)]);
    assert_eq!(snapped.len(), 1);
    let WorldPolygon { vertices, place } = &snapped[0];
    assert_eq!((vertices.len(), &vertices[1]), (4, &corner(number(4, 1))));
    assert_eq!(place, &Place { name: "f".to_owned(), line: Some(7) });
    assert_eq!(
        warnings,
        [
            "line 9: `f`: a polygon has the vertices of one before it; it is left out; 1 in all",
            "line 8: `f`: a polygon has no area once rounded; it is left out; 1 in all",
            "8 coordinates rounded, by 1/25 at most",
        ]
    );
}

/// An outline that is simple before it is rounded and touches itself after falls into triangles.
#[test]
fn rounding_may_make_an_outline_touch_itself() {
    let text = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 0.1 0\nv 0 4 0\nf 1 2 3 4 5\n";
    let options = WorldOptions { snap: Some(0), ..WorldOptions::default() };
    let (world, _) = read_world("x.obj", text.as_bytes(), &options).unwrap();
    let area = |polygon: &WorldPolygon| {
        let corners: Vec<_> = polygon.vertices.iter().map(RationalPoint3::coordinates).collect();
        let [a, b, c] = corners.try_into().unwrap();
        let twice = (&b[0] - &a[0]) * (&c[1] - &a[1]) - (&b[1] - &a[1]) * (&c[0] - &a[0]);
        if twice < Rational::from(Int::ZERO) { -twice } else { twice }
    };
    let twice: Rational = world.polygons.iter().map(area).sum();
    assert_eq!(twice, Rational::from(Int::from(16)));
}

/// The same room as brushes in three forms is the same world but for the order of planes.
#[test]
fn brushes_mean_the_same_in_every_form() {
    let forms = [
        r#"{"box": [[0, 0, 0], [2, 3, "1/2"]]}"#,
        r#"{"points": [[0,0,0],[2,0,0],[2,3,0],[0,3,0],[0,0,0.5],[2,0,0.5],[2,3,0.5],[0,3,0.5],[1,1,0.25]]}"#,
        r#"{"planes": [{"normal": [2,0,0], "offset": 4}, {"normal": [-1,0,0], "offset": 0},
            {"normal": [0,1,0], "offset": 3}, {"normal": [0,-3,0], "offset": 0},
            {"normal": [0,0,"1/3"], "offset": "1/6"}, {"points": [[0,0,0],[0,1,0],[1,0,0]]},
            {"normal": [1,1,0], "offset": 9}, {"normal": [1,0,0], "offset": 2}]}"#,
    ];
    let planes = forms.map(|form| {
        let text = format!(r#"{{"about": "", "format": "stabline-scene/1", "brushes": [{form}]}}"#);
        let (world, warnings) = read_world("x", text.as_bytes(), &WorldOptions::default()).unwrap();
        let redundant = usize::from(form.contains("planes"));
        assert_eq!(warnings.len(), redundant, "{warnings:?}");
        let mut planes = world.solids[0].planes.clone();
        planes.sort_by(|a, b| (&a.normal, &a.offset).cmp(&(&b.normal, &b.offset)));
        planes
    });
    assert_eq!(planes[0], planes[1]);
    assert_eq!(planes[0], planes[2]);
}
