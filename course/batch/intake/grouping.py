"""Puts together what belongs to one person, and gives each person an id that no other has."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace

from course.batch.intake.model import Part, Person, Source, Sources
from course.batch.intake.people import Label, assignment, fingerprint, labels, person
from course.home.opening import Finding, Notes, Opened, is_archive, visible

PASSED_OVER = "Files that are no submission were passed over."


def grouped(items: Sequence[Opened], folder: str) -> Sources:
    """`items` are folders and files that lie in one place, called `folder`; the order does not matter."""
    items = sorted(items, key=lambda item: item.name)
    clones = [item.name for item in items if item.path and (item.path / ".git").exists()]
    told = _clones(labels(item.name for item in items), clones, assignment(clones, folder))
    passed_over = Notes()
    people: dict[tuple[str, ...], list[Opened]] = {}
    for item in items:
        label = told[item.name]
        if label.is_lms:
            people.setdefault((label.person.id, label.person.name), []).append(item)
        elif item.path is None or item.path.is_dir() or is_archive(item.name):
            people[(item.name,)] = [item]
        else:
            passed_over.add(PASSED_OVER, item.name)
    sources = unique([_source(own, told) for own in people.values()])
    return Sources(sources, passed_over.findings())


def _clones(told: dict[str, Label], clones: Iterable[str], slug: str) -> dict[str, Label]:
    own = {name: name.removeprefix(slug) for name in clones if slug and not told[name].is_lms}
    return {**told, **{name: Label(person(user, user), "", False) for name, user in own.items() if user}}


def _source(items: Sequence[Opened], told: dict[str, Label]) -> Source:
    first = told[items[0].name].person
    late = any(told[item.name].person.late for item in items)
    parts = tuple(Part(told[item.name].file or item.name, item.path) for item in items if item.path)
    findings = tuple(finding for item in items for finding in item.findings)
    shown = ", ".join(visible(item.name) for item in items)
    return Source(Person(first.id, first.name, late), shown, parts, findings)


def unique(sources: Iterable[Source]) -> tuple[Source, ...]:
    """Where an id is there twice, those after the first get one made of their own names, and all are told."""
    every = tuple(sources)
    count = Counter(source.person.id for source in every)
    seen: set[str] = set()
    return tuple(_told_apart(source, seen) if count[source.person.id] > 1 else source for source in every)


def _told_apart(source: Source, seen: set[str]) -> Source:
    who = source.person
    what = f"More than one submission goes by the id {who.id}."
    finding = Finding(what, "They are graded one by one; remove those that do not count.", source.shown)
    if who.id in seen:
        who = replace(who, id=f"{who.id}-{fingerprint(source.shown)}")
    seen.add(source.person.id)
    return replace(source, person=who, findings=(*source.findings, finding))
