"""The changes to a grader's text, operator by operator."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import pytest

LinesOf = Callable[[str], Mapping[str, list[str]]]


def check(*lines: str) -> str:
    body = "".join(f"    {line}\n" for line in lines)
    return f'@light.check("long", "it shines")\ndef long(recording):\n{body}'


@pytest.mark.parametrize(
    ("lines", "operator", "afters"),
    [
        (["'''Doc.'''", "expect_x(recording)"], "RETURN", ["return"]),
        (["expect_x(recording)"], "EXPECT", []),  # the same as to return
        (["expect_x(recording)", "recording.expect_y(", "    1,", ")"], "EXPECT", ["pass", "pass"]),
        (["if recording:", "    raise Failure(Feedback('no'))", "expect_x(1)"], "RAISE", ["pass"]),
        (["if recording:", "    raise RuntimeError", "expect_x(1)"], "RAISE", []),
        (["if recording.a < recording.b:", "    pass"], "COMPARISON", ["if recording.a >= recording.b:"]),
        (["if len(a) > (1):", "    pass"], "BOUNDARY", ["if len(a) >= (1):"]),
        (["if a < 0.5:", "    pass"], "BOUNDARY", []),
        (["if a < 0.5:", "    pass"], "BOUND", ["if a < 1:", "if a < 0.25:"]),
        (["if a < 0.2 * b:", "    pass"], "BOUND", ["if a < 0.4 * b:", "if a < 0.1 * b:"]),
        (["if a == 5:", "    pass"], "BOUND", []),
        (["if a is not None:", "    pass"], "COMPARISON", ["if a is None:"]),
        (["if a in b:", "    pass"], "COMPARISON", ["if a not in b:"]),
        (["if a not  in b:", "    pass"], "COMPARISON", ["if a in b:"]),
        (["if 0 < a != 2:", "    pass"], "COMPARISON", ["if 0 >= a != 2:", "if 0 < a == 2:"]),
        (["if not (a):", "    pass"], "NOT", ["if (a):"]),
        (["if a and b or c:", "    pass"], "AND_OR", ["if (a and b and c):", "if (a or b) or c:"]),
        (["if (a or b) and c:", "    pass"], "AND_OR", ["if ((a or b) or c):", "if ((a and b)) and c:"]),
        (["if (a and b):", "    pass"], "AND_OR", ["if ((a or b)):"]),
        (["expect_x(a, tolerance=0.1)"], "BOUND", ["expect_x(a, tolerance=0.2)"]),
        (["expect_x(a, tolerance=1e-6)", "return a < 1e-9"], "BOUND", []),
        (["expect_x(a, at_least=6)"], "BOUND", ["expect_x(a, at_least=3)"]),
        (["a.topic('/x').expect_period(0.5)"], "BOUND", ["a.topic('/x').expect_period(0.5, tolerance=0.4)"]),
        (["expect_period(t, 1,)"], "BOUND", ["expect_period(t, 1, tolerance=0.4,)"]),
        (["if a < ENOUGH:", "    pass"], "BOUND", ["if a < 10:", "if a < 2:"]),
        (["if a < ENOUGH:", "    pass"], "BOUNDARY", ["if a <= ENOUGH:"]),
        (["return 'ä' in a and b"], "AND_OR", ["return ('ä' in a or b)"]),
    ],
)
def test_operators(lines_of: LinesOf, lines: list[str], operator: str, afters: list[str]) -> None:
    head = "from course.api import expect_period\nENOUGH = 5\n\n"
    assert sorted(lines_of(head + check(*lines)).get(operator, [])) == sorted(afters)


@pytest.mark.parametrize(
    "lines",
    [
        ["raise Failure(Feedback('few' if len(a) < 2 else 'many'))"],
        ["few = len(a) < 2", "raise Failure(Feedback('few' if few else 'many'))"],
        ["few = not a", "advice = 'x' if few and b else 'y'", "expect_x(a, advice=advice)"],
        ["raise Failure(why(a))"],
        ["raise Failure(Feedback(text(a)))"],
        ["expect_x(a, what='a' if a > 3 else 'b')"],
        ["if a > 3 and not b:", "    raise OurFault('odd')", "expect_x(a)"],
        ["expect_x(a)", "if a > 3 and not b:", "    raise OurFault('odd')"],
        ["if a > 3:", "    text = 'a'", "elif not a:", "    text = 'b'", "raise Failure(Feedback(text))"],
    ],
)
def test_words_alone_are_left_as_they_are(lines_of: LinesOf, lines: list[str]) -> None:
    others = """
def why(a) -> Feedback:
    return Feedback("x" if a > 5 else "y")

def text(a):
    return "x" if a and a > 5 else "y"

"""
    assert lines_of(others + check(*lines)) == {"RETURN": ["return"]}


def test_what_is_also_more_than_words_is_mutated(lines_of: LinesOf) -> None:
    found = lines_of(check("few = not a", "if few:", "    raise Failure(Feedback(str(few)))"))
    assert found["NOT"] == ["few = a"]


def test_only_what_judges_this_exercise(lines_of: LinesOf) -> None:
    found = lines_of(
        """
def acts(a):
    return a > 1.5

@light.scenario
def shine(arena):
    acts(1)

def helper(a):
    return a is None

@dim.check("dim", "it is dim")
def is_dim(recording):
    return recording == 3

@light.check(id="long", title="it shines")
def long(recording):
    return helper(recording)
"""
    )
    assert found == {"COMPARISON": ["return a is not None"]}


def test_a_helper_that_fails_returns_early_too(lines_of: LinesOf) -> None:
    helper = "def helper(a):\n    raise Failure(Feedback('no'))\n\n"
    found = lines_of(helper + check("helper(recording)"))
    assert found == {"RETURN": ["return", "return"]}


def test_formatted_texts_are_left_as_they_are(lines_of: LinesOf) -> None:
    assert lines_of(check("return f'{recording is None}'")) == {}


def test_a_long_line_is_shown_around_the_change(lines_of: LinesOf) -> None:
    long = "a" * 200
    [after] = lines_of(check(f"return {long} is {long}"))["COMPARISON"]
    assert " is not " in after
    assert len(after) < 120
