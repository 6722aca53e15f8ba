"""README and docs/ are true: snippets run and print what they say, commands and links exist."""

import importlib.util
import json
import re
import shlex
import shutil
import subprocess
import sys
import tomllib
from pathlib import Path

import jsonschema
import pytest
from PIL import Image, ImageChops

from coscrew_codegen.__main__ import main
from coscrew_codegen.runtime.extras import COMMANDS
from coscrew_codegen.simulation.check.error_limits import ALLOWED, ENERGY, FROZEN, KEPT, STRICTLY
from coscrew_codegen.simulation.check.motion_error import REST

ROOT = Path(__file__).parents[2]
README = ROOT / "README.md"
CONTRIBUTING = ROOT / "CONTRIBUTING.md"  # whose snippets are the walks of support/walks.py
WRITTEN = (README, CONTRIBUTING, *sorted((ROOT / "docs").glob("*.md")))
TEXTS = {path.relative_to(ROOT).as_posix(): path.read_text(encoding="utf-8") for path in WRITTEN}
SWEEPS = "docs/sweeps.md"  # whose snippets belong together
GUIDES = {name: text for name, text in TEXTS.items() if name != CONTRIBUTING.name}


def snippets(language: str, holding: str = "") -> list:
    results = [pytest.param(snippet, id=f"{name}-{number}") for name, text in GUIDES.items()
               for number, snippet in enumerate(re.findall(rf"```{language}\n(.*?)```", text,
                                                           re.DOTALL))
               if holding in snippet and (language, name) != ("python", SWEEPS)]
    assert results
    return results


def test_the_readme_is_a_first_screen():
    lines = TEXTS["README.md"].splitlines()
    assert len(lines) <= 200
    assert {language for language in ("c", "python", "toml", "sh")
            if f"```{language}" not in lines} == set()
    assert (ROOT / "examples/arm6.gif").stat().st_size < 500_000


def test_lines_are_short():
    """Except for rows of tables."""
    changes = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    for name, text in {**TEXTS, "CHANGELOG.md": changes}.items():
        long = [line for line in text.splitlines() if len(line) > 120 and line[0] != "|"]
        assert not long, f"{name}: {long[0]}"


def test_each_guide_has_its_snippet():
    """A guide without a snippet has nothing to test; it fails here."""
    results = {name: text.count("```python\n") for name, text in GUIDES.items()}
    assert {name for name, count in results.items() if count} == {
        "README.md", "docs/accuracy.md", "docs/arrays.md", "docs/derivatives.md",
        "docs/from_mujoco.md", "docs/from_pinocchio.md", "docs/models.md", "docs/python.md",
        "docs/scenes.md",
        "docs/urdf.md", SWEEPS}


@pytest.mark.parametrize("snippet", snippets("python"))
def test_python_snippets_print_what_their_comments_say(snippet, tmp_path):
    done = subprocess.run([sys.executable, "-c", snippet], cwd=tmp_path, text=True,
                          capture_output=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines() == re.findall(r"^# (.*)$", snippet, re.MULTILINE)


def test_the_guide_to_sweeps_runs(tmp_path, monkeypatch, capsys):
    """Its scene, its commands, what reads their results, and what one of them prints."""
    (scene,), (commands, alone), (printed, reading) = (re.findall(
        rf"```{x}\n(.*?)```", TEXTS[SWEEPS], re.DOTALL) for x in ("toml", "sh", "python"))
    monkeypatch.chdir(tmp_path)
    Path("swing.toml").write_text(scene)
    for line in (*commands.splitlines(), *alone.splitlines()):
        capsys.readouterr()
        assert main([*shlex.split(line)[1:], "--workers", "1"]) == 0
    assert capsys.readouterr().out.startswith(printed.partition("\nprint")[0])
    for snippet in (printed, reading):
        test_python_snippets_print_what_their_comments_say(snippet, tmp_path)


def firmware(folder: Path) -> Path:
    """Generates the scene in docs/c.md."""
    (scene,) = re.findall(r"```toml\n(.*?)```", TEXTS["docs/c.md"], re.DOTALL)
    (folder / "swing.toml").write_text(scene)
    assert main(["generate", str(folder / "swing.toml"), "--many", "-o",
                 str(folder / "firmware")]) == 0
    return folder / "firmware"


@pytest.mark.parametrize("snippet, sources", (
    *((x.values[0], ["swingf.c"]) for x in snippets("c", '"swing.h"')),
    *((x.values[0], ["swing.c", "swing_many.c"]) for x in snippets("c", '"swing_many.h"'))))
def test_c_snippets_of_scenes_print_what_their_comments_say(snippet, sources, tmp_path):
    """The scene stands above in the same guide."""
    firmware(tmp_path)
    (tmp_path / "program.c").write_text(snippet)
    subprocess.run(["cc", "-std=c11", "-Wall", "-Wextra", "-Wdouble-promotion", "-Werror",
                    "-I", "firmware", "program.c", *(f"firmware/{x}" for x in sources), "-o",
                    "program", "-lm"],
                   cwd=tmp_path, check=True)
    done = subprocess.run([str(tmp_path / "program")], text=True, capture_output=True, check=True)
    assert done.stdout.splitlines() == re.findall(r"/\* (.*?) \*/", snippet)


def test_allowed_errors_of_motions_are_told_as_they_are():
    messages = " ".join(TEXTS["docs/scenes.md"].partition("## Runs with a wrong motion")[2].split())
    for words, number in (
            ("since the start; allowed is {};", ALLOWED), ("velocity makes ({} of it)", FROZEN),
            ("changes by {} of the largest kinetic", KEPT), ("by {} of the largest vel", KEPT),
            ("off by more than {} of the way it moves", ALLOWED), ("`--strict` {})", STRICTLY),
            ("energies do not balance within {} with", ENERGY), ("shorter than {} rad", REST)):
        assert words.format(f"{number:g}") in messages, words


def test_functions_of_scenes_are_described_as_in_their_header(tmp_path):
    """By the same words, and all that are generated by default."""
    header = (firmware(tmp_path) / "swing.h").read_text(encoding="utf-8")
    page = (ROOT / "generated/docs/functions.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `([a-z_]+)` \| (.*?) \| (.*) \| (by default.*) \|$", page, re.MULTILINE)
    declared = re.findall(r"^void swing_([a-z_]+)\(", header, re.MULTILINE)
    needed = [name for name, _, _, when in rows if when.partition(", for up")[0] == "by default"]
    assert len(needed) > 10 and {*needed} <= {*declared}
    for name, takes, words, _ in rows:
        if name in declared:
            above, head = re.search(rf"/\* ([^/]*) \*/\nvoid swing_{name}\((.*?)\);", header,
                                    re.DOTALL).groups()
            assert " ".join(above.split()).startswith(re.sub(r"\\(.)", r"\1", words)), name
            given = re.findall(r"(\w+)(?:\[\w*\])*(?:,|$)", head)
            assert [x for x in re.findall(r"`(\w+)`", takes) if x in given] == given[:-1], name


@pytest.mark.parametrize("snippet", snippets("c", "ksl/coscrew.h"))
@pytest.mark.parametrize("include", ("generated/c/include", "amalgamation"))
def test_c_snippets_compile_and_run(snippet, include, tmp_path):
    if include == "amalgamation":
        shutil.copy(ROOT / "generated/c/coscrew.h", tmp_path)
        snippet, folder = snippet.replace("ksl/coscrew.h", "coscrew.h"), tmp_path
    else:
        folder = ROOT / include
    (tmp_path / "program.c").write_text(snippet)
    subprocess.run(["cc", "-std=c11", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror", "-I",
                    str(folder), "program.c", "-o", "program", "-lm"], cwd=tmp_path, check=True)
    done = subprocess.run([str(tmp_path / "program")], text=True, capture_output=True, check=True)
    assert done.stdout == "0 10 0; 0 0 7\n3\n"


@pytest.mark.parametrize("snippet", snippets("toml"))
def test_scenes_in_snippets_are_of_the_schema(snippet):
    schema = json.loads((ROOT / "generated/docs/scene.schema.json").read_text(encoding="utf-8"))
    jsonschema.validate(tomllib.loads(snippet), schema)


def test_the_scene_of_the_readme_runs_as_it_stands(tmp_path, capsys):
    (scene,) = re.findall(r"```toml\n(.*?)```", TEXTS["README.md"], re.DOTALL)
    (tmp_path / "arm.toml").write_text(scene, encoding="utf-8")
    assert main(["simulate", str(tmp_path / "arm.toml")]) == 0
    assert "q.elbow" in capsys.readouterr().out
    assert main(["check", str(tmp_path / "arm.toml")]) == 0


def test_shell_snippets_run(tmp_path, monkeypatch, capsys):
    """Commands that make everything run for one family; test_generate.py runs them whole."""
    others = "".join(text for name, text in TEXTS.items() if name != SWEEPS)
    blocks = re.findall(r"```sh\n(.*?)```", others, re.DOTALL)
    commands = [line.split("#")[0].split() for block in blocks for line in block.splitlines()]
    ours = [words[1:] for words in commands if words[0] == "coscrew"]
    assert len(ours) == 8
    shutil.copytree(ROOT / "examples/scenes", tmp_path / "examples/scenes")
    shutil.copytree(ROOT / "generated", tmp_path / "generated",
                    ignore=shutil.ignore_patterns("*.so", "__pycache__"))
    monkeypatch.chdir(tmp_path)
    for words in ours:
        whole = words[0] == "generate" and not any(x.endswith(".toml") or x == "--family"
                                                   for x in words)
        assert main([*words, *(("--family", "vec3") if whole else ())]) == 0, capsys.readouterr()
    for name in ("coscrew_accurate.h", "coscrew_certified.h", "include/ksl/ksl_many.h"):
        assert (tmp_path / "vendor/c" / name).exists()
    assert (tmp_path / "firmware/ksl/c/include/ksl/coscrew.h").exists()
    assert (tmp_path / "build/pendulum/pendulum.c").exists()
    assert {words[0] for words in commands} == {"coscrew", "make"}


def test_targets_of_make_exist():
    makefile = (ROOT / "Makefile").read_text()
    named = set(re.findall(r"(?:`|^)make(?: ([a-z-]+))?(?:`| +#|$)", "\n".join(TEXTS.values()),
                           re.MULTILINE))
    assert {"", "test", "docs", "report", "bench", "attack"} <= named
    for target in named:
        assert re.search(rf"^{target or 'all'}:", makefile, re.MULTILINE), target


def test_every_command_is_told_of():
    for command in COMMANDS:
        assert f"`coscrew {command}" in "".join(TEXTS.values()), \
            f"say in docs/scenes.md or another guide what `coscrew {command}` does"


def test_modules_named_exist():
    named = {name for text in TEXTS.values()
             for name in re.findall(r"python -m (tests[\w.]*\w)", text)}
    assert {"tests.search", "tests.benchmarks.dynamics", "tests.benchmarks.accuracy"} <= named
    for name in named:
        assert importlib.util.find_spec(name), name


def test_paths_named_exist():
    for name, text in TEXTS.items():
        for path in re.findall(r"`((?:codegen|templates|generated|tests|examples)/[\w./]*)`", text):
            assert (ROOT / path).exists(), f"{name}: {path}"


def test_the_continuous_integration_runs_the_readme_command():
    assert "make test" in (ROOT / ".ci" / "run").read_text()


def test_links_lead_somewhere():
    for name, text in TEXTS.items():
        prose = re.sub(r"```.*?```", "", text, flags=re.DOTALL)
        for target in re.findall(r"(?<!\\)\[[^\[\]]*\]\(([^)#]+)(?:#[\w-]+)?\)", prose):
            assert ((ROOT / name).parent / target).exists(), f"{name}: {target}"


def test_every_guide_is_reached_from_the_readme():
    for path in WRITTEN[1:]:
        assert f"]({path.relative_to(ROOT).as_posix()}" in TEXTS["README.md"], path.name


def test_the_picture_is_made_by_its_command(tmp_path):
    """Tried with a scene that is shorter and quicker to derive."""
    command = re.search(r"`python (examples/playback.py) (\S+) (\S+)`", TEXTS["README.md"])
    assert (ROOT / command[2]).exists() and (ROOT / command[3]).exists()
    scene = tmp_path / "swing.toml"
    scene.write_text("[bodies]\nbob = { mass = 2, com = [0, 0, -0.5], inertia = [1, 1, 1] }\n"
                     '[joints]\npin = { type = "continuous", child = "bob", axis = [0, 1, 0] }\n'
                     "[effects.gravity]\n[start.q]\npin = 1\n")
    done = subprocess.run([sys.executable, command[1], str(scene), str(tmp_path / "motion.gif")],
                          cwd=ROOT, text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    for path in (tmp_path / "motion.gif", ROOT / command[3]):
        with Image.open(path) as image:
            assert image.n_frames >= 20
            first = image.convert("RGB")
            image.seek(10)
            assert ImageChops.difference(first, image.convert("RGB")).getbbox(), "nothing moves"


def test_the_documentation_builds_without_a_warning(tmp_path):
    done = subprocess.run([sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-c", "docs",
                           ".", str(tmp_path)], cwd=ROOT, text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    page = (tmp_path / "generated/docs/operations/exponential.html").read_text(encoding="utf-8")
    assert "<math" in page and "<script src=\"http" not in page


def test_the_citation_is_of_this_version():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    assert f"\nversion: {project['version']}\n" in (ROOT / "CITATION.cff").read_text()


def test_every_extra_named_exists():
    """In README and docs/, in messages, in the Makefile and among the extras themselves."""
    project = (ROOT / "pyproject.toml").read_text()
    extras = tomllib.loads(project)["project"]["optional-dependencies"]
    texts = [*TEXTS.values(), project, (ROOT / "Makefile").read_text(),
             *(path.read_text() for folder in ("codegen", "templates", "tests/benchmarks")
               for path in sorted((ROOT / folder).rglob("*")) if path.suffix in (".py", ".jinja"))]
    named = re.findall(r"""["'](?:\.|coscrew)\[(\w[\w,-]*)\]""", "\n".join(texts))
    each = {x for names in named for x in names.split(",")}
    assert {"codegen", "docs", "report", "test", "peers"} <= each
    for names in named:
        assert set(names.split(",")) <= set(extras), names
