"""Many small cases in one test: each that fails is named, and none hides another."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from typing import Any

Test = Callable[..., None]


def listing(*values: Any) -> str:
    """Return the values of a case as a list."""
    return ", ".join(map(repr, values))


def each(names: str, cases: Iterable[Any], title: Callable[..., str] = listing) -> Callable[[Test], Test]:
    """Run a test for every case, as ``pytest.mark.parametrize`` would, but as one test.

    For cases of a few milliseconds, which take longer to collect and report than to run. They share the test's fixtures.

    Parameters
    ----------
    names : str
        Parameters of the test that take the values of a case, as for ``parametrize``.
    cases : iterable
    title : callable
        Returns the name of a case from its values.

    Raises
    ------
    ExceptionGroup
        From the test, if cases failed: one exception for each, with its name.
    """
    words = [word.strip() for word in names.split(",")]
    listed = [case if len(words) > 1 else (case,) for case in cases]
    assert listed, "a test without cases cannot fail"

    def decorate(test: Test) -> Test:
        def run(**fixtures: Any) -> None:
            failures = []
            for values in listed:
                try:
                    test(**dict(zip(words, values, strict=True)), **fixtures)
                except Exception as failure:
                    failure.add_note(f"in the case {title(*values)}")
                    failures.append(failure)
            if failures:
                raise ExceptionGroup(f"{len(failures)} of {len(listed)} cases", failures)

        run.__dict__.update(vars(test))  # the marks
        run.__name__, run.__qualname__, run.__module__, run.__doc__ = test.__name__, test.__qualname__, test.__module__, test.__doc__
        signature = inspect.signature(test)
        run.__signature__ = signature.replace(  # type: ignore[attr-defined]
            parameters=[parameter for name, parameter in signature.parameters.items() if name not in words]
        )
        return run

    return decorate
