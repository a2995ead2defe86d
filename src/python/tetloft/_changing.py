"""What Delaunay triangulations that change have in space and in the plane."""

from __future__ import annotations

import ctypes
from ctypes import c_double, c_int, c_int32, c_size_t, c_uint64
from typing import Any, Iterator, NamedTuple, Optional, Sequence, TypeVar

from . import _structs as structs
from ._arrays import ArrayLike, Doubles, Integers, Vertices, doubles, filled, numpy
from ._handles import Handle, Owner
from ._library import lib
from ._options import choice, whole
from ._running import Progress, Run, Stop
from .errors import TooSmall
from .formats import Data, as_bytes, bytes_of
from .voronoi import NaturalNeighbours, check_values

Same = TypeVar("Same", bound="ChangingDelaunay")

LOCATIONS = tuple(structs.LOCATION)
"""The kinds of places, by the number that ``locate`` gives. A triangle is a facet."""


class ConflictZone(NamedTuple):
    """What the insertion of a point would change; of a point that is a vertex nothing."""

    simplices: Vertices
    """The tets (k, 4), in the plane the triangles (k, 3), that would go."""
    horizon: Vertices
    """What the point would be joined to: triangles (h, 3), in the plane edges (h, 2)."""
    neighbours: Vertices
    """The vertices that would have an edge with it, by index."""


def vertex_number(given: int) -> int:
    return whole(given, "vertex", 0, 2**64 - 1)


def _start(near: Optional[int]) -> int:
    return structs.NO_VERTEX if near is None else vertex_number(near)


class ChangingDelaunay(Owner):
    """Of points of ``_dimensions`` coordinates; functions of C begin with the handle's name."""

    _kind: str
    _dimensions: int
    _simplices: str

    def __init__(self, points: ArrayLike = (), *, threads: int = 0,
                 progress: Optional[Progress] = None, stop: Optional[Stop] = None):
        given, made = self._coordinates(points), Handle(self._kind)
        run = Run(threads, progress, stop)
        run.call(self._function("create"), given.pointer, given.rows, run.pointer, made.out)
        self._take(made)

    @classmethod
    def _function(cls, name: str) -> Any:
        return getattr(lib, f"tetloft_{cls._kind}_{name}")

    def _coordinates(self, points: ArrayLike) -> Any:
        return doubles(points, self._dimensions, "points")

    def _point(self, given: Sequence[float]) -> list[float]:
        point = [float(coordinate) for coordinate in given]
        if len(point) != self._dimensions:
            raise ValueError(f"a point has {self._dimensions} coordinates, not {len(point)}")
        return point

    def insert(self, point: Sequence[float], near: Optional[int] = None) -> int:
        """The vertex of a point, which gets one unless it has one. ``near``: a vertex where the
        search starts."""
        vertex = c_uint64()
        self._function("insert")(self._open(), *self._point(point), _start(near),
                                 ctypes.byref(vertex), None)
        return vertex.value

    def insert_all(self, points: ArrayLike, *, threads: int = 0,
                   progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> Vertices:
        """(n,): the vertex of each of the points, inserted in an order that is fast."""
        given, run = self._coordinates(points), Run(threads, progress, stop)
        made = (c_uint64 * given.rows)()
        run.call(self._function("insert_all"), self._open(), given.pointer, given.rows,
                 run.pointer, made)
        return filled(made, given.rows)

    def remove(self, vertex: int) -> None:
        """Takes a vertex away; its index may be taken again, by a vertex of another number."""
        self._function("remove")(self._open(), vertex_number(vertex))

    def move(self, vertex: int, to: Sequence[float]) -> None:
        """The vertex stays the same. Refused where another one is."""
        self._function("move")(self._open(), vertex_number(vertex), *self._point(to))

    def clear(self) -> None:
        """Takes all vertices away."""
        self._function("clear")(self._open())

    def _counts(self) -> dict[str, int]:
        raise NotImplementedError

    def __len__(self) -> int:
        """The number of vertices."""
        return self._counts()["vertices"]

    def __bool__(self) -> bool:
        return True

    def __iter__(self) -> Iterator[int]:
        """The vertices of now."""
        return iter([int(vertex) for vertex in self.vertices])

    def __contains__(self, vertex: int) -> bool:
        """Whether there is this vertex."""
        live = c_int()
        self._function("is_live")(self._open(), vertex_number(vertex), ctypes.byref(live))
        return bool(live.value)

    @property
    def slots(self) -> int:
        """All indices of vertices are below."""
        return self._counts()["slots"]

    @property
    def dimension(self) -> int:
        """Of the points' affine hull, -1 without points; there are tets in 3 alone, triangles of a
        plane in 2."""
        return self._counts()["dimension"]

    @property
    def vertices(self) -> Vertices:
        """(n,), by index."""
        return self._listed("vertices", c_uint64, 1)

    @property
    def points(self) -> Doubles:
        """Those of ``vertices``, (n, 3) or (n, 2)."""
        return self._listed("points", c_double, self._dimensions)

    def point(self, vertex: int) -> tuple[float, ...]:
        """Where a vertex is."""
        coordinates = (c_double * self._dimensions)()
        self._function("point")(self._open(), vertex_number(vertex), coordinates)
        return tuple(coordinates)

    def star(self, vertex: int) -> Vertices:
        """The vertices of the tets of a vertex, (k, 4); in the plane of the triangles, (k, 3)."""
        return self._listed("star", c_uint64, self._dimensions + 1, vertex_number(vertex))

    def neighbours(self, vertex: int) -> Vertices:
        """The vertices that one has edges with, by index."""
        return self._listed("neighbours", c_uint64, 1, vertex_number(vertex))

    def locate(self, points: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None,
               stop: Optional[Stop] = None) -> tuple[Integers, Vertices]:
        """The smallest simplex that holds each of the points: its kind, (n,), a number of
        :data:`LOCATIONS`, and (n, 4), in the plane (n, 3), its vertices by index, then
        NO_VERTEX."""
        given, run = self._coordinates(points), Run(threads, progress, stop)
        columns = self._dimensions + 1
        kinds, vertices = (c_int32 * given.rows)(), (c_uint64 * (columns * given.rows))()
        run.call(self._function("locate"), self._open(), given.pointer, given.rows, run.pointer,
                 kinds, vertices)
        return _wide(filled(kinds, given.rows)), filled(vertices, given.rows, columns)

    def nearest(self, points: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None,
                stop: Optional[Stop] = None) -> Vertices:
        """(n,): the vertex nearest to each of the points, the one of lowest index of equally near
        ones; NO_VERTEX where there are none."""
        given, run = self._coordinates(points), Run(threads, progress, stop)
        found = (c_uint64 * given.rows)()
        run.call(self._function("nearest"), self._open(), given.pointer, given.rows, run.pointer,
                 found)
        return filled(found, given.rows)

    def nearest_one(self, point: Sequence[float]) -> int:
        """The same of one point."""
        return int(self.nearest([self._point(point)], threads=1)[0])

    def nearest_few(self, point: Sequence[float], most: int) -> Vertices:
        """The ``most`` vertices nearest to a point, or all there are, by distance, then by
        index."""
        return self._listed("nearest_few", c_uint64, 1, *self._point(point),
                            whole(most, "most", 0, 2**32))

    def within(self, point: Sequence[float], radius: float) -> Vertices:
        """All vertices at most so far from a point, by distance, then by index."""
        return self._listed("within", c_uint64, 1, *self._point(point), float(radius))

    def conflict_zone(self, point: Sequence[float], near: Optional[int] = None) -> ConflictZone:
        """What the insertion of a point would change. ``near``: a vertex where the search
        starts."""
        columns = (self._dimensions + 1, self._dimensions, 1)
        counts, handle = [c_size_t(64) for _ in columns], self._open()
        while True:
            made = [(c_uint64 * (width * count.value))() for width, count in zip(columns, counts)]
            arrays = [argument for array, count in zip(made, counts)
                      for argument in (array, count.value, ctypes.byref(count))]
            try:
                self._function("conflict_zone")(handle, *self._point(point), _start(near), *arrays)
            except TooSmall:
                continue
            return ConflictZone(*(filled(array, count.value, width)
                                  for array, count, width in zip(made, counts, columns)))

    def natural_neighbours(self, points: ArrayLike, weights: str = "sibson", *, threads: int = 0,
                           progress: Optional[Progress] = None,
                           stop: Optional[Stop] = None) -> NaturalNeighbours:
        """The vertices that would be neighbours of each point, were it one, and their weights:
        "sibson", by what its cell would take of theirs, or "laplace", by area over distance of its
        faces, in the plane length over distance of its edges. A vertex has itself alone, a point
        outside of the hull none. The point is the weighted mean of its neighbours. Refused among
        constraints."""
        given, made = self._coordinates(points), Handle("natural_neighbours")
        run = Run(threads, progress, stop)
        run.call(self._function("natural_neighbours_all"), self._open(), given.pointer,
                 given.rows, choice(structs.WEIGHTS, weights, "weights"), run.pointer, made.out)
        return NaturalNeighbours._of(made)

    def interpolate(self, values: ArrayLike, points: ArrayLike, weights: str = "sibson", *,
                    threads: int = 0, progress: Optional[Progress] = None,
                    stop: Optional[Stop] = None) -> Doubles:
        """Values between vertices: at each point the weighted mean of those of its natural
        neighbours, so that linear functions are reproduced. NaN outside of the hull.
        ``values``: (``slots``,) or (``slots``, k), by index of vertex; where none was removed they
        are those of the points that it was made of.

        >>> from tetloft import DelaunayTriangulation3
        >>> t = DelaunayTriangulation3([(0, 0, 0), (2, 0, 0), (0, 2, 0), (0, 0, 2)])
        >>> found = t.interpolate([7, 8, 9, 10], [(0.5, 0.5, 0.5), (2, 2, 2)])
        >>> [round(float(value), 9) for value in found]
        [8.5, nan]
        """
        given: Any = values if hasattr(values, "__len__") else list(values)  # type: ignore
        check_values(given, self.slots)
        found = self.natural_neighbours(points, weights, threads=threads, progress=progress,
                                        stop=stop)
        return found.mean(given)

    def to_bytes(self) -> bytes:
        """The same on every machine; what is made of them has the same vertices."""
        made = Handle("bytes")
        self._function("serialise")(self._open(), made.out)
        return bytes_of(made)

    @classmethod
    def from_bytes(cls: type[Same], data: Data) -> Same:
        """Of what :meth:`to_bytes` gave; :class:`InvalidInput` where it is damaged."""
        given, made = as_bytes(data), Handle(cls._kind)
        cls._function("deserialise")(given, len(given), made.out)
        return cls._of(made)

    def __copy__(self: Same) -> Same:
        made = Handle(self._kind)
        self._function("copy")(self._open(), made.out)
        return type(self)._of(made)

    def __reduce__(self) -> Any:
        return type(self).from_bytes, (self.to_bytes(),)

    def _listed(self, name: str, kind: Any, columns: int, *of: Any) -> Any:
        return self._found(self._function(name), kind, columns, *of)

    def _measured(self, what: str, threads: int, progress: Optional[Progress],
                  stop: Optional[Stop]) -> Any:
        """Of whole cells, by index of vertex."""
        run = Run(threads, progress, stop)

        def ask(handle: Handle, *arguments: Any) -> None:
            run.call(self._function(what), handle, run.pointer, *arguments)

        return self._found(ask, c_double, 1)

    def _found(self, function: Any, kind: Any, columns: int, *of: Any) -> Any:
        # Room for a few, as of one vertex; where there are more, for as many as there were: between
        # two calls another thread may change it.
        count, handle = c_size_t(64), self._open()
        while True:
            capacity = count.value
            made = (kind * (columns * capacity))()
            try:
                function(handle, *of, made, capacity, ctypes.byref(count))
            except TooSmall:
                continue
            return filled(made, count.value, columns)

    def __repr__(self) -> str:
        name = f"tetloft.{type(self).__name__}"
        if self.closed:
            return f"<{name}, closed>"
        counts = self._counts()
        return f"<{name} of {counts['vertices']} vertices, {counts[self._simplices]} " \
               f"{self._simplices}>"


def _wide(codes: Any) -> Any:
    return codes if numpy is None else codes.astype(numpy.int64)
