"use strict";
// `data` is what was recorded; the page defines it before this program.
const byId = (id) => document.getElementById(id);
const last = data.time.length - 1;
const pointCount = data.names.length;
const components = data.spatial ? 3 : 2;
const dark = matchMedia("(prefers-color-scheme: dark)");
const state = { frame: 0, playing: false, clock: data.time[0] || 0, speed: 1, up: 2, yaw: -0.6, pitch: 0.35 };

document.title = data.title;
document.querySelector("h1").textContent = data.title;
document.querySelector(".doc").textContent = data.doc;
if (data.stopped) {
  const notice = document.querySelector(".stopped");
  notice.hidden = false;
  notice.textContent = `The run stopped early: ${data.stopped}`;
}

/* ---- geometry -------------------------------------------------------------------------------------------------- */

function position(frame, point) {
  const row = data.points[frame], at = point * components;
  if (row[at] === null || row[at + 1] === null) return null;
  return [row[at], row[at + 1], data.spatial ? row[at + 2] : 0];
}

// From world axes to the plane of the picture: identity in the plane, an orthographic view in space.
function project(p) {
  if (!data.spatial) return [p[0], p[1]];
  const u = state.up, a = p[(u + 1) % 3], b = p[(u + 2) % 3], c = p[u];
  const depth = Math.sin(state.yaw) * a + Math.cos(state.yaw) * b;
  return [Math.cos(state.yaw) * a - Math.sin(state.yaw) * b,
          c * Math.cos(state.pitch) + depth * Math.sin(state.pitch)];
}

// The data do not say where up is: it is the axis along which the height follows the potential energy best.
function guessUp() {
  const mean = (values) => values.reduce((sum, x) => sum + x, 0) / values.length;
  let best = 2, most = 0.5;
  for (let axis = 0; axis < 3; axis++) {
    const heights = data.points.map((row) => mean(row.filter((_, i) => i % 3 === axis)));
    const h0 = mean(heights), v0 = mean(data.potential);
    let hv = 0, hh = 0, vv = 0;
    heights.forEach((h, i) => {
      const dh = h - h0, dv = data.potential[i] - v0;
      hv += dh * dv; hh += dh * dh; vv += dv * dv;
    });
    const correlation = hv / Math.sqrt(hh * vv);
    if (correlation > most) { most = correlation; best = axis; }
  }
  return best;
}

let box; // of all points over all frames, in the plane of the picture (in space: of the ball around them)
function measure() {
  box = { x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity };
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let f = 0; f <= last; f++) for (let i = 0; i < pointCount; i++) {
    const p = position(f, i);
    if (p) for (let k = 0; k < 3; k++) { low[k] = Math.min(low[k], p[k]); high[k] = Math.max(high[k], p[k]); }
  }
  if (low[0] > high[0]) { low.fill(-1); high.fill(1); }
  if (data.spatial) {
    const centre = low.map((x, k) => (x + high[k]) / 2), middle = project(centre);
    let radius = 1e-9;
    for (let f = 0; f <= last; f++) for (let i = 0; i < pointCount; i++) {
      const p = position(f, i);
      if (p) radius = Math.max(radius, Math.hypot(p[0] - centre[0], p[1] - centre[1], p[2] - centre[2]));
    }
    box = { x0: middle[0] - radius, x1: middle[0] + radius, y0: middle[1] - radius, y1: middle[1] + radius };
  } else {
    box = { x0: low[0], x1: high[0], y0: low[1], y1: high[1] };
  }
}

// A point that never leaves its place is ground: it has a mark and no trace.
function findFixed() {
  const size = Math.max(box.x1 - box.x0, box.y1 - box.y0) || 1;
  return data.names.map((_, i) => {
    const start = position(0, i);
    for (let f = 0; f <= last; f++) {
      const p = position(f, i);
      if (start && p && Math.hypot(p[0] - start[0], p[1] - start[1], p[2] - start[2]) > 1e-5 * size) return false;
    }
    return true;
  });
}

/* ---- drawing --------------------------------------------------------------------------------------------------- */

const style = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
let colours;
function readColours() {
  colours = { ink: style("--ink"), soft: style("--soft"), grid: style("--grid"), line: style("--line"), page: style("--page"),
    part: [0, 1, 2, 3, 4, 5].map((i) => style(`--c${i}`)) };
}
const parts = [...new Set(data.segments.map((s) => s[0]))];
const partColour = (part) => colours.part[parts.indexOf(part) % colours.part.length];
const pointColour = (i) => {
  const segment = data.segments.find((s) => s[2] === i) || data.segments.find((s) => s[1] === i);
  return segment ? partColour(segment[0]) : colours.part[0];
};

function prepare(canvas) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const c = canvas.getContext("2d");
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.clearRect(0, 0, width, height);
  c.font = "12px system-ui, 'DejaVu Sans', sans-serif";
  return [c, width, height];
}

// Text that stays legible where a line passes behind it.
function haloText(c, text, x, y) {
  c.lineJoin = "round"; c.lineWidth = 5; c.strokeStyle = colours.page;
  c.strokeText(text, x, y);
  c.fillText(text, x, y);
}

// 1, 2 or 5 times a power of ten.
function niceStep(range, wanted) {
  const raw = range / wanted, power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((m) => m * power >= raw * 0.999);
}
const label = (x, step) => {
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return digits > 4 || Math.abs(x) >= 1e5 ? x.toExponential(1) : (Math.abs(x) < step / 2 ? 0 : x).toFixed(digits);
};

function drawScene() {
  const [c, width, height] = prepare(byId("scene"));
  const margin = Math.min(48, width / 9);
  const scale = Math.min((width - 2 * margin) / Math.max(box.x1 - box.x0, 1e-9),
                         (height - 2 * margin) / Math.max(box.y1 - box.y0, 1e-9));
  const x0 = width / 2 - scale * (box.x0 + box.x1) / 2, y0 = height / 2 + scale * (box.y0 + box.y1) / 2;
  const place = (p) => { const q = project(p); return [x0 + scale * q[0], y0 - scale * q[1]]; };
  const step = niceStep(Math.min(width, height) / scale, 5);
  if (data.spatial) drawRuler(c, height, scale, step); else drawGrid(c, width, height, scale, x0, y0, step);
  if (byId("traces").checked) drawTraces(c, place);
  drawParts(c, place);
  drawLegend(c, width);
}

function drawGrid(c, width, height, scale, x0, y0, step) {
  const marks = []; // drawn last: a line through a number makes it illegible
  c.lineWidth = 1;
  const rule = (at, x, y, u, w) => {
    c.strokeStyle = Math.abs(at) < 1e-6 * step ? colours.line : colours.grid;
    c.beginPath(); c.moveTo(x, y); c.lineTo(u, w); c.stroke();
  };
  for (let i = Math.ceil(-x0 / scale / step); i * step < (width - x0) / scale; i++) {
    const x = x0 + scale * i * step;
    rule(i * step, x, 0, x, height);
    if (x > 60 && x < width - 24) marks.push(["center", label(i * step, step), x, height - 11]);
  }
  for (let i = Math.ceil((y0 - height) / scale / step); i * step < y0 / scale; i++) {
    const y = y0 - scale * i * step;
    rule(i * step, 0, y, width, y);
    if (y > 24 && y < height - 30) marks.push(["left", label(i * step, step), 6, y]);
  }
  marks.push(["left", "m", 6, height - 11]);
  c.fillStyle = colours.soft; c.textBaseline = "middle";
  for (const [align, text, x, y] of marks) { c.textAlign = align; haloText(c, text, x, y); }
}

// An oblique picture has no axes to read lengths from: a ruler and the world directions instead.
function drawRuler(c, height, scale, step) {
  const y = height - 14;
  c.strokeStyle = colours.soft; c.fillStyle = colours.soft; c.lineWidth = 1.5;
  c.beginPath();
  c.moveTo(16, y - 4); c.lineTo(16, y); c.lineTo(16 + scale * step, y); c.lineTo(16 + scale * step, y - 4);
  c.stroke();
  c.textAlign = "left"; c.textBaseline = "middle";
  c.fillText(`${label(step, step)} m`, 22 + scale * step, y - 3);
  [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((axis, k) => {
    const q = project(axis), x = 48, middle = y - 52;
    c.beginPath(); c.moveTo(x, middle); c.lineTo(x + 26 * q[0], middle - 26 * q[1]); c.stroke();
    c.textAlign = "center"; c.fillText("xyz"[k], x + 35 * q[0], middle - 35 * q[1]);
  });
}

function drawTraces(c, place) {
  // A trace is the way of the last frames, strongest at its end.
  const from = Math.max(0, state.frame - 400), pieces = 8;
  const far = Math.max(byId("scene").clientWidth, byId("scene").clientHeight) / 16;
  c.lineWidth = 1.25;
  for (let i = 0; i < pointCount; i++) {
    if (fixed[i]) continue;
    c.strokeStyle = pointColour(i);
    for (let piece = 0; piece < pieces; piece++) {
      const a = from + Math.floor((state.frame - from) * piece / pieces);
      const b = from + Math.floor((state.frame - from) * (piece + 1) / pieces);
      c.globalAlpha = 0.1 + 0.5 * (piece + 1) / pieces;
      c.beginPath();
      for (let f = a, before = null; f <= b; f++) {
        const p = position(f, i), q = p && place(p);
        // A record far from the one before it: the way between is not known, a dot says where it was.
        if (q && before && Math.hypot(q[0] - before[0], q[1] - before[1]) < far) c.lineTo(q[0], q[1]);
        else if (q && f > a) { c.moveTo(q[0] + 1, q[1]); c.arc(q[0], q[1], 1, 0, 2 * Math.PI); c.moveTo(q[0], q[1]); }
        else if (q) c.moveTo(q[0], q[1]);
        before = q;
      }
      c.stroke();
    }
  }
  c.globalAlpha = 1;
}

function drawParts(c, place) {
  const now = data.names.map((_, i) => { const p = position(state.frame, i); return p && place(p); });
  c.lineCap = "round"; c.lineWidth = pointCount > 60 ? 2 : 4;
  for (const [part, from, to] of data.segments) {
    if (!now[from] || !now[to]) continue;
    c.strokeStyle = partColour(part);
    c.beginPath(); c.moveTo(...now[from]); c.lineTo(...now[to]); c.stroke();
  }
  now.forEach((p, i) => {
    if (!p) return;
    c.lineWidth = 1.5; c.strokeStyle = colours.ink; c.fillStyle = fixed[i] ? colours.page : colours.ink;
    c.beginPath();
    if (fixed[i]) { c.moveTo(p[0], p[1]); c.lineTo(p[0] - 8, p[1] + 13); c.lineTo(p[0] + 8, p[1] + 13); c.closePath(); }
    else c.arc(p[0], p[1], pointCount > 60 ? 2 : 4, 0, 2 * Math.PI);
    c.fill(); c.stroke();
    if (byId("names").checked) {
      c.fillStyle = colours.ink; c.textAlign = "left"; c.textBaseline = "bottom";
      haloText(c, data.names[i], p[0] + 7, p[1] - 5);
    }
  });
}

function drawLegend(c, width) {
  if (parts.length < 2 || parts.length > 8) return;
  c.textAlign = "right"; c.textBaseline = "middle";
  parts.forEach((part, i) => {
    const y = 16 + 18 * i, x = width - 14;
    c.strokeStyle = partColour(part); c.lineWidth = 4;
    c.beginPath(); c.moveTo(x - 18, y); c.lineTo(x, y); c.stroke();
    c.fillStyle = colours.ink; c.fillText(part, x - 28, y);
  });
}

/* ---- energy strip ---------------------------------------------------------------------------------------------- */

const strip = { left: 64, right: 14, top: 24, bottom: 22 };
const curves = [
  ["T kinetic", "T", data.kinetic],
  ["V potential", "V", data.potential],
  ["T + V", "T + V", data.kinetic.map((t, i) => (t === null || data.potential[i] === null ? null : t + data.potential[i]))],
];
const timeAt = (x, width) => data.time[0] + (x - strip.left) / (width - strip.left - strip.right) * (data.time[last] - data.time[0]);

function drawEnergy() {
  const [c, width, height] = prepare(byId("energy"));
  const finite = curves.flatMap((curve) => curve[2]).filter((x) => x !== null);
  let low = finite.reduce((a, b) => Math.min(a, b), 0);
  let high = finite.reduce((a, b) => Math.max(a, b), 0);
  if (!(high > low)) { low -= 1; high += 1; }
  const span = data.time[last] - data.time[0] || 1;
  const x = (t) => strip.left + (t - data.time[0]) / span * (width - strip.left - strip.right);
  const y = (e) => height - strip.bottom - (e - low) / (high - low) * (height - strip.top - strip.bottom);
  c.lineWidth = 1; c.textBaseline = "middle"; c.textAlign = "right";
  const step = niceStep(high - low, 4);
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) {
    c.strokeStyle = i === 0 ? colours.line : colours.grid; c.fillStyle = colours.soft;
    c.beginPath(); c.moveTo(strip.left, y(i * step)); c.lineTo(width - strip.right, y(i * step)); c.stroke();
    c.fillText(label(i * step, step), strip.left - 6, y(i * step));
  }
  c.textBaseline = "bottom"; c.textAlign = "center";
  const tick = niceStep(span, Math.max(2, width / 110));
  for (let i = Math.ceil(data.time[0] / tick); i * tick <= data.time[last] + 1e-9 * span; i++)
    c.fillText(label(i * tick, tick), Math.min(x(i * tick), width - 4 - c.measureText(label(i * tick, tick)).width / 2), height - 4);
  c.textAlign = "left"; c.fillText("t, s", 6, height - 4);
  c.textBaseline = "middle"; c.fillText("J", 6, 12);
  let at = strip.left;
  curves.forEach(([long, short, values], k) => {
    c.strokeStyle = k === 2 ? colours.ink : colours.part[k];
    c.lineWidth = 1.5; c.setLineDash(k === 2 ? [5, 3] : []);
    c.beginPath();
    let pen = false;
    values.forEach((e, i) => {
      if (e !== null) { if (pen) c.lineTo(x(data.time[i]), y(e)); else c.moveTo(x(data.time[i]), y(e)); }
      pen = e !== null;
    });
    c.stroke();
    const name = width < 560 ? short : long;
    c.beginPath(); c.moveTo(at, 12); c.lineTo(at + 20, 12); c.stroke(); c.setLineDash([]);
    c.fillStyle = colours.ink; c.fillText(name, at + 26, 12);
    at += 46 + c.measureText(name).width;
  });
  c.strokeStyle = colours.ink; c.lineWidth = 1;
  c.beginPath(); c.moveTo(x(data.time[state.frame]), strip.top - 4); c.lineTo(x(data.time[state.frame]), height - strip.bottom); c.stroke();
}

/* ---- controls -------------------------------------------------------------------------------------------------- */

function draw() {
  drawScene();
  drawEnergy();
  byId("time").value = state.frame;
  const digits = Math.max(0, Math.min(6, 3 - Math.floor(Math.log10(data.time[last] || 1))));
  byId("clock").textContent = `${data.time[state.frame].toFixed(digits)} s`;
  byId("time").setAttribute("aria-valuetext", byId("clock").textContent);
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
function show(frame) { state.frame = Math.max(0, Math.min(last, frame)); state.clock = data.time[state.frame]; draw(); }

let before = 0;
function tick(now) {
  if (!state.playing) return;
  state.clock += Math.min(0.1, (now - before) / 1000) * state.speed;
  before = now;
  if (state.clock > data.time[last]) state.clock = data.time[0];
  const frame = frameAt(state.clock);
  if (frame !== state.frame) { state.frame = frame; draw(); }
  requestAnimationFrame(tick);
}
function play(on) {
  state.playing = on;
  byId("play").textContent = on ? "Pause" : "Play";
  if (on) { before = performance.now(); requestAnimationFrame(tick); }
}

function fillSpeeds() {
  const span = data.time[last] - data.time[0] || 1;
  // Real time where that is watchable, else the speed that shows the run in about ten seconds.
  state.speed = span >= 2 && span <= 60 ? 1 : Number((span / 10).toPrecision(1));
  const choices = [...new Set([0.1, 0.25, 0.5, 1, 2, 5, 10].map((m) => Number((m * state.speed).toPrecision(3))).concat(1))];
  for (const speed of choices.sort((a, b) => a - b)) {
    byId("speed").add(new Option(`${speed} ×`, speed, false, speed === state.speed));
  }
}

function dragView(canvas) {
  let from = null;
  canvas.addEventListener("pointerdown", (e) => { from = [e.clientX, e.clientY]; canvas.setPointerCapture(e.pointerId); });
  canvas.addEventListener("pointerup", () => { from = null; });
  canvas.addEventListener("pointermove", (e) => {
    if (!from) return;
    state.yaw += (e.clientX - from[0]) * 0.008;
    state.pitch = Math.max(-1.57, Math.min(1.57, state.pitch + (e.clientY - from[1]) * 0.008));
    from = [e.clientX, e.clientY];
    measure(); draw();
  });
  canvas.style.cursor = "grab";
}

function scrubStrip(canvas) {
  const go = (e) => { show(frameAt(timeAt(e.clientX - canvas.getBoundingClientRect().left, canvas.clientWidth))); };
  canvas.addEventListener("pointerdown", (e) => { play(false); canvas.setPointerCapture(e.pointerId); go(e); });
  canvas.addEventListener("pointermove", (e) => { if (e.buttons) go(e); });
}

let fixed = [];
function start() {
  readColours();
  if (last < 0) { byId("clock").textContent = "nothing was recorded"; return; }
  if (data.spatial) {
    state.up = guessUp();
    const button = byId("up");
    const name = () => { button.textContent = `up: ${"xyz"[state.up]}`; };
    button.hidden = false; name();
    button.onclick = () => { state.up = (state.up + 1) % 3; name(); measure(); draw(); };
    dragView(byId("scene"));
  }
  measure();
  fixed = findFixed();
  fillSpeeds();
  scrubStrip(byId("energy"));
  byId("time").max = last;
  byId("time").oninput = () => { play(false); show(Number(byId("time").value)); };
  byId("play").onclick = () => play(!state.playing);
  byId("speed").onchange = () => { state.speed = Number(byId("speed").value); };
  byId("traces").onchange = byId("names").onchange = draw;
  addEventListener("resize", draw);
  dark.addEventListener("change", () => { readColours(); draw(); });
  addEventListener("keydown", (e) => {
    if (["INPUT", "SELECT", "BUTTON"].includes(e.target.tagName)) return;
    if (e.key === " ") { e.preventDefault(); play(!state.playing); }
    if (e.key === "ArrowRight") { play(false); show(state.frame + 1); }
    if (e.key === "ArrowLeft") { play(false); show(state.frame - 1); }
  });
  draw();
  if (!matchMedia("(prefers-reduced-motion: reduce)").matches) play(true);
}
start();
