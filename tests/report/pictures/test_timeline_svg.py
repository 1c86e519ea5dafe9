"""The time line: what is on it, and that it is a sound and small picture."""

from __future__ import annotations

from collections.abc import Callable
from xml.etree import ElementTree

import pytest

from course.evidence.recording import Recording
from course.model import events as kinds
from course.report.gradebook.cleaning import Cleaner
from course.report.pictures.svg import MOST_BYTES
from course.report.pictures.timeline_svg import timeline
from tests.report.gradebook.hostile import TEXTS
from tests.report.pictures.recordings import COUNTER, flood, recording

SVG = "{http://www.w3.org/2000/svg}"


def drawn(what: Recording, clean: Callable[[str], str] = str) -> ElementTree.Element:
    source = timeline(what, key="k", clean=clean)
    assert source is not None and len(source.encode()) <= MOST_BYTES
    return ElementTree.fromstring(source)


def texts(picture: ElementTree.Element) -> list[str]:
    return [each.text or "" for each in picture.iter(f"{SVG}text")]


def test_everything_that_happened_has_a_lane_with_its_name() -> None:
    shown = texts(drawn(recording(*COUNTER)))
    for label in ("program counter", "node /counter", "messages on /counted (6)", "calls of /add (1)"):
        assert label in shown
    assert "sent by the grader to /told (1)" in shown
    assert "Ctrl+C 5.0 s, ended 5.5 s" in shown


def test_it_is_told_in_words_too() -> None:
    picture = drawn(recording(*COUNTER))
    words = picture.findtext(f"{SVG}desc") or ""
    assert "6 messages, from 1.00 s to 3.50 s." in words
    assert "ran from 0.50 s to 5.50 s (Ctrl+C at 5.00 s; ended at 5.50 s). It printed 1 line." in words
    assert picture.get("aria-labelledby") == "kt kd"
    assert {each.get("id") for each in picture if each.tag in (f"{SVG}title", f"{SVG}desc")} == {"kt", "kd"}


@pytest.mark.parametrize(
    ("end", "word"),
    [
        (kinds.ProcessExited(5.0, "counter", 1, None), "ended with 1"),
        (kinds.ProcessExited(5.0, "counter", None, 2), "ended by Ctrl+C"),
        (kinds.ProcessExited(5.0, "counter", None, 11), "ended by a crash"),
        (kinds.ProcessExited(5.0, "counter", None, 64), "ended by signal 64"),
        (kinds.LimitReached(5.0, "memory", 1e9), "out of memory"),
    ],
)
def test_how_a_program_ended(end: kinds.Event, word: str) -> None:
    shown = texts(drawn(recording(kinds.ProcessStarted(0.5, "counter", ()), end)))
    assert f"{word} 5.0 s" in shown


def test_an_empty_recording_is_no_picture() -> None:
    assert timeline(recording(), key="k", clean=str) is None


def test_as_much_as_can_be_is_small_enough_and_says_what_is_missing() -> None:
    picture = drawn(flood("a_rather_long_name_with_<&>\"'_in_it_" * 2))
    assert any(text.startswith("Not drawn: ") for text in texts(picture))


@pytest.mark.slow
@pytest.mark.parametrize("text", TEXTS, ids=lambda text: text[:12])
def test_names_stay_text(text: str) -> None:
    clean = Cleaner().line
    picture = drawn(flood(text[:200]), lambda label: clean(label, 60))
    tags = {each.tag.removeprefix(SVG) for each in picture.iter()}
    assert tags <= {"svg", "title", "desc", "text", "path", "g"}


def test_what_a_mystery_was_drawn_from_is_on_no_lane() -> None:
    kept, marked = kinds.FileKept(0.2, "answer", "42"), kinds.Marked(0.3, "m", "answer")
    secret = (kinds.Drawn(0.1, 8675309), kept, marked)
    source = timeline(recording(*COUNTER, *secret), key="k", clean=str)
    assert source == timeline(recording(*COUNTER), key="k", clean=str)
