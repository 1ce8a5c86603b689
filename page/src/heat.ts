/** A value in each cell of a grid, in colours, with its scale. */
import type { Heat } from "./contract";
import { add, coloursOf, figure, FONT, sized, Tip, widthOf, type Drawing } from "./base";

const SCALE = 92, BOTTOM = 40, DARK = "#444444";

export function drawHeat(host: HTMLElement, heat: Heat): Drawing {
  const rows = heat.y_names.length, columns = heat.x_names.length, { values } = heat.values;
  const frame = add(host, "div", "cl-panel"), canvas = add(frame, "canvas"), tip = new Tip(frame);
  let left = 0, cell = [1, 1], height = 0;

  function colour(value: number): string {
    if (!Number.isFinite(value)) return DARK;
    const at = Math.min(Math.max((value - heat.low) / (heat.high - heat.low || 1), 0), 1);
    let i = heat.colours.findIndex(([place]) => place > at);
    if (i < 0) i = heat.colours.length - 1;
    const [[low, from], [high, to]] = [heat.colours[i - 1], heat.colours[i]], share = (at - low) / (high - low || 1);
    const mixed = [1, 3, 5].map(k => {
      const a = parseInt(from.slice(k, k + 2), 16), b = parseInt(to.slice(k, k + 2), 16);
      return Math.round(a + Math.min(share, 1) * (b - a));
    });
    return `rgb(${mixed.join()})`;
  }

  function resize(): void {
    const width = widthOf(host), colours = coloursOf(host);
    left = 14 + 7 * Math.max(...heat.y_names.map(name => name.length), 3) + 18;
    height = Math.min(Math.max(16 * rows, 90), 420);
    cell = [(width - left - SCALE) / columns, height / rows];
    const pen = sized(canvas, width, height + BOTTOM + 8);
    pen.translate(0, 8);
    for (let row = 0; row < rows; row += 1) for (let column = 0; column < columns; column += 1) {
      pen.fillStyle = colour(values[row * columns + column]);
      pen.fillRect(left + column * cell[0], height - (row + 1) * cell[1], cell[0] + 0.5, cell[1] + 0.5);
    }
    pen.fillStyle = colours.muted;
    pen.font = FONT;
    pen.textBaseline = "middle";
    pen.textAlign = "right";
    every(rows, cell[1], 16, row => pen.fillText(heat.y_names[row], left - 6, height - (row + 0.5) * cell[1]));
    pen.textAlign = "center";
    const room = 7 * Math.max(...heat.x_names.map(name => name.length)) + 10;
    every(columns, cell[0], room, column => pen.fillText(heat.x_names[column], left + (column + 0.5) * cell[0], height + 11));
    pen.fillText(heat.x_label, left + (columns * cell[0]) / 2, height + 29);
    pen.save();
    pen.translate(8, height / 2);
    pen.rotate(-Math.PI / 2);
    pen.fillText(heat.y_label, 0, 0);
    pen.restore();
    for (let i = 0; i < height; i += 1) {
      pen.fillStyle = colour(heat.low + ((heat.high - heat.low) * (i + 0.5)) / height);
      pen.fillRect(width - SCALE + 14, height - i - 1, 12, 1.5);
    }
    pen.fillStyle = colours.muted;
    pen.textAlign = "left";
    const step = heat.colours.find(([place], i) => i > 0 && place === heat.colours[i - 1][0])?.[0];
    for (const at of [0, step ?? 0.5, 1]) {
      if (at % 1 && Math.min(at, 1 - at) * height < 14) continue;
      const text = figure(heat.low + at * (heat.high - heat.low), "", 3) + (at === 1 ? ` ${heat.unit}` : "");
      pen.fillText(text, width - SCALE + 30, Math.min(Math.max(height * (1 - at), 5), height - 5));
    }
  }

  canvas.addEventListener("pointermove", event => {
    const column = Math.floor((event.offsetX - left) / cell[0]), row = Math.floor((height + 8 - event.offsetY) / cell[1]);
    if (column < 0 || row < 0 || column >= columns || row >= rows) return tip.hide();
    const value = values[row * columns + column];
    const text = Number.isFinite(value) ? figure(value, heat.unit) : "diverged, or not judged";
    tip.show(event.offsetX, event.offsetY, [[`${heat.x_label} ${heat.x_names[column]}`], [`${heat.y_label} ${heat.y_names[row]}`], [text]]);
  });
  canvas.addEventListener("pointerleave", () => tip.hide());
  resize();
  return { resize, destroy: () => host.replaceChildren() };
}

/** Call for some of many places, so that their texts (size `room`) do not meet. */
function every(count: number, size: number, room: number, call: (i: number) => void): void {
  const step = Math.max(Math.ceil(room / size), 1);
  for (let i = 0; i < count; i += step) call(i);
}
