"""Laying starter files: complete, with their mode, and never over a learner's file."""

from __future__ import annotations

import errno
import os
import signal
import stat
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.errors import StorageError, UsageError
from course.home import CourseHome, begin, create_home, keep_answers, reset, storage

PACKAGE = "ros2_tutorial_workspace/src/lanterns"
LIGHT = f"{PACKAGE}/lanterns/light.py"
STARTER = [f"{PACKAGE}/fill.sh", f"{PACKAGE}/lanterns/__init__.py", LIGHT]


def files_in(home: CourseHome) -> list[str]:
    found = (path for path in home.workspace.rglob("*") if not path.is_dir())
    return sorted(path.relative_to(home.path).as_posix() for path in found)


def test_the_files_are_copied_and_told(home: CourseHome, light: Exercise) -> None:
    new = begin(home, light)
    assert [path.relative_to(home.path).as_posix() for path in new] == STARTER == files_in(home)
    assert (home.path / LIGHT).read_text() == (light.starter / LIGHT).read_text()


def test_modes_are_kept(home: CourseHome, light: Exercise) -> None:
    (light.starter / LIGHT).chmod(0o640)
    begin(home, light)
    assert stat.S_IMODE((home.path / PACKAGE / "fill.sh").stat().st_mode) == 0o755
    assert stat.S_IMODE((home.path / LIGHT).stat().st_mode) == 0o640


def test_a_read_only_course_gives_files_that_can_be_edited(home: CourseHome, light: Exercise) -> None:
    (light.starter / LIGHT).chmod(0o444)
    begin(home, light)
    assert stat.S_IMODE((home.path / LIGHT).stat().st_mode) == 0o644


def test_a_learner_s_file_is_never_overwritten(home: CourseHome, light: Exercise) -> None:
    target = home.path / LIGHT
    target.parent.mkdir(parents=True)
    target.write_text("mine")
    assert target not in begin(home, light)
    assert target.read_text() == "mine"
    assert files_in(home) == STARTER


def test_a_second_time_adds_nothing(home: CourseHome, light: Exercise) -> None:
    begin(home, light)
    assert begin(home, light) == ()


def test_an_exercise_without_starter_adds_nothing(home: CourseHome, small_course: Path) -> None:
    for path in (small_course / "chapters/04-lanterns/starter/04-light").rglob("*.*"):
        path.unlink()
    assert begin(home, open_course(small_course).exercise("04-light")) == ()


def test_caches_in_the_course_are_no_starter(home: CourseHome, light: Exercise) -> None:
    cache = light.starter / PACKAGE / "__pycache__"
    cache.mkdir()
    (cache / "light.cpython-311.pyc").write_bytes(b"")
    begin(home, light)
    assert files_in(home) == STARTER


@pytest.fixture
def reachable(open_folder: Path, small_course: Path) -> tuple[CourseHome, Exercise]:
    """A home and an exercise where any user can read them."""
    small_course.rename(open_folder / "course")
    home = create_home(open_folder / "home")
    return home, open_course(open_folder / "course").exercise("04-light")


def test_a_read_only_home_is_told(
    reachable: tuple[CourseHome, Exercise], read_only: Callable[[Path], AbstractContextManager[None]]
) -> None:
    home, light = reachable
    with read_only(home.path.parent), pytest.raises(StorageError) as caught:
        begin(home, light)
    assert "choose another folder" in (caught.value.next_step or "")
    assert files_in(home) == []


def test_a_read_only_home_that_lacks_nothing_is_fine(
    reachable: tuple[CourseHome, Exercise], read_only: Callable[[Path], AbstractContextManager[None]]
) -> None:
    home, light = reachable
    begin(home, light)
    with read_only(home.path.parent):
        assert begin(home, light) == ()


def full(*_arguments: object, **_options: object) -> None:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


@pytest.mark.parametrize("step", ["shutil.copy", "os.link", "os.fsync"])
def test_a_full_disk_leaves_nothing_half_made(
    home: CourseHome, light: Exercise, monkeypatch: pytest.MonkeyPatch, step: str
) -> None:
    with monkeypatch.context() as patched:
        patched.setattr(f"course.home.storage.{step}", full)
        with pytest.raises(StorageError, match="No space left") as caught:
            begin(home, light)
    assert "free some space" in (caught.value.next_step or "")
    assert files_in(home) == []
    assert len(begin(home, light)) == 3


def no_links(*_arguments: object, **_options: object) -> None:
    raise OSError(errno.EPERM, os.strerror(errno.EPERM))


def test_a_disk_without_hard_links_will_do(
    home: CourseHome, light: Exercise, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(storage.os, "link", no_links)
    assert len(begin(home, light)) == 3
    assert files_in(home) == STARTER


@pytest.mark.parametrize("links", [True, False])
def test_a_file_that_appears_meanwhile_is_not_overwritten(
    home: CourseHome, light: Exercise, monkeypatch: pytest.MonkeyPatch, links: bool
) -> None:
    target = home.path / LIGHT
    copy = storage.copy_into

    def slow(source: Path, part: Path) -> None:
        copy(source, part)
        if source.name == "light.py":
            target.write_text("mine")

    monkeypatch.setattr(storage, "copy_into", slow)
    if not links:
        monkeypatch.setattr(storage.os, "link", no_links)
    assert target not in begin(home, light)
    assert target.read_text() == "mine"


@pytest.mark.parametrize("command", [begin, reset])
def test_while_one_command_changes_the_home_another_waits(
    home: CourseHome, light: Exercise, command: Callable[[CourseHome, Exercise], object]
) -> None:
    other = threading.Thread(target=command, args=(home, light))
    with home.lock():
        other.start()
        other.join(0.2)
        assert other.is_alive()
        assert files_in(home) == []
    other.join(10)
    assert files_in(home) == STARTER


def test_a_killed_command_leaves_whole_files_and_the_next_one_the_rest(
    home: CourseHome, light: Exercise, small_course: Path
) -> None:
    code = (
        "import os, shutil, signal, sys; from pathlib import Path\n"
        "from course.content import open_course; from course.home import CourseHome, begin, storage\n"
        "copy = shutil.copy\n"
        "def die(source, target, **options):\n"
        "    copy(source, target, **options)\n"
        "    if source.name == 'light.py':\n"
        "        os.truncate(target, 5); os.kill(os.getpid(), signal.SIGKILL)\n"
        "storage.shutil.copy = die\n"
        "begin(CourseHome(Path(sys.argv[1])), open_course(Path(sys.argv[2])).exercise('04-light'))\n"
    )
    command = [sys.executable, "-c", code, str(home.path), str(small_course)]
    environ = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2])}
    assert subprocess.run(command, env=environ, check=False).returncode == -signal.SIGKILL
    assert not (home.path / LIGHT).exists()
    assert len(files_in(home)) == 3  # two whole ones, and an unfinished one under another name
    assert begin(home, light) == (home.path / LIGHT,)
    assert files_in(home) == STARTER


def test_a_link_that_leads_out_is_not_followed(home: CourseHome, light: Exercise, tmp_path: Path) -> None:
    outside = tmp_path / "outside"
    outside.mkdir()
    (home.path / PACKAGE).symlink_to(outside)
    with pytest.raises(UsageError, match="src/lanterns is a link that leads out"):
        begin(home, light)
    assert not list(outside.iterdir())


def test_a_link_that_stays_inside_is_fine(home: CourseHome, light: Exercise) -> None:
    (home.path / "elsewhere").mkdir()
    (home.path / PACKAGE).symlink_to(home.path / "elsewhere")
    assert len(begin(home, light)) == 3
    assert (home.path / "elsewhere/lanterns/light.py").is_file()


def test_a_link_in_a_circle_is_told(home: CourseHome, light: Exercise) -> None:
    (home.path / PACKAGE).symlink_to(home.path / PACKAGE)
    with pytest.raises(StorageError):
        begin(home, light)


def test_a_file_that_is_a_link_to_nowhere_is_left_as_it_is(
    home: CourseHome, light: Exercise, tmp_path: Path
) -> None:
    target = home.path / LIGHT
    target.parent.mkdir(parents=True)
    target.symlink_to(tmp_path / "nowhere")
    assert target not in begin(home, light)
    assert target.is_symlink()
    assert not (tmp_path / "nowhere").exists()


def test_answers_are_kept(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    keep_answers(home, "05-quiz", "a: b\n")
    keep_answers(home, "05-quiz", "a: c\n")
    assert [file.name for file in (home.path / "answers").iterdir()] == ["05-quiz.yaml"]
    assert (home.path / "answers/05-quiz.yaml").read_text() == "a: c\n"


def test_a_link_is_replaced_and_not_written_through(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    (tmp_path / "other").write_text("precious\n")
    (home.path / "answers").mkdir()
    (home.path / "answers/05-quiz.yaml").symlink_to(tmp_path / "other")
    keep_answers(home, "05-quiz", "a: b\n")
    assert (tmp_path / "other").read_text() == "precious\n"


def test_a_folder_that_leads_elsewhere(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    (tmp_path / "other").mkdir()
    (home.path / "answers").symlink_to(tmp_path / "other")
    with pytest.raises(UsageError, match="leads outside the course home"):
        keep_answers(home, "05-quiz", "a: b\n")


def test_a_file_where_the_folder_should_be(tmp_path: Path) -> None:
    home = create_home(tmp_path / "home")
    (home.path / "answers").write_text("mine\n")
    with pytest.raises(StorageError, match=r"answers/05-quiz\.yaml cannot be written"):
        keep_answers(home, "05-quiz", "a: b\n")
