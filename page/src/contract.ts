// Written by tools/page_contract.py from the classes in contourlab.rendering.charts. Do not edit.

/** An array, unpacked: its numbers row by row, and its shape. */
export interface Numbers { values: Float32Array | Float64Array | Int32Array | Uint8Array; shape: number[] }

export const CONTRACT = "contourlab-page/1";

/** Panels above one another with a common x axis. */
export interface Chart {
  kind: "Chart";
  key: string;
  title: string;
  caption: string;
  panels: Panel[];
  panel_height: number;
  loops: boolean;
}

/** One pair of axes. */
export interface Panel {
  kind: "Panel";
  x_label: string;
  y_label: string;
  curves: Curve[];
  levels: Level[];
  band: [number, number] | null;
  band_label: string;
  span: [number, number] | null;
  span_label: string;
  ticks: Tick[];
  log_x: boolean;
  log_y: boolean;
  y_range: [number, number] | null;
  far: boolean;
  y_ticks: [number, string][];
}

/** One line, in the units of its panel. */
export interface Curve {
  kind: "Curve";
  x: Numbers;
  y: Numbers;
  name: string;
  colour: string;
  dash: string;
  width: number;
  half: Numbers | null;
  numbers: Numbers | null;
}

/** A limit: a horizontal line at `value` with its text. */
export interface Level {
  kind: "Level";
  value: number;
  label: string;
}

/** A mark on the x axis; its label appears on hover. */
export interface Tick {
  kind: "Tick";
  x: number;
  label: string;
  mark: string;
}

/** Radial deviation around a circle; the nominal circle is where the deviation is 0. */
export interface PolarChart {
  kind: "PolarChart";
  key: string;
  title: string;
  caption: string;
  curves: Curve[];
  radius: number;
  marks: Curve[];
}

/** The path in space, and the runs along it. */
export interface PathScene {
  kind: "PathScene";
  key: string;
  title: string;
  caption: string;
  axes: string[];
  path: Numbers;
  lines: Numbers;
  judged: Numbers;
  unjudged: string;
  runs: SceneRun[];
  tolerance: number | null;
  magnification: number;
}

/** A run in space, thinned; its figures cover the stretches with a number, and lines join only points of the same one. */
export interface SceneRun {
  kind: "SceneRun";
  name: string;
  colour: string;
  foot: Numbers;
  error: Numbers;
  size: Numbers;
  time: Numbers;
  feedrate: Numbers;
  lines: Numbers;
  stretch: Numbers;
  worst: Place[];
}

/** A place of a run where the error is large. */
export interface Place {
  kind: "Place";
  foot: number[];
  error: number[];
  size: number;
  time: number;
  line: number;
  cause: string;
}

/** A value in each cell of a grid (n_y, n_x), in colours; NaN is dark. */
export interface Heat {
  kind: "Heat";
  key: string;
  title: string;
  caption: string;
  x_label: string;
  y_label: string;
  unit: string;
  x_names: string[];
  y_names: string[];
  values: Numbers;
  low: number;
  high: number;
  colours: [number, string][];
}

/** The runs of a circle test, with a slider for each cause that scales its curve. */
export interface CircleCauses {
  kind: "CircleCauses";
  key: string;
  title: string;
  caption: string;
  axes: string[];
  causes: string[];
  runs: CircleTrace[];
  radius: number;
}

/** One run of a circle test. */
export interface CircleTrace {
  kind: "CircleTrace";
  name: string;
  colour: string;
  angle: Numbers;
  deviation: Numbers;
  curves: Numbers;
}

/** Runs whose parameters can be changed in the page. */
export interface LiveLoop {
  kind: "LiveLoop";
  key: string;
  title: string;
  caption: string;
  runs: LiveRun[];
  command: string;
}

/** A run of the report as a WebAssembly module; places are words of 8 bytes. `contourlab.loop.PortableLoop` says how to run it. */
export interface LiveRun {
  kind: "LiveRun";
  name: string;
  code: Numbers;
  n_word: number;
  words: [number, Numbers][];
  motion: LiveMotion;
  inputs: number;
  ahead: number[];
  log: number;
  n_log: number;
  position: number[];
  part_error: number;
  foot: number;
  doubt: number;
  place: number;
  planning: number;
  asked: LivePath;
  judged: [number, number][];
  figures: [string, number][];
  failed_at: number;
  state: [number, number][];
  parameters: LiveParameter[];
  short: [number, number];
  controller: string;
}

/** A planned motion along a path, in spans of constant jerk. */
export interface LiveMotion {
  kind: "LiveMotion";
  period: number;
  n_sample: number;
  spans: Numbers;
  duration: number;
  length: number;
  path: LivePath;
}

/** A path in quintic pieces. */
export interface LivePath {
  kind: "LivePath";
  start: Numbers;
  coefficients: Numbers;
  closed: boolean;
}

/** A parameter that can be changed. */
export interface LiveParameter {
  kind: "LiveParameter";
  name: string;
  word: number;
  value: number | null;
  unit: string;
  display: string;
  factor: number;
  minimum: number | null;
  maximum: number | null;
  exclusive: boolean;
  whole: boolean;
  first: boolean;
}

export type Picture = Chart | PolarChart | PathScene | Heat | CircleCauses | LiveLoop;
