"""Honest archives are opened as they are."""

from __future__ import annotations

import stat
import tarfile
import zipfile
from pathlib import Path

import pytest

from course.errors import StorageError
from course.home.opening import Refused, archive_stem, is_archive, open_archive
from tests.home.opening.archives import LINK, contents, entry, make_tar, make_zip


@pytest.fixture
def out(tmp_path: Path) -> Path:
    return tmp_path / "out"


def test_a_zip(tmp_path: Path, out: Path) -> None:
    modes = {"b/run.sh": stat.S_IFREG | 0o4711}
    archive = make_zip(tmp_path / "work.zip", {"a.txt": "a", "b/": "", "b/run.sh": "b"}, modes)
    assert open_archive(archive, out) == ()
    assert contents(out) == {"a.txt": "a", "b/run.sh": "b"}
    assert stat.S_IMODE((out / "a.txt").stat().st_mode) == 0o644
    assert stat.S_IMODE((out / "b/run.sh").stat().st_mode) == 0o755  # and no setuid


@pytest.mark.parametrize("kind", ["", ":gz", ":bz2", ":xz"])
def test_a_tar(tmp_path: Path, out: Path, kind: str) -> None:
    files = [
        entry("./", kind=tarfile.DIRTYPE),
        entry("./a.txt", b"a"),
        entry("./empty"),
        entry("b/c", b"c" * 512),
    ]
    files += [entry("program", b"p", mode=0o6755), entry("last", b"l" * 200_000)]
    archive = make_tar(tmp_path / "work.tar", *files, mode=f"w{kind}")
    assert open_archive(archive, out) == ()
    expected = {"a.txt": "a", "empty": "", "b/c": "c" * 512, "program": "p", "last": "l" * 200_000}
    assert contents(out) == expected
    assert stat.S_IMODE((out / "program").stat().st_mode) == 0o755


def test_the_content_counts_not_the_ending(tmp_path: Path, out: Path) -> None:
    open_archive(make_tar(tmp_path / "work.zip", entry("a", b"a"), mode="w:gz"), out)
    assert contents(out) == {"a": "a"}


@pytest.mark.parametrize("format", [tarfile.PAX_FORMAT, tarfile.GNU_FORMAT])
def test_long_names_in_tars(tmp_path: Path, out: Path, format: int) -> None:
    name = "/".join(["a_rather_long_folder_name"] * 10) + "/ünï.py"
    with tarfile.open(tmp_path / "work.tar", "w", format=format) as archive:
        archive.addfile(entry(name)[0])
    assert open_archive(tmp_path / "work.tar", out) == ()
    assert list(contents(out)) == [name]


def test_links_that_stay_inside_are_kept(tmp_path: Path, out: Path) -> None:
    archive = make_zip(tmp_path / "work.zip", {"a/link": "../b/real", "b/real": "r"}, {"a/link": LINK})
    assert open_archive(archive, out) == ()
    assert contents(out) == {"a/link": "-> ../b/real", "b/real": "r"}


def test_hard_links_become_files(tmp_path: Path, out: Path) -> None:
    archive = make_tar(tmp_path / "w.tar", entry("a", b"a"), entry("b", kind=tarfile.LNKTYPE, target="a"))
    assert open_archive(archive, out) == ()
    assert contents(out) == {"a": "a", "b": "a"}
    assert (out / "b").stat().st_nlink == 1


def test_backslashes_are_slashes_and_utf8_needs_no_mark(tmp_path: Path, out: Path) -> None:
    archive = make_zip(tmp_path / "work.zip", {"ws\\src\\a.py": "", "J\u00fcrgen.py": ""})
    data = bytearray(archive.read_bytes())
    for start in (b"PK\x03\x04", b"PK\x01\x02"):  # take away the mark that says UTF-8
        at = data.rfind(start)
        data[at + (6 if start[2] == 3 else 8) + 1] &= ~0x08 & 0xFF
    archive.write_bytes(data)
    assert not zipfile.ZipFile(archive).infolist()[1].flag_bits & 0x800
    open_archive(archive, out)
    assert set(contents(out)) == {"ws/src/a.py", "Jürgen.py"}


def test_zip64(tmp_path: Path, out: Path) -> None:
    with (
        zipfile.ZipFile(tmp_path / "w.zip", "w") as archive,
        archive.open("a", "w", force_zip64=True) as file,
    ):
        file.write(b"a")
    assert open_archive(tmp_path / "w.zip", out) == ()
    assert contents(out) == {"a": "a"}


def test_a_full_folder_is_left_alone(tmp_path: Path, out: Path) -> None:
    out.mkdir()
    (out / "mine").write_text("mine")
    with pytest.raises(StorageError, match=r"w\.zip cannot be opened"):
        open_archive(make_zip(tmp_path / "w.zip", {"a": "a"}), out)
    assert contents(out) == {"mine": "mine"}
    assert {path.name for path in tmp_path.iterdir()} == {"out", "w.zip"}


def test_an_interrupted_opening_leaves_nothing_and_what_was_killed_is_swept(
    tmp_path: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    archive = make_zip(tmp_path / "w.zip", {"a": "a"})
    (tmp_path / ".out.99999999-77aa.ros2course-part/b").mkdir(parents=True)

    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr("course.home.opening.findings.Meter.data", interrupt)
        with pytest.raises(KeyboardInterrupt):
            open_archive(archive, out)
    assert [path.name for path in tmp_path.iterdir()] == ["w.zip"]


@pytest.mark.parametrize(
    ("content", "says"),
    [(b"", "empty"), (b"Rar!\x1a\x07", "not a zip or a tar"), (b"PK\3\4 and nonsense", "broken")],
)
def test_what_is_no_archive(tmp_path: Path, out: Path, content: bytes, says: str) -> None:
    (tmp_path / "w.zip").write_bytes(content)
    with pytest.raises(Refused, match=says):
        open_archive(tmp_path / "w.zip", out)
    assert not out.exists()


def test_endings() -> None:
    names = ["a.zip", "a.ZIP", "a.tar.gz", "a.tgz", "a.tar.xz", "a.tar.bz2", "a.tar", "a.b.zip", "a.rar"]
    assert all(map(is_archive, names))
    assert [archive_stem(name) for name in names] == ["a"] * 7 + ["a.b", "a.rar"]
    assert not any(map(is_archive, ["a", "zip", "a.py", "a.docx"]))
