"""What the tests share: the package, with NumPy or without, and small stacks."""

import math
import os
import subprocess
import sys

try:
    import numpy
except ImportError:
    numpy = None

import tetloft

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
DATA = os.path.join(ROOT, "data")

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
INNER = [(1, 1), (1, 3), (3, 3), (3, 1)]
CROSSED = [(0, 0), (4, 4), (4, 0), (0, 4)]


def data(*names):
    return os.path.join(DATA, *names)


def box():
    """Of volume 80."""
    return tetloft.Stack([(0, [SQUARE]), (5, [SQUARE])])


def tube():
    """Of volume 60, genus 1."""
    return tetloft.Stack([(0, [SQUARE, INNER]), (5, [SQUARE, INNER])])


def circles(sections, vertices):
    """A column of turned circles, as much work as one likes."""

    def circle(turn):
        angles = (2 * math.pi * (k + turn) / vertices for k in range(vertices))
        return [(100 * math.cos(a), 100 * math.sin(a)) for a in angles]

    return tetloft.Stack([(z, [circle(0.37 * z)]) for z in range(sections)])


def rows(array):
    """As lists of numbers, whether it is NumPy's or a list."""
    plain = array.tolist() if hasattr(array, "tolist") else list(array)
    return [list(row) if isinstance(row, tuple) else row for row in plain]


def run_python(code, *arguments, **environment):
    """A program of its own, in the same surroundings."""
    return subprocess.run([sys.executable, "-c", code, *arguments], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          env={**os.environ, **environment})
