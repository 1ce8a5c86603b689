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
    every = [("write", loop.first, loop.start), ("write", loop.inputs["reference"][0], loop.fed().ravel()), *commands]
    written, given, at = [], [], 0
    for name, *rest in every:
        if name == "write":
            given.append(np.ravel(np.asarray(rest[1], dtype=float)))
            rest = [rest[0], at, given[-1].size]
            at += given[-1].size
        written.append([name, *rest])
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "loop.wasm").write_bytes(loop.code)
        (folder / "given").write_bytes(np.concatenate(given).tobytes())
        (folder / "commands").write_text(json.dumps(written))
        done = subprocess.run(["node", "-e", JAVASCRIPT, name, str(loop.n_word)], check=False, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        found = np.frombuffer((folder / "found").read_bytes())
    return np.split(found, np.cumsum(json.loads(done.stdout))[:-1])


def log_of(loop: PortableLoop) -> tuple[str, int, int]:
    """Return the command that reads the whole log."""
    return ("read", loop.log, len(loop.rows) * loop.feed.reference.n_sample)
