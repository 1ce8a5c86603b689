/** Read messages of contract contourlab-page/1: contourlab.rendering.message describes them. */
import { CONTRACT, type Numbers, type Picture } from "./contract";

/** Unpack a message. */
export const unpacked = (packed: BufferSource): Promise<ArrayBuffer> =>
  new Response(new Blob([packed as BlobPart]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();

/** Return the pictures of an unpacked message. */
export function pictures(buffer: ArrayBuffer): Picture[] {
  const length = new DataView(buffer).getUint32(0, true);
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, length)));
  if (header.contract !== CONTRACT) throw new Error(`message of ${header.contract}, this viewer reads ${CONTRACT}`);
  return header.pictures.map((picture: unknown) => filled(picture, buffer, 4 + length));
}

/** Replace each array's place by its numbers. */
function filled(value: any, buffer: ArrayBuffer, start: number): any {
  if (Array.isArray(value)) return value.map(item => filled(item, buffer, start));
  if (value === null || typeof value !== "object") return value;
  if ("dtype" in value) {
    const kinds = { f4: Float32Array, f8: Float64Array, i4: Int32Array, u1: Uint8Array };
    const size = value.shape.reduce((product: number, n: number) => product * n, 1);
    const Kind = kinds[value.dtype as keyof typeof kinds];
    return { values: new Kind(buffer, start + value.at, size), shape: value.shape } satisfies Numbers;
  }
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, filled(item, buffer, start)]));
}
