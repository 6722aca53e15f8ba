// The body under the pointer: it glows, and its name, mass and joint stand beside the pointer.  A
// click selects it, or marks the place while one measures; a double click brings the view to it.
// And keys of the picture.
import { Raycaster, Vector2 } from "three";
import { words } from "./tree.js";

const CLICK = 4;  // px that a click moves at most

export function pointing(recording, robot, stage, tree, measure, changed) {
  const tip = document.getElementById("tip"), ray = new Raycaster(), at = new Vector2();
  const canvas = stage.canvas;
  let pressed = [0, 0];
  const hit = (event, others = []) => {
    const box = canvas.getBoundingClientRect();
    at.set(2 * (event.clientX - box.left) / box.width - 1,
           1 - 2 * (event.clientY - box.top) / box.height);
    ray.setFromCamera(at, stage.camera);
    const seen = [...robot.bodies, ...others].filter(x => x.visible);
    return ray.intersectObjects(seen, true).find(x => x.object.isMesh);
  };
  const bodyOf = found => found ? found.object.parent.userData.body : null;
  const show = body => {
    if (body === robot.lit) return;
    robot.lit = body;
    robot.light();
    tip.hidden = body === null;
    if (body !== null) tip.textContent = words(recording, body);
    changed();
  };
  canvas.addEventListener("pointermove", event => {
    if (event.buttons) return;
    const box = canvas.getBoundingClientRect();
    show(bodyOf(hit(event)));
    const left = Math.min(event.clientX - box.left + 14, box.width - tip.offsetWidth - 6);
    tip.style.transform = `translate(${left}px,${event.clientY - box.top + 14}px)`;
  });
  canvas.addEventListener("pointerleave", () => show(null));
  canvas.addEventListener("pointerdown", event => { pressed = [event.clientX, event.clientY]; });
  canvas.addEventListener("click", event => {
    if (Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < CLICK) {
      if (measure.on) measure.mark(hit(event, [robot.world, stage.ground]));
      else tree.choose(bodyOf(hit(event)));
      changed();
    }
  });
  canvas.addEventListener("dblclick", event => {
    const place = hit(event);
    if (place) stage.look(place.point);
    changed();
  });
}

// Turn or zoom the view by a key; returns whether it does.
export function turning(event, stage) {
  const action = {
    ArrowLeft: () => stage.orbit(.1, 0), ArrowRight: () => stage.orbit(-.1, 0),
    ArrowUp: () => stage.orbit(0, .1), ArrowDown: () => stage.orbit(0, -.1),
    "+": () => stage.orbit(0, 0, 1 / 1.2), "=": () => stage.orbit(0, 0, 1 / 1.2),
    "-": () => stage.orbit(0, 0, 1.2) }[event.key];
  if (!action) return false;
  event.preventDefault();
  action();
  return true;
}
