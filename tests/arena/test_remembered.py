"""What works on this machine is tried once, until the machine or the program changes."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from course.arena import remembered
from course.arena.remembered import forget, unless_known


@pytest.fixture
def program(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROS2COURSE_CACHE", str(tmp_path / "cache"))
    file = tmp_path / "program"
    file.write_text("one")
    return file


class Trial:
    """Counts how often it is asked."""

    def __init__(self, *answers: str | None) -> None:
        self.answers = list(answers)
        self.asked = 0

    def __call__(self) -> str | None:
        self.asked += 1
        return self.answers.pop(0)


def test_success_is_kept(program: Path) -> None:
    trial = Trial(None)
    assert [unless_known("it", str(program), trial) for _ in range(3)] == [None] * 3
    assert trial.asked == 1


def test_failure_is_tried_again(program: Path) -> None:
    trial = Trial("it failed", None)
    assert unless_known("it", str(program), trial) == "it failed"
    assert unless_known("it", str(program), trial) is None


def test_another_name_is_another_matter(program: Path) -> None:
    assert unless_known("one", str(program), Trial(None)) is None
    assert unless_known("other", str(program), Trial("no")) == "no"


def test_a_changed_program_is_tried_again(program: Path) -> None:
    unless_known("it", str(program), Trial(None))
    program.write_text("another")
    assert unless_known("it", str(program), Trial("no")) == "no"


def test_a_machine_that_was_started_anew_is_tried_again(
    program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    unless_known("it", str(program), Trial(None))
    boot = tmp_path / "boot_id"
    boot.write_text("another")
    monkeypatch.setattr(remembered, "_BOOT", boot)
    assert unless_known("it", str(program), Trial("no")) == "no"


def test_another_user_is_tried_again(program: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    unless_known("it", str(program), Trial(None))
    monkeypatch.setattr(os, "geteuid", lambda: 4242)
    assert unless_known("it", str(program), Trial("no")) == "no"


def test_what_did_not_work_after_all_is_forgotten(program: Path) -> None:
    unless_known("it", str(program), Trial(None))
    forget("it")
    forget("it")  # twice is fine
    assert unless_known("it", str(program), Trial("no")) == "no"


def test_without_a_cache_or_a_program_it_is_always_tried(
    program: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for known in (str(tmp_path / "nowhere"), str(program)):
        monkeypatch.setenv("ROS2COURSE_CACHE", "/dev/null/cache")
        trial = Trial(None, None)
        assert [unless_known("it", known, trial) for _ in range(2)] == [None, None]
        assert trial.asked == 2
