"""`build-underlay`, with a fake ROS; other rooms test what is built."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.cli import underlay
from course.cli.main import main
from course.errors import ExitCode
from course.rosenv.underlay import UnderlayPackage


@pytest.fixture
def built(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """What was built; `two` is missing and `one` is there."""
    names: list[str] = []
    packages = tuple(UnderlayPackage(name, Path(name), True) for name in ("one", "two"))
    monkeypatch.setattr(underlay, "compiled_of_underlay", lambda ros: packages)
    monkeypatch.setattr(underlay, "missing_of_underlay", lambda ros: packages[1:])
    monkeypatch.setattr(underlay, "build", lambda wanted, ros, **_: names.extend(wanted))
    return names


def test_without_names_it_builds_what_is_missing(built: list[str]) -> None:
    assert main(["build-underlay"]) == ExitCode.PASSED
    assert built == ["two"]


def test_names_are_built_whether_or_not_they_were_before(built: list[str]) -> None:
    assert main(["build-underlay", "one"]) == ExitCode.PASSED
    assert built == ["one"]


def test_an_unknown_name_is_refused_with_those_there_are(
    built: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["build-underlay", "three"]) == ExitCode.USAGE
    error = capsys.readouterr().err
    assert "no package three" in error
    assert "one, two" in error
    assert built == []


def test_nothing_missing_is_said(
    built: list[str], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(underlay, "missing_of_underlay", lambda ros: ())
    assert main(["build-underlay"]) == ExitCode.PASSED
    assert capsys.readouterr().out == "Nothing is missing.\n"
