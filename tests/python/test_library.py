"""The shared library: how it is found, and what is said when it is not."""

import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import tetloft
from support import run_python
from tetloft import _library

PACKAGE = os.path.dirname(os.path.abspath(tetloft.__file__))
SHOW = "import tetloft; print(tetloft.library_path, tetloft.library_version())"


class Library(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.package = os.path.join(self.folder.name, "site", "tetloft")
        shutil.copytree(PACKAGE, self.package,
                        ignore=shutil.ignore_patterns("__pycache__", "_location.py", "*.so*"))

    def run_copy(self, code, **environment):
        """In a program that has the copied package, and no library but what it is given."""
        path = os.pathsep.join([os.path.dirname(self.package), os.environ.get("PYTHONPATH", "")])
        surroundings = {**os.environ, "PYTHONPATH": path, **environment}
        if "TETLOFT_LIBRARY" not in environment:
            surroundings.pop("TETLOFT_LIBRARY", None)
        return subprocess.run([sys.executable, "-c", code], env=surroundings, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def put(self, *path):
        path = os.path.join(self.folder.name, *path)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        shutil.copy(tetloft.library_path, path)
        return path

    def loaded(self, **environment):
        made = self.run_copy(SHOW, **environment)
        self.assertEqual(made.returncode, 0, made.stderr)
        path, version = made.stdout.split()
        self.assertEqual(version, tetloft.__version__)
        return path

    def test_is_named_by_the_environment(self):
        path = self.put("elsewhere", "any name".replace(" ", "_"))
        self.put("site", "tetloft", _library.file_names()[0])
        self.assertEqual(self.loaded(TETLOFT_LIBRARY=path), path)

    def test_lies_beside_the_package(self):
        path = self.put("site", "tetloft", _library.file_names()[0])
        self.assertEqual(self.loaded(), path)

    def test_lies_where_the_installation_says(self):
        path = self.put("lib", "libtetloft.so.7")
        with open(os.path.join(self.package, "_location.py"), "w", encoding="utf-8") as location:
            location.write('LIBRARY = "../../lib/libtetloft.so.7"\n')
        self.assertEqual(self.loaded(), path)

    @unittest.skipUnless(sys.platform.startswith("linux"), "LD_LIBRARY_PATH")
    def test_is_found_by_the_loader(self):
        name = _library.file_names()[-1]
        path = self.put("loader", name)
        self.assertEqual(self.loaded(LD_LIBRARY_PATH=os.path.dirname(path)), name)

    def test_that_is_nowhere_is_an_import_error_with_all_places(self):
        made = self.run_copy("try: import tetloft\nexcept ImportError as error: print(error)")
        for place in (*_library.file_names(), self.package, "TETLOFT_LIBRARY", "no such file"):
            self.assertIn(place, made.stdout)
        made = self.run_copy("import tetloft", TETLOFT_LIBRARY="/no/such/library.so")
        self.assertNotEqual(made.returncode, 0)
        self.assertIn("/no/such/library.so", made.stderr)
        self.assertNotIn(self.package + os.sep + "lib", made.stderr)

    def test_of_another_version_is_told(self):
        with open(os.path.join(self.package, "_version.py"), "w", encoding="utf-8") as version:
            version.write('__version__ = "7.8.9"\n')
        made = self.run_copy("import tetloft", TETLOFT_LIBRARY=tetloft.library_path)
        self.assertIn("ImportError", made.stderr)
        for word in ("7.8.9", tetloft.library_version(), tetloft.library_path):
            self.assertIn(word, made.stderr)

    def test_that_is_another_one_is_told(self):
        import _ctypes
        other = getattr(_ctypes, "__file__", None)
        if other is None:
            self.skipTest("no other library at hand")
        made = self.run_copy("import tetloft", TETLOFT_LIBRARY=other)
        self.assertIn("ImportError", made.stderr)
        self.assertIn("not a shared library of tetloft", made.stderr)

    def test_needs_nothing_but_the_standard_library(self):
        made = run_python(
            "import sys\nsys.modules['numpy'] = None\nbefore = set(sys.modules)\nimport tetloft\n"
            "names = {name.split('.')[0] for name in set(sys.modules) - before}\n"
            "print(*sorted(names - {'tetloft'} - set(sys.stdlib_module_names)))\n"
            if sys.version_info >= (3, 10) else "import tetloft; print()")
        self.assertEqual((made.stdout.strip(), made.stderr), ("", ""))

    def test_names_are_all_there(self):
        self.assertEqual(sorted(tetloft.__all__), sorted(set(tetloft.__all__)))
        for name in tetloft.__all__:
            self.assertTrue(hasattr(tetloft, name), name)


if __name__ == "__main__":
    unittest.main()
