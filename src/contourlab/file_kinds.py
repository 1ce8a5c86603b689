"""What kind of file is this? One rule for all commands: a file of another kind is refused by name, with what it is for."""

from __future__ import annotations

import os
import re
import tomllib
from collections.abc import Mapping
from functools import lru_cache
from pathlib import Path
from typing import Any

_HEAD = 1 << 16
"""Bytes that are looked at."""
_FOREIGN = (
    (rb"\x89PNG\r\n", "a PNG picture"),
    (rb"\xff\xd8\xff", "a JPEG picture"),
    (rb"GIF8", "a GIF picture"),
    (rb"%PDF-", "a PDF"),
    (rb"PK\x03\x04", "a ZIP archive or office document"),
    (rb"\x1f\x8b", "a gzip archive"),
    (rb"\s*(?i:<!doctype html|<html)", "a web page"),
    (rb"\0+\Z", "a file of zero bytes only"),
)
_LOGS = rb"MATLAB \d|\x89HDF|CDF[\x01\x02\x05]|PAR1"
_NUMBERS = re.compile(rb"^\s*[-+]?[\d.][-+\d.eE]*([ \t]*[,;\t ][ \t]*[-+]?[\d.][-+\d.eE]*)+\s*$", re.MULTILINE)
_MOTION = re.compile(rb"^\s*/?\s*(?:N\d+\s*)?(?:G\s*\d|M\s*\d|[XYZ]\s*[-+.\d])", re.MULTILINE | re.IGNORECASE)
_LINUXCNC = re.compile(rb"^\s*\[(EMC|EMCMOT|KINS|TRAJ|JOINT_0)\]|^\s*(loadrt|addf)\s+\S", re.MULTILINE)
_GRBL = re.compile(rb"^[^\n$]{0,4}\$1[0-3]0\s*=|^\s+max_rate_mm_per_min\s*:", re.MULTILINE)
_COMMENT = re.compile(rb"\([^()\n]*\)|;.*")
_BEGINNING = 8192
"""Bytes without comments in which a program shows its language."""
_POST = "its language is not read; let the CAM system post for LinuxCNC, grbl, Fanuc or Mach3"
_OTHER_LANGUAGES = (
    (rb"^\s*(?:\d+\s+)?BEGIN PGM\b|^\s*\d+\s+(?:TOOL CALL|CYCL DEF|L [XYZ][+-])", "a program for a Heidenhain control"),
    (
        rb"^%_N_|^\s*(?:N\d+)?\s*(?:A?TRANS|A?ROT|CYCLE\d+|MCALL|WORKPIECE|MSG|DEF\s+(?:REAL|INT))\b|^\s*(?:N\d+)?\s*R\d+\s*="
        rb"|\b(?:CR\s*=|T\s*=\s*\"|[XYZIJK]\s*=\s*[AI]C\b|SUPA\b|STOPRE\b|G500\b)",
        "a program for a Sinumerik",
    ),
    (rb"^\s*M(?:(?:104|109|140|190)\s*[ST]\d|8[23]\b)|^\s*G[01]\b[^\n]*\bE-?[\d.]", "a program for a 3D printer"),
)
"""Programs in languages that are not read, by what stands outside of comments."""
_USE = {
    "a scenario": "run it: contourlab run FILE, whose name must end in .toml",
    "a machine": "name it with --machine, beside a part program",
    "a controller": "name it with --controller, beside a part program",
    "an axis": "name it under [axes] of a machine",
    "a file of answers": "make a machine of it: contourlab new machine --answers FILE",
    "a part program": "run it: contourlab run FILE --machine MACHINE --controller CONTROLLER",
    "a log": "judge it: contourlab measure FILE",
    "a file of LinuxCNC": "name its INI file with --machine, beside a part program",
    "a program for a Heidenhain control": _POST,
    "a program for a Sinumerik": _POST,
    "a program for a 3D printer": "extruder and heaters are not read; let the CAM system post for LinuxCNC, grbl, Fanuc or Mach3",
    "the settings of a control": "name it with --machine, beside a part program",
}
_MADE_OF = {
    "a scenario": "name a scenario (.toml)",
    "a machine": "name a machine file (.toml), with [machine]",
    "a controller": "name a controller file (.toml), with [controller]",
    "an axis": "name an axis file (.toml), with plant, friction, drive",
    "a part program": "name a part program in G-code",
    "a log": "name a log: .mat, .csv, .parquet, .xml, .nc, or text from a scope",
    "a file of answers": "name answers.toml of contourlab new machine",
    "a file of columns": "name a TOML file with [columns]",
    "a file of LinuxCNC": "name the INI file of the configuration, then its HAL files",
}


def kind_of(file: str | os.PathLike[str]) -> str:
    """Return what a file is, with its article, from its content; an empty text if it is not recognised or cannot be read.

    >>> kind_of("nowhere.ngc")
    ''
    """
    path = Path(file)
    try:
        if path.is_dir():
            return "a folder"
        if not path.is_file():  # a pipe can be read only once
            return ""
        with path.open("rb") as stream:
            head = stream.read(_HEAD)
    except (OSError, ValueError):
        return ""
    if not head:
        return "an empty file"
    foreign = next((name for magic, name in _FOREIGN if re.match(magic, head)), "")
    return foreign or ("a log" if re.match(_LOGS, head) else _of_text(head))


@lru_cache(32)
def toml_of(text: str) -> Mapping[str, Any]:
    """Return the content of TOML, which nobody changes: its kind and its values are asked for one after the other."""
    return tomllib.loads(text)


def _of_toml(content: Mapping[str, Any]) -> str:
    """Return what a TOML file is, from its top-level keys."""
    if "plant" in content:
        return "an axis"
    if isinstance(content.get("axes"), str):
        return "a file of answers"
    parts = content.keys() & {"machine", "controller"}
    if len(parts) == 2 or content.keys() & {"program", "contour"}:
        return "a scenario"
    return f"a {parts.pop()}" if parts and all(isinstance(content[part], dict) for part in parts) else ""


def _of_text(head: bytes) -> str:
    try:
        return _of_toml(toml_of(head.decode("utf-8-sig")))
    except (ValueError, RecursionError):  # no UTF-8, or no TOML
        pass
    bare = _COMMENT.sub(b"", head)[:_BEGINNING]
    other = next((name for words, name in _OTHER_LANGUAGES if re.search(words, bare, re.MULTILINE | re.IGNORECASE)), "")
    moves = _MOTION.search(head)
    if other and (moves or other == "a program for a Heidenhain control"):
        return other
    if moves:
        return "a part program"
    if _LINUXCNC.search(head):
        return "a file of LinuxCNC"
    if _GRBL.search(head):
        return "the settings of a control"
    return "a log" if len(_NUMBERS.findall(head)) > 1 else ""


def mistaken(file: str | Path, *wanted: str) -> str:
    """Return why a file is refused that is recognised as none of the kinds wanted; else an empty text.

    Parameters
    ----------
    file : str or Path
    *wanted : str
        Kinds, as ``"a scenario"``; the first one is asked for in the message. Without any, every file is accepted.
    """
    kind = kind_of(file)
    if not (kind and wanted) or kind in wanted:
        return ""
    return f"is {kind}, not {wanted[0]}: {_USE.get(kind) or _MADE_OF[wanted[0]]}"
