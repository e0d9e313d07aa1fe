// Uses a live figure as a reader would. Frames come from a clock of their own: the virtual time of a headless browser passes
// without any, and nobody scrolls there.
window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 16);
window.IntersectionObserver = class {
  constructor(told) { this.told = told; }
  observe() { this.told([{ isIntersecting: true }]); }
};

async function use(root) {
  const name = root.dataset.scene, told = (what, value) => report(`${name}-${what}`, value);
  const [scene, chart] = root.querySelectorAll("canvas"), play = root.querySelector(".live-play");
  const time = () => Number(root.dataset.time), trouble = () => root.querySelector(".live-trouble").textContent;
  const set = async (quantity, value) => {
    const field = root.querySelector(`[data-name="${quantity}"] input[type=number]`);
    field.value = value;
    field.dispatchEvent(new Event("change"));
    await later();
  };
  const still = pixels(scene);
  play.click();
  await later(1000);
  play.click();
  await later();
  const paused = time();
  told("time", paused);
  told("moved", differences(still, pixels(scene)));
  await later(200);
  told("waited", time() - paused);

  const alone = pixels(chart);
  root.querySelector(".live-compare").click();
  play.click();
  await later(1000);
  told("compared", differences(alone, pixels(chart)));
  const keys = [...root.querySelectorAll("tbody tr")].map((row) => Number(row.children[1].textContent));
  told("ours", keys[0]);
  told("theirs", keys[1]);
  told("silent", trouble() === "");

  // A length that is no number, a step beyond its range: a sentence, and back again.
  await set(root.querySelectorAll("[data-name]")[1].dataset.name, "");
  told("parameter", trouble());
  await set(root.querySelectorAll("[data-name]")[1].dataset.name, 1.5);
  await set("step", 7);
  told("step", trouble());
  await set("step", 0.05);
  told("recovered", trouble() === "");
  if (play.getAttribute("aria-label") === "Play") play.click();
  await later(500);
  told("again", time());

  const light = pixels(scene);
  document.documentElement.className = "navy";
  play.click();
  await later();
  told("themed", differences(light, pixels(scene)));
  document.documentElement.className = "light";
}

// The module is unpacked and compiled beside the clock of a headless browser, which runs ahead: it is held up until then.
async function settled() {
  const figures = [...document.querySelectorAll(".live")];
  const waits = () => figures.some((root) => root.querySelectorAll("canvas").length < 2);
  for (let tick = 0; tick < 3000 && waits(); tick++) {
    await later(1);
    for (let i = 0; i < 3e6; i++) globalThis.held = (globalThis.held ^ i) + 1;
  }
  await later(1000);
}

addEventListener("load", async () => {
  await settled();
  for (const root of document.querySelectorAll(".live")) await use(root);
  report("wide", document.documentElement.scrollWidth - innerWidth);
  report("ended", true);
});
