"""Recordings judged again: each independently of the others' errors, and without ROS."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest
from mcap.writer import Writer

from course.errors import OurFault
from course.evidence.mcap_file import save
from course.evidence.recording import Recording
from course.grading.judge.judges import StoredRecording, rejudge
from course.grading.protocol import Judged, ScenarioState, Unjudged, UnjudgedCause
from course.grading.scenario_digest import scenario_digest
from course.model.feedback import Pace

from .conftest import GRADER, Store, judged, outcomes

REPO = Path(__file__).parents[3]


def trouble(answer: Judged | Unjudged) -> UnjudgedCause:
    assert isinstance(answer, Unjudged), answer
    return answer.cause


@pytest.mark.slow
@pytest.mark.parametrize("jobs", [1, 2])
def test_each_gets_its_own_judgment(store: Store, jobs: int) -> None:
    lights = [store(f"light {n}", n) for n in range(60)]
    dims = [store(f"dim {n}", n, "04-dim") for n in range(10)]
    found = judged(*lights, *dims, jobs=jobs)
    assert found.keys() == {one.key for one in (*lights, *dims)}
    for n in range(60):
        assert outcomes(found[f"light {n}"]) == (["passed"] * 2 if n >= 5 else ["failed", "skipped"])
    assert all(outcomes(found[one.key]) == ["passed"] for one in dims)
    three = found["light 3"]
    assert isinstance(three, Judged)
    assert three.judgment.checks[0].feedback is not None
    assert three.judgment.checks[0].feedback.summary == "It shone 3 s."


def test_nothing_to_do() -> None:
    assert judged() == {}


@pytest.mark.slow
def test_the_graders_of_now_judge(store: Store, grader: Path) -> None:
    recording = store("one", 4)
    assert outcomes(judged(recording)["one"]) == ["failed", "skipped"]
    grader.write_text(GRADER.replace("LONG = 5", "LONG = 3.5").replace("points=2", "points=7"))
    answer = judged(recording)["one"]
    assert outcomes(answer) == ["passed", "passed"]
    assert isinstance(answer, Judged)
    assert [check.points for check in answer.judgment.checks] == [7, 1]


@pytest.mark.slow
def test_what_is_wrong_with_one_is_told_of_that_one(
    store: Store, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    good = [store(f"good {n}", 9) for n in range(3)]
    damaged, cut, gone, other = (store(name, 9) for name in ("damaged", "cut", "gone", "other"))
    damaged.file.write_bytes(b"this is no recording \x1b[31m")
    cut.file.write_bytes(cut.file.read_bytes()[:200])
    gone.file.unlink()
    save(Recording("04-dim"), other.file, began_ns=0)
    monkeypatch.setattr("course.evidence.mcap_file._VERSION", "0")
    earlier = store("earlier", 9)
    every = (good[0], damaged, cut, gone, good[1], other, earlier, good[2])
    found = judged(*every)
    assert {key: trouble(answer) for key, answer in found.items() if not key.startswith("good")} == {
        "damaged": UnjudgedCause.DAMAGED,
        "cut": UnjudgedCause.DAMAGED,
        "gone": UnjudgedCause.MISSING,
        "other": UnjudgedCause.EXERCISE,
        "earlier": UnjudgedCause.FORMAT,
    }
    assert all(outcomes(found[one.key]) == ["passed", "passed"] for one in good)
    told = [answer.what for answer in found.values() if isinstance(answer, Unjudged)]
    assert all(what.isprintable() and str(tmp_path) not in what for what in told)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("act", "says"),
    [
        ("os._exit(7)", "ended with 7"),
        ("os.abort()", "ended by signal 6"),
        ("signal.raise_signal(signal.SIGALRM)", "took more than 60 s"),
    ],
)
def test_a_recording_that_ends_its_judge_is_left_out(store: Store, grader: Path, act: str, says: str) -> None:
    grader.write_text(GRADER.replace("if rec", f"if recording.duration == 1 and {act} or rec"))
    found = judged(*(store(str(n), n) for n in (0, 1, 9, 10)))
    answer = found.pop("1")
    assert trouble(answer) is UnjudgedCause.FATAL
    assert isinstance(answer, Unjudged)
    assert says in answer.what
    assert [outcomes(found[key])[0] for key in ("0", "9", "10")] == ["failed", "passed", "passed"]


@pytest.mark.slow
def test_the_time_of_each_is_limited(store: Store, grader: Path) -> None:
    """By the kernel, so that it can end even a regular expression: Python's handlers would wait for it."""
    limited = "signal.getsignal(signal.SIGALRM) is signal.SIG_DFL and 50 < signal.alarm(60) <= 60"
    grader.write_text(GRADER.replace("recording.duration < LONG", f"not ({limited})"))
    found = judged(*(store(str(n), n) for n in range(3)))
    assert [outcomes(answer)[0] for answer in found.values()] == ["passed"] * 3


@pytest.mark.slow
def test_a_grader_that_cannot_be_run_is_a_fault_of_all_its_recordings(store: Store, grader: Path) -> None:
    grader.write_text(GRADER + "\ndef broken(:\n")
    for answer in judged(*(store(str(n), n) for n in range(3))).values():
        assert isinstance(answer, Judged)
        assert answer.judgment.fault is not None
        assert answer.judgment.fault.summary == "The grader of 04-light cannot be run."
        assert "SyntaxError" in "".join(answer.judgment.fault.details)


def test_a_module_that_is_gone(store: Store, grader: Path) -> None:
    recordings = [store(str(n), n) for n in range(3)]
    grader.unlink()
    for answer in judged(*recordings).values():
        assert isinstance(answer, Judged)
        assert answer.judgment.fault is not None


@pytest.mark.slow
def test_what_cannot_even_be_looked_at_is_left_out(store: Store, grader: Path) -> None:
    fail = "def fail(file, exercise):\n    if file.name == '1.mcap':\n        raise RuntimeError\n"
    patch = "import __main__\nread = __main__._read\n__main__._read = fail\n"
    grader.write_text(f"{GRADER}\n{fail}    return read(file, exercise)\n{patch}")
    found = judged(*(store(str(n), 9) for n in range(3)))
    assert trouble(found.pop("1")) is UnjudgedCause.FATAL
    assert [outcomes(answer) for answer in found.values()] == [["passed", "passed"]] * 2


@pytest.mark.slow
def test_an_exercise_whose_grader_is_gone(store: Store, grader: Path) -> None:
    grader.write_text(GRADER.replace("@dim.", "@light."))
    answer = judged(store("one", 1, "04-dim"))["one"]
    assert isinstance(answer, Judged)
    assert answer.judgment.fault is not None


@pytest.mark.slow
def test_a_check_that_finds_no_evidence_for_itself_is_an_error_of_ours(store: Store, grader: Path) -> None:
    grader.write_text(GRADER.replace("    pass", "    recording.marked('dusk').t"))
    assert outcomes(judged(store("one", 9))["one"]) == ["passed", "error"]


@pytest.mark.slow
def test_fixtures_end_with_each_recording(store: Store, grader: Path) -> None:
    fixture = '\n@pytest.fixture(scope="module")\ndef seen():\n    return []\n'
    body = "    seen.append(1)\n    assert len(seen) == 1"
    text = GRADER.replace("def bright(recording):\n    pass", f"def bright(recording, seen):\n{body}")
    grader.write_text(text + fixture)
    found = judged(*(store(str(n), 9) for n in range(3)))
    assert [outcomes(answer) for answer in found.values()] == [["passed", "passed"]] * 3


@pytest.mark.slow
def test_whether_the_scenario_is_still_the_same(store: Store, grader: Path, small_course: Path) -> None:
    exercise = store("any", 9).exercise
    digest = scenario_digest(grader, "04-light", (*exercise.files, *exercise.looks_at))
    given = {"same": digest, "changed": digest[::-1], "unknown": ""}
    found = judged(*(store(key, 9, scenario=value) for key, value in given.items()))
    assert {key: answer.scenario for key, answer in found.items() if isinstance(answer, Judged)} == {
        "same": ScenarioState.SAME,
        "changed": ScenarioState.CHANGED,
        "unknown": ScenarioState.UNKNOWN,
    }


@pytest.mark.slow
def test_what_the_environment_says_to_pytest_does_not_count(
    store: Store, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PYTEST_ADDOPTS", "--no-such-option")
    monkeypatch.setenv("PYTEST_PLUGINS", "no_such_plugin")
    assert outcomes(judged(store("one", 9))["one"]) == ["passed", "passed"]


@pytest.mark.slow
def test_stopped_early_nothing_is_left(store: Store) -> None:
    others = set(psutil.Process().children())  # of tests before this one
    answers = rejudge([store(str(n), 9) for n in range(60)], jobs=2)
    next(iter(answers))
    started = set(psutil.Process().children()) - others
    assert started
    answers.close()  # type: ignore[attr-defined]
    assert not any(process.is_running() for process in started)


@pytest.mark.slow
def test_stopped_in_the_middle_of_a_check_it_does_not_wait(store: Store, grader: Path) -> None:
    grader.write_text(GRADER.replace("if rec", "if recording.duration == 1 and signal.pause() or rec"))
    answers = rejudge([store(str(n), n) for n in (0, 1)])
    assert next(iter(answers))[0] == "0"
    began = time.monotonic()
    answers.close()  # type: ignore[attr-defined]
    assert time.monotonic() - began < 30


def test_where_no_process_can_be_started_it_is_told(store: Store, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("course.grading.judge.judges._PROCESS", "course.grading.judge.nowhere")
    with pytest.raises(OurFault, match=r"course\.grading\.judge\.nowhere"):
        judged(store("one", 9), store("two", 9))


@pytest.mark.slow
def test_many_of_a_module_are_judged_in_few_sessions(store: Store, grader: Path, tmp_path: Path) -> None:
    """A session costs more than a recording: one for all of these."""
    log = tmp_path / "log"
    grader.write_text(f"{GRADER}\nwith open({str(log)!r}, 'a') as log:\n    print('imported', file=log)\n")
    judged(*(store(str(n), 9) for n in range(40)), jobs=2)
    assert len(log.read_text().splitlines()) == 1


WITHOUT_ROS = """
import sys
sys.modules["rclpy"] = None  # importing it fails
from pathlib import Path
from course.content import open_course
from course.evidence.recording import Recording
from course.grading.judge.plugin import judge
from course.grading.load import runs_programs

for exercise in open_course().exercises():
    if runs_programs(exercise):
        told = []
        judge(exercise.grader, {exercise.id}, [Recording(exercise.id)], told.append)
        assert told[0].checks and told[0].fault is None, (exercise.id, told)
assert "course.evidence.recorder" not in sys.modules
"""


@pytest.mark.slow
def test_no_grader_needs_ros_to_judge() -> None:
    command = [sys.executable, "-c", WITHOUT_ROS]
    done = subprocess.run(command, cwd=REPO, capture_output=True, text=True, timeout=120, check=False)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]


@pytest.mark.slow
def test_a_strange_mcap_file(store: Store) -> None:
    one: StoredRecording[str] = store("one", 9)
    with one.file.open("wb") as stream:
        writer = Writer(stream)
        writer.start("ros2", "another")
        writer.finish()
    answer = judged(one)["one"]
    assert trouble(answer) is UnjudgedCause.DAMAGED


@pytest.mark.slow
def test_each_check_has_the_pace_that_it_asked_for(store: Store, grader: Path) -> None:
    """And the next one does not inherit it."""
    asks = "    expect_period(recording.topic('/talk'), 0.5)\n"
    grader.write_text(GRADER.replace("def long(recording):\n", f"def long(recording):\n{asks}"))
    answer = judged(store("one", 9))["one"]
    assert isinstance(answer, Judged)
    long, bright = answer.judgment.checks
    assert long.pace == Pace("/talk", pytest.approx(0.4), pytest.approx(0.6)) and bright.pace is None
