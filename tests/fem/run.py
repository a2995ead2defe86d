#!/usr/bin/env python3
"""Finite elements on solids as `tetloft reconstruct` writes them: a bar whose solution is known,
and an animal that stands under its own weight (CalculiX, from .inp); Poisson problems whose
solutions are known (GetFEM, from .mesh).

run.py TETLOFT DATA bar|weight|poisson; exit code 77 where a package is not there.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

import decks

NOT_THERE = 77


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
    moved = next(rows for title, rows in answer.items() if title.startswith("displacements"))
    assert len(moved) == len(mesh.points)
    strain = stress / young
    for row in moved:
        x, y, z = mesh.points[int(row[0])]
        due = (-poisson * strain * x, -poisson * strain * y, strain * z)
        for got, wanted in zip(row[1:], due):
            if not abs(got - wanted) <= 1e-6 * strain * length:
                raise AssertionError(f"node {row[0]}: {got} where {wanted} is due")
    top = [row[3] for row in moved if mesh.points[int(row[0])][2] == length]
    expect("displacement of the end", max(top), force * length / (young * width**2), 1e-6)
    expect("and at least", min(top), force * length / (young * width**2), 1e-6)
    stresses = next(rows for title, rows in answer.items() if title.startswith("stresses"))
    assert len(stresses) == len(mesh.tets)
    expect("stress", max(row[4] for row in stresses), stress, 1e-6)
    expect("and at least", min(row[4] for row in stresses), stress, 1e-6)
    total = next(rows for title, rows in answer.items() if title.startswith("total force"))
    expect("reaction", -total[0][2], force, 1e-6)


def weight(folder):
    """The bunny as it stands, in millimetres, of soft rubber, held at its lowest section."""
    young, poisson, density, gravity = 1.0, 0.45, 1.1e-9, 9810.0  # MPa, -, t / mm^3, mm / s^2
    sample = pathlib.Path(sys.argv[2], "bunny.cnt")
    for name in ("bunny.inp", "bunny.vtu"):
        tetloft("reconstruct", sample, "-o", folder / name, "--quiet")
    checked = json.loads(tetloft("check", folder / "bunny.vtu", sample, "--json"))
    mesh = decks.read_mesh(folder / "bunny.inp")
    heights = [p[2] for p in mesh.points.values()]
    foot = [n for n, p in mesh.points.items() if p[2] == min(heights)]
    height = max(heights) - min(heights)
    before = (elastic(young, poisson, density) + decks.node_set("FOOT", foot)
              + "*BOUNDARY\nFOOT, 1, 3\n")
    step = (f"*DLOAD\nALL_ELEMENTS, GRAV, {gravity}, 0., 0., -1.\n"
            "*NODE PRINT, NSET=ALL_NODES\nU\n*NODE PRINT, NSET=FOOT, TOTALS=ONLY\nRF\n")
    answer = decks.solve(folder, "bunny.inp", before, step)
    load = density * gravity * checked["volume"]
    total = next(rows for title, rows in answer.items() if title.startswith("total force"))[0]
    expect("reaction", total[2], load, 1e-6)
    for sideways in total[:2]:
        if not abs(sideways) <= 1e-6 * load:
            raise AssertionError(f"a force sideways: {total}")
    moved = next(rows for title, rows in answer.items() if title.startswith("displacements"))
    assert len(moved) == len(mesh.points)
    length = max(sum(c * c for c in row[1:]) ** 0.5 for row in moved)
    print(f"{len(mesh.tets)} tets, height {height}, foot {len(foot)} nodes, moved {length}")
    print("column", density*gravity*height**2/2/young)


def main():
    need = {"bar": ["ccx"], "weight": ["ccx"], "poisson": []}[sys.argv[3]]
    absent = [program for program in need if shutil.which(program) is None]
    if absent:
        print("not there: " + ", ".join(absent))
        return NOT_THERE
    with tempfile.TemporaryDirectory() as folder:
        globals()[sys.argv[3]](pathlib.Path(folder))
    return 0


if __name__ == "__main__":
    sys.exit(main())
