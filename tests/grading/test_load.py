"""Grader modules are loaded without pytest."""

from __future__ import annotations

import sys
from pathlib import Path
from types import ModuleType

import pytest

from course.errors import OurFault
from course.grading.load import load_grader, load_module

MODULE = """\
from __future__ import annotations

from dataclasses import dataclass

from course.api import Grader


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
    """With annotations as texts, dataclasses look up their module by its name."""
    file = tmp_path / "ch04_ovens.py"
    file.write_text(MODULE, encoding="utf-8")
    assert list(load_grader(file, "04-oven").checks) == ["sum"]


def test_a_module_without_the_grader(tmp_path: Path) -> None:
    file = tmp_path / "ch04_ovens.py"
    file.write_text(MODULE, encoding="utf-8")
    with pytest.raises(OurFault, match="04-kettle"):
        load_grader(file, "04-kettle")


SHARING = """\
from course.api import Grader
from lib.heat import most

oven = Grader("04-oven", builds=None)
most()
"""


def shared() -> tuple[dict[str, ModuleType], list[str]]:
    found = {name: one for name, one in sys.modules.items() if name.partition(".")[0] == "lib"}
    return found, list(sys.path)


@pytest.mark.parametrize("names", [("one", "two"), ("two", "one")])
def test_modules_beside_graders_are_those_of_their_own_course(tmp_path: Path, names: tuple[str, str]) -> None:
    for name in names:
        (tmp_path / name / "lib").mkdir(parents=True)
        (tmp_path / name / "lib" / "__init__.py").touch()
        (tmp_path / name / "lib" / "heat.py").write_text(f"def most(): return {name!r}\n", encoding="utf-8")
        (tmp_path / name / "ch04_ovens.py").write_text(SHARING, encoding="utf-8")
    known = shared()
    seen = [load_module(tmp_path / name / "ch04_ovens.py").most() for name in names]
    assert tuple(seen) == names
    assert shared() == known
