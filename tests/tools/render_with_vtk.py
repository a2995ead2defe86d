#!/usr/bin/env python3
"""Draws models side by side into one picture, with VTK, off screen.

    xvfb-run -a /usr/bin/python3 tests/tools/render_with_vtk.py OUT.png MODEL.vtu ...

Colours tell components. `MODEL.vtu:half` cuts the front half away. Needs python3-vtk9; no test
depends on it.
"""
import sys

import vtk

PALETTE = [(0.87, 0.80, 0.66), (0.55, 0.68, 0.79), (0.66, 0.78, 0.58), (0.82, 0.60, 0.55)]
SIZE = 480


def surface(path, half):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(path)
    source = reader
    if half:
        reader.Update()
        bounds = reader.GetOutput().GetBounds()
        plane = vtk.vtkPlane()
        plane.SetOrigin([(bounds[2 * i] + bounds[2 * i + 1]) / 2 for i in range(3)])
        plane.SetNormal(-1, 1, 0)
        source = vtk.vtkClipDataSet()
        source.SetClipFunction(plane)
        source.SetInputConnection(reader.GetOutputPort())
    skin = vtk.vtkDataSetSurfaceFilter()
    skin.SetInputConnection(source.GetOutputPort())
    skin.Update()
    mesh = skin.GetOutput()
    component = mesh.GetCellData().GetArray("component")
    colours = vtk.vtkUnsignedCharArray()
    colours.SetNumberOfComponents(3)
    for i in range(mesh.GetNumberOfCells()):
        colour = PALETTE[int(component.GetTuple1(i)) % len(PALETTE)]
        colours.InsertNextTuple3(*[int(255 * c) for c in colour])
    mesh.GetCellData().SetScalars(colours)
    return mesh


def main():
    out, models = sys.argv[1], sys.argv[2:]
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(SIZE * len(models), SIZE)
    for i, model in enumerate(models):
        path, _, half = model.partition(":")
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputData(surface(path, half == "half"))
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetInterpolationToFlat()
        renderer = vtk.vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        renderer.SetViewport(i / len(models), 0, (i + 1) / len(models), 1)
        renderer.AddActor(actor)
        camera = renderer.GetActiveCamera()
        camera.SetPosition(1, -1, 0.55)
        camera.SetViewUp(0, 0, 1)
        renderer.ResetCamera()
        camera.Zoom(1.1)
        window.AddRenderer(renderer)
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(out)
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()


main()
