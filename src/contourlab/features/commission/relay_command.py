"""``contourlab commission relay``: ultimate gain and period from the log of a relay experiment, and gains by rules."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from contourlab.analysis.identification.relay import PID, RULES, RelayTest, relay_findings, relay_test
from contourlab.app.session import QUIET, Answer, Session, question
from contourlab.errors import ResultError
from contourlab.features.commission.options import OfRelay
from contourlab.features.identify.command import axes_of
from contourlab.features.identify.options import Identify
from contourlab.features.identify.records import Request
from contourlab.figures import number
from contourlab.findings import Finding
from contourlab.logs.load import Log, about
from contourlab.rendering.relay_table import relay_table
from contourlab.rendering.table import Column, Table, paragraphs


@dataclass(frozen=True, eq=False)
class RelayCommissioned(Answer):
    """Relay experiments of a log, and gains by rules.

    Attributes
    ----------
    axes : dict of str to RelayTest
    gains : dict of str to dict of str to PID
        By axis and rule.
    units : dict of str to str
        Unit of the command of each axis.
    findings : tuple of Finding
    """

    axes: dict[str, RelayTest]
    gains: dict[str, dict[str, PID]]
    units: dict[str, str]
    findings: tuple[Finding, ...]

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The gains [SI], one axis and rule a row."""
        return [{"axis": axis, "rule": rule, **vars(pid)} for axis, by_rule in self.gains.items() for rule, pid in by_rule.items()]

    @property
    def text(self) -> str:
        """Tables and findings."""
        rows = [(one.pop("axis"), one.pop("rule"), *(number(1e-3 * gain) for gain in one.values())) for one in self.rows]
        heads = [Column(head, left=True) for head in ("axis", "rule")] + [Column(head) for head in ("P", "I", "D")]
        gains = Table(heads, "Gains per mm, as of LinuxCNC's pid in machine units of mm", rows=rows)
        return "\n\n".join([relay_table(self.axes, self.units).text(), gains.text(), paragraphs(map(str, self.findings))])


@question(OfRelay, name="commission relay")
def relay(log: str | Path | Log, *, settings: OfRelay, session: Session = QUIET) -> RelayCommissioned:
    """Find ultimate gain and period of each axis from a log of a relay experiment, and gains by rules.

    Parameters
    ----------
    log : str, Path or Log
        With the command of the relay, as the drive takes it, and the position.

    Returns
    -------
    RelayCommissioned

    Raises
    ------
    LogError, ResultError
        If the log cannot be read or lacks a signal, or an axis does not oscillate steadily under a relay.
    ParameterError
        If an option is out of range.
    """
    given = {name: getattr(settings, name) for name in Identify.PARTS if name in OfRelay.PARTS}
    tests, units, findings = dict[str, RelayTest](), dict[str, str](), dict[str, Finding]()
    with about(log, options=list(OfRelay.PARTS)):
        opened = Request(Identify(**given), (log,)).log(0)
        driven = [axis for axis in opened.result.axes if (command := opened.signal(axis, "command")) is not None and np.ptp(command) > 0.0]
        for axis in axes_of(opened, settings.axis or ",".join(driven) or None):
            request = Request(Identify(**given | {"axis": axis}), (opened,))
            (record,) = request.records(pieces=False)
            try:
                tests[axis] = relay_test(record.driven(), record.position, record.period)
            except ResultError as error:
                raise ResultError(f"axis {axis}: {error}") from error
            units[axis] = record.unit
            findings |= {str(doubt): doubt for doubt in request.findings()}
    gains = {axis: {rule: test.gains(rule) for rule in RULES} for axis, test in tests.items()}
    return RelayCommissioned(tests, gains, units, (*relay_findings(tests, units), *findings.values()))
