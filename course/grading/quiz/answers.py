"""A learner's answers: `answers/<exercise>.yaml` in the course home, read with suspicion.

The file may be written by hand, and in a batch by anybody. It is one mapping of question ids to
texts or lists of texts. Every value stays the text that it is written as (`yes`, `1e3`, `~`), so
no YAML type is ever made of it; aliases, tags and anything nested are refused, and so is a file
that is too large. Raises `Failure` with file and line for all of that.
"""

from __future__ import annotations

import os
import stat
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any

from course.content import answers_file
from course.content.names import nearest
from course.feedback import Failure, Feedback, Location

MAX_BYTES = 64 * 1024
MAX_ITEMS = 100
_QUOTES = (
    "Put answers in quotes that begin with one of `>|*&!%@#{}[]` or that hold a colon and a blank: "
    '`redirect: ">>"`.'
)


@dataclass(frozen=True)
class Given:
    """The answer to one question: its texts (none when left blank), and the line it stands in."""

    texts: tuple[str, ...]
    line: int = 0


@dataclass(frozen=True)
class Answers:
    """All that a file says. `file` is relative to the course home; `given` may hold unknown ids."""

    file: str
    given: Mapping[str, Given] = field(default_factory=dict)

    def to(self, question: str) -> Given | None:
        """The answer to a question; None when there is none or it was left blank."""
        given = self.given.get(question)
        return given if given and given.texts else None

    def unknown(self, known: frozenset[str]) -> tuple[tuple[str, Given], ...]:
        """Entries under ids that are no questions, by line."""
        return tuple((name, given) for name, given in self.given.items() if name not in known)


def read_answers(home: Path, exercise: str) -> Answers | None:
    """The answers in the course home; None when there is no such file.

    Raises Failure, which blames the file, when it is not what it should be.
    """
    name = answers_file(exercise)
    data = _read(home, name)
    if data is None:
        return None
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        raise _refused(name, "it is not UTF-8 text", line, "Save it as UTF-8.") from None
    return Answers(name, _parsed(name, text))


def missing(home: Path, exercise: str) -> Feedback:
    """What is said when there is no file of answers."""
    name = answers_file(exercise)
    alike = nearest(Path(name).name, _names(home / "answers"), 1)
    return Feedback(
        summary=f"There is no `{name}` in your course home, so nothing is answered yet.",
        seen=f"a file `answers/{alike[0]}`: is it meant to be this one?" if alike else None,
        advice=f"In a terminal, `ros2course check {exercise}` asks the questions. Or write the file: "
        f"one line `question: answer` each; `ros2course show {exercise}` shows the questions.",
    )


def _names(folder: Path) -> list[str]:
    try:
        with os.scandir(folder) as entries:
            return [entry.name for entry in islice(entries, MAX_ITEMS)]
    except OSError:
        return []


def _read(home: Path, name: str) -> bytes | None:
    """The file's bytes: a plain file inside the home, and not without end."""
    path = home / name
    # A pipe must not be waited for, and a link may lead to what is nobody's business.
    flags = os.O_RDONLY | os.O_NONBLOCK | os.O_NOFOLLOW | os.O_CLOEXEC
    try:
        if not path.parent.resolve().is_relative_to(home.resolve()):
            raise _refused(name, "its folder is a link that leads out of the course home")
        descriptor = os.open(path, flags)
    except FileNotFoundError:
        return None
    except (OSError, RuntimeError) as error:
        what = "it is a link" if path.is_symlink() else f"it cannot be read ({error})"
        raise _refused(name, what, advice="Put a plain file in its place.") from None
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise _refused(name, "it is not a plain file", advice="Put a plain text file in its place.")
        data = os.read(descriptor, MAX_BYTES + 1)
    finally:
        os.close(descriptor)
    if len(data) > MAX_BYTES:
        advice = "It should hold one short line for each question."
        raise _refused(name, f"it is larger than {MAX_BYTES // 1024} KiB", advice=advice)
    return data


def _parsed(name: str, text: str) -> dict[str, Given]:
    import yaml

    loader: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    try:
        return _Reading(name, yaml.parse(text, Loader=loader)).mapping()
    except yaml.MarkedYAMLError as error:
        mark = error.problem_mark or error.context_mark
        what = f"it is not valid YAML: {error.problem or error.context}"
        raise _refused(name, what, mark.line + 1 if mark else None, _QUOTES) from None
    except yaml.YAMLError:
        raise _refused(name, "it holds characters that are not text", advice="Write it anew.") from None


class _Reading:
    """One pass over the parser's events, which are made one by one: nothing is expanded or nested."""

    def __init__(self, file: str, events: Iterator[Any]) -> None:
        self._file = file
        self._events = events

    def mapping(self) -> dict[str, Given]:
        import yaml

        event = self._next(yaml.StreamStartEvent, yaml.DocumentStartEvent)
        if isinstance(event, yaml.StreamEndEvent):
            return {}
        if isinstance(event, yaml.ScalarEvent) and not event.value:
            return {}
        if not isinstance(event, yaml.MappingStartEvent):
            raise self._wrong(event, "it must hold one line `question: answer` for each question")
        found: dict[str, Given] = {}
        while not isinstance(event := self._next(), yaml.MappingEndEvent):
            key = self._scalar(event)
            if key in found:
                raise self._wrong(event, f"`{key[:80]}` is answered twice")
            if len(found) >= MAX_ITEMS:
                raise self._wrong(event, f"it holds more than {MAX_ITEMS} answers")
            found[key] = Given(self._value(), event.start_mark.line + 1)
        return found

    def _value(self) -> tuple[str, ...]:
        import yaml

        event = self._next()
        if not isinstance(event, yaml.SequenceStartEvent):
            text = self._scalar(event).strip()
            return (text,) if text else ()
        items: list[str] = []
        while not isinstance(event := self._next(), yaml.SequenceEndEvent):
            items.append(self._scalar(event).strip())
            if len(items) > MAX_ITEMS:
                raise self._wrong(event, f"a list holds more than {MAX_ITEMS} answers")
        return tuple(item for item in items if item)

    def _scalar(self, event: Any) -> str:
        import yaml

        if not isinstance(event, yaml.ScalarEvent):
            raise self._wrong(event, "an answer must be a text or a list of texts")
        if not event.value and event.style in (">", "|"):
            return str(event.style)  # `redirect: >` is meant as it looks
        return str(event.value)

    def _next(self, *skipped: type) -> Any:
        """The next event that is not of a kind in `skipped`. Refuses what makes YAML more than text."""
        event = next(event for event in self._events if not isinstance(event, skipped))
        if getattr(event, "anchor", None) is not None or getattr(event, "tag", None) is not None:
            raise self._wrong(event, "it uses YAML's `&`, `*` or `!`")
        return event

    def _wrong(self, event: Any, what: str) -> Failure:
        return _refused(self._file, what, event.start_mark.line + 1, _QUOTES)


def _refused(name: str, what: str, line: int | None = None, advice: str | None = None) -> Failure:
    return Failure(
        Feedback(summary=f"`{name}` cannot be used: {what}.", where=(Location(name, line),), advice=advice)
    )
