// Names of the joints beside them, moved apart so that none hides another.
import { Vector3 } from "three";

const LINE = 17;  // px from one name to the next

export function labels(recording, robot, place, canvas, camera) {
  const point = new Vector3();
  const entries = recording.labels.map(({ name, body, at }) => {
    const text = document.createElement("span");
    text.textContent = name;
    place.append(text);
    return { text, body, at: new Vector3().fromArray(at) };
  });
  const update = () => {
    const width = canvas.clientWidth, height = canvas.clientHeight, taken = [];
    robot.group.updateWorldMatrix(true, true);
    for (const { text, body, at } of entries) {
      point.copy(at).applyMatrix4(robot.bodies[body].matrixWorld).project(camera);
      text.hidden = point.z > 1 || Math.abs(point.x) > 1 || Math.abs(point.y) > 1;
      if (text.hidden) continue;
      const wide = text.offsetWidth;
      const x = Math.min((point.x + 1) * width / 2 + 10, width - wide - 4);
      let y = (1 - point.y) * height / 2 - 8;
      const hides = other => Math.abs(other.y - y) < LINE && x < other.x + other.wide
        && other.x < x + wide;
      for (let round = 0; round < 40 && taken.some(hides); round++) y += LINE;
      taken.push({ x, y, wide });
      text.style.transform = `translate(${x}px,${y}px)`;
    }
  };
  return { update };
}
