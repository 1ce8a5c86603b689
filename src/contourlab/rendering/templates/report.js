"use strict";
(function () {
  let figures = {};
  // List the allowed buttons: the default set of plotly.js includes an upload of the data.
  const flat = [["zoom2d", "pan2d", "zoomIn2d", "zoomOut2d", "resetScale2d"], ["toImage"]];
  const space = [["orbitRotation", "pan3d", "resetCameraDefault3d"], ["toImage"]];
  const config = { displaylogo: false, showSendToCloud: false, plotlyServerURL: "", responsive: true,
    toImageButtonOptions: { format: "svg", filename: "contourlab" } };
  const steps = [1, 2, 5], axes = ["x", "y", "z"];
  const pathPlots = function () { return Array.from(document.querySelectorAll("#path .plot[data-drawn]")); };
  let scale = null, picked = null;

  function bytes(text) { return Uint8Array.from(atob(text), function (c) { return c.charCodeAt(0); }); }

  function decode(array) {
    const buffer = bytes(array.bdata).buffer;
    return array.dtype === "f8" ? new Float64Array(buffer) : array.dtype === "i4" ? new Int32Array(buffer) : new Float32Array(buffer);
  }

  // --- figures and library, compressed in the page ------------------------------------------------------------------------------------

  async function unpacked(id) {
    const packed = new Blob([bytes(document.getElementById(id).textContent)]);
    return new Response(packed.stream().pipeThrough(new DecompressionStream("gzip"))).text();
  }

  async function load() {
    figures = JSON.parse(await unpacked("figures"));
    const script = document.createElement("script");
    script.textContent = await unpacked("library");
    document.head.append(script);
  }

  // --- pictures ------------------------------------------------------------------------------------------------------------------------

  // foot point [mm] + magnified error [um], a column for each axis
  function enlarged(curve) {
    return curve.foot.map(function (foot, column) {
      const error = curve.error[column];
      return foot.map(function (place, i) { return place + error[i] * 1e-3 * scale; });
    });
  }

  // On a narrow screen a legend has more rows than planned: make room for it between buttons and panels.
  function makeRoom(place, layout) {
    const legend = place.querySelector("g.legend"), margin = layout.margin;
    if (!legend || layout.legend.orientation !== "h") { return; }
    const label = (layout.legend.y - 1) * (layout.height - margin.t - margin.b);
    const missing = Math.ceil(24 + legend.getBBox().height + label - margin.t);
    if (missing > 4) { Plotly.relayout(place, { "margin.t": margin.t + missing, height: layout.height + missing }); }
  }

  function draw(place) {
    const spec = figures[place.id];
    if (!spec || place.dataset.drawn || place.closest("[hidden], details:not([open])")) { return; }
    place.dataset.drawn = "1";
    if (spec.magnify) {
      spec.magnify.curves.forEach(function (curve) {
        ["foot", "error"].forEach(function (key) { curve[key] = curve[key].map(decode).map(function (c) { return Float64Array.from(c); }); });
        enlarged(curve).forEach(function (column, k) { spec.data[curve.trace][axes[k]] = column; });
      });
    }
    (spec.numbered || []).forEach(function (entry) { entry.line = decode(entry.line); });
    spec.data.forEach(function (trace) {  // plotly.js takes typed arrays as places, not as colours
      if (trace.line && trace.line.color && trace.line.color.bdata) { trace.line.color = Array.from(decode(trace.line.color)); }
    });
    if (spec.magnify && window.innerWidth < 700) {
      spec.layout.showlegend = false;
      spec.layout.height = Math.min(spec.layout.height, place.clientWidth);
      place.style.minHeight = place.style.height = spec.layout.height + "px";
    }
    const more = Object.assign({ scrollZoom: Boolean(spec.magnify), modeBarButtons: spec.layout.scene ? space : flat }, config);
    Plotly.newPlot(place, spec.data, spec.layout, more).then(function () {
      makeRoom(place, spec.layout);
      if (spec.numbered) { place.on("plotly_click", function (event) { pickPoint(spec, event.points[0]); }); }
      if (picked !== null) { highlight(place, picked); }
    }).catch(function (error) { place.textContent = "This picture could not be drawn: " + error.message; });
  }

  function showScale() {
    const magnify = Object.values(figures).map(function (spec) { return spec.magnify; }).filter(Boolean)[0];
    document.getElementById("magnification").textContent = "error × " + scale.toLocaleString("en").replace(/,/g, "\u2009");
    const worth = magnify.bar * 1e3 / scale;
    document.getElementById("bar").textContent = magnify.bar + " mm from the path = " + Number(worth.toPrecision(3)) + " um of error";
  }

  // 1, 2, 5, 10, 20, 50 ...: the next step up or down
  function next(value, way) {
    let power = Math.floor(Math.log10(value) + 1e-9), digit = steps.indexOf(Math.round(value / Math.pow(10, power))) + way;
    if (digit < 0) { digit = 2; power -= 1; }
    if (digit > 2) { digit = 0; power += 1; }
    return Math.max(1, steps[digit] * Math.pow(10, power));
  }

  function rescale(way) {
    scale = next(scale, way);
    showScale();
    pathPlots().forEach(function (place) {
      const curves = figures[place.id].magnify.curves, columns = curves.map(enlarged), update = {};
      columns[0].forEach(function (_, k) { update[axes[k]] = columns.map(function (c) { return c[k]; }); });
      Plotly.restyle(place, update, curves.map(function (c) { return c.trace; }));
    });
  }

  function show(button) {
    document.querySelectorAll("[data-view]").forEach(function (other) { other.setAttribute("aria-selected", String(other === button)); });
    document.querySelectorAll(".view").forEach(function (view) { view.hidden = view.dataset.of !== button.dataset.view; });
    draw(document.getElementById(button.dataset.view));
  }

  // --- program lines: from the path to the line and back -----------------------------------------------------------------------------

  function pickPoint(spec, point) {
    const entry = spec.numbered.find(function (one) { return one.trace === point.curveNumber; });
    if (entry && entry.line[point.pointNumber] > 0) { pick(entry.line[point.pointNumber], true); }
  }

  function pick(line, scroll) {
    picked = line;
    document.querySelectorAll("#lines tr.picked").forEach(function (row) { row.classList.remove("picked"); });
    const row = document.querySelector("#lines tr[data-line='" + line + "']");
    const note = document.getElementById("picked");
    note.textContent = "Line " + line + (row ? ": " + row.querySelector("code").textContent : " is not in the table");
    if (row) {
      row.classList.add("picked");
      const box = row.closest(".lines");
      if (scroll) { box.scrollTop = row.offsetTop - box.clientHeight / 2; }
    }
    pathPlots().forEach(function (place) { highlight(place, line); });
  }

  // Draw the part of the path that a line programs: its points, and the point after them.
  function highlight(place, line) {
    const spec = figures[place.id], last = spec.data.length - 1, outline = spec.numbered && spec.numbered[0];
    if (!outline) { return; }
    const columns = axes.slice(0, spec.layout.scene ? 3 : 2), update = {};
    columns.forEach(function (axis) {
      const given = place.data[outline.trace][axis], all = given.bdata ? decode(given) : given, chosen = [];
      outline.line.forEach(function (number, i) {
        if (number === line || (i > 0 && outline.line[i - 1] === line)) { chosen.push(all[i]); }
        else if (chosen.length && chosen[chosen.length - 1] !== null) { chosen.push(null); }
      });
      update[axis] = [chosen];
    });
    Plotly.restyle(place, update, [last]);
  }

  function sort(head) {
    const table = head.closest("table"), column = head.cellIndex, body = table.tBodies[0];
    const down = head.getAttribute("aria-sort") !== "descending";
    const value = function (row) { const text = row.cells[column].textContent; return text === "-" ? -Infinity : Number(text); };
    table.querySelectorAll("th").forEach(function (other) { other.removeAttribute("aria-sort"); });
    head.setAttribute("aria-sort", down ? "descending" : "ascending");
    Array.from(body.rows).sort(function (a, b) { return (down ? -1 : 1) * (value(a) - value(b)) || 0; }).forEach(function (row) { body.append(row); });
  }

  // --- the page ------------------------------------------------------------------------------------------------------------------------

  function openFor(address) {
    const target = address && document.querySelector(address), fold = target && target.querySelector("details");
    if (fold) { fold.open = true; }
  }

  document.querySelectorAll("nav a").forEach(function (a) { a.addEventListener("click", function () { openFor(a.getAttribute("href")); }); });
  document.querySelectorAll("#lines th button").forEach(function (b) { b.addEventListener("click", function () { sort(b.closest("th")); }); });
  document.querySelectorAll("#lines tbody tr").forEach(function (row) {
    row.addEventListener("click", function () { pick(Number(row.dataset.line), false); });
  });
  openFor(location.hash);

  load().then(function () {
    const first = Object.values(figures).filter(function (spec) { return spec.magnify; })[0];
    if (first) { scale = first.magnify.start; showScale(); }
    document.querySelectorAll("[data-step]").forEach(function (b) { b.addEventListener("click", function () { rescale(Number(b.dataset.step)); }); });
    document.querySelectorAll("[data-view]").forEach(function (b) { b.addEventListener("click", function () { show(b); }); });
    // Draw each picture when it comes near the window, so that a long page opens quickly.
    const watch = new IntersectionObserver(function (entries) {
      entries.forEach(function (entry) { if (entry.isIntersecting) { watch.unobserve(entry.target); draw(entry.target); } });
    }, { rootMargin: "800px 0px" });
    const places = Array.from(document.querySelectorAll(".plot"));
    places.forEach(function (place) { watch.observe(place); });
    window.addEventListener("beforeprint", function () { places.forEach(draw); });
  }).catch(function (error) { document.getElementById("trouble").textContent = "The pictures need a browser of 2023 or later: " + error.message; });
}());
