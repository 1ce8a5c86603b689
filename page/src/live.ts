/** "Try it": the reader changes parameters of a run, a worker runs its loop again, and path, curves and figures follow. */
import { add, type Drawing, figure, type Page } from "./base";
import { drawChart } from "./chart";
import type { Chart, Curve, LiveLoop, LiveParameter, Numbers, PathScene, SceneRun } from "./contract";
import { ghosts } from "./path";
import type { Answer, Ask, Points } from "./worker";
import script from "./worker?text";

/** Parameters of the same name of several axes, and those of them that the row changes. */
interface Row { title: string; members: LiveParameter[]; taken: LiveParameter[]; slider: HTMLInputElement; field: HTMLInputElement; unit: HTMLElement }
type Values = ReadonlyMap<string, number>;

/** Time [ms] after which the whole part follows, and the longest that needs no short run before it. */
const REST = 60, QUICK = 60;
const NOW = "changed settings", BEFORE = "settings before", GREY = "#8a949e", COLOURS = ["#d55e00", "#cc79a7", "#56b4e9"];
const FIGURES: [string, string, number, string][] = [
  ["part_error_max", "largest part error", 1e6, "um"], ["part_error_rms", "part error, rms", 1e6, "um"],
  ["tracking_error_max", "largest tracking error", 1e6, "um"], ["command_largest", "largest command, of the limit", 100, "%"],
  ["unsure", "ticks in doubt", 1, ""],
];

export function drawLive(host: HTMLElement, live: LiveLoop, page: Page): Drawing {
  const refused = live.refused.map(([name, why]) => `${name}: ${why}.`).join(" ");
  if (!live.runs.length || typeof WebAssembly !== "object" || typeof Worker !== "function") {
    add(host, "p", "note", live.runs.length ? "The sliders need WebAssembly and workers, which this browser does not offer." : refused);
    return { resize() {}, destroy() { host.replaceChildren(); } };
  }
  return new Panel(host, live, page, refused);
}

const numbers = (values: Numbers["values"], wide = 0): Numbers => ({ values, shape: wide ? [values.length / wide, wide] : [values.length] });
const familyOf = (name: string): string => name.replace(/^(controller\.)?axes\.[^.]+\./, "$1axes.*.");
const axisOf = (name: string): string => /(?:^|\.)axes\.([^.]+)\./.exec(name)?.[1] ?? "";
const inWords = (name: string): string => name.split(".").slice(-2).join(" ").replaceAll("_", " ");
const keyOf = (values: Values): string => JSON.stringify([...values].sort());

class Panel implements Drawing {
  private r = 0;
  private values = new Map<string, number>();
  private past: Values[] = [new Map()];
  private at = 0;
  private rows: Row[] = [];
  /** Whole and short run of each run of the report. */
  private readonly firsts: { whole?: Answer; short?: Answer }[];
  private before: Answer | null = null;
  private settled: { answer: Answer; key: string } | null = null;
  private worker: Worker | null = null;
  private readonly loaded = new Set<number>();
  private asked = 0;
  private since = 0;
  private sent: Values = new Map();
  private took = Infinity;
  private rest = 0;
  private readonly scene?: PathScene;
  /** The error over time. */
  private readonly errors?: Chart;
  private readonly now: SceneRun;
  private readonly then: SceneRun;
  private curves: Curve[] = [];
  private picture: ReturnType<typeof drawChart> | null = null;
  private readonly place: HTMLElement;
  private readonly list: HTMLElement;
  private readonly more: HTMLSelectElement;
  private readonly said: HTMLElement;
  private readonly table: HTMLTableElement;
  private readonly tools: Record<"undo" | "redo" | "reset" | "copy" | "save", HTMLButtonElement>;
  private readonly command: HTMLElement;

  constructor(private readonly host: HTMLElement, private readonly live: LiveLoop, private readonly page: Page, refused: string) {
    this.scene = page.pictures.find(picture => picture.kind === "PathScene") as PathScene | undefined;
    this.errors = page.pictures.find(picture => picture.key === "error-time") as Chart | undefined;
    const used = this.scene?.runs.map(run => run.colour) ?? [], colour = COLOURS.find(one => !used.includes(one)) ?? COLOURS[0];
    [this.then, this.now] = [[BEFORE, GREY], [NOW, colour]].map(([name, paint]) => ({ kind: "SceneRun", name, colour: paint, ...this.drawn(null) }));
    this.firsts = live.runs.map(() => ({}));
    ghosts.add(this.then);
    const top = add(host, "div", "cl-tools"), which = add(top, "select");
    live.runs.forEach((run, i) => which.add(new Option(run.name, String(i))));
    which.setAttribute("aria-label", "Run");
    which.hidden = live.runs.length === 1;
    which.addEventListener("change", () => this.take(Number(which.value)));
    const button = (text: string, act: () => void): HTMLButtonElement => {
      const made = add(host, "button", "", text);
      made.type = "button";
      made.addEventListener("click", act);
      return made;
    };
    this.tools = {
      undo: button("Undo", () => this.step(-1)), redo: button("Redo", () => this.step(1)), reset: button("Reset", () => this.set(new Map())),
      copy: button("Copy the command line", () => void this.copy()), save: button("Save as controller file", () => this.save()),
    };
    this.more = add(top, "select");
    this.more.setAttribute("aria-label", "More parameters");
    this.more.addEventListener("change", () => this.show(this.more.value));
    top.append(this.tools.undo, this.tools.redo, this.tools.reset);
    this.list = add(host, "div", "live-rows");
    this.said = add(host, "p", "live-said");
    this.said.setAttribute("aria-live", "polite");
    const sides = add(host, "div", "cl-sides");
    this.place = add(sides, "div");
    this.table = add(add(sides, "div", "scroll"), "table", "figures slim tight live-table");
    add(host, "div", "cl-tools").append(this.tools.copy, this.tools.save);
    this.command = add(add(host, "pre", "command"), "code");
    if (refused) add(host, "p", "note", refused);
    host.addEventListener("keydown", this.key);
    ["pointerenter", "focusin"].forEach(kind => host.addEventListener(kind, () => this.load(), { once: true }));
    const worst = live.runs.map(run => Math.max(0, ...(this.scene?.runs.find(one => one.name === run.name)?.worst.map(place => place.size) ?? [])));
    which.value = String(worst.indexOf(Math.max(...worst)));
    this.take(Number(which.value));
  }

  resize(): void { this.picture?.resize(); }

  destroy(): void {
    this.worker?.terminate();
    this.picture?.destroy();
    clearTimeout(this.rest);
    this.host.removeEventListener("keydown", this.key);
    this.host.replaceChildren();
  }

  // --- parameters ----------------------------------------------------------------------------------------------------------------------

  /** Take a run of the report. */
  private take(r: number): void {
    this.r = r;
    this.rows = [];
    this.list.replaceChildren();
    [this.values, this.past, this.at] = [new Map(), [new Map()], 0];
    [this.before, this.settled] = [null, null];
    this.asked += 1;  // answers on their way are about earlier values
    this.since = this.asked;
    const { parameters } = this.live.runs[r], families = [...new Set(parameters.map(one => familyOf(one.name)))];
    const sorted = families.sort((a, b) => Number(b.startsWith("controller")) - Number(a.startsWith("controller")));
    this.more.replaceChildren(new Option("more parameters", ""));
    sorted.forEach(family => {
      if (parameters.some(one => one.first && familyOf(one.name) === family)) this.show(family);
      else this.more.add(new Option(inWords(family), family));
    });
    if (this.worker) this.load();
    this.chart();
    this.refresh();
  }

  /** Draw the error of the run, and room for that of other values, around the worst place. */
  private chart(): void {
    const { name, short, motion: { period } } = this.live.runs[this.r], none = numbers(new Float64Array(0));
    this.picture?.destroy();
    if (!this.errors) return;
    const curve = (looks: Partial<Curve>): Curve => ({ kind: "Curve", x: none, y: none, name: "", colour: GREY, dash: "solid", width: 1.3, half: null, numbers: null, ...looks });
    const [panel] = this.errors.panels, base = panel.curves.find(one => one.name === name);
    this.curves = [{ ...base, dash: "dash" }, { name: BEFORE, dash: "dot" }, { name: NOW, colour: this.now.colour, width: 2 }].map(curve);
    this.picture = drawChart(this.place, { ...this.errors, panel_height: 170, panels: [{ ...panel, curves: this.curves }] });
    this.picture.zoom([short[0] * period, short[1] * period]);
  }

  /** Add the row of a family. */
  private show(family: string): void {
    const members = this.live.runs[this.r].parameters.filter(one => familyOf(one.name) === family), title = inWords(family);
    if (!members.length) return;
    const line = add(this.list, "div", "live-row"), name = add(line, "span", "live-name", title), slider = add(line, "input"), field = add(line, "input");
    const row: Row = { title, members, taken: members, slider, field, unit: add(line, "span", "live-unit") };
    name.title = members.map(one => one.name).join("\n");
    if (members.length > 1) {
      const axis = add(name, "select");
      ["all axes", ...members.map(one => axisOf(one.name))].forEach((text, i) => axis.add(new Option(text, String(i))));
      axis.setAttribute("aria-label", `Axes of ${title}`);
      axis.addEventListener("change", () => {
        row.taken = axis.value === "0" ? members : [members[Number(axis.value) - 1]];
        this.refresh();
      });
    }
    Object.assign(slider, { type: "range", min: "-1", max: "1", step: "0.01", ariaLabel: title });
    Object.assign(field, { type: "number", step: "any", ariaLabel: `${title}, value` });
    slider.addEventListener("input", () => this.change(row, base => Number((base * 10 ** Number(slider.value)).toPrecision(3)), Number(slider.value) === 0));
    field.addEventListener("change", () => {
      const given = field.valueAsNumber;
      if (Number.isFinite(given)) this.change(row, (base, { factor }) => (this.isEqual(row) ? given / factor : base * given));
    });
    this.rows.push(row);
    [...this.more.options].find(option => option.value === family)?.remove();
    this.more.value = "";
    this.refresh();
  }

  private baseOf = (one: LiveParameter): number => one.value ?? Infinity;
  private valueOf = (one: LiveParameter): number => this.values.get(one.name) ?? this.baseOf(one);
  /** Whether the parameters that a row changes had one value; else it shows a factor. */
  private isEqual = ({ taken }: Row): boolean => taken.every(one => this.baseOf(one) === this.baseOf(taken[0]));

  private change(row: Row, made: (base: number, one: LiveParameter) => number, isBase = false): void {
    for (const one of row.taken) {
      const base = this.baseOf(one), value = isBase ? base : made(base, one), whole = one.whole ? Math.round(value) : value;
      if (whole === base) this.values.delete(one.name); else this.values.set(one.name, whole);
    }
    this.touched(row);
  }

  private set(values: Values): void {
    this.values = new Map(values);
    this.touched();
  }

  private step(by: number): void {
    if (!this.past[this.at + by]) return;
    this.at += by;
    this.set(this.past[this.at]);
  }

  private readonly key = (event: KeyboardEvent): void => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || !"zy".includes(key)) return;
    event.preventDefault();
    this.step(key === "y" || event.shiftKey ? 1 : -1);
  };

  /** Write the values in their rows; the slider in hand stays where it is. */
  private refresh(inHand?: Row): void {
    for (const row of this.rows) {
      const [one] = row.taken, base = this.baseOf(one), value = this.valueOf(one), isEqual = this.isEqual(row), share = value / base;
      row.slider.disabled = !Number.isFinite(base) || base === 0;
      if (row !== inHand) row.slider.value = String(Math.log10(share > 0 ? share : 1));
      row.field.value = Number.isFinite(value) ? String(Number((isEqual ? value * one.factor : share).toPrecision(5))) : "";
      row.unit.textContent = isEqual ? one.display : "times";
      row.slider.ariaValueText = `${row.field.value} ${row.unit.textContent}`;
    }
    const changed = this.changed(), { undo, redo, reset, save } = this.tools;
    [undo.disabled, redo.disabled, reset.disabled] = [this.at === 0, this.at + 1 >= this.past.length, !changed.length];
    save.hidden = !this.live.runs[this.r].controller;
    const inMachine = changed.some(([one]) => !one.name.startsWith("controller."));
    save.title = inMachine ? "Values of the machine are not in it: they are in the command line." : "";
    this.command.textContent = this.commandLine();
    this.host.classList.toggle("live-same", !changed.length);
  }

  private changed(): [LiveParameter, number][] {
    return this.live.runs[this.r].parameters.filter(one => this.values.has(one.name)).map(one => [one, this.values.get(one.name)!]);
  }

  // --- the worker ----------------------------------------------------------------------------------------------------------------------

  private load(): void {
    if (!this.worker) {
      const address = URL.createObjectURL(new Blob([script], { type: "text/javascript" }));
      this.worker = new Worker(address);
      this.worker.addEventListener("message", ({ data }: MessageEvent<Answer>) => this.answered(data));
      this.worker.addEventListener("error", event => this.say(`The loop cannot run here: ${event.message}.`));
      URL.revokeObjectURL(address);
    }
    if (!this.loaded.has(this.r)) this.worker.postMessage({ run: this.r, loop: this.live.runs[this.r] });
    this.loaded.add(this.r);
  }

  private touched(inHand?: Row): void {
    this.refresh(inHand);
    const beyond = this.changed().map(([one, value]) => this.beyond(one, value)).find(Boolean);
    clearTimeout(this.rest);
    if (beyond) return this.say(`Not possible: ${beyond}.`);
    if (!this.worker) this.load();
    this.ask(this.took > QUICK);
  }

  private ask(short: boolean): void {
    const { parameters } = this.live.runs[this.r], words = new Map(parameters.map(one => [one.name, one.word]));
    this.sent = new Map(this.values);
    this.asked += 1;
    this.worker!.postMessage({ id: this.asked, run: this.r, values: [...this.values].map(([name, value]) => [words.get(name)!, value]), short } satisfies Ask);
  }

  /** Say which bound a value is beyond. */
  private beyond(one: LiveParameter, value: number): string {
    const text = (edge: number): string => figure(edge * one.factor, one.display), { minimum: low, maximum: high } = one;
    const what = `${inWords(one.name)} ${axisOf(one.name)} = ${text(value)}`;
    if (low !== null && (value < low || (one.exclusive && value === low))) return `${what} must be ${one.exclusive ? "more than" : "at least"} ${text(low)}`;
    return high !== null && value > high ? `${what} must be at most ${text(high)}` : "";
  }

  private answered(answer: Answer): void {
    const { short, points, failed } = answer, { period } = this.live.runs[this.r].motion;
    if (!answer.id) {
      this.firsts[answer.run][short ? "short" : "whole"] = answer;
      return answer.run === this.r ? this.draw(null) : undefined;
    }
    if (answer.id <= this.since) return;
    const isLast = answer.id === this.asked;
    if (isLast && short) this.rest = window.setTimeout(() => this.ask(false), REST);
    if (!points) {
      const at = failed === null ? "" : figure(failed * period, "s", 5);
      return this.say(failed === null ? "Not possible: these values do not fit together." : `The loop runs away at ${at}. The picture is that of the settings before.`);
    }
    if (isLast && !short) this.settle(answer);
    this.draw(answer);
  }

  /** The whole part has followed: one more step that can be undone. */
  private settle(answer: Answer): void {
    const key = keyOf(this.sent);
    this.took = answer.took;
    this.settled ??= { answer: this.firsts[this.r].whole!, key: keyOf(new Map()) };
    if (this.settled.key !== key) this.before = this.settled.answer;
    this.settled = { answer, key };
    if (keyOf(this.past[this.at]) === key) return;
    this.past = [...this.past.slice(0, this.at + 1), this.sent];
    this.at += 1;
    this.refresh();
  }

  // --- what is drawn -------------------------------------------------------------------------------------------------------------------

  /** Draw an answer beside the run of the report and the settings before. */
  private draw(answer: Answer | null): void {
    [this.firsts[this.r].whole, this.before, answer].forEach((one, i) => {
      if (one?.points && this.curves[i]) Object.assign(this.curves[i], { x: numbers(one.points.time), y: numbers(one.points.signed) });
    });
    this.picture?.update?.();
    this.figures(answer);
    if (!answer) return;
    const { scene } = this, base = scene?.runs.find(run => run.name === this.live.runs[this.r].name);
    Object.assign(this.now, this.drawn(answer.points, base));
    if (this.before) Object.assign(this.then, this.drawn(this.before.points, base));
    if (scene) {
      if (!scene.runs.includes(this.now)) scene.runs.push(this.then, this.now);
      if (base) ghosts.add(base);
      this.page.changed(scene);
    }
  }

  /** Return the points of an answer as those of a run in space. */
  private drawn(points: Points | null, base?: SceneRun): Pick<SceneRun, "foot" | "error" | "size" | "time" | "feedrate" | "lines" | "stretch" | "worst"> {
    const none = new Float32Array(0), n = points?.time.length ?? 0, names = [...new Set(this.live.runs[this.r].parameters.map(one => axisOf(one.name)))];
    const wide = names.filter(Boolean).length, columns = (this.scene?.axes ?? []).map(name => names.indexOf(name));
    const spread = (values: Float32Array): Numbers => {
      const out = new Float32Array(3 * n);
      for (let i = 0; i < n; i += 1) columns.forEach((column, j) => { out[3 * i + j] = values[wide * i + column]; });
      return numbers(out, 3);
    };
    const lines = Int32Array.from(points?.time ?? [], time => lineAt(base, time));
    const foot = spread(points?.foot ?? none), error = spread(points?.error ?? none), at = points ? worstOf(points) : -1;
    const three = ({ values }: Numbers): number[] => [...values.subarray(3 * at, 3 * at + 3)];
    const worst: SceneRun["worst"] = at < 0 ? [] : [
      { kind: "Place", foot: three(foot), error: three(error), size: points!.size[at], time: points!.time[at], line: lines[at], cause: "" }];
    return {
      foot, error, lines: numbers(lines), worst, size: numbers(points?.size ?? none), time: numbers(points?.time ?? none),
      feedrate: numbers(points?.feedrate ?? none), stretch: numbers(points?.stretch ?? new Int32Array(0)),
    };
  }

  /** Write the table of figures; without an answer, those of the report's run. */
  private figures(answer: Answer | null): void {
    const short = answer?.short ?? false, first = this.firsts[this.r][short ? "short" : "whole"], { motion: { period }, short: [from, to] } = this.live.runs[this.r];
    if (!first) return;
    const base = this.scene?.runs.find(run => run.name === this.live.runs[this.r].name);
    const tolerance = this.scene?.tolerance ?? this.errors?.panels[0].band?.[1] ?? null;
    const given: [string, Answer | null][] = [["report", first], ["before", short ? null : this.before], ["now", answer]];
    const columns = given.filter((one): one is [string, Answer] => one[1] !== null);
    const table = document.createElement("tbody"), head = add(this.table.tHead ?? this.table.createTHead(), "tr");
    this.table.tHead!.replaceChildren(head);
    for (const text of ["", ...columns.map(([name]) => name)]) add(head, "th", "n", text).scope = "col";
    const row = (text: string, write: (one: Answer, cell: HTMLElement) => void): void => {
      const line = add(table, "tr");
      add(line, "th", "", text).scope = "row";
      columns.forEach(([, one]) => write(one, add(line, "td", "n")));
    };
    if (tolerance !== null) row(`tolerance ${figure(tolerance, "um")}`, (one, cell) => {
      const isGood = one.figures.part_error_max * 1e6 <= tolerance;
      cell.className = isGood ? "n" : "n poor";
      add(cell, "span", "seal", isGood ? "PASS" : "FAIL");
    });
    for (const [name, label, factor, unit] of FIGURES) {
      if (name in first.figures) row(label, (one, cell) => { cell.textContent = figure(one.figures[name] * factor, unit); });
    }
    row("worst place", (one, cell) => {
      const time = one.points!.time[worstOf(one.points!)], line = lineAt(base, time);
      cell.textContent = figure(time, "s", 5) + (line ? `, line ${line}` : "");
    });
    this.table.tBodies[0]?.remove();
    this.table.append(table);
    if (!answer) return;
    const where = short ? `Short run, from ${figure(from * period, "s", 5)} to ${figure(to * period, "s", 5)}, begun with the state of the report at ${figure(answer.begun * period, "s", 5)}` : "Whole part";
    const [was, is] = [first, answer].map(one => figure(one.figures.part_error_max * 1e6, "um"));
    this.say(`${where}: largest part error ${is}, in the report ${was}.`);
  }

  private say(text: string): void { this.said.textContent = text; }

  // --- what leaves the page ------------------------------------------------------------------------------------------------------------

  private commandLine(): string {
    return [this.live.command, ...this.changed().map(([one, value]) => `--set ${one.name}=${value}`)].join(" ");
  }

  private async copy(): Promise<void> {
    try {
      await navigator.clipboard.writeText(this.commandLine());
      this.tools.copy.textContent = "Copied";
    } catch {
      getSelection()?.selectAllChildren(this.command);
      this.tools.copy.textContent = "Selected: press Ctrl-C";
    }
    setTimeout(() => { this.tools.copy.textContent = "Copy the command line"; }, 2000);
  }

  private save(): void {
    const { controller, parameters } = this.live.runs[this.r], known = new Map(parameters.map(one => [one.name, this.valueOf(one)]));
    const text = controller.replace(/"@([^"]+)@"/g, (_, name) => { const value = known.get(name)!; return Number.isFinite(value) ? String(value) : "inf"; });
    const link = add(this.host, "a"), address = URL.createObjectURL(new Blob([text], { type: "application/toml" }));
    Object.assign(link, { href: address, download: "controller.toml" }).click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(address), 1000);
  }
}

/** Return the point with the largest error. */
function worstOf({ size, stretch }: Points): number {
  let worst = 0;
  size.forEach((value, i) => { if (stretch[i] && (value > size[worst] || !stretch[worst])) worst = i; });
  return worst;
}

/** Return the line of the program at a time of the report's run. */
function lineAt(run: SceneRun | undefined, time: number): number {
  if (!run) return 0;
  const times = run.time.values;
  let from = 0, to = times.length - 1;
  while (to - from > 1) {
    const middle = (from + to) >> 1;
    if (times[middle] <= time) from = middle; else to = middle;
  }
  return run.lines.values[time - times[from] < times[to] - time ? from : to] ?? 0;
}
