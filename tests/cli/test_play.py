"""`play`, up to the moment that nodes would be started; tests/e2e starts them."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.cli import play
from course.cli.main import main

COURSE = Path(__file__).parents[1] / "fixtures/quiz_course"


def test_whoever_plays_first_gets_the_files_of_the_exercise_too(
    guarded_home: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    played: list[str] = []
    monkeypatch.setattr(play, "_play", lambda exercise, home: played.append(exercise.id))
    home = guarded_home / "mine"
    assert main(["--home", str(home), "--course", str(COURSE), "init", str(home)]) == 0
    assert main(["--home", str(home), "--course", str(COURSE), "play", "05-keepers"]) == 0
    assert played == ["05-keepers"]
    assert (home / "note.txt").is_file()
    assert "+ note.txt" in capsys.readouterr().out
