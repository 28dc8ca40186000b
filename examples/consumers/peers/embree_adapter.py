"""Embree (PyPI: embreex, numpy) under test: scenes of polygons in space, by many rays, as renderers do.

Rays from random points of the one view cell to random points of the other, in single floats; the same
ones in each run.
"""

import json
import sys
from fractions import Fraction

import numpy
from embreex.mesh_construction import TriangleMesh
from embreex.rtcore_scene import EmbreeScene

RAYS = 100_000


def point(values):
    return [float(Fraction(v)) for v in values]


def triangles(polygon):
    corners = [point(p) for p in polygon]
    return [[corners[0], b, c] for b, c in zip(corners[1:], corners[2:])]


def inside(box, random):
    low, high = (numpy.array(point(corner)) for corner in box)
    return low + random.random((RAYS, 3)) * (high - low)


def sees(case):
    scene, random = case["input"], numpy.random.default_rng(0)
    faces = [face for wall in scene["polygons"] for face in triangles(wall["polygon"])]
    rooms = {room["name"]: inside(room["box"], random) for room in scene["objects"]}
    eyes, ways = rooms[case["from"]], rooms[case["to"]] - rooms[case["from"]]
    world = EmbreeScene()
    TriangleMesh(world, numpy.array(faces, dtype=numpy.float32))
    hits = world.run(eyes.astype(numpy.float32), ways.astype(numpy.float32), query="DISTANCE")
    return bool((hits > 1).any())


for line in sys.stdin:
    case = json.loads(line)
    kinds = {"about", "format", "grid", "objects", "polygons", "view"}
    if case["kind"] == "scene" and "polygons" in case["input"] and kinds >= case["input"].keys():
        said = {"class": "open" if sees(case) else "blocked"}
    else:
        said = {"skip": "scenes of polygons only"}
    print(json.dumps(said), flush=True)
