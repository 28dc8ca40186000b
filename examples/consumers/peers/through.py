"""Asks a program about walls, points and targets, a question a line: `through.py [--doubles] PROGRAM ...`

A line is the frame (4 numbers); the number of walls, and 4 numbers for each; the number of targets, and
for each the number of its corners and they; the number of points, and they. Numbers are integers
and ratios. With `--doubles` they are rounded, and for each point and each target there follow the
number of points of the target to look at, and they. The answer is a line with a 0 or 1 for each
target: whether one of the points sees into it.
"""

import subprocess
import sys

from view_points import looks, serve

doubles = sys.argv[1] == "--doubles"
program = subprocess.Popen(
    sys.argv[2 if doubles else 1 :], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
)


def numbers(points):
    return [c for p in points for c in p]


def counted(points):
    return [len(points), *numbers(points)]


def words(question):
    yield from numbers(question.frame)
    yield len(question.walls)
    yield from numbers(end for wall in question.walls for end in wall)
    yield len(question.targets)
    for target in question.targets:
        yield from counted(target)
    yield from counted(question.points)
    if doubles:
        for point in question.points:
            for ends in looks(question, point):
                yield from counted(ends)


def sees(question):
    text = (repr(float(w)) if doubles and not isinstance(w, int) else str(w) for w in words(question))
    print(*text, file=program.stdin, flush=True)
    line = program.stdout.readline()
    if not line:
        sys.exit("the program has ended")
    return [word == "1" for word in line.split()]


serve(sees)
