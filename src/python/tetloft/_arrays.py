"""Arrays in and out: NumPy's, where it is there, without copies; else lists.

What goes out is read only, and keeps its owner alive. What comes in may be anything that looks like
an array of numbers; it is copied only if it is not one of the right type, in one piece, aligned.
"""

from __future__ import annotations

import array
import ctypes
import importlib
import itertools
from typing import TYPE_CHECKING, Any, NamedTuple

numpy: Any = None
try:
    numpy = importlib.import_module("numpy")
    importlib.import_module("numpy.ctypeslib")  # at an interpreter's end nothing is imported
except ImportError:
    pass

if TYPE_CHECKING:
    from numpy import float64, int32, int64, uint8, uint32, uint64
    from numpy.typing import ArrayLike as ArrayLike
    from numpy.typing import NDArray

    # Without NumPy these are lists: of numbers, or of tuples where rows have several.
    Doubles = NDArray[float64]
    Ids = NDArray[uint32]
    Codes = NDArray[uint8]
    Integers = NDArray[int64]
    Vertices = NDArray[uint64]
    Shifts = NDArray[int32]
else:
    ArrayLike = Doubles = Ids = Codes = Integers = Vertices = Shifts = Any


def view(pointer: Any, rows: int, columns: int, owner: Any) -> Any:
    """``rows`` × ``columns`` numbers at ``pointer``, which are ``owner``'s: of one column flat."""
    kind = pointer._type_
    if rows == 0 or not pointer:
        return _none(columns, kind)
    memory = (kind * (rows * columns)).from_address(ctypes.addressof(pointer.contents))
    memory.owner = owner
    if numpy is not None:
        flat = numpy.frombuffer(memoryview(memory).toreadonly(), numpy.dtype(kind))
        return flat.reshape(_shape(rows, columns))
    return _rows(memory[:], columns)


def _shape(rows: int, columns: int) -> Any:
    return rows if columns == 1 else (rows, columns)


def _rows(flat: list[Any], columns: int) -> list[Any]:
    return flat if columns == 1 else list(zip(*[iter(flat)] * columns))


def _none(columns: int, kind: Any) -> Any:
    return [] if numpy is None else numpy.empty(_shape(0, columns), numpy.dtype(kind))


def filled(memory: Any, rows: int, columns: int = 1) -> Any:
    """The first rows of a ctypes array that the library has written into, which is kept."""
    if rows == 0:
        return _none(columns, memory._type_)
    if numpy is None:
        return _rows(memory[: rows * columns], columns)
    flat = numpy.frombuffer(memory, numpy.dtype(memory._type_), rows * columns)
    return flat.reshape(_shape(rows, columns))


class Input(NamedTuple):
    """Numbers for the library: kept by ``memory`` as long as this lives."""

    pointer: Any
    rows: int
    memory: Any


def doubles(value: Any, columns: int, what: str) -> Input:
    """Coordinates, (n, columns); an empty value of any shape is n = 0."""
    if numpy is not None:
        return _of_numpy(value, columns, what, numpy.float64, "fiub")
    return _of_lists(value, columns, what, "d", ctypes.c_double)


def ids(value: Any, columns: int, what: str) -> Input:
    """Integers from 0 to 2^32 - 1, (n, columns)."""
    if numpy is not None:
        return _of_numpy(value, columns, what, numpy.uint32, "iu")
    return _of_lists(value, columns, what, "I", ctypes.c_uint32)


def vertex_tuples(value: Any, columns: int, what: str) -> Input:
    """Vertices of a triangulation that changes, integers from 0 to 2^64 - 1, (n, columns)."""
    if numpy is not None:
        return _of_numpy(value, columns, what, numpy.uint64, "iu")
    return _of_lists(value, columns, what, "Q", ctypes.c_uint64)


def _of_numpy(value: Any, columns: int, what: str, kind: Any, accepted: str) -> Input:
    given = numpy.asarray(value)
    if given.size == 0:
        given = numpy.empty((0, columns), kind)
    if given.dtype.kind not in accepted:
        raise TypeError(f"{what}: numbers of type {given.dtype} are not accepted")
    if given.ndim != 2 or given.shape[1] != columns:
        raise ValueError(f"{what}: an array of shape (n, {columns}) is expected, not {given.shape}")
    if kind is not numpy.float64 and given.size:
        if given.min() < 0 or given.max() > numpy.iinfo(kind).max:
            raise ValueError(f"{what}: numbers are from 0 to 2^{8 * kind(0).itemsize} - 1")
    made = numpy.require(given, kind, ["C", "ALIGNED"])
    pointer = made.ctypes.data_as(ctypes.POINTER(numpy.ctypeslib.as_ctypes_type(kind)))
    return Input(pointer, len(made), made)


def _of_lists(value: Any, columns: int, what: str, code: str, kind: Any) -> Input:
    rows = value.tolist() if hasattr(value, "tolist") else list(value)
    for row in rows:
        if not hasattr(row, "__len__") or len(row) != columns:
            raise ValueError(f"{what}: rows of {columns} numbers are expected, not {row!r}")
    try:
        made = array.array(code, itertools.chain.from_iterable(rows))
    except OverflowError:
        bits = 8 * ctypes.sizeof(kind)
        raise ValueError(f"{what}: numbers are from 0 to 2^{bits} - 1") from None
    pointer = (kind * len(made)).from_buffer(made) if made else None
    return Input(pointer, len(rows), made)


def joined(parts: list[Input]) -> Input:
    """Coordinates one after the other, as one array."""
    if numpy is not None:
        made = numpy.concatenate([part.memory for part in parts] or [numpy.empty((0, 2))])
        return _of_numpy(made, 2, "vertices", numpy.float64, "f")
    flat = array.array("d", itertools.chain.from_iterable(part.memory for part in parts))
    pointer = (ctypes.c_double * len(flat)).from_buffer(flat) if flat else None
    return Input(pointer, len(flat) // 2, flat)
