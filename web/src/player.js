// The page that plays a run back: puts stage, robot, marks, plots and time together.
import { Group, Quaternion, Vector3 } from "three";
import { arrows } from "./arrows.js";
import { Clock } from "./clock.js";
import { Extent } from "./extent.js";
import { listKeys } from "./keys.js";
import { labels } from "./labels.js";
import { Measure } from "./measure.js";
import { frames, masses, trail } from "./marks.js";
import { film, save } from "./picture.js";
import { Plots } from "./plots.js";
import { pointing, turning } from "./pointer.js";
import { Recording } from "./recording.js";
import { overlaid, Robot, shapesOf } from "./robot.js";
import { SIDES, Stage } from "./stage.js";
import { ties } from "./ties.js";
import { Tools } from "./tools.js";
import { Tree } from "./tree.js";

const $ = id => document.getElementById(id);
const GHOSTS = [0xf2711c, 0x8e4ec6, 0x2a9d5c], TOUCHING = 0xe0a100, INERTIA = 0x0f97a8;
const CONTROLS = ["BUTTON", "INPUT", "SELECT", "SUMMARY", "OUTPUT"];
const ROOM = 8;  // px between the robot and the controls

class Player {
  constructor(data, block) {
    this.recording = new Recording(data, block);
    this.drawn = 0;
    this.dirty = true;
    this.gap = null;
    const touch = () => { this.dirty = true; };
    this.clock = new Clock(this.recording.begin, this.recording.end, this.recording.main.times,
                           touch);
    this.space = new Group();
    const up = new Vector3().fromArray(data.up);
    this.space.quaternion.copy(new Quaternion().setFromUnitVectors(up, new Vector3(0, 0, 1)));
    const shapes = shapesOf(this.recording);
    this.robots = this.recording.runs.map((run, i) =>
      new Robot(this.recording, run, shapes, i ? GHOSTS[(i - 1) % GHOSTS.length] : undefined));
    this.robot = this.robots[0];
    this.extent = new Extent(this.recording, this.robot, this.space.quaternion);
    this.recording.locate(this.clock.time);
    this.tools = new Tools($("tools"), touch);
    try {
      this.open();
    } catch (error) {
      $("space").hidden = $("tools").hidden = true;
      $("without").hidden = false;
      $("without").textContent = "This browser shows no 3D (WebGL), so the bodies are not drawn; "
        + `time and plots work without it. ${error.message}`;
    }
    this.plots = new Plots(this.recording, time => this.clock.seek(time), () => this.clock.time,
                           part => { this.clock.part = part; });
    this.listen();
  }

  // Build the stage, and everything that is drawn on it.
  open() {
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    const land = this.recording.ground;
    if (land?.heights) land.values = this.recording.array(land.heights);
    const stage = new Stage($("space"), this.extent, dark, land && {
      ...land, turn: this.space.quaternion });
    const { recording, robot, tools, space, extent: { size } } = this;
    space.add(robot.group);
    stage.scene.add(space);
    this.always = ties(recording, robot, size);
    space.add(this.always.group);
    tools.add("Follow", "f", this.extent.travels,
              () => ({ show: on => { stage.follows = on; } }), space);
    recording.runs.slice(1).forEach((run, i) => tools.add(
      run.label, String(i + 2), run.shown, () => ({ group: this.robots[i + 1].group }), space));
    if (recording.arrows.length + recording.contacts.length) {
      tools.add("Forces", "o", true, () => arrows(recording, robot, size), space);
    }
    tools.add("Trail", "t", true, () => trail(recording, size), space);
    tools.add("Frames", "j", false, () => frames(recording, robot, size), space);
    for (const [name, key, parts, colour] of [["Collision", "c", recording.collisions, TOUCHING],
                                              ["Inertia", "i", recording.inertias, INERTIA]]) {
      if (parts.length) {
        tools.add(name, key, false, () => overlaid(recording, parts, colour), space);
      }
    }
    tools.add("Masses", "m", false, () => masses(recording, robot, size), space);
    tools.add("Names", "n", false, () => ({
      ...labels(recording, robot, $("labels"), $("space"), stage.camera),
      show: on => { $("labels").hidden = !on; } }), space);
    this.measure = new Measure(robot, stage, $("length"), size);
    tools.add("Measure", "d", false, () => this.measure, space);
    tools.add("See-through", "s", false, () => ({ show: on => robot.fade(on) }), space);
    const touch = () => { this.dirty = true; };
    this.tree = new Tree(recording, this.robots, touch);
    tools.add("Ground", "g", true, () => ({ show: on => stage.stand(on) }), space);
    tools.add("Bodies", "b", false, () => ({ show: on => { $("tree").hidden = !on; } }), space);
    tools.add("Loop", "l", false, () => ({ show: on => { this.clock.loops = on; } }), space);
    if (window.MediaRecorder) {
      this.filming = tools.add("Film", "v", false,
                               () => film(stage.canvas, this.clock, this.name), space);
    }
    tools.menu("View", [
      ["First view", "r", () => this.fit()], ["Along x", "x", () => this.fit(SIDES.x)],
      ["Along y", "y", () => this.fit(SIDES.y)], ["From above", "z", () => this.fit(SIDES.z)],
      ["Parallel lines", "u", () => this.change("parallel", on => stage.parallel(on))],
      ["Wireframe", "w", () => this.change("wire", on => this.robots.forEach(x => x.wire(on)))],
      ...document.fullscreenEnabled ? [["Full screen", "e", () => this.fill()]] : [],
      ["Save picture", "p", () => this.save()], ["Keys", "?", () => listKeys(tools.keyed)]]);
    pointing(recording, robot, stage, this.tree, this.measure, touch);
    const { step } = stage.ground.userData;
    $("scale").textContent = `Lines on the ground are ${Number(step.toPrecision(3))} m apart.`;
    stage.controls.addEventListener("change", touch);
    stage.controls.addEventListener("start", () => { this.fitted = false; });
    this.stage = stage;
  }

  // Show the whole robot between the controls: tools stand above it, or, where it is narrow, below.
  fit(from) {
    const [stage, tools, bar] = ["stage", "tools", "bar"].map(x => $(x).getBoundingClientRect());
    const below = tools.top > stage.top + stage.height / 2;
    this.stage.fit(this.clock.time, (below ? 0 : tools.bottom - stage.top) + ROOM,
                   stage.bottom - (below ? tools.top : bar.top) + ROOM, from);
    Object.assign(this, { from, fitted: true, dirty: true });  // until somebody turns it
  }

  // Switch what the menu switches.
  change(name, apply) {
    this[name] = !this[name];
    apply(this[name]);
    this.dirty = true;
  }

  // Fill the screen with the picture, or the window again.
  fill() {
    if (document.fullscreenElement) document.exitFullscreen();
    else $("stage").requestFullscreen();
  }

  // Save the picture as it is drawn now: the canvas has its content until the browser takes it.
  save() {
    this.update();
    save(this.stage.canvas, `${this.name} ${this.clock.time.toFixed(3)} s`);
  }

  get name() { return document.title.split(":")[0]; }

  listen() {
    document.addEventListener("keydown", event => {
      const { tagName } = event.target, letter = event.key.length === 1 && event.key !== " ";
      const own = CONTROLS.includes(tagName) && !(letter && tagName !== "SELECT");
      if (own || event.target.type === "search" || $("keys").open) return;
      if (this.stage && event.target === $("space") && turning(event, this.stage)) {
        Object.assign(this, { fitted: false, dirty: true });
        return;
      }
      if (event.key === "Escape") this.tree?.choose(null);
      if (this.clock.key(event) || this.tools.key(event)) event.preventDefault();
    });
    const resize = () => {
      this.stage?.resize();
      this.plots.resize();
      if (this.fitted) this.fit(this.from);
      this.dirty = true;
    };
    new ResizeObserver(resize).observe($("stage"));
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", event => {
      this.stage?.restyle(event.matches);
      this.plots.restyle();
      this.dirty = true;
    });
    resize();
    if (this.stage) this.fit();
  }

  // Bring everything to the clock's time.
  update() {
    this.recording.locate(this.clock.time);
    for (const robot of this.robots) robot.pose();
    if (this.stage) {
      this.stage.follow(this.clock.time, this.robot);
      this.tree.update();
      this.always.update();
      this.tools.update(this.clock.time);
      this.stage.render();
      if (this.filming?.on) {
        this.filming.mark.add();
        if (!this.clock.playing) this.tools.toggle(this.filming);  // the end of the run
      }
    }
    this.plots.update();
  }

  // Draw a frame if something has changed.
  frame(now) {
    this.clock.tick(now);
    const changed = this.stage?.adapt(
      this.clock.playing ? (this.gap === null ? 0 : now - this.gap) : null);
    this.gap = this.clock.playing ? now : null;
    const moved = this.stage?.controls.update();
    if (this.dirty || this.clock.playing || changed || moved) {
      this.dirty = false;
      this.update();
      this.drawn++;
      document.documentElement.dataset.ready = "";
    }
    requestAnimationFrame(time => this.frame(time));
  }
}

// Start the page; `data` is its JSON, `block` the bytes of its arrays.
export function start(data, block) {
  const player = new Player(data, block);
  requestAnimationFrame(time => player.frame(time));
  return player;
}
