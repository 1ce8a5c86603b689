"""The report as one self-contained HTML file."""

from __future__ import annotations

import base64
import gzip
import hashlib
from collections.abc import Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from contourlab.figures import figure, number
from contourlab.native import store
from contourlab.rendering.charts import Picture
from contourlab.rendering.comparison import compare
from contourlab.rendering.data import ReportData
from contourlab.rendering.lead import MOST_LINES, program_lines, sentence
from contourlab.rendering.message import message
from contourlab.rendering.page_tables import circle_tables, limit_tables, origin_tables, reversal_table
from contourlab.rendering.path_picture import path_scene
from contourlab.rendering.plots import sections
from contourlab.rendering.run_pictures import FINER
from contourlab.rendering.samples import share
from contourlab.rendering.switching import switch_tables
from contourlab.result.atomic import write_text_atomic
from contourlab.result.stamp import current

MOST_POINTS = 4000
"""Most points of a curve: two for every pixel of a wide screen."""

TOTAL_POINTS = 60_000
"""Most points of all curves together; with the viewer, 0.3 MB, they keep a page below 1.5 MB."""

SCENE_POINTS = 30_000
"""Most points of the runs in space, all together."""

MOST_TEXT = 100_000
"""Longest scenario or program in full [characters]."""
TEMPLATES = Path(__file__).parent / "templates"
VIEWER = Path(__file__).parent / "viewer" / "viewer.js"


def write_html(data: ReportData, file: str | Path) -> Path:
    """Write the report as one HTML file.

    Parameters
    ----------
    file : str or Path
        Replaced completely or not at all.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    OutputError
        If it cannot be written.
    ResultError
        If a result has not been judged.

    Notes
    -----
    Time is linear in the number of samples; `MOST_POINTS` and `TOTAL_POINTS` bound the size of the file.
    """
    target = Path(file)
    write_text_atomic(target, render_html(data))
    return target


def render_html(data: ReportData) -> str:
    """Return the text of the report; the same data give the same text."""
    return page_text(
        "report.html.j2",
        picture_groups(data),
        title=data.title,
        made=current(data.schemes[0].result.stamp),
        data=data,
        sentence=sentence(data),
        comparison=compare(data),
        circle_tables=circle_tables(data),
        limit_tables=list(limit_tables(data)),
        reversals=reversal_table(data),
        switch_tables=switch_tables(data),
        origins=origin_tables(data),
        program=_program(data),
        scenario=_clipped(data.provenance.scenario),
        facts=_facts(data, _points(data)),
    )


def picture_groups(data: ReportData) -> dict[str, Sequence[Picture]]:
    """Return the pictures of the report by section."""
    scene = path_scene(data, share(SCENE_POINTS, len(data.schemes), SCENE_POINTS))
    live = (data.live,) if data.live is not None and data.live.runs else ()
    return {"path": () if scene is None else (scene,), "live": live} | dict(sections(data, _points(data)))


def page_text(template: str, groups: Mapping[str, Sequence[Picture]], **values: Any) -> str:
    """Return a page that draws pictures; the template places them by group, and needs `title`."""
    loader, viewer = template_file("loader.js"), base64.b64encode(packed_viewer()).decode("ascii")
    picture = base64.b64encode(message(chart for charts in groups.values() for chart in charts)).decode("ascii")
    hashes = [script_hash(text) for text in (VIEWER.read_text("utf-8"), loader)]
    scripts = {"message": picture, "viewer": viewer, "loader": loader, "hashes": hashes}
    values = {"made": current(), "style": template_file("report.css"), **scripts, **values}
    return str(page_template(template).render(groups=groups, **values))


def _points(data: ReportData) -> int:
    """Return the points of each curve: all possible curves share the total."""
    n_scheme, n_axis = len(data.schemes), len(data.axes)
    n_circle = sum(len(scheme.circles) for scheme in data.schemes)
    n_loop = FINER * sum(len(scheme.gaps) for scheme in data.schemes)
    n_curve = n_scheme * (3 + 5 * n_axis) + n_circle + 4 * n_axis + n_loop
    return max(16, share(TOTAL_POINTS, n_curve, MOST_POINTS))


def _program(data: ReportData) -> dict[str, Any] | None:
    """Return the part program with the errors of its lines."""
    if not data.program:
        return None
    digest = hashlib.sha256("\n".join(data.program).encode("utf-8", "replace")).hexdigest()
    rows = program_lines(data)
    return {"rows": rows, "cut": len(rows) >= MOST_LINES, "count": len(data.program), "digest": digest}


def _clipped(text: str) -> dict[str, Any]:
    """Return a text, or the beginning and digest of a long one."""
    if len(text) <= MOST_TEXT:
        return {"text": text, "note": ""}
    digest = hashlib.sha256(text.encode("utf-8", "replace")).hexdigest()
    note = f"The first {MOST_TEXT} of {len(text)} characters. SHA-256 of the whole text: {digest}."
    return {"text": text[:MOST_TEXT], "note": note}


def _facts(data: ReportData, points: int) -> list[tuple[str, str]]:
    """Return the facts at the end of the page."""
    first, source = data.schemes[0].result, data.provenance
    samples = max(int(scheme.result.n_sample) for scheme in data.schemes)
    period = float(first.servo_period)
    facts: Iterable[tuple[str, str]] = (
        ("Made by", current(first.stamp).removeprefix("made by ")),
        ("Command", source.command),
        ("Platform", source.platform),
        ("Seed", "" if source.seed is None else str(source.seed)),
        ("Axes", ", ".join(data.axes)),
        ("Servo period", figure(period, "ms", 6)),
        ("Samples", f"{samples:,} in {figure(samples * period, 's', 4)}"),
        ("Path length", figure(float(data.planned.length), "mm", 6)),
        ("Curves", f"at most {points} points each; thinning keeps minima and maxima"),
    )
    return [(name, text) for name, text in facts if text]


@cache
def template_file(name: str) -> str:
    """Return a file of the template folder."""
    return (TEMPLATES / name).read_text(encoding="utf-8")


@cache
def packed_viewer() -> bytes:
    """Return the viewer's script, compressed."""
    return gzip.compress(VIEWER.read_text(encoding="utf-8").encode(), 6, mtime=0)


def script_hash(script: str) -> str:
    """Return the hash of a script, with which the page permits it and no other."""
    return "sha256-" + base64.b64encode(hashlib.sha256(script.encode()).digest()).decode("ascii")


@cache
def page_template(name: str) -> Any:
    """Return a template, which escapes all text unless marked safe; its compiled form is kept where machine code is."""
    from jinja2 import BytecodeCache, Environment, FileSystemLoader, StrictUndefined, __version__

    options: dict[str, Any] = {"undefined": StrictUndefined, "trim_blocks": True, "lstrip_blocks": True, "autoescape": True}

    class Kept(BytecodeCache):
        def get_cache_key(self, *names: str | None) -> str:
            return hashlib.sha256(repr((names, __version__, options)).encode()).hexdigest()[:32]

        def load_bytecode(self, bucket: Any) -> None:
            bucket.bytecode_from_string((store.read(bucket.key) or [b""])[0])

        def dump_bytecode(self, bucket: Any) -> None:
            store.write(bucket.key, [bucket.bytecode_to_string()])

    environment = Environment(loader=FileSystemLoader(TEMPLATES), bytecode_cache=Kept(), **options)
    environment.filters |= {"number": number, "figure": figure}
    return environment.get_template(name)
