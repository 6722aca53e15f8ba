// Shapes: meshes of the page with normals, and primitives.
import {
  BoxGeometry, BufferAttribute, BufferGeometry, CapsuleGeometry, CylinderGeometry, SphereGeometry,
} from "three";

const CREASE = Math.cos(32 * Math.PI / 180);  // faces that meet at less look like one surface

// The geometry of a part: its length along z for cylinders and capsules.
export function shapeOf(part, meshes) {
  const size = part.size;
  switch (part.kind) {
    case "mesh": return meshes(part.mesh);
    case "box": return new BoxGeometry(...size);
    case "sphere": return new SphereGeometry(size[0], 40, 24);
    case "ellipsoid": return new SphereGeometry(1, 40, 24).scale(...size);
    case "cylinder":
      return new CylinderGeometry(size[0], size[0], size[1], 48).rotateX(Math.PI / 2);
    case "capsule": return new CapsuleGeometry(size[0], size[1], 12, 36).rotateX(Math.PI / 2);
    default: throw new Error(`no shape ${part.kind}`);
  }
}

// A function from a mesh's number to its geometry, which is made once.
export function meshesOf(recording) {
  const made = [];
  return number => made[number] ??= meshOf(recording, recording.meshes[number]);
}

// Vertices are differences of 16-bit numbers in the mesh's box, faces differences of indices.
function meshOf(recording, mesh) {
  const small = recording.array(mesh.vertices), steps = recording.array(mesh.faces);
  const count = small.length / 3, points = new Float32Array(3 * count);
  for (let axis = 0; axis < 3; axis++) {
    for (let i = 0, whole = 0; i < count; i++) {
      whole = (whole + small[axis * count + i]) & 0xFFFF;
      points[3 * i + axis] = mesh.low[axis] + mesh.step[axis] * whole;
    }
  }
  const corners = new Uint32Array(steps.length);
  for (let i = 0, index = 0; i < steps.length; i++) corners[i] = index += steps[i];
  return creased(points, corners);
}

// Twice the area times the normal of each face.
function areasOf(points, corners) {
  const areas = new Float32Array(corners.length);
  for (let f = 0; f < corners.length; f += 3) {
    const a = 3 * corners[f], b = 3 * corners[f + 1], c = 3 * corners[f + 2];
    const ux = points[b] - points[a], uy = points[b + 1] - points[a + 1];
    const uz = points[b + 2] - points[a + 2], vx = points[c] - points[a];
    const vy = points[c + 1] - points[a + 1], vz = points[c + 2] - points[a + 2];
    areas[f] = uy * vz - uz * vy;
    areas[f + 1] = uz * vx - ux * vz;
    areas[f + 2] = ux * vy - uy * vx;
  }
  return areas;
}

// The faces around each vertex: those of vertex i are around[first[i]] to around[first[i + 1] - 1].
function neighbours(corners, count) {
  const first = new Uint32Array(count + 1);
  for (const vertex of corners) first[vertex + 1]++;
  for (let i = 0; i < count; i++) first[i + 1] += first[i];
  const next = first.slice(), around = new Uint32Array(corners.length);
  for (let i = 0; i < corners.length; i++) around[next[corners[i]]++] = 3 * Math.floor(i / 3);
  return { first, around };
}

// Each corner's normal is the mean, by area, of the faces around it within the crease of its own.
function creased(points, corners) {
  const areas = areasOf(points, corners);
  const { first, around } = neighbours(corners, points.length / 3);
  const length = f => Math.hypot(areas[f], areas[f + 1], areas[f + 2]) || 1;
  const lengths = new Float32Array(corners.length / 3).map((_, i) => length(3 * i));
  const positions = new Float32Array(3 * corners.length);
  const normals = new Float32Array(positions.length);
  for (let i = 0; i < corners.length; i++) {
    const vertex = corners[i], own = i - i % 3;
    let x = 0, y = 0, z = 0;
    for (let k = first[vertex]; k < first[vertex + 1]; k++) {
      const f = around[k];
      const cosine = (areas[own] * areas[f] + areas[own + 1] * areas[f + 1]
        + areas[own + 2] * areas[f + 2]) / (lengths[own / 3] * lengths[f / 3]);
      if (cosine > CREASE) {
        x += areas[f];
        y += areas[f + 1];
        z += areas[f + 2];
      }
    }
    const norm = Math.hypot(x, y, z) || 1;
    for (let axis = 0; axis < 3; axis++) positions[3 * i + axis] = points[3 * vertex + axis];
    normals.set([x / norm, y / norm, z / norm], 3 * i);
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  return geometry;
}
