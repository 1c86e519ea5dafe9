"""Chapter 33: whether a program prints its own solutions or those of a library."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import pytest

from course.errors import OurFault
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.grading.load import load_module
from course.model.events import OutputLine
from course.model.feedback import Failure

GRADERS = load_module(Path(__file__).parents[2] / "graders/ch33_cmake_without_sudo.py")
RIGHT = ("0.5 -1.5 -0.0625", "0 -1 -1.25")
ELSEWHERE = ("0.9 -1.1 0.85", "0.35 -0.8 -0.63")
IN_PLACE = ("1.25 -0.75 2.04", "0.75 -0.75 0.05")
RUNS = GRADERS.RUNS


def recorded(*runs: Sequence[str], used: Sequence[str] = (), known: bool = True) -> Recording:
    """A recording of a program that prints this, with the learner's library, another one, and rebuilt."""
    said = {**dict(zip(RUNS, runs, strict=False)), "used": used}
    if known:
        said |= {f"answers {GRADERS.ELSEWHERE}": ELSEWHERE, f"answers {GRADERS.IN_PLACE}": IN_PLACE}
    events = [OutputLine(1.0, process, text) for process, lines in said.items() for text in lines]
    return Recording("x", tuple(events), sources=Sources({}))


@pytest.mark.parametrize(
    "asked",
    [
        recorded(RIGHT, IN_PLACE),
        recorded(RIGHT, [f"solution: {line}" for line in IN_PLACE]),
        recorded(RIGHT, RIGHT, IN_PLACE),  # linked statically
        recorded(RIGHT, RIGHT, RIGHT, used=["U qpOASES::QProblem::init(double const*)"]),
        recorded(RIGHT, RIGHT, RIGHT, used=["libqpOASES.so.3.2 => /home/learner/opt/lib/libqpOASES.so.3.2"]),
    ],
)
def test_who_prints_the_library_s_answers_has_asked_it(asked: Recording) -> None:
    GRADERS.computed(asked)
    GRADERS.local(asked)


@pytest.mark.parametrize(
    "printed",
    [
        recorded(RIGHT),
        recorded(RIGHT, RIGHT, RIGHT),
        recorded(RIGHT, ELSEWHERE, ELSEWHERE),
        recorded(RIGHT, IN_PLACE[:1], ()),
        recorded(RIGHT, (IN_PLACE[0], RIGHT[1]), IN_PLACE[::-1]),
        recorded(RIGHT, (*RIGHT, *IN_PLACE), ()),
    ],
)
def test_numbers_that_stand_in_the_program_do_not_count(printed: Recording) -> None:
    with pytest.raises(Failure, match="the library did not compute"):
        GRADERS.computed(printed)


def test_whose_answers_are_those_of_another_copy_has_found_that_one() -> None:
    found = recorded(ELSEWHERE, ELSEWHERE, ELSEWHERE)
    GRADERS.computed(found)
    with pytest.raises(Failure, match="another tinyqp"):
        GRADERS.local(found)


def test_without_the_libraries_answers_nobody_is_blamed() -> None:
    with pytest.raises(OurFault):
        GRADERS.computed(recorded(RIGHT, RIGHT, known=False))
