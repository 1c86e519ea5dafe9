"""A learner's answers: `answers/<exercise>.yaml` in the course home, read with suspicion.

The file may be written by hand, and in a batch by anyone. It is one mapping of question ids to
texts or lists of texts. Every value stays the text that was written (`yes`, `1e3`, `~`), and is
never converted to another YAML type. Aliases, tags, anything nested, and files that are too
large are refused: they raise `Failure` with file and line.
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
    """The answer to one question: its texts (none if left empty), and its line."""

    texts: tuple[str, ...]
    line: int = 0


@dataclass(frozen=True)
class Answers:
    """The content of an answers file. file: relative to the course home. given: may have unknown ids."""

    file: str
    given: Mapping[str, Given] = field(default_factory=dict)

    def to(self, question: str) -> Given | None:
        """The answer to a question; None if there is none or it was left empty."""
        given = self.given.get(question)
        return given if given and given.texts else None

    def first(self, question: str) -> Given | None:
        """The first answer to a question, which `check` keeps if it was wrong."""
        return self.to(question + FIRST)

    def unknown(self, known: frozenset[str]) -> tuple[tuple[str, Given], ...]:
        """Entries whose ids are not questions, in the file's order."""
        names = known | {name + FIRST for name in known}
        return tuple((name, given) for name, given in self.given.items() if name not in names)


def read_answers(home: Path, exercise: str) -> Answers | None:
    """The answers in the course home; None if there is no such file.

    Raises Failure, which blames the file, if it is not what it should be.
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
    """The feedback if there is no answers file."""
    name = answers_file(exercise)
    chapter = exercise.partition("-")[0]
    # A file with another chapter's number belongs to another exercise.
    likely = (one for one in _names(home / "answers") if one.startswith(chapter) or not one[:2].isdigit())
    alike = close_names(Path(name).name, likely, 1)
    return Feedback(
        summary=f"There is no `{name}` in your course home, so nothing is answered yet.",
        seen=f"a file `answers/{alike[0]}`: did you mean this one?" if alike else None,
        advice=f"In a terminal, `ros2course check {exercise}` asks the questions. Or write the file, "
        f"with a line `question: answer` for each; `ros2course show {exercise}` shows the questions.",
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
    # Don't wait for a pipe, and don't follow a link: it may lead to a private file.
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
    """Reads the parser's events in one pass, one by one: nothing is expanded or nested."""

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
            return str(event.style)  # `redirect: >` means the sign itself
        return str(event.value)

    def _next(self, *skipped: type) -> Any:
        """The next event whose type is not in `skipped`. Refuses anchors, aliases, and tags."""
        event = next(event for event in self._events if not isinstance(event, skipped))
        if getattr(event, "anchor", None) is not None or getattr(event, "tag", None) is not None:
            raise self._wrong(event, "it uses YAML's `&`, `*`, or `!`")
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
    """The text of a file for `read_answers`. Answers to unknown questions are kept at its end."""
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
