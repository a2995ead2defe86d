"""Builds the wheel for pip (PEP 517): the shared library by CMake, the rest by wheel.py.

Nothing but CMake and a compiler is needed; Ninja and ccache are used where they are. With
`--config-settings build-dir=FOLDER` the build is kept there, for the next time.
"""

from __future__ import annotations

import glob
import os
import shutil
import subprocess
import tempfile
from typing import Any, Optional

import wheel

ROOT = os.path.dirname(os.path.dirname(wheel.HERE))
OPTIONS = {
    "CMAKE_BUILD_TYPE": "Release",
    "CMAKE_UNITY_BUILD": "ON",
    "CMAKE_UNITY_BUILD_BATCH_SIZE": "0",
    "BUILD_SHARED_LIBS": "ON",
    "TETLOFT_BUILD_CLI": "OFF",
    "TETLOFT_BUILD_TESTS": "OFF",
    "TETLOFT_INSTALL": "OFF",
}


class UnsupportedOperation(Exception):
    """What this backend does not do; PEP 517 knows it by its name."""


def _library(folder: str) -> str:
    if not os.path.exists(os.path.join(ROOT, "include", "tetloft", "version.hpp")):
        raise RuntimeError(f"tetloft: the sources of the library are not in {ROOT}")
    cmake = shutil.which("cmake")
    if cmake is None:
        raise RuntimeError("tetloft: CMake is needed to build the library, and was not found")
    generator = ["-G", "Ninja"] if shutil.which("ninja") else []
    options = [f"-D{name}={value}" for name, value in OPTIONS.items()]
    subprocess.run([cmake, "-S", ROOT, "-B", folder, *generator, *options], check=True)
    subprocess.run([cmake, "--build", folder, "--target", "tetloft", "--config", "Release",
                    "--parallel"], check=True)
    return glob.glob(os.path.join(folder, "**", wheel.library_name()), recursive=True)[0]


def build_wheel(wheel_directory: str, config_settings: Optional[dict[str, Any]] = None,
                metadata_directory: Optional[str] = None) -> str:
    kept = (config_settings or {}).get("build-dir")
    if kept:
        return wheel.write(_library(os.path.abspath(kept)), wheel_directory)
    with tempfile.TemporaryDirectory() as folder:
        return wheel.write(_library(folder), wheel_directory)


def build_sdist(sdist_directory: str, config_settings: Optional[dict[str, Any]] = None) -> str:
    raise UnsupportedOperation("the package is built from the whole repository")
