"""A verdict as text: marks, causes, places, points; and a submission's text stays in its place."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import TYPE_CHECKING

from course.model import replace
from course.model.result import (
    CheckResult,
    Doubt,
    Feedback,
    Location,
    Outcome,
    Result,
    Timing,
    Verdict,
    not_applicable,
)
from course.report.verdict import render_result, render_so_far

if TYPE_CHECKING:
    from tests.report.conftest import Page

LONG = (
    "ros2_tutorial_workspace/src/a_package_with_a_long_name/a_package_with_a_long_name/the_publisher_node.py"
)


@dataclass(frozen=True)
class Named:
    id: str = "18-publisher"
    title: str = "A publisher"


BUILDS = CheckResult("builds", "The package builds", 1, Outcome.PASSED)
TOPIC = CheckResult(
    "topic",
    "Publishes on /amazing_quote",
    2,
    Outcome.FAILED,
    feedback=Feedback(
        "Nothing is published on `/amazing_quote`, but /amazing_quotes exists: one letter too many.",
        expected="/amazing_quote",
        seen="/amazing_quotes",
        where=(Location(LONG, 12),),
        advice="Compare the name in `create_publisher` with the task's.",
        details=("Traceback (most recent call last):", "  File x"),
    ),
)
RATE = CheckResult("rate", "Twice per second", 2, Outcome.SKIPPED, skipped_because="no topic to time")
EXTRA = CheckResult("extra", "Stops when told", 0.5, Outcome.PASSED, bonus=True)
FAILED = Result("18-publisher", Verdict.NOT_PASSED, (BUILDS, TOPIC, RATE, EXTRA), Timing(0.1, 2.4, 3.0))
HOSTILE = "\x1b[31m\x1b]0;owned\x07[red]markup[/red] :smile: \u202eabc\x07\rgone" + "y" * 100_000


def test_a_busy_machine_is_no_fault_of_the_course(page: Page) -> None:
    fault = Feedback("This machine was too busy to judge.")
    busy = replace(FAILED, verdict=Verdict.OUR_ERROR, fault=fault, doubt=Doubt.BUSY)
    render_result(page.console, busy, Named())
    assert "Could not be judged now. This attempt does not count." in page.text
    assert "too busy to judge" in page.text


def test_every_check_has_a_mark_its_title_and_its_points(page: Page) -> None:
    render_result(page.console, FAILED, Named())
    assert page.lines[0] == "18-publisher  A publisher"
    assert re.search(r"^  ok  The package builds +1$", page.text, re.M)
    assert re.search(r"^  no  Publishes on /amazing_quote +0 of 2$", page.text, re.M)
    assert re.search(r"^  --  Twice per second +0 of 2$", page.text, re.M)
    assert re.search(r"^  ok  Stops when told +bonus 0.5$", page.text, re.M)


def test_a_failure_says_cause_comparison_place_advice_and_evidence(page: Page) -> None:
    render_result(page.console, FAILED, Named())
    assert "      Nothing is published on `/amazing_quote`, but /amazing_quotes exists: one" in page.lines
    assert "      expected  /amazing_quote" in page.lines
    assert "      seen      /amazing_quotes" in page.lines
    assert f"      in        {LONG}:12" in page.lines, "a place stays whole, to be copied"
    assert "      try       Compare the name in `create_publisher` with the task's." in page.lines
    assert "      |   File x" in page.lines


def test_what_is_certain_before_the_cause_is_known(page: Page) -> None:
    render_so_far(page.console, FAILED)
    assert "not passed" in page.text.lower()
    lines = [line for line in page.text.splitlines() if line.startswith("  failed: ")]
    assert len(lines) == sum(check.outcome is Outcome.FAILED for check in FAILED.checks)


def test_a_skipped_check_names_its_cause(page: Page) -> None:
    render_result(page.console, FAILED, Named())
    assert "      Not judged: no topic to time" in page.lines


def test_the_total_names_the_bonus_beside_the_points(page: Page) -> None:
    render_result(page.console, FAILED, Named())
    assert "  Not passed yet: 1 of 5 points, bonus 0.5.  [built in 0.1 s, watched for 2.4 s]" in page.lines


def test_what_changed_since_the_last_time(page: Page) -> None:
    passed_topic = replace(TOPIC, outcome=Outcome.PASSED, feedback=None)
    before = replace(FAILED, checks=(BUILDS, passed_topic, RATE, EXTRA))
    render_result(page.console, FAILED, Named(), before)
    assert "      This check passed last time." in page.lines
    assert "(last time 3.5)" in page.text


def test_what_failed_before_is_no_news(page: Page) -> None:
    render_result(page.console, FAILED, Named(), FAILED)
    assert "the last time" not in page.text and "last time" not in page.text


def test_a_pass_is_said_plainly(page: Page) -> None:
    render_result(page.console, Result("18-publisher", Verdict.PASSED, (BUILDS,)), Named())
    assert "  Passed: 1 of 1 point." in page.lines


def test_our_error_is_no_failure_of_the_learner(page: Page) -> None:
    fault = Feedback("the recorder ended early", details=("RuntimeError: x",))
    render_result(page.console, Result("18-publisher", Verdict.OUR_ERROR, fault=fault), Named())
    assert "  The course itself has an error. This attempt does not count." in page.lines
    assert "      the recorder ended early" in page.lines
    assert "points" not in page.text


def test_nothing_is_wider_than_the_terminal_but_places(page: Page) -> None:
    render_result(page.console, FAILED, Named())
    assert [line for line in page.lines if len(line) > 80] == [f"      in        {LONG}:12"]


def test_colour_only_adds_to_the_words(page: Page, colour_page: Page) -> None:
    render_result(page.console, FAILED, Named())
    render_result(colour_page.console, FAILED, Named())
    without = re.sub(r"\x1b\[[0-9;]*m", "", colour_page.text)
    assert "\x1b[1;32mok" in colour_page.text
    assert without == page.text.replace("`", "")


def hostile_result() -> Result:
    feedback = Feedback(
        HOSTILE,
        expected=HOSTILE,
        seen=HOSTILE,
        where=(Location(f"src/{HOSTILE}\nno.py", 3),),
        advice=HOSTILE,
        details=tuple([HOSTILE] * 500),
    )
    checks = (
        CheckResult("a", HOSTILE, 1, Outcome.FAILED, feedback=feedback),
        CheckResult("b", "b", 1, Outcome.SKIPPED, skipped_because=HOSTILE),
    )
    return Result("x", Verdict.NOT_PASSED, checks, fault=feedback, notes=(HOSTILE,))


def test_hostile_text_stays_text(page: Page) -> None:
    render_result(page.console, hostile_result(), Named())
    assert not re.search(r"[\x00-\x09\x0b-\x1f\x7f-\x9f\u202a-\u202e]", page.text)
    assert "owned" not in page.text
    assert "[red]markup[/red] :smile:" in page.text
    assert "src/[red]markup" in page.text and "no.py" not in page.lines


def test_hostile_text_brings_no_style_of_its_own(colour_page: Page) -> None:
    render_result(colour_page.console, hostile_result(), Named())
    assert "\x1b]" not in colour_page.text
    assert set(re.findall(r"\x1b\[[0-9;?]*([A-Za-z])", colour_page.text)) == {"m"}


def test_hostile_amounts_are_cut(page: Page) -> None:
    render_result(page.console, hostile_result(), Named())
    assert len(page.text) < 100_000
    assert "... 460 more lines ..." in page.text


def test_what_does_not_apply_says_why_and_costs_nothing(page: Page) -> None:
    gone = CheckResult(
        "index", "Is installed", 2, Outcome.NOT_APPLICABLE, skipped_because="No `index` can be reached."
    )
    render_result(page.console, Result("x", Verdict.PASSED, (BUILDS, gone)), Named())
    assert re.search(r"^  \.\.  Is installed$", page.text, re.M)
    assert "      Does not count here: No `index` can be reached." in page.lines
    assert "  Passed: 1 of 1 point." in page.text


def test_a_whole_exercise_that_does_not_apply(page: Page) -> None:
    render_result(page.console, not_applicable("x", "It is about your own machine."), Named())
    assert "  Does not apply here. This attempt does not count." in page.text
    assert "  Note: It is about your own machine." in page.text
