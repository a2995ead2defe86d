"""Models: points and tets, where they come from, their boundary, files and pictures."""

from __future__ import annotations

import ctypes
from ctypes import c_double, c_int64, c_size_t, c_uint32
from typing import Any, NamedTuple, Optional

from . import _structs as structs
from ._arrays import ArrayLike, Codes, Doubles, Ids, doubles, ids, view
from ._handles import Handle, Owner, Warnings
from ._library import _text, lib
from ._options import (
    Path, choice, defaults, index, path_bytes, read_options, text, whole, write_options
)
from ._running import Progress, Run, Stop
from .errors import UsageError
from .formats import (
    Data, Description, Source, as_bytes, bytes_of, description_of, format_bytes, opened_file
)
from .meshes import Mesh
from .stacks import Stack


def _names(function: Any) -> tuple[str, ...]:
    names: list[str] = []
    while (name := _text(function(len(names)))) != "unknown":
        names.append(name)
    return tuple(names)


TET_KINDS = _names(lib.tetloft_tet_kind_name)
"""What the numbers of Model.kinds mean."""
POINT_ORIGINS = _names(lib.tetloft_point_origin_name)
"""What the numbers of Model.point_origins mean."""


class Report(NamedTuple):
    """What a reconstruction tells of itself."""

    slices: int
    """Given sections."""
    sections_between: int
    """Put between them."""
    sections_given_up: int
    """Of slabs that they did not fit."""
    contours: int
    input_vertices: int
    split_vertices: int
    """Inserted on contours."""
    dividing_vertices: int
    """Of these, the ones that divide coarse contours."""
    vertices: int
    tets: int
    components: int
    volume: float
    """In cubed units of the stack."""
    smallest_lift: float
    """1/2 or more is ideal; 1 without lifted vertices."""
    work: int
    """What was done, whatever the clock and the threads: tets looked at."""
    seconds: float
    """By the clock."""


class Topology(NamedTuple):
    """Of one component of a boundary."""

    vertices: int
    edges: int
    triangles: int
    genus: int
    """The number of handles."""


class Surface(Owner):
    """The boundary of a model: triangles over the model's points, normals outwards."""

    _model: Model

    @property
    def points(self) -> Doubles:
        """(n, 3): those of the model, all of them; read only."""
        return self._model.points

    @property
    def triangles(self) -> Ids:
        """(m, 3) point ids, read only."""
        return self._array("tetloft_surface_triangles", 3)

    @property
    def tets(self) -> Ids:
        """The tet behind each triangle, read only."""
        return self._array("tetloft_surface_tets")

    def _components(self) -> tuple[Ids, int]:
        handle = self._open()
        if "components" not in self._arrays:
            pointer, count, components = ctypes.POINTER(c_uint32)(), c_size_t(), c_size_t()
            lib.tetloft_surface_components(handle, ctypes.byref(pointer), ctypes.byref(count),
                                           ctypes.byref(components))
            self._arrays["components"] = (view(pointer, count.value, 1, handle), components.value)
        return self._arrays["components"]

    @property
    def components(self) -> Ids:
        """The component, of the surface, of each triangle; read only."""
        return self._components()[0]

    @property
    def component_count(self) -> int:
        """Parts of the surface that hang together."""
        return self._components()[1]

    def topology(self, component: int = 0) -> Topology:
        """Of one component."""
        component = index(component, self.component_count, "component")
        vertices, edges, triangles, genus = c_size_t(), c_size_t(), c_size_t(), c_int64()
        lib.tetloft_surface_topology(self._open(), component, ctypes.byref(vertices),
                                     ctypes.byref(edges), ctypes.byref(triangles),
                                     ctypes.byref(genus))
        return Topology(vertices.value, edges.value, triangles.value, genus.value)

    def __len__(self) -> int:
        """The number of triangles."""
        return len(self.triangles)

    def __repr__(self) -> str:
        if self.closed:
            return "<tetloft.Surface, closed>"
        return f"<tetloft.Surface of {len(self)} triangles, {self.component_count} components>"


class Model(Owner):
    """A solid: points and tets, with what each comes from if it was reconstructed.

    ``Model(points, tets)``, of (n, 3) coordinates and (m, 4) point ids, is any mesh, to be checked,
    written or drawn. Arrays are read only, and views on the library's memory; those that a model
    does not have are empty.

    >>> corner = Model([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 1, 2, 3)])
    >>> corner, round(corner.volume * 6, 9)
    (<tetloft.Model of 1 tets, 4 points>, 1.0)
    """

    def __init__(self, points: ArrayLike, tets: ArrayLike):
        corners, cells, handle = doubles(points, 3, "points"), ids(tets, 4, "tets"), Handle("model")
        lib.tetloft_model_create(corners.pointer, corners.rows, cells.pointer, cells.rows,
                                 handle.out)
        self._take(handle)

    # --- arrays ----------------------------------------------------------------------------------

    @property
    def points(self) -> Doubles:
        """(n, 3) coordinates x, y, z, in units of the stack."""
        return self._array("tetloft_model_points", 3)

    @property
    def tets(self) -> Ids:
        """(m, 4) point ids; (b - a) × (c - a) · (d - a) > 0 for each tet a, b, c, d."""
        return self._array("tetloft_model_tets", 4)

    @property
    def components(self) -> Ids:
        """(m,): the component of each tet."""
        return self._array("tetloft_model_tet_components")

    @property
    def slabs(self) -> Ids:
        """(m,): the slab of each tet, between sections ``slab`` and ``slab + 1``."""
        return self._array("tetloft_model_tet_slabs")

    @property
    def kinds(self) -> Codes:
        """(m,): what each tet was cut from, an index of TET_KINDS."""
        return self._array("tetloft_model_tet_kinds")

    @property
    def point_sections(self) -> Ids:
        """(n,): the section that each point lies in, NO_ID between sections."""
        return self._array("tetloft_model_point_sections")

    @property
    def point_contours(self) -> Ids:
        """(n,): the contour that each point lies on, NO_ID off them."""
        return self._array("tetloft_model_point_contours")

    @property
    def point_origins(self) -> Codes:
        """(n,): how each point came to be, an index of POINT_ORIGINS."""
        return self._array("tetloft_model_point_origins")

    # --- figures and parts -----------------------------------------------------------------------

    def __len__(self) -> int:
        """The number of tets."""
        return len(self.tets)

    @property
    def component_count(self) -> int:
        """Parts that hang together; 0 where the model does not know."""
        count = c_size_t()
        lib.tetloft_model_component_count(self._open(), ctypes.byref(count))
        return count.value

    @property
    def description(self) -> Description:
        """What it is of, as its stack's file says."""
        return description_of(lib.tetloft_model_description, self._open())

    @property
    def component_names(self) -> list[str]:
        """What files call the components."""
        names = []
        for component in range(self.component_count):
            name = Handle("bytes")
            lib.tetloft_model_component_name(self._open(), component, name.out)
            names.append(bytes_of(name).decode("utf-8", "replace"))
        return names

    def component(self, number: int) -> Model:
        """One component as a model of its own; without links, which speak of all."""
        part = Handle("model")
        lib.tetloft_model_component(self._open(), index(number, self.component_count, "component"),
                                    part.out)
        return Model._of(part)

    @property
    def volume(self) -> float:
        """In cubed units of the stack; summed anew each time."""
        volume = c_double()
        lib.tetloft_model_volume(self._open(), ctypes.byref(volume))
        return volume.value

    @property
    def report(self) -> Optional[Report]:
        """What the reconstruction tells; None for a model that was read or made from arrays."""
        raw = structs.Report(version=structs.Report.VERSION)
        try:
            lib.tetloft_model_report(self._open(), ctypes.byref(raw))
        except UsageError:
            return None
        return Report(*(getattr(raw, name) for name in Report._fields))

    def boundary(self) -> Surface:
        """The boundary surface; refused where a face belongs to more than two tets."""
        made = Handle("surface")
        lib.tetloft_model_boundary(self._open(), made.out)
        surface = Surface._of(made)
        surface._model = self.__copy__()
        return surface

    def mesh(self) -> Mesh:
        """Its tets with neighbours, star and link, the vertices being its points."""
        made = Handle("mesh")
        lib.tetloft_model_mesh(self._open(), made.out)
        return Mesh._of(made)

    def __repr__(self) -> str:
        if self.closed:
            return "<tetloft.Model, closed>"
        text = f"<tetloft.Model of {len(self)} tets, {len(self.points)} points"
        count = self.component_count
        return text + (f", {count} components>" if count else ">")

    # --- files and pictures ----------------------------------------------------------------------

    def write(self, path: Path, *, format: Optional[str] = None, ascii: bool = False,
              compress: bool = False) -> None:
        """Writes points, tets and what the format can hold of all that is known about them, in the
        format of the extension (formats() lists them), or the one named. ``ascii``: numbers as
        text; ``compress``: as zlib streams; where the format has that."""
        warnings = Warnings()
        lib.tetloft_model_write(self._open(), path_bytes(path),
                                write_options(format, ascii, compress), warnings.out)
        warnings.tell()

    def to_bytes(self, format: str = "vtu", *, ascii: bool = False,
                 compress: bool = False) -> bytes:
        """The bytes of such a file."""
        return format_bytes(lib.tetloft_model_format, self._open(),
                            write_options(format, ascii, compress))

    def write_surface(self, path: Path, *, format: Optional[str] = None, ascii: bool = False,
                      compress: bool = False) -> None:
        """Writes the boundary alone: .stl, .obj, .glb and what else formats() lists."""
        warnings = Warnings()
        lib.tetloft_model_write_surface(self._open(), path_bytes(path),
                                        write_options(format, ascii, compress), warnings.out)
        warnings.tell()

    def surface_to_bytes(self, format: str = "stl", *, ascii: bool = False,
                         compress: bool = False) -> bytes:
        """The bytes of such a file."""
        return format_bytes(lib.tetloft_model_format_surface, self._open(),
                            write_options(format, ascii, compress))

    def render(self, path: Path, stack: Optional[Stack] = None, *, colour: str = "component",
               azimuth: Optional[float] = None, elevation: Optional[float] = None,
               width: Optional[int] = None, height: Optional[int] = None,
               cut: Optional[tuple[str, float]] = None, explode: float = 0, stretch: float = 1,
               edges: bool = False, contours: bool = True, white: bool = False,
               title: Optional[str] = None, threads: int = 0,
               progress: Optional[Progress] = None, stop: Optional[Stop] = None) -> None:
        """A picture (.png, .svg), or a page with a viewer (.html), by the extension.

        ``stack``: whose contours are drawn. ``colour``: by "component", "slab", "kind", "dihedral"
        or "evidence". ``azimuth`` and ``elevation`` of the eye in degrees; ``width`` and ``height``
        in pixels. ``cut``, ("z", 5.0): what is nearer than that plane is left out. ``explode``:
        slabs are moved apart by so many mean heights; ``stretch``: z is drawn so many times as
        large.
        """
        run = Run(threads, progress, stop)
        options = defaults(structs.RenderOptions, "render_options")
        options.colour = choice(structs.COLOUR, colour, "colour")
        for name, degrees in (("azimuth", azimuth), ("elevation", elevation)):
            if degrees is not None:
                setattr(options, name, degrees)
        for name, pixels in (("width", width), ("height", height)):
            if pixels is not None:
                setattr(options, name, whole(pixels, name))
        if cut is not None:
            options.cut_axis = choice({"x": 0, "y": 1, "z": 2}, cut[0], "cut")
            options.cut_position = cut[1]
        options.explode, options.stretch = explode, stretch
        options.edges, options.contours, options.white = bool(edges), bool(contours), bool(white)
        if title is not None:
            options.title = text(title, "title")
        options.execution = run.pointer
        contours_of = None if stack is None else Stack._handle_of(stack, "stack")
        run.call(lib.tetloft_model_render, self._open(), contours_of, path_bytes(path),
                 ctypes.byref(options))

    def __reduce__(self) -> Any:
        return _unpickled, (self.to_bytes("vtu"), self.warnings)


def _unpickled(vtu: bytes, warnings: tuple[str, ...]) -> Model:
    model = parse_model(vtu, format="vtu")
    model.warnings = warnings
    return model


def read_model(source: Source, *, format: Optional[str] = None) -> Model:
    """The model of a file: a path, or one opened for bytes. The format is recognised, or named."""
    opened = opened_file(source)
    if opened:
        return parse_model(*opened, format=format)
    made, warnings = Handle("model"), Warnings()
    lib.tetloft_model_read(path_bytes(source), read_options(format), made.out, warnings.out)
    return Model._of(made, warnings.tell())


def parse_model(data: Data, name: str = "", *, format: Optional[str] = None) -> Model:
    """The same from bytes; ``name`` stands for the file in messages, and tells the extension."""
    made, warnings, given = Handle("model"), Warnings(), as_bytes(data)
    lib.tetloft_model_parse(given, len(given), text(name, "name"), read_options(format), made.out,
                            warnings.out)
    return Model._of(made, warnings.tell())
