"""What is learned from trial to trial: the table ``[learning]``."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from contourlab.components.learning.law import LearningLaw
from contourlab.loop import Machine
from contourlab.scenario.components import read_component
from contourlab.scenario.files import locate
from contourlab.scenario.tables import LearningTable, read_table
from contourlab.scenario.tree import Leaf, Table


@dataclass(frozen=True)
class LearningSettings:
    """How a case learns.

    Attributes
    ----------
    law : LearningLaw
    trials : int
        Largest number of trials after the first, which has learned nothing.
    improvement : float, 0 to 1
        Learning has converged once `patience` trials bring no more than this part of the contour error.
    patience : int
    table : Path or None
        A learned table to start with.
    """

    law: LearningLaw
    trials: int = 30
    improvement: float = 0.01
    patience: int = 10
    table: Path | None = None


def read_learning(table: Table, machine: Machine) -> LearningSettings | None:
    """Return the settings of ``[learning]``; None where there are none, or ``law = "none"``.

    Raises
    ------
    ScenarioError
        With file and key of what is wrong.
    """
    if not table.entries:
        return None
    plain = read_table(LearningTable, table)
    first = machine.axes[0].plant
    law: Any = read_component(table.entries["law"], "learning", (first.command_unit, first.force_unit), optional=True)
    if law is None:
        return None
    start = None
    if plain.table is not None:
        reference = table.entries["table"]
        assert isinstance(reference, Leaf)  # a string, as the model has seen
        start = locate(plain.table, Path(reference.file).parent)
    return LearningSettings(law, plain.trials, plain.improvement, plain.patience, start)
