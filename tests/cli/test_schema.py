"""`schema`: what editors check with is fresh, right, and named by every file of the course."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import jsonschema
import pytest
import yaml

from course.content.schema import Kind, json_schema, schema_text

if TYPE_CHECKING:
    from tests.cli.conftest import Ros2course

ROOT = Path(__file__).parents[2]
WHERE = {
    Kind.LESSON: "chapters/*/lesson.yaml",
    Kind.MISTAKES: "chapters/*/mistakes.yaml",
    Kind.ALTERNATIVE: "solutions/*/alternatives/*/alternative.yaml",
}
COURSES = (ROOT, *sorted((ROOT / "tests/fixtures").iterdir()))
FILES = [(kind, file) for kind, place in WHERE.items() for course in COURSES for file in course.glob(place)]


def complaints(kind: Kind, data: Any) -> list[str]:
    return [error.message for error in jsonschema.Draft202012Validator(json_schema(kind)).iter_errors(data)]


@pytest.mark.parametrize("kind", Kind)
def test_the_kept_ones_are_fresh_and_right(kind: Kind) -> None:
    jsonschema.Draft202012Validator.check_schema(json_schema(kind))
    kept = (ROOT / f"docs/schema/{kind.value}.schema.json").read_text(encoding="utf-8")
    step = f"./ros2course schema {kind.value} --out docs/schema/{kind.value}.schema.json"
    assert kept == schema_text(kind), step


@pytest.mark.parametrize("kind", Kind)
def test_every_key_is_described(kind: Kind) -> None:
    made = json_schema(kind)
    for model in (made, *made.get("$defs", {}).values()):
        assert [name for name, key in model["properties"].items() if not key.get("description")] == []


@pytest.mark.parametrize(
    ("kind", "file"), FILES, ids=lambda v: str(v.parent.name) if isinstance(v, Path) else v
)
def test_every_file_of_every_course_fits(kind: Kind, file: Path) -> None:
    assert complaints(kind, yaml.safe_load(file.read_text(encoding="utf-8"))) == []


@pytest.mark.parametrize("course", [ROOT, ROOT / "tests/fixtures/second_course"], ids=["own", "second"])
@pytest.mark.parametrize("kind", [Kind.LESSON, Kind.MISTAKES])
def test_the_first_line_names_the_schema(kind: Kind, course: Path) -> None:
    for file in course.glob(WHERE[kind]):
        first = file.read_text(encoding="utf-8").splitlines()[0]
        named = first.removeprefix("# yaml-language-server: $schema=")
        assert (file.parent / named).resolve() == ROOT / f"docs/schema/{kind.value}.schema.json", file


LESSON = yaml.safe_load((ROOT / "chapters/18-publishers-and-subscribers/lesson.yaml").read_text("utf-8"))
QUIZ = yaml.safe_load(
    (ROOT / "tests/fixtures/second_course/chapters/72-words-for-heat/lesson.yaml").read_text()
)
MISTAKES = yaml.safe_load(
    (ROOT / "tests/fixtures/second_course/chapters/61-the-greenhouse/mistakes.yaml").read_text()
)
Breaking = Callable[[Any], object]


def _publisher(lesson: Any) -> Any:
    return next(each for each in lesson["exercises"] if each["id"] == "18-publisher")


@pytest.mark.parametrize(
    ("kind", "right", "breaking"),
    [
        (Kind.LESSON, LESSON, lambda d: d.pop("title")),
        (Kind.LESSON, LESSON, lambda d: d.update(titel="x")),
        (Kind.LESSON, LESSON, lambda d: d.update(chapter="18")),
        (Kind.LESSON, LESSON, lambda d: d.update(title=" ")),
        (Kind.LESSON, LESSON, lambda d: _publisher(d).update(id="Publisher")),
        (Kind.LESSON, LESSON, lambda d: _publisher(d).update(hints=["one", "two"])),
        (Kind.LESSON, LESSON, lambda d: _publisher(d).pop("hints")),
        (Kind.LESSON, LESSON, lambda d: _publisher(d).update(files=["/etc/passwd"])),
        (Kind.LESSON, LESSON, lambda d: _publisher(d).update(packages=["Big Package"])),
        (Kind.LESSON, LESSON, lambda d: _publisher(d).update(time_limit=0)),
        (Kind.LESSON, QUIZ, lambda d: d["exercises"][0]["questions"][0].update(text=["both"])),
        (Kind.LESSON, QUIZ, lambda d: d["exercises"][0]["questions"][0].pop("choices")),
        (Kind.LESSON, QUIZ, lambda d: d["exercises"][0]["questions"][1].update(tolerance="a lot")),
        (Kind.MISTAKES, MISTAKES, lambda d: d["mistakes"][0].pop("caught_by")),
        (Kind.MISTAKES, MISTAKES, lambda d: d["mistakes"][0]["edits"][0].pop("with")),
        (Kind.MISTAKES, MISTAKES, lambda d: d["mistakes"][0]["edits"][0].update(delete=True)),
    ],
)
def test_a_wrong_one_does_not_fit(kind: Kind, right: Any, breaking: Breaking) -> None:
    wrong = copy.deepcopy(right)
    breaking(wrong)
    assert complaints(kind, right) == []
    assert complaints(kind, wrong) != []


def test_the_command_shows_and_writes(ros2course: Ros2course, tmp_path: Path) -> None:
    assert json.loads(ros2course("schema").out) == json_schema(Kind.LESSON)
    assert ros2course("schema", "mistakes.yaml").out == schema_text(Kind.MISTAKES)
    (tmp_path / "old.json").write_text("old")
    assert ros2course("schema", "alternative", "--out", str(tmp_path / "old.json")).code == 0
    assert (tmp_path / "old.json").read_text() == schema_text(Kind.ALTERNATIVE)


def test_what_has_no_schema(ros2course: Ros2course, tmp_path: Path) -> None:
    run = ros2course("schema", "lessn")
    assert run.code == 2 and "did you mean `lesson`?" in run.err and "mistakes, alternative" in run.err
    (tmp_path / "file").write_text("")
    run = ros2course("schema", "--out", str(tmp_path / "file/x.json"))
    assert run.code == 4 and "cannot be written" in " ".join(run.err.split())
