"""Signature of each cause in the radial deviation of a circle: the columns of the fit.

With the angle phi from the first axis, s = 1 counter-clockwise and -1 clockwise, nominal radius R and feed v, an error (e_x, e_y) of the
axes shows as the radial deviation e_x cos phi + e_y sin phi, to first order. x reverses at phi = 0 and pi, y at pi/2 and 3 pi/2.

=======================  ====================================  ======================================================
cause                    error of the axes                     radial deviation
=======================  ====================================  ======================================================
radius, centre           r; (a, b)                             r + a cos phi + b sin phi
scaling mismatch c       e_x = c x/2, e_y = -c y/2             (c R/2) cos 2 phi
squareness q             e_x = q y                             (q R/2) sin 2 phi
servo mismatch T         e_x = -T_x v_x, e_y = -T_y v_y        s (T_x - T_y) (v/2) sin 2 phi
backlash b of x          e_x = -sgn(v_x) b/2                   s sgn(sin phi) cos phi b/2
backlash b of y          e_y = -sgn(v_y) b/2                   -s sgn(cos phi) sin phi b/2
lateral play l of x      e_y = -sgn(v_x) l/2                   s |sin phi| l/2
lateral play l of y      e_x = -sgn(v_y) l/2                   -s |cos phi| l/2
reversal spikes of x     a pulse after each reversal of x       the mean of what the others leave there
cyclic error of x        e_x = A cos(2 pi x/p + a)             A cos phi cos(2 pi R cos phi/p + a)
vibration of x           e_x = A cos(k u + a)                  A cos phi cos(k u + a), u the angle travelled
=======================  ====================================  ======================================================

Backlash may differ at both ends of an axis: b + d cos phi adds one column. At a reversal its step may take the time in which the motor
crosses the play (`contourlab.metrics.circle_backlash.crossing`): that is no spike. Cyclic error follows the position and is the same in
both senses; vibration follows time and is not. Only runs in both senses separate squareness from servo mismatch.

References
----------
ISO 230-4; Kakino, Ihara & Shinohara, "Accuracy inspection of NC machine tools by double ball bar method", Hanser, 1993. Names as in
Renishaw's ball-bar software.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from contourlab.arrays import Array
from contourlab.features.circle.runs import CircleRun

BEFORE, AFTER = math.radians(2.0), math.radians(15.0)
"""The fit leaves out samples from `BEFORE` a reversal to `AFTER` it, where the spike is."""


@dataclass(frozen=True)
class Term:
    """A cause in the fit and its columns.

    Attributes
    ----------
    cause : str
        As "backlash".
    axis : str
        Empty for a cause of both axes.
    columns : int
        Number of columns.
    length : float [m]
        Pitch of a cyclic error.
    order : float
        Cycles per turn of a vibration.
    """

    cause: str
    axis: str
    columns: int = 1
    length: float = math.nan
    order: float = math.nan


def usual_terms(axes: tuple[str, str], both: bool) -> list[Term]:
    """Return the terms of every fit; for runs in one sense squareness and servo mismatch share a column."""
    diagonal = [Term("squareness", ""), Term("servo mismatch", "")] if both else [Term("squareness or servo mismatch", "")]
    sides = [Term(cause, axis, n) for cause, n in (("backlash", 2), ("lateral play", 1)) for axis in axes]
    return [Term("radius", ""), Term("centre", "", 2), Term("scaling mismatch", ""), *diagonal, *sides]


def columns_of(term: Term, run: CircleRun, k: int, n: int, axes: tuple[str, str]) -> Array:
    """Return the columns (n_sample, term.columns) of a term in run `k` of `n`, for unit coefficients in m."""
    c, s, sense = np.cos(run.turned), np.sin(run.turned), run.sense
    first = term.axis == axes[0]
    if term.cause == "radius":
        return np.ones((len(c), 1))
    if term.cause == "centre":
        return np.column_stack([c, s])
    if term.cause == "backlash":
        half = 0.5 * sense * (np.sign(s) * c if first else -np.sign(c) * s)
        return np.column_stack([half, half * (c if first else s)])
    if term.cause == "cyclic error":
        along, wave = (c if first else s), 2.0 * math.pi * run.radius / term.length
        return np.column_stack([along * np.cos(wave * along), along * np.sin(wave * along)])
    if term.cause == "vibration":
        columns = np.zeros((len(c), 4 * n))
        phase = term.order * run.turned
        columns[:, 4 * k : 4 * k + 4] = np.column_stack([a * b for a in (c, s) for b in (np.cos(phase), np.sin(phase))])
        return columns
    one = {
        "scaling mismatch": 0.5 * (c * c - s * s),
        "squareness": s * c,
        "squareness or servo mismatch": s * c,
        "servo mismatch": sense * s * c,
        "lateral play": 0.5 * sense * (np.abs(s) if first else -np.abs(c)),
    }
    return np.asarray(one[term.cause][:, None])
