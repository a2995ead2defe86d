#!/usr/bin/env python3
"""Surfaces as the tools see them that people use.

read_surfaces.py TOOL WRITER: the files of WRITER (write_surfaces), read by TOOL: archive, lib3mf,
assimp, vtk, meshio or admesh. Ends with 77 where the tool is not there.
"""
import ctypes
import ctypes.util
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as tree
import zipfile

# Of the tolerances below 1e-9 is that of doubles; 1e-2 of float32, or six digits, 1000 away from the
# origin; 1e-3 of their sums, in which the least component weighs little.

# By component: the volume and the area of its box, in mm; and what it is called.
TITLE = "left \"lung\" & <b>'x'</b> \\"
VOLUMES = [6, 24, 0.125]
AREAS = [22, 52, 1.5]
NAMES = ["Läsion 肝", "two\nlines\t\x01 #1, 100%", TITLE + " 4"]
ONE_LINE = [NAMES[0], "two\\x0alines\\x09\\x01 #1, 100%", NAMES[2]]


def skip(why):
    print("skipped:", why)
    sys.exit(77)


def check(condition, *what):
    if not condition:
        raise AssertionError(what)


def near(values, expected, tolerance):
    check(len(values) == len(expected), values, expected)
    for a, b in zip(values, expected):
        check(abs(a - b) <= tolerance * abs(b), values, expected)


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def figures(points, triangles):
    """Volume and area."""
    volume = area = 0
    origin = points[triangles[0][0]]
    for t in triangles:
        a, b, c = (minus(points[i], origin) for i in t)
        volume += dot(a, cross(b, c)) / 6
        area += math.sqrt(dot(*[cross(minus(b, a), minus(c, a))] * 2)) / 2
    return volume, area


def expect_parts(parts, tolerance=1e-9, scale=1.0):
    """Each of points and triangles, in the order of the components."""
    found = [figures(points, triangles) for points, triangles in parts]
    near([v for v, _ in found], [v * scale ** 3 for v in VOLUMES], tolerance)
    near([a for _, a in found], [a * scale ** 2 for a in AREAS], tolerance)


def in_file_order(points, triangles):
    """The parts of a file that tells them by the order of its triangles alone."""
    check(len(triangles) == 36, len(triangles))
    return [(points, triangles[k:k + 12]) for k in (0, 12, 24)]


def solid_points(folder):
    """Of the .vtu, which lie where the patient lay."""
    with open(os.path.join(folder, "solid.vtu"), "rb") as file:
        data = file.read()
    head = data[:data.index(b"<AppendedData")].decode()
    tag = re.search(r'<DataArray[^>]*Name="Points"[^>]*offset="(\d+)"', head)
    at = data.index(b"_", len(head)) + 1 + int(tag.group(1))
    size, = struct.unpack_from("<Q", data, at)
    values = struct.unpack_from("<%dd" % (size // 8), data, at + 8)
    return {values[k:k + 3] for k in range(0, len(values), 3)}


def read_archive(folder):
    path = os.path.join(folder, "binary.3mf")
    if shutil.which("unzip"):
        subprocess.run(["unzip", "-tq", path], check=True)
    with zipfile.ZipFile(path) as archive:
        check(archive.testzip() is None)
        names = archive.namelist()
        check(names == ["[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model"], names)
        parsed = [tree.fromstring(archive.read(name)) for name in names]
    core = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
    model = parsed[2]
    check(model.get("unit") == "millimeter")
    check(model.find(core + "metadata[@name='Title']").text == TITLE)
    parts, points = [], set()
    objects = model.findall(core + "resources/" + core + "object")
    for each in objects:
        vertices = [tuple(float(v.get(c)) for c in "xyz") for v in each.iter(core + "vertex")]
        points.update(vertices)
        parts.append((vertices, [[int(t.get(c)) for c in ("v1", "v2", "v3")]
                                 for t in each.iter(core + "triangle")]))
    check([each.get("name") for each in objects] == ONE_LINE)
    expect_parts(parts)
    check(points == solid_points(folder))


class Lib3mf:
    """Of its C interface what is needed; a call that fails is an error."""

    def __init__(self, library):
        self.library = library

    def __call__(self, name, *arguments):
        result = getattr(self.library, "lib3mf_" + name)(*arguments)
        check(result == 0, name, hex(result & 0xFFFFFFFF))

    def pointer(self, name, *arguments):
        made = ctypes.c_void_p()
        self(name, *arguments, ctypes.byref(made))
        return made

    def number(self, name, *arguments):
        value = ctypes.c_uint32()
        self(name, *arguments, ctypes.byref(value))
        return value.value

    def text(self, name, *arguments):
        buffer = ctypes.create_string_buffer(1000)
        self(name, *arguments, buffer, 1000, ctypes.byref(ctypes.c_uint32()))
        return buffer.value.decode()


def read_lib3mf(folder):
    found = ctypes.util.find_library("3MF")
    if not found:
        skip("no lib3MF")
    lib = Lib3mf(ctypes.CDLL(found))
    model = lib.pointer("createmodel")
    reader = lib.pointer("model_queryreader", model, b"3mf")
    lib("reader_setstrictmodeactive", reader, 1)
    lib("reader_readfromfileutf8", reader, os.path.join(folder, "binary.3mf").encode())
    check(lib.number("reader_getwarningcount", reader) == 0)
    check(lib.number("model_getunit", model) == 1)  # MODELUNIT_MILLIMETER
    objects = lib.pointer("model_getmeshobjects", model)
    names, parts = [], []
    while lib.number("resourceiterator_movenext", objects):
        mesh = lib.pointer("resourceiterator_getcurrent", objects)
        names.append(lib.text("object_getnameutf8", mesh))
        check(lib.number("meshobject_ismanifoldandoriented", mesh) == 1)
        points = []
        for k in range(lib.number("meshobject_getvertexcount", mesh)):
            point = (ctypes.c_float * 3)()
            lib("meshobject_getvertex", mesh, k, point)
            points.append(list(point))
        triangles = []
        for k in range(lib.number("meshobject_gettrianglecount", mesh)):
            corners = (ctypes.c_uint32 * 3)()
            lib("meshobject_gettriangle", mesh, k, corners)
            triangles.append(list(corners))
        check(len(points) == 8 and len(triangles) == 12)
        parts.append((points, triangles))
    check(names == ONE_LINE, names)
    expect_parts(parts, 1e-2)  # its coordinates are float32


def read_obj_parts(path):
    """Names of groups, and the runs of faces: what assimp exports."""
    points, names, parts, running = [], [], [], False
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if line.startswith("v "):
                points.append([float(w) for w in words[1:4]])
            elif line.startswith("g "):
                names.append(line[2:].rstrip("\n"))
            elif line.startswith("f "):
                if not running:
                    parts.append((points, []))
                parts[-1][1].append([int(w.split("/")[0]) - 1 for w in words[1:]])
            running = line.startswith("f ")
    return names, parts


def read_assimp(folder):
    if not shutil.which("assimp"):
        skip("no assimp")
    for name in ("binary.glb", "binary.3mf", "binary.obj", "binary.ply", "text.ply", "binary.stl",
                 "text.stl", "binary.off"):
        out = os.path.join(folder, "by_assimp.obj")
        told = subprocess.run(["assimp", "export", os.path.join(folder, name), out],
                              stdout=subprocess.PIPE, universal_newlines=True)
        check(told.returncode == 0, name, told.stdout)
        names, parts = read_obj_parts(out)
        if name == "binary.stl" or name.endswith((".ply", ".off")):
            check(len(parts) == 1, name, names)
            parts = in_file_order(*parts[0])
        expect_parts(parts, 1e-2, 0.001 if name.endswith(".glb") else 1.0)
        if name == "binary.glb":
            check(names[0] == NAMES[0] and names[2] == NAMES[2], names)
        if name == "binary.obj":
            check(names == [n.replace(" ", "_") for n in ONE_LINE], names)


def read_vtk(folder):
    try:
        import vtk
    except ImportError:
        skip("no VTK")
    readers = {"stl": vtk.vtkSTLReader, "ply": vtk.vtkPLYReader, "obj": vtk.vtkOBJReader,
               "vtp": vtk.vtkXMLPolyDataReader}

    def measured(surface):
        clean = vtk.vtkCleanPolyData()
        clean.SetInputData(surface)
        clean.PointMergingOn()
        edges = vtk.vtkFeatureEdges()
        edges.SetInputConnection(clean.GetOutputPort())
        edges.FeatureEdgesOff()
        edges.ManifoldEdgesOff()
        edges.Update()
        check(edges.GetOutput().GetNumberOfCells() == 0, "open edges")
        mass = vtk.vtkMassProperties()
        mass.SetInputConnection(clean.GetOutputPort())
        mass.Update()
        return [mass.GetVolume(), mass.GetSurfaceArea()]

    for name in ("binary.stl", "text.stl", "binary.ply", "text.ply", "binary.obj", "binary.vtp",
                 "text.vtp"):
        reader = readers[name.split(".")[1]]()
        reader.SetFileName(os.path.join(folder, name))
        if name == "text.stl":
            reader.ScalarTagsOn()
        reader.Update()
        surface = reader.GetOutput()
        check(surface.GetNumberOfCells() == 36, name, surface.GetNumberOfCells())
        near(measured(surface), [sum(VOLUMES), sum(AREAS)], 1e-3)
        groups = {"text.stl": "STLSolidLabeling", "binary.vtp": "component"}.get(name)
        if groups:
            values = surface.GetCellData().GetArray(groups)
            counts = {}
            for k in range(36):
                counts[values.GetValue(k)] = counts.get(values.GetValue(k), 0) + 1
            check(list(counts.values()) == [12, 12, 12], name, counts)
        if name.endswith(".vtp"):  # texts as bytes of UTF-8
            texts = {}
            for k in range(surface.GetFieldData().GetNumberOfArrays()):
                array = surface.GetFieldData().GetArray(k)
                texts[array.GetName()] = bytes(
                    array.GetValue(i) for i in range(array.GetNumberOfValues())).decode()
            check(texts == {"name": TITLE, "unit": "mm", "orientation": "LPS",
                            "component_names": NAMES[0] + "\0" + NAMES[1].replace("\x01", "\ufffd")
                                               + "\0\0"}, texts)
    if not hasattr(vtk, "vtkGLTFReader"):
        return
    reader = vtk.vtkGLTFReader()
    reader.SetFileName(os.path.join(folder, "binary.glb"))
    reader.ApplyDeformationsToGeometryOn()
    reader.Update()
    found, turned = [], []
    blocks = reader.GetOutput().NewIterator()
    while not blocks.IsDoneWithTraversal():
        surface = blocks.GetCurrentDataObject()
        found.append(measured(surface))
        turned += [surface.GetPoint(k) for k in range(surface.GetNumberOfPoints())]
        blocks.GoToNextItem()
    near([v for v, _ in found], [v * 1e-9 for v in VOLUMES], 1e-2)
    near([a for _, a in found], [a * 1e-6 for a in AREAS], 1e-2)
    expected = [(x / 1000, z / 1000, -y / 1000) for x, y, z in solid_points(folder)]
    for axis in range(3):
        for end in (min, max):
            near([end(p[axis] for p in turned)], [end(p[axis] for p in expected)], 1e-6)


def read_meshio(folder):
    try:
        import meshio
    except ImportError:
        skip("no meshio")
    for name in ("binary.stl", "text.stl", "binary.ply", "text.ply", "binary.obj", "binary.off"):
        mesh = meshio.read(os.path.join(folder, name))
        points = mesh.points.tolist()
        blocks = [(points, block.data.tolist()) for block in mesh.cells]
        if name == "binary.obj":
            check(len(blocks) == 3, name)
        parts = blocks if name == "binary.obj" else in_file_order(*blocks[0])
        expect_parts(parts, 1e-2 if "stl" in name else 1e-9)


def read_admesh(folder):
    if not shutil.which("admesh"):
        skip("no admesh")
    told = subprocess.run(["admesh", os.path.join(folder, "binary.stl")], stdout=subprocess.PIPE,
                          universal_newlines=True, check=True).stdout
    check(re.search(r"Number of parts\s*:\s*3\b", told), told)
    check(re.search(r"All facets connected\.|Facets with 1 disconnected edge\s*:\s*0", told), told)
    near([float(re.search(r"Volume\s*:\s*([-+.\de]+)", told).group(1))], [sum(VOLUMES)], 1e-3)


def main():
    read = globals()["read_" + sys.argv[1]]
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[2], folder], check=True)
        read(folder)
    return 0


if __name__ == "__main__":
    sys.exit(main())
