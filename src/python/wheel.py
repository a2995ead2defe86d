"""Writes a wheel: the package, and the shared library inside it.

python3 wheel.py LIBRARY FOLDER. The same files give the same bytes.
"""

from __future__ import annotations

import base64
import hashlib
import os
import re
import sys
import sysconfig
import zipfile

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE = os.path.join(HERE, "tetloft")

METADATA = """\
Metadata-Version: 2.1
Name: tetloft
Version: {version}
Summary: Solids from planar cross sections, with guarantees
Requires-Python: >=3.9
Provides-Extra: numpy
Requires-Dist: numpy; extra == "numpy"
Description-Content-Type: text/markdown

{description}"""

WHEEL = """\
Wheel-Version: 1.0
Generator: tetloft
Root-Is-Purelib: false
Tag: {tag}
"""


def _read(*path: str) -> bytes:
    with open(os.path.join(*path), "rb") as opened:
        return opened.read()


def version() -> str:
    found = re.search(r'"(.*)"', _read(PACKAGE, "_version.py").decode().split("__version__")[-1])
    assert found
    return found.group(1)


def tag() -> str:
    """For any Python 3 of this platform: ctypes needs no ABI of Python's."""
    return "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())


def metadata() -> str:
    return METADATA.format(version=version(), description=_read(HERE, "README.md").decode())


def library_name() -> str:
    """Of the shared library on this platform."""
    return {"darwin": "libtetloft.dylib", "win32": "tetloft.dll"}.get(sys.platform, "libtetloft.so")


def _contents(library: str) -> list[tuple[str, bytes]]:
    """Names in the wheel, and bytes, all but the record."""
    sources = sorted(name for name in os.listdir(PACKAGE)
                     if name.endswith(".py") and name != "_location.py" or name == "py.typed")
    info = f"tetloft-{version()}.dist-info"
    return ([(f"tetloft/{name}", _read(PACKAGE, name)) for name in sources] +
            [(f"tetloft/{library_name()}", _read(library)),
             (f"{info}/METADATA", metadata().encode()),
             (f"{info}/WHEEL", WHEEL.format(tag=tag()).encode())])


def _record(contents: list[tuple[str, bytes]], name: str) -> bytes:
    lines = []
    for path, data in contents:
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        lines.append(f"{path},sha256={digest},{len(data)}\n")
    return "".join(lines + [f"{name},,\n"]).encode()


def write(library: str, folder: str) -> str:
    """Its name in the folder."""
    contents = _contents(library)
    record = f"tetloft-{version()}.dist-info/RECORD"
    name = f"tetloft-{version()}-{tag()}.whl"
    os.makedirs(folder, exist_ok=True)
    with zipfile.ZipFile(os.path.join(folder, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in contents + [(record, _record(contents, record))]:
            entry = zipfile.ZipInfo(path)  # of 1980, whenever it is made
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o100755 if path.endswith(library_name()) else 0o100644) << 16
            wheel.writestr(entry, data)
    return name


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("wheel.py LIBRARY FOLDER")
    print(os.path.join(sys.argv[2], write(sys.argv[1], sys.argv[2])))
