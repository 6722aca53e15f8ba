"""The player of the playback page: what is committed is what its sources in web/ make."""

import hashlib
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
WEB, VIEW = ROOT / "web", ROOT / "templates/view"
PACKAGE = json.loads((WEB / "package.json").read_text(encoding="utf-8"))
needs_npm = pytest.mark.skipif(
    shutil.which("node") is None or not (WEB / "node_modules/esbuild").is_dir(),
    reason="needs node and `npm ci` in web/")
HIGHEST = 300  # lines of a module
WIDEST = 100


def test_the_player_is_built_from_its_sources():
    """Its first line has their hash; `make web` builds it anew."""
    sources = [WEB / "build.mjs", WEB / "package-lock.json", *sorted((WEB / "src").iterdir())]
    digest = hashlib.sha256(b"".join(x.read_bytes() for x in sources)).hexdigest()
    with (VIEW / "player.min.js").open(encoding="utf-8") as file:
        assert file.readline() == f"// sources {digest}\n", "make web"


@needs_npm
def test_building_again_gives_the_same_bytes(tmp_path):
    subprocess.run(["node", WEB / "build.mjs", tmp_path], check=True)
    for name in ("player.min.js", "LICENSES.txt"):
        assert (tmp_path / name).read_bytes() == (VIEW / name).read_bytes(), "make web"


@needs_npm
def test_modules_do_what_they_say():
    done = subprocess.run(["node", "--test", "test/"], cwd=WEB, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert re.search(r"^# pass [1-9]", done.stdout, re.M)


def test_versions_are_fixed():
    """In package.json to the digit, and in its lock."""
    lock = json.loads((WEB / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    for name, version in (PACKAGE["dependencies"] | PACKAGE["devDependencies"]).items():
        assert re.fullmatch(r"[\d.]+", version)
        assert lock[f"node_modules/{name}"]["version"] == version
        assert lock[f"node_modules/{name}"]["integrity"].startswith("sha512-")


def test_the_licence_of_each_library_is_beside_the_player():
    texts = (VIEW / "LICENSES.txt").read_text(encoding="utf-8")
    for name, version in PACKAGE["dependencies"].items():
        assert f"{name} {version}\n" in texts
    assert texts.count("Permission is hereby granted, free of charge") == len(
        PACKAGE["dependencies"])


def test_modules_are_short_and_their_lines_too():
    for path in (*WEB.glob("*.mjs"), *(WEB / "src").iterdir(), VIEW / "load.js"):
        lines = path.read_text(encoding="utf-8").splitlines()
        assert len(lines) <= HIGHEST, path
        assert [x for x in lines if len(x) > WIDEST] == [], path


def test_each_module_is_used():
    """Every module but the first is imported by another."""
    modules = {x.name: x.read_text(encoding="utf-8") for x in (WEB / "src").iterdir()}
    used = {x for text in modules.values() for x in re.findall(r'from "\./(\w+\.js)"', text)}
    assert used == set(modules) - {"player.js"}
