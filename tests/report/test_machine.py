"""What `doctor` shows."""

from __future__ import annotations

from typing import TYPE_CHECKING

from course.report.problem import MachineFinding, State, render_findings

if TYPE_CHECKING:
    from tests.report.conftest import Page

GOOD = MachineFinding("ROS 2", State.OK, "jazzy, from pip")
LESS = MachineFinding("bubblewrap", State.LESS, "not installed", "Install it: `sudo apt install bubblewrap`")
MISSING = MachineFinding(
    "g++", State.MISSING, "not found", "Install it: `sudo apt install g++` " + "and so on " * 20
)


def test_each_finding_has_a_mark_and_its_step(page: Page) -> None:
    render_findings(page.console, [GOOD, LESS, MISSING])
    assert "  ok  ROS 2       jazzy, from pip" in page.lines
    assert "  --  bubblewrap  not installed" in page.lines
    assert "                  -> Install it: `sudo apt install bubblewrap`" in page.lines
    assert "  no  g++         not found" in page.lines
    assert max(map(len, page.lines)) <= 80


def test_the_last_line_sums_up(page: Page) -> None:
    render_findings(page.console, [GOOD, MISSING])
    assert page.lines[-1] == "Something that is needed is missing: g++."
    render_findings(page.console, [GOOD, LESS])
    assert page.lines[-1] == "Everything that is needed is here."
    render_findings(page.console, [GOOD])
    assert page.lines[-1] == "All is well."
