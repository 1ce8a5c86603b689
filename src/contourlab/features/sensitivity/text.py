"""A sensitivity study in print, and as JSON."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from contourlab.features.sensitivity.curves import CHANGE
from contourlab.features.sensitivity.verdict import ranking, verdict

if TYPE_CHECKING:
    from contourlab.design import DesignVariable
    from contourlab.features.sensitivity import Curve, Distribution, Outcome, Runs, Stretch, Study
    from contourlab.scenario import Case

SHOWN = {"integral": (1e6, "um s"), "rms": (1e6, "um"), "max": (1e6, "um")}
"""Factor from SI, and unit in print."""
FEW = 24
"""A matrix of more numbers than this is not printed: JSON and the picture have it."""


def text_of(study: Study, runs: Runs, case: Case, notes: Sequence[str]) -> str:
    """Return the study as text."""
    factor, unit = SHOWN[study.plan.figure.name]
    n, period = len(study.space.numbers), case.machine.servo_period
    lines = [f"{case.name}: {study.plan.figure.words} {study.figure * factor:.4g} {unit}, servo period {period * 1e3:g} ms"]
    lines.append(f"{n} numbers, {runs.made + runs.found} runs")
    lines += [f"note: {note}" for note in notes]
    parts = (_curves, _local, _interactions, _morris, _sobol)
    for part in parts:
        found = list(part(study))
        lines += ["", *found] if found else []
    return "\n".join([*lines, "", "In words:", *(f"  {sentence}" for sentence in verdict(study))])


def table(rows: Sequence[Sequence[str]]) -> list[str]:
    """Return rows of cells in columns: the first to the left, the others to the right; the last as it is."""
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]))]

    def cell(i: int, text: str) -> str:
        return text.ljust(widths[i]) if i in (0, len(widths) - 1) else text.rjust(widths[i])

    return [("  " + "  ".join(cell(i, text) for i, text in enumerate(row))).rstrip() for row in rows]


def _unit(number: DesignVariable) -> str:
    return number.display_unit


def _curves(study: Study) -> Iterator[str]:
    if study.curves is None:
        return
    factor, unit = SHOWN[study.plan.figure.name]
    yield f"One at a time, {study.plan.values} values each, the others as they are:"
    rows = [("number", "value", "from", "to", "unit", "lowest at", "+-", f"there [{unit}]", "remarks")]
    for curve in study.curves:
        number, lowest = curve.number, curve.minimum
        cells = [number.short, *(f"{number.display_value(value):.4g}" for value in (number.value, number.low, number.high)), _unit(number)]
        if lowest is None:
            cells += ["-", "-", "-"]
        else:
            at, within = number.display_value(lowest.value), number.display_value(lowest.within)
            cells += [f"{at:.4g}", f"{within:.1g}", f"{lowest.figure * factor:.4g}"]
        rows.append((*cells, "; ".join(_curve_remarks(curve))))  # type: ignore[arg-type]
    yield from table(rows)


def _curve_remarks(curve: Curve) -> Iterator[str]:
    if curve.minimum is not None and curve.minimum.bound:
        yield f"lowest at the {curve.minimum.bound} bound, perhaps lower beyond"
    if curve.flat is not None:
        yield f"{_where(curve, curve.flat)} the error changes by less than {100.0 * CHANGE:.0f} %"
    for part in curve.failed:
        yield f"runs fail {_where(curve, part)}"


def _where(curve: Curve, part: Stretch) -> str:
    low, high = (f"{curve.number.display_value(value):.3g}" for value in (part.low, part.high))
    if part.first and part.last:
        return "everywhere"
    if part.last:
        return f"from {low} on"
    return f"up to {high}" if part.first else f"from {low} to {high}"


def _local(study: Study) -> Iterator[str]:
    if study.local is None:
        return
    yield "Small changes: percent of the error for one percent of the number; the step is the one whose neighbour agrees best:"
    rows = [("number", "sensitivity", "twice the step differs by", "step", "below", "above", "remarks")]
    for one in study.local.slopes:
        percent = f"{100.0 * one.step:.2g} %"
        rows.append(
            (one.number.short, f"{one.sensitivity:+.3g}", f"{one.apart:.2g}", percent, f"{one.below:+.3g}", f"{one.above:+.3g}", one.remark)
        )
    yield from table(rows)


def _interactions(study: Study) -> Iterator[str]:
    if study.local is None or not 1 < len(study.space.numbers) <= FEW:
        return
    matrix, doubtful = study.local.interactions, study.local.doubtful
    step = 100.0 * float(study.local.interaction_steps.max())
    yield f"Interactions, second differences in parts of the error (step {step:.2g} %); ? where with half the step it is half off:"
    rows = [("", *(str(j + 1) for j in range(len(matrix))), "")]
    for j, (number, values) in enumerate(zip(study.space.numbers, matrix, strict=True)):
        cells = [f"{value:.2g}" + ("?" if doubtful[j, k] else "") for k, value in enumerate(values)]
        rows.append((f"{j + 1} {number.short}", *cells, ""))
    yield from table(rows)


def _drawn(one: Distribution) -> str:
    number = one.number
    low, high = (f"{number.display_value(value):.4g}" for value in (number.low, number.high))
    if one.kind == "normal":
        centre, deviation = number.display_value(number.value), number.display_value(one.deviation)
        return f"normal around {centre:.4g}, deviation {deviation:.3g}, cut off at {low} and {high}"
    return f"{one.kind} from {low} to {high}"


def _taken(study: Study, found: Outcome) -> str:
    factor, unit = SHOWN[study.plan.figure.name]
    what = "log10 of the figure" if found.logarithmic else "the figure"
    failed = f"{found.failed} failed ({100.0 * found.share:.2g} %)"
    counted = f", each counted as {found.capped * factor:.3g} {unit}" if found.failed else ""
    return f"of {what}; {len(found.values)} runs, {failed}{counted}"


def _morris(study: Study) -> Iterator[str]:
    if study.morris is None or study.morris_outcome is None:
        return
    scale, unit = (1.0, "decades") if study.plan.logarithmic else SHOWN[study.plan.figure.name]
    yield f"Elementary effects (Morris) over each whole range [{unit}], {_taken(study, study.morris_outcome)}:"
    rows = [("number", "mu*", "+- (95 %)", "mu", "sigma", "distribution")]
    m = study.morris
    for j in np.argsort(-m.mu_star, kind="stable"):
        cells = [f"{values[j] * scale:.3g}" for values in (m.mu_star, m.mu_star_interval, m.mu, m.sigma)]
        rows.append((study.space.numbers[j].short, *cells, _drawn(study.distributions[j])))
    yield from table(rows)


def _sobol(study: Study) -> Iterator[str]:
    if study.sobol is None or study.sobol_outcome is None:
        return
    yield f"Shares of the variance (Sobol, Saltelli N = {study.plan.base}) {_taken(study, study.sobol_outcome)}:"
    rows = [("number", "first", "+- (95 %)", "total", "+- (95 %)", "distribution")]
    s = study.sobol
    for j in np.argsort(-s.total, kind="stable"):
        cells = [f"{values[j]:.3f}" for values in (s.first, s.first_interval, s.total, s.total_interval)]
        rows.append((study.space.numbers[j].short, *cells, _drawn(study.distributions[j])))
    yield from table(rows)
    if s.second is not None and s.second_interval is not None:
        pairs = [tuple(pair) for pair in np.argwhere(np.isfinite(s.second))]
        pairs.sort(key=lambda pair: -s.second[pair])  # type: ignore[index]
        yield "  pairs that explain most beyond each by itself:"
        names = [number.short for number in study.space.numbers]
        for j, k in pairs[:8]:
            yield f"    {names[j]} with {names[k]}: {s.second[j, k]:.3f} +- {s.second_interval[j, k]:.3f}"


def summary_of(study: Study, runs: Runs, case: Case, notes: Sequence[str], command: str) -> dict[str, Any]:
    """Return the study as JSON holds it, SI throughout."""
    plan, names = study.plan, study.space.names
    found: dict[str, Any] = {
        "command": command,
        "scheme": case.name,
        "machine": case.machine.name,
        "servo_period": case.machine.servo_period,
        "figure": {"name": plan.figure.name, "key": plan.figure.key, "unit": plan.figure.unit, "value": study.figure},
        "numbers": [
            {"name": n.name, "short": n.short, "value": n.value, "low": n.low, "high": n.high, "unit": n.unit, "display": _unit(n)}
            for n in study.space.numbers
        ],
        "runs": {"made": runs.made, "kept_from_before": runs.found},
    }
    found |= _parts(study)
    order = ranking(study)
    if order is not None:
        groups = {"matter": order.matter, "open": order.open, "rest": order.rest}
        found["ranking"] = {"by": order.by} | {key: [names[j] for j in which] for key, which in groups.items()}
    return found | {"verdict": list(verdict(study)), "notes": list(notes)}


def _parts(study: Study) -> dict[str, Any]:
    plan, names = study.plan, study.space.names
    found: dict[str, Any] = {}
    if study.curves is not None:
        found["curves"] = {curve.number.name: _curve_summary(curve) for curve in study.curves}
    if study.local is not None:
        found["local"] = {
            "sensitivities": {
                one.number.name: {key: getattr(one, key) for key in ("sensitivity", "step", "apart", "below", "above", "remark")}
                for one in study.local.slopes
            },
            "interactions": study.local.interactions.tolist(),
            "interactions_apart": study.local.interactions_apart.tolist(),
            "interaction_steps": study.local.interaction_steps.tolist(),
        }
    if study.morris is not None:
        keys = ("mu_star", "mu_star_interval", "mu", "sigma")
        found["morris"] = _sampled(study, study.morris_outcome) | {key: _named(names, getattr(study.morris, key)) for key in keys}
        found["morris"]["trajectories"] = plan.trajectories
    if study.sobol is not None:
        keys = ("first", "first_interval", "total", "total_interval")
        found["sobol"] = _sampled(study, study.sobol_outcome) | {key: _named(names, getattr(study.sobol, key)) for key in keys}
        found["sobol"] |= {"base": plan.base, "seed": plan.seed, "deviation": study.sobol.deviation}
        if study.sobol.second is not None and study.sobol.second_interval is not None:
            found["sobol"] |= {"second": study.sobol.second.tolist(), "second_interval": study.sobol.second_interval.tolist()}
    return found


def _named(names: Sequence[str], values: Any) -> dict[str, float]:
    return dict(zip(names, values.tolist(), strict=True))


def _sampled(study: Study, found: Outcome | None) -> dict[str, Any]:
    assert found is not None
    return {
        "of": "log10 of the figure" if found.logarithmic else "the figure",
        "runs": len(found.values),
        "failed": found.failed,
        "failed_counts_as": found.capped,
        "distributions": {
            one.number.name: {"kind": one.kind, **({"deviation": one.deviation} if one.kind == "normal" else {})}
            for one in study.distributions
        },
    }


def _curve_summary(curve: Curve) -> dict[str, Any]:
    def ends(part: Stretch) -> dict[str, float]:
        return {"low": part.low, "high": part.high}

    lowest = curve.minimum
    return {
        "values": curve.values.tolist(),
        "figures": curve.figures.tolist(),
        "minimum": None
        if lowest is None
        else {"value": lowest.value, "figure": lowest.figure, "within": lowest.within, "bound": lowest.bound},
        "flat": None if curve.flat is None else ends(curve.flat),
        "failed": [ends(part) for part in curve.failed],
    }
