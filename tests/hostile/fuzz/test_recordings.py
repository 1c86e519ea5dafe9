"""What programs of strangers print, send and answer, judged for real; and damaged files of ours.

Real recordings of right solutions, made in full containment, are changed in everything that a submission
decides. Their graders judge them again: a check may pass or fail, but never end as "our error".
"""

from __future__ import annotations

import contextlib
import json
import random
import shutil
import sqlite3
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import strategies as st
from msgspec.structs import replace as with_fields

from course.arena.probe import _is_answer
from course.arena.process import LineSplitter
from course.batch.results import FILE, Results
from course.content import open_course
from course.errors import CourseError
from course.evidence.mcap_file import BadRecording, OtherFormat, load, save
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.grading import trial
from course.grading.check import Request, check_exercise
from course.grading.judge.judges import StoredRecording, rejudge
from course.grading.protocol import Unjudged
from course.grading.trial_answers import SEED
from course.isolation import Level
from course.isolation.levels import obstacle_to
from course.model.events import (
    FileKept,
    GraphSeen,
    MessageSeen,
    OutputLine,
    Probed,
    ProcessExited,
    ServiceCalled,
    ShellRan,
)
from course.model.result import Outcome
from course.report import sanitize
from course.rosenv import find_ros
from tests.batch.samples import FAILED, graded, submissions
from tests.hostile.fuzz.conftest import CORPUS, as_case, fuzzed, soon
from tests.hostile.fuzz.inputs import TEXTS, json_values, mangled, texts

pytestmark = pytest.mark.slow

# Two of them are drawn in each run: enough of them for every kind of evidence, and each quick to record.
RECORDED = ("02-class", "09-source", "14-library", "18-publisher", "18-subscriber", "20-client", "22-launch")
CHANGED = 120


@pytest.fixture(scope="module")
def bases(tmp_path_factory: pytest.TempPathFactory, request: pytest.FixtureRequest) -> dict[str, Recording]:
    """Recordings of right solutions by their exercises: two that are drawn, and all that the corpus needs."""
    if obstacle := obstacle_to(Level.CONTAINED):
        pytest.skip(f"not exercised here: recordings of strangers' programs are judged ({obstacle})")
    seed = request.config.getoption("hypothesis_seed")
    drawn = random.Random(f"recordings {seed}").sample(RECORDED, 2)
    kept = [case["exercise"] for case in CORPUS.get("test_changed_recordings", [])]
    return {
        name: record(name, tmp_path_factory.mktemp("recorded")) for name in dict.fromkeys([*drawn, *kept])
    }


def record(name: str, folder: Path) -> Recording:
    course = open_course()
    exercise = course.exercise(name)
    home = folder / "home"
    home.mkdir()
    trial.lay_solution(course, exercise, home)
    file = folder / "evidence" / "recorded.mcap"
    result = check_exercise(Request(exercise, home, ros=find_ros(), evidence=file, local=False, seed=SEED))
    assert result.containment == "contained"
    return load(file)


ANSWER = st.fixed_dictionaries(
    {"question": texts | st.just("")},
    optional={field: json_values for field in ("value", "type", "error", "file", "line")},
)
# A change: which of the events or sources (the nth), and what it becomes; see `changed`.
CHANGE = st.tuples(
    st.sampled_from(
        ("line", "more", "less", "message", "call", "exit", "answer", "file", "shell", "graph", "source")
    ),
    st.integers(0, 500),
    texts,
    mangled([text.encode("utf-8", "replace") for text in TEXTS]),
    st.integers(-1, 300),
)
CHANGES: list[list[Any]] = []


@fuzzed(st.lists(CHANGE, min_size=1, max_size=8), cases=CHANGED)
def test_changes_are_drawn(case: list[Any]) -> None:
    """For the test below, which judges many at once."""
    CHANGES.append(case)


def test_changed_recordings(bases: dict[str, Recording], tmp_path: Path) -> None:
    kept = [
        (case["exercise"], as_case(case["changes"])) for case in CORPUS.get("test_changed_recordings", [])
    ]
    drawn = [(name, changes) for number, changes in enumerate(CHANGES) for name in [[*bases][number % 2]]]
    cases, stored = [*kept, *drawn], []
    for number, (name, changes) in enumerate(cases):
        file = tmp_path / f"{number}.mcap"
        with soon():
            save(changed(bases[name], changes), file, began_ns=0)
        stored.append(StoredRecording(number, open_course().exercise(name), file))
    broken = []
    for number, judged in rejudge(stored, jobs=2):
        errors = [judged.what] if isinstance(judged, Unjudged) else list(our_errors(judged.judgment))
        if errors:
            broken.append(f"{cases[number]!r}: {errors}")
    assert not broken, "\n".join(broken[:5])


def our_errors(judgment: Any) -> Iterator[str]:
    if judgment.fault:
        yield str(judgment.fault)
    for check in judgment.checks:
        if check.outcome is Outcome.ERROR:
            yield f"{check.id}: {check.feedback.summary} {' '.join(check.feedback.details)}"


def changed(recording: Recording, changes: list[Any]) -> Recording:
    for change in changes:
        recording = _changed(recording, *change)
    return recording


def _readable(text: str) -> str:
    """Like text that is read from terminals and files."""
    return text.encode("utf-8", "replace").decode()


def _changed(recording: Recording, kind: str, nth: int, text: str, data: bytes, number: int) -> Recording:
    text = _readable(text)
    line = (LineSplitter().feed(text.encode() + b"\n") or [""])[0]
    if kind == "source":
        files = dict(recording.sources.files)
        if files:
            files[sorted(files)[nth % len(files)]] = text
        return replace(recording, sources=Sources(files, recording.sources.others))
    makes: dict[str, tuple[type, Any]] = {
        "line": (OutputLine, lambda event: [with_fields(event, text=line)]),
        "more": (
            OutputLine,
            lambda event: [event, *(with_fields(event, text=one) for one in text.split("\n")[:50])],
        ),
        "less": (OutputLine, lambda event: []),
        "message": (MessageSeen, lambda event: [with_fields(event, data=event.data[: number % 60] + data)]),
        "call": (ServiceCalled, lambda event: [with_fields(event, data=event.data[:4] + data)]),
        "exit": (ProcessExited, lambda event: [with_fields(event, code=abs(number) % 256, signal=None)]),
        "answer": (Probed, lambda event: [with_fields(event, answers=_answers(event.answers, nth, text))]),
        "file": (FileKept, lambda event: [with_fields(event, text=text)]),
        "shell": (ShellRan, lambda event: [with_fields(event, printed=(line,), code=abs(number) % 256)]),
        "graph": (GraphSeen, lambda event: [with_fields(event, graph=_graph(event.graph, nth))]),
    }
    wanted, make = makes[kind]
    places = [place for place, event in enumerate(recording.events) if isinstance(event, wanted)]
    if not places:
        return recording
    place, events = places[nth % len(places)], list(recording.events)
    events[place : place + 1] = make(events[place])
    return replace(recording, events=tuple(events))


def _answers(answers: tuple[str, ...], nth: int, text: str) -> tuple[str, ...]:
    if not answers:
        return answers
    kept = list(answers)
    answer = json.loads(kept[nth % len(kept)])
    values: list[Any] = [text, [text, None], {"a": 1.5}, float("nan"), True, 10**30, None, [[]]]
    field = ("value", "value", "value", "type", "error", "file", "line")[nth % 7]
    line = json.dumps({**answer, field: values[nth % len(values)]})
    if _is_answer(line):
        kept[nth % len(kept)] = line
    return tuple(kept)


def _graph(graph: Any, nth: int) -> Any:
    """Some entries are missing, doubled, or of another type."""
    if nth % 3 == 0:
        return with_fields(graph, nodes=graph.nodes[nth % 2 :], endpoints=graph.endpoints[nth % 5 :])
    odd = [with_fields(end, type="a/msg/B", type_hash="", node="") for end in graph.endpoints[: nth % 4]]
    return with_fields(graph, endpoints=(*graph.endpoints, *odd), services=graph.services[nth % 3 :])


@fuzzed(st.lists(mangled([text.encode("utf-8", "replace") for text in TEXTS]), max_size=6), cases=400)
def test_terminal_output(case: list[bytes]) -> None:
    """Cut into lines, limited, and shown without affecting the terminal."""
    with soon():
        splitter = LineSplitter()
        lines = [line for data in case for line in splitter.feed(data)] + splitter.rest()
        for line in lines:
            assert "\x1b" not in line
            shown = sanitize.paragraph(line)
            assert not any(ord(sign) < 32 or 0x7F <= ord(sign) < 0xA0 for sign in shown), ascii(shown)
            shown.encode()


def test_damaged_evidence(
    bases: dict[str, Recording], tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    """A changed file is reported as such, in time, with right or wrong checksums."""
    file = tmp_path / "evidence.mcap"
    save(next(iter(bases.values())), file, began_ns=0)
    whole = file.read_bytes()
    drawn = random.Random(f"evidence {request.config.getoption('hypothesis_seed')}")
    for _ in range(200):
        data = bytearray(whole)
        for _ in range(drawn.randint(1, 4)):
            at = drawn.randrange(len(data))
            data[at : at + drawn.choice((0, 1, 8, 3000))] = drawn.randbytes(drawn.choice((0, 1, 8, 64)))
        file.write_bytes(data)
        with soon(), contextlib.suppress(BadRecording, OtherFormat):
            load(file)


def test_damaged_results(tmp_path: Path, request: pytest.FixtureRequest) -> None:
    """The file of a class's results: read, or one clear error."""
    whole = tmp_path / "whole"
    with Results.open(whole) as results:
        results.enter(submissions("ada", "bao"))
        results.record(graded("ada", FAILED), "1", None)
    with contextlib.closing(sqlite3.connect(whole / FILE)) as database:
        database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    content = (whole / FILE).read_bytes()
    drawn = random.Random(f"results {request.config.getoption('hypothesis_seed')}")
    for _ in range(150):
        folder = tmp_path / "damaged"
        folder.mkdir()
        data = bytearray(content)
        for _ in range(drawn.randint(1, 30)):
            at = drawn.randrange(len(data))
            data[at : at + 4] = drawn.randbytes(4)
        (folder / FILE).write_bytes(data)
        with soon(), contextlib.suppress(CourseError), Results.look(folder) as results:
            for submission in results.submissions():
                results.gradings(submission.person)
        shutil.rmtree(folder)
