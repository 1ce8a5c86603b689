"""Functional mock-up units: zip archives with description, sources, and a library for this machine if it has a compiler."""

from __future__ import annotations

import io
import os
import platform
import shutil
import subprocess
import sys
import tempfile
import zipfile
from pathlib import Path

from contourlab.engine.translate import fmi
from contourlab.engine.translate.control import Control, header_of, source_of
from contourlab.errors import ParameterError

_SYSTEMS = {"linux": ("linux", ".so"), "darwin": ("darwin", ".dylib"), "win32": ("win", ".dll")}
_PROCESSORS = {"x86_64": "x86_64", "amd64": "x86_64", "aarch64": "aarch64", "arm64": "aarch64"}


def compiler() -> str | None:
    """Return the C compiler: that of ``CC``, else gcc, clang or cc; None if there is none."""
    return next(filter(None, map(shutil.which, filter(None, (os.environ.get("CC"), "gcc", "clang", "cc")))), None)


def unit_of(made: Control, version: str) -> bytes:
    """Return a mock-up unit as a zip archive.

    Parameters
    ----------
    made : Control
    version : str
        One of `fmi.VERSIONS`.

    Raises
    ------
    ParameterError
        If the compiler fails.
    """
    library, interface = fmi.source_files(made)
    sources = {
        f"{made.name}.h": header_of(made),
        library: source_of(made),
        interface: fmi.wrapper_of(made, version),
    }
    files: dict[str, bytes] = {"modelDescription.xml": fmi.description_of(made, version).encode()}
    files |= {f"sources/{name}": text.encode("ascii", "replace") for name, text in sources.items()}
    if version == "3.0":
        files["sources/buildDescription.xml"] = fmi.build_description_of(made).encode()
    place = _binary_place(made.name, version)
    command = compiler()
    if place and command:
        files[place] = _compiled(command, sources, (library, interface))
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            archive.writestr(zipfile.ZipInfo(name), content, zipfile.ZIP_DEFLATED)
    return buffer.getvalue()


def _binary_place(name: str, version: str) -> str:
    """Return where the library of this machine belongs; empty if the standard names no place."""
    system, suffix = _SYSTEMS.get(sys.platform, ("", ""))
    processor = _PROCESSORS.get(platform.machine().lower(), "")
    if not system or not processor or (version == "2.0" and processor != "x86_64"):
        return ""
    folder = f"{system}64" if version == "2.0" else f"{processor}-{'windows' if system == 'win' else system}"
    return f"binaries/{folder}/{name}{suffix}"


def _compiled(command: str, sources: dict[str, str], units: tuple[str, ...]) -> bytes:
    """Return a shared library."""
    with tempfile.TemporaryDirectory(prefix="contourlab-") as folder:
        for name, text in sources.items():
            (Path(folder) / name).write_text(text, encoding="ascii", errors="replace")
        flags = ["-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC", "-fvisibility=hidden"]
        done = subprocess.run([command, *flags, *units, "-o", "library", "-lm"], cwd=folder, capture_output=True, text=True)
        if done.returncode:
            raise ParameterError("CC", command, f"a C compiler: {done.stderr[-300:]}")
        return (Path(folder) / "library").read_bytes()
