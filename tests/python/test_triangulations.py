"""A Delaunay triangulation that changes: the answers of brute force, whatever was done before."""

import copy
import pickle
import random
import threading
import unittest

import tetloft
from changing import expect_as_at_once, go_through_changes, simplices, squared
from support import rows

LATTICE = [(x, y, z) for x in range(3) for y in range(3) for z in range(3)]


def place(random_numbers):
    return tuple(random_numbers.randrange(9) / 4 for _ in range(3))


class Changes(unittest.TestCase):
    def test_end_where_all_points_at_once_do(self):
        numbers = random.Random(21)
        made = tetloft.DelaunayTriangulation3(LATTICE)
        self.assertEqual((len(made), made.slots, made.dimension), (27, 27, 3))
        go_through_changes(self, made, numbers, place)
        expect_as_at_once(self, made)
        made.clear()
        self.assertEqual((len(made), made.dimension, len(made.tets)), (0, -1, 0))

    def test_number_vertices_by_their_points(self):
        made = tetloft.DelaunayTriangulation3(LATTICE + LATTICE[:2])
        self.assertEqual(rows(made.vertices), list(range(27)))
        self.assertEqual(rows(made.points), [list(p) for p in LATTICE])
        self.assertEqual(rows(made.insert_all([(0, 0, 1), (9, 9, 9)], threads=1))[0], 1)
        self.assertEqual(made.insert((0, 0, 2)), 2)
        made.remove(2)
        with self.assertRaises(tetloft.InvalidInput):
            made.point(2)
        with self.assertRaises(tetloft.InvalidInput):
            made.neighbours(2)

    def test_of_one_leave_its_copies(self):
        made = tetloft.DelaunayTriangulation3(LATTICE)
        made.remove(13)
        for other in (copy.copy(made), copy.deepcopy(made), pickle.loads(pickle.dumps(made)),
                      tetloft.DelaunayTriangulation3.from_bytes(made.to_bytes())):
            self.assertEqual(rows(other.vertices), rows(made.vertices))
            self.assertEqual(simplices(other), simplices(made))
            other.remove(0)
            self.assertIn(0, made)
        with self.assertRaises(tetloft.InvalidInput):
            tetloft.DelaunayTriangulation3.from_bytes(made.to_bytes()[:-1])

    def test_are_refused_where_they_make_no_sense(self):
        made = tetloft.DelaunayTriangulation3()
        self.assertTrue(made)
        with self.assertRaises(tetloft.InvalidInput):
            made.insert((0, 0, float("nan")))
        with self.assertRaises(tetloft.InvalidInput):
            made.remove(0)
        for wrong in (-1, 2**64):
            with self.assertRaises(ValueError):
                made.remove(wrong)
        with self.assertRaises(ValueError):
            made.insert((0, 0))
        with self.assertRaises(ValueError):
            made.insert_all([(0, 0)])
        made.close()
        with self.assertRaises(ValueError):
            len(made)
        self.assertEqual(repr(made), "<tetloft.DelaunayTriangulation3, closed>")

    def test_wait_for_those_who_ask(self):
        made = tetloft.DelaunayTriangulation3(LATTICE)
        found = []
        askers = [threading.Thread(target=lambda: found.extend(
            len(made.tets) > 0 for _ in range(50))) for _ in range(3)]
        for asker in askers:
            asker.start()
        for k in range(50):
            made.remove(made.insert((k, 0.5, 0.25)))
        for asker in askers:
            asker.join()
        self.assertEqual(found, [True] * 150)


class Answers(unittest.TestCase):
    def setUp(self):
        self.made = tetloft.DelaunayTriangulation3(LATTICE)
        numbers = random.Random(22)
        self.queries = [place(numbers) for _ in range(60)] + [(5, 5, 5), (1, 1, 1)]

    def test_are_the_nearest(self):
        nearest = rows(self.made.nearest(self.queries))
        for query, vertex in zip(self.queries, nearest):
            ranked = sorted(range(27), key=lambda v: (squared(LATTICE[v], query), v))
            self.assertEqual(vertex, ranked[0])
            self.assertEqual(self.made.nearest_one(query), ranked[0])
            self.assertEqual(rows(self.made.nearest_few(query, 5)), ranked[:5])
            self.assertEqual(rows(self.made.within(query, 1)),
                             [v for v in ranked if squared(LATTICE[v], query) <= 1])
        self.assertEqual(len(self.made.nearest_few((0, 0, 0), 100)), 27)
        self.assertEqual(rows(tetloft.DelaunayTriangulation3().nearest([(0, 0, 0)])),
                         [tetloft.NO_VERTEX])
        with self.assertRaises(tetloft.InvalidInput):
            self.made.within((0, 0, 0), -1)

    def test_are_the_simplices(self):
        flat = tetloft.DelaunayTriangulation3([(0, 0, 0), (2, 0, 0), (0, 2, 0)])
        kinds, vertices = flat.locate([(1, 0, 0), (0.5, 0.5, 0), (0, 2, 0), (0, 0, 1)])
        self.assertEqual([tetloft.LOCATIONS[kind] for kind in rows(kinds)],
                         ["edge", "facet", "vertex", "outside"])
        none = tetloft.NO_VERTEX
        self.assertEqual([list(row) for row in rows(vertices)],
                         [[0, 1, none, none], [0, 1, 2, none], [2] + 3 * [none], 4 * [none]])
        kinds, vertices = self.made.locate(self.queries)
        self.assertEqual(tetloft.LOCATIONS[rows(kinds)[-1]], "vertex")
        self.assertEqual(rows(vertices)[-1][0], 13)
        self.assertEqual(tetloft.LOCATIONS[rows(kinds)[-2]], "outside")

    def test_are_the_surroundings(self):
        tets = rows(self.made.tets)
        for vertex in self.made:
            star = [tet for tet in tets if vertex in tet]
            self.assertEqual(rows(self.made.star(vertex)), star)
            self.assertEqual(rows(self.made.neighbours(vertex)),
                             sorted({v for tet in star for v in tet} - {vertex}))

    def test_are_what_an_insertion_changes(self):
        before = {tuple(row) for row in rows(self.made.tets)}
        for query in self.queries:
            changed = copy.copy(self.made)
            zone = self.made.conflict_zone(query, near=3)
            vertex = changed.insert(query)
            gone = before - {tuple(row) for row in rows(changed.tets)}
            if query in LATTICE:
                self.assertEqual([len(part) for part in zone], [0, 0, 0])
                continue
            self.assertEqual({tuple(row) for row in rows(zone.simplices)}, gone)
            self.assertEqual(rows(zone.neighbours), rows(changed.neighbours(vertex)))
            self.assertEqual({frozenset(face) for face in rows(zone.horizon)},
                             {frozenset(row) - {vertex} for row in rows(changed.star(vertex))})
        many = tetloft.DelaunayTriangulation3(
            [(x % 10, x // 10, (x % 10 - 4.5) ** 2 + (x // 10 - 4.5) ** 2) for x in range(100)])
        far = many.conflict_zone((4.5, 4.5, -100))  # sees all from below
        self.assertEqual(rows(far.neighbours), list(range(100)))  # no room for them at first
        with self.assertRaises(tetloft.InvalidInput):
            self.made.conflict_zone((0, 0, float("nan")))

    def test_end_when_stopped(self):
        stop = tetloft.Stop()
        stop.request()
        with self.assertRaises(tetloft.Cancelled):
            self.made.nearest(self.queries, stop=stop)


if __name__ == "__main__":
    unittest.main()
