"""The step of a component in another language: C99 for a control, or assembly; the loop of a case as WebAssembly."""

from __future__ import annotations

from typing import overload

from contourlab.components.contract import Component
from contourlab.engine.step import Step
from contourlab.engine.translate import c99, llvm_ir, maths
from contourlab.engine.translate.step_graph import graph_of
from contourlab.errors import ParameterError, refuse
from contourlab.loop.portable import portable
from contourlab.scenario.values import Case

_PROCESSORS = {
    "aarch64": ("aarch64-unknown-linux-gnu", "generic"),
    "cortex-m7": ("thumbv7em-none-eabihf", "cortex-m7"),
    "wasm32": ("wasm32-unknown-unknown", "generic"),
    "ptx": ("nvptx64-nvidia-cuda", "sm_70"),
}
"""Triple and processor of LLVM for each name."""
LANGUAGES = ("c99", "llvm", *_PROCESSORS)


@overload
def translate(component: Component, to: str = "c99", *, n_axis: int = 1, friction: Component | None = None) -> str: ...
@overload
def translate(component: Case, to: str) -> bytes: ...
def translate(component: Component | Case, to: str = "c99", *, n_axis: int = 1, friction: Component | None = None) -> str | bytes:
    """Return the step of a component as source text, or the loop of a case as a WebAssembly module.

    Parameters
    ----------
    component : Component or Case
    to : str
        A case takes ``"wasm"`` alone; `contourlab.loop.portable` says what lies where in the module's memory. For a component,
        ``"c99"`` (one function that allocates nothing and needs `<math.h>` alone), ``"llvm"`` (LLVM IR), or the assembly of a processor:
        ``"aarch64"``, ``"cortex-m7"``, ``"wasm32"`` or ``"ptx"``. It calls no mathematical library, except that wasm32 imports `fma`.
    n_axis : int, >= 1
        Axes of an estimator or a coupling.
    friction : Component, optional
        Friction of a plant; none by default.

    Returns
    -------
    str or bytes
        C99 compiled without contraction (``-ffp-contract=off``) computes what plain Python computes, bit for bit. Parameters, states,
        inputs and tables are arguments: a comment in the C source lists them.

    Raises
    ------
    ParameterError
        If `to` is none of these, a friction is to be translated without its plant, or a case learns or changes its controller.
    EngineError
        If the step uses what cannot be translated; names file and line.

    Examples
    --------
    >>> from contourlab.components.registry import component
    >>> print(translate(component("velocity", "true")()).splitlines()[-2].strip())
    out[0] = v0;
    """
    refuse(not isinstance(component, Component | Case), ParameterError, "component", type(component).__name__, "a component or a case")
    allowed = ("wasm",) if isinstance(component, Case) else LANGUAGES
    refuse(to not in allowed, ParameterError, "to", repr(to), "one of " + ", ".join(allowed))
    if isinstance(component, Case):
        refuse(n_axis != 1 or friction is not None, ParameterError, "case", "with n_axis or friction", "without: it has its own")
        varies = bool(component.changes or component.learning)
        refuse(varies, ParameterError, "case", "one that learns or changes its controller", "one with the same controller throughout")
        parts = component.machine, component.controller, component.reference()
        return portable(*parts, seed=component.run.seed, moving=component.moving).code
    step = _step_of(component, n_axis, friction)
    if to == "c99":
        return c99.source_of(graph_of(step))
    if to == "llvm":
        return llvm_ir.source_of(graph_of(step))
    return str(llvm_ir.assembly(llvm_ir.source_of(graph_of(step, contract=True, primitives=maths.LANES)), *_PROCESSORS[to]))


def _step_of(component: Component, n_axis: int, friction: Component | None) -> Step:
    """Return the step; a plant gets its friction, an estimator a path with a table."""
    if component.family == "friction":
        raise ParameterError("component", f"friction {component.kind}", "a plant, with the friction as the argument `friction`")
    if component.family == "plant":
        from contourlab.components.friction.laws import NoFriction
        from contourlab.components.mechanics.core import link

        return link(component, friction or NoFriction())
    if component.family == "estimator":
        from contourlab.geometry import Line, Path
        from contourlab.geometry.view import view_of

        view = view_of(Path([Line((0.0,) * n_axis, (1.0,) * n_axis)]))
        return component.path_step(view, n_axis)  # type: ignore[attr-defined,no-any-return]
    return component.make_step(n_axis)
