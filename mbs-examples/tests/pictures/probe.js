// Uses the animation as a person would.
async function exercise() {
  const scene = document.getElementById("scene"), time = document.getElementById("time");
  const pointer = (target, name, x, y, pointerId = 1) =>
    target.dispatchEvent(new PointerEvent(name, { pointerId, clientX: x, clientY: y, buttons: 1, bubbles: true }));
  const key = (name) => document.body.dispatchEvent(new KeyboardEvent("keydown", { key: name, bubbles: true, cancelable: true }));
  const goTo = async (t) => { location.hash = `#t=${t}`; await later(); return pixels(scene); };
  const about = (text) => { const box = text.getBoundingClientRect(); return [box.left + 0.75 * box.width, box.top + 0.5 * box.height]; };

  const early = await goTo(1), clock = document.getElementById("clock").textContent;
  report("clock", clock);
  report("moved", differences(early, await goTo(2)));
  report("returned", differences(early, await goTo(1)));

  const frame = Number(time.value);
  key("ArrowRight");
  report("stepped", Number(time.value) - frame);
  key("Home");
  report("home", time.value);
  key(" ");
  report("played", document.getElementById("play").getAttribute("aria-label"));
  key(" ");

  const chart = document.querySelector("#charts canvas"), [x, y] = about(chart);
  pointer(chart, "pointerdown", x, y);
  pointer(chart, "pointerup", x, y);
  report("scrubbed", Number(time.value) / Number(time.max));

  const [u, w] = about(scene), upright = pixels(scene);
  pointer(scene, "pointerdown", u, w);
  pointer(scene, "pointermove", u - 80, w + 30);
  pointer(scene, "pointerup", u - 80, w + 30);
  report("dragged", differences(upright, pixels(scene)));
  document.getElementById("fit").click();
  report("reset", differences(upright, pixels(scene)));
  scene.dispatchEvent(new WheelEvent("wheel", { deltaY: -200, clientX: u, clientY: w, cancelable: true }));
  report("zoomed", differences(upright, pixels(scene)));

  document.getElementById("fit").click();
  pointer(scene, "pointerdown", u, w);
  pointer(scene, "pointerdown", u - 60, w, 2);
  pointer(scene, "pointermove", u - 120, w, 2);
  pointer(scene, "pointerup", u, w);
  pointer(scene, "pointerup", u - 120, w, 2);
  report("pinched", differences(upright, pixels(scene)));
  report("zoom", view.zoom);

  for (const chip of document.querySelectorAll(".chip")) chip.click();
  const before = document.documentElement.dataset.theme, theme = document.getElementById("theme");
  theme.click(); theme.click();
  report("themed", before !== document.documentElement.dataset.theme);
  report("wide", document.documentElement.scrollWidth - innerWidth);
}
addEventListener("load", async () => {
  await later();
  if (!document.getElementById("play").disabled) await exercise();
  report("ended", true);
});
