"""Chapter 33: whose solutions a program prints, its own or those of a library."""

from __future__ import annotations

from pathlib import Path

import pytest

from course.evidence.events import OutputLine
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.feedback import Failure
from course.grading.load import load_module

GRADERS = load_module(Path(__file__).parents[2] / "graders/ch33_cmake_without_sudo.py")
PRINTED = ("0.5 -1.5 -0.0625", "0 -1 -1.25")


def run(*used: str) -> Recording:
    """Of a program that prints the same, whatever tinyqp it is given. used: what `nm` and `ldd` say of it."""
    said = {"solve": PRINTED, "with other": PRINTED, "used": used}
    events = (OutputLine(1.0, process, text) for process, lines in said.items() for text in lines)
    return Recording("x", tuple(events), sources=Sources({}))


@pytest.mark.parametrize(
    "used",
    [
        "                 U qpOASES::QProblem::init(double const*, double const*, double const*)",
        "0000000000001b40 T qpOASES::QProblem::QProblem(int, int)",
        "\tlibqpOASES.so.3.2 => /home/learner/opt/lib/libqpOASES.so.3.2 (0x00007f0000000000)",
        "0000000000001b40 T tinyqp::solve(tinyqp::Problem const&)",
    ],
)
def test_what_another_library_or_a_static_one_has_computed_counts(used: str) -> None:
    GRADERS.computed(run(used))


def test_numbers_that_stand_in_the_program_do_not() -> None:
    with pytest.raises(Failure, match="no library has computed"):
        GRADERS.computed(run())
