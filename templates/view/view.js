"use strict";
// Plays a recording: time, controls, charts.  All it knows is the data embedded in the page.

const $ = id => document.getElementById(id);
const data = JSON.parse($("data").textContent);
const bytes = text => Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer;
const times = new Float64Array(bytes(data.t));
const poses = new Float32Array(bytes(data.poses));  // frames × bodies × 7
const columns = data.values.map(x => ({ unit: x.unit === "1" ? "" : ` ${x.unit}`,
                                        values: new Float64Array(bytes(x.values)) }));
const end = times.at(-1), count = data.bodies.length;
const HUES = [212, 28, 152, 330, 48, 268, 185, 0, 90, 240];
const canvas = $("space"), context = canvas.getContext("2d");

const stored = (frame, body) => Array.from(
  poses.subarray(7 * (frame * count + body), 7 * (frame * count + body) + 7));

const state = { time: 0, playing: false, speed: Number($("speed").value), last: null };
const { target, distance, floor } = framing();
const view = camera(target, distance, data.up), home = { ...view };

// The frame at or before a time, and how far the time is on the way to the next.
function frameAt(t) {
  let low = 0, high = times.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle; else high = middle;
  }
  const span = times[high] - times[low];
  return [low, high, span > 0 ? Math.min(Math.max((t - times[low]) / span, 0), 1) : 0];
}

function poseOf(body, t) {
  if (body < 0) return REST;
  const [low, high, k] = frameAt(t);
  return between(stored(low, body), stored(high, body), k);
}

// What the camera looks at, from how far, and how high the floor is, for all that is ever drawn.
function framing() {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  let floor = Infinity;
  const every = Math.max(1, Math.floor(times.length / 200));
  for (let frame = 0; frame < times.length; frame += every) {
    for (const { body, points } of data.extent) {
      const pose = body < 0 ? REST : stored(frame, body);
      for (const point of points) {
        const at = placed(pose, point);
        floor = Math.min(floor, dot(at, data.up));
        at.forEach((x, i) => {
          low[i] = Math.min(low[i], x);
          high[i] = Math.max(high[i], x);
        });
      }
    }
  }
  const size = Math.max(Math.hypot(...plus(high, low, -1)), 1e-9);
  return { target: scaled(plus(low, high), .5), distance: 1.2 * size, floor };
}

const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

function draw() {
  const ratio = devicePixelRatio || 1, { clientWidth: width, clientHeight: height } = canvas;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.font = "12px system-ui, sans-serif";
  context.lineJoin = context.lineCap = "round";
  const painter = new Painter(context, projection(view, width, height), view.distance / 100);
  const now = Array.from({ length: count }, (_, body) => poseOf(body, state.time));
  const at = body => body < 0 ? REST : now[body];
  const ink = colour("--ink"), quiet = colour("--quiet"), card = colour("--card");
  drawGrid(painter, colour("--rule"));
  const light = unit(plus(plus(view.axes[2], view.axes[0], .5), view.axes[1], -.3));
  for (const { body, shape } of data.shapes) {
    painter.box(at(body), shape, body < 0 ? 215 : HUES[body % HUES.length], light);
  }
  for (const { body, points: [from, to], rod } of data.lines) {
    painter.rod(placed(at(body), from), placed(at(body), to), rod ? quiet : ink, rod ? 2 : 3.5);
  }
  for (const { body, point, child } of data.slides) {
    painter.line(placed(at(body), point), placed(at(child), [0, 0, 0]), quiet, 2, [5, 4]);
  }
  for (const { body, point } of data.joints) painter.disc(placed(at(body), point), 4.5, card, ink);
  if ($("names").checked) {
    data.bodies.forEach((name, body) =>
      painter.text(placed(now[body], data.labels[body]), name, ink));
  }
  painter.paint();
}

// A grid below everything, across the upward direction, its lines 1, 2 or 5 times a power of ten
// apart.
function drawGrid(painter, style) {
  const [first, second, up] = home.axes, size = home.distance / 1.2;
  const decade = 10 ** Math.floor(Math.log10(size / 6));
  const step = decade * [1, 2, 5, 10].find(k => k * decade > size / 6);
  const centre = plus(home.target, up, floor - dot(home.target, up));
  const half = Math.ceil(.7 * size / step);
  for (let i = -half; i <= half; i++) {
    for (const [along, across] of [[first, second], [second, first]]) {
      const middle = plus(centre, across, i * step);
      for (let j = -half; j < half; j++) {
        painter.line(plus(middle, along, j * step), plus(middle, along, (j + 1) * step), style, 1);
      }
    }
  }
}

const digits = Math.min(6, Math.max(2, Math.ceil(2 - Math.log10(end || 1))));
const written = x => Math.abs(x) >= 1e5 || x !== 0 && Math.abs(x) < 1e-3
  ? x.toExponential(4) : String(Number(x.toPrecision(5)));

function show() {
  const [low, high, k] = frameAt(state.time);
  $("time").value = end > 0 ? state.time / end : 0;
  $("time").setAttribute("aria-valuetext", `${state.time.toFixed(digits)} seconds`);
  $("clock").textContent = `${state.time.toFixed(digits)} / ${written(end)} s`;
  const values = document.querySelectorAll(".value");
  columns.forEach(({ unit, values: of }, i) => {
    values[i].textContent = written(of[low] * (1 - k) + of[high] * k) + unit;
  });
  const [left, width] = data.chart, share = end > 0 ? state.time / end : 0;
  for (const cursor of document.querySelectorAll(".cursor")) {
    cursor.style.left = `${100 * (left + width * share)}%`;
  }
  $("play").textContent = state.playing ? "Pause" : "Play";
  draw();
}

function seek(t) {
  state.time = Math.min(Math.max(t, 0), end);
  show();
}

function play(on) {
  if (on && state.time >= end) state.time = 0;
  state.playing = on;
  state.last = null;
  show();
  if (on) requestAnimationFrame(tick);
}

function tick(now) {
  if (!state.playing) return;
  if (state.last !== null) state.time += state.speed * (now - state.last) / 1000;
  state.last = now;
  if (state.time >= end) {
    state.time = end;
    play(false);
    return;
  }
  show();
  requestAnimationFrame(tick);
}
