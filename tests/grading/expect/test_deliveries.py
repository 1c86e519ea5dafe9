"""What a node logs of the messages that it is sent."""

from __future__ import annotations

import pytest

from course.errors import OurFault
from course.evidence.events import Event, OutputLine
from course.evidence.recording import Recording
from course.feedback import Feedback
from course.grading.expect.deliveries import expect_contents, expect_deliveries

from .conftest import STARTED, TOPIC, log, record, said, sent, where

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
    return said(expect_deliveries, recording, "talker", recording.sent(TOPIC))


def contents(recording: Recording) -> Feedback | None:
    return said(expect_contents, recording, recording.sent(TOPIC), ("quote", "author", "id"), once="quote")


def test_each_message_is_logged() -> None:
    assert deliveries(all_logged()) is None
    assert contents(all_logged()) is None


def test_one_message_may_take_several_lines() -> None:
    lines = [log(SENT[n][0] + 0.1 * k, str(SENT[n][k])) for n in range(3) for k in (1, 2, 3)]
    assert deliveries(heard(*lines)) is None
    assert contents(heard(*lines)) is None


def test_when_nothing_was_sent_nobody_is_blamed() -> None:
    with pytest.raises(OurFault, match="sent nothing"):
        expect_deliveries(record(STARTED), "talker", ())


def test_some_are_missing() -> None:
    found = deliveries(heard(log(1.1, whole(0)), log(3.1, whole(2))))
    assert found is not None
    assert found.summary.startswith("The node does not log each message: 1 of 3")
    assert (found.expected, found.seen) == ("3 messages logged", "2 logged")
    assert where(found) == ["talk/talker.py:3"]


def test_a_sleep_is_blamed() -> None:
    found = deliveries(heard(log(1.1, whole(0)), code="\n\ntime.sleep(5)"))
    assert found is not None
    assert "`sleep`" in str(found.advice)
    assert where(found) == ["talk/talker.py:3"]


def test_what_was_logged_before_is_no_answer() -> None:
    found = deliveries(heard(log(0.5, "ready")))
    assert found is not None
    assert found.seen == "0 logged"


def test_printed_and_not_logged() -> None:
    found = deliveries(heard(OutputLine(0.5, "talker", "ready"), OutputLine(1.1, "talker", whole(0))))
    assert found is not None
    assert "`print`" in found.summary
    assert found.seen == f"on the terminal only: {whole(0)}"
    assert where(found) == ["talk/talker.py:4"]


def test_silent() -> None:
    found = deliveries(heard(OutputLine(0.5, "talker", "ready")))
    assert found is not None
    assert found.summary == "3 messages were sent, and the node logged nothing."
    assert where(found) == ["talk/talker.py:2"]


# what is in the log


@pytest.mark.parametrize(
    ("text", "field", "value", "words"),
    [
        ("11: amber brook", "author", "Ann", "Log `author`"),
        ("amber brook (Ann)", "id", "11", "Log `id`"),
        ("11: {message.quote} (Ann)", "quote", "amber brook", "braces"),
    ],
)
def test_a_field_that_is_missing(text: str, field: str, value: str, words: str) -> None:
    found = contents(heard(log(1.1, text), log(2.1, whole(1)), log(3.1, whole(2))))
    assert found is not None
    assert found.summary == f"The log does not hold the `{field}` of a message that was sent."
    assert (found.expected, found.seen) == (value, text)
    assert words in str(found.advice)
    assert where(found) == ["talk/talker.py:3"]


def test_the_first_message_again_and_again() -> None:
    found = contents(heard(*(log(SENT[n][0] + 0.1, whole(0)) for n in range(3))))
    assert found is not None
    assert "The first message is logged again" in str(found.advice)


def test_a_message_that_is_logged_twice() -> None:
    found = contents(all_logged(log(1.2, whole(0))))
    assert found is not None
    assert found.summary == "The same quote is logged 2 times, not once."
    assert found.seen == "2 for the message with id 11"


def test_long_texts_are_cut() -> None:
    recording = record(STARTED, sent(1.0, 1, "x" * 500), log(1.1, "1 Ann"))
    found = contents(recording)
    assert found is not None
    assert found.expected == "x" * 60 + "... (500 letters)"
