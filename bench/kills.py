"""Kills our own processes while a class is graded: does a mark change, is anything lost or doubled?

A class hands in the solution and the known mistakes in turn. The usual `grade` command grades it once
quietly, and then in rounds, each with other packages to build. During a round, processes are killed
(SIGKILL) at random moments: one of the kind that was killed least often so far, and sometimes the command
itself, which is then started again. One command hits each submission at most twice, because the third attempt
at a grading is the last one. The command is killed only after it has judged a few.

All results are in the folder --keep: you can stop this at any moment, even with kill -9. The same command
then continues.
"""

from __future__ import annotations

import argparse
import csv
import json
import random
import sqlite3
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Iterator
from contextlib import closing, suppress
from dataclasses import asdict, dataclass, field
from pathlib import Path

import psutil
from mixed import lay_variants, variants
from repeat import changes, outcomes
from table import show

ROOT = Path(__file__).parents[1]
sys.path.insert(0, str(ROOT))

from course.batch.results import FILE  # noqa: E402 - the repository must be on the path
from course.content import open_course  # noqa: E402
from tests.batch.command import groups_of, half_written, outliving  # noqa: E402
from tests.processes import ours_below  # noqa: E402

COMMAND, WORKER, DASK = "command", "worker", "Dask worker"
# A `grade` that also writes down which worker gets whose submission, which is not visible from outside.
NOTING = """
import sys
from course.batch.pool import Worker
from course.child import Child
from course.cli.main import run

notes, sys.argv[1:] = open(sys.argv[1], "w", buffering=1), sys.argv[2:]
do = Worker.do

def noted(self, task):
    self._child = self._child or Child(self._work.worker)
    notes.write(f"{self._child.process.pid} {task.unit.person}\\n")
    return do(self, task)

Worker.do = noted
run()
"""
LONGEST_PAUSE = 0.6  # seconds between two kills
MOST_HITS = 2  # on one submission, by one command
FEW = 3  # gradings of a command before it may be killed, and kills of one kind more than of another
MOST_COMMANDS = 200  # in one round
Hit = tuple[str, str]  # kind of process, and whose submission it was working on; "" for the command
Gradings = dict[str, tuple[str, float]]


@dataclass
class Round:
    """The result of a round. again: whose first attempt did not count. changed: what, by person.

    our_errors, lost, doubled: by person. left: files, processes, and control groups that nobody needs.
    """

    hits: list[Hit] = field(default_factory=list)
    again: list[str] = field(default_factory=list)
    our_errors: list[str] = field(default_factory=list)
    changed: dict[str, list[str]] = field(default_factory=dict)
    lost: list[str] = field(default_factory=list)
    doubled: list[str] = field(default_factory=list)
    left: list[str] = field(default_factory=list)


@dataclass(frozen=True)
class Class:
    """One class, and where its results are. before: the command line up to and including `grade`."""

    folder: Path
    words: tuple[str, ...]

    @property
    def out(self) -> Path:
        return self.folder / "grades"

    @property
    def notes(self) -> Path:
        return self.folder / "notes.txt"

    @property
    def people(self) -> set[str]:
        return {home.name for home in (self.folder / "class").glob("p*")}

    def start(self) -> subprocess.Popen[bytes]:
        """Start a command that ends with us."""
        guard = ["setpriv", "--pdeathsig", "KILL", "--"]
        self.notes.write_text("")
        program = [sys.executable, "-c", NOTING, str(self.notes)]
        command = [*guard, *program, *self.words, "--out", str(self.out)]
        return subprocess.Popen(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def tasks(self) -> dict[int, str]:
        """Whose submission each worker has, by process id."""
        whole = self.notes.read_text().rpartition("\n")[0]
        noted = (line.split() for line in whole.splitlines())
        return {int(worker): person for worker, person in noted}

    def database(self) -> sqlite3.Connection:
        return sqlite3.connect(self.out / FILE)

    def judged(self) -> Gradings:
        """When each was graded, and how long it took, which identifies a grading."""
        with suppress(sqlite3.OperationalError), closing(self.database()) as database:
            rows = database.execute("SELECT person, at, seconds FROM gradings WHERE verdict <> 'our error'")
            return {person: (at, seconds) for person, at, seconds in rows}
        return {}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--course", type=Path, default=ROOT / "tests/fixtures/second_course")
    parser.add_argument("--exercise", default="61-alarm")
    parser.add_argument("--people", type=int, default=24, help="in each round")
    parser.add_argument("--jobs", type=int, default=4, help="gradings at once")
    parser.add_argument("--cluster", action="store_true", help="on Dask workers of this machine; kills those")
    parser.add_argument("--kills", type=int, default=100, help="of each kind of process")
    parser.add_argument("--rounds", type=int, default=1000, help="do at most this many more now")
    parser.add_argument("--keep", type=Path, default=Path("killed"), help="folder for all output")
    options = parser.parse_args()
    quiet, kinds = graded_quietly(options)
    kinds = [kind for kind in kinds if kind in (COMMAND, DASK)] if options.cluster else kinds
    journal = options.keep / options.exercise / "rounds.jsonl"
    rounds = [Round(**json.loads(line)) for line in lines(journal)]
    last = len(rounds) + options.rounds
    while len(rounds) < last and min((kills := killed(rounds, kinds)).values()) < options.kills:
        this = lay_class(options, f"round-{len(rounds)}", options.people)
        rounds.append(played(this, kills, options.kills))
        conclude(rounds[-1], this, quiet)
        append(journal, asdict(rounds[-1]))
        report(rounds, kinds)
    report(rounds, kinds)


def graded_quietly(options: argparse.Namespace) -> tuple[Class, list[str]]:
    """The expected results of a class with one of each, and the kinds of processes that were seen."""
    course = open_course(options.course)
    quiet = lay_class(options, "quiet", len(variants(options.exercise, course)))
    file = quiet.folder / "kinds.json"
    seen: set[str] = {COMMAND, *json.loads(file.read_text() if file.exists() else "[]")}
    while quiet.judged().keys() != quiet.people:
        with quiet.start() as process:
            top = psutil.Process(process.pid)
            while process.poll() is None:
                seen.update(kind for kind, _ in ours_below(top))
                time.sleep(0.02)
        file.write_text(json.dumps(sorted(seen)))
    return quiet, sorted(seen)


def lay_class(options: argparse.Namespace, name: str, people: int) -> Class:
    folder = options.keep.resolve() / options.exercise / name
    lay_variants(folder / "class", people, options.exercise, open_course(options.course))
    for file in (folder / "class").glob("p*/**/setup.py"):
        mark = f"# {file}"
        if mark not in file.read_text(encoding="utf-8"):  # without this edit, its build would be in the cache
            with file.open("a", encoding="utf-8") as opened:
                opened.write(f"\n{mark}\n")
    about = ("--course", str(options.course), "grade", str(folder / "class"))
    where = ("--cluster", "local") if options.cluster else ("--jobs", str(options.jobs))
    return Class(folder, (*about, "--exercises", options.exercise, *where))


def played(this: Class, kills: Counter[str], wanted: int) -> Round:
    """Grade the class, and kill. kills: how many of each kind there were so far; updated."""
    one, journal = Round(), this.folder / "hits.jsonl"
    for line in lines(journal):
        kind, person = json.loads(line)
        one.hits.append((kind, person))
        kills[kind] += 1
    started: set[psutil.Process] = set()
    began = time.time()
    for _ in range(MOST_COMMANDS):
        before = this.judged()
        with this.start() as process:
            for hit in strikes(process, this, kills, wanted, started):
                one.hits.append(hit)
                append(journal, hit)
        after = this.judged()
        one.doubled += [person for person, moment in before.items() if after.get(person) != moment]
        if process.returncode >= 0:
            one.our_errors += this.people - after.keys()
        if process.returncode == 0:
            break
    if not one.hits:
        raise SystemExit(f"{this.folder} was graded, and no process of ours was found there.")
    one.left += outliving([*started])
    one.left += groups_of([each.pid for each in started], since=began)
    return one


def strikes(
    command: subprocess.Popen[bytes],
    this: Class,
    kills: Counter[str],
    most: int,
    started: set[psutil.Process],
) -> Iterator[Hit]:
    """Kill until the command has ended. started: a set to which everything that it starts is added."""
    top, hits, judged = psutil.Process(command.pid), Counter[str](), len(this.judged())
    while command.poll() is None:
        time.sleep(random.uniform(0, LONGEST_PAUSE))
        spared = {kind for kind in kills if kills[kind] >= min(most, min(kills.values()) + FEW)}
        if len(this.judged()) < judged + FEW:
            spared.add(COMMAND)
        aims = [
            aim for aim in targets(top, this.tasks()) if aim[0] not in spared and hits[aim[2]] < MOST_HITS
        ]
        if aims:
            random.shuffle(aims)
            kind, process, person = min(aims, key=lambda aim: kills[aim[0]])
            started.update(below(top))
            with suppress(psutil.Error):
                process.kill()
                kills[kind] += 1
                hits[person] += 1
                yield kind, person


def targets(top: psutil.Process, tasks: dict[int, str]) -> Iterator[tuple[str, psutil.Process, str]]:
    """Kind, process, and person of everything that is working on a submission; and the command itself."""
    whose: dict[psutil.Process, str] = {}
    found = list(ours_below(top))
    for _, worker in (each for each in found if each[0] == WORKER):
        if person := tasks.get(worker.pid):
            whose.update(dict.fromkeys([worker, *below(worker)], person))
    yield from ((kind, process, whose[process]) for kind, process in found if process in whose)
    dask = [process for kind, process in found if kind == DASK]
    yield from ((DASK, process, "") for process in dask)  # it is not known whose submission it has
    if whose or dask:
        yield COMMAND, top, ""


def below(process: psutil.Process) -> list[psutil.Process]:
    try:
        return process.children(recursive=True)
    except psutil.Error:
        return []


def conclude(one: Round, this: Class, quiet: Class) -> None:
    with closing(this.database()) as database, closing(quiet.database()) as other:
        found, expected = outcomes(database), outcomes(other)
        again = database.execute("SELECT person FROM gradings WHERE attempt > 1")
        one.again = [person for (person,) in again]
    for person in sorted(this.people):
        if person not in found:
            one.lost.append(person)
        elif what := changes(expected[f"p{int(person[1:]) % len(expected):05}"], found[person]):
            one.changed[person] = what
            print(f"{this.folder.name} {person}, {[kind for kind, of in one.hits if of == person]}: {what}")
    with (this.out / "results.csv").open(encoding="utf-8-sig", newline="") as file:
        rows = Counter(row["id"] for row in csv.DictReader(file))
    one.lost += [person for person in this.people if not rows[person]]
    one.doubled += [person for person, times in rows.items() if times > 1]
    one.left += half_written(this.out)


def killed(rounds: list[Round], kinds: list[str]) -> Counter[str]:
    found = Counter(dict.fromkeys(kinds, 0))
    found.update(kind for one in rounds for kind, _ in one.hits)
    return found


HEAD = ("process", "kills", "graded again", "our errors", "marks changed", "lost", "doubled")


def report(rounds: list[Round], kinds: list[str]) -> None:
    """Each grading counts for every kind of kill that hit it; all gradings count for the command."""
    rows = []
    for kind, kills in sorted(killed(rounds, kinds).items()):
        figures = [0] * (len(HEAD) - 2)
        for one in rounds:
            hit = {person for each, person in one.hits if each == kind}
            for place, people in enumerate((one.again, one.our_errors, one.changed, one.lost, one.doubled)):
                figures[place] += len(people) if "" in hit else len(hit.intersection(people))
        rows.append([kind, str(kills), *map(str, figures)])
    left = sum(len(one.left) for one in rounds)
    show(f"{len(rounds)} rounds; {left} files, processes or control groups left behind", HEAD, rows)


def lines(file: Path) -> list[str]:
    return file.read_text(encoding="utf-8").splitlines() if file.exists() else []


def append(file: Path, what: object) -> None:
    with file.open("a", encoding="utf-8") as opened:
        opened.write(json.dumps(what) + "\n")


if __name__ == "__main__":
    main()
