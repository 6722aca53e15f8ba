"""Opens, moves and reads a playback page in a browser."""

import math
from pathlib import Path

import numpy as np
from selenium.webdriver import Chrome
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

from tests.support.browser import SECONDS, resize

SMALL = 760, 480  # pixels of the window: a larger picture takes longer


def opened(browser: Chrome, folder: Path, name: str, width: int = SMALL[0],
           height: int = SMALL[1], phone: bool = False) -> Chrome:
    """The page, freshly loaded and drawn, with empty logs."""
    browser.get("about:blank")
    resize(browser, width, height, phone)
    browser.get_log("browser")  # type: ignore[no-untyped-call]
    browser.get_log("performance")  # type: ignore[no-untyped-call]
    browser.get((folder / f"{name}.html").as_uri())
    drawn(browser)
    return browser


def drawn(browser: Chrome) -> None:
    """Wait for the first picture."""
    WebDriverWait(browser, SECONDS).until(lambda x: x.execute_script(
        "return document.documentElement.dataset.ready !== undefined;"))


def clock(shown: Chrome) -> float:
    """The time that the page says, in s."""
    return float(shown.find_element(By.ID, "clock").text.split("/")[0])


def camera(shown: Chrome) -> tuple[float, float, float]:
    """Azimuth and elevation of the camera about its target, and its distance."""
    x, y, z = shown.execute_script("""
        const { camera, controls } = player.stage;
        return camera.position.clone().sub(controls.target).toArray();""")
    distance = math.hypot(x, y, z)
    return math.atan2(y, x), math.asin(z / distance), distance


def pose(shown: Chrome, body: int, t: float) -> np.ndarray:
    """Position and quaternion of a drawn body at a time."""
    return np.array(shown.execute_script("""
        player.clock.seek(arguments[1]);
        player.update();
        const { position, quaternion } = player.robot.bodies[arguments[0]];
        return [...position.toArray(), ...quaternion.toArray()];""", body, t))


PIXEL = """
    const { renderer, camera, canvas } = player.stage, gl = renderer.getContext();
    player.update();
    const colours = arguments[0].map(point => {
      const p = player.stage.now.clone().set(...point).project(camera), pixel = new Uint8Array(4);
      const x = (p.x + 1) / 2 * gl.drawingBufferWidth, y = (p.y + 1) / 2 * gl.drawingBufferHeight;
      gl.readPixels(Math.floor(x), Math.floor(y), 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return [...pixel];
    });
    return colours;"""
"""Colours of the picture at points of the world."""


def touch(shown: Chrome, kind: str, *points: tuple[float, float]) -> None:
    """Send an event of fingers at these points."""
    shown.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [
        {"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)]})
