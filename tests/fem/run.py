#!/usr/bin/env python3
"""Finite elements on solids as `tetloft reconstruct` writes them: a bar whose solution is known,
and an animal under its own weight and under water (CalculiX, from .inp); a Poisson problem whose
solution is known (GetFEM, from .mesh).

run.py TETLOFT DATA bar|weight|pressure|poisson; exit code 77 where a package is not installed.
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

import decks

try:
    import numpy
    import getfem
except ImportError:
    numpy = getfem = None

NOT_THERE = 77
PRINTED = 1e-6  # of a number that CalculiX prints, in seven digits


def tetloft(*arguments):
    run = subprocess.run([sys.argv[1], *map(str, arguments)], capture_output=True, text=True,
                         check=True)
    return run.stdout


def expect(what, value, due, tolerance):
    """Within a relative tolerance; each is told."""
    print(f"{what}: {value:.10g}, due {due:.10g}")
    if not abs(value - due) <= tolerance * abs(due):
        raise AssertionError(f"{what} is {value!r} where {due!r} is due")


def write_bar(path, width, heights):
    """A square prism of a contour with eight vertices at each height."""
    square = [(0, 0), (1, 0), (2, 0), (2, 1), (2, 2), (1, 2), (0, 2), (0, 1)]
    text = f"S {len(heights)}\n"
    for z in heights:
        text += f"v {len(square)} z {z}\n{{\n"
        text += "".join(f"{x * width / 2} {y * width / 2}\n" for x, y in square) + "}\n"
    pathlib.Path(path).write_text(text, encoding="utf-8")


def elastic(young, poisson, density=None):
    text = f"*MATERIAL, NAME=M\n*ELASTIC\n{young}, {poisson}\n"
    if density is not None:
        text += f"*DENSITY\n{density}\n"
    return text + "*SOLID SECTION, ELSET=ALL_ELEMENTS, MATERIAL=M\n"


def bar(folder):
    """Uniaxial tension: stress F / A, displacement F z / (E A), contraction by Poisson's ratio."""
    width, length, young, poisson, force = 2.0, 10.0, 200.0, 0.25, 50.0
    write_bar(folder / "bar.cnt", width, [0, 2, 5, 6, 10])
    tetloft("reconstruct", folder / "bar.cnt", "-o", folder / "bar.inp", "--quiet")
    mesh = decks.read_mesh(folder / "bar.inp")
    stress = force / width**2
    bottom = [n for n, p in mesh.points.items() if p[2] == 0]
    at = {p: n for n, p in mesh.points.items()}
    pulled = [f for f in mesh.faces if all(p[2] == length for p in decks.corners(mesh, f))]
    # The plane z = 0 stays plane; one corner stays, another does not turn about it.
    before = (elastic(young, poisson) + decks.node_set("BOTTOM", bottom) + "*BOUNDARY\nBOTTOM, 3, 3\n"
              + f"{at[0, 0, 0]}, 1, 2\n{at[width, 0, 0]}, 2, 2\n")
    step = ("*DLOAD\n" + decks.pressed_faces(pulled, -stress)
            + "*NODE PRINT, NSET=ALL_NODES\nU\n*NODE PRINT, NSET=BOTTOM, TOTALS=ONLY\nRF\n"
            + "*EL PRINT, ELSET=ALL_ELEMENTS\nS\n")
    answer = decks.solve(folder, "bar.inp", before, step)
    moved = decks.table(answer, "displacements")
    assert len(moved) == len(mesh.points)
    strain = stress / young
    for row in moved:
        x, y, z = mesh.points[int(row[0])]
        due = (-poisson * strain * x, -poisson * strain * y, strain * z)
        for got, wanted in zip(row[1:], due):
            if not abs(got - wanted) <= PRINTED * strain * length:
                raise AssertionError(f"node {row[0]}: {got} where {wanted} is due")
    top = [row[3] for row in moved if mesh.points[int(row[0])][2] == length]
    expect("displacement of the end", max(top), force * length / (young * width**2), PRINTED)
    expect("and at least", min(top), force * length / (young * width**2), PRINTED)
    stresses = decks.table(answer, "stresses")
    assert len(stresses) == len(mesh.tets)
    expect("stress", max(row[4] for row in stresses), stress, PRINTED)
    expect("and at least", min(row[4] for row in stresses), stress, PRINTED)
    total = decks.table(answer, "total force")
    expect("reaction", -total[0][2], force, PRINTED)


def bunny(folder):
    """The mesh of the sample, and its volume as `check` tells it."""
    sample = pathlib.Path(sys.argv[2], "bunny.cnt")
    for name in ("bunny.inp", "bunny.vtu"):
        tetloft("reconstruct", sample, "-o", folder / name, "--quiet")
    checked = json.loads(tetloft("check", folder / "bunny.vtu", sample, "--json"))
    mesh = decks.read_mesh(folder / "bunny.inp")
    volumes = {t: decks.volume(mesh, t) for t in mesh.tets}
    # Both are sums over the same tets, in doubles.
    expect("volume", sum(volumes.values()), checked["volume"], 1e-12)
    print(f"{len(mesh.tets)} tets")
    return mesh, volumes, checked["volume"]


def weight(folder):
    """The bunny, in millimetres, of soft rubber, on its lowest section, which is held."""
    young, poisson, density, gravity = 1.0, 0.3, 1.1e-9, 9810.0  # MPa, -, t / mm^3, mm / s^2
    mesh, volumes, whole = bunny(folder)
    lowest = min(p[2] for p in mesh.points.values())
    height = max(p[2] for p in mesh.points.values()) - lowest
    foot = {n for n, p in mesh.points.items() if p[2] == lowest}
    before = (elastic(young, poisson, density) + decks.node_set("FOOT", sorted(foot))
              + "*BOUNDARY\nFOOT, 1, 3\n")
    step = (f"*DLOAD\nALL_ELEMENTS, GRAV, {gravity}, 0., 0., -1.\n"
            "*NODE PRINT, NSET=ALL_NODES\nU\n*NODE PRINT, NSET=FOOT, TOTALS=ONLY\nRF\n")
    answer = decks.solve(folder, "bunny.inp", before, step)

    # What is printed is what the elements exert: the weight but for what the held nodes themselves
    # weigh, each a quarter of its tets.
    load = density * gravity * whole
    total = decks.table(answer, "total force")[0]
    of_foot = sum(v / 4 * len(foot.intersection(mesh.tets[t])) for t, v in volumes.items())
    expect("reaction", total[2] + density * gravity * of_foot, load, PRINTED)
    if max(abs(total[0]), abs(total[1])) > PRINTED * load:
        raise AssertionError(f"a force sideways: {total}")

    # No less than a column of one section all the way up is shortened; no more than a cantilever
    # is moved whose section is a disc of the area that stands, and which carries the whole weight at
    # its upper end, as far aside as the centre of mass is.
    area, stand = decks.level_area(mesh, [f for f in mesh.faces if all(
        p[2] == lowest for p in decks.corners(mesh, f))])
    centre = [sum(v / 4 * sum(mesh.points[n][i] for n in mesh.tets[t])
                  for t, v in volumes.items()) / whole for i in range(2)]
    aside = math.dist(stand, centre)
    column = density * gravity * height**2 / (2 * young)
    cantilever = (load * height / (young * area)
                  + load * aside * height**2 / (2 * young * area**2 / (4 * math.pi)))
    moved = decks.table(answer, "displacements")
    furthest = max(math.hypot(*row[1:]) for row in moved)
    print(f"column {column:.4g} <= moved {furthest:.4g} <= cantilever {cantilever:.4g}")
    assert len(moved) == len(mesh.points)
    assert column <= furthest <= cantilever


def pressure(folder):
    """The bunny under water, of a pressure p all around: whatever the shape is, it shrinks evenly,
    by p (1 - 2 nu) / E, which linear elements have exactly."""
    young, poisson, water = 1.0, 0.3, 0.01
    mesh, _, _ = bunny(folder)
    # Six displacements of three points far from each other are given, as they are due: nothing can
    # move as a whole, and nothing pulls at them.
    a = min(mesh.points, key=lambda n: mesh.points[n][2])
    shrink = water * (1 - 2 * poisson) / young
    origin = mesh.points[a]

    def due(n):
        return [-shrink * (x - o) for x, o in zip(mesh.points[n], origin)]

    b = max(mesh.points, key=lambda n: math.dist(mesh.points[n], origin))
    c = max(mesh.points, key=lambda n: abs(mesh.points[n][0] - origin[0]))
    before = (elastic(young, poisson) + f"*BOUNDARY\n{a}, 1, 3\n")
    held = "".join(f"{n}, {i}, {i}, {due(n)[i - 1]!r}\n" for n, i in ((b, 1), (b, 2), (c, 2)))
    step = (f"*BOUNDARY\n{held}*DLOAD\n" + decks.pressed_faces(mesh.faces, water)
            + "*NODE PRINT, NSET=ALL_NODES\nU\n")
    answer = decks.solve(folder, "bunny.inp", before, step)
    moved = decks.table(answer, "displacements")
    assert len(moved) == len(mesh.points)
    size = max(math.hypot(*due(n)) for n in mesh.points)
    off = max(math.dist(row[1:], due(int(row[0]))) for row in moved)
    print(f"displacements up to {size:.6g}, off by {off:.2g}")
    assert off <= 10 * PRINTED * size  # of three coordinates, of a system that is solved in doubles


def read_medit(path):
    """Points, tets and boundary triangles of a .mesh."""
    lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    words = " ".join(line for line in lines if not line.startswith("#")).split()

    def section(keyword, width):
        at = words.index(keyword) + 1
        count = int(words[at])
        numbers = [float(word) for word in words[at + 1:at + 1 + count * width]]
        return numpy.array(numbers).reshape(count, width)[:, :-1]

    return (section("Vertices", 4), section("Tetrahedra", 5).astype(int) - 1,
            section("Triangles", 4).astype(int) - 1)


def poisson(folder):
    """-div grad u = f for a u of degree two, on a standing torus: quadratic elements have it
    exactly."""
    tetloft("reconstruct", pathlib.Path(sys.argv[2], "torus.cnt"), "-o", folder / "torus.mesh",
            "--quiet")
    points, tets, triangles = read_medit(folder / "torus.mesh")
    getfem.util_trace_level(0)
    mesh = getfem.Mesh("empty", 3)
    mesh.add_point(points.T)
    mesh.add_convex(getfem.GeoTrans("GT_PK(3,1)"), points[tets].transpose(2, 1, 0))
    outer = mesh.outer_faces()
    assert mesh.nbpts() == len(points) and mesh.nbcvs() == len(tets)
    assert outer.shape[1] == len(triangles)
    mesh.set_region(1, outer)
    elements = getfem.MeshFem(mesh, 1)
    elements.set_fem(getfem.Fem("FEM_PK(3,2)"))
    x, y, z = elements.basic_dof_nodes()
    due = x * x + 2 * y * y + 3 * z * z + x * y - z
    model = getfem.Model("real")
    model.add_fem_variable("u", elements)
    integration = getfem.MeshIm(mesh, getfem.Integ("IM_TETRAHEDRON(5)"))
    model.add_Laplacian_brick(integration, "u")
    model.add_initialized_fem_data("border", elements, due)
    model.add_Dirichlet_condition_with_simplification("u", 1, "border")
    model.add_initialized_data("f", [-12.0])
    model.add_source_term_brick(integration, "u", "f")
    model.solve()
    off = abs(model.variable("u") - due).max()
    print(f"{len(tets)} tets, {elements.nbdof()} unknowns, u up to {abs(due).max():.6g}, off by {off:.2g}")
    # Nothing is printed: what is off is what the solver rounds, times the system's condition.
    assert off <= 1e-9 * abs(due).max()


CASES = {"bar": bar, "weight": weight, "pressure": pressure, "poisson": poisson}


def missing(case):
    """What is not installed."""
    if case != "poisson":
        return [] if shutil.which("ccx") else ["CalculiX"]
    return [] if getfem else ["GetFEM"]


def main():
    case = sys.argv[3]
    if missing(case):
        print("not installed: " + ", ".join(missing(case)))
        return NOT_THERE
    with tempfile.TemporaryDirectory() as folder:
        CASES[case](pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
