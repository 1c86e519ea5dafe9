"""Submissions: archives, folders, rosters, and the files of a course home that we read ourselves."""

from __future__ import annotations

import contextlib
import functools
import os
import shutil
from collections.abc import Iterator
from pathlib import Path

from hypothesis import strategies as st

from course.arena.mystery_module import read_log
from course.batch.intake import Limits, Upload, find_sources, lay_out, look
from course.batch.intake.people import labels
from course.batch.worker import seed_of
from course.content import Exercise, open_course
from course.errors import CourseError
from course.grading.quiz.questions import check_quiz
from course.grading.trial_answers import SEED
from course.home.opening import Refused, open_archive
from course.model.result import Verdict, from_json, to_json
from tests.hostile.fuzz.conftest import fuzzed, soon
from tests.hostile.fuzz.inputs import mangled, names, tars, texts, zips

LIMITS = Limits(bytes=2_000_000, file=1_000_000, files=300, free=100_000)
ENDINGS = st.sampled_from(("zip", "tar", "tar.gz", "tgz", "tar.xz", "tar.bz2", "ZIP"))


@functools.cache
def exercises() -> tuple[Exercise, ...]:
    return open_course().exercises()


@contextlib.contextmanager
def a_place(tmp_path: Path) -> Iterator[Path]:
    """A fresh folder with a neighbor, which must be unchanged afterwards."""
    around, neighbor = tmp_path / "around", tmp_path / "around" / "neighbor"
    place = around / "place"
    place.mkdir(parents=True)
    neighbor.write_text("as it was")
    try:
        yield place
        assert {entry.name for entry in around.iterdir()} == {"place", "neighbor"}
        assert {entry.name for entry in tmp_path.iterdir()} == {"around"}
        assert neighbor.read_text() == "as it was"
    finally:
        shutil.rmtree(around)


def stays_inside(folder: Path) -> None:
    top = folder.resolve()
    for path, folders, files in os.walk(folder):
        for name in (*folders, *files):
            entry = Path(path, name)
            assert entry.resolve().is_relative_to(top), entry
            assert not entry.lstat().st_mode & 0o6000, entry


@fuzzed(st.tuples(ENDINGS, st.one_of(zips(), tars())), cases=150)
def test_an_archive(case: tuple[str, bytes], tmp_path: Path) -> None:
    ending, data = case
    with a_place(tmp_path) as place, soon():
        archive = place / f"work.{ending}"
        archive.write_bytes(data)
        try:
            open_archive(archive, place / "opened", LIMITS)
        except Refused:
            assert not (place / "opened").exists()
        else:
            stays_inside(place / "opened")
        assert {entry.name for entry in place.iterdir()} <= {archive.name, "opened"}


@fuzzed(st.tuples(st.lists(st.tuples(names, texts), max_size=6), st.lists(names, max_size=3)), cases=80)
def test_a_class_as_a_folder(case: tuple[list[tuple[str, str]], list[str]], tmp_path: Path) -> None:
    """Found, looked at and laid out, as `grade` does it; the second part of the case are links."""
    files, links = case
    with a_place(tmp_path) as place, soon():
        lay(place / "class", files, links)
        with contextlib.suppress(CourseError):
            hand_out(place)


@fuzzed(st.one_of(zips(), tars()), cases=50)
def test_a_class_as_an_archive(case: bytes, tmp_path: Path) -> None:
    with a_place(tmp_path) as place, soon():
        (place / "class.zip").write_bytes(case)
        with contextlib.suppress(CourseError):
            hand_out(place, "class.zip")


ROSTERS = (b"id,name,path\n1,Ada,ada\n2,Bao,bao.zip\n", "id;name;path\r\n1;\xc9;a\r\n".encode("cp1252"))


@fuzzed(mangled(ROSTERS), cases=300)
def test_a_roster(case: bytes, tmp_path: Path) -> None:
    with a_place(tmp_path) as place, soon():
        (place / "roster.csv").write_bytes(case)
        with contextlib.suppress(CourseError):
            for source in find_sources(place / "roster.csv", place / "opened", LIMITS).each:
                sound(source)


@fuzzed(st.lists(names, max_size=8), cases=300)
def test_names_of_people(case: list[str]) -> None:
    for label in labels(os.fsdecode(name.encode("utf-8", "surrogatepass")) for name in case).values():
        assert label.person.id.strip("._@+-"), label
        assert not {"/", "\0", "\n"} & set(label.person.id)
        label.person.name.encode()


MARKERS = (b'{"schema": 1, "seed": 123}', b'{"schema": 1e999, "seed": 1e999}', b"[" * 200_000)
ACTS = (b'{"schema": 1, "acts": [{"name": "set", "detail": "1"}]}', b'{"acts": ' + b"[" * 100_000)


@fuzzed(st.tuples(mangled(MARKERS), mangled(ACTS)), cases=200)
def test_the_state_of_a_course_home(case: tuple[bytes, bytes], tmp_path: Path) -> None:
    marker, acts = case
    with a_place(tmp_path) as place, soon():
        (place / ".ros2course").mkdir()
        (place / ".ros2course/home.json").write_bytes(marker)
        (place / "acts.json").write_bytes(acts)
        assert isinstance(seed_of("ada", place), int)
        assert len(read_log(place / "acts.json")) <= 1000


QUIZ = "01-terminal-quiz"
ANSWERS = (
    b"tab: completes\nhome: [a, b]\n",
    b"a: &a [x,x]\nb: &b [*a,*a]\ntab: *b\n",
    b"tab: !!python/name:os.system ''\n",
)


@fuzzed(mangled(ANSWERS), cases=150)
def test_answers(case: bytes, tmp_path: Path) -> None:
    quiz = next(exercise for exercise in exercises() if exercise.id == QUIZ)
    with a_place(tmp_path) as place, soon():
        (place / "answers").mkdir()
        (place / "answers" / f"{QUIZ}.yaml").write_bytes(case)
        result = check_quiz(quiz, place, SEED)
        assert result.verdict is Verdict.NOT_PASSED, result.fault
        assert from_json(to_json(result)).checks == result.checks


def lay(folder: Path, files: list[tuple[str, str]], links: list[str]) -> None:
    """If the file system accepts the names."""
    folder.mkdir()
    for name, text in files:
        with contextlib.suppress(OSError, ValueError):
            target = folder / Path(name.lstrip("/").replace("..", "_"))
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_bytes(text.encode("utf-8", "surrogatepass"))
    for number, leads_to in enumerate(links):
        with contextlib.suppress(OSError, ValueError):
            (folder / f"link-{number}").symlink_to(leads_to)


def hand_out(place: Path, name: str = "class") -> None:
    for number, source in enumerate(find_sources(place / name, place / "parts", LIMITS).each):
        sound(source)
        found = look(source, place / "opened" / str(number), exercises(), LIMITS)
        if found.places:
            lay_out(found, place / "homes" / source.person.id)
            stays_inside(place / "homes")


def sound(source: Upload) -> None:
    """Their ids are names of files, and what is shown can be shown."""
    assert source.person.id not in ("", ".", "..")
    assert "/" not in source.person.id
    for text in (source.person.name, source.shown, *(finding.what for finding in source.findings)):
        text.encode()
