"""A Delaunay triangulation of points in space that come, go and move."""

from __future__ import annotations

import ctypes
from ctypes import c_double, c_int, c_int32, c_size_t, c_uint64
from typing import Any, Iterator, Optional, Sequence

from . import _structs as structs
from ._arrays import ArrayLike, Doubles, Integers, Vertices, doubles, filled, numpy
from ._handles import Handle, Owner
from ._library import lib
from ._options import choice, whole
from ._running import Progress, Run, Stop
from .errors import TooSmall
from .formats import Data, as_bytes, bytes_of
from .voronoi import NaturalNeighbours, VoronoiCell, VoronoiCells, check_values, clipping_box

LOCATIONS = tuple(structs.LOCATION)
"""The kinds of places, by the number that :meth:`DelaunayTriangulation3.locate` gives."""


def _point(given: Sequence[float]) -> tuple[float, float, float]:
    x, y, z = given
    return float(x), float(y), float(z)


def _vertex(given: int) -> int:
    return whole(given, "vertex", 0, 2**64 - 1)


class DelaunayTriangulation3(Owner):
    """The Delaunay triangulation of the points that are there, whatever was done before: insert,
    remove, move; nearest, locate, neighbours; Voronoi cells, natural neighbours.

    ``points``: (n, 3); vertex i is that of point i, of equal ones the first has it. A vertex is an
    integer, index + 2^32 · generation: the index is taken again when it is gone, the generation
    tells the next one from it. Where a vertex that is gone is handed in, :class:`InvalidInput` is
    raised, and nothing changed. Points may be few, in a plane, in a row; there are no tets then,
    and all questions have answers. Distances are compared exactly.

    Several threads may use one: those who ask at once, who changes it alone. A call's progress must
    not use it. Arrays are copies. Copies are triangulations of their own.

    >>> t = DelaunayTriangulation3([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
    >>> t.insert((1, 1, 1)), t.nearest_one((0.9, 0.8, 1)), len(t.tets)
    (4, 4, 2)
    >>> t.remove(4)
    >>> t
    <tetloft.DelaunayTriangulation3 of 4 vertices, 1 tets>
    >>> t.insert((2, 2, 2)) == 4 + 2**32
    True
    """

    def __init__(self, points: ArrayLike = (), *, threads: int = 0,
                 progress: Optional[Progress] = None, stop: Optional[Stop] = None):
        given, made = doubles(points, 3, "points"), Handle("delaunay")
        run = Run(threads, progress, stop)
        run.call(lib.tetloft_delaunay_create, given.pointer, given.rows, run.pointer, made.out)
        self._take(made)

    def insert(self, point: Sequence[float], near: Optional[int] = None) -> int:
        """The vertex of a point, which gets one unless it has one. ``near``: a vertex where the
        search starts."""
        vertex = c_uint64()
        start = structs.NO_VERTEX if near is None else _vertex(near)
        lib.tetloft_delaunay_insert(self._open(), *_point(point), start, ctypes.byref(vertex), None)
        return vertex.value

    def insert_all(self, points: ArrayLike, *, threads: int = 0,
                   progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> Vertices:
        """(n,): the vertex of each point of (n, 3), inserted in an order that is fast."""
        given, run = doubles(points, 3, "points"), Run(threads, progress, stop)
        made = (c_uint64 * given.rows)()
        run.call(lib.tetloft_delaunay_insert_all, self._open(), given.pointer, given.rows,
                 run.pointer, made)
        return filled(made, given.rows)

    def remove(self, vertex: int) -> None:
        """Takes a vertex away; its index may be taken again, by a vertex of another number."""
        lib.tetloft_delaunay_remove(self._open(), _vertex(vertex))

    def move(self, vertex: int, to: Sequence[float]) -> None:
        """The vertex stays the same. Refused where another one is."""
        lib.tetloft_delaunay_move(self._open(), _vertex(vertex), *_point(to))

    def clear(self) -> None:
        """Takes all vertices away."""
        lib.tetloft_delaunay_clear(self._open())

    def _counts(self) -> tuple[int, int, int, int]:
        vertices, slots, tets, dimension = c_size_t(), c_size_t(), c_size_t(), c_int()
        lib.tetloft_delaunay_counts(self._open(), ctypes.byref(vertices), ctypes.byref(slots),
                                    ctypes.byref(tets), ctypes.byref(dimension))
        return vertices.value, slots.value, tets.value, dimension.value

    def __len__(self) -> int:
        """The number of vertices."""
        return self._counts()[0]

    def __bool__(self) -> bool:
        return True

    def __iter__(self) -> Iterator[int]:
        """The vertices of now."""
        return iter([int(vertex) for vertex in self.vertices])

    def __contains__(self, vertex: int) -> bool:
        """Whether there is this vertex."""
        live = c_int()
        lib.tetloft_delaunay_is_live(self._open(), _vertex(vertex), ctypes.byref(live))
        return bool(live.value)

    @property
    def slots(self) -> int:
        """All indices of vertices are below."""
        return self._counts()[1]

    @property
    def dimension(self) -> int:
        """Of the points' affine hull, -1 to 3; there are tets in 3 alone."""
        return self._counts()[3]

    @property
    def vertices(self) -> Vertices:
        """(n,), by index."""
        return self._found(lib.tetloft_delaunay_vertices, c_uint64, 1)

    @property
    def points(self) -> Doubles:
        """(n, 3), those of ``vertices``."""
        return self._found(lib.tetloft_delaunay_points, c_double, 3)

    @property
    def tets(self) -> Vertices:
        """(m, 4) vertices. Where none was removed, and no points were equal, they are the rows of
        ``points``."""
        return self._found(lib.tetloft_delaunay_tets, c_uint64, 4)

    def point(self, vertex: int) -> tuple[float, float, float]:
        """Where a vertex is."""
        xyz = (c_double * 3)()
        lib.tetloft_delaunay_point(self._open(), _vertex(vertex), xyz)
        return xyz[0], xyz[1], xyz[2]

    def star(self, vertex: int) -> Vertices:
        """(k, 4): the vertices of the tets of a vertex."""
        return self._found(lib.tetloft_delaunay_star, c_uint64, 4, _vertex(vertex))

    def neighbours(self, vertex: int) -> Vertices:
        """The vertices that one has edges with, by index."""
        return self._found(lib.tetloft_delaunay_neighbours, c_uint64, 1, _vertex(vertex))

    def locate(self, points: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None,
               stop: Optional[Stop] = None) -> tuple[Integers, Vertices]:
        """The smallest simplex that holds each point of (n, 3): its kind, (n,), a number of
        :data:`LOCATIONS`, and (n, 4) its vertices by index, then NO_VERTEX."""
        given, run = doubles(points, 3, "points"), Run(threads, progress, stop)
        kinds, vertices = (c_int32 * given.rows)(), (c_uint64 * (4 * given.rows))()
        run.call(lib.tetloft_delaunay_locate, self._open(), given.pointer, given.rows, run.pointer,
                 kinds, vertices)
        return _wide(filled(kinds, given.rows)), filled(vertices, given.rows, 4)

    def nearest(self, points: ArrayLike, *, threads: int = 0, progress: Optional[Progress] = None,
                stop: Optional[Stop] = None) -> Vertices:
        """(n,): the vertex nearest to each point of (n, 3), the one of lowest index of equally near
        ones; NO_VERTEX where there are none."""
        given, run = doubles(points, 3, "points"), Run(threads, progress, stop)
        found = (c_uint64 * given.rows)()
        run.call(lib.tetloft_delaunay_nearest, self._open(), given.pointer, given.rows,
                 run.pointer, found)
        return filled(found, given.rows)

    def nearest_one(self, point: Sequence[float]) -> int:
        """The same of one point."""
        return int(self.nearest([_point(point)], threads=1)[0])

    def nearest_few(self, point: Sequence[float], most: int) -> Vertices:
        """The ``most`` vertices nearest to a point, or all there are, by distance, then by
        index."""
        return self._found(lib.tetloft_delaunay_nearest_few, c_uint64, 1, *_point(point),
                           whole(most, "most", 0, 2**32))

    def within(self, point: Sequence[float], radius: float) -> Vertices:
        """All vertices at most so far from a point, by distance, then by index."""
        return self._found(lib.tetloft_delaunay_within, c_uint64, 1, *_point(point), float(radius))

    def cells(self, box: Optional[ArrayLike] = None, *, threads: int = 0,
              progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> VoronoiCells:
        """The Voronoi cells of all vertices, by index: whole, or what of them is in a box, given as
        its low and its high corner. Those in a box are bounded, and their volumes sum to its."""
        clip, made, run = clipping_box(box), Handle("cells"), Run(threads, progress, stop)
        run.call(lib.tetloft_delaunay_cells, self._open(), clip and clip.pointer, run.pointer,
                 made.out)
        return VoronoiCells._of(made)

    def cell(self, vertex: int, box: Optional[ArrayLike] = None) -> VoronoiCell:
        """That of one vertex."""
        clip, made = clipping_box(box), Handle("cells")
        lib.tetloft_delaunay_cell(self._open(), _vertex(vertex), clip and clip.pointer, made.out)
        return VoronoiCells._of(made)[0]

    def volumes(self, *, threads: int = 0, progress: Optional[Progress] = None,
                stop: Optional[Stop] = None) -> Doubles:
        """(``slots``,): of all whole cells, by index of vertex, infinite where unbounded, 0 where
        there is no vertex. Several times as fast as making the cells."""
        run = Run(threads, progress, stop)

        def ask(handle: Handle, *arguments: Any) -> None:
            run.call(lib.tetloft_delaunay_volumes, handle, run.pointer, *arguments)

        return self._found(ask, c_double, 1)

    @property
    def circumspheres(self) -> Doubles:
        """(m, 4): centre and radius of the spheres through the vertices of ``tets``."""
        return self._found(lib.tetloft_delaunay_circumspheres, c_double, 4)

    def natural_neighbours(self, points: ArrayLike, weights: str = "sibson", *, threads: int = 0,
                           progress: Optional[Progress] = None,
                           stop: Optional[Stop] = None) -> NaturalNeighbours:
        """The vertices that would be neighbours of each point of (n, 3), were it one, and their
        weights: "sibson", by what its cell would take of theirs, or "laplace", by area over
        distance of its faces, in less time. A vertex has itself alone, a point outside of the hull
        none. The point is the weighted mean of its neighbours."""
        given, made = doubles(points, 3, "points"), Handle("natural_neighbours")
        run = Run(threads, progress, stop)
        run.call(lib.tetloft_delaunay_natural_neighbours_all, self._open(), given.pointer,
                 given.rows, choice(structs.WEIGHTS, weights, "weights"), run.pointer, made.out)
        return NaturalNeighbours._of(made)

    def interpolate(self, values: ArrayLike, points: ArrayLike, weights: str = "sibson", *,
                    threads: int = 0, progress: Optional[Progress] = None,
                    stop: Optional[Stop] = None) -> Doubles:
        """Values between vertices: at each point of (n, 3) the weighted mean of those of its
        natural neighbours, so that linear functions are reproduced. NaN outside of the hull.
        ``values``: (``slots``,) or (``slots``, k), by index of vertex; where none was removed they
        are those of the points that it was made of.

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
        lib.tetloft_delaunay_serialise(self._open(), made.out)
        return bytes_of(made)

    @classmethod
    def from_bytes(cls, data: Data) -> DelaunayTriangulation3:
        """Of what :meth:`to_bytes` gave; :class:`InvalidInput` where it is damaged."""
        given, made = as_bytes(data), Handle("delaunay")
        lib.tetloft_delaunay_deserialise(given, len(given), made.out)
        return cls._of(made)

    def __copy__(self) -> DelaunayTriangulation3:
        made = Handle("delaunay")
        lib.tetloft_delaunay_copy(self._open(), made.out)
        return type(self)._of(made)

    def __reduce__(self) -> Any:
        return type(self).from_bytes, (self.to_bytes(),)

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
        if self.closed:
            return "<tetloft.DelaunayTriangulation3, closed>"
        vertices, _, tets, _ = self._counts()
        return f"<tetloft.DelaunayTriangulation3 of {vertices} vertices, {tets} tets>"


def _wide(codes: Any) -> Any:
    return codes if numpy is None else codes.astype(numpy.int64)
