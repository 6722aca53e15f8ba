"""A headless browser: Chromium, driven through chromedriver."""

import shutil
from collections.abc import Iterator
from contextlib import contextmanager

from selenium import webdriver
from selenium.webdriver.chrome.service import Service

SECONDS = 60  # until a script of a page has run: a picture by software on a busy machine
_LIGHT = """
    const shaderSource = WebGL2RenderingContext.prototype.shaderSource;
    WebGL2RenderingContext.prototype.shaderSource = function (shader, text) {
      return shaderSource.call(this, shader, text.replace("GGX_SAMPLES 256u", "GGX_SAMPLES 8u"));
    };"""
"""Fewer samples for reflections in smooth surfaces.  Pages have no such surfaces, but by software
these samples take half of the time in which a page is opened.  Pictures differ in no channel by
more than 1 of 255."""


def _command(*names: str) -> str:
    """The first of these commands that is installed."""
    path = next(filter(None, map(shutil.which, names)), None)
    if path is None:
        raise RuntimeError(f"the report's page is tested in a browser, and {names[0]} is not here: "
                           "sh tests/install_tools.sh installs it")
    return path


@contextmanager
def chromium(*arguments: str) -> Iterator[webdriver.Chrome]:
    """The browser, its console and network traffic logged; it draws in 3D by software, unless
    further `arguments` forbid it."""
    options = webdriver.ChromeOptions()
    options.binary_location = _command("chromium", "google-chrome", "chromium-browser")
    for argument in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
                     "--disable-background-networking", "--force-prefers-reduced-motion",
                     "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                     *arguments):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(options, Service(_command("chromedriver")))
    driver.set_script_timeout(SECONDS)
    driver.execute_cdp_cmd("Page.addScriptToEvaluateOnNewDocument", {"source": _LIGHT})
    try:
        yield driver
    finally:
        driver.quit()


def resize(driver: webdriver.Chrome, width: int, height: int, phone: bool = False) -> None:
    """Give the page a window of this size in CSS pixels, optionally a phone's."""
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {
        "width": width, "height": height, "deviceScaleFactor": 3 if phone else 1, "mobile": phone})
