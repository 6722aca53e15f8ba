"""Marks of the playback page: collision shapes, hidden at first, over the robot at a key; arrows of
forces inside the picture."""

from selenium.webdriver.common.by import By

from coscrew_codegen.simulation.view.view_files import view
from tests.support.browser import chromium
from tests.support.playback_data import ARM, arm
from tests.support.playback_page import PIXEL, opened, pose

BALL = ('<collision><origin xyz="0 0 -1"/><geometry><sphere radius="0.5"/></geometry></collision>')


def test_collision_shapes_appear_over_the_robot_and_move_with_it(tmp_path):
    view(arm(tmp_path, BALL, precision="double", until=1.0), [tmp_path / "arm.html"])
    view(arm(tmp_path, precision="double", until=1.0), [tmp_path / "bare.html"])
    with chromium() as browser:
        shown = opened(browser, tmp_path, "arm")
        body = shown.execute_script(
            "return player.recording.bodies.findIndex(x => x.name === 'arm');")
        for t in (0.0, 0.8):
            _, y, _, w = map(float, pose(shown, body, t)[3:])
            sine, cosine = 2 * y * w, 1 - 2 * y * y
            point = [-1.2 * sine - 0.3 * cosine, 0, -1.2 * cosine + 0.3 * sine]  # in the ball
            off, on = _switched(shown, point), _switched(shown, point)
            assert on[0] > on[2] + 40 and on != off  # amber
        assert shown.get_log("browser") == []
        names = [x.text for x in opened(browser, tmp_path, "bare").find_elements(
            By.CSS_SELECTOR, "#tools button")]
        assert "Collision" not in names and "Masses" in names


TIPS = """
    const { camera, canvas } = player.stage, box = canvas.getBoundingClientRect();
    const covers = ["tools", "bar"].map(x => document.getElementById(x).getBoundingClientRect());
    const forces = player.tools.tools.find(x => x.name === "Forces").mark.group;
    const points = arguments[0].flatMap(time => {
      player.clock.seek(time);
      player.update();
      player.space.updateWorldMatrix(true, true);
      return forces.children.filter(x => x.visible).map(x => {
        const tip = x.children[1], p = tip.getWorldPosition(tip.position.clone()).project(camera);
        return [(p.x + 1) / 2 * box.width, (1 - p.y) / 2 * box.height];
      });
    });
    return [points, covers[0].bottom - box.top, covers[1].top - box.top, box.width];"""


def test_arrows_of_forces_are_framed(tmp_path):
    """An arm that hangs: the reaction points up, above everything else."""
    text = ARM.replace("force = [3, 0, 0]", "force = [0, 0, 0.1]")
    view(arm(tmp_path, text=text, precision="double", until=1.0), [tmp_path / "arm.html"])
    with chromium() as browser:
        shown = opened(browser, tmp_path, "arm", 1000, 800)
        points, top, bottom, width = shown.execute_script(TIPS, [0, 0.5, 1])
    assert len(points) == 6
    assert all(0 <= x <= width and top <= y <= bottom for x, y in points), (points, top, bottom)
    assert min(y for _, y in points) < (top + bottom) / 2


def _switched(shown, point: list[float]) -> list[int]:
    """The colour at a point, before a press of C."""
    (colour,) = shown.execute_script(PIXEL, [point])
    shown.find_element(By.TAG_NAME, "body").send_keys("c")
    return colour
