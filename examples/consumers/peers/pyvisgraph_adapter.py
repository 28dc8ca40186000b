"""pyvisgraph (PyPI) under test: scenes of segments, a case a line.

The library answers which points see each other between polygons. View cells are regions, so points
inside them are tried: a grid in each. Segments become polygons of two corners.
"""

import json
import sys
from fractions import Fraction

import pyvisgraph as vg
from pyvisgraph.visible_vertices import edge_intersect

STEPS = 6


def point(pair):
    return [float(Fraction(c)) for c in pair]


def inside(polygon):
    """Points inside of a rectangle."""
    (x0, y0), (x1, y1) = point(polygon[0]), point(polygon[2])
    shares = [(i + 0.5) / STEPS for i in range(STEPS)]
    return [vg.Point(x0 + s * (x1 - x0), y0 + t * (y1 - y0)) for s in shares for t in shares]


def sees(case):
    scene = case["input"]
    walls = [vg.graph.Edge(*(vg.Point(*point(p)) for p in wall)) for wall in scene["segments"]]
    rooms = {room["name"]: inside(room["polygon"]) for room in scene["objects"]}
    free = lambda p, q: not any(edge_intersect(p, q, wall) for wall in walls)
    return any(free(p, q) for p in rooms[case["from"]] for q in rooms[case["to"]])


for line in sys.stdin:
    case = json.loads(line)
    if case["kind"] == "scene" and "segments" in case["input"]:
        print(json.dumps({"class": "open" if sees(case) else "blocked"}), flush=True)
    else:
        print('{"skip": "scenes of segments only"}', flush=True)
