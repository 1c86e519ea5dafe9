"""What stands in a recording where a message came that cannot be read."""

from __future__ import annotations

from typing import Any

from course.errors import OurFault
from course.evidence.messages import Decoder, Undecodable
from course.feedback import Failure, Feedback


class Unreadable:
    """In place of a message's fields; whoever asks for one of them raises the learner's Failure.

    It is false, where a message is true. source: the topic or service that it came on.
    """

    def __init__(self, source: str, type_name: str, error: Undecodable) -> None:
        self._feedback = _feedback(source, type_name, error)

    def __bool__(self) -> bool:
        return False

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Unreadable) and other._feedback == self._feedback

    def __hash__(self) -> int:
        return hash(self._feedback)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):  # Python's own questions, such as those of copy
            raise AttributeError(name)
        raise Failure(self._feedback)


def decoded(source: str, type_name: str, data: bytes, decoder: Decoder) -> Any:
    """The message's fields as attributes; an `Unreadable` when the bytes are none of that type.

    Raises OurFault for a type whose fields our own decoder does not know.
    """
    try:
        return decoder.decode(type_name, data)
    except Undecodable as error:
        if isinstance(error.__cause__, NotImplementedError):
            raise OurFault(f"{type_name} cannot be decoded here: {error.__cause__}") from error
        return Unreadable(source, type_name, error)


def _feedback(source: str, type_name: str, error: Undecodable) -> Feedback:
    if isinstance(error.__cause__, UnicodeDecodeError):
        return Feedback(
            summary=f"A text in a message on `{source}` is not valid UTF-8, so nobody can read the message.",
            expected="text in UTF-8",
            seen=f"bytes that are none: {error.__cause__.reason}",
            advice="Put text into string fields as it is, and do not encode it or cut its bytes.",
        )
    return Feedback(
        summary=f"A message on `{source}` cannot be read as `{type_name}`.",
        expected=f"the fields of {type_name}, in their order",
        seen=f"other bytes: {error}",
        advice=f"Does the program use a `{type_name}` with other fields? Build its package anew.",
    )
