"""Voronoi cells, of points and of periodic sets, and natural neighbours."""

from __future__ import annotations

from ctypes import c_double
from dataclasses import dataclass
from typing import Any, Iterator, Optional, Sequence

from . import _structs as structs
from ._arrays import ArrayLike, Codes, Doubles, Ids, Integers, Shifts, Vertices, doubles, numpy
from ._handles import Owner
from ._library import lib
from ._options import index

BOX_SIDES = tuple(structs.SIDE)
"""The sides of a box, by the number that :attr:`VoronoiCells.sides` has."""


@dataclass(frozen=True, eq=False)
class VoronoiFace:
    """A face of a cell."""

    neighbour: Optional[int]
    """Whose cell is across, as ``site`` is; None on the box."""
    side: str
    """Of :data:`BOX_SIDES` that on which it lies; "none" between two cells."""
    bounded: bool
    """False: it goes on without end."""
    area: float
    """Infinite where unbounded."""
    corners: Ids
    """Places in the cell's corners, counter-clockwise as seen from outside."""
    shift: Optional[tuple[int, int, int]]
    """Of periodic sets: how many times a, b and c the neighbour is away from where it was given."""
    normal: Optional[tuple[float, float, float]]
    """Of periodic sets: of length 1, towards the neighbour."""


@dataclass(frozen=True, eq=False)
class VoronoiCell:
    """One cell."""

    site: int
    """Whose it is: a vertex; of periodic sets the index of a point."""
    bounded: bool
    """False: it goes on without end, as cells of vertices on the hull do."""
    volume: float
    """Infinite where unbounded."""
    corners: Doubles
    """(n, 3); of periodic sets relative to the point."""
    faces: list[VoronoiFace]
    """One for each neighbour, by index, then those on the box. Of points on a common sphere, as in
    lattices, some have no area, or what rounding left of it."""


class VoronoiCells(Owner):
    """Cells one after the other: whole arrays of all, and ``cells[i]``, a :class:`VoronoiCell`.

    An array ``…_begin`` has one element more than what it divides: the faces of cell i are
    ``face_begin[i]`` to before ``face_begin[i + 1]``. Arrays are read only.

    >>> from tetloft import periodic_voronoi
    >>> cells = periodic_voronoi([(0, 0, 0), (0.5, 0.5, 0.5)], (1, 1, 1))
    >>> cells, round(float(cells.volumes[0]), 9), len(cells[0].corners)
    (<tetloft.VoronoiCells: 2>, 0.5, 24)
    >>> sorted({round(face.area, 3) for face in cells[1].faces if face.neighbour == 0})
    [0.325]
    """

    def __len__(self) -> int:
        """The number of cells."""
        return len(self.volumes)

    def __getitem__(self, number: int) -> VoronoiCell:
        at = index(number, len(self), "cell")
        first, last = int(self.corner_begin[at]), int(self.corner_begin[at + 1])
        faces = range(int(self.face_begin[at]), int(self.face_begin[at + 1]))
        return VoronoiCell(int(self.sites[at]), bool(self.bounded[at]), float(self.volumes[at]),
                           self.corners[first:last], [self._face(face, first) for face in faces])

    def __iter__(self) -> Iterator[VoronoiCell]:
        return (self[number] for number in range(len(self)))

    def _face(self, face: int, first_corner: int) -> VoronoiFace:
        neighbour = int(self.neighbours[face])
        corners: Any = self.face_corners[
            int(self.face_corner_begin[face]):int(self.face_corner_begin[face + 1])]
        if numpy is None:
            corners = [corner - first_corner for corner in corners]
        else:
            corners = corners - numpy.uint32(first_corner)
        shift: Any = None
        normal: Any = None
        if len(self.shifts):
            shift = tuple(int(times) for times in self.shifts[face])
            normal = tuple(float(x) for x in self.normals[face])
        return VoronoiFace(None if neighbour == structs.NO_VERTEX else neighbour,
                           BOX_SIDES[self.sides[face]], bool(self.faces_bounded[face]),
                           float(self.areas[face]), corners, shift, normal)

    @property
    def sites(self) -> Vertices:
        """(n,): whose the cells are, vertices; of periodic sets indices of points."""
        return self._array("tetloft_cells_sites")

    @property
    def bounded(self) -> Codes:
        """(n,): 0 where a cell goes on without end."""
        return self._array("tetloft_cells_bounded")

    @property
    def volumes(self) -> Doubles:
        """(n,): infinite where unbounded."""
        return self._array("tetloft_cells_volumes")

    @property
    def corner_begin(self) -> Integers:
        """(n + 1,): where the corners of each cell begin."""
        return signed(self._array("tetloft_cells_corner_begin"))

    @property
    def corners(self) -> Doubles:
        """(c, 3), of all cells; of periodic sets relative to the cell's point."""
        return self._array("tetloft_cells_corners", 3)

    @property
    def face_begin(self) -> Integers:
        """(n + 1,): where the faces of each cell begin."""
        return signed(self._array("tetloft_cells_face_begin"))

    @property
    def neighbours(self) -> Vertices:
        """(f,): of each face whose cell is across, as ``sites``; NO_VERTEX on the box."""
        return self._array("tetloft_cells_neighbours")

    @property
    def sides(self) -> Codes:
        """(f,): where it lies on the box, a number of :data:`BOX_SIDES`."""
        return self._array("tetloft_cells_sides")

    @property
    def faces_bounded(self) -> Codes:
        """(f,): 0 where a face goes on without end."""
        return self._array("tetloft_cells_faces_bounded")

    @property
    def areas(self) -> Doubles:
        """(f,): infinite where unbounded."""
        return self._array("tetloft_cells_areas")

    @property
    def face_corner_begin(self) -> Integers:
        """(f + 1,): where the corners of each face begin, in ``face_corners``."""
        return signed(self._array("tetloft_cells_face_corner_begin"))

    @property
    def face_corners(self) -> Ids:
        """Places in ``corners``, of each face counter-clockwise as seen from outside its cell."""
        return self._array("tetloft_cells_face_corners")

    @property
    def shifts(self) -> Shifts:
        """(f, 3), of periodic sets alone: how many times a, b and c the neighbour is away from
        where it was given."""
        return self._array("tetloft_cells_shifts", 3)

    @property
    def normals(self) -> Doubles:
        """(f, 3), of periodic sets alone: of length 1, towards the neighbour."""
        return self._array("tetloft_cells_normals", 3)

    def __repr__(self) -> str:
        return f"<tetloft.VoronoiCells{', closed' if self.closed else f': {len(self)}'}>"


class NaturalNeighbours(Owner):
    """The natural neighbours of points, one after the other: those of point i are
    ``vertices[begin[i]]`` to before ``vertices[begin[i + 1]]``, and so their ``weights``, of sum 1;
    none of points outside of the hull. ``neighbours[i]`` is both. Arrays are read only."""

    def __len__(self) -> int:
        """The number of points."""
        return len(self._array("tetloft_natural_neighbours_begin")) - 1

    def __getitem__(self, number: int) -> tuple[Vertices, Doubles]:
        at = index(number, len(self), "point")
        these = slice(int(self.begin[at]), int(self.begin[at + 1]))
        return self.vertices[these], self.weights[these]

    def __iter__(self) -> Iterator[tuple[Vertices, Doubles]]:
        return (self[number] for number in range(len(self)))

    @property
    def begin(self) -> Integers:
        """(n + 1,)."""
        return signed(self._array("tetloft_natural_neighbours_begin"))

    @property
    def vertices(self) -> Vertices:
        """Of each point by index."""
        return self._array("tetloft_natural_neighbours_vertices")

    @property
    def weights(self) -> Doubles:
        """Not negative, of sum 1 at each point."""
        return self._array("tetloft_natural_neighbours_weights")

    def mean(self, values: ArrayLike) -> Doubles:
        """The weighted mean of values, one for each index of a vertex, at each point: (n,) of
        numbers, (n, k) of rows. NaN where there are no neighbours."""
        given: Any = values
        if numpy is not None:
            return _mean_of_array(self, numpy.asarray(given))
        return _mean_of_list(self, given if hasattr(given, "__len__") else list(given))

    def __repr__(self) -> str:
        if self.closed:
            return "<tetloft.NaturalNeighbours, closed>"
        return f"<tetloft.NaturalNeighbours of {len(self)} points>"


def _too_few(values: int, needed: int) -> ValueError:
    return ValueError(f"values: one for each index of a vertex is expected, {needed}, not {values}")


def check_values(values: Any, slots: int) -> None:
    """One at least for each index of a vertex."""
    if len(values) < slots:
        raise _too_few(len(values), slots)


def _mean_of_array(found: NaturalNeighbours, values: Any) -> Any:
    if values.dtype.kind not in "fiub":
        raise TypeError(f"values: numbers of type {values.dtype} are not accepted")
    if values.ndim not in (1, 2):
        raise ValueError("values: an array of shape (n,) or (n, k) is expected, "
                         f"not {values.shape}")
    begin: Any = found.begin
    at = (found.vertices & numpy.uint64(0xFFFFFFFF)).astype(numpy.intp)
    check_values(values, int(at.max()) + 1 if len(at) else 0)
    mean = numpy.full((len(found), *values.shape[1:]), numpy.nan)
    some = begin[1:] > begin[:-1]
    if some.any():
        weights: Any = found.weights
        shares = values[at] * (weights if values.ndim == 1 else weights[:, numpy.newaxis])
        mean[some] = numpy.add.reduceat(shares, begin[:-1][some], axis=0)
    return mean


def _mean_of_list(found: NaturalNeighbours, values: Any) -> Any:
    columns = len(values[0]) if len(values) and hasattr(values[0], "__len__") else 0

    def mean(column: Optional[int], vertices: Any, weights: Any) -> float:
        def value(vertex: int) -> float:
            return values[vertex] if column is None else values[vertex][column]

        if not vertices:
            return float("nan")
        return float(sum(w * value(v & 0xFFFFFFFF) for v, w in zip(vertices, weights)))

    check_values(values, max((v & 0xFFFFFFFF for v in found.vertices), default=-1) + 1)
    if columns == 0:
        return [mean(None, *of) for of in found]
    return [tuple(mean(column, *of) for column in range(columns)) for of in found]


def clipping_box(box: Optional[ArrayLike], columns: int = 3, what: str = "box") -> Any:
    """For the library: its low and its high corner, or nothing."""
    if box is None:
        return None
    given = doubles(box, columns, what)
    if given.rows != 2:
        raise ValueError(f"{what}: the low and the high corner are expected, "
                         f"not {given.rows} points")
    return given


def signed(sizes: Any) -> Any:
    """Counts as numbers that one may subtract and mix with others."""
    return sizes if numpy is None else sizes.view(numpy.intp)


def circumsphere(a: Sequence[float], b: Sequence[float], c: Sequence[float],
                 d: Sequence[float]) -> tuple[tuple[float, float, float], float]:
    """Centre and radius of the sphere through four points; of points in a plane the radius is
    infinite, and the centre not a number.

    >>> circumsphere((0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2))[0]
    (1.0, 1.0, 1.0)
    """
    given, sphere = doubles([tuple(p) for p in (a, b, c, d)], 3, "points"), (c_double * 4)()
    lib.tetloft_circumsphere(given.pointer, sphere)
    return (sphere[0], sphere[1], sphere[2]), sphere[3]
