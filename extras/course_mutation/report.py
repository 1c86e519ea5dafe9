"""Weakened graders in the terminal: how many were noticed, and which were not. Works without color."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import groupby
from pathlib import Path

from rich.console import Console
from rich.table import Table
from rich.text import Text

from course.report import sanitize
from course.report.console import put, put_prose, with_code
from course_mutation.model import Fate, Mutant, Mutation, OfExercise
from course_mutation.mutants import suggestion

_COLUMNS = ("exercise", "mutants", "killed", "broken", "endless", "survived", "recorded", "seconds")
_NOT_ASKED = "`validate` without `--mutate` first: it was left out"


def render_mutation(console: Console, mutation: Mutation) -> None:
    """A table, problems, the survivors by file and line, and a summary."""
    exercises = mutation.exercises
    console.print(_table(exercises))
    for exercise in exercises:
        for problem in exercise.problems:
            put(console)
            put_prose(console, with_code(console, sanitize.paragraph(problem)))
            put_prose(console, with_code(console, _NOT_ASKED), first="  try  ")
    survivors = [judged.mutant for exercise in exercises for judged in exercise.survivors]
    survivors.sort(key=lambda mutant: (mutant.file, mutant.line))
    for file, mutants in groupby(survivors, key=lambda mutant: mutant.file):
        put(console)
        put(console, sanitize.one_line(shown(file, Path.cwd())), "bold")
        for mutant in mutants:
            _render(console, mutant)
    put(console)
    put(console, _ending(exercises))


def shown(file: Path, base: Path) -> str:
    """The path relative to `base`, if the file is in it."""
    return str(file.relative_to(base) if file.is_relative_to(base) else file)


def _table(exercises: Sequence[OfExercise]) -> Table:
    table = Table(box=None, pad_edge=False, header_style="bold")
    for title in _COLUMNS:
        table.add_column(title, justify="left" if title == "exercise" else "right", no_wrap=True)
    for exercise in exercises:
        table.add_row(sanitize.one_line(exercise.exercise), *_cells([exercise]))
    if len(exercises) > 1:
        table.add_section()
        table.add_row("in all", *_cells(exercises))
    return table


def _cells(exercises: Sequence[OfExercise]) -> list[Text]:
    def total(*fates: Fate) -> int:
        return sum(exercise.count(*fates) for exercise in exercises)

    counts = [total(*Fate), total(Fate.KILLED), total(Fate.BROKEN), total(Fate.ENDLESS)]
    survived = Text(f"{total(Fate.SURVIVED)}", "red" if total(Fate.SURVIVED) else "")
    made = sum(exercise.recorded for exercise in exercises)
    kept = sum(exercise.kept for exercise in exercises)
    recording = sum(exercise.recording for exercise in exercises)
    judging = sum(exercise.judging for exercise in exercises)
    seconds = f"{recording:.0f}+{judging:.1f}"
    return [*(Text(f"{count}") for count in counts), survived, Text(f"{made}/{made + kept}"), Text(seconds)]


def _render(console: Console, mutant: Mutant) -> None:
    first = f"  {mutant.line:>4}  "
    hanging = " " * len(first)
    checks = ", ".join(f"`{check}`" for check in mutant.checks)
    what = f"{mutant.exercise}, {checks}: {mutant.change.operator.value}"
    put_prose(console, with_code(console, sanitize.one_line(what)), first=first)
    put_prose(console, sanitize.one_line(mutant.before), first=f"{hanging}- ")
    put_prose(console, sanitize.one_line(mutant.after), first=f"{hanging}+ ")
    put_prose(console, with_code(console, sanitize.paragraph(suggestion(mutant))), first=f"{hanging}try  ")


def _ending(exercises: Sequence[OfExercise]) -> Text:
    survived = sum(exercise.count(Fate.SURVIVED) for exercise in exercises)
    mutants = sum(exercise.count(*Fate) for exercise in exercises)
    if survived:
        return Text(f"{survived} of {mutants} mutants survived: a mistake is missing for each.", "red")
    if any(exercise.problems for exercise in exercises):
        return Text("Not everything could be judged.", "red")
    noticed = f"All {mutants} mutants were noticed."
    return Text(noticed if mutants else "There was nothing to mutate.", "green")
