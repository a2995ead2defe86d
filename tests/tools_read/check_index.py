#!/usr/bin/env python3
"""Makes a .pvtu over pieces, and reads it with VTK: the tets and the volume of the joined solid.

Usage: check_index.py TETLOFT DATA FOLDER      DATA: the folder of samples; FOLDER is made anew
Exit code 77: VTK is not installed. On Debian: python3-vtk9.
"""
import os
import shutil
import subprocess
import sys

SKIPPED = 77
PLATE = "v 4 z {}\n{{ -1000 0 -800 0 -800 100 -1000 100 }}\n"


def read(path):
    import vtk
    kinds = {".vtu": vtk.vtkXMLUnstructuredGridReader, ".pvtu": vtk.vtkXMLPUnstructuredGridReader}
    reader = kinds[os.path.splitext(path)[1]]()
    complaints = []
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_: complaints.append("VTK complains of " + path))
    reader.SetFileName(path)
    reader.Update()
    if complaints:
        raise ValueError(complaints[0])
    return reader.GetOutput()


def volumes(grid):
    """Of each tet, in order."""
    from vtk.util.numpy_support import vtk_to_numpy
    import numpy
    points = vtk_to_numpy(grid.GetPoints().GetData())
    tets = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    a, b, c, d = (points[tets[:, i]] for i in range(4))
    return numpy.einsum("ij,ij->i", numpy.cross(b - a, c - a), d - a) / 6


def fields(data):
    return {data.GetArrayName(k) for k in range(data.GetNumberOfArrays())}


def compare(whole, listed):
    import numpy
    from vtk.util.numpy_support import vtk_to_numpy
    if numpy.any(volumes(whole) != volumes(listed)):
        raise ValueError("the tets differ")
    for name in ("component", "slab", "kind"):
        a, b = (vtk_to_numpy(grid.GetCellData().GetArray(name)) for grid in (whole, listed))
        if numpy.any(a != b):
            raise ValueError(name + " differs")
    if not {"section", "contour", "origin"} <= fields(listed.GetPointData()):
        raise ValueError("fields of points are lost")


def check(tetloft, folder, stack, cuts, options):
    def run(*words):
        subprocess.run([tetloft, *words, "--quiet"], check=True)
    plan, whole, index = (os.path.join(folder, name) for name in ("plan", "whole.vtu", "all.pvtu"))
    run("plan", stack, "-o", plan, *options)
    pieces = []
    for first, end in zip(cuts, cuts[1:]):
        pieces.append(os.path.join(folder, f"piece{first}.vtu"))
        run("reconstruct", stack, "--plan", plan, "--slabs", f"{first}:{end}", "-o", pieces[-1])
    run("join", *pieces, "-o", whole, "--plan", plan)
    run("join", *pieces, "--index", "-o", index, "--plan", plan)
    compare(read(whole), read(index))


def main():
    tetloft, data, folder = sys.argv[1:]
    try:
        import vtk  # noqa: F401
    except ImportError:
        print("skipped: VTK is not installed")
        return SKIPPED
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    torus = os.path.join(data, "torus.cnt")
    check(tetloft, folder, torus, [0, 4, 11, 19], ["--ends", "half"])
    # Sections without contours: a piece without a tet.
    gap = os.path.join(folder, "gap.cnt")
    with open(gap, "w", encoding="ascii") as file:
        file.write("S 6\n" + PLATE.format(0) + PLATE.format(1) + "v 0 z 2\nv 0 z 3\n" +
                   PLATE.format(4) + PLATE.format(5))
    check(tetloft, folder, gap, [0, 2, 3, 5], [])
    # Slabs that are left open.
    with open(os.path.join(data, "cases", "shielded.cnt"), encoding="ascii") as file:
        slab = file.read().split("\n", 1)[1]
    stack, labels = (os.path.join(folder, name) for name in ("open.cnt", "open.labels"))
    with open(stack, "w", encoding="ascii") as file:
        file.write("S 10\n" + "".join(PLATE.format(z) for z in range(-4, 0)) + slab + "\n" +
                   "".join(PLATE.format(z) for z in range(2, 6)))
    with open(labels, "w", encoding="ascii") as file:
        file.write("4 0 1\n4 1 3\n5 0 1\n5 1 2\n")
    check(tetloft, folder, stack, [0, 4, 9],
          ["--no-divide", "--correspondence", "overlap", "--labels", labels])
    if not os.path.exists(os.path.join(folder, "all_1.vtu")):
        raise ValueError("no piece was written anew")
    return 0


if __name__ == "__main__":
    sys.exit(main())
