"use strict";
// `data` is what was recorded; the page defines it before this program.
const byId = (id) => document.getElementById(id);
const last = data.time.length - 1;
const begin = data.time[0] ?? 0, end = data.time[last] ?? 0;

// A column is an array with a value per frame, or one number where it never changes.
const valueAt = (column, frame) => (Array.isArray(column) ? column[frame] : column);

/* ---- geometry -------------------------------------------------------------------------------------------------- */

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
const size = (a) => Math.hypot(a[0], a[1], a[2]);
const unit = (a) => { const s = size(a) || 1; return [a[0] / s, a[1] / s, a[2] / s]; };

// Points that go the same way are one track.
const trackCount = data.tracks.length;
function position(track, frame) {
  const columns = data.tracks[track];
  const x = valueAt(columns[0], frame), y = valueAt(columns[1], frame), z = data.spatial ? valueAt(columns[2], frame) : 0;
  return x === null || y === null || z === null ? null : [x, y, z];
}

const up = data.spatial ? unit(data.up) : [0, 1, 0];

// What the motion fills: a box in world axes, and its middle.
const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
for (let track = 0; track < trackCount; track++) for (let f = 0; f <= last; f++) {
  const p = position(track, f);
  if (p) for (let k = 0; k < 3; k++) { low[k] = Math.min(low[k], p[k]); high[k] = Math.max(high[k], p[k]); }
}
if (!(low[0] <= high[0])) { low.fill(-1); high.fill(1); }
const middle = low.map((x, k) => (x + high[k]) / 2);
// At rest, where only round-off moves, a metre is shown.
const moved = size(low.map((x, k) => high[k] - x));
const extent = moved > 1e-9 * Math.max(size(low), size(high)) ? moved : 1;

/* ---- what is drawn --------------------------------------------------------------------------------------------- */

// A part that is one of many with the same stem (`crank12`, `crank[12]`, `stage[3].rod`) shares its colour with them.
const stem = (name) => name.replace(/\[\d+\]/g, "").replace(/[_.]?\d+$/, "") || name;
const shown = [...new Set([...data.parts, ...data.segments.map((s) => s[0])])];
const groupOf = data.parts.length > 8 ? stem : (name) => name;
const groups = [...new Set(data.parts.map(groupOf))];

const segments = data.segments.map(([part, from, to]) => ({ part, from: data.track[from], to: data.track[to] }));
const jointed = new Set(data.reactions.filter((r) => r[3] !== null).map((r) => data.track[r[3]]));

// Many lines that hold no joint are the outline of a shape.
const outlined = (part) => segments.filter((s) => s.part === part && !jointed.has(s.from) && !jointed.has(s.to)).length >= 6;
const bodies = shown.map((name) => {
  const lines = segments.filter((s) => s.part === name);
  const spring = !data.parts.includes(name);
  const outline = !spring && outlined(name);
  const wire = lines.filter((s) => outline && !jointed.has(s.from) && !jointed.has(s.to));
  const solid = lines.filter((s) => !wire.includes(s) && (s.from !== s.to));
  const own = [...new Set(data.names.map((point, i) => [point, data.track[i]]).filter(([point]) => point.startsWith(`${name}.`)).map((x) => x[1]))];
  const of = (list) => [...new Set(list.flatMap((s) => [s.from, s.to]))];
  return { name, spring, wire, solid, rim: of(wire), ends: of(solid), own, group: groups.indexOf(groupOf(name)) };
});

const rims = new Set(bodies.flatMap((b) => b.rim));
for (const body of bodies) for (const end of body.ends) rims.delete(end);
data.names.forEach((name, i) => { if (name.endsWith(".origin")) rims.delete(data.track[i]); });

// The part that a track is first an end of, for its colour.
const ownerOf = data.tracks.map((_, track) =>
  bodies.find((b) => !b.spring && b.ends.length && b.ends[b.ends.length - 1] === track) ||
  bodies.find((b) => !b.spring && (b.ends.includes(track) || b.own.includes(track))) || bodies[0]);

// A track that never leaves its place is held by the ground; one that stays on a line is a slider, if a joint is there.
const travel = data.tracks.map((columns, track) => {
  if (!columns.some(Array.isArray)) return { fixed: true };
  const start = position(track, 0);
  let far = null, most = 0;
  for (let f = 0; f <= last; f++) {
    const p = position(track, f);
    if (!p || !start) return { fixed: false };
    const away = size(add(p, start, -1));
    if (away > most) { most = away; far = p; }
  }
  if (most < 1e-5 * extent) return { fixed: true };
  const axis = unit(add(far, start, -1));
  let from = 0, to = 0;
  for (let f = 0; f <= last; f++) {
    const d = add(position(track, f), start, -1), along = dot(d, axis);
    if (size(add(d, axis, -along)) > 1e-5 * extent) return { fixed: false };
    from = Math.min(from, along); to = Math.max(to, along);
  }
  return { fixed: false, axis, ends: [add(start, axis, from), add(start, axis, to)] };
});
const fixed = travel.map((t) => t.fixed);
const still = fixed.every((f) => f);
const held = fixed.map((f, track) => f && (!still || jointed.has(track)));
const isJoint = data.tracks.map((_, track) =>
  held[track] || jointed.has(track) || bodies.filter((b) => b.ends.includes(track)).length > 1);

/* ---- reactions ------------------------------------------------------------------------------------------------- */

const reactions = [...new Set(data.reactions.map((r) => r[0]))].map((joint) => {
  const rows = data.reactions.filter((r) => r[0] === joint);
  // Without such a row the component is zero; with one whose values are no numbers it is unknown.
  const component = (name) => { const row = rows.find((r) => r[1] === name); return row ? row[4] : 0; };
  const force = ["fx", "fy", "fz"].map(component);
  const acts = rows.some((r) => /^f[xyz]$/.test(r[1]));
  const point = rows[0][3];
  // Redundant rows share such a reaction out: what is shown is the smallest of many.
  const note = rows[0][5] === false ? " (minimum-norm, not unique)" : "";
  return { joint, note, acts: acts && point !== null, track: point === null ? null : data.track[point], force, rows };
});
const arrows = reactions.filter((r) => r.acts);
const forceAt = (reaction, frame) => {
  const f = reaction.force.map((column) => valueAt(column, frame));
  return f.includes(null) ? null : f;
};

// The size that few forces exceed: spikes must not make all other arrows invisible.
const usualForce = (() => {
  const all = [];
  for (const r of arrows) for (let f = 0; f <= last; f += Math.max(1, last >> 8)) {
    const force = forceAt(r, f);
    if (force) all.push(size(force));
  }
  all.sort((a, b) => a - b);
  return all[Math.floor(0.9 * (all.length - 1))] || 0;
})();
