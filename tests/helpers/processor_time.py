"""Processor time of each test, child processes included, and a list of those that take more than their budget."""

from __future__ import annotations

import json
import os
import time
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

BUDGET, SLOW_BUDGET = 0.5, 20.0
"""Seconds for a test, and for one marked slow, on the warm cache of machine code. What exceeds them is listed; no test fails for time."""


def spent() -> float:
    """Return the processor time of this process and of its finished children [s]."""
    return time.process_time() + sum(os.times()[2:4])


class ProcessorTimes:
    """A plug-in of pytest: one in each worker adds the times to the reports, the one that prints sums them."""

    def __init__(self) -> None:
        self.mark = spent()
        self.workers = 0.0
        self.left_out = 0
        """Slow tests that do not run."""
        self.phases: dict[str, dict[str, float]] = {}
        self.slow: set[str] = set()

    def pytest_runtest_logstart(self) -> None:
        self.mark = spent()

    @pytest.hookimpl(wrapper=True)
    def pytest_runtest_makereport(self, item: pytest.Item) -> Any:
        report = yield
        now = spent()
        report.processor_time, self.mark = now - self.mark, now
        report.is_slow = item.get_closest_marker("slow") is not None
        return report

    def pytest_runtest_logreport(self, report: Any) -> None:
        self.phases.setdefault(report.nodeid, {})[report.when] = report.processor_time
        if report.is_slow:
            self.slow.add(report.nodeid)

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        output = getattr(session.config, "workeroutput", None)
        if output is not None:
            output["processor_time"], output["left_out"] = spent(), self.left_out

    @pytest.hookimpl(optionalhook=True)
    def pytest_testnodedown(self, node: Any) -> None:
        output = getattr(node, "workeroutput", {})
        self.workers += output.get("processor_time", 0.0)
        self.left_out = output.get("left_out", self.left_out)  # each worker collects all tests

    def pytest_terminal_summary(self, terminalreporter: Any, config: pytest.Config) -> None:
        """Print what exceeds its budget, the most first: whoever uses a shared fixture first pays for it."""
        sums = {name: sum(phases.values()) for name, phases in self.phases.items()}
        over = Counter({name: used for name, used in sums.items() if used > (SLOW_BUDGET if name in self.slow else BUDGET)})
        terminalreporter.section("processor time")
        for name, used in over.most_common():
            phases = ", ".join(f"{phase} {part:.2f}" for phase, part in self.phases[name].items() if part >= 0.01)
            terminalreporter.write_line(f"{used:7.2f} s  {name}  ({phases})")
        share = f"{over.total():.0f} s of the tests' {sum(sums.values()):.0f} s"
        terminalreporter.write_line(f"{len(over)} of {len(sums)} tests take more than {BUDGET:g} s, or {SLOW_BUDGET:g} s if slow: {share}")
        if self.left_out:
            terminalreporter.write_line(f"{self.left_out} slow tests are left out: run them with --slow")
        whole = self.workers or spent()
        terminalreporter.write_line(f"all test processes together: {whole:.0f} s")
        file = config.getoption("--processor-times")
        if file:
            Path(file).write_text(json.dumps(self.phases, indent=1), encoding="utf-8")
