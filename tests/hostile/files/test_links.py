"""Links out of the home, and things that only look like files."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from course.model.result import Verdict, to_json
from tests.hostile.files.conftest import GradeHome
from tests.hostile.world import NODE, PACKAGE, SECRET, SRC, Graded, World

pytestmark = pytest.mark.slow
WORKSPACE = "ros2_tutorial_workspace"
ROOT = f"{SRC}/{PACKAGE}"
MODULE = f"{PACKAGE}/amazing_quote_publisher_node.py"
CHAPTER = "solutions/18-publishers-and-subscribers"
Target = Callable[[World], Path]


def replaced(name: str, target: Target) -> Callable[[World], None]:
    """Puts a link in the place of this file or folder of the home."""

    def change(world: World) -> None:
        place = world.home / name
        if place.exists():
            place.rename(world.home.parent / "taken-away")
        place.symlink_to(target(world))

    return change


def in_course(name: str) -> Target:
    return lambda world: world.course / name


def at(name: str) -> Target:
    return lambda world: Path(name)


def told(graded: Graded) -> str:
    return to_json(graded.result)


@pytest.mark.parametrize(("name", "local"), [(WORKSPACE, False), (SRC, False), (ROOT, False)])
def test_the_solution_is_not_handed_in_by_a_link(grade_home: GradeHome, name: str, local: bool) -> None:
    target = in_course(f"{CHAPTER}/{name}")
    guarantee = "what is graded lies in the home"
    graded = grade_home({}, guarantee=guarantee, change=replaced(name, target), local=local)
    assert graded.failed == ("builds",)
    assert f"{name} is a link out of the course home" in graded.words("builds")


@pytest.mark.parametrize("name", ["package.xml", "setup.py", f"{PACKAGE}/amazing_quote_publisher_node.py"])
@pytest.mark.parametrize(
    "target", [f"solutions/{SECRET}.txt", f"{CHAPTER}/{ROOT}"], ids=["canary", "solution"]
)
def test_no_file_is_taken_from_elsewhere(grade_home: GradeHome, name: str, target: str) -> None:
    leads_to = target if target.endswith(".txt") else f"{target}/{name}"
    change = replaced(f"{ROOT}/{name}", in_course(leads_to))
    guarantee = "no file of a submission is read through a link out of its home"
    graded = grade_home({}, guarantee=guarantee, change=change, local=False)
    assert graded.result.verdict is Verdict.NOT_PASSED
    assert SECRET not in told(graded).replace(f"{SECRET}.txt", "")
    recording = graded.recording
    assert recording is not None
    assert not any(SECRET in text for text in recording.sources.files.values())
    assert f"{ROOT}/{name}" not in recording.sources.files


@pytest.mark.parametrize("target", ["/etc/passwd", "/dev/zero"])
def test_what_never_ends_is_not_read(grade_home: GradeHome, target: str) -> None:
    def change(world: World) -> None:
        replaced(f"{ROOT}/package.xml", at(target))(world)
        replaced(f"{ROOT}/README.md", at(target))(world)

    graded = grade_home({}, guarantee="devices are not read", change=change, local=False)
    assert graded.failed == ("builds",)
    assert "root:" not in told(graded)


def test_pipes_and_folders_in_the_place_of_files(grade_home: GradeHome) -> None:
    def change(world: World) -> None:
        package = world.home / ROOT
        for name in ("setup.py", "setup.cfg", f"{PACKAGE}/amazing_quote_subscriber_node.py"):
            (package / name).unlink()
            (package / name).mkdir()
        for name in ("pipe", f"{PACKAGE}/pipe.py"):
            os.mkfifo(package / name)
        os.mkfifo(world.home / "pipe")
        (world.home / ".bashrc").unlink(missing_ok=True)
        os.mkfifo(world.home / ".bashrc")

    graded = grade_home({}, guarantee="pipes and folders keep nobody waiting", change=change)
    assert graded.failed == ("builds",)
    assert "setup.py" in graded.words("builds")


def test_strange_names_are_no_harm(grade_home: GradeHome) -> None:
    names = (
        b"new\nline.py",
        b"\x1b]0;title\x07.py",
        b"\xff\xfe\x80.py",
        "‮yp.live".encode(),
        b"n" * 255,
        b"'\"; $(id)",
    )

    def change(world: World) -> None:
        for folder in (world.home, world.home / ROOT, world.home / ROOT / "resource", world.home / SRC):
            for name in names:
                (folder / os.fsdecode(name)).write_text("x = 1\n")

    graded = grade_home({}, guarantee="names of files do no harm", change=change)
    assert graded.result.verdict is Verdict.PASSED, told(graded)
    told(graded).encode()


def test_a_package_of_strange_name(grade_home: GradeHome) -> None:
    """The place is part of what is told."""

    def change(world: World) -> None:
        folder = world.home / ROOT
        (folder / "setup.py").write_text("raise RuntimeError('\\x1b[31mred\\x1b]8;;http://evil\\x07')\n")
        folder.rename(folder.parent / os.fsdecode(b"\x1b[31m\xff\nred"))

    graded = grade_home({}, guarantee="names of folders do no harm", change=change)
    assert graded.failed == ("builds",)
    text = told(graded)
    text.encode()
    assert not {"\x1b", "\x07", "\x9b"} & set(text)


def test_huge_files(grade_home: GradeHome) -> None:
    def change(world: World) -> None:
        with (world.home / ROOT / "huge").open("wb") as file:
            file.truncate(10 * 1024**3)
        with (world.home / "huge").open("wb") as file:
            file.truncate(10 * 1024**3)

    graded = grade_home({}, guarantee="huge files are not read", change=change)
    assert graded.failed == ("builds",)
    assert "contains more than a package may: look at `huge`" in graded.words("builds")


def test_a_node_that_is_huge(grade_home: GradeHome) -> None:
    text = "x = 1\n" * 1_000_000
    graded = grade_home({NODE: text}, guarantee="huge sources are judged")
    assert "starts" in graded.failed


def test_folders_without_end(grade_home: GradeHome) -> None:
    def change(world: World) -> None:
        for top in (world.home / ROOT, world.home / SRC, world.home):
            (top / ("d/" * 100)).mkdir(parents=True)

    graded = grade_home({}, guarantee="deep folders do no harm", change=change)
    assert graded.failed == ("builds",)
    assert "look at `d`" in graded.words("builds")
