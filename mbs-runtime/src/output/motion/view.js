
/* ---- view ------------------------------------------------------------------------------------------------------ */

const state = { frame: 0, playing: false, clock: begin, speed: 1, traces: true, forces: true, names: false, hidden: new Set() };
const view = { yaw: 0, pitch: 0, zoom: 1, pan: [0, 0] };

// The horizontal axes, right-handed with up.
const ahead = (() => {
  const most = up.map(Math.abs).indexOf(Math.max(...up.map(Math.abs)));
  const axis = [0, 0, 0];
  axis[(most + 1) % 3] = 1;
  return unit(add(axis, up, -dot(axis, up)));
})();
const aside = cross(up, ahead);

function axes(yaw, pitch) {
  if (!data.spatial) return { right: cross(up, [0, 0, 1]), over: up, into: [0, 0, -1] };
  const right = add(ahead.map((x) => x * Math.cos(yaw)), aside, Math.sin(yaw));
  const level = add(ahead.map((x) => -x * Math.sin(yaw)), aside, Math.cos(yaw));
  return {
    right,
    over: add(up.map((x) => x * Math.cos(pitch)), level, Math.sin(pitch)),
    into: add(up.map((x) => -x * Math.sin(pitch)), level, Math.cos(pitch)),
  };
}

// A mild perspective: the eye is a few sizes of the motion away.
const distance = 3.5 * extent;
function flatten(p, { right, over, into }) {
  const d = add(p, middle, -1), depth = dot(d, into);
  const nearer = data.spatial ? distance / Math.max(0.2 * distance, distance + depth) : 1;
  return [dot(d, right) * nearer, dot(d, over) * nearer, depth];
}

// The yaw from which the motion shows most of itself, close to the usual one unless another is much better.
const home = (() => {
  const pitch = 0.42, usual = 0.62;
  if (!data.spatial) return { yaw: 0, pitch: 0 };
  const spread = (yaw) => {
    const frame = axes(yaw, pitch);
    let n = 0, u = 0, w = 0, uu = 0, uw = 0, ww = 0;
    for (let track = 0; track < trackCount; track++) for (let f = 0; f <= last; f += Math.max(1, last >> 6)) {
      const p = position(track, f);
      if (!p) continue;
      const [x, y] = flatten(p, frame);
      n++; u += x; w += y; uu += x * x; uw += x * y; ww += y * y;
    }
    return (uu - u * u / n) * (ww - w * w / n) - (uw - u * w / n) ** 2;
  };
  const best = [0, 0.5, -0.5, 1, -1].map((more) => usual + more * Math.PI / 2).map((yaw) => [spread(yaw), yaw]);
  const [most] = best.reduce((a, b) => (b[0] > a[0] ? b : a));
  return { yaw: best.find(([s]) => s >= 0.5 * most)?.[1] ?? usual, pitch };
})();

// The box of the whole motion in the picture from there. In space the view turns about its middle, which stays in place,
// as does the scale: none that loses much of the motion from other sides.
let radius = 0;
const box = (() => {
  const frame = axes(home.yaw, home.pitch);
  const box = { x0: Infinity, x1: -Infinity, y0: Infinity, y1: -Infinity };
  for (let track = 0; track < trackCount; track++) for (let f = 0; f <= last; f++) {
    const p = position(track, f);
    if (!p) continue;
    const [x, y] = flatten(p, frame);
    box.x0 = Math.min(box.x0, x); box.x1 = Math.max(box.x1, x);
    box.y0 = Math.min(box.y0, y); box.y1 = Math.max(box.y1, y);
    radius = Math.max(radius, Math.hypot(x, y));
  }
  if (!(box.x0 <= box.x1)) return { x0: -1, x1: 1, y0: -1, y1: 1 };
  if (!data.spatial) return box;
  const x = Math.max(-box.x0, box.x1, 0.75 * radius), y = Math.max(-box.y0, box.y1, 0.75 * radius);
  return { x0: -x, x1: x, y0: -y, y1: y };
})();

function resetView() {
  view.yaw = home.yaw; view.pitch = home.pitch; view.zoom = 1; view.pan = [0, 0];
}
const isReset = () => view.yaw === home.yaw && view.pitch === home.pitch && view.zoom === 1 && !view.pan[0] && !view.pan[1];

// How world points get onto a canvas of this size.
function camera(width, height) {
  const margin = Math.min(64, width / 7, height / 6);
  const [wide, high] = [box.x1 - box.x0, box.y1 - box.y0];
  const least = Math.max(wide, high) > 1e-6 * extent ? 1e-6 * extent : extent;
  const fit = Math.min((width - 2 * margin) / Math.max(wide, least), (height - 2 * margin) / Math.max(high, least));
  const scale = fit * view.zoom, frame = axes(view.yaw, view.pitch);
  const x0 = width / 2 + view.pan[0] - scale * (box.x0 + box.x1) / 2;
  const y0 = height / 2 + view.pan[1] + scale * (box.y0 + box.y1) / 2;
  const place = (p) => {
    const [x, y, depth] = flatten(p, frame);
    return [x0 + scale * x, y0 - scale * y, depth];
  };
  return { ...frame, scale, x0, y0, place, width, height };
}

/* ---- colours and canvases -------------------------------------------------------------------------------------- */

let colours;
function readColours() {
  const style = getComputedStyle(document.documentElement);
  const read = (name) => style.getPropertyValue(`--${name}`).trim();
  colours = { groups: [0, 1, 2, 3, 4, 5].map((i) => read(`c${i}`)) };
  for (const name of ["page", "panel", "ink", "soft", "grid", "line", "shadow", "force"]) colours[name] = read(name);
}
// Part of one colour, the rest of another; both as #rrggbb.
function mix(one, other, part) {
  const [a, b] = [one, other].map((colour) => [1, 3, 5].map((i) => parseInt(colour.slice(i, i + 2), 16)));
  return `rgb(${a.map((x, i) => Math.round(part * x + (1 - part) * b[i])).join(" ")})`;
}
const partColour = (body) => (!body || body.spring ? colours.soft : colours.groups[body.group % colours.groups.length]);

const FONT = "12px system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif";
function prepare(canvas) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const c = canvas.getContext("2d");
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.clearRect(0, 0, width, height);
  c.font = FONT;
  return [c, width, height];
}

// Text that stays legible where a line passes behind it.
function haloText(c, text, x, y) {
  c.lineJoin = "round"; c.lineWidth = 4; c.strokeStyle = colours.page;
  c.strokeText(text, x, y);
  c.fillText(text, x, y);
}

// 1, 2 or 5 times a power of ten.
function niceStep(range, wanted) {
  const raw = range / wanted, power = 10 ** Math.floor(Math.log10(raw));
  return power * [1, 2, 5, 10].find((m) => m * power >= raw * 0.999);
}
const MINUS = "\u2212";
const signed = (text) => text.replaceAll("-", MINUS);
const label = (x, step) => {
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const size = Math.abs(x) < step / 2 ? 0 : Math.abs(x);
  if (digits <= 4 && size < (digits ? 1e5 : 1e7)) return signed((size && x).toFixed(digits));
  // As many digits as tell neighbouring ticks apart.
  const more = Math.floor(Math.log10(size) + 1e-9) - Math.floor(Math.log10(step) + 1e-9);
  return size ? signed(x.toExponential(Math.min(12, Math.max(1, more)))) : "0";
};
const quantity = (x) => {
  if (x === null || x === undefined) return "–";
  const plain = x === 0 || (Math.abs(x) >= 1e-3 && Math.abs(x) < 1e5);
  return signed(plain ? String(Number(x.toPrecision(4))) : Number(x.toPrecision(Math.abs(x) < 1 ? 2 : 4)).toExponential());
};
