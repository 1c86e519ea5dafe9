"""Reads lesson.yaml: checks the schema, then that the entries agree with each other and the folder."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from course.content.document import Document, Place
from course.content.layout import CHAPTER_FOLDER, LESSON
from course.content.schema import LessonSchema
from course.content.schema_errors import Reading, read_checked
from course.errors import ContentError


def read_lesson(folder: Path) -> Reading[dict[str, Any]]:
    """The content of the chapter's lesson.yaml, with defaults filled in."""

    def agreeing(document: Document, lesson: LessonSchema) -> Reading[dict[str, Any]]:
        data = lesson.model_dump()
        problems = tuple(_disagreements(document, data, folder.name))
        return Reading(None if problems else data, problems, document)

    return read_checked(folder / LESSON, LessonSchema, agreeing)


def _disagreements(document: Document, data: dict[str, Any], folder: str) -> Iterator[ContentError]:
    match = CHAPTER_FOLDER.fullmatch(folder)
    if not match:
        what = f"the chapter's folder `{folder}` is not named like `18-publishers-and-subscribers`"
        yield document.error(what, "allowed: two digits, then lowercase letters and digits joined by dashes")
    elif int(match[1]) != data["chapter"]:
        what = f"`chapter` is {data['chapter']}, but the folder is `{folder}`"
        yield document.error(what, f"allowed: {int(match[1])}", place=("chapter",))
    yield from _bad_ids(document, data)
    yield from question_problems(document, data)


def _bad_ids(document: Document, data: dict[str, Any]) -> Iterator[ContentError]:
    prefix, ids = f"{data['chapter']:02d}-", [exercise["id"] for exercise in data["exercises"]]
    for index, name in enumerate(ids):
        if not name.startswith(prefix):
            what = f"`{name}` must begin with `{prefix}`, the number of its chapter"
            step = f"allowed: `{prefix}` and a name"
            yield document.error(what, step, place=("exercises", index, "id"))
    yield from document.used_twice("exercise", ids, ("exercises",))


FORMS = ("choices", "text", "all_of", "number", "computed")
# Keys that only have a meaning in these forms.
_BELONGS = {
    "multiple": ("choices",),
    "program": ("choices",),
    "keep_order": ("choices", "computed"),
    "exact": ("text", "all_of"),
    "tolerance": ("number",),
    "wrong": ("text", "all_of", "number"),
}
_EXPLAINED = ("text", "all_of", "number", "computed")
FEWEST_CHOICES = 2


def question_problems(document: Document, data: dict[str, Any]) -> Iterator[ContentError]:
    """What is wrong with a lesson's questions beyond what the schema checks."""
    for index, exercise in enumerate(data["exercises"]):
        place, questions = ("exercises", index, "questions"), exercise["questions"]
        yield from document.used_twice("question", [item["id"] for item in questions], place)
        for number, item in enumerate(questions):
            yield from _question_problems(document, item, (*place, number))


def _question_problems(document: Document, item: dict[str, Any], place: Place) -> Iterator[ContentError]:
    given = [name for name in FORMS if item[name] not in (None, False, [])]
    if len(given) != 1:
        found = " and ".join(f"`{name}`" for name in given) or "none"
        what = f"a question must contain exactly one of {', '.join(FORMS)}; this one contains {found}"
        yield document.error(what, "keep one of them", place=(*place, given[-1]) if given else place)
        return
    form = given[0]
    yield from _misplaced(document, item, place, form)
    if form in _EXPLAINED and not item["explain"]:
        step = "add `explain`: text shown after a right answer, and after a wrong one that is not listed"
        yield document.error("`explain` is missing", step, place=place)
    if form == "choices":
        yield from _choice_problems(document, item, place)
    else:
        yield from _spoilt(document, item, place)


def _misplaced(document: Document, item: dict[str, Any], place: Place, form: str) -> Iterator[ContentError]:
    for key, forms in _BELONGS.items():
        if form not in forms and item[key] not in (None, False, [], 0.0, ""):
            what = f"`{key}` does not belong in a question with `{form}`"
            yield document.error(what, f"it goes with {' and '.join(forms)}", place=(*place, key))


def _choice_problems(document: Document, item: dict[str, Any], place: Place) -> Iterator[ContentError]:
    choices, at = item["choices"], (*place, "choices")
    right = sum(choice["right"] for choice in choices)
    if len(choices) < FEWEST_CHOICES:
        yield document.error("there must be at least two choices", "add one, with why it is wrong", place=at)
    elif right == 0 or (right > 1 and not item["multiple"]):
        what = f"exactly one choice must be right, not {right}" if right else "no choice is right"
        yield document.error(what, "`right: true` marks it; `multiple: true` allows several", place=at)
    first: dict[str, int] = {}
    for number, choice in enumerate(choices):
        here = (*at, number)
        if not choice["right"] and not choice["why"]:
            step = "add `why`: say what is wrong about it, for the learner who chose it"
            yield document.error("a wrong choice needs `why`", step, place=here)
        for name in {_plain(choice["text"]), _plain(choice["id"] or choice["text"])}:
            if name in first:
                what = f"this choice already exists on line {first[name]}"
                yield document.error(what, "give each its own text and id", place=here)
            first[name] = document.line(here)


def _spoilt(document: Document, item: dict[str, Any], place: Place) -> Iterator[ContentError]:
    """An explanation that is also shown after wrong answers must not contain the right answer."""
    key = "otherwise" if item["otherwise"] else "explain"
    said = _tidy(item[key] or "")
    texts = [_tidy(text) for text in (item["text"] or item["all_of"])]
    told = [text for text in texts if len(text) > 1 and text in said]
    if item["number"] is not None:
        numbers = re.findall(r"(?<![\w.])\d+(?:\.\d+)?(?![\w]|\.\d)", said.replace("ros 2", ""))
        told = [text for text in numbers if float(text) == item["number"]]
    if told and (not item["all_of"] or len(told) == len(texts)):
        what = f"`{key}` is shown after wrong answers too, and it contains the right one (`{told[0]}`)"
        step = "reword it, or add `otherwise`: what wrong answers get instead of `explain`"
        yield document.error(what, step, place=(*place, key))


def _tidy(text: str) -> str:
    return _plain(text).casefold()


def _plain(text: str) -> str:
    return " ".join(text.replace("`", "").split())
