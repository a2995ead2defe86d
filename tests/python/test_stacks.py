"""Stacks: made from arrays and files, asked, mended, written."""

import copy
import io
import json
import math
import os
import pathlib
import pickle
import tempfile
import unittest
import warnings

import support
import tetloft
from support import CROSSED, INNER, SQUARE, box, data, rows, tube


class Stacks(unittest.TestCase):
    def test_hold_what_they_were_made_of(self):
        stack = tetloft.Stack([(1, [SQUARE, INNER]), (2.5, []), (3, [SQUARE])])
        self.assertEqual((len(stack), stack.contour_count, stack.vertex_count), (3, 3, 12))
        self.assertEqual(stack.z, [1, 2.5, 3])
        self.assertEqual([len(section.contours) for section in stack], [2, 0, 1])
        self.assertEqual(rows(stack[0].contours[1]), [list(p) for p in INNER])
        self.assertEqual(rows(stack.contour(-1, -1)), [list(p) for p in SQUARE])
        self.assertEqual(repr(stack), "<tetloft.Stack of 3 sections, 3 contours, 12 vertices>")

    def test_are_made_of_other_stacks(self):
        again = tetloft.Stack(tube())
        self.assertEqual(again.to_bytes(), tube().to_bytes())

    def test_are_read_by_all_options(self):
        square = {"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 4], [0, 0]]]}
        features = [{"type": "Feature", "geometry": square,
                     "properties": {"id": 7, "roof": z, "height": z + 1}} for z in (0, 5)]
        text = json.dumps({"type": "FeatureCollection", "features": features}).encode()
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", tetloft.TetloftWarning)
            self.assertEqual(tetloft.parse_stack(text, "a.geojson").z, [1, 6])
            stack = tetloft.parse_stack(text, "a.geojson", property="roof")
        self.assertEqual(stack.z, [0, 5])
        self.assertIsNone(stack.labels)
        with self.assertRaises(TypeError):
            tetloft.parse_stack(text, "a.geojson", rof="roof")
        with self.assertRaises(ValueError):
            tetloft.parse_stack(text, "a.geojson", axis=3)
        with self.assertRaises(tetloft.UsageError):
            tetloft.parse_stack(text, "a.geojson", structure="lung")

    def test_bring_labels_along(self):
        plane = "\n{0} 3 1 0 0 1 -{0}\n\n0 0 {0}\n4 0 {0}\n0 4 {0}\n\n3 1 0 1 2\n"
        text = ("CSLC\n2 2\n" + plane.format(1) + plane.format(2)).encode()
        stack = tetloft.parse_stack(text, "a.csl")
        self.assertEqual(stack.labels.to_bytes(), b"0 0 1\n1 0 1\n")

    def test_may_be_empty(self):
        stack = tetloft.Stack([])
        self.assertEqual((len(stack), stack.z, list(stack)), (0, [], []))

    def test_take_any_iterables(self):
        made = tetloft.Stack((z, (map(list, c) for c in [SQUARE])) for z in (0, 5)) \
            if support.numpy is None else tetloft.Stack((z, iter([SQUARE])) for z in (0, 5))
        self.assertEqual(made.to_bytes(), box().to_bytes())

    def test_refuse_other_shapes_naming_the_contour(self):
        for bad in ([SQUARE, [(1, 2, 3)]], [SQUARE, [1, 2]], [SQUARE, [[(1, 2)]]]):
            with self.assertRaisesRegex(ValueError, "section 1, contour 1"):
                tetloft.Stack([(0, [SQUARE]), (1, bad)])
        for bad in (["a", "b"], [None, None], [1j, 0]):
            with self.assertRaises((TypeError, ValueError)):
                tetloft.Stack([(0, [[bad]])])

    def test_that_are_invalid_say_where(self):
        stack = tetloft.Stack([(0, [SQUARE]), (1, [SQUARE, [(x + 9, y) for x, y in CROSSED]])])
        with self.assertRaises(tetloft.InvalidInput) as caught:
            stack.validate()
        self.assertEqual((caught.exception.place.section, caught.exception.place.contour), (1, 1))
        with self.assertRaises(tetloft.InvalidInput) as caught:
            tetloft.Stack([(0, [SQUARE[:3] + [(0, math.nan)]])]).validate()
        self.assertEqual(caught.exception.place.vertex, 3)
        with self.assertRaises(tetloft.InvalidInput):
            tetloft.Stack([(1, [SQUARE]), (0, [SQUARE])]).validate()
        box().validate()

    def test_indices_out_of_range_are_index_errors(self):
        stack = box()
        for ask in (lambda: stack[2], lambda: stack[-3], lambda: stack.contour(0, 1),
                    lambda: stack.contour(5, 0), lambda: stack.twice_area(0, 1),
                    lambda: stack.nesting(2), lambda: stack.triangulate(2)):
            with self.assertRaises(IndexError):
                ask()
        with self.assertRaises(TypeError):
            stack[0.5]

    def test_areas_are_signed(self):
        stack = tube()
        self.assertEqual((stack.twice_area(0, 0), stack.twice_area(1, 1)), (32, -8))

    def test_nesting_tells_holes(self):
        nesting = tube().nesting(0)
        self.assertEqual(rows(nesting.parent), [tetloft.NO_ID, 0])
        self.assertEqual(rows(nesting.depth), [0, 1])
        self.assertEqual(rows(nesting.region), [0, 0])
        self.assertEqual(nesting.regions, 1)
        self.assertEqual(rows(tetloft.Stack([(0, [])]).nesting(0).parent), [])

    def test_sections_are_triangulated(self):
        made = tube().triangulate(1)
        inside = [t for t, internal in zip(rows(made.triangles), rows(made.internal)) if internal]
        points = rows(made.points)
        area = sum((points[b][0] - points[a][0]) * (points[c][1] - points[a][1]) -
                   (points[c][0] - points[a][0]) * (points[b][1] - points[a][1])
                   for a, b, c in inside)
        self.assertEqual(area, 24)

    def test_are_repaired_and_tell_how(self):
        stack = tetloft.Stack([(0, [CROSSED])])
        with self.assertRaises(tetloft.InvalidInput):
            stack.validate()
        repaired = stack.repair()
        repaired.validate()
        self.assertEqual(repaired.contour_count, 2)
        self.assertTrue(repaired.warnings)
        self.assertIn("section 0", repaired.warnings[0])
        self.assertEqual(box().repair(0.5).warnings, ())
        for bad in (0, -1, math.nan):
            with self.assertRaises(ValueError):
                stack.repair(bad)

    def test_are_repaired_by_a_fill_rule(self):
        square = [(0, 0), (2, 0), (2, 2), (0, 2)]
        other = [(x + 1, y + 1) for x, y in square]
        overlapping = tetloft.Stack([(0, [square, other, square[::-1]])])
        for fill, area in (("union", 7), ("odd", 6)):
            repaired = overlapping.repair(fill=fill)
            repaired.validate()
            self.assertAlmostEqual(repaired.repaired.area_after, area, 4)
            self.assertEqual(repaired.repaired.copies, 1)
            self.assertEqual(repaired.repaired.lost, 0)
        self.assertIsNone(overlapping.repaired)
        with self.assertRaisesRegex(ValueError, "odd, union, winding"):
            overlapping.repair(fill="even")
        twice = tetloft.Stack([(0, [square + square])]).repair()
        self.assertEqual((twice.contour_count, twice.repaired.lost), (0, 1))
        self.assertTrue(any("NOTHING IS LEFT" in text for text in twice.warnings))

    def test_have_keyholes_closed(self):
        keyhole = [(0, 0), (10, 0), (10, 4.9), (7, 4.9), (7, 3), (3, 3), (3, 7), (7, 7), (7, 5.1),
                   (10, 5.1), (10, 10), (0, 10)]
        stack = tetloft.Stack([(0, [keyhole])])
        closed = stack.repair(keyholes=0.25)
        self.assertEqual((closed.contour_count, closed.repaired.channels), (2, 1))
        self.assertEqual(stack.repair(keyholes=0.1).contour_count, 1)
        for bad in (0, -1, math.nan):
            with self.assertRaises(ValueError):
                stack.repair(keyholes=bad)

    def test_have_their_planes_arranged(self):
        square = [(0, 0), (2, 0), (2, 2), (0, 2)]
        other = [(x + 4, y) for x, y in square]
        stack = tetloft.Stack([(1, [square]), (0, [square]), (1, [other])])
        with self.assertRaises(tetloft.InvalidInput):
            stack.validate()
        sorted_ = stack.arrange()
        sorted_.validate()
        self.assertEqual([len(section.contours) for section in sorted_], [1, 2])
        self.assertEqual(len(sorted_.warnings), 1)
        self.assertEqual(tetloft.Stack([(1, [square]), (0, [square])]).arrange("flip").z, [0, 1])
        self.assertEqual(len(stack.arrange("merge", tolerance=1)), 1)
        with self.assertRaises(tetloft.InvalidInput):
            stack.arrange("flip")
        with self.assertRaises(tetloft.UsageError):
            stack.arrange("merge", tolerance=-1)
        for bad in (dict(rule="merge"), dict(rule="sort", tolerance=1), dict(rule="up")):
            with self.assertRaises(ValueError):
                stack.arrange(**bad)

    def test_are_snapped_and_refined(self):
        third = tetloft.Stack([(0, [[(0, 0), (4 / 3, 0), (0, 4)]])])
        self.assertEqual(rows(third.snap(4)[0].contours[0]), [[0, 0], [1.25, 0], [0, 4]])
        self.assertEqual(box().refine(1).vertex_count, 32)
        with self.assertRaises(tetloft.UsageError):
            box().snap(51)
        with self.assertRaises(ValueError):
            box().refine(-1)
        with self.assertRaises(TypeError):
            box().snap(1.5)

    def test_are_written_and_read(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a box ü.cnt"
            box().write(path)
            for source in (path, str(path), os.fsencode(path)):
                self.assertEqual(tetloft.read_stack(source).to_bytes(), box().to_bytes())
            with open(path, "rb") as opened:
                self.assertEqual(tetloft.read_stack(opened).to_bytes(), box().to_bytes())
            with open(path, encoding="utf-8") as opened, self.assertRaises(TypeError):
                tetloft.read_stack(opened)
        text = box().to_bytes("cnt")
        for given in (text, bytearray(text), memoryview(text), memoryview(text + b" " * 4)[::1]):
            self.assertEqual(tetloft.parse_stack(given, "box.cnt").to_bytes(), text)
        self.assertEqual(tetloft.read_stack(io.BytesIO(text), format="cnt").to_bytes(), text)
        with self.assertRaises(tetloft.UsageError):
            box().to_bytes("no such format")
        with self.assertRaises(ValueError):
            box().to_bytes("cnt\0")

    def test_of_files_are_validated_unless_told_otherwise(self):
        text = tetloft.Stack([(0, [CROSSED])]).to_bytes()
        with self.assertRaises(tetloft.InvalidInput) as caught:
            tetloft.parse_stack(text, "crossed.cnt")
        self.assertEqual(caught.exception.place.file, "crossed.cnt")
        self.assertEqual(len(tetloft.parse_stack(text, validate=False)), 1)

    def test_what_was_mended_is_warned_of(self):
        closed = b"S 1\nv 5 z 0\n{\n0 0\n4 0\n4 4\n0 4\n0 0\n}\n"
        with self.assertWarnsRegex(tetloft.TetloftWarning, "closed.cnt.*section 0") as told:
            stack = tetloft.parse_stack(closed, "closed.cnt")
        self.assertEqual(told.filename, __file__)
        self.assertEqual(len(stack.warnings), 1)
        self.assertEqual(stack.vertex_count, 4)
        with warnings.catch_warnings():
            warnings.simplefilter("error", tetloft.TetloftWarning)
            with self.assertRaises(tetloft.TetloftWarning):
                tetloft.parse_stack(closed)

    def test_are_copied_and_pickled(self):
        stack = tetloft.Stack([(0.1, [SQUARE, [(1, 1.1), (1, 3), (3, 3)]]), (1, []), (2, [SQUARE])])
        for again in (copy.copy(stack), copy.deepcopy(stack), pickle.loads(pickle.dumps(stack))):
            self.assertEqual(again.to_bytes(), stack.to_bytes())
            self.assertEqual(again.z, stack.z)
        self.assertEqual(len(pickle.loads(pickle.dumps(tetloft.Stack([])))), 0)
        repaired = tetloft.Stack([(0, [CROSSED])]).repair()
        self.assertEqual(pickle.loads(pickle.dumps(repaired)).warnings, repaired.warnings)

    def test_that_are_closed_say_so(self):
        with box() as stack:
            other = copy.copy(stack)
        self.assertTrue(stack.closed)
        self.assertEqual(repr(stack), "<tetloft.Stack, closed>")
        for ask in (lambda: len(stack), lambda: stack[0], stack.to_bytes, stack.validate,
                    lambda: tetloft.reconstruct(stack), stack.__enter__):
            with self.assertRaisesRegex(ValueError, "closed"):
                ask()
        stack.close()
        self.assertEqual(len(other), 2)

    def test_sample_files_are_read(self):
        self.assertEqual(len(tetloft.read_stack(data("bunny.cnt"))), 60)


if __name__ == "__main__":
    unittest.main()
