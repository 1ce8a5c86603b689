"""Steps in other languages: every component is printed, and what a tool at hand can run computes the bits of plain Python."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
from pathlib import Path

import llvmlite.binding as llvm
import numpy as np
import pytest

from contourlab.components.conformance import subject
from contourlab.components.contract import Component
from contourlab.components.registry import component, components
from contourlab.engine.step import Step, pack, record, rows, unpack
from contourlab.errors import ParameterError
from contourlab.native.llvm import module_of
from contourlab.primitives import Clock
from contourlab.scenario import load_scenario
from contourlab.scenario.translation import LANGUAGES, translate

KINDS = [kind for kind in components() if kind.family not in ("learning", "friction")]
CALLS = {"aarch64": r"\bbl\s+(\w+)", "cortex-m7": r"\bbl\s+(\w+)", "wasm32": r"\bcall\s+(\w+)", "ptx": r"\bcall[^;]*?(\w+)\s*,"}
RUNTIME = {"cortex-m7": {"__fixdfdi", "__floatundidf", "__floatdidf"}, "wasm32": {"fma"}}


@pytest.mark.parametrize("to", LANGUAGES)
@pytest.mark.slow
def test_every_component_is_printed(to: str) -> None:
    for kind in KINDS:
        text = translate(kind(**kind.example), to, n_axis=2)
        assert len(text) > 100
        if to in CALLS:
            assert set(re.findall(CALLS[to], text)) <= RUNTIME.get(to, set()), kind


@pytest.mark.skipif(shutil.which("ptxas") is None, reason="ptxas is not installed")
def test_ptx_is_assembled(tmp_path: Path) -> None:
    plant, friction = component("plant", "two-inertia"), component("friction", "smooth-coulomb")
    source = tmp_path / "step.ptx"
    source.write_text(translate(plant(**plant.example), "ptx", friction=friction(**friction.example)))
    subprocess.run(["ptxas", "-arch=sm_80", source, "-o", tmp_path / "step.cubin"], check=True)


def test_what_cannot_be_printed_is_refused() -> None:
    friction = component("friction", "none")()
    scenario = load_scenario("builtin:ghaffari/demo-stage")
    for part, to in ((component("drive", "saturation")(), "cobol"), (friction, "c99"), (scenario, "wasm"), (None, "c99")):
        with pytest.raises(ParameterError):
            translate(part, to)


def test_a_case_becomes_a_module_that_imports_its_memory() -> None:
    case = load_scenario("builtin:ghaffari/demo-stage").base
    code = translate(case, "wasm")
    assert code[:8] == b"\x00asm\x01\x00\x00\x00"
    assert b"\x03env\x06memory\x02" in code and code.count(b"\x03env") == 1
    for name in (b"run", b"prepare", b"judge"):
        assert bytes([len(name)]) + name + b"\x00" in code
    with pytest.raises(ParameterError):
        translate(case, "c99")
    with pytest.raises(ParameterError):
        translate(case, "wasm", n_axis=2)  # type: ignore[call-overload]
    with pytest.raises(ParameterError):
        translate(component("drive", "saturation")(), "wasm")
    with pytest.raises(ParameterError):
        translate(load_scenario("builtin:gecer-ulu/contour-simulated").base, "wasm")


def exported(code: bytes) -> bytes:
    """Return a relocatable wasm module with an export of its first function, which a linker would add."""
    parts, at = [code[:8]], 8
    while at < len(code):
        begin, kind, length, shift = at, code[at], 0, 0
        while True:
            at += 1
            length |= (code[at] & 127) << shift
            shift += 7
            if code[at] < 128:
                break
        at += 1 + length
        parts += [bytes([7, 8, 1, 4]) + b"step" + bytes([0, 0])] if kind == 10 else []
        parts.append(code[begin:at])
    return b"".join(parts)


JAVASCRIPT = """
const [wasm, data] = process.argv.slice(1).map((name) => require("fs").readFileSync(name));
const memory = new WebAssembly.Memory({initial: 1});
const words = new Float64Array(memory.buffer);
const { step } = new WebAssembly.Instance(new WebAssembly.Module(wasm), {env: {__linear_memory: memory}}).exports;
const made = JSON.parse(data).map(([par, x, inp, sizes]) => {
  let at = 16;
  const places = [par, x, inp, ...sizes.map((n) => new Array(n).fill(0))].map((values) => {
    words.set(values, at);
    at += values.length + 1;
    return 8 * (at - values.length - 1);
  });
  step(places[0], 0, 0, places[1], places[2], 0n, 3, 0.003, 0.001, places[3], places[4]);
  return [3, 4].map((i) => Array.from(words.slice(places[i] / 8, places[i] / 8 + sizes[i - 3])));
});
console.log(JSON.stringify(made));
"""


def plain(step: Step, par: list[float], x: list[float], inputs: list[float]) -> list[list[float]]:
    def shaped(ports: tuple, values: list[float]) -> object:  # type: ignore[type-arg]
        return record(tuple(port.name for port in ports))(*unpack(ports, values))

    following, out = step.function(step.par_type(*par), shaped(step.states, x), shaped(step.inputs, inputs), Clock(3.0, 0.003, 0.001))
    return [pack(step.states, following), pack(step.outputs, out)]


@pytest.mark.skipif(shutil.which("node") is None, reason="node is not installed")
@pytest.mark.parametrize("named", ["controller position", "controller cascade", "drive saturation", "compensation backlash-offset"])
def test_wasm_computes_the_bits_of_plain_python(tmp_path: Path, named: str) -> None:
    chosen: type[Component] = component(*named.split())
    step, values, _ = subject(chosen(**chosen.example))
    numbers, par = np.random.default_rng(0), [float(values[name]) for name in step.parameters]
    cases = [[par, *([*map(float, numbers.normal(size=n))] for n in (rows(step.states), rows(step.inputs)))] for _ in range(50)]
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple("wasm32-unknown-unknown").create_target_machine(opt=2)
    wasm, data = tmp_path / "step.wasm", tmp_path / "data.json"
    code = machine.emit_object(module_of(translate(chosen(**chosen.example), "llvm"), machine, "wasm32-unknown-unknown"))
    wasm.write_bytes(exported(code))
    sizes = [rows(step.states), rows(step.outputs)]
    data.write_text(json.dumps([[*case, sizes] for case in cases]))
    done = subprocess.run(["node", "-e", JAVASCRIPT, wasm, data], check=True, capture_output=True, text=True)
    assert json.loads(done.stdout) == [plain(step, *case) for case in cases]
