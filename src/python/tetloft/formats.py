"""File formats, and points from files."""

from __future__ import annotations

import ctypes
import os
from typing import IO, Any, NamedTuple, Optional, Union

from . import _structs as structs
from ._arrays import ArrayLike, Doubles, doubles, view
from ._handles import Handle, Warnings
from ._library import _text, lib
from ._options import Path, path_bytes, read_options, text, write_options

Source = Union[Path, IO[bytes]]
Data = Union[bytes, bytearray, memoryview]


class Format(NamedTuple):
    """A file format."""

    name: str
    """For ``format=``."""
    summary: str
    extension: str
    """The usual one, with the dot."""
    reads: frozenset[str]
    """Of "stack", "model", "surface", "points", "labels", "lines"."""
    writes: frozenset[str]


def formats() -> list[Format]:
    """All formats, in the order in which contents are looked at.

    >>> [format.name for format in formats() if "surface" in format.writes]
    ['obj', 'ply', 'vtp', 'stl', 'off', '3mf', 'glb']
    """
    found = []
    for number in range(lib.tetloft_format_count()):
        raw = structs.Format(version=structs.Format.VERSION)
        lib.tetloft_format_info(number, ctypes.byref(raw))
        found.append(Format(_text(raw.name), _text(raw.summary), _text(raw.extension),
                            _contents(raw.reads), _contents(raw.writes)))
    return found


def _contents(bits: int) -> frozenset[str]:
    return frozenset(name for name, bit in structs.CONTENTS.items() if bits & bit)


class Description(NamedTuple):
    """What a stack or a model is of, beside its geometry; each "" where the file does not say."""

    name: str
    """Of the structure (ROI, object, segment, label)."""
    unit: str
    """Of length: "mm"."""
    orientation: str
    """Where x, y and z of the file's space grow towards in a body: "LPS", "RAS"."""


def description_of(function: Any, handle: Any) -> Description:
    texts = [ctypes.c_char_p() for _ in Description._fields]
    function(handle, *(ctypes.byref(each) for each in texts))
    return Description(*(_text(each.value) for each in texts))


def opened_file(source: Any) -> Optional[tuple[bytes, str]]:
    """Of an open file its bytes, and a name for messages; of a path None."""
    if isinstance(source, (str, bytes, os.PathLike)) or not hasattr(source, "read"):
        return None
    data = source.read()
    if isinstance(data, str):
        raise TypeError("a file opened for bytes (\"rb\") is expected, not one of text")
    name = getattr(source, "name", "")
    return data, name if isinstance(name, str) else ""


def as_bytes(data: Data) -> bytes:
    return data if isinstance(data, bytes) else bytes(data)


def bytes_of(handle: Handle) -> bytes:
    address, size = ctypes.c_void_p(), ctypes.c_size_t()
    lib.tetloft_bytes_data(handle, ctypes.byref(address), ctypes.byref(size))
    return ctypes.string_at(address, size.value) if size.value else b""


def format_bytes(function: Any, *arguments: Any) -> bytes:
    """What a format function writes; its warnings are told at the caller's caller."""
    made, warnings = Handle("bytes"), Warnings()
    function(*arguments, made.out, warnings.out)
    warnings.tell(4)
    return bytes_of(made)


def read_points(source: Source, *, format: Optional[str] = None) -> Doubles:
    """Points of a file, (n, 3), read only: text lines "x y z", or float64 triples (.bin).

    ``source`` is a path, or a file opened for bytes; the format is recognised, or named.
    """
    opened = opened_file(source)
    if opened:
        return parse_points(*opened, format=format)
    points, warnings = Handle("points"), Warnings()
    lib.tetloft_points_read(path_bytes(source), read_options(format), points.out, warnings.out)
    warnings.tell()
    return _view(points)


def parse_points(data: Data, name: str = "", *, format: Optional[str] = None) -> Doubles:
    """The same from bytes; ``name`` stands for the file in messages, and tells the extension.

    >>> [tuple(p) for p in parse_points(b"0 0 0\\n1 0 2.5\\n")] == [(0, 0, 0), (1, 0, 2.5)]
    True
    """
    points, warnings, given = Handle("points"), Warnings(), as_bytes(data)
    lib.tetloft_points_parse(given, len(given), text(name, "name"), read_options(format),
                             points.out, warnings.out)
    warnings.tell()
    return _view(points)


def _view(points: Handle) -> Any:
    pointer, count = ctypes.POINTER(ctypes.c_double)(), ctypes.c_size_t()
    lib.tetloft_points_data(points, ctypes.byref(pointer), ctypes.byref(count))
    return view(pointer, count.value, 3, points)


def write_points(path: Path, points: ArrayLike, *, format: Optional[str] = None,
                 ascii: bool = False) -> None:
    """Writes points, (n, 3), in the format of the extension, or the one named."""
    given, warnings = doubles(points, 3, "points"), Warnings()
    lib.tetloft_points_write(given.pointer, given.rows, path_bytes(path),
                             write_options(format, ascii), warnings.out)
    warnings.tell()


def format_points(points: ArrayLike, format: str, *, ascii: bool = False) -> bytes:
    """The bytes of such a file."""
    given = doubles(points, 3, "points")
    return format_bytes(lib.tetloft_points_format, given.pointer, given.rows,
                        write_options(format, ascii))
