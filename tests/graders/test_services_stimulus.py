"""The questions and answers of chapter 20: unpredictable, and as its checks need them."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

from course.evidence.sources import Sources
from course.grading.load import load_module

GRADERS = load_module(Path(__file__).parents[2] / "graders/ch20_services.py")
Oracle, quotes_about_life = GRADERS.Oracle, GRADERS.quotes_about_life


def asked(quote: str) -> SimpleNamespace:
    return SimpleNamespace(quote=SimpleNamespace(quote=quote))


def test_five_of_nine_quotes_are_about_life() -> None:
    quotes = [str(quote["quote"]) for quote in quotes_about_life()]
    about = [quote for quote in quotes if "life" in quote.lower()]
    others = [quote for quote in quotes if quote not in about]
    assert (len(about), len(others), len(set(others))) == (5, 4, 3)
    assert "" in others
    assert sum("life" in quote for quote in about) == 2  # the others in capitals
    assert any("lifetime" in quote for quote in about)


def test_no_two_drawings_are_alike() -> None:
    assert quotes_about_life() != quotes_about_life()


def test_the_oracle_remembers_what_it_was_asked_and_gave() -> None:
    oracle = Oracle()
    points = [oracle(asked(quote))["point"] for quote in ("LIFE", "", "alive")]
    assert oracle.about_life == {True, False}
    assert oracle.given == [tuple(str(int(point[axis])) for axis in "xyz") for point in points]
    assert all(float(number).is_integer() and len(number) == 4 for given in oracle.given for number in given)


def test_capitals_are_missed() -> None:
    def at(text: str) -> list[str]:
        cause = GRADERS.case_sensitive(Sources({"server.py": text}))
        return [str(place) for place in cause.where] if cause else []

    assert at("\nif 'life' in quote: pass") == ["server.py:2"]
    assert at("if 'life' in quote.lower(): pass") == []
    assert at("if re.search('life', quote, re.IGNORECASE): pass") == []
    assert at("if LIFE in quote: pass") == []
