// Build the viewer: node build.mjs [FOLDER]. The bundle and the licences of its parts go to the package.
import { readFile, writeFile, mkdir } from "node:fs/promises";
import { build } from "esbuild";

const folder = process.argv[2] ?? "../src/contourlab/rendering/viewer";
await mkdir(folder, { recursive: true });
await build({
  entryPoints: ["src/main.ts"],
  bundle: true,
  minify: true,
  format: "iife",
  globalName: "contourlab",
  target: "es2022",
  charset: "utf8",
  legalComments: "none",
  loader: { ".css": "text" },
  outfile: `${folder}/viewer.js`,
});
const used = JSON.parse(await readFile("package.json", "utf8")).dependencies;
const texts = await Promise.all(Object.entries(used).map(async ([name, version]) =>
  `${name} ${version}\n\n${(await readFile(`node_modules/${name}/LICENSE`, "utf8")).replaceAll("\r", "").trim()}\n`));
await writeFile(`${folder}/LICENSES`, `viewer.js contains:\n\n${texts.join("\n\n")}`);
