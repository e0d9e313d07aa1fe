"use strict";
// The module that integrates: one instance for each figure, with two runs. Its functions are described in the crate
// `mbs-live`; a negative answer −n is a text of n bytes that says why not.
{
  const unpack = async () => {
    const packed = Uint8Array.from(atob(LIVE_MODULE), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return WebAssembly.compile(await new Response(stream).arrayBuffer());
  };
  let compiled;

  globalThis.LiveEngine = class {
    static async make(name) {
      compiled ??= unpack();
      const engine = new LiveEngine();
      engine.calls = (await WebAssembly.instantiate(await compiled, {})).exports;
      for (engine.index = 0; ; engine.index++) {
        engine.scene = engine.describe();
        if (engine.scene.name === name) return engine;
      }
    }

    // Views end with the memory they look at, which grows: a new one each time.
    numbers(count) { return new Float64Array(this.calls.memory.buffer, this.calls.live_buffer(), count); }
    text(length) { return new TextDecoder().decode(new Uint8Array(this.calls.memory.buffer, this.calls.live_text(), length)); }
    answered(number) {
      if (number < 0) throw new Error(this.text(-number));
      return number;
    }

    describe() {
      const scene = { parameters: [], points: [], segments: [], joints: [], methods: [] };
      const readers = {
        scene: ([name, title, world, ...up]) => Object.assign(scene, { name, title, spatial: world === "space", up: up.map(Number) }),
        size: ([q, v, rows]) => Object.assign(scene, { coordinates: +q, velocities: +v, rows: +rows }),
        steps: ([least, usual, most]) => { scene.step = { name: "step", unit: "s", value: +usual, least: +least, most: +most, doc: "Step." }; },
        parameter: ([name, unit, value, least, most, doc]) =>
          scene.parameters.push({ name, unit, value: +value, least: +least, most: +most, doc }),
        point: ([name]) => scene.points.push(name),
        segment: ([part, from, to]) => scene.segments.push({ part, from: +from, to: +to }),
        joint: ([point]) => scene.joints.push(+point),
        method: ([title]) => scene.methods.push(title),
      };
      for (const line of this.text(this.answered(this.calls.live_describe(this.index))).trimEnd().split("\n")) {
        const [kind, ...fields] = line.split("\t");
        readers[kind](fields);
      }
      return scene;
    }

    start(run, method, step, parameters) {
      this.numbers(parameters.length).set(parameters);
      this.answered(this.calls.live_start(run, this.index, method, step, parameters.length));
    }

    // Takes steps up to `time`, as far as the deadline allows; whether it got there.
    advance(run, time, deadline = Infinity) {
      const some = 50;
      while (this.answered(this.calls.live_advance(run, time, some)) === some) {
        if (performance.now() > deadline) return false;
      }
      return true;
    }

    read(run) {
      const [time, error, worst, holonomic, ...rest] = this.numbers(this.answered(this.calls.live_read(run)));
      return { time, error, worst, holonomic, points: this.scene.points.map((_, i) => rest.slice(3 * i, 3 * i + 3)) };
    }
  };
}
