"""The machines that come of exchanging axes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, product

from contourlab.errors import ParameterError
from contourlab.loop import Axis, Machine
from contourlab.loop.machine import AXIS_SLOTS


@dataclass(frozen=True)
class Variant:
    """A machine with some of its axes exchanged.

    Attributes
    ----------
    name : str
        What is in place of which axis, as ``"1 = axis2"``.
    machine : Machine
    modules : tuple of (str, str)
        For each axis that is swapped, what stands there.
    """

    name: str
    machine: Machine
    modules: tuple[tuple[str, str], ...] = ()

    def module(self, name: str) -> str:
        """Return what a number by its dotted name moves with: the module of its axis, or nothing where that is not swapped."""
        return next((called for axis, called in self.modules if name.startswith(f"controller.axes.{axis}.")), "")


def variants_of(machine: Machine, swaps: Mapping[str, Sequence[tuple[str, Axis]]]) -> tuple[Variant, ...]:
    """Return every combination of axes, the machine's own first.

    Parameters
    ----------
    machine : Machine
    swaps : mapping of str to sequence of (str, Axis)
        For each axis that is swapped the others that take its place, by what they are called.

    Raises
    ------
    ParameterError
        If the machine has no such axis, nothing but its like takes its place, two are alike or called the same, or one has a drive of
        another unit.
    """
    if not swaps:
        raise ParameterError("axis", "none", f"at least one axis to swap, of {', '.join(machine.axis_names)}")
    choices = [_choices(machine, name, others) for name, others in swaps.items()]
    found = []
    for picked in product(*choices):
        made = machine
        for name, _, module in picked:
            made = made if module is None else made.swapped(name, module)
        modules = tuple((name, called) for name, called, _ in picked)
        found.append(Variant(", ".join(f"{name} = {called}" for name, called in modules), made, modules))
    return tuple(found)


def _choices(machine: Machine, name: str, others: Sequence[tuple[str, Axis]]) -> list[tuple[str, str, Axis | None]]:
    """Return what may stand in the place of an axis: itself first, by the name of the file that has it, if one does."""
    if name not in machine.axis_names:
        raise ParameterError("axis", repr(name), f"one of {', '.join(machine.axis_names)}, the axes of {machine.name}")
    if not others:
        raise ParameterError("with", "nothing", f"at least one axis to take the place of {name}")
    own = machine.axis(name)
    same = next((called for called, other in others if _alike(own, other)), "as it is")
    kept = [(called, other) for called, other in others if not _alike(own, other)]
    _check_differ(name, others, kept)
    calls = [called for called, _ in kept]
    if len({same, *calls}) != len(calls) + 1:
        raise ParameterError("with", ", ".join([same, *calls]), "axes that differ in their names")
    for called, other in kept:
        _check_fits(own, other, called)
    return [(name, same, None), *((name, called, other) for called, other in kept)]


def _check_differ(name: str, others: Sequence[tuple[str, Axis]], kept: Sequence[tuple[str, Axis]]) -> None:
    """Refuse one module by two names, which would be searched twice, and a swap for nothing but what stands there already."""
    for (called, one), (again, other) in combinations(others, 2):
        if _alike(one, other):
            raise ParameterError(
                "with", f"{called}, {again}", f"axes that differ in a value, to take the place of {name}: these two do not"
            )
    if not kept:
        wanted = f"an axis that differs from axis {name} of the machine in a value: in place of its like nothing is lost"
        raise ParameterError("with", ", ".join(called for called, _ in others), wanted)


def _alike(one: Axis, other: Axis) -> bool:
    """Tell whether two axes are the same module."""
    slots = (*AXIS_SLOTS, "substeps", "stage_mass", "limits")
    return all(getattr(one, slot) == getattr(other, slot) for slot in slots)


def _check_fits(own: Axis, other: Axis, called: str) -> None:
    units, wanted = (other.plant.command_unit, other.plant.force_unit), (own.plant.command_unit, own.plant.force_unit)
    if units[0] != wanted[0]:
        raise ParameterError(
            "with", called, f"an axis whose drive takes its command in {wanted[0]}, as that of {own.name} does: this one takes {units[0]}"
        )
    if other.plant.two_sided != own.plant.two_sided:
        shown = "one with a motor and a load side" if own.plant.two_sided else "one without a motor side of its own"
        raise ParameterError("with", called, f"{shown}, as {own.name} is")
