"""Which changes are saves: of files of the exercise, and not by the course itself."""

from __future__ import annotations

import asyncio
import contextlib
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

from course.content import Exercise
from course.errors import MissingHere
from course.home import CourseHome, create_home
from course.model import replace
from course.watch import saves as module
from course.watch.saves import concerning, saves
from course.watch.session import OwnFiles
from tests.watch.pretended import LIGHT


@pytest.mark.parametrize(
    ("file", "concerns"),
    [
        (LIGHT, True),
        ("ros2_tutorial_workspace/src/other/other.py", True),
        ("notes.txt", True),
        ("answers/04-light.yaml", True),
        (".bashrc", True),
        (".config/tool", True),
        (".config/other/tool", False),
        (".bash_history", False),
        (".ros/log/latest.log", False),
        ("ros2_tutorial_workspace/build/lanterns/x.py", False),
        ("ros2_tutorial_workspace/log/latest/x", False),
        ("ros2_tutorial_workspace/install/setup.bash", True),
        ("ros2_tutorial_workspace/install/deeper/setup.bash", False),
        ("ros2_tutorial_workspace/src/build/x.py", True),
        (f"{LIGHT}~", False),
        ("ros2_tutorial_workspace/src/lanterns/.light.py.swp", False),
        ("ros2_tutorial_workspace/src/lanterns/__pycache__/light.cpython-311.pyc", False),
        ("ros2_tutorial_workspace/src/lanterns/.git/index", False),
    ],
)
def test_what_an_exercise_looks_at(light: Exercise, file: str, concerns: bool) -> None:
    looks_at = ("*", ".bashrc", ".config/*", "ros2_tutorial_workspace/install/*")
    exercise = replace(light, looks_at=looks_at)
    assert concerning(exercise, [file]) == ((file,) if concerns else ())


def test_what_the_course_wrote_is_nobody_s_save(tmp_path: Path) -> None:
    own = OwnFiles(tmp_path)
    (tmp_path / "a/b").mkdir(parents=True)
    (tmp_path / "a/b/c.py").write_text("starter")
    own.wrote(["a/b/c.py", "b/not-there.yaml"])
    files = ("a", "a/b", "a/b/c.py")
    assert own.without(files) == ()
    assert own.without(("a/b/d.py",)) == ("a/b/d.py",)
    assert own.without(("b", "b/not-there.yaml")) == ("b", "b/not-there.yaml"), "it did not write that"
    (tmp_path / "a/b/c.py").write_text("changed by somebody")
    assert own.without(files) == ("a/b/c.py",)
    shutil.rmtree(tmp_path / "a")
    assert own.without(files) == ("a", "a/b", "a/b/c.py")


def told_of(home: CourseHome, act: Callable[[], object], until: Callable[[list[str]], bool]) -> list[str]:
    """The files that were told of after `act`, until that is enough, or `saves` ends."""

    async def listen() -> list[str]:
        found: list[str] = []
        async with contextlib.aclosing(saves(home)) as told:
            first = asyncio.ensure_future(anext(told))
            await asyncio.sleep(0)  # it is listening now
            act()
            with contextlib.suppress(StopAsyncIteration):
                found += await first
                while not until(found):
                    found += await anext(told)
        return found

    return asyncio.run(asyncio.wait_for(listen(), 60))


def test_a_save_in_several_steps_is_told_of_and_the_course_s_own_files_are_not(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")

    def save() -> None:
        (home.state / "progress.sqlite3").write_text("stored")
        (home.path / ".light.py.tmp").write_text("new")
        (home.path / ".light.py.tmp").replace(home.path / "light.py")

    found = told_of(home, save, lambda files: "light.py" in files)
    assert not [file for file in found if file.startswith(".ros2course")]


def test_a_home_behind_a_link(tmp_path: Path) -> None:
    create_home(tmp_path / "home")
    (tmp_path / "link").symlink_to("home")
    linked = CourseHome(tmp_path / "link")
    assert "x.py" in told_of(linked, lambda: (linked.path / "x.py").write_text("x"), bool)


@pytest.mark.parametrize("how", [shutil.rmtree, lambda path: path.rename(f"{path}-elsewhere")])
def test_it_ends_with_the_home(tmp_path: Path, how: Callable[[Path], object]) -> None:
    home = create_home(tmp_path / "home")
    assert told_of(home, lambda: how(home.path), lambda files: False) == []


def test_a_machine_that_cannot_tell(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def exhausted(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(module, "awatch", exhausted)
    home = create_home(tmp_path / "home")
    with pytest.raises(MissingHere, match="cannot report saves") as raised:
        told_of(home, lambda: None, bool)
    assert "WATCHFILES_FORCE_POLLING" in (raised.value.next_step or "")
