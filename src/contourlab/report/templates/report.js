"use strict";
(function () {
  const figures = JSON.parse(document.getElementById("figures").textContent);
  // List the allowed buttons: the default set of plotly.js includes an upload of the data.
  const buttons = [["zoom2d", "pan2d", "zoomIn2d", "zoomOut2d", "resetScale2d"], ["toImage"]];
  const config = { displaylogo: false, showSendToCloud: false, plotlyServerURL: "", responsive: true, modeBarButtons: buttons,
    toImageButtonOptions: { format: "svg", filename: "contourlab" } };
  const steps = [1, 2, 5];
  let scale = null;

  function decode(array) {
    const bytes = Uint8Array.from(atob(array.bdata), function (c) { return c.charCodeAt(0); });
    return array.dtype === "f8" ? new Float64Array(bytes.buffer) : new Float32Array(bytes.buffer);
  }

  // foot point [mm] + magnified error [um]
  function enlarged(curve, column) {
    const foot = curve.foot[column], error = curve.error[column], out = new Float64Array(foot.length);
    for (let i = 0; i < foot.length; i += 1) { out[i] = foot[i] + error[i] * 1e-3 * scale; }
    return out;
  }

  function unpack(magnify) {
    magnify.curves.forEach(function (curve) {
      curve.foot = curve.foot.map(decode);
      curve.error = curve.error.map(decode);
    });
  }

  function draw(place) {
    const spec = figures[place.id];
    if (!spec || place.dataset.drawn || place.closest("[hidden]")) { return; }
    place.dataset.drawn = "1";
    if (spec.magnify) {
      unpack(spec.magnify);
      spec.magnify.curves.forEach(function (curve) {
        spec.data[curve.trace].x = enlarged(curve, 0);
        spec.data[curve.trace].y = enlarged(curve, 1);
      });
    }
    const more = spec.magnify ? Object.assign({ scrollZoom: true }, config) : config;
    Plotly.newPlot(place, spec.data, spec.layout, more).catch(function (error) {
      place.textContent = "This picture could not be drawn: " + error.message;
    });
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
    document.querySelectorAll("#path .plot[data-drawn]").forEach(function (place) {
      const curves = figures[place.id].magnify.curves;
      Plotly.restyle(place, { x: curves.map(function (c) { return enlarged(c, 0); }), y: curves.map(function (c) { return enlarged(c, 1); }) },
        curves.map(function (c) { return c.trace; }));
    });
  }

  function show(button) {
    document.querySelectorAll("[data-view]").forEach(function (other) { other.setAttribute("aria-selected", String(other === button)); });
    document.querySelectorAll(".view").forEach(function (view) { view.hidden = view.dataset.of !== button.dataset.view; });
    draw(document.getElementById(button.dataset.view));
  }

  const places = Array.from(document.querySelectorAll(".plot"));
  const first = Object.values(figures).filter(function (spec) { return spec.magnify; })[0];
  if (first) { scale = first.magnify.start; showScale(); }
  document.querySelectorAll("[data-step]").forEach(function (b) { b.addEventListener("click", function () { rescale(Number(b.dataset.step)); }); });
  document.querySelectorAll("[data-view]").forEach(function (b) { b.addEventListener("click", function () { show(b); }); });

  // Draw each picture when it comes near the window, so that a long page opens quickly.
  const watch = new IntersectionObserver(function (entries) {
    entries.forEach(function (entry) { if (entry.isIntersecting) { watch.unobserve(entry.target); draw(entry.target); } });
  }, { rootMargin: "800px 0px" });
  places.forEach(function (place) { watch.observe(place); });
  window.addEventListener("beforeprint", function () { places.forEach(draw); });
}());
