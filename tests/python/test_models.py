"""Models: reconstructed, read, made of arrays; their parts, files and pictures."""

import copy
import os
import pathlib
import pickle
import tempfile
import unittest

import tetloft
from support import INNER, SQUARE, box, data, rows, tube

CORNER = ([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2, 3)])


def volume(model):
    """By definition, of rows."""
    points, total = rows(model.points), 0.0
    for a, b, c, d in rows(model.tets):
        u, v, w = ([points[p][k] - points[a][k] for k in range(3)] for p in (b, c, d))
        total += (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
                  u[2] * (v[0] * w[1] - v[1] * w[0]))
    return total / 6


class Models(unittest.TestCase):
    def test_are_the_solid_of_a_stack(self):
        solid = tetloft.reconstruct(tube())
        self.assertEqual(solid.volume, 60)
        self.assertAlmostEqual(volume(solid), 60)
        self.assertEqual(solid.component_count, 1)
        self.assertEqual(set(rows(solid.components)), {0})
        self.assertEqual(set(rows(solid.slabs)), {0})
        self.assertLess(max(rows(solid.kinds)), len(tetloft.TET_KINDS))
        self.assertEqual(len(solid), len(solid.tets))
        report = solid.report
        self.assertEqual((report.slices, report.contours, report.tets, report.volume),
                         (2, 4, len(solid), 60))

    def test_know_where_points_come_from(self):
        solid = tetloft.reconstruct(box(), ends="half")
        self.assertAlmostEqual(solid.volume, 160)
        where = [(tetloft.POINT_ORIGINS[origin], section, contour, point[2])
                 for origin, section, contour, point in zip(
                     rows(solid.point_origins), rows(solid.point_sections),
                     rows(solid.point_contours), rows(solid.points))]
        self.assertEqual([w[1:] for w in where if w[0] == "input"],
                         [(0, 0, 0)] * 4 + [(1, 0, 5)] * 4)
        caps = [w for w in where if w[0] == "cap"]
        self.assertEqual({w[1:] for w in caps},
                         {(tetloft.NO_ID, tetloft.NO_ID, z) for z in (-2.5, 7.5)})

    def test_follow_options(self):
        small = [(x / 2 + 1, y / 2 + 1) for x, y in SQUARE]
        stack = tetloft.Stack([(0, [SQUARE]), (4, [small])])
        self.assertEqual(tetloft.reconstruct(stack, between=3).report.sections_between, 3)
        self.assertEqual(tetloft.reconstruct(stack, between=0).report.sections_between, 0)
        single = tetloft.Stack([(0, [SQUARE])])
        self.assertAlmostEqual(tetloft.reconstruct(single, thickness=0.5).volume, 8)
        with self.assertWarns(tetloft.TetloftWarning):
            solid = tetloft.reconstruct(single)
        self.assertAlmostEqual(solid.volume, 6.4)
        self.assertEqual(len(solid.warnings), 1)
        tets = [rows(tetloft.reconstruct(stack, engine=engine, threads=threads).tets)
                for engine, threads in (("automatic", 1), ("slab", 2), ("incremental", 3))]
        self.assertEqual(tets[0], tets[1])
        self.assertEqual(tets[0], tets[2])

    def test_have_a_boundary(self):
        solid = tetloft.reconstruct(tube())
        surface = solid.boundary()
        solid.close()
        self.assertEqual(surface.component_count, 1)
        topology = surface.topology()
        self.assertEqual(topology.genus, 1)
        self.assertEqual(topology.triangles, len(surface))
        self.assertEqual(topology.vertices - topology.edges + topology.triangles, 0)
        self.assertEqual(len(rows(surface.tets)), len(surface))
        self.assertEqual(set(rows(surface.components)), {0})
        points = rows(surface.points)  # the divergence of x is the volume
        total = 0.0
        for a, b, c in rows(surface.triangles):
            u = [points[b][k] - points[a][k] for k in range(3)]
            v = [points[c][k] - points[a][k] for k in range(3)]
            total += sum(points[p][0] for p in (a, b, c)) * (u[1] * v[2] - u[2] * v[1]) / 6
        self.assertAlmostEqual(total, 60)
        self.assertRegex(repr(surface), r"<tetloft.Surface of \d+ triangles, 1 components>")
        with self.assertRaises(IndexError):
            surface.topology(1)
        surface.close()
        self.assertEqual(repr(surface), "<tetloft.Surface, closed>")

    def test_are_made_of_arrays(self):
        model = tetloft.Model(*CORNER)
        self.assertEqual((rows(model.points), rows(model.tets)),
                         ([list(p) for p in CORNER[0]], [[0, 1, 2, 3]]))
        self.assertAlmostEqual(model.volume, 1 / 6)
        self.assertIsNone(model.report)
        self.assertEqual(len(model.slabs), 0)
        self.assertEqual(len(model.boundary()), 4)
        with self.assertRaises(ValueError):
            tetloft.Model([(0, 0)], [])
        pile = tetloft.Model(CORNER[0], [(0, 1, 2, 3)] * 3)  # one face of three tets
        with self.assertRaises(tetloft.Error):
            pile.mesh()

    def test_are_written_and_read_bit_for_bit(self):
        solid = tetloft.reconstruct(tube(), ends="half")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "tube.vtu")
            for ascii in (False, True):
                solid.write(path, ascii=ascii)
                self.assertEqual(b'format="ascii"' in path.read_bytes(), ascii)
                with open(path, "rb") as opened:
                    for again in (tetloft.read_model(path), tetloft.read_model(opened)):
                        self.same(again, solid)
            for extension in ("stl", "obj", "ply", "vtp"):
                surface = path.with_suffix("." + extension)
                solid.write_surface(surface)
                self.assertEqual(surface.read_bytes(), solid.surface_to_bytes(extension))
        self.assertNotEqual(solid.surface_to_bytes("stl", ascii=True), solid.surface_to_bytes())
        self.same(tetloft.parse_model(solid.to_bytes(), "tube.vtu"), solid)

    def test_know_what_they_are_of(self):
        square = "\\".join("%g\\%g\\{z:g}" % corner for corner in SQUARE)
        lines = "".join("1||4|%d||%s\n" % (z, square.format(z=z)) for z in (0, 1))
        stack = tetloft.parse_stack(
            ("ROI_NAMES\n1|255\\0\\0|left lung\nEND_OF_ROI_NAMES\n" + lines).encode(), "a.cxt")
        self.assertEqual(stack.description, ("left lung", "mm", "LPS"))
        solid = tetloft.reconstruct(stack)
        self.assertEqual(solid.description, stack.description)
        self.assertEqual(solid.component_names, ["left lung"])
        nothing = tetloft.reconstruct(tube())
        self.assertEqual(nothing.description, ("", "", ""))
        self.assertEqual(nothing.component_names, ["component 1"])

    def test_have_components_that_are_models(self):
        two = tetloft.Stack([(z, [SQUARE, [(x + 50, y) for x, y in SQUARE]]) for z in (0, 1)])
        solid = tetloft.reconstruct(two)
        parts = [solid.component(k) for k in range(2)]
        self.assertEqual(sum(len(part) for part in parts), len(solid))
        self.assertAlmostEqual(sum(part.volume for part in parts), solid.volume)
        self.assertEqual([part.component_names for part in parts],
                         [["component 1"], ["component 2"]])
        with self.assertRaises(IndexError):
            solid.component(2)

    def test_warn_of_what_a_format_loses(self):
        thin = tetloft.Model([(x + 1e9, y, z) for x, y, z in CORNER[0]], CORNER[1])
        with self.assertWarnsRegex(tetloft.TetloftWarning, "float32") as told:
            thin.surface_to_bytes("stl")
        self.assertEqual(told.filename, __file__)
        with tempfile.TemporaryDirectory() as folder, self.assertWarns(tetloft.TetloftWarning):
            thin.write_surface(os.path.join(folder, "thin.stl"))

    def test_are_copied_and_pickled(self):
        solid = tetloft.reconstruct(tube())
        self.same(pickle.loads(pickle.dumps(solid)), solid)
        other = copy.deepcopy(solid)
        solid.close()
        self.assertEqual((other.volume, other.report.slices), (60, 2))
        with self.assertRaises(TypeError):
            pickle.dumps(other.boundary())

    def same(self, one, two):
        for name in ("points", "tets", "components", "slabs", "kinds", "point_sections",
                     "point_contours", "point_origins"):
            self.assertEqual(rows(getattr(one, name)), rows(getattr(two, name)), name)
        self.assertEqual(one.component_count, two.component_count)

    def test_are_drawn(self):
        solid = tetloft.reconstruct(tube())
        with tempfile.TemporaryDirectory() as folder:
            def drawn(name, *arguments, **options):
                path = os.path.join(folder, name)
                solid.render(path, *arguments, **options)
                with open(path, "rb") as picture:
                    return picture.read()

            small = {"width": 60, "height": 40}
            png = drawn("a.png", tube(), **small)
            self.assertEqual(png[:8] + png[16:24], b"\x89PNG\r\n\x1a\n\0\0\0\x3c\0\0\0\x28")
            self.assertIn(b"<svg", drawn("a.svg"))
            self.assertIn("Röhre <1>".replace("<", "&lt;").split("&")[0].encode(),
                          drawn("a.html", title="Röhre <1>"))
            for option in ({"colour": "kind"}, {"azimuth": 10.0}, {"elevation": 80.0},
                           {"cut": ("z", 2.0)}, {"explode": 1, "stretch": 2}, {"edges": True},
                           {"white": True}):
                self.assertNotEqual(drawn("b.png", tube(), **small, **option), png, option)
            for bad in ({"colour": "loud"}, {"cut": ("w", 1)}, {"width": 0}, {"width": 2**31}):
                with self.assertRaises(ValueError):
                    drawn("c.png", **bad)

    def test_of_samples_have_a_genus(self):
        solid = tetloft.reconstruct(tetloft.read_stack(data("torus.cnt")))
        self.assertEqual(solid.boundary().topology(0).genus, 1)

    def test_show_what_they_are(self):
        solid = tetloft.reconstruct(box())
        self.assertRegex(repr(solid), r"<tetloft.Model of \d+ tets, 8 points, 1 components>")
        self.assertEqual(repr(tetloft.Model(*CORNER)), "<tetloft.Model of 1 tets, 4 points>")
        solid.close()
        self.assertEqual(repr(solid), "<tetloft.Model, closed>")


class Between(unittest.TestCase):
    def test_gives_a_longer_stack_of_the_same_components(self):
        apart = [(x + 3, y) for x, y in SQUARE]
        stack = tetloft.Stack([(0, [SQUARE]), (4, [apart])])
        longer, rule, decisions = tetloft.between(stack, sections=3)
        self.assertEqual(longer.z, [0, 1, 2, 3, 4])
        self.assertEqual(rows(longer.contour(0, 0)), rows(stack.contour(0, 0)))
        solid = tetloft.reconstruct(longer, correspondence=rule, between=0)
        self.assertEqual(solid.component_count, tetloft.links(stack).components)
        self.assertTrue(tetloft.check(solid, longer, correspondence=rule))
        self.assertIn(b"join", decisions.to_bytes())
        self.assertIs(rule.labels, decisions)

    def test_keeps_the_rule_of_voids(self):
        stack = tetloft.Stack([(0, [SQUARE, INNER]), (4, [SQUARE])])
        free = tetloft.Correspondence(voids="free")
        self.assertEqual(tetloft.between(stack, correspondence=free).correspondence.voids, "free")
        self.assertEqual(tetloft.between(stack).correspondence.voids, "overlap")


if __name__ == "__main__":
    unittest.main()
