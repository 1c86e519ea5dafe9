"""Everything that the architecture page names exists, and the recipes for contributors work as written."""

from __future__ import annotations

import ast
import re
import shlex
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from course.cli.main import main
from course.content import open_course, problems
from course.evidence.sources import Sources
from course.explain.engine import Evidence, Known, Symptom, explain
from course.explain.python_errors import EXCEPTIONS
from course.files import write_pieces
from course.report.gradebook.sheets import Sheet, sheets
from tests.report.gradebook.samples import CLASS, CLEANER

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs/architecture.md"
RECIPES = ROOT / "CONTRIBUTING.md"
MOST_HOPS = 30
# `course/cli/`, `docs/results.md`; not `chapters/NN-name/`, where each author has another name.
FILE = re.compile(r"`((?:course|docs|tests|extras|graders|underlay|chapters|solutions)/[\w./-]*)`")
HOP = re.compile(r"^\| (\d+) \| `([\w.]+):(\w+)`", re.MULTILINE)


@pytest.mark.parametrize("page", [PAGE, RECIPES], ids=lambda page: page.name)
def test_every_file_that_is_named_exists(page: Path) -> None:
    named = [name for name in FILE.findall(page.read_text(encoding="utf-8")) if "NN" not in name]
    assert len(named) > 10
    assert [name for name in named if not (ROOT / name).exists()] == []


def test_every_room_is_on_the_page() -> None:
    rooms = {path.parent.name for path in (ROOT / "course").glob("*/__init__.py")}
    named = set(re.findall(r"^\| `course/(\w+)/` \|", PAGE.read_text(encoding="utf-8"), re.MULTILINE))
    drawn = set(re.findall(r"^\s+(?:.* )?(\w+)\[\"", PAGE.read_text(encoding="utf-8"), re.MULTILINE))
    assert named == rooms and drawn == rooms, "say in docs/architecture.md what the room does, and draw it"


def test_the_way_of_a_check_is_there_and_short() -> None:
    hops = HOP.findall(PAGE.read_text(encoding="utf-8"))
    assert [int(number) for number, _, _ in hops] == list(range(1, len(hops) + 1))
    assert 10 < len(hops) <= MOST_HOPS
    assert [f"{module}:{name}" for _, module, name in hops if name not in _names_of(module)] == []


def _names_of(module: str) -> set[str]:
    path = ROOT.joinpath(*module.split("."))
    file = path / "__init__.py" if path.is_dir() else path.with_suffix(".py")
    body = ast.parse(file.read_text(encoding="utf-8")).body
    own = {node.name for node in body if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    return own | {alias.name for node in body if isinstance(node, ast.ImportFrom) for alias in node.names}


def recipe(title: str, language: str) -> str:
    """The code of the recipe under this heading."""
    page = RECIPES.read_text(encoding="utf-8")
    (section,) = re.findall(rf"^## {title}$(.*?)(?=^## |\Z)", page, re.M | re.S)
    (code,) = re.findall(rf"```{language}\n(.*?)```", section, re.DOTALL)
    return str(code)


def test_the_recipe_for_a_chapter(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    course = tmp_path / "robots"
    assert main(["new", "course", str(course)]) == 0
    *made, checked = (
        main(shlex.split(line.replace("DIR", str(course)))[1:])
        for line in recipe("Add a chapter", "sh").splitlines()
    )
    shown = capsys.readouterr().out
    assert made == [0, 0] and checked == 1, shown
    assert f"{shown.count('write your own text here')} problems were found." in shown
    assert [exercise.id for exercise in open_course(course).exercises()] == ["30-battery"]
    assert problems(open_course(course)) == ()


def test_the_recipe_for_a_known_error() -> None:
    entry = eval(recipe("Add a known error", "python"), {"Known": Known})
    symptoms = [Symptom(line) for line in entry.example.splitlines()]
    evidence = Evidence(sources=Sources())
    before = explain(EXCEPTIONS, symptoms, evidence)
    assert before is None or not before.known.pattern, "known already: choose another example"
    found = explain((entry, *EXCEPTIONS), symptoms, evidence)
    assert found is not None and found.known is entry
    assert found.cause == "The disk is full, so `/tmp/log` could not be written."


def test_the_recipe_for_an_output_format(tmp_path: Path) -> None:
    names: dict[str, object] = {"Iterable": Iterable, "Iterator": Iterator, "Sheet": Sheet}
    exec(recipe("Add an output format", "python"), names)
    made = names["as_markdown"]
    assert callable(made)
    write_pieces(tmp_path / "class.md", made(sheets(CLASS, CLEANER)))
    lines = (tmp_path / "class.md").read_text(encoding="utf-8").splitlines()
    assert len(lines) == 2 + len(list(sheets(CLASS, CLEANER))) and lines[2].startswith("| ada | ")
