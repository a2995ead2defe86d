"""Histories of triangulations that change, and what they are compared by, in space and in the
plane."""

import tetloft
from support import rows


def squared(a, b):
    return sum((s - t) ** 2 for s, t in zip(a, b))


def corners(made):
    """The vertices of each tet, in the plane of each triangle."""
    return rows(made.tets if hasattr(made, "tets") else made.triangles)


def simplices(made):
    """Tets, or triangles, as sets of points."""
    at = {vertex: tuple(point) for vertex, point in zip(rows(made.vertices), rows(made.points))}
    return {frozenset(at[v] for v in simplex) for simplex in corners(made)}


def go_through_changes(test, made, numbers, place):
    """Removes, inserts and moves, of vertices at random; every other move is to a place that is
    taken, and refused."""
    for step in range(60):
        vertex = numbers.choice(rows(made.vertices))
        if step % 3 == 0:
            made.remove(vertex)
            test.assertNotIn(vertex, made)
        elif step % 3 == 1:
            vertex = made.insert(place(numbers), near=vertex)
            test.assertIn(vertex, made)
        elif step % 6 == 2:
            to = place(numbers)
            if list(to) not in rows(made.points):
                made.move(vertex, to)
                test.assertEqual(made.point(vertex), to)
        else:
            before = made.point(vertex)
            with test.assertRaises(tetloft.InvalidInput):
                made.move(vertex, made.point(next(v for v in made if v != vertex)))
            test.assertEqual(made.point(vertex), before)


def expect_as_at_once(test, made):
    """It is that of its points, made of all at once, and that of the batch."""
    test.assertEqual(simplices(made), simplices(type(made)(made.points)))
    points = rows(made.points)
    test.assertEqual({frozenset(tuple(points[v]) for v in simplex)
                      for simplex in corners(tetloft.delaunay(made.points))}, simplices(made))
