"""The viewer in JupyterLab: a real server and browser, without a network."""

from __future__ import annotations

import os
import re
import socket
import subprocess
import sys
import time
import urllib.error
import urllib.request
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browsing import drawn, painted

pytestmark = pytest.mark.slow
RUN = """\
import contourlab as cl
case = cl.load_scenario("builtin:ghaffari/demo-stage").base
circle = cl.uniform(cl.contour("circle", radius=5e-3), 1.0, 1, case.machine.servo_period)
result = cl.judge(cl.simulate(case.machine, case.controller, circle), circle)
print(f"{1e6 * abs(result['part_error']).max():.4g} um")
cl.show(result)"""
TOKEN = "contourlab"
OWN = [f"JUPYTER_{name}_DIR" for name in ("CONFIG", "DATA", "RUNTIME")]
OWN += ["JUPYTERLAB_SETTINGS_DIR", "JUPYTERLAB_WORKSPACES_DIR", "IPYTHONDIR"]
"""Folders that a user has."""


@pytest.fixture(scope="module")
def lab(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[str, Path]]:
    """The address of a JupyterLab of its own, and its folder."""
    pytest.importorskip("jupyterlab", reason="no JupyterLab in this environment")
    pytest.importorskip("anywidget", reason="no anywidget in this environment")
    home, folder = tmp_path_factory.mktemp("home"), tmp_path_factory.mktemp("notebooks")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    options = ["--no-browser", "--allow-root", f"--IdentityProvider.token={TOKEN}", f"--ServerApp.root_dir={folder}"]
    options += [f"--ServerApp.port={port}", "--ServerApp.port_retries=0"]
    notice = home / "jupyterlab_settings_dir" / "@jupyterlab" / "apputils-extension" / "notification.jupyterlab-settings"
    notice.parent.mkdir(parents=True)
    notice.write_text('{"fetchNews": "false", "checkForUpdates": false}')
    environment = {**os.environ, **{name: str(home / name.lower()) for name in OWN}}
    with (home / "log").open("w") as log:
        server = subprocess.Popen([sys.executable, "-m", "jupyterlab", *options], cwd=folder, env=environment, stdout=log, stderr=log)
        try:
            yield wait_for(f"http://127.0.0.1:{port}", server, home / "log"), folder
        finally:
            server.terminate()
            server.wait(20)


def wait_for(address: str, server: subprocess.Popen[bytes], log: Path) -> str:
    """Return the address of a server that answers."""
    for _ in range(240):
        assert server.poll() is None, log.read_text()
        try:
            with urllib.request.urlopen(f"{address}/api/status?token={TOKEN}", timeout=5):
                return address
        except (urllib.error.URLError, TimeoutError):
            time.sleep(0.25)
    raise AssertionError(log.read_text())


@pytest.fixture
def book(lab: tuple[str, Path], chromium: Any) -> Iterator[Any]:
    """Open a notebook whose scripts must not complain, in a browser that reaches its server only."""
    import nbformat

    address, folder = lab
    notebook = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(RUN)])
    notebook.metadata.kernelspec = {"name": "python3", "display_name": "Python 3", "language": "python"}
    nbformat.write(notebook, folder / "book.ipynb")
    context, complaints, elsewhere = chromium.new_context(viewport={"width": 1280, "height": 1000}), [], []
    context.route(re.compile(f"^(?!{address}|blob:|data:)"), lambda route: (elsewhere.append(route.request.url), route.abort()))
    page = context.new_page()
    page.on("pageerror", lambda error: complaints.append(str(error)))
    page.on("console", lambda said: complaints.append(f"{said.text} {said.location}") if said.type in ("error", "warning") else None)
    page.goto(f"{address}/lab/tree/book.ipynb?token={TOKEN}")
    yield page
    end_kernels(page, address)
    context.close()
    assert (complaints, elsewhere) == ([], [])


def end_kernels(page: Any, address: str) -> None:
    """End all sessions of a server."""
    for session in page.request.get(f"{address}/api/sessions?token={TOKEN}").json():
        page.request.delete(f"{address}/api/sessions/{session['id']}?token={TOKEN}")


def run_all(page: Any) -> None:
    """Run the cell once its kernel is ready, and wait for its viewer."""
    page.locator('.jp-Notebook-ExecutionIndicator[data-status="idle"]').wait_for(timeout=60_000)
    page.get_by_text("Run", exact=True).click()  # a key that comes before the notebook listens is lost
    page.get_by_text("Run All Cells", exact=True).click()
    page.locator(".cl-show").wait_for(timeout=60_000)


def stills(page: Any) -> list[str]:
    """Return how the still pictures are displayed."""
    shown: list[str] = page.locator("div[class^=contourlab-]").evaluate_all("all => all.map(still => getComputedStyle(still).display)")
    return shown


def test_a_notebook_shows_figures_and_curves_in_the_look_of_its_page(book):
    run_all(book)
    place = drawn(book, "path-space")
    (printed,) = book.locator(".jp-OutputArea-output pre").all_inner_texts()
    assert place.locator(".path-worst text").first.text_content() == printed.strip()
    book.locator(".cl-show summary", has_text="Error over time").click()
    (path,), (curves,) = painted(book, "path-space"), painted(book, "error-time", "#0072b2")
    assert path > 1000 and curves > 500 and stills(book) == ["none"]
    book.get_by_text("Settings", exact=True).click()
    book.get_by_text("Theme", exact=True).hover()
    book.get_by_text("JupyterLab Dark", exact=True).click()
    book.locator(".cl-show.cl-dark").wait_for()
    assert place.evaluate("plot => getComputedStyle(plot).backgroundColor") == "rgb(27, 33, 39)"
    book.wait_for_function("document.querySelector('[data-key=error-time]').dataset.size")
    assert painted(book, "error-time", "#0072b2") == [0]  # lighter now
    for _ in range(18):  # a page has some 16 contexts of WebGL
        book.evaluate("globalThis.old = document.querySelector('.cl-show canvas')")
        run_all(book)
        book.wait_for_function("!old.isConnected && document.querySelector('.cl-show .plot[data-drawn]')")
    assert painted(book, "path-space")[0] > 1000 and stills(book) == ["none"]


def test_a_saved_notebook_shows_the_viewer_while_its_kernel_runs_and_then_a_still_picture(book, lab, chromium):
    import nbconvert

    address, folder = lab
    run_all(book)
    book.keyboard.press("Control+s")
    book.locator(".jp-mod-dirty").wait_for(state="detached")
    book.reload()
    book.locator(".cl-show .plot[data-drawn]").first.wait_for(timeout=60_000)
    assert stills(book) == ["none"]
    end_kernels(book, address)
    later = chromium.new_page()
    later.goto(f"{address}/lab/tree/book.ipynb?token={TOKEN}")
    later.locator("div[class^=contourlab-] svg").first.wait_for(timeout=60_000)
    later.get_by_text("model not found").wait_for()
    assert stills(later) == ["block"] and later.locator(".cl-show").count() == 0
    later.close()
    page, _ = nbconvert.HTMLExporter().from_filename(str(folder / "book.ipynb"))
    assert "<svg" in page and "contour error" in page
