#!/usr/bin/env python3
"""Reads solids with the programs that people use, and compares them with what was written.

Usage: check_solids.py READER SOLIDS.json      READER: one of READERS

A reader is a function of a path and the name of a format, which returns a Solid, or None where it
does not read the format. What a Solid leaves as None its format, or the reader, does not tell.
Exit code 77: the reader is not installed. On Debian: python3-vtk9, python3-meshio, python3-gmsh.
"""
import json
import math
import re
import sys

SKIPPED = 77


class Solid:
    """points: triples. tets and triangles: rows of indices. tags of each: numbers of components, from
    1 on. names: by tag. text: what is told of the whole, by "name" and "unit"."""

    def __init__(self, points, tets):
        self.points = points
        self.tets = tets
        self.tet_tags = None
        self.triangles = None
        self.triangle_tags = None
        self.names = None
        self.text = None


# Readers ------------------------------------------------------------------------------------------

def read_with_vtk(path, format):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
    kinds = {"vtu": vtk.vtkXMLUnstructuredGridReader, "vtk": vtk.vtkUnstructuredGridReader}
    if format not in kinds:
        return None
    reader = kinds[format]()
    complaints = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_: complaints.append("VTK complains"))
    reader.SetFileName(path)
    reader.Update()
    if complaints:
        raise ValueError(complaints[0])
    grid = reader.GetOutput()
    for i in range(grid.GetNumberOfCells()):
        if grid.GetCellType(i) != vtk.VTK_TETRA:
            raise ValueError("a cell is no tet")
    corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    solid = Solid(vtk_to_numpy(grid.GetPoints().GetData()), corners)
    solid.tet_tags = vtk_to_numpy(grid.GetCellData().GetArray("component")) + 1
    whole = grid.GetFieldData()

    def text(array):
        values = whole.GetArray(array)
        return "" if values is None else bytes(vtk_to_numpy(values)).decode("utf-8")
    solid.text = {"name": text("name"), "unit": text("unit")}
    if text("component_names"):
        solid.names = dict(enumerate(text("component_names").split("\0"), 1))
    return solid


def read_with_meshio(path, format):
    import meshio
    import numpy
    known = {"vtu": "vtu", "vtk": "vtk", "msh": "gmsh", "msh2": "gmsh", "medit": "medit",
             "tetgen": "tetgen", "abaqus": "abaqus", "nastran": "nastran", "netgen": "netgen"}
    if format not in known:
        return None
    mesh = meshio.read(path, file_format=known[format])

    def rows(kind, size):
        blocks = [block.data for block in mesh.cells if block.type == kind]
        return numpy.concatenate(blocks) if blocks else numpy.zeros((0, size), int)

    def tags(array, kind):
        if array not in mesh.cell_data:
            return None
        return numpy.concatenate([numpy.asarray(values).reshape(-1) for values, block in
                                  zip(mesh.cell_data[array], mesh.cells) if block.type == kind])
    solid = Solid(mesh.points, rows("tetra", 4))
    if known[format] == "gmsh":
        solid.tet_tags = tags("gmsh:physical", "tetra")
        solid.triangles = rows("triangle", 3)
        solid.triangle_tags = tags("gmsh:physical", "triangle")
        solid.names = {int(tag): name for name, (tag, dimension) in mesh.field_data.items()
                       if dimension == 3}
    elif format in ("medit", "netgen"):
        array = {"medit": "medit:ref", "netgen": "netgen:index"}[format]
        solid.tet_tags = tags(array, "tetra")
        solid.triangles = rows("triangle", 3)
        solid.triangle_tags = tags(array, "triangle")
        if format == "netgen":
            solid.names = {int(tag): name for name, (tag, dimension) in mesh.field_data.items()
                           if dimension == 3}
    elif format == "abaqus":
        sets = [name for name in mesh.cell_sets if name != "ALL_ELEMENTS"]
        solid.names = dict(enumerate(sets, 1))
        solid.tet_tags = numpy.concatenate(
            [numpy.full(len(block.data), 1 + [len(mesh.cell_sets[name][i]) > 0 for name in sets]
                        .index(True)) for i, block in enumerate(mesh.cells)])
    elif format in ("tetgen", "nastran"):
        solid.tet_tags = tags(format + ":ref", "tetra")
    else:
        solid.tet_tags = tags("component", "tetra") + 1
    return solid


def read_with_gmsh(path, format):
    import gmsh
    import numpy
    if format not in ("msh", "msh2", "vtk", "medit", "nastran"):
        return None
    gmsh.initialize()
    try:
        gmsh.option.setNumber("General.Terminal", 0)
        gmsh.logger.start()
        gmsh.open(path)
        complaints = [line for line in gmsh.logger.get() if not line.startswith("Info")]
        if complaints:
            raise ValueError(complaints[0])
        numbers, coordinates, _ = gmsh.model.mesh.getNodes()
        index = {number: i for i, number in enumerate(numbers)}
        mesh = gmsh.model.mesh

        def elements(dimension, kind, size):
            rows, tags = [], []
            for _, entity in gmsh.model.getEntities(dimension):
                # Of some formats numbers become those of entities.
                groups = (gmsh.model.getPhysicalGroupsForEntity(dimension, entity)
                          if format in ("msh", "msh2") else [entity])
                _, nodes = mesh.getElementsByType(kind, entity)
                found = [[index[n] for n in nodes[i:i + size]] for i in range(0, len(nodes), size)]
                rows += found
                tags += [groups[0] if len(groups) else 0] * len(found)
            return numpy.array(rows).reshape(-1, size), numpy.array(tags)
        tets, tet_tags = elements(3, 4, 4)
        solid = Solid(coordinates.reshape(-1, 3), tets)
        if format != "vtk":  # of which it reads the tets alone
            solid.tet_tags = tet_tags
        if format in ("msh", "msh2", "medit"):
            solid.triangles, solid.triangle_tags = elements(2, 2, 3)
        if format in ("msh", "msh2"):
            volumes, surfaces = ({tag: gmsh.model.getPhysicalName(dimension, tag)
                                  for _, tag in gmsh.model.getPhysicalGroups(dimension)}
                                 for dimension in (3, 2))
            if volumes != surfaces:
                raise ValueError("volumes and surfaces have other names")
            solid.names = volumes
        return solid
    finally:
        gmsh.logger.stop()
        gmsh.finalize()


READERS = {"vtk": read_with_vtk, "meshio": read_with_meshio, "gmsh": read_with_gmsh}


# Comparison ---------------------------------------------------------------------------------------

def name_in(format, name):
    """The name as the format can hold it."""
    if format in ("abaqus", "netgen"):
        return re.sub("[^A-Z0-9]+", "_", name.upper()).strip("_")
    return name.replace('"', "'") if format in ("msh", "msh2") else name


def volume(points, tets):
    import numpy
    a, b, c, d = (points[tets[:, k]].astype(float) for k in range(4))
    return float(numpy.einsum("ij,ij->i", numpy.cross(b - a, c - a), d - a).sum() / 6)


def area(points, triangles):
    import numpy
    a, b, c = (points[triangles[:, k]].astype(float) for k in range(3))
    return float(numpy.linalg.norm(numpy.cross(b - a, c - a), axis=1).sum() / 2)


def signed_volume_of(points, triangles):
    """What closed triangles enclose: positive where they look outward."""
    import numpy
    a, b, c = (points[triangles[:, k]].astype(float) for k in range(3))
    return float(numpy.einsum("ij,ij->i", numpy.cross(a, b), c).sum() / 6)


def differences(solid, expected):
    """Pairs of what differs, as texts."""
    def compare(what, got, due):
        same = math.isclose(got, due, rel_tol=1e-9) if isinstance(due, float) else got == due
        if not same:
            yield "%s: %s where %s was written" % (what, got, due)

    yield from compare("points", len(solid.points), expected["points"])
    yield from compare("tets", len(solid.tets), expected["tets"])
    box = [float(x) for x in list(solid.points.min(axis=0)) + list(solid.points.max(axis=0))]
    if expected["format"] == "nastran":  # of 16 characters
        box = [round(x, 9) for x in box]
        expected["box"] = [round(x, 9) for x in expected["box"]]
    yield from compare("box", box, expected["box"])
    yield from compare("volume", volume(solid.points, solid.tets),
                       math.fsum(c["volume"] for c in expected["components"]))
    if solid.text is not None:
        yield from compare("text", solid.text, {key: expected[key] for key in ("name", "unit")})
    for tag, component in enumerate(expected["components"], 1):
        of = " of component %d" % tag
        if solid.tet_tags is not None:
            tets = solid.tets[solid.tet_tags == tag]
            yield from compare("tets" + of, len(tets), component["tets"])
            yield from compare("volume" + of, volume(solid.points, tets), float(component["volume"]))
        if solid.triangles is not None:
            triangles = solid.triangles[solid.triangle_tags == tag]
            yield from compare("triangles" + of, len(triangles), component["triangles"])
            yield from compare("area" + of, area(solid.points, triangles), float(component["area"]))
            yield from compare("volume enclosed" + of, signed_volume_of(solid.points, triangles),
                               float(component["volume"]))
        if solid.names is not None:
            yield from compare("name" + of, solid.names.get(tag),
                               name_in(expected["format"], component["name"]))


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in READERS:
        print(__doc__)
        return 2
    try:
        __import__("numpy")
        __import__(sys.argv[1])
    except ImportError as missing:
        print("skipped: %s" % missing)
        return SKIPPED
    read = 0
    wrong = 0
    with open(sys.argv[2], encoding="utf-8") as file:
        solids = json.load(file)
    for expected in solids:
        try:
            solid = READERS[sys.argv[1]](expected["file"], expected["format"])
            if solid is None:
                continue
            found = list(differences(solid, expected))
        except BaseException as error:  # meshio ends the program where it cannot read
            found = [repr(error)]
        read += 1
        wrong += bool(found)
        for difference in found:
            print("%s: %s" % (expected["file"], difference))
    print("%d solids read, %d of them wrong" % (read, wrong))
    return 1 if wrong or not read else 0


if __name__ == "__main__":
    sys.exit(main())
