"use strict";
// Unpack the viewer and the message, and draw.
(async function () {
  const unpacked = function (id) {
    const bytes = Uint8Array.from(atob(document.getElementById(id).textContent), function (c) { return c.charCodeAt(0); });
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
  };
  const script = document.createElement("script");
  script.textContent = await unpacked("viewer").text();
  document.head.append(script);
  contourlab.page(await unpacked("message").arrayBuffer());
}()).catch(function (error) {
  document.getElementById("trouble").textContent = "The pictures need a browser of 2023 or later: " + error.message;
});
