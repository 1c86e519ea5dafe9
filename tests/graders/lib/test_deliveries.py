"""What a node logs about the messages that it receives."""

from __future__ import annotations

import pytest

from course.errors import OurFault
from course.evidence.recording import Recording
from course.model.events import Event, OutputLine
from course.model.feedback import Feedback
from lib.deliveries import expect_contents, expect_deliveries
from tests.golden import golden
from tests.grading.expect.conftest import STARTED, TOPIC, log, record, said, sent

SENT = (
    (1.0, 11, "amber brook", "Ann"),
    (2.0, 22, "", "Bob"),
    (3.0, 33, "çà et là", "Cem"),
)
CODE = "\nself.create_subscription(Quote, 'q', self.hear, 10)\nself.get_logger().info(f'x')\nprint(x)\n"


def heard(*events: Event, code: str = CODE) -> Recording:
    return record(STARTED, *(sent(*one) for one in SENT), *events, code=code)


def whole(number: int) -> str:
    _, ident, quote, author = SENT[number]
    return f"{ident}: {quote} ({author})"


def all_logged(*more: Event) -> Recording:
    return heard(*(log(SENT[n][0] + 0.1, whole(n)) for n in range(3)), *more)


def deliveries(recording: Recording) -> Feedback | None:
    return said(expect_deliveries, recording, "talker", TOPIC)


def contents(recording: Recording) -> Feedback | None:
    return said(expect_contents, recording, TOPIC, ("quote", "author", "id"), once="quote")


def test_each_message_is_logged() -> None:
    assert deliveries(all_logged()) is None
    assert contents(all_logged()) is None


def test_one_message_may_take_several_lines() -> None:
    lines = [log(SENT[n][0] + 0.1 * k, str(SENT[n][k])) for n in range(3) for k in (1, 2, 3)]
    assert deliveries(heard(*lines)) is None
    assert contents(heard(*lines)) is None


def test_when_nothing_was_sent_nobody_is_blamed() -> None:
    with pytest.raises(OurFault, match="sent nothing"):
        expect_deliveries(record(STARTED), "talker", TOPIC)


def test_some_are_missing() -> None:
    golden(deliveries(heard(log(1.1, whole(0)), log(3.1, whole(2)))))


def test_a_sleep_is_blamed() -> None:
    golden(deliveries(heard(log(1.1, whole(0)), code="\n\ntime.sleep(5)")))


def test_what_was_logged_before_is_no_answer() -> None:
    golden(deliveries(heard(log(0.5, "ready"))))


def test_printed_and_not_logged() -> None:
    golden(deliveries(heard(OutputLine(0.5, "talker", "ready"), OutputLine(1.1, "talker", whole(0)))))


def test_silent() -> None:
    golden(deliveries(heard(OutputLine(0.5, "talker", "ready"))))


# what is in the log


@pytest.mark.parametrize("text", ["11: amber brook", "amber brook (Ann)", "11: {message.quote} (Ann)"])
def test_a_field_that_is_missing(text: str) -> None:
    golden(contents(heard(log(1.1, text), log(2.1, whole(1)), log(3.1, whole(2)))))


def test_the_first_message_again_and_again() -> None:
    golden(contents(heard(*(log(SENT[n][0] + 0.1, whole(0)) for n in range(3)))))


def test_a_message_that_is_logged_twice() -> None:
    golden(contents(all_logged(log(1.2, whole(0)))))


def test_long_texts_are_cut() -> None:
    recording = record(STARTED, sent(1.0, 1, "x" * 500), log(1.1, "1 Ann"))
    golden(contents(recording))
