"""Gradescope's results.json for one submission: a test for each check, with points and feedback."""

from __future__ import annotations

import io
import json
import re
import zipfile
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

from course.errors import UsageError
from course.model.result import CheckResult, Outcome
from course.report.gradebook.check_words import NOTHING, comments, headline, summary, text_of, total, why
from course.report.gradebook.sheets import INCOMPLETE, Mark, Sheet, tidy


def as_text(sheet: Sheet) -> str:
    """The file as text."""
    return json.dumps(as_data(sheet), ensure_ascii=False, allow_nan=False, indent=2) + "\n"


def as_data(sheet: Sheet) -> dict[str, Any]:
    """The file as JSON types.

    Everything is plain text, because a learner's output could be HTML or Markdown. Everything is visible,
    because one hidden test hides a learner's total. Standard output is not shown: it may reveal the machine.
    """
    return {
        "score": sheet.judged_points,
        "execution_time": round(sheet.seconds, 3),
        "output": "\n".join((_opening(sheet), *map(_line, sheet.marks), *comments(sheet), *sheet.remarks)),
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "visibility": "visible",
        "stdout_visibility": "hidden",
        "tests": [test for place, mark in enumerate(sheet.marks, 1) for test in _tests(mark, place)],
        "extra_data": {"state": sheet.state, "max_points": sheet.judged_max},
    }


def _opening(sheet: Sheet) -> str:
    if sheet.state != INCOMPLETE:
        return f"{summary(sheet)[:1].upper()}{summary(sheet)[1:]}."
    return (
        "Not everything could be checked, through no fault of yours. The score counts only what was; "
        "your instructor can run the autograder again."
    )


def _line(mark: Mark) -> str:
    points = total(mark)
    return f"{mark.exercise.id}: {headline(mark)}{f', {points}' if points else ''}."


def _tests(mark: Mark, place: int) -> Iterator[dict[str, Any]]:
    result = mark.result
    if result is None and not mark.counts:
        yield {**_named(mark, str(place)), "output": f"{headline(mark)}."}
        return
    if result is None:
        scored = {"score": 0, "max_score": 0 if mark.exercise.bonus else tidy(mark.exercise.max_points)}
        yield {**_named(mark, str(place)), **scored, "status": "failed", "output": NOTHING}
        return
    if result.fault:
        yield {**_named(mark, str(place)), "output": text_of(result.fault)}
    elif not result.checks:
        yield {**_named(mark, str(place)), "output": " ".join((f"{headline(mark)}.", *result.notes))}
    for number, check in enumerate(result.checks, 1):
        yield _test(mark, check, f"{place}.{number}")


def _test(mark: Mark, check: CheckResult, place: str) -> dict[str, Any]:
    feedback = why(check)
    output = {"output": text_of(feedback)} if feedback else {}
    return {**_named(mark, place, check.title), **_scored(mark, check), **output}


def _named(mark: Mark, place: str, title: str = "") -> dict[str, str]:
    return {"number": place, "name": f"{mark.exercise.id}: {title or mark.exercise.title}"}


def _scored(mark: Mark, check: CheckResult) -> dict[str, Any]:
    """Return nothing if there are no points: then the check neither counts nor looks failed."""
    if not mark.counts or check.outcome in (Outcome.NOT_APPLICABLE, Outcome.ERROR):
        return {}
    is_bonus = check.bonus or mark.exercise.bonus
    status = "passed" if check.outcome is Outcome.PASSED else "failed"
    return {"score": tidy(check.earned), "max_score": 0 if is_bonus else tidy(check.points), "status": status}


_SCRIPTS = ("setup.sh", "run_autograder")
_WHEEL = re.compile(r"ros2course-[0-9][A-Za-z0-9._+]*-py3-none-any\.whl")


@dataclass(frozen=True)
class Packed:
    """One file of a zip, or a folder, if its path ends with a slash."""

    path: str
    content: bytes
    executable: bool = False


def bundle(
    wheel_name: str,
    wheel: bytes,
    exercises: Iterable[str],
    course: Mapping[str, bytes] | None = None,
    *,
    contained: bool = True,
) -> tuple[Packed, ...]:
    """The contents of the zip.

    wheel_name, wheel: ros2course as `pip wheel --no-deps` makes it. exercises: ids or chapter numbers, as
    for `grade --exercises`. course: another course's files by their relative paths.
    contained: refuse to grade if submissions cannot be contained.
    Raises UsageError if the wheel is not one of ours.
    """
    if not _WHEEL.fullmatch(wheel_name) or not zipfile.is_zipfile(io.BytesIO(wheel)):
        advice = "Make it with: pip wheel --no-deps -w wheels ."
        raise UsageError("This is not a wheel of ros2course.", advice)
    own = (Packed(name, _script(name), executable=True) for name in _SCRIPTS)
    chosen = Packed("exercises.txt", ",".join(exercises).encode("utf-8"))
    others = (Packed(f"course/{path}", content) for path, content in sorted((course or {}).items()))
    trusting = () if contained else (Packed("no-sandbox", b""),)
    return (*own, Packed(wheel_name, wheel), chosen, *trusting, *others)


def zipped(packed: Iterable[Packed]) -> bytes:
    """The zip itself; the same files always give the same bytes."""
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in packed:
            entry = zipfile.ZipInfo(file.path)  # with a date of 1980, always
            entry.create_system = 3  # Unix, so that the mode counts
            folder = file.path.endswith("/")
            mode = 0o40755 if folder else 0o100755 if file.executable else 0o100644
            entry.external_attr = mode << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, file.content)
    return target.getvalue()


def _script(name: str) -> bytes:
    return (files("course.report.gradebook") / "scripts" / name).read_bytes()
