"use strict";
// Magnitudes over time on a logarithmic scale: as they are, and the largest so far. The time axis doubles when it is full,
// and pairs of bins become one: a figure may run for hours.
{
  const BINS = 480, FIRST = 20, FLOOR = 1e-17;

  globalThis.LiveChart = class {
    constructor(canvas) { this.canvas = canvas; this.clear(); }

    clear() {
      this.span = FIRST;
      this.series = [0, 1].map(() => ({ bins: new Float64Array(BINS).fill(NaN), most: 0 }));
    }

    push(which, time, value) {
      while (time > this.span) this.halve();
      const series = this.series[which], bin = Math.min(BINS - 1, Math.floor(time / this.span * BINS));
      series.bins[bin] = Math.max(series.bins[bin] || 0, value);
      series.most = Math.max(series.most, value);
    }

    halve() {
      this.span *= 2;
      for (const { bins } of this.series) {
        const pairs = Float64Array.from({ length: BINS / 2 }, (_, i) => Math.max(bins[2 * i] || 0, bins[2 * i + 1] || 0) || NaN);
        bins.fill(NaN).set(pairs);
      }
    }

    draw(colours, shown) {
      const [c, width, height] = livePrepare(this.canvas);
      const left = 44, right = width - 8, top = 8, bottom = height - 20;
      const values = this.series.filter((_, i) => shown[i]).flatMap(({ bins }) => [...bins].filter((x) => x > FLOOR));
      if (!values.length) values.push(1e-8, 1);
      // Four to fourteen decades. What has blown up leaves at the top.
      const most = Math.max(-13, Math.min(4, Math.ceil(Math.log10(Math.max(...values)) + 0.05)));
      const least = Math.min(most - 4, Math.max(most - 14, Math.floor(Math.log10(Math.min(...values)))));
      const x = (bin) => left + (bin + 0.5) / BINS * (right - left);
      const y = (value) => bottom - (Math.log10(Math.max(value, FLOOR)) - least) / (most - least) * (bottom - top);

      c.lineWidth = 1; c.strokeStyle = colours.grid; c.fillStyle = colours.soft; c.textBaseline = "middle";
      const each = Math.ceil((most - least) / Math.max(2, Math.floor((bottom - top) / 24)));
      c.textAlign = "right";
      for (let k = least; k <= most; k += each) {
        const level = Math.round(y(10 ** k)) + 0.5;
        c.beginPath(); c.moveTo(left, level); c.lineTo(right, level); c.stroke();
        c.fillText(`1e${k}`, left - 6, level);
      }
      for (let i = 0; i <= 4; i++) {
        c.textAlign = i === 4 ? "right" : i ? "center" : "left";
        c.fillText(`${this.span * i / 4}${i === 4 ? " s" : ""}`, left + i / 4 * (right - left), bottom + 12);
      }

      c.save();
      c.beginPath(); c.rect(left, top, right - left, bottom - top); c.clip();
      this.series.forEach(({ bins }, i) => {
        if (!shown[i]) return;
        c.strokeStyle = colours.methods[i];
        const curve = (value) => {
          c.beginPath();
          bins.forEach((bin, k) => { if (!Number.isNaN(bin)) c.lineTo(x(k), y(value(bin))); });
          c.stroke();
        };
        c.lineWidth = 1; c.globalAlpha = 0.4; curve((bin) => bin);
        let largest = 0;
        c.lineWidth = 2; c.globalAlpha = 1; curve((bin) => (largest = Math.max(largest, bin)));
      });
      c.restore();
    }
  };
}
