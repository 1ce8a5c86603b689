"""What ``contourlab swap`` writes."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from contourlab.app.json_values import json_values
from contourlab.features.run.command import RunOutcome, file_names
from contourlab.features.swap.numbers import divided_controller
from contourlab.features.swap.picture import write_matrices
from contourlab.features.swap.report import SwapReport
from contourlab.features.swap.study import SwapStudy
from contourlab.features.swap.text import matrices, summary_of, text_of
from contourlab.result import write_text_atomic


def written(report: SwapReport, folder: Path, out: Path, plots: Sequence[str]) -> RunOutcome:
    """Write everything into a folder that takes the place of `out`; return what is printed."""
    study, lines = report.study, [text_of(report)]
    if plots:
        write_matrices(matrices(study), study.settings.full, "What a swap loses", folder / "plots", plots)
        lines += [f"picture: {out / 'plots' / f'swap.{name}'}" for name in plots]
    (folder / "controllers").mkdir()
    lines += list(_controllers(study, folder / "controllers", out / "controllers"))
    summary = summary_of(report)
    write_text_atomic(folder / "swap.json", json.dumps(json_values(summary), indent=2, allow_nan=False) + "\n")
    return RunOutcome(report.passed, summary, "\n".join(lines))


def _controllers(study: SwapStudy, folder: Path, out: Path) -> Iterator[str]:
    """Write the recommended design, the best of each variant, and the shared design; yield where they are."""
    from contourlab.scenario.dump import dump

    fleet, best, base = study.fleet, study.recommended, study.base
    names = file_names([variant.name for variant in fleet.variants])

    def write(name: str, point: Any, i: int, head: str, local: Sequence[str] = ()) -> None:
        made = divided_controller(fleet.controller, fleet.space.values(point), local)
        write_text_atomic(folder / f"{name}.toml", f"# {head}\n\n{dump(made, fleet.variants[i].machine)}")

    met = "J and the guards were met on the motion of the study"
    for i, variant in enumerate(fleet.variants):
        write(f"own-{names[variant.name]}", fleet.best_points[i], i, f"Best of {variant.name} alone; {met}.")
        if best is not None:
            head, local = f"For {variant.name}; {met}. `local` moves with the axis.", sorted(best.design.local)
            write(names[variant.name], best.design.points[i], i, head, local)
            yield f"controller for {variant.name}: {out / f'{names[variant.name]}.toml'}"
    others = [f"the best of each variant alone: {out / 'own-*.toml'}"]
    if base.design.holds:
        write(
            "shared", base.design.points[0], 0, f"Shared by {'; '.join(variant.name for variant in fleet.variants)}, nothing local; {met}."
        )
        others.append(f"the shared design, nothing local: {out / 'shared.toml'}")
    yield ", ".join(others)
