"""What a learner reads about mistakes that no feedback was written for: `bench/mistakes/*.yaml`.

Each mistake is made in the solution, or in the alternative that `over` names, and graded as `check` does. The
feedback for those that match PATTERN is printed, for a person to read and judge. --figures prints the
judgments in `bench/mistakes/judgments.yaml`. Each mistake has letters, and after a `/` those of a second
reading, after its feedback was improved: c (the true cause is named), l (the
feedback leads to the fix) or p (it leads there partly), m (it misleads), u (not caught). `e` marks edits
that turned out to be right. `fresh` and `strict` are sets. Every other mistake of each other file belongs
to the set `blind`: read these only after explanations were improved.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import yaml
from table import show

from course.content import Course, Edit, Exercise, Mistake, open_course
from course.errors import ContentError
from course.grading import trial
from course.grading.check import Request, check_exercise
from course.grading.load import runs_programs
from course.grading.trial_answers import SEED
from course.model.result import Outcome, Result
from course.rosenv import find_ros
from course.validate.claims import words_of

MISTAKES = Path(__file__).parent / "mistakes"
JUDGMENTS = MISTAKES / "judgments.yaml"
WHOLE = ("fresh", "strict")  # sets that are a file each
Entry = dict[str, Any]


class DoesNotFit(Exception):
    """An edit that finds no text to replace, no file, or several files."""


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("pattern", nargs="*", help="parts of the ids; by default, all")
    parser.add_argument("--set", choices=("open", "blind", *WHOLE), help="only these")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--keep", type=Path, default=Path("feedback"), help="folder for what was said")
    parser.add_argument("--again", action="store_true", help="grade what was graded before, too")
    parser.add_argument("--figures", action="store_true", help="print the percentages of the judgments")
    options = parser.parse_args()
    if options.figures:
        return figures()
    options.keep.mkdir(exist_ok=True)
    chosen = [entry for entry in entries() if options.set in (None, entry["set"])]
    if options.pattern:
        chosen = [entry for entry in chosen if any(part in entry["id"] for part in options.pattern)]
    files = {entry["id"]: options.keep / f"{entry['id']}.txt" for entry in chosen}
    todo = [entry for entry in chosen if options.again or not files[entry["id"]].exists()]
    unfit = []
    with ProcessPoolExecutor(options.jobs) as pool:
        for entry, task in [(entry, pool.submit(graded, entry)) for entry in todo]:
            try:
                text = task.result()
            except DoesNotFit as error:
                unfit.append(f"{entry['id']}: {error}")
                continue
            files[entry["id"]].write_text(text, encoding="utf-8")
            print(text, flush=True)
    if unfit:
        sys.exit("\n".join(["These mistakes cannot be made:", *unfit]))


def entries() -> Iterator[Entry]:
    for file in sorted(MISTAKES.glob("*.yaml")):
        if file != JUDGMENTS:
            for number, entry in enumerate(yaml.safe_load(file.read_text(encoding="utf-8"))):
                yield {**entry, "set": file.stem if file.stem in WHOLE else ("open", "blind")[number % 2]}


def graded(entry: Entry) -> str:
    """The feedback of every check that failed, in a few lines."""
    course = open_course()
    exercise = course.exercise(entry["exercise"])
    over = f", {entry['over']}" if "over" in entry else ""
    head = f"=== {entry['id']} ({exercise.id}{over}): {entry['summary']}"
    with tempfile.TemporaryDirectory(prefix="ros2course-bench-") as home:
        try:
            lay(course, exercise, entry, Path(home))
        except ContentError as error:
            raise DoesNotFit(f"{error}. {error.next_step}") from None
        ros = find_ros() if runs_programs(exercise) else None
        result = check_exercise(Request(exercise, Path(home), ros=ros, seed=SEED))
    return "\n".join([head, *told(result)])


def lay(course: Course, exercise: Exercise, entry: Entry, home: Path) -> None:
    other = next((one for one in exercise.alternatives() if one.name == entry.get("over")), None)
    if other:
        trial.lay_alternative(course, exercise, other, home)
    else:
        trial.lay_solution(course, exercise, home)
    trial.apply_mistake(exercise, mistake(entry, home), home)


def mistake(entry: Entry, home: Path) -> Mistake:
    edits = []
    for given in entry["edits"]:
        edit = {("with_" if key == "with" else key): value for key, value in given.items()}
        names = [str(path.relative_to(home)) for path in home.rglob("*") if path.is_file()]
        found = [name for name in names if f"/{name}".endswith(f"/{edit['file']}") and "/build/" not in name]
        if len(found) != 1:
            raise DoesNotFit(f"{edit['file']} is {', '.join(found) or 'not there'}")
        edits.append(Edit(**{**edit, "file": found[0]}))
    return Mistake(entry["id"], entry["exercise"], entry["summary"], tuple(edits), "", ())


def told(result: Result) -> Iterator[str]:
    if result.fault:
        yield f"FAULT {words_of(result.fault)}"
    for check in result.checks:
        if check.outcome in (Outcome.FAILED, Outcome.ERROR):
            yield f"[{check.id}] {check.outcome.value}: {words_of(check.feedback)}"
    yield f"-- {result.verdict.value}, {result.points:g} of {result.max_points:g}"


def figures() -> None:
    judged: dict[str, str] = yaml.safe_load(JUDGMENTS.read_text(encoding="utf-8"))
    every = list(entries())
    unknown = sorted({*judged} - {entry["id"] for entry in every})
    assert not unknown, f"no such mistakes: {unknown}"
    rows = []
    for name in ("open", "blind", *WHOLE):
        mine = [judged[entry["id"]] for entry in every if entry["set"] == name and entry["id"] in judged]
        letters = [each.split("/") for each in mine if each != "e"]
        for title, place in ((name, 0), (f"{name}, again", -1))[: 1 + any(len(each) > 1 for each in letters)]:
            chosen = [each[place] for each in letters]
            rows.append([title, str(len(chosen)), *(_share(letter, chosen) for letter in "uclpm")])
    show("mistakes that no feedback was written for", HEAD, rows)


HEAD = ("set", "judged", "not caught", "cause named", "leads to the fix", "partly", "misleads")


def _share(letter: str, letters: list[str]) -> str:
    count = sum(letter in each for each in letters)
    return f"{count} ({100 * count / max(len(letters), 1):.0f} %)"


if __name__ == "__main__":
    main()
