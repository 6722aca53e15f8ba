// The space that a robot sweeps: its size, its centre at each time, and the points to be framed.
import { Quaternion, Vector3 } from "three";
import { tips } from "./arrows.js";

const POINTS = 8000, FEWEST = 24, MOST = 240;  // instants, for so many points in all
const RISE = 10;  // sizes of the robot, which fit into a picture one above the other

export class Extent {
  // `turn` brings the recording's upward direction to z.
  constructor(recording, robot, turn) {
    const times = recording.main.times;
    const corners = recording.bodies.map((_, body) => robot.corners(body));
    const instants = Math.min(Math.max(POINTS / corners.flat().length, FEWEST), MOST);
    const every = Math.max(1, Math.floor(times.length / instants));
    const still = robot.corners(-1).map(x => x.clone().applyQuaternion(turn));
    this.low = new Vector3(Infinity, Infinity, Infinity);
    this.high = this.low.clone().negate();
    this.size = 0;
    this.common = { low: this.high.clone(), high: this.low.clone() };  // of the boxes of all times
    this.samples = [];
    for (let sample = 0; sample < times.length; sample += every) this.samples.push(sample);
    this.sets = this.samples.map(sample => pointsAt(recording.main, corners, sample, turn));
    this.centres = this.sets.map(points => this.add(points));
    const swept = this.high.clone().sub(this.low).length();
    this.size = Math.max(this.size, 1e-9);
    this.travels = swept > 1.6 * this.size && !this.stays;
    this.rises = this.high.z - this.low.z >= RISE * this.size;
    this.middle = (this.low.z + this.high.z) / 2;
    for (const point of still) {
      this.low.min(point);
      this.high.max(point);
    }
    if (!this.travels) this.size = Math.max(this.size, spread(still));
    this.swept = this.high.clone().sub(this.low).length();
    const near = this.low.z > -.02 * this.size && this.low.z < .3 * this.size;
    this.floor = near ? Math.min(this.low.z, 0) : this.low.z;
    this.times = this.samples.map(sample => times[sample]);
    const arrows = tips(recording, this.size);
    this.samples.forEach((sample, i) => this.sets[i].push(
      ...arrows(sample).map(x => x.applyQuaternion(turn))));
    this.points = this.framed(still);
  }

  // Count in the points of one instant; returns their centre.
  add(points) {
    const low = points[0].clone(), high = points[0].clone();
    for (const point of points) {
      low.min(point);
      high.max(point);
    }
    this.low.min(low);
    this.high.max(high);
    this.common.low.max(low);
    this.common.high.min(high);
    this.size = Math.max(this.size, high.clone().sub(low).length());
    return low.add(high).multiplyScalar(.5);
  }

  // Whether a place is in the robot's box at all times, as that of a base that stands.
  get stays() {
    const { low, high } = this.common;
    return low.x <= high.x && low.y <= high.y && low.z <= high.z;
  }

  // All points that must be in the picture: against the centre if the camera follows it.
  framed(still) {
    if (!this.travels) return [...this.sets.flat(), ...still];
    return this.sets.flatMap((points, i) => {
      const centre = this.level(this.centres[i].clone());
      return points.map(point => point.clone().sub(centre));
    });
  }

  // A rise that fits into the picture is seen, not followed.
  level(centre) { return this.rises ? centre : centre.setZ(this.middle); }

  // The centre at a time, as the camera follows it.
  centre(time, result) { return this.level(this.place(time, result)); }

  // The centre at a time.
  place(time, result) {
    let i = 0;
    while (i < this.times.length - 1 && this.times[i + 1] <= time) i++;
    const next = Math.min(i + 1, this.times.length - 1), span = this.times[next] - this.times[i];
    const share = span > 0 ? Math.min(Math.max((time - this.times[i]) / span, 0), 1) : 0;
    return result.copy(this.centres[i]).lerp(this.centres[next], share);
  }
}

function pointsAt(run, corners, sample, turn) {
  const pose = { at: new Vector3(), turn: new Quaternion() };
  return corners.flatMap((points, body) => {
    run.stored(body, sample, pose);
    return points.map(point =>
      point.clone().applyQuaternion(pose.turn).add(pose.at).applyQuaternion(turn));
  });
}

function spread(points) {
  if (!points.length) return 0;
  const low = points[0].clone(), high = points[0].clone();
  for (const point of points) {
    low.min(point);
    high.max(point);
  }
  return high.sub(low).length();
}
