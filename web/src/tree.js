// The tree of bodies: names, masses, joints.  A click selects a body, a tick shows it.
import { written } from "./plots.js";

const $ = id => document.getElementById(id);

export class Tree {
  // `robots` are the robot and its ghosts.
  constructor(recording, robots, changed) {
    Object.assign(this, { recording, robots, changed, rows: [] });
    $("bodies").append(this.branch(-1));
    this.choose(null);
  }

  // The bodies that joints connect to a body (-1: the world).
  branch(parent) {
    const list = document.createElement("ul");
    for (const joint of this.recording.joints.filter(x => x.parent === parent)) {
      const row = document.createElement("li");
      row.append(this.tick(joint.child), this.button(joint));
      const below = this.branch(joint.child);
      if (below.children.length) row.append(below);
      list.append(row);
    }
    return list;
  }

  tick(body) {
    const tick = document.createElement("input");
    tick.type = "checkbox";
    tick.checked = true;
    tick.setAttribute("aria-label", `show ${this.recording.bodies[body].name}`);
    tick.addEventListener("change", () => {
      for (const robot of this.robots) robot.bodies[body].visible = tick.checked;
      this.changed();
    });
    return tick;
  }

  button({ child, kind, name }) {
    const button = document.createElement("button"), words = document.createElement("small");
    button.type = "button";
    words.textContent = joined(mass(this.recording.bodies[child]), `${kind} ${name}`);
    button.append(this.recording.bodies[child].name, " ", words);
    button.addEventListener("click", () => this.choose(this.chosen === child ? null : child));
    this.rows[child] = button;
    return button;
  }

  // Select a body, or none.
  choose(body) {
    this.chosen = this.robots[0].chosen = body;
    this.rows.forEach((row, i) => row.setAttribute("aria-pressed", String(i === body)));
    if (body !== null && !$("tree").hidden) this.rows[body].scrollIntoView({ block: "nearest" });
    $("chosen").hidden = body === null;
    this.robots[0].light();
    this.changed();
  }

  // Say what the selected body is, where it is, and what its joint's coordinates and velocities
  // are.
  update() {
    if (this.chosen === null) return;
    const { joints, groups, main } = this.recording;
    const { name } = joints.find(x => x.child === this.chosen);
    const { x, y, z } = this.robots[0].bodies[this.chosen].position;
    const state = ["q", "v"].map(quantity => {
      const own = `${quantity}.${name}`;
      const numbers = groups.flatMap(group => group.signals).filter(x =>
        x.run === 0 && (x.name === own || x.name.startsWith(`${own}.`)));
      const values = numbers.map(signal => written(main.value(signal.numbers)));
      return values.length && `${quantity} ${values.join(", ")}`;
    });
    $("chosen").textContent = [words(this.recording, this.chosen),
                               `at ${[x, y, z].map(written).join(", ")} m`,
                               joined(...state)].join("\n");
  }
}

const joined = (...parts) => parts.filter(x => x).join(" · ");

const mass = body => body.mass ? `${Number(body.mass.toPrecision(4))} kg` : "";

// What a body is, in a line.
export function words(recording, number) {
  const body = recording.bodies[number], joint = recording.joints.find(x => x.child === number);
  return joined(body.name, mass(body), joint?.name);
}
