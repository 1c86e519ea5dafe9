"""Bytes that are not a message of their type: a learner's failure, as soon as a field is read."""

from __future__ import annotations

import copy

import pytest

from course.errors import OurFault
from course.evidence.messages import Decoder, decoded
from course.model.feedback import Failure

from .conftest import HELLO, STRING

DECODER = Decoder({STRING: "string data"})


def test_what_can_be_read_is_the_message() -> None:
    assert decoded("/talk", STRING, HELLO, DECODER).data == "hello"


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (HELLO.replace(b"hello", b"h\xff\xfelo"), "A string in a message on `/talk` is not valid UTF-8"),
        (HELLO[:9], "A message on `/talk` cannot be read as `std_msgs/msg/String`"),
    ],
)
def test_what_cannot_be_read_blames_the_learner(data: bytes, words: str) -> None:
    found = decoded("/talk", STRING, data, DECODER)
    assert not found
    with pytest.raises(Failure, match=words):
        _ = found.data


def test_python_may_ask_what_it_likes() -> None:
    found = decoded("/talk", STRING, b"", DECODER)
    assert copy.copy(found) == found
    assert found != decoded("/other", STRING, b"", DECODER)
    assert "Unreadable" in repr(found)


def test_what_our_own_decoder_cannot_read_is_our_fault() -> None:
    with pytest.raises(OurFault, match="wstring"):
        decoded("/talk", STRING, HELLO, Decoder({STRING: "wstring data"}))
