// The ground: a grid and a plate that fade out, and the shadow on them; or heights.
import {
  BufferAttribute, BufferGeometry, CanvasTexture, CircleGeometry, Color, DoubleSide, Group,
  LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshStandardMaterial, PlaneGeometry,
  ShadowMaterial, SRGBColorSpace, Vector3,
} from "three";

const PIECES = 16;  // of a line, so that it fades along its length
const LINE = 4;  // points of heights from one line to the next

// `land` is the ground of the scene: a plane, or heights; without it, below the robot.
export function ground(extent, dark, land) {
  return land?.values ? heights(land, dark) : plane(extent, dark, land);
}

function plane(extent, dark, land) {
  const { size } = extent, reach = Math.max(2.4 * size, 1.3 * extent.swept);
  const decade = 10 ** Math.floor(Math.log10(.6 * size)), group = new Group();
  const step = decade * [1, 2, 5].find(k => reach / (k * decade) < 30 || k === 5);
  const middle = extent.low.clone().add(extent.high).multiplyScalar(extent.travels ? .5 : 0);
  group.position.set(Math.round(middle.x / step) * step, Math.round(middle.y / step) * step,
                     extent.floor);
  if (land) {
    const normal = new Vector3().fromArray(land.normal).applyQuaternion(land.turn);
    group.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), normal);
    group.position.addScaledVector(normal, land.offset - normal.dot(group.position));
  }
  const shade = new Mesh(new CircleGeometry(reach, 64),
                         new ShadowMaterial({ opacity: dark ? .5 : .28 }));
  shade.receiveShadow = true;
  const lines = grid(reach, step, dark), below = plate(reach, dark);
  lines.position.z = .0006 * size;
  below.position.z = -.0006 * size;
  group.add(below, shade, lines);
  group.userData.step = step;
  return group;
}

function grid(reach, step, dark) {
  const count = Math.ceil(reach / step), points = [], colours = [];
  const { r, g, b } = new Color(dark ? 0x8fa0b5 : 0x64748b);
  const vertex = (x, y, strong) => {
    const faded = Math.max(0, 1 - Math.hypot(x, y) / reach) ** 1.5;
    points.push(x, y, 0);
    colours.push(r, g, b, (strong ? .5 : .2) * faded);
  };
  for (let i = -count; i <= count; i++) {
    for (let k = 0; k < PIECES; k++) {
      const ends = [k, k + 1].map(x => (2 * x / PIECES - 1) * count * step);
      for (const end of ends) vertex(end, i * step, i % 5 === 0);
      for (const end of ends) vertex(i * step, end, i % 5 === 0);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(colours), 4));
  const lines = new LineSegments(geometry, new LineBasicMaterial({
    vertexColors: true, transparent: true, depthWrite: false,
  }));
  lines.renderOrder = -1;
  return lines;
}

function plate(reach, dark) {
  const canvas = document.createElement("canvas"), edge = 256, half = edge / 2;
  canvas.width = canvas.height = edge;
  const context = canvas.getContext("2d");
  const fade = context.createRadialGradient(half, half, 0, half, half, half);
  const [near, far] = dark ? ["60,72,90", "40,48,60"] : ["255,255,255", "255,255,255"];
  fade.addColorStop(0, `rgba(${near},${dark ? .85 : .95})`);
  fade.addColorStop(.55, `rgba(${far},${dark ? .4 : .45})`);
  fade.addColorStop(1, `rgba(${far},0)`);
  context.fillStyle = fade;
  context.fillRect(0, 0, edge, edge);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  const disc = new Mesh(new CircleGeometry(reach, 64), new MeshBasicMaterial({
    map: texture, transparent: true, depthWrite: false, toneMapped: false,
  }));
  disc.renderOrder = -2;
  return disc;
}

// A surface through the heights over a square, with every fourth line of its points.
function heights({ middle, half, points, values, turn }, dark) {
  const shape = new PlaneGeometry(2 * half, 2 * half, points - 1, points - 1);
  const at = shape.attributes.position, lines = [];
  const place = (i, k) => [middle[0] + half * (2 * k / (points - 1) - 1),
                           middle[1] + half * (2 * i / (points - 1) - 1), values[i * points + k]];
  for (let i = 0; i < points; i++) {
    for (let k = 0; k < points; k++) {
      at.setXYZ((points - 1 - i) * points + k, ...place(i, k));  // the plane's rows begin at +y
      if (k + 1 === points) continue;
      if (i % LINE === 0) lines.push(...place(i, k), ...place(i, k + 1));
      if (i % LINE === 0) lines.push(...place(k, i), ...place(k + 1, i));
    }
  }
  shape.computeVertexNormals();
  const surface = new Mesh(shape, new MeshStandardMaterial({
    color: dark ? 0x3a4557 : 0xe4e9f0, roughness: 1, side: DoubleSide,
    polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 4,
  }));
  surface.receiveShadow = true;
  const drawn = new LineSegments(
    new BufferGeometry().setAttribute("position", new BufferAttribute(new Float32Array(lines), 3)),
    new LineBasicMaterial({ color: dark ? 0x8fa0b5 : 0x64748b, transparent: true, opacity: .35 }));
  const group = new Group();
  group.add(surface, drawn);
  group.userData.step = LINE * 2 * half / (points - 1);
  group.quaternion.copy(turn);
  return group;
}
