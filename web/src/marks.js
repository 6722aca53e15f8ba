// Marks on the robot, each switched on and off: joint frames, a trail, masses.  A mark has a
// `group` to draw, and `update` that brings it to the located time.
import {
  BufferAttribute, BufferGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Quaternion,
  SphereGeometry, Vector3,
} from "three";

const X = new Vector3(1, 0, 0), Y = new Vector3(0, 1, 0), Z = new Vector3(0, 0, 1);
const [a, b, c] = [new Vector3(), new Vector3(), new Vector3()];

// A material that nothing hides.
export const above = colour => new MeshBasicMaterial({
  color: colour, depthTest: false, transparent: true, toneMapped: false,
});

// Red, green and blue axes of the world and of the frames of all bodies that joints move, and a
// thin line along the joint's axis.
export function frames(recording, robot, size) {
  const group = new Group(), length = .07 * size;
  for (const joint of [{ child: -1 }, ...recording.joints.filter(x => x.moves)]) {
    const frame = new Group();
    for (const [axis, colour] of [[X, 0xe5484d], [Y, 0x30a46c], [Z, 0x3e63dd]]) {
      const bar = new Mesh(new CylinderGeometry(.035 * length, .035 * length, length, 10)
        .translate(0, length / 2, 0), above(colour));
      bar.quaternion.setFromUnitVectors(Y, axis);
      bar.renderOrder = 5;
      frame.add(bar);
    }
    if (joint.axis) {
      const bar = new Mesh(new CylinderGeometry(.02 * length, .02 * length, 3 * length, 10),
                           above(0xf5b301));
      bar.quaternion.setFromUnitVectors(Y, a.fromArray(joint.axis));
      bar.renderOrder = 4;
      frame.add(bar);
    }
    frame.userData.body = joint.child;
    group.add(frame);
  }
  const update = () => {
    for (const frame of group.children) {
      const { position, quaternion } = robot.bodies[frame.userData.body] ?? robot.world;
      frame.position.copy(position);
      frame.quaternion.copy(quaternion);
    }
  };
  return { group, update };
}

// A ball at each centre of mass, of a volume in proportion to the mass, and one at that of all.
export function masses(recording, robot, size) {
  const group = new Group(), most = Math.max(...recording.bodies.map(x => x.mass));
  recording.bodies.forEach((body, number) => {
    if (!body.mass) return;
    const ball = new Mesh(new SphereGeometry(.035 * size * Math.cbrt(body.mass / most), 20, 14),
                          above(0xf5b301));
    ball.material.opacity = .9;
    ball.renderOrder = 4;
    ball.userData = { number, com: new Vector3().fromArray(body.com) };
    group.add(ball);
  });
  const balls = [...group.children], whole = new Mesh(new SphereGeometry(.022 * size, 20, 14),
                                                      above(0xd6409f));
  whole.renderOrder = 5;
  if (balls.length > 1) group.add(whole);
  const update = () => {
    let sum = 0;
    whole.position.set(0, 0, 0);
    for (const ball of balls) {
      const { position, quaternion } = robot.bodies[ball.userData.number];
      const { mass } = recording.bodies[ball.userData.number];
      ball.position.copy(ball.userData.com).applyQuaternion(quaternion).add(position);
      whole.position.addScaledVector(ball.position, mass);
      sum += mass;
    }
    whole.position.divideScalar(sum || 1);
  };
  return { group, update };
}

// The path of a body's origin, darkest where the body was last.
export function trail(recording, size) {
  const run = recording.main, count = Math.min(run.times.length, 700), sides = 6;
  const samples = Array.from({ length: count },
    (_, i) => Math.round(i * (run.times.length - 1) / Math.max(count - 1, 1)));
  const pose = { at: new Vector3(), turn: new Quaternion() };
  const path = samples.map(sample => {
    run.stored(recording.tracked, sample, pose);
    return pose.at.clone();
  });
  const geometry = tube(path, .0026 * size, sides), group = new Group();
  const colours = new BufferAttribute(new Float32Array(4 * sides * count), 4);
  geometry.setAttribute("color", colours);
  const mesh = new Mesh(geometry, new MeshBasicMaterial({
    vertexColors: true, transparent: true, depthWrite: false, toneMapped: false,
  }));
  mesh.frustumCulled = false;
  mesh.renderOrder = 2;
  group.add(mesh);
  const span = Math.max(.3 * (run.end - run.begin), 1e-9);
  const update = time => {
    samples.forEach((sample, i) => {
      const age = time - run.times[sample];
      const shown = age < 0 ? .13 : .2 + .8 * Math.max(0, 1 - age / span);
      for (let k = 0; k < sides; k++) colours.setXYZW(i * sides + k, .03, .19, .85, shown);
    });
    colours.needsUpdate = true;
  };
  return { group, update };
}

// A tube along a path.
function tube(path, radius, sides) {
  const points = new Float32Array(3 * path.length * sides), faces = [];
  const side = new Vector3(.3, .5, .8), last = path.length - 1;
  path.forEach((at, i) => {
    const along = a.copy(path[Math.min(last, i + 1)]).sub(path[Math.max(0, i - 1)]);
    if (along.lengthSq() < 1e-18) along.copy(Z);
    along.normalize();
    side.addScaledVector(along, -side.dot(along));
    if (side.lengthSq() < 1e-9) side.set(along.y, along.z, along.x);
    side.addScaledVector(along, -side.dot(along)).normalize();
    const other = b.crossVectors(along, side);
    for (let k = 0; k < sides; k++) {
      const angle = 2 * Math.PI * k / sides, corner = i * sides + k;
      c.copy(at).addScaledVector(side, radius * Math.cos(angle))
        .addScaledVector(other, radius * Math.sin(angle)).toArray(points, 3 * corner);
      if (i === 0) continue;
      const next = i * sides + (k + 1) % sides;
      faces.push(corner - sides, next - sides, corner, next - sides, next, corner);
    }
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(points, 3));
  geometry.setIndex(faces);
  return geometry;
}
