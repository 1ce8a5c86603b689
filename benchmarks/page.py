"""The page of a report in Chromium without a graphics card: its size, its frames, its memory, and the loop that it carries.

    python benchmarks/page.py [--only WORD] [--rounds N] [--lines N]

Each row has a figure, its unit, and the goal or the row that it is compared with. Needs Chromium and Playwright (extra `dev`); for
`node` rows Node. Everything is opened from files. The figures go to benchmarks/out/page.json too.
"""

from __future__ import annotations

import argparse
import base64
import gzip
import json
import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import figures_file
import numpy as np

import contourlab as cl
from contourlab.engine.runner import CompiledGroup
from contourlab.loop.portable import PortableLoop, portable
from contourlab.rendering import html

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tests" / "helpers"))
from browsing import BROWSER, OPEN, OPTIONS, drawn

POINTS, COUNT, WARM = 50_000, 100, 12
"""Points of a run in space, frames, and runs of a loop after which a browser has compiled it well."""
Row = tuple[str, float, str, str]
"""Name, figure, unit, and what it is compared with: a goal, or another row and the ratio to it."""

FRAMES = """async frames => {
  const own = requestAnimationFrame.bind(window), slider = document.querySelector("[aria-label^=Magnification]");
  let script = 0;
  const timed = act => { const start = performance.now(); act(); script += performance.now() - start; };
  window.requestAnimationFrame = call => own(now => timed(() => call(now)));
  const start = performance.now();
  for (let i = 0; i < frames; i += 1) {
    timed(() => { slider.value = String(2 + (i % 40) / 40); slider.dispatchEvent(new Event("input", {bubbles: true})); });
    await new Promise(done => own(done));
  }
  window.requestAnimationFrame = own;
  return [(performance.now() - start) / frames, script / frames];
}"""
"""Move the magnification in every frame; return the mean time of a frame and of its script [ms]."""

DRAG = """async ([times, whole]) => {
  const slider = document.querySelector("#live input[type=range]"), said = document.querySelector("#live [aria-live]"), found = [];
  const until = () => new Promise((done, failed) => {
    const look = () => {
      if (!(whole ? /^Whole part/ : /^(Short run|Whole part)/).test(said.textContent)) return;
      watch.disconnect();
      requestAnimationFrame(() => requestAnimationFrame(done));
    };
    const watch = new MutationObserver(look);
    watch.observe(said, {childList: true, characterData: true, subtree: true});
    setTimeout(() => { watch.disconnect(); failed(new Error(`no picture in 20 s: ${said.textContent}`)); }, 20_000);
  });
  const wait = ms => new Promise(done => setTimeout(done, ms));
  for (let i = 0; i < times; i += 1) {
    const seen = until(), start = performance.now();
    said.textContent = "";
    slider.value = String(0.02 + 0.01 * i);
    slider.dispatchEvent(new Event("input", {bubbles: true}));
    await seen;
    found.push(performance.now() - start);
    await wait(1500);
  }
  return found;
}"""
"""Drag the first slider of the panel; return the times until the new picture is painted [ms]."""

TIMED = """async given => {
  const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)), numbers = text => new Float64Array(bytes(text).buffer);
  const memory = new WebAssembly.Memory({initial: Math.ceil(given.n_word / 8192)}), words = new Float64Array(memory.buffer);
  const {instance} = await WebAssembly.instantiate(bytes(given.code), {env: {memory}}), start = numbers(given.start);
  words.set(numbers(given.fed), given.inputs);
  return () => { words.set(start, given.first); instance.exports.run(0, given.ticks); };
}"""
"""Return a function that runs a loop again in one memory."""
NODE = """const given = JSON.parse(require("fs").readFileSync(process.argv[1]));
const [warm, rounds] = process.argv.slice(2).map(Number), found = [];
(TIMED)(given).then(run => {
  for (let i = 0; i < warm; i += 1) run();
  for (let i = 0; i < rounds; i += 1) {
    const start = process.cpuUsage();
    run();
    const used = process.cpuUsage(start);
    found.push((used.user + used.system) / 1e3);
  }
  console.log(Math.min(...found));
});"""
WORKER = """([source, given]) => {
  const text = `let ready; onmessage = async ({data: [given, rounds]}) => {
    ready ??= (${source})(given);
    const run = await ready;
    for (let i = 0; i < rounds; i += 1) run();
    postMessage(null);
  }`;
  window.worker = new Worker(URL.createObjectURL(new Blob([text], {type: "text/javascript"})));
  window.runs = rounds => new Promise((done, failed) => {
    worker.onmessage = done;
    worker.onerror = event => failed(new Error(event.message));
    worker.postMessage([given, rounds]);
  });
}"""


def processes(browser: Any, kind: str) -> list[dict[str, Any]]:
    """Return the processes of a browser of one kind, or all."""
    found = browser.new_browser_cdp_session().send("SystemInfo.getProcessInfo")["processInfo"]
    return [one for one in found if kind in one["type"]]


def size_rows(report: Path) -> Iterator[Row]:
    """Yield the sizes of the viewer and of the page of the demonstration part."""
    yield "viewer.js, gzip", len(gzip.compress(html.VIEWER.read_bytes(), 9)) / 1e3, "kB", "below 220"
    yield "report.html of the demonstration part", report.stat().st_size / 1e6, "MB", "below 1.2"


def frame_rows(opened: Callable[[Path], Any], used: Callable[[str], float], runs: Any, folder: Path) -> Iterator[Row]:
    """Yield a frame and its script while the magnification of one run of `POINTS` points moves."""
    html.SCENE_POINTS = POINTS
    page = opened(html.write_html(replace(runs.data, schemes=runs.data.schemes[:1]), folder / "frames.html"))
    page.locator("#path-space").scroll_into_view_if_needed()
    page.wait_for_selector(".path-stage canvas")
    page.evaluate(FRAMES, 10)
    begun = used("")
    frame, script = page.evaluate(FRAMES, COUNT)
    yield f"processor time of a frame, {POINTS} points", 1e3 * (used("") - begun) / COUNT, "ms", ""
    yield f"frame, {POINTS} points", frame, "ms", "below 60"
    yield f"script of a frame, {POINTS} points", script, "ms", "below 2"


def drag_rows(opened: Callable[[Path], Any], report: Path) -> Iterator[Row]:
    """Yield the time from a dragged gain to the new picture: of the worst second, and of the whole part."""
    page = opened(report)
    if not page.locator("#live").count():
        print("the page has no sliders: no rows for them")
        return
    drawn(page, "live")
    page.locator("#live input[type=range]").first.focus()
    page.wait_for_timeout(4000)  # the worker has read the loop and run it
    for name, whole, goal in (("the worst second", False, 50), ("the whole part", True, 300)):
        yield f"gain dragged to the picture of {name}", statistics.median(page.evaluate(DRAG, [8, whole])), "ms", f"below {goal}"


def memory_rows(driver: Any, lines: int, folder: Path) -> Iterator[Row]:
    """Yield time and size of the report of a long program, and the memory of the process that shows it."""
    from run import relief

    (folder / "relief.ngc").write_text(relief(lines), encoding="utf-8")
    machine = 'name = "relief"\nmachine = "builtin:xyz"\ncontroller = "builtin:xyz-controller"\nprogram = "relief.ngc"\n'
    (folder / "relief.toml").write_text(machine + '[run]\ntolerance = "25 um"\n', encoding="utf-8")
    data = cl.run(folder / "relief.toml", interval=False).data
    begun = time.process_time()
    file = html.write_html(data, folder / "relief.html")
    yield f"report of {lines} lines, written in", time.process_time() - begun, "s", ""
    yield f"report of {lines} lines", file.stat().st_size / 1e6, "MB", ""
    browser = driver.chromium.launch(executable_path=BROWSER, args=OPTIONS)
    page = browser.new_page()
    page.goto(file.as_uri())
    page.evaluate(OPEN)
    for place in page.locator(".plot").all():
        place.scroll_into_view_if_needed()
        page.wait_for_timeout(300)
    status = [Path(f"/proc/{one['id']}/status").read_text(encoding="utf-8") for one in processes(browser, "renderer")]
    most = max(int(text.split("VmHWM:")[1].split()[0]) for text in status)
    yield f"most memory of the process that shows {lines} lines", most / 1e3, "MB", "below 500"
    browser.close()


def loop_rows(opened: Callable[[Path], Any], used: Callable[[str], float], loop: PortableLoop, rounds: int, folder: Path) -> Iterator[Row]:
    """Yield the least processor time of a warm run of the loop: native, in node and in a worker of Chromium, in turns."""
    external, rows, ticks = loop.fed().T, list(loop.rows), loop.feed.reference.n_sample
    texts = {"code": loop.code, "start": loop.start.tobytes(), "fed": np.ascontiguousarray(external.T).tobytes()}
    given: dict[str, Any] = {name: base64.b64encode(value).decode() for name, value in texts.items()}
    given |= {"n_word": loop.n_word, "first": loop.first, "inputs": loop.inputs["reference"][0], "ticks": ticks}
    (folder / "given.json").write_text(json.dumps(given), encoding="utf-8")
    (folder / "empty.html").write_text("<!doctype html>", encoding="utf-8")
    page, group, node = opened(folder / "empty.html"), CompiledGroup(loop.schedule, 1, slice(0, 1), like_lanes=True), shutil.which("node")
    start, log = group.snapshot(), group.run(external, rows)
    page.evaluate(WORKER, [TIMED, given])
    page.evaluate("async rounds => { await runs(rounds); }", WARM)
    times: dict[str, list[float]] = {}
    for _ in range(3):
        for _ in range(rounds):
            group.restore(start)
            begun = time.process_time()
            group.run(external, rows, log)
            times.setdefault("native", []).append(1e3 * (time.process_time() - begun))
        if node:
            words = [node, "-e", NODE.replace("TIMED", TIMED), str(folder / "given.json"), str(WARM), str(rounds)]
            times.setdefault("node", []).append(float(subprocess.run(words, check=True, capture_output=True, text=True).stdout))
        begun = used("renderer")
        page.evaluate("async rounds => { await runs(rounds); }", rounds)
        times.setdefault("Chromium", []).append(1e3 * (used("renderer") - begun) / rounds)
    native = min(times["native"])
    for name, each in times.items():
        against = "" if name == "native" else f"{min(each) / native:.2f} times native" + (", goal 1.3" if name == "Chromium" else "")
        yield f"{ticks} ticks, judged: {name}, processor time", min(each), "ms", against


def main() -> int:
    """Print the rows, and write them to benchmarks/out/page.json."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", metavar="WORD", help="sizes, frames, drag, loop or memory")
    parser.add_argument("--rounds", type=int, default=10, help="warm runs of the loop in a turn; the shortest of three turns counts")
    parser.add_argument("--lines", type=int, default=40_000, help="of the long program")
    given = parser.parse_args()
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        print("skipped: Playwright is not installed")
        return 0
    if BROWSER is None:
        print("skipped: no Chromium on this machine")
        return 0
    rows: list[Row] = []
    print(f"{platform.platform()}, Python {platform.python_version()}, {os.cpu_count()} processors, load {os.getloadavg()[0]:.1f}")
    with tempfile.TemporaryDirectory() as name, sync_playwright() as driver:
        folder = Path(name)
        browser = driver.chromium.launch(executable_path=BROWSER, args=OPTIONS)

        def opened(file: Path) -> Any:
            page = browser.new_context(viewport={"width": 1280, "height": 720}, offline=True).new_page()
            page.on("pageerror", lambda error: print(f"{file.name}: {error}"))
            page.goto(file.as_uri())
            page.evaluate(OPEN)
            return page

        def used(kind: str) -> float:
            return sum(one["cpuTime"] for one in processes(browser, kind))

        runs = cl.run("builtin:demo-part", interval=False)
        report, case = Path(runs.save(folder / "demo").files["report"]), runs.outcomes[-1].case
        loop = portable(case.machine, case.controller, case.reference())
        parts: dict[str, Callable[[], Iterator[Row]]] = {
            "sizes": lambda: size_rows(report),
            "drag": lambda: drag_rows(opened, report),
            "loop": lambda: loop_rows(opened, used, loop, given.rounds, folder),
            "frames": lambda: frame_rows(opened, used, runs, folder),
            "memory": lambda: memory_rows(driver, given.lines, folder),
        }
        for part, measured in parts.items():
            for row in measured() if given.only in part else ():
                rows.append(row)
                print(f"{row[0]:60}{row[1]:10.4g} {row[2]:4}{row[3]}", flush=True)
        browser.close()
    figures_file.write("page.json", [dict(zip(("name", "value", "unit", "compared"), row, strict=True)) for row in rows])
    return 0


if __name__ == "__main__":
    sys.exit(main())
