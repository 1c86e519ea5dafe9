"""Submissions on disk: links stay inside, limits hold, and nothing hangs."""

from __future__ import annotations

import os
import socket
from pathlib import Path

import pytest

from course.batch.intake.submission import Part
from course.batch.intake.tree import Tree, read_tree
from course.home.opening import USUAL, Limits, Refused
from course.model import replace
from tests.batch.intake.trees import lay


def tree(folder: Path, limits: Limits = USUAL) -> Tree:
    return read_tree((Part(folder.name, folder),), limits)


def test_links(tmp_path: Path) -> None:
    lay(tmp_path, "secret", "in/a/file", "in/b/")
    for name, target in {
        "file": "../a/file",
        "folder": "../a",
        "up": "..",
        "self": "self",
        "out": "../../secret",
        "absolute": "/etc/passwd",
        "missing": "nothing",
    }.items():
        (tmp_path / "in/b" / name).symlink_to(target)
    (tmp_path / "in/b/absolute_inside").symlink_to(tmp_path / "in/a/file")
    found = tree(tmp_path / "in")
    assert found.files() == {"a/file", "b/file", "b/folder/file", "b/absolute_inside"}
    assert [finding.where for finding in found.findings] == [
        "b/absolute, b/missing, b/out and 1 more",  # the link to itself
        "b/up",
    ]


def test_links_that_multiply_come_to_an_end(tmp_path: Path) -> None:
    lay(tmp_path / "in", "0/file")
    for level in range(1, 30):
        (tmp_path / f"in/{level}").mkdir()
        for name in "ab":
            (tmp_path / f"in/{level}/{name}").symlink_to(f"../{level - 1}")
    with pytest.raises(Refused, match="more than 1,000 files"):
        tree(tmp_path / "in", replace(USUAL, files=1000))


def test_links_to_and_fro_come_to_an_end(tmp_path: Path) -> None:
    lay(tmp_path / "in", "a/file", "b/file")
    for number in range(3):
        (tmp_path / f"in/a/{number}").symlink_to("../b")
        (tmp_path / f"in/b/{number}").symlink_to("../a")
    assert len(tree(tmp_path / "in").files()) < 100


def test_pipes_and_sockets_are_left_out(tmp_path: Path) -> None:
    lay(tmp_path / "in", "file")
    os.mkfifo(tmp_path / "in/pipe")
    with socket.socket(socket.AF_UNIX) as listener:
        listener.bind(str(tmp_path / "in/s"))
        found = tree(tmp_path / "in")
    assert found.files() == {"file"}
    assert [finding.where for finding in found.findings] == ["pipe, s"]


def test_names_are_made_safe_and_stay_different(tmp_path: Path) -> None:
    lay(tmp_path / "in", "a\nb/c", "a_b/d", "\x1b[2J")
    Path(os.fsdecode(os.fsencode(tmp_path) + b"/in/\xff")).write_text("")
    found = tree(tmp_path / "in")
    assert found.files() == {"a_b/c", "_[2J", "_"}
    assert [finding.where for finding in found.findings] == ["\\x1b[2J, a\\nb, \\udcff", "a_b"]


def test_a_file_without_end_takes_no_room(tmp_path: Path) -> None:
    lay(tmp_path / "in", "small")
    with (tmp_path / "in/large").open("wb") as file:
        file.truncate(10**13)
    found = tree(tmp_path / "in")
    assert found.files() == {"small"}
    assert found.findings[0].where == "large"


def test_too_much_in_all(tmp_path: Path) -> None:
    for number in range(4):
        lay(tmp_path / "in")
        (tmp_path / "in").mkdir(exist_ok=True)
        (tmp_path / f"in/{number}").write_bytes(bytes(300))
    with pytest.raises(Refused):
        tree(tmp_path / "in", replace(USUAL, bytes=1000))


def test_very_deep(tmp_path: Path) -> None:
    lay(tmp_path / "in", "d/" * 40 + "file", "file")
    found = tree(tmp_path / "in")
    assert found.files() == {"file"}
    assert "deep" in found.findings[0].what


def test_of_the_course_s_own_folder_only_seed_and_acts_are_taken(tmp_path: Path) -> None:
    lay(
        tmp_path / "in",
        *(f".ros2course/{name}" for name in ("home.json", "acts/19.json", "backups/a", "progress.db")),
    )
    assert tree(tmp_path / "in").files() == {".ros2course/home.json", ".ros2course/acts/19.json"}


def test_what_tools_leave_is_passed_over(tmp_path: Path) -> None:
    left = ["__MACOSX/x", "a/._x", "a/.DS_Store", "a/__pycache__/x", ".git/x", "v/pyvenv.cfg", "v/bin/x"]
    built = [
        "ws/src/x",
        "ws/build/x",
        "ws/log/x",
        "p/package.xml",
        "p/install/x",
        "install/setup.bash",
        "install/x",
    ]
    lay(tmp_path / "in", *left, *built, "a/log/x", "build/x")
    assert tree(tmp_path / "in").files() == {"ws/src/x", "p/package.xml", "a/log/x", "build/x"}


def test_several_parts_keep_their_names(tmp_path: Path) -> None:
    lay(tmp_path, "one/x/file", "two/x/file", "setup.py")
    parts = [
        Part("x", tmp_path / "one/x"),
        Part("x", tmp_path / "two/x"),
        Part("setup.py", tmp_path / "setup.py"),
    ]
    assert read_tree(parts).files() == {"x/file", "x-2/file", "setup.py"}
