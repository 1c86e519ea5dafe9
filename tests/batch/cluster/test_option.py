"""`grade --cluster` on the command line: what is missing or does not fit is said at once."""

from __future__ import annotations

import importlib.util
from collections.abc import Callable
from importlib.machinery import ModuleSpec
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
    real = importlib.util.find_spec

    def find(name: str, package: str | None = None) -> ModuleSpec | None:
        return None if name == "distributed" else real(name, package)

    monkeypatch.setattr(importlib.util, "find_spec", find)
    code, said = grade("--cluster", "local")
    assert code == 4 and "pip install 'ros2course[cluster]'" in said
    assert grade()[0] == 0


@pytest.mark.parametrize("words", [(), ("--cluster", "local")])
def test_keys_for_nobody(grade: Grade, words: tuple[str, ...]) -> None:
    pytest.importorskip("distributed")
    code, said = grade(*words, "--cluster-security", "dask.yaml")
    assert code == 2 and "--cluster" in said


def test_no_address(grade: Grade) -> None:
    pytest.importorskip("distributed")
    code, said = grade("--cluster", "host")
    assert code == 2 and "tcp://host:8786" in said
