// Errors and what the page did go into attributes of the root, which a dump of the document shows.
const report = (name, value) => document.documentElement.setAttribute(`data-${name}`, value);
const fail = (text) => report("errors", `${document.documentElement.dataset.errors || ""}[${text}]`);
addEventListener("error", (e) => fail(e.message));
addEventListener("unhandledrejection", (e) => fail(e.reason));
console.error = console.warn = (...texts) => fail(texts.join(" "));

const later = (ms = 60) => new Promise((done) => setTimeout(done, ms));
const pixels = (canvas) => canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
const differences = (a, b) => a.reduce((sum, x, i) => sum + (x !== b[i]), 0);
