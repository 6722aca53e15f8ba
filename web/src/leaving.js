// The bodies that fly off: they leave the robot behind, which the picture keeps.
import { Box3, Vector3 } from "three";

const REACH = 2;  // sizes of all at the start, from the robot to what has left it

// The robot among the bodies, and what leaves it; `boxes` has the box of each body at each instant.
// Bodies between which no joint slides are one part; the robot is the part of most bodies.
export class Leaving {
  constructor(joints, boxes) {
    const parts = partsOf(joints, boxes[0].length);
    const robot = parts.reduce((best, one) => one.length > best.length ? one : best);
    this.robots = boxes.map(at => union(robot.map(body => at[body])));
    this.reach = REACH * union(boxes[0]).getSize(new Vector3()).length();
    const gone = part => part !== robot && boxes.some((at, instant) =>
      part.some(body => !this.near(instant, at[body])));
    this.bodies = new Set(parts.filter(gone).flat());
  }

  // Whether a box, or a point, is within reach of the robot at an instant.
  near(instant, { min, max }) {
    const robot = this.robots[instant], gap = new Vector3();
    gap.max(robot.min.clone().sub(max)).max(min.clone().sub(robot.max));
    return gap.length() <= this.reach;
  }
}

const union = boxes => boxes.reduce((all, box) => all.union(box), new Box3());

// Lists of bodies that joints connect without sliding, also by the world.
function partsOf(joints, count) {
  const part = new Map([[-1, []]]);
  for (let body = 0; body < count; body++) part.set(body, [body]);
  for (const { parent, child, slides } of joints) {
    const [into, from] = [part.get(parent), part.get(child)];
    if (slides || into === from) continue;
    into.push(...from);
    for (const body of from) part.set(body, into);
    part.set(child, into);
  }
  return [...new Set(part.values())].filter(bodies => bodies.length);
}
