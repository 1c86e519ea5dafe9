"""A learner's answers: `answers/<exercise>.yaml` in the course home, read with suspicion.

The file may be written by hand, and in a batch by anybody. It is one mapping of question ids to
texts or lists of texts. Every value stays the text that it is written as (`yes`, `1e3`, `~`), so
no YAML type is ever made of it. Aliases, tags and anything nested are refused, and so is a file
that is too large. Raises `Failure` with file and line for all of that.
"""

from __future__ import annotations

import json
import os
import re
import stat
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any

from course.content import Choice, Question, answers_file
from course.model.feedback import Failure, Feedback, Location
from course.spelling import close_names

MAX_BYTES = 64 * 1024
MAX_ITEMS = 100
# `ID.first: ANSWER` keeps a learner's first answer to a question, if it was wrong.
FIRST = ".first"
_QUOTES = (
    "Put an answer in quotes if it begins with one of `>|*&!%@#{}[]` or contains a colon and "
    'a space: `redirect: ">>"`.'
)


@dataclass(frozen=True)
class Given:
    """The answer to one question: its texts (none when left empty), and its line."""

    texts: tuple[str, ...]
    line: int = 0


@dataclass(frozen=True)
class Answers:
    """All that a file says. `file` is relative to the course home; `given` may hold unknown ids."""

    file: str
    given: Mapping[str, Given] = field(default_factory=dict)

    def to(self, question: str) -> Given | None:
        """The answer to a question; None when there is none or it was left empty."""
        given = self.given.get(question)
        return given if given and given.texts else None

    def first(self, question: str) -> Given | None:
        """The first answer to a question if it was wrong, as `check` has kept it."""
        return self.to(question + FIRST)

    def unknown(self, known: frozenset[str]) -> tuple[tuple[str, Given], ...]:
        """Entries under ids that are not questions, by line."""
        names = known | {name + FIRST for name in known}
        return tuple((name, given) for name, given in self.given.items() if name not in names)


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
    chapter = exercise.partition("-")[0]
    # A file of another chapter is its own exercise's.
    likely = (one for one in _names(home / "answers") if one.startswith(chapter) or not one[:2].isdigit())
    alike = close_names(Path(name).name, likely, 1)
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
    """The content of a plain file in the home, up to a maximum size."""
    path = home / name
    # A pipe must not be waited for, and a link may lead to what is nobody's business.
    flags = os.O_RDONLY | os.O_NONBLOCK | os.O_NOFOLLOW | os.O_CLOEXEC
    try:
        if not path.parent.resolve().is_relative_to(home.resolve()):
            raise _refused(name, "its folder is a link to a place outside the course home")
        descriptor = os.open(path, flags)
    except FileNotFoundError:
        return None
    except (OSError, RuntimeError) as error:
        what = "it is a link" if path.is_symlink() else f"it cannot be read ({error})"
        raise _refused(name, what, advice="Replace it with a regular file.") from None
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise _refused(name, "it is not a regular file", advice="Replace it with a text file.")
        data = os.read(descriptor, MAX_BYTES + 1)
    finally:
        os.close(descriptor)
    if len(data) > MAX_BYTES:
        advice = "It should contain one short line for each question."
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
        raise _refused(name, "it contains characters that are not text", advice="Write it again.") from None


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
            raise self._wrong(event, "it must contain one line `question: answer` for each question")
        found: dict[str, Given] = {}
        while not isinstance(event := self._next(), yaml.MappingEndEvent):
            key = self._scalar(event)
            if key in found:
                raise self._wrong(event, f"`{key[:80]}` is answered twice", "Remove one of the two lines.")
            if len(found) >= MAX_ITEMS:
                raise self._wrong(event, f"it contains more than {MAX_ITEMS} answers")
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
                raise self._wrong(event, f"a list contains more than {MAX_ITEMS} answers")
        return tuple(item for item in items if item)

    def _scalar(self, event: Any) -> str:
        import yaml

        if not isinstance(event, yaml.ScalarEvent):
            raise self._wrong(event, "an answer must be a string or a list of strings")
        if not event.value and event.style in (">", "|"):
            return str(event.style)  # `redirect: >` is meant as it looks
        return str(event.value)

    def _next(self, *skipped: type) -> Any:
        """The next event that is not of a kind in `skipped`. Refuses what makes YAML more than text."""
        event = next(event for event in self._events if not isinstance(event, skipped))
        if getattr(event, "anchor", None) is not None or getattr(event, "tag", None) is not None:
            raise self._wrong(event, "it uses YAML's `&`, `*` or `!`")
        return event

    def _wrong(self, event: Any, what: str, advice: str | None = None) -> Failure:
        return _refused(self._file, what, event.start_mark.line + 1, advice or _QUOTES)


def _refused(name: str, what: str, line: int | None = None, advice: str | None = None) -> Failure:
    return Failure(
        Feedback(summary=f"`{name}` cannot be used: {what}.", where=(Location(name, line),), advice=advice)
    )


Texts = Sequence[str]
_ODD = re.compile("[\x7f-\x9f\u2028\u2029\ufeff\ufffe\uffff]")
_PLAIN = re.compile(r"[A-Za-z0-9_/][A-Za-z0-9_/ .,+()'-]*")


def answers_text(exercise: str, questions: Iterable[Question], given: Mapping[str, Texts]) -> str:
    """A file that `read_answers` reads back. Answers to unknown questions are kept at its end."""
    asked = list(questions)
    parts = [f"# Your answers to {exercise}. `ros2course check {exercise}` asks and judges them.\n"]
    parts += [_entry(question, given) for question in asked]
    others = given.keys() - {question.id + end for question in asked for end in ("", FIRST)}
    if others:
        lines = (f"{_scalar(name)}: {_value(given[name])}\n" for name in sorted(others))
        parts.append("# There are no such questions:\n" + "".join(lines))
    return "\n".join(parts)


def _entry(question: Question, given: Mapping[str, Texts]) -> str:
    lines = [*question.ask.splitlines(), *(f"  - {_described(choice)}" for choice in question.choices)]
    comment = "".join(f"# {line}".rstrip() + "\n" for line in lines)
    answer = f"{comment}{question.id}: {_value(given.get(question.id, ()))}".rstrip() + "\n"
    first = given.get(question.id + FIRST, ())
    return answer + (f"{question.id}{FIRST}: {_value(first)}  # wrong, so half the points\n" if first else "")


def _described(choice: Choice) -> str:
    return choice.text if choice.name == choice.text else f"{choice.name}: {choice.text}"


def _value(texts: Texts) -> str:
    if len(texts) == 1:
        return _scalar(texts[0])
    return f"[{', '.join(_quoted(text) for text in texts)}]" if texts else ""


def _scalar(text: str) -> str:
    return text if _PLAIN.fullmatch(text) and text == text.strip() else _quoted(text)


def _quoted(text: str) -> str:
    """JSON strings are valid double-quoted YAML, except for a few characters."""
    return _ODD.sub(lambda odd: f"\\u{ord(odd[0]):04x}", json.dumps(text, ensure_ascii=False))
