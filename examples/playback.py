"""A scene's motion as an animated GIF, from the pictures of its playback page:

    python examples/playback.py examples/scenes/arm6.toml examples/arm6.gif

Chromium draws the page, through chromedriver and the package selenium."""

import base64
import io
import shutil
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from PIL import Image
from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.support.ui import WebDriverWait

from coscrew_codegen.__main__ import main

WIDTH, HEIGHT = 640, 400  # pixels
FRAMES_A_SECOND = 20
COLOURS = 96
SECONDS = 60  # until the first picture
ARGUMENTS = ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--hide-scrollbars",
             "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
PREPARE = """
    document.getElementById("stage").style.cssText =
      `position: fixed; inset: 0; margin: 0; height: ${innerHeight}px; border-radius: 0`;
    player.stage.resize();
    player.stage.fit(0, 12, 12);
    return player.clock.end;"""
PICTURE = """
    player.clock.seek(arguments[0]);
    player.update();
    return player.stage.canvas.toDataURL("image/png");"""


def pictures(page: Path) -> Iterator[Image.Image]:
    """The pictures of a page, on white, FRAMES_A_SECOND for each second of the run."""
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium") or ""  # "": Chrome, wherever it is
    for argument in (*ARGUMENTS, f"--window-size={WIDTH},{HEIGHT}"):
        options.add_argument(argument)
    driver = webdriver.Chrome(options, Service(shutil.which("chromedriver")))
    try:
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
            "width": WIDTH, "height": HEIGHT, "deviceScaleFactor": 1, "mobile": False})
        driver.get(page.as_uri())
        WebDriverWait(driver, SECONDS).until(lambda x: x.execute_script(
            "return document.documentElement.dataset.ready !== undefined;"))
        count = int(driver.execute_script(PREPARE) * FRAMES_A_SECOND)
        for i in range(count):
            data = driver.execute_script(PICTURE, i / FRAMES_A_SECOND)
            drawn = Image.open(io.BytesIO(base64.b64decode(data.partition(",")[2])))
            white = Image.new("RGBA", drawn.size, (255, 255, 255, 255))
            yield Image.alpha_composite(white, drawn.convert("RGBA")).convert("RGB")
    finally:
        driver.quit()


def written(scene: str, output: str) -> None:
    """Simulate the scene and write the GIF."""
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "run.html"
        if main(["simulate", scene, "--precision", "double", "--view", str(page)]):
            raise SystemExit(f"{scene}: the run stopped early")
        images = list(pictures(page))
    palette = images[len(images) // 2].quantize(COLOURS)
    shown = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    shown[0].save(output, save_all=True, append_images=shown[1:], loop=0, optimize=True,
                  duration=1000 // FRAMES_A_SECOND)


if __name__ == "__main__":
    written(*sys.argv[1:])
