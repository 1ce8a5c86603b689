"""What an axis file does not take of friction that differs by direction, in words."""

from __future__ import annotations

from collections.abc import Mapping


def on_ways(x: Mapping[str, float], units: Mapping[str, str]) -> list[str]:
    """Return what is to be said of parameters by direction that an axis file has the mean of; nothing where there are none.

    Parameters
    ----------
    x : mapping
        Of names such as ``"Fv+"`` and ``"Fv-"``, each the friction against the motion that way.
    units : mapping
        By name without its sign.

    >>> on_ways({"Fc+": 21.0, "Fc-": 23.0}, {"Fc": "N"})[0].partition(": ")[2].partition(";")[0]
    'it is given the mean, Fc 22 N of 21 forwards and 23 backwards, 9.1 % apart'
    """
    names = [name.removesuffix("+") for name in x if name.endswith("+")]
    if not names:
        return []
    told = []
    for name in names:
        ahead, back = x[f"{name}+"], x[f"{name}-"]
        mean = 0.5 * (ahead + back)
        apart = f", {100.0 * abs(ahead - back) / abs(mean):.2g} % apart" if mean else ""
        told.append(f"{name} {mean:.4g} {units[name]} of {ahead:.4g} forwards and {back:.4g} backwards{apart}")
    halved = "half the difference of Fc is its constant force"
    return [f"an axis file has one friction for both directions: it is given the mean, {', '.join(told)}; {halved}"]
