"""All reports of a class in one folder."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from course.report.gradebook import document, gradescope, junit, spreadsheet
from course.report.gradebook.cleaning import Cleaner
from course.report.gradebook.files import file_stem, write
from course.report.gradebook.letter import letter
from course.report.gradebook.model import Gradebook
from course.report.gradebook.sheets import Sheet, exercises_of, sheets
from course.report.gradebook.unique import Names


def write_reports(folder: Path, gradebook: Gradebook, cleaner: Cleaner) -> None:
    """results.csv, results.json, junit.xml, and for each person feedback/NAME.md and gradescope/NAME.json.

    Memory stays flat: the gradebook is walked five times, and one submission is held at a time.
    Raises StorageError.
    """
    course = cleaner.prose(gradebook.course)

    def walk() -> Iterator[Sheet]:
        return sheets(gradebook, cleaner)

    write(folder / "results.csv", spreadsheet.rows(exercises_of(gradebook, cleaner), walk()))
    write(folder / "results.json", document.pieces(gradebook, cleaner, walk()))
    write(folder / "junit.xml", junit.pieces(course, gradebook.began, walk))
    names = Names()
    for sheet in walk():
        name = names.unique(file_stem(sheet.person.id))
        write(folder / "feedback" / f"{name}.md", [letter(sheet, course)])
        write(folder / "gradescope" / f"{name}.json", [gradescope.as_text(sheet)])
