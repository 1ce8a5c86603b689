"""Run a portable loop in node: what a page does, command by command."""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from contourlab.loop.portable import PortableLoop

Array = NDArray[np.float64]
needs_node = pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")

JAVASCRIPT = """
const fs = require("fs"), [folder, n_word] = process.argv.slice(1);
const memory = new WebAssembly.Memory({initial: Math.ceil(n_word / 8192)});
const words = new Float64Array(memory.buffer), given = fs.readFileSync(folder + "/given");
const numbers = new Float64Array(given.buffer.slice(given.byteOffset, given.byteOffset + given.length));
const loop = new WebAssembly.Instance(new WebAssembly.Module(fs.readFileSync(folder + "/loop.wasm")), {env: {memory}}).exports;
const found = [];
for (const [name, ...rest] of JSON.parse(fs.readFileSync(folder + "/commands"))) {
  if (name === "write") words.set(numbers.subarray(rest[1], rest[1] + rest[2]), rest[0]);
  else if (name === "read") found.push(words.slice(rest[0], rest[0] + rest[1]));
  else found.push(Float64Array.of(...[loop[name](...rest)].filter((value) => value !== undefined)));
}
fs.writeFileSync(folder + "/found", Buffer.concat(found.map((part) => Buffer.from(part.buffer))));
console.log(JSON.stringify(found.map((part) => part.length)));
"""


def in_node(loop: PortableLoop, *commands: tuple[Any, ...]) -> list[Array]:
    """Return what each command reads or returns, after the memory is set for the first tick.

    Commands are ``("write", word, numbers)``, ``("read", word, n)`` and calls such as ``("run", first, count)``.
    """
    return module_in_node(
        loop.code, loop.n_word, ("write", loop.first, loop.start), ("write", loop.inputs["reference"][0], loop.fed()), *commands
    )


def live_in_node(run: dict[str, Any], *commands: tuple[Any, ...]) -> list[Array]:
    """Return what each command reads or returns in a run of a message's `LiveLoop`; its memory is set from the message alone."""
    begin = [("write", at, values) for at, values in run["words"]] + [("write", run["inputs"], live_inputs(run))]
    return module_in_node(run["code"].astype(np.uint8).tobytes(), run["n_word"], *begin, *commands)


def live_inputs(run: dict[str, Any]) -> Array:
    """Return the inputs (n_input, n_sample) of a run, as the documentation of `LiveRun`, `LiveMotion` and `LivePath` says."""
    motion = run["motion"]
    starts, path, last = motion["spans"][0], motion["path"], motion["n_sample"] - 1
    time = np.arange(motion["n_sample"]) * motion["period"]
    span = np.searchsorted(starts, time, side="right") - 1
    t0, s, v, a, j = motion["spans"][:, span]
    dt = time - t0
    s, v, a = s + dt * (v + dt * (a / 2 + dt * j / 6)), v + dt * (a + dt * j / 2), a + dt * j
    rests = time >= motion["duration"]
    s[rests], v[rests], a[rests] = motion["length"], 0.0, 0.0
    along = s % path["start"][-1] if path["closed"] else s
    piece = np.clip(np.searchsorted(path["start"], along, side="right") - 1, 0, len(path["coefficients"]) - 1)
    h, c = (along - path["start"][piece])[:, None], np.moveaxis(path["coefficients"][piece], 2, 0)
    r, r1, r2 = (np.polynomial.polynomial.polyval(h, part, tensor=False) for part in (c, *(_derivative(c, n) for n in (1, 2))))
    moves = (r, r1 * v[:, None], r2 * v[:, None] ** 2 + r1 * a[:, None])
    later = [r[np.minimum(np.arange(last + 1) + ticks, last), j] for j, ticks in enumerate(run["ahead"])]
    return np.concatenate([*(part.T for part in moves), s[None], v[None], *(one[None] for one in later)])


def _derivative(coefficients: Array, n: int) -> Array:
    return np.polynomial.polynomial.polyder(coefficients, n)


def module_in_node(code: bytes, n_word: int, *commands: tuple[Any, ...]) -> list[Array]:
    """Return what each command reads or returns, in a module with an empty memory; commands as of `in_node`."""
    written, given, at = [], [], 0
    for name, *rest in commands:
        if name == "write":
            given.append(np.ravel(np.asarray(rest[1], dtype=float)))
            rest = [rest[0], at, given[-1].size]
            at += given[-1].size
        written.append([name, *rest])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "loop.wasm").write_bytes(code)
        (folder / "given").write_bytes(np.concatenate(given).tobytes())
        (folder / "commands").write_text(json.dumps(written))
        done = subprocess.run(["node", "-e", JAVASCRIPT, name, str(n_word)], check=False, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        found = np.frombuffer((folder / "found").read_bytes())
    return np.split(found, np.cumsum(json.loads(done.stdout))[:-1])


def log_of(loop: PortableLoop) -> tuple[str, int, int]:
    """Return the command that reads the whole log."""
    return ("read", loop.log, len(loop.rows) * loop.feed.reference.n_sample)
