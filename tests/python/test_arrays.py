"""Arrays: views on the library's memory that keep it, and what is taken for one."""

import array
import ctypes
import gc
import unittest
import weakref

import tetloft
from support import SQUARE, box, numpy, rows
from tetloft import _arrays, _handles, _library

with_numpy = unittest.skipIf(numpy is None, "without NumPy")
without_numpy = unittest.skipIf(numpy is not None, "with NumPy")


def address(function, handle):
    """Where the library has an array."""
    pointer = getattr(_library.lib, function).argtypes[1]._type_()
    getattr(_library.lib, function)(handle, ctypes.byref(pointer), ctypes.byref(ctypes.c_size_t()))
    return ctypes.cast(pointer, ctypes.c_void_p).value


class ArraysOfTheLibrary(unittest.TestCase):
    @with_numpy
    def test_are_no_copies(self):
        solid = tetloft.reconstruct(box())
        for name, function, kind, shape in (
                ("points", "points", "float64", (8, 3)),
                ("tets", "tets", "uint32", (len(solid), 4)),
                ("components", "tet_components", "uint32", (len(solid),)),
                ("kinds", "tet_kinds", "uint8", (len(solid),)),
                ("point_origins", "point_origins", "uint8", (8,))):
            made = getattr(solid, name)
            self.assertEqual(made.ctypes.data, address(f"tetloft_model_{function}", solid._handle))
            self.assertEqual((str(made.dtype), made.shape), (kind, shape))
            self.assertTrue(numpy.shares_memory(made, getattr(solid, name)))
        self.assertTrue(numpy.shares_memory(solid.points, solid.boundary().points))

    @with_numpy
    def test_cannot_be_written(self):
        points = tetloft.reconstruct(box()).points
        with self.assertRaises(ValueError):
            points[0, 0] = 7
        with self.assertRaises(ValueError):
            points.flags.writeable = True

    @with_numpy
    def test_outlive_their_object_and_free_it_at_last(self):
        solid = tetloft.reconstruct(box())
        handle = weakref.ref(solid._handle)
        expected = solid.points.tolist()
        part = solid.points[1:]
        del solid
        gc.collect()
        self.assertIsNotNone(handle())
        self.assertEqual(part.tolist(), expected[1:])
        del part
        gc.collect()
        self.assertIsNone(handle())

    @with_numpy
    def test_outlive_a_closed_object(self):
        with tetloft.reconstruct(box()) as solid:
            points = solid.points
            handle = weakref.ref(solid._handle)
        self.assertEqual(points[0].tolist(), [0, 0, 0])
        self.assertIsNotNone(handle())

    def test_handles_are_freed_with_their_object(self):
        solid = tetloft.reconstruct(box())
        name = ctypes.c_void_p(solid._handle._value.value)
        count = ctypes.c_size_t()
        _library.lib.tetloft_model_component_count(name, ctypes.byref(count))
        del solid
        gc.collect()
        with self.assertRaises(tetloft.BadHandle):
            _library.lib.tetloft_model_component_count(name, ctypes.byref(count))

    def test_handles_are_freed_on_close(self):
        stack = box()
        handle = weakref.ref(stack._handle)
        stack.close()
        gc.collect()
        self.assertIsNone(handle())

    def test_handles_of_failures_are_none(self):
        made = _handles.Handle("model")
        self.assertFalse(made._value)
        del made  # nothing is freed

    @without_numpy
    def test_are_lists_of_tuples(self):
        solid = tetloft.reconstruct(box())
        self.assertEqual(solid.points[0], (0, 0, 0))
        self.assertEqual([type(solid.points), type(solid.tets), type(solid.kinds)], [list] * 3)
        self.assertEqual({len(tet) for tet in solid.tets}, {4})
        self.assertIs(solid.points, solid.points)
        self.assertEqual(solid.mesh().neighbours,
                         [tuple(h if h == tetloft.NO_ID else h // 4 for h in row)
                          for row in solid.mesh().opposites])

    def test_may_be_empty(self):
        model = tetloft.Model([], [])
        self.assertEqual((len(model.points), len(model.tets), len(model.kinds)), (0, 0, 0))
        if numpy is not None:
            self.assertEqual((model.points.shape, model.tets.shape), ((0, 3), (0, 4)))
            self.assertEqual(model.points.dtype, numpy.float64)


class ArraysOfTheCaller(unittest.TestCase):
    @with_numpy
    def test_of_other_types_and_orders_are_copied(self):
        square = numpy.array(SQUARE, dtype=float)
        expected = box().to_bytes()
        wide = numpy.zeros((8, 4))
        wide[::2, 1:3] = square
        for given in (square, square.astype("float32"), square.astype("int16"),
                      square.astype(">f8"), numpy.asfortranarray(square), wide[::2, 1:3],
                      square[::-1][::-1], numpy.matrix(square)):
            self.assertEqual(tetloft.Stack([(0, [given]), (5, [given])]).to_bytes(), expected)
        square.flags.writeable = False
        self.assertEqual(tetloft.Stack([(0, [square]), (5, [square])]).to_bytes(), expected)

    @with_numpy
    def test_that_are_not_aligned_are_copied(self):
        packed = numpy.zeros(4, dtype=[("tag", "u1"), ("point", "f8", 2)])["point"]
        file = numpy.frombuffer(bytes(1) + numpy.array(SQUARE, float).tobytes(), float, offset=1)
        for given in (packed, file.reshape(4, 2)):
            self.assertFalse(given.flags.aligned)
            made = _arrays.doubles(given, 2, "points").memory
            self.assertTrue(made.flags.aligned and made.flags.c_contiguous)
            self.assertEqual(rows(made), rows(given))
        aligned = numpy.array(SQUARE, float)
        self.assertIs(_arrays.doubles(aligned, 2, "points").memory, aligned)

    @with_numpy
    def test_stay_the_callers(self):
        square = numpy.array(SQUARE, dtype=float)
        stack = tetloft.Stack([(0, [square])])
        square[:] = 0
        self.assertEqual(rows(stack.contour(0, 0)), [list(p) for p in SQUARE])

    @with_numpy
    def test_of_unfit_types_are_refused(self):
        for unfit in (numpy.array(SQUARE, dtype=complex), numpy.array(SQUARE).astype(str),
                      numpy.array(SQUARE, dtype=object)):
            with self.assertRaises(TypeError):
                tetloft.Stack([(0, [unfit])])
        with self.assertRaises(TypeError):
            tetloft.Mesh(4, [[0.0, 1.0, 2.0, 3.0]])

    @without_numpy
    def test_may_be_buffers_and_sequences(self):
        flat = array.array("d", [x for p in SQUARE for x in p])
        twice = memoryview(flat).cast("B").cast("d", (4, 2))
        for given in (twice, [list(p) for p in SQUARE], iter(SQUARE), tuple(map(tuple, SQUARE))):
            self.assertEqual(rows(tetloft.Stack([(0, [given])]).contour(0, 0)),
                             [list(p) for p in SQUARE])
        with self.assertRaises(TypeError):
            tetloft.Mesh(4, [[0.0, 1.0, 2.0, 3.0]])

    def test_of_ids_are_checked_for_their_range(self):
        for bad in (-1, 2**32):
            with self.assertRaises(ValueError):
                tetloft.Mesh(4, [[0, 1, 2, bad]])
        with self.assertRaises(tetloft.InvalidInput):
            tetloft.Mesh(4, [[0, 1, 2, 4]])
        with self.assertRaises(ValueError):
            tetloft.Mesh(4, [[0, 1, 2]])

    def test_may_be_empty(self):
        self.assertEqual(len(tetloft.Mesh(0, [])), 0)
        self.assertEqual(tetloft.Stack([(0, [[]])]).vertex_count, 0)
        self.assertEqual(len(tetloft.delaunay([])), 0)
        if numpy is not None:
            self.assertEqual(len(tetloft.delaunay(numpy.empty((0, 2))).triangles), 0)


if __name__ == "__main__":
    unittest.main()
