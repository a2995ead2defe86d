"""Voronoi cells and Delaunay tets of periodic sets of points."""

from __future__ import annotations

from typing import Any, Optional

from ._arrays import ArrayLike, Ids, Input, Shifts, doubles, numpy
from ._handles import Handle, Owner
from ._library import lib
from ._running import Progress, Run, Stop
from .voronoi import VoronoiCells


def _vectors(box: Any) -> Input:
    rows = box.tolist() if hasattr(box, "tolist") else list(box)
    if len(rows) == 3 and not any(hasattr(row, "__len__") for row in rows):
        rows = [[length if k == axis else 0 for k in range(3)] for axis, length in enumerate(rows)]
    given = doubles(rows, 3, "box")
    if given.rows != 3:
        raise ValueError("box: three lengths, or three vectors, are expected")
    return given


def periodic_voronoi(points: ArrayLike, box: ArrayLike, *, threads: int = 0,
                     progress: Optional[Progress] = None,
                     stop: Optional[Stop] = None) -> VoronoiCells:
    """The cells of points, (n, 3), that are repeated for ever: their volumes sum to the box's.

    ``box``: three lengths, or three vectors a, b, c as rows, however skewed. Points may lie
    anywhere: the neighbour of a face is at ``points[neighbour] + shift @ box``. Few are enough: one
    has itself as neighbour. Neighbours are exact, and mutual; nothing depends on a buffer's width.

    >>> cell = periodic_voronoi([(5, 5, 5)], (1, 2, 3))[0]
    >>> cell.volume, {face.neighbour for face in cell.faces}
    (6.0, {0})
    """
    given, vectors, made = doubles(points, 3, "points"), _vectors(box), Handle("cells")
    run = Run(threads, progress, stop)
    run.call(lib.tetloft_periodic_voronoi, given.pointer, given.rows, vectors.pointer, run.pointer,
             made.out)
    return VoronoiCells._of(made)


class PeriodicTets(Owner):
    """Delaunay tets of a periodic set, each once of all its images."""

    def __len__(self) -> int:
        """The number of tets."""
        return len(self.points)

    @property
    def points(self) -> Ids:
        """(m, 4) indices of points, in positive order; read only."""
        return self._array("tetloft_periodic_tets_points", 4)

    @property
    def shifts(self) -> Shifts:
        """(m, 4, 3): how many times a, b and c each of them is away from where it was given; 0 of
        the first; read only."""
        flat: Any = self._array("tetloft_periodic_tets_shifts", 12)
        if numpy is not None:
            return flat.reshape(-1, 4, 3)
        rows: Any = [tuple(row[k:k + 3] for k in range(0, 12, 3)) for row in flat]
        return rows

    def __repr__(self) -> str:
        return f"<tetloft.PeriodicTets{', closed' if self.closed else f': {len(self)}'}>"


def periodic_delaunay(points: ArrayLike, box: ArrayLike, *, threads: int = 0,
                      progress: Optional[Progress] = None,
                      stop: Optional[Stop] = None) -> PeriodicTets:
    """The Delaunay tets of points that are repeated for ever, as :func:`periodic_voronoi` has them.

    >>> tets = periodic_delaunay([(0, 0, 0)], (1, 1, 1))
    >>> len(tets), [int(times) for times in tets.shifts[0][0]]
    (6, [0, 0, 0])
    """
    given, vectors, made = doubles(points, 3, "points"), _vectors(box), Handle("periodic_tets")
    run = Run(threads, progress, stop)
    run.call(lib.tetloft_periodic_delaunay, given.pointer, given.rows, vectors.pointer, run.pointer,
             made.out)
    return PeriodicTets._of(made)
