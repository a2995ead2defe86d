"""Voronoi cells in the plane."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Iterator, Optional

from . import _structs as structs
from ._arrays import Codes, Doubles, Ids, Integers, Vertices
from ._handles import Owner
from ._options import index
from .voronoi import BOX_SIDES, signed


@dataclass(frozen=True, eq=False)
class PlaneEdge:
    """An edge of a cell in the plane."""

    neighbour: Optional[int]
    """Whose cell is across, a vertex; None on the rectangle."""
    side: str
    """Of :data:`BOX_SIDES` that on which it lies; "none" between two cells."""
    inside: bool
    """Whether anything of it is in the rectangle."""
    ends: tuple[Optional[int], Optional[int]]
    """Places in the cell's corners, counter-clockwise; None where it goes on without end, or
    nothing of it is inside."""
    length: float
    """Infinite without end."""


@dataclass(frozen=True, eq=False)
class PlaneCell:
    """One cell in the plane."""

    site: int
    """The vertex whose it is."""
    bounded: bool
    """Of the whole cell: False where it goes on without end."""
    area: float
    """Infinite of a whole cell without end."""
    corners: Doubles
    """(n, 2), counter-clockwise."""
    edges: list[PlaneEdge]
    """One for each neighbour, by index, then those on the rectangle."""


class PlaneCells(Owner):
    """Cells in the plane one after the other: whole arrays of all, and ``cells[i]``, a
    :class:`PlaneCell`. Arrays are read only.

    >>> from tetloft import DelaunayTriangulation2
    >>> plane = DelaunayTriangulation2([(0, 0), (2, 0), (0, 2), (2, 2)])
    >>> [float(area) for area in plane.cells(rectangle=[(0, 0), (2, 3)]).areas]
    [1.0, 1.0, 2.0, 2.0]
    """

    def __len__(self) -> int:
        """The number of cells."""
        return len(self.areas)

    def __getitem__(self, number: int) -> PlaneCell:
        at = index(number, len(self), "cell")
        first, last = int(self.corner_begin[at]), int(self.corner_begin[at + 1])
        edges = range(int(self.edge_begin[at]), int(self.edge_begin[at + 1]))
        return PlaneCell(int(self.sites[at]), bool(self.bounded[at]), float(self.areas[at]),
                         self.corners[first:last], [self._edge(edge, first) for edge in edges])

    def __iter__(self) -> Iterator[PlaneCell]:
        return (self[number] for number in range(len(self)))

    def _edge(self, edge: int, first_corner: int) -> PlaneEdge:
        def end(place: int) -> Optional[int]:
            return None if place == structs.NO_ID else place - first_corner

        neighbour, ends = int(self.neighbours[edge]), self.ends[edge]
        return PlaneEdge(None if neighbour == structs.NO_VERTEX else neighbour,
                         BOX_SIDES[self.sides[edge]], bool(self.inside[edge]),
                         (end(int(ends[0])), end(int(ends[1]))), float(self.lengths[edge]))

    @property
    def sites(self) -> Vertices:
        """(n,): the vertices whose they are."""
        return self._array("tetloft_plane_cells_sites")

    @property
    def bounded(self) -> Codes:
        """(n,), of the whole cells: 0 where one goes on without end."""
        return self._array("tetloft_plane_cells_bounded")

    @property
    def areas(self) -> Doubles:
        """(n,): infinite of whole cells without end."""
        return self._array("tetloft_plane_cells_areas")

    @property
    def corner_begin(self) -> Integers:
        """(n + 1,): where the corners of each cell begin."""
        return signed(self._array("tetloft_plane_cells_corner_begin"))

    @property
    def corners(self) -> Doubles:
        """(c, 2), of each cell counter-clockwise."""
        return self._array("tetloft_plane_cells_corners", 2)

    @property
    def edge_begin(self) -> Integers:
        """(n + 1,): where the edges of each cell begin."""
        return signed(self._array("tetloft_plane_cells_edge_begin"))

    @property
    def neighbours(self) -> Vertices:
        """(e,): of each edge whose cell is across; NO_VERTEX on the rectangle."""
        return self._array("tetloft_plane_cells_neighbours")

    @property
    def sides(self) -> Codes:
        """(e,): where it lies on the rectangle, a number of :data:`BOX_SIDES`."""
        return self._array("tetloft_plane_cells_sides")

    @property
    def inside(self) -> Codes:
        """(e,): 0 where nothing of it is in the rectangle."""
        return self._array("tetloft_plane_cells_inside")

    @property
    def ends(self) -> Ids:
        """(e, 2) places in ``corners``, counter-clockwise around the cell; NO_ID where an edge goes
        on without end, or nothing of it is inside."""
        return self._array("tetloft_plane_cells_ends", 2)

    @property
    def lengths(self) -> Doubles:
        """(e,): infinite without end."""
        return self._array("tetloft_plane_cells_lengths")

    def __repr__(self) -> str:
        return f"<tetloft.PlaneCells{', closed' if self.closed else f': {len(self)}'}>"
