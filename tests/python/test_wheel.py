"""The wheel: what is in it, and that its record says so."""

import base64
import csv
import hashlib
import importlib.util
import io
import os
import tempfile
import unittest
import zipfile

import tetloft
from support import ROOT

SPEC = importlib.util.spec_from_file_location("wheel",
                                              os.path.join(ROOT, "src", "python", "wheel.py"))
wheel = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(wheel)


class Wheel(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.library = os.path.join(folder.name, "any.so")
        with open(self.library, "wb") as library:
            library.write(b"library")
        self.name = wheel.write(self.library, folder.name)
        self.path = os.path.join(folder.name, self.name)
        with zipfile.ZipFile(self.path) as opened:
            self.assertIsNone(opened.testzip())
            self.files = {name: opened.read(name) for name in opened.namelist()}
        self.info = f"tetloft-{tetloft.__version__}.dist-info"

    def test_has_the_package_and_the_library(self):
        package = os.path.join(ROOT, "src", "python", "tetloft")
        for name in os.listdir(package):
            if name.endswith(".py") or name == "py.typed":
                with open(os.path.join(package, name), "rb") as source:
                    self.assertEqual(self.files.pop(f"tetloft/{name}"), source.read())
        libraries = [name for name in self.files if name.startswith("tetloft/")]
        self.assertEqual([self.files[name] for name in libraries], [b"library"])
        self.assertEqual(libraries[0], f"tetloft/{tetloft._library.file_names()[0]}")
        self.assertEqual(sorted(name for name in self.files if name not in libraries),
                         [f"{self.info}/{name}" for name in ("METADATA", "RECORD", "WHEEL")])

    def test_has_a_record_of_all_files(self):
        record = {name: (digest, size) for name, digest, size in
                  csv.reader(io.StringIO(self.files[f"{self.info}/RECORD"].decode()))}
        self.assertEqual(sorted(record), sorted(self.files))
        self.assertEqual(record.pop(f"{self.info}/RECORD"), ("", ""))
        for name, (digest, size) in record.items():
            expected = base64.urlsafe_b64encode(hashlib.sha256(self.files[name]).digest())
            self.assertEqual(digest, "sha256=" + expected.decode().rstrip("="))
            self.assertEqual(int(size), len(self.files[name]))

    def test_tells_name_version_and_platform(self):
        metadata = self.files[f"{self.info}/METADATA"].decode()
        self.assertIn(f"\nName: tetloft\nVersion: {tetloft.__version__}\n", metadata)
        self.assertIn("\n\n# tetloft for Python\n", metadata)
        tag = self.name[len(f"tetloft-{tetloft.__version__}-"):-len(".whl")]
        self.assertTrue(tag.startswith("py3-none-"))
        self.assertIn(f"\nTag: {tag}\n", self.files[f"{self.info}/WHEEL"].decode())

    def test_is_the_same_each_time(self):
        with tempfile.TemporaryDirectory() as folder:
            wheel.write(self.library, folder)
            with open(os.path.join(folder, self.name), "rb") as again, open(self.path, "rb") as one:
                self.assertEqual(again.read(), one.read())


if __name__ == "__main__":
    unittest.main()
