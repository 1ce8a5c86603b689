"""Where independent work is done: threads, a GPU or processes of this machine, or the workers of a Dask cluster."""

from __future__ import annotations

import hashlib
import logging
import os
import pickle
import re
import shutil
import signal
import tempfile
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any, TypeAlias

from contourlab.engine.gpu import gpu_of_process
from contourlab.errors import EngineError, ParameterError, refuse
from contourlab.extras import extra_module
from contourlab.rendering.stages import INTERVAL, wait_for
from contourlab.study.checkpoint import program_text

HERE = ("threads", "gpu")
"""Executors that need no workers."""
EXECUTORS = (*HERE, "processes", "dask-local", "slurm")
AHEAD = 2
"""Items in work or waiting for each worker: enough to keep it busy, and memory does not grow with the work."""
QUIET = {"distributed.worker.profile.enabled": False, "distributed.admin.tick.interval": "500 ms"}
"""Settings of Dask that save a tenth of the processor time of short tasks: nobody looks at its profile."""
NO_DASHBOARD = {"dashboard": False, "dashboard_address": "127.0.0.1:0"}
"""A scheduler that we start serves no dashboard and takes any free port, so commands can run side by side."""
ROOMS = ("analysis", "study", "features")
"""Rooms of the program, besides those of a run, that must be the same on all workers."""
Work: TypeAlias = Callable[[Any, Any], Any]


@dataclass(frozen=True)
class Executor:
    """Where a command does its work; the results do not depend on it.

    Attributes
    ----------
    kind : str
        One of `EXECUTORS`, or ``dask://HOST:PORT``.
    workers : int, optional
        Threads, processes or Slurm jobs; by default one for each processor. A cluster at an address has its own number.
    """

    kind: str = "threads"
    workers: int | None = None

    def __post_init__(self) -> None:
        if self.kind not in EXECUTORS and not re.fullmatch(r"dask://[^/]+:\d+", self.kind):
            raise ParameterError("--executor", repr(self.kind), f"one of {', '.join(EXECUTORS)}, or dask://HOST:PORT")
        refuse(self.workers is not None and self.workers < 1, ParameterError, "--workers", f"{self.workers}", "1 or more")
        if self.kind not in (*HERE, "processes"):
            extra_module("distributed")
        if self.kind in ("dask-local", "slurm"):
            extra_module("cryptography")
        if self.kind == "slurm":
            with _deaf():  # its import makes Ctrl-C a plain exit
                extra_module("dask_jobqueue")

    @property
    def gpu(self) -> bool:
        """Whether a GPU does the work."""
        return self.kind == "gpu"

    @contextmanager
    def started(self, plugins: Iterable[str | Path] = (), then: str = "Repeat the command to continue") -> Iterator[Workers | None]:
        """Start workers, and stop them after the block; None for an executor of `HERE`.

        Parameters
        ----------
        plugins : iterable of str or Path
            Python files with components.
        then : str
            What to do after workers are lost.

        Raises
        ------
        EngineError
            If the cluster cannot be reached, or there is no GPU.
        """
        if self.gpu:
            gpu_of_process()
        if self.kind in HERE:
            yield None
            return
        files = tuple(str(Path(plugin).resolve()) for plugin in plugins)
        with (_processes if self.kind == "processes" else _cluster)(self, files, then) as made:
            yield made


Place: TypeAlias = tuple[Callable[[str], bytes], str]
"""The function that finds a shared value on a worker, packed, and its argument."""


def _opened(packed: bytes) -> Any:
    """Return a shared value, on a worker.

    Raises
    ------
    EngineError
        If the worker has another version of contourlab or its libraries.
    """
    from contourlab.components.registry import load_plugin

    program, plugins, value = pickle.loads(packed)
    if program != program_text(*ROOMS):
        raise EngineError("a worker has another version of contourlab, numpy or scipy: install the same on all machines")
    for plugin in plugins:
        load_plugin(plugin)
    return pickle.loads(value)


@dataclass(frozen=True, eq=False)
class Workers:
    """Workers that do items of work, a few more at a time than there are workers.

    Attributes
    ----------
    least : int
        Number of workers to plan for before they are there.
    present : callable
        Returns the number of workers there now.
    name : str
        What to wait for while none is there.
    plugins : tuple of str
    submit : callable
        Starts a call on a worker; returns its `concurrent.futures.Future`.
    share : callable
        Makes a shared value known to all workers by its key; returns the function that finds it there, and its argument.
    lost : mapping of type to str
        Exceptions that mean that workers are lost, and what to say.
    places : dict
        What `share` returned, by key.
    """

    least: int
    present: Callable[[], int]
    name: str
    plugins: tuple[str, ...]
    submit: Callable[..., Future[Any]]
    share: Callable[[str, bytes], Place]
    lost: Mapping[type[BaseException], str]
    places: dict[str, Place] = field(default_factory=dict, repr=False)

    @property
    def count(self) -> int:
        """Number of items at work at the same time."""
        return max(self.least, self.present())

    def shared(self, value: object) -> str:
        """Send a value to all workers; return its key."""
        packed = pickle.dumps(value)
        key = hashlib.sha256(packed).hexdigest()[:16]
        if key not in self.places:
            # Packed twice: a worker of another version does not open the value.
            self.places[key] = self.share(key, pickle.dumps((program_text(*ROOMS), self.plugins, packed)))
        return key

    def run(self, work: Work, key: str, items: Iterable[Any]) -> Iterator[tuple[int, Any]]:
        """Yield the number of each item and ``work(value, item)``, in any order.

        Parameters
        ----------
        work : callable
            A function of a module, which raises errors that can be pickled.
        key : str
            Key of the shared value.
        items : iterable

        Raises
        ------
        EngineError
            If the workers are lost.
        """
        left, waiting = enumerate(items), dict[Future[Any], int]()

        def fill(count: int) -> None:
            for number, item in islice(left, count):
                waiting[self.submit(_done, *self.places[key], key, work, item)] = number

        try:
            fill(AHEAD * self.count)
            while waiting:
                done, _ = wait(waiting, INTERVAL, FIRST_COMPLETED)
                wait_for("" if done or self.present() else self.name)
                ended = [(waiting.pop(future), future.result()) for future in done]  # a lost scheduler raises here at once
                fill(max(AHEAD * self.count - len(waiting), 0))
                yield from ended
        except tuple(self.lost) as error:
            raise EngineError(next(text for kind, text in self.lost.items() if isinstance(error, kind))) from error

    def map(self, work: Work, key: str, items: Iterable[Any]) -> list[Any]:
        """Return ``work(value, item)`` of each item, in order; see `run`."""
        done = dict(self.run(work, key, items))
        return [done[number] for number in range(len(done))]


_values: dict[str, Any] = {}
"""Shared values that this worker has opened."""
_opening = threading.Lock()


def _done(find: Callable[[str], bytes], place: str, key: str, work: Work, item: Any) -> Any:
    """Do an item of work on a worker, which opens each shared value once."""
    with _opening:
        if key not in _values:
            _values[key] = _opened(find(place))
    return work(_values[key], item)


# --- processes -------------------------------------------------------------------------------------------------------------------------


def _begin() -> None:
    """Prepare a worker process: leave Ctrl-C to its parent, and end with its parent."""
    import multiprocessing

    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:

        def watch() -> None:
            parent.join()
            os._exit(1)

        threading.Thread(target=watch, daemon=True).start()


def _read(file: str) -> bytes:
    return Path(file).read_bytes()


@contextmanager
def _processes(executor: Executor, plugins: tuple[str, ...], then: str) -> Iterator[Workers]:
    import multiprocessing

    count = executor.workers or os.cpu_count() or 1
    lost: dict[type[BaseException], str] = {BrokenProcessPool: f"a worker process ended: killed, or out of memory. {then}"}
    with tempfile.TemporaryDirectory(prefix="contourlab-") as folder:

        def share(key: str, packed: bytes) -> Place:
            (Path(folder) / key).write_bytes(packed)
            return _read, str(Path(folder) / key)

        pool = ProcessPoolExecutor(count, multiprocessing.get_context("spawn"), _begin)
        try:
            yield Workers(count, lambda: count, "", plugins, pool.submit, share, lost)
        except BaseException:
            for process in multiprocessing.active_children():
                process.terminate()
            raise
        finally:
            pool.shutdown(wait=True, cancel_futures=True)


# --- Dask ------------------------------------------------------------------------------------------------------------------------------


def _carried(key: str) -> bytes:
    from distributed import get_worker

    packed: bytes = get_worker().plugins[key].packed
    return packed


@contextmanager
def _cluster(executor: Executor, plugins: tuple[str, ...], then: str) -> Iterator[Workers]:
    """Start or find a cluster; Dask repeats the work of a worker that is lost."""
    import asyncio

    from distributed import KilledWorker, WorkerPlugin

    killed, gone = "some work has ended several Dask workers: do they have enough memory?", f"the Dask scheduler is lost. {then}"
    lost: dict[type[BaseException], str] = {KilledWorker: killed, OSError: gone, TimeoutError: gone, CancelledError: gone}
    count = executor.workers or os.cpu_count() or 1
    with _client(executor.kind, count) as client:

        def share(key: str, packed: bytes) -> Place:
            carrier = WorkerPlugin()  # the scheduler gives it to workers that join later, too
            carrier.packed = packed
            name = f"contourlab-{key}"
            client.register_plugin(carrier, name=name)
            return _carried, name

        def submit(*call: Any) -> Future[Any]:
            return asyncio.run_coroutine_threadsafe(_result_of(client.submit(*call, pure=False)), client.loop.asyncio_loop)

        def present() -> int:
            try:
                return sum(client.nthreads().values())
            except (OSError, TimeoutError):  # the futures say so, too
                return 0

        least, name = (count, "a Slurm job") if executor.kind == "slurm" else (1, "a Dask worker")
        made = Workers(least, present, name, plugins, submit, share, lost)
        yield made
        for _, name in made.places.values():
            client.unregister_worker_plugin(name)


async def _result_of(future: Any) -> Any:
    """Wait for a task of Dask, in its loop: its own adapter and threads that wait for a result may wait forever after a lost scheduler."""
    return await future


@contextmanager
def _client(executor: str, count: int) -> Iterator[Any]:
    distributed = extra_module("distributed")
    for name in logging.root.manager.loggerDict:
        if name.partition(".")[0] in ("distributed", "tornado"):  # each logger has a level of its own; an interrupt may end in theirs
            logging.getLogger(name).setLevel(logging.CRITICAL)
    if executor.startswith("dask://"):
        # Dask's configuration names the keys of a cluster, if it has some.
        address = f"{'tls' if distributed.Security().tls_ca_file else 'tcp'}://{executor.removeprefix('dask://')}"
        try:
            client = distributed.Client(address, timeout="10s")
        except (OSError, TimeoutError, ValueError) as error:
            raise EngineError(f"no Dask scheduler answers at {executor}: start one with  dask scheduler") from error
        with client:
            if not client.nthreads():
                raise EngineError(f"no worker at {executor}: start some with  dask worker {executor.removeprefix('dask://')}")
            yield client
        return
    keys = distributed.Security.temporary()  # of this run: without them nobody reaches its scheduler and workers
    if executor == "slurm":
        cluster = _slurm(count, keys)
    else:
        extra_module("dask").config.set(QUIET)
        with _deaf():
            settings = {"silence_logs": logging.CRITICAL, "scheduler_kwargs": NO_DASHBOARD, "security": keys}
            cluster = distributed.LocalCluster(n_workers=count, threads_per_worker=1, **settings)
    with cluster, distributed.Client(cluster) as client:
        yield client


@contextmanager
def _deaf() -> Iterator[None]:
    """Let processes that the block starts leave Ctrl-C to this one; what the block does to Ctrl-C ends with it."""
    if threading.current_thread() is not threading.main_thread():  # which cannot set it
        yield
        return
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)


def _slurm(jobs: int, keys: Any) -> Any:
    """Return a cluster of Slurm jobs, as the user's ``jobqueue.yaml`` describes them; they read `keys` from files for this user alone."""
    refuse(shutil.which("sbatch") is None, EngineError, "no sbatch on this machine: type the command where you submit Slurm jobs")
    folder = extra_module("dask").config.get("jobqueue.slurm.shared-temp-directory", None) or str(Path.cwd())
    try:
        cluster = extra_module("dask_jobqueue").SLURMCluster(scheduler_options=NO_DASHBOARD, security=keys, shared_temp_directory=folder)
    except ValueError as error:
        where = "set cores and memory under jobqueue: slurm: in ~/.config/dask/jobqueue.yaml"
        raise EngineError(f"Slurm: {' '.join(str(error).split())}: {where}") from error
    cluster.scale(jobs=jobs)
    return cluster
