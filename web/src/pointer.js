// The body under the pointer: it glows, and its name, mass and joint stand beside the pointer.  A
// click selects it, a double click brings the view to the place.  And keys of the picture.
import { Raycaster, Vector2 } from "three";
import { words } from "./tree.js";

const CLICK = 4;  // px that a click moves at most

export function pointing(recording, robot, stage, tree, changed) {
  const tip = document.getElementById("tip"), ray = new Raycaster(), at = new Vector2();
  const canvas = stage.canvas;
  let pressed = [0, 0];
  const hit = event => {
    const box = canvas.getBoundingClientRect();
    at.set(2 * (event.clientX - box.left) / box.width - 1,
           1 - 2 * (event.clientY - box.top) / box.height);
    ray.setFromCamera(at, stage.camera);
    return ray.intersectObjects(robot.bodies.filter(x => x.visible), true)[0];
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
      tree.choose(bodyOf(hit(event)));
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
