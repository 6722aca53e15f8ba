// The body under the pointer: it glows, and its name, mass and joint stand beside the pointer.
import { Raycaster, Vector2 } from "three";

export function pointing(recording, robot, stage, changed) {
  const tip = document.getElementById("tip"), ray = new Raycaster(), at = new Vector2();
  const canvas = stage.canvas;
  let lit = null;
  const show = body => {
    if (body === lit) return;
    lit = body;
    robot.glow(body);
    tip.hidden = body === null;
    if (body !== null) tip.textContent = words(recording, body);
    changed();
  };
  canvas.addEventListener("pointermove", event => {
    if (event.buttons) return;
    const box = canvas.getBoundingClientRect();
    const x = event.clientX - box.left, y = event.clientY - box.top;
    at.set(2 * x / box.width - 1, 1 - 2 * y / box.height);
    ray.setFromCamera(at, stage.camera);
    const [hit] = ray.intersectObjects(robot.bodies, true);
    show(hit ? hit.object.parent.userData.body : null);
    const left = Math.min(x + 14, box.width - tip.offsetWidth - 6);
    tip.style.transform = `translate(${left}px,${y + 14}px)`;
  });
  canvas.addEventListener("pointerleave", () => show(null));
}

function words(recording, body) {
  const { name, mass } = recording.bodies[body];
  const joint = recording.joints.find(x => x.child === body);
  const parts = [name];
  if (mass) parts.push(`${Number(mass.toPrecision(4))} kg`);
  if (joint) parts.push(joint.name);
  return parts.join(" · ");
}
