"""Voronoi cells and natural neighbours in the plane: lattices, sums, mirrors, linear functions."""

import math
import random
import unittest

import tetloft
from geometry import large_edges
from support import rows

CORNERS = [(0, 0), (1, 0), (0, 1), (1, 1)]


def places(numbers, count, low=0.0, high=1.0):
    return [(numbers.uniform(low, high), numbers.uniform(low, high)) for _ in range(count)]


def shoelace(corners):
    return sum(p[0] * q[1] - p[1] * q[0]
               for p, q in zip(corners, corners[1:] + corners[:1])) / 2


class CellsOfPlanePoints(unittest.TestCase):
    def setUp(self):
        self.points = places(random.Random(51), 80)
        self.made = tetloft.DelaunayTriangulation2(self.points)

    def test_fill_their_rectangle(self):
        for rectangle, area in (([(0, 0), (1, 1)], 1), ([(-1, 0.5), (2, 1)], 1.5)):
            cells = self.made.cells(rectangle)
            self.assertAlmostEqual(sum(rows(cells.areas)), area, places=12)
            for cell in cells:
                corners = rows(cell.corners)
                self.assertAlmostEqual(shoelace(corners) if corners else 0, cell.area, places=12)
                self.assertAlmostEqual(
                    sum(edge.length for edge in cell.edges if edge.inside),
                    sum(math.dist(p, q) for p, q in zip(corners, corners[1:] + corners[:1])),
                    places=12)

    def test_are_between_neighbours(self):
        lengths = {}
        cells = self.made.cells()
        for cell in cells:
            self.assertEqual([edge.neighbour for edge in cell.edges],
                             rows(self.made.neighbours(cell.site)))
            self.assertEqual(math.isinf(cell.area), not cell.bounded)
            corners = rows(cell.corners)
            for edge in cell.edges:
                lengths[cell.site, edge.neighbour] = edge.length
                self.assertEqual(None in edge.ends, math.isinf(edge.length))
                for end in edge.ends:
                    if end is not None:
                        to_site = math.dist(corners[end], self.points[cell.site])
                        self.assertAlmostEqual(
                            math.dist(corners[end], self.points[edge.neighbour]), to_site,
                            delta=1e-7 * (1 + to_site))
        for (site, neighbour), length in lengths.items():
            mirror = lengths[neighbour, site]
            self.assertTrue(length == mirror or abs(length - mirror) < 1e-6 * length + 1e-12)
        areas = rows(self.made.areas())
        for site, area in zip(rows(cells.sites), rows(cells.areas)):
            self.assertTrue(areas[site] == area or abs(areas[site] - area) < 1e-9 * area)

    def test_are_squares_in_a_lattice(self):
        lattice = [(x, y) for x in range(4) for y in range(4)]
        made = tetloft.DelaunayTriangulation2(lattice)
        inner = made.cell(5)
        self.assertAlmostEqual(inner.area, 1)
        self.assertEqual([(lattice[edge.neighbour], round(edge.length, 9))
                          for edge in large_edges(inner)],
                         [((0, 1), 1), ((1, 0), 1), ((1, 2), 1), ((2, 1), 1)])
        corner = made.cell(0, [(-1, -2), (9, 9)])
        self.assertAlmostEqual(corner.area, 1.5 * 2.5)
        self.assertFalse(corner.bounded)
        self.assertEqual([edge.side for edge in corner.edges if edge.neighbour is None],
                         ["low_x", "low_y"])

    def test_are_one_after_the_other(self):
        cells = self.made.cells([(0, 0), (1, 1)])
        self.assertEqual(len(cells), 80)
        self.assertEqual(int(cells.corner_begin[80]), len(cells.corners))
        self.assertEqual(int(cells.edge_begin[80]), len(cells.lengths))
        for array in (cells.neighbours, cells.sides, cells.inside, cells.ends):
            self.assertEqual(len(array), len(cells.lengths))
        last = self.made.cell(79, [(0, 0), (1, 1)])
        self.assertEqual(rows(cells[-1].corners), rows(last.corners))
        with self.assertRaises(IndexError):
            cells[80]
        cells.close()
        self.assertEqual(repr(cells), "<tetloft.PlaneCells, closed>")

    def test_are_refused_where_they_make_no_sense(self):
        for rectangle in ([(0, 0)], [(0, 0, 0), (1, 1, 1)]):
            with self.assertRaises(ValueError):
                self.made.cells(rectangle)
        with self.assertRaises(tetloft.InvalidInput):
            self.made.cell(80)
        with self.assertRaises(tetloft.InvalidInput):
            self.made.cells([(0, 0), (-1, 1)])
        edge = [int(v) for v in self.made.triangles[0]][:2]
        constraint = self.made.insert_constraint(*edge)
        for ask in (self.made.cells, self.made.areas,
                    lambda: self.made.natural_neighbours([(0.5, 0.5)])):
            with self.assertRaises(tetloft.InvalidInput):
                ask()
        self.made.remove_constraint(constraint)
        self.assertEqual(len(self.made.cells()), 80)


class NaturalNeighboursOfThePlane(unittest.TestCase):
    def test_reproduce_linear_functions(self):
        numbers = random.Random(52)
        points = CORNERS + places(numbers, 60)
        made = tetloft.DelaunayTriangulation2(points)
        queries = places(numbers, 60, -0.1, 1.1) + points[:8] + [(0.5, 0)]
        inside = [all(0 <= x <= 1 for x in q) for q in queries]
        self.assertTrue(any(inside) and not all(inside))
        for weights in ("sibson", "laplace"):
            found = rows(made.interpolate([2 * x - 3 * y + 7 for x, y in points], queries, weights))
            for (x, y), there, value in zip(queries, inside, found):
                if there:
                    self.assertAlmostEqual(value, 2 * x - 3 * y + 7, places=9)
                else:
                    self.assertTrue(math.isnan(value))
        vertices, weights = map(rows, made.natural_neighbours([points[5]])[0])
        self.assertEqual((vertices, weights), ([5], [1]))

    def test_are_weighted_by_what_an_insertion_takes(self):
        made = tetloft.DelaunayTriangulation2(CORNERS + places(random.Random(53), 40))
        query, rectangle = (0.45, 0.55), [(-9, -9), (9, 9)]
        vertices, weights = map(rows, made.natural_neighbours([query])[0])
        before = [made.cell(v, rectangle).area for v in vertices]
        whole = made.cell(made.insert(query), rectangle).area
        for vertex, weight, area in zip(vertices, weights, before):
            self.assertAlmostEqual((area - made.cell(vertex, rectangle).area) / whole, weight,
                                   places=9)

    def test_are_refused_where_they_make_no_sense(self):
        made = tetloft.DelaunayTriangulation2(CORNERS)
        with self.assertRaises(ValueError):
            made.natural_neighbours([(0.5, 0.5, 0.5)])
        with self.assertRaisesRegex(ValueError, "4, not 3"):
            made.interpolate([1, 2, 3], [(0.5, 0.5)])


if __name__ == "__main__":
    unittest.main()
