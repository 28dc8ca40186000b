"""No library: lines of sight against walls in Fractions. The control: what fails here, the points miss."""

from view_points import cross, minus, number, serve_segments


def clear(walls):
    def free(p, q):
        return not any(meets(p, q, *wall) for wall in walls)

    return free


def meets(p, q, a, b):
    """Whether two closed segments meet, or are on one line."""
    ways = [(minus(q, p), minus(a, p)), (minus(q, p), minus(b, p))]
    ways += [(minus(b, a), minus(p, a)), (minus(b, a), minus(q, a))]
    first, second, third, fourth = (cross(*way) for way in ways)
    return first * second <= 0 and third * fourth <= 0


serve_segments(clear, number)
