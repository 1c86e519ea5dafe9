"""Whether the course's own commands in texts exist, and the exercises that are named."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence

from course.content import lookup
from course.content.names import did_you_mean
from course.errors import UsageError
from course.validate.model import Finding
from course.validate.texts.markdown import Code, contents
from course.validate.texts.prose import Prose
from course.validate.texts.ros2_commands import unreadable
from course.validate.texts.shell_lines import ANYTHING, PLACEHOLDER, Command, Unreadable, commands
from course.validate.texts.subject import Subject

# What is wrong with the words after `ros2course`, or None. The command line says it: see course/cli/typed.py.
Complaint = Callable[[Sequence[str]], str | None]

_PROGRAM = "ros2course"
# As many arguments as any of our commands wants.
_MOST = 2
# Commands that take an exercise; in a text they may stand alone: `check 17`.
_OF_EXERCISES = ("check", "hint", "play", "show", "solution", "reset", "next")
_SHORT = re.compile(rf"({'|'.join(_OF_EXERCISES)}) (\d\d?(?:-[\w-]+)?)")
_ID = re.compile(r"\d\d-[a-z0-9]+(-[a-z0-9]+)*")


def own_findings(subject: Subject, texts: Sequence[Prose], complaint: Complaint | None) -> Iterator[Finding]:
    """complaint: None leaves options and arguments of our own commands unchecked."""
    for text in texts:
        for code in contents(text.text).codes:
            yield from _of_names(subject, text, code)
            for found in commands(code, _PROGRAM):
                if isinstance(found, Unreadable):
                    yield unreadable(text, found)
                elif not found.only_name:
                    yield from _of_command(subject, text, found, complaint)


def _of_names(subject: Subject, text: Prose, code: Code) -> Iterator[Finding]:
    """`check 17` and `18-publisher` in a sentence."""
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
    subject: Subject, text: Prose, command: Command, complaint: Complaint | None
) -> Iterator[Finding]:
    words = command.words[1:]
    if ANYTHING in words:
        return
    said = _said(command, words, complaint) if complaint and words else None
    if said:
        what = f"`{' '.join(command.words)}` is nothing that {_PROGRAM} understands: {said}"
        step = f"correct it; `{_PROGRAM} --help` lists the commands"
        yield Finding(text.file, text.at(command.line), what, step, text.exercise)
    elif words and words[0] in _OF_EXERCISES:
        for word in words[1:]:
            if word[0].isdigit():
                yield from _unknown(subject, text, word, command.line)


def _said(command: Command, words: Sequence[str], complaint: Complaint) -> str | None:
    """A command that is only mentioned may lack its arguments."""
    said = complaint(words)
    more = range(1, _MOST + 1) if said and command.mentioned else ()
    return None if any(complaint([*words, *[PLACEHOLDER] * count]) is None for count in more) else said


def _unknown(subject: Subject, text: Prose, wanted: str, line: int) -> Iterator[Finding]:
    if wanted == PLACEHOLDER:
        return
    try:
        found = lookup.choose(lookup.tidy(wanted), subject.exercises)
    except UsageError as error:
        step = error.next_step
        yield Finding(text.file, text.at(line), error.what, step, text.exercise)
        return
    if found is None:
        what = f"there is no exercise `{wanted}`{did_you_mean(wanted, subject.exercises)}"
        yield Finding(text.file, text.at(line), what, "name one that exists", text.exercise)
