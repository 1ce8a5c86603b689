"""Build the source archive and, from it, the wheel; try the wheel where nothing else is installed: ``make package``.

With ``--notes TAG`` print the changelog's section for a tag instead, or fail if the tag is not the version of the project.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import tomllib
import venv
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
DIST = ROOT / "dist"
SECONDS = 0.5  # for `import contourlab`
IMPORT = "import time; start = time.perf_counter(); import contourlab; print(time.perf_counter() - start)"


def build() -> Path:
    """Build both archives into dist, with the kernels in the language of LLVM; return the wheel."""
    subprocess.run([sys.executable, "-m", "contourlab.app.precompile"], check=True)
    for folder in (DIST, ROOT / "build"):
        shutil.rmtree(folder, ignore_errors=True)
    subprocess.run([sys.executable, "-m", "build", ROOT], check=True)
    (wheel,) = DIST.glob("*.whl")
    return wheel


def missing_data(wheel: Path) -> list[str]:
    """Return the data files of the sources that the wheel lacks."""
    source = ROOT / "src"
    files = [path for path in (source / "contourlab").rglob("*") if path.is_file() and path.suffix not in (".py", ".pyc")]
    with zipfile.ZipFile(wheel) as archive:
        return sorted({path.relative_to(source).as_posix() for path in files} - set(archive.namelist()))


def try_out(wheel: Path, place: Path) -> None:
    """Install the wheel in a fresh environment; run the demonstration and the reproduction; measure the import."""
    venv.create(place / "venv", with_pip=True)
    scripts = place / "venv" / ("Scripts" if os.name == "nt" else "bin")
    python, command = scripts / "python", scripts / "contourlab"
    own = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    own["CONTOURLAB_CACHE"] = str(place / "cache")  # compiled from the start, as at a user's first run

    def run(*words: str | Path) -> None:
        subprocess.run(words, cwd=place, env=own, check=True)

    run(python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-c", ROOT / "constraints.txt", wheel)
    run(command, "--version")
    run(python, "-c", "import sys; sys.modules['numba'] = None; from contourlab.app.precompile import precompile; precompile()")
    run(command, "demo", "--out", "demo")
    if not (place / "demo" / "report.html").is_file():
        raise SystemExit("the demonstration wrote no report")
    run(command, "reproduce", "ghaffari")
    times = [float(subprocess.run([python, "-c", IMPORT], cwd=place, env=own, check=True, capture_output=True).stdout) for _ in range(10)]
    middle = statistics.median(times)
    print(f"import contourlab: {middle:.3f} s, median of {len(times)}")
    if middle > SECONDS:
        raise SystemExit(f"import contourlab takes more than {SECONDS} s")


def notes(tag: str) -> str:
    """Return the changelog's section for a tag."""
    version = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["version"]
    if tag != f"v{version}":
        raise SystemExit(f"tag {tag}, but the project is version {version}")
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    section = re.search(rf"^## \[{re.escape(version)}\] - \d{{4}}-\d\d-\d\d\n(.*?)(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
    if section is None:
        raise SystemExit(f"CHANGELOG.md has no heading '## [{version}] - YYYY-MM-DD'")
    return section[1].strip()


def main() -> None:
    """Build and try, or print the notes."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--notes", metavar="TAG", help="print the notes of a release")
    given = parser.parse_args()
    if given.notes:
        print(notes(given.notes))
        return
    wheel = build()
    if missing := missing_data(wheel):
        raise SystemExit("not in the wheel: " + ", ".join(missing))
    with tempfile.TemporaryDirectory() as place:
        try_out(wheel, Path(place))


if __name__ == "__main__":
    main()
