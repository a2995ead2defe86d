"""The tables of the package say what the C header says: no function, argument or field differs."""

import ctypes
import os
import re
import unittest

from support import ROOT
from tetloft import _library, _signatures, _structs, _version, errors

with open(os.path.join(ROOT, "include", "tetloft", "tetloft.h"), encoding="utf-8") as header:
    HEADER = re.sub(r"/\*.*?\*/", "", header.read(), flags=re.S)

PLAIN = {
    "int": ctypes.c_int, "int32_t": ctypes.c_int32, "int64_t": ctypes.c_int64,
    "uint8_t": ctypes.c_uint8, "uint32_t": ctypes.c_uint32, "uint64_t": ctypes.c_uint64,
    "size_t": ctypes.c_size_t, "double": ctypes.c_double, "tetloft_progress": _structs.Progress,
}
ENUMS = re.findall(r"typedef enum (\w+) \{", HEADER)
STRUCTS = dict(re.findall(r"typedef struct (\w+) \{(.*?)\} \w+;", HEADER, flags=re.S))
HANDLES = set(re.findall(r"typedef struct (\w+) \w+;", HEADER))


def camel(name):
    return "".join(word.capitalize() for word in name[len("tetloft_"):].split("_"))


def ctype(text):
    """The type that ctypes has for one of C."""
    words = re.sub(r"\bconst\b", " ", text).replace("*", " * ").split()
    name, stars = words[0], words.count("*")
    if name == "char" or name == "void" or name in HANDLES:
        kind, stars = (ctypes.c_char_p if name == "char" else ctypes.c_void_p), stars - 1
    elif name in ENUMS:
        kind = ctypes.c_int
    elif name in STRUCTS:
        kind = getattr(_structs, camel(name))
    else:
        kind = PLAIN[name]
    for _ in range(stars):
        kind = ctypes.POINTER(kind)
    return kind


def declared(text):
    """(type, name) of "const double* xy"."""
    kind, name = re.fullmatch(r"\s*(.*?[\s*])(\w+)\s*", text, flags=re.S).groups()
    return kind, name


FUNCTIONS = {
    name: (result, [] if arguments.strip() == "void" else arguments.split(","))
    for result, name, arguments in re.findall(
        r"TETLOFT_C_API\s+([\w\s*]+?)\s*\b(tetloft_\w+)\s*\(([^)]*)\);", HEADER)
}


class TheHeader(unittest.TestCase):
    def test_is_read_whole(self):
        self.assertEqual(len(FUNCTIONS), HEADER.count("TETLOFT_C_API") -
                         HEADER.count("#define TETLOFT_C_API"))
        self.assertGreater(len(FUNCTIONS), 100)
        self.assertGreater(len(STRUCTS), 10)
        self.assertGreater(len(HANDLES), 10)

    def test_has_the_functions_of_the_table_and_no_others(self):
        self.assertEqual(sorted(FUNCTIONS), sorted(_signatures.FUNCTIONS))

    def test_functions_take_and_return_the_same(self):
        for name, (result, arguments) in FUNCTIONS.items():
            with self.subTest(name):
                ours = _signatures.FUNCTIONS[name]
                self.assertIs(ours[0], ctype(result))
                self.assertEqual(ours[1], [ctype(declared(text)[0]) for text in arguments])

    def test_statuses_are_those_whose_failures_raise(self):
        for name, (result, _) in FUNCTIONS.items():
            checked = getattr(getattr(_library.lib, name), "errcheck", None) is not None
            self.assertEqual(checked, result == "tetloft_status" and name != "tetloft_last_place",
                             name)

    def test_structs_have_the_same_fields(self):
        self.assertEqual({camel(name) for name in STRUCTS},
                         {name for name, value in vars(_structs).items()
                          if isinstance(value, type) and issubclass(value, ctypes.Structure)})
        for name, body in STRUCTS.items():
            with self.subTest(name):
                fields = []
                for line in filter(str.strip, body.split(";")):
                    line, array = re.fullmatch(r"(.*?)(?:\[(\d+)\])?\s*", line, flags=re.S).groups()
                    kind, field = declared(line)
                    fields.append((field, ctype(kind) * int(array) if array else ctype(kind)))
                self.assertEqual(getattr(_structs, camel(name))._fields_, fields)

    def test_versions_of_results_are_the_same(self):
        for name in ("Place", "Format", "Report", "Figures"):
            number = re.search(rf"TETLOFT_{name.upper()}_VERSION (\d+)", HEADER).group(1)
            self.assertEqual(getattr(_structs, name).VERSION, int(number))

    def test_enumerators_have_the_same_values(self):
        def values(prefix, of):
            found = re.findall(rf"\bTETLOFT_{prefix}(\w+) = (\d+)", of)
            return {name.lower(): int(value) for name, value in found}

        def body(enum):
            return re.search(rf"typedef enum {enum} \{{(.*?)\}}", HEADER, flags=re.S).group(1)

        self.assertEqual(_structs.STATUS, values("", body("tetloft_status")))
        self.assertEqual(_structs.CRITERION, values("", body("tetloft_criterion")))
        self.assertEqual(_structs.VOIDS, values("VOIDS_", body("tetloft_void_rule")))
        self.assertEqual(_structs.ENDS, values("ENDS_", body("tetloft_ends")))
        self.assertEqual(_structs.ENGINE, values("ENGINE_", body("tetloft_engine")))
        self.assertEqual(_structs.COLOUR, values("COLOUR_", body("tetloft_colour")))
        self.assertEqual(_structs.LINK, values("LINK_", body("tetloft_link_kind")))
        self.assertEqual(_structs.CROSSING, values("CROSSING_", body("tetloft_crossing")))
        self.assertEqual(_structs.LOCATION, values("LOCATION_", body("tetloft_location")))
        self.assertEqual(_structs.SIDE, values("SIDE_", body("tetloft_side")))
        self.assertEqual(_structs.WEIGHTS, values("", body("tetloft_natural_weights")))
        self.assertEqual(_structs.CONTENTS, values("CONTENTS_", HEADER))
        self.assertIn("TETLOFT_NO_ID UINT32_C(0xFFFFFFFF)", HEADER)
        self.assertEqual(_structs.NO_ID, 0xFFFFFFFF)
        self.assertIn("TETLOFT_NO_VERTEX UINT64_C(0xFFFFFFFF)", HEADER)
        self.assertEqual(_structs.NO_VERTEX, 0xFFFFFFFF)

    def test_each_status_has_its_exception(self):
        for name, value in _structs.STATUS.items():
            self.assertEqual(_library.lib.tetloft_status_name(value).decode(), name)
            self.assertEqual(name in errors.OF_STATUS, name != "ok")

    def test_version_is_that_of_the_sources(self):
        with open(os.path.join(ROOT, "include", "tetloft", "version.hpp"), encoding="utf-8") as of:
            numbers = re.findall(r"#define TETLOFT_VERSION_\w+ (\d+)", of.read())
        self.assertEqual(_version.__version__, ".".join(numbers))


if __name__ == "__main__":
    unittest.main()
