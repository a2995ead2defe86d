"""Meshes with star and link, triangulations, and points from files."""

import io
import os
import random
import tempfile
import unittest

import tetloft
from support import box, numpy, rows

CUBE = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]


def clouds(count, columns):
    random.seed(7)
    return [tuple(random.random() for _ in range(columns)) for _ in range(count)]


class Meshes(unittest.TestCase):
    def setUp(self):
        self.mesh = tetloft.delaunay(clouds(60, 3))
        self.tets = rows(self.mesh.tets)

    def test_know_their_neighbours(self):
        opposites, neighbours = rows(self.mesh.opposites), rows(self.mesh.neighbours)
        inner = 0
        for tet, of in enumerate(neighbours):
            for face, other in enumerate(of):
                if other == tetloft.NO_ID:
                    self.assertEqual(opposites[tet][face], tetloft.NO_ID)
                    continue
                inner += 1
                self.assertIn(tet, neighbours[other])
                corners = set(self.tets[tet]) - {self.tets[tet][face]}
                self.assertEqual(opposites[tet][face] // 4, other)
                across = self.tets[other][opposites[tet][face] % 4]
                self.assertEqual(set(self.tets[other]) - {across}, corners)
        self.assertGreater(inner, 100)
        self.assertEqual(sum(row.count(tetloft.NO_ID) for row in opposites),
                         len(self.mesh.boundary()))
        for half_face in rows(self.mesh.boundary()):
            self.assertEqual(opposites[half_face // 4][half_face % 4], tetloft.NO_ID)

    def test_have_stars_and_links(self):
        for vertex in range(60):
            star = [t for t, tet in enumerate(self.tets) if vertex in tet]
            self.assertEqual(rows(self.mesh.star(vertex)), star)
            self.assertEqual([sorted(t) for t in rows(self.mesh.link(vertex))],
                             [sorted(set(self.tets[t]) - {vertex}) for t in star])
            self.assertIn(self.mesh.link_kind(vertex), ("disc", "sphere"))
        a, b = self.tets[0][:2]
        star = [t for t, tet in enumerate(self.tets) if a in tet and b in tet]
        self.assertEqual(rows(self.mesh.star(a, b)), star)
        self.assertEqual([sorted(e) for e in rows(self.mesh.link(a, b))],
                         [sorted(set(self.tets[t]) - {a, b}) for t in star])
        self.assertIn(self.mesh.link_kind(a, b), ("disc", "sphere"))
        self.assertEqual(len(self.mesh.singular_vertices()), 0)

    def test_tell_singular_vertices(self):
        pair = tetloft.Mesh(8, [(0, 1, 2, 3), (0, 4, 5, 6)])
        self.assertEqual(rows(pair.singular_vertices()), [0])
        self.assertEqual([pair.link_kind(v) for v in (0, 1, 7)], ["components", "disc", "empty"])
        self.assertEqual(rows(pair.star(7)), [])
        self.assertEqual(len(pair.link(7)), 0)
        self.assertEqual((len(pair), pair.vertex_count), (2, 8))

    def test_refuse_other_vertices(self):
        for ask in (lambda: self.mesh.star(60), lambda: self.mesh.link(0, 60),
                    lambda: self.mesh.link_kind(2**32)):
            with self.assertRaises(IndexError):
                ask()
        self.assertEqual(rows(self.mesh.star(-1)), rows(self.mesh.star(59)))

    def test_of_models_are_the_models(self):
        solid = tetloft.reconstruct(box())
        mesh = solid.mesh()
        self.assertEqual(rows(mesh.tets), rows(solid.tets))
        self.assertEqual(mesh.vertex_count, 8)
        self.assertEqual(len(mesh.boundary()), len(solid.boundary()))
        self.assertRegex(repr(mesh), r"<tetloft.Mesh of \d+ tets, 8 vertices>")
        mesh.close()
        self.assertEqual(repr(mesh), "<tetloft.Mesh, closed>")


class Delaunay(unittest.TestCase):
    def test_in_space_tells_dimension_and_duplicates(self):
        mesh = tetloft.delaunay(CUBE + CUBE[2:3])
        self.assertEqual(mesh.dimension, 3)
        self.assertEqual(rows(mesh.representative), [0, 1, 2, 3, 4, 5, 6, 7, 2])
        flat = tetloft.delaunay([(x, y, 0) for x, y, z in CUBE])
        self.assertEqual((flat.dimension, len(flat)), (2, 0))
        self.assertEqual(tetloft.delaunay([]).dimension, -1)
        self.assertEqual(rows(tetloft.delaunay([]).representative), [])

    def test_in_space_does_not_depend_on_the_engine(self):
        made = {engine: sorted(map(sorted, rows(tetloft.delaunay(
            clouds(40, 2) and [p + (float(k % 2),) for k, p in enumerate(clouds(40, 2))],
            engine=engine).tets))) for engine in ("automatic", "incremental", "slab")}
        self.assertEqual(made["automatic"], made["incremental"])
        self.assertEqual(made["automatic"], made["slab"])

    def test_in_space_stops_at_its_limit(self):
        with self.assertRaises(tetloft.WorkLimit):
            tetloft.delaunay(clouds(60, 3), most_tets=10)

    def test_in_the_plane_has_empty_circles(self):
        made = tetloft.delaunay(clouds(40, 2))
        points = rows(made.points)
        self.assertEqual(sorted(points), sorted(list(p) for p in clouds(40, 2)))
        for a, b, c in rows(made.triangles):
            for d in range(40):
                if d in (a, b, c):
                    continue
                m = [[points[v][0] - points[d][0], points[v][1] - points[d][1]] for v in (a, b, c)]
                m = [row + [row[0] ** 2 + row[1] ** 2] for row in m]
                inside = (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                          m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                          m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))
                self.assertLess(inside, 1e-12)  # rounding of this sum, not of the library's
        triangles = rows(made.triangles)
        for t, of in enumerate(rows(made.neighbours)):
            for k, other in enumerate(of):
                if other != tetloft.NO_ID:
                    self.assertTrue(set(triangles[t]) - {triangles[t][k]} <= set(triangles[other]))
        self.assertEqual(len(made.internal), 0)
        self.assertRegex(repr(made), r"<tetloft.Triangulation of \d+ triangles, 40 points>")
        made.close()
        self.assertEqual(repr(made), "<tetloft.Triangulation, closed>")

    def test_in_the_plane_has_segments_as_chains(self):
        points = [(0, 0), (10, 0), (4, 1), (6, -1), (5, 3), (5, -3)]
        made = tetloft.delaunay(points, segments=[(0, 1)])
        chain = rows(made.chain(0))
        self.assertEqual((chain[0], chain[-1]), (0, 1))
        self.assertGreater(len(chain), 2)
        where = rows(made.points)
        self.assertTrue(all(where[v][1] == 0 for v in chain))
        edges = {frozenset(edge) for a, b, c in rows(made.triangles)
                 for edge in ((a, b), (b, c), (c, a))}
        self.assertTrue(all(frozenset(e) in edges for e in zip(chain, chain[1:])))
        for bad in ([(0, 6)], [(0, 0)]):
            with self.assertRaises(ValueError):
                tetloft.delaunay(points, segments=bad)
        with self.assertRaises(ValueError):
            tetloft.delaunay(CUBE, segments=[(0, 1)])
        with self.assertRaises(tetloft.Error):
            made.chain(1)

    def test_refuses_unfit_points(self):
        for bad in ([(0,)], [(0, 0, 0, 0)], [(0, 0, 0), (1, 1)]):
            with self.assertRaises(ValueError):
                tetloft.delaunay(bad)
        with self.assertRaises(tetloft.InvalidInput):
            tetloft.delaunay([(0, 0, float("nan"))])
        if numpy is not None:
            with self.assertRaises(ValueError):
                tetloft.delaunay(numpy.zeros(6))


class Points(unittest.TestCase):
    def test_are_written_and_read(self):
        points = clouds(5, 3)
        with tempfile.TemporaryDirectory() as folder:
            for name in ("p.xyz", "p.bin"):
                path = os.path.join(folder, name)
                tetloft.write_points(path, points)
                self.assertEqual(rows(tetloft.read_points(path)), [list(p) for p in points])
                with open(path, "rb") as opened:
                    data = opened.read()
                    opened.seek(0)
                    self.assertEqual(rows(tetloft.read_points(opened)), [list(p) for p in points])
                self.assertEqual(tetloft.format_points(points, name[2:]), data)
                self.assertEqual(rows(tetloft.parse_points(data, name)), [list(p) for p in points])
        self.assertEqual(rows(tetloft.read_points(io.BytesIO(b"1 2 3\n"))), [[1, 2, 3]])
        with self.assertRaises(tetloft.InvalidInput) as caught:
            tetloft.parse_points(b"0 0 0\n1 2\n", "p.xyz")
        self.assertEqual(caught.exception.place[:2], ("p.xyz", 2))

    def test_keep_their_memory(self):
        first = tetloft.parse_points(b"1 2 3\n4 5 6\n")[1]
        self.assertEqual(list(first), [4, 5, 6])

    def test_formats_are_told(self):
        by_name = {format.name: format for format in tetloft.formats()}
        self.assertEqual(by_name["vtu"].extension, ".vtu")
        self.assertIn("model", by_name["vtu"].reads & by_name["vtu"].writes)
        self.assertEqual({name for name, format in by_name.items() if "stack" in format.writes},
                         {name for name in by_name if self.writes_a_stack(name)})

    def writes_a_stack(self, name):
        try:
            return bool(box().to_bytes(name))
        except tetloft.UsageError:
            return False


if __name__ == "__main__":
    unittest.main()
