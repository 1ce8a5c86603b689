"""Searches of a swap that are kept: what decides them."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.metadata import version
from pathlib import Path

from contourlab.app.component_sources import plugin_digests
from contourlab.app.program_version import DECIDES_RUNS, program_version
from contourlab.features.swap.fleet import Fleet
from contourlab.features.swap.kept import Kept
from contourlab.features.swap.settings import SwapSettings

KEPT = "searches"
"""Folder of the searches that are kept, in that of the results."""


def kept_searches(folder: Path, fleet: Fleet, candidates: Sequence[str], settings: SwapSettings) -> Kept:
    """Return where the searches of a study are kept: under all that decides it, the content of its files included."""
    from contourlab.scenario.dump import dump

    words = [f"{variant.name} {variant.modules}\n{dump(variant.machine)}" for variant in fleet.variants]
    words += [dump(fleet.controller, fleet.variants[0].machine), fleet.reference.digest, f"seed {fleet.seed}, moving {fleet.moving}"]
    words += [f"{fleet.objective} {fleet.floor!r} {fleet.bounds}", *map(repr, fleet.space.numbers), f"candidates {list(candidates)}"]
    # Sets have no order of their own.
    local = None if settings.local is None else [sorted(names) for names in settings.local]
    known = [[sorted(values.items()) for values in design] for design in settings.known]
    words.append(f"{settings.budget} {settings.seed} {settings.full!r} {settings.exhaustive} {local} {known}")
    words += plugin_digests([variant.machine for variant in fleet.variants], fleet.controller)
    words += [f"{name} {version(name)}" for name in ("cma", "numpy")]
    words.append(program_version((*DECIDES_RUNS, "analysis", "design", "features/swap")))
    return Kept(folder, "\n".join(words))
