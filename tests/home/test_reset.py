"""Starting over: everything that was there can be found again."""

from __future__ import annotations

import errno
import multiprocessing
import os
import stat
from dataclasses import replace
from datetime import datetime
from pathlib import Path

import pytest

from course.content import Exercise, open_course
from course.errors import StorageError, UsageError
from course.home import CourseHome, begin, reset, storage

PACKAGE = "ros2_tutorial_workspace/src/lanterns"
LIGHT, DIM = f"{PACKAGE}/lanterns/light.py", f"{PACKAGE}/lanterns/dim.py"
NAMES, INIT, FILL = f"{PACKAGE}/lanterns/names.py", f"{PACKAGE}/lanterns/__init__.py", f"{PACKAGE}/fill.sh"
NOON = datetime(2026, 11, 21, 12, 0, 0)


@pytest.fixture
def worked(home: CourseHome, light: Exercise) -> CourseHome:
    """A home in which the exercise was begun and worked on."""
    begin(home, light)
    (home.path / LIGHT).write_text("my work")
    (home.path / NAMES).write_text("my names")
    (home.path / PACKAGE / "other.txt").write_text("none of the exercise's files")
    return home


def test_the_work_is_in_the_backup_and_the_starter_in_its_place(worked: CourseHome, light: Exercise) -> None:
    report = reset(worked, light, now=NOON)
    assert report.backup == worked.state / "backups/2026-11-21T12-00-00-04-light"
    assert (report.backup / LIGHT).read_text() == "my work"
    assert (worked.path / LIGHT).read_bytes() == (light.starter / LIGHT).read_bytes()
    assert set(report.saved) == {FILL, INIT, LIGHT, NAMES}
    assert set(report.restored) == {FILL, INIT, LIGHT}


def test_modes_are_kept_on_both_ways(worked: CourseHome, light: Exercise) -> None:
    (worked.path / FILL).chmod(0o700)
    report = reset(worked, light)
    assert stat.S_IMODE((report.backup / FILL).stat().st_mode) == 0o700
    assert stat.S_IMODE((worked.path / FILL).stat().st_mode) == 0o755


def test_what_other_exercises_need_is_kept(worked: CourseHome, light: Exercise) -> None:
    report = reset(worked, light)
    assert report.kept == (NAMES,)
    assert (worked.path / NAMES).read_text() == "my names"


def test_what_the_starter_lacks_is_removed(home: CourseHome, small_course: Path) -> None:
    lesson = small_course / "chapters/04-lanterns/lesson.yaml"
    lesson.write_text(lesson.read_text().replace("lanterns/names.py", "lanterns/alone.py", 1))
    light = open_course(small_course).exercise("04-light")
    begin(home, light)
    alone = home.path / PACKAGE / "lanterns/alone.py"
    alone.write_text("mine")
    report = reset(home, light)
    assert report.removed == (f"{PACKAGE}/lanterns/alone.py",)
    assert not alone.exists()
    assert (report.backup / report.removed[0]).read_text() == "mine"


def test_other_files_are_not_touched(worked: CourseHome, light: Exercise) -> None:
    reset(worked, light)
    assert (worked.path / PACKAGE / "other.txt").read_text() == "none of the exercise's files"


def test_with_nothing_there_no_backup_is_made(home: CourseHome, light: Exercise) -> None:
    report = reset(home, light)
    assert (report.backup, report.saved) == (None, ())
    assert set(report.restored) == {FILL, INIT, LIGHT}
    assert not (home.state / "backups").exists()


def test_two_in_one_second_do_not_collide(worked: CourseHome, light: Exercise) -> None:
    first = reset(worked, light, now=NOON).backup
    (worked.path / LIGHT).write_text("more work")
    second = reset(worked, light, now=NOON).backup
    assert (first / LIGHT).read_text() == "my work"
    assert (second / LIGHT).read_text() == "more work"
    assert second.name == "2026-11-21T12-00-00-04-light-2"


@pytest.mark.slow
def test_two_at_once_lose_nothing(worked: CourseHome, small_course: Path) -> None:
    with multiprocessing.get_context("spawn").Pool(2) as pool:
        backups = pool.starmap(_reset, [(worked.path, small_course)] * 4, chunksize=1)
    assert len(set(backups)) == 4
    assert "my work" in {(backup / LIGHT).read_text() for backup in backups}


def _reset(home: Path, course: Path) -> Path:
    backup = reset(CourseHome(home), open_course(course).exercise("04-light"), now=NOON).backup
    assert backup is not None
    return backup


def full(*_arguments: object, **_options: object) -> None:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def test_a_disk_that_is_full_at_the_backup_changes_nothing(
    worked: CourseHome, light: Exercise, monkeypatch: pytest.MonkeyPatch
) -> None:
    with monkeypatch.context() as patched:
        patched.setattr("course.home.storage.shutil.copy", full)
        with pytest.raises(StorageError, match=r"cannot be reset .No space left"):
            reset(worked, light)
    assert (worked.path / LIGHT).read_text() == "my work"
    assert list((worked.state / "backups").iterdir()) == []


def test_a_disk_that_is_full_at_the_starter_names_the_backup(
    worked: CourseHome, light: Exercise, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(storage.Path, "replace", full)
    with pytest.raises(StorageError, match=r"the earlier files are in .*-04-light"):
        reset(worked, light)
    assert (worked.path / LIGHT).read_text() == "my work"
    (backup,) = (worked.state / "backups").iterdir()
    assert (backup / LIGHT).read_text() == "my work"
    assert not list(worked.path.rglob("*.ros2course-part"))


def test_what_a_killed_command_left_is_not_taken_for_a_backup(worked: CourseHome, light: Exercise) -> None:
    left = worked.state / "backups/unfinished" / PACKAGE
    left.mkdir(parents=True)
    (left / "stale.txt").write_text("stale")
    report = reset(worked, light)
    assert not (report.backup / PACKAGE / "stale.txt").exists()
    assert list((worked.state / "backups").iterdir()) == [report.backup]


def test_a_link_is_saved_as_a_link_and_what_it_leads_to_left_alone(
    worked: CourseHome, light: Exercise, tmp_path: Path
) -> None:
    outside = tmp_path / "outside.py"
    outside.write_text("outside")
    (worked.path / LIGHT).unlink()
    (worked.path / LIGHT).symlink_to(outside)
    report = reset(worked, light)
    assert (report.backup / LIGHT).is_symlink()
    assert not (worked.path / LIGHT).is_symlink()
    assert outside.read_text() == "outside"


def test_a_folder_in_a_file_s_place_is_saved_too(worked: CourseHome, light: Exercise) -> None:
    (worked.path / LIGHT).unlink()
    (worked.path / LIGHT).mkdir()
    (worked.path / LIGHT / "inside.py").write_text("mine")
    report = reset(worked, light)
    assert (report.backup / LIGHT / "inside.py").read_text() == "mine"
    assert (worked.path / LIGHT).is_file()


@pytest.mark.parametrize("link", [PACKAGE, ".ros2course/backups"])
def test_a_folder_that_leads_out_is_not_written(
    worked: CourseHome, light: Exercise, tmp_path: Path, link: str
) -> None:
    outside = tmp_path / "outside"
    if (worked.path / link).exists():
        (worked.path / link).rename(outside)
    else:
        outside.mkdir()
    (worked.path / link).symlink_to(outside)
    before = contents(outside)
    with pytest.raises(UsageError, match="leads out"):
        reset(worked, light)
    assert contents(outside) == before


def contents(folder: Path) -> dict[Path, bytes]:
    return {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_the_bashrc_is_saved_and_stays(worked: CourseHome, light: Exercise) -> None:
    (worked.path / ".bashrc").write_text("mine\n")
    report = reset(worked, replace(light, files=(*light.files, ".bashrc")))
    assert (worked.path / ".bashrc").read_text() == "mine\n"
    assert (report.backup / ".bashrc").read_text() == "mine\n"
    assert ".bashrc" in report.kept
