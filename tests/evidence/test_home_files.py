"""Which files of a course home are read, and which were probably meant."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from course.evidence.home_files import Home, HomeEntry, read_entries
from course.evidence.sources import MAX_FILES, Sources, read_sources


@pytest.fixture
def home(tmp_path: Path) -> Path:
    """
    .bashrc  .ros2course/home.json  notes.txt  a_folder/x.txt  a_folder/deep/y.txt  a_folder/build/z.txt
    """
    home = tmp_path / "home"
    for name in (".bashrc", ".ros2course/home.json", "notes.txt", "a_folder/x.txt", "a_folder/deep/y.txt"):
        (home / name).parent.mkdir(parents=True, exist_ok=True)
        (home / name).write_text(name)
    (home / "a_folder/build").mkdir()
    (home / "a_folder/build/z.txt").write_text("z")
    return home


def paths(home: Path, *patterns: str) -> list[str]:
    return [entry.path for entry in read_entries(home, patterns)]


@pytest.mark.parametrize(
    ("patterns", "found"),
    [
        (("*",), ["a_folder", "notes.txt"]),
        ((".*",), [".bashrc"]),
        (("*/*",), ["a_folder/build", "a_folder/deep", "a_folder/x.txt"]),
        (("a_folder",), ["a_folder", "a_folder/deep", "a_folder/x.txt", "a_folder/deep/y.txt"]),
        (("a_folder/*.txt", "a_folder/x.txt"), ["a_folder/x.txt"]),
        (("notes.txt", "*"), ["notes.txt", "a_folder"]),
        (("lost.txt", "lost/*", "notes.txt/x"), []),
        ((".ros2course", ".ros2course/*"), []),
        (("[n]otes.???",), ["notes.txt"]),
    ],
)
def test_patterns(home: Path, patterns: tuple[str, ...], found: list[str]) -> None:
    assert paths(home, *patterns) == found


def test_kinds_modes_and_sizes(home: Path) -> None:
    (home / "notes.txt").chmod(0o754)
    (home / "a_folder").chmod(0o750)
    os.mkfifo(home / "pipe")
    folder, file, pipe = read_entries(home, ("*",))
    assert (folder.kind, folder.mode) == ("folder", 0o750)
    assert file == HomeEntry("notes.txt", "file", 0o754, len("notes.txt"))
    assert pipe.kind == "other"


def test_links_that_lead_away_are_named_and_not_followed(home: Path, tmp_path: Path) -> None:
    (tmp_path / "secret").mkdir()
    (tmp_path / "secret/key.txt").write_text("secret")
    (home / "out").symlink_to(tmp_path / "secret")
    (home / "file").symlink_to(tmp_path / "secret/key.txt")
    (home / "nowhere").symlink_to("lost.txt")
    (home / "round").symlink_to(home)
    found = {entry.path: entry for entry in read_entries(home, ("*", "*/*", "out", "out/key.txt", "round"))}
    assert {name for name, entry in found.items() if entry.kind == "link"} == {
        "out",
        "file",
        "nowhere",
        "round",
    }
    assert found["nowhere"].target == "lost.txt"
    assert not [name for name in found if name.startswith(("out/", "round/"))]


def test_a_link_inside_the_home_is_what_it_leads_to(home: Path) -> None:
    (home / "way").symlink_to("a_folder/x.txt")
    (entry,) = read_entries(home, ("way",))
    assert (entry.kind, entry.target) == ("file", "a_folder/x.txt")


def test_not_without_end(home: Path) -> None:
    for number in range(3 * MAX_FILES):
        (home / f"{number}.txt").touch()
    assert len(read_entries(home, ("notes.txt", "*", "*.txt"))) <= 2 * MAX_FILES
    assert paths(home, "notes.txt", "*")[0] == "notes.txt"


def home_of(*names: str, folders: tuple[str, ...] = (), text: str = "text\n") -> Home:
    entries = [HomeEntry(name, "folder") for name in folders] + [HomeEntry(name, "file") for name in names]
    return Home.of(entries, Sources(dict.fromkeys(names, text)))


def test_a_file_and_what_is_none() -> None:
    home = home_of("a/x.txt", folders=("a",), text="one\ntwo")
    assert (home.file("a/x.txt").text, home.file("a/x.txt").lines) == ("one\ntwo", ("one", "two"))
    assert home.file("a").exists and not home.file("a").is_file
    lost = home.file("a/y.txt")
    assert (lost.exists, lost.text, lost.lines) == (False, None, ())
    assert home.inside("a") == ("x.txt",)
    assert home.inside() == ("a",)


@pytest.mark.parametrize(
    ("there", "near"),
    [
        (("empty.txt",), ("empty.txt",)),
        (("a/emtpy.txt",), ("a/emtpy.txt",)),
        (("a/Empty.txt",), ("a/Empty.txt",)),
        (("a/empty",), ("a/empty",)),
        (("a/empty.txt.txt",), ("a/empty.txt.txt",)),
        (("b/c/empty.txt", "a/empyt.txt"), ("a/empyt.txt", "b/c/empty.txt")),
        (("a/stuff.txt", "notes.txt"), ()),
        (("a/a_long_name_of_its_own.txt", "empty_.md"), ()),
        ((), ()),
    ],
)
def test_near_misses(there: tuple[str, ...], near: tuple[str, ...]) -> None:
    assert home_of(*there, folders=("a",)).near("a/empty.txt") == near


@pytest.mark.parametrize(
    ("folders", "near"),
    [
        (("A_Folder",), "A_Folder"),
        (("a-folder",), "a-folder"),
        (("b/a_folder", "b"), "b/a_folder"),
        (("b",), None),
    ],
)
def test_near_folders(folders: tuple[str, ...], near: str | None) -> None:
    assert home_of(folders=folders).near_folder("a_folder") == near


@pytest.mark.parametrize(
    ("data", "dos"),
    [
        (b"one\r\ntwo\r\n", True),
        (b"one\ntwo\n", False),
        ("häufig\n".encode(), False),
        (b"one", False),
        (b"", False),
    ],
)
def test_line_ends_of_windows(home: Path, data: bytes, dos: bool) -> None:
    (home / "notes.txt").write_bytes(data)
    found = Home.of(read_entries(home, ("notes.txt",)), read_sources(home, ("notes.txt",)))
    assert found.file("notes.txt").dos_line_ends is dos


def test_near_misses_of_longer_names() -> None:
    there = ("package/_minimalist_class.py", "package/minimalist_script.py", "test/minimalist_class_tests.py")
    home = home_of(*there)
    assert home.near("test/test_minimalist_class.py") == ("test/minimalist_class_tests.py",)
    assert home.near("package/_minimalist_class_.py") == ("package/_minimalist_class.py",)
    assert home.near("other/test_minimalist_class.py") == ("test/minimalist_class_tests.py",)


def test_when_a_file_was_changed(tmp_path: Path) -> None:
    (tmp_path / "notes").touch()
    os.utime(tmp_path / "notes", (100.0, 200.5))
    (entry,) = read_entries(tmp_path, ["notes"])
    assert entry.modified == 200.5
