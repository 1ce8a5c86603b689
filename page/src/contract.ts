// Written by hand until tools/page_contract.py is here: the same shape, of the classes that path.ts draws.

/** An array, unpacked: its numbers row by row, and its shape. */
export interface Numbers { values: Float32Array | Float64Array | Int32Array; shape: number[] }

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
