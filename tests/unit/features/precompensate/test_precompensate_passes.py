"""When passes stop."""

import pytest

from contourlab.features.precompensate.passes import Passes, PassFigures


def figures(number: int, rms: float, in_time: bool) -> PassFigures:
    return PassFigures(number, rms, rms, 1.0, (), (), in_time)


@pytest.mark.parametrize(
    ("rms", "in_time", "helps", "best"),
    [
        ((9, 5, 4), "yyy", True, 2),
        ((9, 5, 4.99), "yyy", True, 2),
        ((99, 5, 4.99), "yyy", False, 2),
        ((9, 5, 4, 5.2), "yyyy", True, 2),
        ((9, 5, 4, 5.2, 4.1), "yyyyy", False, 2),
        ((9, 5, 4), "ynn", True, 0),
        ((9, 5, 4, 3), "ynnn", False, 0),
        ((9, 5, 4, 3, 3.5), "ynnyn", True, 3),
    ],
)
def test_passes_stop_when_they_no_longer_help(rms: tuple[float, ...], in_time: str, helps: bool, best: int) -> None:
    passes = Passes("", figures=tuple(figures(k, one, sign == "y") for k, (one, sign) in enumerate(zip(rms, in_time, strict=True))))
    assert passes.helps == helps
    assert passes.best == best
