/** What all pictures share: elements, colours, texts of numbers, legend, tip, canvas. */
import type { Picture } from "./contract";

/** A picture on the page. */
export interface Drawing {
  /** Draw again: another size, other colours, or paper. */
  resize(): void;
  /** Draw what the picture holds now. */
  update?(): void;
  destroy(): void;
}

/** What a picture may ask of its page. */
export interface Page {
  readonly pictures: Picture[];
  pick(line: number): void;
  /** Numbers of a picture have changed. */
  changed(picture: Picture): void;
}

/** Room on paper [px]: A4 less margins and padding. */
const PAPER = 640;

export const isPaper = (): boolean => document.documentElement.classList.contains("printing");

/** Return the width that a picture has inside its place [px]. */
export function widthOf(host: HTMLElement): number {
  if (isPaper()) return PAPER;
  const style = getComputedStyle(host);
  return Math.max(host.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight), 200);
}

type Tags = HTMLElementTagNameMap;

/** Return an element with properties, and what is inside. */
export function element<K extends keyof Tags>(tag: K, given: object = {}, ...inside: (Node | string)[]): Tags[K] {
  const made = Object.assign(document.createElement(tag), given);
  made.append(...inside);
  return made;
}

/** Return an element of a class, with what is inside, at the end of another. */
export const add = <K extends keyof Tags>(host: Element, tag: K, className = "", ...inside: string[]): Tags[K] =>
  host.appendChild(element(tag, { className }, ...inside));

/** Return a button. */
export function button(textContent: string, act: () => void): HTMLButtonElement {
  const made = element("button", { type: "button", textContent });
  made.addEventListener("click", act);
  return made;
}

// --- colours -------------------------------------------------------------------------------------------------------------------------

export interface Colours { ink: string; muted: string; line: string; edge: string; card: string; band: string; limit: string }

/** Return the colours of the page around an element. */
export function coloursOf(host: Element): Colours {
  const style = getComputedStyle(host);
  const of = (name: string, other: string): string => style.getPropertyValue(`--${name}`).trim() || other;
  const card = of("card", "#ffffff");
  return {
    card, ink: of("ink", "#1d2733"), muted: of("muted", "#5b6774"), line: of("line", "#e4e8ec"), edge: of("edge", "#b9c1c9"),
    band: visible("#0f7b5f", card), limit: visible("#a33b3b", card),
  };
}

function parts(colour: string): number[] {
  const hex = colour.length === 4 ? colour.replace(/[0-9a-f]/gi, "$&$&") : colour;
  return [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16));
}

function luminance(rgb: number[]): number {
  const [r, g, b] = rgb.map(v => v / 255).map(v => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4));
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

/** Return whether what lies behind an element is dark; paper is not. */
export function isDark(element: Element | null): boolean {
  for (let at = isPaper() ? null : element; at; at = at.parentElement ?? (at.getRootNode() as ShadowRoot).host ?? null) {
    const [r, g, b, opacity = 1] = getComputedStyle(at).backgroundColor.match(/[\d.]+/g)?.map(Number) ?? [0, 0, 0, 0];
    if (opacity > 0.5) return luminance([r, g, b]) < 0.2;
  }
  return false;
}

/** Return a colour (#rrggbb), on a dark ground mixed with white until its contrast is 4.5. */
export function visible(colour: string, ground: string): string {
  const dark = luminance(parts(ground));
  let rgb = parts(colour);
  if (dark > 0.2 || rgb.some(Number.isNaN)) return colour;
  for (let i = 0; i < 12 && (luminance(rgb) + 0.05) / (dark + 0.05) < 4.5; i += 1) rgb = rgb.map(v => v + (255 - v) * 0.12);
  return "#" + rgb.map(v => Math.round(v).toString(16).padStart(2, "0")).join("");
}

// --- texts ---------------------------------------------------------------------------------------------------------------------------

export const unitOf = (label: string): string => label.match(/\[(.*)\]$/)?.[1] ?? "";
export const nameOf = (label: string): string => label.replace(/\s*\[[^\]]*\]$/, "");

/** Return a number with some digits, and its unit. */
export function figure(value: number, unit = "", digits = 4): string {
  const text = String(Number(value.toPrecision(digits)));
  return unit && unit !== "1" ? `${text} ${unit}` : text;
}

/** Return the largest of 1, 2, 5 times a power of ten that is not above a value (> 0). */
export function roundDown(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value) + 1e-12);
  return ([5, 2].find(step => step <= (value / power) * (1 + 1e-12)) ?? 1) * power;
}

/** Return the i of ascending values with values[i] <= value < values[i + 1], or that of the first or last two. */
export function indexBefore(values: ArrayLike<number>, value: number): number {
  let from = 0, to = values.length - 1;
  while (to - from > 1) {
    const middle = (from + to) >> 1;
    if (values[middle] <= value) from = middle; else to = middle;
  }
  return from;
}

// --- legend and tip ------------------------------------------------------------------------------------------------------------------

export interface Entry { name: string; colour: string; dash: string; glyph?: string }

/** Write a legend; a click on an entry hides or shows its curves. */
export function legend(host: Element, entries: Entry[], hidden: Set<string>, toggled: () => void): HTMLElement {
  const row = add(host, "div", "cl-legend");
  const known = entries.filter((entry, i) => entries.findIndex(other => other.name === entry.name) === i);
  for (const entry of known) {
    const made = row.appendChild(button("", () => {
      if (!hidden.delete(entry.name)) hidden.add(entry.name);
      press();
      toggled();
    }));
    const press = (): void => made.setAttribute("aria-pressed", String(!hidden.has(entry.name)));
    const swatch = add(made, "i", entry.glyph ? "cl-glyph" : "", entry.glyph ?? "");
    if (!entry.glyph) swatch.style.borderTop = `3px ${{ dash: "dashed", dot: "dotted" }[entry.dash] ?? "solid"} ${entry.colour}`;
    made.append(entry.name);
    press();
  }
  return row;
}

/** A small box beside the pointer; its lines may have a colour. */
export class Tip {
  readonly box: HTMLElement;

  constructor(private readonly host: HTMLElement) {
    this.box = add(host, "div", "cl-tip");
    this.box.hidden = true;
  }

  show(left: number, top: number, lines: [string, string?][]): void {
    this.box.replaceChildren();
    for (const [text, colour] of lines) {
      const line = add(this.box, "div");
      if (colour) add(line, "i").style.background = colour;
      line.append(text);
    }
    this.box.hidden = lines.length === 0;
    const width = this.box.offsetWidth;
    const right = left + 14 + width > this.host.clientWidth;
    this.box.style.left = `${Math.max(right ? left - 14 - width : left + 14, 0)}px`;
    this.box.style.top = `${Math.max(Math.min(top, this.host.clientHeight - this.box.offsetHeight), 0)}px`;
  }

  hide(): void {
    this.box.hidden = true;
  }
}

// --- canvas --------------------------------------------------------------------------------------------------------------------------

/** Size a canvas [px], sharp on its screen or on paper, and return its context in these units. */
export function sized(canvas: HTMLCanvasElement, width: number, height: number): CanvasRenderingContext2D {
  const ratio = isPaper() ? 3 : Math.max(devicePixelRatio, 1);
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
  Object.assign(canvas.style, { width: `${width}px`, height: `${height}px` });
  const context = canvas.getContext("2d")!;
  context.scale(ratio, ratio);
  context.clearRect(0, 0, width, height);
  context.font = FONT;
  context.lineJoin = "round";
  return context;
}

export const FONT = "12px system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif";
export const DASHES: Record<string, number[]> = { solid: [], dash: [7, 4], dot: [2, 3] };
