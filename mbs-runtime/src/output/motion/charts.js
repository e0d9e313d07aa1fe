
/* ---- diagrams -------------------------------------------------------------------------------------------------- */

const DASHES = [[], [7, 3], [2, 3], [9, 3, 2, 3]];
const curveColour = (k) => colours.groups[[0, 1, 2, 4, 5, 3][k % 6]];
const series = (column) => (Array.isArray(column) ? column : data.time.map(() => column));

const charts = [
  { title: "Energy", unit: "J", curves: [
    { name: "T", values: data.kinetic }, { name: "V", values: data.potential }, { name: "T + V", values: data.total }] },
  { title: "Energy error", unit: "J", log: true, curves: [{ name: "|E \u2212 E\u2080 \u2212 W|", values: data.energyError }] },
  { title: "Constraint error, max", unit: "", log: true, curves: [
    { name: "|φ|", values: data.holonomicError }, { name: "|A v + b|", values: data.velocityError }] },
];

// Outputs and the sizes of reactions: those of one unit share a diagram.
const choices = data.outputs.map(([name, unit, column]) => ({ name, unit, values: series(column) }));
for (const r of arrows) {
  choices.push({ name: `|F| ${r.joint}${r.note}`, reaction: true, unit: "N", values: data.time.map((_, f) => { const force = forceAt(r, f); return force && size(force); }) });
}
for (const r of reactions) for (const [joint, component, unit, , column] of r.rows) {
  if (!/^f[xyz]$/.test(component)) choices.push({ name: `${component} ${joint}${r.note}`, reaction: true, unit, values: series(column) });
}
if (choices.length) {
  const first = choices.filter((choice) => choice.unit === choices[0].unit && choice.reaction === choices[0].reaction);
  charts.push({ title: "", choices, curves: first.slice(0, 2), unit: choices[0].unit });
}

function buildChart(chart) {
  const root = document.createElement("div");
  root.className = chart.choices ? "chart chosen" : "chart";
  root.innerHTML = '<div class="keys"><h2></h2></div><canvas role="img"></canvas>';
  chart.root = root; chart.canvas = root.querySelector("canvas"); chart.keys = root.querySelector(".keys");
  chart.picture = document.createElement("canvas");
  if (chart.choices) {
    const chips = document.createElement("div");
    chips.className = "choices";
    for (const choice of chart.choices) {
      const chip = document.createElement("button");
      chip.type = "button"; chip.className = "chip"; chip.textContent = choice.name;
      chip.onclick = () => { choose(chart, choice); };
      choice.chip = chip; chips.append(chip);
    }
    root.insertBefore(chips, chart.canvas);
  }
  byId("charts").append(root);
  scrubChart(chart);
  buildKeys(chart);
}

// Another unit begins anew; at least one curve stays.
function choose(chart, choice) {
  if (choice.unit !== chart.unit) chart.curves = [choice];
  else if (!chart.curves.includes(choice)) chart.curves = [...chart.curves, choice].slice(-4);
  else if (chart.curves.length > 1) chart.curves = chart.curves.filter((other) => other !== choice);
  chart.unit = choice.unit;
  buildKeys(chart); plot(chart); drawChart(chart);
}

function buildKeys(chart) {
  const title = chart.title || (chart.curves.every((curve) => curve.reaction) ? "Reactions" : "Outputs");
  const heading = chart.unit ? `${title}, ${chart.unit}` : title;
  chart.keys.querySelector("h2").textContent = heading;
  chart.canvas.setAttribute("aria-label", `${heading} over time`);
  for (const key of chart.keys.querySelectorAll("span")) key.remove();
  chart.curves.forEach((curve, k) => {
    const key = document.createElement("span");
    key.innerHTML = `<svg viewBox="0 0 20 8" aria-hidden="true"><path d="M0 4H20" fill="none" stroke-width="2" stroke="var(--c${[0, 1, 2, 4, 5, 3][k % 6]})" stroke-dasharray="${DASHES[k % 4].join(" ")}"/></svg>`;
    const value = document.createElement("b");
    key.append(`${curve.name} `, value);
    curve.value = value;
    chart.keys.append(key);
  });
  for (const choice of chart.choices || []) choice.chip.setAttribute("aria-pressed", chart.curves.includes(choice));
}

const strip = { left: 52, right: 10, top: 8, bottom: 20 };
const timeX = (t, width) => strip.left + (t - begin) / (end - begin || 1) * (width - strip.left - strip.right);
const timeOf = (x, width) => begin + (x - strip.left) / (width - strip.left - strip.right) * (end - begin);

const SUPERSCRIPTS = "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079";
const tenTo = (k) => `10${String(k).replace(/./g, (d) => (d === "-" ? "\u207b" : SUPERSCRIPTS[d]))}`;

// Errors matter where they are large: the dips of an oscillating one to zero would fill a logarithmic diagram.
function envelope(values) {
  const span = Math.max(1, Math.ceil((last + 1) / 200)), points = [];
  for (let f = 0; f <= last; f += span) {
    const part = values.slice(f, f + span).filter((x) => x !== null);
    points.push([data.time[f], part.length ? Math.max(...part.map(Math.abs)) : null]);
  }
  if (points.length) points.push([end, points[points.length - 1][1]]);
  return points;
}
const pointsOf = (chart, curve) => (curve.points ??= chart.log ? envelope(curve.values) : curve.values.map((x, f) => [data.time[f], x]));

// Values, ticks and where they are, on the axis of a chart.
function axisOf(chart, room) {
  const all = chart.curves.flatMap((curve) => pointsOf(chart, curve)).map((point) => point[1]).filter((x) => x !== null);
  if (chart.log) {
    const sizes = all.filter((x) => x > 0);
    const top = Math.ceil(Math.log10(sizes.reduce((a, b) => Math.max(a, b), 1e-18)) + 1e-9);
    const least = Math.floor(Math.log10(sizes.reduce((a, b) => Math.min(a, b), 10 ** top)));
    // The smallest decades only as far as they tell something.
    const bottom = Math.min(top - 2, Math.max(least, top - 8));
    const every = Math.ceil((top - bottom) / Math.max(2, Math.floor(room / 24)));
    const ticks = [];
    for (let k = top; k >= bottom; k -= every) ticks.push([k, tenTo(k)]);
    return { low: bottom, high: top, ticks, map: (x) => Math.max(bottom, Math.log10(Math.max(Math.abs(x), 1e-300))) };
  }
  let low = all.reduce((a, b) => Math.min(a, b), Infinity), high = all.reduce((a, b) => Math.max(a, b), -Infinity);
  if (!(low <= high)) { low = 0; high = 1; }
  if (!(high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high)))) {
    const more = Math.abs(low) || 1;
    low -= 0.5 * more; high += 0.5 * more;
  }
  const more = 0.05 * (high - low);
  low -= more; high += more;
  const step = niceStep(high - low, Math.max(3, room / 22)), ticks = [];
  for (let i = Math.ceil(low / step); i * step <= high; i++) ticks.push([i * step, label(i * step, step), i === 0]);
  return { low, high, ticks, map: (x) => x };
}

// The picture without its time cursor is drawn once; following the time is then cheap.
function plot(chart) {
  const width = chart.canvas.clientWidth, height = chart.canvas.clientHeight, ratio = window.devicePixelRatio || 1;
  chart.picture.width = Math.round(width * ratio); chart.picture.height = Math.round(height * ratio);
  if (!width || !height) return;
  const c = chart.picture.getContext("2d"), room = height - strip.top - strip.bottom;
  c.setTransform(ratio, 0, 0, ratio, 0, 0);
  c.font = FONT; c.lineWidth = 1;
  const axis = axisOf(chart, room);
  const y = (value) => height - strip.bottom - (value - axis.low) / (axis.high - axis.low) * room;
  // All diagrams have the same room for the longest label, so that instants are one above the other.
  const widest = 10 + Math.max(...axis.ticks.map(([, text]) => Math.ceil(c.measureText(text).width)));
  if (widest > strip.left) {
    strip.left = widest;
    for (const other of charts) if (other.canvas) { plot(other); drawChart(other); }
    return;
  }
  c.textBaseline = "middle"; c.textAlign = "right"; c.fillStyle = colours.soft;
  for (const [value, text, zero] of axis.ticks) {
    c.strokeStyle = zero ? colours.line : colours.grid;
    path(c, [[strip.left, Math.round(y(value)) + 0.5], [width - strip.right, Math.round(y(value)) + 0.5]]); c.stroke();
    c.fillText(text, strip.left - 6, y(value));
  }
  const step = niceStep(end - begin || 1, Math.max(2, width / 62));
  c.textBaseline = "bottom"; c.textAlign = "center";
  for (let i = Math.ceil(begin / step - 1e-9); i * step <= end + 1e-9 * step; i++) {
    const x = timeX(i * step, width), text = label(i * step, step), half = c.measureText(text).width / 2;
    c.strokeStyle = colours.line;
    path(c, [[x, height - strip.bottom], [x, height - strip.bottom + 4]]); c.stroke();
    c.fillText(text, Math.min(x, width - half - 2), height - 1);
  }
  c.textAlign = "left"; c.fillText("t, s", 4, height - 1);
  c.strokeStyle = colours.line;
  path(c, [[strip.left, height - strip.bottom + 0.5], [width - strip.right, height - strip.bottom + 0.5]]); c.stroke();
  c.lineJoin = "round"; c.lineWidth = 1.4;
  chart.curves.forEach((curve, k) => {
    c.strokeStyle = curveColour(k); c.setLineDash(DASHES[k % 4]);
    c.beginPath();
    let pen = false;
    const put = (t, value) => {
      if (value === null) { pen = false; return; }
      const px = timeX(t, width), py = Math.max(-1e4, Math.min(1e4, y(axis.map(value))));
      if (pen) c.lineTo(px, py); else { c.moveTo(px, py); c.lineTo(px + 0.01, py); }
      pen = true;
    };
    for (const [t, value] of pointsOf(chart, curve)) put(t, value);
    c.stroke();
  });
  c.setLineDash([]);
  chart.y = (value) => y(axis.map(value));
}

function drawChart(chart) {
  const [c, width, height] = prepare(chart.canvas);
  if (!width || !height || !chart.picture.width) return;
  c.drawImage(chart.picture, 0, 0, width, height);
  const x = timeX(data.time[state.frame], width);
  c.strokeStyle = colours.ink; c.lineWidth = 1; c.globalAlpha = 0.75;
  path(c, [[x, strip.top - 4], [x, height - strip.bottom]]); c.stroke();
  c.globalAlpha = 1;
  chart.curves.forEach((curve, k) => {
    const value = curve.values[state.frame];
    curve.value.textContent = quantity(chart.log && value !== null ? Math.abs(value) : value);
    if (value !== null && !chart.log) disc(c, [x, chart.y(value)], 3, curveColour(k), colours.panel, 1.2);
  });
}
