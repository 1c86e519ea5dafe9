"""The shell completes exercise ids."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from course.cli.main import main

Complete = Callable[[str], list[str]]


@pytest.fixture
def completed(
    small_course: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> Complete:
    """What bash would offer at the end of these words."""

    def complete(words: str) -> list[str]:
        line = f"ros2course --course {small_course} {words}"
        monkeypatch.setenv("_ROS2COURSE_COMPLETE", "complete_bash")
        monkeypatch.setenv("COMP_WORDS", line)
        monkeypatch.setenv("COMP_CWORD", str(len(line.split(" ")) - 1))
        main([])
        out, err = capsys.readouterr()
        assert err == "", "a message would end up in the middle of what is being typed"
        return out.split()

    return complete


@pytest.mark.parametrize("command", ["next", "check", "hint", "show", "reset", "solution"])
def test_ids_complete(completed: Complete, command: str) -> None:
    assert completed(f"{command} 04-l") == ["04-light"]


def test_commands_complete(completed: Complete) -> None:
    assert completed("so") == ["solution"]


def test_a_broken_course_only_offers_nothing(completed: Complete, small_course: Path) -> None:
    (small_course / "chapters/04-lanterns/lesson.yaml").write_text("chapter: [")
    assert completed("show 04") == []
