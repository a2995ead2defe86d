"""What goes wrong, as exceptions with the place where it does.

Arguments that no call of the library could take (a shape, a word that is no choice, an object that
was closed) are ``ValueError``, ``TypeError`` and ``IndexError``, as everywhere in Python. What the
library refuses is an :class:`Error`.
"""

from __future__ import annotations

from typing import Any, NamedTuple, Optional


class Place(NamedTuple):
    """Where something is wrong; what is not known is None."""

    file: Optional[str] = None
    line: Optional[int] = None
    """One-based."""
    section: Optional[int] = None
    """Zero-based, like all below."""
    slab: Optional[int] = None
    """Between sections ``slab`` and ``slab + 1``."""
    contour: Optional[int] = None
    vertex: Optional[int] = None
    point: Optional[tuple[float, float, float]] = None
    """Coordinates x, y, z, in units of the input."""


class Error(Exception):
    """What the library refuses. ``str(error)`` is place and message in one line."""

    status = "unknown"
    """The name of the status, "invalid_input"."""
    code: int
    """Its number, which is the exit code of the command line."""
    message: str
    """Without the place."""
    place: Place

    def __init__(self, text: str, code: int = 0, message: str = "", place: Place = Place()):
        super().__init__(text)
        self.code = code
        self.message = message or text
        self.place = place
        self._text = text

    def __str__(self) -> str:
        return self._text

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self._text, self.code, self.message, self.place)


class UsageError(Error, ValueError):
    """Arguments that are missing, contradict each other, or are out of range."""

    status = "usage"


class InvalidInput(Error, ValueError):
    """The input is not a valid stack, mesh, label or point set."""

    status = "invalid_input"


class FileError(Error, OSError):
    """A file cannot be read or written."""

    status = "io"


class Unrepresentable(Error):
    """Double precision holds no valid model of this input."""

    status = "unrepresentable"


class Cancelled(Error):
    """Stopped by a :class:`tetloft.Stop`. (Ctrl-C is a KeyboardInterrupt, as everywhere; what a
    ``progress`` raises comes out as it is.)"""

    status = "cancelled"


class WorkLimit(Error):
    """More work than ``work_limit`` allows; a higher one may succeed."""

    status = "work_limit"


class BadHandle(Error, RuntimeError):
    """A handle that the library does not know: a defect of this package."""

    status = "bad_handle"


class TooSmall(Error, RuntimeError):
    """An array that does not hold the result: a defect of this package."""

    status = "too_small"


class InternalError(Error, RuntimeError):
    """A defect of the library."""

    status = "internal"


class OutOfMemory(Error, MemoryError):
    """Memory ended, or the system's limit on it; nothing is lost."""

    status = "out_of_memory"


class UnfitArithmetic(Error, RuntimeError):
    """The library was compiled, or runs, without the arithmetic that exactness needs."""

    status = "unfit_arithmetic"


class TetloftWarning(UserWarning):
    """Something that was mended, or that one should know."""


OF_STATUS: dict[str, type[Error]] = {
    kind.status: kind
    for kind in (
        UsageError,
        InvalidInput,
        FileError,
        Unrepresentable,
        Cancelled,
        WorkLimit,
        BadHandle,
        TooSmall,
        InternalError,
        OutOfMemory,
        UnfitArithmetic,
    )
}
