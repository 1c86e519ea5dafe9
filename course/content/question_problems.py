"""What is wrong with the questions of a lesson, as only several keys together can tell."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from course.content.document import Document, Place
from course.errors import ContentError

FORMS = ("choices", "text", "all_of", "number", "computed")
# Keys that mean something in these forms only.
_BELONGS = {
    "multiple": ("choices",),
    "keep_order": ("choices", "computed"),
    "exact": ("text", "all_of"),
    "tolerance": ("number",),
    "wrong": ("text", "all_of", "number"),
}
_EXPLAINED = ("text", "all_of", "number", "computed")
FEWEST_CHOICES = 2


def question_problems(document: Document, data: dict[str, Any]) -> Iterator[ContentError]:
    """What is wrong with the questions of a lesson beyond the form of each key."""
    for index, exercise in enumerate(data["exercises"]):
        first: dict[str, int] = {}
        for number, item in enumerate(exercise["questions"]):
            place: Place = ("exercises", index, "questions", number)
            line = document.line((*place, "id"))
            if item["id"] in first:
                what = f"`{item['id']}` is used twice; the first is in line {first[item['id']]}"
                yield document.error(what, "give each question an id of its own", place=(*place, "id"))
            first.setdefault(item["id"], line)
            yield from _problems(document, item, place)


def _problems(document: Document, item: dict[str, Any], place: Place) -> Iterator[ContentError]:
    given = [name for name in FORMS if item[name] not in (None, False, [])]
    if len(given) != 1:
        found = " and ".join(f"`{name}`" for name in given) or "none"
        what = f"a question must hold exactly one of {', '.join(FORMS)}; this one holds {found}"
        yield document.error(what, "keep one of them", place=(*place, given[-1]) if given else place)
        return
    form = given[0]
    yield from _misplaced(document, item, place, form)
    if form in _EXPLAINED and not item["explain"]:
        step = "add `explain`: a text shown after a right answer, and after a wrong one that is not listed"
        yield document.error("`explain` is missing", step, place=place)
    if form == "choices":
        yield from _choice_problems(document, item, place)
    else:
        yield from _spoilt(document, item, place)


def _misplaced(document: Document, item: dict[str, Any], place: Place, form: str) -> Iterator[ContentError]:
    for key, forms in _BELONGS.items():
        if form not in forms and item[key] not in (None, False, [], 0.0):
            what = f"`{key}` means nothing in a question with `{form}`"
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
                what = f"this choice is there already, in line {first[name]}"
                yield document.error(what, "give each a text and an id of its own", place=here)
            first[name] = document.line(here)


def _spoilt(document: Document, item: dict[str, Any], place: Place) -> Iterator[ContentError]:
    """An explanation that wrong answers get too must not hold what is right."""
    key = "otherwise" if item["otherwise"] else "explain"
    said = _tidy(item[key] or "")
    texts = [_tidy(text) for text in (item["text"] or item["all_of"])]
    told = [text for text in texts if len(text) > 1 and text in said]
    if item["number"] is not None:
        numbers = re.findall(r"(?<![\w.])\d+(?:\.\d+)?(?![\w]|\.\d)", said.replace("ros 2", ""))
        told = [text for text in numbers if float(text) == item["number"]]
    if told and (not item["all_of"] or len(told) == len(texts)):
        what = f"`{key}` is shown after wrong answers too, and it holds the right one (`{told[0]}`)"
        step = "reword it, or add `otherwise`: what wrong answers get instead of `explain`"
        yield document.error(what, step, place=(*place, key))


def _tidy(text: str) -> str:
    return _plain(text).casefold()


def _plain(text: str) -> str:
    return " ".join(text.replace("`", "").split())
