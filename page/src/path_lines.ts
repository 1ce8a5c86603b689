/**
 * The lines of the path on the graphics card. One shader draws all: a point is foot + magnification * error, so a new magnification is one
 * uniform. They are plain GL lines, a pixel wide; wider ones are drawn several times, each a pixel further.
 */
import {
  BufferAttribute, GLSL3, InstancedBufferGeometry, LineSegments, OrthographicCamera, Scene, ShaderMaterial, Vector2, Vector3, Vector4, WebGLRenderer,
} from "three";
import type { Numbers } from "./contract";

export type Values = Numbers["values"];
export type Point = [number, number, number];

const VERTEX = `
in vec3 foot, error, tangent;
in float size;
uniform float magnification, side, top;
uniform vec3 view;
uniform vec2 pixel;
uniform int wide;
out float share;
void main() {
  share = size / top;
  vec3 beside = cross(tangent, view);
  float l = length(beside);
  vec3 off = l > 1e-6 ? beside * (side / l) : vec3(0.0);
  gl_Position = projectionMatrix * viewMatrix * vec4(foot + magnification * (error + off), 1.0);
  gl_Position.xy += (vec2(gl_InstanceID % wide, gl_InstanceID / wide) - 0.5 * float(wide - 1)) * pixel;
}`;
const FRAGMENT = `
in float share;
uniform vec3 scale[9];
uniform vec4 paint;
out vec4 colour;
void main() {
  float x = 8.0 * clamp(share, 0.0, 1.0);
  int i = min(int(x), 7);
  colour = vec4(mix(paint.rgb, mix(scale[i], scale[i + 1], x - float(i)), paint.a), 1.0);
}`;
const VIRIDIS = ["#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725"].map(rgb);

/** Return the parts, 0 to 1, of a colour #rrggbb. */
export function rgb(hex: string): Point {
  const value = parseInt(hex.trim().slice(1), 16);
  return [(value >> 16) / 255, ((value >> 8) & 255) / 255, (value & 255) / 255];
}

export const mix = (a: Point, b: Point, f: number): Point => [a[0] + (b[0] - a[0]) * f, a[1] + (b[1] - a[1]) * f, a[2] + (b[2] - a[2]) * f];

/** Return nine colours, from no error to the largest, which stands out: dark on white, bright on black. */
export function scaleColours(dark: boolean): Point[] {
  const [from, to] = dark ? [2, 8] : [6.2, 0];
  return VIRIDIS.map((_, k) => {
    const x = from + ((to - from) * k) / 8, i = Math.min(Math.floor(x), 7);
    return mix(VIRIDIS[i], VIRIDIS[i + 1], x - i);
  });
}

/** Return whether the processor draws, for lack of a graphics card. */
export function drawsInSoftware(): boolean {
  const context = new OffscreenCanvas(1, 1).getContext("webgl2"), info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? String(context!.getParameter(info.UNMASKED_RENDERER_WEBGL)) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/** Return the neighbours (i, i + 1) that are joined, as an index of line segments. */
export function pairs(count: number, joined: (i: number) => boolean): Uint32Array {
  const index: number[] = [];
  for (let i = 0; i + 1 < count; i += 1) if (joined(i)) index.push(i, i + 1);
  return Uint32Array.from(index);
}

/** Return numbers about a centre, in another unit, for the graphics card. */
export function attribute(values: Values, parts: number, centre: Point = [0, 0, 0], unit = 1): BufferAttribute {
  return new BufferAttribute(Float32Array.from(values, (value, i) => (value - centre[i % parts]) * unit), parts);
}

/** Return unit vectors along a path (n, 3); where points are closer than `least`, that of the point before, or at the start the first. */
export function tangents(path: Values, least: number): BufferAttribute {
  const end = path.length - 3, along = new Float32Array(path.length);
  for (let i = 0; i <= end; i += 3) {
    const before = Math.max(i - 3, 0), after = Math.min(i + 3, end);
    const step = [0, 1, 2].map(k => path[after + k] - path[before + k]), length = Math.hypot(...step);
    if (length > least) along.set(step.map(part => part / length), i); else along.copyWithin(i, i - 3, i);
  }
  const first = along.findIndex(part => part !== 0), start = first - (first % 3);
  for (let i = 0; i < start; i += 3) along.copyWithin(i, start, start + 3);
  return new BufferAttribute(along, 3);
}

/** Lines of one kind. */
export class Lines {
  readonly object: LineSegments<InstancedBufferGeometry, ShaderMaterial>;
  private readonly own: { side: { value: number }; paint: { value: Vector4 }; wide: { value: number } };

  /** Runs hide one another; all other lines lie below them, in their order. */
  constructor(shared: object, attributes: Record<string, BufferAttribute>, index: Uint32Array, order: number, side = 0) {
    const geometry = new InstancedBufferGeometry();
    this.own = { side: { value: side }, paint: { value: new Vector4() }, wide: { value: 1 } };
    const isRun = order >= RUN, uniforms = { ...shared, ...this.own };
    const looks = { glslVersion: GLSL3, vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms };
    const material = new ShaderMaterial({ ...looks, depthTest: isRun, depthWrite: isRun });
    this.object = new LineSegments(geometry, material);
    this.object.frustumCulled = false;
    this.fill(attributes, index);
    this.object.renderOrder = order;
    this.width(1);
  }

  /** Take one colour, or that of the error. */
  paint(colour: Point | null): void { this.own.paint.value.set(...(colour ?? [0, 0, 0] as Point), colour ? 0 : 1); }

  /** Take other points and segments. */
  fill(attributes: Record<string, BufferAttribute>, index: Uint32Array): void {
    const { geometry } = this.object;
    geometry.dispose();  // of the graphics card's copies
    for (const [name, values] of Object.entries(attributes)) geometry.setAttribute(name, values);
    geometry.setIndex(new BufferAttribute(index, 1));
    geometry.setDrawRange(0, Infinity);
  }

  width(pixels: number): void {
    this.own.wide.value = pixels;
    this.object.geometry.instanceCount = pixels * pixels;
  }

  /** Draw some of the segments that there were at first. */
  only(part: number[]): void {
    const index = this.object.geometry.index!;
    index.array.set(part);
    index.clearUpdateRanges();
    index.addUpdateRange(0, part.length);
    index.needsUpdate = true;
    this.object.geometry.setDrawRange(0, part.length);
    this.object.visible = part.length > 0;
  }
}

export const RUN = 9;

export class Canvas {
  readonly camera = new OrthographicCamera();
  readonly scene = new Scene();
  readonly renderer: WebGLRenderer;
  readonly uniforms = {
    magnification: { value: 1 }, view: { value: new Vector3() }, pixel: { value: new Vector2() }, top: { value: 1 },
    scale: { value: VIRIDIS.map(() => new Vector3()) },
  };

  constructor(canvas: HTMLCanvasElement, context: WebGL2RenderingContext) {
    this.renderer = new WebGLRenderer({ canvas, context });
    this.renderer.setClearColor(0, 0);
  }

  add(attributes: Record<string, BufferAttribute>, index: Uint32Array, order: number, side = 0): Lines {
    const lines = new Lines(this.uniforms, attributes, index, order, side);
    this.scene.add(lines.object);
    return lines;
  }

  destroy(): void {
    for (const { geometry, material } of this.scene.children as Lines["object"][]) { geometry.dispose(); material.dispose(); }
    this.renderer.dispose();
    this.renderer.forceContextLoss();  // a page has some 16
  }
}
