"""Try inputs in processes that are forked for one input each: imports and machine code are there, and each has limits of its own."""

from __future__ import annotations

import contextlib
import gc
import json
import os
import resource
import select
import shutil
import signal
import sys
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

SECONDS, BYTES = 60.0, 1 << 30
"""What one input may take; memory beyond that of the imports."""
KILO = 1 if sys.platform == "darwin" else 1024  # the unit of ru_maxrss
END, MOST = b"\0", 900
"""Mark behind what is wrong, and its most bytes."""
Try = Callable[[int, Path], str]


class Tried(NamedTuple):
    """The number of an input, what is wrong or nothing, and its time [s]."""

    number: int
    fault: str
    seconds: float


def tried(number: int, attempt: Try, folder: Path) -> Tried:
    """Try one input in a process of its own, which ends with all that it started."""
    reader, writer = os.pipe()
    begun = time.monotonic()
    pid = os.fork()
    if pid == 0:
        os.close(reader)
        _child(number, attempt, folder, writer)
    os.close(writer)
    text, late = b"", False
    with open(reader, "rb", buffering=0) as stream:  # noqa: PTH123
        while True:
            left = begun + SECONDS - time.monotonic()
            late = left <= 0.0 or not select.select([stream], [], [], left)[0]
            part = b"" if late else stream.read(1 << 16)
            if not part:
                break
            text += part
            if text.endswith(END):
                break
    with contextlib.suppress(ProcessLookupError):
        os.killpg(pid, signal.SIGKILL)
    _, status, usage = os.wait4(pid, 0)
    extra = usage.ru_maxrss * KILO - resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * KILO
    if late:
        fault = f"more than {SECONDS:g} s"
    elif not text.endswith(END):
        fault = f"the process ended with status {status}"
    else:
        fault = text[:-1].decode(errors="replace") or (f"{extra >> 20} MB of memory" if extra > BYTES else "")
    return Tried(number, fault, time.monotonic() - begun)


def _child(number: int, attempt: Try, folder: Path, writer: int) -> None:
    """Try the input, write what is wrong, and leave without a trace of the parent's."""
    try:
        os.setsid()
        resource.setrlimit(resource.RLIMIT_CPU, (int(2 * SECONDS) + 5, int(2 * SECONDS) + 5))  # if the parent is no more
        if sys.platform != "darwin":
            present = int(Path("/proc/self/statm").read_text().split()[0]) * os.sysconf("SC_PAGE_SIZE")
            resource.setrlimit(resource.RLIMIT_AS, (present + 2 * BYTES, present + 2 * BYTES))  # threads reserve more than they use
        silent = os.open(os.devnull, os.O_RDWR)
        for descriptor in (0, 1, 2):
            os.dup2(silent, descriptor)
        os.write(writer, attempt(number, folder).encode()[-MOST:] + END)
    except BaseException as error:
        os.write(writer, f"{type(error).__name__}: {error}".encode()[-MOST:] + END)
    finally:
        os._exit(0)


class Pool:
    """Workers that try inputs, each forked with what is imported by then; they begin together, when the results are read."""

    def __init__(self, seconds: float) -> None:
        self.seconds = seconds
        self.reader, self.writer = os.pipe()
        self.wait, self.go = os.pipe()
        self.pids: list[int] = []

    def hire(self, numbers: Iterable[int], attempt: Try) -> None:
        """Fork a worker for some inputs."""
        gc.freeze()  # children then copy fewer pages
        pid = os.fork()
        if pid:
            self.pids.append(pid)
            return
        try:
            os.close(self.reader)
            os.close(self.go)
            os.read(self.wait, 1)
            self._serve(numbers, attempt, time.monotonic() + self.seconds)
        finally:
            os._exit(0)

    def _serve(self, numbers: Iterable[int], attempt: Try, end: float) -> None:
        """Try one input after the other until the time is up, and write a line for each."""
        with tempfile.TemporaryDirectory() as name:
            for number in numbers:
                if time.monotonic() > end:
                    break
                folder = Path(name, str(number))
                folder.mkdir()
                found = tried(number, attempt, folder)
                shutil.rmtree(folder, ignore_errors=True)
                os.write(self.writer, json.dumps(found).encode() + b"\n")  # short enough to be written whole

    def results(self) -> Iterator[Tried]:
        """Let the workers begin; yield each input as it ends."""
        for descriptor in (self.writer, self.wait, self.go):
            os.close(descriptor)
        try:
            with open(self.reader, encoding="utf-8") as lines:  # noqa: PTH123
                for line in lines:
                    yield Tried(*json.loads(line))
        finally:
            for pid in self.pids:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGTERM)
                os.waitpid(pid, 0)
