"""Tetrahedral meshes with star and link, and triangulations of the plane."""

from __future__ import annotations

import ctypes
from ctypes import c_size_t, c_uint32
from typing import Any, Optional, Union

from . import _structs as structs
from ._arrays import ArrayLike, Codes, Doubles, Ids, doubles, filled, ids, numpy, view
from ._handles import Handle, Owner
from ._library import lib
from ._options import choice, defaults, index, whole
from ._running import Progress, Run, Stop

_LINK_NAMES = {value: name for name, value in structs.LINK.items()}


class Mesh(Owner):
    """Tets that know their neighbours; no coordinates.

    ``tets``: (m, 4) vertex ids from 0 to ``vertex_count - 1``. Refused (:class:`InvalidInput`)
    where a face belongs to more than two tets, or to two on its same side.

    >>> mesh = Mesh(5, [(0, 1, 2, 3), (1, 4, 2, 3)])
    >>> [int(tet) for tet in mesh.star(2, 3)], mesh.link_kind(0)
    ([0, 1], 'disc')
    """

    def __init__(self, vertex_count: int, tets: ArrayLike):
        given, handle = ids(tets, 4, "tets"), Handle("mesh")
        lib.tetloft_mesh_create(whole(vertex_count, "vertex_count", 0, 2**32), given.pointer,
                                given.rows, handle.out)
        self._take(handle)

    def _counts(self) -> tuple[int, int]:
        vertices, tets = c_size_t(), c_size_t()
        lib.tetloft_mesh_counts(self._open(), ctypes.byref(vertices), ctypes.byref(tets))
        return vertices.value, tets.value

    @property
    def vertex_count(self) -> int:
        """Vertices, those of no tet included."""
        return self._counts()[0]

    def __len__(self) -> int:
        """The number of tets."""
        return self._counts()[1]

    @property
    def tets(self) -> Ids:
        """(m, 4) vertex ids, read only; face i lies opposite vertex i."""
        return self._array("tetloft_mesh_tets", 4)

    @property
    def opposites(self) -> Ids:
        """(m, 4): by face of each tet the half-face 4 · tet + face on its other side, NO_ID on the
        boundary; read only."""
        return self._array("tetloft_mesh_opposites", 4, parts=4)

    @property
    def neighbours(self) -> Ids:
        """(m, 4): by face of each tet the tet across it, NO_ID on the boundary; made anew."""
        opposites: Any = self.opposites
        none = structs.NO_ID
        if numpy is None:
            rows: Any = [tuple(h if h == none else h // 4 for h in row) for row in opposites]
            return rows
        return numpy.where(opposites == none, none, opposites // 4).astype(numpy.uint32)

    def star(self, vertex: int, other: Optional[int] = None) -> Ids:
        """The tets of a vertex, or of the edge to ``other``, by id."""
        return self._around("star", vertex, other, 1)

    def link(self, vertex: int, other: Optional[int] = None) -> Ids:
        """(k, 3): the triangles opposite a vertex in its star; or of an edge (k, 2), the edges
        opposite it."""
        return self._around("link", vertex, other, 3 if other is None else 2)

    def link_kind(self, vertex: int, other: Optional[int] = None) -> str:
        """"disc", "sphere", "empty"; or, singular, "components", "pinch", "holes"."""
        kind = ctypes.c_int()
        if other is None:
            lib.tetloft_mesh_link_kind(self._open(), self._vertex(vertex), ctypes.byref(kind))
        else:
            lib.tetloft_mesh_edge_link_kind(self._open(), self._vertex(vertex),
                                            self._vertex(other), ctypes.byref(kind))
        return _LINK_NAMES[kind.value]

    def singular_vertices(self) -> Ids:
        """The vertices whose link is neither disc nor sphere nor empty."""
        return self._ask(lib.tetloft_mesh_singular_vertices, 1)

    def boundary(self) -> Ids:
        """The half-faces 4 · tet + face without another side."""
        return self._ask(lib.tetloft_mesh_boundary, 1)

    def _vertex(self, vertex: int) -> int:
        return index(vertex, self.vertex_count, "vertex")

    def _around(self, what: str, vertex: int, other: Optional[int], columns: int) -> Any:
        if other is None:
            return self._ask(getattr(lib, f"tetloft_mesh_{what}"), columns, self._vertex(vertex))
        return self._ask(getattr(lib, f"tetloft_mesh_edge_{what}"), columns, self._vertex(vertex),
                         self._vertex(other))

    def _ask(self, function: Any, columns: int, *of: int) -> Any:
        count = c_size_t()
        function(self._open(), *of, None, 0, ctypes.byref(count))
        made = (c_uint32 * (columns * count.value))()
        function(self._open(), *of, made, count.value, ctypes.byref(count))
        return filled(made, count.value, columns)

    def __repr__(self) -> str:
        name = f"tetloft.{type(self).__name__}"
        if self.closed:
            return f"<{name}, closed>"
        vertices, tets = self._counts()
        return f"<{name} of {tets} tets, {vertices} vertices>"


class Delaunay(Mesh):
    """The Delaunay triangulation of points in space; its vertices are the points, by index."""

    dimension: int
    """Of the points' affine hull, -1 to 3; there are tets in 3 alone."""
    representative: Ids
    """For each point the lowest index with the same coordinates."""


class Triangulation(Owner):
    """A Delaunay triangulation of the plane."""

    @property
    def points(self) -> Doubles:
        """(n, 2), read only."""
        return self._array("tetloft_triangulation_points", 2)

    @property
    def triangles(self) -> Ids:
        """(m, 3) point ids, counter-clockwise, read only."""
        return self._array("tetloft_triangulation_triangles", 3)

    @property
    def neighbours(self) -> Ids:
        """(m, 3) triangles opposite vertex 0, 1, 2; NO_ID on the hull; read only."""
        return self._array("tetloft_triangulation_neighbours", 3)

    @property
    def internal(self) -> Codes:
        """Of a section: for each triangle 1 iff it lies in the region; else empty."""
        return self._array("tetloft_triangulation_internal")

    def chain(self, segment: int) -> Ids:
        """Of a triangulation with segments: the points of one, from its first to its second end."""
        handle = self._open()
        pointer, count = ctypes.POINTER(c_uint32)(), c_size_t()
        lib.tetloft_triangulation_chain(handle, whole(segment, "segment", 0, 2**63),
                                        ctypes.byref(pointer), ctypes.byref(count))
        return view(pointer, count.value, 1, handle)

    def __repr__(self) -> str:
        if self.closed:
            return "<tetloft.Triangulation, closed>"
        return (f"<tetloft.Triangulation of {len(self.triangles)} triangles, "
                f"{len(self.points)} points>")


def _columns(points: Any) -> int:
    """2 or 3, by shape; of no points 3."""
    shape = getattr(points, "shape", None)
    if shape is not None:
        return int(shape[1]) if len(shape) == 2 else 0
    return len(points[0]) if len(points) else 3


def delaunay(points: ArrayLike, *, segments: Optional[ArrayLike] = None,
             engine: str = "automatic", most_tets: int = 0, threads: int = 0,
             progress: Optional[Progress] = None,
             stop: Optional[Stop] = None) -> Union[Triangulation, Delaunay]:
    """The Delaunay triangulation of points: (n, 3) gives a :class:`Delaunay`, (n, 2) a
    :class:`Triangulation`.

    ``segments``, of points of the plane alone: (k, 2) point ids; each becomes a union of edges, for
    which points are inserted. ``engine`` and ``most_tets`` (0: no limit) in space alone: the
    triangulation does not depend on the engine, "automatic", "incremental" or "slab".

    >>> mesh = delaunay([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)])
    >>> mesh, mesh.dimension
    (<tetloft.Delaunay of 1 tets, 4 vertices>, 3)
    >>> delaunay([(0, 0), (1, 0), (0, 1)])
    <tetloft.Triangulation of 1 triangles, 3 points>
    """
    given: Any = points if hasattr(points, "shape") else list(points)  # type: ignore[arg-type]
    run = Run(threads, progress, stop)
    if _columns(given) == 2:
        return _of_plane(given, segments, run)
    if segments is not None:
        raise ValueError("segments: of points of the plane, (n, 2), alone")
    return _of_space(given, engine, most_tets, run)


def _of_plane(points: ArrayLike, segments: Optional[ArrayLike], run: Run) -> Triangulation:
    given, made = doubles(points, 2, "points"), Handle("triangulation")
    if segments is None:
        run.call(lib.tetloft_delaunay2, given.pointer, given.rows, run.pointer, made.out)
    else:
        pairs = ids(segments, 2, "segments")
        run.call(lib.tetloft_conforming_delaunay2, given.pointer, given.rows, pairs.pointer,
                 pairs.rows, run.pointer, made.out)
    return Triangulation._of(made)


def _of_space(points: ArrayLike, engine: str, most_tets: int, run: Run) -> Delaunay:
    given, made = doubles(points, 3, "points"), Handle("mesh")
    options = defaults(structs.Delaunay3Options, "delaunay3_options")
    options.engine = choice(structs.ENGINE, engine, "engine")
    options.most_tets = whole(most_tets, "most_tets", 0, 2**64 - 1)
    options.execution = run.pointer
    dimension, representative = ctypes.c_int(), (c_uint32 * given.rows)()
    run.call(lib.tetloft_delaunay3, given.pointer, given.rows, ctypes.byref(options), made.out,
             ctypes.byref(dimension), representative)
    mesh = Delaunay._of(made)
    mesh.dimension = dimension.value
    mesh.representative = filled(representative, given.rows)
    return mesh
