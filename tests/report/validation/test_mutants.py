"""How weakened graders are shown."""

from __future__ import annotations

import io

import pytest

from course.report.console import open_console
from course.report.validation.mutants import MutantsRow, Survivor, render_mutants

SURVIVOR = Survivor(
    "graders/x.py", 12, "18-publisher", ["rate"], "a bound made wider", "a < 1", "a < \x1b[31m2", "add `one`"
)


def row(**counts: int) -> MutantsRow:
    every = {"killed": 3, "broken": 2, "endless": 1, "survived": 0, "recorded": 4, "kept": 5, **counts}
    return MutantsRow("18-publisher", recording=12.3, judging=4.56, **every)


def shown(rows: list[MutantsRow], survivors: list[Survivor]) -> list[str]:
    stream = io.StringIO()
    render_mutants(open_console(stream, width=90), rows, survivors)
    return stream.getvalue().splitlines()


def test_all_noticed() -> None:
    head, line, *_, end = shown([row()], [])
    assert head.split() == "exercise mutants killed broken endless survived recorded seconds".split()
    assert line.split() == ["18-publisher", "6", "3", "2", "1", "0", "4/9", "12+4.6"]
    assert end == "All 6 mutants were noticed."


def test_survivors_by_line() -> None:
    lines = shown([row(survived=1), row()], [SURVIVOR])
    assert lines[lines.index("graders/x.py") :] == [
        "graders/x.py",
        "    12  18-publisher, `rate`: a bound made wider",
        "        - a < 1",
        "        + a < 2",
        "        try  add `one`",
        "",
        "1 of 13 mutants survived: a mistake is missing for each.",
    ]
    assert any(line.split()[:5] == ["in", "all", "13", "6", "4"] for line in lines)


@pytest.mark.parametrize(
    ("rows", "end"),
    [
        ([MutantsRow("x", 0, 0, 0, 0, 0, 0, 0, 0, ["it does not build"])], "Not everything could be judged."),
        ([], "There was nothing to mutate."),
    ],
)
def test_endings(rows: list[MutantsRow], end: str) -> None:
    lines = shown(rows, [])
    assert lines[-1] == end
    assert any("it does not build" in line for line in lines) is bool(rows)
