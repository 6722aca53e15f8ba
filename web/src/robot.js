// The bodies of one run in space: their parts, and their poses.
import { Color, Group, Mesh, MeshStandardMaterial, SRGBColorSpace, Vector3 } from "three";
import { meshesOf, shapeOf } from "./geometry.js";

const DARKEST = .045;  // pure black would swallow all shape
const LIT = 0x0b2a5c, CHOSEN = 0x7a3b00, FADED = .3;

// The parts' geometries, shared by the robot and its ghosts.
export function shapesOf(recording, parts = recording.parts) {
  const meshes = meshesOf(recording);
  return parts.map(part => shapeOf(part, meshes));
}

// A mark: further shapes of the bodies over their own, as those of collisions and of inertia.
export function overlaid(recording, parts, colour) {
  const shapes = shapesOf(recording, parts);
  const robot = new Robot(recording, recording.main, shapes, colour, parts);
  robot.group.traverse(({ material }) => {
    if (material) Object.assign(material, { opacity: .5, polygonOffsetFactor: -2,
                                            polygonOffsetUnits: -8 });
  });
  return { group: robot.group, update: () => robot.pose() };
}

function solid([red, green, blue, opacity]) {
  const bright = red + green + blue > 2.4, lift = x => Math.max(x, DARKEST);
  return new MeshStandardMaterial({
    color: new Color().setRGB(lift(red), lift(green), lift(blue), SRGBColorSpace),
    roughness: bright ? .42 : .55, metalness: bright ? 0 : .12,
    transparent: opacity < 1, opacity, depthWrite: opacity > .5,
  });
}

function ghostly(colour) {
  return new MeshStandardMaterial({
    color: colour, transparent: true, opacity: .32, roughness: .6, depthWrite: false,
    polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 8,  // behind an equal robot
  });
}

// A group for each body and, as the last, for what stands in the world.
export class Robot {
  constructor(recording, run, shapes, ghost, parts = recording.parts) {
    this.run = run;
    this.lit = this.chosen = null;
    this.group = new Group();
    this.coms = recording.bodies.map(x => x.com);
    this.bodies = recording.bodies.map((_, number) => {
      const group = new Group();
      group.userData.body = number;
      return group;
    });
    this.world = new Group();
    this.group.add(...this.bodies, this.world);
    const material = ghost === undefined ? null : ghostly(ghost);
    parts.forEach((part, i) => {
      if (material && part.body < 0) return;
      const mesh = new Mesh(shapes[i], material ?? solid(part.colour));
      mesh.castShadow = mesh.receiveShadow = !material;
      mesh.position.fromArray(part.place);
      mesh.quaternion.fromArray(part.place, 3);
      (part.body < 0 ? this.world : this.bodies[part.body]).add(mesh);
    });
  }

  // Move all bodies to where they are at the located time.
  pose() {
    this.bodies.forEach((group, body) => this.run.pose(body, group.position, group.quaternion));
  }

  // The centre of mass of a body in space.
  centre(body, result) { return this.bodies[body].localToWorld(result.fromArray(this.coms[body])); }

  // Corners of the parts' boxes in the frame of a body (-1: the world); its origin without parts.
  corners(body) {
    const group = body < 0 ? this.world : this.bodies[body], corners = [];
    for (const mesh of group.children) {
      mesh.geometry.computeBoundingBox();
      const { min, max } = mesh.geometry.boundingBox;
      for (let i = 0; i < 8; i++) {
        corners.push(new Vector3(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y,
                                 i & 4 ? max.z : min.z)
          .applyQuaternion(mesh.quaternion).add(mesh.position));
      }
    }
    return corners.length || body < 0 ? corners : [new Vector3()];
  }

  // Light up the selected body, and the one under the pointer.
  light() {
    this.bodies.forEach((group, body) => {
      const glow = body === this.chosen ? CHOSEN : body === this.lit ? LIT : 0;
      for (const mesh of group.children) mesh.material.emissive.setHex(glow);
    });
  }

  // Draw the edges of all triangles alone, or not.
  wire(on) { this.group.traverse(({ material }) => { if (material) material.wireframe = on; }); }

  // Let everything shine through the bodies, or not.
  fade(on) {
    for (const { material } of this.bodies.flatMap(group => group.children)) {
      material.userData.own ??= [material.transparent, material.opacity, material.depthWrite];
      [material.transparent, material.opacity, material.depthWrite] = on
        ? [true, FADED * material.userData.own[1], false] : material.userData.own;
      material.needsUpdate = true;  // shaders of opaque materials are others
    }
  }
}
