/** Runs loops of a report in a worker: the newest question counts, older ones are dropped. */
import { indexBefore } from "./base";
import type { LivePath, LiveRun } from "./contract";

/** Run loop `run` with values in some words; `short`: around the worst place only. */
export interface Ask { id: number; run: number; values: [number, number][]; short: boolean }

/** Points of a run [s, um, mm, mm/min], thinned; the largest errors stay. In stretch 0 nothing is judged. */
export interface Points {
  time: Float64Array; signed: Float32Array; size: Float32Array; stretch: Int32Array; foot: Float32Array; error: Float32Array; feedrate: Float32Array;
}

/**
 * What came out: figures [SI], the first tick that ran, and the time that it took [ms]. Without points the values are not possible, or the
 * loop failed at a tick. Id 0: the run of the report.
 */
export interface Answer {
  id: number; run: number; short: boolean; begun: number; took: number; failed: number | null; figures: Record<string, number>; points: Points | null;
}

/** A short run begins this much earlier [s]: an axis that stands before the worst place comes there with the new values. */
const LEAD = 2;
const CHUNK = 1 << 13, BINS = 4000;
/** Parts of a window in which the nearest point is searched, and a length that counts as none [m]. */
const PARTS = 12, INSIDE = 1e-12;
/** Least window of the judge [m]. */
const MARGIN = 1e-4;

/** Return a function that writes the position of each axis at an arc length, then its first and second derivatives. */
function along({ start, coefficients, closed }: LivePath, axes: number): (s: number, out: Float64Array) => void {
  const at = start.values, c = coefficients.values, last = at.length - 2, length = at[last + 1];
  let piece = 0;
  return (s, out) => {
    if (closed) s -= length * Math.floor(s / length);
    while (piece < last && s >= at[piece + 1]) piece += 1;
    while (piece > 0 && s < at[piece]) piece -= 1;
    const x = s - at[piece];
    for (let j = 0, k = 6 * axes * piece; j < axes; j += 1, k += 6) {
      out[j] = c[k] + x * (c[k + 1] + x * (c[k + 2] + x * (c[k + 3] + x * (c[k + 4] + x * c[k + 5]))));
      out[axes + j] = c[k + 1] + x * (2 * c[k + 2] + x * (3 * c[k + 3] + x * (4 * c[k + 4] + x * 5 * c[k + 5])));
      out[2 * axes + j] = 2 * c[k + 2] + x * (6 * c[k + 3] + x * (12 * c[k + 4] + x * 20 * c[k + 5]));
    }
  };
}

/**
 * Return a function that finds the point of a path nearest to a tool between two arc lengths: its arc length, and the distance, in the plane
 * positive to the left.
 */
function nearestOn(path: LivePath, axes: number): (tool: number[], low: number, high: number) => [number, number] {
  const on = along(path, axes), at = path.start.values, length = at[at.length - 1], out = new Float64Array(3 * axes);
  return (tool, low, high) => {
    let best = Infinity, found = low, side = 1, slope = 0, bend = 0;
    const look = (s: number): void => {
      on(s, out);
      let square = slope = bend = 0;
      for (let j = 0; j < axes; j += 1) {
        const gap = out[j] - tool[j], v = out[axes + j];
        square += gap * gap;
        slope += gap * v;
        bend += v * v + gap * out[2 * axes + j];
      }
      if (square < best) [best, found, side] = [square, s, axes === 2 && out[3] * (tool[0] - out[0]) > out[2] * (tool[1] - out[1]) ? -1 : 1];
    };
    // Between two of these places the path has no corner, and the distance at most one valley.
    const places = Array.from({ length: PARTS + 1 }, (_, i) => low + ((high - low) * i) / PARTS);
    for (let lap = path.closed ? length * Math.floor(low / length) : 0; lap < high; lap += length) {
      for (let i = 1 + indexBefore(at, low - lap); i < at.length && lap + at[i] < high; i += 1) if (lap + at[i] > low) places.push(lap + at[i]);
    }
    places.sort((a, b) => a - b).slice(1).forEach((end, i) => {
      let a = places[i], b = Math.max(a, end - INSIDE);
      look(a);
      const falls = slope < 0;
      look(b);
      for (let s = b, step = 1; falls && slope !== 0 && (s < b || slope > 0) && Math.abs(step) > INSIDE;) {
        if (slope < 0) a = s; else b = s;
        const next = s - slope / bend, to = next > a && next < b ? next : (a + b) / 2;
        step = to - s;
        s = to;
        look(s);
      }
    });
    return [found, side * Math.sqrt(best)];
  };
}

/** A loop in its memory. */
class Live {
  private readonly memory: Float64Array;
  private readonly loop: { run(first: number, count: number): void; prepare(): number; judge(): void };
  private readonly rest: Float64Array[];
  private readonly early: number;
  private atEarly: Float64Array[] = [];

  constructor(private readonly given: LiveRun) {
    const memory = new WebAssembly.Memory({ initial: Math.ceil(given.n_word / 8192) });
    const instance = new WebAssembly.Instance(new WebAssembly.Module(given.code.values as Uint8Array<ArrayBuffer>), { env: { memory } });
    this.memory = new Float64Array(memory.buffer);
    this.loop = instance.exports as unknown as Live["loop"];
    this.early = Math.max(0, given.short[0] - Math.round(LEAD / given.motion.period));
    given.words.forEach(([at, { values }]) => this.memory.set(values, at));
    this.plan();
    this.rest = this.state();
  }

  /** Make the inputs from the motion. */
  private plan(): void {
    const { memory, given: { motion: { period, n_sample: n, spans, duration, length, path }, inputs, ahead, position } } = this;
    const axes = position.length, many = spans.shape[1], [t0, s0, v0, a0, jerk] = [0, 1, 2, 3, 4].map(i => spans.values.subarray(i * many, (i + 1) * many));
    const on = along(path, axes), out = new Float64Array(3 * axes), row = (i: number): number => inputs + n * i;
    for (let k = 0, i = 0; k < n; k += 1) {
      while (i + 1 < many && k * period >= t0[i + 1]) i += 1;
      const moves = k * period < duration, dt = k * period - t0[i], v = moves ? v0[i] + dt * (a0[i] + (dt * jerk[i]) / 2) : 0;
      const s = moves ? s0[i] + dt * (v0[i] + dt * (a0[i] / 2 + (dt * jerk[i]) / 6)) : length, a = moves ? a0[i] + dt * jerk[i] : 0;
      on(s, out);
      for (let j = 0; j < axes; j += 1) {
        memory[row(j) + k] = out[j];
        memory[row(axes + j) + k] = out[axes + j] * v;
        memory[row(2 * axes + j) + k] = out[2 * axes + j] * v * v + out[axes + j] * a;
      }
      memory[row(3 * axes) + k] = s;
      memory[row(3 * axes + 1) + k] = v;
    }
    ahead.forEach((ticks, j) => {
      for (let k = 0; k < n; k += 1) memory[row(3 * axes + 2 + j) + k] = memory[row(j) + Math.min(k + ticks, n - 1)];
    });
  }

  private state(): Float64Array[] { return this.given.state.map(([from, to]) => this.memory.slice(from, to)); }

  private restore(parts: Float64Array[]): void { this.given.state.forEach(([from], i) => this.memory.set(parts[i], from)); }

  /** Take values and the state of rest; return whether the values are possible. */
  private begin(values: [number, number][]): boolean {
    this.restore(this.rest);
    this.given.parameters.forEach(({ word, value }) => { this.memory[word] = value ?? Infinity; });
    values.forEach(([word, value]) => { this.memory[word] = value; });
    return this.loop.prepare() !== 0;
  }

  /** Return the answers for the report's own values, and keep the state at the begin of short runs. */
  first(run: number): Answer[] {
    const { early, given: { motion } } = this, from = performance.now();
    this.begin([]);
    this.loop.run(0, early);
    this.atEarly = this.state();
    this.loop.run(early, motion.n_sample - early);
    return [false, true].map(short => this.found({ id: 0, run, values: [], short }, from));
  }

  /** Answer a question; null if it is dropped. */
  async answer(ask: Ask, dropped: () => Promise<boolean>): Promise<Answer | null> {
    const { loop, early, given: { short, motion } } = this, [begun, stop] = ask.short ? [early, short[1]] : [0, motion.n_sample], from = performance.now();
    if (!this.begin(ask.values)) return this.none(ask);
    if (ask.short) this.restore(this.atEarly);
    for (let k = begun; k < stop; k += CHUNK) {
      loop.run(k, Math.min(CHUNK, stop - k));
      if (!ask.short && (await dropped())) return null;
    }
    return this.found(ask, from);
  }

  private none = ({ id, run, short }: Ask): Answer =>
    ({ id, run, short, begun: short ? this.early : 0, took: 0, failed: null, figures: {}, points: null });

  private found(ask: Ask, from: number): Answer {
    const { memory, loop, given: { short, motion, failed_at } } = this, none = this.none(ask);
    if (memory[failed_at] >= 0) return { ...none, failed: memory[failed_at] };
    const [first, stop] = ask.short ? short : [0, motion.n_sample];
    if (!ask.short) loop.judge();
    this.decide(first, stop);
    const whole = ask.short ? [] : this.given.figures.map(([name, word]) => [name, memory[word]]);
    const figures = { ...Object.fromEntries(whole), ...this.around(first, stop) };
    return { ...none, figures, points: this.points(first, stop), took: performance.now() - from };
  }

  private logged = (k: number, column: number): number => this.memory[this.given.log + k * this.given.n_log + column];

  /** Judge some ticks in doubt as the report's judge does: by the nearest point in a window around the place of the reference. */
  private decide(first: number, stop: number): void {
    const { memory, early, given: { asked, doubt, part_error, foot, place, planning, position, inputs, log, n_log, motion: { n_sample: n }, judged } } = this;
    const nearest = nearestOn(asked, position.length), length = asked.start.values.at(-1)!;
    let error = 0;
    for (let k = first ? early : 0; k < stop; k += 1) {
      error = Math.max(error, position.reduce((sum, column, j) => sum + (memory[inputs + n * j + k] - this.logged(k, column)) ** 2, 0));
    }
    const reach = 3 * Math.sqrt(error) + MARGIN, window = (asked.closed ? Math.min(reach, length / 2) : reach) + planning;
    for (const [from, to] of judged) for (let k = Math.max(from, first); k < Math.min(to, stop); k += 1) {
      if (!this.logged(k, doubt)) continue;
      const at = memory[place + k], [low, high] = asked.closed ? [at - window, at + window] : [Math.max(0, at - window), Math.min(length, at + window)];
      [memory[log + k * n_log + foot], memory[log + k * n_log + part_error]] = nearest(position.map(column => this.logged(k, column)), low, high);
    }
  }

  /** Return figures of some ticks. */
  private around(first: number, stop: number): Record<string, number> {
    const { part_error, judged } = this.given;
    let count = 0, square = 0, largest = 0;
    for (const [from, to] of judged) for (let k = Math.max(from, first); k < Math.min(to, stop); k += 1) {
      const size = Math.abs(this.logged(k, part_error));
      count += 1;
      square += size * size;
      largest = Math.max(largest, size);
    }
    return { part_error_max: largest, part_error_rms: Math.sqrt(square / (count || 1)) };
  }

  /** Return the ticks to draw, with their stretches: of each bin the first tick, and the one with the largest error. */
  private kept(first: number, stop: number): [number, number][] {
    const { judged, part_error } = this.given, begin = Math.max(first, judged[0][0]), end = Math.min(stop, judged.at(-1)![1]), kept: [number, number][] = [];
    const bin = Math.max(1, Math.ceil((end - begin) / BINS)), size = (k: number): number => Math.abs(this.logged(k, part_error));
    const take = (from: number, to: number, stretch: number): void => {
      for (let k = from; k < to; k += bin) {
        let most = k;
        for (let q = k + 1; stretch && q < Math.min(k + bin, to); q += 1) if (size(q) > size(most)) most = q;
        kept.push([k, stretch]);
        if (most !== k) kept.push([most, stretch]);
      }
      if (to > from && kept.at(-1)![0] !== to - 1) kept.push([to - 1, stretch]);
    };
    judged.forEach(([from, to], i) => {
      take(Math.max(begin, i ? judged[i - 1][1] : begin), Math.min(from, end), 0);
      take(Math.max(begin, from), Math.min(to, end), i + 1);
    });
    return kept;
  }

  private points(first: number, stop: number): Points {
    const { part_error, foot, position, asked, motion, inputs } = this.given, kept = this.kept(first, stop), n = kept.length, axes = position.length;
    const on = along(asked, axes), out = new Float64Array(3 * axes), speed = inputs + (3 * axes + 1) * motion.n_sample;
    const made: Points = {
      time: new Float64Array(n), signed: new Float32Array(n), size: new Float32Array(n), stretch: Int32Array.from(kept, ([, stretch]) => stretch),
      foot: new Float32Array(axes * n), error: new Float32Array(axes * n), feedrate: new Float32Array(n),
    };
    kept.forEach(([k, stretch], i) => {
      const tool = position.map(column => this.logged(k, column));
      if (stretch) on(this.logged(k, foot), out); else out.set(tool);
      made.time[i] = k * motion.period;
      made.feedrate[i] = this.memory[speed + k] * 6e4;
      made.signed[i] = stretch ? this.logged(k, part_error) * 1e6 : NaN;
      made.size[i] = stretch ? Math.abs(made.signed[i]) : 0;
      tool.forEach((value, j) => { made.foot[axes * i + j] = out[j] * 1e3; made.error[axes * i + j] = (value - out[j]) * 1e6; });
    });
    return made;
  }
}

const loops: Live[] = [], channel = new MessageChannel();
let latest: Ask | null = null, works = false;

/** Let messages in, and return whether there is a newer question. */
const newer = (): Promise<boolean> => new Promise(done => {
  channel.port1.onmessage = () => done(latest !== null);
  channel.port2.postMessage(0);
});
const send = (answer: Answer): void => postMessage(answer, { transfer: Object.values(answer.points ?? {}).map(values => values.buffer) });

async function work(): Promise<void> {
  works = true;
  while (latest) {
    const ask: Ask = latest;
    latest = null;
    const answer = await loops[ask.run].answer(ask, newer);
    if (answer) send(answer);
  }
  works = false;
}

/** A message is a question, or the number of a loop, and the loop. */
addEventListener("message", ({ data }: MessageEvent<Ask | { run: number; loop: LiveRun }>) => {
  if ("loop" in data) return (loops[data.run] = new Live(data.loop)).first(data.run).forEach(send);
  latest = data;
  if (!works) void work();
});
