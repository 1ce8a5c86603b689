/** Radial deviation around a circle: the ring at 0 is the nominal circle. And a circle test, with a slider for each cause. */
import type { CircleCauses, Curve, PolarChart } from "./contract";
import { add, button, coloursOf, DASHES, figure, isPaper, legend, roundDown, sized, Tip, visible, widthOf, type Drawing } from "./base";

const LARGEST = 560, ROOM = 34;
type Round = Pick<Curve, "name" | "colour" | "dash"> & { x: ArrayLike<number>; y: ArrayLike<number>; alpha?: number };

/** Distance of two rings, and deviation at the rim [um]: the curves fill the outer part. */
function spacing(curves: Round[]): [number, number] {
  let largest = 0;
  for (const { y } of curves) for (let i = 0; i < y.length; i += 1) if (Math.abs(y[i]) > largest) largest = Math.abs(y[i]);
  if (largest <= 0) return [1, 3];
  const division = roundDown(largest / 2);
  return [division, division * Math.ceil((1.05 * largest) / division)];
}

/** A polar picture whose curves may change. */
class Polar {
  private readonly canvas: HTMLCanvasElement;
  private readonly tip: Tip;
  private radius = 0;
  private middle = 0;

  constructor(
    private readonly host: HTMLElement, readonly curves: () => Round[], private readonly rings: [number, number],
    private readonly marks: Round[] = [], private readonly axes: string[] = [],
  ) {
    const frame = add(host, "div", "cl-panel");
    this.canvas = add(frame, "canvas");
    this.tip = new Tip(frame);
    this.canvas.addEventListener("pointermove", event => this.pointed(event));
    this.canvas.addEventListener("pointerleave", () => this.tip.hide());
  }

  private at(angle: number, deviation: number): [number, number] {
    const rim = this.rings[1], r = (this.radius * (deviation + 2 * rim)) / (3 * rim), a = (angle * Math.PI) / 180;
    return [this.middle + r * Math.cos(a), this.middle - r * Math.sin(a)];
  }

  draw(): void {
    const size = Math.min(widthOf(this.host), isPaper() ? 420 : LARGEST), colours = coloursOf(this.host);
    const pen = sized(this.canvas, size, size), [division, rim] = this.rings, count = Math.round(rim / division);
    this.middle = size / 2;
    this.radius = size / 2 - ROOM;
    pen.fillStyle = colours.muted;
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    for (let angle = 0; angle < 360; angle += 45) {
      pen.strokeStyle = colours.line;
      stroke(pen, [this.at(angle, -2 * rim), this.at(angle, rim)]);
      pen.fillText((angle % 180 ? this.axes[1] : this.axes[0]) && angle % 90 === 0 ? `${angle >= 180 ? "-" : "+"}${this.axes[angle % 180 ? 1 : 0]}` : `${angle}°`,
        ...this.at(angle, rim * (1 + (3 * 15) / this.radius)));
    }
    for (let k = -2 * count; k <= count; k += 1) {
      pen.strokeStyle = k ? colours.line : colours.ink;
      pen.lineWidth = 1.1;
      pen.beginPath();
      pen.arc(this.middle, this.middle, (this.radius * (k + 2 * count)) / (3 * count), 0, 7);
      pen.stroke();
    }
    for (const { x, y, colour, dash, alpha } of this.curves()) {
      pen.strokeStyle = visible(colour, colours.card);
      pen.globalAlpha = alpha ?? 1;
      pen.lineWidth = 1.5;
      pen.setLineDash(DASHES[dash]);
      stroke(pen, Array.from(x, (angle, i) => this.at(angle, y[i])));
    }
    pen.globalAlpha = 1;
    pen.setLineDash([]);
    for (const { x, y, colour } of this.marks) {
      pen.strokeStyle = visible(colour, colours.card);
      for (let i = 0; i < x.length; i += 1) {
        pen.beginPath();
        pen.arc(...this.at(x[i], y[i]), 4.5, 0, 7);
        pen.stroke();
      }
    }
    for (let k = -count; k <= count; k += 1) {
      if (k % 2 && k !== count) continue;
      const [left, top] = this.at(67.5, k * division), text = (k > 0 ? "+" : "") + figure(k * division) + (k === count ? " um" : "");
      pen.lineWidth = 3;
      pen.strokeStyle = colours.card;
      pen.strokeText(text, left, top);
      pen.fillText(text, left, top);
    }
  }

  private pointed(event: PointerEvent): void {
    let least = 24 ** 2, best: [Round, number] | null = null;
    for (const curve of this.curves()) {
      for (let i = 0; i < curve.x.length; i += 1) {
        const [left, top] = this.at(curve.x[i], curve.y[i]), away = (left - event.offsetX) ** 2 + (top - event.offsetY) ** 2;
        if (away < least) [least, best] = [away, [curve, i]];
      }
    }
    if (!best) return this.tip.hide();
    const [curve, i] = best as [Round, number], angle = ((curve.x[i] % 360) + 360) % 360;
    this.tip.show(event.offsetX, event.offsetY, [[curve.name, curve.colour], [`${figure(curve.y[i], "um", 3)} at ${angle.toFixed(1)}°`]]);
  }
}

function stroke(pen: CanvasRenderingContext2D, points: [number, number][]): void {
  pen.beginPath();
  let down = false;
  for (const [x, y] of points) {
    const good = Number.isFinite(x) && Number.isFinite(y);
    if (good && down) pen.lineTo(x, y);
    else if (good) pen.moveTo(x, y);
    down = good;
  }
  pen.stroke();
}

export function drawPolar(host: HTMLElement, chart: PolarChart): Drawing {
  const round = (curve: Curve): Round => ({ ...curve, x: curve.x.values, y: curve.y.values });
  const all = chart.curves.map(round), hidden = new Set<string>();
  let polar: Polar;
  const resize = (): void => {
    host.replaceChildren();
    const colours = coloursOf(host);
    legend(host, all.map(curve => ({ ...curve, colour: visible(curve.colour, colours.card) })), hidden, () => polar.draw());
    polar = new Polar(host, () => all.filter(curve => !hidden.has(curve.name)), spacing(all), chart.marks.map(round));
    polar.draw();
  };
  resize();
  return { resize, destroy: () => host.replaceChildren() };
}

// --- circle test -----------------------------------------------------------------------------------------------------------------------

type Trace = { angle: ArrayLike<number>; deviation: ArrayLike<number> };

/** Return the circular deviation: largest less smallest distance from the least-squares centre of all runs. */
export function circular(runs: Trace[]): number {
  let cc = 0, cs = 0, ss = 0, c1 = 0, s1 = 0, n = 0, dc = 0, ds = 0, d1 = 0, low = Infinity, high = -Infinity;
  const each = (take: (c: number, s: number, d: number) => void): void => runs.forEach(({ angle, deviation }) => {
    for (let i = 0; i < angle.length; i += 1) take(Math.cos((angle[i] * Math.PI) / 180), Math.sin((angle[i] * Math.PI) / 180), deviation[i]);
  });
  each((c, s, d) => {
    cc += c * c; cs += c * s; ss += s * s; c1 += c; s1 += s; n += 1; dc += d * c; ds += d * s; d1 += d;
  });
  cc -= (c1 * c1) / n; ss -= (s1 * s1) / n; cs -= (c1 * s1) / n; dc -= (d1 * c1) / n; ds -= (d1 * s1) / n;
  const det = cc * ss - cs * cs, x = (dc * ss - ds * cs) / det, y = (ds * cc - dc * cs) / det;
  each((c, s, d) => { low = Math.min(low, d - x * c - y * s); high = Math.max(high, d - x * c - y * s); });
  return high - low;
}

export function drawCauses(host: HTMLElement, test: CircleCauses): Drawing {
  const kept = test.causes.map(() => 1), { runs } = test;
  const rounds = (factors: number[], alpha?: number): Round[] => runs.map(run => {
    const count = run.deviation.values.length, y = Float64Array.from(run.deviation.values);
    factors.forEach((factor, k) => {
      if (factor !== 1) for (let i = 0; i < count; i += 1) y[i] -= (1 - factor) * run.curves.values[k * count + i];
    });
    return { name: run.name, colour: run.colour, dash: "solid", x: run.angle.values, y, alpha };
  });
  const size = (all: Round[]): string => figure(circular(all.map(({ x, y }) => ({ angle: x, deviation: y }))), "um", 3);
  const measured = rounds(kept, 0.3), rings = spacing(measured);
  let now = rounds(kept), polar: Polar;
  const sides = add(host, "div", "cl-sides"), left = add(sides, "div"), right = add(sides, "div");
  const line = add(right, "p");
  line.append("Circular deviation: ");
  const output = add(add(line, "b"), "output", "", size(now));
  line.append(` of ${size(measured)} as measured, least-squares centre.`);
  const inputs = test.causes.map((name, k) => {
    const row = add(right, "label", "cl-slider");
    add(row, "span", "", name);
    const input = add(row, "input"), share = add(row, "output", "", "100 %");
    Object.assign(input, { type: "range", min: "0", max: "100", value: "100" });
    input.addEventListener("input", () => {
      kept[k] = Number(input.value) / 100;
      share.textContent = `${input.value} %`;
      now = rounds(kept);
      output.textContent = size(now);
      polar.draw();
    });
    return input;
  });
  const buttons = add(right, "p", "cl-tools");
  for (const [text, value] of [["Remove all", "0"], ["As measured", "100"]]) {
    buttons.append(button(text, () => inputs.forEach(input => {
      input.value = value;
      input.dispatchEvent(new Event("input"));
    })));
  }
  const resize = (): void => {
    left.replaceChildren();
    const colours = coloursOf(host);
    legend(left, now.map(run => ({ ...run, colour: visible(run.colour, colours.card) })), new Set(), () => undefined);
    polar = new Polar(left, () => [...measured, ...now], rings, [], test.axes);
    polar.draw();
  };
  resize();
  return { resize, destroy: () => host.replaceChildren() };
}
