"""Periodic sets: crystals that are known, sums, mirrors, and brute force."""

import itertools
import math
import random
import unittest

import tetloft
from geometry import determinant, dot, large, minus, places, polygon, times
from support import numpy, rows

BCC = [(0, 0, 0), (0.5, 0.5, 0.5)]
FCC = [(0, 0, 0), (0, 0.5, 0.5), (0.5, 0, 0.5), (0.5, 0.5, 0)]


class PeriodicSets(unittest.TestCase):
    def check(self, points, box, cells):
        """What holds of all cells of periodic sets: `box` as vectors."""
        self.assertEqual(rows(cells.sites), list(range(len(points))))
        self.assertAlmostEqual(sum(rows(cells.volumes)) / abs(determinant(box)), 1, places=12)
        faces = {(cell.site, face.neighbour, face.shift): face
                 for cell in cells for face in cell.faces}
        for (site, neighbour, shift), face in faces.items():
            mirror = faces[neighbour, site, tuple(-times for times in shift)]
            self.assertEqual(mirror.area, face.area)
            self.assertEqual(mirror.normal, tuple(-x for x in face.normal))
            to = minus([p + s for p, s in zip(points[neighbour], times(shift, box))], points[site])
            self.assertAlmostEqual(dot(to, face.normal) / math.sqrt(dot(to, to)), 1, places=9)
        for cell in cells:
            self.assertTrue(cell.bounded)
            thirds = 0
            for face in cell.faces:
                for corner in polygon(cell, face):
                    self.assertAlmostEqual(math.dist(corner, (0, 0, 0)), math.dist(
                        corner, minus([p + s for p, s in zip(points[face.neighbour],
                                                             times(face.shift, box))],
                                      points[cell.site])), places=9)
                corners = polygon(cell, face)
                thirds += face.area * dot(corners[0], face.normal) if corners else 0
            self.assertAlmostEqual(thirds / 3 / cell.volume, 1, places=9)

    def test_are_the_known_ones_of_crystals(self):
        known = (  # faces by area: of a cube, a truncated octahedron, a rhombic dodecahedron
            ([(0, 0, 0)], 1, [1] * 6),
            (BCC, 1 / 2, [1 / 8] * 6 + [3 * math.sqrt(3) / 16] * 8),
            (FCC, 1 / 4, [math.sqrt(2) / 8] * 12),
        )
        for points, volume, areas in known:
            cells = tetloft.periodic_voronoi(points, (1, 1, 1))
            self.check(points, ((1, 0, 0), (0, 1, 0), (0, 0, 1)), cells)
            for cell in cells:
                self.assertAlmostEqual(cell.volume, volume, places=12)
                found = sorted(face.area for face in large(cell))
                self.assertEqual(len(found), len(areas))
                for area, expected in zip(found, sorted(areas)):
                    self.assertAlmostEqual(area, expected, places=12)

    def test_fill_skewed_boxes(self):
        numbers = random.Random(34)
        for box in (((1, 0, 0), (0, 1, 0), (0, 0, 1)), ((2, 0, 0), (1.9, 1, 0), (-5, 3, 1.5)),
                    ((0, 1, 3), (2, 0.5, 0), (1, 1, 1))):
            for count in (1, 2, 3, 50):
                points = places(numbers, count, -3, 3)
                self.check(points, box, tetloft.periodic_voronoi(points, box))

    def test_of_one_point_are_those_of_its_lattice(self):
        cell = tetloft.periodic_voronoi([(7, 8, 9)], (1, 2, 4))[0]
        self.assertAlmostEqual(cell.volume, 8)
        self.assertEqual({(face.neighbour, face.shift): round(face.area, 9)
                          for face in large(cell)},
                         {(0, tuple(sign * (k == axis) for k in range(3))): 8 // (1, 2, 4)[axis]
                          for axis in range(3) for sign in (1, -1)})

    def test_do_not_depend_on_the_vectors_chosen(self):
        points = places(random.Random(35), 20)
        plain = tetloft.periodic_voronoi(points, (1, 1, 1))
        skewed = tetloft.periodic_voronoi(points, [(1, 0, 0), (5, 1, 0), (-3, 2, 1)])
        for one, other in zip(plain, skewed):
            self.assertAlmostEqual(one.volume, other.volume, places=12)
            self.assertEqual([face.neighbour for face in one.faces],
                             [face.neighbour for face in other.faces])

    def test_have_empty_spheres(self):
        numbers = random.Random(36)
        box = ((1, 0, 0), (0.5, 1, 0), (0.25, -0.5, 1))
        points = places(numbers, 12)
        tets = tetloft.periodic_delaunay(points, box)
        images = [tuple(p + s for p, s in zip(point, times(shift, box))) for point in points
                  for shift in itertools.product(range(-3, 4), repeat=3)]
        volume = 0
        for of, shifts in zip(rows(tets.points), tets.shifts):
            shifts = rows(shifts)
            self.assertEqual(shifts[0], [0, 0, 0])
            corners = [tuple(p + s for p, s in zip(points[i], times(shift, box)))
                       for i, shift in zip(of, shifts)]
            six_times = determinant([minus(corners[k], corners[0]) for k in (1, 2, 3)])
            self.assertGreater(six_times, 0)
            volume += six_times / 6
            centre, radius = tetloft.circumsphere(*corners)
            self.assertFalse([image for image in images
                              if math.dist(image, centre) < radius * (1 - 1e-9)])
        self.assertAlmostEqual(volume, determinant(box))

    def test_box_may_be_given_in_several_ways(self):
        ways = [(1, 2, 3), [1.0, 2.0, 3.0], [(1, 0, 0), (0, 2, 0), (0, 0, 3)]]
        if numpy is not None:
            ways += [numpy.array([1, 2, 3]), numpy.diag([1.0, 2.0, 3.0])]
        for box in ways:
            self.assertAlmostEqual(tetloft.periodic_voronoi([(0, 0, 0)], box)[0].volume, 6)
            self.assertEqual(len(tetloft.periodic_delaunay([(0, 0, 0)], box)), 6)
        for wrong in ((1, 2), (1, 2, 3, 4), [(1, 0, 0), (0, 1, 0)], [(1, 0), (0, 1)], [1, 2, (3,)]):
            with self.assertRaises(ValueError):
                tetloft.periodic_voronoi([(0, 0, 0)], wrong)
        with self.assertRaises(TypeError):
            tetloft.periodic_voronoi([(0, 0, 0)], 1.0)

    def test_are_refused_where_they_make_no_sense(self):
        for make in (tetloft.periodic_voronoi, tetloft.periodic_delaunay):
            with self.assertRaises(tetloft.InvalidInput):
                make([(0, 0, 0), (1, 0, 0)], (1, 1, 1))
            with self.assertRaises(tetloft.InvalidInput):
                make([(0, 0, 0)], (1, 1, 0))
            self.assertEqual(len(make([], (1, 1, 1))), 0)
            stop = tetloft.Stop()
            stop.request()
            with self.assertRaises(tetloft.Cancelled):
                make([(0, 0, 0)], (1, 1, 1), stop=stop)


if __name__ == "__main__":
    unittest.main()
