"""What the comparison relies on in the library."""

from __future__ import annotations

import random
import sys

import pytest

from course.errors import ExitCode, MissingHere
from course_similar.tokens import DIFFERENT
from course_similar.work import SHORTEST, fingerprinter


def some_words(draw: random.Random, count: int) -> str:
    return "".join(chr(0x100 + draw.randrange(DIFFERENT)) for _ in range(count))


def test_so_many_words_in_common_are_always_seen() -> None:
    draw, fingerprints = random.Random(4), fingerprinter()
    for _ in range(200):
        shared = some_words(draw, SHORTEST)
        one, other = (
            some_words(draw, draw.randrange(90)) + shared + some_words(draw, draw.randrange(90))
            for _ in range(2)
        )
        assert fingerprints(one) & fingerprints(other)


def test_other_words_have_nothing_in_common() -> None:
    draw, fingerprints = random.Random(5), fingerprinter()
    assert not fingerprints(some_words(draw, 2000)) & fingerprints(some_words(draw, 2000))


def test_fewer_words_have_no_fingerprint() -> None:
    words = some_words(random.Random(6), SHORTEST)
    assert len(fingerprinter()(words)) >= 1
    assert fingerprinter()(words[1:]) == frozenset()
    assert fingerprinter()("") == frozenset()


def test_without_the_library_it_says_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "scanoss_winnowing.winnowing", None)
    with pytest.raises(MissingHere) as caught:
        fingerprinter()
    assert caught.value.exit_code == ExitCode.MISSING_HERE
    assert "scanoss-winnowing" in str(caught.value.next_step)
