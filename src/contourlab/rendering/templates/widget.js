// The viewer in a notebook, by the contract of anywidget. All widgets of a page share one script.
const viewers = (globalThis.contourlabViewers ??= {});
async function load(packed) {
  const script = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"))).text();
  const module = new Blob([script, "\nexport default contourlab;"], { type: "text/javascript" });
  return (await import(URL.createObjectURL(module))).default;
}
export default {
  async render({ model, el }) {
    return (await (viewers["DIGEST"] ??= load(model.get("viewer")))).render({ model, el });
  },
};
