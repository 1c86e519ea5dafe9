"""What a submission sends on the network: packets like those of the middleware, changed at random.

A wrong node sends them to the grading process while it is watched. It must not pass, and not be our error.
"""

from __future__ import annotations

import os
import random

import pytest

from course.arena.lateness import Lateness
from course.model.result import Verdict
from tests.hostile.fuzz.conftest import CORPUS
from tests.hostile.test_blame import wrong
from tests.hostile.world import NODE, Grade, judged, with_attack

pytestmark = pytest.mark.slow
RATE = 2000
GUARANTEE = "odd packets are no fault of the grader"
# The seeds that once found something, and others.
SEEDS = [
    *CORPUS.get("test_packets", []),
    *(None for _ in range(round(float(os.environ.get("ROS2COURSE_FUZZ", "1"))))),
]


@pytest.mark.parametrize("number", range(len(SEEDS)))
def test_packets(grade: Grade, machine: Lateness, request: pytest.FixtureRequest, number: int) -> None:
    drawn = random.Random(f"packets {request.config.getoption('hypothesis_seed')} {number}").getrandbits(32)
    seed = drawn if SEEDS[number] is None else SEEDS[number]
    text = wrong(with_attack("odd_packets", SEED=seed, RATE=RATE))
    graded = grade({NODE: text}, guarantee=GUARANTEE)
    assert judged(graded, machine, GUARANTEE) is Verdict.NOT_PASSED, (seed, graded.result)
    assert "500 packets were sent" in graded.printed, (seed, graded.all_words)
