"""The file of results: each grading is complete or missing, and belongs to the current submission."""

from __future__ import annotations

import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from course.batch.gradings import Unit
from course.batch.intake.packed import claim_of, differences
from course.batch.intake.submission import PackManifest
from course.batch.results import FILE, SCHEMA_VERSION, Results, keep_packed, packed_of
from course.errors import StorageError, UsageError
from course.model import replace
from course.model.result import Verdict
from tests.batch.samples import FAILED, OURS, PASSED, SHINES, graded, submissions

REPO = Path(__file__).parents[2]


@pytest.fixture
def results(tmp_path: Path) -> Iterator[Results]:
    with Results.open(tmp_path) as opened:
        opened.enter(submissions("ada", "bao"))
        yield opened


def changed(folder: Path, statement: str) -> None:
    database = sqlite3.connect(folder / FILE)
    database.execute(statement)
    database.commit()
    database.close()


def test_what_was_recorded_is_there_when_opened_again(results: Results, tmp_path: Path) -> None:
    results.record(graded("ada", FAILED), "1.0", "evidence/ada.mcap")
    with Results.open(tmp_path) as again:
        (stored,) = again.gradings("ada")
        assert (stored.unit, stored.result) == (Unit("ada", "04-light"), FAILED)
        assert stored.evidence == "evidence/ada.mcap"
        assert again.submissions() == submissions("ada", "bao")
        assert again.verdicts() == {"not passed": 1}
        assert again.containments() == ("contained",)


def test_each_check_has_a_row(results: Results, tmp_path: Path) -> None:
    results.record(graded("ada", FAILED), "1.0", None)
    database = sqlite3.connect(tmp_path / FILE)
    columns = "person, check_id, outcome, earned, points, summary"
    rows = database.execute(f"SELECT {columns} FROM checks").fetchall()
    database.close()
    assert rows == [("ada", "shines", "failed", 0.0, 2.0, "It is dark.")]


def test_our_errors_are_not_done(results: Results) -> None:
    results.record(graded("ada"), "1.0", None)
    results.record(graded("bao", OURS), "1.0", None)
    assert results.done() == {("ada", "04-light")}


def test_graded_again_counts_once(results: Results) -> None:
    results.record(graded("ada", FAILED), "1.0", None)
    results.record(graded("ada", PASSED, attempt=2), "1.0", None)
    (stored,) = results.gradings("ada")
    assert (stored.result.verdict, stored.unit.attempt) == (Verdict.PASSED, 2)


def test_a_grading_is_there_as_a_whole_or_not_at_all(results: Results) -> None:
    """Two checks with one id cannot be kept, so the first one, and the grading, must not stay either."""
    results.record(graded("ada", PASSED), "1.0", None)
    with pytest.raises(StorageError):
        results.record(graded("ada", replace(FAILED, checks=(SHINES, SHINES))), "1.0", None)
    assert [stored.result for stored in results.gradings("ada")] == [PASSED]
    results.record(graded("bao"), "1.0", None)  # and it goes on


def test_what_has_changed_or_gone_is_graded_anew(results: Results) -> None:
    for person in ("ada", "bao"):
        results.record(graded(person), "1.0", None)
    results.enter([*submissions("ada", digest="d2"), *submissions("cleo")])
    assert results.done() == set()
    assert [one.person for one in results.submissions()] == ["ada", "cleo"]
    assert results.gradings("bao") == []


def test_what_is_as_it_was_stays(results: Results) -> None:
    results.record(graded("ada"), "1.0", None)
    results.enter([*submissions("bao"), *submissions("ada")])
    assert results.done() == {("ada", "04-light")}
    assert [one.person for one in results.submissions()] == ["bao", "ada"]


def test_notes_are_kept(results: Results) -> None:
    assert results.noted("began") is None
    results.note("began", "1")
    results.note("began", "2")
    assert results.noted("began") == "2"


def test_a_folder_without_results_is_none(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="no results"):
        Results.open(tmp_path / "nothing", create=False)
    assert not (tmp_path / "nothing").exists()


def test_a_file_that_is_not_ours_is_left_alone(tmp_path: Path) -> None:
    changed(tmp_path, "CREATE TABLE recipes (name TEXT)")
    changed(tmp_path, "PRAGMA application_id = 7")
    with pytest.raises(UsageError, match="not a file of ros2course"):
        Results.open(tmp_path)


def test_a_database_without_a_mark_that_holds_something_is_left_alone(tmp_path: Path) -> None:
    changed(tmp_path, "CREATE TABLE recipes (name TEXT)")
    with pytest.raises(UsageError, match="not a file of ros2course"):
        Results.open(tmp_path)


def test_a_newer_file_is_left_alone(results: Results, tmp_path: Path) -> None:
    changed(tmp_path, f"PRAGMA user_version = {SCHEMA_VERSION + 1}")
    with pytest.raises(UsageError, match="newer"):
        Results.open(tmp_path)


def test_a_damaged_file_is_told(tmp_path: Path) -> None:
    (tmp_path / FILE).write_bytes(b"no database at all" * 1000)
    with pytest.raises(StorageError, match="damaged"):
        Results.open(tmp_path)


def test_names_of_tables_that_are_no_text_are_told(tmp_path: Path) -> None:
    """SQLite's message quotes them, and Python cannot decode that."""
    with Results.open(tmp_path):
        pass
    content = (tmp_path / FILE).read_bytes()
    assert b"TABLE submissions" in content
    (tmp_path / FILE).write_bytes(content.replace(b"TABLE submissions", b"TABL\xf5 submissions"))
    with pytest.raises(StorageError, match="damaged"):
        Results.open(tmp_path)


def test_a_folder_that_cannot_be_made_is_told(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    with pytest.raises(StorageError, match="cannot be saved"):
        Results.open(tmp_path / "file" / "out")


_UNTIL_FULL = """
import resource, signal, sys
from pathlib import Path
from typing import Any
from course.batch.results import Results
from course.errors import StorageError
from tests.batch.samples import FAILED, graded, submissions
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
people = [f"p{n}" for n in range(2000)]
with Results.open(Path(sys.argv[1])) as results:
    results.enter(submissions(*people))
    resource.setrlimit(resource.RLIMIT_FSIZE, (600_000, 600_000))
    for n, person in enumerate(people):
        try:
            results.record(graded(person, FAILED), "1.0", None)
        except StorageError as error:
            print(n, error.next_step)
            break
"""


def test_a_full_disk_loses_nothing_that_was_recorded(tmp_path: Path) -> None:
    command = [sys.executable, "-c", _UNTIL_FULL, str(tmp_path)]
    done = subprocess.run(command, cwd=REPO, capture_output=True, text=True, timeout=60, check=True)
    count, advice = done.stdout.split(" ", 1)
    assert advice.strip() == "Free some space, then run the command again."
    with Results.open(tmp_path) as results:
        assert len(results.done()) == int(count) > 0


_UNTIL_KILLED = """
import sys
from itertools import count
from pathlib import Path
from typing import Any
from course.batch.results import Results
from tests.batch.samples import FAILED, graded, submissions
with Results.open(Path(sys.argv[1])) as results:
    results.enter(submissions(*(f"p{n}" for n in range(20))))
    for n in count():
        results.record(graded(f"p{n % 20}", FAILED), "1.0", None)
        print(n, flush=True)
"""


def test_killed_in_the_middle_nothing_is_half_written(tmp_path: Path) -> None:
    command = [sys.executable, "-c", _UNTIL_KILLED, str(tmp_path)]
    with subprocess.Popen(command, cwd=REPO, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout
        said = [process.stdout.readline() for _ in range(40)]
        process.kill()
    assert said[-1].strip() == "39"
    with Results.open(tmp_path) as results:
        assert len(results.done()) == 20
        assert all(len(stored.result.checks) == 1 for n in range(20) for stored in results.gradings(f"p{n}"))
    database = sqlite3.connect(tmp_path / FILE)
    assert database.execute("SELECT COUNT(*) FROM checks").fetchone() == (20,)
    assert database.execute("PRAGMA integrity_check").fetchone() == ("ok",)
    database.close()


def manifest(**changed: Any) -> PackManifest:
    return replace(PackManifest(1, "2026-01-01", {"python": "3.12"}, (claim_of(PASSED),), {}), **changed)


@pytest.mark.parametrize("name", ["a", "\ud800"])
def test_what_one_zip_claims_harms_no_other(results: Results, name: str) -> None:
    infinite = replace(claim_of(PASSED), exercise=name, points=float("inf"))
    keep_packed(results, {"ada": manifest(), "bao": manifest(claims=(infinite,))})
    assert packed_of(results)["ada"] == manifest()


def test_who_is_held_back_keeps_what_was_packed(results: Results) -> None:
    keep_packed(results, {"ada": manifest(), "bao": manifest(), "cem": manifest()})
    keep_packed(results, {"ada": manifest(at="later")}, held=["bao"])
    assert packed_of(results) == {"ada": manifest(at="later"), "bao": manifest()}


def test_a_difference_tells_three_versions_and_only_of_what_was_judged() -> None:
    many = manifest(versions={"python": "3.12", **{f"x{number}": "1" for number in range(5000)}})
    (said,) = differences(many, [FAILED])
    assert "(python 3.12)" in said and "Different: " in said
    for verdict in ("our error", "not available here", "no verdict"):
        claims = (replace(claim_of(PASSED), verdict=verdict),)
        assert list(differences(manifest(claims=claims), [FAILED])) == []
