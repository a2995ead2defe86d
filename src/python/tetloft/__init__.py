"""Solids from planar cross sections.

Closed contours in parallel planes become a tetrahedral mesh and its boundary surface, with
guarantees: manifold, cut at each section exactly its contours, embedded, with the components, and
the cavities and tunnels, that the sections imply.

    import tetloft
    stack = tetloft.read_stack("bunny.cnt")
    solid = tetloft.reconstruct(stack)
    print(solid.volume, solid.points.shape, tetloft.check(solid, stack))
    solid.write_surface("bunny.stl")

Arrays are NumPy's, without copies, where NumPy is installed, else lists. Lengths are in the units
of the input. Ids are zero-based; NO_ID means none. What is refused raises an :class:`Error` with
its place. Functions may be called from any thread; results do not depend on the number of threads.
"""

from ._changing import LOCATIONS, ConflictZone
from ._library import library_path, library_version
from ._running import Stop
from ._structs import NO_ID, NO_VERTEX
from ._version import __version__
from .checking import Failure, Figures, Guarantee, Verdict, check
from .correspondence import (
    Correspondence, Labels, Link, Links, links, parse_labels, read_labels
)
from .errors import (
    BadHandle, Cancelled, Error, FileError, InternalError, InvalidInput, OutOfMemory, Place,
    TetloftWarning, TooSmall, UnfitArithmetic, Unrepresentable, UsageError, WorkLimit
)
from .formats import (
    Description, Format, format_points, formats, parse_points, read_points, write_points
)
from .meshes import Delaunay, Mesh, Triangulation, delaunay
from .models import (
    POINT_ORIGINS, TET_KINDS, Model, Report, Surface, Topology, parse_model, read_model
)
from .periodic import PeriodicTets, periodic_delaunay, periodic_voronoi
from .plane_cells import PlaneCell, PlaneCells, PlaneEdge
from .reconstructing import LongStack, between, reconstruct
from .stacks import Nesting, Repair, Section, Stack, parse_stack, read_stack
from .triangulations import DelaunayTriangulation2, DelaunayTriangulation3
from .voronoi import (
    BOX_SIDES, NaturalNeighbours, VoronoiCell, VoronoiCells, VoronoiFace, circumsphere
)

__all__ = [
    "BOX_SIDES", "BadHandle", "Cancelled", "ConflictZone", "Correspondence", "Delaunay",
    "DelaunayTriangulation2", "DelaunayTriangulation3", "Description", "Error", "Failure",
    "Figures", "FileError", "Format", "Guarantee", "InternalError", "InvalidInput", "LOCATIONS",
    "Labels", "Link", "Links", "LongStack", "Mesh", "Model", "NO_ID", "NO_VERTEX",
    "NaturalNeighbours", "Nesting", "OutOfMemory", "POINT_ORIGINS", "PeriodicTets", "Place",
    "PlaneCell", "PlaneCells", "PlaneEdge", "Repair", "Report", "Section", "Stack", "Stop",
    "Surface", "TET_KINDS", "TetloftWarning", "TooSmall", "Topology", "Triangulation",
    "UnfitArithmetic", "Unrepresentable", "UsageError", "Verdict", "VoronoiCell", "VoronoiCells",
    "VoronoiFace", "WorkLimit", "__version__", "between", "check", "circumsphere", "delaunay",
    "format_points", "formats", "library_path", "library_version", "links", "parse_labels",
    "parse_model", "parse_points", "parse_stack", "periodic_delaunay", "periodic_voronoi",
    "read_labels", "read_model", "read_points", "read_stack", "reconstruct", "write_points",
]
