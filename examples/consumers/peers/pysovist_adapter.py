"""pysovist (PyPI) under test: whether its exact isovist of a point reaches as far as another."""

from math import atan2, dist

from pysovist import Plan, isovist
from view_points import looks, serve, sides


def place(p):
    return tuple(float(c) for c in p)


def sees(question):
    (x0, y0), (x1, y1) = question.frame
    frame = sides([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
    plan = Plan([[place(end) for end in wall] for wall in [*question.walls, *frame]])
    seen = [False] * len(question.targets)
    for point in question.points:
        eye = place(point)
        view = isovist(plan, eye)
        for number, ends in enumerate(looks(question, point)):
            for x, y in map(place, ends):
                reach = view.depth(atan2(y - eye[1], x - eye[0]))
                seen[number] = seen[number] or bool(dist(eye, (x, y)) < reach)
        if all(seen):
            break
    return seen


serve(sees)
