"""The shared library: where it is, and its functions, which raise what goes wrong.

It is looked for, in this order: where the environment variable TETLOFT_LIBRARY says (nowhere else
then); beside this file, as wheels have it; where the installation says that it put it
(_location.py, written by `cmake --install`); and by the system's loader.
"""

from __future__ import annotations

import ctypes
import os
import sys
from typing import Any, Optional

from . import _structs as structs
from ._signatures import FUNCTIONS, STATUS
from ._version import __version__
from .errors import OF_STATUS, Error, Place

_HERE = os.path.dirname(os.path.abspath(__file__))
_SERIES = ".".join(__version__.split(".")[:2])


def file_names() -> list[str]:
    """Of the library: as a wheel has it, and with the version of its interface."""
    if sys.platform == "win32":
        return ["tetloft.dll"]
    if sys.platform == "darwin":
        return ["libtetloft.dylib", f"libtetloft.{_SERIES}.dylib"]
    return ["libtetloft.so", f"libtetloft.so.{_SERIES}"]


def _installed() -> Optional[str]:
    try:
        from . import _location  # type: ignore[attr-defined]
    except ImportError:
        return None
    return os.path.normpath(os.path.join(_HERE, _location.LIBRARY))


def candidates() -> list[str]:
    """Where to look, in order; a name without folder is for the system's loader."""
    named = os.environ.get("TETLOFT_LIBRARY")
    if named:
        return [os.path.abspath(named)]
    beside = [os.path.join(_HERE, name) for name in file_names()]
    installed = _installed()
    return beside + ([installed] if installed else []) + file_names()[::-1]


def _open() -> tuple[ctypes.CDLL, str]:
    tried = []
    for candidate in candidates():
        if os.path.isabs(candidate) and not os.path.exists(candidate):
            tried.append(f"{candidate}: no such file")
            continue
        try:
            return ctypes.CDLL(candidate), candidate
        except OSError as reason:
            tried.append(f"{candidate}: {reason}")
    raise ImportError(
        "tetloft: its shared library was not found. Looked for:\n  "
        + "\n  ".join(tried)
        + "\nThe environment variable TETLOFT_LIBRARY may name it.",
        name="tetloft",
    )


def _unfit(path: str, why: str) -> ImportError:
    return ImportError(f"tetloft: the library {path} {why}", name="tetloft", path=path)


def _text(value: Optional[bytes]) -> str:
    return (value or b"").decode("utf-8", "replace")


def _place(library: Any) -> Place:
    raw = structs.Place(version=structs.Place.VERSION)
    library.tetloft_last_place(ctypes.byref(raw))
    parts = ("line", "section", "slab", "contour", "vertex")
    numbers = {name: getattr(raw, name) for name in parts}
    return Place(
        file=os.fsdecode(raw.file) if raw.file else None,
        point=(raw.point[0], raw.point[1], raw.point[2]) if raw.has_point else None,
        **{name: number for name, number in numbers.items() if number >= 0},
    )


def _failure(library: Any, status: int) -> Error:
    name = _text(library.tetloft_status_name(status))
    return OF_STATUS.get(name, Error)(
        _text(library.tetloft_last_error()),
        status,
        _text(library.tetloft_last_message()),
        _place(library),
    )


def _declare(library: Any, path: str) -> None:
    """Gives the functions their types, and lets a status that is none of success raise its error,
    which is read in the thread of the call."""

    def succeed(status: int, function: Any, arguments: Any) -> int:
        if status:
            raise _failure(library, status)
        return status

    for name, (result, arguments) in FUNCTIONS.items():
        try:
            function = getattr(library, name)
        except AttributeError:
            raise _unfit(path, f"has no function {name}: it is no shared library of this version") \
                from None
        function.restype, function.argtypes = result, arguments
        if result is STATUS and name != "tetloft_last_place":
            function.errcheck = succeed


def _load() -> tuple[Any, str]:
    library, path = _open()
    try:
        library.tetloft_version.restype = ctypes.c_char_p
        version = _text(library.tetloft_version())
    except AttributeError:
        raise _unfit(path, "is not a shared library of tetloft") from None
    if version.split(".")[:2] != __version__.split(".")[:2]:
        raise _unfit(path, f"is of version {version}, but the package of version {__version__}")
    _declare(library, path)
    return library, path


lib, library_path = _load()


def library_version() -> str:
    """Of the shared library that runs, "0.1.0"."""
    return _text(lib.tetloft_version())
