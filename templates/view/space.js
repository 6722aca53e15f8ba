"use strict";
// Bodies in space, drawn on a canvas: camera, perspective, painter's order.  Knows poses and
// shapes, not time.  Vectors are arrays of three; a pose is a position and a unit quaternion
// (x, y, z, w): seven numbers.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const plus = (a, b, k = 1) => [a[0] + k * b[0], a[1] + k * b[1], a[2] + k * b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]];
const scaled = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
const unit = a => scaled(a, 1 / Math.hypot(...a));

const REST = [0, 0, 0, 0, 0, 0, 1];

// R(q) p + t
function placed(pose, p) {
  const v = [pose[3], pose[4], pose[5]], w = pose[6];
  const twice = scaled(cross(v, p), 2);
  return plus(plus(plus(p, twice, w), cross(v, twice)), pose);
}

// Between two poses: positions on a line, quaternions on the shorter arc.
function between(a, b, k) {
  const near = a[3] * b[3] + a[4] * b[4] + a[5] * b[5] + a[6] * b[6] < 0 ? -k : k;
  const pose = a.map((x, i) => x * (1 - k) + b[i] * (i < 3 ? k : near));
  const norm = Math.hypot(pose[3], pose[4], pose[5], pose[6]);
  return pose.map((x, i) => i < 3 ? x : x / norm);
}

// A camera that looks at `target` from `distance`; angles are about `up`.
function camera(target, distance, up) {
  const third = unit(up), other = Math.abs(third[0]) < .9 ? [1, 0, 0] : [0, 1, 0];
  const first = unit(cross(other, third));
  const axes = [first, cross(third, first), third];
  return { target, distance, axes, azimuth: -2.2, elevation: .35 };
}

// What turns points into pixels: (p) -> [x, y, depth], depth <= 0 behind the eye.
function projection(view, width, height) {
  const [ca, sa, ce, se] = [Math.cos(view.azimuth), Math.sin(view.azimuth),
                            Math.cos(view.elevation), Math.sin(view.elevation)];
  const mixed = (x, y, z) => plus(plus(scaled(view.axes[0], x), view.axes[1], y), view.axes[2], z);
  const back = mixed(ce * ca, ce * sa, se), right = mixed(-sa, ca, 0), above = cross(back, right);
  const focal = 1.4 * Math.min(width, height);
  return p => {
    const from = plus(p, view.target, -1), depth = view.distance - dot(from, back);
    const k = focal / depth;
    return [width / 2 + k * dot(from, right), height / 2 - k * dot(from, above), depth];
  };
}

const CORNERS = [0, 1, 2, 3, 4, 5, 6, 7].map(i => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1]);
const FACES = [[0, 2, 6, 4], [1, 3, 7, 5], [0, 1, 5, 4], [2, 3, 7, 6], [0, 1, 3, 2], [4, 5, 7, 6]];

// Draws faces, lines and points from far to near.
class Painter {
  constructor(context, project, nearest) {
    this.context = context;
    this.project = project;
    this.nearest = nearest;
    this.items = [];
  }

  add(points, draw) {
    const pixels = points.map(this.project);
    if (pixels.some(p => p[2] < this.nearest)) return;
    const depth = pixels.reduce((sum, p) => sum + p[2], 0) / pixels.length;
    this.items.push({ depth, pixels, draw });
  }

  box(pose, shape, hue, light) {
    const corners = CORNERS.map(c => placed(pose, placed(shape.place,
      [c[0] * shape.half[0], c[1] * shape.half[1], c[2] * shape.half[2]])));
    const centre = placed(pose, shape.place);
    for (const face of FACES) {
      const points = face.map(i => corners[i]);
      const middle = scaled(points.reduce((a, b) => plus(a, b)), .25);
      const out = plus(middle, centre, -1), size = Math.hypot(...out);
      const bright = 46 + 22 * (size > 0 ? dot(out, light) / size : 0);
      this.add(points, (context, pixels) => {
        trace(context, pixels);
        context.closePath();
        context.fillStyle = `hsl(${hue} 52% ${bright}%)`;
        context.strokeStyle = `hsl(${hue} 45% 24%)`;
        context.lineWidth = 1;
        context.fill();
        context.stroke();
      });
    }
  }

  line(from, to, style, width, dashes = []) {
    this.add([from, to], (context, pixels) => {
      trace(context, pixels);
      context.strokeStyle = style;
      context.lineWidth = width;
      context.setLineDash(dashes);
      context.stroke();
      context.setLineDash([]);
    });
  }

  // A line in pieces, so that it may end inside a box.
  rod(from, to, style, width) {
    const at = k => plus(scaled(from, 1 - k), to, k);
    for (let k = 0; k < 1; k += .125) this.line(at(k), at(k + .125), style, width);
  }

  disc(at, radius, fill, rim) {
    this.add([at], (context, [[x, y]]) => {
      context.beginPath();
      context.arc(x, y, radius, 0, 2 * Math.PI);
      context.fillStyle = fill;
      context.strokeStyle = rim;
      context.lineWidth = 1.5;
      context.fill();
      context.stroke();
    });
  }

  text(at, words, style) {
    this.add([at], (context, [[x, y]]) => {
      context.fillStyle = style;
      context.fillText(words, x + 7, y - 7);
    });
  }

  paint() {
    this.items.sort((a, b) => b.depth - a.depth);
    for (const item of this.items) item.draw(this.context, item.pixels);
  }
}

function trace(context, pixels) {
  context.beginPath();
  for (const [x, y] of pixels) context.lineTo(x, y);
}
