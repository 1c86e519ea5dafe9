"""Near misses, and lists of names."""

from __future__ import annotations

import pytest

from course.spelling import listed, nearest


@pytest.mark.parametrize(
    ("wanted", "candidates", "found"),
    [
        ("/amazing_quote", ["/amazing_qoute", "/chatter"], "/amazing_qoute"),
        ("/amazing_quote", ["amazing_quote"], "amazing_quote"),
        ("/amazing_quote", ["/Amazing_Quote"], "/Amazing_Quote"),
        ("/amazing_quote", ["/amazing_quotes", "/amazing_quot"], "/amazing_quotes"),
        ("/amazing_quote", ["/chatter"], None),
        ("/amazing_quote", [], None),
        # Two different things, not a typo.
        ("amazing_quote_publisher_node", ["amazing_quote_subscriber_node"], None),
        ("rclpy", ["rcl_py"], "rcl_py"),
        ("a", ["/a"], "/a"),
        ("", ["a"], None),
    ],
)
def test_nearest(wanted: str, candidates: list[str], found: str | None) -> None:
    assert nearest(wanted, candidates) == found


@pytest.mark.parametrize(
    ("names", "text"),
    [([], "none"), (["a"], "`a`"), (["a", "b"], "`a` and `b`"), (["a", "b", "c"], "`a`, `b`, and `c`")],
)
def test_listed(names: list[str], text: str) -> None:
    assert listed(names) == text


def test_listed_nothing_in_other_words() -> None:
    assert listed([], "no node at all") == "no node at all"


@pytest.mark.parametrize("slip", ["qoute", "quotes", "qute", "quode", "uqote", "quot"])
def test_one_slip_in_a_short_name(slip: str) -> None:
    assert nearest("quote", ["period", slip]) == slip


@pytest.mark.parametrize(
    ("wanted", "other"),
    [("quote", "qutoes"), ("quote", "route_"), ("quote", "quiet"), ("talk", "tall"), ("quote", "q")],
)
def test_two_slips_and_very_short_names_are_other_names(wanted: str, other: str) -> None:
    assert nearest(wanted, [other]) is None
