// Arrays, poses, the space that a robot sweeps, and shapes: node --test test/
import assert from "node:assert/strict";
import { test } from "node:test";
import { Group, Mesh, Quaternion, Vector3 } from "three";
import { Extent } from "../src/extent.js";
import { meshesOf, shapeOf } from "../src/geometry.js";
import { Recording, unpacked } from "../src/recording.js";

// The bytes of numbers in planes, and their places: what the page's writer makes.
function packed(...arrays) {
  const bytes = [], places = [];
  for (const [kind, numbers] of arrays) {
    const raw = new Uint8Array(numbers.buffer), size = numbers.BYTES_PER_ELEMENT;
    places.push([bytes.length, kind, numbers.length]);
    for (let plane = 0; plane < size; plane++) {
      for (let i = 0; i < numbers.length; i++) bytes.push(raw[i * size + plane]);
    }
  }
  return [Uint8Array.from(bytes), places];
}

const turn = angle => [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)];

// Bodies that move along x by their speeds and turn about z, in three samples at 0, 1 and 3 s;
// without others they slide on the world.
function recording(speeds, angle, joints = []) {
  const times = [0, 1, 3], columns = [speeds].flat().flatMap(speed => {
    const rows = times.map(t => [speed * t, 0, 1, ...turn(angle * t)]);
    return [0, 1, 2, 3, 4, 5, 6].flatMap(i => rows.map(row => row[i]));
  });
  const [block, [t, poses, values]] = packed(
    ["f8", Float64Array.from(times)], ["f4", Float32Array.from(columns)],
    ["f4", Float32Array.from([-1, 0, 1])]);
  return new Recording({
    bodies: [speeds].flat().map(name => ({ name })), joints, runs: [{ label: "double", shown: true, t, poses }], arrows: [],
    contacts: [],
    groups: [{ signals: [{ name: "x", run: 0, base: 5, values }] }] }, block);
}

test("arrays are read from their planes, wherever they begin", () => {
  const [block, places] = packed(["i2", Int16Array.from([1, -2, 300])],
                                 ["f8", Float64Array.from([Math.PI, -1e300])]);
  assert.deepEqual([...unpacked(block, places[0])], [1, -2, 300]);
  assert.deepEqual([...unpacked(block, places[1])], [Math.PI, -1e300]);
});

test("poses between samples are on a line and on the shorter arc", () => {
  const { main } = recording(2, .5), at = new Vector3(), quaternion = new Quaternion();
  for (const [time, x, angle] of [[0, 0, 0], [.5, 1, .25], [2, 4, 1], [3, 6, 1.5], [9, 6, 1.5]]) {
    main.locate(time);
    main.pose(0, at, quaternion);
    assert.ok(Math.abs(at.x - x) < 1e-6 && Math.abs(at.z - 1) < 1e-6);
    assert.ok(Math.abs(quaternion.z - Math.sin(angle / 2)) < 1e-6);
  }
});

test("signals are between their samples, about their base", () => {
  const given = recording(0, 0), [signal] = given.groups[0].signals;
  given.locate(.5);
  assert.equal(given.main.value(signal.numbers), 4.5);
  given.locate(2);
  assert.equal(given.main.value(signal.numbers), 5.5);
});

const cube = { corners: body => body < 0 ? [] : [-1, 1].flatMap(x => [-1, 1].flatMap(y =>
  [-1, 1].map(z => new Vector3(x, y, z)))) };

test("what leaves its place travels, and what turns in it does not", () => {
  assert.equal(new Extent(recording(0, 1), cube, still).travels, false);
  const far = new Extent(recording(10, 0), cube, still);
  assert.equal(far.travels, true);
  assert.ok(Math.abs(far.centre(.5, new Vector3()).x - 5) < 1e-6);
  for (const point of far.points) assert.ok(Math.abs(point.x) <= 1 + 1e-6);
});

const still = new Quaternion(), reach = points => Math.max(...points.map(x => x.x));

test("what flies off leaves the robot in the picture, and is there while it is near", () => {
  const gone = new Extent(recording([0, 0, 10], 0, [
    { parent: -1, child: 0 }, { parent: 0, child: 1 }, { parent: -1, child: 2, slides: true },
  ]), cube, still);
  assert.deepEqual([...gone.leaving.bodies], [2]);
  assert.equal(gone.travels, false);
  assert.equal(gone.size, Math.hypot(2, 2, 2));
  assert.ok(reach(gone.points) === 1);  // at 1 s it is 8 m away, and two sizes are 6.9 m
  const near = new Extent(recording([0, 0, 2], 0, [{ parent: -1, child: 0 },
    { parent: 0, child: 1 }]), cube, still);
  assert.deepEqual([...near.leaving.bodies], []);
  assert.ok(reach(near.points) === 7);
});

test("the robot travels on, and what stays behind leaves it", () => {
  const gone = new Extent(recording([0, 10, 10], 0, [{ parent: -1, child: 1, slides: true },
    { parent: 1, child: 2 }]), cube, still);
  assert.deepEqual([...gone.leaving.bodies], [0]);
  assert.equal(gone.travels, true);
  assert.ok(Math.abs(gone.centre(3, new Vector3()).x - 30) < 1e-5);
  assert.ok(reach(gone.points) < 1 + 1e-5);
});

test("up is turned to z", () => {
  const sideways = new Quaternion().setFromUnitVectors(new Vector3(1, 0, 0), new Vector3(0, 0, 1));
  const extent = new Extent(recording(10, 0), cube, sideways);
  assert.ok(extent.high.z - extent.low.z > 30 && extent.high.x - extent.low.x < 4);
});

test("a cube of the page keeps its edges, and its faces look outward", () => {
  const faces = [0, 1, 3, 0, 3, 2, 4, 7, 5, 4, 6, 7, 0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6,
                 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3].reverse();
  const whole = [0, 1, 2, 3, 4, 5, 6, 7].map(i => [i & 1, i >> 1 & 1, i >> 2].map(x => 65535 * x));
  const steps = whole[0].flatMap((_, axis) => whole.map((row, i) =>
    row[axis] - (i ? whole[i - 1][axis] : 0) & 0xFFFF));
  const [block, [vertices, corners]] = packed(["u2", Uint16Array.from(steps)],
    ["i2", Int16Array.from(faces.map((x, i) => x - (i ? faces[i - 1] : 0)))]);
  const recorded = { meshes: [{ low: [-1, -1, -1], step: [2 / 65535, 2 / 65535, 2 / 65535],
                                vertices, faces: corners }], array: x => unpacked(block, x) };
  const geometry = shapeOf({ kind: "mesh", mesh: 0, size: [] }, meshesOf(recorded));
  const normals = geometry.getAttribute("normal").array;
  for (let i = 0; i < normals.length; i += 3) {
    const sizes = [...normals.slice(i, i + 3)].map(Math.abs).sort();
    assert.ok(sizes[0] < 1e-6 && sizes[1] < 1e-6 && Math.abs(sizes[2] - 1) < 1e-6);
  }
  const positions = geometry.getAttribute("position").array;
  for (let i = 0; i < normals.length; i += 3) {  // outward: to the side of the corner
    const out = normals[i] * positions[i] + normals[i + 1] * positions[i + 1]
      + normals[i + 2] * positions[i + 2];
    assert.ok(Math.abs(out - 1) < 1e-6);
  }
});

test("every shape has the sizes of its part", () => {
  const box = part => {
    const mesh = new Mesh(shapeOf(part, null)), group = new Group().add(mesh);
    mesh.geometry.computeBoundingBox();
    group.clear();
    return mesh.geometry.boundingBox.getSize(new Vector3()).toArray();
  };
  const near = (a, b) => a.forEach((x, i) => assert.ok(Math.abs(x - b[i]) < 1e-6, `${a}`));
  near(box({ kind: "box", size: [1, 2, 3] }), [1, 2, 3]);
  near(box({ kind: "sphere", size: [2] }), [4, 4, 4]);
  near(box({ kind: "ellipsoid", size: [1, 2, 3] }), [2, 4, 6]);
  near(box({ kind: "cylinder", size: [1, 5] }), [2, 2, 5]);
  near(box({ kind: "capsule", size: [1, 5] }), [2, 2, 7]);
  assert.throws(() => shapeOf({ kind: "torus", size: [] }, null), /no shape torus/);
});
