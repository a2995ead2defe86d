"""The five guarantees, checked on any model."""

from __future__ import annotations

import ctypes
from ctypes import c_char_p, c_int, c_size_t
from dataclasses import dataclass
from typing import Any, NamedTuple, Optional, Union

from . import _structs as structs
from ._handles import Handle
from ._library import _text, lib
from ._options import defaults, whole
from ._running import Progress, Run, Stop
from .correspondence import Correspondence, LabelsLike, correspondence_of
from .models import Model
from .stacks import Stack

_GUARANTEES = 5
_UNKNOWN = {"cavities": -1, "expected_cavities": -1, "least_genus": -(2**63),
            "most_genus": -(2**63)}


@dataclass(frozen=True)
class Failure:
    """A condition that fails."""

    what: str
    """The condition, with its number in src/check/README.md."""
    count: int
    """How often."""
    places: list[str]
    """The first few."""


@dataclass(frozen=True)
class Guarantee:
    """One of the five: manifold, re-sampling, embedded, components, cavities and tunnels."""

    number: int
    name: str
    passed: bool
    not_asked: str
    """Why it was not asked; empty if it was."""
    failures: list[Failure]

    def __str__(self) -> str:
        why = f"not asked: {self.not_asked}" if self.not_asked else "FAIL"
        word = "pass" if self.passed else why
        lines = [f"{self.number} {self.name}: {word}"]
        for failure in self.failures:
            lines.append(f"    {failure.what} ({failure.count}×)")
            lines += [f"        {place}" for place in failure.places]
        return "\n".join(lines)


class Figures(NamedTuple):
    """Figures beside the guarantees; None: not known."""

    components: int
    volume: float
    """In cubed units of the stack."""
    overshoot: float
    """How far the solid leaves both sections' regions sideways, in gaps."""
    smallest_dihedral_degrees: float
    largest_split_ulps: float
    """Of inserted vertices off their contour edge."""
    inner_vertices: int
    dropped_links: int
    cavities: Optional[int]
    expected_cavities: Optional[int]
    least_genus: Optional[int]
    """What the genus, summed over all surfaces, may be by the links."""
    most_genus: Optional[int]
    deviations: int
    forced_voids: int
    unrealisable_voids: int
    genus: list[int]
    """Of each boundary surface."""


@dataclass(frozen=True)
class Verdict:
    """What check() found: true iff all guarantees pass; ``print(verdict)`` tells all of it."""

    passed: bool
    guarantees: list[Guarantee]
    figures: Figures

    def __bool__(self) -> bool:
        return self.passed

    def __repr__(self) -> str:
        words = (f"{g.number} {'pass' if g.passed else 'not asked' if g.not_asked else 'FAIL'}"
                 for g in self.guarantees)
        return f"<tetloft.Verdict: {', '.join(words)}>"

    def __str__(self) -> str:
        figures = (f"{name}: {value}" for name, value in zip(self.figures._fields, self.figures))
        return "\n".join([*map(str, self.guarantees), *figures])


def check(model: Model, stack: Stack, *, correspondence: Union[str, Correspondence] = "moved",
          labels: Optional[LabelsLike] = None, split_ulps: Optional[float] = None, places: int = 5,
          recompute_motions: bool = False, strict: bool = False, threads: int = 0,
          progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> Verdict:
    """Whether a model, wherever it comes from, keeps the five guarantees on a stack.

    ``correspondence`` and ``labels`` as of the reconstruction. ``split_ulps``: how far an inserted
    vertex may lie off its contour edge; None: the library's. ``places``: how many are told of each
    failure. ``recompute_motions``: those of "moved" are estimated anew, not taken from the model.
    ``strict``: deviations that the model admits fail, too. A guarantee that fails is no error.

    >>> from tetloft import reconstruct
    >>> square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    >>> stack = Stack([(0, [square]), (5, [square])])
    >>> check(reconstruct(stack), stack)
    <tetloft.Verdict: 1 pass, 2 pass, 3 pass, 4 pass, 5 pass>
    """
    run, made = Run(threads, progress, stop), Handle("verdict")
    options = defaults(structs.CheckOptions, "check_options")
    options.correspondence = correspondence_of(correspondence, labels)
    if split_ulps is not None:
        options.split_ulps = split_ulps
    options.places = whole(places, "places", 0, 2**64 - 1)
    options.recompute_motions, options.strict = bool(recompute_motions), bool(strict)
    options.execution = run.pointer
    run.call(lib.tetloft_check, Model._handle_of(model, "model"),
             Stack._handle_of(stack, "stack"), ctypes.byref(options), made.out)
    passed = c_int()
    lib.tetloft_verdict_pass(made, ctypes.byref(passed))
    return Verdict(bool(passed.value), [_guarantee(made, 1 + i) for i in range(_GUARANTEES)],
                   _figures(made))


def _guarantee(verdict: Handle, number: int) -> Guarantee:
    name, passed, not_asked, failures = c_char_p(), c_int(), c_char_p(), c_size_t()
    lib.tetloft_verdict_guarantee(verdict, number, ctypes.byref(name), ctypes.byref(passed),
                                  ctypes.byref(not_asked), ctypes.byref(failures))
    return Guarantee(number, _text(name.value), bool(passed.value), _text(not_asked.value),
                     [_failure(verdict, number, failure) for failure in range(failures.value)])


def _failure(verdict: Handle, number: int, failure: int) -> Failure:
    what, count, places = c_char_p(), c_size_t(), c_size_t()
    lib.tetloft_verdict_failure(verdict, number, failure, ctypes.byref(what), ctypes.byref(count),
                                ctypes.byref(places))
    return Failure(_text(what.value), count.value,
                   [_place(verdict, number, failure, place) for place in range(places.value)])


def _place(verdict: Handle, number: int, failure: int, place: int) -> str:
    text = c_char_p()
    lib.tetloft_verdict_place(verdict, number, failure, place, ctypes.byref(text))
    return _text(text.value)


def _figures(verdict: Handle) -> Figures:
    raw = structs.Figures(version=structs.Figures.VERSION)
    lib.tetloft_verdict_figures(verdict, ctypes.byref(raw))
    genus, count = ctypes.POINTER(ctypes.c_int64)(), c_size_t()
    lib.tetloft_verdict_genus(verdict, ctypes.byref(genus), ctypes.byref(count))
    values: dict[str, Any] = {name: getattr(raw, name) for name in Figures._fields[:-1]}
    for name, unknown in _UNKNOWN.items():
        if values[name] == unknown:
            values[name] = None
    return Figures(**values, genus=genus[: count.value] if count.value else [])
