"""Grader modules are loaded without pytest."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.errors import OurFault
from course.grading.load import load_grader

MODULE = """\
from __future__ import annotations

from dataclasses import dataclass

from course.grading.author import Grader


@dataclass(frozen=True)
class Pair:
    first: int
    second: int = 2


oven = Grader("04-oven", builds=None)


@oven.check("sum", "it adds up")
def adds_up(recording):
    assert Pair(1).second == 2
"""


def test_a_module_with_a_dataclass(tmp_path: Path) -> None:
    """With annotations as texts, dataclasses look their module up by its name."""
    file = tmp_path / "ch04_ovens.py"
    file.write_text(MODULE, encoding="utf-8")
    assert list(load_grader(file, "04-oven").checks) == ["sum"]


def test_a_module_without_the_grader(tmp_path: Path) -> None:
    file = tmp_path / "ch04_ovens.py"
    file.write_text(MODULE, encoding="utf-8")
    with pytest.raises(OurFault, match="04-kettle"):
        load_grader(file, "04-kettle")
