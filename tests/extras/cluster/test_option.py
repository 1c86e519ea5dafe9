"""`grade --cluster` on the command line: what is missing or does not fit is said at once."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from course.cli.main import main
from tests.batch.conftest import Lay
from tests.conftest import FIXTURES

Grade = Callable[..., tuple[int, str]]


@pytest.fixture
def grade(lay: Lay, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> Grade:
    folder = lay("ada")

    def run(*words: str) -> tuple[int, str]:
        command = ("grade", str(folder), "--out", str(tmp_path / "out"), "--no-sandbox", *words)
        return main(["--course", str(FIXTURES / "quiz_course"), *command]), capsys.readouterr().err

    return run


def test_without_dask_the_command_to_type(grade: Grade, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in sys.modules if name.startswith("course_cluster")]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setitem(sys.modules, "distributed", None)
    monkeypatch.delenv("ROS2COURSE_LAUNCHER", raising=False)
    code, said = grade("--cluster", "local")
    assert code == 4 and "package `distributed`" in said
    assert "-m pip install" in said and "'distributed<" in said and "ros2course[" not in said
    monkeypatch.setenv("ROS2COURSE_LAUNCHER", "./ros2course")
    assert "`./ros2course --setup-only cluster`" in grade("--cluster", "local")[1]
    assert grade()[0] == 0


def test_dask_is_imported_for_a_cluster_only(grade: Grade, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in sys.modules if name.startswith("course_cluster")]:
        monkeypatch.delitem(sys.modules, name)
    assert grade()[0] == 0
    assert not [name for name in sys.modules if name.startswith("course_cluster")]


@pytest.mark.parametrize("words", [(), ("--cluster", "local")])
def test_keys_for_nobody(grade: Grade, words: tuple[str, ...]) -> None:
    pytest.importorskip("distributed")
    code, said = grade(*words, "--cluster-security", "dask.yaml")
    assert code == 2 and "--cluster" in said


def test_no_address(grade: Grade) -> None:
    pytest.importorskip("distributed")
    code, said = grade("--cluster", "host")
    assert code == 2 and "tcp://host:8786" in said
