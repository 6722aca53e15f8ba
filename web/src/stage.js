// The stage: renderer, lights, sky, and the camera, which frames the robot and follows it.
import {
  ACESFilmicToneMapping, DirectionalLight, HemisphereLight, PCFShadowMap, PerspectiveCamera,
  PMREMGenerator, Scene, Spherical, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import { ground } from "./ground.js";

export const SIDES = {  // directions from the robot to the camera
  first: new Vector3(.82, -1, .42).normalize(), x: new Vector3(1, 0, 0),
  y: new Vector3(0, -1, 0), z: new Vector3(0, -.01, 1).normalize(),
};
const LIGHT = new Vector3(1.1, -.7, 2.2);
const LOWEST = .52 * Math.PI;  // polar angle of the camera above the ground
const LENS = 30, PARALLEL = 1;  // degrees of the picture's height
const FINEST = 2, COARSEST = .5;  // pixels of the picture for one of the screen
const SLOW = 90;  // ms for a frame, from which the picture becomes coarser

export class Stage {
  // `land` is the scene's ground.  Throws if the browser has no WebGL.
  constructor(canvas, extent, dark, land) {
    this.canvas = canvas;
    this.extent = extent;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(LENS, 1, extent.size / 50, extent.size * 60);
    this.camera.up.set(0, 0, 1);
    this.follows = extent.travels;
    this.leader = null;  // the body that the camera follows; null: the robot
    this.now = new Vector3();
    this.ratio = this.finest;
    this.frameTime = this.slowFrames = 0;
    this.land = land;
    this.light();
    this.restyle(dark);
    this.control();
  }

  get finest() { return Math.min(devicePixelRatio || 1, FINEST); }

  light() {
    const { renderer, scene, extent: { size } } = this;
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = PCFShadowMap;
    renderer.toneMapping = ACESFilmicToneMapping;
    renderer.setClearColor(0, 0);
    scene.environment = new PMREMGenerator(renderer).fromScene(new RoomEnvironment()).texture;
    this.sky = new HemisphereLight(0xffffff, 0x9aa4b2);
    scene.add(this.sky);
    const key = this.key = new DirectionalLight(0xfff4e6, 2.55), shadow = key.shadow;
    key.castShadow = true;
    shadow.mapSize.set(2048, 2048);
    shadow.radius = 5;
    shadow.bias = -.0004;
    shadow.normalBias = .002 * size;
    const half = .85 * size;
    Object.assign(shadow.camera, { left: -half, right: half, bottom: -half, top: half,
                                   near: .1 * size, far: 8 * size });
    const rim = new DirectionalLight(0xdfe9ff, .7);
    rim.position.set(-2, 3, 1.6);
    scene.add(key, key.target, rim);
  }

  // Light and ground of a dark page, or of a light one.
  restyle(dark) {
    this.scene.environmentIntensity = dark ? .42 : .46;
    this.sky.intensity = dark ? .25 : .3;
    const visible = this.ground?.visible ?? true;
    if (this.ground) this.scene.remove(this.ground);
    this.ground = Object.assign(ground(this.extent, dark, this.land), { visible });
    this.scene.add(this.ground);
  }

  control() {
    const controls = this.controls = new OrbitControls(this.camera, this.canvas);
    controls.enableDamping = !matchMedia("(prefers-reduced-motion: reduce)").matches;
    controls.dampingFactor = .12;
    controls.minDistance = .15 * this.extent.size;
    controls.maxPolarAngle = LOWEST;
    // Without focus the wheel scrolls the page.
    this.canvas.addEventListener("wheel", event => {
      controls.enableZoom = document.activeElement === this.canvas || event.ctrlKey;
    }, { capture: true, passive: true });
    this.canvas.addEventListener("pointerdown", () => {
      controls.enableZoom = true;
      this.canvas.focus({ preventScroll: true });
    }, { capture: true });
  }

  // Draw the ground, or leave it out and let the camera go below.
  stand(on) {
    this.ground.visible = on;
    this.controls.maxPolarAngle = on ? LOWEST : Math.PI;
  }

  // The distance from which this lens shows as much as the first one does from 1.
  get away() { return Math.tan(LENS * Math.PI / 360) / Math.tan(this.camera.fov * Math.PI / 360); }

  // Look from so far away that parallel lines hardly meet in the picture, or as before.
  parallel(on) {
    const { camera, controls } = this, before = this.away;
    camera.fov = on ? PARALLEL : LENS;
    camera.updateProjectionMatrix();
    const further = this.away / before;
    controls.minDistance *= further;
    controls.maxDistance *= further;
    camera.position.sub(controls.target).multiplyScalar(further).add(controls.target);
    controls.update();
  }

  // Turn the camera about its target, or change its distance.
  orbit(azimuth, elevation, factor = 1) {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const flat = new Spherical().setFromVector3(new Vector3(offset.x, offset.z, -offset.y));
    flat.theta += azimuth;
    flat.phi = Math.min(Math.max(flat.phi - elevation, .02),
                        Math.min(this.controls.maxPolarAngle, Math.PI - .02));
    flat.radius = Math.min(Math.max(flat.radius * factor, this.controls.minDistance),
                           this.controls.maxDistance);
    const { x, y, z } = new Vector3().setFromSpherical(flat);
    this.camera.position.set(x, -z, y).add(this.controls.target);
    this.controls.update();
  }

  // Move the camera until all points fill the part of the picture that no control covers:
  // `above` and `below` are the heights of the controls, in pixels; `from` is one of SIDES.
  fit(time, above, below, from = SIDES.first) {
    const { camera, controls, extent, canvas } = this, p = new Vector3();
    const height = canvas.clientHeight || 1;
    const top = 1 - 2 * above / height, bottom = 1 - 2 * below / height;
    const target = extent.travels ? new Vector3()
      : extent.low.clone().add(extent.high).multiplyScalar(.5);
    let distance = 2 * extent.size * this.away;
    for (let round = 0; round < 16; round++) {
      camera.position.copy(target).addScaledVector(from, distance);
      camera.lookAt(target);
      camera.updateMatrixWorld();
      let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
      for (const point of extent.points) {
        p.copy(point).project(camera);
        left = Math.min(left, p.x);
        right = Math.max(right, p.x);
        low = Math.min(low, p.y);
        high = Math.max(high, p.y);
      }
      const fills = Math.max((right - left) / 1.8, (high - low) / (.94 * (top + bottom)), .02);
      distance *= 1 + .8 * (Math.min(fills, 5) - 1);
      const half = Math.tan(camera.fov * Math.PI / 360) * distance;
      p.set((left + right) / 2 * half * camera.aspect,
            ((high + low) / 2 - (top - bottom) / 2) * half, 0).applyQuaternion(camera.quaternion);
      target.addScaledVector(p, .7);
    }
    const at = extent.travels ? extent.centre(time, new Vector3()) : new Vector3();
    this.now.copy(at);
    camera.position.copy(target).addScaledVector(from, distance).add(at);
    controls.target.copy(target).add(at);
    controls.maxDistance = Math.max(12 * extent.size * this.away, 1.5 * distance);
    controls.update();
  }

  // Turn about another place.
  look(place) {
    this.camera.position.add(place).sub(this.controls.target);
    this.controls.target.copy(place);
    this.controls.update();
  }

  // Bring camera, light and shadow to where the robot, or its selected body, is at a time.
  follow(time, robot) {
    const before = this.now.clone(), { chosen } = robot, same = this.leader === chosen;
    const centre = chosen === null ? this.extent.centre(time, this.now)
      : robot.centre(chosen, this.now);
    this.leader = chosen;
    if (this.follows && same && (chosen !== null || this.extent.travels)) {
      const moved = centre.clone().sub(before);
      this.controls.target.add(moved);
      this.camera.position.add(moved);
    }
    this.extent.place(time, this.key.target.position);
    this.key.position.copy(this.key.target.position).addScaledVector(LIGHT, 1.2 * this.extent.size);
  }

  // Fill the canvas, in finer or coarser pixels.
  resize() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
  }

  // Slow machines play coarser, and rest sharp; returns whether the picture has changed.
  adapt(milliseconds) {
    if (milliseconds === null) {
      const changed = this.ratio !== this.finest;
      this.ratio = this.finest;
      this.frameTime = this.slowFrames = 0;
      if (changed) this.resize();
      return changed;
    }
    this.frameTime = .8 * this.frameTime + .2 * milliseconds;
    if (this.frameTime < SLOW || this.ratio <= COARSEST || ++this.slowFrames < 6) return false;
    this.ratio = Math.max(.75 * this.ratio, COARSEST);
    this.slowFrames = 0;
    this.resize();
    return true;
  }

  render() {
    const { camera, controls, extent: { size } } = this;
    const distance = camera.position.distanceTo(controls.target), near = distance - 30 * size;
    [camera.near, camera.far] = [Math.max(near, size / 50), distance + 60 * size];
    camera.updateProjectionMatrix();
    this.renderer.render(this.scene, camera);
  }
}
