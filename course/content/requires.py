"""Whether exercises stand on exercises that exist, and not on themselves by a detour."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from course.content.document import Document
from course.content.lesson import LessonReading
from course.content.names import did_you_mean
from course.errors import ContentError

Graph = dict[str, tuple[str, ...]]


def requires_problems(readings: Iterable[LessonReading]) -> Iterator[ContentError]:
    usable = [reading for reading in readings if reading.data is not None]
    graph: Graph = {}
    for reading in usable:
        graph.update(_edges(reading))
    for reading in usable:
        yield from _unknown(reading, graph)
        yield from _cycles(reading, graph)


def _edges(reading: LessonReading) -> Graph:
    assert reading.data is not None
    return {exercise["id"]: tuple(exercise["requires"]) for exercise in reading.data["exercises"]}


def _places(reading: LessonReading) -> Iterator[tuple[Document, str, int, int, str]]:
    """Document, exercise id, its index, and each thing that it requires with its index."""
    assert reading.data is not None and reading.document is not None
    for index, exercise in enumerate(reading.data["exercises"]):
        for number, required in enumerate(exercise["requires"]):
            yield reading.document, exercise["id"], index, number, required


def _unknown(reading: LessonReading, graph: Graph) -> Iterator[ContentError]:
    for document, _id, index, number, required in _places(reading):
        if required not in graph:
            what = f"there is no exercise `{required}`{did_you_mean(required, graph)}"
            place = ("exercises", index, "requires", number)
            yield document.error(what, "allowed: the id of an exercise of this course", place=place)


def _cycles(reading: LessonReading, graph: Graph) -> Iterator[ContentError]:
    for document, exercise, index, number, required in _places(reading):
        way = _way(graph, required, exercise)
        if way and exercise == min(way):  # said once, not by each member of the circle
            what = f"`{exercise}` stands on itself: {' -> '.join((exercise, *way))}"
            place = ("exercises", index, "requires", number)
            yield document.error(what, "take one of them out of `requires`", place=place)


def _way(graph: Graph, start: str, goal: str) -> tuple[str, ...]:
    """The exercises from `start` to `goal` along `requires`, or nothing."""
    ways: list[tuple[str, ...]] = [(start,)]
    seen = {start}
    for way in ways:  # grows while it is walked: breadth first
        if way[-1] == goal:
            return way
        new = [name for name in graph.get(way[-1], ()) if name not in seen]
        seen.update(new)
        ways += [(*way, name) for name in new]
    return ()
