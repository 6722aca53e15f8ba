// Ties between points of two bodies: springs as coils, rods, and balls at the points that close
// loops.
import {
  CatmullRomCurve3, CylinderGeometry, Group, Mesh, MeshStandardMaterial, SphereGeometry,
  TubeGeometry, Vector3,
} from "three";

const Y = new Vector3(0, 1, 0), [from, to] = [new Vector3(), new Vector3()];
const TURNS = 9, COLOURS = { spring: 0x0f97a8, rod: 0x8a94a3, closure: 0x8e4ec6 };

// A coil of length 1 along y.
function coil(radius, thick) {
  const points = Array.from({ length: 16 * TURNS + 1 }, (_, i) => {
    const share = i / (16 * TURNS), angle = 2 * Math.PI * TURNS * share;
    const wide = radius * Math.min(1, 12 * share, 12 * (1 - share));
    return new Vector3(wide * Math.cos(angle), share, wide * Math.sin(angle));
  });
  return new TubeGeometry(new CatmullRomCurve3(points), 24 * TURNS, thick, 6);
}

const rod = size => new CylinderGeometry(.004 * size, .004 * size, 1, 12).translate(0, .5, 0);

// What a tie consists of: balls that stay at its ends, and what is as long as it.
function pieces({ kind }, size) {
  if (kind === "spring") return [coil(.016 * size, .0028 * size)];
  const balls = [0, 1].map(() => new SphereGeometry((kind === "rod" ? .006 : .015) * size, 24, 16));
  return [rod(size), ...balls];
}

export function ties(recording, robot, size) {
  const group = new Group();
  for (const tie of recording.ties) {
    const material = new MeshStandardMaterial({
      color: COLOURS[tie.kind], roughness: .45, metalness: .3,
    });
    const one = new Group();
    for (const shape of pieces(tie, size)) {
      const mesh = new Mesh(shape, material);
      mesh.castShadow = true;
      mesh.frustumCulled = false;
      one.add(mesh);
    }
    one.userData = tie;
    group.add(one);
  }
  const end = ({ body, point }, result) => {
    result.fromArray(point);
    if (body < 0) return result;
    const { position, quaternion } = robot.bodies[body];
    return result.applyQuaternion(quaternion).add(position);
  };
  const update = () => {
    for (const one of group.children) {
      const [mesh, ...balls] = one.children;
      one.userData.ends.forEach((place, i) => {
        end(place, to);
        if (i === 0) from.copy(to);
        balls[i]?.position.copy(to);
      });
      to.sub(from);
      const length = to.length();
      mesh.visible = length > 1e-6 * size;
      mesh.position.copy(from);
      mesh.quaternion.setFromUnitVectors(Y, to.normalize());
      mesh.scale.set(1, Math.max(length, 1e-9), 1);
    }
  };
  return { group, update };
}
