//! Polygons of every kind, in portal files of one portal between cells 0 and 1.

use super::*;
use crate::geom::RationalPoint3;
use crate::num::Int;

/// A portal file with one portal of these vertices.
fn one_portal(vertices: &str) -> String {
    let count = vertices.split(',').count();
    let vertices: String = vertices.split(',').map(|v| format!("({} ) ", v.trim())).collect();
    format!("PRT1\n2\n1\n{count} 0 1 {vertices}\n")
}

fn read(vertices: &str) -> Result<PortalGraph, InputError> {
    read_graph("x.prt", one_portal(vertices).as_bytes())
}

fn polygons(graph: &PortalGraph) -> Vec<Vec<u32>> {
    graph.portals.iter().map(|portal| portal.vertices.clone()).collect()
}

#[test]
fn planar_convex_portals_keep_their_order_and_their_sides() {
    let graph = read("0 0 1.5, 0 4 1.5, 0 4 0.25, 0 0 0.25").unwrap();
    assert_eq!(polygons(&graph), [[0, 1, 2, 3]]);
    assert_eq!((graph.portals[0].from, graph.portals[0].to), (CellId(0), CellId(1)));
    assert_eq!(graph.small_grid().unwrap().denominator, Int::from(4));
    assert_eq!(graph.vertices[2], RationalPoint3::new([0, 16, 1].map(Int::from), Int::from(4)));
    assert_eq!((graph.skew_portals, graph.repairs), (0, Repairs::default()));
}

#[test]
fn portals_share_equal_vertices() {
    let text = "PRT1\n3\n2\n3 0 1 (0 0 0 ) (1 0 0 ) (0 1 0 )\n3 1 2 (0 0 5 ) (1.0 0 0 ) (0 1 0 )\n";
    let graph = read_graph("x.prt", text.as_bytes()).unwrap();
    assert_eq!(polygons(&graph), [[0, 1, 2], [3, 1, 2]]);
}

#[test]
fn skew_portals_become_fans_from_their_first_vertex() {
    let graph = read("0 0 0, 4 0 0, 4 4 0.000001, 2 6 0, 0 4 0").unwrap();
    assert_eq!(polygons(&graph), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    assert!(graph.portals.iter().all(|portal| portal.source == 0));
    assert_eq!((graph.skew_portals, graph.repairs), (1, Repairs::default()));
}

#[test]
fn repeated_and_collinear_vertices_are_dropped_and_counted() {
    let graph = read("0 0 0, 0 0 0, 2 0 0, 4 0 0, 4 4 0, 0 4 0, 0 2 0, 0.0 0 0").unwrap();
    assert_eq!(polygons(&graph), [[0, 2, 3, 4]]);
    let repairs = Repairs { repeated_vertices: 2, collinear_vertices: 2, ..Repairs::default() };
    assert_eq!(graph.repairs, repairs);
}

#[test]
fn a_dent_moves_the_fan_to_where_it_tiles() {
    // The third vertex lies a hair inside the line between its neighbours.
    let graph = read("0 0 0, 4 0 0, 3.999999 2 0, 4 4 0, 0 4 0").unwrap();
    assert_eq!(polygons(&graph), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    let repairs = Repairs { dented_portals: 1, ..Repairs::default() };
    assert_eq!(graph.repairs, repairs);
    let graph = read("0 0 0, 2 0.000001 0, 4 0 0, 4 4 0, 0 4 0").unwrap();
    assert_eq!(polygons(&graph), [[1, 2, 3], [1, 3, 4], [1, 4, 0]]);
    let repairs = Repairs { dented_portals: 1, moved_fans: 1, ..Repairs::default() };
    assert_eq!((graph.skew_portals, graph.repairs), (0, repairs));
}

#[test]
fn portals_that_share_both_cells_need_no_order_but_make_a_cell_not_convex() {
    // A skew door: as seen from one side, each triangle reaches through the other's plane.
    let graph = read("0 0 0, 0 4 0, 1 4 4, 0 0 4").unwrap();
    assert_eq!((graph.portals.len(), graph.skew_portals), (2, 1));
    let order = CellOrder::new(&graph);
    assert_eq!((order.pairs(), order.nonconvex_cells), (&[][..], 1));
    // Doors beyond it do need the order, in each of its cells.
    let door =
        |cells: &str, x: i32| format!("4 {cells} ({x} 0 0 ) ({x} 4 0 ) ({x} 4 4 ) ({x} 0 4 )\n");
    let skew = "4 0 1 (0 0 0 ) (0 4 0 ) (5 4 4 ) (0 0 4 )\n";
    let text = format!("PRT1\n3\n2\n{skew}{}", door("1 2", 4));
    let graph = read_graph("x.prt", text.as_bytes()).unwrap();
    let order = CellOrder::new(&graph);
    assert!(order.is_implied(PortalId(0), PortalId(1)));
    assert!(order.pairs().iter().all(|[_, far]| *far == PortalId(2)));
    assert!(!order.pairs().is_empty());
}

#[test]
fn a_zigzag_that_no_fan_tiles_is_cut_by_its_ears() {
    // Two hairs of rounding dent each side: from no vertex are all the others seen.
    let zigzag = "0 0 0, 1 0.000001 0, 2 0 0, 3 0.000001 0, 4 0 0, 3.999999 1 0, 4 2 0, \
                  3.999999 3 0, 4 4 0, 3 3.999999 0, 2 4 0, 1 3.999999 0, 0 4 0, 0.000001 3 0, \
                  0 2 0, 0.000001 1 0";
    for (height, skew) in [("0", 0), ("0.000001", 1)] {
        let graph = read(&zigzag.replace("4 4 0,", &format!("4 4 {height},"))).unwrap();
        assert_eq!(graph.portals.len(), 14);
        let used: std::collections::BTreeSet<u32> =
            polygons(&graph).into_iter().flatten().collect();
        assert_eq!(used.len(), 16);
        let repairs =
            Repairs { dented_portals: 1 - skew, clipped_portals: 1, ..Repairs::default() };
        assert_eq!((graph.skew_portals, graph.repairs), (skew, repairs));
    }
    // A comb, whose teeth hide from one another.
    let comb = "0 0 0, 9 0 0, 9 9 0, 7 1 0, 5 9 0, 4 1 0, 2 9 0, 1 1 0, 0 9 0";
    assert_eq!(read(comb).unwrap().portals.len(), 7);
}

#[test]
fn triangles_without_area_are_dropped_and_counted() {
    let graph = read("0 0 0, 2 0 0, 4 0 0, 4 4 1, 0 4 0").unwrap();
    assert_eq!(polygons(&graph), [[0, 2, 3], [0, 3, 4]]);
    let repairs = Repairs { vanished_triangles: 1, ..Repairs::default() };
    assert_eq!((graph.skew_portals, graph.repairs), (1, repairs));
}

#[test]
fn a_spike_without_area_is_dropped_and_counted() {
    let graph = read("0 0 0, 2 0 0, 4 0 0, 2 0 0, 2 2 0").unwrap();
    assert_eq!(polygons(&graph), [[0, 1, 3]]);
    let repairs = Repairs { dented_portals: 1, vanished_triangles: 2, ..Repairs::default() };
    assert_eq!(graph.repairs, repairs);
}

#[test]
fn degenerate_polygons_are_refused() {
    let cases = [
        ("0 0 0, 1 1 1, 2 2 2", "x.prt:4: portal 0: the polygon has zero area"),
        ("0 0 0, 0 0 0, 2 2 2", "x.prt:4: portal 0: 2 distinct vertices in a row"),
        ("1 1 1, 1 1 1, 1 1 1", "x.prt:4: portal 0: 1 distinct vertices in a row"),
        // A figure eight of equal loops, one of different loops.
        ("0 0 0, 2 2 0, 2 0 0, 0 2 0", "the polygon has zero area"),
        ("0 0 0, 3 3 0, 3 0 0, 0 2 0", "not convex"),
        // A pentagram turns left throughout, but twice around.
        ("0 10 0, -6 -8 0, 9 3 0, -9 3 0, 6 -8 0", "not convex"),
        // An outline that touches itself in a corner, in an edge, and folded back on itself.
        ("0 0 0, 4 0 0, 2 2 0, 4 4 0, 0 4 0, 2 2 0", "touches itself"),
        ("0 0 0, 4 0 0, 4 4 0, 2 0 0, 0 4 0", "touches itself"),
        ("0 0 0, 6 0 0, 6 4 0, 6 -2 0, 7 6 0, 0 6 0", "touches itself"),
    ];
    for (vertices, expected) in cases {
        let error = read(vertices).unwrap_err().to_string();
        assert!(error.contains(expected), "{vertices}: {error}");
    }
    let error = read_graph("x.prt", b"PRT1\n2\n1\n3 1 1 (0 0 0 ) (1 0 0 ) (0 1 0 )\n");
    assert!(error.unwrap_err().to_string().contains("joins cell 1 with itself"));
}

#[test]
fn wide_coordinates_give_the_same_shapes() {
    let shift = "12345678901234567890";
    for polygon in [
        "0 0 0, 4 0 0, 4 4 0, 0 4 0",
        "0 0 0, 4 0 0, 4 4 0.000001, 0 4 0",
        "0 0 0, 2 0.000001 0, 4 0 0, 4 4 0, 0 4 0",
        "0 0 0, 0 0 0, 2 0 0, 4 0 0, 4 4 0, 0 4 0",
    ] {
        let near = read(polygon).unwrap();
        let moved: Vec<String> =
            polygon.split(", ").map(|vertex| format!("{shift}{}", vertex)).collect();
        let far = read(&moved.join(", ")).unwrap();
        assert_eq!(polygons(&near), polygons(&far), "{polygon}");
        assert_eq!((near.skew_portals, near.repairs), (far.skew_portals, far.repairs));
    }
}

#[test]
fn json_scenes_name_their_cells_and_keep_every_digit() {
    let text = r#"{"about": "one door", "format": "stabline-scene/1", "cells": ["hall", "yard"],
        "portals": [{"from": "yard", "to": "hall", "polygon":
        [[0, 0, 0.56285683454726874605620706], ["7/3", 1e1, 0], [0, "12.5", 0]]}]}"#;
    let graph = read_graph("x.json", text.as_bytes()).unwrap();
    assert_eq!((graph.portals[0].from, graph.portals[0].to), (CellId(1), CellId(0)));
    let z = &graph.vertices[0].coordinates()[2];
    assert_eq!(*z, crate::num::parse_decimal("0.56285683454726874605620706").unwrap());
    assert_eq!(graph.vertices[1].numerators(), &[7, 30, 0].map(Int::from));
    assert_eq!(graph.vertices[1].denominator(), &Int::from(3));
    assert_eq!(graph.small_grid(), None);
    assert_eq!(graph.leaf_to_cell, [CellId(0), CellId(1)]);
}

#[test]
fn a_broken_scene_names_the_place() {
    let good = r#"{"about": "one door", "format": "stabline-scene/1", "grid": 2,
        "cells": ["hall", "yard"],
        "portals": [{"from": "yard", "to": "hall", "polygon": [[0, 0, 0], [2, 0, 0.5], [0, 2, 0]]}]}"#;
    assert!(read_graph("x.json", good.as_bytes()).is_ok());
    let cases = [
        ("0.5", "0.25", "x.json: portal 0: vertex 1: coordinate 1/4 is not a multiple"),
        ("0.5", "\"nan\"", "x.json:3: column"),
        ("0.5", "\"1/0\"", "coordinate `1/0`: the denominator is zero"),
        ("0.5", "null", "expected a number or a ratio in quotes, got `null`"),
        ("0.5", "1e9999", "the exponent is larger than 4096"),
        ("\"grid\": 2", "\"grid\": 0", "grid: expected a positive integer, got `0`"),
        ("\"grid\": 2", "\"grit\": 2", "unknown field `grit`"),
        ("scene/1", "scene/2", "format: expected `stabline-scene/1`, got `stabline-scene/2`"),
        ("\"yard\", \"to\"", "\"cellar\", \"to\"", "portals[0].from: there is no cell `cellar`"),
        (
            "\"hall\", \"yard\"",
            "\"yard\", \"yard\"",
            "cells[1]: `yard` is the name of cells[0] too",
        ),
        ("[2, 0, 0.5], ", "", "2 distinct vertices in a row"),
        ("[2, 0, 0.5]", "[2, 0]", "invalid length 2"),
        ("]}", "", "x.json:"),
    ];
    for (from, to, expected) in cases {
        assert!(good.contains(from), "{from}");
        let error = read_graph("x.json", good.replacen(from, to, 1).as_bytes()).unwrap_err();
        assert!(error.to_string().contains(expected), "{to}: {error}");
    }
}

#[test]
fn a_grid_of_many_denominators_is_refused() {
    let vertices: Vec<String> = (0..2000u64)
        .map(|i| format!("[{i}, {}, \"1/{}\"]", i * i, (1 << 40) + 2 * i + 1))
        .collect();
    let text = format!(
        r#"{{"about": "", "format": "stabline-scene/1", "cells": ["a", "b"],
        "portals": [{{"from": "a", "to": "b", "polygon": [{}]}}]}}"#,
        vertices.join(", ")
    );
    let error = read_graph("x.json", text.as_bytes()).unwrap_err().to_string();
    assert!(
        error.contains("the common denominator of the portal's coordinates exceeds"),
        "{error}"
    );
}

#[test]
fn portals_on_grids_of_their_own_need_no_common_one() {
    // Each wall is at another fraction: together 80000 bits of denominators.
    let wall = |i: u64| {
        let x = format!("\"{i}/{}\"", (1u64 << 40) + 2 * i + 1);
        format!(
            r#"{{"from": "a", "to": "b", "polygon": [[{x}, 0, 0], [{x}, 4, 0], [{x}, 4, 4], [{x}, 0, 4]]}}"#
        )
    };
    let walls: Vec<String> = (1..2000).map(wall).collect();
    let text = format!(
        r#"{{"about": "", "format": "stabline-scene/1", "cells": ["a", "b"], "portals": [{}]}}"#,
        walls.join(", ")
    );
    let graph = read_graph("x.json", text.as_bytes()).unwrap();
    assert_eq!((graph.portals.len(), graph.vertices.len()), (1999, 4 * 1999));
    assert_eq!((graph.small_grid(), graph.repairs), (None, Repairs::default()));
    let x = crate::num::Rational::new(3.into(), ((1u64 << 40) + 7).into());
    assert_eq!(graph.vertices[8].coordinates()[0], x);
}

#[test]
fn the_order_of_portals_is_implied_in_convex_cells() {
    // Cell 1 is a box with doors in three of its walls.
    let door = "4 0 1 (0 1 1 ) (0 3 1 ) (0 3 3 ) (0 1 3 )";
    let opposite = "4 1 2 (4 1 1 ) (4 3 1 ) (4 3 3 ) (4 1 3 )";
    let beside = "4 1 3 (1 4 1 ) (1 4 3 ) (3 4 3 ) (3 4 1 )";
    let text = format!("PRT1\n4\n3\n{door}\n{opposite}\n{beside}\n");
    let graph = read_graph("x.prt", text.as_bytes()).unwrap();
    assert_eq!(CellOrder::new(&graph), CellOrder::default());

    // The first door now leans through the second door's plane, and that one through its own.
    let leaning = "3 0 1 (0 1 1 ) (6 3 1 ) (0 1 3 )";
    let text = format!("PRT1\n4\n3\n{leaning}\n{opposite}\n{beside}\n");
    let graph = read_graph("x.prt", text.as_bytes()).unwrap();
    let order = CellOrder::new(&graph);
    assert_eq!(order.nonconvex_cells, 1);
    assert_eq!(order.pairs(), &[[PortalId(0), PortalId(1)]]);
    assert!(!order.is_implied(PortalId(1), PortalId(0)));
    assert!(order.is_implied(PortalId(1), PortalId(2)));
}

#[test]
fn portals_of_one_plane_that_are_crossed_the_same_way_have_no_order() {
    // Two doors of the plane x = 0: out of cell 0 into cell 1, and out of cell 1 into cell 2.
    let door = |cells: &str, corners: &str| format!("4 {cells} {corners}\n");
    let one = "(0 0 0 ) (0 4 0 ) (0 4 4 ) (0 0 4 )";
    let other = "(0 1 1 ) (0 5 1 ) (0 5 5 ) (0 1 5 )";
    let turned = "(0 1 5 ) (0 5 5 ) (0 5 1 ) (0 1 1 )";
    for (cells, corners, expected) in [
        ("1 2", other, true),
        // Written from the other side, the same; turned about, an ordinary wall with two doors.
        ("2 1", turned, true),
        ("1 2", turned, false),
        ("2 1", other, false),
    ] {
        let text = format!("PRT1\n3\n2\n{}{}", door("0 1", one), door(cells, corners));
        let order = CellOrder::new(&read_graph("x.prt", text.as_bytes()).unwrap());
        assert_eq!(order.is_impossible(PortalId(1), PortalId(0)), expected, "{cells} {corners}");
        assert!(order.is_implied(PortalId(0), PortalId(1)));
    }
}
