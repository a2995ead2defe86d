"""Voronoi cells and natural neighbours: what is known of lattices, sums, linear functions."""

import math
import random
import unittest

import tetloft
from geometry import area_vector, dot, large, minus, places, polygon
from support import numpy, rows

try:
    from scipy import spatial
except ImportError:
    spatial = None

CORNERS = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]


class CellsOfPoints(unittest.TestCase):
    def setUp(self):
        numbers = random.Random(31)
        self.points = places(numbers, 120)
        self.made = tetloft.DelaunayTriangulation3(self.points)

    def test_fill_their_box(self):
        for box, volume in (([(0, 0, 0), (1, 1, 1)], 1), ([(-1, 0.5, 0.25), (3, 1, 2)], 3.5)):
            cells = self.made.cells(box)
            self.assertEqual(len(cells), 120)
            self.assertTrue(all(rows(cells.bounded)))
            self.assertAlmostEqual(sum(rows(cells.volumes)), volume, places=12)

    def test_have_the_volume_that_their_faces_enclose(self):
        for cell in self.made.cells([(0, 0, 0), (1, 1, 1)]):
            six_times = 0
            for face in cell.faces:
                corners = polygon(cell, face)
                outwards = area_vector(corners)
                self.assertAlmostEqual(face.area, math.sqrt(dot(outwards, outwards)) / 2)
                if corners:
                    at = minus(corners[0], self.points[cell.site])
                    self.assertGreaterEqual(dot(at, outwards), -1e-12)
                    six_times += dot(at, outwards)
            self.assertAlmostEqual(six_times / 6, cell.volume, places=12)

    def test_are_between_neighbours(self):
        cells = self.made.cells()
        self.assertEqual(rows(cells.sites), list(range(120)))
        areas = {}
        for cell in cells:
            neighbours = [face.neighbour for face in cell.faces]
            self.assertEqual(neighbours, rows(self.made.neighbours(cell.site)))
            self.assertEqual({face.side for face in cell.faces}, {"none"})
            self.assertEqual(cell.bounded, all(face.bounded for face in cell.faces))
            self.assertEqual(math.isinf(cell.volume), not cell.bounded)
            for face in cell.faces:
                areas[cell.site, face.neighbour] = face.area
                for corner in polygon(cell, face):
                    self.assertAlmostEqual(
                        math.dist(corner, self.points[cell.site]),
                        math.dist(corner, self.points[face.neighbour]),
                        delta=1e-7 * (1 + math.dist(corner, self.points[cell.site])))
        for (site, neighbour), area in areas.items():
            mirror = areas[neighbour, site]
            self.assertTrue(area == mirror or abs(area - mirror) < 1e-6 * area + 1e-12)

    def test_are_cubes_in_a_lattice(self):
        lattice = [(x, y, z) for x in range(4) for y in range(4) for z in range(4)]
        made = tetloft.DelaunayTriangulation3(lattice)
        inner = made.cell(lattice.index((1, 2, 1)))
        self.assertAlmostEqual(inner.volume, 1, places=12)
        self.assertEqual([round(face.area, 9) for face in large(inner)], [1] * 6)
        self.assertEqual(sorted(lattice[face.neighbour] for face in large(inner)),
                         sorted([(0, 2, 1), (2, 2, 1), (1, 1, 1), (1, 3, 1), (1, 2, 0), (1, 2, 2)]))
        corner = made.cell(0, [(-1, -1, -1), (9, 9, 9)])
        self.assertAlmostEqual(corner.volume, 1.5 ** 3, places=12)
        self.assertEqual([face.side for face in large(corner) if face.neighbour is None],
                         ["low_x", "low_y", "low_z"])
        self.assertEqual(tetloft.BOX_SIDES[rows(made.cells([(0, 0, 0), (3, 3, 3)]).sides)[-1]],
                         "high_z")

    def test_have_their_volumes_told_faster(self):
        self.made.remove(7)
        told, cells = rows(self.made.volumes()), self.made.cells()
        self.assertEqual((len(told), told[7]), (120, 0))
        for site, volume in zip(rows(cells.sites), rows(cells.volumes)):
            self.assertTrue(told[site] == volume or abs(told[site] - volume) < 1e-9 * volume)
        self.assertEqual(len(tetloft.DelaunayTriangulation3().volumes()), 0)

    def test_are_one_after_the_other(self):
        cells = self.made.cells([(0, 0, 0), (1, 1, 1)])
        self.assertEqual([len(cells.corner_begin), len(cells.face_begin)], [121, 121])
        self.assertEqual(int(cells.corner_begin[120]), len(cells.corners))
        self.assertEqual(int(cells.face_begin[120]), len(cells.areas))
        self.assertEqual(int(cells.face_corner_begin[len(cells.areas)]), len(cells.face_corners))
        for array in (cells.neighbours, cells.sides, cells.faces_bounded):
            self.assertEqual(len(array), len(cells.areas))
        self.assertEqual([len(cells.shifts), len(cells.normals)], [0, 0])
        last, same = cells[-1], cells[119]
        self.assertEqual(rows(last.corners), rows(same.corners))
        self.assertEqual(last.volume, self.made.cell(119, [(0, 0, 0), (1, 1, 1)]).volume)
        with self.assertRaises(IndexError):
            cells[120]
        face, begin = int(cells.face_begin[5]), int(cells.face_corner_begin[cells.face_begin[5]])
        everywhere = rows(cells.corners)
        self.assertEqual(polygon(cells[5], cells[5].faces[0]),
                         [everywhere[int(corner)] for corner in
                          cells.face_corners[begin:int(cells.face_corner_begin[face + 1])]])

    @unittest.skipIf(numpy is None, "without NumPy")
    def test_are_views_of_one_memory(self):
        cells = self.made.cells()
        corners, part = cells.corners, cells[3].corners
        self.assertTrue(numpy.shares_memory(corners, part))
        self.assertFalse(corners.flags.writeable)
        self.assertEqual([str(cells.face_begin.dtype), str(cells.face_corners.dtype)],
                         ["int64", "uint32"])
        cells.close()
        self.assertEqual(len(part), len(corners[:len(part)]))
        self.assertEqual(repr(cells), "<tetloft.VoronoiCells, closed>")

    def test_are_refused_where_they_make_no_sense(self):
        for box in ([(0, 0, 0)], [(0, 0), (1, 1)], [0, 0, 0, 1, 1, 1]):
            with self.assertRaises(ValueError):
                self.made.cells(box)
        with self.assertRaises(tetloft.InvalidInput):
            self.made.cells([(0, 0, 0), (1, -1, 1)])
        with self.assertRaises(tetloft.InvalidInput):
            self.made.cell(120)
        stop = tetloft.Stop()
        stop.request()
        with self.assertRaises(tetloft.Cancelled):
            self.made.cells(stop=stop)
        with self.assertRaises(tetloft.Cancelled):
            self.made.volumes(stop=stop)

    @unittest.skipIf(spatial is None, "without SciPy")
    def test_are_those_of_scipy(self):
        diagram = spatial.Voronoi(self.points)
        for cell in self.made.cells():
            region = diagram.regions[diagram.point_region[cell.site]]
            self.assertEqual(cell.bounded, -1 not in region)
            if cell.bounded:
                hull = spatial.ConvexHull(diagram.vertices[region])
                self.assertAlmostEqual(cell.volume / hull.volume, 1, places=9)


class Spheres(unittest.TestCase):
    def test_go_through_the_points(self):
        points = places(random.Random(32), 40)
        made = tetloft.DelaunayTriangulation3(points)
        spheres = rows(made.circumspheres)
        self.assertEqual(len(spheres), len(made.tets))
        for tet, (x, y, z, radius) in zip(rows(made.tets), spheres):
            for vertex in tet:
                self.assertAlmostEqual(math.dist((x, y, z), points[vertex]) / radius, 1, places=9)
            self.assertEqual(tetloft.circumsphere(*(points[v] for v in tet)), ((x, y, z), radius))

    def test_of_points_in_a_plane_are_infinite(self):
        self.assertEqual(tetloft.circumsphere((0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0))[1],
                         math.inf)
        with self.assertRaises(ValueError):
            tetloft.circumsphere((0, 0), (1, 0), (0, 1), (1, 1))


class NaturalNeighbours(unittest.TestCase):
    def setUp(self):
        numbers = random.Random(33)
        self.points = CORNERS + places(numbers, 60)
        self.made = tetloft.DelaunayTriangulation3(self.points)
        self.queries = places(numbers, 50, -0.1, 1.1) + self.points[:10] + [(0.5, 0, 1)]
        self.inside = [all(0 <= x <= 1 for x in q) for q in self.queries]

    def test_reproduce_linear_functions(self):
        def linear(p):
            return 2 * p[0] - 3 * p[1] + 0.5 * p[2] + 7

        for weights in ("sibson", "laplace"):
            found = rows(self.made.interpolate(list(map(linear, self.points)), self.queries,
                                               weights))
            pairs = rows(self.made.interpolate([(linear(p), -p[2]) for p in self.points],
                                               self.queries, weights))
            self.assertEqual(len(found), len(self.queries))
            self.assertTrue(any(self.inside) and not all(self.inside))
            for query, inside, value, pair in zip(self.queries, self.inside, found, pairs):
                if not inside:
                    self.assertTrue(math.isnan(value) and all(map(math.isnan, pair)))
                    continue
                self.assertAlmostEqual(value, linear(query), places=9)
                self.assertAlmostEqual(pair[0], value, places=12)
                self.assertAlmostEqual(pair[1], -query[2], places=9)

    def test_have_weights_of_sum_one(self):
        found = self.made.natural_neighbours(self.queries)
        self.assertEqual(len(found), len(self.queries))
        self.assertEqual(int(found.begin[len(found)]), len(found.vertices))
        for number, (vertices, weights) in enumerate(found):
            vertices, weights = rows(vertices), rows(weights)
            self.assertEqual(bool(vertices), self.inside[number])
            self.assertEqual(vertices, sorted(vertices))
            if vertices:
                self.assertAlmostEqual(sum(weights), 1, places=12)
                self.assertGreaterEqual(min(weights), 0)
        at_vertex = found[self.queries.index(self.points[3])]
        self.assertEqual((rows(at_vertex[0]), rows(at_vertex[1])), ([3], [1]))

    def test_are_weighted_by_what_an_insertion_takes(self):
        query, box = (0.4, 0.5, 0.55), [(-9, -9, -9), (9, 9, 9)]
        vertices, weights = map(rows, self.made.natural_neighbours([query])[0])
        before = [self.made.cell(v, box).volume for v in vertices]
        added = self.made.insert(query)
        whole = self.made.cell(added, box).volume
        for vertex, weight, volume in zip(vertices, weights, before):
            self.assertAlmostEqual((volume - self.made.cell(vertex, box).volume) / whole, weight,
                                   places=9)

    def test_do_not_depend_on_threads(self):
        alone = self.made.natural_neighbours(self.queries * 20, threads=1)
        several = self.made.natural_neighbours(self.queries * 20, threads=3)
        self.assertEqual(rows(alone.vertices), rows(several.vertices))
        self.assertEqual(rows(alone.weights), rows(several.weights))

    def test_of_changed_vertices_go_by_index(self):
        self.made.remove(20)
        again = self.made.insert((0.5, 0.5, 0.5))
        self.assertEqual(again, 20 + 2**32)
        values = [float(v) for v in range(68)]
        self.assertEqual(rows(self.made.interpolate(values, [(0.5, 0.5, 0.5)])), [20])
        self.assertEqual(rows(self.made.interpolate(iter(values), [(0.5, 0.5, 0.5)])), [20])

    def test_are_none_without_space(self):
        flat = tetloft.DelaunayTriangulation3([(0, 0, 0), (1, 0, 0), (0, 1, 0)])
        self.assertTrue(math.isnan(rows(flat.interpolate([1, 2, 3], [(0.25, 0.25, 0)]))[0]))
        self.assertEqual(len(self.made.interpolate(range(68), [])), 0)
        self.assertEqual(len(self.made.natural_neighbours([])), 0)

    def test_are_refused_where_they_make_no_sense(self):
        with self.assertRaisesRegex(ValueError, "68, not 67"):
            self.made.interpolate([0.0] * 67, [(0.5, 0.5, 0.5)])
        with self.assertRaisesRegex(ValueError, "sibson, laplace"):
            self.made.natural_neighbours([(0.5, 0.5, 0.5)], "linear")
        with self.assertRaises(ValueError):
            self.made.natural_neighbours([(0.5, 0.5)])
        with self.assertRaises(tetloft.InvalidInput):
            self.made.natural_neighbours([(0.5, 0.5, math.nan)])
        with self.assertRaises(TypeError):
            self.made.interpolate(["a"] * 68, [(0.5, 0.5, 0.5)])
        found = self.made.natural_neighbours([(0.5, 0.5, 0.5)])
        with self.assertRaises(ValueError):
            found.mean([1.0])
        if numpy is not None:
            with self.assertRaises(ValueError):
                found.mean(numpy.zeros((68, 2, 2)))


if __name__ == "__main__":
    unittest.main()
