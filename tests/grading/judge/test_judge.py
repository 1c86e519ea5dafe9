"""Recordings judged as they arrive, by one persistent process."""

from __future__ import annotations

import contextlib
import signal
from collections.abc import Iterator
from pathlib import Path

import pytest

from course.errors import OurFault
from course.grading.judge.judges import Judge
from course.grading.protocol import PORTION, Judgment
from course.model.events import ProcessExited
from course.model.result import Doubt
from tests.processes import below, none_stays

from .conftest import GRADER, Store

# Notes in a file that a session of pytest has collected the module.
COUNTED = "\n@light.check('once', 'asked', points=1)\ndef once(recording, session):\n    pass\n"


@pytest.fixture
def beside() -> Iterator[Judge]:
    with contextlib.closing(Judge()) as beside:
        yield beside


@pytest.fixture
def sessions(grader: Path, tmp_path: Path) -> Path:
    """A file that gets a line for each session of pytest in which a recording is judged."""
    lines = tmp_path / "sessions"
    note = f"open({str(lines)!r}, 'a').write(f'{{id(request.session)}}\\n')"
    grader.write_text(f"{GRADER}\n@pytest.fixture\ndef session(request):\n    {note}\n{COUNTED}")
    return lines


def outcomes(judgment: Judgment) -> list[str]:
    assert judgment.fault is None, judgment.fault
    return [check.outcome.value for check in judgment.checks]


@pytest.mark.slow
def test_each_gets_its_own_judgment(beside: Judge, store: Store) -> None:
    for n, said in ((9, ["passed", "passed"]), (1, ["failed", "skipped"]), (8, ["passed", "passed"])):
        stored = store(str(n), n)
        assert outcomes(beside.judge(stored.exercise, stored.file)) == said
        dim = store(f"dim {n}", n, "04-dim")
        assert outcomes(beside.judge(dim.exercise, dim.file)) == ["passed"]


@pytest.mark.slow
def test_a_killed_program_is_a_doubt_where_something_failed(beside: Judge, store: Store) -> None:
    killed = (ProcessExited(1.0, "light", None, signal.SIGKILL),)
    for seconds, events, doubt in ((1, killed, Doubt.KILLED), (9, killed, None), (1, (), None)):
        stored = store(f"{seconds} {len(events)}", seconds, events=events)
        assert beside.judge(stored.exercise, stored.file).doubt is doubt


@pytest.mark.slow
def test_one_session_judges_many_but_not_too_many(beside: Judge, store: Store, sessions: Path) -> None:
    stored = store("one", 9)
    for _ in range(PORTION + 2):
        assert outcomes(beside.judge(stored.exercise, stored.file)) == ["passed"] * 3
    seen = sessions.read_text().split()
    assert len(seen) == PORTION + 2
    assert len(set(seen[:PORTION])) == 1
    assert seen[PORTION - 1] != seen[PORTION] == seen[PORTION + 1]


@pytest.mark.slow
def test_what_is_wrong_with_one_is_a_fault_of_that_one(beside: Judge, store: Store) -> None:
    gone, good = store("gone", 9), store("good", 9)
    gone.file.unlink()
    judgment = beside.judge(gone.exercise, gone.file)
    assert judgment.fault is not None
    assert judgment.fault.summary == "The recording no longer exists."
    assert judgment.doubt is None
    assert outcomes(beside.judge(good.exercise, good.file)) == ["passed", "passed"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("act", "says"), [("os._exit(7)", "ended with 7"), ("os.abort()", "ended by signal 6")]
)
def test_the_next_one_gets_another_process(
    beside: Judge, store: Store, grader: Path, act: str, says: str
) -> None:
    grader.write_text(GRADER.replace("if rec", f"if recording.duration == 1 and {act} or rec"))
    fatal, good = store("fatal", 1), store("good", 9)
    judgment = beside.judge(fatal.exercise, fatal.file)
    assert judgment.fault is not None
    assert says in judgment.fault.summary
    assert judgment.doubt is Doubt.SPOILT
    assert outcomes(beside.judge(good.exercise, good.file)) == ["passed", "passed"]


@pytest.mark.slow
def test_who_ends_pytest_spoils_no_other(beside: Judge, store: Store, grader: Path) -> None:
    """The next recording gets its own session."""
    broken = "    if recording.duration == 1:\n        raise KeyboardInterrupt\n    if rec"
    grader.write_text(GRADER.replace("    if rec", broken))
    bad, good = store("bad", 1), store("good", 9)
    assert outcomes(beside.judge(good.exercise, good.file)) == ["passed", "passed"]
    assert beside.judge(bad.exercise, bad.file).fault is not None
    assert outcomes(beside.judge(good.exercise, good.file)) == ["passed", "passed"]


@pytest.mark.slow
def test_it_ends_with_its_owner(store: Store) -> None:
    with none_stays() as known, contextlib.closing(Judge()) as beside:
        stored = store("one", 9)
        beside.judge(stored.exercise, stored.file)
        assert below() > known


def test_where_no_process_can_be_started_it_is_told(
    beside: Judge, store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("course.grading.judge.judges._PROCESS", "course.grading.judge.nowhere")
    stored = store("one", 9)
    with pytest.raises(OurFault, match="nowhere"):
        beside.judge(stored.exercise, stored.file)
