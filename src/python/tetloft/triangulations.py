"""Delaunay triangulations of points that come, go and move, in space and in the plane."""

from __future__ import annotations

import ctypes
from ctypes import c_double, c_int, c_size_t, c_uint32, c_uint64
from typing import Any, Optional

from . import _structs as structs
from ._arrays import ArrayLike, Doubles, Ids, Vertices, doubles, filled, vertex_tuples
from ._changing import ChangingDelaunay, vertex_number
from ._handles import Handle
from ._library import lib
from ._options import choice, whole
from ._running import Progress, Run, Stop
from .plane_cells import PlaneCell, PlaneCells
from .voronoi import VoronoiCell, VoronoiCells, clipping_box


class DelaunayTriangulation3(ChangingDelaunay):
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

    _kind = "delaunay"
    _dimensions = 3
    _simplices = "tets"

    def _counts(self) -> dict[str, int]:
        vertices, slots, tets, dimension = c_size_t(), c_size_t(), c_size_t(), c_int()
        lib.tetloft_delaunay_counts(self._open(), ctypes.byref(vertices), ctypes.byref(slots),
                                    ctypes.byref(tets), ctypes.byref(dimension))
        return {"vertices": vertices.value, "slots": slots.value, "tets": tets.value,
                "dimension": dimension.value}

    @property
    def tets(self) -> Vertices:
        """(m, 4) vertices. Where none was removed, and no points were equal, they are the rows of
        ``points``."""
        return self._listed("tets", c_uint64, 4)

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
        lib.tetloft_delaunay_cell(self._open(), vertex_number(vertex), clip and clip.pointer,
                                  made.out)
        return VoronoiCells._of(made)[0]

    def volumes(self, *, threads: int = 0, progress: Optional[Progress] = None,
                stop: Optional[Stop] = None) -> Doubles:
        """(``slots``,): of all whole cells, by index of vertex, infinite where unbounded, 0 where
        there is no vertex. Several times as fast as making the cells."""
        return self._measured("volumes", threads, progress, stop)

    @property
    def circumspheres(self) -> Doubles:
        """(m, 4): centre and radius of the spheres through the vertices of ``tets``."""
        return self._listed("circumspheres", c_double, 4)


class DelaunayTriangulation2(ChangingDelaunay):
    """The same of points of the plane, (n, 2), with constraints: segments between vertices that are
    unions of edges. With them it is the constrained Delaunay triangulation; no vertex is put on a
    constraint but where two cross, and where that is asked for.

    Constraints go over all vertices on them, those that come later too, and share edges where they
    overlap. A constraint is an integer that is not given again. A vertex that one goes over is
    neither removed nor moved: :class:`InvalidInput`.

    >>> t = DelaunayTriangulation2([(0, 0), (4, 0), (4, 4), (0, 4), (1, 1), (3, 1), (2, 3)])
    >>> outline = [(0, 1), (1, 2), (2, 3), (3, 0)]
    >>> hole = [(4, 5), (5, 6), (6, 4)]
    >>> numbers = t.insert_constraints(outline + hole)
    >>> t
    <tetloft.DelaunayTriangulation2 of 7 vertices, 8 triangles>
    >>> len(t.inside())
    7
    """

    _kind = "delaunay_plane"
    _dimensions = 2
    _simplices = "triangles"

    def _counts(self) -> dict[str, int]:
        vertices, slots, triangles, constraints, dimension = \
            c_size_t(), c_size_t(), c_size_t(), c_size_t(), c_int()
        lib.tetloft_delaunay_plane_counts(
            self._open(), ctypes.byref(vertices), ctypes.byref(slots), ctypes.byref(triangles),
            ctypes.byref(constraints), ctypes.byref(dimension))
        return {"vertices": vertices.value, "slots": slots.value, "triangles": triangles.value,
                "constraints": constraints.value, "dimension": dimension.value}

    @property
    def triangles(self) -> Vertices:
        """(m, 3) vertices, counter-clockwise. Where none was removed, and no points were equal,
        they are the rows of ``points``."""
        return self._listed("triangles", c_uint64, 3)

    def hull(self) -> Vertices:
        """The vertices on the hull, counter-clockwise from that of lowest index; of points in a row
        all of them, from one end to the other."""
        return self._listed("hull", c_uint64, 1)

    def cells(self, rectangle: Optional[ArrayLike] = None, *, threads: int = 0,
              progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> PlaneCells:
        """The Voronoi cells of all vertices, by index: whole, or what of them is in a rectangle,
        given as its low and its high corner; their areas sum to its. Refused among
        constraints."""
        clip, made = clipping_box(rectangle, 2, "rectangle"), Handle("plane_cells")
        run = Run(threads, progress, stop)
        run.call(lib.tetloft_delaunay_plane_cells, self._open(), clip and clip.pointer, run.pointer,
                 made.out)
        return PlaneCells._of(made)

    def cell(self, vertex: int, rectangle: Optional[ArrayLike] = None) -> PlaneCell:
        """That of one vertex."""
        clip, made = clipping_box(rectangle, 2, "rectangle"), Handle("plane_cells")
        lib.tetloft_delaunay_plane_cell(self._open(), vertex_number(vertex), clip and clip.pointer,
                                        made.out)
        return PlaneCells._of(made)[0]

    def areas(self, *, threads: int = 0, progress: Optional[Progress] = None,
              stop: Optional[Stop] = None) -> Doubles:
        """(``slots``,): of all whole cells, by index of vertex, infinite where unbounded, 0 where
        there is no vertex. Refused among constraints."""
        return self._measured("areas", threads, progress, stop)

    def insert_constraint(self, u: int, v: int, crossing: str = "refuse") -> int:
        """The segment between two vertices, as a constraint.

        ``crossing``: where it crosses others it is refused, "refuse", with where in the error's
        place; or a vertex is put there, "split", and all go over it: the point is rounded, which
        bends them by ulps."""
        constraint = c_uint32()
        lib.tetloft_delaunay_plane_insert_constraint(
            self._open(), vertex_number(u), vertex_number(v), _crossing(crossing),
            ctypes.byref(constraint))
        return constraint.value

    def insert_constraints(self, segments: ArrayLike, crossing: str = "refuse") -> Ids:
        """(k,): the constraint of each of the segments, (k, 2) vertices: all or, where one is
        refused, none. Of many much faster than one by one where they cross."""
        given = vertex_tuples(segments, 2, "segments")
        made = (c_uint32 * given.rows)()
        lib.tetloft_delaunay_plane_insert_constraints(self._open(), given.pointer, given.rows,
                                                      _crossing(crossing), made)
        return filled(made, given.rows)

    def remove_constraint(self, constraint: int) -> None:
        """Takes a constraint away; its vertices stay."""
        lib.tetloft_delaunay_plane_remove_constraint(self._open(), _constraint(constraint))

    def has_constraint(self, constraint: int) -> bool:
        """Whether there is this constraint."""
        has = c_int()
        lib.tetloft_delaunay_plane_has_constraint(self._open(), _constraint(constraint),
                                                  ctypes.byref(has))
        return bool(has.value)

    @property
    def constraints(self) -> Ids:
        """(k,), by number."""
        return self._listed("constraints", c_uint32, 1)

    def constraint_ends(self, constraint: int) -> tuple[int, int]:
        """The two vertices that it was given."""
        ends = (c_uint64 * 2)()
        lib.tetloft_delaunay_plane_constraint_ends(self._open(), _constraint(constraint), ends)
        return ends[0], ends[1]

    def constraint_edges(self, constraint: int) -> Vertices:
        """(k, 2): the edges that it goes over, each by index, sorted."""
        return self._listed("constraint_edges", c_uint64, 2, _constraint(constraint))

    def edge_constraints(self, u: int, v: int) -> Ids:
        """The constraints over an edge, by number; none where the vertices are not joined."""
        return self._listed("edge_constraints", c_uint32, 1, vertex_number(u), vertex_number(v))

    def inside(self) -> Vertices:
        """(k, 3): the triangles that one comes to from outside across an odd number of constraints:
        of an outline and its holes what is between. Refused where constraints end."""
        return self._listed("inside", c_uint64, 3)


def _crossing(word: str) -> int:
    return choice(structs.CROSSING, word, "crossing")


def _constraint(given: int) -> int:
    return whole(given, "constraint", 0, 2**32 - 1)
