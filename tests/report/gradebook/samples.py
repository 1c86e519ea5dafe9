"""The samples in docs/results.md: what the formats make of five results that real checks gave.

    .venv/bin/python -m tests.report.gradebook.samples           write them again
    .venv/bin/python -m tests.report.gradebook.samples --check   exit 1 if they are not fresh

The results in data/ are those of `check 18-publisher --json`, with five of the eleven checks.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable
from datetime import datetime, timezone
from pathlib import Path

from course.model.feedback import Feedback
from course.model.gradebook import Gradebook, GradedExercise, GradedSubmission, Person
from course.model.result import Result, Verdict, from_json
from course.report.gradebook import class_files, github, gradescope, junit
from course.report.gradebook.cleaning import Cleaner
from course.report.gradebook.github import job_summary
from course.report.gradebook.letter import letter
from course.report.gradebook.sheets import Sheet, sheets

DOCUMENT = Path(__file__).parents[3] / "docs" / "results.md"
DATA = Path(__file__).parent / "data"
SCHEMA = json.loads(Path(class_files.__file__).with_name("results.schema.json").read_text(encoding="utf-8"))
REGION = re.compile(r"<!-- sample:(\w+) -->\n.*?<!-- end -->", re.DOTALL)
EXERCISE = GradedExercise("18-publisher", "A publisher", 5)
BEGAN = datetime(2026, 3, 2, 9, 0, tzinfo=timezone.utc)
ENDED = datetime(2026, 3, 2, 9, 0, 14, tzinfo=timezone.utc)


def result(name: str) -> Result:
    return from_json((DATA / f"{name}.json").read_text(encoding="utf-8"))


def our_error() -> Result:
    fault = Feedback("The grading process did not finish within 60 s.", details=("Traceback ...",))
    return Result("18-publisher", Verdict.OUR_ERROR, fault=fault)


def gradebook(*graded: GradedSubmission) -> Gradebook:
    return Gradebook("ROS 2, step by step", (EXERCISE,), graded, BEGAN, ENDED, "namespaces")


ADA = GradedSubmission(Person("ada", "Ada Okafor"), "ada.zip", (result("right"),))
BAO = GradedSubmission(Person("bao", "Bảo Nguyễn"), "bao.zip", (result("plural"),))
CARL = GradedSubmission(
    Person("carl", "Carl Lind"), "carl.tar.gz", (result("crash"),), ("Handed in twice; the last one counts.",)
)
DILARA = GradedSubmission(Person("dilara", "Dilara Aydın"), "dilara.zip", (our_error(),))
EMRE = GradedSubmission(Person("emre", "Emre Kaya"), "")
CLASS = gradebook(ADA, BAO, CARL, DILARA, EMRE)
CLEANER = Cleaner()


def sheet_of(graded: GradedSubmission, cleaner: Cleaner = CLEANER) -> Sheet:
    (sheet,) = sheets(gradebook(graded), cleaner)
    return sheet


def csv() -> str:
    return _block("text", "".join(class_files.rows((EXERCISE,), sheets(CLASS, CLEANER))).lstrip("\ufeff"))


def results() -> str:
    only = gradebook(BAO)
    text = "".join(class_files.pieces(only, CLEANER, sheets(only, CLEANER)))
    return _block("json", json.dumps(json.loads(text), indent=2, ensure_ascii=False))


def xml() -> str:
    return _block(
        "xml", "".join(junit.pieces(CLASS.course, BEGAN, lambda: sheets(gradebook(BAO, DILARA), CLEANER)))
    )


def scope() -> str:
    return _block("json", gradescope.as_text(sheet_of(BAO)))


def room() -> str:
    return _block("json", json.dumps(github.as_data(sheet_of(BAO)), indent=2, ensure_ascii=False))


def page() -> str:
    return _block("markdown", job_summary(CLASS.course, (EXERCISE,), sheets(gradebook(ADA, CARL), CLEANER)))


def note() -> str:
    return _block("text", "\n".join(github.commands(sheet_of(BAO))))


def mail() -> str:
    return _block("markdown", letter(sheet_of(CARL), CLASS.course))


SAMPLES: dict[str, Callable[[], str]] = {
    "csv": csv,
    "json": results,
    "junit": xml,
    "gradescope": scope,
    "classroom": room,
    "summary": page,
    "annotations": note,
    "letter": mail,
}


def fresh(text: str) -> str:
    """The document with every sample made again."""
    return REGION.sub(lambda match: _region(match[1]), text)


def _region(name: str) -> str:
    return f"<!-- sample:{name} -->\n{SAMPLES[name]()}<!-- end -->"


def _block(kind: str, text: str) -> str:
    # Four, since the samples of Markdown hold blocks of three.
    return f"````{kind}\n{text.strip()}\n````\n".replace("\r\n", "\n")


def main() -> int:
    before = DOCUMENT.read_text(encoding="utf-8")
    after = fresh(before)
    if "--check" in sys.argv:
        return int(after != before)
    DOCUMENT.write_text(after, encoding="utf-8")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
