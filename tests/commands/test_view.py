"""The playback in a real browser, by mouse, keys and touch, without a network."""

import json
import math

import numpy as np
import pytest
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import Select, WebDriverWait

from coscrew_codegen.simulation.run_summary import RunOverrides, simulated
from coscrew_codegen.simulation.view.page_text import page
from coscrew_codegen.simulation.view.view_files import view
from tests.support.browser import chromium, resize
from tests.support.playback_page import (
    PIXEL,
    SECONDS,
    SMALL,
    camera,
    clock,
    opened,
    pose,
    touch,
)
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
    folder, results = tmp_path_factory.mktemp("view"), {}
    for name, text in TEXTS.items():
        path = folder / f"{name}.toml"
        path.write_text(text)
        kernels = checked(path, None, others=("body_poses",), precisions=("double",))
        (results[name],) = simulated(kernels, RunOverrides(until=2.0, precision="double"))
        view([results[name]], [folder / f"{name}.html"])
    return results, folder


@pytest.fixture(scope="module")
def browser():
    with chromium() as driver:
        yield driver


@pytest.fixture(scope="module", params=TEXTS)
def each(request, browser, runs):
    """The page of each run, opened once for all tests of it: a page opens slowly by software."""
    return opened(browser, runs[1], request.param)


@pytest.fixture(scope="module")
def pendulum(browser, runs):
    """The pendulum's page, which the tests of this file share."""
    return opened(browser, runs[1], "pendulum")


@pytest.fixture
def shown(pendulum, runs):
    """The pendulum's page as it is first seen, on a desktop."""
    if "pendulum" not in pendulum.current_url:
        opened(pendulum, runs[1], "pendulum")
    resize(pendulum, *SMALL)
    pendulum.execute_script("""
        scrollTo(0, 0);
        document.activeElement.blur();
        player.clock.play(false);
        player.clock.seek(0);
        player.clock.speed = .1;  // so that it does not end by itself
        player.fit();""")
    return pendulum


CORNERS = """
    const { camera, canvas } = player.stage, box = canvas.getBoundingClientRect();
    const covers = ["tools", "bar"].map(x => document.getElementById(x).getBoundingClientRect());
    const narrow = innerWidth < 640;
    const free = { top: narrow ? 0 : covers[0].bottom - box.top,
                   bottom: (narrow ? covers[0].top : covers[1].top) - box.top };
    const points = arguments[0].flatMap(time => {
      player.clock.seek(time);
      player.update();
      player.space.updateWorldMatrix(true, true);
      return player.robot.bodies.flatMap((group, body) => player.robot.corners(body).map(point => {
        const p = point.clone().applyMatrix4(group.matrixWorld).project(camera);
        return [(p.x + 1) / 2 * box.width, (1 - p.y) / 2 * box.height];
      }));
    });
    return [points, free, box.width];"""


@pytest.mark.parametrize("each", ("pendulum", "brick", "spring"), indirect=True)
def test_all_bodies_are_framed(each):
    """At each time all corners are between the controls, and they fill half of the room there, one
    way or the other; on a phone as on a desktop."""
    for width, phone in ((1280, False), (390, True)):
        resize(each, width, 844, phone)
        each.execute_async_script("""
            const done = arguments[0];
            requestAnimationFrame(() => requestAnimationFrame(() => done()));""")
        points, free, wide = each.execute_script(CORNERS, [0, 0.5, 1, 1.5, 2])
        x, y = np.transpose(points)
        assert x.min() > 0 and x.max() < wide
        assert free["top"] - 2 < y.min() and y.max() < free["bottom"] + 2
        filled = max(np.ptp(x) / wide, np.ptp(y) / (free["bottom"] - free["top"]))
        assert 0.5 < filled <= 1


@pytest.mark.parametrize("each", ("awkward",), indirect=True)
def test_awkward_names_are_text(each):
    assert each.title == "awkward: playback"
    assert AWKWARD in each.find_element(By.ID, "space").get_attribute("aria-label")
    each.find_element(By.TAG_NAME, "body").send_keys("n")
    each.execute_script("player.update();")
    assert AWKWARD in [x.text for x in each.find_elements(By.CSS_SELECTOR, "#labels span")]
    assert each.get_log("browser") == []


def test_nothing_is_loaded_and_nothing_fails(each):
    """The messages include those of the tests above."""
    resize(each, *SMALL)
    each.find_element(By.ID, "play").click()
    for tool in each.find_elements(By.CSS_SELECTOR, "#tools button, #groups button"):
        tool.click()
    assert each.get_log("browser") == []
    requested = [message["params"]["request"]["url"] for message in (
        json.loads(entry["message"])["message"] for entry in each.get_log("performance"))
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
    """The picture has the colour of its box at the projection of its position, which is reddish or
    orange, and not on the other side, where nothing is."""
    for t in (0.0, 0.4, 0.8):
        shown.execute_script("player.clock.seek(arguments[0]);", t)
        angle = float(texts.pendulum(t)[0])
        at, other = shown.execute_script(PIXEL, [
            [-math.sin(angle), 0, -math.cos(angle)], [math.sin(angle), .3, math.cos(angle)]])
        assert at[3] == 255 and at[0] > at[2] + 40, (t, at)
        assert other[3] < 255 or abs(other[0] - other[2]) < 40, (t, other)


def test_it_plays_pauses_and_ends(shown):
    play = shown.find_element(By.ID, "play")
    assert (play.get_attribute("aria-label"), clock(shown)) == ("Play", 0)
    play.click()
    assert play.get_attribute("aria-label") == "Pause"
    WebDriverWait(shown, SECONDS).until(lambda x: clock(x) > 0)
    play.click()
    at = clock(shown)
    assert play.get_attribute("aria-label") == "Play"
    assert clock(shown) == at
    Select(shown.find_element(By.ID, "speed")).select_by_visible_text("5×")
    play.click()
    WebDriverWait(shown, SECONDS).until(lambda x: play.get_attribute("aria-label") == "Play")
    assert clock(shown) == 2
    play.click()  # again from the start
    assert clock(shown) < 1.9


@pytest.mark.parametrize("words, speed", (("1×", 1), ("0.25×", 0.25), ("2×", 2)))
def test_speeds_are_what_they_say(shown, words, speed):
    """By the times of frames, which are given here: a slow machine shows few."""
    Select(shown.find_element(By.ID, "speed")).select_by_visible_text(words)
    passed = shown.execute_script("""
        const clock = player.clock;
        clock.play(true);
        for (const now of [1000, 1020, 1100, 1400]) clock.tick(now);
        return clock.time;""")
    assert passed == pytest.approx(0.4 * speed, rel=1e-9)


def test_it_draws_nothing_at_rest(shown):
    """A page that stands still leaves the processor alone."""
    def rests(shown) -> bool:
        first, last = shown.execute_async_script("""
            const done = arguments[0], first = player.drawn;
            setTimeout(() => done([first, player.drawn]), 1500);""")
        return first == last

    WebDriverWait(shown, SECONDS).until(rests)


def test_the_slider_moves_time_by_key(shown):
    slider = shown.find_element(By.ID, "time")
    slider.send_keys(Keys.END)
    assert clock(shown) == 2
    assert slider.get_attribute("aria-valuetext").startswith("2.0")
    slider.send_keys(Keys.HOME)
    assert clock(shown) == 0


def test_keys_play_and_step(shown):
    body, play = shown.find_element(By.TAG_NAME, "body"), shown.find_element(By.ID, "play")
    body.send_keys(Keys.SPACE)
    assert play.get_attribute("aria-label") == "Pause"
    body.send_keys(Keys.SPACE)
    assert play.get_attribute("aria-label") == "Play"
    body.send_keys(Keys.END)
    assert clock(shown) == 2
    body.send_keys(Keys.ARROW_LEFT)
    assert clock(shown) == 1.98
    body.send_keys(Keys.HOME, Keys.ARROW_RIGHT)
    assert clock(shown) == 0.02


@pytest.mark.parametrize("key, name", (("t", "Trail"), ("j", "Frames"), ("n", "Names")))
def test_a_letter_switches_a_mark(shown, key, name):
    (tool,) = (x for x in shown.find_elements(By.CSS_SELECTOR, "#tools button") if x.text == name)
    before = tool.get_attribute("aria-pressed")
    shown.find_element(By.TAG_NAME, "body").send_keys(key)
    assert tool.get_attribute("aria-pressed") == ("false" if before == "true" else "true")
    shown.find_element(By.TAG_NAME, "body").send_keys(key)
    assert tool.get_attribute("aria-pressed") == before


def test_a_drag_turns_the_view_and_not_the_time(shown):
    """A drag of the picture's height is a whole turn."""
    canvas = shown.find_element(By.ID, "space")
    before, t, height = camera(shown), clock(shown), canvas.rect["height"]
    ActionChains(shown).move_to_element_with_offset(canvas, 0, -60).click_and_hold().move_by_offset(
        150, 30).release().perform()
    after = camera(shown)
    turned = math.remainder(before[0] - after[0] - 2 * math.pi * 150 / height, 2 * math.pi)
    assert turned == pytest.approx(0, abs=1e-3)
    assert after[1] == pytest.approx(before[1] + 2 * math.pi * 30 / height, abs=1e-3)
    assert after[2] == pytest.approx(before[2])
    assert clock(shown) == t
    shown.find_element(By.TAG_NAME, "body").send_keys("r")
    assert camera(shown) == pytest.approx(before, rel=1e-6)


def test_keys_turn_and_zoom_the_view(shown):
    canvas = shown.find_element(By.ID, "space")
    before = camera(shown)
    canvas.send_keys(Keys.ARROW_LEFT, Keys.ARROW_UP, "+")
    after = camera(shown)
    assert after[0] == pytest.approx(before[0] + 0.1)
    assert after[1] == pytest.approx(before[1] + 0.1)
    assert after[2] == pytest.approx(before[2] / 1.2)
    assert clock(shown) == 0


def test_touch_turns_and_pinches_on_a_phone(shown):
    resize(shown, 390, 600, phone=True)
    shown.execute_script("player.stage.resize(); player.fit();")
    box = shown.find_element(By.ID, "space").rect
    x, y = box["x"] + 100, box["y"] + 100
    before = camera(shown)
    touch(shown, "touchStart", (x, y))
    touch(shown, "touchMove", (x + 75, y))
    touch(shown, "touchEnd")
    turned = camera(shown)
    rest = before[0] - turned[0] - 2 * math.pi * 75 / box["height"]
    assert math.remainder(rest, 2 * math.pi) == pytest.approx(0, abs=0.02)
    touch(shown, "touchStart", (x, y), (x + 50, y))
    touch(shown, "touchMove", (x, y), (x + 100, y))
    touch(shown, "touchEnd")
    assert camera(shown)[2] < 0.7 * before[2]


@pytest.mark.parametrize("width, phone", ((1280, False), (768, False), (390, True), (320, True)))
def test_the_page_fits_its_window(shown, width, phone):
    resize(shown, width, 844, phone)
    wide, there = shown.execute_script(
        "return [document.documentElement.scrollWidth, innerWidth];")
    assert wide <= there == width
    for name in ("play", "start", "speed"):
        box = shown.find_element(By.ID, name).rect
        assert box["height"] >= 38 and box["x"] + box["width"] <= width, name


def test_controls_have_names(shown):
    unnamed = shown.execute_script("""
        return [...document.querySelectorAll("button, input, select, #space, svg")].filter(node =>
          !(node.innerText || node.getAttribute("aria-label") || node.ariaHidden === "true"
            || node.labels?.length)).length;""")
    assert unnamed == 0
    assert "bob" in shown.find_element(By.ID, "space").get_attribute("aria-label")


def values(shown, title: str) -> dict[str, str]:
    """The values beside the plot of this title, by label."""
    return dict(shown.execute_script("""
        const chart = [...document.querySelectorAll(".signals")].find(x =>
          x.querySelector("strong").textContent.startsWith(arguments[0]));
        return [...chart.querySelectorAll("figcaption button")].map(x =>
          [x.childNodes[1].textContent, x.querySelector("output").textContent]);""", title))


def test_energies_are_those_of_the_pendulum(shown):
    for t in (0.0, 1.0, 2.0):
        shown.execute_script("player.clock.seek(arguments[0]); player.update();", t)
        q, v = map(float, texts.pendulum(t))
        written = values(shown, "Energy, J")
        assert list(written) == ["kinetic", "potential", "total"]
        for name, wanted in (("kinetic", v**2 / 2), ("potential", -texts.GRAVITY * math.cos(q)),
                             ("total", 0)):
            assert float(written[name]) == pytest.approx(wanted, rel=1e-4, abs=2e-6), (name, t)


def test_curves_are_where_the_axis_says(shown):
    """The heights of the kinetic energy, v²/2, in the plot's own pixels."""
    heights = shown.execute_script("""
        const chart = [...player.plots.charts.values()].find(x => x.group.heading === "Energy, J");
        return arguments[0].map(t => {
          const i = chart.plot.data[0].findIndex(x => Math.abs(x - t) < 1e-9);
          return chart.plot.data[1][i];
        });""", [0.25, 1.0, 1.75])
    for t, height in zip([0.25, 1.0, 1.75], heights, strict=True):
        assert height == pytest.approx(float(texts.pendulum(t)[1])**2 / 2, abs=1e-5)


def test_a_click_in_a_plot_moves_there(shown):
    """To 1 % of the run, and the cursor stands there."""
    over = shown.find_element(By.CSS_SELECTOR, ".signals .u-over")
    for share in (0.25, 0.9, 0.5):
        across = round((share - 0.5) * over.rect["width"])
        ActionChains(shown).move_to_element_with_offset(over, across, 0).click().perform()
        assert clock(shown) == pytest.approx(2 * share, abs=0.02)


def test_signals_are_plotted_on_demand(shown):
    """Each quantity and unit has a button; pressed, it has a plot."""
    groups = {x.text: x for x in shown.find_elements(By.CSS_SELECTOR, "#groups button")}
    assert set(groups) == {
        "Positions q, rad", "Energy, J", "Velocities v, rad/s", "Position, bob, m",
        "Reaction, hinge, N", "Reaction, hinge, N·m"}
    before = len(shown.find_elements(By.CSS_SELECTOR, ".signals"))
    groups["Position, bob, m"].click()
    assert len(shown.find_elements(By.CSS_SELECTOR, ".signals")) == before + 1
    shown.execute_script("player.clock.seek(1); player.update();")
    angle = float(texts.pendulum(1.0)[0])
    written = values(shown, "Position, bob, m")
    assert float(written["x"]) == pytest.approx(-math.sin(angle), abs=1e-4)
    assert float(written["z"]) == pytest.approx(-math.cos(angle), abs=1e-4)
    groups["Position, bob, m"].click()
    assert len(shown.find_elements(By.CSS_SELECTOR, ".signals")) == before


@pytest.fixture(scope="module")
def unstable(runs):
    """A run that stopped; its page stands beside the others."""
    path = runs[1] / "unstable.toml"
    path.write_text(texts.UNSTABLE)
    kernels = checked(path, None, others=("body_poses",), precisions=("double",))
    (result,) = simulated(kernels, RunOverrides(precision="double"))
    view([result], [path.with_suffix(".html")])
    return result


def test_a_run_that_stopped_says_so(unstable):
    assert f'role="status">{unstable.trajectory.stopped}' in page([unstable])


def test_a_run_of_huge_numbers_is_shown_as_far_as_they_go(browser, runs, unstable):
    shown = opened(browser, runs[1], "unstable")
    assert shown.get_log("browser") == []
    assert shown.execute_script("""
        const poses = player.recording.main.poses;
        return poses.length > 0 && poses.every(Number.isFinite);""")
    ends = shown.execute_script("return player.clock.end;")
    assert ends < unstable.trajectory.t[-1]
    assert shown.find_element(By.ID, "shown").text.startswith(
        f"The playback ends at t = {ends:.6g} s: ")
    assert 'id="shown"' not in (runs[1] / "pendulum.html").read_text()


def test_without_3d_a_sentence_says_so_and_plots_work(runs):
    with chromium("--disable-3d-apis") as driver:
        shown = opened(driver, runs[1], "pendulum")
        assert "WebGL" in shown.find_element(By.ID, "without").text
        shown.execute_script("player.clock.seek(1);")
        WebDriverWait(shown, SECONDS).until(lambda x: float(values(x, "Energy, J")["kinetic"]) > 0)
        assert [x["message"] for x in shown.get_log("browser") if "WebGL" not in x["message"]] == []
