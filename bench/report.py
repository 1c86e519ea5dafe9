"""The page of a large class: how long it takes to make, how large it is, how soon a browser can use it.

People, marks, and feedback are made up; the recordings, of 6 s, are from a busy publisher. A page is ready
when its script has drawn the table and the browser's main thread is free again.

    .venv/bin/python bench/report.py                    500 people, 10 exercises, each with a recording
    .venv/bin/python bench/report.py --people 100 --keep page.html
"""

from __future__ import annotations

import argparse
import random
import resource
import shutil
import tempfile
import time
from datetime import datetime, timezone
from pathlib import Path
from statistics import median

from table import show

import course as package
from course.batch.class_page import PICTURES_ROOM, read_class, with_pictures
from course.batch.gradings import Graded, Unit
from course.batch.results import BatchSettings, Results, Submission, keep_settings
from course.content import Course, Exercise, open_course
from course.evidence import mcap_file
from course.evidence.recording import Recording
from course.evidence.sources import Sources, read_sources
from course.files import write_pieces
from course.model import replace
from course.model.events import (
    GraphSeen,
    MessageSeen,
    OutputLine,
    ProcessExited,
    ProcessStarted,
    SignalSent,
)
from course.model.feedback import Feedback, Location
from course.model.graph import Graph
from course.model.result import CheckResult, Outcome, Result, Timing, verdict_of
from course.report.page.html import class_page

NUMBER = "std_msgs/msg/Int32"
CHECKS = 11
MADE = ("people", "recordings", "made (s)", "CPU (s)", "MB", "pictures", "peak MB")
OPENED = ("loaded (s)", "ready (s)", "sorted (s)")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--people", type=int, nargs="+", default=[50, 500])
    parser.add_argument("--exercises", type=int, default=10)
    parser.add_argument("--recorded", type=float, default=1.0, help="Share of gradings with a recording.")
    parser.add_argument("--opened", type=int, default=5, help="How often the page is opened.")
    parser.add_argument("--keep", type=Path, help="Where to keep the last page.")
    options = parser.parse_args()
    rows = [row(people, options) for people in options.people]
    show(f"Pages of {options.exercises} exercises", (*MADE, *OPENED), rows)


def row(people: int, options: argparse.Namespace) -> list[str]:
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as folder:
        out, page = Path(folder) / "grades", Path(folder) / "page.html"
        recorded = a_class(out, people, options.exercises, options.recorded)
        busy = cpu()
        took, drawn = made(out, page)
        busy = cpu() - busy
        loaded, ready, sorted_ = opened(page, options.opened)
        size = page.stat().st_size / 1e6
        if options.keep:
            shutil.copy(page, options.keep)
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1000
    times = [f"{seconds:.2f}" for seconds in (loaded, ready, sorted_)]
    return [
        str(people),
        str(recorded),
        f"{took:.1f}",
        f"{busy:.1f}",
        f"{size:.1f}",
        str(drawn),
        f"{peak:.0f}",
        *times,
    ]


def cpu() -> float:
    """CPU seconds used by this process and by its children that have ended."""
    used = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(each.ru_utime + each.ru_stime for each in used)


def made(out: Path, page: Path) -> tuple[float, int]:
    began = time.monotonic()
    with Results.look(out) as results:
        found = read_class(out, results, open_course())
    whole = with_pictures(found, PICTURES_ROOM, lambda done, total: None)
    write_pieces(page, class_page(whole))
    return time.monotonic() - began, len(whole.pictures)


def opened(page: Path, times: int) -> tuple[float, float, float]:
    """Seconds until the page is loaded, until it is ready, and from a click on a heading to a new order."""
    from playwright.sync_api import sync_playwright

    figures = []
    with sync_playwright() as player:
        browser = player.chromium.launch(executable_path="/usr/bin/chromium", args=["--no-sandbox"])
        for _ in range(times):
            shown = browser.new_page()
            began = time.monotonic()
            shown.goto(page.as_uri(), wait_until="load")
            loaded = time.monotonic() - began
            shown.wait_for_selector("html[data-ready]", state="attached")
            shown.evaluate("() => new Promise((done) => requestAnimationFrame(() => setTimeout(done)))")
            ready = time.monotonic() - began
            begun = time.monotonic()
            shown.get_by_role("button", name="Total").click()
            shown.wait_for_selector("th[aria-sort=descending]")
            figures.append((loaded, ready, time.monotonic() - begun))
            shown.close()
        browser.close()
    loads, readies, sorts = zip(*figures, strict=True)
    return median(loads), median(readies), median(sorts)


def a_class(out: Path, people: int, exercises: int, recorded: float) -> int:
    """Make the folder of results; return how many recordings are in it."""
    chance = random.Random(7)
    chosen = [one for one in Course(open_course().root).exercises() if one.packages][:exercises]
    asked = [exercise.id for exercise in chosen]
    recordings = [a_recording(exercise, chance) for exercise in chosen]
    count = 0
    with Results.open(out) as results, results.all_or_nothing():
        every = [f"learner{number:04}" for number in range(people)]
        results.enter([Submission(one, f"Learner {one[7:]} Müller", f"{one}.zip", "d") for one in every])
        keep_settings(
            results, BatchSettings(out / "class", (), tuple(asked), False, True, datetime.now(timezone.utc))
        )
        for person in every:
            for name, recording in zip(asked, recordings, strict=True):
                file = f"evidence/{person}/{name}.mcap" if chance.random() < recorded else None
                if file:
                    count += 1
                    (out / file).parent.mkdir(parents=True, exist_ok=True)
                    (out / file).write_bytes(chance.choice(recording))
                graded = Graded(Unit(person, name), a_result(name, chance), 8.0)
                results.record(graded, package.__version__, file)
    return count


def a_result(exercise: str, chance: random.Random) -> Result:
    right = chance.choice((CHECKS, CHECKS, 9, 6, 3))
    checks = tuple(a_check(number, number < right, chance) for number in range(CHECKS))
    return Result(exercise, verdict_of(checks), checks, Timing(0.5, 4.0, chance.uniform(4, 12)))


def a_check(number: int, passed: bool, chance: random.Random) -> CheckResult:
    title = f"it does what step {number} of the lesson asks for"
    if passed:
        return CheckResult(f"step_{number}", title, 1, Outcome.PASSED)
    if number % 2:
        return CheckResult(f"step_{number}", title, 1, Outcome.SKIPPED, skipped_because='needs "step"')
    name = f"node_{chance.randrange(10**6):06}"
    place = Location(f"ros2_tutorial_workspace/src/package_{name}/package/{name}.py", chance.randrange(1, 90))
    feedback = Feedback(
        f"The program stopped with an error: NameError: name 'thing_{chance.randrange(12)}' is not defined.",
        expected=f"/{name}",
        seen=f"/{name}s",
        where=(place,),
        advice="Spell the name `thing`, letter by letter.",
        details=tuple(f"  {place}: {chance.random()}" for _ in range(6)),
    )
    return CheckResult(f"step_{number}", title, 1, Outcome.FAILED, feedback=feedback)


def a_recording(exercise: Exercise, chance: random.Random) -> list[bytes]:
    """Ten recordings, as files, with the code that was judged: the solution, edited."""
    files = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(10):
            file = Path(folder) / "one.mcap"
            seen = recording_of(exercise.id, chance)
            mcap_file.save(replace(seen, sources=sources_of(exercise, chance)), file, began_ns=10**18)
            files.append(file.read_bytes())
    return files


def sources_of(exercise: Exercise, chance: random.Random) -> Sources:
    texts = read_sources(exercise.solution, exercise.files).files
    return Sources({name: f"# {chance.random()}\n{text}" for name, text in texts.items()})


def recording_of(exercise: str, chance: random.Random) -> Recording:
    times = [round(1 + number * 0.1 + chance.uniform(0, 0.02), 6) for number in range(45)]
    values = [chance.randrange(1000) for _ in times]
    messages = [
        MessageSeen(t, "/counted", NUMBER, b"\0\1\0\0" + value.to_bytes(4, "little"))
        for t, value in zip(times, values, strict=True)
    ]
    events = (
        ProcessStarted(0.2, "counter", ("python3",)),
        GraphSeen(0.9, Graph(("/counter", "/helper"))),
        *(OutputLine(t, "counter", "counted") for t in times),
        *messages,
        SignalSent(5.6, "counter", 2),
        ProcessExited(5.9, "counter", 0, None),
    )
    ordered = tuple(sorted(events, key=lambda event: event.t))
    return Recording(exercise, ordered, {NUMBER: "int32 data\n"}, duration=6.0)


if __name__ == "__main__":
    main()
