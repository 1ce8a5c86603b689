"""Units as people and data sheets write them."""

import math
import random
from typing import Any

import pytest
from each import each

from contourlab.errors import UnitError
from contourlab.scenario.quantities import read_number
from contourlab.units import _COMMON, _common, registry, si_unit, to_si

WRITTEN = [
    ("1.27 Nm", "N*m", 1.27),
    ("1.27Nm", "N*m", 1.27),
    ("1.27 N·m", "N*m", 1.27),
    ("1.27 N⋅m", "N*m", 1.27),
    ("127 Ncm", "N*m", 1.27),
    ("1270 mNm", "N*m", 1.27),
    ("1270 Nmm", "N*m", 1.27),
    ("1.27 N m", "N*m", 1.27),
    ("0.47 Nm/A", "N*m/A", 0.47),
    ("0.47 Nm/Arms", "N*m/A", None),
    ("0.3 kg cm²", "kg*m^2", 3e-5),
    ("0.3 kgcm²", "kg*m^2", 3e-5),
    ("0.3 kg·cm^2", "kg*m^2", 3e-5),
    ("300 gcm²", "kg*m^2", 3e-5),
    ("3e-5 kgm²", "kg*m^2", 3e-5),
    ("3000 rpm", "rad/s", 100.0 * math.pi),
    ("1.8 (m/min)/mm", "1/s", 30.0),
    ("1.8(m/min)/mm", "1/s", 30.0),
    ("1.8 m/min/mm", "1/s", 30.0),
    ("30 1/s", "1/s", 30.0),
    ("30 s⁻¹", "1/s", 30.0),
    ("3 m/s²", "m/s^2", 3.0),
    ("3 m s⁻²", "m/s^2", 3.0),
    ("40 m/s³", "m/s^3", 40.0),
    ("1.6 µm", "m", 1.6e-6),
    ("1.6μm", "m", 1.6e-6),
    ("90 °", "rad", math.pi / 2.0),
    ("90°", "rad", math.pi / 2.0),
    ("18 Vs/m", "V*s/m", 18.0),
    ("190 Ns/m", "N*s/m", 190.0),
    ("0.2 Nms/rad", "N*m*s/rad", 0.2),
    ("2.5 Ω", "ohm", 2.5),
    ("4 full_scale/mm", "full_scale/m", 4000.0),
    ("25 nm", "m", 25e-9),
    ("5 nm", "N*m", None),
    ("3 Nm", "m", None),
    ("40 kg", "m", None),
    ("20 furlongz", "m", None),
    ("20 mm", "", None),
    ("20", "m", None),
    ("2,5 mm", "m", None),
    ("3000 rpm", "Hz", None),
    ("45 °C", "rad", None),
]
"""Text, unit wanted, value in SI; None where the text is refused."""


@each("text, unit, si", WRITTEN)
def test_units_as_people_write_them(text, unit, si):
    if si is not None:
        assert read_number(text, unit) == pytest.approx(si, rel=1e-12)
        assert to_si(text, unit) == pytest.approx(si, rel=1e-12)
        return
    with pytest.raises(UnitError) as refused:
        read_number(text, unit)
    assert text.split()[-1] in str(refused.value)
    assert "\n" not in str(refused.value)


def test_the_si_unit_of_a_joined_unit_has_its_usual_name():
    assert [si_unit(unit) for unit in ("Nm", "mNm", "µm", "m/s²")] == ["N*m", "N*m", "m", "m/s^2"]


def by_pint(unit: str) -> tuple[Any, float]:
    one = registry().Quantity(1.0, registry().parse_units(unit)).to_base_units()
    return frozenset(one.dimensionality.items()), float(one.magnitude)


def test_common_units_are_those_of_pint_to_the_bit() -> None:
    products = ["mm/min", "m/s^2", "N*m", "kg*cm^2", "um/m", "1/s", "mN*m/A", "full_scale*s/mm", "N*m*s/rad", "mm/s/V"]
    for unit in [*_COMMON, *products]:
        assert _common(unit) == by_pint(unit), unit


def test_products_of_common_units_are_those_of_pint() -> None:
    draw, count = random.Random(1), 0
    for _ in range(200):
        unit = draw.choice(list(_COMMON))
        for _ in range(draw.randrange(1, 4)):
            a, b = draw.choices(list(_COMMON), k=2)
            unit += draw.choice("*/") + draw.choice([a, f"{b}^{draw.choice([-3, -2, -1, 2, 3])}"])
        found = _common(unit)
        if found is None:  # very large or very small
            continue
        dimension, size = by_pint(unit)
        assert found[0] == dimension and found[1] == pytest.approx(size, rel=1e-14), unit
        count += 1
    assert count > 180


@each(
    "text",
    [
        "m m",
        "2*m",
        "/s",
        "*m",
        "m*",
        "m//s",
        "m^2^2",
        "m/(min*mm)",
        "11",
        "1m",
        "m\n",
        "m^0",
        "m^0.5",
        "(m",
        "m)",
        "()",
        "m^",
        "^2",
        "mm^200",
        "(mm^9)^9",
        "m^99999999999",
        "*m" * 5000,
        "furlong",
        "-",
    ],
)
def test_pint_reads_everything_else(text: str) -> None:
    assert _common(text) is None
