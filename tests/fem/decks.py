"""Decks of CalculiX around the mesh of an .inp, and what it answers; and meshes read by own hands.

Nothing of a mesh is edited: a deck includes the file as it was written.
"""
import collections
import pathlib
import re
import subprocess

# Corners of faces S1 to S4 of a C3D4, from 0.
FACES = {"S1": (0, 1, 2), "S2": (0, 3, 1), "S3": (1, 3, 2), "S4": (2, 3, 0)}

Mesh = collections.namedtuple("Mesh", "points tets faces")


def read_mesh(path):
    """Points and tets by number, and the faces of the surface BOUNDARY."""
    points, tets, faces = {}, {}, []
    keyword, name = "", ""
    for line in pathlib.Path(path).read_text(encoding="utf-8").splitlines():
        if line.startswith("**"):
            continue
        if line.startswith("*"):
            keyword = line[1:].split(",")[0]
            found = re.search("NAME=([A-Z0-9_]*)", line)
            name = found[1] if found else ""
            continue
        fields = [field.strip() for field in line.split(",")]
        if keyword == "NODE":
            points[int(fields[0])] = tuple(float(field) for field in fields[1:])
        elif keyword == "ELEMENT":
            tets[int(fields[0])] = tuple(int(field) for field in fields[1:])
        elif keyword == "SURFACE" and name == "BOUNDARY":
            faces.append((int(fields[0]), fields[1]))
    return Mesh(points, tets, faces)


def corners(mesh, face):
    tet, side = face
    return [mesh.points[mesh.tets[tet][k]] for k in FACES[side]]


def volume(mesh, tet):
    a, b, c, d = (mesh.points[n] for n in mesh.tets[tet])
    u, v, w = ([p[i] - a[i] for i in range(3)] for p in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) + u[1] * (v[2] * w[0] - v[0] * w[2])
            + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


def level_area(mesh, faces):
    """Of faces in a plane of equal z, and the centre of that area."""
    parts = []
    for face in faces:
        a, b, c = corners(mesh, face)
        size = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2
        parts.append((size, [(a[i] + b[i] + c[i]) / 3 for i in range(2)]))
    area = sum(size for size, _ in parts)
    return area, [sum(size * c[i] for size, c in parts) / area for i in range(2)]


def node_set(name, nodes):
    return f"*NSET, NSET={name}\n" + "".join(f"{node}\n" for node in nodes)


def pressed_faces(faces, pressure):
    """Lines of *DLOAD."""
    return "".join(f"{tet}, P{side[1]}, {pressure!r}\n" for tet, side in faces)


def table(answer, title):
    return next(rows for name, rows in answer.items() if name.startswith(title))


def solve(folder, mesh_file, before, step):
    """What CalculiX prints of a static step: {title: [[number, …], …]}."""
    deck = (f"*INCLUDE, INPUT={mesh_file}\n{before}*STEP\n*STATIC\n{step}*END STEP\n")
    pathlib.Path(folder, "job.inp").write_text(deck, encoding="utf-8")
    run = subprocess.run(["ccx", "job"], cwd=folder, capture_output=True, text=True, check=False)
    if run.returncode != 0 or "ERROR" in run.stdout:
        raise AssertionError("ccx fails: " + run.stdout[-2000:])
    tables, title = {}, ""
    for line in pathlib.Path(folder, "job.dat").read_text(encoding="utf-8").splitlines():
        words = line.split()
        if not words:
            continue
        try:
            row = [float(word) for word in words]
        except ValueError:
            title = re.sub(r" and time .*| \(.*", "", line.strip())
            tables[title] = []
            continue
        tables[title].append(row)
    return tables
