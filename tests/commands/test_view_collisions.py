"""Collision shapes in the playback page: hidden at first, over the robot at a key."""

from selenium.webdriver.common.by import By

from coscrew_codegen.simulation.view.view_files import view
from tests.support.browser import chromium
from tests.support.playback_data import arm
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


def _switched(shown, point: list[float]) -> list[int]:
    """The colour at a point, before a press of C."""
    (colour,) = shown.execute_script(PIXEL, [point])
    shown.find_element(By.TAG_NAME, "body").send_keys("c")
    return colour
