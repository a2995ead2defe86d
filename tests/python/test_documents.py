"""What is written about the package works: docstrings, README, examples, type hints."""

import contextlib
import doctest
import importlib
import importlib.util
import inspect
import io
import os
import pkgutil
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import tetloft
from support import ROOT, data, numpy

SOURCES = os.path.join(ROOT, "src", "python")
EXAMPLES = os.path.join(SOURCES, "examples")
_DOCUMENTED = (type(lambda: None), property)


def there(module):
    return importlib.util.find_spec(module) is not None


def example(name, *arguments):
    return subprocess.run([sys.executable, os.path.join(EXAMPLES, name), *arguments], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE)


def modules():
    return [importlib.import_module(f"tetloft.{found.name}")
            for found in pkgutil.iter_modules(tetloft.__path__)]


class Docstrings(unittest.TestCase):
    def test_have_examples_that_work(self):
        results = [doctest.testmod(module) for module in modules()]
        self.assertEqual([failed for failed, _ in results], [0] * len(results))
        self.assertGreater(sum(attempted for _, attempted in results), 20)

    def test_are_there_for_everything_public(self):
        for name in tetloft.__all__:
            thing = getattr(tetloft, name)
            if not inspect.isclass(thing) and not inspect.isfunction(thing):
                continue
            self.assertTrue((thing.__doc__ or "").strip(), name)
            self.assertFalse(thing.__doc__.startswith(f"{name}("), f"{name}: a generated one")
            if inspect.isclass(thing):
                for member, value in vars(thing).items():
                    if isinstance(value, _DOCUMENTED) and not member.startswith("_"):
                        self.assertTrue(value.__doc__, f"{name}.{member}")


class Readme(unittest.TestCase):
    def test_code_works(self):
        with open(os.path.join(SOURCES, "README.md"), encoding="utf-8") as readme:
            blocks = re.findall(r"```python\n(.*?)```", readme.read(), flags=re.S)
        self.assertGreater(len(blocks), 5)
        run, names, before = 0, {}, os.getcwd()
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(data("bunny.cnt"), folder)
            os.chdir(folder)
            try:
                for block in blocks:
                    wanted = re.search(r"^import (meshio|pyvista)", block, flags=re.M)
                    if wanted and (numpy is None or not there(wanted.group(1))):
                        continue
                    with contextlib.redirect_stdout(io.StringIO()):
                        exec(block, names)
                    run += 1
            finally:
                os.chdir(before)
        self.assertGreaterEqual(run, 4)


class Examples(unittest.TestCase):
    def test_first_model(self):
        with tempfile.TemporaryDirectory() as folder:
            made = example("first_model.py", folder)
            self.assertEqual((made.returncode, made.stderr), (0, ""), made.stdout)
            self.assertEqual(sorted(os.listdir(folder)), ["vase.html", "vase.stl", "vase.vtu"])
        self.assertIn("3 embedded: pass", made.stdout)

    def test_progress_and_stop(self):
        made = example("progress_and_stop.py", data("torus.cnt"))
        self.assertEqual((made.returncode, made.stderr), (0, ""))
        self.assertIn("[" + "#" * 40 + "]", made.stdout)
        made = example("progress_and_stop.py", data("torus.cnt"), "0")
        self.assertIn(made.returncode, (0, 1))  # the timer may be late
        made = example("progress_and_stop.py", "no/such.cnt")
        self.assertEqual(made.returncode, 4)

    @unittest.skipUnless(numpy is not None and there("meshio"), "without meshio")
    def test_with_meshio(self):
        import meshio
        solid = tetloft.reconstruct(tetloft.read_stack(data("torus.cnt")))
        with tempfile.TemporaryDirectory() as folder:
            for name in ("torus.vtu", "torus.vtk"):
                path = os.path.join(folder, name)
                made = example("with_meshio.py", data("torus.cnt"), path)
                self.assertEqual(made.returncode, 0, made.stderr)
                again = meshio.read(path)
                self.assertTrue((again.points == solid.points).all())
                self.assertTrue((again.cells_dict["tetra"] == solid.tets).all())
        mesh = meshio.Mesh(solid.points, [("tetra", solid.tets)])
        self.assertTrue(numpy.shares_memory(mesh.points, solid.points))
        self.assertTrue(numpy.shares_memory(mesh.cells[0].data, solid.tets))

    @unittest.skipUnless(numpy is not None and there("pyvista"), "without PyVista")
    def test_with_pyvista(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "torus.png")
            made = example("with_pyvista.py", data("torus.cnt"), path)
            self.assertEqual(made.returncode, 0, made.stderr)
            self.assertTrue(os.path.exists(path))


class TypeHints(unittest.TestCase):
    @unittest.skipUnless(numpy is not None and there("mypy") and "TETLOFT_SLOW" in os.environ,
                         "without mypy, or TETLOFT_SLOW")
    def test_agree_with_the_code_and_are_seen_by_callers(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "caller.py")
            with open(path, "w", encoding="utf-8") as caller:
                caller.write("import tetloft\n"
                             "stack = tetloft.read_stack('a.cnt')\n"
                             "points = tetloft.reconstruct(stack, between=None).points\n"
                             "reveal_type(points)\n"
                             "tetloft.Stack([(0, [[(0, 0), (1, 0), (0, 1)], points[:, :2]])])\n"
                             "tetloft.reconstruct(7)\n")
            made = subprocess.run(
                [sys.executable, "-m", "mypy", "--strict", "--no-warn-return-any",
                 "--python-version", "3.9", "--cache-dir", os.path.join(folder, "cache"),
                 os.path.join(SOURCES, "tetloft"), os.path.join(SOURCES, "wheel.py"), path],
                text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertRegex(made.stdout, r"caller.py:4: note: Revealed type is .*ndarray")
        self.assertRegex(made.stdout, r'caller.py:6: error: .*"int"; expected "Stack"')
        self.assertEqual(made.stdout.count("error:"), 1, made.stdout)

    def test_are_there_for_every_argument(self):
        for module in modules():
            for name, thing in vars(module).items():
                if inspect.isfunction(thing) and thing.__module__ == module.__name__:
                    signature = inspect.signature(thing)
                    self.assertIsNot(signature.return_annotation, signature.empty, name)
                    for argument in signature.parameters.values():
                        self.assertIsNot(argument.annotation, argument.empty,
                                         f"{name}({argument.name})")


if __name__ == "__main__":
    unittest.main()
