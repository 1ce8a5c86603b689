"""The result of ``contourlab swap``: as JSON, as text, and as its picture."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from textwrap import wrap
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from contourlab.analysis.linear.margins import Margins
from contourlab.app.json_values import write_json
from contourlab.app.results import proposed, staged
from contourlab.app.session import Answer, Asked
from contourlab.arrays import Array, Flags
from contourlab.errors import ParameterError, refuse
from contourlab.features.link.result import largest_held
from contourlab.features.run.command import file_names
from contourlab.features.swap.beyond import Coverage, NetworkCost
from contourlab.features.swap.linear import LinearSwap
from contourlab.features.swap.search import Design, Optimum
from contourlab.features.swap.study import SwapStudy
from contourlab.features.swap.variants import Variants
from contourlab.figures import figure
from contourlab.findings import Finding, finding
from contourlab.rendering.margin_words import decibel, degrees
from contourlab.rendering.stages import begin_stage
from contourlab.rendering.style import INK, MUTED
from contourlab.rendering.table import Column, Table, paragraphs
from contourlab.result import write_text_atomic

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False)
class VariantResult:
    """The result for one variant, in SI.

    Attributes
    ----------
    best : float
        J*.
    alone : Optimum
        Result of the searches for this variant alone.
    parameters : dict
        The design that reached J*.
    margins : dict of str to Margins
        Exact margins of the recommended design, or of the shared one if none is recommended; omits axes without a linear model.
    broken : tuple of str
        Guards that this design breaks in the exact analysis.
    """

    best: float
    alone: Optimum
    parameters: dict[str, float]
    margins: dict[str, Margins]
    broken: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class SwapResult(Answer):
    """The result of the command, in SI; its fields are the keys of ``swap.json``.

    `local` is None if no choice of local parameters is modular. `swap_loss` is the loss of the shared design, and
    `uncertainty` how much it may still change, from a quick study. `designs_on_variants` holds
    J of the best design of each variant (rows) on each variant (columns).
    """

    study: SwapStudy = field(repr=False)
    variants: dict[str, VariantResult]
    networks: tuple[NetworkCost, ...] = ()
    coverage: Coverage | None = None
    linear: tuple[LinearSwap, ...] = ()
    warm_starts: tuple[str, ...] = ()
    on_files: tuple[Finding, ...] = ()
    inputs: tuple[str | Path, ...] = field(default=(), repr=False)
    lines: tuple[str, ...] = field(default=(), repr=False)

    json_form: ClassVar = {
        "passed": "passed",
        "verdict": "study.verdict",
        "full_modularity": "study.full",
        "local": "local",
        "swap_loss": "study.base.swap_loss",
        **{name: f"study.{name}" for name in ("uncertainty", "inconclusive", "settings")},
        **{name: f"study.variants.{name}" for name in ("objective", "floor")},
        "guards": "study.variants.bounds",
        "runs": "study.variants.runs",
        "warm_starts": "warm_starts",
        "parameters": "study.variants.space.numbers",
        "variants": "variants",
        "as_given": "study.given",
        "choices": "study.choices",
        "designs_on_variants": "study.crossed",
        **{name: name for name in ("networks", "coverage", "linear", "findings")},
    }

    @property
    def passed(self) -> bool:
        """Whether a design is modular, keeps the guards, and holds over a network."""
        study, kept = self.study, not any(one.broken for one in self.variants.values())
        modular = study.recommended is not None and not study.inconclusive and not study.unsure
        return modular and kept and any(cost.holds for cost in self.networks)

    @property
    def local(self) -> tuple[str, ...] | None:
        """The local parameters of the recommended design."""
        best = self.study.recommended
        return None if best is None else tuple(sorted(best.local))

    @property
    def findings(self) -> tuple[Finding, ...]:
        """All findings, the verdict first."""
        return tuple(_findings(self))

    @property
    def text(self) -> str:
        """The verdict, losses, designs and margins; files once it is saved."""
        return "\n\n".join([text_of(self), *self.lines])

    @property
    def rows(self) -> list[dict[str, Any]]:
        """The variants, one a row [SI]."""
        return [{"variant": name, "best": one.best, **one.parameters} for name, one in self.variants.items()]

    def plot(self, ax: Axes | None = None, *, key: str = "", width: float | str | None = None) -> Axes:
        """Draw the losses of each variant; on given axes those of one controller for all. It has the width of its names."""
        refuse(width is not None, ParameterError, "width", repr(width), "left out: names and cells set it")
        losses, full = matrices(self.study), self.study.settings.full
        if ax is None:
            return drawing(losses, full).axes[0]  # type: ignore[no-any-return]
        _draw(ax, losses[0], full)
        return ax

    def save(self, folder: str | Path = "results", *, plots: Sequence[str] = ("png",)) -> SwapResult:
        """Write ``swap.json``, controllers and a picture into a folder.

        Parameters
        ----------
        folder : str or Path
        plots : sequence of str
            Formats of the picture: png, svg or pdf.

        Returns
        -------
        SwapResult
            With the lines that list its files.

        Raises
        ------
        OutputError
            If the folder cannot be written to.
        """
        begin_stage("writing")
        with staged(folder, "swap.json", inputs=self.inputs) as stage:
            lines = write_results(self.study, stage, Path(folder), plots)
            write_json(stage / "swap.json", self)
        return replace(self, lines=tuple(lines))

    def _next(self, asked: Asked) -> Sequence[object]:
        """Answer in full; or divide the controllers."""
        return asked.again(without="--quick") if asked.settings.quick else ["link", *asked.given]


def judged_exactly(study: SwapStudy) -> dict[str, VariantResult]:
    """Return the result for each variant, with exact margins of the recommended design, or of the shared one."""
    variants, judged = study.variants, {}
    for i, (name, point) in enumerate(zip(variants.names, study.shown.points, strict=True)):
        values, guards = variants.space.values(point), variants.guards[i]
        margins = guards.exact(values)
        # The runs have already checked the time at drive limits.
        broken = guards.broken(values, 0.0, 0.0, margins)
        own = variants.space.values(variants.best_points[i])
        judged[name] = VariantResult(float(variants.best[i]), study.optima[i], own, margins, broken)
    return judged


def _findings(result: SwapResult) -> Iterator[Finding]:
    study, networks, coverage = result.study, result.networks, result.coverage
    variants = study.variants
    yield study.verdict
    if not math.isfinite(study.base.swap_loss):
        yield finding("CL723")
    elif study.uncertainty is not None and not study.unsure:
        yield finding("CL722", loss=study.base.swap_loss, uncertainty=study.uncertainty)
    for name, variant in result.variants.items():
        if variant.broken:
            yield finding("CL711", name, guards=variant.broken)
    for cost in networks:
        yield from _on_network(variants, cost)
    if networks and study.settings.quick:
        yield finding("CL765")
    if coverage is not None:
        low, high = coverage.interval
        yield finding("CL717", share=coverage.share, low=low, high=high, covered=coverage.covered, points=len(coverage.points))
        if coverage.without_design:
            yield finding("CL719", count=coverage.without_design)
    if edges := on_bounds(variants, study.shown):
        yield finding("CL712", names=edges)
    if study.given_breaks:
        yield finding("CL713", names=study.given_breaks)
    for axis, reason in {axis: reason for guards in variants.guards for axis, reason in guards.unknown.items()}.items():
        yield finding("CL714", f"axis {axis}", reason=reason)
    for designs in result.linear:
        yield from designs.findings
    yield from result.on_files
    settings, guarded = study.settings, variants.bounds.words
    yield finding("CL720", runs=variants.runs, budget=settings.budget, seed=settings.seed, guards=guarded)


def _on_network(variants: Variants, cost: NetworkCost) -> Iterator[Finding]:
    if math.isnan(cost.rate):
        yield finding("CL707", cost.name)
    else:
        fails = {"fails": 1.0 / cost.fails} if cost.limited else {}
        yield finding("CL705" if fails else "CL706", cost.name, rate=cost.rate, **fails)
        if not cost.holds:
            yield finding("CL708", cost.name)
    if any(variant.unstable for variant in cost.variants):
        yield finding("CL709", cost.name)
    if cost.local_in_base:
        yield finding("CL710", cost.name, names=[short for name in cost.local_in_base for short in variants.short((name,))])


def on_bounds(variants: Variants, choice: Design) -> list[str]:
    """Return the parameters of a design that lie on a bound that could be wider, with the bound."""
    values = ((one, value) for j, one in enumerate(variants.space.numbers) for value in one.physical(choice.points[:, j]).tolist())
    bounds = ((one, one.low if value - one.low < one.high - value else one.high) for one, value in values if one.cramped(value))
    return list(dict.fromkeys(f"{one.short} at {one.display_value(bound):.4g} {one.display_unit}".rstrip() for one, bound in bounds))


# --- text --------------------------------------------------------------------------------------------------------------------------------


def text_of(result: SwapResult) -> str:
    """Return the result as text, the verdict first."""
    study, best = result.study, result.study.recommended
    verdict, *others = map(str, result.findings)
    which = "the shared design, nothing local" if best is None else "the recommended design"
    tables = [*([] if best is None else [_division(study, best)]), _margins(result, which)]
    tables += [_networks(result, which)] if result.networks else []
    tables += map(_linear, result.linear)
    return "\n\n".join([paragraphs([verdict]), _losses(study).text(), paragraphs(others), *(table.text() for table in tables)])


def _losses(study: SwapStudy) -> Table:
    variants = study.variants
    tolerance = figure(variants.floor, variants.unit)
    title = f"J: {variants.objective.replace('_', ' ')} [{variants.unit}]; loss: (J - J*)/max(J*, J_tol), J_tol {tolerance}"
    columns = [Column("local parameters", left=True, prose=True), Column("number"), *map(Column, variants.names), Column("loss [%]")]
    rows: list[tuple[str, str, Iterable[float], str]] = [
        ("J*, best value of all searches", "", variants.best, ""),
        ("best value of its own search", "", (optimum.reached for optimum in study.optima), ""),
        ("the scenario's own", "", study.given.values, _percent(study.given.swap_loss)),
        *((choice.name, str(len(choice.local)), choice.values, _percent(choice.swap_loss)) for choice in study.choices),
    ]
    shown = [(name, count, *(_number(value, variants.unit) for value in values), loss) for name, count, values, loss in rows]
    return Table(columns, title, rows=shown)


def _division(study: SwapStudy, choice: Design) -> Table:
    """Return the table of a design: base parameters once, local parameters for each variant."""
    columns = [Column("parameter", left=True), Column("", left=True), *map(Column, study.variants.names), Column("unit", left=True)]
    rows = []
    for number in study.variants.space.numbers:
        local = number.name in choice.local
        values = [f"{number.display_value(point[number.name]):.6g}" for point in choice.parameters]
        shown = values if local else [values[0], *[""] * (len(values) - 1)]
        rows.append((number.short, "local" if local else "base", *shown, number.display_unit))
    return Table(columns, "Recommended design", rows=rows)


def _margins(result: SwapResult, which: str) -> Table:
    columns = [Column("variant", left=True), Column("axis", left=True), Column("gain margin"), Column("phase margin")]
    margins = [(name, axis, of_axis) for name, variant in result.variants.items() for axis, of_axis in variant.margins.items()]
    rows: list[tuple[str, ...]] = [(name, axis, decibel(of_axis), degrees(of_axis)) for name, axis, of_axis in margins]
    return Table(columns, f"Exact margins of {which}", rows=rows)


def _networks(result: SwapResult, which: str) -> Table:
    heads = ("wired", "allowed", "as given", "longest period that holds")
    unit = result.study.variants.unit
    rows: list[tuple[str, ...]] = []
    for cost in result.networks:
        rows.append((cost.name, "", "", "", ""))
        for variant in cost.variants:
            values = [_number(value, unit, "diverges") for value in (variant.undivided, variant.allowed, variant.as_given)]
            rows.append((f"  {variant.variant}", *values, largest_held(variant.sweep)))
    return Table([Column("division, variant", left=True), *map(Column, heads)], f"J of {which} over a network [{unit}]", rows=rows)


def _linear(designs: LinearSwap) -> Table:
    title = f"Linear designs, axis {designs.axis}, {designs.case}: J/J* of each module"
    rows = [
        ("a [mm/s^2]", *(f"{model.gain:.4g}" for model in designs.models)),
        ("b [1/s]", *(f"{model.damping:.3g}" for model in designs.models)),
    ]
    ratios = {f"optimal for {module}": row for module, row in zip(designs.modules, designs.blind, strict=True)}
    ratios |= {f"{design.method}, {', '.join(design.local) or 'nothing'}": design.ratio for design in designs.designs}
    rows += [(name, *(f"{ratio:.4g}" for ratio in row)) for name, row in ratios.items()]
    return Table([Column("method, local", left=True), *map(Column, designs.modules)], title, rows=rows)


def _number(value: float, unit: str, missing: str = "breaks a guard") -> str:
    return figure(value, unit, 4).removesuffix(f" {unit}") if math.isfinite(value) else missing


def _percent(loss: float) -> str:
    return f"{100.0 * loss:.3g}" if loss < 1.0 else f"{100.0 * loss:.0f}" if math.isfinite(loss) else "-"


def write_results(study: SwapStudy, folder: Path, out: Path, plots: Sequence[str]) -> list[str]:
    """Write picture and controllers into a folder that will replace `out`; return lines that list the files."""
    from contourlab.rendering.plots import write_figures
    from contourlab.scenario.dump import dump

    variants, best, base = study.variants, study.recommended, study.base
    write_figures([("swap", lambda: drawing(matrices(study), study.settings.full))], folder / "plots", plots)
    lines = [f"picture: {out / 'plots' / f'swap.{name}'}" for name in plots]
    (folder / "controllers").mkdir()

    def write(name: str, i: int, point: Array, title: str, local: Collection[str] = ()) -> None:
        head, machine = f"{title}; J and the guards apply to the motion of the study.", variants.members[i].machine
        text = proposed(head, dump(variants.controller_at(point, local), machine))
        write_text_atomic(folder / "controllers" / f"{name}.toml", text)

    for i, (name, file) in enumerate(file_names(variants.names).items()):
        write(f"own-{file}", i, variants.best_points[i], f"Best of {name} alone")
        if best is not None:
            write(file, i, best.points[i], f"For {name}. `local` parameters move with the axis", best.local)
            lines.append(f"controller for {name}: {out / 'controllers' / f'{file}.toml'}")
    lines.append(f"the best controller of each variant alone: {out / 'controllers' / 'own-*.toml'}")
    if base.holds:
        write("shared", 0, base.points[0], f"Shared by {'; '.join(variants.names)}, nothing local")
        lines.append(f"the shared design, nothing local: {out / 'controllers' / 'shared.toml'}")
    return ["\n".join(lines)]


ROW_WIDTH = 44
"""Line width of row names [characters]."""


@dataclass(frozen=True, eq=False)
class LossMatrix:
    """Losses as coloured cells.

    Parameters
    ----------
    title : str
    rows, columns : tuple of str
    losses : ndarray (n_row, n_column)
        Not finite where a guard is broken.
    texts : tuple of tuple of str
    uncertain : ndarray (n_row, n_column) of bool
        Losses below the limit whose J* may be lower: hatched instead of coloured.
    """

    title: str
    rows: tuple[str, ...]
    columns: tuple[str, ...]
    losses: Array
    texts: tuple[tuple[str, ...], ...]
    uncertain: Flags


def matrices(study: SwapStudy) -> list[LossMatrix]:
    """Return the two matrices: the best choice of each size, and the designs of J* on each variant."""
    best: dict[int, Design] = {}
    for choice in sorted(study.choices, key=lambda choice: (len(choice.local), choice.swap_loss)):
        best.setdefault(len(choice.local), choice)
    rows = tuple("\n".join(wrap(choice.name if choice.local else "nothing local", ROW_WIDTH)) for choice in best.values())
    others = (*(f"best for {name}" for name in study.variants.names), "design of the scenario")
    return [
        _loss_matrix(study, "loss of each variant, by local parameters", rows, np.array([choice.values for choice in best.values()])),
        _loss_matrix(study, "best design of each variant, run on every variant", others, np.vstack([study.crossed, study.given.values])),
    ]


def _loss_matrix(study: SwapStudy, title: str, rows: tuple[str, ...], values: Array) -> LossMatrix:
    variants = study.variants
    losses = variants.losses(np.where(np.isfinite(values), values, np.nan))
    unsure = np.array([name in study.inconclusive for name in variants.names])

    def text(lost: float, value: float, at_least: bool) -> str:
        if not math.isfinite(lost):
            return "breaks a guard"
        return f"{'at least ' if at_least else ''}{figure(lost, '%')}  ({figure(value, variants.unit)})"

    texts = tuple(tuple(map(text, *row, unsure.tolist())) for row in zip(losses.tolist(), values.tolist(), strict=True))
    return LossMatrix(title, rows, variants.names, losses, texts, unsure & (losses < study.settings.full))


def drawing(matrices: Sequence[LossMatrix], limit: float) -> Any:
    """Draw matrices into one figure, one below the other; cells up to the limit of full modularity are green."""
    from contourlab.rendering.matplotlib_view import WIDTH, new_figure

    # In inches: row height from the lines of its name, column width from the text of a cell.
    heights = [0.75 + max(0.27, 0.14 * max(name.count("\n") + 1 for name in matrix.rows)) * len(matrix.rows) for matrix in matrices]
    names = 0.065 * max(len(line) for matrix in matrices for name in matrix.rows for line in name.split("\n"))
    cells = max(3.8, 1.6 * max(len(matrix.columns) for matrix in matrices))
    page = new_figure(0.9 + sum(heights), max(WIDTH, names + cells + 0.9))
    page.suptitle("Loss at a swap", fontsize=9.5, fontweight="bold")
    if any(matrix.uncertain.any() for matrix in matrices):
        page.supxlabel("hatched: inconclusive; J* may be lower, and then the loss is larger", fontsize=7.5, color=MUTED)
    places = page.subplots(len(matrices), 1, squeeze=False, height_ratios=heights)[:, 0]
    shown = [_draw(place, matrix, limit) for place, matrix in zip(places, matrices, strict=True)]
    bar = page.colorbar(shown[-1], ax=list(places), location="right", fraction=0.035, pad=0.02)
    bar.set_label(f"loss [%]; green up to {100.0 * limit:g} %", size=7.5)
    bar.outline.set_visible(False)
    bar.set_ticks([0.01, 0.03, 0.1, 0.3, 1.0], labels=["1", "3", "10", "30", "100"])
    bar.ax.minorticks_off()
    return page


def _draw(place: Axes, matrix: LossMatrix, limit: float) -> Any:
    from matplotlib.colors import LinearSegmentedColormap, LogNorm
    from matplotlib.patches import Rectangle

    low, high = limit / 6.0, 1.0
    at = np.log(limit / low) / np.log(high / low)
    # Blue-green up to the limit, then yellow to vermilion: distinct for colour-blind readers too.
    colours = [(0.0, "#8fd3bd"), (at, "#cdeee2"), (at, "#fdf3cf"), (0.5 + 0.5 * at, "#f4b266"), (1.0, "#d9663a")]
    scale = LinearSegmentedColormap.from_list("loss", colours).with_extremes(bad="#c9ced4")
    values = np.ma.masked_invalid(np.where(matrix.uncertain, np.nan, np.clip(matrix.losses, low, high)))
    shown = place.imshow(values, cmap=scale, norm=LogNorm(low, high), aspect="auto")
    place.set_title(matrix.title, loc="left", fontsize=8.5, color=INK)
    place.set_xticks(range(len(matrix.columns)), matrix.columns, fontsize=7.5)
    place.set_yticks(range(len(matrix.rows)), matrix.rows, fontsize=7.5)
    place.tick_params(length=0, colors=MUTED)
    place.grid(visible=False)
    place.spines[:].set_visible(False)
    place.set_xticks(np.arange(0.5, len(matrix.columns) - 1), minor=True)
    place.set_yticks(np.arange(0.5, len(matrix.rows) - 1), minor=True)
    place.grid(visible=True, which="minor", color="white", linewidth=2.0)
    place.tick_params(which="minor", length=0)
    style: dict[str, Any] = {"facecolor": "#f3f4f6", "edgecolor": "#d9dde2", "hatch": "///", "linewidth": 0.0, "zorder": 0.2}
    for i, j in zip(*np.nonzero(matrix.uncertain), strict=True):
        place.add_patch(Rectangle((j - 0.5, i - 0.5), 1.0, 1.0, **style))
    for (i, j), text in np.ndenumerate(np.array(matrix.texts)):
        place.text(j, i, text, ha="center", va="center", fontsize=7.5, color=INK)
    return shown
