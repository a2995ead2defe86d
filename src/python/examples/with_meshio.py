"""A model in meshio, which writes some thirty formats (Debian: python3-meshio).

    python3 with_meshio.py STACK OUTPUT
"""

import sys

import meshio
import tetloft

solid = tetloft.reconstruct(tetloft.read_stack(sys.argv[1]))

mesh = meshio.Mesh(solid.points, [("tetra", solid.tets)], cell_data={"slab": [solid.slabs]})
surface = meshio.Mesh(solid.points, [("triangle", solid.boundary().triangles)])

mesh.write(sys.argv[2])
print(mesh, surface, sep="\n")
