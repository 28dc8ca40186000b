//! What becomes of arbitrary polygons, against definitions written out by brute force.

use proptest::prelude::*;
use stabline::scene::{PortalGraph, read_graph};

type Vector = [i64; 3];

fn minus(a: Vector, b: Vector) -> Vector {
    [0, 1, 2].map(|i| a[i] - b[i])
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: Vector, b: Vector) -> i64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// Twice the vector area of a polygon.
fn area(polygon: &[Vector]) -> Vector {
    let n = polygon.len();
    (0..n).fold([0; 3], |sum, i| {
        let term = cross(polygon[i], polygon[(i + 1) % n]);
        [0, 1, 2].map(|axis| sum[axis] + term[axis])
    })
}

/// Every vertex that is not on an edge lies strictly on its inner side, and in the plane.
fn is_planar_and_strictly_convex(polygon: &[Vector]) -> bool {
    let normal = area(polygon);
    let n = polygon.len();
    normal != [0; 3]
        && (0..n).all(|i| {
            let (a, b) = (polygon[i], polygon[(i + 1) % n]);
            let inwards = cross(normal, minus(b, a));
            (0..n).all(|j| {
                let side = dot(inwards, minus(polygon[j], a));
                let on_edge = j == i || j == (i + 1) % n;
                dot(normal, minus(polygon[j], a)) == 0 && if on_edge { side == 0 } else { side > 0 }
            })
        })
}

fn pieces(graph: &PortalGraph) -> Vec<Vec<Vector>> {
    let grid = |vertex: &u32| {
        let numerators = graph.vertices[*vertex as usize].numerators();
        [0, 1, 2].map(|axis| i64::try_from(&numerators[axis]).unwrap())
    };
    graph.portals.iter().map(|portal| portal.vertices.iter().map(grid).collect()).collect()
}

fn read(polygon: &[Vector], suffix: &str) -> Option<PortalGraph> {
    let corner = |[x, y, z]: &Vector| format!("({x}{suffix} {y}{suffix} {z}{suffix} ) ");
    let corners: String = polygon.iter().map(corner).collect();
    let text = format!("PRT1\n2\n1\n{} 0 1 {corners}\n", polygon.len());
    read_graph("x.prt", text.as_bytes()).ok()
}

/// Whether the polygon, as it looks along the axis of its largest area, has an outline in which no
/// point comes twice. (Repeated neighbours are one corner.)
fn looks_simple(polygon: &[Vector]) -> bool {
    let area = area(polygon).map(i64::abs);
    let largest = *area.iter().max().unwrap();
    let axis = area.iter().position(|&part| part == largest).unwrap();
    let mut whole = polygon.to_vec();
    whole.dedup();
    if whole.len() > 1 && whole.first() == whole.last() {
        whole.pop();
    }
    let flat: Vec<[i64; 2]> =
        whole.iter().map(|v| [v[(axis + 1) % 3], v[(axis + 2) % 3]]).collect();
    let n = flat.len();
    let turn = |a: [i64; 2], b: [i64; 2], c: [i64; 2]| {
        ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).signum()
    };
    let within = |p: [i64; 2], a: [i64; 2], b: [i64; 2]| {
        turn(a, b, p) == 0 && (0..2).all(|i| a[i].min(b[i]) <= p[i] && p[i] <= a[i].max(b[i]))
    };
    largest > 0
        && (0..n).all(|i| {
            let (a, b) = (flat[i], flat[(i + 1) % n]);
            a != b
                && (0..n).filter(|&j| j != i).all(|j| {
                    let (c, d) = (flat[j], flat[(j + 1) % n]);
                    let crosses =
                        turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
                    // A corner lies on the edges that it ends, and on no other.
                    !crosses && (j == (i + 1) % n || !within(c, a, b))
                })
        })
}

fn check(polygon: &[Vector]) {
    let Some(graph) = read(polygon, "") else {
        assert!(!looks_simple(polygon), "{polygon:?} was refused");
        return;
    };
    let pieces = pieces(&graph);
    let mut sum = [0; 3];
    for piece in &pieces {
        assert!(is_planar_and_strictly_convex(piece), "{polygon:?} became {pieces:?}");
        let area = area(piece);
        sum = [0, 1, 2].map(|axis| sum[axis] + area[axis]);
        assert!(piece.iter().all(|vertex| polygon.contains(vertex)));
    }
    assert_eq!(sum, area(polygon), "{polygon:?} became {pieces:?}");
    if is_planar_and_strictly_convex(polygon) {
        assert_eq!(pieces, [polygon.to_vec()]);
        assert_eq!(graph.skew_portals, 0);
    }
    // Far beyond 128 bits the same pieces come out.
    let far = read(polygon, "e50").unwrap();
    assert_eq!(far.portals, graph.portals);
    assert_eq!((far.skew_portals, far.repairs), (graph.skew_portals, graph.repairs));
}

proptest! {
    #![proptest_config(ProptestConfig {
        cases: 4000,
        failure_persistence: None,
        ..ProptestConfig::default()
    })]

    #[test]
    fn polygons_of_a_small_grid(
        polygon in prop::collection::vec(prop::array::uniform3(-2i64..3), 3..7),
    ) {
        check(&polygon);
    }

    #[test]
    fn planar_polygons_of_a_small_grid(
        flat in prop::collection::vec(prop::array::uniform2(-3i64..4), 3..8),
        u in prop::array::uniform3(-2i64..3),
        v in prop::array::uniform3(-2i64..3),
    ) {
        let polygon: Vec<Vector> =
            flat.iter().map(|[s, t]| [0, 1, 2].map(|axis| s * u[axis] + t * v[axis])).collect();
        check(&polygon);
    }

    #[test]
    fn nearly_planar_nearly_convex_polygons(
        radii in prop::collection::vec(900i64..1000, 8),
        heights in prop::collection::vec(-1i64..2, 8),
    ) {
        const DIRECTIONS: [[i64; 2]; 8] =
            [[10, 0], [7, 7], [0, 10], [-7, 7], [-10, 0], [-7, -7], [0, -10], [7, -7]];
        let polygon: Vec<Vector> = (0..8)
            .map(|i| [DIRECTIONS[i][0] * radii[i], DIRECTIONS[i][1] * radii[i], heights[i]])
            .collect();
        check(&polygon);
    }
}
