#!/usr/bin/env python3
"""Checks a proof of a PVS (`stabline pvs INPUT --proof DIR`), with nothing but the standard library.

Written from the page docs/formats/proof.md alone, whose words it uses, so that it shares nothing
with the program that made the proof. All numbers are integers; there are no tolerances.

    verify.py PROOF [INPUT]   PROOF is the folder of the proof or its file, .txt or .gz; with INPUT,
                              a .prt (PRT1, PRT2) or a JSON portal graph, whether it is of that
    verify.py --each FILE…    one line for each of many proofs

Exit codes: 0 all holds; 3 a file cannot be read, or is no proof; 5 something does not hold.
"""

import gzip
import hashlib
import json
import os
import re
import sys
import zlib
from fractions import Fraction

FORMAT = b"stabline-proof/1"
INTEGER = re.compile(rb"(0|-?[1-9][0-9]*)\Z")
NATURAL = re.compile(rb"(0|[1-9][0-9]*)\Z")
DECIMAL = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]{1,4})?\Z")
RATIO = re.compile(r"[+-]?[0-9]+/[0-9]+\Z")


class Wrong(Exception):
    """What does not hold, as a sentence that names the rule."""


class Unreadable(Exception):
    """A file that cannot be read."""


def need(holds, rule):
    if not holds:
        raise Wrong(rule)


# Numbers, vectors, lines.


def integer(field):
    need(INTEGER.match(field), "an integer was expected")
    return int(field)


def natural(field, below=None):
    """A number that counts or names something, less than `below`."""
    need(NATURAL.match(field), "a number from 0 was expected")
    number = int(field)
    need(below is None or number < below, "a number is too large for what it names")
    return number


def integers(fields):
    return [integer(field) for field in fields]


def sign(x):
    return (x > 0) - (x < 0)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def vertex(fields):
    point = tuple(integers(fields))
    need(len(point) == 4 and point[3] > 0, "a vertex has four integers, the last of them positive")
    return point


def line_through(p, q):
    """Direction, then moment, of the line from p to q."""
    return tuple(p[3] * q[i] - q[3] * p[i] for i in range(3)) + cross(p, q)


def side(x, y):
    return (x[0] * y[3] + x[1] * y[4] + x[2] * y[5]
            + x[3] * y[0] + x[4] * y[1] + x[5] * y[2])


def plane_through(a, b, c):
    """The normal N and D."""
    bc, ca, ab = cross(b, c), cross(c, a), cross(a, b)
    normal = tuple(a[3] * bc[i] + b[3] * ca[i] + c[3] * ab[i] for i in range(3))
    return normal, dot(a, bc)


def height(plane, p):
    return dot(plane[0], p) - plane[1] * p[3]


def surd_sign(a, b, r):
    """The sign of a + b√r."""
    if sign(a) * sign(b) >= 0 or r == 0:
        return sign(a) if r == 0 else sign(a) or sign(b)
    return sign(a) * sign(a * a - r * b * b)


# The text.


class Lines:
    """The lines of a proof, one after another, and their hash."""

    def __init__(self, stream):
        self.stream, self.number = stream, 0
        self.hash, self.raw = hashlib.sha256(), b""

    def next(self):
        """The next line; what was hashed then ends before it."""
        self.hash.update(self.raw)
        self.number += 1
        try:
            self.raw = self.stream.readline()
        except (OSError, EOFError, zlib.error) as error:
            raise Wrong("cannot be unpacked: %s" % error) from None
        need(self.raw, "the text ends before its last line, the seal")
        need(self.raw.endswith(b"\n"), "the line has no end")
        try:
            self.raw.decode("utf-8")
        except UnicodeDecodeError:
            raise Wrong("the text is no UTF-8") from None
        return self.raw[:-1]

    def fields(self):
        return self.next().split(b" ")

    def count(self, word):
        """The number of a line `WORD N`."""
        fields = self.fields()
        need(len(fields) == 2 and fields[0] == word, "`%s N` was expected" % word.decode())
        return natural(fields[1])


class Directed:
    """A directed portal: from where it leads where, its vertices, its plane, its edges as lines."""

    def __init__(self, leaves, enters, corners):
        self.leaves, self.enters, self.corners = leaves, enters, corners
        self.plane = plane_through(*corners[:3])
        self.edges = [line_through(a, b) for a, b in zip(corners, corners[1:] + corners[:1])]

    def check(self):
        """Planar and strictly convex, between two different cells."""
        need(self.leaves != self.enters, "a portal is between two different cells")
        normal = self.plane[0]
        need(any(normal), "a portal has an area")
        for v in self.corners:
            need(height(self.plane, v) == 0, "a portal is planar")
        for i, a in enumerate(self.corners):
            j = (i + 1) % len(self.corners)
            b = self.corners[j]
            inward = cross(normal, [a[3] * b[k] - b[3] * a[k] for k in range(3)])
            for k, v in enumerate(self.corners):
                # N · (e × x) = (N × e) · x
                if k not in (i, j):
                    x = [a[3] * v[n] - v[3] * a[n] for n in range(3)]
                    need(dot(inward, x) > 0, "a portal is strictly convex")


class Graph:
    """Cells, vertices, and portals, each also as two directed ones."""

    def __init__(self, lines):
        self.cells = [lines.next() for _ in range(lines.count(b"cells"))]
        self.vertices = [vertex(lines.fields()) for _ in range(lines.count(b"vertices"))]
        self.portals = []  # (from, to, the input's number, indices of vertices)
        self.directed = []
        for _ in range(lines.count(b"portals")):
            self.read_portal(lines.fields())
        self.leaving = [[] for _ in self.cells]
        for p, portal in enumerate(self.directed):
            self.leaving[portal.leaves].append((p, portal.enters))
        self.neighbours = [sum({1 << enters for _, enters in ways}) for ways in self.leaving]
        self.orders, self.sights, self.planes, self.ranges = {}, {}, {}, {}

    def read_portal(self, fields):
        need(len(fields) >= 6, "a portal has two cells, a number and three or more vertices")
        cells = [natural(field, len(self.cells)) for field in fields[:2]]
        corners = [natural(field, len(self.vertices)) for field in fields[3:]]
        self.portals.append((cells[0], cells[1], natural(fields[2]), corners))
        points = [self.vertices[v] for v in corners]
        for portal in (Directed(*cells, points), Directed(*cells[::-1], points[::-1])):
            portal.check()
            self.directed.append(portal)

    def order(self, p, q):
        """The order vector of two directed portals."""
        if (p, q) not in self.orders:
            (n, d), (m, e) = self.directed[p].plane, self.directed[q].plane
            self.orders[p, q] = cross(n, m) + tuple(e * n[i] - d * m[i] for i in range(3))
        return self.orders[p, q]

    def sequence(self, fields, a, b):
        """A sequence of directed portals from cell a to cell b."""
        sequence, crossed = [natural(field, len(self.directed)) for field in fields], [a]
        for p in sequence:
            portal = self.directed[p]
            need(portal.leaves == crossed[-1], "a portal leaves the cell that was entered last")
            need(portal.enters not in crossed, "a sequence crosses no cell twice")
            crossed.append(portal.enters)
        need(crossed[-1] == b, "a sequence ends in the cell that it leads to")
        return sequence

    # Cuts. Heights of a portal's vertices are asked for again and again: (any in front, any behind).

    def sight(self, p, q):
        """Whether directed portal q has vertices in front of the plane of p, and behind it."""
        if (p, q) not in self.sights:
            plane = self.directed[p].plane
            heights = [height(plane, v) for v in self.directed[q].corners]
            self.sights[p, q] = (max(heights) > 0, min(heights) < 0)
        return self.sights[p, q]

    def range(self, corners, q):
        """The same for the plane through three vertices."""
        key = corners + (q >> 1,)
        if key not in self.ranges:
            if corners not in self.planes:
                self.planes[corners] = plane_through(*[self.vertices[v] for v in corners])
            plane = self.planes[corners]
            heights = [height(plane, v) for v in self.directed[q].corners]
            self.ranges[key] = (max(heights) > 0, min(heights) < 0)
        return self.ranges[key]

    def cuts(self, fields, sequence):
        """The portals that cannot be crossed after the sequence."""
        cut, at = set(), 0
        while at < len(fields):
            kind, at = fields[at], at + 1
            positions, length = {b"b": (1, 1), b"p": (2, 5)}.get(kind, (0, 0))
            head, at = [natural(field) for field in fields[at:at + length]], at + length
            need(head and len(head) == length, "a cut is `b I P…` or `p I J U V W P…`")
            need(max(head[:positions]) < len(sequence), "a cut names portals of the sequence")
            if kind == b"p":
                self.check_plane(head, sequence)
            while at < len(fields) and fields[at] not in (b"b", b"p"):
                p = natural(fields[at], len(self.directed))
                if kind == b"b":
                    i = sequence[head[0]]
                    need(not self.sight(i, p)[0] or not self.sight(p, i)[1],
                         "a portal that is cut excludes one of the sequence")
                else:
                    need(not self.range(tuple(head[2:]), p)[0],
                         "a portal that is cut has no vertex in front of the plane")
                cut.add(p)
                at += 1
        return cut

    def check_plane(self, head, sequence):
        i, j, corners = head[0], head[1], tuple(head[2:])
        need(all(v < len(self.vertices) for v in corners), "a plane is through three vertices")
        need(i < j, "the portals of a plane are in the order of the sequence")
        before, after = self.range(corners, sequence[i]), self.range(corners, sequence[j])
        need(not before[0], "the first portal has no vertex in front of the plane")
        need(not after[1], "the second portal has no vertex behind the plane")
        need(before[1] or after[0], "not all vertices of the two portals are in the plane")


# Lines that are open or grazing.


def check_open(graph, fields):
    """`open A B X Y Z W X Y Z W P P …`: the pair of cells."""
    need(len(fields) > 11, "an open pair has two cells, two points, and a sequence")
    a, b = [natural(field, len(graph.cells)) for field in fields[1:3]]
    line = line_through(vertex(fields[3:7]), vertex(fields[7:11]))
    sequence = graph.sequence(fields[11:], a, b)
    for p in sequence:
        for edge in graph.directed[p].edges:
            need(side(line, edge) > 0, "the line passes every portal on the inner side of its edges")
    for p, q in zip(sequence, sequence[1:]):
        need(side(line, graph.order(p, q)) > 0, "the line crosses each portal before the next")
    return a, b


def check_grazing(graph, fields):
    """`grazing A B R X X X X X X Y Y Y Y Y Y P P …`: the pair of cells."""
    need(len(fields) > 16, "a grazing pair has two cells, a root, twelve parts, and a sequence")
    a, b = [natural(field, len(graph.cells)) for field in fields[1:3]]
    root, x, y = integer(fields[3]), integers(fields[4:10]), integers(fields[10:16])
    need(root >= 0, "there is no root of a negative number")
    need(dot(x, x[3:]) + root * dot(y, y[3:]) == 0 and side(x, y) == 0, "the vector is a line")
    need(any(surd_sign(x[i], y[i], root) for i in range(3)), "the line has a direction")
    for p in graph.sequence(fields[16:], a, b):
        check_touch(graph.directed[p], x, y, root)
    return a, b


def check_touch(portal, x, y, root):
    normal = portal.plane[0]
    along = surd_sign(dot(x, normal), dot(y, normal), root)
    need(along >= 0, "the line goes through the portal's plane from behind, or in it")
    sides = [surd_sign(side(x, edge), side(y, edge), root) for edge in portal.edges]
    if along > 0:
        need(min(sides) >= 0, "the line touches the portal: it is on no edge's outer side")
        return
    need(not any(sides), "a line that does not cross the portal's plane is in it")
    turned = [(cross(normal, z), dot(normal, z[3:])) for z in (x, y)]
    signs = [surd_sign(*[dot(t, v) + m * v[3] for t, m in turned], root) for v in portal.corners]
    need(min(signs) <= 0 <= max(signs), "the portal is not on one side of a line in its plane")


# Refutations.


class Refutation:
    """Reads a refutation of a sequence and checks it."""

    def __init__(self, graph, sequence, fields):
        self.graph, self.sequence = graph, sequence
        self.rest, self.splits = iter(fields), []
        self.is_linear = self.check()
        need(next(self.rest, None) is None, "nothing follows a refutation")

    def take(self):
        field = next(self.rest, None)
        need(field is not None, "the refutation ends too early")
        return field

    def check(self):
        kind = self.take()
        if kind == b"l":
            self.linear()
        elif kind == b"i":
            self.identity()
        elif kind == b"s":
            self.split()
        else:
            raise Wrong("a refutation is `l`, `i` or `s`")
        return kind == b"l"

    def factor(self):
        """A factor's vector, and whether it is of the sequence and no split."""
        field = self.take()
        if field[:1] == b"h":
            return self.splits[natural(field[1:], len(self.splits))], False
        if field[:1] == b"o":
            i = natural(field[1:], len(self.sequence))
            need(i > 0, "an order vector is of a portal and the one before")
            return self.graph.order(self.sequence[i - 1], self.sequence[i]), True
        i, dotted, j = field.partition(b".")
        need(dotted, "a factor is `I.J`, `oI` or `hK`")
        edges = self.graph.directed[self.sequence[natural(i, len(self.sequence))]].edges
        return edges[natural(j, len(edges))], True

    def weight(self):
        weight = integer(self.take())
        need(weight > 0, "a weight is positive")
        return weight

    def linear(self):
        total, is_strict = [0] * 6, False
        for _ in range(natural(self.take())):
            vector, strict = self.factor()
            weight = self.weight()
            total = [t + weight * v for t, v in zip(total, vector)]
            is_strict |= strict
        need(is_strict, "one of the factors is no split")
        need(not any(total), "the vectors of the sum cancel")

    def identity(self):
        multiple = integer(self.take())
        need(multiple != 0, "the multiple of the Klein form is not zero")
        total, is_strict = [[0] * 6 for _ in range(6)], False
        for _ in range(natural(self.take())):
            (f, first), (g, second), weight = self.factor(), self.factor(), self.weight()
            f, g = f[3:] + f[:3], g[3:] + g[:3]
            for a in range(6):
                for b in range(6):
                    total[min(a, b)][max(a, b)] += weight * f[a] * g[b]
            is_strict |= first and second
        need(is_strict, "one of the products is of two factors that are no split")
        for a in range(6):
            for b in range(a, 6):
                need(total[a][b] == (multiple if b == a + 3 else 0),
                     "the products are a multiple of the Klein form")

    def split(self):
        need(len(self.splits) < 64, "at most 64 splits enclose one another")
        vector = tuple(integers([self.take() for _ in range(6)]))
        for half in (vector, tuple(-x for x in vector)):
            self.splits.append(half)
            self.check()
            self.splits.pop()


# Trees.


class Node:
    """A node of a tree while its children are read."""

    def __init__(self, line, sequence, cells, seen, targets, cut):
        self.line, self.sequence, self.cells = line, sequence, cells
        self.seen, self.targets, self.cut = seen, targets, cut
        self.children = set()

    def flood(self, graph):
        """No way from the node's last cell leads to a target, but through its children."""
        passed, open_cells = self.seen, [self.cells[-1]]
        barred = self.cut | self.children
        while open_cells:
            cell = open_cells.pop()
            if not graph.neighbours[cell] & (passed | self.targets):
                continue
            for p, enters in graph.leaving[cell]:
                bit = 1 << enters
                if bit & (passed | self.targets) and p not in barred:
                    need(not bit & self.targets, "a way to cell %d is left (node of line %d)"
                         % (enters, self.line))
                    passed &= ~bit
                    open_cells.append(enters)


class Trees:
    """The trees of all cells."""

    def __init__(self, graph, claims):
        self.graph, self.claims = graph, claims
        # Per cell the cells that are claimed open or undecided with it, as bits.
        self.maybe = [sum(1 << j for j, c in enumerate(row) if c in b"23") for row in claims]
        self.told, self.stack = set(), []
        self.nodes = self.linear = self.quadric = 0

    def source(self, line, fields):
        self.close(0)
        need(len(fields) == 2, "`source A` was expected")
        a = natural(fields[1], len(self.graph.cells))
        need(a not in self.told, "a cell has one tree")
        told = sum(1 << cell for cell in self.told)
        self.told.add(a)
        everything = (1 << len(self.graph.cells)) - 1
        targets = everything & ~self.maybe[a] & ~told
        self.stack = [Node(line, (), (a,), self.maybe[a] & ~(1 << a), targets, frozenset())]

    def close(self, depth):
        """Ends the nodes deeper than `depth - 1`: all their children are known."""
        while len(self.stack) > depth:
            node = self.stack.pop()
            if node is not None:
                node.flood(self.graph)

    def node(self, line, fields):
        need(len(fields) >= 2, "a node has a depth and a portal")
        depth, p = natural(fields[0]), natural(fields[1], len(self.graph.directed))
        need(1 <= depth <= len(self.stack), "a node has a parent")
        self.close(depth)
        parent, portal = self.stack[-1], self.graph.directed[p]
        need(parent is not None, "nothing follows a sequence that is refuted")
        need(portal.leaves == parent.cells[-1], "a portal leaves the cell where the sequence ends")
        need(p not in parent.children, "no portal has two nodes with the same parent")
        parent.children.add(p)
        cell, bit = portal.enters, 1 << portal.enters
        need(bit & (parent.seen | parent.targets), "a child enters a seen cell or a target")
        sequence, rest = parent.sequence + (p,), fields[2:]
        self.nodes += 1
        if rest and rest[0] in (b"l", b"i", b"s"):
            is_linear = Refutation(self.graph, sequence, rest).is_linear
            self.linear += is_linear
            self.quadric += not is_linear
            self.stack.append(None)
            return
        need(not bit & parent.targets, "a node that enters a target has a refutation")
        maybe = self.maybe[cell]
        cut = self.graph.cuts(rest, sequence)
        self.stack.append(Node(line, sequence, parent.cells + (cell,),
                               parent.seen & maybe & ~bit, parent.targets & maybe,
                               parent.cut | cut if cut else parent.cut))

    def end(self):
        self.close(0)
        need(len(self.told) == len(self.graph.cells), "every cell has a tree")


# The proof as a whole.


def read_claims(lines, count):
    need(lines.next() == b"claims", "`claims` was expected")
    rows = []
    for _ in range(count):
        row = lines.next()
        need(len(row) == count and not row.strip(b"0123"), "a row has a digit 0 to 3 for each cell")
        rows.append(row)
    for i in range(count):
        need(rows[i][i] == ord("2"), "a cell is open to itself")
        need(all(rows[i][j] == rows[j][i] for j in range(i)), "the claims are symmetric")
    return rows


def verify(lines):
    """The graph and a summary of a proof that holds."""
    need(lines.next() == FORMAT, "no proof: the first line is not %s" % FORMAT.decode())
    need(lines.fields()[0] == b"program", "`program NAME VERSION` was expected")
    need(lines.fields()[0] == b"input", "`input BLAKE3 FILE-NAME` was expected")
    graph = Graph(lines)
    claims = read_claims(lines, len(graph.cells))
    line, shown = lines.fields(), set()
    while line[0] in (b"open", b"grazing"):
        check_line, claim = (check_open, b"2") if line[0] == b"open" else (check_grazing, b"1")
        a, b = check_line(graph, line)
        need(claims[a][b] == claim[0], "the pair is claimed so")
        need((min(a, b), max(a, b)) not in shown, "a pair has one line")
        shown.add((min(a, b), max(a, b)))
        line = lines.fields()
    count = [0, 0, 0, 0]
    for i, row in enumerate(claims):
        for j in range(i):
            count[row[j] - ord("0")] += 1
            need(row[j] not in b"12" or (j, i) in shown,
                 "every pair that is open or grazing has a line, but %d and %d" % (j, i))
    trees = Trees(graph, claims)
    need(line[0] in (b"source", b"sha256"), "`source A` was expected")
    while line[0] != b"sha256":
        if line[0] == b"source":
            trees.source(lines.number, line)
        else:
            trees.node(lines.number, line)
        line = lines.fields()
    trees.end()
    need(len(line) == 2 and line[1] == lines.hash.hexdigest().encode(), "the seal is of this text")
    need(not lines.stream.read(1), "nothing follows the seal")
    return graph, (
        "all holds; pairs of different cells: %d open, %d grazing, %d not open, %d undecided\n"
        "%d nodes; refuted: %d by a linear combination, %d by a quadric"
        % (count[2], count[1], count[0], count[3], trees.nodes, trees.linear, trees.quadric))


# The input that a proof is said to be of.


class CannotMatch(Exception):
    """Why an input cannot be matched, which says nothing against the proof."""


def number(value):
    """A coordinate: a decimal or a ratio, exactly."""
    text = str(value)
    if not (DECIMAL.match(text) or RATIO.match(text)):
        raise Unreadable("a coordinate was expected, got %r" % text)
    try:
        return Fraction(text)
    except ZeroDivisionError:
        raise Unreadable("a coordinate was expected, got %r" % text) from None


def read_prt(text):
    """Names of cells and portals (from, to, polygon) of a portal file."""
    rows = [line for line in (line.split() for line in text.splitlines()) if line]
    words = iter(rows)
    magic = next(words)[0]
    if magic not in ("PRT1", "PRT2"):
        raise CannotMatch("only PRT1 and PRT2 can be")
    counts = [int(next(words)[0]) for _ in range(3 if magic == "PRT2" else 2)]
    cells, portals = counts[-2], []
    for _ in range(counts[-1]):
        row = " ".join(next(words)).replace("(", " ").replace(")", " ").split()
        size = int(row[0])
        if len(row) == 4 + 3 * size or len(rows[3]) == 1 and magic == "PRT1":
            raise CannotMatch("the dialect of Quake 3 cannot be")
        if len(row) != 3 + 3 * size:
            raise Unreadable("a portal has another number of vertices than it says")
        vertices = [tuple(map(number, row[i:i + 3])) for i in range(3, len(row), 3)]
        portals.append((str(int(row[1])), str(int(row[2])), vertices))
    return [str(cell) for cell in range(cells)], portals


def read_json(text):
    scene = json.loads(text, parse_float=str)
    portals = scene.get("portals") if isinstance(scene, dict) else None
    if portals is None:
        raise CannotMatch("only a portal file or a JSON portal graph can be")
    return scene["cells"], [(portal["from"], portal["to"], polygon(portal)) for portal in portals]


def polygon(portal):
    """A portal's vertices; a segment, its left end first, is one with a height of 1."""
    if "polygon" in portal:
        return [tuple(map(number, vertex)) for vertex in portal["polygon"]]
    left, right = [tuple(map(number, end)) for end in portal["segment"]]
    return [right + (0,), left + (0,), left + (1,), right + (1,)]


def read_graph(content):
    """Names of cells, and portals, of an input."""
    try:
        text = content.decode("utf-8")
        return read_prt(text) if text.lstrip()[:3] == "PRT" else read_json(text)
    except UnicodeDecodeError:
        raise CannotMatch("only a portal file or a JSON portal graph can be") from None
    except json.JSONDecodeError:
        raise CannotMatch("only PRT1, PRT2 and JSON can be") from None
    except (ValueError, KeyError, TypeError, IndexError, StopIteration) as error:
        raise Unreadable("broken: %s %s" % (type(error).__name__, error)) from None


def vector(a, b):
    return tuple(y - x for x, y in zip(a, b))


def area(outline):
    """Twice the vector area."""
    parts = [cross(vector(outline[0], a), vector(outline[0], b))
             for a, b in zip(outline[1:], outline[2:])]
    return tuple(map(sum, zip(*parts))) if parts else (0, 0, 0)


def cleaned(outline):
    """The polygon without repeated vertices and those between their neighbours on one line."""
    kept = list(outline)
    at = 0
    while len(kept) > 2 and at < len(kept):
        before, here, after = kept[at - 1], kept[at], kept[(at + 1) % len(kept)]
        if here == before or here == after or not any(
                cross(vector(before, here), vector(here, after))):
            kept.pop(at)
            at = max(at - 1, 0)
        else:
            at += 1
    return kept


def rotated(outline):
    at = outline.index(min(outline))
    return outline[at:] + outline[:at]


def unescaped(name):
    """A cell's name, whose characters may be escaped."""
    special = {"n": "\n", "r": "\r", "t": "\t", "0": "\0"}
    return re.sub(r"\\(?:u\{([0-9a-f]{1,6})\}|(.))",
                  lambda m: chr(int(m[1], 16)) if m[1] else special.get(m[2], m[2]), name)


def match(graph, cells, portals):
    """Whether the proof's graph is that of the input; what differs, as a sentence, if not."""
    need([unescaped(name.decode("utf-8")) for name in graph.cells] == cells, "the cells differ")
    pieces = {}
    for a, b, numbered, corners in graph.portals:
        points = [tuple(Fraction(v[i], v[3]) for i in range(3))
                  for v in (graph.vertices[c] for c in corners)]
        pieces.setdefault(numbered, []).append((cells[a], cells[b], points))
    need(set(pieces) == set(range(len(portals))), "the portals' numbers differ")
    for numbered, (a, b, outline) in enumerate(portals):
        mine = pieces[numbered]
        where = "portal %d of the input differs: its " % numbered
        need(all(piece[:2] == (a, b) for piece in mine), where + "cells")
        if len(mine) == 1 and rotated(mine[0][2]) == rotated(cleaned(outline)):
            continue
        # A portal that is not planar and convex is cut into triangles, which keep its vector area.
        need(all(len(points) == 3 for _, _, points in mine), where + "vertices")
        need(all(v in outline for _, _, points in mine for v in points), where + "vertices")
        total = tuple(map(sum, zip(*[area(points) for _, _, points in mine])))
        need(total == area(outline), where + "area")


# The command.


def proof_file(path):
    if os.path.isdir(path):
        plain = os.path.join(path, "proof.txt")
        return plain if os.path.exists(plain) else plain + ".gz"
    return path


def check(path):
    """(exit code, message, graph) of a proof."""
    try:
        with open(path, "rb") as file:
            is_packed = file.peek(2)[:2] == b"\x1f\x8b"
            lines = Lines(gzip.GzipFile(fileobj=file) if is_packed else file)
            try:
                graph, summary = verify(lines)
                return 0, summary, graph
            except Wrong as wrong:
                code = 3 if lines.number == 1 else 5
                return code, "%s: line %d: %s" % (path, lines.number, wrong), None
    except OSError as error:
        return 3, "%s: %s" % (path, error.strerror), None


def check_input(graph, proof, path, content):
    """(exit code, message) of the comparison with an input."""
    try:
        match(graph, *read_graph(content))
        return 0, "the proof's graph is that of %s" % path
    except CannotMatch as why:
        return 0, ("%s: not matched: %s; the proof holds for the portal graph that it states"
                   % (path, why))
    except Unreadable as error:
        return 3, "%s: %s" % (path, error)
    except Wrong as wrong:
        return 5, "%s: the proof is of another graph than %s: %s" % (proof, path, wrong)


def failed(code, message):
    print("error: " + message, file=sys.stderr)
    return code


def check_each(paths):
    codes = []
    for path in paths:
        code, message, _ = check(path)
        codes.append(code)
        print(code, message.splitlines()[0])
    return max(codes, default=0)


def main(arguments):
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    if arguments[:1] == ["--each"]:
        return check_each(arguments[1:])
    if len(arguments) not in (1, 2) or arguments[0].startswith("-"):
        print(__doc__, file=sys.stderr)
        return 2
    content = None
    if len(arguments) == 2:
        try:
            with open(arguments[1], "rb") as file:
                content = file.read()
        except OSError as error:
            return failed(3, "%s: %s" % (arguments[1], error.strerror))
    path = proof_file(arguments[0])
    code, message, graph = check(path)
    if code:
        return failed(code, message)
    if content is not None:
        code, matched = check_input(graph, path, arguments[1], content)
        if code:
            return failed(code, matched)
        if ": not matched: " in matched:
            print(matched, file=sys.stderr)
        else:
            message += "\n" + matched
    print(message)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
