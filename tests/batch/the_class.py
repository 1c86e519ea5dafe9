"""A class of sixty, and the verdicts that each must get: as right, wrong and hostile as classes are.

Their exercises are quick ones, and nobody is graded for what they did not hand in. Of a mistake it is known
which checks fail (mistakes.yaml); of all else whether it passes.
"""

from __future__ import annotations

import itertools
import os
import shutil
import tarfile
import zipfile
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from course.content import Course, Exercise, Mistake
from course.files import wipe
from course.grading import trial
from course.grading.author import Grader
from course.grading.load import declared, load_module
from course.model.result import Verdict
from tests.hostile.world import NODE, with_attack

WORKSPACE = "ros2_tutorial_workspace"
MESSAGES = f"{WORKSPACE}/src/python_package_that_uses_the_messages/python_package_that_uses_the_messages"
# Other exercises of the same chapters.
OTHERS = (f"{MESSAGES}/amazing_quote_subscriber_node.py", f"{WORKSPACE}/src/rover")
# How many mistakes of which exercise.
MISTAKES = {"07-simplest-package": 13, "14-library": 12, "04-layout": 4, "18-publisher": 8}
ATTACKS: Mapping[str, Mapping[str, object]] = {
    "fork_bomb": {"MOST": 40},
    "memory_hog": {"PROCESSES": 0},
    "disk_filler": {},
    "thread_bomb": {},
}


@dataclass(frozen=True)
class Expected:
    """failed: ids of all checks that fail, None where it is only known that some do."""

    verdict: Verdict
    failed: frozenset[str] | None = frozenset()


PASSES = Expected(Verdict.PASSED)
FAILS = Expected(Verdict.NOT_PASSED, None)


@dataclass(frozen=True)
class Member:
    """person: the id that they get. what: for a reader of the table. expected: by exercise."""

    person: str
    what: str
    expected: Mapping[str, Expected] = field(default_factory=dict)


@dataclass(frozen=True)
class _Work:
    """A person's work before it is handed in. home_only: it counts only in its place in the home."""

    what: str
    exercise: str
    expected: Expected
    lay: Callable[[Path], None]
    home_only: bool = False


def lay_class(
    course: Course, folder: Path, mistakes: Mapping[str, int] = MISTAKES, *, honest: bool = False
) -> tuple[Member, ...]:
    """Makes the folder, with sixty submissions; the verdicts that they must get.

    mistakes: how many of which exercises, beside their right ways. honest: nobody hostile, nothing odd.
    """
    folder.mkdir()
    forms = itertools.cycle((_as_folder, _as_moodle, _as_canvas, _as_tar))
    loose = itertools.cycle((_as_workspace, _as_packages, _as_folder, _as_canvas))
    members = []
    for number, work in enumerate(_works(course, mistakes)):
        home = folder.parent / "made"
        work.lay(home)
        form = next(forms if work.home_only else loose)
        person = form(home, folder, number)
        members.append(Member(person, work.what, _expected(work)))
        shutil.rmtree(home)
    if not honest:
        members += [*_hostile(course, folder), *_odd(folder)]
    return tuple(members)


def _expected(work: _Work) -> dict[str, Expected]:
    """People who publish messages have also handed in their definition."""
    before = {"17-interfaces": PASSES} if work.exercise.startswith("18") else {}
    return {**before, work.exercise: work.expected}


def _works(course: Course, wanted: Mapping[str, int]) -> Iterator[_Work]:
    for name, count in wanted.items():
        exercise = course.exercise(name)
        home_only = name == "04-layout"  # not in the workspace
        yield _Work("solution", name, PASSES, _solution(course, exercise), home_only)
        # If a file of the exercise is missing, nobody can tell that it was handed in.
        for alternative in [each for each in exercise.alternatives() if not each.deletes][:3]:
            lay = _alternative(course, exercise, alternative.name)
            yield _Work(alternative.name, name, PASSES, lay, home_only)
        mistakes = [mistake for mistake in exercise.mistakes() if _stays_in_its_files(mistake)]
        for mistake in mistakes[:: max(1, len(mistakes) // count)][:count]:
            expected = _failing(exercise, frozenset({mistake.caught_by, *mistake.also_fails}))
            yield _Work(mistake.id, name, expected, _mistake(course, exercise, mistake), home_only=True)


def _failing(exercise: Exercise, failed: frozenset[str]) -> Expected:
    """A bonus is not needed to pass."""
    checks = declared(load_module(exercise.grader), Grader, exercise.id).checks
    spared = all(checks[name].bonus for name in failed)
    return Expected(Verdict.PASSED if spared else Verdict.NOT_PASSED, failed)


def _stays_in_its_files(mistake: Mistake) -> bool:
    """If files are missing or misplaced, another exercise may be found, or none."""
    return all(edit.replace is not None for edit in mistake.edits)


def _without_others(home: Path) -> None:
    for other in OTHERS:
        wipe(home / other)


def _solution(course: Course, exercise: Exercise) -> Callable[[Path], None]:
    def lay(home: Path) -> None:
        home.mkdir()
        trial.lay_solution(course, exercise, home)
        _without_others(home)

    return lay


def _alternative(course: Course, exercise: Exercise, name: str) -> Callable[[Path], None]:
    def lay(home: Path) -> None:
        home.mkdir()
        chosen = next(each for each in exercise.alternatives() if each.name == name)
        trial.lay_alternative(course, exercise, chosen, home)
        _without_others(home)

    return lay


def _mistake(course: Course, exercise: Exercise, mistake: Mistake) -> Callable[[Path], None]:
    def lay(home: Path) -> None:
        home.mkdir()
        trial.lay_mistake(course, exercise, mistake, home)
        _without_others(home)

    return lay


def _hostile(course: Course, folder: Path) -> Iterator[Member]:
    """Right solutions whose node attacks first."""
    for name, values in ATTACKS.items():
        home = folder / f"mallory-{name}"
        _solution(course, course.exercise("18-publisher"))(home)
        (home / NODE).write_text(with_attack(name, **values), encoding="utf-8")
        yield Member(home.name, name, {"17-interfaces": PASSES, "18-publisher": FAILS})


def _odd(folder: Path) -> Iterator[Member]:
    """Submissions that contain nothing to grade."""
    (folder / "empty").mkdir()
    yield Member("empty", "an empty folder")
    (folder / "poem").mkdir()
    (folder / "poem/poem.txt").write_text("Roses are red.")
    yield Member("poem", "no program")
    (folder / "broken.zip").write_bytes(b"PK\x03\x04 and no more")
    yield Member("broken", "a broken archive")
    (folder / "torn.tar.gz").write_bytes(b"\x1f\x8b\x08\x00 torn")
    yield Member("torn", "a torn archive")
    with zipfile.ZipFile(folder / "climber.zip", "w") as archive:
        archive.writestr("../../climbed.txt", "out")
        archive.writestr("/tmp/climbed.txt", "out")
    yield Member("climber", "an archive that wants to be written elsewhere")
    with zipfile.ZipFile(folder / "bomb.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("zeros", bytes(90_000_000))
    yield Member("bomb", "an archive that is far larger than it looks")
    (folder / "pipe").mkdir()
    os.mkfifo(folder / "pipe/package.xml")
    yield Member("pipe", "a pipe for a file")
    (folder / "linker").mkdir()
    (folder / "linker/src").symlink_to("/etc")
    yield Member("linker", "a link to elsewhere")


def _as_folder(home: Path, folder: Path, number: int) -> str:
    shutil.copytree(home, folder / f"learner{number:02}", symlinks=True)
    return f"learner{number:02}"


def _as_moodle(home: Path, folder: Path, number: int) -> str:
    name = f"Ada M. Learner_{number + 7000}_assignsubmission_file_"
    (folder / name).mkdir()
    _zip(home, folder / name / "my work.zip", "")
    return str(number + 7000)


def _as_canvas(home: Path, folder: Path, number: int) -> str:
    _zip(home, folder / f"learnerbao_{number + 3000}_{number + 90000}_ros2.zip", "ros2/")
    return str(number + 3000)


def _as_tar(home: Path, folder: Path, number: int) -> str:
    with tarfile.open(folder / f"tarred{number:02}.tar.gz", "w:gz") as archive:
        archive.add(home, f"tarred{number:02}")
    return f"tarred{number:02}"


def _as_workspace(home: Path, folder: Path, number: int) -> str:
    shutil.copytree(home / WORKSPACE, folder / f"workspace{number:02}")
    return f"workspace{number:02}"


def _as_packages(home: Path, folder: Path, number: int) -> str:
    shutil.copytree(home / WORKSPACE / "src", folder / f"packages{number:02}" / "ros2")
    return f"packages{number:02}"


def _zip(home: Path, archive: Path, top: str) -> None:
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as written:
        for path in sorted(home.rglob("*")):
            written.write(path, top + str(path.relative_to(home)))
