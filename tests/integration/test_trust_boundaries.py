"""The trust boundaries of SECURITY.md: who can run code, and which files cannot."""

from __future__ import annotations

import io
import json
import os
import pickle
import re
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from operator import mul
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from made_studies import STUDY, made_study

from contourlab.cli.main import main
from contourlab.components.registry import components
from contourlab.errors import EngineError
from contourlab.features.sweep.store import Store, read_manifest
from contourlab.study.checkpoint import Checkpoint
from contourlab.study.executors import Executor


class Trap:
    """A value whose pickle makes a file when it is read."""

    def __init__(self, file: Path) -> None:
        self.file = file

    def __reduce__(self) -> tuple[Any, ...]:
        return Path.touch, (self.file,)


@pytest.fixture
def trap(tmp_path: Path) -> Iterator[Trap]:
    """A trap that must not have been sprung at the end, though it can be."""
    made = Trap(tmp_path / "sprung")
    yield made
    assert not made.file.exists()
    pickle.loads(pickle.dumps(made))
    assert made.file.exists()


@pytest.fixture
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    made_study(tmp_path)
    assert main(["sweep", "study.toml", "--out", "store"]) == 0
    return Path("store")


# --- clusters --------------------------------------------------------------------------------------------------------------------------

STRANGERS = """
import sys, distributed
for address in sys.argv[1:]:
    for protocol, security in (("tcp", None), ("tls", distributed.Security.temporary())):
        try:
            with distributed.Client(f"{protocol}://{address}", security=security, timeout="3s"):
                print("in", flush=True)
        except Exception:
            print("refused", flush=True)
"""
SBATCH = """#!/bin/sh
cp "$1" job.sh
exec 3> job.log
sh job.sh >&3 2>&3 &
echo "Submitted batch job $!"
"""


def answers(*addresses: str) -> set[str]:
    """Return what happens to clients without keys, and with keys of their own, at some addresses."""
    done = subprocess.run([sys.executable, "-c", STRANGERS, *addresses], capture_output=True, text=True, timeout=200, check=True)
    assert len(done.stdout.split()) == 2 * len(addresses)
    return set(done.stdout.split())


@pytest.mark.slow
def test_nobody_without_the_keys_of_the_run_reaches_a_local_cluster() -> None:
    import distributed

    with Executor("dask-local", 1).started() as pool:
        assert pool is not None and pool.map(mul, pool.shared(21), [1, 2]) == [21, 42]
        client = distributed.default_client()
        addresses = [client.scheduler.address, *client.scheduler_info()["workers"]]
        assert len(addresses) == 2 and all(address.startswith("tls://") for address in addresses)
        assert answers(*(address.removeprefix("tls://") for address in addresses)) == {"refused"}
    with distributed.LocalCluster(n_workers=0, dashboard_address="127.0.0.1:0", host="127.0.0.1") as plain:
        assert "in" in answers(plain.scheduler_address.removeprefix("tcp://"))  # so a stranger could


@pytest.mark.slow
@pytest.mark.skipif(sys.platform != "linux", reason="a stand-in for Slurm")
def test_nobody_without_the_keys_of_the_run_reaches_jobs_of_slurm(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    made_study(tmp_path, STUDY.replace("variants = 100", "variants = 1000000"))
    for name, text in (("sbatch", SBATCH), ("scancel", '#!/bin/sh\nkill "$@"\n')):
        Path(name).write_text(text)
        Path(name).chmod(0o755)
    Path("jobqueue.yaml").write_text("jobqueue: {slurm: {cores: 1, memory: 1GB, interface: lo, job-extra-directives: []}}\n")
    environment = os.environ | {"PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}", "DASK_CONFIG": str(tmp_path)}
    command = [sys.executable, "-m", "contourlab", "sweep", "study.toml", "--executor", "slurm", "--workers", "1", "--yes"]
    with subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        try:
            while not list(Path("store").glob("part-*")):
                assert process.poll() is None, process.communicate()
                time.sleep(0.1)
            job = Path("job.sh").read_text()
            (scheduler,) = set(re.findall(r"tls://([\d.]+:\d+)", job))
            assert "PRIVATE" not in job and "tcp://" not in job
            keys = list(tmp_path.glob(".dask-jobqueue*"))
            assert len(keys) == 3 and all(file.stat().st_mode & 0o077 == 0 for file in keys)
            assert answers(scheduler) == {"refused"}
        finally:
            process.send_signal(signal.SIGINT)
            errors = process.communicate(timeout=100)[1]
    assert process.returncode == 130, errors
    assert not list(tmp_path.glob(".dask-jobqueue*"))


@pytest.mark.slow
def test_a_cluster_at_an_address_takes_the_keys_of_the_configuration(tmp_path: Path) -> None:
    import dask
    import distributed

    keys, tls = distributed.Security.temporary(), {"distributed.comm.tls.ca-file": str(tmp_path / "ca.pem")}
    for name, text in (("ca", keys.tls_ca_file), ("cert", keys.tls_client_cert), ("key", keys.tls_client_key)):
        (tmp_path / f"{name}.pem").write_text(text)
    roles = [(role, part) for role in ("scheduler", "worker", "client") for part in ("cert", "key")]
    tls |= {f"distributed.comm.tls.{role}.{part}": str(tmp_path / f"{part}.pem") for role, part in roles}
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    words = {"scheduler": ["--host", "tls://127.0.0.1", "--port", str(port)], "worker": [f"tls://127.0.0.1:{port}", "--no-nanny"]}
    environment = os.environ | {f"DASK_{key.replace('.', '__').replace('-', '_').upper()}": value for key, value in tls.items()}
    started = [
        subprocess.Popen(
            [sys.executable, "-m", f"distributed.cli.dask_{role}", *more, "--no-dashboard"],
            env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        for role, more in words.items()
    ]  # fmt: skip
    try:
        with pytest.raises(EngineError), Executor(f"dask://127.0.0.1:{port}").started():
            pass
        with dask.config.set(tls):
            with distributed.Client(f"tls://127.0.0.1:{port}", timeout="60s", set_as_default=False) as client:
                client.wait_for_workers(1, timeout=60)
            with Executor(f"dask://127.0.0.1:{port}").started() as pool:
                assert pool is not None and pool.map(mul, pool.shared(21), [2]) == [42]
    finally:
        for process in started:
            process.kill()
            process.wait()


# --- stores ----------------------------------------------------------------------------------------------------------------------------


def test_a_chunk_of_a_strangers_store_runs_no_code(store: Path, trap: Trap, capsys: pytest.CaptureFixture[str]) -> None:
    """Not even one whose name has the right digest."""
    (part,) = store.glob("part-000001-*")
    part.unlink()
    data = pickle.dumps(trap)
    (store / f"part-000001-{Store(store, read_manifest(store)).seal('000001', data)}.parquet").write_bytes(data)
    for words in (["show"], ["report"], ["worst"], ["worst", "--rerun", "40"], ["query", "SELECT 1"], ["export", "--to", "a.csv"]):
        assert main(["sweep", words[0], "store", *words[1:]]) == 2
    assert main(["sweep", "study.toml", "--out", "store", "--resume"]) == 0


@pytest.mark.parametrize("sampler", [pytest.param("cma-es", marks=pytest.mark.slow), "tpe"])
def test_the_journal_of_a_strangers_search_runs_no_code(store: Path, trap: Trap, sampler: str) -> None:
    """Optuna keeps the state of a sampler in it as a pickle."""
    words = ["sweep", "optimise", "study.toml", "--out", "best", "--sampler", sampler, "--trials", "24", "--batch", "8"]
    assert main(words) == 0
    journal, rows = Path("best/optuna.log"), {file.name for file in Path("best").glob("part-*")}
    lines = []
    for line in journal.read_text().splitlines():
        entry = json.loads(line)
        attributes = entry.get("system_attr", {})
        for key in attributes:
            if "optimizer" in key:
                attributes[key] = pickle.dumps(trap).hex()
        lines.append(json.dumps(entry))
    journal.write_text("\n".join(lines) + "\n")
    next(Path("best").glob("part-000002-*")).unlink()
    assert main([*words, "--resume"]) == 0
    assert {file.name for file in Path("best").glob("part-*")} == rows


# --- checkpoints and the cache ---------------------------------------------------------------------------------------------------------


def test_a_strangers_checkpoint_runs_no_code(tmp_path: Path, trap: Trap) -> None:
    checkpoint = Checkpoint(tmp_path, "study")
    path, buffer = checkpoint.path(b"piece"), io.BytesIO()
    np.savez(buffer, values=np.array([trap], dtype=object))
    checkpoint.put(path.name.partition("-")[2], buffer.getvalue(), "npz")
    assert checkpoint.load(path) is None and checkpoint.damaged == 1


@pytest.mark.skipif(not hasattr(os, "geteuid"), reason="no owners on this system")
def test_a_cache_that_others_can_write_is_not_used(tmp_path: Path) -> None:
    code, cache = "from contourlab.native import store; print(store.folder())", tmp_path / "cache"
    cache.mkdir()
    for mode, is_used in ((0o777, False), (0o700, True)):
        cache.chmod(mode)
        environment = os.environ | {"CONTOURLAB_CACHE": str(cache)}
        done = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, timeout=60, check=True)
        assert (done.stdout.strip() == str(cache)) == is_used


# --- plug-ins --------------------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("line", ['plugin = "evil.py"', 'plugins = ["evil.py"]', 'machine = "evil.py"', 'controller = "evil.py"'])
def test_no_file_loads_a_plug_in(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: str, trap: Trap) -> None:
    monkeypatch.chdir(tmp_path)
    Path("evil.py").write_text(f"import pathlib\npathlib.Path({str(trap.file)!r}).touch()\n")
    study, known = made_study(tmp_path), components()
    study.write_text(f"{line}\n{STUDY}")
    assert main(["sweep", "study.toml"]) == 2
    study.write_text(STUDY)
    file, key = Path("scenario.toml"), line.partition(" ")[0]
    rest = [other for other in file.read_text().splitlines() if not other.startswith(f"{key} ")]
    file.write_text("\n".join([line, *rest]))
    for words in (["run", "scenario.toml"], ["sweep", "study.toml"]):
        assert main(words) == 2
    assert components() == known
