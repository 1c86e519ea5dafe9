"""Mistakes that Python accepts without an error: what the code must show, and what is not a mistake."""

from __future__ import annotations

import pytest

from course.evidence.sources import Sources
from course.explain.python_slips import local_copy, missing_sign, never_awaited, quoted_variable, uncalled

FILE = "src/talk/talk/talker.py"
NODE = "self.create_timer(1, self.tick)\nclass Talker:\n    def tick(self):\n        {}\n"


def sources(text: str) -> Sources:
    return Sources({FILE: text})


@pytest.mark.parametrize("text", ["def stop(): pass\nstop\n", "def main(node):\n    node.spin\n"])
def test_a_function_that_is_only_named(text: str) -> None:
    found = uncalled(sources(text))
    assert found and [place.line for place in found.where] == [2]


@pytest.mark.parametrize(
    "text",
    [
        "def stop(): pass\nstop()\n",
        "def stop(): pass\nstop = 1\nstop\n",
        "def stop(): pass\ndef f(stop):\n    if stop: pass\n",
        "def stop(): pass\nlater = None or stop\n",
        "ready = True\nready\n",
    ],
)
def test_a_variable_is_no_function(text: str) -> None:
    assert uncalled(sources(text)) is None


@pytest.mark.parametrize(
    ("text", "line", "words"),
    [
        ("x = [\n    'a'\n    2,\n]\n", 2, "comma is missing at the end of line 2"),
        ("f(\n    g(\n        1,\n    )\n    g(2),\n)\n", 4, "comma is missing at the end of line 4"),
        ("x = {'a' = 1}\n", 1, "write `:` in place of `=`: `x = {'a': 1}`"),
        ("def tick()\n    pass\n", 1, "colon is missing at the end of line 1"),
    ],
)
def test_one_sign_that_python_misses(text: str, line: int, words: str) -> None:
    found = missing_sign(sources(text))
    assert found and found.where[0].line == line
    assert words in found.text


@pytest.mark.parametrize("text", ["x = [1, 2]\n", "x = (1\n", "x = = 1\n", "for x in\n    y z\n"])
def test_what_one_sign_does_not_mend(text: str) -> None:
    assert missing_sign(sources(text)) is None


@pytest.mark.parametrize("text", ["asyncio.sleep(1)\n", "async def ask(): pass\n\nask()\n"])
def test_a_coroutine_that_nothing_awaits(text: str) -> None:
    assert never_awaited(sources(text))


@pytest.mark.parametrize("text", ["time.sleep(1)\n", "x = asyncio.sleep(1)\n", "def ask(): pass\n\nask()\n"])
def test_other_calls_need_no_await(text: str) -> None:
    assert never_awaited(sources(text)) is None


def test_a_copy_that_only_the_function_knows() -> None:
    found = local_copy(sources(NODE.format("count = self.count + 1")))
    assert found and "Write `self.count = self.count + 1`" in found.text


@pytest.mark.parametrize(
    "line", ["count = self.count + 1; print(count)", "total = self.count + 1", "self.count = self.count + 1"]
)
def test_a_copy_that_is_used(line: str) -> None:
    assert local_copy(sources(NODE.format(line))) is None


def test_a_variable_in_quotation_marks() -> None:
    text = "topic = name()\ncreate_publisher(Quote, 'topic', 10)\n"
    assert quoted_variable(sources(text), "create_publisher", ["/topic"])
    assert quoted_variable(sources(text), "create_publisher", ["/other"]) is None
    assert quoted_variable(sources(text[15:]), "create_publisher", ["/topic"]) is None
