"""Delaunay triangulations of the plane that change, with constraints: the answers of brute force,
whatever was done before."""

import copy
import pickle
import random
import threading
import unittest

import tetloft
from changing import expect_as_at_once, go_through_changes, simplices, squared
from support import numpy, rows

GRID = [(x, y) for x in range(5) for y in range(5)]
SQUARE = [(0, 0), (8, 0), (8, 8), (0, 8)]
SQUARE_HOLE = [(2, 2), (6, 2), (6, 6), (2, 6)]


def ring(first, count):
    """Segments around."""
    return [(first + k, first + (k + 1) % count) for k in range(count)]


def place(numbers):
    return tuple(numbers.randrange(17) / 4 for _ in range(2))


def doubled_area(points, triangle):
    (ax, ay), (bx, by), (cx, cy) = (points[v] for v in triangle)
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)


def with_hole():
    """A square with a square hole."""
    made = tetloft.DelaunayTriangulation2(SQUARE + SQUARE_HOLE)
    return made, rows(made.insert_constraints(ring(0, 4) + ring(4, 4)))


class Changes(unittest.TestCase):
    def test_end_where_all_points_at_once_do(self):
        numbers = random.Random(23)
        made = tetloft.DelaunayTriangulation2(GRID)
        self.assertEqual((len(made), made.slots, made.dimension, len(made.triangles)),
                         (25, 25, 2, 32))
        go_through_changes(self, made, numbers, place)
        expect_as_at_once(self, made)
        made.clear()
        self.assertEqual((len(made), made.dimension, len(made.triangles)), (0, -1, 0))

    def test_number_vertices_by_their_points(self):
        made = tetloft.DelaunayTriangulation2(GRID + GRID[:2])
        self.assertEqual(rows(made.vertices), list(range(25)))
        self.assertEqual(rows(made.points), [list(p) for p in GRID])
        # The places of points that were there are free.
        self.assertEqual(rows(made.insert_all([(0, 1), (9, 9)], threads=1)), [1, 25])
        made.remove(2)
        again = made.insert((0, 2))
        self.assertEqual((again % 2**32, again // 2**32), (2, 1))
        self.assertEqual(made.point(again), (0, 2))
        with self.assertRaises(tetloft.InvalidInput):
            made.point(2)

    def test_of_one_leave_its_copies(self):
        made, numbers = with_hole()
        made.remove_constraint(numbers[0])
        for other in (copy.copy(made), copy.deepcopy(made), pickle.loads(pickle.dumps(made)),
                      tetloft.DelaunayTriangulation2.from_bytes(made.to_bytes())):
            self.assertEqual(rows(other.vertices), rows(made.vertices))
            self.assertEqual(rows(other.constraints), numbers[1:])
            self.assertEqual(simplices(other), simplices(made))
            other.remove_constraint(numbers[1])
            self.assertTrue(made.has_constraint(numbers[1]))
        with self.assertRaises(tetloft.InvalidInput):
            tetloft.DelaunayTriangulation2.from_bytes(made.to_bytes()[:-1])
        with self.assertRaises(tetloft.InvalidInput):
            tetloft.DelaunayTriangulation3.from_bytes(made.to_bytes())

    def test_are_refused_where_they_make_no_sense(self):
        made = tetloft.DelaunayTriangulation2()
        self.assertTrue(made)
        with self.assertRaises(tetloft.InvalidInput):
            made.insert((0, float("inf")))
        for wrong in ((0, 0, 0), (0,)):
            with self.assertRaises(ValueError):
                made.insert(wrong)
            with self.assertRaises(ValueError):
                made.insert_all([wrong])
        made.close()
        with self.assertRaises(ValueError):
            len(made)
        self.assertEqual(repr(made), "<tetloft.DelaunayTriangulation2, closed>")

    def test_wait_for_those_who_ask(self):
        made, _ = with_hole()
        found = []
        askers = [threading.Thread(target=lambda: found.extend(
            len(made.inside()) > 0 for _ in range(50))) for _ in range(3)]
        for asker in askers:
            asker.start()
        for k in range(50):
            made.remove(made.insert((3 + k / 64, 1)))
        for asker in askers:
            asker.join()
        self.assertEqual(found, [True] * 150)


class Constraints(unittest.TestCase):
    def test_have_an_inside(self):
        made, numbers = with_hole()
        self.assertEqual((len(made), len(made.triangles), len(made.inside())), (8, 10, 8))
        points = rows(made.points)
        self.assertEqual(sum(doubled_area(points, t) for t in rows(made.inside())), 2 * (64 - 16))
        self.assertEqual(sum(doubled_area(points, t) for t in rows(made.triangles)), 2 * 64)
        made.remove_constraint(numbers[0])
        with self.assertRaises(tetloft.InvalidInput) as refused:
            made.inside()
        self.assertEqual(refused.exception.place.vertex, 0)
        made.insert_constraint(0, 1)
        self.assertEqual(len(made.inside()), 8)

    def test_are_found_by_number_and_by_edge(self):
        made, numbers = with_hole()
        self.assertEqual((numbers, rows(made.constraints)), (list(range(8)), list(range(8))))
        middle = made.insert((4, 0))
        self.assertEqual(made.constraint_ends(0), (0, 1))
        self.assertEqual(rows(made.constraint_edges(0)), [[0, middle], [1, middle]])
        self.assertEqual(rows(made.edge_constraints(middle, 1)), [0])
        self.assertEqual(rows(made.edge_constraints(0, 1)), [])
        longer = made.insert_constraint(1, 0)
        self.assertEqual(rows(made.edge_constraints(0, middle)), [0, longer])
        with self.assertRaisesRegex(tetloft.InvalidInput, "constraint 0 goes over"):
            made.remove(middle)
        made.remove_constraint(0)
        made.remove_constraint(longer)
        made.remove(middle)
        self.assertFalse(made.has_constraint(0))
        for ask in (made.constraint_ends, made.constraint_edges, made.remove_constraint):
            with self.assertRaisesRegex(tetloft.InvalidInput, "there is no constraint 0"):
                ask(0)
            with self.assertRaises(ValueError):
                ask(2**32)

    def test_that_cross_are_refused_or_split(self):
        made, _ = with_hole()
        before = simplices(made)
        with self.assertRaisesRegex(tetloft.InvalidInput, "crosses constraint 7") as refused:
            made.insert_constraint(0, made.insert((4, 5)))
        self.assertEqual(refused.exception.place.point, (2, 2.5, 0))
        made.remove(8)
        with self.assertRaisesRegex(tetloft.InvalidInput, "segment 1: "):
            made.insert_constraints([(4, 6), (5, 7)])
        self.assertEqual((len(made.constraints), simplices(made)), (8, before))
        across = rows(made.insert_constraints([(4, 6), (5, 7)], "split"))
        self.assertEqual(len(made), 9)
        centre = made.nearest_one((4, 4))
        self.assertEqual(made.point(centre), (4, 4))
        self.assertEqual([rows(made.constraint_edges(c)) for c in across],
                         [sorted([[4, centre], [6, centre]]), sorted([[5, centre], [7, centre]])])
        for wrong in ("", "SPLIT", "cross"):
            with self.assertRaisesRegex(ValueError, "one of refuse, split"):
                made.insert_constraint(0, 1, crossing=wrong)

    def test_take_all_numbers_of_vertices_and_no_others(self):
        made, _ = with_hole()
        made.remove_constraint(0)
        made.remove_constraint(3)
        made.remove(0)
        again = made.insert((0, 0))
        self.assertGreaterEqual(again, 2**32)
        pairs = [(again, 1), (3, again)]
        for given in (pairs, *([numpy.array(pairs), numpy.array(pairs, "uint64")]
                               if numpy is not None else [])):
            for constraint in rows(made.insert_constraints(given)):
                made.remove_constraint(constraint)
        self.assertEqual(len(made.insert_constraints([])), 0)
        for wrong in ([(-1, 1)], [(0, 1, 2)], [0, 1]):
            with self.assertRaises(ValueError):
                made.insert_constraints(wrong)
        with self.assertRaises(tetloft.InvalidInput):
            made.insert_constraints([(0, 1)])
        with self.assertRaises(TypeError):
            made.insert_constraints([(0.5, 1.5)])


class Answers(unittest.TestCase):
    def setUp(self):
        numbers = random.Random(24)
        self.queries = [place(numbers) for _ in range(60)] + [(9, 9), (1, 1)]
        plain = tetloft.DelaunayTriangulation2(GRID)
        walled = copy.copy(plain)
        walled.insert_constraints([(0, 23), (10, 14)], "split")
        self.all = (plain, walled)

    def test_are_the_nearest(self):
        for made in self.all:
            points = rows(made.points)
            nearest = rows(made.nearest(self.queries))
            for query, vertex in zip(self.queries, nearest):
                ranked = sorted(range(len(points)), key=lambda v: (squared(points[v], query), v))
                self.assertEqual(vertex, ranked[0])
                self.assertEqual(made.nearest_one(query), ranked[0])
                self.assertEqual(rows(made.nearest_few(query, 5)), ranked[:5])
                self.assertEqual(rows(made.within(query, 1)),
                                 [v for v in ranked if squared(points[v], query) <= 1])
        with self.assertRaises(tetloft.InvalidInput):
            made.within((0, 0), -1)

    def test_are_the_simplices(self):
        made = tetloft.DelaunayTriangulation2([(0, 0), (2, 0), (0, 2)])
        kinds, vertices = made.locate([(1, 0), (0.5, 0.5), (0, 2), (3, 3)])
        self.assertEqual([tetloft.LOCATIONS[kind] for kind in rows(kinds)],
                         ["edge", "facet", "vertex", "outside"])
        none = tetloft.NO_VERTEX
        self.assertEqual([list(row) for row in rows(vertices)],
                         [[0, 1, none], [0, 1, 2], [2, none, none], 3 * [none]])

    def test_are_the_surroundings(self):
        for made in self.all:
            triangles = rows(made.triangles)
            for vertex in made:
                star = [triangle for triangle in triangles if vertex in triangle]
                self.assertEqual(rows(made.star(vertex)), star)
                self.assertEqual(rows(made.neighbours(vertex)),
                                 sorted({v for triangle in star for v in triangle} - {vertex}))
            self.assertEqual(rows(made.hull())[:6], [0, 5, 10, 15, 20, 21])
        row = tetloft.DelaunayTriangulation2([(2, 2), (0, 0), (1, 1)])
        self.assertEqual((rows(row.hull()), row.dimension), ([1, 2, 0], 1))

    def test_are_what_an_insertion_changes(self):
        for made in self.all:
            before = {tuple(row) for row in rows(made.triangles)}
            for query in self.queries:
                changed = copy.copy(made)
                zone = made.conflict_zone(query, near=3)
                vertex = changed.insert(query)
                gone = before - {tuple(row) for row in rows(changed.triangles)}
                if list(query) in rows(made.points):
                    self.assertEqual([len(part) for part in zone], [0, 0, 0])
                    continue
                self.assertEqual({tuple(row) for row in rows(zone.simplices)}, gone)
                self.assertEqual(rows(zone.neighbours), rows(changed.neighbours(vertex)))
                self.assertEqual({frozenset(edge) for edge in rows(zone.horizon)},
                                 {frozenset(row) - {vertex}
                                  for row in rows(changed.star(vertex))})

    def test_end_when_stopped(self):
        stop = tetloft.Stop()
        stop.request()
        for call in (self.all[0].nearest, self.all[1].locate, self.all[0].insert_all):
            with self.assertRaises(tetloft.Cancelled):
                call(self.queries, stop=stop)


if __name__ == "__main__":
    unittest.main()
