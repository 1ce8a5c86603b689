"""Fixtures and settings of all tests. Machine code is kept in the user's cache between runs; CONTOURLAB_CACHE names another folder."""

import ctypes
import gc
import math
import os
import signal
import subprocess
import sys
from collections.abc import Iterator

import one_thread  # noqa: F401
import pytest
from browsing import browsing, chromium  # noqa: F401
from host_gpu import HostGpu
from hypothesis import settings
from once import once
from processor_time import ProcessorTimes
from schemas import check_results

from contourlab.engine import gpu
from contourlab.errors import EngineError

os.environ.setdefault("MPLBACKEND", "Agg")
os.environ["CONTOURLAB_PROGRESS"] = "0"  # tests read standard error
# Python's byte code is kept too: without it each worker rewrites every assertion, and each command compiles the package again.
sys.dont_write_bytecode = False
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
# Background processes of a shell, and their children, ignore Ctrl-C; tests send it.
signal.signal(signal.SIGINT, signal.default_int_handler)

EXAMPLES = 30
"""Examples of a property test that names no number of its own, before the share below; with --slow it tries 100."""
QUICK_SHARE = 0.3
"""Share of its examples that a property test tries without --slow."""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--slow", action="store_true", help="run the tests marked slow too")
    parser.addoption("--processor-times", metavar="FILE", help="write the processor time of each test to a JSON file")


def pytest_configure(config: pytest.Config) -> None:
    config.pluginmanager.register(ProcessorTimes(), "processor times")
    # Deadlines measure the machine, not the code. CI runs the same examples every time, so its answer depends on the commit alone.
    count = 100 if config.getoption("--slow") else EXAMPLES
    same = {"derandomize": True, "database": None} if os.environ.get("CI") else {}
    settings.register_profile("contourlab", deadline=None, max_examples=count, **same)
    settings.load_profile("contourlab")


def pytest_collection() -> None:
    """Keep the garbage collector away from modules and tests, which all live until the end: it would walk through them again and again."""
    gc.disable()


def pytest_collection_finish() -> None:
    gc.freeze()
    gc.enable()


@pytest.hookimpl(trylast=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    # LinuxCNC runs in real time, one instance after the other: the other processes work meanwhile.
    items.sort(key=lambda item: not item.path.name.endswith("_rig.py"))
    if config.getoption("--slow"):
        return
    for item in items:
        if "reproduction" in getattr(item, "fixturenames", ()):  # takes a minute
            item.add_marker("slow")
    # Each function once: its cases share it.
    for test in {item.obj for item in items if getattr(getattr(item, "obj", None), "is_hypothesis_test", False)}:
        every = test._hypothesis_internal_use_settings
        test._hypothesis_internal_use_settings = settings(every, max_examples=math.ceil(QUICK_SHARE * every.max_examples))
    slow = [item for item in items if item.get_closest_marker("slow")]
    items[:] = [item for item in items if not item.get_closest_marker("slow")]
    config.hook.pytest_deselected(items=slow)
    times = config.pluginmanager.get_plugin("processor times")
    assert isinstance(times, ProcessorTimes)
    times.left_out = len(slow)


@pytest.fixture(scope="session")
def reproduction(tmp_path_factory: pytest.TempPathFactory, worker_id: str) -> tuple[int, str, str]:
    """Exit code, output and error of ``contourlab reproduce ghaffari --json``; it takes a minute and runs once for all tests."""

    def run() -> tuple[int, str, str]:
        place = tmp_path_factory.mktemp("ghaffari")
        words = [sys.executable, "-m", "contourlab", "reproduce", "ghaffari", "--json"]
        done = subprocess.run(words, cwd=place, capture_output=True, encoding="utf-8", timeout=900)
        assert not any(place.iterdir()), "the reproduction leaves nothing behind"
        return done.returncode, done.stdout, done.stderr

    found: tuple[int, str, str] = once(tmp_path_factory, worker_id, "ghaffari", run)
    return found


@pytest.fixture(params=["stand-in", "real"])
def a_gpu(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Make variants run on a stand-in for a GPU, then on the GPU of this machine if there is one."""
    gpu.gpu_of_process.cache_clear()
    if request.param == "stand-in":
        monkeypatch.setattr(gpu, "Gpu", HostGpu)
    else:
        try:
            gpu.gpu_of_process()
        except EngineError as error:
            pytest.skip(str(error))
    yield
    gpu.gpu_of_process.cache_clear()


@pytest.fixture
def no_gpu(monkeypatch: pytest.MonkeyPatch) -> None:
    """Hide the driver of a GPU."""

    def missing(name: str) -> None:
        raise OSError(name)

    gpu.gpu_of_process.cache_clear()
    monkeypatch.setattr(ctypes, "CDLL", missing)


@pytest.fixture(autouse=True, scope="session")
def results_follow_their_schemas() -> Iterator[None]:
    """Check that --json output has only the keys of its schema."""
    with pytest.MonkeyPatch.context() as patch:
        check_results(patch)
        yield
