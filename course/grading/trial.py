"""Trial homes: course homes made from the course's own solutions, starters and known mistakes.

They test graders: the reference and every alternative solution must pass, a starter must not, and
each mistake must be caught.
"""

from __future__ import annotations

import shutil
from pathlib import Path

from course.content import Alternative, Course, Edit, Exercise, Mistake
from course.content.layout import ADDED_TO, ALTERNATIVE, BUILT, with_addition
from course.errors import ContentError
from course.files import wipe
from course.grading.trial_answers import change_answers, lay_answers
from course.grading.trial_build import build_in_place
from course.rosenv import on_this_machine

_NOT_LAID = frozenset({"alternatives", "alternative.yaml", BUILT})


def lay_solution(course: Course, exercise: Exercise, home: Path) -> None:
    """Copy the reference solutions of this exercise's chapter and of everything that it builds on."""
    needed = _standing_on(course, exercise)
    for solution in dict.fromkeys(one.solution for one in needed):
        _lay(solution, home)
    for one in needed:
        lay_answers(one, home)


def lay_starter(course: Course, exercise: Exercise, home: Path) -> None:
    """Copy what a learner has who did everything before, and begins this exercise now.

    If earlier exercises of the chapter share its solution, their starters are used instead.
    """
    before = _standing_on(course, exercise)[:-1]
    for needed in before:
        if needed.solution != exercise.solution:
            _lay(needed.solution, home)
    for needed in (*before, exercise):
        if needed.solution == exercise.solution and needed.starter.is_dir():
            _lay(needed.starter, home)


def lay_alternative(course: Course, exercise: Exercise, alternative: Alternative, home: Path) -> None:
    """Copy another right solution over the reference solution."""
    lay_solution(course, exercise, home)
    for name in alternative.deletes:
        (home / name).unlink()
    _lay(alternative.tree, home)
    own = {question.id for question in exercise.questions}
    answers = {name: given for name, given in alternative.answers.items() if name in own}
    if answers:
        change_answers(exercise, home, answers, alternative.tree / ALTERNATIVE)


def lay_mistake(course: Course, exercise: Exercise, mistake: Mistake, home: Path) -> dict[str, str]:
    """Copy the reference solution, make this mistake in it, and return the texts of its files before that.

    Raises ContentError if an edit no longer applies to the solution.
    """
    lay_solution(course, exercise, home)
    return apply_mistake(exercise, mistake, home)


def apply_mistake(exercise: Exercise, mistake: Mistake, home: Path) -> dict[str, str]:
    """Make the mistake in a home that contains the reference solution.

    Returns what the files contained before that, if their contents change.
    """
    before: dict[str, str] = {}
    for edit in mistake.edits:
        where = exercise.folder / "mistakes.yaml"
        if edit.answers is not None:
            change_answers(exercise, home, edit.answers, where)
        else:
            if (edit.replace or edit.content) is not None and (home / edit.file).is_file():
                text = (home / edit.file).read_text(encoding="utf-8", errors="replace")
                before.setdefault(edit.file, text)
            _apply(edit, mistake, home, where)
    return before


def _standing_on(course: Course, exercise: Exercise) -> tuple[Exercise, ...]:
    """All exercises that this one requires, each once, and then the exercise itself."""
    found: dict[str, Exercise] = {}
    for name in exercise.requires:
        found.update((needed.id, needed) for needed in _standing_on(course, course.exercise(name)))
    found[exercise.id] = exercise
    return tuple(found.values())


def _lay(tree: Path, home: Path) -> None:
    if not tree.is_dir():  # a chapter of quizzes has no solutions
        return
    for entry in sorted(tree.iterdir()):
        if entry.name in ADDED_TO:
            _add_to(home / entry.name, entry)
        elif entry.is_dir() and entry.name not in _NOT_LAID:
            shutil.copytree(entry, home / entry.name, dirs_exist_ok=True)
        elif entry.name not in _NOT_LAID:
            shutil.copy(entry, home / entry.name)
    if (tree / BUILT).is_file():
        for line in (tree / BUILT).read_text(encoding="utf-8").splitlines():
            folder, *options = line.split()
            build_in_place(home / folder, [option.replace("~", str(home)) for option in options])


def _add_to(file: Path, addition: Path) -> None:
    before = file.read_text(encoding="utf-8") if file.exists() else ""
    added = on_this_machine(addition.read_text(encoding="utf-8"))
    file.write_text(with_addition(before, added), encoding="utf-8")


def _apply(edit: Edit, mistake: Mistake, home: Path, where: Path) -> None:
    file = home / edit.file
    if not file.exists() and edit.content is None:
        raise ContentError(f"{mistake.id} edits {edit.file}, which the solution does not have", file=where)
    if edit.delete:
        wipe(file)
    elif edit.rename is not None:
        target = home / edit.rename
        target.parent.mkdir(parents=True, exist_ok=True)
        file.rename(target)
    elif edit.content is not None:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(_there(edit.content, file), encoding="utf-8")
    elif edit.mode is not None:
        file.chmod(int(edit.mode, 8))
    else:
        _replace(edit, mistake, file, where)


def _replace(edit: Edit, mistake: Mistake, file: Path, where: Path) -> None:
    text = file.read_text(encoding="utf-8")
    old, new = _there(edit.replace or "", file), _there(edit.with_ or "", file)
    if not old or old not in text:
        step = f"Make its `replace` match the solution's {edit.file}."
        raise ContentError(f"{mistake.id} no longer applies", step, file=where, key="replace")
    file.write_text(text.replace(old, new), encoding="utf-8")


def _there(text: str, file: Path) -> str:
    return on_this_machine(text) if file.name in ADDED_TO else text
