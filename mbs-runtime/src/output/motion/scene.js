
/* ---- scene ----------------------------------------------------------------------------------------------------- */

// Shorter rods are thinner, and many of them too.
const rodWidth = (() => {
  const lengths = bodies.flatMap((body) => (body.spring ? [] : body.solid)).map((s) => {
    const a = position(s.from, 0), b = position(s.to, 0);
    return a && b ? size(add(a, b, -1)) : 0;
  }).filter((x) => x > 0).sort((a, b) => a - b);
  const short = lengths[Math.floor(lengths.length / 4)] || extent;
  return (scale) => Math.max(lengths.length < 12 ? 4 : 2, Math.min(8, scale * short / 8, 9 - 0.06 * lengths.length));
})();

// Supports are smaller where they are close together.
const supportGap = (() => {
  const places = data.tracks.map((_, track) => track).filter((track) => held[track]).map((track) => position(track, 0));
  let least = Infinity;
  places.forEach((a, i) => places.slice(0, i).forEach((b) => { least = Math.min(least, size(add(a, b, -1))); }));
  return least;
})();
const supportSize = (scale) => Math.max(0.35, Math.min(1, supportGap * scale / 40));

const path = (c, points, closed) => {
  c.beginPath();
  points.forEach((p, i) => (i ? c.lineTo(p[0], p[1]) : c.moveTo(p[0], p[1])));
  if (closed) c.closePath();
};

// The outline of points in the picture: what a convex body covers.
function hull(points) {
  const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list) => {
    const chain = [];
    for (const p of list) {
      while (chain.length > 1) {
        const [a, b] = chain.slice(-2);
        if ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) > 0) break;
        chain.pop();
      }
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

const mean = (points) => points.reduce((sum, p) => add(sum, p), [0, 0, 0]).map((x) => x / points.length);

function drawScene() {
  const [c, width, height] = prepare(byId("scene"));
  const cam = camera(width, height);
  const now = data.tracks.map((_, track) => position(track, state.frame));
  const at = now.map((p) => p && cam.place(p));
  const step = niceStep(Math.min(width, height) / cam.scale, data.spatial ? 9 : 5);
  const rod = rodWidth(cam.scale);
  c.lineCap = "round"; c.lineJoin = "round";
  if (data.spatial) { drawFloor(c, cam, step); drawShadows(c, cam, now, rod); } else drawGrid(c, cam, step);
  drawGuides(c, cam);
  if (state.traces) drawTraces(c, cam);
  drawBodies(c, cam, at, rod);
  if (state.forces) drawForces(c, cam, now, at);
  if (state.names) drawNames(c, at);
  if (data.spatial) drawTriad(c, cam, step);
  drawForceKey(c, cam);
}

// The multiples of a step between two numbers; not without end, where round-off is larger than the step.
function multiples(from, to, step) {
  const first = Math.ceil(from / step), list = [];
  for (let n = 0; n < 2000 && (first + n) * step <= to; n++) list.push(first + n);
  return list;
}

function drawGrid(c, cam, step) {
  const { width, height, scale } = cam, marks = []; // drawn last: a line through a number makes it illegible
  const [x0, y0] = cam.place([0, 0, 0]);
  c.lineWidth = 1;
  const rule = (i, x, y, u, w) => {
    c.strokeStyle = i === 0 ? colours.line : colours.grid;
    c.beginPath(); c.moveTo(Math.round(x) + 0.5, Math.round(y) + 0.5); c.lineTo(Math.round(u) + 0.5, Math.round(w) + 0.5); c.stroke();
  };
  for (const i of multiples(-x0 / scale, (width - x0) / scale, step)) {
    const x = x0 + scale * i * step;
    rule(i, x, 0, x, height);
    if (x > 60 && x < width - 24) marks.push(["center", label(i * step, step), x, height - 11]);
  }
  for (const i of multiples((y0 - height) / scale, y0 / scale, step)) {
    const y = y0 - scale * i * step;
    rule(i, 0, y, width, y);
    if (y > 16 && y < height - 30) marks.push(["left", label(i * step, step), 8, y]);
  }
  marks.push(["left", "m", 8, height - 11]);
  c.fillStyle = colours.soft; c.textBaseline = "middle";
  for (const [align, text, x, y] of marks) { c.textAlign = align; haloText(c, text, x, y); }
}

/* ---- ground in space ------------------------------------------------------------------------------------------- */

// The lowest level of the motion, and how far the floor reaches around the middle.
const floor = (() => {
  let lowest = Infinity, reach = 0;
  for (let track = 0; track < trackCount; track++) for (let f = 0; f <= last; f += Math.max(1, last >> 8)) {
    const p = position(track, f);
    if (!p) continue;
    const d = add(p, middle, -1), height = dot(d, up);
    lowest = Math.min(lowest, height);
    reach = Math.max(reach, size(add(d, up, -height)));
  }
  return lowest < Infinity ? { level: lowest - 1e-3 * extent, reach: 1.05 * reach + 0.05 * extent } : { level: 0, reach: extent };
})();
const onFloor = (p) => add(p, up, floor.level - dot(add(p, middle, -1), up));

function drawFloor(c, cam, step) {
  const foot = onFloor(middle), [a0, b0] = [dot(middle, ahead), dot(middle, aside)];
  const spot = (a, b) => cam.place(add(add(foot, ahead, a - a0), aside, b - b0));
  const circle = Array.from({ length: 72 }, (_, i) => spot(a0 + floor.reach * Math.cos(i / 36 * Math.PI), b0 + floor.reach * Math.sin(i / 36 * Math.PI)));
  path(c, circle, true);
  c.fillStyle = colours.panel; c.fill();
  c.lineWidth = 1; c.strokeStyle = colours.grid; c.stroke();
  const rules = (middleOf, line) => {
    for (const i of multiples(middleOf - floor.reach, middleOf + floor.reach, step)) {
      const half = Math.sqrt(Math.max(0, floor.reach ** 2 - (i * step - middleOf) ** 2));
      c.strokeStyle = i === 0 ? colours.line : colours.grid;
      path(c, line(i * step, half)); c.stroke();
    }
  };
  rules(a0, (a, half) => [spot(a, b0 - half), spot(a, b0 + half)]);
  rules(b0, (b, half) => [spot(a0 - half, b), spot(a0 + half, b)]);
}

// What is above a place of the floor darkens it: heights can be read that way.
function drawShadows(c, cam, now, rod) {
  if (dot(cam.into, up) > 0) return; // seen from below
  const spot = now.map((p) => p && cam.place(onFloor(p)));
  c.globalAlpha = 0.35; c.strokeStyle = c.fillStyle = colours.shadow; c.lineWidth = rod;
  c.beginPath();
  for (const body of bodies) for (const s of body.spring ? [] : body.solid) {
    if (spot[s.from] && spot[s.to]) { c.moveTo(...spot[s.from].slice(0, 2)); c.lineTo(...spot[s.to].slice(0, 2)); }
  }
  c.stroke();
  for (const body of bodies) {
    const rim = body.rim.map((i) => spot[i]).filter(Boolean);
    if (rim.length > 2) { path(c, hull(rim), true); c.fill(); }
  }
  c.globalAlpha = 1;
}

// The world directions and the step of the floor, in a corner.
function drawTriad(c, cam, step) {
  const x = 50, y = cam.height - 64;
  c.lineWidth = 1.5; c.textAlign = "center"; c.textBaseline = "middle";
  const arms = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis, k) => [dot(axis, cam.into), dot(axis, cam.right), dot(axis, cam.over), "xyz"[k]]);
  for (const [depth, right, over, name] of arms.sort((a, b) => b[0] - a[0])) {
    c.strokeStyle = colours.ink; c.fillStyle = colours.ink;
    c.globalAlpha = depth > 0.3 ? 0.45 : 1;
    arrow(c, [x, y], [x + 26 * right, y - 26 * over], 1.5, 6);
    haloText(c, name, x + 36 * right, y - 36 * over);
  }
  c.globalAlpha = 1;
  c.textAlign = "left"; c.fillStyle = colours.soft;
  haloText(c, `grid ${label(step, step)} m`, 12, cam.height - 14);
}

/* ---- traces ---------------------------------------------------------------------------------------------------- */

const traced = data.tracks.map((_, track) => track).filter((track) => !fixed[track] && !rims.has(track));

function drawTraces(c, cam) {
  // The whole way faintly where that is not too much, the way of the last frames stronger towards its end.
  const from = Math.max(0, state.frame - 400), pieces = 6;
  const far = Math.max(cam.width, cam.height) / 12;
  const run = (track, a, b) => {
    c.beginPath();
    for (let f = a, before = null; f <= b; f++) {
      const p = position(track, f), q = p && cam.place(p);
      // A record far from the one before it: the way between is not known, a dot says where it was.
      if (q && before && Math.hypot(q[0] - before[0], q[1] - before[1]) < far) c.lineTo(q[0], q[1]);
      else if (q && f > a) { c.moveTo(q[0] + 0.5, q[1]); c.arc(q[0], q[1], 0.5, 0, 2 * Math.PI); c.moveTo(q[0], q[1]); }
      else if (q) c.moveTo(q[0], q[1]);
      before = q;
    }
    c.stroke();
  };
  for (const track of traced) {
    const body = ownerOf[track];
    if (body && state.hidden.has(body.group)) continue;
    c.strokeStyle = partColour(body);
    if (traced.length <= 12) { c.lineWidth = 1; c.globalAlpha = 0.16; run(track, 0, last); }
    c.lineWidth = traced.length > 24 ? 1 : 1.6;
    for (let piece = 0; piece < pieces; piece++) {
      const cut = (k) => from + Math.floor((state.frame - from) * k / pieces);
      c.globalAlpha = 0.08 + 0.62 * ((piece + 1) / pieces) ** 1.5;
      if (cut(piece) < cut(piece + 1)) run(track, cut(piece), cut(piece + 1));
    }
  }
  c.globalAlpha = 1;
}

/* ---- bodies ---------------------------------------------------------------------------------------------------- */

// Lines that sliders run along.
function drawGuides(c, cam) {
  c.strokeStyle = colours.soft; c.lineWidth = 1;
  travel.forEach((t, track) => {
    if (!t.axis || !jointed.has(track)) return;
    const more = 26 / cam.scale;
    path(c, [cam.place(add(t.ends[0], t.axis, -more)), cam.place(add(t.ends[1], t.axis, more))]);
    c.setLineDash([10, 4, 2, 4]); c.stroke(); c.setLineDash([]);
  });
}

// A spring keeps its turns, whatever its length.
function turnsOf(segment) {
  const a = position(segment.from, 0), b = position(segment.to, 0);
  return a && b ? Math.max(6, Math.min(24, Math.round(40 * size(add(a, b, -1)) / extent))) : 9;
}

function drawBodies(c, cam, at, rod) {
  // Painter's order: far things first. In the plane all are equally far, and the order of making stays.
  const items = [];
  const item = (depth, draw) => items.push([depth, draw]);
  // Far things fade a little.
  const haze = (depth) => (data.spatial ? Math.max(0.55, Math.min(1, 0.85 - 0.5 * depth / extent)) : 1);
  const nudge = 1e-3 * extent;

  at.forEach((p, track) => {
    if (!p || rims.has(track)) return;
    if (held[track]) item(p[2] + nudge, () => drawSupport(c, cam, track, p, haze(p[2])));
    if (travel[track].axis && jointed.has(track)) item(p[2] + nudge, () => drawSlider(c, cam, track, p));
  });

  for (const body of bodies) {
    const colour = partColour(body);
    if (body.spring) {
      for (const s of body.solid) {
        const a = at[s.from], b = at[s.to];
        if (a && b) item((a[2] + b[2]) / 2, () => drawSpring(c, a, b, turnsOf(s)));
      }
      continue;
    }
    const rim = body.rim.map((i) => at[i]).filter(Boolean);
    if (rim.length > 2) {
      const depth = mean(rim)[2];
      item(depth, () => {
        path(c, hull(rim), true);
        c.fillStyle = colour; c.globalAlpha = 0.13; c.fill(); c.globalAlpha = 1;
      });
    }
    for (const s of body.wire) {
      const a = at[s.from], b = at[s.to];
      if (!a || !b) continue;
      const depth = (a[2] + b[2]) / 2, behind = depth > mean(rim)[2] + 1e-6 * extent;
      item(depth, () => {
        c.strokeStyle = colour; c.lineWidth = 1.1; c.globalAlpha = behind ? 0.4 : 0.95;
        path(c, [a, b]); c.stroke(); c.globalAlpha = 1;
      });
    }
    const ends = body.ends.map((i) => at[i]).filter(Boolean);
    if (ends.length > 2 && ends.length === body.ends.length) {
      // A body with several joints is a plate.
      item(mean(ends)[2], () => drawPlate(c, hull(ends), colour, 0.75 * rod));
    } else for (const s of body.solid) {
      const a = at[s.from], b = at[s.to];
      if (!a || !b) continue;
      // Long rods are cut for the order: two that cross lie right then.
      const pieces = data.spatial ? 8 : 1;
      for (let k = 0; k < pieces; k++) {
        const cut = (t) => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
        const [from, to] = [cut(k / pieces), cut((k + 1) / pieces)], depth = (from[2] + to[2]) / 2;
        item(depth, () => drawRod(c, from, to, colour, rod, haze(depth), k === 0, k === pieces - 1));
      }
    }
    if (!body.solid.length && !body.wire.length) for (const track of body.own) {
      // A joint there is drawn over it, and leaves a ring.
      const p = at[track], radius = isJoint[track] ? Math.max(13, 0.62 * rod + 7) : 6.5;
      if (p) item(p[2], () => disc(c, p, radius, colour, colours.page, 2));
    }
  }

  at.forEach((p, track) => {
    if (!p || rims.has(track) || !isJoint[track]) return;
    item(p[2] - 0.07 * extent, () => disc(c, p, Math.max(2, 0.62 * rod), colours.page, colours.ink, rod > 4 ? 1.6 : 1));
  });
  items.sort((a, b) => b[0] - a[0]);
  for (const [, draw] of items) draw();
}

function disc(c, p, radius, fill, stroke, width) {
  c.beginPath(); c.arc(p[0], p[1], radius, 0, 2 * Math.PI);
  c.lineWidth = width; c.fillStyle = fill; c.strokeStyle = stroke;
  c.fill(); c.stroke();
}

// A rim in the colour of the page parts it from what it passes. Pieces of one rod overlap a little and hide their seams.
function drawRod(c, a, b, colour, width, strength, first, final) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const x = (b[0] - a[0]) / (length || 1) * 0.7, y = (b[1] - a[1]) / (length || 1) * 0.7;
  const dot = (p, radius) => { c.beginPath(); c.arc(p[0], p[1], radius, 0, 2 * Math.PI); c.fill(); };
  c.lineCap = "butt";
  for (const [paint, wide] of [[colours.page, width + 2.5], [mix(colour, colours.page, strength), width]]) {
    c.strokeStyle = c.fillStyle = paint; c.lineWidth = wide;
    if (wide > width) path(c, [a, b]); else path(c, [[a[0] - x, a[1] - y], [b[0] + x, b[1] + y]]);
    c.stroke();
    if (first) dot(a, wide / 2);
    if (final) dot(b, wide / 2);
  }
  c.lineCap = "round";
}

function drawPlate(c, outline, colour, width) {
  path(c, outline, true);
  c.lineWidth = width + 3; c.strokeStyle = colours.page; c.stroke();
  c.fillStyle = c.strokeStyle = colour; c.lineWidth = width;
  c.globalAlpha = 0.3; c.fill();
  c.globalAlpha = 1; c.stroke();
}

function drawSpring(c, a, b, turns) {
  const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  if (length < 1) return;
  const along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length], width = Math.min(7, length / 5);
  const spot = (s, w) => [a[0] + s * length * along[0] - w * along[1], a[1] + s * length * along[1] + w * along[0]];
  const zigzag = Array.from({ length: 2 * turns }, (_, i) => spot(0.1 + 0.8 * (i + 0.5) / (2 * turns), i % 2 ? width : -width));
  path(c, [a, spot(0.1, 0), ...zigzag, spot(0.9, 0), b]);
  c.lineWidth = 1.6; c.strokeStyle = colours.soft; c.stroke();
}

// Ground: a triangle with hatching in the plane, a pyramid on its square in space.
function drawSupport(c, cam, track, p, strength) {
  c.lineWidth = 1.3; c.strokeStyle = colours.ink; c.fillStyle = colours.page; c.globalAlpha = strength;
  if (data.spatial) {
    const height = 15 * supportSize(cam.scale) / cam.scale, tip = position(track, state.frame), foot = add(tip, up, -height);
    const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([i, k]) =>
      cam.place(add(add(foot, ahead, 0.5 * i * height), aside, 0.5 * k * height)));
    path(c, hull([p, ...corners]), true);
    c.fill(); c.stroke();
    c.lineWidth = 1;
    path(c, corners, true); c.stroke();
    for (const corner of corners) { path(c, [p, corner]); c.stroke(); }
  } else {
    const k = supportSize(cam.scale);
    c.save(); c.translate(p[0], p[1]); c.scale(k, k);
    path(c, [[0, 0], [-9, 15], [9, 15]], true);
    c.fill(); c.stroke();
    path(c, [[-15, 15], [15, 15]]); c.stroke();
    c.lineWidth = 1;
    for (let x = -13; x <= 15; x += 5.6) { path(c, [[x, 15.5], [x - 5, 21]]); c.stroke(); }
    c.restore();
  }
  c.globalAlpha = 1;
}

function drawSlider(c, cam, track, p) {
  const axis = travel[track].axis, before = cam.place(add(position(track, state.frame), axis, 1e-3 * extent));
  const angle = Math.atan2(before[1] - p[1], before[0] - p[0]);
  c.save(); c.translate(p[0], p[1]); c.rotate(angle);
  c.beginPath(); c.rect(-13, -8.5, 26, 17);
  c.fillStyle = colours.page; c.strokeStyle = colours.ink; c.lineWidth = 1.4;
  c.fill(); c.stroke(); c.restore();
}

/* ---- forces and names ------------------------------------------------------------------------------------------ */

function arrow(c, from, to, width, head) {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  if (length < 1) return;
  const tip = Math.min(head, length), x = (to[0] - from[0]) / length, y = (to[1] - from[1]) / length;
  c.lineWidth = width;
  if (length > tip) { path(c, [from, [to[0] - x * tip * 0.8, to[1] - y * tip * 0.8]]); c.stroke(); }
  path(c, [to, [to[0] - x * tip - y * tip * 0.42, to[1] - y * tip + x * tip * 0.42], [to[0] - x * tip + y * tip * 0.42, to[1] - y * tip - x * tip * 0.42]], true);
  c.fill();
}

// Pixels per newton: the usual force is a fifth of the picture.
const forceScale = (cam) => 0.17 * Math.min(cam.width, cam.height) / usualForce;

function drawForces(c, cam, now, at) {
  if (!(usualForce > 0)) return;
  const scale = forceScale(cam), most = 0.36 * Math.min(cam.width, cam.height);
  for (const reaction of arrows) {
    const force = forceAt(reaction, state.frame), from = at[reaction.track];
    if (!force || !from) continue;
    const length = scale * size(force);
    if (length < 2) continue;
    // Longer ones are cut; a ring on the arrow says so.
    const drawn = Math.min(length, most), tip = cam.place(add(now[reaction.track], unit(force), drawn / cam.scale));
    c.strokeStyle = c.fillStyle = colours.page;
    arrow(c, from, tip, 4.5, 0);
    c.strokeStyle = c.fillStyle = colours.force;
    arrow(c, from, tip, 2, 9);
    if (length > most) disc(c, [from[0] + 0.5 * (tip[0] - from[0]), from[1] + 0.5 * (tip[1] - from[1])], 3, colours.page, colours.force, 1.5);
  }
}

function drawForceKey(c, cam) {
  if (!state.forces || !(usualForce > 0)) return;
  const force = niceStep(46 / forceScale(cam), 1), length = force * forceScale(cam), x = data.spatial ? 112 : cam.width - 16 - length;
  const y = cam.height - (data.spatial ? 14 : 34);
  c.strokeStyle = c.fillStyle = colours.force;
  arrow(c, [x, y], [x + length, y], 2, 9);
  c.textBaseline = "middle"; c.textAlign = data.spatial ? "left" : "right"; c.fillStyle = colours.ink;
  haloText(c, `${quantity(force)} N`, data.spatial ? x + length + 8 : x - 8, y);
}

function drawNames(c, at) {
  c.textAlign = "left"; c.textBaseline = "bottom"; c.fillStyle = colours.ink;
  const named = new Set();
  data.names.forEach((name, i) => {
    const track = data.track[i], p = at[track];
    if (!p || rims.has(track) || named.has(track)) return;
    named.add(track);
    haloText(c, name, p[0] + 8, p[1] - 6);
  });
}
