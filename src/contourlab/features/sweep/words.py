"""The answers of a store in sentences."""

from __future__ import annotations

from dataclasses import dataclass

from contourlab.features.sweep.answers import GOAL, Answers
from contourlab.features.sweep.effects import Effect, Subset
from contourlab.features.sweep.pairings import Pairings, enough
from contourlab.features.sweep.summary import display
from contourlab.figures import figure, listing, number

KINDS = {"max": "largest", "rms": "rms", "mean": "mean"}
SHORT = 0.1
"""Time [s] below which milliseconds are shown."""
CLEAR = 0.02
"""Least difference of two yields that is worth a sentence."""
SORTED = (0.9, 0.99, 0.999)
"""Yields to reach by sorting out modules: the next one above the yield of all."""
MATTERS = 0.01
"""Least share of the variance of a parameter that matters."""
LITTLE = "less than 1 %, or may explain nothing (interval from 0 %)"
"""What a parameter explains that does not matter for certain."""


@dataclass(frozen=True)
class Words:
    """Sentences.

    Attributes
    ----------
    sentence, decides, stop, front, modules : str
        The first answer; what decides the figure; whether more variants are needed; the Pareto front; what the modules decide, and which
        to sort out. Empty where there is none.
    """

    sentence: str
    decides: str
    stop: str
    front: str
    modules: str


def said(answers: Answers) -> Words:
    """Return the answers in sentences."""
    first = _best(answers) if answers.design == "search" else _yield(answers) if answers.share is not None else _spread(answers)
    return Words(" ".join(filter(None, (first, _which(answers)))), _decides(answers), _stop(answers), _front(answers), _modules(answers))


def title_of(name: str) -> str:
    """Return a figure in words.

    >>> title_of("part_error_max"), title_of("cycle_time")
    ('largest part error', 'cycle time')
    """
    base, _, kind = name.rpartition("_")
    return f"{KINDS[kind]} {title_of(base)}" if kind in KINDS else name.replace("_", " ")


def kind_of(answers: Answers) -> str:
    """Return what the variants are: pairings of modules, or machines, if only these vary."""
    if answers.pairings is not None:
        return "pairings"
    return "machines" if answers.effects and all(one.column.startswith("axes.") for one in answers.effects) else "variants"


def share_text(share: float | None, digits: int = 4) -> str:
    """Return a share in percent; close to 0 and 1 without needless digits."""
    return "-" if share is None else figure(round(share, digits), "%", digits)


def range_text(low: float | None, high: float | None, digits: int = 4) -> str:
    """Return an interval of shares in percent."""
    return "-" if low is None or high is None else f"{share_text(low, digits).removesuffix(' %')} to {share_text(high, digits)}"


def shown(value: float | None, unit: str, digits: int = 3) -> str:
    """Return a value in its display unit."""
    if unit == "s" and value is not None and abs(value) < SHORT:
        return figure(value, "ms", digits)
    name, factor = display(unit)
    return "-" if value is None else f"{number(value * factor, digits)} {name}".strip()


def value_text(subset: Subset) -> str:
    """Return the value of a subset."""
    return subset.value if isinstance(subset.value, str) else shown(subset.value, subset.unit, 4)


def _yield(answers: Answers) -> str:
    ends = range_text(answers.low, answers.high)
    interval = f" ({ends} with 95 % confidence)" if answers.is_sample else ""
    passing = f"{answers.passed:,} of {answers.judged:,} {kind_of(answers)} make the part within {shown(answers.tolerance, 'm', 6)}"
    return f"{passing}: {share_text(answers.share)}{interval}."


def _best(answers: Answers) -> str:
    value = shown(answers.smallest, answers.unit)
    return f"The best of {answers.judged:,} variants of a search has a {title_of(answers.figure)} of {value}."


def _spread(answers: Answers) -> str:
    ends = f" ({shown(answers.p95_low, answers.unit)} to {shown(answers.p95_high, answers.unit)} with 95 % confidence)"
    interval = ends if answers.is_sample and answers.p95_low is not None else ""
    most = f"95 % of {answers.judged:,} {kind_of(answers)} have a {title_of(answers.figure)} up to {shown(answers.p95, answers.unit)}"
    return f"{most}{interval}; half of them up to {shown(answers.median, answers.unit)}."


def _which(answers: Answers) -> str:
    """Return which variants pass: those on one side of the best cut."""
    best: Effect | None = max(answers.effects, key=lambda one: one.gain, default=None)
    if best is None or best.below is None or best.above is None or abs(best.below - best.above) < CLEAR:
        return ""
    low_is_better = best.below > best.above
    side, (good, bad) = ("up to" if low_is_better else "above"), sorted((best.below, best.above), reverse=True)
    return f"Of those with {best.column} {side} {shown(best.cut, best.unit)}, {share_text(good, 3)} do, of the others {share_text(bad, 3)}."


def _decides(answers: Answers) -> str:
    strong = [one for one in answers.effects if one.index_low > 0.0 and one.index >= MATTERS]
    rest = len(answers.effects) - len(strong)
    if not answers.effects:
        return ""
    if not strong:
        return f"No parameter decides the {title_of(answers.figure)} alone: each explains {LITTLE}."
    named = listing([f"{one.column} ({share_text(one.index, 2)})" for one in strong])
    others = "The other one explains" if rest == 1 else f"Each of the other {rest} explains"
    tail = f" {others} {LITTLE}." if rest else ""
    twice = " They add up to more than 100 %, because some of them are correlated." if sum(one.index for one in strong) > 1.0 else ""
    what = f"What decides the {title_of(answers.figure)}, in order, with the share of its variance that each explains"
    return f"{what}: {named}.{twice}{tail}"


def _stop(answers: Answers) -> str:
    if not answers.is_sample:
        return f"A {answers.design} is no sample: more variants of it would not make these numbers surer."
    said = []
    if answers.low is not None and answers.high is not None:
        half = figure((answers.high - answers.low) / 2.0, "%", 2)
        said.append(f"The yield is known to +-{half}; {_enough(answers.needed_for_yield, answers)}.")
    if answers.p95 is not None and answers.p95_low is not None and answers.p95_high is not None:
        error = (answers.p95_high - answers.p95_low) / 2.0
        known = f"The 95 % quantile, {shown(answers.p95, answers.unit)}, is known to +-{shown(error, answers.unit, 2)}"
        share = f" ({figure(error / answers.p95, '%', 2)})" if answers.p95 > 0.0 else ""
        said.append(f"{known}{share}; {_enough(answers.needed_for_p95, answers)}.")
    return " ".join(said)


def _enough(needed: int | None, answers: Answers) -> str:
    if needed is None:
        return "how many more it needs cannot be told"
    goal = f"+-{figure(GOAL, '%')}"
    if answers.pairings is not None:
        kinds = answers.pairings.kinds
        times = (needed / answers.judged) ** (1.0 / len(kinds))
        modules = " and ".join(f"{_about(times * kind.modules)} {kind.column.removesuffix('.module')} modules" for kind in kinds)
        return f"{goal} needs about {modules}" if times > 1.0 else f"that is enough for {goal}"
    if needed <= answers.judged:
        return f"{_about(needed)} variants are enough for {goal}"
    return f"{goal} needs about {_about(needed - answers.judged)} more variants"


def _about(count: float) -> str:
    """Return a count in two digits.

    >>> _about(22_400), _about(87)
    ('22,000', '87')
    """
    return f"{float(f'{count:.2g}'):,.0f}"


def _front(answers: Answers) -> str:
    if not answers.objectives:
        return ""
    names = listing([title_of(name) for name in answers.objectives])
    return f"{answers.front_size:,} of {answers.judged:,} {kind_of(answers)} are best compromises of {names}: no other is better in all."


def _modules(answers: Answers) -> str:
    found = answers.pairings
    if found is None:
        return ""
    explained = listing([f"{kind.column.removesuffix('.module')} ({share_text(kind.index, 2)})" for kind in found.kinds])
    rest = max(1.0 - sum(kind.index for kind in found.kinds), 0.0)
    what = f"Share of the variance of the {title_of(answers.figure)} that the module explains, whatever its partners: {explained}"
    pairing = f"; the pairing itself: {share_text(rest, 2)}" if len(found.kinds) > 1 else ""
    return " ".join(filter(None, (_under(found), f"{what}{pairing}.", _sorting(found))))


def _under(found: Pairings) -> str:
    """Return under which choices the modules are judged."""
    if not found.choices:
        return ""
    named = listing([f"{name} {value if isinstance(value, str) else number(value)}" for name, value in found.choices.items()])
    yields = f", with which {share_text(found.share)} of {found.judged:,} pairings pass" if found.share is not None else ""
    return f"Modules are judged under the best choice, {named}{yields}."


def _sorting(found: Pairings) -> str:
    """Return how few modules spoil the yield."""
    if found.share is None or not found.bad:
        return ""
    goal = next((goal for goal in SORTED if found.share < goal), 1.0)
    count = enough(found.bad, goal)
    bad = found.bad[:count]
    if bad[-1].left < goal:
        return f"Even without the worst {count} modules the yield stays below {share_text(goal)}."
    parts = [(kind.column.removesuffix(".module"), sum(one.column == kind.column for one in bad), kind.modules) for kind in found.kinds]
    which = listing([f"{gone} of {modules:,} {name}" for name, gone, modules in parts if gone])
    return f"Without the worst modules, {which}, the yield rises from {share_text(found.share)} to {share_text(bad[-1].left)}."
