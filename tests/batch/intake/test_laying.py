"""A submission is laid out as a fresh course home of ordinary files."""

from __future__ import annotations

import errno
import os
import stat
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from course.batch.intake import Found, lay_out
from course.batch.intake.packed import NOT_READ
from course.batch.intake.recognize import FLAT
from course.batch.intake.tree import Tree, read_tree
from course.build import Workspace
from course.errors import StorageError
from tests.batch.intake.trees import INTERFACES, MESSAGES, lay, manifest, package
from tests.home.opening.archives import contents, make_zip

Looked = Callable[..., Found]
WS = "ros2_tutorial_workspace"
HAND_IN = ".ros2course/hand-in.json"


def test_a_home(tmp_path: Path, looked: Looked) -> None:
    names = ["answers/10-run-quiz.yaml", "howdy.sh", ".bashrc", ".ros2course/home.json", f"{WS}/a.yaml"]
    lay(
        tmp_path / "in", *(f"repo-main/{name}" for name in (*package("a", f"{WS}/src/"), *names, "a_folder/"))
    )
    assert lay_out(looked(tmp_path / "in"), tmp_path / "home") == ()
    assert set(contents(tmp_path / "home")) == {*package("a", f"{WS}/src/"), *names}
    assert (tmp_path / "home/a_folder").is_dir()


NODE = "amazing_quote_publisher_node.py"


@pytest.mark.parametrize(
    ("beside", "inside"),
    [
        ((NODE,), (f"{MESSAGES}/{NODE}", f"{MESSAGES}/__init__.py")),
        ((f"{NODE[:-3]}-1.py",), (f"{MESSAGES}/{NODE}", f"{MESSAGES}/__init__.py")),
        (
            (NODE, "quotes.py", "__init__.py", MESSAGES),
            (f"{MESSAGES}/{NODE}", f"{MESSAGES}/quotes.py", f"{MESSAGES}/__init__.py"),
        ),
        ((NODE, "resource"), (f"{MESSAGES}/{NODE}", "resource")),
    ],
)
@pytest.mark.parametrize("folder", ["", "repo-main/"])
def test_a_package_without_its_folders(
    tmp_path: Path, looked: Looked, folder: str, beside: tuple[str, ...], inside: tuple[str, ...]
) -> None:
    names = ("package.xml", "setup.py", *beside)
    lay(tmp_path / "in", *(f"{folder}{name}" for name in names))
    (tmp_path / "in" / folder / "package.xml").write_text(manifest(MESSAGES))
    found = looked(tmp_path / "in")
    assert [(one.what, one.where) for one in found.findings][-1:] == [(FLAT, MESSAGES)]
    assert lay_out(found, tmp_path / "home") == ()
    laid = {file.removeprefix(f"{WS}/src/{MESSAGES}/") for file in contents(tmp_path / "home")}
    marker = () if "resource" in beside else (f"resource/{MESSAGES}",)
    assert laid >= {"package.xml", "setup.py", *inside, *marker}
    assert "18-publisher" in found.exercises


def test_a_package_with_its_folders_stays_as_it_is(tmp_path: Path, looked: Looked) -> None:
    names = (*package(MESSAGES), f"{MESSAGES}/{MESSAGES}/{NODE}", f"{MESSAGES}/{NODE}", f"{MESSAGES}/more.py")
    found = looked(lay(tmp_path / "in", *names))
    assert (found.findings, found.written, len(found.places)) == ((), (), 1)


def test_messages_beside_their_package_xml(tmp_path: Path, looked: Looked) -> None:
    lay_out(
        looked(lay(tmp_path / "in", f"{INTERFACES}/package.xml", f"{INTERFACES}/AmazingQuote.msg")),
        tmp_path / "home",
    )
    assert f"{WS}/src/{INTERFACES}/msg/AmazingQuote.msg" in contents(tmp_path / "home")


def test_a_workspace_an_archive_and_packages(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in", *package("a", "src/"), "other.yaml", f"{INTERFACES}/package.xml")
    archive = make_zip(tmp_path / "b.zip", {"b-main/package.xml": manifest("b"), "b-main/b.py": "b"})
    lay_out(looked(tmp_path / "in", archive), tmp_path / "home")
    expected = [*package("a", f"{WS}/src/"), f"{WS}/other.yaml", f"{WS}/{INTERFACES}/package.xml"]
    expected += [f"{WS}/src/b/package.xml", f"{WS}/src/b/b.py"]
    assert set(contents(tmp_path / "home")) == set(expected)
    found = Workspace.scan(tmp_path / "home" / WS)
    assert sorted(package.name for package in found.packages) == ["a", "b", INTERFACES]


def test_a_package_comes_before_a_single_file(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in", *package(MESSAGES, "good/"), f"y/{MESSAGES}/setup.py", f"z/{MESSAGES}/setup.py")
    found = looked(tmp_path / "in")
    lay_out(found, tmp_path / "home")
    assert len(found.places) == 2
    laid = tmp_path / "home" / WS / "src" / MESSAGES / "setup.py"
    assert laid.read_text() == f"good/{MESSAGES}/setup.py"


def test_nothing_is_a_home_all_the_same(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in", "notes.txt")
    lay_out(looked(tmp_path / "in"), tmp_path / "home")
    assert [path.name for path in (tmp_path / "home").rglob("*")] == [WS, "src"]


def test_links_become_what_they_lead_to(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path, "secret", *package("a", "in/packages/"), "in/src/")
    (tmp_path / "in/src/a").symlink_to("../packages/a")
    (tmp_path / "in/packages/a/leak").symlink_to("../../../secret")
    found = looked(tmp_path / "in")
    lay_out(found, tmp_path / "home")
    assert set(package("a", f"{WS}/src/")) <= set(contents(tmp_path / "home"))
    every = list((tmp_path / "home").rglob("*"))
    assert not any(path.is_symlink() or path.name == "leak" for path in every)
    assert any("Links that lead out" in finding.what for finding in found.findings)


def test_modes(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in", *package("a"), "a/run.sh")
    (tmp_path / "in/a/run.sh").chmod(0o6711)
    (tmp_path / "in/a/setup.py").chmod(0o602)
    (tmp_path / "in/a/a").chmod(0o1777)
    lay_out(looked(tmp_path / "in"), tmp_path / "home")
    modes = {path.name: stat.S_IMODE(path.stat().st_mode) for path in (tmp_path / "home").rglob("*")}
    assert (modes["run.sh"], modes["setup.py"], modes["a"]) == (0o755, 0o644, 0o755)
    assert (tmp_path / "in/a/setup.py").read_text() == "a/setup.py"  # nothing there has changed


def test_a_file_that_turned_into_a_pipe_or_grew_does_no_harm(
    tmp_path: Path, looked: Looked, monkeypatch: pytest.MonkeyPatch
) -> None:
    lay(tmp_path / "in", *package("a"), "a/x", "a/y", "a/z")
    found = looked(tmp_path / "in")
    real = os.open

    def change_first(path: str | Path, *arguments: int) -> int:
        if not Path(path).is_relative_to(tmp_path / "in"):
            pass
        elif Path(path).name == "x":
            Path(path).unlink()
            os.mkfifo(path)
        elif Path(path).name == "y":
            Path(path).write_text("y" * 10_000)
        elif Path(path).name == "z":
            Path(path).unlink()
            Path(path).symlink_to("/etc/passwd")
        return real(path, *arguments)

    with monkeypatch.context() as patched:
        patched.setattr("course.batch.intake.tree.os.open", change_first)
        findings = lay_out(found, tmp_path / "home")
    laid = contents(tmp_path / "home")
    assert laid[f"{WS}/src/a/y"] == "yyy"
    assert laid.get(f"{WS}/src/a/x", "") == ""
    assert f"{WS}/src/a/z" not in laid
    assert len(findings) == 1


def test_a_full_disk_leaves_nothing(tmp_path: Path, looked: Looked, monkeypatch: pytest.MonkeyPatch) -> None:
    found = looked(lay(tmp_path / "in", *package("a")))

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    with monkeypatch.context() as patched:
        patched.setattr("course.batch.intake.contents.read_into", full)
        with pytest.raises(StorageError, match="submission of jane cannot be put in place"):
            lay_out(found, tmp_path / "home")
    assert {path.name for path in tmp_path.iterdir()} <= {"in", "opened"}


def test_a_home_that_is_there_is_left_alone(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path, *package("a", "in/"), "home/mine")
    with pytest.raises(StorageError):
        lay_out(looked(tmp_path / "in"), tmp_path / "home")
    assert contents(tmp_path / "home") == {"mine": "home/mine"}


def test_what_is_no_file_in_the_place_of_a_manifest_is_no_manifest(tmp_path: Path, looked: Looked) -> None:
    lay(tmp_path / "in", *package("a", "src/"), "src/b/package.xml/", "src/b/setup.py")
    assert "a" in looked(tmp_path / "in").packages


@pytest.mark.parametrize("name", ["package.xml", HAND_IN])
@pytest.mark.parametrize("turn", ["folder", "closed", "pipe", "link"])
def test_a_manifest_that_turns_into_something_else_is_not_read(
    tmp_path: Path, looked: Looked, monkeypatch: pytest.MonkeyPatch, name: str, turn: str
) -> None:
    lay(tmp_path / "in", *package("a", f"{WS}/src/"), "answers/a.yaml", ".ros2course/home.json")
    file = tmp_path / "in" / (name if name == HAND_IN else f"{WS}/src/a/package.xml")
    lay(tmp_path, "secret")
    file.write_text("<package/>")
    lay_out(looked(tmp_path / "in"), tmp_path / "home")
    real = read_tree

    def then(*arguments: Any) -> Tree:
        tree = real(*arguments)
        if file.is_file() and not file.is_symlink():
            file.unlink()
            {
                "folder": lambda: file.mkdir(),
                "closed": lambda: file.symlink_to(file.name),  # cannot be opened, even by root
                "pipe": lambda: os.mkfifo(file),
                "link": lambda: file.symlink_to(tmp_path / "secret"),
            }[turn]()
        return tree

    monkeypatch.setattr("course.batch.intake.contents.read_tree", then)
    found = looked(tmp_path / "in")
    assert found.kind.value == "course home" and found.packed is None
    assert (NOT_READ in [one.what for one in found.findings]) is (name == HAND_IN)
