"""A random search for input that brings us down: what strangers hand in, print, send and leave behind.

Every run draws different cases from the seed that pytest prints when it starts. `--hypothesis-seed=NUMBER`
draws the same ones again, and ROS2COURSE_FUZZ=10 draws ten times as many. One thing must hold for each case:
an answer or an error of ours, in bounded time and memory, and nothing changed elsewhere. When a case breaks
that, add it to corpus.json: every run tries all cases in it.
"""

from __future__ import annotations

import json
import os
import resource
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, TypeVar

import pytest
from hypothesis import HealthCheck, Phase, example, given, settings
from hypothesis.strategies import SearchStrategy

CORPUS = json.loads((Path(__file__).parent / "corpus.json").read_text(encoding="utf-8"))
MB = 1024 * 1024
# Wide: a case takes milliseconds. CPU seconds, so that a busy machine changes nothing.
MOST_SECONDS = 15.0
MOST_GROWTH = 700 * MB
_TIMES = float(os.environ.get("ROS2COURSE_FUZZ", "1"))

Test = TypeVar("Test", bound=Callable[..., None])


def fuzzed(strategy: SearchStrategy[Any], cases: int) -> Callable[[Test], Any]:
    """The test with this many random cases as its argument `case`, after its own cases in the corpus."""

    def decorate(test: Test) -> Any:
        many = settings(
            max_examples=max(1, round(cases * _TIMES)),
            deadline=None,
            database=None,  # the corpus is what is remembered
            phases=(Phase.explicit, Phase.generate, Phase.shrink),
            suppress_health_check=list(HealthCheck),
            print_blob=False,
        )
        fuzzing: Any = many(given(case=strategy)(test))
        for kept in CORPUS.get(test.__name__, []):
            fuzzing = example(case=as_case(kept))(fuzzing)
        quiet = pytest.mark.filterwarnings(
            "ignore:Generating overly large repr"
        )  # of a long text that failed
        return quiet(fuzzing)

    return decorate


def as_case(kept: Any) -> Any:
    """A case as corpus.json has it. A long text is {"text": ..., "times": ...}; bytes are {"bytes": ...}."""
    if isinstance(kept, list):
        return [as_case(item) for item in kept]
    if isinstance(kept, dict):
        text = kept.get("text", kept.get("bytes")) * kept.get("times", 1)
        return text if "text" in kept else text.encode("latin-1")
    return kept


@pytest.fixture(autouse=True)
def bounded() -> Iterator[None]:
    """No memory leaks over all cases of a test."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024
    yield
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 - before
    assert grown < MOST_GROWTH, f"this process grew by {grown // MB} MB"


class soon:  # noqa: N801 - used as a context
    """`with soon():` fails if it took more CPU time than a case may."""

    def __enter__(self) -> None:
        self._began = time.process_time()

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        taken = time.process_time() - self._began
        assert kind is not None or taken < MOST_SECONDS, f"this case took {taken:.0f} s of CPU"
