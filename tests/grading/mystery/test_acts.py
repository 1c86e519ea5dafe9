"""What a learner should do in a mystery, done or not."""

from __future__ import annotations

import pytest

from course.evidence.recording import Recording
from course.grading.mystery import Mystery
from course.model.events import Acted
from course.model.feedback import Failure

MYSTERY = Mystery("19-x", __file__)
RECORDING = Recording("19-x", (Acted(0.0, "mumbled", "hm"), Acted(0.0, "greeted", "hello")))


def test_what_was_done() -> None:
    MYSTERY.expect_act(RECORDING, "greeted", "Not greeted.", at_home=True)


def test_what_was_not_done() -> None:
    with pytest.raises(Failure) as caught:
        MYSTERY.expect_act(RECORDING, "waved", "Nobody waved.", near_miss="mumbled")
    feedback = caught.value.feedback
    assert (feedback.summary, feedback.seen) == ("Nobody waved.", "`hm`")
    assert "`ros2course play 19-x`" in (feedback.advice or "")
