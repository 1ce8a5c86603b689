"use strict";
// Draw each message of the page when it comes near the window. Scripts load in pages that are opened from a file, too; data do not.
(function () {
  const home = document.currentScript.src.replace(/[^/]*$/, "");
  const loaded = new Map();
  const load = name => {
    if (!loaded.has(name)) {
      loaded.set(name, new Promise((done, failed) => {
        const script = document.createElement("script");
        Object.assign(script, { src: home + name, onload: done, onerror: () => failed(new Error(name + " is missing")) });
        document.head.append(script);
      }));
    }
    return loaded.get(name);
  };
  const show = async place => {
    const name = place.dataset.message;
    await Promise.all([load("viewer.js"), load("message-" + name + ".js")]);
    const message = await contourlab.unpacked(Uint8Array.from(atob(contourlabMessages[name]), c => c.charCodeAt(0)));
    place.replaceChildren();
    contourlab.show(place, message);
  };
  const watch = new IntersectionObserver(entries => entries.filter(entry => entry.isIntersecting).forEach(({ target }) => {
    watch.unobserve(target);
    show(target).catch(error => target.append("The viewer needs a browser of 2023 or later: " + error.message));
  }), { rootMargin: "600px 0px" });
  document.querySelectorAll(".viewer[data-message]").forEach(place => watch.observe(place));
}());
