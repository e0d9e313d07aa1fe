
/* ---- controls -------------------------------------------------------------------------------------------------- */

const clockDigits = Math.max(0, Math.min(12, 3 - Math.floor(Math.log10(end - begin || 1))));

function draw() {
  drawScene();
  charts.forEach(drawChart);
  byId("time").value = state.frame;
  const now = `${data.time[state.frame].toFixed(clockDigits)}`;
  byId("clock").innerHTML = `${signed(now)} s<small> / ${Number(end.toPrecision(4))}</small>`;
  byId("time").setAttribute("aria-valuetext", `${now} s`);
  byId("fit").hidden = isReset();
}

function redraw() {
  readColours();
  charts.forEach(plot);
  draw();
}

// The recorded instant at or before t: bars keep their lengths, as no instant between two records is made up.
function frameAt(t) {
  let low = 0, high = last;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (data.time[middle] <= t) low = middle; else high = middle - 1;
  }
  return low;
}
// The recorded instant next to t.
function frameNear(t) {
  const frame = frameAt(t);
  return frame < last && data.time[frame + 1] - t < t - data.time[frame] ? frame + 1 : frame;
}
function show(frame) { state.frame = Math.max(0, Math.min(last, frame)); state.clock = data.time[state.frame]; draw(); }

let before = 0;
function tick(now) {
  if (!state.playing) return;
  state.clock += Math.min(0.1, (now - before) / 1000) * state.speed;
  before = now;
  if (state.clock > end) state.clock = begin;
  const frame = frameAt(state.clock);
  if (frame !== state.frame) { state.frame = frame; draw(); }
  requestAnimationFrame(tick);
}
function play(on) {
  const was = state.playing;
  state.playing = on && last > 0;
  byId("play").setAttribute("aria-label", state.playing ? "Pause" : "Play");
  byId("play").querySelector("path").setAttribute("d", state.playing ? "M3.5 2h3v12h-3zM9.5 2h3v12h-3z" : "M4 1.8v12.4L14 8z");
  if (state.playing && !was) { before = performance.now(); requestAnimationFrame(tick); }
}

function fillSpeeds() {
  const span = end - begin || 1;
  // Real time where that is watchable, else the speed that shows the run in about ten seconds.
  state.speed = span >= 2 && span <= 60 ? 1 : Number((span / 10).toPrecision(1));
  const choices = [...new Set([0.1, 0.25, 0.5, 1, 2, 5, 10].map((m) => Number((m * state.speed).toPrecision(3))).concat(1))];
  for (const speed of choices.sort((a, b) => a - b)) {
    byId("speed").add(new Option(`${speed} ×`, speed, false, speed === state.speed));
  }
}

/* ---- legend ---------------------------------------------------------------------------------------------------- */

function chip(text, title, pressed, toggle) {
  const button = document.createElement("button");
  button.type = "button"; button.className = "chip"; button.title = title;
  button.setAttribute("aria-pressed", pressed);
  button.append(text);
  button.onclick = () => {
    button.setAttribute("aria-pressed", toggle());
    draw();
  };
  byId("legend").append(button);
  return button;
}

function buildLegend() {
  chip("Traces", "The ways of points", state.traces, () => (state.traces = !state.traces));
  if (arrows.length) {
    const unsure = data.redundant ? "; not unique, as rows are redundant" : "";
    chip("Reactions", `Forces of joints on the second partner${unsure}`, state.forces, () => (state.forces = !state.forces));
  }
  chip("Names", "Names of points", state.names, () => (state.names = !state.names));
  if (groups.length < 2 || groups.length > 12) return;
  const gap = document.createElement("span");
  gap.className = "gap";
  byId("legend").append(gap);
  groups.forEach((group, k) => {
    const many = bodies.filter((b) => b.group === k && !b.spring).length;
    const button = chip(many > 1 ? `${group} (${many})` : group, `Traces of ${group}`, true, () => {
      if (!state.hidden.delete(k)) state.hidden.add(k);
      return !state.hidden.has(k);
    });
    const swatch = document.createElement("i");
    swatch.style.background = `var(--c${k % 6})`;
    button.prepend(swatch);
  });
}

/* ---- colours of the page --------------------------------------------------------------------------------------- */

const dark = matchMedia("(prefers-color-scheme: dark)");
const THEMES = { auto: "Auto", light: "Light", dark: "Dark" };
let theme = "auto";
try { theme = localStorage.getItem("motion-theme") || theme; } catch { /* not everywhere allowed */ }
if (!(theme in THEMES)) theme = "auto";

function applyTheme() {
  document.documentElement.dataset.theme = theme === "auto" ? (dark.matches ? "dark" : "light") : theme;
  byId("theme").querySelector("span").textContent = THEMES[theme];
}
function nextTheme() {
  const names = Object.keys(THEMES);
  theme = names[(names.indexOf(theme) + 1) % names.length];
  try { localStorage.setItem("motion-theme", theme); } catch { /* not everywhere allowed */ }
  applyTheme();
  if (last >= 0) redraw();
}

/* ---- pointers and keys ----------------------------------------------------------------------------------------- */

function zoomAt(x, y, factor) {
  const canvas = byId("scene"), zoom = Math.max(0.2, Math.min(50, view.zoom * factor)), by = zoom / view.zoom;
  // What is under the pointer stays there.
  const from = camera(canvas.clientWidth, canvas.clientHeight);
  view.zoom = zoom;
  const centre = camera(canvas.clientWidth, canvas.clientHeight);
  view.pan[0] += x - (x - from.x0) * by - centre.x0;
  view.pan[1] += y - (y - from.y0) * by - centre.y0;
  if (!state.playing) draw();
}

// A pointer that is already gone cannot be held.
function hold(canvas, e) {
  try { canvas.setPointerCapture(e.pointerId); } catch { /* gone */ }
}

// One pointer turns the view in space and shifts it in the plane; two shift and zoom.
function moveView(canvas) {
  const pointers = new Map();
  const centre = () => {
    const all = [...pointers.values()], n = all.length;
    const x = all.reduce((s, p) => s + p[0], 0) / n, y = all.reduce((s, p) => s + p[1], 0) / n;
    return { x, y, spread: n > 1 ? Math.hypot(all[0][0] - all[1][0], all[0][1] - all[1][1]) : 0 };
  };
  canvas.addEventListener("pointerdown", (e) => { pointers.set(e.pointerId, [e.offsetX, e.offsetY]); hold(canvas, e); });
  for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (e) => pointers.delete(e.pointerId));
  canvas.addEventListener("pointermove", (e) => {
    if (!pointers.has(e.pointerId)) return;
    const from = centre();
    pointers.set(e.pointerId, [e.offsetX, e.offsetY]);
    const to = centre(), dx = to.x - from.x, dy = to.y - from.y;
    if (data.spatial && pointers.size === 1 && !e.shiftKey && e.buttons !== 4) {
      view.yaw -= dx * 0.008;
      view.pitch = Math.max(-1.57, Math.min(1.57, view.pitch + dy * 0.008));
    } else {
      view.pan[0] += dx; view.pan[1] += dy;
      if (from.spread > 0 && to.spread > 0) zoomAt(to.x, to.y, to.spread / from.spread);
    }
    if (!state.playing) draw();
  });
  canvas.addEventListener("wheel", (e) => {
    e.preventDefault();
    zoomAt(e.offsetX, e.offsetY, Math.exp(-e.deltaY * (e.deltaMode ? 0.05 : 0.0015)));
  }, { passive: false });
  canvas.addEventListener("dblclick", () => { resetView(); draw(); });
}

function scrubChart(chart) {
  const go = (e) => { show(frameNear(timeOf(e.offsetX, chart.canvas.clientWidth))); };
  chart.canvas.addEventListener("pointerdown", (e) => { play(false); hold(chart.canvas, e); go(e); });
  chart.canvas.addEventListener("pointermove", (e) => { if (e.buttons) go(e); });
}

function onKey(e) {
  if (e.ctrlKey || e.metaKey || e.altKey || e.target.tagName === "SELECT") return;
  const paging = Math.max(1, Math.round(last / 50));
  const keys = {
    " ": () => play(!state.playing),
    ArrowRight: () => { play(false); show(state.frame + (e.shiftKey ? paging : 1)); },
    ArrowLeft: () => { play(false); show(state.frame - (e.shiftKey ? paging : 1)); },
    Home: () => show(0),
    End: () => { play(false); show(last); },
    "+": () => zoomAt(byId("scene").clientWidth / 2, byId("scene").clientHeight / 2, 1.25),
    "-": () => zoomAt(byId("scene").clientWidth / 2, byId("scene").clientHeight / 2, 0.8),
    0: () => { resetView(); draw(); },
  };
  // A button that has the focus keeps the space key.
  if (!keys[e.key] || (e.key === " " && e.target.tagName === "BUTTON" && e.target.id !== "play")) return;
  e.preventDefault();
  keys[e.key]();
}

// `#t=1.5` in the address: that instant, at rest.
function openAddress() {
  const wanted = /[#&]t=([-+.\deE]+)/.exec(location.hash);
  if (!wanted || !Number.isFinite(Number(wanted[1]))) return false;
  play(false); show(frameNear(Number(wanted[1])));
  return true;
}

function begins() {
  document.title = data.title;
  document.querySelector("h1").textContent = data.title;
  byId("doc").textContent = data.doc;
  byId("stopped").hidden = !data.stopped;
  byId("stopped").textContent = `The run stopped early: ${data.stopped}`;
  byId("thinned").hidden = last + 1 >= data.recorded;
  byId("thinned").textContent = `Shown: ${last + 1} of ${data.recorded} recorded instants; the table has all of them.`;
  applyTheme();
  byId("theme").onclick = nextTheme;
  play(false);
  if (last < 0) {
    byId("clock").textContent = "nothing was recorded";
    for (const name of ["play", "time", "speed"]) byId(name).disabled = true;
    return;
  }
  readColours();
  resetView();
  state.forces = arrows.length > 0 && arrows.length <= 16;
  buildLegend();
  charts.forEach(buildChart);
  fillSpeeds();
  moveView(byId("scene"));
  byId("time").max = last;
  byId("time").oninput = () => { play(false); show(Number(byId("time").value)); };
  byId("play").onclick = () => play(!state.playing);
  byId("fit").onclick = () => { resetView(); draw(); };
  byId("speed").onchange = () => { state.speed = Number(byId("speed").value); };
  new ResizeObserver(redraw).observe(byId("stage"));
  dark.addEventListener("change", () => { applyTheme(); redraw(); });
  addEventListener("keydown", onKey);
  addEventListener("hashchange", openAddress);
  redraw();
  if (!openAddress() && !matchMedia("(prefers-reduced-motion: reduce)").matches) play(true);
}
begins();
