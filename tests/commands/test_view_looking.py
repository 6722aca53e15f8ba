"""Ways to look at a run in the playback page: the robot where a part flies off, parallel lines,
wireframe, distances, the search of signals, the repetition of a part."""

import numpy as np
import pytest
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select

import coscrew_codegen
from tests.support.browser import chromium
from tests.support.playback_page import camera, clock, opened

UPPER, LOWER = 0.6, 0.4  # m
SPEED, DURATION = 20.0, 2.0  # of the ball, m/s and s
SCENE = f"""
[bodies.upper]
mass = 2
com = [0, 0, {UPPER / 2}]
inertia = [0.06, 0.06, 0.001]
[bodies.lower]
mass = 1
com = [0, 0, {LOWER / 2}]
inertia = [0.014, 0.014, 0.001]
[bodies.ball]
mass = 0.1
inertia = [1e-4, 1e-4, 1e-4]
[joints.shoulder]
type = "revolute"
child = "upper"
axis = [0, 1, 0]
[joints.elbow]
type = "revolute"
parent = "upper"
child = "lower"
axis = [0, 1, 0]
origin = {{ xyz = [0, 0, {UPPER}] }}
[joints.flight]
type = "free"
child = "ball"
[effects.viscous]
joints = ["shoulder", "elbow"]
d = 0.1
[start.q]
flight = [0, 0, {UPPER + LOWER + 0.1}, 0, 0, 0, 1]
[start.v]
flight = [{SPEED}, 0, 0, 0, 0, 0]
[outputs]
record = ["q", "v", "position.ball"]
[run]
duration = {DURATION}
step = 1e-2
integrator = "rk4"
"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    folder = tmp_path_factory.mktemp("looking")
    (folder / "throw.toml").write_text(SCENE, encoding="utf-8")
    coscrew_codegen.run(folder / "throw.toml").view(folder / "throw.html")
    with chromium() as driver:
        yield opened(driver, folder, "throw", 900, 700)


@pytest.fixture
def shown(browser):
    """The page at its start, as it is first seen."""
    yield browser
    assert browser.get_log("browser") == []
    browser.execute_script("""
        for (const tool of player.tools.tools) if (tool.on !== (tool.name in arguments[0])) {
          player.tools.toggle(tool);
        }
        for (const name of ["parallel", "wire"]) if (player[name]) {
          player.tools.keys.get({ parallel: "u", wire: "w" }[name]).act();
        }
        player.tree.choose(null);
        player.clock.play(false);
        player.clock.seek(0);
        player.fit();
        player.update();""", {"Trail": 1, "Ground": 1})


def press(shown, key: str) -> None:
    shown.find_element(By.TAG_NAME, "body").send_keys(key)


PLACES = """
    const { camera, canvas } = player.stage, p = camera.position.clone();
    player.clock.seek(arguments[1]);
    player.update();
    player.space.updateWorldMatrix(true, true);
    return arguments[0].map(name => {
      const body = player.recording.bodies.findIndex(x => x.name === name);
      return player.robot.corners(body).map(point => {
        p.copy(point).applyMatrix4(player.robot.bodies[body].matrixWorld).project(camera);
        return [p.x, p.y];
      });
    });"""
"""Corners of bodies at a time in the picture, from -1 to 1 in width and height."""


def places(shown, time: float, *bodies: str) -> np.ndarray:
    """The corners of all these bodies, one after the other; a body's box comes first.  (n, 2)."""
    return np.concatenate([*map(np.array, shown.execute_script(PLACES, bodies, time))])


def test_a_part_that_flies_off_leaves_the_robot_as_large_as_it_was(shown):
    """The ball is 40 m away at the end; the arm has a third of the picture's height from the start
    to the end, and the ball is in the picture at the start."""
    for time in (0, DURATION / 2, DURATION):
        corners = places(shown, time, "upper", "lower")
        assert np.ptp(corners[:, 1]) > 2 / 3
        assert np.abs(corners).max() < 1
    assert np.abs(places(shown, 0, "ball")).max() < 1
    assert np.abs(places(shown, DURATION, "ball")).max() > 1


def test_the_camera_goes_after_a_part_that_flies_off_if_it_is_selected(shown):
    press(shown, "f")
    shown.execute_script("""
        player.tree.choose(player.recording.bodies.findIndex(x => x.name === "ball"));
        player.update();""")
    before = places(shown, 0, "ball")
    after = places(shown, DURATION, "ball")
    assert np.abs(before - after).max() < 1e-3


def test_parallel_lines_are_parallel_and_the_robot_stays_as_large(shown):
    """Corners of a box that differ along one axis, seen aslant: the ratio of the nearer and the
    farther edge is 1 to 0.2 %, and in perspective it is not."""
    def edges():
        corners = places(shown, 0, "upper")[:8]
        return np.linalg.norm(corners[[4, 5, 6, 7]] - corners[[0, 1, 2, 3]], axis=1)

    near, height = edges(), np.ptp(places(shown, 0, "upper", "lower")[:, 1])
    press(shown, "u")
    far = edges()
    assert near.max() / near.min() > 1.01 and far.max() / far.min() < 1.002
    assert np.ptp(places(shown, 0, "upper", "lower")[:, 1]) == pytest.approx(height, rel=0.06)
    press(shown, "r")
    assert np.abs(places(shown, 0, "upper", "lower")).max() < 1
    Select(shown.find_element(By.ID, "view")).select_by_value("u")
    assert edges() == pytest.approx(near, rel=0.1)


def test_keys_zoom_between_the_same_limits_where_lines_are_parallel(shown):
    press(shown, "u")
    far = camera(shown)[2]
    shown.find_element(By.ID, "space").send_keys("-")
    assert camera(shown)[2] == pytest.approx(1.2 * far)
    assert shown.execute_script("""
        player.update();
        return player.stage.camera.far / player.stage.camera.near;""") < 20


def test_wireframe_draws_edges_alone(shown):
    """Three quarters of the robot's pixels at most: it is thin."""
    covered = """
        const { stage, space } = player, gl = stage.renderer.getContext();
        const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
        const pictures = [true, false].map(visible => {
          player.robot.group.visible = visible;
          stage.render();
          const bytes = new Uint8Array(4 * width * height);
          gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
          return bytes;
        });
        player.robot.group.visible = true;
        return pictures[0].reduce((sum, x, i) => sum + (Math.abs(x - pictures[1][i]) > 16), 0);"""
    solid = shown.execute_script(covered)
    press(shown, "w")
    assert 0 < shown.execute_script(covered) < 0.75 * solid


def test_a_distance_is_that_of_the_places_and_moves_with_them(shown):
    """From the middle of the upper link to that of the lower one, as their shapes are met: with
    both at q = 0, then in the length's text at another time by the poses alone."""
    press(shown, "d")
    for name in ("upper", "lower"):
        x, y = places(shown, 0, name)[:8].mean(0)
        canvas = shown.find_element(By.ID, "space")
        ActionChains(shown).move_to_element_with_offset(
            canvas, round(x * canvas.rect["width"] / 2),
            round(-y * canvas.rect["height"] / 2)).click().perform()
    words = shown.find_element(By.ID, "length")
    assert words.is_displayed() and shown.execute_script("return player.tree.chosen;") is None
    held = shown.execute_script("""
        return player.measure.places.map(({ holder, at }) =>
          [player.robot.bodies.indexOf(holder), ...at.toArray()]);""")
    assert [x[0] for x in held] == [0, 1]
    for time in (0, 1):
        shown.execute_script("player.clock.seek(arguments[0]); player.update();", time)
        (_, *a), (_, *b) = held  # the arm stands still: each at its joint's height
        wanted = np.array(b) + [0, 0, UPPER] - a
        length, along = words.text.split(" m: ")
        assert float(length) == pytest.approx(np.linalg.norm(wanted), rel=1e-3)
        assert [*map(float, along.split(", "))] == pytest.approx(wanted, abs=1e-3)
    press(shown, "d")
    assert not words.is_displayed()


def test_the_page_says_how_far_the_ground_s_lines_are_apart(shown):
    words = shown.find_element(By.ID, "scale").text
    step = shown.execute_script("return player.stage.ground.userData.step;")
    assert words == f"Lines on the ground are {step:g} m apart."


def test_signals_are_found_by_a_part_of_their_names(shown):
    """Groups without one are hidden, and curves and values of others; letters switch no tool."""
    field = shown.find_element(By.ID, "find")
    field.send_keys("ELB")
    headings = [x.text for x in shown.find_elements(By.CSS_SELECTOR, "#groups button")
                if x.is_displayed()]
    assert headings == ["Positions q, rad", "Velocities v, rad/s"]
    shown_now = [x.text.split("\n")[0] for x in shown.find_elements(
        By.CSS_SELECTOR, ".signals figcaption button") if x.is_displayed()]
    assert [x.split()[0] for x in shown_now] == ["elbow"]
    assert shown.execute_script("""
        const chart = [...player.plots.charts.values()][0];
        return chart.plot.series.slice(1).filter(x => x.show).map(x => x.label);""") == ["q.elbow"]
    assert not shown.execute_script("return player.tools.tools.find(x => x.name === 'Loop').on;")
    field.send_keys(Keys.CONTROL, "a")
    field.send_keys(Keys.DELETE)
    assert all(x.is_displayed() for x in shown.find_elements(By.CSS_SELECTOR, "#groups button"))
    assert shown.execute_script("""
        return [...player.plots.charts.values()].every(x => x.plot.series.every(y => y.show));""")


def test_a_part_that_is_zoomed_is_shown_by_all_plots_and_repeated(shown):
    """A drag over the second quarter; played with Loop on, the time stays in it."""
    over = shown.find_elements(By.CSS_SELECTOR, ".u-over")[0]
    width = over.rect["width"]
    ActionChains(shown).scroll_to_element(over).move_to_element_with_offset(
        over, round(-width / 4), 0).click_and_hold().move_by_offset(
        round(width / 4), 0).release().perform()
    scales = """
        return [...player.plots.charts.values()].map(x => [x.plot.scales.x.min,
                                                           x.plot.scales.x.max]);"""
    wanted = [DURATION / 4, DURATION / 2]
    assert np.array(shown.execute_script(scales)) == pytest.approx(
        np.array([wanted, wanted]), abs=0.02 * DURATION)
    buttons = shown.find_elements(By.CSS_SELECTOR, "#groups button")
    buttons[-1].click()
    assert shown.execute_script(scales)[-1] == pytest.approx(wanted, abs=0.02 * DURATION)
    buttons[-1].click()
    times = shown.execute_script("""
        const { clock } = player, times = [];
        player.tools.toggle(player.tools.tools.find(x => x.name === "Loop"));
        clock.speed = 1;
        clock.play(true);
        for (let i = 0; i < 40; i++) {
          clock.tick(1000 + 100 * i);
          times.push(clock.time);
        }
        clock.play(false);
        return times;""")
    assert min(times) >= wanted[0] - 0.02 * DURATION and max(times) < wanted[1] + 0.02 * DURATION
    assert sum(np.diff(times) < 0) > 3
    ActionChains(shown).move_to_element(over).double_click().perform()
    assert shown.execute_script("return player.clock.part;") is None
    assert np.array(shown.execute_script(scales)) == pytest.approx(
        np.array([[0, DURATION]] * 2), abs=1e-6)
    assert clock(shown) >= 0
