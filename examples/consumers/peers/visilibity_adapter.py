"""VisiLibity (PyPI) under test: whether a point is in the visibility polygon of another, both by it.

It wants a polygon with an inside all along its outline, so walls become wedges, with the tip at the
wall's end. They are so flat that they hide nothing that leads from one row of walls to the next.
"""

from view_points import looks, serve
from visilibity import Environment, Point, Polygon, Visibility_Polygon

EPSILON = 1e-12


def outline(question):
    """The frame with wedges for walls that lead along x from its left or right side."""
    (x0, y0), (x1, y1) = question.frame
    heights = sorted({y0, y1} | {wall[0][1] for wall in question.walls})
    flat = min(b - a for a, b in zip(heights, heights[1:])) / (4 * (x1 - x0))
    rising, falling = [], []
    for (ax, y), (bx, _) in question.walls:
        side, tip = (ax, bx) if ax in (x0, x1) else (bx, ax)
        half = flat * abs(tip - side)
        (rising if side == x1 else falling).append([(side, y - half), (tip, y), (side, y + half)])
    rising.sort(key=lambda wedge: wedge[1][1])
    falling.sort(key=lambda wedge: wedge[1][1], reverse=True)
    right = [corner for wedge in rising for corner in wedge]
    left = [corner for wedge in falling for corner in reversed(wedge)]
    return [(x0, y0), (x1, y0), *right, (x1, y1), (x0, y1), *left]


def place(p):
    return Point(float(p[0]), float(p[1]))


def sees(question):
    room = Environment([Polygon([place(p) for p in outline(question)])])
    room.enforce_standard_form()
    if not room.is_valid(EPSILON):
        return None
    seen = [False] * len(question.targets)
    for point in question.points:
        region = Visibility_Polygon(place(point), room, EPSILON)
        for number, ends in enumerate(looks(question, point)):
            seen[number] = seen[number] or any(place(q)._in(region, EPSILON) for q in ends)
        if all(seen):
            break
    return seen


serve(sees)
