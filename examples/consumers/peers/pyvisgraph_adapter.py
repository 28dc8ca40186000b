"""pyvisgraph (PyPI) under test: whether a point sees another past the walls, polygons of two corners."""

import pyvisgraph as vg
from pyvisgraph.graph import Graph
from pyvisgraph.visible_vertices import visible_vertices
from view_points import serve_segments


def clear(walls):
    graph = Graph([[vg.Point(*end) for end in wall] for wall in walls])

    def free(p, q):
        there = vg.Point(*q)
        return there in visible_vertices(vg.Point(*p), graph, destination=there)

    return free


serve_segments(clear)
