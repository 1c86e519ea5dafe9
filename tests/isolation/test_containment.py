"""The strongest containment that the machine offers, and what the grading process can do in it."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from course.isolation import Level
from course.isolation import levels as module
from course.isolation.levels import MachinePlaces, isolated, obstacle_to
from course.isolation.view import View

needs_containment = pytest.mark.skipif(
    obstacle_to(Level.CONTAINED) is not None,
    reason=f"not exercised: the grading process reads and does not write ({obstacle_to(Level.CONTAINED)})",
)


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS2COURSE_CACHE", str(tmp_path / "cache"))


REPO = Path(__file__).parents[2]
# Wherever this is run: also in a folder of /tmp, which is private inside.
OURS = (REPO, Path(sys.prefix), Path(sys.base_prefix))


def inside(places: MachinePlaces, code: str) -> list[str]:
    with isolated(MachinePlaces((*OURS, *places.read), places.write)) as place:
        assert place.level == "contained"
        command = [*place.prefix, sys.executable, "-S", "-c", f"import os\n{code}"]
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
    assert inside(MachinePlaces((read,), (write,)), code) == ["OSError", "written", "OSError"]
    assert (write / "x").read_text() == "x"


@needs_containment
def test_tmp_is_its_own_but_for_what_is_named(tmp_path: Path) -> None:
    named, other = tmp_path / "named", tmp_path / "other"
    for folder in (named, other):
        folder.mkdir()
    code = f"print(os.path.exists('{named}'), os.path.exists('{other}'))"
    if not tmp_path.is_relative_to("/tmp"):
        pytest.skip("not exercised: a private /tmp (the tests' folder is elsewhere)")
    assert inside(MachinePlaces((named,)), code) == ["True False"]


@needs_containment
def test_whose_programs_they_are_is_known_to_nobody_else() -> None:
    with isolated(MachinePlaces()) as one, isolated(MachinePlaces()) as other:
        assert one.identity is not None and other.identity is not None
        assert one.identity.user is None or one.identity.user != other.identity.user
        assert not set(one.identity.control_groups) & set(other.identity.control_groups)


def test_without_namespaces_there_is_a_domain_and_no_plan() -> None:
    with isolated(MachinePlaces(), namespaces=False) as place:
        assert place.level == "domain"
        assert place.missing is None
        assert place.sandbox(View()) is None


def test_what_is_missing_is_said_once(monkeypatch: pytest.MonkeyPatch) -> None:
    kept = module.obstacle_to
    lacking = {Level.CONTAINED: "no second layer here"}
    monkeypatch.setattr(module, "obstacle_to", lambda level: lacking.get(level) or kept(level))
    with isolated(MachinePlaces()) as place:
        assert place.level in ("namespaces", "domain")
        assert place.missing
        assert place.sandbox(View()) is None


def test_no_bubblewrap_is_the_reason(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    assert "bubblewrap is not installed" in (obstacle_to(Level.CONTAINED) or "")
