/** The reader changes parameters of a run; a worker runs its loop again, and path, error and figures follow. */
import { add, button, type Drawing, figure, indexBefore, type Page } from "./base";
import { drawChart } from "./chart";
import type { Chart, Curve, LiveLoop, LiveParameter, Numbers, PathScene, SceneRun } from "./contract";
import { ghosts } from "./path";
import type { Answer, Ask, Points } from "./worker";
import script from "./worker?text";

/** Parameters of several axes with one name, and those of them that the row changes. */
interface Row { taken: LiveParameter[]; slider: HTMLInputElement; field: HTMLInputElement; unit: HTMLElement }
type Values = ReadonlyMap<string, number>;
/** Values, and what came out. */
interface Step { values: Values; answer?: Answer }

/** Time [ms] after which the whole part follows, and the longest for which it needs no short run before it. */
const REST = 60, QUICK = 60;
const NOW = "changed settings", BEFORE = "settings before", GREY = "#8a949e", COLOURS = ["#d55e00", "#cc79a7", "#56b4e9"];
const FIGURES: [string, string, number][] = [
  ["part_error_max", "largest part error [um]", 1e6], ["part_error_rms", "part error, rms [um]", 1e6],
  ["tracking_error_max", "largest tracking error [um]", 1e6], ["command_largest", "largest command [% of the limit]", 100],
];

const numbers = (values: Numbers["values"]): Numbers => ({ values, shape: [values.length] });
const familyOf = ({ name }: LiveParameter): string => name.replace(/^(controller\.)?axes\.[^.]+\./, "$1axes.*.");
const axisOf = ({ name }: LiveParameter): string => /(?:^|\.)axes\.([^.]+)\./.exec(name)?.[1] ?? "";
const inWords = (name: string): string => name.split(".").slice(-2).join(" ").replaceAll("_", " ");
const keyOf = (values: Values): string => JSON.stringify([...values].sort());
const baseOf = (one: LiveParameter): number => one.value ?? Infinity;

/** Return the point with the largest error. */
function worstOf({ size, stretch }: Points): number {
  return size.reduce((worst, value, i) => (stretch[i] && (value > size[worst] || !stretch[worst]) ? i : worst), 0);
}

/** Return the line of the program at a time of the report's run. */
function lineAt(run: SceneRun | undefined, time: number): number {
  if (!run) return 0;
  const times = run.time.values, i = indexBefore(times, time);
  return run.lines.values[times[i + 1] - time < time - times[i] ? i + 1 : i];
}

/** Return a value as files and options take it. */
const written = ({ display, factor }: LiveParameter, value: number): string =>
  (Number.isFinite(value) ? `${Number((value * factor).toPrecision(15))} ${display}`.trim() : "inf");

/** Return what is wrong with a value, or nothing. */
function wrong(one: LiveParameter, value: number): string {
  const text = (edge: number): string => figure(edge * one.factor, one.display), { minimum: low, maximum: high } = one;
  const what = `${inWords(one.name)} of ${axisOf(one) || "all axes"} = ${text(value)}`;
  if (low !== null && (value < low || (one.exclusive && value === low))) return `${what} must be ${one.exclusive ? "more than" : "at least"} ${text(low)}`;
  return high !== null && value > high ? `${what} must be at most ${text(high)}` : "";
}

export function drawLive(host: HTMLElement, live: LiveLoop, page: Page): Drawing {
  const cannot = live.runs.length && (typeof WebAssembly !== "object" || typeof Worker !== "function");
  if (cannot || !live.runs.length) {
    if (cannot) add(host, "p", "note", "The sliders need WebAssembly and workers, which this browser does not offer.");
    return { resize() {}, destroy() { host.replaceChildren(); } };
  }
  const scene = page.pictures.find(picture => picture.kind === "PathScene") as PathScene | undefined;
  const errors = page.pictures.find(picture => picture.key === "error-time") as Chart | undefined;
  const tolerance = scene?.tolerance ?? errors?.panels[0].band?.[1] ?? null, used = scene?.runs.map(run => run.colour) ?? [];
  const colour = COLOURS.find(one => !used.includes(one)) ?? COLOURS[0];
  const [then, now] = [[BEFORE, GREY], [NOW, colour]].map(([name, paint]): SceneRun => ({ kind: "SceneRun", name, colour: paint, ...drawn(null, 0) }));

  let r = -1, values = new Map<string, number>(), past: Step[] = [], at = 0, rows: Row[] = [];
  /** A drag is one step to undo. Numbers of the next drag, of the one that made the values, and of the one that made the newest step. */
  let next = 1, movement = 0, newest = 0;
  let worker: Worker | null = null, asked = 0, since = 0, sent: Values = values, took = Infinity, rest = 0;
  let before: Answer | undefined;
  /** The report's own runs, whole and short, as the worker has found them. */
  const firsts = live.runs.map((): { whole?: Answer; short?: Answer } => ({}));
  let picture: ReturnType<typeof drawChart> | null = null, curves: Curve[] = [];
  const gone = new AbortController(), { signal } = gone;

  // --- controls ----------------------------------------------------------------------------------------------------------------------
  const select = (place: HTMLElement, ariaLabel: string, texts: string[], act: (index: number) => void): HTMLSelectElement => {
    const made = Object.assign(add(place, "select"), { ariaLabel });
    texts.forEach((text, i) => made.add(new Option(text, String(i))));
    made.addEventListener("change", () => act(Number(made.value)));
    return made;
  };
  const top = add(host, "div", "cl-tools"), which = select(top, "Run", live.runs.map(run => run.name), take);
  const more = Object.assign(add(top, "select"), { ariaLabel: "More parameters" });
  more.addEventListener("change", () => { show(more.value); refresh(); });
  const undo = button("Undo", () => step(-1)), redo = button("Redo", () => step(1)), reset = button("Reset", () => set(new Map()));
  top.append(undo, redo, reset);
  const list = add(host, "div", "live-rows"), said = Object.assign(add(host, "p", "live-said"), { ariaLive: "polite" });
  const sides = add(host, "div", "cl-sides"), place = add(sides, "div"), table = add(add(sides, "div", "scroll"), "table", "figures slim tight live-table");
  const end = add(host, "div", "cl-tools"), copied = button("Copy the command line", () => void copy());
  end.append(copied, button("Save as controller file", save));
  const note = add(end, "span"), line = add(host, "pre", "command"), command = add(line, "code");
  /** Say what is shown now: the run of the report, a short run, the whole part, or nothing new. */
  const say = (text: string, shown: "report" | "short" | "whole" | "none"): void => {
    said.textContent = text;
    host.dataset.shows = shown;
  };
  which.hidden = live.runs.length === 1;
  copied.hidden = line.hidden = !live.command;  // no command has written the page
  host.addEventListener("keydown", event => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || !["z", "y"].includes(key)) return;
    event.preventDefault();
    step(key === "y" || event.shiftKey ? 1 : -1);
  }, { signal });
  ["pointerenter", "focusin"].forEach(kind => host.addEventListener(kind, load, { signal }));

  // --- parameters --------------------------------------------------------------------------------------------------------------------
  /** Take a run of the report. */
  function take(index: number): void {
    [r, rows, values, past, at, before] = [index, [], new Map(), [{ values: new Map() }], 0, undefined];
    since = asked;  // answers on their way are about another run
    scene?.runs.forEach(run => ghosts.delete(run));
    ghosts.add(then);
    [then, now].forEach(run => Object.assign(run, drawn(null, r)));
    if (scene?.runs.includes(now)) page.changed(scene);
    const { name, parameters, short, motion: { period } } = live.runs[r], families = [...new Set(parameters.map(familyOf))];
    list.replaceChildren();
    more.replaceChildren(new Option("more parameters", ""));
    families.sort((a, b) => Number(b.startsWith("controller")) - Number(a.startsWith("controller"))).forEach(family => more.add(new Option(inWords(family), family)));
    const drags = families.filter(family => parameters.some(one => one.value && familyOf(one) === family));
    const usual = drags.filter(family => parameters.some(one => one.first && one.value && familyOf(one) === family));
    (usual.length ? usual : drags.slice(0, 5)).forEach(show);  // a stepper has no gains
    if (errors) {
      const [panel] = errors.panels, base = panel.curves.find(one => one.name === name), none = numbers(new Float64Array(0));
      curves = [{ ...base, dash: "dash" }, { name: BEFORE, colour: GREY, dash: "dot" }, { name: NOW, colour, dash: "solid", width: 2 }].map(looks =>
        ({ kind: "Curve", x: none, y: none, name: "", colour: GREY, width: 1.3, half: null, numbers: null, ...looks }));
      picture?.destroy();
      picture = drawChart(place, { ...errors, panel_height: 170, panels: [{ ...panel, curves }] });
      picture.zoom([short[0] * period, short[1] * period]);
    }
    if (worker) load();
    refresh();
    draw(null);
    say("Drag a slider: the loop runs in this page.", "report");
  }

  /** Add the row of a family. */
  function show(family: string): void {
    const members = live.runs[r].parameters.filter(one => familyOf(one) === family), title = inWords(family);
    if (!members.length) return;
    const one = add(list, "div", "live-row"), name = add(one, "span", "live-name", title);
    const slider = Object.assign(add(one, "input"), { type: "range", min: "-1", max: "1", step: "0.01", ariaLabel: title });
    const field = Object.assign(add(one, "input"), { type: "number", step: "any", ariaLabel: `${title}, value` });
    const row: Row = { taken: members, slider, field, unit: add(one, "span", "live-unit") };
    name.title = members.map(each => each.name).join("\n");
    if (members.length > 1) select(name, `Axes of ${title}`, ["all axes", ...members.map(axisOf)], i => {
      row.taken = i ? [members[i - 1]] : members;
      refresh();
    });
    slider.addEventListener("input", () => {
      const power = Number(slider.value);
      change(row, base => (power ? Number((base * 10 ** power).toPrecision(3)) : base));
    });
    slider.addEventListener("change", () => { next += 1; });
    field.addEventListener("change", () => {
      const given = field.valueAsNumber;
      if (Number.isFinite(given)) change(row, (base, { factor }) => (isAlike(row) ? given / factor : base * given)); else refresh();
      next += 1;
    });
    rows.push(row);
    [...more.options].find(option => option.value === family)?.remove();
  }

  /** Whether what a row changes had one value in the report; else the row shows factors. */
  const isAlike = ({ taken }: Row): boolean => taken.every(one => one.value === taken[0].value);
  const changed = (): [LiveParameter, number][] =>
    live.runs[r].parameters.filter(one => values.has(one.name)).map(one => [one, values.get(one.name)!]);

  function change(row: Row, made: (base: number, one: LiveParameter) => number): void {
    for (const one of row.taken) {
      const value = made(baseOf(one), one), fit = one.whole ? Math.round(value) : value;
      if (fit === baseOf(one)) values.delete(one.name); else values.set(one.name, fit);
    }
    touched(row);
  }

  function set(wanted: Values): void {
    values = new Map(wanted);
    next += 1;
    touched();
    next += 1;
  }

  /** Go back to the values before, or forth. Values that gave no picture are no step. */
  function step(by: number): void {
    const to = at + (by > 0 || keyOf(values) === keyOf(past[at].values) ? by : 0);
    if (!past[to]) return;
    at = to;
    set(past[to].values);
  }

  /** Write the values in their rows; the slider in hand stays where it is. */
  function refresh(inHand?: Row): void {
    for (const row of rows) {
      const [one] = row.taken, base = baseOf(one), value = values.get(one.name) ?? base, share = value / base, { slider, field, unit } = row;
      slider.disabled = !Number.isFinite(base) || base === 0;
      if (row !== inHand) slider.value = String(Math.log10(share > 0 ? share : 1));
      field.value = Number.isFinite(value) ? String(Number((isAlike(row) ? value * one.factor : share).toPrecision(5))) : "";
      unit.textContent = isAlike(row) ? one.display : "times";
      slider.ariaValueText = `${field.value} ${unit.textContent}`;
    }
    const all = changed();
    [undo.disabled, redo.disabled, reset.disabled] = [!at && !all.length, at + 1 >= past.length, !all.length];
    note.textContent = all.some(([one]) => !one.name.startsWith("controller.")) ? "The controller file lacks the values of the machine." : "";
    command.textContent = [live.command, ...all.map(([one, value]) => `--set "${one.name}=${written(one, value)}"`)].join(" ");
    host.classList.toggle("live-same", !all.length);
  }

  // --- the worker --------------------------------------------------------------------------------------------------------------------
  const loaded = new Set<number>();
  /** Start the worker, and give it the loop; it runs the report's own values first. */
  function load(): void {
    if (!worker) {
      const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
      worker = new Worker(address);
      worker.addEventListener("message", ({ data }: MessageEvent<Answer>) => answered(data));
      worker.addEventListener("error", event => say(`The loop cannot run here: ${event.message}.`, "none"));
      URL.revokeObjectURL(address);
    }
    if (!loaded.has(r)) worker.postMessage({ run: r, loop: live.runs[r] });
    loaded.add(r);
  }

  function touched(inHand?: Row): void {
    movement = next;
    refresh(inHand);
    clearTimeout(rest);
    const reason = changed().map(([one, value]) => wrong(one, value)).find(Boolean);
    if (reason) return say(`Not possible: ${reason}.`, "none");
    load();
    delete host.dataset.shows;
    ask(took > QUICK);
  }

  function ask(short: boolean): void {
    sent = new Map(values);
    asked += 1;
    worker!.postMessage({ id: asked, run: r, values: changed().map(([one, value]) => [one.word, value]), short } satisfies Ask);
  }

  function answered(answer: Answer): void {
    const { id, run, short, points, failed } = answer;
    if (!id) {
      firsts[run][short ? "short" : "whole"] = answer;
      if (run === r) draw(null);
    }
    if (id <= since) return;
    if (id === asked && short) rest = window.setTimeout(() => ask(false), REST);
    if (!points) {
      const when = figure((failed ?? 0) * live.runs[r].motion.period, "s", 5);
      const why = failed === null ? "Not possible: these values do not fit together" : `At ${when} an axis leaves its limit of following error`;
      return say(`${why}. The pictures show the values before.`, "none");
    }
    if (id === asked && !short) settle(answer);
    draw(answer);
  }

  /** The whole part has followed. */
  function settle(answer: Answer): void {
    took = answer.took;
    if (keyOf(past[at].values) !== keyOf(sent)) {
      past = [...past.slice(0, at + (movement === newest && at ? 0 : 1)), { values: sent }];
      [at, newest] = [past.length - 1, movement];
    }
    past[at].answer = answer;
    const last = at > 1 ? past[at - 1].answer : undefined;
    if (last !== before) Object.assign(then, drawn(last?.points, r, baseRun()));
    before = last;
    refresh();
  }

  const baseRun = (): SceneRun | undefined => scene?.runs.find(run => run.name === live.runs[r].name);

  // --- what is drawn -----------------------------------------------------------------------------------------------------------------
  /** Draw an answer beside the run of the report and the values before. */
  function draw(answer: Answer | null): void {
    const base = baseRun();
    [firsts[r].whole, before, answer].forEach((one, i) => {
      const points = one?.points, none = new Float64Array(0);
      if (curves[i] && (points || i)) Object.assign(curves[i], { x: numbers(points?.time ?? none), y: numbers(points?.signed ?? none) });
    });
    picture?.update?.();
    tabulate(answer, base);
    if (!scene || !answer) return;
    Object.assign(now, drawn(answer.points, r, base));
    if (!scene.runs.includes(now)) scene.runs.push(then, now);
    if (base) ghosts.add(base);
    page.changed(scene);
  }

  /** Return points as those of a run in space. */
  function drawn(points: Points | null | undefined, run: number, base?: SceneRun): Omit<SceneRun, "kind" | "name" | "colour"> {
    const n = points?.time.length ?? 0, names = [...new Set(live.runs[run].parameters.map(axisOf).filter(Boolean))];
    const columns = (scene?.axes ?? []).map(name => names.indexOf(name)), none = new Float32Array(0);
    const spread = (given: Float32Array = none): Numbers => {
      const out = new Float32Array(3 * n);
      for (let i = 0; i < n; i += 1) columns.forEach((column, j) => { out[3 * i + j] = given[names.length * i + column]; });
      return numbers(out);
    };
    const foot = spread(points?.foot), error = spread(points?.error), lines = Int32Array.from(points?.time ?? [], time => lineAt(base, time));
    const i = points ? worstOf(points) : 0, three = ({ values: all }: Numbers): number[] => [...all.subarray(3 * i, 3 * i + 3)];
    const worst = points ? [{ kind: "Place" as const, foot: three(foot), error: three(error), size: points.size[i], time: points.time[i], line: lines[i], cause: "" }] : [];
    return {
      foot, error, worst, lines: numbers(lines), size: numbers(points?.size ?? none), time: numbers(points?.time ?? none),
      feedrate: numbers(points?.feedrate ?? none), stretch: numbers(points?.stretch ?? none),
    };
  }

  /** Write the figures of the report, of the values before, and of an answer; say what it covers. */
  function tabulate(answer: Answer | null, base?: SceneRun): void {
    const short = answer?.short ?? false, first = firsts[r][short ? "short" : "whole"], { motion: { period }, short: [from, to] } = live.runs[r];
    table.replaceChildren();
    if (!first?.points) return;
    const columns = [["report", first], ["before", short ? null : before], ["now", answer]].filter((one): one is [string, Answer] => Boolean(one[1]));
    const head = add(add(table, "thead"), "tr"), body = add(table, "tbody");
    ["", ...columns.map(([name]) => name)].forEach(text => { add(head, "th", "n", text).scope = "col"; });
    const row = (text: string, write: (one: Answer, cell: HTMLElement) => void): void => {
      const made = add(body, "tr");
      add(made, "th", "", text).scope = "row";
      columns.forEach(([, one]) => write(one, add(made, "td", "n")));
    };
    if (tolerance !== null) row(`tolerance ${figure(tolerance, "um")}`, (one, cell) => {
      const isGood = one.figures.part_error_max * 1e6 <= tolerance;
      cell.classList.toggle("poor", !isGood);
      add(cell, "span", "seal", isGood ? "PASS" : "FAIL");
    });
    for (const [name, label, factor] of FIGURES) {
      if (columns.some(([, one]) => one.figures[name])) row(label, (one, cell) => { cell.textContent = figure(one.figures[name] * factor); });
    }
    row("worst place", ({ points }, cell) => {
      const time = points!.time[worstOf(points!)], found = lineAt(base, time);
      cell.textContent = figure(time, "s", 5) + (found ? `, line ${found}` : "");
    });
    if (!answer) return;
    const [start, stop, begun] = [from, to, answer.begun].map(k => figure(k * period, "s", 5));
    const where = short ? `Short run, from ${start} to ${stop}, begun with the state of the report at ${begun}` : "Whole part";
    const [was, is] = [first, answer].map(one => figure(one.figures.part_error_max * 1e6, "um"));
    say(`${where}: largest part error ${is}, with the report's values ${was}.`, short ? "short" : "whole");
  }

  // --- what leaves the page ----------------------------------------------------------------------------------------------------------
  async function copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(command.textContent!);
      copied.textContent = "Copied";
    } catch {
      getSelection()?.selectAllChildren(command);
      copied.textContent = "Selected: press Ctrl-C";
    }
    setTimeout(() => { copied.textContent = "Copy the command line"; }, 2000);
  }

  function save(): void {
    const known = new Map(live.runs[r].parameters.map(one => [one.name, written(one, values.get(one.name) ?? baseOf(one))]));
    // What a file says of a value, such as its source, does not hold for another one.
    const text = live.runs[r].controller.replace(/(\{value = )?"@([^"]+)@"(.*\})?/g, (_, open = "", name, rest = "") => {
      const value = JSON.stringify(known.get(name)).replace(/^"([^ ]*)"$/, "$1");
      return values.has(name) ? value : open + value + rest;
    });
    const link = document.createElement("a"), href = URL.createObjectURL(new Blob([text], { type: "application/toml" }));
    Object.assign(link, { href, download: "controller.toml" }).click();
    setTimeout(() => URL.revokeObjectURL(href), 1000);
  }

  const most = live.runs.map(({ name }) => Math.max(0, ...(scene?.runs.find(run => run.name === name)?.worst ?? []).map(({ size }) => size)));
  which.value = String(most.indexOf(Math.max(...most)));
  take(Number(which.value));
  return {
    resize() { picture?.resize(); },
    destroy() {
      worker?.terminate();
      clearTimeout(rest);
      picture?.destroy();
      gone.abort();
      host.replaceChildren();
    },
  };
}
