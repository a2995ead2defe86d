"""Correspondence: options, labels and decisions, links; and checking by them."""

import os
import pickle
import tempfile
import unittest

import tetloft
from support import INNER, SQUARE, box, rows, tube

LEFT, RIGHT = [(0, 0), (4, 0), (4, 4), (0, 4)], [(9, 0), (13, 0), (13, 4), (9, 4)]
BAR = [(0, 0), (13, 0), (13, 4), (0, 4)]


def fork():
    """A bar over two squares."""
    return tetloft.Stack([(0, [LEFT, RIGHT]), (5, [BAR])])


def column():
    """Two pairs of squares, of two columns."""
    return tetloft.Stack([(0, [LEFT, RIGHT]), (5, [LEFT, RIGHT])])


class LabelsAndDecisions(unittest.TestCase):
    def test_are_kept_as_they_were_given(self):
        labels = tetloft.Labels({(0, 0): 7, (2, 1): 2**32 - 2}, join=[(0, 1, 2)], part=[(1, 2, 3)],
                                hole_labels={(0, 1): 3}, open=[(0, 1, None)], close=[(0, None, 1)])
        text = labels.to_bytes()
        self.assertEqual(sorted(text.decode().splitlines()), sorted([
            "0 0 7", "2 1 4294967294", "join 0 1 2", "part 1 2 3", "hole 0 1 3",
            "open 0 1 outside", "close 0 outside 1"]))
        self.assertEqual(tetloft.parse_labels(text).to_bytes(), text)
        self.assertEqual(pickle.loads(pickle.dumps(labels)).to_bytes(), text)
        self.assertEqual(repr(labels), "<tetloft.Labels of 7 lines>")
        labels.close()
        self.assertEqual(repr(labels), "<tetloft.Labels, closed>")

    def test_are_written_and_read(self):
        labels = tetloft.Labels({(0, 0): 7})
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "fork.labels")
            labels.write(path)
            self.assertEqual(tetloft.read_labels(path).to_bytes(), labels.to_bytes())
            with open(path, "rb") as opened:
                self.assertEqual(tetloft.read_labels(opened).to_bytes(), labels.to_bytes())
            solid = tetloft.reconstruct(fork(), labels=path)
        self.assertEqual(solid.component_count, 1)
        with self.assertRaises(tetloft.InvalidInput) as caught:
            tetloft.parse_labels(b"0 0 7\nnonsense\n", "wrong.labels")
        self.assertEqual(caught.exception.place[:2], ("wrong.labels", 2))

    def test_must_be_ids(self):
        for bad in ({(-1, 0): 1}, {(0, 2**32 - 1): 1}, {(0, 0): -1}):
            with self.assertRaises(ValueError):
                tetloft.Labels(bad)
        with self.assertRaises(TypeError):
            tetloft.Labels({(0, 0): "7"})

    def test_decide(self):
        self.assertEqual(tetloft.links(fork()).components, 1)
        for labels in ({(0, 0): 1, (0, 1): 2, (1, 0): 1}, tetloft.Labels(part=[(0, 1, 0)])):
            found = tetloft.links(fork(), labels=labels)
            self.assertEqual(found.components, 2)
            self.assertEqual([rows(part) for part in found.partition], [[0, 1], [0]])
        rule = tetloft.Correspondence("overlap", labels=tetloft.Labels(part=[(0, 1, 0)]))
        solid = tetloft.reconstruct(fork(), correspondence=rule)
        self.assertEqual(solid.component_count, 2)
        self.assertTrue(tetloft.check(solid, fork(), correspondence=rule))
        self.assertFalse(tetloft.check(solid, fork(), correspondence="overlap"))
        with self.assertRaisesRegex(ValueError, "twice"):
            tetloft.links(fork(), correspondence=rule, labels={})
        with self.assertRaises(tetloft.InvalidInput):
            tetloft.links(fork(), labels={(5, 0): 1})

    def test_outlive_the_names_they_had(self):
        rule = tetloft.Correspondence(labels=tetloft.Labels(part=[(0, 1, 0)]))
        self.assertEqual([tetloft.links(fork(), correspondence=rule).components
                          for _ in range(3)], [2, 2, 2])


class LinksOfAStack(unittest.TestCase):
    def test_tell_evidence_and_fate(self):
        found = tetloft.links(column(), correspondence="overlap")
        made = [link for link in found.regions if link.fate == "made"]
        self.assertEqual([(link.slab, link.lower, link.upper, link.evidence, link.ratio)
                          for link in made], [(0, 0, 0, "overlap", 1), (0, 1, 1, "overlap", 1)])
        self.assertTrue(all(link.margin > 0 and link.distance == 0 for link in made))
        self.assertEqual((found.components, found.cavities, found.warnings), (2, 0, ()))
        self.assertRegex(repr(found), r"<tetloft.Links: 2 of \d+ made, 2 components, 0 cavities>")
        self.assertIsNone(tetloft.links(box()).regions[0].lead)

    def test_of_voids_name_holes_and_the_exterior(self):
        closed = tetloft.Stack([(0, [SQUARE]), (1, [SQUARE, INNER]), (2, [SQUARE])])
        self.assertEqual(tetloft.links(closed).cavities, 1)
        voids = tetloft.links(tube()).voids
        self.assertIn((0, 1, 1, "made"), [v[:3] + (v.fate,) for v in voids])
        opened = tetloft.links(closed, labels=tetloft.Labels(open=[(0, None, 1)]))
        self.assertEqual(opened.cavities, 0)
        self.assertIn((0, None, 1), [v[:3] for v in opened.voids if v.evidence == "decision"])
        self.assertEqual(tetloft.links(tube(), correspondence=tetloft.Correspondence(
            voids="free")).voids, [])

    def test_follow_options(self):
        apart = tetloft.Stack([(0, [LEFT]), (1, [[(x + 3.8, y) for x, y in LEFT]])])

        def components(**options):
            return tetloft.links(apart, correspondence=tetloft.Correspondence(
                "overlap", lone=False, chain=False, **options)).components
        self.assertEqual(components(), 1)
        with self.assertWarns(tetloft.TetloftWarning):  # that nothing meets
            self.assertEqual(components(tau=0.5), 2)


class Check(unittest.TestCase):
    def test_passes_what_was_reconstructed(self):
        solid = tetloft.reconstruct(tube())
        verdict = tetloft.check(solid, tube(), recompute_motions=True, strict=True, split_ulps=0)
        self.assertTrue(verdict)
        self.assertEqual([g.number for g in verdict.guarantees], [1, 2, 3, 4, 5])
        self.assertTrue(all(g.passed and not g.failures and not g.not_asked
                            for g in verdict.guarantees))
        figures = verdict.figures
        self.assertEqual((figures.components, figures.volume, figures.genus), (1, 60, [1]))
        self.assertEqual((figures.cavities, figures.least_genus, figures.most_genus), (0, 1, 1))
        self.assertIn("1 manifold: pass", str(verdict))
        self.assertIn("genus: [1]", str(verdict))

    def test_tells_what_fails_and_where(self):
        solid = tetloft.reconstruct(box())
        lacking = tetloft.Model(solid.points, solid.tets[1:])
        verdict = tetloft.check(lacking, box())
        self.assertFalse(verdict)
        sampling = verdict.guarantees[1]
        self.assertFalse(sampling.passed)
        self.assertTrue(sampling.failures[0].what.startswith("2."))
        self.assertGreater(sampling.failures[0].count, 0)
        self.assertIn("2 re-sampling: FAIL", str(verdict))
        self.assertIn(sampling.failures[0].places[0], str(verdict))
        self.assertIn("2 FAIL", repr(verdict))
        self.assertIn("5 not asked", repr(verdict))
        self.assertIsNone(verdict.figures.cavities)
        few = tetloft.check(lacking, box(), places=0)
        self.assertEqual(few.guarantees[1].failures[0].places, [])
        self.assertEqual(pickle.loads(pickle.dumps(verdict)), verdict)

    def test_refuses_an_invalid_stack(self):
        solid = tetloft.reconstruct(box())
        with self.assertRaises(tetloft.InvalidInput):
            tetloft.check(solid, tetloft.Stack([(1, [SQUARE]), (0, [SQUARE])]))
        with self.assertRaises(tetloft.UsageError):
            tetloft.check(solid, box(), split_ulps=-1)


if __name__ == "__main__":
    unittest.main()
