"""Whether something that learners get contains what they should find out: solutions and right answers.

It examines the texts, hints and mysteries, and a real course home with all starters copied into it. A last
hint may be nearly the answer.
"""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from course.content import Exercise, Question, answers_file, layout
from course.home import CourseHome, begin, create_home, starter_files
from course.validate import Finding
from course.validate.static.markdown_parts import contents
from course.validate.static.subject import Prose, Subject, files_in, text_of

# Shorter files, such as an import and a name, are the same for everybody.
_FEWEST_LINES = 4
_OURS = (layout.LESSON, layout.MISTAKES, layout.ALTERNATIVE)

# The code of solutions in a form that can be compared, with the file and the exercise that asks for it.
Wanted = Mapping[str, tuple[str, Exercise]]


def leak_findings(subject: Subject, texts: Sequence[Prose]) -> Iterator[Finding]:
    wanted = _wanted(subject)
    yield from _in_texts(texts, wanted)
    for exercise in subject.exercises.values():
        yield from _nothing_to_do(exercise)
        yield from _in_starter(exercise, subject, wanted)
        yield from _in_play(exercise, wanted)
        yield from _answers_in_starter(exercise, subject)
    yield from _in_home(subject)


def _wanted(subject: Subject) -> Wanted:
    """The learner's part of the solution, without what the starter contains."""
    found: dict[str, tuple[str, Exercise]] = {}
    given = set(_given(subject))
    for exercise in subject.exercises.values():
        for file in exercise.files:
            code = _plain(text_of(exercise.solution / file) or "")
            if code.count("\n") + 1 >= _FEWEST_LINES and (file, code) not in given:
                found.setdefault(code, (file, exercise))
    return found


def _given(subject: Subject) -> Iterator[tuple[str, str]]:
    for exercise in subject.exercises.values():
        for file in set(starter_files(exercise)) & set(exercise.files):
            yield file, _plain(text_of(exercise.starter / file) or "")


def _plain(text: str) -> str:
    """The text without trailing spaces, empty lines, and comments."""
    lines = (line.rstrip() for line in text.splitlines())
    return "\n".join(line for line in lines if line.strip() and not line.lstrip().startswith("#"))


def _in_texts(texts: Sequence[Prose], wanted: Wanted) -> Iterator[Finding]:
    for text in texts:
        for code in contents(text.text).codes if text.hint != -1 else ():
            plain = _plain(code.text)
            if code.language is None or plain.count("\n") + 1 < _FEWEST_LINES:
                continue
            for solution, (file, exercise) in wanted.items():
                if solution in plain:
                    what = f"this is the whole solution of {exercise.id}, `{file}`"
                    step = "show another example, or a part of it; only a last hint may be nearly the answer"
                    yield Finding(text.file, text.at(code.line), what, step, exercise.id)


def _nothing_to_do(exercise: Exercise) -> Iterator[Finding]:
    own = [file for file in exercise.files if file != answers_file(exercise.id)]
    same = [file for file in own if _is_same(exercise.starter / file, exercise.solution / file)]
    if own and len(same) == len(own):
        what = f"the starter of {exercise.id} is its solution: {', '.join(same)}"
        step = "remove from the starter what the learner should write"
        yield Finding(exercise.starter / same[0], None, what, step, exercise.id)


def _is_same(one: Path, other: Path) -> bool:
    """Compares permissions, too, because the task may be to make a file executable."""
    text = text_of(one)
    return text is not None and text == text_of(other) and one.stat().st_mode == other.stat().st_mode


def _in_starter(exercise: Exercise, subject: Subject, wanted: Wanted) -> Iterator[Finding]:
    """Solutions in starters. But a starter may contain what earlier exercises added to its package."""
    order = list(subject.exercises)
    earlier = order[: order.index(exercise.id)]
    for name in starter_files(exercise):
        for finding in _copy(exercise.starter / name, f"the starter of {exercise.id}", wanted):
            known = subject.exercises[finding.exercise or exercise.id]
            goes_on = known.id in earlier and set(known.packages) & set(exercise.packages)
            if not goes_on:
                yield finding


def _in_play(exercise: Exercise, wanted: Wanted) -> Iterator[Finding]:
    if exercise.play is not None:
        files = files_in(exercise.play.parent) if exercise.play.name == "__init__.py" else (exercise.play,)
        for file in files:
            yield from _copy(file, f"the mystery of {exercise.id}", wanted)


def _copy(file: Path, where: str, wanted: Wanted) -> Iterator[Finding]:
    known = wanted.get(_plain(text_of(file) or ""))
    if known:
        what = f"{where} contains the solution of {known[1].id}, `{known[0]}`"
        yield Finding(file, None, what, "remove it, or leave a part of it for the learner", known[1].id)


def _answers_in_starter(exercise: Exercise, subject: Subject) -> Iterator[Finding]:
    questions = {q.id: (q, one) for one in subject.exercises.values() for q in one.questions}
    for name in starter_files(exercise):
        for number, line in enumerate((text_of(exercise.starter / name) or "").splitlines(), 1):
            match = re.match(r"\s*[\"']?([a-z0-9_-]+)[\"']?\s*:\s*(.+?)\s*$", line)
            if match and match[1] in questions and _is_right(questions[match[1]][0], match[2].strip("\"'[]")):
                what = f"this is the right answer to `{match[1]}` of {questions[match[1]][1].id}"
                place = exercise.starter / name
                yield Finding(place, number, what, "remove it from the starter", exercise.id)


def _is_right(question: Question, given: str) -> bool:
    """Whether the answer is right, as far as that is known without drawing a mystery."""
    if question.form == "number":
        return not question.computed and given == f"{question.value:g}"
    right = [choice.name for choice in question.choices if choice.right] + list(question.texts)
    return given.casefold() in (text.casefold() for text in right)


def _in_home(subject: Subject) -> Iterator[Finding]:
    """Findings in a new home in which each exercise was begun, with the same calls as in the commands."""
    with tempfile.TemporaryDirectory() as folder:
        home = create_home(Path(folder) / "home")
        for exercise in subject.exercises.values():
            for laid in begin(home, exercise):
                yield from _laid(home, exercise, laid)


def _laid(home: CourseHome, exercise: Exercise, laid: Path) -> Iterator[Finding]:
    name = laid.relative_to(home.path)
    place = exercise.starter / name
    if name.parts[0] == "answers":
        what = f"the starter of {exercise.id} contains an answers file, `{name}`"
        yield Finding(place, None, what, "remove it: answers are the learner's own", exercise.id)
    if name.name in _OURS or name.parts[0] in layout.PARTS:
        what = f"`{name}` of the course itself is copied into the course home"
        yield Finding(place, None, what, "remove it from the starter", exercise.id)
    if laid.is_symlink():
        what = f"`{name}` of this starter is a link that leads outside the course home"
        yield Finding(place, None, what, "put a copy of the file there", exercise.id)
