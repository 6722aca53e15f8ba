"""Tools of the playback page: the tree of bodies, selection, views, repetition, saved pictures."""

import base64
import io
import math

import numpy as np
import pytest
from PIL import Image
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

from coscrew_codegen.simulation.view.view_files import view
from tests.support.browser import chromium
from tests.support.playback_data import arm
from tests.support.playback_page import PIXEL, SECONDS, camera, clock, opened, pose

BALL = '<visual><origin xyz="0 0 -1"/><geometry><sphere radius="0.3"/></geometry></visual>'
PLACE = """
    const { camera, canvas } = player.stage;
    const p = player.stage.now.clone().set(...arguments[0]).project(camera);
    return [p.x * canvas.clientWidth / 2, -p.y * canvas.clientHeight / 2];"""


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    folder = tmp_path_factory.mktemp("tools")
    view(arm(folder, BALL, precision="double", until=1.0), [folder / "arm.html"])
    with chromium() as driver:
        yield opened(driver, folder, "arm")


@pytest.fixture
def shown(browser):
    """The page at its start, with all tools as they were, the pointer beside the picture."""
    ActionChains(browser).move_to_element(browser.find_element(By.TAG_NAME, "h1")).perform()
    yield browser
    assert browser.get_log("browser") == []
    browser.execute_script("""
        for (const tool of player.tools.tools) if (tool.on !== (tool.name in arguments[0])) {
          player.tools.toggle(tool);
        }
        player.tree.choose(null);
        player.clock.play(false);
        player.clock.seek(0);
        player.fit();""", {"Forces": 1, "Trail": 1, "Ground": 1})


def press(shown, key: str) -> None:
    shown.find_element(By.TAG_NAME, "body").send_keys(key)


def centre(shown) -> list[float]:
    """The ball's centre, as it is drawn."""
    body = shown.execute_script("return player.recording.bodies.findIndex(x => x.name === 'arm');")
    x, y, z, qx, qy, qz, qw = map(float, pose(shown, body, clock(shown)))
    return [x - 2 * (qx * qz + qw * qy), y - 2 * (qy * qz - qw * qx),
            z - 1 + 2 * (qx * qx + qy * qy)]


def colour(shown) -> list[int]:
    """The ball's colour in the picture, beside the marks at its centre."""
    x, y, z = centre(shown)
    (result,) = shown.execute_script(PIXEL, [[x, y - .1, z + .2]])
    return result


def test_the_tree_names_all_bodies_with_masses_and_joints(shown):
    assert not shown.find_element(By.ID, "tree").is_displayed()
    press(shown, "b")
    rows = [x.text for x in shown.find_elements(By.CSS_SELECTOR, "#tree button")]
    assert rows == ["base fixed base", "arm 1 kg · revolute hinge"]


def test_a_click_in_the_tree_selects_a_body_and_says_where_it_is(shown):
    """In the tree, and, without it, in the picture."""
    press(shown, "b")
    before = colour(shown)
    row = shown.find_elements(By.CSS_SELECTOR, "#tree button")[-1]
    row.click()
    shown.execute_script("player.clock.seek(0.8); player.update();")
    words = shown.find_element(By.ID, "chosen").text
    body, place, q = words.split("\n")
    assert body == "arm · 1 kg · hinge" and place.startswith("at 0, 0, 0 m")
    assert float(q.removeprefix("q ")) == pytest.approx(shown.execute_script("""
        const signal = player.recording.groups.flatMap(x => x.signals).find(
          x => x.name === "q.hinge" && x.run === 0);
        return player.recording.main.value(signal.numbers);"""), rel=1e-4)
    shown.execute_script("player.clock.seek(0);")
    assert row.get_attribute("aria-pressed") == "true" and colour(shown) != before
    press(shown, "b")
    assert shown.find_element(By.ID, "chosen").is_displayed()
    press(shown, Keys.ESCAPE)
    assert row.get_attribute("aria-pressed") == "false" and colour(shown) == before
    assert not shown.find_element(By.ID, "chosen").is_displayed()


def test_a_click_in_the_picture_selects_the_body_there(shown):
    press(shown, "b")
    canvas = shown.find_element(By.ID, "space")
    across, down = shown.execute_script(PLACE, centre(shown))
    ActionChains(shown).move_to_element_with_offset(canvas, round(across), round(down)
                                                    ).click().perform()
    pressed = [x.get_attribute("aria-pressed")
               for x in shown.find_elements(By.CSS_SELECTOR, "#tree button")]
    assert pressed[-1] == "true" and pressed.count("true") == 1


def test_a_tick_hides_a_body(shown):
    press(shown, "b")
    before, tick = colour(shown), shown.find_elements(By.CSS_SELECTOR, "#tree input")[-1]
    tick.click()
    assert colour(shown) != before
    tick.click()
    assert colour(shown) == before
    press(shown, "b")  # letters are keys of the page while a control has the focus
    assert not shown.find_element(By.ID, "tree").is_displayed()


def test_one_sees_through_bodies(shown):
    before = colour(shown)
    press(shown, "s")
    assert colour(shown) != before
    press(shown, "s")
    assert colour(shown) == before


@pytest.mark.parametrize("key, azimuth, elevation", (
    ("x", 0, 0), ("y", -math.pi / 2, 0), ("z", -math.pi / 2, math.atan(100))))
def test_views_stand_on_the_axes(shown, key, azimuth, elevation):
    first = camera(shown)
    press(shown, key)
    assert camera(shown)[:2] == pytest.approx((azimuth, elevation), abs=1e-6)
    press(shown, "r")
    assert camera(shown) == pytest.approx(first, rel=1e-6)


def test_a_double_click_turns_about_the_place(shown):
    place = centre(shown)
    across, down = shown.execute_script(PLACE, place)
    ActionChains(shown).move_to_element_with_offset(
        shown.find_element(By.ID, "space"), round(across), round(down)).double_click().perform()
    target = shown.execute_script("return player.stage.controls.target.toArray();")
    assert math.dist(target, place) == pytest.approx(0.3, abs=0.05)  # on the ball


def test_samples_are_stepped_and_runs_repeated(shown):
    press(shown, ".")
    press(shown, ".")
    times = shown.execute_script("return [...player.recording.main.times.slice(0, 3)];")
    assert shown.execute_script("return player.clock.time;") == times[2]
    press(shown, ",")
    assert shown.execute_script("return player.clock.time;") == times[1]
    press(shown, "l")
    assert shown.execute_script("""
        const { clock } = player;
        clock.seek(clock.end - .01);
        clock.play(true);
        clock.speed = 1;
        for (const now of [1000, 1100]) clock.tick(now);
        return [clock.playing, clock.time];""") == [True, 0]


def test_a_picture_is_saved_with_its_background(shown):
    shown.execute_script("""
        HTMLAnchorElement.prototype.click = function () {
          window.saved = [this.download, this.href];
        };
        """)
    press(shown, "p")
    name, text = shown.execute_script("return saved;")
    image = Image.open(io.BytesIO(base64.b64decode(text.partition(",")[2])))
    assert name == "arm 0.000 s.png"
    assert [*image.size] == shown.execute_script(
        "return [player.stage.canvas.width, player.stage.canvas.height];")
    pixels = np.asarray(image.convert("RGBA")).reshape(-1, 4)
    assert (pixels[:, 3] == 255).all() and len(np.unique(pixels, axis=0)) > 100
    near = shown.execute_script("""
        return getComputedStyle(document.documentElement).getPropertyValue("--near");""")
    assert f"#{bytes(pixels[0, :3].tolist()).hex()}" == near.strip()


def test_all_keys_are_listed(shown):
    """Each tool and each action of the menu with its key; meanwhile keys do nothing else."""
    press(shown, "?")
    dialog = shown.find_element(By.ID, "keys")
    listed = dict(zip(*([x.text for x in dialog.find_elements(By.TAG_NAME, kind)]
                        for kind in ("dt", "dd")), strict=True))
    for name in ("Trail", "Frames", "Ground", "Inertia", "Save picture", "From above"):
        (key,) = (key for key, words in listed.items() if words == name)
        assert shown.execute_script("return player.tools.keys.get(arguments[0].toLowerCase()).name",
                                    key) == name
    assert {"space", "Esc", ", ."} <= listed.keys()
    press(shown, "t")
    assert shown.execute_script("return player.tools.keys.get('t').on;")
    press(shown, Keys.ESCAPE)
    assert not dialog.is_displayed()


def test_the_camera_follows_a_selected_body(shown):
    """The centre of mass leads; a selection alone turns nothing."""
    target = "return player.stage.controls.target.toArray();"
    before, first = np.array(shown.execute_script(target)), np.array(centre(shown))
    shown.execute_script("player.tree.choose(1); player.update();")
    press(shown, "f")
    shown.execute_script("player.update();")
    assert np.array(shown.execute_script(target)) == pytest.approx(before)
    shown.execute_script("player.clock.seek(.6); player.update();")
    moved = centre(shown) - first
    assert np.linalg.norm(moved) > 0.05
    assert np.array(shown.execute_script(target)) - before == pytest.approx(moved, abs=1e-6)


def test_without_the_ground_one_sees_the_robot_from_below(shown):
    canvas = shown.find_element(By.ID, "space")
    for key, below in (("g", True), ("g", False)):
        press(shown, key)
        for _ in range(25):
            canvas.send_keys(Keys.ARROW_DOWN)
        assert (camera(shown)[1] < -1) == below
        assert shown.execute_script("return player.stage.ground.visible;") != below


def test_the_speed_has_keys(shown):
    speed = "return [player.clock.speed, document.getElementById('speed').value];"
    shown.execute_script("player.clock.hurry(0);")
    first = shown.execute_script(speed)[0]
    press(shown, ">")
    faster = shown.execute_script(speed)
    assert faster[0] > first and float(faster[1]) == faster[0]
    press(shown, "<")
    assert shown.execute_script(speed)[0] == first


def test_the_picture_fills_the_screen_and_shrinks_again(shown):
    full = "return document.fullscreenElement?.id;"
    press(shown, "e")
    WebDriverWait(shown, SECONDS).until(lambda x: x.execute_script(full) == "stage")
    press(shown, "e")
    WebDriverWait(shown, SECONDS).until(lambda x: x.execute_script(full) is None)


def test_boxes_of_inertia_appear_over_the_bodies(shown):
    """m (y² + z²)/12 = 0.1 about each axis."""
    assert not shown.execute_script("return player.tools.keys.get('i').mark;")
    press(shown, "i")
    (body, size, centre), = shown.execute_script("""
        const { group } = player.tools.keys.get("i").mark;
        return player.recording.inertias.map(x => [x.body, x.size, x.place.slice(0, 3)])
          .filter(() => group.visible);""")
    assert shown.execute_script("return player.recording.bodies[arguments[0]].name;", body) == "arm"
    assert size == pytest.approx([math.sqrt(0.6)] * 3) and centre == [0, 0, -1]


def test_the_run_is_filmed_to_its_end(shown):
    """From the start to the end; the file begins as all of its format do."""
    shown.execute_script("""
        window.films = [];
        HTMLAnchorElement.prototype.click = function () {
          fetchBlob(this.href).then(bytes => films.push([this.download, bytes]));
        };
        const make = URL.createObjectURL, blobs = new Map();
        URL.createObjectURL = blob => {
          const address = make.call(URL, blob);
          blobs.set(address, blob);
          return address;
        };
        window.fetchBlob = async address =>
          [...new Uint8Array(await blobs.get(address).arrayBuffer())].slice(0, 2000);
        player.clock.seek(.5);""")
    press(shown, "v")
    begin, playing = shown.execute_script("return [player.clock.time, player.clock.playing];")
    assert playing and begin < 0.5
    WebDriverWait(shown, SECONDS).until(lambda x: x.execute_script("return films.length;"))
    ((name, content),) = shown.execute_script("return films;")
    assert shown.execute_script("return player.clock.time === player.clock.end;")
    assert not shown.execute_script("return player.filming.on;")
    assert name == "arm.webm" and bytes(content[:4]).hex() == "1a45dfa3"  # EBML
    assert len(content) == 2000
