/** From where the path is seen: parallel, from azimuth and elevation; z points up. */
import type { OrthographicCamera } from "three";
import type { Point, Values } from "./path_lines";

export const point = (values: Values, i: number): Point => [values[3 * i], values[3 * i + 1], values[3 * i + 2]];
const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** Width and height of the key of colours [px], at the top left. */
const KEY: [number, number] = [210, 52];
const DEGREE = Math.PI / 180;

export class View {
  /** The stage [px], how much of the path fills its height [mm], and the point in its middle [mm]. */
  width = 0;
  height = 0;
  span: number;
  target: Point;
  /** To the right, up, and to the viewer. */
  right: Point = [1, 0, 0];
  up: Point = [0, 1, 0];
  back: Point = [0, 0, 1];

  /** Azimuth and elevation are in degrees; `changed` is called after each change. */
  constructor(
    private readonly path: Values, private readonly centre: Point, private readonly extent: number,
    private azimuth: number, private elevation: number, private readonly changed: () => void,
  ) {
    this.span = extent;
    this.target = centre;
  }

  /** Turn by degrees. */
  turn(across: number, upward: number): void { this.from(this.azimuth - across, this.elevation + upward); }

  from(azimuth: number, elevation: number): void {
    this.azimuth = azimuth;
    this.elevation = Math.min(Math.max(elevation, -90), 90);
    const [cos, sin] = [Math.cos(azimuth * DEGREE), Math.sin(azimuth * DEGREE)], e = this.elevation * DEGREE;
    this.right = [-sin, cos, 0];
    this.up = [-Math.sin(e) * cos, -Math.sin(e) * sin, Math.cos(e)];
    this.back = [Math.cos(e) * cos, Math.cos(e) * sin, Math.sin(e)];
    this.changed();
  }

  /** Show the whole path, with room [mm] for its errors, and for labels; a wide one lies below the key of colours. */
  fit(room: number): void {
    const [[left, wide], [bottom, tall]] = [this.right, this.up].map(along => {
      let from = Infinity, to = -Infinity;
      for (let i = 0; i < this.path.length / 3; i += 1) {
        const at = dot(point(this.path, i), along);
        from = Math.min(from, at);
        to = Math.max(to, at);
      }
      return [(from + to) / 2, to - from + 2 * room];
    });
    this.target = [0, 1, 2].map(k => left * this.right[k] + bottom * this.up[k] + dot(this.centre, this.back) * this.back[k]) as Point;
    const across = (wide * this.height) / this.width / Math.max(1 - 48 / this.width, 0.5);
    const spanOf = (used: number): number => Math.max(tall / Math.max(1 - used / this.height, 0.5), across, 1e-3 * this.extent);
    this.span = spanOf(64);
    if (this.width - (wide * this.height) / this.span < 2 * KEY[0]) {
      this.span = spanOf(64 + KEY[1]);
      this.shift(0, KEY[1] / 2);
    }
    this.changed();
  }

  /** Return the pixel of a point [mm]. */
  project(at: Point): [number, number] {
    const k = this.height / this.span, off: Point = [at[0] - this.target[0], at[1] - this.target[1], at[2] - this.target[2]];
    return [this.width / 2 + k * dot(off, this.right), this.height / 2 - k * dot(off, this.up)];
  }

  holds([x, y]: [number, number]): boolean { return x >= 0 && y >= 0 && x <= this.width && y <= this.height; }

  /** Move the picture by pixels. */
  shift(dx: number, dy: number): void {
    this.target = this.target.map((part, i) => part - (this.span / this.height) * (this.right[i] * dx - this.up[i] * dy)) as Point;
    this.changed();
  }

  /** Show `factor` times as much; the point under a pixel stays. */
  zoom(factor: number, x = this.width / 2, y = this.height / 2): void {
    const next = Math.min(Math.max(this.span * factor, 1e-6 * this.extent), 50 * this.extent), part = 1 - next / this.span;
    this.shift((this.width / 2 - x) * part, (this.height / 2 - y) * part);
    this.span = next;
  }

  /** Set a camera, for lines about the centre, that sees what is nearer than `far` [mm] to the target. */
  aim(camera: OrthographicCamera, far: number): void {
    const at = this.target.map((part, k) => part - this.centre[k]) as Point, tall = this.span / 2, wide = (tall * this.width) / this.height;
    Object.assign(camera, { top: tall, bottom: -tall, right: wide, left: -wide, near: 0, far: 2 * far });
    camera.position.set(at[0] + this.back[0] * far, at[1] + this.back[1] * far, at[2] + this.back[2] * far);
    camera.up.set(...this.up);
    camera.lookAt(...at);
    camera.updateProjectionMatrix();
  }
}
