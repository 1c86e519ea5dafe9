"""Ids that two chapters use: within one, `course.content.problems` tells of them."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from course.validate.model import Finding
from course.validate.texts.subject import Subject


def id_findings(subject: Subject) -> Iterator[Finding]:
    first: dict[str, tuple[Path, int]] = {}
    for chapter, reading in subject.lessons.items():
        if reading.data is None or reading.document is None:
            continue
        for index, exercise in enumerate(reading.data["exercises"]):
            name, line = exercise["id"], reading.document.line(("exercises", index, "id"))
            other, there = first.setdefault(name, (chapter, line))
            if other != chapter:
                what = f"`{name}` is an exercise of {other.name} too, in line {there} of its lesson.yaml"
                yield Finding(reading.document.file, line, what, "give each an id of its own", name)
