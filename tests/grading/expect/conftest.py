"""Recordings made by hand, and what an expectation says about them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from struct import pack
from typing import Any

from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.recording import ROSOUT, ROSOUT_TYPE, Recording
from course.evidence.sources import Sources
from course.model.events import Event, MessageSeen, MessageSent, ProcessStarted
from course.model.feedback import Failure, Feedback

FOLDER = "src/talk"
FILE = f"{FOLDER}/talk/talker.py"
PACKAGES = BuiltPackages((BuiltPackage("talk", FOLDER, "/store/talk", ("talker",)),))
QUOTE = "words/msg/Quote"
TOPIC = "/amazing_quotes"
STARTED = ProcessStarted(0.1, "talker", ("talker",))
DEFINITIONS = {
    QUOTE: "int32 id\nstring quote\nstring author\n",
    ROSOUT_TYPE: "uint32 level\nstring name\nstring msg\n",
    "words/srv/Point_Request": "",
    "words/srv/Point_Response": "",
}


def record(*events: Event, code: str = "", files: Mapping[str, str] | None = None) -> Recording:
    """`code` is the learner's program; `files` are others of the package."""
    others = {f"{FOLDER}/{name}": text for name, text in (files or {}).items()}
    sources = Sources({**others, FILE: code})
    return Recording("x", tuple(sorted(events, key=lambda e: e.t)), DEFINITIONS, sources, PACKAGES, 9.0)


def with_manifest(*lines: str) -> Recording:
    inner = "\n".join(f"  {line}" for line in lines)
    return record(files={"package.xml": f'<package format="3">\n  <name>talk</name>\n{inner}\n</package>\n'})


def said(expect: Callable[..., Any], *args: Any, **kwargs: Any) -> Feedback | None:
    """What a learner reads, or None if all is well."""
    try:
        expect(*args, **kwargs)
    except Failure as failure:
        return failure.feedback
    return None


def told(expect: Callable[..., Any], *args: Any, **kwargs: Any) -> Feedback:
    """What a learner reads; there must be something."""
    found = said(expect, *args, **kwargs)
    assert found is not None
    return found


def where(feedback: Feedback) -> list[str]:
    return [str(place).removeprefix(f"{FOLDER}/") for place in feedback.where]


def _string(text: str, at: int) -> bytes:
    data = text.encode() + b"\0"
    return bytes(-at % 4) + pack("<I", len(data)) + data


def _message(number: int, *texts: str) -> bytes:
    body = pack("<i", number)
    for text in texts:
        body += _string(text, len(body))
    return b"\0\1\0\0" + body


def log(t: float, text: str, level: int = 20, node: str = "talker") -> MessageSeen:
    return MessageSeen(t, ROSOUT, ROSOUT_TYPE, _message(level, node, text))


def sent(t: float, number: int, quote: str, author: str = "Ann") -> MessageSent:
    return MessageSent(t, TOPIC, QUOTE, _message(number, quote, author))
