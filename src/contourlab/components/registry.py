"""Find components: in this package, in the entry-point group ``contourlab.components``, and in loose files.

A module that cannot be imported is an error and is never skipped: a missing part would give a wrong machine.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import importlib.util
import pkgutil
import sys
import traceback
from functools import cache
from importlib.abc import Loader
from importlib.machinery import SourceFileLoader
from pathlib import Path
from types import CodeType, ModuleType
from typing import Any

from contourlab.components.contract import FAMILIES, Component, fault, file_of_class
from contourlab.components.declaration import check_class
from contourlab.engine.translate.outer import TYPED
from contourlab.errors import ComponentError, ContourlabError, error_text, hint

ENTRY_POINT_GROUP = "contourlab.components"
OTHER_NAMES = {
    **dict.fromkeys(("p-pi", "ppi", "pi", "servo", "p-pi-cascade", "cascaded"), "cascade"),
    **dict.fromkeys(("ccc", "cross-coupling", "crosscoupled"), "cross-coupled"),
    **dict.fromkeys(("dob", "dobs", "observer"), "disturbance-observer"),
    **dict.fromkeys(("ism", "integral-sliding-mode", "sliding-mode", "smc"), "integral-sliding"),
    **dict.fromkeys(("sta", "stw", "supertwisting"), "super-twisting"),
    **dict.fromkeys(("stribeck", "dry", "stick-slip"), "coulomb"),
    **dict.fromkeys(("mass", "linear-axis", "rigid"), "mass-damper"),
    **dict.fromkeys(("ballscrew", "screw", "leadscrew", "lead-screw"), "ball-screw"),
    **dict.fromkeys(("two-mass-model", "resonant", "elastic", "flexible"), "two-mass"),
    **dict.fromkeys(("ilc", "zero-phase-ilc"), "zero-phase"),
    **dict.fromkeys(("linear-scale", "grating", "resolver", "glass-scale"), "encoder"),
    **dict.fromkeys(("stepper-motor", "step-motor"), "stepper"),
    **dict.fromkeys(("stepgen", "step-gen"), "step-generator"),
    **dict.fromkeys(("derivative", "dirty-derivative", "difference"), "filtered-difference"),
    **dict.fromkeys(("ff", "feedforward", "model-inverse"), "inverse-dynamics"),
}
"""Other words for components -> their kinds."""
_plugins: dict[tuple[str, str], type[Component]] = {}


def _own(module: ModuleType) -> list[type[Component]]:
    return [v for v in vars(module).values() if isinstance(v, type) and issubclass(v, Component) and v.__module__ == module.__name__]


def _declared(module: ModuleType) -> list[type[Component]]:
    """Return the components that a module itself defines."""
    return [kind for kind in _own(module) if kind.kind]


@cache
def _built_in() -> dict[tuple[str, str], type[Component]]:
    import contourlab.components as package

    found: dict[tuple[str, str], type[Component]] = {}
    for info in pkgutil.walk_packages(package.__path__, package.__name__ + "."):
        for kind in _declared(importlib.import_module(info.name)):
            _add(found, kind, info.name)
    for entry in importlib.metadata.entry_points(group=ENTRY_POINT_GROUP):
        try:
            loaded = entry.load()
        except Exception as error:  # a package may raise anything on import
            raise ComponentError(f"entry point {entry.name} = {entry.value} cannot be loaded: {error_text(error)}") from error
        kinds = _declared(loaded) if isinstance(loaded, ModuleType) else [loaded]
        if not kinds:
            raise ComponentError(f"entry point {entry.name}: defines no component: write a subclass of Component with family and kind")
        for kind in kinds:
            _add(found, kind, f"entry point {entry.name}")
            check_class(kind)
    return found


def _add(found: dict[tuple[str, str], type[Component]], kind: type[Component], where: str = "") -> None:
    if not (isinstance(kind, type) and issubclass(kind, Component) and kind.kind):
        raise ComponentError(f"{where}: {kind!r} is not a component: write a class with family and kind")
    key = (kind.family, kind.kind)
    if key in found and found[key] is not kind:
        other = found[key]
        home = other.__module__ if other.__module__.startswith("contourlab.") else file_of_class(other)
        error = fault(kind, f"{kind.family} {kind.kind!r} already exists, {other.__name__} in {home}: choose another kind")
        raise ComponentError(f"{where}: {error}") if where else error
    found[key] = kind


def _imported(module: ModuleType, loader: Loader) -> list[type[Component]]:
    """Run the code of a plug-in; return its components, which can run."""
    file = getattr(module, TYPED)
    try:
        loader.exec_module(module)
    except KeyboardInterrupt:
        raise
    except BaseException as error:  # a plug-in may raise anything
        raise ComponentError(_import_fault(file, error)) from error
    own = _own(module)
    for kind in own:
        if not kind.kind and not any(kind in other.__mro__[1:] for other in own):
            raise fault(kind, 'has no kind: write kind = "my-name", its name in files')
    if not (kinds := _declared(module)):
        raise ComponentError(f"{file}: defines no component: write a subclass of Component with family and kind")
    for kind in kinds:
        check_class(kind)
    return kinds


def _import_fault(file: str, error: BaseException) -> str:
    """Return the message about a file that cannot be imported, with the line and the class where there is one."""
    if isinstance(error, SyntaxError):
        cure = ": save the file as UTF-8" if "codec" in str(error.msg) or "null bytes" in str(error.msg) else ""
        return f"{file}{f':{error.lineno}' if error.lineno else ''}: cannot be read as Python: {type(error).__name__}: {error.msg}{cure}"
    frames = [(frame, line) for frame, line in traceback.walk_tb(error.__traceback__) if frame.f_globals.get(TYPED) == file]
    # In the body of a class the code has the name of the class.
    classes = [frame.f_code.co_name for frame, _ in frames if "__qualname__" in frame.f_locals]
    place = ": ".join([f"{file}:{frames[-1][1]}" if frames else file, *classes[-1:]])
    return f"{place}: {error}" if isinstance(error, ContourlabError) else f"{place}: cannot be imported: {error_text(error)}"


class _FreshLoader(SourceFileLoader):
    """Compiles a file anew: Python's byte code is that of an older text if a file of the same size was written within the same second."""

    def get_code(self, fullname: str) -> CodeType:
        """Return the code of the file."""
        return self.source_to_code(self.get_data(self.path), self.path)


def load_plugin(file: str | Path) -> list[type[Component]]:
    """Load and return the components of a loose Python file. Loading a file again replaces its components.

    Parameters
    ----------
    file : str or Path
        A Python file that defines components.

    Returns
    -------
    list of subclasses of Component
        The components of the file, now known by family and kind.

    Raises
    ------
    ComponentError
        If the file cannot be imported, defines no component or one without the ports and methods of its family
        (`docs/reference/ports.md`), or uses a name that is taken; then nothing is registered. The message names file, line and class.
    """
    path = Path(file).resolve()
    name = str(path).replace(".", "_")  # shows the file; pickle takes what stands before a dot for a package
    loader = _FreshLoader(name, str(path))
    spec = importlib.util.spec_from_file_location(name, path, loader=loader)
    if spec is None or path.suffix != ".py" or not path.is_file():
        raise ComponentError(f"{file}: not a Python file: name one that defines components")
    module = importlib.util.module_from_spec(spec)
    setattr(module, TYPED, str(file))
    before = sys.modules.get(name)
    sys.modules[name] = module
    try:
        kinds = _imported(module, loader)
    except BaseException:
        # The components of an earlier version stay.
        sys.modules.pop(name) if before is None else sys.modules.update({name: before})
        raise
    known = {**_built_in(), **{key: kind for key, kind in _plugins.items() if kind.__module__ != name}}
    for kind in kinds:
        _add(known, kind)
    for key in [key for key, kind in _plugins.items() if kind.__module__ == name]:
        del _plugins[key]
    _plugins.update({(kind.family, kind.kind): kind for kind in kinds})
    return kinds


def components(family: str | None = None) -> list[type[Component]]:
    """Return all components, or those of one family, in the order of `FAMILIES` and by name.

    Raises
    ------
    ComponentError
        If there is no such family.
    """
    if family is not None and family not in FAMILIES:
        raise ComponentError(f"no family {family!r}; the families are: {', '.join(FAMILIES)}")
    chosen = [kind for (slot, _), kind in {**_built_in(), **_plugins}.items() if family in (None, slot)]
    return sorted(chosen, key=lambda kind: (FAMILIES.index(kind.family), kind.kind))


def component(family: str, kind: str) -> type[Any]:
    """Return one component by family and kind.

    Parameters
    ----------
    family : str
        Such as ``"plant"``; ``contourlab components`` lists all.
    kind : str
        Its name in files.

    Returns
    -------
    subclass of Component

    Raises
    ------
    ComponentError
        If there is none; the message suggests the nearest kind, or lists all.

    >>> component("plant", "rigid-axis").kind
    'rigid-axis'
    """
    if (found := _plugins.get((family, kind)) or _built_in().get((family, kind))) is None:
        meant = hint(kind, [known.kind for known in components(family)], OTHER_NAMES)
        raise ComponentError(f"no {family} {kind!r}: {meant}" + ("" if meant.endswith("?") else ", or give its file with --plugin"))
    return found
