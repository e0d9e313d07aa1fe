"use strict";
// What a reader uses: the picture, the clock, the step and the parameters, the energy errors of two methods.
{
  const SPEEDS = [0.25, 1, 4, 16];
  // Of a frame, for integration: what is beyond makes the clock slower.
  const BUDGET = 10;
  // Time between two instants of a trail, s.
  const TRAIL = 0.02;
  const PLAY = "M4 2.5v11l9-5.5z", PAUSE = "M4 2.5h3v11H4zM9 2.5h3v11H9z", BACK = "M8 3a5 5 0 1 1-4.6 3M3 2v4h4";

  const element = (name, attributes = {}, ...children) => {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    made.append(...children);
    return made;
  };
  const button = (label, drawing, stroked) => {
    const made = element("button", { type: "button", "aria-label": label, title: label, class: stroked ? "" : "live-play" });
    const style = stroked ? `fill="none" stroke="currentColor" stroke-width="1.6" stroke-linecap="round"` : `fill="currentColor"`;
    made.innerHTML = `<svg viewBox="0 0 16 16" aria-hidden="true" ${style}><path d="${drawing}"/></svg>`;
    return made;
  };
  const short = (value) => (value === 0 ? "0" : value.toExponential(1));

  // A slider with a field beside it. The field takes what the slider does not; what cannot be is the runtime's to refuse.
  class Control {
    constructor(quantity, changed) {
      const { unit, least, most, value, doc } = quantity, [degrees, shown] = unit === "rad" ? [Math.PI / 180, "°"] : [1, unit];
      const logarithmic = least > 0 && most / least > 20;
      const place = logarithmic ? (x) => Math.log(x / least) / Math.log(most / least) : (x) => (x - least) / (most - least);
      const at = logarithmic ? (s) => least * (most / least) ** s : (s) => least + s * (most - least);
      const label = doc.replace(/[,.;].*/, "");
      const slider = element("input", { type: "range", min: 0, max: 1, step: 0.005, "aria-label": label });
      const field = element("input", { type: "number", step: "any", "aria-label": `${label}, ${shown}` });
      this.value = value;
      const show = () => {
        field.value = +(this.value / degrees).toPrecision(3);
        slider.setAttribute("aria-valuetext", `${field.value} ${shown}`);
      };
      slider.value = place(value);
      show();
      slider.addEventListener("input", () => {
        // As many digits as the field shows.
        this.value = +(at(+slider.value) / degrees).toPrecision(logarithmic ? 2 : 3) * degrees;
        show(); changed();
      });
      field.addEventListener("change", () => {
        this.value = field.value === "" ? NaN : +field.value * degrees;
        slider.value = Math.max(0, Math.min(1, place(this.value) || 0));
        slider.setAttribute("aria-valuetext", `${field.value} ${shown}`);
        changed();
      });
      this.row = element("label", { class: "live-control", "data-name": quantity.name }, element("span", {}, label), slider, element("span", { class: "live-field" }, field, ` ${shown}`));
    }
  }

  class LiveFigure {
    constructor(root, engine) {
      const { scene } = engine;
      Object.assign(this, { root, engine, playing: false, clock: 0, comparing: false, stopped: ["", ""], stale: true });
      this.step = new Control(scene.step, () => this.changed());
      this.parameters = scene.parameters.map((quantity) => new Control(quantity, () => this.changed()));
      this.play = button("Play", PLAY);
      const again = button("From the start", BACK, true);
      this.time = element("output", {});
      this.speed = element("select", { "aria-label": "Speed" }, ...SPEEDS.map((s) => element("option", { value: s }, `${s} ×`)));
      this.speed.value = 1;
      this.compare = element("button", { type: "button", class: "live-compare", "aria-pressed": "false" }, "Compare with");
      this.method = element("select", { "aria-label": "Method to compare with" }, ...scene.methods.slice(1).map((title, i) => element("option", { value: i + 1 }, title)));
      this.trouble = element("p", { class: "live-trouble", role: "status" });
      this.keys = [0, 1].map(() => element("tr", {}, ...["th", "td", "td"].map((cell) => element(cell))));
      const scenery = element("canvas", { class: "live-scene", role: "img", "aria-label": scene.title });
      const chart = element("canvas", { class: "live-chart", role: "img", "aria-label": "Energy error over time" });
      const head = element("tr", {}, ...["method", "largest so far, J", "rows |φ|"].map((text) => element("th", {}, text)));
      root.replaceChildren(
        scenery,
        element("div", { class: "live-bar" }, this.play, again, this.time, this.speed),
        element("div", { class: "live-controls" }, this.step.row, ...this.parameters.map((p) => p.row)),
        this.trouble,
        element("div", { class: "live-bar" }, element("span", {}, "Energy error"), this.compare, this.method),
        chart,
        element("table", { class: "live-keys" }, element("thead", {}, head), element("tbody", {}, ...this.keys)),
      );
      this.picture = new LivePicture(scenery, scene);
      this.chart = new LiveChart(chart);
      this.play.addEventListener("click", () => this.toggle());
      again.addEventListener("click", () => this.changed());
      this.compare.addEventListener("click", () => {
        this.comparing = !this.comparing;
        this.compare.setAttribute("aria-pressed", this.comparing);
        this.changed();
      });
      this.method.addEventListener("change", () => { this.comparing = true; this.compare.setAttribute("aria-pressed", "true"); this.changed(); });
      if (scene.spatial) this.orbit(scenery);
      const look = () => this.readColours();
      new MutationObserver(look).observe(document.documentElement, { attributes: true, attributeFilter: ["class"] });
      new ResizeObserver(() => this.request()).observe(root);
      new IntersectionObserver(([entry]) => { this.visible = entry.isIntersecting; this.request(); }).observe(root);
      look();
    }

    orbit(canvas) {
      let from = null;
      canvas.classList.add("live-orbit");
      canvas.addEventListener("pointerdown", (e) => { from = [e.clientX, e.clientY]; try { canvas.setPointerCapture(e.pointerId); } catch { /* a pointer that is gone */ } });
      canvas.addEventListener("pointermove", (e) => {
        if (!from) return;
        this.picture.yaw -= 0.008 * (e.clientX - from[0]);
        this.picture.pitch = Math.max(-0.2, Math.min(1.5, this.picture.pitch + 0.008 * (e.clientY - from[1])));
        from = [e.clientX, e.clientY];
        this.request();
      });
      for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, () => { from = null; });
    }

    readColours() {
      const style = getComputedStyle(this.root), read = (name) => style.getPropertyValue(`--${name}`).trim();
      const list = [0, 1, 2, 3, 4, 5].map((i) => read(`live-c${i}`));
      this.colours = { page: read("live-page"), parts: list, methods: [list[0], list[1]] };
      for (const name of ["ink", "soft", "grid", "line", "panel", "shadow"]) this.colours[name] = read(`live-${name}`);
      this.request();
    }

    changed() { this.stale = true; this.request(); }

    toggle() {
      this.playing = !this.playing && !this.stopped[0];
      this.play.setAttribute("aria-label", this.playing ? "Pause" : "Play");
      this.play.querySelector("path").setAttribute("d", this.playing ? PAUSE : PLAY);
      this.before = undefined;
      this.request();
    }

    request() { this.asked ??= requestAnimationFrame((now) => { this.asked = undefined; this.frame(now); }); }

    frame(now) {
      if (this.stale) this.restart();
      if (this.playing && this.visible) {
        // A page that was away does not catch up.
        const passed = Math.min(0.1, (now - (this.before ?? now)) / 1000);
        this.before = now;
        this.run(this.clock + passed * this.speed.value);
        if (this.playing) this.request();
      }
      this.show();
    }

    values() { return this.parameters.map((p) => p.value); }

    attempt(run, work) {
      if (this.stopped[run]) return;
      try { work(); } catch (error) { this.stopped[run] = error.message; }
    }

    restart() {
      const { engine } = this;
      this.stale = false; this.clock = 0; this.before = undefined; this.stopped = ["", ""]; this.now = [undefined, undefined];
      this.chart.clear();
      // Ten seconds in advance show how much room the motion takes.
      this.attempt(0, () => {
        const motion = [];
        engine.start(0, 0, 0.01, this.values());
        try {
          for (let i = 0; i < 200; i++) { motion.push(engine.read(0).points); engine.advance(0, 0.05 * (i + 1)); }
        } catch { /* the run itself will say what is wrong */ }
        engine.start(0, 0, this.step.value, this.values());
        this.picture.learn(motion);
        this.now[0] = engine.read(0);
        this.picture.remember(this.now[0].points);
      });
      if (this.comparing) this.attempt(1, () => {
        engine.start(1, +this.method.value, this.step.value, this.values());
        this.now[1] = engine.read(1);
      });
      if (this.stopped[0] && this.playing) this.toggle();
    }

    run(time) {
      const deadline = performance.now() + BUDGET;
      // At high speed a frame has several instants.
      for (let next = this.clock; next < time && !this.stopped[0] && performance.now() < deadline;) {
        next = Math.min(time, next + TRAIL);
        this.attempt(0, () => { if (!this.advance(0, next, deadline)) next = Math.min(next, this.now[0].time); });
        // The clock waits for the slower one, so that what is drawn is of one time.
        if (this.comparing) this.attempt(1, () => { if (!this.advance(1, next, deadline + BUDGET)) next = Math.min(next, this.now[1].time); });
        this.clock = next;
      }
      if (this.stopped[0]) this.toggle();
    }

    // Whether it got there.
    advance(run, time, deadline) {
      const arrived = this.engine.advance(run, time, deadline), now = this.engine.read(run);
      if (now.time !== this.now[run].time) {
        this.chart.push(run, now.time, now.worst);
        if (!run) this.picture.remember(now.points);
      }
      this.now[run] = now;
      return arrived;
    }

    show() {
      const [ours, other] = this.now, { scene } = this.engine;
      this.root.dataset.time = ours?.time ?? "";
      this.time.textContent = `${(ours?.time ?? 0).toFixed(2)} s`;
      const named = [scene.methods[0], this.method.selectedOptions[0].textContent];
      const [here, there] = this.stopped;
      // A clock adds up steps, and shows it in its last digits.
      this.trouble.textContent = (here || (there && `${named[1]} stopped: ${there}`)).replace(/\d+\.\d{8,}/g, (x) => +(+x).toPrecision(9));
      [ours, other].forEach((now, i) => {
        const [name, energy, rows] = this.keys[i].children;
        this.keys[i].hidden = i > 0 && !this.comparing;
        name.textContent = named[i];
        name.style.setProperty("--key", this.colours.methods[i]);
        energy.textContent = now ? short(this.chart.series[i].most) : "–";
        rows.textContent = now && scene.rows ? short(now.holonomic) : "–";
      });
      if (ours) this.picture.draw(this.colours, ours.points, this.comparing && other?.points);
      this.chart.draw(this.colours, [true, this.comparing]);
    }
  }

  const failed = (root, error) => root.replaceChildren(element("p", { class: "live-trouble" }, `This figure cannot run here: ${error.message}`));
  for (const root of document.querySelectorAll(".live[data-scene]")) {
    LiveEngine.make(root.dataset.scene).then((engine) => new LiveFigure(root, engine)).catch((error) => failed(root, error));
  }
}
