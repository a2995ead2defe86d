"""Calls that take long: with progress, a stop button, and Ctrl-C.

A signal's handler, and so KeyboardInterrupt, comes to life in the main thread alone, and not while
it is inside the library. So a call of the main thread is made by a thread of its own, while the
main one waits; any exception that ends the waiting presses the stop, and is raised again once the
call has ended. Other threads call directly.
"""

from __future__ import annotations

import ctypes
import sys
import threading
from typing import Any, Callable, Optional

from . import _structs as structs
from ._handles import Handle
from ._library import lib
from ._options import defaults, whole
from .errors import Cancelled

Progress = Callable[[int, int], Any]


class _Button(Handle):
    """The stop of one call."""

    __slots__ = ()

    def __init__(self) -> None:
        super().__init__("stop")
        lib.tetloft_stop_create(self.out)

    def press(self) -> None:
        lib.tetloft_stop_request(self)


class Stop:
    """A stop button for long calls: ``request()``, from any thread, ends those it was given to with
    :class:`Cancelled`. It stays pressed."""

    def __init__(self) -> None:
        self._lock = threading.RLock()  # request() may be called by a signal's handler
        self._buttons: list[_Button] = []
        self._requested = False

    @property
    def requested(self) -> bool:
        """Whether it was pressed."""
        return self._requested

    def request(self) -> None:
        """Presses it."""
        with self._lock:
            self._requested = True
            for button in self._buttons:
                button.press()

    def _add(self, button: _Button) -> None:
        with self._lock:
            self._buttons.append(button)
            if self._requested:
                button.press()

    def _remove(self, button: _Button) -> None:
        with self._lock:
            self._buttons.remove(button)

    def __repr__(self) -> str:
        return f"<tetloft.Stop{', pressed' if self._requested else ''}>"


class Run:
    """How one call of the library runs: ``pointer`` is its tetloft_execution."""

    def __init__(self, threads: int, progress: Optional[Progress], stop: Optional[Stop]):
        self._stop = Stop() if stop is None else stop
        if not isinstance(self._stop, Stop):
            raise TypeError(f"stop: a tetloft.Stop is expected, not {stop!r}")
        self._button = _Button()
        self._raised: list[BaseException] = []
        self._execution = defaults(structs.Execution, "execution")
        self._execution.threads = whole(threads, "threads", 0, 2**32 - 1)
        self._execution.stop = self._button._as_parameter_
        if progress is not None:
            if not callable(progress):
                raise TypeError(f"progress: {progress!r} cannot be called")
            self._execution.progress = _callback(progress, self._raised)

    @property
    def pointer(self) -> Any:
        return ctypes.pointer(self._execution)

    def call(self, function: Any, *arguments: Any) -> None:
        self._stop._add(self._button)
        try:
            # No thread begins where the interpreter is ending, as in a finalizer that runs late.
            if threading.current_thread() is threading.main_thread() and not sys.is_finalizing():
                _call_beside(lambda: function(*arguments), self._button.press)
            else:
                function(*arguments)
        except Cancelled:
            if not self._raised:
                raise
        finally:
            self._stop._remove(self._button)
        if self._raised:
            raise self._raised.pop()


def _callback(progress: Progress, raised: list[BaseException]) -> Any:
    def tell(user: Any, done: int, all: int) -> int:
        if raised:
            return 1
        try:
            progress(done, all)
        except BaseException as reason:  # raised again by Run.call
            raised.append(reason)
            return 1
        return 0

    return structs.Progress(tell)


def _call_beside(call: Callable[[], None], press: Callable[[], None]) -> None:
    """Makes the call in another thread, and waits for its end; what interrupts the waiting presses
    the stop, and is what is raised then."""
    go, given_up, ended = threading.Event(), threading.Event(), threading.Event()
    raised: list[BaseException] = []
    interrupted: list[BaseException] = []

    def work() -> None:
        go.wait()
        try:
            if not given_up.is_set():
                call()
        except BaseException as reason:
            raised.append(reason)
        finally:
            ended.set()

    # No daemon: where it is still in the library, the interpreter must not end before it.
    worker, begun = threading.Thread(target=work, name="tetloft"), False
    while not ended.is_set():
        try:
            if not begun:
                worker.start()
                begun = True
            go.set()
            ended.wait()
        except BaseException as reason:
            if not begun:  # start() waits, too; whether there is a thread or not, it does nothing
                given_up.set()
                go.set()
                raise
            interrupted.append(reason)
            press()
    if interrupted:
        raise interrupted.pop(0)
    if raised:
        raise raised.pop()
