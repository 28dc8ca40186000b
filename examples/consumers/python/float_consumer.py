"""A small consumer in floats: is there a line through segments of the plane?

Some line through two of the segments' ends is weakly right if any line is, so all are tried, with
an epsilon of 1e-9, as many programs do. As a program under test it reads one case a line.
"""

import json
import sys
from stabline_vectors import number

EPSILON = 1e-9


def floats(points):
    return [[float(number(c)) for c in point] for point in points]


def passes(gates):
    """Whether a line touches all gates, each a (left, right), in their direction."""
    left = [gate[0] for gate in gates]
    right = [gate[1] for gate in gates]
    if len(gates) == 1:
        return True
    for p in left + right:
        for q in left + right:
            d = (q[0] - p[0], q[1] - p[1])
            if d == (0.0, 0.0):
                continue
            turn = lambda r: d[0] * (r[1] - p[1]) - d[1] * (r[0] - p[0])
            if all(turn(r) >= -EPSILON for r in left) and all(turn(r) <= EPSILON for r in right):
                return True
    return False


def sees(case):
    """Whether a sequence, or a pair of cells of a graph, is seen; None if it is not of the plane."""
    if case["kind"] == "sequence":
        gates = case["input"]["portals"]
        return passes([floats(g) for g in gates]) if len(gates[0][0]) == 2 else None
    portals = case["input"].get("portals")
    if case["kind"] != "graph" or "segment" not in portals[0]:
        return None
    doors = [(p["from"], p["to"], floats(p["segment"])) for p in portals]
    doors += [(b, a, [right, left]) for a, b, (left, right) in doors]

    def reaches(cell, gates, crossed):
        if cell == case["to"]:
            return True
        return any(
            a == cell and b not in crossed and passes(gates + [gate])
            and reaches(b, gates + [gate], crossed | {b})
            for a, b, gate in doors
        )

    return reaches(case["from"], [], {case["from"]})


if __name__ == "__main__":
    for line in sys.stdin:
        seen = sees(json.loads(line))
        answer = {"skip": "the plane only"} if seen is None else {"class": "open" if seen else "blocked"}
        print(json.dumps(answer), flush=True)
