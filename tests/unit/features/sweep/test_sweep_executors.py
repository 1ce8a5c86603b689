"""Every executor gives the same bytes; kills of workers, of the scheduler and of the command lose nothing and repeat nothing."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from random import Random

import pytest
from made_studies import STUDY, exported, made_study
from once import once

from contourlab.cli.main import main

MODULE = [sys.executable, "-m"]
KILLS = int(os.environ.get("CONTOURLAB_TEST_KILLS", "2"))
"""Kills of the command at random moments."""
MANY = STUDY.replace("variants = 100", "variants = 2000").replace("chunk = 32", "chunk = 64")


@pytest.fixture
def study(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return made_study(tmp_path)


@pytest.fixture(scope="session")
def undisturbed(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> tuple[bytes, float]:
    """The rows of many variants from one process, and the time that it took [s]."""

    def run() -> tuple[bytes, float]:
        folder = tmp_path_factory.mktemp("undisturbed")
        made_study(folder, MANY)
        with contextlib.chdir(folder):
            began = time.perf_counter()
            assert main(["sweep", "study.toml", "--out", "store"]) == 0
            return exported(Path("store")), time.perf_counter() - began

    found: tuple[bytes, float] = once(tmp_path_factory, worker_id, "undisturbed study", run)
    return found


def parts(store: str) -> dict[str, int]:
    """Return the finished chunks of a store, and the time at which each was written [ns]."""
    return {path.name: path.stat().st_mtime_ns for path in Path(store).glob("part-*.parquet")}


def the_port_of_another_scheduler() -> contextlib.AbstractContextManager[object]:
    """Take the port that Dask's dashboards ask for first, if it is free."""
    try:
        return socket.create_server(("", 8787))
    except OSError:
        return contextlib.nullcontext()


SBATCH = """#!/bin/sh
cp "$1" job-$$.sh
exec 3> job-$$.log
sh job-$$.sh >&3 2>&3 &
echo "Submitted batch job $!"
"""
"""A stand-in for Slurm: runs the job at once, in the background."""


@pytest.mark.slow
@pytest.mark.parametrize("executor", ["processes", "dask-local", *(["slurm"] if sys.platform == "linux" else [])])
def test_executors_give_the_same_bytes(study: Path, executor: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, text in (("sbatch", SBATCH), ("scancel", '#!/bin/sh\nkill "$@"\n')):
        Path(name).write_text(text)
        Path(name).chmod(0o755)
    Path("jobqueue.yaml").write_text("jobqueue: {slurm: {cores: 1, memory: 1GB, interface: lo, job-extra-directives: []}}\n")
    monkeypatch.setenv("PATH", f"{Path.cwd()}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.setenv("DASK_CONFIG", str(Path.cwd()))
    assert main(["sweep", "study.toml", "--out", "threads"]) == 0
    command = [*MODULE, "contourlab", "sweep", "study.toml", "--executor", executor, "--workers", "2", "--out", "other"]
    with the_port_of_another_scheduler():
        done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    assert (done.returncode, done.stderr) == (0, "")
    assert not list(Path.cwd().glob(".dask-jobqueue*"))  # the keys of the jobs
    assert set(parts("threads")) == set(parts("other"))
    assert exported(Path("threads")) == exported(Path("other"))


def test_a_gpu_gives_the_same_bytes(study: Path, a_gpu: None) -> None:
    assert main(["sweep", "study.toml", "--out", "threads"]) == 0
    assert main(["sweep", "study.toml", "--executor", "gpu", "--out", "gpu"]) == 0
    assert set(parts("threads")) == set(parts("gpu")) and exported(Path("threads")) == exported(Path("gpu"))


def test_without_a_gpu_nothing_begins(study: Path, capsys: pytest.CaptureFixture[str], no_gpu: None) -> None:
    assert main(["sweep", "study.toml", "--executor", "gpu"]) == 2
    assert not Path("store").exists() and capsys.readouterr().err.count("\n") == 1


def test_an_unknown_executor_or_an_absent_scheduler_is_said(study: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["sweep", "study.toml", "--executor", "cloud"]) == 2
    assert not Path("store").exists()
    assert capsys.readouterr().err.count("\n") == 1


@pytest.mark.slow
def test_without_a_scheduler_or_a_worker_nothing_begins(study: Path, cluster: Callable[[int], Cluster]) -> None:
    alone = cluster(0)
    for _ in ("no worker", "no scheduler"):
        done = subprocess.run(alone.command(), capture_output=True, text=True, timeout=100)
        assert (done.returncode, done.stderr.count("\n")) == (2, 1)
        assert not Path("store").exists()
        alone.scheduler.kill()


def test_without_its_package_a_cluster_says_what_to_type(
    study: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    assert main(["sweep", "study.toml", "--executor", "dask-local"]) == 2
    assert 'pip install "contourlab[cluster]"' in capsys.readouterr().err


class Cluster:
    """A Dask scheduler and workers, each in a process of its own."""

    def __init__(self, stack: contextlib.ExitStack, workers: int) -> None:
        with socket.create_server(("127.0.0.1", 0)) as free:
            self.port = free.getsockname()[1]
        self.stack = stack
        self.scheduler = self._start("scheduler", "--host", "127.0.0.1", "--port", str(self.port))
        self.workers = [self.started_worker() for _ in range(workers)]

    def started_worker(self) -> subprocess.Popen[bytes]:
        return self._start("worker", f"tcp://127.0.0.1:{self.port}", "--nthreads", "1", "--no-nanny")

    def _start(self, role: str, *words: str) -> subprocess.Popen[bytes]:
        command = [*MODULE, f"distributed.cli.dask_{role}", *words, "--no-dashboard"]
        process = self.stack.enter_context(subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL))
        self.stack.callback(process.kill)
        return process

    def command(self, *more: str) -> list[str]:
        executor = f"dask://127.0.0.1:{self.port}"
        return [*MODULE, "contourlab", "sweep", "study.toml", "--executor", executor, "--out", "store", *more]


@pytest.fixture
def cluster() -> Iterator[Callable[[int], Cluster]]:
    """A function that starts a cluster."""
    with contextlib.ExitStack() as stack:
        yield lambda workers: Cluster(stack, workers)


def wait_for(store: str, count: int, process: subprocess.Popen[str]) -> None:
    """Wait until a store has a number of chunks; fail if its writer ends before."""
    while len(parts(store)) < count:
        assert process.poll() is None, process.communicate()
        time.sleep(0.02)


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")
def test_a_cluster_may_lose_a_worker_and_then_its_scheduler(
    study: Path, cluster: Callable[[int], Cluster], undisturbed: tuple[bytes, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    """One worker goes on for the other; without any the command says that it waits, and goes on with the next."""
    study.write_text(MANY)
    monkeypatch.delenv("CONTOURLAB_PROGRESS", raising=False)
    first = cluster(2)
    with subprocess.Popen(first.command(), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        wait_for("store", 3, process)
        first.workers[0].kill()
        wait_for("store", 8, process)
        first.workers[1].kill()
        assert process.stderr is not None
        assert any("waiting" in line for line in process.stderr)
        held = len(parts("store"))
        first.started_worker()
        wait_for("store", held + 3, process)
        first.scheduler.kill()
        _, errors = process.communicate(timeout=300)
    (fault,) = (line for line in errors.splitlines() if line.startswith("contourlab:"))
    assert process.returncode == 2 and "--resume" in fault
    before = parts("store")
    second = cluster(1)
    time.sleep(2.0)
    done = subprocess.run(second.command("--resume", "--json"), capture_output=True, text=True, timeout=500)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["chunks_made"] == 32 - len(before) and before.items() <= parts("store").items()
    assert exported(Path("store")) == undisturbed[0]


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="no SIGKILL")
def test_a_study_killed_at_random_moments_ends_equal(study: Path, undisturbed: tuple[bytes, float]) -> None:
    study.write_text(MANY)
    took, random, kept = undisturbed[1] + 2.0, Random(1), dict[str, int]()
    for _ in range(KILLS):
        command = [*MODULE, "contourlab", "sweep", "study.toml", "--out", "store", "--resume"]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as process:
            time.sleep(random.uniform(0.1, 1.0) * took)
            process.send_signal(signal.SIGKILL)
        assert kept.items() <= parts("store").items()  # nothing is written twice
        kept = parts("store")
    assert main(["sweep", "study.toml", "--out", "store", "--resume"]) == 0
    assert kept.items() <= parts("store").items()
    assert exported(Path("store")) == undisturbed[0]
    assert not list(Path("store").glob(".*.part"))
