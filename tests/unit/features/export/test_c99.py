"""Exported C99: compiled without a warning, it computes the commands of plain Python bit for bit."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from exported_axes import CASES, REFUSED, excited, exported

from contourlab.engine.translate import control

STRICT = ("-std=c99", "-Wall", "-Wextra", "-Wconversion", "-pedantic", "-Werror", "-O2", "-ffp-contract=off")


def built(folder: Path, case: str, compiler: str) -> Path:
    """Write the files of a controller with its recorded run, and compile the bench."""
    found = exported(case)
    name = found.control.name
    (folder / f"{name}.h").write_text(control.header_of(found.control))
    (folder / f"{name}.c").write_text(control.source_of(found.control))
    (folder / f"{name}_bench.c").write_text(control.bench_of(found.control))
    (folder / f"{name}_run.csv").write_text(excited(found).text)
    done = subprocess.run(
        [compiler, *STRICT, f"{name}.c", f"{name}_bench.c", "-o", "bench", "-lm"], cwd=folder, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return folder / "bench"


@pytest.mark.slow
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
@pytest.mark.parametrize("case", [case for case in CASES if case not in REFUSED])
def test_the_bench_replays_a_run_bit_for_bit(tmp_path: Path, case: str, compiler: str) -> None:
    if shutil.which(compiler) is None:
        pytest.skip(f"{compiler} is not installed")
    done = subprocess.run([built(tmp_path, case, compiler), tmp_path / "axis_x_run.csv"], capture_output=True, text=True)
    assert done.returncode == 0
    assert done.stdout.split()[0] == "400"
    assert float(done.stdout.split()[-1]) == 0.0  # the functions of <math.h> are those that Python calls here


@pytest.mark.skipif(shutil.which("gcc") is None, reason="gcc is not installed")
def test_the_bench_finds_a_wrong_command(tmp_path: Path) -> None:
    bench = built(tmp_path, "controller/position", "gcc")
    run = tmp_path / "axis_x_run.csv"
    lines = run.read_text().splitlines()
    head, _, last = lines[200].rpartition(",")
    run.write_text("\n".join([*lines[:200], f"{head},{float(last) * (1.0 + 2**-50)!r}", *lines[201:], ""]))
    assert subprocess.run([bench, run], stdout=subprocess.DEVNULL).returncode == 1
    assert subprocess.run([bench], stderr=subprocess.DEVNULL).returncode == 2
