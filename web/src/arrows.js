// Arrows of recorded forces and of contacts: a mark, and the points that are to be in the picture.
import {
  ConeGeometry, CylinderGeometry, Group, Mesh, Quaternion, SphereGeometry, Vector3,
} from "three";
import { above } from "./marks.js";

const Y = new Vector3(0, 1, 0), a = new Vector3(), spare = new Quaternion();
const CONTACT = 0x12a594;  // colour
const LONGEST = .33, TYPICAL = .2;  // lengths of arrows, in sizes of the robot
const MOST = .9;  // the share of forces whose arrows are at most TYPICAL

// The arrows with their numbers, and a function from a force to its arrow's length in sizes of the
// robot: in proportion, except shocks, which would make all others too small.  Arrows stand on a
// point of a body, those of contacts on places in the world.
export function forces(recording) {
  const signals = recording.groups.flatMap(group => group.signals);
  const given = recording.arrows.map(arrow => ({
    ...arrow, numbers: arrow.signals.map(name => signals.find(x => x.name === name).numbers) }));
  given.push(...recording.contacts.map(arrays => ({
    places: arrays.slice(0, 3), numbers: arrays.slice(3), colour: CONTACT })));
  const sizes = given.flatMap(({ numbers: [x, y, z] }) =>
    Array.from(x, (_, i) => Math.hypot(x[i], y[i], z[i]))).filter(x => x > 0).sort((x, y) => x - y);
  const typical = sizes[Math.floor(MOST * (sizes.length - 1))] || 1;
  return { given, length: force => Math.min(TYPICAL * force / typical, LONGEST) };
}

// A function from a sample to the points of all arrows.
export function tips(recording, size) {
  const { given, length } = forces(recording);
  const pose = { at: new Vector3(), turn: new Quaternion() };
  return sample => given.flatMap(({ body, point, places, numbers, turns }) => {
    const tip = new Vector3(...numbers.map(x => x[sample] || 0));
    if (places && !tip.length()) return [];
    tip.setLength(size * length(tip.length()));
    if (places) return [tip.add(a.set(...places.map(x => x[sample])))];
    recording.main.stored(body, sample, pose);
    if (turns) tip.applyQuaternion(pose.turn);
    return [tip.add(a.fromArray(point).applyQuaternion(pose.turn)).add(pose.at)];
  });
}

// Arrows of recorded forces, whose components are in the body's axes or the world's, and of
// contacts, each with a ball where it touches.
export function arrows(recording, robot, size) {
  const { given, length: lengthOf } = forces(recording);
  const group = new Group(), thick = .0045 * size, head = .03 * size;
  for (const arrow of given) {
    const material = above(arrow.colour), one = new Group();
    const shaft = new Mesh(new CylinderGeometry(thick, thick, 1, 12).translate(0, .5, 0), material);
    const tip = new Mesh(new ConeGeometry(2.6 * thick, 1, 16).translate(0, -.5, 0), material);
    shaft.renderOrder = tip.renderOrder = 6;
    one.add(shaft, tip);
    if (arrow.places) one.add(new Mesh(new SphereGeometry(1.8 * thick, 16, 12), material));
    one.userData = arrow;
    group.add(one);
  }
  const update = () => {
    for (const one of group.children) {
      const { body, point, places, numbers, turns } = one.userData, [shaft, tip] = one.children;
      const { position, quaternion } = robot.bodies[body] ?? robot.world;
      a.set(...numbers.map(x => recording.main.value(x)));
      const length = size * lengthOf(a.length());
      one.visible = length > 1e-3 * size;
      if (!one.visible) continue;
      if (places) one.position.set(...places.map(x => recording.main.value(x)));
      else one.position.fromArray(point).applyQuaternion(quaternion).add(position);
      a.normalize();
      if (turns) a.applyQuaternion(quaternion);
      one.quaternion.copy(spare.setFromUnitVectors(Y, a));
      const pointed = Math.min(head, .5 * length);
      shaft.scale.set(1, length - pointed, 1);
      tip.scale.set(1, pointed, 1);
      tip.position.y = length;
    }
  };
  return { group, update };
}
