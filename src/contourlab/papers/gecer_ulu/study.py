"""Parts of Gecer Ulu, Ulu & Cakmakci, "Design and analysis of a modular learning based cross-coupled control algorithm for multi-axis
precision positioning systems"."""

from __future__ import annotations

from contourlab.papers.gecer_ulu.axis import axis_rows
from contourlab.papers.gecer_ulu.convergence import convergence_rows
from contourlab.papers.gecer_ulu.learning import learning_rows
from contourlab.papers.gecer_ulu.tables import table_rows
from contourlab.papers.rows import Part

PARTS: tuple[Part, ...] = (
    ("Tables 2 and 3", table_rows),
    ("one axis", axis_rows),
    ("convergence over trials, Figs 9 and 10", convergence_rows),
    ("learning and coupling", learning_rows),
)
