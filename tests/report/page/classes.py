"""Classes for pages."""

from __future__ import annotations

from collections.abc import Iterable

from course.model import replace
from course.model.gradebook import Gradebook, GradedSubmission
from course.report.gradebook.cleaning import Cleaner
from course.report.gradebook.sheets import exercises_of, sheets
from course.report.page.data import ClassPage, Key
from course.report.pictures.timeline_svg import pictures
from tests.report.gradebook.hostile import CLEANER, TEXTS, graded
from tests.report.gradebook.samples import BEGAN, CLASS, ENDED, gradebook
from tests.report.pictures.recordings import COUNTER, flood, recording


def page_of(book: Gradebook, cleaner: Cleaner, drawn: dict[Key, tuple[str, ...]] | None = None) -> ClassPage:
    every = tuple(sheets(book, cleaner))
    return ClassPage("ROS 2, step by step", exercises_of(book, cleaner), every, BEGAN, ENDED, drawn or {})


def small() -> ClassPage:
    """Ada passed, Bảo and Carl did not, Dilara's result is unknown, and Emre handed in nothing."""
    drawn = {(1, "18-publisher"): pictures(recording(*COUNTER), key="p1", clean=str)}
    page = page_of(CLASS, Cleaner(), drawn)
    then = {sheet.person.id: sheet for sheet in page_of(gradebook(*few()), Cleaner()).sheets}
    return replace(page, code={(1, "18-publisher"): {NODE: LINES}}, before=then)


def few() -> list[GradedSubmission]:
    """An earlier run, in which Ada had handed in what is Carl's now."""
    ada, _, carl, *_ = CLASS.graded
    return [replace(carl, person=ada.person), carl]


NODE = (
    "ros2_tutorial_workspace/src/python_package_that_uses_the_messages/python_package_that_uses_the_messages/"
    "amazing_quote_publisher_node.py"
)
LINES = tuple(f"line_{number} = {number}" for number in range(1, 31))


def hostile(texts: Iterable[str] = TEXTS) -> ClassPage:
    """One person for each text, everything of theirs being that text."""
    every: list[GradedSubmission] = [graded(text) for text in texts]
    drawn: dict[Key, tuple[str, ...]] = {}
    for place, one in enumerate(texts):
        if place < 4:
            clean = CLEANER.line
            drawn[place, "18-publisher"] = pictures(flood(one[:80]), key=f"p{place}", clean=clean)
    return page_of(gradebook(*every), CLEANER, drawn)


def large(people: int) -> ClassPage:
    """The same few over and over, under other names."""
    few = list(CLASS.graded)
    every = [few[place % len(few)] for place in range(people)]
    named = [
        replace(one, person=replace(one.person, id=f"{one.person.id}{place:04}"))
        for place, one in enumerate(every)
    ]
    return page_of(gradebook(*named), Cleaner())
