"""Handles of the library: given back when nothing refers to them, nor to arrays on their memory."""

from __future__ import annotations

import ctypes
import warnings
from types import TracebackType
from typing import Any, Optional, TypeVar

from ._arrays import view
from ._library import _text, lib
from .errors import TetloftWarning

Self = TypeVar("Self", bound="Owner")


class Handle:
    """What a function of the library makes: put in by ``out``, freed with its last reference."""

    __slots__ = ("_value", "_free", "__weakref__")

    def __init__(self, kind: str):
        self._value = ctypes.c_void_p()
        self._free = getattr(lib, f"tetloft_{kind}_free")

    @property
    def _as_parameter_(self) -> ctypes.c_void_p:
        return self._value

    @property
    def out(self) -> Any:
        return ctypes.byref(self._value)

    def __del__(self) -> None:
        if self._value:
            self._free(self._value)


class Warnings(Handle):
    """Of one call; texts() once it was made."""

    __slots__ = ()

    def __init__(self) -> None:
        super().__init__("warnings")

    def texts(self) -> tuple[str, ...]:
        if not self._value:
            return ()
        count = ctypes.c_size_t()
        lib.tetloft_warnings_count(self, ctypes.byref(count))
        return tuple(self._text(index) for index in range(count.value))

    def _text(self, index: int) -> str:
        text = ctypes.c_char_p()
        lib.tetloft_warnings_text(self, index, ctypes.byref(text))
        return _text(text.value)

    def tell(self, stacklevel: int = 3) -> tuple[str, ...]:
        """As warnings of Python, at the line that called the function that calls this."""
        texts = self.texts()
        for text in texts:
            warnings.warn(text, TetloftWarning, stacklevel=stacklevel)
        return texts


class Owner:
    """An object of the library.

    It never changes. It is freed when nothing refers to it, neither this object nor an array that
    came from it; ``close()``, or the end of a ``with`` block, lets go of it earlier. Copies share
    it.
    """

    warnings: tuple[str, ...] = ()
    """What was said when it was made, place and message in one line each."""

    _handle: Optional[Handle] = None
    _arrays: dict[str, Any]

    @classmethod
    def _of(cls: type[Self], handle: Handle, warnings: tuple[str, ...] = ()) -> Self:
        made = cls.__new__(cls)
        made._take(handle, warnings)
        return made

    def _take(self, handle: Handle, warnings: tuple[str, ...] = ()) -> None:
        self._handle = handle
        self._arrays = {}
        self.warnings = warnings

    def _open(self) -> Handle:
        if self._handle is None:
            raise ValueError(f"this {type(self).__name__} is closed")
        return self._handle

    def _array(self, name: str, columns: int = 1, parts: int = 1) -> Any:
        """What the function of that name tells, kept: its count in ``parts`` of a row."""
        handle = self._open()
        if name not in self._arrays:
            function = getattr(lib, name)
            pointer = function.argtypes[1]._type_()
            count = ctypes.c_size_t()
            function(handle, ctypes.byref(pointer), ctypes.byref(count))
            self._arrays[name] = view(pointer, count.value // parts, columns, handle)
        return self._arrays[name]

    @classmethod
    def _handle_of(cls, given: Any, what: str) -> Handle:
        """Of an argument that should be one of these."""
        if not isinstance(given, cls):
            raise TypeError(f"{what}: a tetloft.{cls.__name__} is expected, not {given!r:.80}")
        return given._open()

    @property
    def closed(self) -> bool:
        """Whether close() was called."""
        return self._handle is None

    def close(self) -> None:
        """Lets go of the memory. Arrays that were taken stay valid, and keep it as long as they
        live; whatever else is asked of this object raises ValueError."""
        self._handle = None
        self._arrays = {}

    def __enter__(self: Self) -> Self:
        self._open()
        return self

    def __exit__(self, kind: Optional[type[BaseException]], reason: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self.close()

    def __copy__(self: Self) -> Self:
        copied = type(self).__new__(type(self))
        copied.__dict__.update(self.__dict__)
        copied._arrays = dict(self._arrays)
        return copied

    def __deepcopy__(self: Self, memo: dict[int, Any]) -> Self:
        return self.__copy__()

    def __reduce__(self) -> Any:
        raise TypeError(f"cannot pickle a {type(self).__name__}")
