"""GitHub's job summary: a table, details, and 1 MiB."""

from __future__ import annotations

import pytest

from course.model import replace
from course.model.gradebook import Person
from course.report.gradebook.github import LIMIT, job_summary
from course.report.gradebook.sheets import Sheet, sheets
from tests.report.gradebook import hostile, reading, samples


def summary(*made: Sheet, used: int = 0) -> str:
    return job_summary("The course", (samples.EXERCISE,), made, used=used)


def people(count: int) -> list[Sheet]:
    one = samples.sheet_of(samples.CARL)
    return [replace(one, person=Person(f"p{number}")) for number in range(count)]


def test_everyone_has_a_row_and_who_failed_has_details() -> None:
    text = summary(*sheets(samples.CLASS, samples.CLEANER))
    rows = [line for line in text.splitlines() if line.startswith("|")]
    assert rows[0] == "| id | name | 18-publisher | total |"
    assert "| ada | Ada Okafor | passed, 5 of 5 | 5 of 5 |" in rows
    assert "| dilara | Dilara Aydın | our error | incomplete |" in rows
    assert "| emre | Emre Kaya | not handed in, 0 of 5 | 0 of 5 |" in rows
    assert "## Carl Lind" in text and "## Ada Okafor" not in text
    assert "Left out" not in text


@pytest.mark.slow
def test_no_more_than_github_shows_and_a_note_counts_the_rest() -> None:
    text = summary(*people(3000))
    assert LIMIT - 5000 < len(text.encode("utf-8")) <= LIMIT
    rows = text.count("| p")
    told = text.count("\n### ")
    assert rows == 3000
    assert text.endswith(f"Left out here: details of {3000 - told} exercises. They are in results.json.\n")


def test_rows_are_left_out_last() -> None:
    text = summary(*people(20), used=LIMIT - 1000)
    assert len(text.encode("utf-8")) <= 1000
    rows = text.count("| p")
    assert 0 < rows < 20 and "###" not in text
    assert f"{20 - rows} rows of the table and details of 20 exercises" in text


def test_nothing_is_told_past_what_was_left_out() -> None:
    long = replace(samples.sheet_of(samples.ADA), person=Person("x" * 2000))
    text = summary(*people(2), long, *people(5), used=LIMIT - 1000)
    assert text.count("| p") == 2 and "6 rows of the table" in text


def test_a_full_summary_gets_nothing() -> None:
    assert summary(*people(1), used=LIMIT) == ""


@pytest.mark.parametrize("text", hostile.TEXTS, ids=lambda text: ascii(text[:20]))
def test_hostile_texts_break_no_table(text: str) -> None:
    page = summary(hostile.sheet(text), hostile.sheet("x"))
    assert reading.harm(page) == []
    assert len([token for token in reading.tokens(page) if token.type == "td_open"]) == 8
    headings = [token.tag for token in reading.tokens(page) if token.type == "heading_open"]
    assert headings == ["h1", "h2", "h3", "h2", "h3"]
