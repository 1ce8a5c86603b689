"""A runner whose figures come from a function instead of a machine."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, cast

import numpy as np

from contourlab.study.checkpoint import Checkpoint
from contourlab.study.runner import Columns, Runner

Model = Callable[[Columns], Mapping[str, np.ndarray]]


class Modelled(Runner):
    """Figures of candidates from a model."""

    def __init__(self, model: Model, store: Checkpoint | None = None) -> None:
        super().__init__(cast(Any, None), store=store)
        self.model = model

    def run(self, columns: Columns, threads: int | None = None) -> dict[str, np.ndarray]:
        """Return the figures of the model."""
        return dict(self.model(columns))
