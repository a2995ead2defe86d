"""A model in PyVista: cut open, with the slabs in colours (pip install pyvista).

    python3 with_pyvista.py STACK PICTURE
"""

import sys

import pyvista
import tetloft

solid = tetloft.reconstruct(tetloft.read_stack(sys.argv[1]))

grid = pyvista.UnstructuredGrid({pyvista.CellType.TETRA: solid.tets}, solid.points)
surface = pyvista.PolyData.from_regular_faces(solid.points, solid.boundary().triangles)

grid.cell_data["slab"] = solid.slabs
plotter = pyvista.Plotter(off_screen=True)
plotter.add_mesh(grid.clip("y"), scalars="slab", show_edges=True)
plotter.add_mesh(surface, style="wireframe", opacity=0.1)
plotter.screenshot(sys.argv[2])
print(grid)
