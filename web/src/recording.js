// The recording in the page: its arrays, and the bodies' poses at any time.  Draws nothing.
import { Quaternion, Vector3 } from "three";

const KINDS = {
  f8: Float64Array, f4: Float32Array, u2: Uint16Array, i2: Int16Array, i4: Int32Array,
};

// The array that stands in the block from byte `at`, in planes: the first byte of every number,
// then the second bytes, and so on.
export function unpacked(block, [at, kind, count]) {
  const numbers = new KINDS[kind](count), size = numbers.BYTES_PER_ELEMENT;
  const bytes = new Uint8Array(numbers.buffer);
  for (let place = 0; place < size; place++) {
    for (let i = 0; i < count; i++) bytes[i * size + place] = block[at + place * count + i];
  }
  return numbers;
}

// Poses of all bodies at the times of one run; `low`, `high` and `share` are where a time lies.
export class Run {
  constructor(given, block, count) {
    this.label = given.label;
    this.shown = given.shown;
    this.times = unpacked(block, given.t);
    this.poses = unpacked(block, given.poses);  // bodies × 7 × times
    this.count = count;
    this.low = this.high = this.share = 0;
    this.before = { at: new Vector3(), turn: new Quaternion() };
    this.after = { at: new Vector3(), turn: new Quaternion() };
  }

  get begin() { return this.times[0]; }

  get end() { return this.times[this.times.length - 1]; }

  // Find the samples before and after a time.
  locate(time) {
    let low = 0, high = this.times.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if (this.times[middle] <= time) low = middle; else high = middle;
    }
    const span = this.times[high] - this.times[low];
    this.low = low;
    this.high = high;
    this.share = span > 0 ? Math.min(Math.max((time - this.times[low]) / span, 0), 1) : 0;
  }

  // The recorded pose of a body (-1: the world) in one sample.
  stored(body, sample, { at, turn }) {
    if (body < 0) {
      at.set(0, 0, 0);
      turn.identity();
      return;
    }
    const n = this.times.length, p = (7 * body) * n + sample, x = this.poses;
    at.set(x[p], x[p + n], x[p + 2 * n]);
    turn.set(x[p + 3 * n], x[p + 4 * n], x[p + 5 * n], x[p + 6 * n]);
  }

  // The pose of a body at the located time: positions on a line, quaternions on the shorter arc.
  pose(body, position, quaternion) {
    this.stored(body, this.low, this.before);
    this.stored(body, this.high, this.after);
    position.copy(this.before.at).lerp(this.after.at, this.share);
    quaternion.copy(this.before.turn).slerp(this.after.turn, this.share);
  }

  // The value of a signal of this run at the located time.
  value(numbers) {
    return numbers[this.low] + (numbers[this.high] - numbers[this.low]) * this.share;
  }
}

// All that the page holds; `data` is its JSON, `block` the bytes of its arrays.
export class Recording {
  constructor(data, block) {
    Object.assign(this, data);
    this.block = block;
    this.runs = data.runs.map(run => new Run(run, block, data.bodies.length));
    this.main = this.runs[0];
    this.begin = Math.min(...this.runs.map(run => run.begin));
    this.end = Math.max(...this.runs.map(run => run.end));
    this.contacts = data.contacts.map(x => x.map(place => unpacked(block, place)));
    for (const group of this.groups) {
      group.signals.sort((a, b) => a.run - b.run);  // as plots join their runs
      for (const signal of group.signals) {
        const small = unpacked(block, signal.values);
        signal.numbers = Float64Array.from(small, x => x + signal.base);
      }
    }
  }

  locate(time) { for (const run of this.runs) run.locate(time); }

  array(place) { return unpacked(this.block, place); }
}
