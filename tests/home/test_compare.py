"""The learner's files beside the solution's."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import pytest

from course.content import Exercise
from course.errors import ContentError
from course.home import CourseHome, begin, compare, solution_diff

LIGHT = "ros2_tutorial_workspace/src/lanterns/lanterns/light.py"


def test_a_file_is_shown_as_the_way_to_the_reference(home: CourseHome, light: Exercise) -> None:
    begin(home, light)
    shown = dict(solution_diff(home, light))
    assert list(shown) == list(light.files)
    assert shown[LIGHT].splitlines()[:2] == [f"--- your {LIGHT}", f"+++ reference {LIGHT}"]
    assert "-    return 0  # how bright is it?\n+    return 100\n" in shown[LIGHT]


def test_equal_files_have_an_empty_diff(home: CourseHome, light: Exercise) -> None:
    begin(home, light)
    (home.path / LIGHT).write_bytes((light.solution / LIGHT).read_bytes())
    assert dict(solution_diff(home, light))[LIGHT] == ""


def test_a_missing_file_counts_as_empty(home: CourseHome, light: Exercise) -> None:
    diff = dict(solution_diff(home, light))[LIGHT]
    assert diff.startswith("--- (you have no such file)\n")
    assert "+    return 100\n" in diff


@pytest.mark.parametrize(
    ("content", "shown"),
    [
        (b"return 0", "-return 0\n\\ No newline at end of file\n"),
        (b"return 0\r\n", "-return 0\r\n"),
        (b"caf\xe9\n", "-caf\N{REPLACEMENT CHARACTER}\n"),
        (b"one\x0ctwo\n", "-one\x0ctwo\n"),
    ],
)
def test_bytes_of_any_kind_are_shown(home: CourseHome, light: Exercise, content: bytes, shown: str) -> None:
    begin(home, light)
    (home.path / LIGHT).write_bytes(content)
    assert shown in dict(solution_diff(home, light))[LIGHT]


def test_a_huge_file_is_not_compared(
    home: CourseHome, light: Exercise, monkeypatch: pytest.MonkeyPatch
) -> None:
    begin(home, light)
    monkeypatch.setattr(compare, "LARGEST", 10)
    assert "too large" in dict(solution_diff(home, light))[LIGHT]


def test_a_pipe_is_not_waited_for(home: CourseHome, light: Exercise) -> None:
    begin(home, light)
    (home.path / LIGHT).unlink()
    os.mkfifo(home.path / LIGHT)
    assert dict(solution_diff(home, light))[LIGHT].startswith("--- (you have no such file)\n")


def test_a_solution_that_lacks_the_file_is_our_fault(home: CourseHome, light: Exercise) -> None:
    (light.solution / LIGHT).unlink()
    with pytest.raises(ContentError, match="not in the reference solution") as caught:
        solution_diff(home, light)
    assert caught.value.file == Path(light.solution / LIGHT)


def test_of_a_bashrc_the_addition_is_shown(home: CourseHome, light: Exercise, tmp_path: Path) -> None:
    (tmp_path / ".bashrc").write_text("alias a=b\n")
    exercise = replace(light, files=(".bashrc",), solution=tmp_path)
    (home.path / ".bashrc").write_text("mine\n")
    ((_, diff),) = solution_diff(home, exercise)
    assert [line for line in diff.splitlines()[2:] if line[0] in "+-"] == ["+", "+alias a=b"]
    (home.path / ".bashrc").write_text("alias a=b\nmine\n")
    assert solution_diff(home, exercise)[0].diff == ""
