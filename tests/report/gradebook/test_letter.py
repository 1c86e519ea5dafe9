"""The feedback file of one learner."""

from __future__ import annotations

import pytest

from course.model import replace
from course.model.gradebook import GradedSubmission, Person
from course.model.result import not_applicable
from course.report.gradebook.letter import letter, prose
from tests.report.gradebook import hostile, reading, samples


def lines(graded: GradedSubmission) -> list[str]:
    text = letter(samples.sheet_of(graded), "The course")
    assert reading.harm(text) == []
    return text.splitlines()


def test_a_pass_is_short() -> None:
    told = lines(samples.ADA)
    assert told[0] == "# Feedback for Ada Okafor"
    assert "The course: 5 of 5 points." in told
    assert "**Passed**: 5 of 5 points." in told
    assert "- **ok** the packages build (1)" in told


def test_a_failure_says_cause_comparison_place_and_advice() -> None:
    told = lines(samples.BAO)
    assert "**Not passed yet**: 3 of 5 points." in told
    assert "- **no** it has a publisher on /amazing_quote (0 of 1)" in told
    assert "  The node publishes on `/amazing_quotes`, not `/amazing_quote`." in told
    assert "  - expected: /amazing_quote" in told
    assert "  - seen: /amazing_quotes" in told
    assert "  - try: Spell the topic's name exactly like this: `amazing_quote`." in told
    assert any(line.startswith("  - in: `ros2_tutorial") and line.endswith(".py:21`") for line in told)
    assert '  Not judged: needs "it has a publisher on /amazing_quote"' in told


def test_evidence_is_a_block_of_code() -> None:
    told = lines(samples.CARL)
    start = told.index("  ```text")
    assert told[start + 2].startswith("      self.publishers = self.create_publisher(AmazingQuote, ")
    assert "Note: Handed in twice; the last one counts." in told


def test_our_error_is_no_failure_and_owes_a_verdict() -> None:
    told = lines(samples.DILARA)
    assert "**The course itself has an error**." in told
    assert any(line.startswith("Something could not be checked, through no fault of yours") for line in told)
    assert not any("60 s" in line or "Traceback" in line for line in told)


def test_nothing_was_found() -> None:
    told = lines(samples.EMRE)
    assert "**Not handed in**: 0 of 5 points." in told
    assert any(line.startswith("Nothing of yours was found.") for line in told)


def test_what_does_not_apply_says_so() -> None:
    told = lines(
        GradedSubmission(Person("a"), "a.zip", (not_applicable("18-publisher", "It is about a screen."),))
    )
    assert "**Does not apply here**." in told and "Note: It is about a screen." in told


@pytest.mark.parametrize("text", hostile.TEXTS, ids=lambda text: ascii(text[:20]))
def test_hostile_texts_stay_in_their_places(text: str) -> None:
    page = letter(hostile.sheet(text), "The course")
    page.encode("utf-8")
    assert reading.harm(page) == []
    headings = [token.tag for token in reading.tokens(page) if token.type == "heading_open"]
    assert headings == ["h1", "h2"]
    fences = [token for token in reading.tokens(page) if token.type == "fence"]
    assert len(fences) == 1


def test_tags_and_points_read_well_as_plain_text() -> None:
    assert prose("Add <depend>rclpy</depend> (or <name>).") == "Add `<depend>rclpy</depend>` (or `<name>`)."
    assert prose("<depend>rclpy</depend>") == "`<depend>rclpy</depend>`"
    assert prose("<a> or `b`, not `c`<d>") == "`<a>` or `b`, not `c`&lt;d&gt;"
    assert prose("12.5 of 13, 2. or 3) no list") == "12.5 of 13, 2. or 3) no list"
    assert (prose("2. A list"), prose("3)")) == ("2\\. A list", "3\\)")
    assert prose("1 < 2 <b>bold") == "1 &lt; 2 &lt;b&gt;bold"


def test_what_cannot_be_read_is_not_nothing() -> None:
    told = lines(replace(samples.EMRE, source="emre.rar", remarks=("This is no zip and no tar.",)))
    assert "Nothing that can be graded was found in what you handed in. The note says why." in told
