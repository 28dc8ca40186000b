"""What libraries of the plane are asked: walls, view points that are enough, and targets.

A case becomes a `Question`: walls in a frame, and whether one of the points sees into a target. Its
points are enough, exactly. Let A and B be convex and apart, and an open set of lines of sight lead
from A to B. What a point of A sees of B changes only on the lines through two ends of walls or corners of B;
these cut A into cells, and one point of each is enough; even one of each cell at A's outline, for all
these lines of sight leave A. In the same way (`looks`) a point needs to look only once between two
directions in which there is an end or a corner. All numbers are Fractions, to be rounded last.
"""

import json
import sys
from collections import namedtuple
from fractions import Fraction
from itertools import combinations, pairwise

Question = namedtuple("Question", "frame walls corners points targets")
LONGEST = 12
REFUSED = f"no scene of segments, and no portals one above the other, up to {LONGEST}"


def number(value):
    return Fraction(value)


def pair(values):
    return tuple(number(value) for value in values)


def minus(p, q):
    return (p[0] - q[0], p[1] - q[1])


def cross(u, v):
    return u[0] * v[1] - u[1] * v[0]


def between(p, q, share=Fraction(1, 2)):
    return (p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]))


def sides(polygon):
    return list(zip(polygon, polygon[1:] + polygon[:1]))


def on_segment(p, wall):
    a, b = wall
    along = minus(p, a), minus(p, b)
    return cross(*along) == 0 and along[0][0] * along[1][0] + along[0][1] * along[1][1] <= 0


def on_frame(p, frame):
    return p[0] in (frame[0][0], frame[1][0]) or p[1] in (frame[0][1], frame[1][1])


def ends(walls, frame):
    """The ends of walls, and where two cross, but for what is on the frame."""
    found = {p for wall in walls for p in wall}
    for (a, b), other in combinations(walls, 2):
        share = meet(a, b, *other)
        if share is not None and on_segment(between(a, b, share), (a, b)):
            p = between(a, b, share)
            found |= {p} if on_segment(p, other) else set()
    return sorted(p for p in found if not on_frame(p, frame))


def meet(a, b, c, d):
    """Where on the line a b it meets the line c d: the share of the way from a to b."""
    turn = cross(minus(b, a), minus(d, c))
    return cross(minus(c, a), minus(d, c)) / turn if turn else None


def cell_points(area, target, walls, corners, frame):
    """A point inside each cell at the area's outline, but for walls and the frame."""
    corners = sorted({*corners, *target})
    lines = list(combinations(corners, 2))
    points = []
    for a, b in sides(area):
        if all(on_frame(p, frame) for p in (a, b, between(a, b))):
            continue
        shares = {meet(a, b, *line) for line in lines} - {None}
        for p in corners:
            if on_segment(p, (a, b)):
                shares.add(max(minus(p, a), key=abs) / max(minus(b, a), key=abs))
        shares = [0, *sorted(s for s in shares if 0 < s < 1), 1]
        middles = (between(a, b, (s + t) / 2) for s, t in pairwise(shares))
        free = (p for p in middles if not any(on_segment(p, wall) for wall in walls))
        points += [inward(p, (a, b), lines + sides(area)) for p in free]
    return points


def inward(p, side, lines):
    """A point halfway from a point of a side to the next line on the inside."""
    x, y = minus(side[1], side[0])
    within = (p[0] - y, p[1] + x)
    shares = (meet(p, within, *line) for line in lines)
    return between(p, within, min(s for s in shares if s is not None and s > 0) / 2)


def turn_of(v):
    """Grows with the angle of a direction, from 0 to 4."""
    share = v[1] / (abs(v[0]) + abs(v[1]))
    return share % 4 if v[0] >= 0 else 2 - share


def looks(question, point):
    """For each target, the points of it to look at from a point."""
    for target in question.targets:
        known = [p for p in [*question.corners, *target] if p != point]
        around = {turn_of(minus(p, point)): minus(p, point) for p in known}
        turns = [around[turn] for turn in sorted(around)]
        yield [q for u, v in zip(turns, turns[1:] + turns[:1]) if (q := middle(point, u, v, target))]


def middle(point, u, v, target):
    """The middle of what the ray halfway between two directions has in common with a polygon."""
    u, v = (tuple(c / (abs(w[0]) + abs(w[1])) for c in w) for w in (u, v))
    far = (point[0] + u[0] + v[0], point[1] + u[1] + v[1])
    low, high = Fraction(0), None
    for a, b in sides(target):
        height = [cross(minus(b, a), minus(p, a)) for p in (point, far)]
        if height[0] == height[1]:
            if height[0] <= 0:
                return None
        elif height[0] < height[1]:
            low = max(low, height[0] / (height[0] - height[1]))
        else:
            end = height[0] / (height[0] - height[1])
            high = end if high is None else min(high, end)
    return between(point, far, (low + high) / 2) if high is not None and low < high else None


def counter_clockwise(polygon):
    area = sum(cross(p, q) for p, q in sides(polygon))
    return polygon if area > 0 else polygon[::-1]


def scene(case):
    given = case["input"]
    frame = [pair(corner) for corner in given["view"]]
    walls = [[pair(end) for end in wall] for wall in given["segments"]]
    rooms = {o["name"]: counter_clockwise([pair(p) for p in o["polygon"]]) for o in given["objects"]}
    area, target = rooms[case["from"]], rooms[case["to"]]
    return between_rooms(frame, walls, area, target)


def between_rooms(frame, walls, area, target):
    corners = ends(walls, frame)
    points = cell_points(area, target, walls, corners, frame)
    return Question(frame, walls, corners, points, [target])


def row(portals, extra=()):
    """The frame, walls and rooms of portals one above the other, crossed upwards; else None."""
    portals = [[pair(end) for end in portal] for portal in portals]
    heights = [y for (_, y), _ in portals]
    if len(portals) > LONGEST:
        return None
    level = all(a[1] == b[1] and a[0] < b[0] for a, b in portals)
    if not level or any(y >= z for y, z in pairwise(heights)):
        return None
    known = [p for portal in portals for p in portal] + list(extra)
    (x0, x1), (y0, y1) = ((min(c) - 1, max(c) + 1) for c in zip(*known))
    walls = [wall for a, b in portals for wall in ([(x0, a[1]), a], [b, (x1, a[1])])]
    rooms = [[(x0, y), (x1, y), (x1, z), (x0, z)] for y, z in pairwise([y0, *heights, y1])]
    return [(x0, y0), (x1, y1)], walls, rooms


def chain(portals, start, end):
    frame, walls, rooms = row(portals)
    return between_rooms(frame, walls, rooms[start], rooms[end])


def in_order(graph):
    steps = list(pairwise(graph["cells"]))
    return [(p["from"], p["to"]) for p in graph["portals"]] == steps


def question_of(case):
    """What to ask for a case, or None where it cannot be asked."""
    given, kind = case["input"], case["kind"]
    if kind == "scene":
        return scene(case) if "segments" in given else None
    if kind == "sequence":
        flat = len(given["portals"][0]) == 2 and row(given["portals"])
        return chain(given["portals"], 0, len(given["portals"])) if flat else None
    graph = given.get("scene", given)
    if kind not in ("graph", "eye") or any("segment" not in p for p in graph["portals"]):
        return None
    portals = [p["segment"] for p in graph["portals"]]
    if not in_order(graph) or not row(portals):
        return None
    if kind == "graph":
        return chain(portals, *(graph["cells"].index(case[end]) for end in ("from", "to")))
    at = pair(given["at"])
    frame, walls, rooms = row(portals, [at])
    if at[1] >= pair(portals[0][0])[1]:
        return None
    return Question(frame, walls, ends(walls, frame), [at], rooms[1:])


def answer(case, sees):
    question = question_of(case)
    if question is None:
        return {"skip": REFUSED}
    seen = sees(question)
    if seen is None:
        return {"skip": "refused by the library"}
    if case["kind"] == "eye":
        cells = case["input"]["scene"]["cells"]
        return {"cells": cells[:1] + [cell for cell, yes in zip(cells[1:], seen) if yes]}
    return {"class": "open" if seen[0] else "blocked"}


def serve(sees):
    """Answers a case a line; `sees(question)` tells for each target whether it is seen, or None."""
    for line in sys.stdin:
        print(json.dumps(answer(json.loads(line), sees)), flush=True)


def serve_segments(clear, rounded=float):
    """As `serve`; `clear(walls)` makes the test whether a segment p q meets no wall."""

    def place(p):
        return tuple(rounded(c) for c in p)

    def sees(question):
        free = clear([[place(end) for end in wall] for wall in question.walls])
        seen = [False] * len(question.targets)
        for point in question.points:
            for number, ends in enumerate(looks(question, point)):
                seen[number] = seen[number] or any(free(place(point), place(q)) for q in ends)
            if all(seen):
                break
        return seen

    serve(sees)
