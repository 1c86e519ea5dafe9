"""Recordings judged as they come, by one process that stays."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.errors import OurFault
from course.grading.channel import Judgement
from course.grading.rejudge import Beside
from course.grading.rejudge.model import PORTION
from tests.processes import below, none_stays

from .conftest import GRADER, Store

# Says in a file that a session of pytest has collected the module.
COUNTED = "\n@light.check('once', 'asked', points=1)\ndef once(recording, session):\n    pass\n"


@pytest.fixture
def beside() -> Iterator[Beside]:
    with contextlib.closing(Beside()) as beside:
        yield beside


@pytest.fixture
def sessions(grader: Path, tmp_path: Path) -> Path:
    """A file that gets a line for each session of pytest in which a recording is judged."""
    lines = tmp_path / "sessions"
    note = f"open({str(lines)!r}, 'a').write(f'{{id(request.session)}}\\n')"
    grader.write_text(f"{GRADER}\n@pytest.fixture\ndef session(request):\n    {note}\n{COUNTED}")
    return lines


def outcomes(judgement: Judgement) -> list[str]:
    assert judgement.fault is None, judgement.fault
    return [check.outcome.value for check in judgement.checks]


@pytest.mark.slow
def test_each_gets_its_own_judgement(beside: Beside, store: Store) -> None:
    for n, said in ((9, ["passed", "passed"]), (1, ["failed", "skipped"]), (8, ["passed", "passed"])):
        stored = store(str(n), n)
        assert outcomes(beside.judge(stored.exercise, stored.file)) == said
        dim = store(f"dim {n}", n, "04-dim")
        assert outcomes(beside.judge(dim.exercise, dim.file)) == ["passed"]


@pytest.mark.slow
def test_one_session_judges_many_but_not_too_many(beside: Beside, store: Store, sessions: Path) -> None:
    stored = store("one", 9)
    for _ in range(PORTION + 2):
        assert outcomes(beside.judge(stored.exercise, stored.file)) == ["passed"] * 3
    seen = sessions.read_text().split()
    assert len(seen) == PORTION + 2
    assert len(set(seen[:PORTION])) == 1
    assert seen[PORTION - 1] != seen[PORTION] == seen[PORTION + 1]


@pytest.mark.slow
def test_what_is_wrong_with_one_is_a_fault_of_that_one(beside: Beside, store: Store) -> None:
    gone, good = store("gone", 9), store("good", 9)
    gone.file.unlink()
    fault = beside.judge(gone.exercise, gone.file).fault
    assert fault is not None
    assert fault.summary == "The recording is not there any more."
    assert outcomes(beside.judge(good.exercise, good.file)) == ["passed", "passed"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("act", "says"), [("os._exit(7)", "ended with 7"), ("os.abort()", "ended by signal 6")]
)
def test_the_next_one_gets_another_process(
    beside: Beside, store: Store, grader: Path, act: str, says: str
) -> None:
    grader.write_text(GRADER.replace("if rec", f"if recording.duration == 1 and {act} or rec"))
    fatal, good = store("fatal", 1), store("good", 9)
    fault = beside.judge(fatal.exercise, fatal.file).fault
    assert fault is not None
    assert says in fault.summary
    assert outcomes(beside.judge(good.exercise, good.file)) == ["passed", "passed"]


@pytest.mark.slow
def test_who_ends_pytest_spoils_no_other(beside: Beside, store: Store, grader: Path) -> None:
    """Who is judged next gets a session of its own."""
    broken = "    if recording.duration == 1:\n        raise KeyboardInterrupt\n    if rec"
    grader.write_text(GRADER.replace("    if rec", broken))
    bad, good = store("bad", 1), store("good", 9)
    assert outcomes(beside.judge(good.exercise, good.file)) == ["passed", "passed"]
    assert beside.judge(bad.exercise, bad.file).fault is not None
    assert outcomes(beside.judge(good.exercise, good.file)) == ["passed", "passed"]


@pytest.mark.slow
def test_it_ends_with_its_owner(store: Store) -> None:
    with none_stays() as known, contextlib.closing(Beside()) as beside:
        stored = store("one", 9)
        beside.judge(stored.exercise, stored.file)
        assert below() > known


def test_where_no_process_can_be_started_it_is_told(
    beside: Beside, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("course.grading.rejudge.process._WORKER", "course.grading.rejudge.nowhere")
    stored = store("one", 9)
    with pytest.raises(OurFault, match="nowhere"):
        beside.judge(stored.exercise, stored.file)
