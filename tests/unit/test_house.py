"""House rules that can be checked automatically."""

import ast
import importlib.metadata
import importlib.util
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest
from each import each

import contourlab
from contourlab import errors
from contourlab.extras import EXTRAS, extra_module

ROOT = Path(__file__).parents[2]
SOURCE = ROOT / "src" / "contourlab"
MODULES = sorted(SOURCE.rglob("*.py"))
TEXT = {".py", ".md", ".toml", ".ngc", ".txt", ".cff", ".cfg", ".ini", ".j2", ".js", ".css", ".c", ".yml", ".yaml", ".json", ""}
CACHES = {".hypothesis", ".mypy_cache", ".ruff_cache", ".pytest_cache", ".import_linter_cache", "__pycache__"}
GENERATED = CACHES | {".git", ".venv", "build", "dist", "out", "results"}
HEAVY = ("numba", "llvmlite", "numpy", "scipy", "matplotlib", "pandas", "xarray", "pint", "pydantic", "control", "h5py", "jinja2")


def fresh_python(code: str) -> str:
    """Run code in a separate process and return what it prints."""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60)
    return done.stdout


def modules_after(code: str) -> set[str]:
    """Return the top-level modules loaded after some code."""
    tail = "import sys; print('\\nloaded', *sorted({name.partition('.')[0] for name in sys.modules}))"
    return set(fresh_python(f"{code}\n{tail}").splitlines()[-1].split())


def project_files() -> list[Path]:
    found = (path for path in ROOT.rglob("*") if not GENERATED & set(path.relative_to(ROOT).parts))
    return [path for path in found if path.is_file() and path.suffix in TEXT and ".egg-info" not in str(path)]


@each("path", MODULES)
def test_a_module_defines_a_constant_once(path: Path):
    text = path.read_text(encoding="utf-8")
    begun = [name for line in re.findall(r"^\w[\w, =]*=", text, re.MULTILINE) for name in re.findall(r"\w+", line)]
    if len(set(begun)) == len(begun):  # to parse every module takes a second
        return
    body = ast.parse(text).body
    targets = [target for line in body if isinstance(line, ast.Assign) for target in line.targets]
    names = [target.id for target in targets if isinstance(target, ast.Name) and target.id != "_"]
    assert sorted(names) == sorted(set(names))


def test_no_two_test_files_share_a_name():
    """Pytest would refuse to collect the second one."""
    names = [path.name for path in (ROOT / "tests").rglob("test_*.py")]
    assert sorted(set(names)) == sorted(names)


def test_the_version_is_the_same_everywhere():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
    citation = re.search(r"^version: (.+)$", (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)
    newest = re.search(r"^## \[(\d\S*)\]", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    assert citation is not None
    assert newest is not None
    assert {contourlab.__version__, importlib.metadata.version("contourlab"), citation[1], newest[1]} == {project}


@pytest.mark.slow
def test_no_file_mentions_the_machine_it_was_written_on():
    # Assembled here, so that this file does not match.
    folders = "|".join(("home", "work", "root", "Users", "tmp"))
    private = re.compile(rf"(?<![\w.:/~$}}-])/(?:{folders})/\w|[A-Z]:\\Users\\")
    allowed = {ROOT / ".ci" / "run"}
    faults = []
    for path in project_files():
        if path not in allowed:
            lines = enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), start=1)
            faults += [f"{path.relative_to(ROOT)}:{n}: {line.strip()[:120]}" for n, line in lines if private.search(line)]
    assert not faults, "\n".join(faults)


def test_every_dependency_is_pinned():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    lines = (ROOT / "constraints.txt").read_text(encoding="utf-8").splitlines()
    pins = [re.match(r"([\w.-]+)==[\w.!+]+", line) for line in lines if line.strip() and not line.startswith("#")]
    assert all(pins), "every line is NAME==VERSION"
    pinned = {re.sub(r"[-_.]+", "-", pin[1]).lower() for pin in pins if pin}
    wanted = [*project["dependencies"], *(one for extra in project["optional-dependencies"].values() for one in extra)]
    names = {re.sub(r"[-_.]+", "-", re.split(r"[^\w.-]", requirement)[0]).lower() for requirement in wanted}
    assert names - {"contourlab"} <= pinned
    # The hooks before a commit use the same ruff.
    hooks = (ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8")
    assert re.findall(r"ruff==[\d.]+", hooks) == [line for line in lines if line.startswith("ruff==")]


@pytest.mark.parametrize("module", EXTRAS)
def test_a_missing_extra_is_named(module: str, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(sys.modules, module, None)
    with pytest.raises(errors.MissingPackageError) as caught:
        extra_module(module)
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    assert any(caught.value.package in requirement for requirement in extras[caught.value.extra])


def test_help_loads_nothing_heavy():
    loaded = modules_after("from contourlab.cli.main import main\nassert main(['--help']) == 0")
    assert {"typer", "contourlab"} <= loaded
    assert not loaded & set(HEAVY)


@pytest.mark.slow
def test_a_second_run_loads_no_compiler_and_no_optimiser(tmp_path: Path):
    """The first one compiles; the rest of what is heavy computes, writes signals and the report."""
    (tmp_path / "part.ngc").write_text("G21 G64 P0.01\nG1 X5 F3000\nX9 Y3 Z1\nX12 Y9\nM2\n", encoding="utf-8")
    words = ["run", str(tmp_path / "part.ngc"), "--machine", "builtin:xyz", "--controller", "builtin:xyz-controller"]
    code = f"from contourlab.cli.main import main\nassert main({[*words, '--out', str(tmp_path / 'out')]!r}) == 0"
    modules_after(code)
    assert modules_after(code) & set(HEAVY) <= {"llvmlite", "numpy", "h5py", "jinja2", "pydantic"}  # Typer takes pydantic if it is there


def test_importing_contourlab_loads_nothing_heavy():
    assert not modules_after("import contourlab") & {*HEAVY, "typer", "rich"}


def test_every_public_name_is_found():
    assert len(set(contourlab.__all__)) == len(contourlab.__all__)
    # Importing a sub-package replaces a name of the same spelling.
    assert not set(contourlab.__all__) & {path.name.removesuffix(".py") for path in SOURCE.iterdir()}
    assert set(contourlab.__all__) <= set(dir(contourlab))
    with pytest.raises(AttributeError, match="no_such_name"):
        contourlab.no_such_name  # noqa: B018


def test_the_documented_exception_tree_is_complete():
    assert errors.__doc__ is not None
    for name in errors.__all__:
        kind = getattr(errors, name)
        assert issubclass(kind, errors.ContourlabError)
        assert name in errors.__doc__
        assert kind.exit_code == (3 if kind is errors.DivergenceError else 2)


@pytest.mark.slow
def test_the_component_of_the_contributing_guide_keeps_the_contract(tmp_path: Path):
    guide = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    block = next(found for found in re.findall(r"```python\n(.*?)```", guide, re.DOTALL) if "(Component)" in found)
    file = tmp_path / "drag.py"
    file.write_text(block, encoding="utf-8")
    # In a separate process: a loaded plug-in stays registered.
    code = f"""
import contourlab as cl
kinds = cl.load_plugin({str(file)!r})
for kind in kinds:
    cl.check_component(kind)
print(*(f"{{kind.family}}/{{kind.kind}}" for kind in kinds))
"""
    assert fresh_python(code).split() == ["friction/drag"]
