/** The viewer: draws the pictures of a message in a page that we write, or in any element. */
import uplotStyle from "uplot/dist/uPlot.min.css";
import style from "./viewer.css";
import { add, element, isDark, type Drawing, type Page } from "./base";
import { drawChart } from "./chart";
import type { Picture } from "./contract";
import { drawHeat } from "./heat";
import { drawLive } from "./live";
import { pictures, unpacked } from "./message";
import { alive } from "./page";
import { drawPath } from "./path";
import { drawCauses, drawPolar } from "./polar";

export { unpacked };

type Drawn = Drawing & { highlight?(line: number | null): void };

function draw(host: HTMLElement, picture: Picture, page: Page): Drawn {
  switch (picture.kind) {
    case "Chart": return drawChart(host, picture);
    case "PolarChart": return drawPolar(host, picture);
    case "PathScene": return drawPath(host, picture, page);
    case "Heat": return drawHeat(host, picture);
    case "CircleCauses": return drawCauses(host, picture);
    case "LiveLoop": return drawLive(host, picture, page);
  }
}

const FOLDED = "details.fold:not([open]), .verdict details:not([open])";
/** What the size of a picture follows: the width of its place and the height of the window. */
const sizeOf = (width: number): string => `${Math.round(width)} ${innerHeight}`;

/** Pictures in their places. Each is drawn when it comes near the window, so that a long page opens quickly. */
class Viewer {
  private readonly drawn = new Map<HTMLElement, Drawn>();
  private line: number | null = null;
  private readonly watch = new IntersectionObserver(entries => entries.forEach(({ isIntersecting, target }) => {
    if (isIntersecting) this.draw(target as HTMLElement);
  }), { rootMargin: "600px 0px" });
  private readonly folds: HTMLDetailsElement[] = [];
  private readonly themes = new MutationObserver(() => this.dress());
  private readonly gone = new AbortController();
  private dark = false;
  private readonly sizes = new ResizeObserver(entries => entries.forEach(({ target, contentRect }) => {
    const host = target as HTMLElement, size = sizeOf(contentRect.width);
    if (host.dataset.size !== size && contentRect.width > 0) {
      host.dataset.size = size;
      this.drawn.get(host)?.resize();
    }
  }));

  private readonly page: Page;

  constructor(private readonly places: Map<HTMLElement, Picture>, pick: (line: number) => void, private readonly root: HTMLElement) {
    this.page = { pick, pictures: [...places.values()], changed: picture => this.changed(picture) };
    const tree = root.getRootNode(), home = tree instanceof ShadowRoot ? tree : document.head;
    if (!home.querySelector("#cl-style")) home.appendChild(element("style", { id: "cl-style" }, uplotStyle + style));
    places.forEach((_, host) => this.watch.observe(host));
    const { signal } = this.gone;
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.dress(), { signal });
    addEventListener("beforeprint", () => this.paper(true), { signal });
    addEventListener("afterprint", () => this.paper(false), { signal });
    // Notebooks and sites change their theme by attributes.
    for (const page of [document.documentElement, document.body]) this.themes.observe(page, { attributes: true });
  }

  /** Take the look of what lies behind, light or dark. */
  private dress(): void {
    const dark = isDark(this.root);
    if (this.root.classList.toggle("cl-dark", dark) !== this.dark) this.resize();
    this.dark = dark;
  }

  private draw(host: HTMLElement): void {
    if (this.drawn.has(host) || host.closest("[hidden], details:not([open])")) return;
    this.watch.unobserve(host);
    this.dress();
    host.dataset.size = sizeOf(host.clientWidth - parseFloat(getComputedStyle(host).paddingLeft) * 2);
    try {
      const drawing = draw(host, this.places.get(host)!, this.page);
      this.drawn.set(host, drawing);
      if (this.line !== null) drawing.highlight?.(this.line);
      this.sizes.observe(host);
    } catch (error) {
      host.textContent = `This picture could not be drawn: ${(error as Error).message}`;
      console.error(error);
    }
    host.dataset.drawn = "1";
  }

  private changed(picture: Picture): void {
    this.drawn.forEach((drawing, host) => { if (this.places.get(host) === picture) drawing.update?.(); });
  }

  highlight(line: number): void {
    this.line = line;
    this.drawn.forEach(drawing => drawing.highlight?.(line));
  }

  /** Draw again what is seen now, and the rest when its fold opens. */
  private resize(): void {
    this.drawn.forEach((drawing, host) => {
      if (host.clientWidth) return drawing.resize();
      host.dataset.size = "";
      this.sizes.unobserve(host);
      this.sizes.observe(host);  // tells its size anew, if it is seen again at the same
    });
  }

  /** On paper all folds are open, and all pictures drawn, in light colours. */
  private paper(on: boolean): void {
    document.documentElement.classList.toggle("printing", on);
    if (on) document.querySelectorAll<HTMLDetailsElement>(FOLDED).forEach(fold => { this.folds.push(fold); fold.open = true; });
    this.root.classList.toggle("cl-dark", this.dark = isDark(this.root));
    this.resize();
    if (on) this.places.forEach((_, host) => this.draw(host)); else this.folds.splice(0).forEach(fold => { fold.open = false; });
  }

  destroy(): void {
    this.gone.abort();
    [this.watch, this.sizes, this.themes].forEach(observer => observer.disconnect());
    this.drawn.forEach(drawing => drawing.destroy());
  }
}

/** Draw the pictures of a message in the places of this page: elements whose ids are their keys. */
export function page(message: ArrayBuffer): void {
  const places = new Map<HTMLElement, Picture>();
  for (const picture of pictures(message)) {
    const host = document.getElementById(picture.key);
    if (host) places.set(host, picture);
  }
  const viewer: Viewer = new Viewer(places, alive(line => viewer.highlight(line)), document.body);
}

/** Draw the pictures of a message in an element, the first two open and the others folded; return what takes them away. */
export function show(root: HTMLElement, message: ArrayBuffer): () => void {
  const places = new Map<HTMLElement, Picture>();
  root.classList.add("cl-show");
  for (const picture of pictures(message)) {
    const fold = add(root, "details", "fold");
    fold.open = places.size < 2;
    add(fold, "summary", "", picture.title);
    const host = add(fold, "div", "plot");
    host.dataset.key = picture.key;
    places.set(host, picture);
    add(fold, "p", "", picture.caption);
  }
  const viewer: Viewer = new Viewer(places, line => viewer.highlight(line), root);
  return () => {
    viewer.destroy();
    root.replaceChildren();
  };
}

/** Draw in a notebook, by the contract of anywidget. */
export async function render({ model, el }: { model: { get(name: string): any }; el: HTMLElement }): Promise<() => void> {
  const message = await unpacked(model.get("message"));
  el.dataset.lmSuppressShortcuts = "true";  // keys are for the pictures, not for JupyterLab
  const end = show(el, message);
  // A saved notebook also has a still picture.
  add(el, "style", "", `.${model.get("name")} { display: none; }`);
  return end;
}
