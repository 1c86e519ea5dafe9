"""Whether `ros2course` and `ros2` commands in texts are valid, and the things that they name exist."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from course.content.course import choose, tidy
from course.errors import MissingHere, OurFault, UsageError
from course.rosenv import find_ros
from course.rosenv.underlay import source_root
from course.spelling import did_you_mean
from course.validate import Finding
from course.validate.static import ros2_program
from course.validate.static.markdown_parts import (
    ANYTHING,
    PLACEHOLDER,
    Code,
    ShellCommand,
    UnreadableLine,
    commands,
    contents,
)
from course.validate.static.subject import Prose, Subject

# Returns what is wrong with the words after `ros2course`, or None; see course/cli/typed.py.
Complaint = Callable[[Sequence[str]], str | None]

_PROGRAM = "ros2course"
# The largest number of arguments that any of our commands requires.
_MOST = 2
# Commands that take an exercise. A text may mention them without `ros2course`: `check 17`.
_OF_EXERCISES = ("check", "hint", "play", "show", "solution", "reset", "next")
_SHORT = re.compile(rf"({'|'.join(_OF_EXERCISES)}) (\d\d?(?:-[\w-]+)?)")
_ID = re.compile(r"\d\d-[a-z0-9]+(-[a-z0-9]+)*")


def own_findings(subject: Subject, texts: Sequence[Prose], complaint: Complaint | None) -> Iterator[Finding]:
    """complaint: None leaves options and arguments of our own commands unchecked."""
    for text in texts:
        for code in contents(text.text).codes:
            yield from _of_names(subject, text, code)
            for found in commands(code, _PROGRAM):
                if isinstance(found, UnreadableLine):
                    yield unreadable(text, found)
                elif not found.only_name:
                    yield from _of_command(subject, text, found, complaint)


def _of_names(subject: Subject, text: Prose, code: Code) -> Iterator[Finding]:
    """Exercises that do not exist, in names within a sentence: `check 17` and `18-publisher`."""
    if code.language is not None:
        return
    short = _SHORT.fullmatch(code.text.strip())
    if short:
        yield from _unknown(subject, text, short[2], code.line)
    elif _ID.fullmatch(code.text):
        chapters = [chapter.name for chapter in subject.chapters]
        if code.text not in chapters:
            yield from _unknown(subject, text, code.text, code.line)


def _of_command(
    subject: Subject, text: Prose, command: ShellCommand, complaint: Complaint | None
) -> Iterator[Finding]:
    words = command.words[1:]
    if ANYTHING in words:
        return
    said = _said(command, words, complaint) if complaint and words else None
    if said:
        what = f"`{' '.join(command.words)}` is not a command of {_PROGRAM}: {said}"
        step = f"correct it; `{_PROGRAM} --help` lists the commands"
        yield Finding(text.file, text.at(command.line), what, step, text.exercise)
    elif words and words[0] in _OF_EXERCISES:
        for word in words[1:]:
            if word[0].isdigit():
                yield from _unknown(subject, text, word, command.line)


def _said(command: ShellCommand, words: Sequence[str], complaint: Complaint) -> str | None:
    """What is wrong with the words, or None. A command that is only mentioned may lack its arguments."""
    said = complaint(words)
    more = range(1, _MOST + 1) if said and command.mentioned else ()
    return None if any(complaint([*words, *[PLACEHOLDER] * count]) is None for count in more) else said


def _unknown(subject: Subject, text: Prose, wanted: str, line: int) -> Iterator[Finding]:
    if wanted == PLACEHOLDER:
        return
    try:
        found = choose(tidy(wanted), subject.exercises)
    except UsageError as error:
        step = error.next_step
        yield Finding(text.file, text.at(line), error.what, step, text.exercise)
        return
    if found is None:
        what = f"there is no exercise `{wanted}`{did_you_mean(wanted, subject.exercises)}"
        yield Finding(text.file, text.at(line), what, "name one that exists", text.exercise)


_PATIENCE = 60.0


def ros2_findings(course: Path, texts: Sequence[Prose]) -> Iterator[Finding]:
    """Finds nothing if this installation lacks our own `ros2`. course: its folder."""
    shown: list[tuple[Prose, ShellCommand]] = []
    for text in texts:
        for code in contents(text.text).codes:
            for found in commands(code, "ros2"):
                if isinstance(found, UnreadableLine):
                    yield unreadable(text, found)
                else:
                    shown.append((text, found))
    for (text, command), complaint in zip(shown, _complaints([one for _, one in shown]), strict=True):
        if complaint:
            what = f"`{' '.join(command.words)}` is not a command of `ros2`: {_short(complaint)}"
            step = "correct it; `ros2 COMMAND --help` shows what there is"
            yield Finding(text.file, text.at(command.line), what, step, text.exercise)
    yield from _of_types(course, shown)


def _of_types(course: Path, shown: Sequence[tuple[Prose, ShellCommand]]) -> Iterator[Finding]:
    types = Types(course) if shown else None
    for text, command in shown:
        complaint = types.complaint(command) if types else None
        if complaint:
            what = f"in `{' '.join(command.words)}`: {complaint}"
            step = "correct it; `ros2 interface list` shows what there is"
            yield Finding(text.file, text.at(command.line), what, step, text.exercise)


def unreadable(text: Prose, found: UnreadableLine) -> Finding:
    what = f"no shell can read `{found.text}`: a quotation mark is not closed"
    return Finding(text.file, text.at(found.line), what, "close it", text.exercise)


def _short(complaint: str) -> str:
    """The complaint with only the likely suggestions."""
    match = re.match(r"invalid choice: '(.*)' \(choose from (.*)\)$", complaint)
    if match is None:
        return complaint
    known = [name.strip(" '") for name in match[2].split(",")]
    return f"there is no `{match[1]}`{did_you_mean(match[1], known)}"


def _complaints(shown: Sequence[ShellCommand]) -> list[str | None]:
    root = source_root()
    if root is None or not shown:
        return [None] * len(shown)
    lines = [(one.words[1:], one.mentioned, one.only_name) for one in shown]
    asked = list(dict.fromkeys(lines))
    environment = {**os.environ, "PYTHONPATH": str(root / "src/ros2cli")}
    done = subprocess.run(
        [sys.executable, str(Path(ros2_program.__file__))],
        input=json.dumps(asked),
        env=environment,
        capture_output=True,
        text=True,
        timeout=_PATIENCE,
        check=False,
    )
    if done.returncode != 0:
        raise OurFault(f"the parsers of `ros2` cannot be asked: {done.stderr.strip().splitlines()[-1:]}")
    found: dict[object, str | None] = dict(zip(asked, json.loads(done.stdout), strict=True))
    return [found[line] for line in lines]


_TYPE = re.compile(r"([a-z][a-z0-9_]*)/(msg|srv|action)/([A-Z]\w*)")


class Types:
    """The interfaces of the course's own solutions, of the underlay, and of this machine's ROS."""

    def __init__(self, course: Path) -> None:
        self._places = tuple(_package_folders(course))

    def complaint(self, command: ShellCommand) -> str | None:
        """A complaint about a missing type of a known package; an unknown package may be an example."""
        for package, kind, name in filter(None, map(_type_parts, command.words)):
            folders = [folder for place in self._places for folder in place.glob(f"{package}/{kind}")]
            known = {file.stem for folder in folders for file in folder.glob(f"*.{kind}")}
            if known and name not in known:
                return f"{package} has no {kind} `{name}`{did_you_mean(name, known)}"
        return None


def _type_parts(word: str) -> tuple[str, str, str] | None:
    match = _TYPE.fullmatch(word)
    return (match[1], match[2], match[3]) if match else None


def _package_folders(course: Path) -> Iterator[Path]:
    yield from {file.parents[1] for file in course.glob("solutions/**/package.xml")}
    root = source_root()
    if root is not None:
        yield root / "src"
    try:
        yield find_ros().prefix / "share"
    except MissingHere:
        return
