"""From stacks to solids."""

from __future__ import annotations

import ctypes
from typing import Any, NamedTuple, Optional, Union

from . import _structs as structs
from ._handles import Handle, Warnings
from ._library import lib
from ._options import choice, defaults, whole
from ._running import Progress, Run, Stop
from .correspondence import Correspondence, Labels, LabelsLike, correspondence_of
from .models import Model
from .stacks import Stack


def _options(correspondence: Union[str, Correspondence], labels: Optional[LabelsLike],
             between: Optional[int], divide_coarse: bool, work_limit: Optional[float],
             run: Run) -> Any:
    options = defaults(structs.ReconstructOptions, "reconstruct_options")
    options.correspondence = correspondence_of(correspondence, labels)
    options.between = -1 if between is None else whole(between, "between", 0, 2**63 - 1)
    options.divide_coarse = bool(divide_coarse)
    if work_limit is not None:
        options.work_limit = work_limit
    options.execution = run.pointer
    return options


def reconstruct(stack: Stack, *, between: Optional[int] = None, ends: str = "flat",
                correspondence: Union[str, Correspondence] = "moved",
                labels: Optional[LabelsLike] = None, thickness: Optional[float] = None,
                divide_coarse: bool = True, work_limit: Optional[float] = None,
                engine: str = "automatic", threads: int = 0,
                progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> Model:
    """The solid of a stack, which keeps the five guarantees, or an :class:`Error` that says why.

    between: how many sections are put between two neighbouring given ones, interpolated; None: as
        many as gaps and contours call for.
    ends: "flat", at the first and last section, or "half", half a gap beyond.
    correspondence: what belongs together, "moved", "overlap", "reverse", or a
        :class:`Correspondence`; labels: of contours, see :class:`Labels`.
    thickness: of a single section, in units of the stack; None: a tenth of its larger side.
    divide_coarse: divide long edges of contours of few vertices.
    work_limit: the most work of a section or slab, in tets per vertex; beyond it
        :class:`WorkLimit`. None: the library's; math.inf: none.
    engine: that triangulates, "automatic", "incremental", "slab"; the solid is the same.
    threads: 0: as many as the machine offers; the solid does not depend on them.
    progress: called with steps done and in all, from any thread; what it raises stops the run, and
        is raised here.
    stop: a button that ends the run with :class:`Cancelled`.

    Warnings come as :class:`TetloftWarning`, and as ``warnings`` of the model.

    >>> square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    >>> solid = reconstruct(Stack([(0, [square]), (5, [square])]))
    >>> solid.volume
    80.0
    """
    if thickness is not None and not thickness > 0:
        raise ValueError(f"thickness: {thickness} is not above 0")
    run = Run(threads, progress, stop)
    options = _options(correspondence, labels, between, divide_coarse, work_limit, run)
    options.ends = choice(structs.ENDS, ends, "ends")
    options.engine = choice(structs.ENGINE, engine, "engine")
    options.thickness = 0 if thickness is None else thickness
    made, warnings = Handle("model"), Warnings()
    run.call(lib.tetloft_reconstruct, Stack._handle_of(stack, "stack"), ctypes.byref(options), made.out, warnings.out)
    return Model._of(made, warnings.tell())


class LongStack(NamedTuple):
    """A stack with the sections that were put between the given ones."""

    stack: Stack
    correspondence: Correspondence
    """By it, with ``between=0``, the longer stack has the components and voids of the given one."""
    decisions: Labels
    """The decisions that this correspondence has, on all links."""


def between(stack: Stack, *, sections: Optional[int] = None,
            correspondence: Union[str, Correspondence] = "moved",
            labels: Optional[LabelsLike] = None, divide_coarse: bool = True,
            work_limit: Optional[float] = None, threads: int = 0,
            progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> LongStack:
    """The stack with the sections that :func:`reconstruct` puts between the given ones, which stay
    as they are; arguments as there, ``sections`` being its ``between``.

    >>> square, small = [(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (3, 1), (3, 3), (1, 3)]
    >>> between(Stack([(0, [square]), (4, [small])]), sections=1).stack.z
    [0.0, 2.0, 4.0]
    """
    run, made, decisions, warnings = (Run(threads, progress, stop), Handle("stack"),
                                      Handle("labels"), Warnings())
    options = _options(correspondence, labels, sections, divide_coarse, work_limit, run)
    run.call(lib.tetloft_between, Stack._handle_of(stack, "stack"), ctypes.byref(options), made.out, decisions.out,
             warnings.out)
    given = Correspondence(correspondence) if isinstance(correspondence, str) else correspondence
    decided = Labels._of(decisions)
    rule = Correspondence("overlap", chain=False, lone=False, labels=decided,
                          voids="free" if given.voids == "free" else "overlap")
    return LongStack(Stack._of(made, warnings.tell()), rule, decided)
