"""What two works share, compared with a slow and simple count."""

from __future__ import annotations

import random
from array import array
from pathlib import Path

import pytest

from course_similar.find import GIVEN
from course_similar.tokens import File, Words
from course_similar.work import SAME, SHORTEST, Work, lines_of, runs, stretches, work_of


def work(text: str, given: frozenset[str] = frozenset()) -> Work:
    words = Words(text, array("i", (1 + at // 8 for at in range(len(text)))))
    return work_of("x", [(File("x.py", Path("x.py")), words)], given, lambda _: frozenset())


def draws(count: int = 60) -> list[tuple[str, str]]:
    """Pairs of texts with common pieces, some of them several times."""
    draw = random.Random(7)
    found = []
    for _ in range(count):
        pieces = ["".join(draw.choices("abc", k=draw.randrange(5, 60))) for _ in range(4)]
        one, other = ("".join(draw.choices(pieces, k=6)) for _ in range(2))
        found.append((one, other))
    return found


def shared(one: str, other: str) -> set[int]:
    """The simple way: every place in `one` that a run of SAME characters of `other` covers."""
    return {
        at + more for at in range(len(one) - SAME + 1) if one[at : at + SAME] in other for more in range(SAME)
    }


def test_runs_are_the_same_in_both_and_do_not_overlap() -> None:
    for one, other in draws():
        left, right = work(one), work(other)
        end = 0
        for run in runs(left, right):
            assert run.length >= SAME and run.one >= end
            assert left.text[run.one :][: run.length] == right.text[run.other :][: run.length]
            end = run.one + run.length


def test_nearly_all_that_is_shared_is_in_a_run() -> None:
    found = total = 0
    for one, other in draws():
        total += len(shared(one, other))
        found += sum(run.length for run in runs(work(one), work(other)))
    assert found >= 0.9 * total > 1000  # what is left of a piece after a longer one may be too short


def test_the_whole_of_a_copy_is_one_run() -> None:
    text = "".join(random.Random(8).choices("abcdefghij", k=500))
    (run,) = runs(work(text), work(text))
    assert (run.one, run.other, run.length) == (0, 0, 500)


def test_a_run_does_not_go_from_one_file_into_the_next() -> None:
    draw = random.Random(9)
    texts = ["".join(draw.choices("abcdef", k=60)) for _ in range(2)]
    words = [Words(text, array("i", [1] * 60)) for text in texts]
    files = [File(f"{number}.py", Path(f"{number}.py")) for number in range(2)]
    both = work_of("x", list(zip(files, words, strict=True)), frozenset(), lambda _: frozenset())
    found = list(runs(both, both))
    assert [run.length for run in found] == [60, 60]
    assert [both.files[run.one] for run in found] == [0, 1]
    assert both.words == 120


@pytest.mark.parametrize("at", [0, 1, 40, 60])
def test_what_is_given_is_cut_out(at: int) -> None:
    draw = random.Random(10)
    own = "".join(draw.choices("abcdef", k=100))
    gift = "".join(draw.choices("uvwxyz", k=50))
    given = frozenset(gift[i : i + GIVEN] for i in range(len(gift) - GIVEN + 1))
    text = own[:at] + gift + own[at:]
    parts = [text[begin:end] for begin, end in stretches(text, given)]
    assert parts == [part for part in (own[:at], own[at:]) if len(part) >= SHORTEST]
    assert work(text, given).words == sum(map(len, parts))


def test_all_given_leaves_nothing() -> None:
    assert work("a" * 100, frozenset({"a" * GIVEN})).words == 0
    assert not list(stretches("", frozenset({"a" * GIVEN})))


def test_lines_are_counted_once() -> None:
    assert lines_of(work("ab" * 40), [range(0, 16), range(10, 24)]) == 3
