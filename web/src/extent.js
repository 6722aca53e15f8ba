// The space that a robot sweeps: its size, its centre at each time, and the points to be framed.
import { Box3, Quaternion, Vector3 } from "three";
import { tips } from "./arrows.js";
import { Leaving } from "./leaving.js";

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
    this.samples = [];
    for (let sample = 0; sample < times.length; sample += every) this.samples.push(sample);
    const bodies = this.samples.map(sample => pointsAt(recording.main, corners, sample, turn));
    const boxes = bodies.map(at => at.map(points => new Box3().setFromPoints(points)));
    this.leaving = new Leaving(recording.joints, boxes);
    const stay = (_, body) => !this.leaving.bodies.has(body);
    const staying = boxes.map(at => at.filter(stay).reduce((all, x) => all.union(x), new Box3()));
    const { min: low, max: high } = staying.reduce((all, x) => all.union(x), new Box3());
    Object.assign(this, { low, high });
    this.size = Math.max(...staying.map(box => box.getSize(new Vector3()).length()));
    this.common = staying.reduce((all, box) => all.intersect(box), staying[0].clone());
    this.centres = staying.map(box => box.getCenter(new Vector3()));
    this.sets = bodies.map((at, i) => at.filter((points, body) =>
      stay(points, body) || this.leaving.near(i, boxes[i][body])).flat());
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
      ...arrows(sample).map(x => x.applyQuaternion(turn)).filter(x =>
        this.leaving.near(i, { min: x, max: x }))));
    this.points = this.framed(still);
  }

  // Whether a place is in the robot's box at all times, as that of a base that stands.
  get stays() { return !this.common.isEmpty(); }

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

// The corners of each body in one sample.
function pointsAt(run, corners, sample, turn) {
  const pose = { at: new Vector3(), turn: new Quaternion() };
  return corners.map((points, body) => {
    run.stored(body, sample, pose);
    return points.map(point =>
      point.clone().applyQuaternion(pose.turn).add(pose.at).applyQuaternion(turn));
  });
}

function spread(points) {
  return points.length ? new Box3().setFromPoints(points).getSize(new Vector3()).length() : 0;
}
