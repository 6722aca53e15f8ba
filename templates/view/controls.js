"use strict";
// The page's controls: buttons, keys, mouse and touch.

$("play").addEventListener("click", () => play(!state.playing));
$("start").addEventListener("click", () => { play(false); seek(0); });
$("time").addEventListener("input", () => {
  const time = Number($("time").value) * end;  // before the page shows the old one again
  play(false);
  seek(time);
});
$("speed").addEventListener("change", () => { state.speed = Number($("speed").value); });
$("names").addEventListener("change", draw);
$("reset").addEventListener("click", () => { Object.assign(view, home); draw(); });

for (const chart of document.querySelectorAll(".chart")) {
  chart.addEventListener("click", event => {
    const box = chart.getBoundingClientRect(), [left, width] = data.chart;
    play(false);
    seek(end * ((event.clientX - box.left) / box.width - left) / width);
  });
}

function orbit(dx, dy) {
  view.azimuth -= dx;
  view.elevation = Math.min(Math.max(view.elevation + dy, -1.55), 1.55);
  draw();
}

function zoom(factor) {
  const wanted = view.distance * factor;
  view.distance = Math.min(Math.max(wanted, home.distance / 50), home.distance * 20);
  draw();
}

document.addEventListener("keydown", event => {
  const tag = event.target.tagName;
  if (event.key === " " && !["BUTTON", "INPUT", "SELECT", "SUMMARY"].includes(tag)) {
    event.preventDefault();
    play(!state.playing);
  }
});

canvas.addEventListener("keydown", event => {
  const action = {
    ArrowLeft: () => orbit(-.1, 0), ArrowRight: () => orbit(.1, 0),
    ArrowUp: () => orbit(0, .1), ArrowDown: () => orbit(0, -.1),
    "+": () => zoom(1 / 1.2), "=": () => zoom(1 / 1.2), "-": () => zoom(1.2) }[event.key];
  if (action) {
    event.preventDefault();
    action();
  }
});

// One pointer orbits; two zoom by their distance.
const pointers = new Map();
const apart = () => {
  const [a, b] = [...pointers.values()];
  return Math.hypot(a.x - b.x, a.y - b.y);
};
canvas.addEventListener("pointerdown", event => {
  canvas.setPointerCapture(event.pointerId);
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
});
canvas.addEventListener("pointermove", event => {
  const before = pointers.get(event.pointerId);
  if (!before) return;
  const distance = pointers.size === 2 ? apart() : 0;
  pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  if (pointers.size === 1) {
    orbit((event.clientX - before.x) / 150, (event.clientY - before.y) / 150);
  }
  if (pointers.size === 2 && apart() > 0) zoom(distance / apart());
});
for (const name of ["pointerup", "pointercancel"]) {
  canvas.addEventListener(name, event => pointers.delete(event.pointerId));
}
// Without focus the wheel scrolls the page.
canvas.addEventListener("wheel", event => {
  if (document.activeElement !== canvas && !event.ctrlKey) return;
  event.preventDefault();
  zoom(Math.exp(event.deltaY / 500));
}, { passive: false });

new ResizeObserver(draw).observe(canvas);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", draw);
show();
