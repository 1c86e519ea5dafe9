"""A class that hands in one exercise in every way that real classes do, with a list of the whole class."""

from __future__ import annotations

import csv
import shutil
import subprocess
import tarfile
import zipfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from course.batch.batch_plan import BatchPlan, plan_batch, remarks_on, sentence
from course.build import Store
from course.cli.main import main
from course.content import open_course
from course.grading import trial
from course.isolation import Level
from course.isolation.levels import obstacle_to
from tests.batch.command import Command
from tests.batch.term import MESSAGES, lay_renamed

EXERCISE = "18-publisher"
INTERFACES = "package_with_interfaces"
SRC = "ros2_tutorial_workspace/src"
NODE = f"{SRC}/{MESSAGES}/{MESSAGES}/amazing_quote_publisher_node.py"
MOODLE = "_assignsubmission_file_"
LENIENT = f"{EXERCISE} is graded as if "
LAID = f"For packages that were not handed in, the course's own are used. ({INTERFACES})"

# Lays what one person hands in: home (right, for this person alone), folder of the class.
Lay = Callable[[Path, Path], object]


@dataclass(frozen=True)
class Way:
    """id: whose it becomes. kind: as the table shows it. points: of 12. remarks: how each of them begins."""

    id: str
    kind: str
    points: float
    lay: Lay
    remarks: tuple[str, ...] = ()


def zipped(home: Path, file: Path, top: str = "") -> None:
    with zipfile.ZipFile(file, "w") as archive:
        for path in sorted(home.rglob("*")):
            archive.write(path, top + str(path.relative_to(home)))


def wrong(home: Path) -> Path:
    """The home with another topic."""
    node = home / NODE
    node.write_text(node.read_text().replace("'/amazing_quote'", "'/amazing_quotes'"))
    return home


def two_tries(home: Path, folder: Path) -> None:
    zipped(home, folder / "liwei_4102_678906_homework-2.zip")
    zipped(wrong(home), folder / "liwei_4102_678904_homework-1.zip")


def report_beside(home: Path, folder: Path) -> None:
    zipped(home, folder / "okaforcem_4103_8003_work.zip")
    (folder / "okaforcem_4103_8013_report.pdf").write_bytes(b"%PDF")


def flat(home: Path, folder: Path) -> None:
    package = home / SRC / MESSAGES
    files = (package / "package.xml", package / "setup.py", package / "setup.cfg", home / NODE)
    for number, file in enumerate(files, 8104):
        shutil.copy(file, folder / f"linddi_4104_{number}_{file.name}")


def late_tar(home: Path, folder: Path) -> None:
    with tarfile.open(folder / "kayaemre_LATE_4105_8005_work.tar.gz", "w:gz") as archive:
        archive.add(wrong(home), "work")


def put(folder: Path, name: str, content: bytes = b"") -> None:
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_bytes(content)


def moodle(home: Path, folder: Path) -> None:
    (folder / f"Ines Ib_5101{MOODLE}").mkdir()
    zipped(home, folder / f"Ines Ib_5101{MOODLE}" / "my work.zip", "my work/")


def beside_src(home: Path, folder: Path) -> None:
    shutil.copytree(home / SRC, folder / "leo/ws/src")
    shutil.move(folder / "leo/ws/src" / INTERFACES, folder / "leo/ws")


def twice(home: Path, folder: Path) -> None:
    for copy in ("a", "b"):
        shutil.copytree(home / SRC, folder / "max" / copy)


def ignored(home: Path, folder: Path) -> None:
    shutil.copytree(home / SRC, folder / "noa/src")
    (folder / "noa/src" / MESSAGES / "COLCON_IGNORE").touch()


def clone(name: str) -> Lay:
    def lay(home: Path, folder: Path) -> None:
        shutil.copytree(home, folder / name)
        who = ("-c", "user.name=a", "-c", "user.email=a@b")
        for words in (("init", "-q"), ("add", "-A"), (*who, "commit", "-q", "-m", "Work")):
            subprocess.run(["git", *words], cwd=folder / name, check=True)

    return lay


def renamed(person: str) -> Lay:
    """A right package or program of another name, from `tests.batch.term`."""

    def lay(home: Path, folder: Path) -> None:
        lay_renamed(home.parent / "renamed")
        shutil.copytree(home.parent / "renamed" / person, folder / f"renamed-{person}")
        shutil.rmtree(home.parent / "renamed")

    return lay


def put_nested(home: Path, folder: Path) -> None:
    """An archive in a folder in a folder, next to notes."""
    put(folder, "oli/week 3/notes.txt")
    zipped(home, folder / "oli/week 3/final (2).zip", "final/")


def torn(home: Path, folder: Path) -> None:
    zipped(home, folder / "uma.zip")
    (folder / "uma.zip").write_bytes((folder / "uma.zip").read_bytes()[:-200])


def broken(home: Path, folder: Path) -> None:
    (home / NODE).write_text("def main(:\n")
    shutil.copytree(home, folder / "vic/some/where")


WAYS = (
    Way("4101", "course home", 12, lambda home, to: zipped(home, to / "okaforada_4101_8001_a.zip")),
    Way("4102", "course home", 12, two_tries, ("It contains more than one course home. Used: `homework-2`",)),
    Way("4103", "course home", 12, report_beside, ("Other files were not used. (report.pdf)",)),
    Way("4104", "packages", 12, flat, (LAID, "Its files were handed in without their folders")),
    Way("4105", "course home", 5, late_tar),
    Way(
        *(
            "4106",
            "files",
            11,
            lambda home, to: shutil.copy(home / NODE, to / f"eh_4106_8006_{Path(NODE).name}"),
        ),
        (f"{LENIENT}a setup.py", LAID, "For files of the package that were not handed in"),
    ),
    Way("4107", "nothing", 0, lambda _, to: put(to, "ho_4107_link.html"), ("A link was handed in",)),
    Way(
        "4108", "unreadable", 0, lambda _, to: put(to, "ha_4108_8008_w.rar", b"Rar!"), ("This is not a zip",)
    ),
    Way(
        "4109", "unreadable", 0, lambda _, to: put(to, "hu_4109_8009_w.7z", b"7z\xbc"), ("This is not a zip",)
    ),
    Way("4110", "unreadable", 0, lambda _, to: put(to, "hi_4110_8010_w.zip"), ("The archive is empty.",)),
    Way(
        "4111", "nothing", 0, lambda _, to: zipped(to / "none", to / "he_4111_8011_w.zip"), ("It is empty.",)
    ),
    Way("4112", "nothing", 0, lambda _, to: put(to, "hy_4112_8012_w.pdf", b"%PDF"), ("No course home",)),
    Way("5101", "course home", 12, moodle),
    Way("5102", "nothing", 0, lambda _, to: (to / f"Jo Ja_5102{MOODLE}").mkdir(), ("It is empty.",)),
    Way("5103", "course home", 12, lambda home, to: zipped(home, to / f"Kim Ko_5103{MOODLE}w.zip")),
    Way("eva", "workspace", 12, lambda home, to: shutil.copytree(home / SRC, to / "eva/src")),
    Way("fay", "packages", 12, lambda home, to: shutil.copytree(home / SRC, to / "fay")),
    Way(
        "gus", "packages", 12, lambda home, to: zipped(home / SRC / MESSAGES, to / "gus.zip", "a/b/"), (LAID,)
    ),
    Way("leo", "workspace", 12, beside_src),
    Way("max", "packages", 12, twice, ("It contains a package more than once. Used: `a/",)),
    Way("noa", "workspace", 0, ignored),
    Way("oli", "course home", 12, put_nested),
    Way("tim", "course home", 12, clone("lab1-tim")),
    Way("tom", "course home", 12, clone("lab1-tom")),
    Way("renamed-ada", "course home", 11, renamed("ada"), (LENIENT,)),
    Way("renamed-bao", "course home", 11, renamed("bao"), (LENIENT,)),
    Way("uma", "unreadable", 0, torn, ("The archive is broken. (uma.zip)",)),
    Way("vic", "course home", 2, broken),
    Way("wes", "nothing", 0, lambda _, to: put(to, "wes/poem.txt", b"Roses are red."), ("No course home",)),
    Way("absent", "nothing", 0, lambda home, folder: None, ("Nothing was handed in.",)),
)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """`class`, also with files that are nobody's. `sheet.csv` next to it: Canvas' gradebook of everybody."""
    course, to = open_course(), tmp_path / "class"
    to.mkdir()
    trial.lay_solution(course, course.exercise(EXERCISE), tmp_path / "solved")
    shutil.rmtree(tmp_path / "solved" / SRC / "rover")
    for way in WAYS:
        home = shutil.copytree(tmp_path / "solved", tmp_path / "home")
        way.lay(home, to)
        shutil.rmtree(home)
    for name in ("README.txt", "grades.xlsx", ".DS_Store"):
        put(to, name)
    rows = "".join(f"Learner {way.id},{way.id},,87.5\r\n" for way in WAYS)
    sheet = f"\ufeffStudent,ID,Week 3 (77),Final Score\r\n    Points Possible,,12,(read only)\r\n{rows}"
    (tmp_path / "sheet.csv").write_bytes(sheet.encode())
    return to


def looked_at(folder: Path) -> BatchPlan:
    course, opened = open_course(), folder.parent / "opened"
    roster = folder.parent / "sheet.csv"
    chosen = [EXERCISE]
    return plan_batch(
        folder, opened, course, chosen, single=False, roster=roster, complete=True, lenient=True
    )


def test_everybody_is_recognized_and_what_is_wrong_is_named(folder: Path) -> None:
    plan = looked_at(folder)
    told = {found.person.id: remarks_on(found) for found in plan.found}
    kinds = [(found.person.id, found.kind.value) for found in plan.found]
    assert kinds == [(way.id, way.kind) for way in WAYS]
    for way in WAYS:
        assert len(told[way.id]) == len(way.remarks), (way.id, told[way.id])
        assert all(map(str.startswith, told[way.id], way.remarks)), (way.id, told[way.id])
    nobodys = "Files that are not a submission were ignored. (README.txt, grades.xlsx)"
    assert [sentence(finding) for finding in plan.findings] == [nobodys]
    found = {found.person.id: found.person for found in plan.found}
    assert [person.id for person in found.values() if person.late] == ["4105"]
    assert found["tim"].handed_in and found["tom"].handed_in


def rows(out: Path) -> Iterator[dict[str, str]]:
    with (out / "results.csv").open(encoding="utf-8-sig", newline="") as file:
        yield from csv.DictReader(file)


@pytest.mark.slow
def test_everybody_gets_their_points_and_the_sheet_is_filled_in(
    folder: Path, tmp_path: Path, shared_builds: Store, capsys: pytest.CaptureFixture[str]
) -> None:
    if obstacle := obstacle_to(Level.CONTAINED):
        pytest.skip(f"not exercised here: a class is graded contained ({obstacle})")
    out, sheet = tmp_path / "out", tmp_path / "sheet.csv"
    words = ("--roster", str(sheet), "--exercises", EXERCISE, "--names", "lenient")
    Command(folder, out, tmp_path / "tmp", words, cache=shared_builds.root.parent).until_judged()
    found = list(rows(out))
    assert [(row["id"], float(row["total"])) for row in found] == [(way.id, way.points) for way in WAYS]
    assert {row["total max"] for row in found} == {"12"}
    assert main(["results", "fill", str(sheet), str(out)]) == 0
    assert f"Canvas, Week 3 (77): {len(WAYS)} filled in." in capsys.readouterr().out
    expected = sheet.read_bytes()
    for way in WAYS:
        expected = expected.replace(f",{way.id},,".encode(), f",{way.id},{way.points:g},".encode())
    assert (out / "filled-sheet.csv").read_bytes() == expected
    letters = {file.stem: file.read_text(encoding="utf-8") for file in (out / "feedback").iterdir()}
    assert letters.keys() == {way.id for way in WAYS}
    assert "`colcon build` ignores" in letters["noa"]
