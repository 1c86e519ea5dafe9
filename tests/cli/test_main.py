"""The boundary: every error becomes a message, a next step and an exit code."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from course import __version__
from course.cli.main import main

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course

REPO = Path(__file__).parents[2]


def test_an_unknown_command_gets_the_nearest(ros2course: Ros2course) -> None:
    run = ros2course("chekc")
    assert run.code == 2
    assert "check" in run.err


@pytest.mark.parametrize("words", [["list"], ["hint"], ["check"], ["show"], ["shell"], ["env"]])
def test_without_a_home_it_says_how_to_make_one(ros2course: Ros2course, home: Path, words: list[str]) -> None:
    run = ros2course(*words)
    assert run.code == 2
    assert "no course home" in run.err and "ros2course init" in run.err


def test_a_broken_lesson_names_file_line_and_key(
    ros2course: Ros2course, home: Path, small_course: Path
) -> None:
    ros2course("init")
    lesson = small_course / "chapters/04-lanterns/lesson.yaml"
    lesson.write_text(lesson.read_text().replace("    time_limit: 20", "    tiem_limit: 20"))
    run = ros2course("list")
    assert run.code == 3
    flat = run.err.replace("\n", " ")
    line = next(n for n, text in enumerate(lesson.read_text().splitlines(), 1) if "tiem" in text)
    assert f"lesson.yaml:{line}" in flat.replace(" ", "") or f"lesson.yaml:{line}" in flat
    assert "tiem_limit" in flat and "time_limit" in flat


def test_a_folder_that_is_gone_is_no_bug(
    ros2course: Ros2course, home: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    run = ros2course("list")
    assert run.code == 2
    assert "no longer exists" in run.err


def test_no_course_there(ros2course: Ros2course, tmp_path: Path) -> None:
    run = ros2course("list", course=tmp_path)
    assert run.code == 2
    assert "is not a course" in " ".join(run.err.split())


def test_a_damaged_progress_file_is_told_of(ros2course: Ros2course, home: Path) -> None:
    ros2course("next")
    (home / ".ros2course/progress.sqlite3").write_bytes(b"not a database at all" * 100)
    run = ros2course("list")
    assert run.code == 0
    assert "progress.damaged-" in run.err.replace("\n", "")
    assert "04-light" in run.out


def test_the_global_options_may_stand_after_the_command(ros2course: Ros2course, tmp_path: Path) -> None:
    assert ros2course("next", "--home", str(tmp_path / "x")).code == 0
    assert ros2course("list", f"--home={tmp_path / 'x'}").code == 0
    assert "--home" in ros2course("list", "--home").err, "without a value it is wrong usage"


def test_version_and_help(ros2course: Ros2course) -> None:
    assert ros2course("--version").out == f"ros2course {__version__}\n"
    alone = ros2course(course=None)
    assert alone.code == 0
    assert "Commands:" in alone.out and "Exit codes:" in alone.out


def test_debug_shows_the_traceback(
    ros2course: Ros2course, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS2COURSE_DEBUG", "1")
    assert "Traceback" in ros2course("list").err


def test_a_bug_with_no_place_for_its_log_shows_the_traceback(
    ros2course: Ros2course, home: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(*_: object) -> None:
        raise ZeroDivisionError("oh")

    monkeypatch.setenv("ROS2COURSE_CACHE", "/dev/null/nowhere")
    monkeypatch.setattr("course.home.find_home", broken)
    monkeypatch.setattr("course.cli.session.find_home", broken)
    run = ros2course("list")
    assert run.code == 3
    assert "ZeroDivisionError" in run.err and "Traceback" in run.err


def test_an_interrupt_anywhere_is_130(monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupted(_words: object) -> int:
        raise KeyboardInterrupt

    monkeypatch.setattr("course.cli.main._dispatch", interrupted)
    assert main(["list"]) == 130


def environment(home: Path) -> dict[str, str]:
    path = os.pathsep.join(filter(None, [str(REPO), os.environ.get("PYTHONPATH")]))
    return {**os.environ, "PYTHONPATH": path, "ROS2COURSE_HOME": str(home), "COLUMNS": "80"}


def test_a_reader_that_goes_away_is_no_error(ros2course: Ros2course, home: Path, small_course: Path) -> None:
    ros2course("next")
    command = [sys.executable, "-m", "course", "--course", str(small_course), "show", "--lesson"]
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "wb") as pipe:
        done = subprocess.run(
            command, stdout=pipe, stderr=subprocess.PIPE, env=environment(home), text=True, check=False
        )
    assert done.stderr == ""


def test_what_is_left_to_write_for_it_is_no_error_either() -> None:
    code = (
        "import sys, course.cli.main as m; m._dispatch = lambda words: print('x') or 0; sys.exit(m.main([]))"
    )
    reading, writing = os.pipe()
    os.close(reading)
    with os.fdopen(writing, "wb") as pipe:
        done = subprocess.run(
            [sys.executable, "-c", code],
            stdout=pipe,
            stderr=subprocess.PIPE,
            cwd=REPO,
            text=True,
            check=False,
        )
    assert done.stderr == ""


def test_a_terminal_that_knows_no_unicode_is_no_obstacle(
    ros2course: Ros2course, home: Path, small_course: Path
) -> None:
    ros2course("next")
    (small_course / "chapters/04-lanterns/04-light.md").write_text("Ἕν οἶδα “quoted”", encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "course", "--course", str(small_course), "show"],
        capture_output=True,
        env={**environment(home), "PYTHONIOENCODING": "ascii"},
        check=False,
    )
    assert done.returncode == 0
    assert b"\\u201cquoted\\u201d" in done.stdout


def test_python_m_course_is_the_same_program() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "course", "--version"], capture_output=True, cwd=REPO, text=True, check=False
    )
    assert done.stdout == f"ros2course {__version__}\n"


@pytest.mark.parametrize(
    ("words", "unneeded"),
    [
        (["--version"], {"rich", "pydantic", "yaml", "course.content", "sqlite3"}),
        (["list"], {"course.rosenv", "pydantic", "yaml", "markdown_it", "course.grading.check"}),
        (
            ["hint"],
            {"course.rosenv", "msgspec", "pydantic", "yaml", "course.grading", "pygments.lexers.python"},
        ),
    ],
)
def test_a_quick_command_loads_only_what_it_needs(
    ros2course: Ros2course, home: Path, small_course: Path, words: list[str], unneeded: set[str]
) -> None:
    ros2course("next")  # also makes the content's cache, which is what spares YAML and pydantic
    code = (
        "import sys, course.cli.main as m; m.main(sys.argv[1:]);"
        "print(*sorted(name for name in sys.modules), file=sys.stderr)"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, "--course", str(small_course), *words],
        capture_output=True,
        env=environment(home),
        text=True,
        check=False,
    )
    assert unneeded & set(done.stderr.split()) == set()


@pytest.mark.parametrize(("command", "said"), [("check", "False"), ("list", "")])
def test_what_check_waits_for_is_started_before_all_else(command: str, said: str, home: Path) -> None:
    code = (
        "import sys, course.cli.main as m; from course.grading.supervisor import ForkServer;"
        "ForkServer.start_early = lambda self: print('typer' in sys.modules); m.main(sys.argv[1:])"
    )
    words = [sys.executable, "-c", code, command, "--nonsense"]
    done = subprocess.run(words, capture_output=True, env=environment(home), text=True, check=False)
    assert done.stdout.strip() == said
