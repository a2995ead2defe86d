#!/usr/bin/env python3
"""Reads files written by tetloft with VTK's own readers and prints what VTK sees.

Usage: read_with_vtk.py FILE…     (.vtu .vtp .ply .stl .obj)

For grids: cells by type, volume, data arrays. For surfaces: open, non-manifold edges and
the enclosed volume. A tool for people; no test needs it. On Debian: python3-vtk9.
"""
import os
import sys

import vtk


def read(path):
    readers = {
        ".vtu": vtk.vtkXMLUnstructuredGridReader,
        ".vtp": vtk.vtkXMLPolyDataReader,
        ".ply": vtk.vtkPLYReader,
        ".stl": vtk.vtkSTLReader,
        ".obj": vtk.vtkOBJReader,
    }
    reader = readers[os.path.splitext(path)[1].lower()]()
    errors = []
    reader.AddObserver("ErrorEvent", lambda *_: errors.append("error"))
    reader.AddObserver("WarningEvent", lambda *_: errors.append("warning"))
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput(), errors


def arrays(data):
    return ", ".join(
        "%s %s %s" % (
            data.GetArray(i).GetName(),
            data.GetArray(i).GetDataTypeAsString(),
            data.GetArray(i).GetRange(),
        )
        for i in range(data.GetNumberOfArrays())
        if data.GetArray(i) is not None
    )


def describe_grid(grid):
    types = vtk.vtkCellTypes()
    grid.GetCellTypes(types)
    names = [vtk.vtkCellTypes.GetClassNameFromTypeId(types.GetCellType(i))
             for i in range(types.GetNumberOfTypes())]
    volume = 0.0
    for i in range(grid.GetNumberOfCells()):
        p = [grid.GetPoint(grid.GetCell(i).GetPointId(k)) for k in range(4)]
        volume += vtk.vtkTetra.ComputeVolume(*p)
    print("  points %d (%s), cells %d %s, volume %.17g" % (
        grid.GetNumberOfPoints(), grid.GetPoints().GetData().GetDataTypeAsString()
        if grid.GetPoints() else "none", grid.GetNumberOfCells(), names, volume))
    print("  cell data:  " + arrays(grid.GetCellData()))
    print("  point data: " + arrays(grid.GetPointData()))


def describe_surface(surface):
    edges = vtk.vtkFeatureEdges()
    edges.SetInputData(surface)
    edges.BoundaryEdgesOn()
    edges.NonManifoldEdgesOn()
    edges.FeatureEdgesOff()
    edges.ManifoldEdgesOff()
    edges.Update()
    mass = vtk.vtkMassProperties()
    mass.SetInputData(surface)
    mass.Update()
    print("  points %d (%s), polygons %d, open or non-manifold edges %d, volume %.9g" % (
        surface.GetNumberOfPoints(), surface.GetPoints().GetData().GetDataTypeAsString(),
        surface.GetNumberOfPolys(), edges.GetOutput().GetNumberOfCells(), mass.GetVolume()))
    for name, data in (("cell", surface.GetCellData()), ("point", surface.GetPointData())):
        if data.GetNumberOfArrays():
            print("  %s data: %s" % (name, arrays(data)))


def main():
    bad = False
    for path in sys.argv[1:]:
        print(path)
        output, errors = read(path)
        if errors:
            print("  VTK complains: " + ", ".join(errors))
            bad = True
        if isinstance(output, vtk.vtkUnstructuredGrid):
            describe_grid(output)
        else:
            describe_surface(output)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
