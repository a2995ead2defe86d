"""What belongs together: options, decisions of the user, and the links of a stack."""

from __future__ import annotations

import ctypes
import math
import os
from ctypes import c_size_t, c_uint32
from dataclasses import dataclass
from typing import Any, Iterable, Mapping, NamedTuple, Optional, Union

from . import _structs as structs
from ._arrays import Ids, view
from ._handles import Handle, Owner, Warnings
from ._library import _text, lib
from ._options import Path, choice, defaults, path_bytes, text, whole
from ._running import Progress, Run, Stop
from .formats import Data, Source, as_bytes, bytes_of, opened_file
from .stacks import Stack

Contour = tuple[int, int]
"""(section, contour)"""
Pair = tuple[int, Optional[int], Optional[int]]
"""(slab, contour of the section below, contour of the one above); of voids None: the exterior"""


class Labels(Owner):
    """What a user decides about contours, each named by zero-based ids.

    ``labels``, {(section, contour): label}: the same label, the same component; different ones,
    different components. ``join`` and ``part``: decisions on single links, (slab, lower contour,
    upper contour). ``hole_labels``, ``open`` and ``close``: the same of voids, which are named by
    the contours of their holes, None being the exterior.

    >>> print(Labels({(0, 0): 7, (1, 2): 7}, part=[(0, 0, 1)]).to_bytes().decode(), end="")
    0 0 7
    1 2 7
    part 0 0 1
    """

    def __init__(self, labels: Mapping[Contour, int] = {}, *, join: Iterable[Pair] = (),
                 part: Iterable[Pair] = (), hole_labels: Mapping[Contour, int] = {},
                 open: Iterable[Pair] = (), close: Iterable[Pair] = ()):
        handle = Handle("labels")
        arrays = (_labels(labels), _decisions(join, part), _labels(hole_labels),
                  _decisions(open, close))
        lib.tetloft_labels_create(*(part for made in arrays for part in (made, len(made))),
                                  handle.out)
        self._take(handle)

    def write(self, path: Path) -> None:
        """Writes a file of labels."""
        lib.tetloft_labels_write(self._open(), path_bytes(path))

    def to_bytes(self) -> bytes:
        """The bytes of such a file, lines "section contour label", "join section contour other"."""
        made = Handle("bytes")
        lib.tetloft_labels_format(self._open(), made.out)
        return bytes_of(made)

    def __repr__(self) -> str:
        if self.closed:
            return "<tetloft.Labels, closed>"
        return f"<tetloft.Labels of {self.to_bytes().count(10)} lines>"

    def __reduce__(self) -> Any:
        return parse_labels, (self.to_bytes(),)


def _id(value: Optional[int], what: str) -> int:
    return structs.NO_ID if value is None else whole(value, what, 0, structs.NO_ID - 1)


def _labels(labels: Mapping[Contour, int]) -> Any:
    made = [structs.Label(_id(section, "section"), _id(contour, "contour"),
                          _id(label, "label"))
            for (section, contour), label in labels.items()]
    return (structs.Label * len(made))(*made)


def _decisions(join: Iterable[Pair], part: Iterable[Pair]) -> Any:
    made = [structs.Decision(_id(slab, "slab"), _id(lower, "lower"), _id(upper, "upper"), joined)
            for joined, pairs in ((1, join), (0, part)) for slab, lower, upper in pairs]
    return (structs.Decision * len(made))(*made)


def read_labels(source: Source) -> Labels:
    """The labels of a file: a path, or a file opened for bytes."""
    opened = opened_file(source)
    if opened:
        return parse_labels(*opened)
    made = Handle("labels")
    lib.tetloft_labels_read(path_bytes(source), made.out)
    return Labels._of(made)


def parse_labels(data: Data, name: str = "") -> Labels:
    """The same from bytes; ``name`` stands for the file in messages."""
    made, given = Handle("labels"), as_bytes(data)
    lib.tetloft_labels_parse(given, len(given), text(name, "name"), made.out)
    return Labels._of(made)


LabelsLike = Union[Labels, Path, Mapping[Contour, int]]


@dataclass(frozen=True)
class Correspondence:
    """How it is found what belongs together; the rule in full is in include/tetloft, in
    correspondence.hpp and voids.hpp.

    A word as ``correspondence=`` is this with that criterion, and the rest by default.
    """

    criterion: str = "moved"
    """"moved", "overlap", or "reverse" (Definition 2 of Nonato et al. 2000)."""
    tau: Optional[float] = None
    """The threshold, in [0, 1); None: the criterion's default."""
    chain: bool = True
    """Oblique parts whose neighbouring sections do not overlap are followed."""
    lone: bool = True
    """A region that nothing else links belongs to what is nearest; not so for particles."""
    voids: str = "overlap"
    """"overlap", "near", or "free": nothing is decided about voids."""
    void_reach: Optional[float] = None
    """Of "near", in gaps between sections."""
    labels: Optional[LabelsLike] = None
    """:class:`Labels`, a file of them, or {(section, contour): label}."""


def correspondence_of(given: Union[str, Correspondence], labels: Optional[LabelsLike]) -> Any:
    """The struct, which keeps the labels alive."""
    rule = Correspondence(given) if isinstance(given, str) else given
    if not isinstance(rule, Correspondence):
        raise TypeError(f"correspondence: a word or a Correspondence is expected, not {given!r}")
    if labels is not None and rule.labels is not None:
        raise ValueError("labels are given twice, by themselves and by the correspondence")
    if rule.tau is not None and not rule.tau >= 0:
        raise ValueError(f"tau: {rule.tau} is not in [0, 1)")
    options = defaults(structs.Correspondence, "correspondence")
    options.criterion = choice(structs.CRITERION, rule.criterion, "correspondence")
    options.tau = -1 if rule.tau is None else rule.tau
    options.chain, options.lone = bool(rule.chain), bool(rule.lone)
    options.void_rule = choice(structs.VOIDS, rule.voids, "voids")
    if rule.void_reach is not None:
        options.void_reach = rule.void_reach
    chosen = rule.labels if labels is None else labels
    if chosen is not None:
        options.kept = _as_labels(chosen)._open()
        options.labels = options.kept._as_parameter_
    return ctypes.pointer(options)


def _as_labels(given: LabelsLike) -> Labels:
    if isinstance(given, Labels):
        return given
    if isinstance(given, (str, bytes, os.PathLike)):
        return read_labels(given)
    if not isinstance(given, Mapping):
        raise TypeError(f"labels: Labels, a path or a mapping is expected, not {given!r}")
    return Labels(given)


class Link(NamedTuple):
    """A link between two regions, or two voids, of neighbouring sections: made, or nearly so."""

    slab: int
    """Between sections ``slab`` and ``slab + 1``."""
    lower: Optional[int]
    """The outer contour of the region below; of voids that of the hole, None: the exterior."""
    upper: Optional[int]
    evidence: str
    """What it rests on: "overlap", "motion", "chain", "lone", "label", …"""
    fate: str
    """"made", or why not: "too_weak", "outruled", …"""
    ratio: float
    """How far the two overlap, 0 to 1."""
    moved: float
    """How far they overlap where they are moved."""
    distance: float
    """In gaps between sections."""
    margin: float
    """How far the decision was from going the other way; negative: it falls short."""
    lead: Optional[float]
    """Over the next best pair; None: there is none."""


@dataclass(frozen=True, eq=False)
class Links:
    """What belongs together in a stack, and how surely."""

    regions: list[Link]
    voids: list[Link]
    components: int
    """Parts that hang together."""
    cavities: int
    """Voids that nothing opens to the outside."""
    partition: list[Ids]
    """For each section the component of each of its contours."""
    warnings: tuple[str, ...]

    def __repr__(self) -> str:
        made = sum(link.fate == "made" for link in self.regions)
        return (f"<tetloft.Links: {made} of {len(self.regions)} made, "
                f"{self.components} components, {self.cavities} cavities>")


def links(stack: Stack, *, correspondence: Union[str, Correspondence] = "moved",
          labels: Optional[LabelsLike] = None, threads: int = 0,
          progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> Links:
    """What belongs together in a stack, link by link, without making the solid."""
    run, made, warnings = Run(threads, progress, stop), Handle("links"), Warnings()
    run.call(lib.tetloft_links_find, Stack._handle_of(stack, "stack"),
             correspondence_of(correspondence, labels), run.pointer, made.out, warnings.out)
    components, cavities = c_size_t(), c_size_t()
    lib.tetloft_links_counts(made, ctypes.byref(components), ctypes.byref(cavities))
    return Links(_links(lib.tetloft_links_regions, made), _links(lib.tetloft_links_voids, made),
                 components.value, cavities.value,
                 [_partition(made, section) for section in range(len(stack))], warnings.tell())


def _links(function: Any, made: Handle) -> list[Link]:
    array, count = ctypes.POINTER(structs.Link)(), c_size_t()
    function(made, ctypes.byref(array), ctypes.byref(count))
    return [_link(array[number]) for number in range(count.value)]


def _link(raw: Any) -> Link:
    return Link(raw.slab, None if raw.lower == structs.NO_ID else raw.lower,
                None if raw.upper == structs.NO_ID else raw.upper,
                _text(lib.tetloft_evidence_name(raw.evidence)),
                _text(lib.tetloft_fate_name(raw.fate)), raw.ratio, raw.moved, raw.distance,
                raw.margin, None if math.isnan(raw.lead) else raw.lead)


def _partition(made: Handle, section: int) -> Any:
    pointer, count = ctypes.POINTER(c_uint32)(), c_size_t()
    lib.tetloft_links_partition(made, section, ctypes.byref(pointer), ctypes.byref(count))
    return view(pointer, count.value, 1, made)
