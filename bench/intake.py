"""Finds, inspects, and lays out a class, compared with copying or unpacking it without inspection.

The baseline is `shutil.copytree` for folders and `shutil.unpack_archive` for archives, on the same disk.
"""

from __future__ import annotations

import argparse
import shutil
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from table import show

from course.batch.intake import SubmissionKind, find_sources, lay_out, look
from course.content import Exercise, open_course
from course.grading import trial

EXERCISE = "18-publisher"
FORMS = ("folders", "zip", "gztar")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=int, default=500)
    options = parser.parse_args()
    exercises = open_course().exercises()
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as name:
        folder = Path(name)
        home = solved(folder / "home")
        forms = [(form, a_class(folder / form, home, form, options.people)) for form in FORMS]
        forms.append(("one zip of zips", moodle(folder / "moodle", folder / "zip")))
        rows = [row(form, path, folder, exercises) for form, path in forms]
    head = (
        "handed in as",
        "people",
        "find (s)",
        "look (s)",
        "lay out (s)",
        "ours (s)",
        "plain (s)",
        "x plain",
    )
    show(f"{options.people} submissions of the reference solution of {EXERCISE}", head, rows)


def solved(home: Path) -> Path:
    course = open_course()
    home.mkdir()
    trial.lay_solution(course, course.exercise(EXERCISE), home)
    return home


def a_class(folder: Path, home: Path, form: str, people: int) -> Path:
    folder.mkdir()
    packed = home if form == "folders" else Path(shutil.make_archive(str(folder / "packed"), form, home))
    for number in range(people):
        target = folder / f"Person {number}_{1000 + number}_assignsubmission_file_"
        if form == "folders":
            shutil.copytree(home, target)
        else:
            shutil.copy(packed, f"{target}work{''.join(packed.suffixes)}")
    if packed.parent == folder:
        packed.unlink()
    return folder


def moodle(folder: Path, of: Path) -> Path:
    return Path(shutil.make_archive(str(folder), "zip", of))


def row(form: str, path: Path, folder: Path, exercises: tuple[Exercise, ...]) -> list[str]:
    out, plain = folder / "ours", folder / "plain"
    find, sources = timed(lambda: find_sources(path, out / "class"))
    looked, found = timed(lambda: [look(s, out / "opened" / s.person.id, exercises) for s in sources.each])
    laid, _ = timed(lambda: [lay_out(each, out / "homes" / each.person.id) for each in found])
    assert all(each.kind is SubmissionKind.HOME and not each.findings for each in found)
    floor, _ = timed(lambda: plainly(path, plain))
    shutil.rmtree(out)
    shutil.rmtree(plain)
    ours = find + looked + laid
    figures = (find, looked, laid, ours, floor)
    return [form, str(len(found)), *(f"{figure:.2f}" for figure in figures), f"{ours / floor:.1f}"]


def plainly(path: Path, target: Path) -> None:
    if path.is_file():
        shutil.unpack_archive(path, target / "class")
        path = target / "class"
    for number, each in enumerate(sorted(path.iterdir())):
        if each.is_dir():
            shutil.copytree(each, target / str(number))
        else:
            shutil.unpack_archive(each, target / str(number))


def timed(call: Callable[[], object]) -> tuple[float, object]:
    began = time.monotonic()
    result = call()
    return time.monotonic() - began, result


if __name__ == "__main__":
    main()
