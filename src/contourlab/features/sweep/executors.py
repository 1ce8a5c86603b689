"""Where chunks are simulated: threads of this process, processes of this machine, or the workers of a Dask cluster."""

from __future__ import annotations

import hashlib
import logging
import os
import pickle
import shutil
import signal
import threading
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from itertools import islice
from typing import Any

from contourlab.errors import ContourlabError, EngineError, ParameterError
from contourlab.extras import extra_module
from contourlab.features.sweep.chunk import Chunk, run_chunk
from contourlab.features.sweep.study import Study

EXECUTORS = ("threads", "processes", "dask-local", "slurm")
AHEAD = 2
"""Chunks in work or waiting for each worker: enough to keep it busy, and memory does not grow with the study."""
QUIET = {"distributed.worker.profile.enabled": False, "distributed.admin.tick.interval": "500 ms"}
"""Settings of Dask that save a tenth of the processor time of short chunks: nobody looks at its profile."""
Progress = Callable[[float], None]


def check_executor(executor: str) -> None:
    """Raise `ParameterError` for an unknown executor, `MissingPackageError` if a package is missing."""
    if executor not in EXECUTORS and not executor.startswith("dask://"):
        raise ParameterError("--executor", repr(executor), f"one of {', '.join(EXECUTORS)}, or dask://HOST:PORT")
    if executor not in ("threads", "processes"):
        extra_module("distributed")
    if executor == "slurm":
        extra_module("dask_jobqueue")


def run_chunks(study: Study, numbers: Iterable[int], executor: str, workers: int | None, progress: Progress) -> Iterator[Chunk]:
    """Yield finished chunks, in any order. They do not depend on the executor.

    Parameters
    ----------
    study : Study
    numbers : iterable of int
        Chunks to simulate.
    executor : str
        One of `EXECUTORS`, or ``dask://HOST:PORT``.
    workers : int, optional
        Threads, processes or Slurm jobs; by default one for each processor. A cluster at an address has its own number.
    progress : callable
        Called with the share done of the present chunk, where it is known.

    Raises
    ------
    ParameterError
        If there is no such executor.
    EngineError
        If the cluster is lost.
    """
    if executor == "threads":
        for number in numbers:
            yield run_chunk(study, number, workers, progress)
    elif executor == "processes":
        yield from _in_processes(study, numbers, workers or os.cpu_count() or 1)
    else:
        with _client(executor, workers) as client:
            yield from _on_cluster(client, study, numbers)


# --- processes -------------------------------------------------------------------------------------------------------------------------

_study: Study | None = None


def _begin(packed: bytes, plugins: tuple[str, ...]) -> None:
    """Prepare a worker process: leave Ctrl-C to its parent, and end with its parent."""
    global _study
    import multiprocessing

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:

        def watch() -> None:
            parent.join()
            os._exit(1)

        threading.Thread(target=watch, daemon=True).start()
    _study = unpacked(packed, plugins)


def _work(number: int) -> Chunk:
    assert _study is not None  # set by `_begin`
    return _alone(_study, number)


def _alone(study: Study, number: int) -> Chunk:
    """Run a chunk in one thread; raise errors of a kind that can be sent."""
    try:
        return run_chunk(study, number, 1)
    except ContourlabError as error:
        raise EngineError(f"chunk {number}: {error}") from None


def _in_processes(study: Study, numbers: Iterable[int], workers: int) -> Iterator[Chunk]:
    import multiprocessing
    from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
    from concurrent.futures.process import BrokenProcessPool

    left = iter(numbers)
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(workers, context, _begin, (pickle.dumps(study), study.plugins))
    try:
        futures: set[Future[Chunk]] = {pool.submit(_work, number) for number in islice(left, AHEAD * workers)}
        while futures:
            done, futures = wait(futures, return_when=FIRST_COMPLETED)
            futures |= {pool.submit(_work, number) for number in islice(left, len(done))}
            yield from (future.result() for future in done)
    except BrokenProcessPool as error:
        raise EngineError("a worker process ended: killed, or out of memory. Repeat the command with --resume to continue") from error
    except BaseException:
        for process in multiprocessing.active_children():
            process.terminate()
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


# --- Dask ------------------------------------------------------------------------------------------------------------------------------


def unpacked(packed: bytes, plugins: Iterable[str]) -> Study:
    """Return a study on the worker that runs it; refuse to run it with another version of contourlab or its libraries.

    Raises
    ------
    EngineError
        If the versions differ.
    """
    from contourlab.components.registry import load_plugin
    from contourlab.features.sweep.study import program

    for plugin in plugins:
        load_plugin(plugin)
    study: Study = pickle.loads(packed)
    if study.identity["program"] != program():
        raise EngineError("a worker has another version of contourlab, numpy or scipy: install the same on all machines")
    return study


_unpacked: dict[str, Study] = {}
_unpacking = threading.Lock()


def _on_worker(key: str, plugins: tuple[str, ...], number: int) -> Chunk:
    """Run a chunk on a Dask worker, one thread for each task."""
    from distributed import get_worker

    with _unpacking:
        if key not in _unpacked:
            _unpacked[key] = unpacked(get_worker().plugins[key].packed, plugins)
    return _alone(_unpacked[key], number)


def _on_cluster(client: Any, study: Study, numbers: Iterable[int]) -> Iterator[Chunk]:
    """Yield the chunks from a cluster; Dask repeats those of a worker that is lost."""
    from concurrent.futures import CancelledError

    from distributed import KilledWorker, WorkerPlugin, as_completed
    from distributed.comm.core import CommClosedError

    packed = pickle.dumps(study)
    key = f"contourlab-{hashlib.sha256(packed).hexdigest()[:16]}"
    carrier = WorkerPlugin()  # the scheduler gives it to workers that join later, too
    carrier.packed = packed
    left = iter(numbers)
    try:
        client.register_plugin(carrier, name=key)
        cores = max(sum(client.nthreads().values()), 1)
        futures = as_completed([_submitted(client, key, study, number) for number in islice(left, AHEAD * cores)])
        for future in futures:
            chunk = future.result()
            future.release()
            for number in islice(left, 1):
                futures.add(_submitted(client, key, study, number))
            yield chunk
        client.unregister_worker_plugin(key)
    except KilledWorker as error:
        raise EngineError("a chunk has ended several Dask workers: do they have enough memory?") from error
    except (OSError, TimeoutError, CancelledError, CommClosedError) as error:
        raise EngineError("the Dask scheduler is lost. Repeat the command with --resume to continue") from error


def _submitted(client: Any, key: str, study: Study, number: int) -> Any:
    return client.submit(_on_worker, key, study.plugins, number, key=f"{key}-{number}", pure=False)


@contextmanager
def _client(executor: str, workers: int | None) -> Iterator[Any]:
    distributed = extra_module("distributed")
    for name in logging.root.manager.loggerDict:
        if name.partition(".")[0] == "distributed":  # each of its loggers has a level of its own
            logging.getLogger(name).setLevel(logging.CRITICAL)
    if executor.startswith("dask://"):
        address = "tcp://" + executor.removeprefix("dask://")
        try:
            client = distributed.Client(address, timeout="10s")
        except (OSError, TimeoutError, ValueError) as error:
            raise EngineError(f"no Dask scheduler answers at {executor}: start one with  dask scheduler") from error
        with client:
            yield client
        return
    count = workers or os.cpu_count() or 1
    if executor == "slurm":
        cluster = _slurm(count)
    else:
        extra_module("dask").config.set(QUIET)
        with _deaf():
            cluster = distributed.LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=None, silence_logs=logging.CRITICAL)
    with cluster, distributed.Client(cluster) as client:
        yield client


@contextmanager
def _deaf() -> Iterator[None]:
    """Let processes that the block starts leave Ctrl-C to this one."""
    if threading.current_thread() is not threading.main_thread():  # which cannot set it
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _slurm(jobs: int) -> Any:
    """Return a cluster of Slurm jobs, as the user's ``jobqueue.yaml`` describes them."""
    if shutil.which("sbatch") is None:
        raise EngineError("no sbatch on this machine: type the command where you submit Slurm jobs")
    try:
        cluster = extra_module("dask_jobqueue").SLURMCluster(scheduler_options={"dashboard_address": ":0"})
    except ValueError as error:
        where = "set cores and memory under jobqueue: slurm: in ~/.config/dask/jobqueue.yaml"
        raise EngineError(f"Slurm: {' '.join(str(error).split())}: {where}") from error
    cluster.scale(jobs=jobs)
    return cluster
