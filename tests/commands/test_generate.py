"""`coscrew generate`: selections, --check, refusals, whole files, the same bytes everywhere."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from coscrew_codegen.__main__ import main
from coscrew_codegen.accuracy.tiers import TIERS
from coscrew_codegen.algebra.operations import FAMILIES
from coscrew_codegen.runtime.build import extensions

ROOT = Path(__file__).parents[2]


def contents(folder: Path) -> dict[str, bytes]:
    return {p.relative_to(folder).as_posix(): p.read_bytes()
            for p in sorted(folder.rglob("*")) if p.is_file()}


def committed() -> dict[str, bytes]:
    """The files of generated/ that git tracks: all except compiled ones."""
    return {path: data for path, data in contents(ROOT / "generated").items()
            if not path.endswith((".so", ".pyc", ".pyd"))}


def run(*arguments: str, cwd: Path = ROOT, **environment: str) -> subprocess.CompletedProcess:
    return subprocess.run([sys.executable, "-m", "coscrew_codegen", *arguments], cwd=cwd, text=True,
                          capture_output=True, env={**os.environ, **environment})


@pytest.fixture(scope="module")
def copy(tmp_path_factory) -> Path:
    """All files, generated anew into a folder with files of users and of older runs; with another
    hash seed than this process's, an ASCII locale and terminal, in another time zone."""
    base = tmp_path_factory.mktemp("everything")
    folder = strewn(base / "generated")
    done = run("generate", "--output", str(folder), PYTHONHASHSEED="4242",
               LC_ALL="POSIX", PYTHONUTF8="0", PYTHONCOERCECLOCALE="0", PYTHONIOENCODING="ascii",
               TZ="Asia/Tokyo", XDG_CACHE_HOME=str(base / "cache"))
    assert done.returncode == 0, done.stderr
    (folder / "c/include/ksl/users.h").unlink()
    return folder


def strewn(folder: Path) -> Path:
    """The folder, with a file that is no longer generated, and one that never was."""
    headers = folder / "c/include/ksl"
    headers.mkdir(parents=True, exist_ok=True)
    (headers / "old.h").write_text("/* Made by `coscrew generate`; … */\n")
    (headers / "users.h").write_text("/* not ours */\n")
    return folder


def test_regenerating_restores_what_is_committed(copy):
    """The bytes do not depend on hash seed or locale, and are all there is."""
    made, kept = contents(copy), committed()
    differ = [path for path in sorted({*made, *kept}) if made.get(path) != kept.get(path)]
    assert not differ, "generated/ is out of date: run `make generate`"


def test_check_shows_each_difference_and_the_command_that_mends_it(copy, tmp_path, capsys):
    """There is no other difference: it derives everything anew, with this process's hash seed and
    locale."""
    folder = tmp_path / "changed"
    shutil.copytree(copy, folder)
    header = strewn(folder) / "c/include/ksl/coscrew.h"
    line = "  const double co_3 = KSL_MUL(D->m13, w_2) - KSL_MUL(D->m23, w_1) + w_3,"
    assert line in header.read_text()
    header.write_text(header.read_text().replace(line, line.replace(" - ", " + ")))
    (folder / "c/include/ksl/vec3.h").unlink()
    before = contents(folder)
    assert main(["generate", "--check", "--output", str(folder)]) == 1
    captured = capsys.readouterr()
    assert f"+{line}" in captured.out
    assert "--- /dev/null\n+++ c/include/ksl/vec3.h" in captured.out
    assert "--- c/include/ksl/old.h" in captured.out and "users.h" not in captured.out
    assert f"3 files are out of date; run `coscrew generate --output {folder}`" in captured.err
    assert contents(folder) == before


def test_check_passes_on_what_is_current_and_the_command_it_names_mends_the_rest(tmp_path, capsys):
    part = ["--family", "vec3"]
    assert main(["generate", *part, "--output", str(tmp_path)]) == 0
    wanted = contents(tmp_path)
    capsys.readouterr()
    assert main(["generate", *part, "--check", "--output", str(tmp_path)]) == 0
    assert capsys.readouterr().out == f"{tmp_path}: {len(wanted)} files are current\n"
    (tmp_path / "c/include/ksl/vec3.h").write_text("changed\n")
    (tmp_path / "c/include/ksl/ksl.h").unlink()
    assert main(["generate", *part, "--check", "--output", str(tmp_path)]) == 1
    command = re.search(r"2 files are out of date; run `coscrew (.*)`", capsys.readouterr().err)[1]
    assert main(command.split(" ")) == 0
    assert contents(tmp_path) == wanted


def test_one_family_in_one_precision_and_language(tmp_path):
    assert main(["generate", "--family", "coscrew", "--precision", "single", "--language", "c",
                 "--output", str(tmp_path)]) == 0
    made = contents(tmp_path)
    tiers = ("", "_accurate", "_certified")
    headers = (*(f"{x}{tier}" for x in ("coscrew", "ksl") for tier in tiers),
               "elementary", "ksl_elementary_error", "ksl_exact", "ksl_exactf",
               "ksl_rounding", "ksl_selfcheck", "ksl_states", "ksl_types")
    assert sorted(made) == ["c/coscrew.h",
                            *(f"c/include/ksl/{name}.h" for name in sorted(headers))]
    for path, text in made.items():
        assert b"ksl_product_CoAdc(" not in text and b"ksl_coscrew_t" not in text
        assert b"ksl_screwf(" not in text
        if "accurate" not in path and "exact" not in path:
            assert b"double" not in re.sub(rb'/\*.*?\*/|#error "[^"]*"', b"", text,
                                           flags=re.DOTALL)
        assert text.startswith(
            b"/* Made by `coscrew generate --family coscrew --precision single --language c`;")


def test_options_add_files_and_change_none(tmp_path, capsys):
    """Each names in its first line the command that makes it."""
    part = ["generate", "--family", "trig", "--language", "c", "--output", str(tmp_path)]
    extra = ["--amalgamate", "certified", "accurate", "--many"]
    assert main(part) == 0
    before = contents(tmp_path)
    assert main([*part, *extra]) == 0 == main([*part, *extra, "--check"])
    after = contents(tmp_path)
    assert before.items() <= after.items()
    heads = {path: text.partition(b";")[0].decode() for path, text in after.items()
             if path not in before}
    base = "/* Made by `coscrew generate --family trig --language c"
    assert heads == {
        **{f"c/coscrew_{tier}.h": f"{base} --amalgamate {tier}`"
           for tier in ("accurate", "certified")},
        **{f"c/include/ksl/{name}.h": f"{base} --many`"
           for name in ("ksl_planes", *(f"{x}{tier}_many" for x in ("ksl", "trig")
                                        for tier in ("", "_accurate", "_certified")))}}
    capsys.readouterr()
    (tmp_path / "c/coscrew_accurate.h").unlink()
    assert main([*part, *extra, "--check"]) == 1
    assert ("run `coscrew generate --family trig --language c --amalgamate accurate certified "
            "--many") in capsys.readouterr().err


LARGEST = 12_000_000
"""Bytes that generated/ may have, as git stores them: uncompressed."""


def test_what_is_committed_is_small():
    size = sum(map(len, committed().values()))
    assert size <= LARGEST, f"generated/ has {size:,} bytes; wanted at most {LARGEST:,}"


EACH_PACKAGE = """
import sys
from pathlib import Path

for folder in map(Path, sys.argv[1:]):
    sys.path.insert(0, str(folder / "python"))
    import coscrew

    assert Path(coscrew.__file__).parent == folder / "python/coscrew" and not coscrew.COMPILED
    print(folder.name, *coscrew.__all__)
    for name in [x for x in sys.modules if x.partition(".")[0] == "coscrew"]:
        del sys.modules[name]
"""


@pytest.mark.parametrize("precision", ("double", "single"))
def test_each_family_of_the_python_package_stands_alone(precision, tmp_path):
    for family in FAMILIES:
        assert main(["generate", "--family", family, "--precision", precision, "--language",
                     "python", "--output", str(tmp_path / family)]) == 0
    done = subprocess.run([sys.executable, "-c", EACH_PACKAGE, *(tmp_path / x for x in FAMILIES)],
                          text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    output = [line.split() for line in done.stdout.splitlines()]
    assert [words[0] for words in output] == list(FAMILIES)
    assert all(precision in words for words in output)


@pytest.mark.parametrize(("arguments", "near"), [
    (["--family", "coskrew"], "did you mean 'coscrew'"),
    (["--family", "screw", "vec33"], "did you mean 'vec3'"),
    (["--precision", "float"], "did you mean"),
    (["--precision", "doubel"], "did you mean 'double'"),
    (["--language", "pyton"], "did you mean 'python'"),
    (["--amalgamate", "acurate"], "unknown tier 'acurate': did you mean 'accurate'?"),
    (["--amalgamate", "accurate", "certifed"], "did you mean 'certified'"),
    (["--many", "--language", "python"], "--many writes C, and --language python leaves it out"),
    (["--amalgamate", "accurate", "--language", "python"], "wanted --language c, or neither"),
    (["examples/scenes/pendulum.toml", "--amalgamate", "accurate"], "--amalgamate selects"),
])
def test_unknown_names_get_the_nearest_valid_one(arguments, near, tmp_path, capsys):
    assert main(["generate", *arguments, "--output", str(tmp_path / "new")]) == 2
    assert near in capsys.readouterr().err
    assert not (tmp_path / "new").exists()


def test_an_unwritable_output_is_one_clear_error(tmp_path, capsys):
    (tmp_path / "file").write_text("not a folder\n")
    assert main(["generate", "--family", "trig", "--output", str(tmp_path / "file")]) == 2
    assert "coscrew: cannot write" in capsys.readouterr().err
    assert contents(tmp_path) == {"file": b"not a folder\n"}


def test_a_run_that_cannot_finish_leaves_the_old_files_whole(tmp_path, capsys, monkeypatch):
    options = ["generate", "--family", "trig", "--output", str(tmp_path)]
    assert main(options) == 0
    (tmp_path / "c/include/ksl/trig.h").write_text("old\n")
    (tmp_path / "python/coscrew/py.typed").unlink()
    (tmp_path / "python/coscrew/py.typed").mkdir()  # in the way, and last in line
    before = contents(tmp_path)
    assert main(options) == 2
    assert "py.typed: it is a folder; nothing was changed" in capsys.readouterr().err
    assert contents(tmp_path) == before

    def interrupted(*_):
        raise KeyboardInterrupt

    (tmp_path / "python/coscrew/py.typed").rmdir()
    with monkeypatch.context() as patch:
        patch.setattr(os, "chmod", interrupted)
        assert main(options) == 130
    assert contents(tmp_path) == before


def test_templates_hold_shapes_only():
    """Lines that continue the one before do not count."""
    for path in (ROOT / "templates").rglob("*.jinja"):
        lines = [x for x in path.read_text().splitlines() if not x.lstrip().startswith("{#- #}")]
        assert len(lines) <= 80, path.name


def hand_written() -> list[Path]:
    return [path for folder in ("codegen", "examples", "templates", "tests")
            for path in sorted((ROOT / folder).rglob("*.py"))]


def templates() -> list[Path]:
    """All files in templates/ but bundles of libraries: Jinja, C, scripts and styles."""
    return [path for path in sorted((ROOT / "templates").rglob("*"))
            if path.is_file() and path.suffix != ".pyc" and not path.name.endswith(".min.js")]


def test_every_hand_written_file_is_python():
    """Benchmarks and long searches, too, which no test runs."""
    for path in hand_written():
        compile(path.read_text(encoding="utf-8"), path.name, "exec", dont_inherit=True)


def test_no_hand_written_line_is_over_100_characters():
    over = [f"{path.relative_to(ROOT)}:{number}: {len(line)} characters"
            for path in {*hand_written(), *templates()}
            for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1)
            if len(line) > 100]
    assert not over, "\n".join(sorted(over))


def test_what_is_built_is_what_is_generated():
    """Every source of an extension, also those of tiers; they are in no list."""
    made = [path for path in committed() if path.endswith(".c")]
    built = {extension.name: extension for extension in extensions(ROOT)}
    assert {source for x in built.values() for source in x.sources} == {
        f"generated/{path}" for path in made}
    assert set(built) == {f"{tier.package}._gufunc" for tier in TIERS}
    assert all((ROOT / path).is_file() for x in built.values() for path in x.depends)
