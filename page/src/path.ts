/** The path with magnified errors, seen along one axis. */
import type { Magnified, PathChart } from "./contract";
import { add, coloursOf, DASHES, figure, isPaper, legend, roundDown, sized, visible, widthOf, type Drawing, type Page } from "./base";

/** Draw the path; `highlight` marks the part that a line of the program makes. */
export function drawPath(host: HTMLElement, scene: PathChart, page: Page): Drawing & { highlight(line: number | null): void } {
  const hidden = new Set<string>(), [outline] = scene.lines, bar = add(host, "div", "cl-tools");
  const buttons = ["−", "+"].map(text => add(bar, "button", "", text)), scale = add(bar, "output"), worth = add(bar, "span");
  const frame = add(host, "div"), canvas = add(frame, "canvas");
  let magnification = scene.magnification, picked: number | null = null, toPixel: (x: number, y: number) => [number, number];

  function limits(values: ArrayLike<number>): [number, number] {
    let low = Infinity, high = -Infinity;
    for (let i = 0; i < values.length; i += 1) { low = Math.min(low, values[i]); high = Math.max(high, values[i]); }
    return [low, high];
  }

  function draw(): void {
    const width = widthOf(host), colours = coloursOf(host), room = 40;
    const [[left, right], [bottom, top]] = [limits(outline.x.values), limits(outline.y.values)];
    const wide = right - left || 1, high = top - bottom;
    const factor = Math.min((width - 2 * room) / wide, (isPaper() ? 420 : 620) / (high || 1));
    const height = Math.max(high * factor, 120) + 2 * room, pen = sized(canvas, width, height);
    toPixel = (x, y) => [width / 2 + factor * (x - (left + right) / 2), height / 2 - factor * (y - (bottom + top) / 2)];
    const stroke = (x: (i: number) => number, y: (i: number) => number, count: number, colour: string, dash: string, size: number): void => {
      pen.beginPath();
      pen.strokeStyle = visible(colour, colours.card);
      pen.lineWidth = size;
      pen.setLineDash(DASHES[dash]);
      let down = false;
      for (let i = 0; i < count; i += 1) {
        const [a, b] = toPixel(x(i), y(i)), good = Number.isFinite(a + b);
        if (good && down) pen.lineTo(a, b);
        else if (good) pen.moveTo(a, b);
        down = good;
      }
      pen.stroke();
    };
    const place = (run: Magnified, i: number, k: number): number =>
      run.foot.values[2 * i + k] + run.error.values[2 * i + k] * 1e-3 * magnification;
    for (const line of scene.lines) stroke(i => line.x.values[i], i => line.y.values[i], line.x.values.length, line.colour, line.dash, line.width);
    if (picked !== null) {
      const at = scene.asked_at.values, on = (i: number): boolean => at[i] === picked || (i > 0 && at[i - 1] === picked);
      pen.globalAlpha = 0.7;
      stroke(i => (on(i) ? outline.x.values[i] : NaN), i => outline.y.values[i], at.length, "#f0a202", "solid", 6);
      pen.globalAlpha = 1;
    }
    for (const run of [...scene.tolerance, ...scene.runs]) {
      if (!hidden.has(run.name)) stroke(i => place(run, i, 0), i => place(run, i, 1), run.foot.shape[0], run.colour, run.dash, 1.4);
    }
    for (const run of scene.worst) {
      pen.beginPath();
      pen.setLineDash([]);
      pen.strokeStyle = visible(run.colour, colours.card);
      pen.lineWidth = 2;
      pen.arc(...toPixel(place(run, 0, 0), place(run, 0, 1)), 7, 0, 7);
      pen.stroke();
    }
    const length = roundDown(Math.max(wide, high) / 8);
    scale.textContent = `error × ${magnification.toLocaleString("en").replace(/,/g, "\u2009")}`;
    worth.textContent = `${figure(length)} mm from the path = ${figure((length * 1e3) / magnification, "um", 3)} of error`;
  }

  buttons.forEach((button, k) => {
    button.type = "button";
    button.setAttribute("aria-label", k ? "larger errors" : "smaller errors");
    button.addEventListener("click", () => {
      const two = String(magnification).startsWith(k ? "2" : "5");
      magnification = Math.max(k ? magnification * (two ? 2.5 : 2) : magnification / (two ? 2.5 : 2), 1);
      draw();
    });
  });
  canvas.addEventListener("click", event => {
    let least = 20 ** 2, line = 0;
    for (let i = 0; i < outline.x.values.length; i += 1) {
      const [x, y] = toPixel(outline.x.values[i], outline.y.values[i]), away = (x - event.offsetX) ** 2 + (y - event.offsetY) ** 2;
      if (away < least && scene.asked_at.values[i] > 0) [least, line] = [away, scene.asked_at.values[i]];
    }
    if (line) page.pick(line);
  });
  const row = (): HTMLElement => legend(host, [...scene.tolerance, ...scene.runs].map(run => ({ ...run, colour: visible(run.colour, coloursOf(host).card) })), hidden, draw);
  let below = row();
  draw();
  return {
    highlight(line) { picked = line; draw(); },
    resize() { below.remove(); below = row(); draw(); },
    destroy() { host.replaceChildren(); },
  };
}
