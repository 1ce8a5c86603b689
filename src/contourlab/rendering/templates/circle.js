"use strict";
// The polar picture of a circle test: each slider scales the curve of one cause.
const data = JSON.parse(document.getElementById("data").textContent);
const svg = document.getElementById("polar"), MIDDLE = 300, NOMINAL = 190, BAND = 95;
const kept = data.causes.map(() => 1);

const deviations = run => run.deviation.map((d, i) => run.curves.reduce((sum, curve, k) => sum - (1 - kept[k]) * curve[i], d));

// Largest less smallest distance from the least-squares centre of all runs.
function circular(all) {
  let cc = 0, cs = 0, ss = 0, c1 = 0, s1 = 0, n = 0, dc = 0, ds = 0, d1 = 0;
  data.runs.forEach((run, r) => run.angle.forEach((a, i) => {
    const c = Math.cos(a), s = Math.sin(a), d = all[r][i];
    cc += c * c; cs += c * s; ss += s * s; c1 += c; s1 += s; n += 1; dc += d * c; ds += d * s; d1 += d;
  }));
  cc -= c1 * c1 / n; ss -= s1 * s1 / n; cs -= c1 * s1 / n; dc -= d1 * c1 / n; ds -= d1 * s1 / n;
  const det = cc * ss - cs * cs, x = (dc * ss - ds * cs) / det, y = (ds * cc - dc * cs) / det;
  let low = Infinity, high = -Infinity;
  data.runs.forEach((run, r) => run.angle.forEach((a, i) => {
    const d = all[r][i] - x * Math.cos(a) - y * Math.sin(a);
    low = Math.min(low, d); high = Math.max(high, d);
  }));
  return high - low;
}

const measured = data.runs.map(deviations);
const largest = Math.max(...measured.map(d => d.reduce((most, v) => Math.max(most, Math.abs(v)), 0)), 1e-6);
const power = 10 ** Math.floor(Math.log10(largest));
const ring = [1, 2, 5, 10].map(k => k * power).find(k => k * 2 >= largest);
const scale = BAND / (2 * ring);

function element(name, values, text) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const key in values) made.setAttribute(key, values[key]);
  if (text) made.textContent = text;
  svg.appendChild(made);
  return made;
}

function line(run, values) {
  return run.angle.map((a, i) => {
    const r = NOMINAL + scale * values[i];
    return (i ? "L" : "M") + (MIDDLE + r * Math.cos(a)).toFixed(2) + " " + (MIDDLE - r * Math.sin(a)).toFixed(2);
  }).join("");
}

for (let k = -2; k <= 2; k += 1) {
  const r = NOMINAL + scale * k * ring;
  element("circle", { cx: MIDDLE, cy: MIDDLE, r, fill: "none", stroke: k ? "#e4e8ec" : "#8a949e" });
  element("text", { x: MIDDLE + 4, y: MIDDLE - r - 3 }, (k > 0 ? "+" : "") + +(k * ring).toPrecision(3) + (k ? "" : " um"));
}
element("line", { x1: MIDDLE - 290, y1: MIDDLE, x2: MIDDLE + 290, y2: MIDDLE, stroke: "#e4e8ec" });
element("line", { x1: MIDDLE, y1: 10, x2: MIDDLE, y2: 590, stroke: "#e4e8ec" });
element("text", { x: 584, y: MIDDLE - 5 }, data.axes[0]);
element("text", { x: MIDDLE - 12, y: 18 }, data.axes[1]);
data.runs.forEach((run, r) => element("path", { d: line(run, measured[r]), fill: "none", stroke: run.colour, "stroke-opacity": 0.25 }));
const paths = data.runs.map(run => element("path", { fill: "none", stroke: run.colour, "stroke-width": 1.6 }));
document.getElementById("scale").textContent = "Grey circles are " + ring + " um apart.";
document.getElementById("measured").textContent = circular(measured).toPrecision(3) + " um";

function draw() {
  const all = data.runs.map(deviations);
  data.runs.forEach((run, r) => paths[r].setAttribute("d", line(run, all[r])));
  document.getElementById("left").textContent = circular(all).toPrecision(3) + " um";
}

const inputs = data.causes.map((name, k) => {
  const row = document.createElement("label"), text = document.createElement("span");
  const input = document.createElement("input"), output = document.createElement("output");
  row.className = "slider";
  text.textContent = name;
  Object.assign(input, { type: "range", min: 0, max: 100, value: 100 });
  input.setAttribute("value", 100);
  output.textContent = "100 %";
  input.addEventListener("input", () => { kept[k] = input.value / 100; output.textContent = input.value + " %"; draw(); });
  row.append(text, input, output);
  document.getElementById("sliders").appendChild(row);
  return input;
});
function all(value) {
  inputs.forEach(input => { input.value = value; input.dispatchEvent(new Event("input")); });
}
document.getElementById("all").addEventListener("click", () => all(0));
document.getElementById("none").addEventListener("click", () => all(100));
draw();
