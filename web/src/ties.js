// Ties between points of two bodies: springs as coils, sliding joints as rods.
import {
  CatmullRomCurve3, CylinderGeometry, Group, Mesh, MeshStandardMaterial,
  TubeGeometry, Vector3,
} from "three";

const Y = new Vector3(0, 1, 0), [from, to] = [new Vector3(), new Vector3()];
const TURNS = 9;

// A coil of length 1 along y.
function coil(radius, thick) {
  const points = Array.from({ length: 16 * TURNS + 1 }, (_, i) => {
    const share = i / (16 * TURNS), angle = 2 * Math.PI * TURNS * share;
    const wide = radius * Math.min(1, 12 * share, 12 * (1 - share));
    return new Vector3(wide * Math.cos(angle), share, wide * Math.sin(angle));
  });
  return new TubeGeometry(new CatmullRomCurve3(points), 24 * TURNS, thick, 6);
}


export function ties(recording, robot, size) {
  const group = new Group();
  for (const tie of recording.ties) {
    const colour = tie.spring ? 0x0f97a8 : 0x8a94a3;
    const shape = tie.spring ? coil(.016 * size, .0028 * size)
      : new CylinderGeometry(.004 * size, .004 * size, 1, 12).translate(0, .5, 0);
    const mesh = new Mesh(shape, new MeshStandardMaterial({
      color: colour, roughness: .45, metalness: .3,
    }));
    mesh.castShadow = true;
    mesh.frustumCulled = false;
    mesh.userData = tie;
    group.add(mesh);
  }
  const end = ({ body, point }, result) => {
    result.fromArray(point);
    if (body < 0) return result;
    const { position, quaternion } = robot.bodies[body];
    return result.applyQuaternion(quaternion).add(position);
  };
  const update = () => {
    for (const mesh of group.children) {
      const [first, second] = mesh.userData.ends;
      end(first, from);
      end(second, to).sub(from);
      const length = to.length();
      mesh.visible = length > 1e-6 * size;
      mesh.position.copy(from);
      mesh.quaternion.setFromUnitVectors(Y, to.normalize());
      mesh.scale.set(1, Math.max(length, 1e-9), 1);
    }
  };
  return { group, update };
}
