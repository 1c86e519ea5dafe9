"""A class of twenty-four that answers a quiz, as Canvas exports it: zip, gradebook, people."""

from __future__ import annotations

import shutil
import tarfile
import zipfile
from collections.abc import Callable
from pathlib import Path

from course.content import open_course
from course.grading import trial
from tests.batch.samples import QUIZ
from tests.conftest import FIXTURES

MESSAGES = "python_package_that_uses_the_messages"
COURSE = FIXTURES / "quiz_course"
FIRST = (
    *("Ada", "Bao", "Carla", "Dilara", "Emre", "Fatou", "Gita", "Hugo", "Ines", "Jun", "Kofi", "Lena"),
    *("Mateo", "Nadia", "Omar", "Priya", "Quinn", "Rosa", "Sven", "Tariq", "Uma", "Vera", "Wei", "Zoë"),
)
LAST = ("Okafor", "Nguyen", "Lind", "Aydın")
# People who handed in nothing; their last names come first in Canvas' list.
ABSENT = frozenset({22, 23})
LATE = frozenset({5, 6})


def name(place: int) -> str:
    return f"{LAST[place % 4]}, {FIRST[place]}"


def identity(place: int) -> str:
    return str(4100 + place)


def gradebook() -> bytes:
    """Canvas' own gradebook, in its odd form: a second row, quotes only where needed, a test student."""
    rows = ["Student,ID,SIS User ID,SIS Login ID,Section,Quiz on lights (771),Final Score"]
    rows.append("    Points Possible,,,,,6.00,(read only)")
    for place in range(len(FIRST)):
        login = FIRST[place].lower()
        rows.append(f'"{name(place)}",{identity(place)},S{place:03},{login},"ROS, A",,87.50')
    rows.append('"Student, Test",9999,,abcdef0123,"ROS, A",,')
    return "\r\n".join([*rows, ""]).encode("utf-8-sig")


def lay_term(folder: Path) -> Path:
    """Makes class.zip and canvas.csv in the folder, which is made."""
    folder.mkdir(parents=True)
    made = folder / "made"
    made.mkdir()
    for place in range(len(FIRST)):
        if place not in ABSENT:
            _hand_in(place, folder / "home", made)
    with zipfile.ZipFile(folder / "class.zip", "w") as archive:
        for file in sorted(made.iterdir()):
            archive.write(file, file.name)
    shutil.rmtree(made)
    (folder / "canvas.csv").write_bytes(gradebook())
    return folder


def lay_moodle(term: Path) -> Path:
    """Adds `moodle`: the same class as Moodle exports it, a folder for each person."""
    with zipfile.ZipFile(term / "class.zip") as archive:
        for file in archive.namelist():
            number, upload = file.split("_")[-3::2]
            folder = term / "moodle" / f"{name(int(number) - 4100)}_{number}_assignsubmission_file_"
            folder.mkdir(parents=True)
            (folder / upload).write_bytes(archive.read(file))
    return term


def lay_renamed(folder: Path) -> None:
    """Three right publishers: in a package of another name, as a program of another name, and both."""
    course = open_course()
    for person, package, program in (
        ("ada", "quotes", ""),
        ("bao", "", "talker"),
        ("cleo", "quotes", "talker"),
    ):
        trial.lay_solution(course, course.exercise("18-publisher"), folder / person)
        src = folder / person / "ros2_tutorial_workspace/src"
        if program:
            _replace(src / MESSAGES / "setup.py", "'amazing_quote_publisher_node = '", f"'{program} = '")
        if package:
            for file in ("setup.py", "setup.cfg", "package.xml"):
                _replace(src / MESSAGES / file, MESSAGES, package)
            for inside in (MESSAGES, f"resource/{MESSAGES}", ""):
                path = src / MESSAGES / inside
                path.rename(path.with_name(package))


def _replace(file: Path, old: str, new: str) -> None:
    file.write_text(file.read_text(encoding="utf-8").replace(old, new), encoding="utf-8")


def _hand_in(place: int, home: Path, made: Path) -> None:
    late = "_LATE" if place in LATE else ""
    plain = "".join(filter(str.isascii, name(place).replace(", ", "").lower()))
    stem = made / f"{plain}{late}_{identity(place)}_{8000 + place}_"
    course = open_course(COURSE)
    exercise = course.exercise(QUIZ)
    home.mkdir()
    trial.lay_solution(course, exercise, home)
    mistakes = {mistake.id: mistake for mistake in exercise.mistakes()}
    if place % 3 == 1:
        trial.apply_mistake(exercise, mistakes["saves-oil"], home)
    if place % 8 == 2:
        trial.apply_mistake(exercise, mistakes["whole-file-wrong"], home)
    _FORMS[place % len(_FORMS)](home, stem)
    shutil.rmtree(home)


def _zip(home: Path, stem: Path) -> None:
    with zipfile.ZipFile(f"{stem}quiz.zip", "w") as archive:
        for path in home.rglob("*"):
            archive.write(path, path.relative_to(home))


def _wrapped(home: Path, stem: Path) -> None:
    with zipfile.ZipFile(f"{stem}my work-1.zip", "w") as archive:
        for path in home.rglob("*"):
            archive.write(path, Path("my work") / path.relative_to(home))


def _tar(home: Path, stem: Path) -> None:
    with tarfile.open(f"{stem}quiz.tar.gz", "w:gz") as archive:
        archive.add(home, "submission")


def _single(home: Path, stem: Path) -> None:
    shutil.copy(home / f"answers/{QUIZ}.yaml", f"{stem}{QUIZ}.yaml")


def _broken(home: Path, stem: Path) -> None:
    Path(f"{stem}quiz.zip").write_bytes(b"PK\x03\x04 and no more")


def _poem(home: Path, stem: Path) -> None:
    Path(f"{stem}poem.txt").write_text("Roses are red.")


_FORMS: tuple[Callable[[Path, Path], None], ...] = (
    *(_zip, _wrapped, _tar, _single, _zip, _wrapped, _zip, _broken, _tar, _single, _zip, _poem),
)
