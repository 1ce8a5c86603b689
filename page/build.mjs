// Build the viewer: node build.mjs [FOLDER]. The bundle and the licences of its parts go to the package.
import { readFile, writeFile, mkdir } from "node:fs/promises";
import { build } from "esbuild";

const folder = process.argv[2] ?? "../src/contourlab/rendering/viewer";
await mkdir(folder, { recursive: true });
const options = { bundle: true, minify: true, format: "iife", target: "es2022", charset: "utf8", legalComments: "none", loader: { ".css": "text" } };
/** `import text from "./module?text"`: the script of a worker. */
const scripts = {
  name: "scripts",
  setup(of) {
    of.onResolve({ filter: /\?text$/ }, ({ path, resolveDir }) => ({ path: `${resolveDir}/${path.slice(0, -5)}.ts`, namespace: "script" }));
    of.onLoad({ filter: /./, namespace: "script" }, async ({ path }) => {
      const made = await build({ ...options, entryPoints: [path], write: false });
      return { contents: made.outputFiles[0].text, loader: "text" };
    });
  },
};
await build({ ...options, entryPoints: ["src/main.ts"], globalName: "contourlab", plugins: [scripts], outfile: `${folder}/viewer.js` });
const used = JSON.parse(await readFile("package.json", "utf8")).dependencies;
const texts = await Promise.all(Object.entries(used).map(async ([name, version]) =>
  `${name} ${version}\n\n${(await readFile(`node_modules/${name}/LICENSE`, "utf8")).replaceAll("\r", "").trim()}\n`));
await writeFile(`${folder}/LICENSES`, `viewer.js contains:\n\n${texts.join("\n\n")}`);
