/** The path in space, judged: errors magnified and coloured, worst places, playback. Nothing is drawn while nothing changes. */
import { button, type Drawing, element, figure, indexBefore, isPaper, type Page, roundDown, visible as seen } from "./base";
import type { PathScene, Place, SceneRun } from "./contract";
import LOOK from "./path.css";
import { attribute, Canvas, drawsInSoftware, mix, pairs, type Point, rgb, RUN, scaleColours, tangents, type Values } from "./path_lines";
import { point, View } from "./path_view";

/** A place of a run between two samples, or of the path where nothing is judged. */
interface Spot { run: SceneRun; foot: Point; error: Point; size: number; time: number; line: number; feedrate: number; judged: boolean }

const MOST = 10_000, NEAR = 14, SOON = 0.25, FLAT = 0.05;
const ISO: [number, number] = [-60, 35.264], PAPER: [number, number] = [640, 440];
/** Left ends and heights [px] that the key of colours takes from labels. */
const KEY_PLACE = [20, 36, 52].flatMap(y => [12, 90].map((x): [number, number] => [x, y]));
const SPEEDS = [0.1, 0.2, 0.5, 1, 2, 5, 10], NOTHING: Point = [0, 0, 0];

/** Return an element of SVG. */
function shape(tag: string, given: Record<string, string | number>, ...inside: (Node | string)[]): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(given)) made.setAttribute(name, String(value));
  made.append(...inside);
  return made;
}

/** Runs with thin lines: what there was before. */
export const ghosts = new WeakSet<SceneRun>();

/** Draw the path and its runs; a click on them picks the line of the program, and `highlight` marks the stretch that a line makes. */
export function drawPath(host: HTMLElement, scene: PathScene, page: Page): Drawing & { highlight(line: number | null): void } {
  // Without a graphics card, smooth edges cost as much as all the rest. A page that is printed needs the last frame.
  const isSlow = drawsInSoftware(), canvas = element("canvas");
  const context = canvas.getContext("webgl2", { antialias: !isSlow, alpha: true, preserveDrawingBuffer: true });
  if (!context) {
    host.replaceChildren("The path in space needs WebGL 2, which this browser does not offer.");
    return { highlight() {}, resize() {}, destroy() { host.replaceChildren(); } };
  }
  const tree = host.getRootNode(), root = tree instanceof ShadowRoot ? tree : document, look = new CSSStyleSheet(), gone = new AbortController();
  look.replaceSync(LOOK);
  root.adoptedStyleSheets.push(look);
  const listen = (target: EventTarget, kinds: string, act: (event: never) => void, more: object = {}): void =>
    kinds.split(" ").forEach(kind => target.addEventListener(kind, act as EventListener, { signal: gone.signal, ...more }));

  // --- lines -------------------------------------------------------------------------------------------------------------------------
  const gl = new Canvas(canvas, context), uniforms = gl.uniforms, path = scene.path.values, judged = scene.judged.values, count = judged.length;
  const low: Point = [Infinity, Infinity, Infinity], high: Point = [-Infinity, -Infinity, -Infinity];
  path.forEach((value, i) => { low[i % 3] = Math.min(low[i % 3], value); high[i % 3] = Math.max(high[i % 3], value); });
  const centre = mix(low, high, 0.5), extent = Math.max(...high.map((value, k) => value - low[k])) || 1, tolerance = scene.tolerance;
  const asked = { foot: attribute(path, 3, centre), tangent: tangents(path, 3e-5 * extent) };  // a corner comes as three points, rounded to 2^-17 of the extent
  const cuts = pairs(count, i => judged[i] > 0 && judged[i + 1] > 0), rests = pairs(count, i => !(judged[i] && judged[i + 1]));
  const rapids = gl.add(asked, rests, 0), outline = gl.add(asked, cuts, 2), halo = gl.add(asked, pairs(count, () => true), 3);
  const edges = tolerance === null ? [] : [1, -1].map(side => gl.add(asked, cuts, 1, side * tolerance * 1e-3));
  /** Return what is drawn of a run. */
  function drawnOf(run: SceneRun) {
    const size = run.size.values, stretch = run.stretch.values, index = pairs(size.length, i => stretch[i] > 0 && stretch[i] === stretch[i + 1]);
    const places = { foot: attribute(run.foot.values, 3, centre), error: attribute(run.error.values, 3, NOTHING, 1e-3), size: attribute(size, 1) };
    let top = 0;
    size.forEach((value, i) => { if (stretch[i] > 0) top = Math.max(top, value); });
    return { index, top, places, of: run.size };
  }
  function added(run: SceneRun, r: number) {
    const drawn = drawnOf(run), { places, index } = drawn;
    return { run, ...drawn, shown: false, lines: gl.add(places, index, RUN + r), halo: gl.add(places, index.slice(), 4) };
  }
  const runs = scene.runs.map(added);
  const visible = (): typeof runs => runs.filter(one => one.shown);
  const worstRun = runs.reduce((a, b) => (b.top > a.top ? b : a));
  (runs.length === 2 ? runs : [worstRun]).forEach(one => { one.shown = true; });  // before and after

  // --- controls ----------------------------------------------------------------------------------------------------------------------
  const copy = element("canvas", { hidden: true }), svg = shape("svg", {});
  const bar = element("div", { className: "path-bar" }), key = element("div", { className: "path-key" });
  const ariaLabel = `${scene.title}. Arrow keys turn, with shift they move; plus and minus zoom, space plays.`;
  const stage = element("div", { className: "path-stage", tabIndex: 0, role: "application", ariaLabel }, canvas, copy, svg, key, bar);
  const times = element("output", { className: "path-times" }), clock = element("output");
  const said = element("output", { className: "path-said", textContent: "Click on the path: line, time, error and cause." });
  const slider = element("input", { type: "range", min: "0", max: "4", step: "any", ariaLabel: "Magnification of the error" });
  const first = Math.min(...runs.map(({ run }) => run.time.values[0] ?? 0)), last = Math.max(...runs.map(({ run }) => run.time.values.at(-1) ?? 0));
  const scrubber = element("input", { type: "range", min: String(first), max: String(last), step: "any", ariaLabel: "Time", value: String(first) });
  const play = button("", () => toggle());
  const speed = element("select", { ariaLabel: "Speed" }, ...SPEEDS.map(s => new Option(`${s} ×`, String(s))));
  const colourBy = element("select", { ariaLabel: "Colour" }, new Option("colour: error", "error"), new Option("colour: run", "run", runs.length === 2, runs.length === 2));
  const tick = (text: string, checked: boolean, act: (on: boolean) => void, colour = ""): HTMLElement => {
    const box = element("input", { type: "checkbox", checked }), swatch = element("i");
    swatch.style.background = colour;
    listen(box, "change", () => { act(box.checked); dress(); });
    return element("label", {}, box, ...(colour ? [swatch] : []), text);
  };
  const letters = scene.axes.map(name => name.toUpperCase()), [x, y, z] = letters, longest = Math.max(...letters.map(name => name.length));
  const plane = (a: string, b: string): string => a + (longest > 1 ? " " : "") + b;
  const views: [string, number, number][] = [[plane(x, y), -90, 90], ["ISO", ...ISO]];
  if (z) views.splice(1, 0, [plane(x, z), -90, 0], [plane(y, z), 0, 0]);
  const which = element("span", { className: "path-which" });
  function show(one: typeof runs[0], on: boolean): void {
    one.shown = on;
    colourBy.value = visible().length > 1 ? "run" : "error";
  }
  const list = (): void => {
    if (runs.length > 1) which.replaceChildren(...runs.map(one => tick(one.run.name, one.shown, on => show(one, on), one.run.colour)), colourBy);
  };
  list();
  // A flat path is seen from above; there, edges of the tolerance do not hide one another.
  let length = 0, climb = 0, showRapids = true;
  for (let k = 0; k < cuts.length; k += 2) {
    const a = point(path, cuts[k]), b = point(path, cuts[k + 1]);
    length += Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    climb += Math.abs(b[2] - a[2]);
  }
  const isFlat = climb <= FLAT * length;
  let showEdges = isFlat;
  const [azimuth, elevation] = isFlat ? [-90, 90] : ISO, view = new View(path, centre, extent, azimuth, elevation, () => invalidate());
  host.classList.add("cl-path");
  host.replaceChildren(
    element("div", { className: "path-row" },
      element("span", { className: "path-views" },
        ...views.map(([name, a, e]) => button(name, () => { view.from(a, e); fit(); })), button("Fit", fit)),
      which,
      ...(rests.length ? [tick(scene.unjudged, true, on => { showRapids = on; })] : []),
      ...(edges.length ? [tick("tolerance", showEdges, on => { showEdges = on; })] : [])),
    stage,
    element("div", { className: "path-row" }, times, slider),
    element("div", { className: "path-row" }, play, scrubber, speed, clock), said);

  // --- one frame ---------------------------------------------------------------------------------------------------------------------
  let frame = 0, settling = 0, dense = 1, moves = false, isSeen = true;
  const inView = new IntersectionObserver(([{ isIntersecting }]) => { isSeen = isIntersecting; invalidate(); }, { rootMargin: "200px" });
  inView.observe(stage);
  function invalidate(): void { if (isSeen) frame ||= requestAnimationFrame(render); }

  function fit(): void {
    view.fit(Math.min(1e-3 * uniforms.magnification.value * Math.max(...visible().map(one => one.top), 0), 0.3 * extent));
  }

  /** Lines are a pixel wide while the picture moves, if wide ones are slow. */
  function move(): void {
    moves = isSlow;
    clearTimeout(settling);
    settling = window.setTimeout(() => { moves = false; invalidate(); }, 150);
  }

  function render(): void {
    cancelAnimationFrame(frame);
    frame = 0;
    view.aim(gl.camera, 4 * (extent + 1e-3 * MOST * Math.max(...runs.map(one => one.top))));
    uniforms.view.value.set(...view.back);
    rapids.object.visible = showRapids;
    edges.forEach(edge => { edge.object.visible = showEdges && tolerance! * 1e-3 * uniforms.magnification.value < 0.3 * extent; });
    runs.forEach(one => { one.lines.object.visible = one.shown; one.lines.width(moves || ghosts.has(one.run) ? 1 : 2 * dense); });
    gl.renderer.render(gl.scene, gl.camera);
    annotate();
  }

  const drawnAt = ({ foot, error }: { foot: number[]; error: number[] }): Point =>
    [0, 1, 2].map(k => foot[k] + error[k] * 1e-3 * uniforms.magnification.value) as Point;
  let tools: SVGElement[] = [], listed: { run: SceneRun; place: Place }[] = [], chosen: Spot | null = null;

  /** Draw worst places with labels that do not cover one another, the chosen place, axes, tools and scale. */
  function annotate(): void {
    const marks: SVGElement[] = [], taken = KEY_PLACE.slice(), [cx, cy] = view.project(centre);
    listed = visible().flatMap(({ run }) => run.worst.map(place => ({ run, place }))).sort((a, b) => b.place.size - a.place.size);
    listed.forEach(({ run, place }, k) => {
      const [px, py] = view.project(drawnAt(place)), { width, height } = view;
      if (!view.holds([px, py])) return;
      const text = `${figure(place.size, "um", 3)}${place.line ? `, line ${place.line}` : ""}`, long = 7 * text.length, out = px < cx ? -1 : 1;
      const side = px + out * (18 + long) < 0 || px + out * (18 + long) > width ? -out : out, way = py < cy ? -1 : 1;
      const tx = px + side * 14, left = side > 0 ? tx : tx - long;
      const free = [15, 31, 47, 63, -23, -39].map(off => py + 3 + way * off).find(ty => ty > 12 && ty < height - 6
        && !taken.some(([x, y]) => Math.abs(x - left) < long + 6 && Math.abs(y - ty) < 16));
      const label = shape("g", { class: "path-worst", "data-place": k }, shape("circle", { class: "path-mark", cx: px, cy: py, r: 6 }));
      if (visible().length > 1) (label.firstChild as SVGElement).style.stroke = run.colour;
      if (free !== undefined) {
        taken.push([left, free]);
        const looks = tolerance !== null && place.size > tolerance ? "path-over" : "";
        label.append(shape("line", { class: "path-lead", x1: px + side * 5, y1: py, x2: tx - side * 2, y2: free - 4 }),
          shape("text", { class: looks, x: tx, y: free, "text-anchor": side > 0 ? "start" : "end" }, text));
      }
      marks.push(label);
    });
    if (chosen) {
      const [px, py] = view.project(drawnAt(chosen));
      marks.push(shape("path", { class: "path-mark", d: `M${px - 11} ${py}h8m6 0h8M${px} ${py - 11}v8m0 6v8` }));
    }
    letters.forEach((letter, k) => {
      const [bx, by] = [view.width - 30 - 8 * Math.min(longest, 9), view.height - 34], dx = view.right[k], dy = -view.up[k];
      marks.push(shape("line", { class: "path-mark", x1: bx, y1: by, x2: bx + 24 * dx, y2: by + 24 * dy }));
      if (Math.hypot(dx, dy) > 0.3) marks.push(shape("text", { x: bx + 30 * dx - 4, y: by + 32 * dy + 4 }, letter));
    });
    tools = runs.map(({ run }) => shape("circle", { class: "path-tool", r: 6, fill: run.colour }));
    svg.replaceChildren(...marks, ...tools);
    const worth = roundDown((120 * view.span) / view.height), line = element("i");
    line.style.width = `${(worth * view.height) / view.span}px`;
    bar.replaceChildren(line, `${figure(worth, "mm")} of path, ${figure((worth * 1e3) / uniforms.magnification.value, "um", 3)} of error`);
    showTools();
  }

  // --- playback ----------------------------------------------------------------------------------------------------------------------
  /** Return a place between samples i and i + 1 of a run; its error is drawn where it is judged. */
  function between(run: SceneRun, i: number, f: number): Spot {
    const stretch = run.stretch.values, j = Math.min(i + 1, stretch.length - 1);
    const value = ({ values }: { values: Values }): number => values[i] + (values[j] - values[i]) * f;
    const error = (k: number): Point => (stretch[k] > 0 ? point(run.error.values, k) : NOTHING);
    const foot = mix(point(run.foot.values, i), point(run.foot.values, j), f);
    return {
      run, foot, error: mix(error(i), error(j), f), size: value(run.size), time: value(run.time), line: run.lines.values[f > 0 ? j : i],
      feedrate: value(run.feedrate), judged: stretch[i] > 0 && stretch[i] === stretch[j],
    };
  }

  function toolAt(run: SceneRun, when: number): Spot {
    const values = run.time.values, i = indexBefore(values, when);
    return between(run, i, Math.min(Math.max((when - values[i]) / (values[i + 1] - values[i] || 1), 0), 1));
  }

  let time = first, playing = 0, before = 0;

  function showTools(): void {
    const spots = runs.map(({ run, shown }) => (shown && run.time.values.length && (time > first || playing) ? toolAt(run, time) : null));
    spots.forEach((spot, r) => {
      tools[r].setAttribute("visibility", spot ? "visible" : "hidden");
      if (spot) view.project(drawnAt(spot)).forEach((at, k) => tools[r].setAttribute(k ? "cy" : "cx", at.toFixed(2)));
    });
    const there = spots.filter(spot => spot !== null), line = there.find(spot => spot.line)?.line;
    const errors = there.map(spot => (spot.judged ? figure(spot.size, "um", 3) : scene.unjudged));
    clock.textContent = [`${time.toFixed(3)} s`, ...(line ? [`line ${line}`] : []), ...errors].join(", ");
  }

  function advance(now: number): void {
    time = Math.min(time + ((now - before) / 1e3) * Number(speed.value), last);
    before = now;
    scrubber.value = String(time);
    if (time < last) playing = requestAnimationFrame(advance); else pause();
    showTools();
  }

  function pause(): void {
    cancelAnimationFrame(playing);
    playing = 0;
    Object.assign(play, { textContent: "▶", ariaLabel: "Play" });
  }

  function toggle(): void {
    if (playing) return pause();
    if (time >= last) time = first;
    before = performance.now();
    playing = requestAnimationFrame(advance);
    Object.assign(play, { textContent: "❚❚", ariaLabel: "Pause" });
  }

  listen(scrubber, "input", () => { time = Number(scrubber.value); showTools(); });

  // --- places and lines --------------------------------------------------------------------------------------------------------------
  /** Return the place nearest to a pixel on the runs that are shown, else on the rapids; null if none is near. */
  function nearest(px: number, py: number): Spot | null {
    let best = NEAR, spot: Spot | null = null;
    const search = (index: Uint32Array, at: (i: number) => Point, made: (i: number, f: number) => Spot): void => {
      let found = -1, share = 0;
      for (let k = 0; k < index.length; k += 2) {
        const [ax, ay] = view.project(at(index[k])), [bx, by] = view.project(at(index[k + 1])), dx = bx - ax, dy = by - ay;
        const f = Math.min(Math.max(((px - ax) * dx + (py - ay) * dy) / (dx * dx + dy * dy || 1), 0), 1);
        const off = Math.hypot(px - ax - f * dx, py - ay - f * dy);
        if (off < best) [best, found, share] = [off, index[k], f];
      }
      if (found >= 0) spot = made(found, share);
    };
    for (const { run, index } of visible()) {
      search(index, i => drawnAt({ foot: point(run.foot.values, i), error: point(run.error.values, i) }), (i, f) => between(run, i, f));
    }
    if (!spot && showRapids) {
      search(rests, i => point(path, i), (i, f) => ({
        run: worstRun.run, foot: mix(point(path, i), point(path, i + 1), f), error: NOTHING, line: scene.lines.values[f < 0.5 ? i : i + 1],
        size: NaN, time: NaN, feedrate: NaN, judged: false,
      }));
    }
    return spot;
  }

  /** Say what is known of a place, and pick its line. */
  function choose(spot: Spot): void {
    chosen = spot;
    const name = spot.line ? `Line ${spot.line}` : "";
    if (spot.judged) {
      const apart = (place: Place): number => Math.abs(place.time - spot.time);
      const near = spot.run.worst.filter(place => place.cause && apart(place) < SOON).sort((a, b) => apart(a) - apart(b));
      said.textContent = [name, `t = ${spot.time.toFixed(3)} s`, `error ${figure(spot.size, "um", 3)}`, figure(spot.feedrate, "mm/min"),
        ...near.slice(0, 1).map(place => `cause: ${place.cause}`), runs.length > 1 ? spot.run.name : ""].filter(Boolean).join(", ");
      time = spot.time;
      scrubber.value = String(time);
    } else said.textContent = [name, scene.unjudged].filter(Boolean).join(", ");
    invalidate();
    if (spot.line) page.pick(spot.line);
  }

  let marked: number | null = null;

  function highlight(line: number | null): void {
    marked = line;
    /** Segments that end on the line; if thinning left it none, those that pass over it. */
    const part = (index: Uint32Array, lines: Values): number[] => {
      const own: number[] = [], over: number[] = [];
      for (let k = 0; line !== null && k < index.length; k += 2) {
        const a = lines[index[k]], b = lines[index[k + 1]];
        if (b === line) own.push(index[k], index[k + 1]); else if (a < line && line < b) over.push(index[k], index[k + 1]);
      }
      return own.length ? own : over;
    };
    const own = part(pairs(count, () => true), scene.lines.values);
    halo.only(own);
    runs.forEach(one => one.halo.only(one.shown ? part(one.index, one.run.lines.values) : []));
    if (own.length && !own.some(i => view.holds(view.project(point(path, i))))) view.target = point(path, own[own.length >> 1]);
    invalidate();
  }

  // --- pointer and keys --------------------------------------------------------------------------------------------------------------
  const down = new Map<number, [number, number]>();
  let travel = 0;
  const local = (event: MouseEvent): [number, number] => {
    const box = stage.getBoundingClientRect();
    return [event.clientX - box.left - stage.clientLeft, event.clientY - box.top - stage.clientTop];
  };
  listen(stage, "pointerdown", (event: PointerEvent) => { down.set(event.pointerId, local(event)); travel = 0; });
  listen(stage, "pointerup pointercancel", (event: PointerEvent) => { down.delete(event.pointerId); });
  listen(stage, "contextmenu", (event: Event) => event.preventDefault());
  listen(stage, "pointermove", (event: PointerEvent) => {
    const from = down.get(event.pointerId), to = local(event), other = [...down].find(([id]) => id !== event.pointerId)?.[1];
    if (!from) return;
    const dx = to[0] - from[0], dy = to[1] - from[1], apart = (at: number[]): number => Math.hypot(at[0] - other![0], at[1] - other![1]) || 1;
    travel += Math.hypot(dx, dy);
    if (travel > 4) stage.setPointerCapture(event.pointerId);
    down.set(event.pointerId, to);
    move();
    if (other) {
      view.zoom(apart(from) / apart(to), ...other);
      view.shift(dx / 2, dy / 2);
    } else if (event.shiftKey || event.buttons & 6) view.shift(dx, dy); else view.turn(dx / 2, dy / 2);
  });
  listen(stage, "click", (event: MouseEvent) => {
    const label = (event.target as Element).closest<SVGElement>(".path-worst"), worst = label && listed[Number(label.dataset.place)];
    const spot = worst ? toolAt(worst.run, worst.place.time) : travel > 4 ? null : nearest(...local(event));
    if (spot) choose(spot);
  });
  listen(stage, "wheel", (event: WheelEvent) => {  // it moves the page until the picture has the focus
    if (!event.ctrlKey && root.activeElement !== stage) return;
    event.preventDefault();
    move();
    view.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.003), ...local(event));
  }, { passive: false });
  listen(stage, "keydown", (event: KeyboardEvent) => {
    const arrow = (dx: number, dy: number) => () => { if (event.shiftKey) view.shift(5 * dx, 5 * dy); else view.turn(dx, dy); };
    const acts: Record<string, () => void> = {
      ArrowLeft: arrow(-6, 0), ArrowRight: arrow(6, 0), ArrowUp: arrow(0, -6), ArrowDown: arrow(0, 6), Home: fit, " ": toggle,
      "+": () => view.zoom(0.8), "=": () => view.zoom(0.8), "-": () => view.zoom(1.25),
    };
    if (!acts[event.key] || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    move();
    acts[event.key]();
  });

  // --- magnification, colours, size --------------------------------------------------------------------------------------------------
  function magnify(value: number): void {
    uniforms.magnification.value = Number(Math.min(Math.max(value, 1), MOST).toPrecision(2));
    times.textContent = slider.ariaValueText = `error × ${uniforms.magnification.value.toLocaleString("en")}`;
    invalidate();
  }
  listen(slider, "input", () => { move(); magnify(10 ** Number(slider.value)); });
  listen(colourBy, "change", () => dress());

  let onPaper = false, kept = {};

  /** Take the colours of the theme, and those of the runs: by error, or one each. */
  function dress(): void {
    const style = getComputedStyle(host), named = (name: string): string => style.getPropertyValue(`--p-${name}`).trim();
    const bySize = colourBy.value === "error", stops = scaleColours(host.closest(".cl-dark") !== null);
    const paint = (lines: { paint(colour: Point): void }[], name: string): void => lines.forEach(one => one.paint(rgb(named(name))));
    paint([outline], "path");
    paint([rapids], "rapid");
    paint(edges, "band");
    paint([halo, ...runs.map(one => one.halo)], "picked");
    runs.forEach(({ run, lines }) => lines.paint(bySize ? null : rgb(seen(run.colour, named("paper")))));
    stops.forEach((colour, k) => uniforms.scale.value[k].set(...colour));
    const top = Math.max(...visible().map(one => one.top), 0) || 1, strip = element("div", { className: "path-scale" }), mark = element("i");
    uniforms.top.value = top;
    const inCss = stops.map(colour => `rgb(${colour.map(part => Math.round(255 * part)).join(" ")})`);
    strip.style.background = `linear-gradient(90deg, ${inCss.join(", ")})`;
    mark.style.left = `${(100 * (tolerance ?? 0)) / top}%`;
    if (tolerance !== null && tolerance <= top) strip.append(mark);
    const ends = element("div", { className: "path-ends" }, element("span", {}, "0"), element("span", {}, figure(top, "um", 3)));
    const texts = [...(bySize ? ["error"] : []), ...(tolerance === null ? [] : [`tolerance ${figure(tolerance, "um")}`])];
    key.replaceChildren(texts.join(", "), ...(bySize ? [strip, ends] : []));
    highlight(marked);
  }

  function size(): void {
    const isFirst = !view.width, ratio = onPaper ? 2 : devicePixelRatio || 1;
    if (!stage.clientWidth || !stage.clientHeight) return;
    [view.width, view.height] = [stage.clientWidth, stage.clientHeight];
    gl.renderer.setPixelRatio(ratio);
    gl.renderer.setSize(view.width, view.height, false);
    uniforms.pixel.value.set(2 / (view.width * ratio), 2 / (view.height * ratio));
    dense = Math.max(Math.round(ratio), 1);
    halo.width(4 * dense);
    runs.forEach(one => one.halo.width(6 * dense));
    if (isFirst) fit();
    render();
  }

  /** On paper the picture has its own size and the light colours; what is printed is a flat copy. */
  function paper(on: boolean): void {
    if (on) kept = { target: view.target, span: view.span };
    onPaper = on;
    [stage.style.width, stage.style.height] = on ? PAPER.map(pixels => `${pixels}px`) : ["", ""];
    dress();
    size();
    if (on) fit(); else Object.assign(view, kept);
    render();
    [copy.width, copy.height, copy.hidden] = [canvas.width, canvas.height, !on];
    if (on) copy.getContext("2d")!.drawImage(canvas, 0, 0);
  }

  function resize(): void {
    if (onPaper !== isPaper()) return paper(isPaper());
    dress();
    size();
  }
  listen(canvas, "webglcontextrestored", invalidate);
  speed.value = "1";
  pause();
  slider.value = String(Math.log10(scene.magnification));
  magnify(scene.magnification);
  view.turn(0, 0);
  dress();
  size();
  if (isPaper()) paper(true);

  /** Take runs that are new, or have other points; a new one shows itself. */
  function update(): void {
    for (const run of scene.runs.slice(runs.length)) {
      const one = added(run, runs.length);
      runs.push(one);
      one.halo.width(6 * dense);
      show(one, true);
      list();
    }
    runs.filter(({ run, of }) => run.size !== of).forEach(one => {
      const { places, index } = Object.assign(one, drawnOf(one.run));
      if (chosen?.run === one.run) chosen = null;
      one.lines.fill(places, index);
      one.halo.fill(places, index.slice());
    });
    move();
    dress();
  }

  return {
    highlight,
    resize,
    update,
    destroy() {
      gone.abort();
      pause();
      cancelAnimationFrame(frame);
      clearTimeout(settling);
      inView.disconnect();
      gl.destroy();
      root.adoptedStyleSheets = root.adoptedStyleSheets.filter(sheet => sheet !== look);
      host.classList.remove("cl-path");
      host.replaceChildren();
    },
  };
}
