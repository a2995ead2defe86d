"""Errors: what kind, where, and whose exception it is in Python."""

import math
import os
import pickle
import sys
import tempfile
import threading
import unittest

import support
import tetloft
from support import CROSSED, SQUARE, box
from tetloft import errors


def raised(call):
    try:
        call()
    except tetloft.Error as error:
        return error
    raise AssertionError("nothing was raised")


class Errors(unittest.TestCase):
    def test_of_files_name_file_and_line(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "broken ü.cnt")
            with open(path, "wb") as broken:
                broken.write(b"S 1\nv 4 z 0\n{\n0 0\n4 0\n4 x\n0 4\n}\n")
            error = raised(lambda: tetloft.read_stack(path))
        self.assertIsInstance(error, tetloft.InvalidInput)
        self.assertIsInstance(error, ValueError)
        self.assertEqual((error.place.file, error.place.line), (path, 6))
        self.assertEqual((error.code, error.status), (3, "invalid_input"))
        self.assertTrue(str(error).startswith(f"{path}:6: "))
        self.assertTrue(str(error).endswith(error.message))
        self.assertNotIn(path, error.message)
        self.assertIsNone(error.place.slab)

    def test_of_absent_files_are_os_errors(self):
        for call in (lambda: tetloft.read_stack("no/such.cnt"),
                     lambda: tetloft.read_model("no/such.vtu"),
                     lambda: tetloft.read_points("no/such.xyz"),
                     lambda: tetloft.read_labels("no/such.labels"),
                     lambda: box().write("no/such.cnt"),
                     lambda: tetloft.reconstruct(box()).write("no/such.vtu"),
                     lambda: tetloft.reconstruct(box()).write_surface("no/such.stl"),
                     lambda: tetloft.write_points("no/such.xyz", [(0, 0, 0)])):
            error = raised(call)
            self.assertIsInstance(error, OSError)
            self.assertIsInstance(error, tetloft.FileError)
            self.assertIn("no/such", str(error))

    def test_of_geometry_name_section_contour_and_point(self):
        error = raised(tetloft.Stack([(0, [SQUARE]), (1, [CROSSED])]).validate)
        self.assertEqual((error.place.section, error.place.contour), (1, 0))
        self.assertIn("section 1", str(error))
        point = raised(tetloft.Stack([(0, [SQUARE[:2] + [(2, 0)]])]).validate).place.point
        self.assertTrue(point is None or (len(point) == 3 and point[2] == 0))

    def test_of_work_name_the_slab_or_section(self):
        stack = support.circles(2, 40000)
        error = raised(lambda: tetloft.reconstruct(stack, work_limit=0.001))
        self.assertIsInstance(error, tetloft.WorkLimit)
        self.assertTrue(error.place.slab == 0 or error.place.section is not None)

    def test_of_options_are_value_errors(self):
        for call in (lambda: tetloft.reconstruct(box(), ends="round"),
                     lambda: tetloft.reconstruct(box(), correspondence="magic"),
                     lambda: tetloft.reconstruct(box(), engine="steam"),
                     lambda: tetloft.reconstruct(box(), between=-1),
                     lambda: tetloft.reconstruct(box(), thickness=0),
                     lambda: tetloft.reconstruct(box(), thickness=math.nan),
                     lambda: tetloft.reconstruct(box(), work_limit=-1),
                     lambda: tetloft.reconstruct(box(), threads=-1),
                     lambda: tetloft.reconstruct(box(), threads=2**32),
                     lambda: tetloft.links(box(), correspondence=tetloft.Correspondence(tau=-1)),
                     lambda: tetloft.links(box(), correspondence=tetloft.Correspondence(tau=1)),
                     lambda: tetloft.read_stack("a\0b"),
                     lambda: tetloft.parse_stack(b"", "a\0b")):
            with self.assertRaises(ValueError):
                call()
        for call in (lambda: tetloft.reconstruct(box(), between=0.5),
                     lambda: tetloft.reconstruct(box(), threads="2"),
                     lambda: tetloft.reconstruct(box(), progress=7),
                     lambda: tetloft.reconstruct(box(), stop=threading.Event()),
                     lambda: tetloft.reconstruct([(0, [SQUARE])]),
                     lambda: tetloft.links(None),
                     lambda: tetloft.check(box(), box()),
                     lambda: tetloft.check(tetloft.reconstruct(box()), "box.cnt"),
                     lambda: tetloft.links(box(), correspondence=1),
                     lambda: tetloft.links(box(), labels=1),
                     lambda: tetloft.reconstruct(box()).render("a.png", "box.cnt"),
                     lambda: tetloft.read_stack(None),
                     lambda: tetloft.parse_stack("text")):
            with self.assertRaises(TypeError):
                call()

    def test_are_those_of_python_too(self):
        for ours, theirs in ((tetloft.UsageError, ValueError), (tetloft.InvalidInput, ValueError),
                             (tetloft.FileError, OSError), (tetloft.OutOfMemory, MemoryError),
                             (tetloft.InternalError, RuntimeError)):
            self.assertTrue(issubclass(ours, theirs) and issubclass(ours, tetloft.Error))

    @unittest.skipUnless(sys.platform.startswith("linux"), "RLIMIT_AS")
    def test_of_memory_are_memory_errors(self):
        made = support.run_python(
            "import random, resource, tetloft\n"
            "random.seed(1)\n"
            "points = [[random.random() for _ in range(3)] for _ in range(200000)]\n"
            "tetloft.delaunay(points[:100])\n"
            "pages = int(open('/proc/self/statm').read().split()[0])\n"
            "limit = pages * resource.getpagesize() + 2**22\n"
            "resource.setrlimit(resource.RLIMIT_AS, (limit, limit))\n"
            "try: tetloft.delaunay(points, threads=1)\n"
            "except MemoryError as error: print(type(error).__name__, error)\n")
        self.assertTrue(made.stdout.startswith(("OutOfMemory", "MemoryError")),
                        made.stdout + made.stderr)

    def test_are_pickled(self):
        for kind in errors.OF_STATUS.values():
            error = kind("a:1: no", 7, "no", tetloft.Place("a", 1))
            again = pickle.loads(pickle.dumps(error))
            self.assertIs(type(again), kind)
            self.assertEqual((str(again), again.code, again.message, again.place),
                             ("a:1: no", 7, "no", tetloft.Place("a", 1)))

    def test_of_threads_are_each_threads_own(self):
        places, barrier = {}, threading.Barrier(8)

        def fail(number):
            sections = [(z, [CROSSED if z == number else SQUARE]) for z in range(8)]
            barrier.wait()
            places[number] = raised(tetloft.Stack(sections).validate).place.section

        threads = [threading.Thread(target=fail, args=(number,)) for number in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(places, {number: number for number in range(8)})


if __name__ == "__main__":
    unittest.main()
