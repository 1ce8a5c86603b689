"""The viewers on the pages of the site: a directive, what it shows, and those of the examples."""

from __future__ import annotations

import base64
import hashlib
import re
import shutil
import tempfile
from collections.abc import Callable
from contextlib import chdir
from dataclasses import replace
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

import contourlab as cl
from contourlab.features.run.show import pictures_of
from contourlab.rendering.charts import Picture
from contourlab.rendering.html import VIEWER
from contourlab.rendering.message import message

OUT = Path()
"""Folder of the scripts of the site; set when it is built."""
WITHOUT = "<p>The viewer needs JavaScript.</p>"
FILE = re.compile(r"^```toml\n# ([\w.-]+)\n(.*?)^```", re.MULTILINE | re.DOTALL)
TURNS = "G17 G21 G90 G94\nG0 X0 Y-40\nG3 X40 Y0 J40 F1200\nI-40\nI-40\nX0 Y40 I-40\nG4 P0.5\nG2 X40 Y0 J-40\nI-40\nI-40\nX0 Y-40 I-40\nM2\n"


def circle() -> Any:
    """Return the test of a machine with 8 um of play in x, 50 um/m out of square."""
    case = cl.load_scenario("builtin:demo-part").case("position loop")
    x, *others = case.machine.axes
    worn = (replace(x, error=cl.AxisError(backlash=8e-6)), *others)
    machine = replace(case.machine, axes=worn, squareness={("x", "y"): 50e-6})
    reference = cl.plan(cl.route_from_program(cl.parse_program(TURNS)), machine.planner_limits(), machine.servo_period)
    run = cl.simulate(machine, case.controller, reference)
    columns = {f"{name}.{axis} [mm]": 1e3 * run[name][:, i] for name in ("reference", "tool_position") for i, axis in enumerate("xy")}
    return cl.circle(cl.load_log({"time [s]": run.time, **columns}), tolerance="8 um")


SHOWN: dict[str, Callable[[], Any]] = {
    "part": lambda: cl.run("builtin:demo-part").save(),  # its report has the loop, too
    "circle": circle,
    "learning": lambda: cl.learn("stage.toml", schemes="ccc+ilc", trials=100),
}
"""What pages show; the files that a page spells out are there."""
_made: dict[str, list[Picture]] = {}


class Viewer(SphinxDirective):
    """``{viewer} NAME KEY ...``: pictures of one of `SHOWN`; the content is for readers without JavaScript."""

    required_arguments, optional_arguments, has_content = 1, 100, True

    def run(self) -> list[nodes.Node]:
        """Write the message, and return its place with the content in it."""
        name, *keys = self.arguments
        if name not in _made:
            with tempfile.TemporaryDirectory() as folder, chdir(folder):
                for file, text in FILE.findall(Path(self.get_source_info()[0]).read_text("utf-8")):
                    Path(file).write_text(text, "utf-8")
                _made[name] = pictures_of(SHOWN[name]())
        by_key = {picture.key: picture for picture in _made[name]}
        if wrong := set(keys) - by_key.keys() - {"live"}:  # not every loop can run in a page
            raise self.error(f"{name}: no picture {', '.join(wrong)}; there are {', '.join(by_key)}")
        still = nodes.container(classes=["cl-still"])
        self.state.nested_parse(self.content, self.content_offset, still)
        return [html(opened(message([by_key[key] for key in keys or by_key if key in by_key]))), still, html("</div>")]


def html(text: str) -> nodes.raw:
    """Return HTML as a node."""
    return nodes.raw("", text, format="html")


def opened(packed: bytes) -> str:
    """Write a message as a script, which a page opened from a file can load too; return the start of the element that shows it."""
    name = hashlib.sha256(packed).hexdigest()[:16]
    text = base64.b64encode(packed).decode("ascii")
    (OUT / f"message-{name}.js").write_text(f'(globalThis.contourlabMessages ??= {{}})["{name}"] = "{text}";\n', "utf-8")
    return f'<div class="viewer" data-message="{name}">'


def of_examples(block: Any, variables: dict[str, Any], settings: Any) -> str:
    """Show the viewer that a block of an example ends with; a scraper of Sphinx-Gallery."""
    last = variables["example_globals"].get("___")  # the value of the last expression
    packed = getattr(last, "message", None)
    if not isinstance(packed, bytes) or last is variables.get("viewer"):
        return ""
    variables["viewer"] = last
    return f"\n.. raw:: html\n\n    {opened(packed)}{WITHOUT}</div>\n\n"


def setup(app: Any) -> None:
    """Add the directive, and the script that draws."""
    global OUT
    OUT = Path(app.outdir) / "_static"
    OUT.mkdir(parents=True, exist_ok=True)
    for old in OUT.glob("message-*.js"):
        old.unlink()
    for file in (VIEWER, VIEWER.with_name("LICENSES")):  # one script for all pages, and the licences of its parts
        shutil.copy(file, OUT)
    app.add_directive("viewer", Viewer)
    app.add_js_file("live.js", loading_method="defer")
