"""shapely (PyPI; GEOS) under test: scenes of segments, and eyes in the plane, a case a line.

A line of sight is a segment that does not cross a wall (`crosses` or `touches` by the library). Of
eyes the rooms are asked for, seen if some of many points along the last portal is.
"""

import json
import sys
from fractions import Fraction

from shapely.geometry import LineString, MultiLineString

STEPS = 6


def point(pair):
    return tuple(float(Fraction(c)) for c in pair)


def inside(polygon):
    """Points inside of a rectangle."""
    (x0, y0), (x1, y1) = point(polygon[0]), point(polygon[2])
    shares = [(i + 0.5) / STEPS for i in range(STEPS)]
    return [(x0 + s * (x1 - x0), y0 + t * (y1 - y0)) for s in shares for t in shares]


def scene(case):
    walls = MultiLineString([[point(p) for p in wall] for wall in case["input"]["segments"]])
    rooms = {room["name"]: inside(room["polygon"]) for room in case["input"]["objects"]}
    pairs = ((p, q) for p in rooms[case["from"]] for q in rooms[case["to"]])
    seen = any(not LineString(pair).intersects(walls) for pair in pairs)
    return {"class": "open" if seen else "blocked"}


def eye(case):
    at = point(case["input"]["at"])
    doors = [LineString([point(p) for p in d["segment"]]) for d in case["input"]["scene"]["portals"]]
    cells = case["input"]["scene"]["cells"]
    seen = cells[:1]
    for number, door in enumerate(doors):
        targets = [door.interpolate((i + 0.5) / 64, normalized=True) for i in range(64)]
        ray = lambda target: LineString([at, (target.x, target.y)])
        if not any(all(ray(t).intersects(d) for d in doors[:number]) for t in targets):
            break
        seen.append(cells[number + 1])
    return {"cells": seen}


for line in sys.stdin:
    case = json.loads(line)
    if case["kind"] == "scene" and "segments" in case["input"]:
        said = scene(case)
    elif case["kind"] == "eye" and "segment" in case["input"]["scene"]["portals"][0]:
        said = eye(case)
    else:
        said = {"skip": "the plane only"}
    print(json.dumps(said), flush=True)
