"""The playback in a real browser, by mouse, keys and touch, without a network."""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

from coscrew_codegen.simulation.recordings.playback import box_of, drawn, page, view
from coscrew_codegen.simulation.run_summary import RunOverrides, simulated
from tests.support.browser import chromium, resize
from tests.support.scenes import scene_texts as texts
from tests.support.scenes.selecting import checked

AWKWARD = "</script><script>document.title='no'</script>"
TEXTS = {"pendulum": texts.PENDULUM, "brick": texts.BRICK, "spring": texts.SPRING,
         "awkward": texts.PENDULUM.replace("bob", f'"{AWKWARD}"').replace(
             f'child = ""{AWKWARD}""', f'child = "{AWKWARD}"').replace(
             f', "position."{AWKWARD}""', "")}


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """The runs by name, and the folder with their pages."""
    folder, result = tmp_path_factory.mktemp("view"), {}
    for name, text in TEXTS.items():
        path = folder / f"{name}.toml"
        path.write_text(text)
        kernels = checked(path, None, others=("body_poses",), precisions=("double",))
        (result[name],) = simulated(kernels, RunOverrides(until=2.0, precision="double"))
        shown = result[name]
        view(shown.system, shown.trajectory, shown.recording.provenance, folder / f"{name}.html")
    return result, folder


@pytest.fixture(scope="module")
def browser():
    with chromium() as driver:
        yield driver


def opened(browser, folder: Path, name: str):
    """The page, freshly loaded on a desktop, with empty logs."""
    browser.get("about:blank")
    resize(browser, 1280, 900)
    browser.get_log("browser")
    browser.get_log("performance")
    browser.get((folder / f"{name}.html").as_uri())
    return browser


@pytest.fixture
def shown(browser, runs):
    """The pendulum's page."""
    return opened(browser, runs[1], "pendulum")


def clock(shown) -> float:
    return float(shown.find_element(By.ID, "clock").text.split("/")[0])


def pixels(shown) -> str:
    return shown.execute_script("return document.getElementById('space').toDataURL();")


def camera(shown) -> tuple[float, float, float]:
    return tuple(shown.execute_script("return [view.azimuth, view.elevation, view.distance];"))


def pose(shown, body: int, t: float) -> np.ndarray:
    return np.array(shown.execute_script("return poseOf(arguments[0], arguments[1]);", body, t))


@pytest.mark.parametrize("name", TEXTS)
def test_nothing_is_loaded_and_nothing_fails(browser, runs, name):
    shown = opened(browser, runs[1], name)
    shown.find_element(By.ID, "play").click()
    assert shown.get_log("browser") == []
    requested = [message["params"]["request"]["url"] for message in (
        json.loads(entry["message"])["message"] for entry in shown.get_log("performance"))
        if message["method"] == "Network.requestWillBeSent"]
    assert [x for x in requested if not x.startswith(("file:", "data:"))] == []
    assert sum(x.startswith("file:") for x in requested) == 1


@pytest.mark.parametrize("t", (0.0, 0.3333, 1.0, 1.987))
def test_bodies_are_where_the_closed_form_says(shown, t):
    """The bob hangs 1 m below the hinge, turned by the angle about y; between samples it is off by
    at most h²/8 times its acceleration, which is at most 2 g."""
    angle = float(texts.pendulum(t)[0])
    wanted = (-math.sin(angle), 0, -math.cos(angle), 0, math.sin(angle / 2), 0, math.cos(angle / 2))
    assert np.abs(pose(shown, 1, t) - wanted).max() < 0.05**2 / 8 * 2 * texts.GRAVITY
    stored = round(t / 0.05) * 0.05
    angle = float(texts.pendulum(stored)[0])
    wanted = (-math.sin(angle), 0, -math.cos(angle), 0, math.sin(angle / 2), 0, math.cos(angle / 2))
    assert np.abs(pose(shown, 1, stored) - wanted).max() < 1e-6


def test_the_bob_is_drawn_where_it_is(shown):
    """The picture has the colour of its box at the projection of its position, and not elsewhere.
    """
    for t in (0.0, 0.4, 0.8):
        shown.execute_script("seek(arguments[0]);", t)
        angle = float(texts.pendulum(t)[0])
        hue = shown.execute_script("""
            const project = projection(view, canvas.clientWidth, canvas.clientHeight);
            const at = p => {
              const [x, y] = project(p), k = devicePixelRatio || 1;
              return [...context.getImageData(Math.round(x * k), Math.round(y * k), 1, 1).data];
            };
            return [at(arguments[0]), at(arguments[1])];""",
            [-math.sin(angle), 0, -math.cos(angle)], [math.sin(angle), .3, math.cos(angle)])
        assert hue[0][3] == 255, t
        assert hue[0] != hue[1], t


def test_it_plays_pauses_and_ends(shown):
    play = shown.find_element(By.ID, "play")
    assert (play.text, clock(shown)) == ("Play", 0)
    before = pixels(shown)
    play.click()
    assert play.text == "Pause"
    WebDriverWait(shown, 10).until(lambda x: clock(x) > 0.2)
    play.click()
    at = clock(shown)
    assert pixels(shown) != before
    assert play.text == "Play"
    assert clock(shown) == at
    Select(shown.find_element(By.ID, "speed")).select_by_visible_text("5×")
    play.click()
    WebDriverWait(shown, 10).until(lambda x: play.text == "Play")
    assert clock(shown) == 2
    play.click()  # again from the start
    assert clock(shown) < 1.9


@pytest.mark.parametrize("words, speed", (("1×", 1), ("0.25×", 0.25), ("2×", 2)))
def test_speeds_are_what_they_say(shown, words, speed):
    """By the times of the frames that were shown, however few they are."""
    Select(shown.find_element(By.ID, "speed")).select_by_visible_text(words)
    passed = shown.execute_async_script("""
        const done = arguments[0];
        let first = null;
        const look = now => {  // each time after the page's own
          first ??= [now, state.time];
          if (now - first[0] < 400) requestAnimationFrame(look);
          else done((state.time - first[1]) / ((now - first[0]) / 1000));
        };
        play(true);
        requestAnimationFrame(look);""")
    assert passed == pytest.approx(speed, rel=1e-6)


def test_the_slider_moves_time_by_key(shown):
    slider = shown.find_element(By.ID, "time")
    slider.send_keys(Keys.END)
    assert clock(shown) == 2
    assert slider.get_attribute("aria-valuetext").startswith("2.0")
    slider.send_keys(Keys.HOME)
    assert clock(shown) == 0


def test_space_plays_and_pauses(shown):
    body = shown.find_element(By.TAG_NAME, "body")
    body.send_keys(Keys.SPACE)
    assert shown.find_element(By.ID, "play").text == "Pause"
    body.send_keys(Keys.SPACE)
    assert shown.find_element(By.ID, "play").text == "Play"


def test_a_drag_turns_the_view_and_not_the_time(shown):
    before, image, t = camera(shown), pixels(shown), clock(shown)
    canvas = shown.find_element(By.ID, "space")
    ActionChains(shown).click_and_hold(canvas).move_by_offset(150, 30).release().perform()
    after = camera(shown)
    assert after[0] == pytest.approx(before[0] - 1)
    assert after[1] == pytest.approx(before[1] + 0.2)
    assert after[2] == before[2]
    assert (pixels(shown) != image, clock(shown)) == (True, t)
    shown.find_element(By.ID, "reset").click()
    assert camera(shown) == before


def test_keys_turn_and_zoom_the_view(shown):
    canvas = shown.find_element(By.ID, "space")
    before = camera(shown)
    canvas.send_keys(Keys.ARROW_LEFT, Keys.ARROW_UP, "+")
    after = camera(shown)
    assert after[0] > before[0]
    assert after[1] > before[1]
    assert after[2] == pytest.approx(before[2] / 1.2)


def touch(shown, kind: str, *points: tuple[float, float]) -> None:
    shown.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [
        {"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]})


def test_touch_turns_and_pinches_on_a_phone(shown):
    resize(shown, 390, 844, phone=True)
    shown.refresh()
    box = shown.find_element(By.ID, "space").rect
    x, y = box["x"] + 100, box["y"] + 100
    before = camera(shown)
    touch(shown, "touchStart", (x, y))
    touch(shown, "touchMove", (x + 75, y))
    touch(shown, "touchEnd")
    turned = camera(shown)
    assert turned[0] == pytest.approx(before[0] - 0.5, abs=0.01)
    touch(shown, "touchStart", (x, y), (x + 50, y))
    touch(shown, "touchMove", (x, y), (x + 100, y))
    touch(shown, "touchEnd")
    assert camera(shown)[2] == pytest.approx(before[2] / 2, rel=0.01)
    assert camera(shown)[0] == pytest.approx(turned[0])


@pytest.mark.parametrize("width, phone", ((1280, False), (768, False), (390, True), (320, True)))
def test_the_page_fits_its_window(shown, width, phone):
    resize(shown, width, 844, phone)
    shown.refresh()
    wide, there = shown.execute_script(
        "return [document.documentElement.scrollWidth, innerWidth];")
    assert wide <= there == width
    for name in ("play", "start", "reset", "speed"):
        box = shown.find_element(By.ID, name).rect
        assert box["height"] >= 38 and box["x"] + box["width"] <= width, name


def test_controls_have_names(shown):
    unnamed = shown.execute_script("""
        return [...document.querySelectorAll("button, input, select, canvas, svg")].filter(node =>
          !(node.innerText || node.getAttribute("aria-label") || node.labels?.length)).length;""")
    assert unnamed == 0
    assert "bob" in shown.find_element(By.ID, "space").get_attribute("aria-label")


def test_energies_are_those_of_the_pendulum(shown):
    for t in (0.0, 1.0, 2.0):
        shown.execute_script("seek(arguments[0]);", t)
        q, v = map(float, texts.pendulum(t))
        for name, wanted in (("kinetic", v**2 / 2), ("potential", -texts.GRAVITY * math.cos(q)),
                             ("total", 0)):
            names = [x.text for x in shown.find_elements(By.CSS_SELECTOR, ".energies dt")]
            text = shown.find_elements(By.CSS_SELECTOR, ".energies dd")[names.index(name)].text
            assert text.endswith(" J")
            assert float(text[:-2]) == pytest.approx(wanted, rel=1e-4, abs=1e-9), (name, t)


def middle(box: dict[str, float]) -> float:
    return box["x"] + box["width"] / 2


def test_the_cursor_stands_at_its_time(shown):
    """The cursor's place on the axis is that of its time, on a wide page and on a phone."""
    for width, phone in ((1280, False), (390, True)):
        resize(shown, width, 844, phone)
        ticks = {float(x.text): middle(x.rect) for x in shown.find_elements(
            By.CSS_SELECTOR, ".energies .chart text")[:5]}
        assert list(ticks) == [0, 0.5, 1, 1.5, 2]
        for t, x in ticks.items():
            shown.execute_script("seek(arguments[0]);", t)
            cursor = shown.find_element(By.CSS_SELECTOR, ".energies .cursor").rect
            assert middle(cursor) == pytest.approx(x, abs=2), (width, t)


def test_curves_of_energies_are_where_the_axis_says(shown):
    """Heights of the kinetic energy, v²/2, at times between ticks, by the ticks at 0 and 10 J."""
    path, levels = shown.execute_script("""
        const chart = document.querySelector(".energies .chart");
        const curve = chart.querySelector("[data-mark=kinetic] path");
        const box = chart.querySelector("svg").getBoundingClientRect();
        const numbers = curve.getAttribute("d").match(/-?[\\d.]+/g).map(Number);
        const scale = box.width / chart.querySelector("svg").viewBox.baseVal.width;
        const texts = [...chart.querySelectorAll("text")].slice(5).map(x => {
          const at = x.getBoundingClientRect();
          return [x.textContent, (at.y + at.height / 2 - box.y) / scale];
        });
        return [numbers, texts];""")
    at = {float(text.replace("\u2212", "-")): y for text, y in levels if text != "t, s"}
    points = np.reshape(path, (-1, 2))
    left, right = points[0, 0], points[-1, 0]
    for x, y in points:
        v = float(texts.pendulum(2 * (x - left) / (right - left))[1])
        energy = 10 * (y - at[0]) / (at[10] - at[0])
        assert energy == pytest.approx(v**2 / 2, abs=0.2)


def test_a_click_on_the_energies_moves_there(shown):
    figure = shown.find_element(By.CSS_SELECTOR, ".energies .chart")
    left, width = shown.execute_script("return data.chart;")
    for share in (0.25, 1, 0.5):
        across = round((left + width * share - 0.5) * figure.rect["width"])
        ActionChains(shown).move_to_element_with_offset(figure, across, 0).click().perform()
        assert clock(shown) == pytest.approx(2 * share, abs=0.02)


def test_awkward_names_are_text(browser, runs):
    shown = opened(browser, runs[1], "awkward")
    assert shown.title == "awkward: playback"
    assert AWKWARD in shown.find_element(By.ID, "space").get_attribute("aria-label")
    shown.find_element(By.ID, "names").click()
    assert shown.get_log("browser") == []


def test_a_run_that_stopped_says_so(runs, tmp_path):
    path = tmp_path / "unstable.toml"
    path.write_text(texts.UNSTABLE)
    kernels = checked(path, None, others=("body_poses",), precisions=("double",))
    (result,) = simulated(kernels, RunOverrides(precision="double"))
    text = page(result.system, result.trajectory, result.recording.provenance)
    assert f'role="status">{result.trajectory.stopped}' in text


def test_a_run_of_huge_numbers_is_shown_as_far_as_they_go(browser, runs, tmp_path):
    path = tmp_path / "unstable.toml"
    path.write_text(texts.UNSTABLE)
    kernels = checked(path, None, others=("body_poses",), precisions=("double",))
    (result,) = simulated(kernels, RunOverrides(precision="double"))
    view(result.system, result.trajectory, result.recording.provenance, tmp_path / "unstable.html")
    shown = opened(browser, tmp_path, "unstable")
    assert shown.get_log("browser") == []
    assert shown.execute_script("return poses.length > 0 && poses.every(Number.isFinite);")
    ends = shown.execute_script("return end;")
    assert ends < result.trajectory.t[-1]
    assert shown.find_element(By.ID, "shown").text.startswith(
        f"The playback ends at t = {ends:.6g} s: ")
    assert 'id="shown"' not in (runs[1] / "pendulum.html").read_text()


# what is drawn

@pytest.mark.parametrize("sides", ((1, 2, 3), (0.1, 0.1, 5), (2, 2, 2)))
def test_boxes_have_the_bodies_inertia(sides):
    a, b, c = sides
    mass = 7.0
    moments = mass / 12 * np.array([b * b + c * c, a * a + c * c, a * a + b * b])
    half, axes = box_of(np.array([mass]), np.array([*moments, 0, 0, 0]))
    assert half == pytest.approx(np.array(sides) / 2)
    assert np.array_equal(axes, np.eye(3))
    turn = np.linalg.qr(np.array([[1.0, 2, 3], [-1, 1, 0.5], [0.3, -2, 1]]))[0]
    xx, xy, xz, yy, yz, zz = (turn @ np.diag(moments) @ turn.T)[np.triu_indices(3)]
    half, axes = box_of(np.array([mass]), np.array([xx, yy, zz, xy, xz, yz]))
    assert sorted(2 * half) == pytest.approx(sorted(sides))
    assert np.linalg.det(axes) == pytest.approx(1)
    again = axes @ np.diag(mass / 3 * (np.sum(half**2) - half**2)) @ axes.T
    assert again == pytest.approx(turn @ np.diag(moments) @ turn.T)


def test_lines_go_from_origins_to_joints_and_centres(runs):
    result = drawn(runs[0]["pendulum"].system)
    assert [(x["body"], x["points"], x["rod"]) for x in result.lines] == [
        (-1, [[0, 0, 0], [0, 0, 0]], False), (0, [[0, 0, 0], [0, 0, -1]], False),
        (1, [[0, 0, 0], [0, 0, 0]], True)]
    assert result.joints == [{"body": -1, "point": [0, 0, 0]}]
    assert drawn(runs[0]["spring"].system).slides == [{"body": -1, "point": [0, 0, 0], "child": 0}]
    assert drawn(runs[0]["brick"].system).joints == []
