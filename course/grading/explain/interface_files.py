"""Reads .msg and .srv files to say how they differ from what was asked."""

from __future__ import annotations

import re
from dataclasses import dataclass

from course.evidence.sources import Sources
from course.feedback import Feedback, Location
from course.grading.explain.names import listed, nearest

Section = tuple[tuple[str, str], ...]
_FIELD = re.compile(r"^\s*(?P<type>[A-Za-z][\w/]*(?:<=\d+)?(?:\[[^\]]*\])?)\s+(?P<name>\w+)\s*(?P<rest>.*)$")
_SECTION_NAMES = {1: ("message",), 2: ("request", "response")}


@dataclass(frozen=True)
class Field:
    """One field of an interface file. `line` counts from 1."""

    type: str
    name: str
    line: int


@dataclass(frozen=True)
class InterfaceFile:
    """An interface file in its sections: one for a message, request and response for a service."""

    file: str
    sections: tuple[tuple[Field, ...], ...]


def interface_file(sources: Sources, package: str, kind: str, short: str) -> InterfaceFile | None:
    """The learner's `msg/Short.msg` or `srv/Short.srv`; None when it is not there."""
    wanted = f"{package}/{kind}/{short}.{kind}"
    name = next((file for file in sources.files if file.endswith(wanted)), None)
    if name is None:
        return None
    sections: list[list[Field]] = [[]]
    for number, line in enumerate(sources.files[name].splitlines(), start=1):
        text = line.split("#", 1)[0]
        if text.strip() == "---":
            sections.append([])
        match = _FIELD.match(text)
        if match and not match["rest"].startswith("="):  # a constant is no field
            sections[-1].append(Field(match["type"], match["name"], number))
    return InterfaceFile(name, tuple(tuple(section) for section in sections))


def compare(file: InterfaceFile | None, wanted: tuple[Section, ...], package: str, short: str) -> Feedback:
    """Feedback that names the first difference between the file and the wanted sections."""
    if file is None:
        return Feedback(
            summary=f"`{short}` has other fields than the task asks for, and its file was not found.",
            advice="Its file belongs in the folder `msg` or `srv` of the package: compare it with the task.",
        )
    names = _SECTION_NAMES[len(wanted)]
    found = tuple(_pairs(section, package) for section in file.sections)
    if len(wanted) == 2 and found == (_short(wanted[1], package), _short(wanted[0], package)):
        return Feedback(
            summary=f"In `{short}`, request and response are swapped.",
            where=(Location(file.file, 1),),
            advice="Put the request above the line `---`, the response below it.",
        )
    for name, section, fields in zip(names, wanted, file.sections, strict=False):
        difference = _difference(
            file.file,
            f"the {name} of `{short}`" if len(names) > 1 else f"`{short}`",
            section,
            fields,
            package,
        )
        if difference:
            return difference
    return Feedback(
        summary=f"`{short}` is not the type that the task asks for.",
        where=(Location(file.file, 1),),
        advice="Compare the file with the task, line by line.",
    )


def _difference(
    file: str, what: str, wanted: Section, fields: tuple[Field, ...], package: str
) -> Feedback | None:
    expected = _short(wanted, package)
    found = _pairs(fields, package)
    if found == expected:
        return None
    summary, field, advice = _first_difference(what, expected, found, fields)
    return Feedback(
        summary=summary,
        expected=_written(expected),
        seen=_written(found) or "no field",
        where=(Location(file, field.line if field else 1),),
        advice=advice,
    )


def _first_difference(
    what: str, expected: Section, found: Section, fields: tuple[Field, ...]
) -> tuple[str, Field | None, str]:
    names = [name for _, name in found]
    missing = [name for _, name in expected if name not in names]
    extra = [field for field in fields if field.name not in [name for _, name in expected]]
    if missing and extra:
        close = nearest(missing[0], [field.name for field in extra])
        field = next((f for f in extra if f.name == close), extra[0])
        return (
            f"In {what}, the field `{field.name}` should be called `{missing[0]}`.",
            field,
            f"Rename it: `{missing[0]}`.",
        )
    if missing:
        return (
            f"In {what}, the field {listed(missing)} is missing."
            if len(missing) == 1
            else f"In {what}, the fields {listed(missing)} are missing.",
            fields[-1] if fields else None,
            "Add it." if len(missing) == 1 else "Add them.",
        )
    if extra:
        return f"In {what}, there is a field too many: `{extra[0].name}`.", extra[0], "Remove it."
    for field, (kind, name) in zip(
        sorted(fields, key=lambda f: f.name), sorted(found, key=lambda p: p[1]), strict=True
    ):
        wanted_type = next(t for t, n in expected if n == name)
        if kind != wanted_type:
            return (
                f"In {what}, `{name}` is of type `{field.type}`, not `{wanted_type}`.",
                field,
                f"Write `{wanted_type} {name}`.",
            )
    return (
        f"In {what}, the fields are in another order.",
        fields[0],
        "Put them into the order of the task: it is part of the type.",
    )


def _pairs(fields: tuple[Field, ...], package: str) -> Section:
    return _short(tuple((field.type, field.name) for field in fields), package)


def _short(section: Section, package: str) -> Section:
    """Types of the package itself may be written with or without its name, and with `msg/`."""
    plain = ((kind.replace("/msg/", "/"), name) for kind, name in section)
    return tuple((kind.removeprefix(f"{package}/"), name) for kind, name in plain)


def _written(section: Section) -> str:
    return ", ".join(f"{kind} {name}" for kind, name in section)
