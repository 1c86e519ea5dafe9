"""results.csv, as a spreadsheet reads it."""

from __future__ import annotations

import csv
import io
import unicodedata

import pytest

from course.report.gradebook import class_files
from course.report.gradebook.sheets import sheets
from tests.report.gradebook import hostile, samples


def read(*graded: samples.Graded) -> list[dict[str, str]]:
    text = "".join(class_files.rows((samples.EXERCISE,), sheets(samples.gradebook(*graded), hostile.CLEANER)))
    assert text.startswith("\ufeffid,name,") and text.count("\ufeff") == 1
    assert text.endswith("\r\n")
    return list(csv.DictReader(io.StringIO(text.removeprefix("\ufeff"), newline="")))


def test_zero_nothing_and_our_error_can_be_told_apart() -> None:
    ada, bao, dilara, emre = read(samples.ADA, samples.BAO, samples.DILARA, samples.EMRE)
    assert ada["18-publisher points"] == ada["total"] == "5" and ada["18-publisher verdict"] == "passed"
    assert (bao["18-publisher points"], bao["18-publisher max"], bao["total"]) == ("3", "5", "3")
    assert (dilara["18-publisher points"], dilara["18-publisher verdict"]) == ("", "our error")
    assert (dilara["total"], dilara["total max"], dilara["state"]) == ("", "", "incomplete")
    assert (emre["18-publisher points"], emre["18-publisher verdict"]) == ("0", "not handed in")
    assert (emre["total"], emre["state"]) == ("0", "not handed in")


@pytest.mark.parametrize("text", hostile.TEXTS, ids=lambda text: ascii(text[:20]))
def test_no_cell_is_a_formula_and_no_row_breaks(text: str) -> None:
    (row,) = read(hostile.graded(text))
    assert row["state"] == "complete" and None not in row
    for cell in row.values():
        for part in cell.split(";"):
            assert not _first_visible(part).startswith(tuple("=+-@＝＋－＠\t")), cell
        assert "\n" not in cell and "\r" not in cell


def test_a_name_that_begins_like_a_formula_stays_readable() -> None:
    assert class_files.guarded("=cmd()") == "'=cmd()"
    assert class_files.guarded("  @x") == "  '@x"
    assert class_files.guarded("a; =b") == "a; '=b"
    for sign in "=+-@\uff1d\uff0b\uff0d\uff20":
        assert class_files.guarded(f"{sign}1") == f"'{sign}1"
    assert class_files.guarded("Anne-Marie O'Neil (a=b)") == "Anne-Marie O'Neil (a=b)"


def test_a_row_is_there_before_the_next_submission_is_read() -> None:
    def endless():  # type: ignore[no-untyped-def]
        yield samples.sheet_of(samples.ADA)
        raise AssertionError("read ahead")

    lines = class_files.rows((samples.EXERCISE,), endless())
    assert next(lines).startswith("\ufeffid")
    assert next(lines).startswith("ada,")


def _first_visible(text: str) -> str:
    return "".join(c for c in text if unicodedata.category(c) not in ("Zs", "Cf"))[:1]
