"""The strongest containment that the machine offers, and what the grading process can do in it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from course.arena import containment as module
from course.arena.containment import PROGRAMS, SCRATCH, Places, containment, sandbox_obstacle
from course.arena.sandbox.limits import Limits

needs_containment = pytest.mark.skipif(
    sandbox_obstacle() is not None,
    reason=f"not exercised: the grading process reads and does not write ({sandbox_obstacle()})",
)


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS2COURSE_CACHE", str(tmp_path / "cache"))


REPO = Path(__file__).parents[2]
# Wherever this is run: also in a folder of /tmp, which is private inside.
OURS = (REPO, Path(sys.prefix), Path(sys.base_prefix))


def inside(places: Places, code: str) -> list[str]:
    with containment(Places((*OURS, *places.read), places.write)) as place:
        assert place.around.kind == "contained"
        command = [*place.around.prefix, sys.executable, "-S", "-c", f"import os\n{code}"]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


TRY = """
def attempt(path):
    try:
        open(path, 'w').write('x')
        return 'written'
    except OSError as error:
        return type(error).__name__
"""


@needs_containment
def test_only_what_is_named_can_be_written(tmp_path: Path) -> None:
    read, write = tmp_path / "read", tmp_path / "write"
    for folder in (read, write):
        folder.mkdir()
    code = f"{TRY}\nfor path in ('{read}/x', '{write}/x', '{Path(__file__).parent}/x'): print(attempt(path))"
    assert inside(Places((read,), (write,)), code) == ["OSError", "written", "OSError"]
    assert (write / "x").read_text() == "x"


@needs_containment
def test_tmp_is_its_own_but_for_what_is_named(tmp_path: Path) -> None:
    named, other = tmp_path / "named", tmp_path / "other"
    for folder in (named, other):
        folder.mkdir()
    code = f"print(os.path.exists('{named}'), os.path.exists('{other}'))"
    if not tmp_path.is_relative_to("/tmp"):
        pytest.skip("not exercised: a private /tmp (the tests' folder is elsewhere)")
    assert inside(Places((named,)), code) == ["True False"]


@needs_containment
def test_the_scratch_of_programs_is_a_file_system_of_its_own_size() -> None:
    code = (
        f"s = os.statvfs('{SCRATCH / PROGRAMS}')\nprint(s.f_blocks * s.f_frsize)\n"
        f"print(os.stat('{SCRATCH}').st_dev != os.stat('{SCRATCH / PROGRAMS}').st_dev)"
    )
    assert inside(Places(), code) == [str(Limits().scratch), "True"]


@needs_containment
def test_whose_programs_they_are_is_known_to_nobody_else() -> None:
    with containment(Places()) as one, containment(Places()) as other:
        assert one.who is not None and other.who is not None
        assert one.who.user is None or one.who.user != other.who.user
        assert not set(one.who.control_groups) & set(other.who.control_groups)


def test_without_namespaces_there_is_a_domain_and_no_plan() -> None:
    with containment(Places(), namespaces=False) as place:
        assert place.around.kind == "domain"
        assert place.around.missing is None
        assert place.plan((), ()) is None


def test_what_is_missing_is_said_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "sandbox_obstacle", lambda: "no second layer here")
    with containment(Places()) as place:
        assert place.around.kind in ("namespaces", "domain")
        assert place.around.missing
        assert place.plan((), ()) is None


def test_no_bubblewrap_is_the_reason(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert "bubblewrap is not installed" in (sandbox_obstacle() or "")
