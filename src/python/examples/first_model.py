"""Contours in, a solid out: a vase of turned squares, checked, written, and drawn.

    python3 first_model.py [FOLDER]
"""

import math
import os
import sys

import tetloft


def ring(z):
    """A square that turns and widens with height."""
    radius, turn = 10 + 3 * math.sin(z / 5), z / 20
    return [(radius * math.cos(turn + k * math.pi / 2), radius * math.sin(turn + k * math.pi / 2))
            for k in range(4)]


def main(folder):
    stack = tetloft.Stack([(z, [ring(z)]) for z in range(0, 31, 3)])
    solid = tetloft.reconstruct(stack, ends="half")
    verdict = tetloft.check(solid, stack)
    print(solid)
    print(f"volume {solid.volume:.1f}, {len(solid.boundary())} triangles around it")
    print(verdict)
    solid.write(os.path.join(folder, "vase.vtu"))
    solid.write_surface(os.path.join(folder, "vase.stl"))
    solid.render(os.path.join(folder, "vase.html"), stack, title="Vase")
    return 0 if verdict else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else "."))
