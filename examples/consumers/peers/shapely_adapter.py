"""shapely (PyPI; GEOS) under test: a line of sight is a segment that does not meet the walls."""

from shapely.geometry import LineString, MultiLineString
from view_points import serve_segments


def clear(walls):
    blocked = MultiLineString(walls)
    return lambda p, q: not LineString([p, q]).intersects(blocked)


serve_segments(clear)
