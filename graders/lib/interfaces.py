"""Interfaces: how .msg and .srv files and their types differ from the task, and what package.xml lacks."""

from __future__ import annotations

import re
from dataclasses import dataclass

from course.api import Failure, Feedback, Location, Recording, Sources, expect_manifest, listed, nearest

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
    """An interface file as sections: one for a message; request and response for a service."""

    file: str
    sections: tuple[tuple[Field, ...], ...]


def expect_tag(
    recording: Recording, package: str, tags: tuple[str, ...], value: str, *, purpose: str
) -> None:
    """Check that package.xml has an element with one of these tags and this text."""
    found = expect_manifest(recording, package)
    if found.depends(value, *tags):
        return
    elsewhere = [tag for tag, text in found.tags if text == value]
    written = f"<{tags[0]}>{value}</{tags[0]}>"
    near = nearest(value, {text for tag, text in found.tags if tag in tags} - {value})
    near = None if elsewhere else near
    raise Failure(
        Feedback(
            summary=f"package.xml does not contain `{written}`: {purpose}.",
            expected=written,
            seen=f"<{elsewhere[0]}>{value}</{elsewhere[0]}>" if elsewhere else near,
            where=(found.place_of(near or value) or found.where,),
            advice=f"Correct `{near}`: it must be `{value}`."
            if near
            else f"Add the line `{written}` to package.xml.",
        )
    )


def expect_same_definition(
    recording: Recording, kind: str, topic: str, type_name: str, type_hash: str, *, advice: str
) -> None:
    """Expect that the type with this name was built from the definition that the course uses.

    kind: `publisher` or `subscription`. advice: tells the learner where to find that definition.
    """
    own = (one for one in recording.seen_endpoints() if (one.topic, one.kind) == (topic, kind))
    if any(one.type == type_name and one.type_hash != type_hash for one in own):
        raise Failure(_other_fields(type_name, advice))


def expect_same_service(
    recording: Recording, name: str, type_name: str, hashes: tuple[str, str], *, advice: str
) -> None:
    """Expect that the server was built from the definition that the course uses.

    hashes: of the request and the response. advice: tells the learner where to find that definition.
    """
    own = (one for one in recording.seen_graph().services if (one.name, one.type) == (name, type_name))
    # Without a server, there are no hashes.
    if any((one.request_hash, one.response_hash) not in (hashes, ("", "")) for one in own):
        raise Failure(_other_fields(type_name, advice))


def _other_fields(type_name: str, advice: str) -> Feedback:
    summary = f"Your `{type_name}` does not have the fields that the exercise asks for."
    return Feedback(summary=summary, advice=advice)


def interface_file(sources: Sources, package: str, kind: str, short: str) -> InterfaceFile | None:
    """The learner's `msg/Short.msg` or `srv/Short.srv`; None if it does not exist."""
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
        if match and not match["rest"].startswith("="):  # a constant is not a field
            sections[-1].append(Field(match["type"], match["name"], number))
    return InterfaceFile(name, tuple(tuple(section) for section in sections))


def compare(file: InterfaceFile | None, wanted: tuple[Section, ...], package: str, short: str) -> Feedback:
    """Feedback that names the first difference between the file and the wanted sections."""
    if file is None:
        return Feedback(
            summary=(
                f"`{short}` does not have the fields that the task asks for, and its file was not found."
            ),
            advice=(
                "Its file belongs in the folder `msg` or `srv` of the package. Compare it with the task."
            ),
        )
    names = _SECTION_NAMES[len(wanted)]
    found = tuple(_pairs(section, package) for section in file.sections)
    if len(wanted) == 2 and found == (_short(wanted[1], package), _short(wanted[0], package)):
        return Feedback(
            summary=f"In `{short}`, request and response are swapped.",
            where=(Location(file.file, 1),),
            advice="Put the request above the line `---` and the response below it.",
        )
    for name, section, fields in zip(names, wanted, file.sections, strict=False):
        what = f"the {name} of `{short}`" if len(names) > 1 else f"`{short}`"
        expected, seen = _short(section, package), _pairs(fields, package)
        if seen != expected:
            summary, field, advice = _difference(what, expected, seen, fields)
            where = Location(file.file, field.line if field else 1)
            return Feedback(summary, _written(expected), _written(seen) or "no field", (where,), advice)
    return Feedback(
        summary=f"`{short}` is not the type that the task asks for.",
        where=(Location(file.file, 1),),
        advice="Compare the file with the task, line by line.",
    )


def _difference(
    what: str, expected: Section, seen: Section, fields: tuple[Field, ...]
) -> tuple[str, Field | None, str]:
    """For two sections that differ: the summary, the field to look at, and the advice."""
    missing = [name for _, name in expected if name not in [name for _, name in seen]]
    extra = [field for field in fields if field.name not in [name for _, name in expected]]
    if missing and extra:
        close = nearest(missing[0], [field.name for field in extra])
        field = next((f for f in extra if f.name == close), extra[0])
        summary = f"In {what}, the field `{field.name}` should be called `{missing[0]}`."
        return summary, field, f"Rename it: `{missing[0]}`."
    if missing:
        one = len(missing) == 1
        summary = f"In {what}, the {'field' if one else 'fields'} {listed(missing)} {'is' if one else 'are'}"
        return f"{summary} missing.", fields[-1] if fields else None, "Add it." if one else "Add them."
    if extra:
        return f"In {what}, there is an extra field: `{extra[0].name}`.", extra[0], "Remove it."
    types = dict((name, kind) for kind, name in expected)
    for field, (kind, name) in zip(fields, seen, strict=True):
        if kind != types[name]:
            summary = f"In {what}, `{name}` is of type `{field.type}`, not `{types[name]}`."
            return summary, field, f"Write `{types[name]} {name}`."
    order = "Put them in the order of the task: the order is part of the type."
    return f"In {what}, the fields are in a different order.", fields[0], order


def _pairs(fields: tuple[Field, ...], package: str) -> Section:
    return _short(tuple((field.type, field.name) for field in fields), package)


def _short(section: Section, package: str) -> Section:
    """The section without `msg/` in types and without the package's own name, which are both optional."""
    plain = ((kind.replace("/msg/", "/"), name) for kind, name in section)
    return tuple((kind.removeprefix(f"{package}/"), name) for kind, name in plain)


def _written(section: Section) -> str:
    return ", ".join(f"{kind} {name}" for kind, name in section)
