"""Stacks of sections: the input."""

from __future__ import annotations

import ctypes
from ctypes import c_double, c_size_t
from typing import TYPE_CHECKING, Any, Iterable, Iterator, NamedTuple, Optional

from . import _structs as structs
from ._arrays import ArrayLike, Doubles, Ids, Input, doubles, filled, joined, view
from ._handles import Handle, Owner, Warnings
from ._library import lib
from ._options import (
    Path, choice, defaults, index, path_bytes, text, whole, write_options
)
from ._running import Progress, Run, Stop
from .formats import (
    Data, Description, Source, as_bytes, description_of, format_bytes, opened_file
)
from .meshes import Triangulation

if TYPE_CHECKING:
    from .correspondence import Labels


class Section(NamedTuple):
    """A plane with its contours."""

    z: float
    contours: list[Doubles]
    """(n, 2) each, x and y, read only; the first vertex is not repeated at the end."""


class Nesting(NamedTuple):
    """How the contours of a section lie in each other, one entry for each contour."""

    parent: Ids
    """The innermost contour around it, NO_ID without one."""
    depth: Ids
    """How many are around it; odd: it is a hole."""
    region: Ids
    """The region that it bounds."""
    regions: int
    """How many there are."""


class Repair(NamedTuple):
    """What a repair did to a stack."""

    moved: float
    """How far the boundary moved at most."""
    area_before: float
    """Of the region by the fill rule, summed over sections."""
    area_after: float
    copies: int
    """Contours left out, for they repeat another."""
    channels: int
    """Closed."""
    lost: int
    """Contours of which nothing is left: warnings name them."""
    area_lost: float
    """That these bounded."""


class Stack(Owner):
    """Sections by increasing z, of closed contours.

    ``sections``: pairs (z, contours), the contours (n, 2) arrays, or anything like it, of x and y,
    which may run either way round; what lies inside an odd number of them is solid. Lengths are in
    whatever unit you like, the same for all three coordinates. Nothing is refused here but shapes:
    functions that need a valid stack check it (see :meth:`validate`, :meth:`repair`).

    A sequence of :class:`Section`: ``len(stack)``, ``stack[i]``, ``for z, contours in stack``.

    >>> square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    >>> stack = Stack([(0, [square]), (5, [square])])
    >>> stack
    <tetloft.Stack of 2 sections, 2 contours, 8 vertices>
    >>> stack[1].z
    5.0
    """

    labels: Optional[Labels] = None
    """That the file gives its contours."""
    repaired: Optional[Repair] = None
    """Of a stack that :meth:`repair` made: what it did."""

    def __init__(self, sections: Iterable[tuple[float, Iterable[ArrayLike]]]):
        z: list[float] = []
        contour_counts: list[int] = []
        contours: list[Input] = []
        for height, given in sections:
            where = f"section {len(z)}, contour"
            made = [doubles(c, 2, f"{where} {i}") for i, c in enumerate(given)]
            z.append(float(height))
            contour_counts.append(len(made))
            contours += made
        self._create(z, contour_counts, [contour.rows for contour in contours], joined(contours))

    def _create(self, z: list[float], contour_counts: list[int], vertex_counts: list[int],
                vertices: Input) -> None:
        handle = Handle("stack")
        lib.tetloft_stack_create((c_double * len(z))(*z), (c_size_t * len(z))(*contour_counts),
                                 len(z), (c_size_t * len(vertex_counts))(*vertex_counts),
                                 len(vertex_counts), vertices.pointer, vertices.rows, handle.out)
        self._take(handle)

    # --- what it holds ---------------------------------------------------------------------------

    def _counts(self) -> tuple[int, int, int]:
        counts = (c_size_t(), c_size_t(), c_size_t())
        lib.tetloft_stack_counts(self._open(), *map(ctypes.byref, counts))
        return counts[0].value, counts[1].value, counts[2].value

    def __len__(self) -> int:
        return self._counts()[0]

    @property
    def contour_count(self) -> int:
        """Of all sections."""
        return self._counts()[1]

    @property
    def vertex_count(self) -> int:
        """Of all contours."""
        return self._counts()[2]

    def _section(self, section: int) -> tuple[float, int]:
        z, contours = c_double(), c_size_t()
        lib.tetloft_stack_section(self._open(), section, ctypes.byref(z), ctypes.byref(contours))
        return z.value, contours.value

    @property
    def z(self) -> list[float]:
        """The height of each section."""
        return [self._section(section)[0] for section in range(len(self))]

    def __getitem__(self, section: int) -> Section:
        section = index(section, len(self), "section")
        z, contours = self._section(section)
        return Section(z, [self._contour(section, contour) for contour in range(contours)])

    def __iter__(self) -> Iterator[Section]:
        return (self[section] for section in range(len(self)))

    def contour(self, section: int, contour: int) -> Doubles:
        """One contour, (n, 2), read only."""
        section = index(section, len(self), "section")
        return self._contour(section, index(contour, self._section(section)[1], "contour"))

    def _contour(self, section: int, contour: int) -> Doubles:
        handle = self._open()
        pointer, count = ctypes.POINTER(c_double)(), c_size_t()
        lib.tetloft_stack_contour(handle, section, contour, ctypes.byref(pointer),
                                  ctypes.byref(count))
        return view(pointer, count.value, 2, handle)

    def twice_area(self, section: int, contour: int) -> float:
        """Twice the signed area of a contour, positive if it runs counter-clockwise."""
        section = index(section, len(self), "section")
        area = c_double()
        lib.tetloft_stack_twice_area(self._open(), section,
                                     index(contour, self._section(section)[1], "contour"),
                                     ctypes.byref(area))
        return area.value

    def nesting(self, section: int) -> Nesting:
        """How the contours of a section lie in each other."""
        section = index(section, len(self), "section")
        room = self._section(section)[1]
        arrays = [(ctypes.c_uint32 * room)() for _ in range(3)]
        contours, regions = c_size_t(), c_size_t()
        lib.tetloft_stack_nesting(self._open(), section, *arrays, room, ctypes.byref(contours),
                                  ctypes.byref(regions))
        parent, depth, region = (filled(made, contours.value) for made in arrays)
        return Nesting(parent, depth, region, regions.value)

    def triangulate(self, section: int, *, threads: int = 0, progress: Optional[Progress] = None,
                    stop: Optional[Stop] = None) -> Triangulation:
        """The conforming Delaunay triangulation of a section: its contours are unions of edges."""
        section = index(section, len(self), "section")
        run, made = Run(threads, progress, stop), Handle("triangulation")
        run.call(lib.tetloft_stack_triangulate, self._open(), section, run.pointer, made.out)
        return Triangulation._of(made)

    def __repr__(self) -> str:
        if self.closed:
            return "<tetloft.Stack, closed>"
        sections, contours, vertices = self._counts()
        return (f"<tetloft.Stack of {sections} sections, {contours} contours, "
                f"{vertices} vertices>")

    # --- whether it is valid, and making it so ---------------------------------------------------

    def validate(self, *, threads: int = 0, progress: Optional[Progress] = None,
                 stop: Optional[Stop] = None) -> None:
        """Raises :class:`InvalidInput`, which names section, contour and vertex, unless sections
        rise, coordinates are finite, and contours are simple and meet nowhere."""
        run = Run(threads, progress, stop)
        run.call(lib.tetloft_stack_validate, self._open(), run.pointer)

    def repair(self, distance: Optional[float] = None, *, fill: str = "odd",
               keyholes: Optional[float] = None, threads: int = 0,
               progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> Stack:
        """A valid stack instead of one that crosses or touches itself, or has spikes.

        The boundary may move by ``distance``, in units of the stack; by default 2^-20 of the
        largest coordinate of a section. ``fill`` says which points make up the region where
        contours overlap: "odd" (those inside an odd number of contours), "union" (traces that
        overlap are united, contours wholly inside others stay holes) or "winding" (those that the
        contours wind around; holes must run the other way). Copies of contours are left out.
        Channels up to ``keyholes`` wide, by which tools cut holes to the outline, are closed. All
        that was changed is told by ``warnings`` of the new stack, its sum by ``repaired``.

        >>> traces = [[(0, 0), (2, 0), (2, 2), (0, 2)], [(1, 1), (3, 1), (3, 3), (1, 3)]]
        >>> Stack([(0, traces)]).repair(fill="union").repaired.area_after
        7.0
        """
        for name, length in (("distance", distance), ("keyholes", keyholes)):
            if length is not None and not length > 0:
                raise ValueError(f"{name}: {length} is not above 0")
        run, made, changes = Run(threads, progress, stop), Handle("stack"), Warnings()
        options = defaults(structs.RepairOptions, "repair_options")
        options.fill = choice(structs.FILL, fill, "fill")
        if distance is not None:
            options.distance = distance
        if keyholes is not None:
            options.keyholes = keyholes
        options.execution = run.pointer
        raw = structs.RepairReport(version=structs.RepairReport.VERSION)
        run.call(lib.tetloft_stack_repair_by, self._open(), ctypes.byref(options), made.out,
                 ctypes.byref(raw), changes.out)
        stack = Stack._of(made, changes.texts())
        stack.repaired = Repair(*(getattr(raw, name) for name in Repair._fields))
        return stack

    def arrange(self, rule: str = "sort", *, tolerance: Optional[float] = None) -> Stack:
        """The sections in the order of their planes: "sort" (by z, those of one z made one), "flip"
        (a stack that descends is turned over) or "merge" (sort, and those at most ``tolerance``
        apart made one). Which were made one is told by ``warnings``."""
        if (rule == "merge") != (tolerance is not None):
            raise ValueError("tolerance: merge takes one, the other rules none")
        made, changes = Handle("stack"), Warnings()
        lib.tetloft_stack_arrange_planes(self._open(), choice(structs.PLANES, rule, "rule"),
                                         0.0 if tolerance is None else tolerance, made.out,
                                         changes.out)
        return Stack._of(made, changes.texts())

    def snap(self, bits: int, *, threads: int = 0, progress: Optional[Progress] = None,
             stop: Optional[Stop] = None) -> Stack:
        """x and y rounded to 2^-bits of the largest coordinate, or finer where contours touch."""
        run, made = Run(threads, progress, stop), Handle("stack")
        run.call(lib.tetloft_stack_snap, self._open(), whole(bits, "bits", -(2**31)), run.pointer,
                 made.out)
        return Stack._of(made)

    def refine(self, length: float, *, threads: int = 0, progress: Optional[Progress] = None,
               stop: Optional[Stop] = None) -> Stack:
        """Contour edges longer than ``length``, in units of the stack, divided into equal parts."""
        run, made = Run(threads, progress, stop), Handle("stack")
        run.call(lib.tetloft_stack_refine, self._open(), length, run.pointer, made.out)
        return Stack._of(made)

    # --- files -----------------------------------------------------------------------------------

    @property
    def description(self) -> Description:
        """What the file that it came from says of it."""
        return description_of(lib.tetloft_stack_description, self._open())

    def write(self, path: Path, *, format: Optional[str] = None, ascii: bool = False) -> None:
        """Writes a file in the format of the extension, or the one named."""
        warnings = Warnings()
        lib.tetloft_stack_write(self._open(), path_bytes(path), write_options(format, ascii),
                                warnings.out)
        warnings.tell()

    def to_bytes(self, format: str = "cnt", *, ascii: bool = False) -> bytes:
        """The bytes of such a file."""
        return format_bytes(lib.tetloft_stack_format, self._open(), write_options(format, ascii))

    def __reduce__(self) -> Any:
        sections = list(self)
        contours = [doubles(contour, 2, "") for section in sections for contour in section.contours]
        return _unpickled, (
            [section.z for section in sections],
            [len(section.contours) for section in sections],
            [contour.rows for contour in contours],
            bytes(memoryview(joined(contours).memory)),
            self.warnings,
        )


def _unpickled(z: list[float], contour_counts: list[int], vertex_counts: list[int], xy: bytes,
               warnings: tuple[str, ...]) -> Stack:
    stack = Stack.__new__(Stack)
    rows = memoryview(xy).cast("d", (len(xy) // 16, 2)) if xy else []
    stack._create(z, contour_counts, vertex_counts, doubles(rows, 2, "vertices"))
    stack.warnings = warnings
    return stack


_READING = frozenset({
    "format", "validate", "structure", "iso", "lattice", "axis", "property", "plane_tolerance",
    "close_on_frame", "threads", "progress", "stop",
})


class _Read:
    """A stack on its way from the library."""

    def __init__(self, given: dict[str, Any]) -> None:
        unknown = sorted(set(given) - _READING)
        if unknown:
            raise TypeError(f"there is no option {unknown[0]!r} of reading")
        self.run = Run(given.get("threads", 0), given.get("progress"), given.get("stop"))
        self.stack, self.labels, self.warnings = Handle("stack"), Handle("labels"), Warnings()
        self.options = options = defaults(structs.StackOptions, "stack_options")
        options.unchecked = not given.get("validate", True)
        for name, value in (("format", given.get("format")), ("property", given.get("property")),
                            ("structure", given.get("structure"))):
            if value is not None:
                setattr(options, name, text(str(value), name))
        iso = given.get("iso")
        if iso is not None:
            options.has_iso, options.iso = 1, iso
        options.lattice = bool(given.get("lattice", False))
        axis = given.get("axis")
        if axis is not None:
            options.axis = whole(axis, "axis", 0, 2) + 1
        tolerance = given.get("plane_tolerance")
        if tolerance is not None:
            if not tolerance > 0:
                raise ValueError(f"plane_tolerance: {tolerance} is not above 0")
            options.plane_tolerance = tolerance
        options.close_on_frame = bool(given.get("close_on_frame", False))
        options.execution = self.run.pointer

    def call(self, function: Any, *source: Any) -> Stack:
        from .correspondence import Labels

        self.run.call(function, *source, ctypes.byref(self.options), self.stack.out,
                      self.labels.out, self.warnings.out)
        labels = Labels._of(self.labels)
        stack = Stack._of(self.stack, self.warnings.tell(4))
        if labels.to_bytes():
            stack.labels = labels
        return stack


def read_stack(source: Source, **options: Any) -> Stack:
    """The stack of a file: a path, or a file opened for bytes.

    Options, all by keyword: ``format``, by name, or it is recognised; ``validate=False`` takes a
    stack that is not valid, to be repaired; ``structure``, of a file with several ROIs, objects or
    labels the one of this name or number; of a volume ``iso``, for the region where values are at
    least this, ``lattice=True`` for contours along the faces of voxels, ``axis``, the index axis (0
    to 2) across which sections are taken; ``property``, of GeoJSON the height; ``plane_tolerance``:
    contours whose heights differ by at most this are one section; ``close_on_frame=True``: open
    lines that end at the rectangle around all lines are closed along it; ``threads``, ``progress``,
    ``stop``.

    What was mended comes as :class:`TetloftWarning`, and as ``warnings`` of the stack; labels that
    the file gives its contours as ``labels``.
    """
    opened = opened_file(source)
    if opened:
        return parse_stack(*opened, **options)
    return _Read(options).call(lib.tetloft_stack_read_by, path_bytes(source))


def parse_stack(data: Data, name: str = "", **options: Any) -> Stack:
    """The same from bytes; ``name`` stands for the file in messages, and tells the extension."""
    read, given = _Read(options), as_bytes(data)
    return read.call(lib.tetloft_stack_parse_by, given, len(given), text(name, "name"))
