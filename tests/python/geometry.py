"""Vectors and polygons, for what is known of cells."""

from support import rows


def places(numbers, count, low=0.0, high=1.0):
    return [tuple(numbers.uniform(low, high) for _ in range(3)) for _ in range(count)]


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def determinant(box):
    return dot(cross(box[0], box[1]), box[2])


def times(shift, box):
    return tuple(sum(s * vector[k] for s, vector in zip(shift, box)) for k in range(3))


def polygon(cell, face):
    corners = rows(cell.corners)
    return [corners[int(corner)] for corner in face.corners]


def area_vector(points):
    """Twice the area of a flat polygon, along its normal."""
    parts = [cross(minus(p, points[0]), minus(q, points[0]))
             for p, q in zip(points[1:], points[2:])]
    return tuple(sum(part[k] for part in parts) for k in range(3))


def large(cell, least=1e-9):
    """The faces that have an area."""
    return [face for face in cell.faces if face.area > least]


def large_edges(cell, least=1e-9):
    """The edges, of a cell in the plane, that have a length."""
    return [edge for edge in cell.edges if edge.length > least]
