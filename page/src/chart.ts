/** Curves: panels under one another that zoom and point together (uPlot draws axes and keeps the scales; the curves are our own paths). */
import uPlot from "uplot";
import type { Chart, Curve, Panel } from "./contract";
import {
  add, coloursOf, DASHES, figure, FONT, isPaper, legend, nameOf, Tip, unitOf, visible, widthOf, type Colours, type Drawing, type Entry,
} from "./base";

const GLYPHS: Record<string, string> = { reversal: "▲", corner: "◆", "first zero": "●", "curvature step": "▼", peak: "▲" };
const HEIGHT = { alone: 250, each: 170, paper: 120, axis: 40, gap: 8 };
type Range = [number, number];

export function drawChart(host: HTMLElement, chart: Chart): Drawing & { zoom(range?: Range): void } {
  return new Chartist(host, chart);
}

class Chartist implements Drawing {
  range: Range;
  readonly whole: Range;
  readonly hidden = new Set<string>();
  private views: View[] = [];
  private readonly body: HTMLElement;

  constructor(private readonly host: HTMLElement, readonly chart: Chart) {
    this.whole = this.range = spanOf(chart);
    host.tabIndex = 0;
    host.addEventListener("keydown", this.key);
    this.body = add(host, "div");
    this.resize();
  }

  resize(): void {
    this.views.forEach(view => view.plot.destroy());
    this.body.replaceChildren();
    const colours = coloursOf(this.host), { panels } = this.chart;
    const entries: Entry[] = panels.flatMap(panel => panel.curves.map(curve => ({
      name: curve.name, dash: curve.dash, colour: visible(curve.colour, colours.card), glyph: curve.half ? "●" : undefined,
    })));
    const marks = panels.flatMap(panel => panel.ticks.map(tick => ({ name: tick.mark, dash: "", colour: colours.muted, glyph: GLYPHS[tick.mark] })));
    const row = legend(this.body, [...entries, ...marks], this.hidden, () => this.update());
    entries.filter(entry => entry.glyph).forEach(entry => {
      const button = [...row.children].find(child => child.lastChild!.textContent === entry.name);
      (button!.firstChild as HTMLElement).style.color = entry.colour;
    });
    const texts = panels.flatMap(panel => panel.y_ticks.map(([, text]) => text.length));
    const gutter = Math.max(58, 7 * Math.max(0, ...texts) + 14);
    this.views = panels.map((panel, i) => new View(this, panel, this.body, colours, gutter, i === panels.length - 1));
  }

  /** Show a range of x; without one, all. */
  zoom(range: Range = this.whole): void {
    const log = this.chart.panels[0].log_x, [low, high] = range;
    const least = log ? (high / low > 1.0001) : (high - low > 1e-9 * (this.whole[1] - this.whole[0]));
    if (least) this.range = [Math.max(low, this.whole[0]), Math.min(high, this.whole[1])];
    this.update();
  }

  update(): void { this.views.forEach(view => view.plot.redraw()); }

  /** Move the pointer of all panels to a value of x; null takes it away. */
  point(x: number | null, from?: View): void {
    this.views.forEach(view => {
      if (view !== from) view.moved(x);
    });
  }

  destroy(): void {
    this.views.forEach(view => view.plot.destroy());
    this.host.removeEventListener("keydown", this.key);
    this.host.replaceChildren();
  }

  /** Arrows move the pointer; plus, minus and 0 zoom. */
  private readonly key = (event: KeyboardEvent): void => {
    const log = this.chart.panels[0].log_x, to = log ? Math.log : (v: number) => v, back = log ? Math.exp : (v: number) => v;
    const [low, high] = this.range.map(to) as Range, at = to(this.views[0].at ?? back((low + high) / 2));
    const step = { ArrowLeft: -0.01, ArrowRight: 0.01 }[event.key], factor = { "+": 0.5, "-": 2 }[event.key];
    if (step) this.point(back(Math.min(Math.max(at + step * (high - low), low), high)));
    else if (factor) this.zoom([back(at - factor * (at - low)), back(at + factor * (high - at))]);
    else if (event.key === "0" || event.key === "Escape") this.zoom();
    else return;
    event.preventDefault();
  };
}

/** Return the range of x of all curves, with room beside loops and points. */
function spanOf(chart: Chart): Range {
  let low = Infinity, high = -Infinity;
  for (const panel of chart.panels) for (const curve of panel.curves) for (const x of curve.x.values) {
    if (x < low) low = x;
    if (x > high) high = x;
  }
  const log = chart.panels[0].log_x;
  if (low > high) return [log ? 0.1 : 0, 1];
  if (low === high) return log ? [low / 2, low * 2] : [low - 0.5, low + 0.5];
  const room = !log && (chart.loops || chart.panels.some(panel => panel.curves.some(curve => curve.half))) ? 0.015 * (high - low) : 0;
  return [low - room, high + room];
}

/** One panel. */
class View {
  readonly plot: uPlot;
  at: number | null = null;
  private readonly tip: Tip;
  /** On paper everything is twice as large, and shown at half its size: sharp. */
  private readonly scale = isPaper() ? 2 : 1;

  constructor(
    private readonly group: Chartist, private readonly panel: Panel, host: HTMLElement, private readonly colours: Colours, gutter: number,
    last: boolean,
  ) {
    const head = add(host, "div", "cl-head");
    add(head, "b", "", panel.y_label);
    for (const [text, colour] of this.notes()) add(head, "span", "", text).style.color = colour;
    const place = add(host, "div", "cl-panel"), k = this.scale, count = group.chart.panels.length;
    const inner = group.chart.panel_height || (count === 1 ? HEIGHT.alone : isPaper() ? HEIGHT.paper : HEIGHT.each);
    place.style.setProperty("zoom", String(1 / k));
    this.tip = new Tip(place);
    const font = `${12 * k}px ${FONT.slice(5)}`;
    const axis: uPlot.Axis = {
      values: (plot, splits, i, _space, step) =>
        splits.map(at => (at === null ? "" : tickText(at, plot.scales[plot.axes[i].scale!].distr === 3 ? at : step))),
      stroke: colours.muted, font, labelFont: font, gap: 5 * k,
      grid: { stroke: colours.line, width: k }, ticks: { stroke: colours.edge, width: k, size: 4 * k }, border: { show: true, stroke: colours.edge, width: k },
    };
    const y = panel.y_ticks;
    this.plot = new uPlot({
      width: widthOf(host.parentElement!) * k,
      height: (inner + (last ? HEIGHT.axis : HEIGHT.gap)) * k,
      padding: [6 * k, 22 * k, 0, 0],
      scales: {
        x: { time: false, distr: panel.log_x ? 3 : 1, range: () => group.range },
        y: { distr: panel.log_y ? 3 : 1, range: () => this.heights() },
      },
      series: [{}, ...panel.curves.map(curve => this.series(curve))],
      axes: [
        { ...axis, ...(panel.log_x ? { splits: logSplits, filter: named } : {}), size: (last ? 24 : HEIGHT.gap) * k, space: 70 * k, ...(last ? { label: panel.x_label, labelSize: 16 * k, labelGap: 0 } : { values: () => [] }) },
        { ...axis, ...(panel.log_y ? { splits: (_plot, _i, low, high) => logSplits(_plot, _i, low, high).filter(at => high < 2e3 * low || isPower(at)) } : {}), size: gutter * k, space: 32 * k, ...(y.length ? { splits: () => y.map(([at]) => at), values: () => y.map(([, text]) => text) } : {}) },
      ],
      legend: { show: false },
      cursor: { y: false, points: { show: false }, drag: { setScale: false, x: true, y: false } },
      hooks: {
        drawAxes: [() => this.shade()],
        draw: [() => this.mark()],
        setCursor: [plot => this.pointed(plot)],
        setSelect: [plot => this.selected(plot)],
      },
    }, [group.whole, ...panel.curves.map(() => [1, 1])], place);
    this.plot.over.addEventListener("dblclick", () => group.zoom());
  }

  private get shown(): Curve[] {
    return this.panel.curves.filter(curve => !this.group.hidden.has(curve.name));
  }

  private notes(): [string, string][] {
    const { band, y_range, levels, far } = this.panel, beyond = ", off scale", notes: [string, string][] = [];
    if (band) notes.push([this.panel.band_label + (y_range && band[1] > y_range[1] ? beyond : ""), this.colours.band]);
    if (this.panel.span) notes.push([this.panel.span_label, this.colours.band]);
    for (const level of levels) if (level.label) notes.push([level.label + (far ? beyond : ""), this.colours.limit]);
    return notes;
  }

  /** Return the range of y that holds the curves within the range of x. */
  private heights(): Range {
    const { y_range, log_y, band, levels, far } = this.panel;
    if (y_range) return y_range;
    const [from, to] = this.group.range;
    let low = Infinity, high = -Infinity;
    const take = (v: number): void => {
      if (!Number.isFinite(v) || (log_y && v <= 0)) return;
      if (v < low) low = v;
      if (v > high) high = v;
    };
    for (const { x, y, half } of this.shown) {
      for (let i = 0; i < x.values.length; i += 1) {
        const inside = x.values[i] >= from && x.values[i] <= to;
        if (!inside && !(i > 0 && x.values[i - 1] < to && x.values[i] > from)) continue;
        take(y.values[i] - (half ? half.values[i] : 0));
        take(y.values[i] + (half ? half.values[i] : 0));
      }
    }
    if (!log_y) for (const edge of band ?? []) take(edge);
    if (!far) for (const level of levels) take(level.value);
    for (const [at] of this.panel.y_ticks) { take(at - 0.5); take(at + 0.5); }
    if (low > high) return log_y ? [1, 10] : [0, 1];
    if (log_y) return [low / 1.3, high * 1.3];
    const room = this.panel.y_ticks.length ? 0 : 0.07 * (high - low || Math.abs(high) || 1);
    return [low - room, high + room];
  }

  private series(curve: Curve): uPlot.Series {
    const colour = visible(curve.colour, this.colours.card), k = this.scale;
    return {
      // A curve that stays where it is shows as a dot.
      cap: curve.dash === "solid" && curve.width < 3 ? "round" : "butt",
      stroke: colour, width: (curve.half ? 1 : curve.width) * k, dash: DASHES[curve.dash].map(v => v * k), points: { show: false },
      fill: curve.half ? colour : undefined,
      paths: plot => this.group.hidden.has(curve.name) ? null : this.path(plot, curve),
    };
  }

  private path(plot: uPlot, { x, y, half, width }: Curve): uPlot.Series.Paths {
    const X = place(plot, "x"), Y = place(plot, "y"), line = new Path2D(), dots = new Path2D();
    const radius = (1.3 + 1.3 * width) * this.scale * uPlot.pxRatio;
    let down = false;
    for (let i = 0; i < x.values.length; i += 1) {
      const at = X(x.values[i]), high = Y(y.values[i]);
      if (!Number.isFinite(at) || !Number.isFinite(high)) { down = false; continue; }
      if (half) {
        dots.moveTo(at + radius, high);
        dots.arc(at, high, radius, 0, 7);
        if (half.values[i] > 0) {
          line.moveTo(at, Y(y.values[i] - half.values[i]));
          line.lineTo(at, Y(y.values[i] + half.values[i]));
        }
      } else {
        if (!down) line.moveTo(at, high);
        line.lineTo(at, high);
      }
      down = true;
    }
    const { left, top, width: w, height } = plot.bbox, clip = new Path2D();
    clip.rect(left, top, w, height);
    return { stroke: line, fill: half ? dots : null, clip } as uPlot.Series.Paths;
  }

  /** Shade tolerance and span below the curves. */
  private shade(): void {
    const { band, span } = this.panel, { ctx } = this.plot, { left, top, width, height } = this.plot.bbox;
    const X = place(this.plot, "x"), Y = place(this.plot, "y");
    ctx.save();
    ctx.beginPath();
    ctx.rect(left, top, width, height);
    ctx.clip();
    ctx.fillStyle = ctx.strokeStyle = this.colours.band;
    ctx.globalAlpha = 0.1;
    if (band) ctx.fillRect(left, Y(band[1]), width, Y(band[0]) - Y(band[1]));
    if (span) ctx.fillRect(X(span[0]), top, X(span[1]) - X(span[0]), height);
    ctx.globalAlpha = 1;
    for (const edge of band ?? []) if (edge !== 0) this.across(Y(edge), DASHES.dot);
    ctx.restore();
  }

  private across(y: number, dash: number[]): void {
    const { ctx, bbox } = this.plot, k = this.scale * uPlot.pxRatio;
    ctx.lineWidth = 1.1 * k;
    ctx.setLineDash(dash.map(v => v * k));
    ctx.beginPath();
    ctx.moveTo(bbox.left, y);
    ctx.lineTo(bbox.left + bbox.width, y);
    ctx.stroke();
    ctx.setLineDash([]);
  }

  /** Draw limits, and marks at the foot of the panel. */
  private mark(): void {
    const { levels, ticks, far } = this.panel, { ctx, bbox } = this.plot, k = this.scale * uPlot.pxRatio;
    const X = place(this.plot, "x"), Y = place(this.plot, "y");
    ctx.save();
    ctx.strokeStyle = this.colours.limit;
    for (const level of far ? [] : levels) {
      const at = Y(level.value);
      if (at >= bbox.top && at <= bbox.top + bbox.height) this.across(at, DASHES.dash);
    }
    ctx.fillStyle = this.colours.muted;
    ctx.font = `${9 * k}px ${FONT.slice(5)}`;
    ctx.textAlign = "center";
    ctx.textBaseline = "bottom";
    for (const tick of ticks) {
      const at = X(tick.x);
      if (at >= bbox.left && at <= bbox.left + bbox.width && !this.group.hidden.has(tick.mark)) {
        ctx.fillText(GLYPHS[tick.mark] ?? "●", at, bbox.top + bbox.height);
      }
    }
    ctx.restore();
  }

  // --- pointer -------------------------------------------------------------------------------------------------------------------------

  private selected(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width < 3) return;
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.group.zoom([plot.posToVal(left, "x"), plot.posToVal(left + width, "x")]);
  }

  /** The reader's own pointer moved. */
  private pointed(plot: uPlot): void {
    if (!plot.cursor.event) return;
    const { left = -1, top = -1 } = plot.cursor;
    this.at = left < 0 ? null : plot.posToVal(left, "x");
    this.tell(left, top);
    this.group.point(this.at, this);
  }

  /** Another panel's pointer moved, or a key was pressed. */
  moved(x: number | null): void {
    this.at = x;
    const left = x === null ? -10 : this.plot.valToPos(x, "x");
    this.plot.setCursor({ left, top: -10 }, false);
    this.tell(left, 8);
  }

  private tell(left: number, top: number): void {
    if (this.at === null) return this.tip.hide();
    const lines = this.group.chart.loops && top !== 8 ? this.nearest(left, top) : this.values(this.at);
    this.tip.show(this.plot.over.offsetLeft + left, this.plot.over.offsetTop + top, lines);
  }

  /** Return the values of the curves at x: those of their nearest points. */
  private values(x: number): [string, string?][] {
    const { x_label, y_label, ticks, y_ticks } = this.panel, { valToPos } = this.plot, lines: [string, string?][] = [];
    const far = (other: number): number => Math.abs(valToPos(other, "x") - valToPos(x, "x"));
    if (this.group.chart.loops) return lines;
    for (const curve of this.shown) {
      const i = closest(curve.x.values, x), value = curve.y.values[i];
      if (i < 0 || !Number.isFinite(value) || far(curve.x.values[i]) > 24) continue;
      const text = y_ticks.length ? "" : ` ${figure(value, unitOf(y_label))}`;
      if (!lines.length) lines.push([figure(curve.x.values[i], unitOf(x_label), 6)]);
      lines.push([curve.name + text, visible(curve.colour, this.colours.card)]);
    }
    const tick = ticks.reduce<Panel["ticks"][0] | null>((best, one) => (far(one.x) < (best ? far(best.x) : 6) ? one : best), null);
    if (tick && lines.length) lines.push([`${GLYPHS[tick.mark] ?? ""} ${tick.label}`]);
    return lines;
  }

  /** Return the point that is nearest on the screen. */
  private nearest(left: number, top: number): [string, string?][] {
    const X = place(this.plot, "x", false), Y = place(this.plot, "y", false);
    let least = 30 ** 2, best: [Curve, number] | null = null;
    for (const curve of this.shown) {
      curve.x.values.forEach((x, i) => {
        const away = (X(x) - left) ** 2 + (Y(curve.y.values[i]) - top) ** 2;
        if (away < least) [least, best] = [away, [curve, i]];
      });
    }
    if (!best) return [];
    const [curve, i] = best as [Curve, number], { x_label, y_label } = this.panel;
    const number = curve.numbers ? ` ${curve.numbers.values[i]}` : "";
    return [
      [curve.name + number, visible(curve.colour, this.colours.card)],
      [`${nameOf(x_label)} ${figure(curve.x.values[i], unitOf(x_label))}`],
      [`${nameOf(y_label)} ${figure(curve.y.values[i], unitOf(y_label))}`],
    ];
  }
}

/** Return a function from values to pixels, of the canvas or of the page: valToPos for many points. */
function place(plot: uPlot, key: "x" | "y", canvas = true): (value: number) => number {
  const { min, max, distr } = plot.scales[key], { bbox } = plot, ratio = canvas ? 1 : uPlot.pxRatio;
  const to = distr === 3 ? Math.log : (v: number) => v, low = to(min!), span = to(max!) - low;
  const size = (key === "x" ? bbox.width : bbox.height) / ratio, start = canvas ? (key === "x" ? bbox.left : bbox.top) : 0;
  return key === "x" ? v => start + (size * (to(v) - low)) / span : v => start + size * (1 - (to(v) - low) / span);
}

/** Return 1 to 9 times each power of ten in a range: uPlot's own begin at its lower end, as in 128, 228, 328. */
function logSplits(_plot: uPlot, _i: number, low: number, high: number): number[] {
  const first = Math.floor(Math.log10(low)), count = 9 * (Math.ceil(Math.log10(high)) - first) + 1;
  const all = Array.from({ length: count }, (_, k) => Number(`${1 + (k % 9)}e${first + Math.floor(k / 9)}`));
  return all.filter(at => at >= low && at <= high);
}

const isPower = (at: number): boolean => at.toExponential()[0] === "1";

/** Keep the powers of ten, and 2 and 5 times them where there is room. */
function named(plot: uPlot, splits: number[]): (number | null)[] {
  const room = Math.abs(plot.valToPos(10, "x") - plot.valToPos(1, "x")), digits = room > 240 ? "125" : "1";
  return splits.map(at => (digits.includes(at.toExponential()[0]) ? at : null));
}

/** Return the text of a tick, with the digits that its distance to the next asks for; a point in every language, as in the tables. */
function tickText(at: number, step: number): string {
  const digits = Math.ceil(-Math.log10(step)) + 1;
  return digits > 7 ? figure(at) : at.toLocaleString("en", { maximumFractionDigits: Math.max(digits, 0) });
}

/** Return the index of the value nearest to x; values ascend, nan in between are skipped. */
function closest(values: ArrayLike<number>, x: number): number {
  let low = 0, high = values.length - 1;
  while (high - low > 1) {
    let middle = (low + high) >> 1;
    while (middle < high && Number.isNaN(values[middle])) middle += 1;
    if (middle === high) { high = (low + high) >> 1; continue; }
    if (values[middle] <= x) low = middle;
    else high = middle;
  }
  if (high < 0) return -1;
  return Math.abs(values[low] - x) <= Math.abs(values[high] - x) ? low : high;
}
