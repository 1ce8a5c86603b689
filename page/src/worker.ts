/** Runs loops of a report in a worker: the newest question counts, older ones are dropped. */
import type { LivePath, LiveRun } from "./contract";

/** Run loop `run` with values in some words; `short`: around the worst place only. */
export interface Ask { id: number; run: number; values: [number, number][]; short: boolean }

/** Points of a run [s, mm, um, mm/min], thinned: each keeps the largest errors around it. Foot points lie on the programmed path; in stretch 0 nothing is judged. */
export interface Points {
  time: Float64Array; signed: Float32Array; size: Float32Array; stretch: Int32Array; foot: Float32Array; error: Float32Array;
  feedrate: Float32Array;
}

/** What came out, in SI, its first tick, and the time that it took [ms]; without points the values are not possible, or the run failed at a tick. Id 0 is the run of the report. */
export interface Answer {
  id: number; run: number; short: boolean; begun: number; took: number; failed: number | null; unsure: number; figures: Record<string, number>; points: Points | null;
}

/** A short run begins so much earlier [s], and is not shown there: an axis that stands before the worst place has come there with the new values. */
const LEAD = 2;
const CHUNK = 1 << 13, BINS = 4000;
type Loop = { memory: Float64Array; run(first: number, count: number): void; prepare(): number; judge(): void };

/** Return a function that sets the derivatives of order 0 to 2 of each axis at an arc length. */
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

/** A loop in its memory. */
class Live {
  private readonly loop: Loop;
  private readonly rest: Float64Array[];
  private worst: Float64Array[] = [];
  private readonly axes: number;

  constructor(private readonly given: LiveRun) {
    const memory = new WebAssembly.Memory({ initial: Math.ceil(given.n_word / 8192) });
    const instance = new WebAssembly.Instance(new WebAssembly.Module(given.code.values as Uint8Array<ArrayBuffer>), { env: { memory } });
    this.loop = { memory: new Float64Array(memory.buffer), ...instance.exports } as unknown as Loop;
    this.axes = given.position.length;
    given.words.forEach(({ at, values }) => this.loop.memory.set(values.values, at));
    this.plan();
    this.rest = this.state();
  }

  /** Make the inputs from the motion. */
  private plan(): void {
    const { motion: { period, n_sample: n, spans, duration, length, path }, inputs, ahead } = this.given, { memory } = this.loop;
    const { axes } = this, many = spans.shape[1], [t0, s0, v0, a0, jerk] = [0, 1, 2, 3, 4].map(i => spans.values.subarray(i * many, (i + 1) * many));
    const on = along(path, axes), out = new Float64Array(3 * axes), row = (i: number): number => inputs + n * i;
    for (let k = 0, i = 0; k < n; k += 1) {
      const t = k * period, rests = t >= duration;
      while (i + 1 < many && t >= t0[i + 1]) i += 1;
      const dt = t - t0[i], s = rests ? length : s0[i] + dt * (v0[i] + dt * (a0[i] / 2 + (dt * jerk[i]) / 6));
      const v = rests ? 0 : v0[i] + dt * (a0[i] + (dt * jerk[i]) / 2), a = rests ? 0 : a0[i] + dt * jerk[i];
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

  private get early(): number { return Math.max(0, this.given.short[0] - Math.round(LEAD / this.given.motion.period)); }

  private state(): Float64Array[] { return this.given.state.map(([from, to]) => this.loop.memory.slice(from, to)); }

  private restore(parts: Float64Array[]): void { this.given.state.forEach(([from], i) => this.loop.memory.set(parts[i], from)); }

  /** Return the answers for the run of the report, and keep its state before the worst place. */
  first(run: number): Answer[] {
    const { early, given: { motion } } = this, from = performance.now();
    this.begin([]);
    this.loop.run(0, early);
    this.worst = this.state();
    this.loop.run(early, motion.n_sample - early);
    return [false, true].map(short => this.found({ id: 0, run, values: [], short }, from));
  }

  /** Answer a question; null if it is dropped. */
  async answer(ask: Ask, dropped: () => Promise<boolean>): Promise<Answer | null> {
    const { loop, given: { short, motion } } = this, [first, stop] = ask.short ? [this.early, short[1]] : [0, motion.n_sample], from = performance.now();
    if (!this.begin(ask.values)) return this.none(ask);
    if (ask.short) this.restore(this.worst);
    for (let k = first; k < stop; k += CHUNK) {
      loop.run(k, Math.min(CHUNK, stop - k));
      if (!ask.short && (await dropped())) return null;
    }
    return this.found(ask, from);
  }

  private none = ({ id, run, short }: Ask): Answer => ({ id, run, short, begun: short ? this.early : 0, took: 0, failed: null, unsure: 0, figures: {}, points: null });

  private found(ask: Ask, from: number): Answer {
    const { short, motion: { n_sample }, failed_at } = this.given, [first, stop] = ask.short ? short : [0, n_sample], failed = this.loop.memory[failed_at];
    if (failed >= 0) return { ...this.none(ask), failed };
    const figures = ask.short ? this.around(first, stop) : this.judged(), points = this.points(first, stop);
    return { ...this.none(ask), figures, points, unsure: figures.unsure, took: performance.now() - from };
  }

  private begin(values: [number, number][]): boolean {
    const { memory, prepare } = this.loop;
    this.restore(this.rest);
    this.given.parameters.forEach(({ word, value }) => { memory[word] = value ?? Infinity; });
    values.forEach(([word, value]) => { memory[word] = value; });
    return prepare() !== 0;
  }

  private judged(): Record<string, number> {
    this.loop.judge();
    return Object.fromEntries(this.given.figures.map(([name, word]) => [name, this.loop.memory[word]]));
  }

  /** Return figures of some ticks. */
  private around(first: number, stop: number): Record<string, number> {
    const { log, n_log: wide, part_error, doubt } = this.given, { memory } = this.loop;
    let count = 0, square = 0, largest = 0, unsure = 0, at = first;
    this.given.judged.forEach(([from, to]) => {
      for (let k = Math.max(from, first); k < Math.min(to, stop); k += 1) {
        const size = Math.abs(memory[log + k * wide + part_error]);
        count += 1;
        square += size * size;
        doubt.forEach(column => { unsure += memory[log + k * wide + column]; });
        if (size > largest) [largest, at] = [size, k];
      }
    });
    return { part_error_max: largest, part_error_rms: Math.sqrt(square / (count || 1)), part_error_max_time: at * this.given.motion.period, unsure };
  }

  private points(first: number, stop: number): Points {
    const { log, n_log: wide, part_error, foot, position, judged, motion, inputs } = this.given, { memory } = this.loop, { axes } = this;
    const kept: number[] = [], stretches: number[] = [], from = Math.max(first, judged[0][0]), to = Math.min(stop, judged.at(-1)![1]);
    const bin = Math.max(1, Math.ceil((to - from) / BINS)), size = (k: number): number => Math.abs(memory[log + k * wide + part_error]);
    let end = from;
    const keep = (k: number, stretch: number): void => { kept.push(k); stretches.push(stretch); };
    const walk = (until: number, stretch: number): void => {
      for (; end < until; end = Math.min(end + bin, until)) {
        let most = end;
        for (let k = end; stretch && k < Math.min(end + bin, until); k += 1) if (size(k) > size(most)) most = k;
        keep(end, stretch);
        if (most !== end) keep(most, stretch);
      }
      if (kept.at(-1) !== until - 1 && until > from) keep(until - 1, stretch);
    };
    judged.forEach(([start, past], i) => {
      walk(Math.min(Math.max(start, end), to), 0);
      walk(Math.min(past, to), i + 1);
    });
    const n = kept.length, on = along(this.given.asked, axes), out = new Float64Array(3 * axes), many = motion.n_sample;
    const made: Points = {
      time: new Float64Array(n), signed: new Float32Array(n), size: new Float32Array(n), stretch: Int32Array.from(stretches),
      foot: new Float32Array(axes * n), error: new Float32Array(axes * n), feedrate: new Float32Array(n),
    };
    kept.forEach((k, i) => {
      const row = log + k * wide, tool = position.map(column => memory[row + column]);
      if (stretches[i]) on(memory[row + foot], out); else out.set(tool);
      made.time[i] = k * motion.period;
      made.feedrate[i] = memory[inputs + (3 * axes + 1) * many + k] * 6e4;
      made.signed[i] = stretches[i] ? memory[row + part_error] * 1e6 : NaN;
      made.size[i] = stretches[i] ? size(k) * 1e6 : 0;
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
  if ("id" in data) {
    latest = data;
    if (!works) void work();
  } else {
    loops[data.run] = new Live(data.loop);
    loops[data.run].first(data.run).forEach(send);
  }
});
