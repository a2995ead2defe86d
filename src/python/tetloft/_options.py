"""Options as the library takes them: words for choices, numbers in their range, texts as bytes."""

from __future__ import annotations

import ctypes
import operator
import os
from typing import Any, Optional, Union

from . import _structs as structs
from ._library import lib

Path = Union[str, "os.PathLike[str]", bytes, "os.PathLike[bytes]"]


def choice(table: dict[str, int], word: str, what: str) -> int:
    if word not in table:
        raise ValueError(f"{what}={word!r}: one of {', '.join(table)} is expected")
    return table[word]


def whole(value: Any, what: str, low: int = 0, high: int = 2**31 - 1) -> int:
    """An integer in the range; ctypes would cut off what is outside."""
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{what}: an integer is expected, not {value!r}") from None
    if not low <= number <= high:
        raise ValueError(f"{what}: {number} is not between {low} and {high}")
    return number


def index(value: Any, count: int, what: str) -> int:
    """An index as Python has them, negative ones from the end."""
    number = operator.index(value)
    if not -count <= number < count:
        raise IndexError(f"{what} {number} of {count}")
    return number + count if number < 0 else number


def text(value: str, what: str) -> bytes:
    encoded = value.encode("utf-8")
    if b"\0" in encoded:
        raise ValueError(f"{what}: a zero byte in {value!r}")
    return encoded


def path_bytes(path: Any) -> bytes:
    """Of a Path; what is none is a TypeError."""
    encoded = os.fsencode(path)
    if b"\0" in encoded:
        raise ValueError(f"a zero byte in the path {path!r}")
    return encoded


def defaults(kind: Any, name: str) -> Any:
    options = kind()
    getattr(lib, f"tetloft_{name}_defaults")(ctypes.byref(options))
    return options


def read_options(format: Optional[str], validate: bool = True) -> Any:
    options = defaults(structs.ReadOptions, "read_options")
    options.unchecked = not validate
    if format is not None:
        options.format = text(format, "format")
    return ctypes.byref(options)


def write_options(format: Optional[str], ascii: bool, compress: bool = False) -> Any:
    if ascii and compress:
        raise ValueError("ascii, compress: one or the other")
    options = defaults(structs.WriteOptions, "write_options")
    options.ascii = 2 if compress else bool(ascii)
    if format is not None:
        options.format = text(format, "format")
    return ctypes.byref(options)
