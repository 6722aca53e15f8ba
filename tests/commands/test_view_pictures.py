"""Pictures of the playback pages of the examples, on a desktop and on a phone, light and dark: kept
in build/pictures, as the report of this test."""

import base64
import io
from itertools import product
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from coscrew_codegen.__main__ import main
from tests.support.browser import chromium, resize
from tests.support.playback_page import opened

ROOT = Path(__file__).parents[2]
PICTURES = ROOT / "build/pictures"
DESKTOP, PHONE = (1280, 900), (390, 844)  # pixels
SHOWN = {"pendulum": 0.2, "arm6": 0.6, "landing": 0.12, "bouncing_ball": 0.6, "four_bars": 0.5}
"""Shares of the runs of examples at which the pictures are taken."""
DRAWN = """
    const [share, done] = arguments;
    requestAnimationFrame(() => requestAnimationFrame(() => {  // the page has its size
      const before = player.drawn;
      player.clock.seek(player.clock.end * share);
      const wait = () => player.drawn > before ? done() : setTimeout(wait, 20);
      wait();
    }));"""
"""Draws the page at a share of the run."""
MIDDLE = """
    const { stage, space } = player, pictures = [];
    stage.ratio = .25;  // software draws slowly
    stage.resize();
    for (const visible of [true, false]) {
      space.visible = visible;
      stage.render();
      pictures.push(stage.canvas.toDataURL("image/png"));
    }
    space.visible = true;
    stage.adapt(null);  // sharp again
    return pictures;"""
"""Coarse pictures with the robot, and without it."""


@pytest.fixture(scope="module")
def pages(tmp_path_factory):
    """The folder with the page of each example."""
    folder = tmp_path_factory.mktemp("pictures")
    PICTURES.mkdir(parents=True, exist_ok=True)
    for name in SHOWN:
        assert main(["simulate", str(ROOT / f"examples/scenes/{name}.toml"), "--precision",
                     "double", "--view", str(folder / f"{name}.html")]) == 0
    return folder


@pytest.fixture(scope="module")
def browser():
    with chromium() as driver:
        yield driver


def pixels(text: str) -> np.ndarray:
    """The middle half of a picture, either way."""
    image = np.asarray(Image.open(io.BytesIO(base64.b64decode(text.partition(",")[2]))), int)
    height, width = image.shape[:2]
    return image[height // 4:3 * height // 4, width // 4:3 * width // 4, :3]


OVERLAPS = """
    const boxes = [...document.querySelectorAll(
      "#tools > *, #bar > *, #tree, #said p, #groups > *, header > *, figcaption > *, .uplot")]
      .filter(x => x.checkVisibility()).map(x => [x, x.getBoundingClientRect()]);
    const results = [];
    boxes.forEach(([one, a], i) => boxes.slice(i + 1).forEach(([other, b]) => {
      if (!one.contains(other) && a.left < b.right - 1 && b.left < a.right - 1
          && a.top < b.bottom - 1 && b.top < a.bottom - 1 && !scrolled(one) && !scrolled(other)) {
        results.push([one.id || one.textContent, other.id || other.textContent]);
      }
    }));
    function scrolled(x) {  // out of the part of a list that is seen
      const [own, list] = [x, x.parentElement].map(y => y.getBoundingClientRect());
      return own.bottom > list.bottom + 1 || own.right > list.right + 1;
    }
    return [boxes.length, results];"""


@pytest.mark.parametrize("theme", ("light", "dark"))
@pytest.mark.parametrize("width, height", (DESKTOP, PHONE))
def test_nothing_lies_over_anything_with_everything_open(pages, browser, width, height, theme):
    """All tools on, the tree open, a body selected, a distance measured; the picture is kept."""
    browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {
        "features": [{"name": "prefers-color-scheme", "value": theme}]})
    shown = opened(browser, pages, "arm6", width, height)
    shown.execute_async_script(DRAWN, SHOWN["arm6"])
    count, overlapping = shown.execute_script("""
        for (const tool of player.tools.tools) {
          if (!tool.on && !["Film", "See-through"].includes(tool.name)) player.tools.toggle(tool);
        }
        player.tree.choose(2);
        for (const body of [player.robot.bodies[1], player.robot.bodies[4]]) {
          player.measure.mark({ object: { parent: body }, point: body.getWorldPosition(
            player.stage.now.clone()) });
        }
        player.update();
    """ + OVERLAPS)
    shown.save_screenshot(str(PICTURES / f"everything_{width}_{theme}.png"))
    assert count > 30 and overlapping == []
    assert shown.get_log("browser") == []


@pytest.mark.parametrize("name", SHOWN)
def test_the_robot_is_seen_in_the_picture_of_each_example(pages, browser, name):
    """1.5 % of the middle differ from the bare ground: a pendulum is thin.  The page fits its
    window, and nothing is on the console."""
    shown = opened(browser, pages, name, *DESKTOP)
    for (width, height), theme in product((DESKTOP, PHONE), ("light", "dark")):
        shown.execute_cdp_cmd("Emulation.setEmulatedMedia", {
            "features": [{"name": "prefers-color-scheme", "value": theme}]})
        resize(shown, width, height)
        shown.execute_async_script(DRAWN, SHOWN[name])
        shown.save_screenshot(str(PICTURES / f"{name}_{width}_{theme}.png"))
        with_robot, without = map(pixels, shown.execute_script(MIDDLE))
        seen = (np.abs(with_robot - without).max(-1) > 8).mean()
        assert seen > 0.015, width
        assert shown.execute_script("return document.documentElement.scrollWidth;") <= width
    assert shown.get_log("browser") == []
