// The distance between two places that clicks mark, on bodies or on the ground: it moves with them.
import { CylinderGeometry, Group, Mesh, SphereGeometry, Vector3 } from "three";
import { above } from "./marks.js";
import { written } from "./plots.js";

const Y = new Vector3(0, 1, 0), COLOUR = 0xd6409f, [from, to] = [new Vector3(), new Vector3()];

// A mark: balls at the places, a line between them, and its length in `label`.
export class Measure {
  constructor(robot, stage, label, size) {
    Object.assign(this, { robot, stage, label, on: false, places: [], group: new Group() });
    const material = above(COLOUR), radius = .009 * size;
    this.line = new Mesh(new CylinderGeometry(.25 * radius, .25 * radius, 1, 8), material);
    this.balls = [0, 1].map(() => new Mesh(new SphereGeometry(radius, 20, 14), material));
    this.group.add(this.line, ...this.balls);
    this.group.traverse(x => { x.renderOrder = 7; });
    this.update();
  }

  show(on) {
    this.on = on;
    this.places = [];
    this.update();
  }

  // Mark the place that a click hits: after the second one a third begins anew.
  mark(hit) {
    if (!hit) return;
    if (this.places.length === 2) this.places = [];
    const { robot } = this, parent = hit.object.parent;
    const holder = robot.bodies.includes(parent) ? parent : robot.world;
    this.places.push({ holder, at: holder.worldToLocal(hit.point.clone()) });
    this.update();
  }

  update() {
    const { places, balls, line, label } = this;
    balls.forEach((ball, i) => {
      ball.visible = i < places.length;
      if (ball.visible) {
        const { holder, at } = places[i];
        ball.position.copy(at).applyQuaternion(holder.quaternion).add(holder.position);
      }
    });
    line.visible = places.length === 2;
    label.hidden = !line.visible;
    if (!line.visible) return;
    from.copy(balls[0].position);
    to.copy(balls[1].position).sub(from);
    const length = to.length(), along = to.toArray().map(written).join(", ");
    label.textContent = `${written(length)} m: ${along}`;
    line.position.copy(from).addScaledVector(to, .5);
    line.scale.set(1, Math.max(length, 1e-9), 1);
    line.quaternion.setFromUnitVectors(Y, to.normalize());
  }
}
