"""`coscrew sweep` and `opened` on folders whose files were damaged: flipped bits, cut off, emptied,
deleted, exchanged.  Nothing of it is read as numbers; the same command makes the parts again."""

import errno
import os
import re
import shutil
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import numpy as np
import pandas
import pyarrow.parquet
import pytest
from distributed import LocalCluster

from coscrew_codegen.__main__ import main
from coscrew_codegen.simulation.sweep import SweepError, chunk, opened
from coscrew_codegen.simulation.sweep.files import part, quarantine
from coscrew_codegen.simulation.sweep.files.folder import Folder
from coscrew_codegen.simulation.sweep.files.part import DamagedError
from tests.support.scenes.sweeps import SLIDER, prepared
from tests.support.sweeping import VARIED, after, processes, sweep, table

pytestmark = pytest.mark.usefixtures("small_chunks")


@pytest.fixture(scope="module")
def workers() -> Iterator[LocalCluster]:
    with processes(1) as result:
        yield result


@pytest.fixture(scope="module")
def whole(scene, workers, tmp_path_factory) -> Path:
    out = tmp_path_factory.mktemp("sweeps") / "whole"
    assert finished(scene, out, workers) == 0
    return out


def finished(scene: Path, out: Path, workers: LocalCluster, *more: str) -> int:
    """The status of the command with its arrays, tables and page."""
    return main(["sweep", str(scene), *VARIED, "--scheduler", workers.scheduler_address, "--out",
                 str(out), *more])


@pytest.fixture
def copied(whole, tmp_path) -> Path:
    shutil.copytree(whole, tmp_path / "out")
    return tmp_path / "out"


def flip(path: Path, bit: int) -> None:
    content = bytearray(path.read_bytes())
    content[bit // 8] ^= 1 << bit % 8
    path.write_bytes(content)


def cut(path: Path, length: int) -> None:
    path.write_bytes(path.read_bytes()[:length])


def test_a_bit_flipped_anywhere_in_a_part_is_found(tmp_path):
    """In every byte, one bit: of numbers, statistics, names, the checksum and its name."""
    its = prepared(tmp_path, SLIDER, ("block.mass=1:7:3",))
    specification, path = its.specification, tmp_path / "part.parquet"
    content = chunk.computed(chunk.Job.of(its.kernels, specification), 0).content
    path.write_bytes(content)
    part.check(path, specification, 0)
    assert len(content) > 5000
    silent = []
    for place in range(len(content)):
        changed = bytearray(content)
        changed[place] ^= 1 << place % 8
        path.write_bytes(changed)
        try:
            part.read(path)
        except DamagedError as error:
            assert str(error).startswith(f"{path}: ")
        else:
            silent.append(place)
    assert not silent
    for length in {*range(0, len(content), 97), 1, 3, 4, 8, len(content) - 1}:
        path.write_bytes(content[:length])
        with pytest.raises(DamagedError, match="is empty|is cut off"):
            part.read_metadata(path)


def test_statistics_and_tables_of_a_part_are_those_that_were_written(tmp_path):
    its = prepared(tmp_path, SLIDER, ("block.mass=1:7:3",))
    path = tmp_path / "part.parquet"
    path.write_bytes(chunk.computed(chunk.Job.of(its.kernels, its.specification), 0).content)
    assert part.read(path).equals(pyarrow.parquet.read_table(path))
    assert part.read_metadata(path).equals(pyarrow.parquet.read_metadata(path))
    assert part.SEAL.encode() in pyarrow.parquet.read_metadata(path).metadata


def without_checksum(path: Path) -> None:
    """Removes the checksum, as in a file of an older version."""
    pyarrow.parquet.write_table(pyarrow.parquet.read_table(path), path)


def another(path: Path) -> None:
    """The next part in its place."""
    shutil.copy(path.with_name(f"part-{int(path.stem[-8:]) + 1:08d}.parquet"), path)


def replaced(path: Path) -> None:
    path.unlink()
    path.mkdir()


def queue(path: Path) -> None:
    """One whose reader would wait for ever."""
    path.unlink()
    os.mkfifo(path)


def loop(path: Path) -> None:
    path.unlink()
    path.symlink_to(path.name)


@pytest.mark.parametrize(("damage", "why"), (
    (partial(flip, bit=8 * 3000), "differs from its checksum"),
    (partial(cut, length=2000), "is cut off or overwritten (2000 bytes)"),
    (partial(cut, length=0), "is empty"),
    (without_checksum, "has no checksum (coscrew.sha256), as parts of older versions"),
    (another, "holds the members of another part"),
    (replaced, "is no file"), (queue, "is no file"), (loop, "cannot be read: "),
    (Path.unlink, "")), ids=("flipped", "cut", "empty", "old", "another", "folder", "queue", "loop",
                             "gone"))
def test_a_damaged_part_is_named_set_aside_and_made_again(damage: Callable[[Path], None], why,
                                                          scene, workers, whole, copied, capsys):
    path = copied / "members" / "part-00000004.parquet"
    damage(path)
    assert sweep(scene, copied, workers) == 0
    output = capsys.readouterr().err
    assert f"600 members, {600 - 64} of them written" in output
    assert (f"coscrew: {path}: {why}" in output) is bool(why)
    assert ("set aside as damaged/part-00000004.parquet, made again" in output) is bool(why)
    assert os.path.lexists(copied / "damaged" / path.name) is bool(why)
    assert table(copied).equals(table(whole))


def test_parts_damaged_in_the_middle_of_a_run_are_made_again(scene, workers, whole, tmp_path,
                                                             capsys):
    out = tmp_path / "out"

    def damage() -> None:
        first, second, third, *_ = sorted((out / "members").iterdir())
        flip(first, 8 * 2500 + 3)
        cut(second, 1000)
        third.unlink()

    with after(5, damage):
        assert finished(scene, out, workers) == 0
    output = capsys.readouterr().err
    assert output.count("made again") == 3 and "Traceback" not in output
    for why in ("differs from its checksum; set aside", "is cut off or overwritten", "is gone; "):
        assert why in output
    assert len(list((out / "damaged").iterdir())) == 2
    assert table(out).equals(table(whole))
    assert opened(out).load().equals(opened(whole).load())


def renamed(members: Path) -> None:
    (members / "part-00000000.parquet").rename(members / "part-000000000.parquet")


def one_more(members: Path) -> None:
    shutil.copy(members / "part-00000001.parquet", members / "part-00000099.parquet")


def notes(members: Path) -> None:
    (members / "notes.txt").write_text("of a person")


def a_sweep_within(members: Path) -> None:
    shutil.copytree(members, members / "members")


@pytest.mark.parametrize(("change", "name", "gone"), (
    (renamed, "part-000000000.parquet", 64), (one_more, "part-00000099.parquet", 0),
    (notes, "notes.txt", 0), (a_sweep_within, "members", 0)),
    ids=("renamed", "more", "notes", "within"))
def test_what_is_no_part_is_told_and_set_aside(change: Callable[[Path], None], name, gone, scene,
                                               workers, whole, copied, capsys):
    """Programs would read it with the parts."""
    change(copied / "members")
    for unread in ("_unread", ".hidden"):
        (copied / "members" / unread).touch()
    assert sweep(scene, copied, workers) == 0
    output = capsys.readouterr().err
    assert (f"coscrew: {copied / 'members' / name}: is no part of this sweep; set aside as "
            f"damaged/{name}\n") in output
    assert f"600 members, {600 - gone} of them written" in output
    assert (copied / "damaged" / name).exists()
    assert pandas.read_parquet(copied / "members").equals(pandas.read_parquet(whole / "members"))
    assert {x.name for x in (copied / "members").iterdir()} == {
        "_unread", ".hidden", *(x.name for x in (whole / "members").iterdir())}


def test_what_is_spoilt_in_the_middle_of_a_run_is_told_and_made_again(scene, workers, whole,
                                                                      tmp_path, capsys):
    out = tmp_path / "out"

    def spoil() -> None:
        flip(out / "sweep.json", 8 * 700)
        one_more(out / "members")

    with after(5, spoil):
        assert finished(scene, out, workers) == 0
    output = capsys.readouterr().err
    assert re.search(r"sweep.json: (differs from|has no|cannot be read).*; set aside as "
                     "damaged/sweep.json, written again", output)
    assert "part-00000099.parquet: is no part of this sweep; set aside as damaged/part-" in output
    assert (out / "sweep.json").read_bytes() == (whole / "sweep.json").read_bytes()
    assert opened(out).load().equals(opened(whole).load()) and table(out).equals(table(whole))


@pytest.mark.parametrize("spoil", (Path.unlink, replaced, partial(cut, length=50)),
                         ids=("gone", "folder", "cut"))
def test_a_description_is_written_again_at_the_end_of_a_run(spoil: Callable[[Path], None], scene,
                                                            workers, whole, tmp_path, capsys):
    out = tmp_path / "out"
    with after(9, lambda: spoil(out / "sweep.json")):
        assert sweep(scene, out, workers) == 0
    assert capsys.readouterr().err.rstrip().endswith("written again")
    assert (out / "sweep.json").read_bytes() == (whole / "sweep.json").read_bytes()


def test_what_stands_in_the_way_is_set_aside(scene, workers, whole, copied, capsys):
    """Folders in place of files, files in place of folders; what killed processes leave is
    removed."""
    for name in ("sweep.zarr.sha256", "summary.html", ".lock"):
        replaced(copied / name)
    for name in ("sweep.zarr", "members"):
        shutil.rmtree(copied / name)
        (copied / name).write_text("in the way")
    left = copied / ".sweep.zarr.part"
    left.mkdir()
    assert finished(scene, copied, workers) == 0
    output = capsys.readouterr().err
    for name in ("sweep.zarr.sha256", "summary.html", ".lock"):
        assert (f"coscrew: {copied / name}: is no file; set aside as damaged/{name}, made again\n"
                ) in output
    for name in ("sweep.zarr", "members"):
        assert f"{copied / name}: is no folder; set aside as damaged/{name}, made again\n" in output
        assert (copied / "damaged" / name).read_text() == "in the way"
    assert not left.exists() and "Traceback" not in output
    assert opened(copied).load().equals(opened(whole).load())
    assert (copied / "summary.html").read_bytes() == (whole / "summary.html").read_bytes()


def forbid(monkeypatch: pytest.MonkeyPatch, path: Path) -> None:
    """Makes this file unreadable, although root, who may run the tests, can read any file."""
    read_bytes = Path.read_bytes

    def forbidden(self: Path) -> bytes:
        if self == path:
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(path))
        return read_bytes(self)

    monkeypatch.setattr(Path, "read_bytes", forbidden)


@pytest.mark.parametrize("name", ("members/part-00000004.parquet", "sweep.json"))
def test_a_person_is_told_what_cannot_be_read(name, scene, workers, copied, monkeypatch, capsys):
    with monkeypatch.context() as patch:
        forbid(patch, copied / name)
        assert sweep(scene, copied, workers) == 2
    output = capsys.readouterr().err
    assert output.endswith(f"coscrew: {copied / name}: cannot be read: Permission denied; make it "
                           "readable, or remove it, and the command that made the sweep makes it "
                           "again\n")
    assert "cannot write" not in output and not (copied / "damaged").exists()
    assert sweep(scene, copied, workers) == 0


@pytest.mark.parametrize("name", ("sweep.json", "sweep.zarr.sha256", "sweep.zarr/zarr.json",
                                  "sweep.zarr/q.slide.final/c/0", "members/part-00000004.parquet"))
def test_what_cannot_be_read_is_not_opened(name, whole, monkeypatch):
    forbid(monkeypatch, whole / name)
    with pytest.raises(SweepError, match="cannot be read: Permission denied; make it readable") as (
            caught):
        opened(whole).load()
    assert str(caught.value).startswith(f"{whole / name}: ")


def test_a_person_is_told_what_cannot_be_set_aside(scene, workers, whole, copied, monkeypatch,
                                                   capsys):
    path, damaged = copied / "members" / "part-00000004.parquet", copied / "damaged"
    cut(path, 0)
    damaged.write_text("of a person")
    assert sweep(scene, copied, workers) == 2
    output = capsys.readouterr().err
    assert output.endswith(f"coscrew: {path}: is empty, and cannot be set aside: {damaged} is no "
                           f"folder; rename or remove {damaged}, and give the same command again\n")
    assert damaged.read_text() == "of a person"
    damaged.unlink()

    def refused(*_: object) -> None:
        raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

    with monkeypatch.context() as patch:
        patch.setattr(quarantine.os, "replace", refused)
        assert sweep(scene, copied, workers) == 2
    output = capsys.readouterr().err
    assert output.endswith(f"is empty, and cannot be moved into {damaged}: Permission denied; move "
                           "or remove it, and give the same command again\n")
    assert sweep(scene, copied, workers) == 0
    assert table(copied).equals(table(whole))


def test_a_disk_that_damages_what_is_written_ends_the_command(scene, workers, tmp_path, monkeypatch,
                                                              capsys):
    write = Folder.write

    def spoilt(self: Folder, number: int, content: bytes) -> None:
        write(self, number, content)
        cut(self.of(number), 100)

    monkeypatch.setattr(Folder, "write", spoilt)
    assert finished(scene, tmp_path / "out", workers) == 2
    output = capsys.readouterr().err.splitlines()[-1]
    assert re.search(r"part-\d{8}\.parquet: is cut off or overwritten \(100 bytes\), again and "
                     r"again; is the disk in order\?", output)


def test_no_damaged_file_is_opened_as_numbers(whole, tmp_path):
    """Some bits of each file that `opened` reads; numbers only where the file says the same."""
    wanted, rng = opened(whole).load(), np.random.default_rng(1)
    files = [x.relative_to(whole) for x in sorted(whole.rglob("*"))
             if x.is_file() and x.name not in (".lock", "summary.html")]
    assert len(files) >= 40
    out = tmp_path / "out"
    shutil.copytree(whole, out)
    for file in files:
        content = (out / file).read_bytes()
        for bit in (*rng.integers(8 * len(content), size=2), None):
            if bit is None:
                os.truncate(out / file, len(content) // 2)
            else:
                flip(out / file, int(bit))
            try:
                assert opened(out).load().identical(wanted), file
            except DamagedError as error:
                assert str(error).startswith(str(out))
            (out / file).write_bytes(content)
        (out / file).unlink()
        with pytest.raises(DamagedError, match="is gone"):
            opened(out).load()
        (out / file).write_bytes(content)
    assert opened(out).load().equals(wanted)


def test_the_same_command_mends_what_is_opened(scene, workers, whole, copied, capsys):
    flip(copied / "sweep.json", 8 * 700)
    flip(copied / "sweep.zarr" / "q.slide.final" / "c" / "0", 8 * 40)
    with pytest.raises(DamagedError, match="sweep.json: (differs|has no|cannot)"):
        opened(copied)
    assert finished(scene, copied, workers) == 0
    assert "sweep.json: " in capsys.readouterr().err
    assert opened(copied).load().identical(opened(whole).load())
    assert (copied / "sweep.json").read_bytes() == (whole / "sweep.json").read_bytes()


def test_a_damaged_description_hides_no_other_sweep(scene, workers, copied, capsys):
    (copied / "sweep.json").unlink()
    words = [str(scene), *VARIED[:-1], "201", "--scheduler", workers.scheduler_address]
    assert main(["sweep", *words, "--out", str(copied)]) == 2
    output = capsys.readouterr().err
    assert "sweep.json: is gone; the parts beside it are of another sweep" in output
    assert finished(scene, copied, workers) == 0


def test_a_folder_of_which_nothing_is_whole_is_refused(scene, workers, copied, capsys):
    (copied / "sweep.json").write_text("{")
    for path in (copied / "members").iterdir():
        cut(path, 0)
    before = sorted((x, x.stat().st_size) for x in copied.rglob("*"))
    assert sweep(scene, copied, workers) == 2
    output = capsys.readouterr().err
    assert "no part beside it is undamaged" in output and "take another --out" in output
    assert sorted((x, x.stat().st_size) for x in copied.rglob("*")) == before
