"""What a learner was to do in a mystery, done or not."""

from __future__ import annotations

import pytest

from course.evidence.acts import Act
from course.evidence.events import Acted
from course.evidence.recording import Recording
from course.feedback import Failure
from course.grading.expect.acts import expect_act

RECORDING = Recording("19-x", (Acted(0.0, "mumbled", "hm"), Acted(0.0, "greeted", "hello")))


def test_what_was_done() -> None:
    assert expect_act(RECORDING, "greeted", "Not greeted.") == Act("greeted", "hello")


def test_what_was_not_done() -> None:
    with pytest.raises(Failure) as caught:
        expect_act(RECORDING, "waved", "Nobody waved.", near_miss="mumbled")
    feedback = caught.value.feedback
    assert (feedback.summary, feedback.seen) == ("Nobody waved.", "`hm`")
    assert "`ros2course play 19-x`" in (feedback.advice or "")
