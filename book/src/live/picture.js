"use strict";
// A mechanism of the plane or of space on a canvas: the signs and colours of the animation that `mbs simulate` writes.
{
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const add = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1], a[2] + s * b[2]];
  const size = (a) => Math.hypot(a[0], a[1], a[2]);
  const unit = (a) => a.map((x) => x / (size(a) || 1));
  const FONT = "12px system-ui, -apple-system, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif";
  const TRAIL = 150, PIECES = 8;

  // A canvas as sharp as the screen, and empty.
  globalThis.livePrepare = (canvas) => {
    const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    const [w, h] = [width, height].map((x) => Math.round(x * ratio));
    if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
    const c = canvas.getContext("2d");
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    c.clearRect(0, 0, width, height);
    c.font = FONT; c.lineCap = "round"; c.lineJoin = "round";
    return [c, width, height];
  };

  const path = (c, points, closed) => {
    c.beginPath();
    for (const p of points) c.lineTo(p[0], p[1]);
    if (closed) c.closePath();
  };
  // The outline of points in the picture: what a convex body covers.
  const hull = (points) => {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const half = (list) => {
      const chain = [];
      for (const p of list) {
        for (let n = chain.length; n > 1 && cross(add(chain[n - 1], chain[n - 2], -1), add(p, chain[n - 2], -1))[2] <= 0; n--) chain.pop();
        chain.push(p);
      }
      return chain.slice(0, -1);
    };
    return [...half(sorted), ...half(sorted.reverse())];
  };
  const disc = (c, p, radius, fill, stroke, width) => {
    c.beginPath(); c.arc(p[0], p[1], radius, 0, 2 * Math.PI);
    c.lineWidth = width; c.fillStyle = fill; c.strokeStyle = stroke;
    c.fill(); c.stroke();
  };
  // 1, 2 or 5 times a power of ten, about `wanted`.
  const round = (wanted) => {
    const power = 10 ** Math.floor(Math.log10(wanted)), digit = wanted / power;
    return power * (digit < 1.5 ? 1 : digit < 3.5 ? 2 : digit < 7.5 ? 5 : 10);
  };

  globalThis.LivePicture = class {
    constructor(canvas, scene) {
      Object.assign(this, { canvas, scene, trail: [], yaw: 0.62, pitch: scene.spatial ? 0.42 : 0 });
      this.up = scene.spatial ? unit(scene.up) : [0, 1, 0];
      const most = this.up.map(Math.abs).indexOf(Math.max(...this.up.map(Math.abs)));
      const axis = [0, 0, 0];
      axis[(most + 1) % 3] = 1;
      this.ahead = unit(add(axis, this.up, -dot(axis, this.up)));
      this.aside = cross(this.up, this.ahead);
      this.parts = [...new Set(scene.segments.map((s) => s.part))];
    }

    // Learns from a motion, as a list of instants, what stands still, what slides, and how much room it takes. The room
    // does not become less than that of the first motion: what is shorter than before looks shorter.
    learn(motion) {
      const first = motion[0], low = [Infinity, Infinity, Infinity], high = low.map((x) => -x);
      for (const p of [...motion.flat(), ...(this.room ?? [])]) {
        p.forEach((x, k) => { low[k] = Math.min(low[k], x); high[k] = Math.max(high[k], x); });
      }
      this.room = [low, high];
      this.middle = low.map((x, k) => (x + high[k]) / 2);
      this.extent = size(add(high, low, -1)) || 1;
      // Points that go the same way are drawn once, as the first of them.
      const same = (a, b) => motion.every((at) => size(add(at[a], at[b], -1)) < 1e-6 * this.extent);
      this.track = first.map((_, i) => first.findIndex((_, k) => same(i, k)));
      this.ways = first.map((from, i) => {
        const moves = motion.map((at) => add(at[i], from, -1));
        const far = moves.reduce((a, b) => (size(b) > size(a) ? b : a)), axis = unit(far);
        const fixed = size(far) < 1e-6 * this.extent;
        const straight = !fixed && moves.every((move) => size(cross(move, axis)) < 1e-6 * this.extent);
        const along = moves.map((move) => dot(move, axis));
        const ends = [Math.min(...along), Math.max(...along)].map((s) => add(from, axis, s));
        return { fixed, straight, ends };
      });
      const levels = motion.flat().map((p) => dot(p, this.up));
      this.floor = Math.min(...levels) - 0.03 * this.extent;
      this.joints = [...new Set(this.scene.joints.map((i) => this.track[i]))];
      const segments = this.scene.segments.map((s) => ({ part: s.part, from: this.track[s.from], to: this.track[s.to] }));
      // Many lines of a part that touch no joint are the outline of its shape.
      const free = (s) => !this.joints.includes(s.from) && !this.joints.includes(s.to);
      this.edges = segments.filter((s) => free(s) && segments.filter((o) => o.part === s.part && free(o)).length >= 6);
      this.rods = segments.filter((s) => !this.edges.includes(s));
      const ends = (list) => [...new Set(list.flatMap((s) => [s.from, s.to]))];
      this.corners = this.parts.map((part) => ends(this.edges.filter((s) => s.part === part)));
      this.moving = ends(this.rods).filter((i) => !this.ways[i].fixed);
      this.trail = [];
    }

    camera(width, height) {
      const { up, ahead, aside, yaw, pitch, scene, extent, middle, room: [low, high] } = this, margin = 34;
      const turned = add(ahead.map((x) => x * Math.cos(yaw)), aside, Math.sin(yaw));
      const level = add(ahead.map((x) => -x * Math.sin(yaw)), aside, Math.cos(yaw));
      const right = scene.spatial ? turned : [1, 0, 0], over = add(up.map((x) => x * Math.cos(pitch)), level, scene.spatial ? Math.sin(pitch) : 0);
      const into = scene.spatial ? add(up.map((x) => -x * Math.sin(pitch)), level, Math.cos(pitch)) : [0, 0, -1];
      const scale = scene.spatial
        ? (Math.min(width, 1.15 * height) - 2 * margin) / extent
        : Math.min((width - 2 * margin) / (high[0] - low[0] || 1), (height - 2 * margin) / (high[1] - low[1] || 1));
      const place = (p) => {
        const d = add(p, middle, -1), depth = dot(d, into), nearer = scene.spatial ? 3.5 * extent / (3.5 * extent + depth) : 1;
        return [width / 2 + scale * nearer * dot(d, right), (scene.spatial ? 0.44 : 0.5) * height - scale * nearer * dot(d, over), depth];
      };
      return { width, height, scale, place, right, over, into };
    }

    // `points` as they are, and those of another method beside them.
    draw(colours, points, other) {
      const [c, width, height] = livePrepare(this.canvas), cam = this.camera(width, height);
      const rod = Math.max(4, Math.min(8, cam.scale * this.extent / 40));
      this.colours = colours;
      this.halo = (text, x, y) => {
        c.strokeStyle = colours.page; c.lineWidth = 3; c.strokeText(text, x, y);
        c.fillStyle = colours.soft; c.fillText(text, x, y);
      };
      if (this.scene.spatial) this.drawFloor(c, cam, points, rod); else this.drawGrid(c, cam);
      this.drawGuides(c, cam);
      this.drawTrail(c, cam);
      if (other) this.drawOther(c, cam, other);
      this.drawBodies(c, cam, points, rod);
    }

    drawGrid(c, cam) {
      const step = round(Math.min(cam.width, cam.height) / cam.scale / 4), [x0, y0] = cam.place([0, 0, 0]), marks = [];
      const label = (i) => String(+(i * step).toPrecision(6));
      const rule = (i, ...line) => {
        c.strokeStyle = i === 0 ? this.colours.line : this.colours.grid; c.lineWidth = 1;
        path(c, line.map((p) => p.map((x) => Math.round(x) + 0.5))); c.stroke();
      };
      for (let i = Math.ceil(-x0 / cam.scale / step); x0 + i * step * cam.scale < cam.width; i++) {
        const x = x0 + i * step * cam.scale;
        rule(i, [x, 0], [x, cam.height]);
        if (x > 50 && x < cam.width - 20) marks.push([label(i), x, cam.height - 10, "center"]);
      }
      for (let i = Math.ceil((y0 - cam.height) / cam.scale / step); i * step * cam.scale < y0; i++) {
        const y = y0 - i * step * cam.scale;
        rule(i, [0, y], [cam.width, y]);
        if (y > 12 && y < cam.height - 26) marks.push([label(i), 8, y, "left"]);
      }
      c.textBaseline = "middle";
      for (const [text, x, y, align] of [...marks, ["m", 8, cam.height - 10, "left"]]) { c.textAlign = align; this.halo(text, x, y); }
    }

    drawFloor(c, cam, points, rod) {
      const onFloor = (p) => add(p, this.up, this.floor - dot(p, this.up));
      const step = round(this.extent / 7), reach = 0.62 * this.extent, foot = onFloor(this.middle);
      const spot = (a, b) => cam.place(add(add(foot, this.ahead, a), this.aside, b));
      const rim = Array.from({ length: 72 }, (_, i) => spot(reach * Math.cos(i / 36 * Math.PI), reach * Math.sin(i / 36 * Math.PI)));
      path(c, rim, true);
      c.fillStyle = this.colours.panel; c.fill();
      c.lineWidth = 1; c.strokeStyle = this.colours.grid; c.stroke();
      const rules = (middle, line) => {
        for (let i = Math.ceil((middle - reach) / step); i * step < middle + reach; i++) {
          const off = i * step - middle, half = Math.sqrt(Math.max(0, reach ** 2 - off ** 2));
          path(c, line(off, half)); c.stroke();
        }
      };
      rules(dot(this.middle, this.ahead), (a, half) => [spot(a, -half), spot(a, half)]);
      rules(dot(this.middle, this.aside), (b, half) => [spot(-half, b), spot(half, b)]);
      c.strokeStyle = this.colours.shadow; c.lineWidth = rod; c.globalAlpha = 0.35;
      c.beginPath();
      for (const s of this.rods) {
        const [a, b] = [s.from, s.to].map((i) => cam.place(onFloor(points[i])));
        c.moveTo(a[0], a[1]); c.lineTo(b[0], b[1]);
      }
      c.stroke();
      c.globalAlpha = 1; c.textAlign = "left"; c.textBaseline = "middle";
      this.halo(`grid ${+step.toPrecision(6)} m`, 8, cam.height - 10);
    }

    drawGuides(c, cam) {
      c.strokeStyle = this.colours.soft; c.lineWidth = 1; c.setLineDash([10, 4, 2, 4]);
      for (const i of this.joints) if (this.ways[i].straight) {
        const [a, b] = this.ways[i].ends, axis = unit(add(b, a, -1)), more = 24 / cam.scale;
        path(c, [cam.place(add(a, axis, -more)), cam.place(add(b, axis, more))]); c.stroke();
      }
      c.setLineDash([]);
    }

    remember(points) {
      this.trail.push(points);
      if (this.trail.length > TRAIL) this.trail.shift();
    }

    drawTrail(c, cam) {
      c.lineWidth = 1.6;
      for (const i of this.moving) {
        const way = this.trail.map((points) => cam.place(points[i]));
        c.strokeStyle = this.colourOf(this.rods.find((s) => s.from === i || s.to === i).part);
        for (let piece = 0; piece < PIECES; piece++) {
          const cut = (k) => Math.floor((way.length - 1) * k / PIECES);
          c.globalAlpha = 0.06 + 0.5 * ((piece + 1) / PIECES) ** 1.5;
          path(c, way.slice(cut(piece), cut(piece + 1) + 1)); c.stroke();
        }
      }
      c.globalAlpha = 1;
    }

    colourOf(part) { return this.colours.parts[this.parts.indexOf(part) % this.colours.parts.length]; }

    drawOther(c, cam, points) {
      c.strokeStyle = this.colours.methods[1]; c.lineWidth = 2; c.setLineDash([5, 5]);
      for (const s of this.rods) {
        const line = [points[s.from], points[s.to]].map(cam.place);
        // What has blown up is elsewhere.
        if (line.flat().every((x) => Math.abs(x) < 1e5)) { path(c, line); c.stroke(); }
      }
      c.setLineDash([]);
    }

    // Far things first. Rods of space are cut into pieces for that order.
    drawBodies(c, cam, points, rod) {
      const at = points.map(cam.place), items = [], pieces = this.scene.spatial ? 8 : 1;
      this.corners.forEach((corners, part) => {
        if (!corners.length) return;
        const rim = corners.map((i) => at[i]), middle = rim.reduce((sum, p) => sum + p[2], 0) / rim.length, colour = this.colourOf(this.parts[part]);
        items.push([middle, () => { path(c, hull(rim), true); c.fillStyle = colour; c.globalAlpha = 0.13; c.fill(); c.globalAlpha = 1; }]);
        for (const s of this.edges.filter((s) => s.part === this.parts[part])) {
          const [a, b] = [at[s.from], at[s.to]], depth = (a[2] + b[2]) / 2;
          items.push([depth, () => {
            c.strokeStyle = colour; c.lineWidth = 1; c.globalAlpha = depth > middle ? 0.35 : 0.8;
            path(c, [a, b]); c.stroke(); c.globalAlpha = 1;
          }]);
        }
      });
      for (const s of this.rods) {
        const [a, b] = [at[s.from], at[s.to]], cut = (t) => a.map((x, k) => x + (b[k] - x) * t), colour = this.colourOf(s.part);
        for (let k = 0; k < pieces; k++) {
          const from = cut(k / pieces), to = cut((k + 1) / pieces), depth = (from[2] + to[2]) / 2;
          items.push([depth, () => this.drawRod(c, from, to, colour, rod, k === 0, k === pieces - 1)]);
        }
      }
      for (const i of this.joints) {
        const p = at[i], way = this.ways[i];
        if (way.fixed) items.push([p[2] + 1e-3 * this.extent, () => this.drawSupport(c, cam, points[i], p)]);
        if (way.straight) items.push([p[2] + 1e-3 * this.extent, () => this.drawSlider(c, cam, way, p)]);
        items.push([p[2] - 0.07 * this.extent, () => disc(c, p, 0.62 * rod, this.colours.page, this.colours.ink, 1.6)]);
      }
      items.sort((a, b) => b[0] - a[0]);
      for (const [, draw] of items) draw();
    }

    // A rim in the colour of the page parts it from what it passes. Pieces of one rod overlap a little and hide their seams.
    drawRod(c, a, b, colour, width, first, final) {
      const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1, [x, y] = [0, 1].map((k) => (b[k] - a[k]) / length * 0.7);
      c.lineCap = "butt";
      for (const [paint, wide, more] of [[this.colours.page, width + 2.5, 0], [colour, width, 1]]) {
        c.strokeStyle = c.fillStyle = paint; c.lineWidth = wide;
        path(c, [[a[0] - more * x, a[1] - more * y], [b[0] + more * x, b[1] + more * y]]); c.stroke();
        for (const p of [first && a, final && b]) if (p) { c.beginPath(); c.arc(p[0], p[1], wide / 2, 0, 2 * Math.PI); c.fill(); }
      }
      c.lineCap = "round";
    }

    // Ground: a triangle with hatching in the plane, a pyramid in space.
    drawSupport(c, cam, point, p) {
      c.lineWidth = 1.3; c.strokeStyle = this.colours.ink; c.fillStyle = this.colours.page;
      if (this.scene.spatial) {
        const height = 15 / cam.scale, foot = add(point, this.up, -height);
        const corners = [[1, 1], [1, -1], [-1, -1], [-1, 1]].map(([i, k]) => cam.place(add(add(foot, this.ahead, 0.5 * i * height), this.aside, 0.5 * k * height)));
        path(c, corners, true); c.fill(); c.stroke();
        for (const [i, corner] of corners.entries()) { path(c, [p, corner, corners[(i + 1) % 4]], true); c.fill(); c.stroke(); }
        return;
      }
      c.save(); c.translate(p[0], p[1]);
      path(c, [[0, 0], [-9, 15], [9, 15]], true); c.fill(); c.stroke();
      path(c, [[-15, 15], [15, 15]]); c.stroke();
      c.lineWidth = 1;
      for (let x = -13; x <= 15; x += 5.6) { path(c, [[x, 15.5], [x - 5, 21]]); c.stroke(); }
      c.restore();
    }

    drawSlider(c, cam, way, p) {
      const [a, b] = way.ends.map(cam.place);
      c.save(); c.translate(p[0], p[1]); c.rotate(Math.atan2(b[1] - a[1], b[0] - a[0]));
      c.beginPath(); c.rect(-13, -8.5, 26, 17);
      c.fillStyle = this.colours.page; c.strokeStyle = this.colours.ink; c.lineWidth = 1.4;
      c.fill(); c.stroke(); c.restore();
    }
  };
}
