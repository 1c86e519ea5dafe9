"""./run-tests and .ci/run: what they call, in which order, and what they do about missing system packages."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from course.content import open_course
from course.validate.proofs import ProofKind
from course.validate.proofs import proofs as proofs_of
from tests.launcher.machine import GUARD, REPO, Machine

PACKAGES = {"git": "git", "g++": "g++", "cmake": "cmake", "make": "make", "bwrap": "bubblewrap", "zsh": "zsh"}
PACKAGES |= {"chromium": "chromium"}
PYTEST = "python -m pytest -n 4 --dist worksteal --durations 30"


@pytest.fixture
def checks(machine: Machine) -> Machine:
    """Everything is installed, and every program only notes that it was called."""
    for script in ("run-tests", ".ci/run"):
        (machine.clone / script).parent.mkdir(exist_ok=True)
        shutil.copy2(REPO / script, machine.clone / script)
    for name in ("dirname", "bash"):
        (machine.bin / name).symlink_to(shutil.which(name) or pytest.fail(f"no {name} here"))
    machine.script("id", "echo 1000")
    for name in (*PACKAGES, "python3", "apt-get"):
        machine.script(name, notes(name if name == "apt-get" else ""))
    in_venv = Path(os.path.relpath(machine.clone / ".venv/bin", machine.bin))
    (machine.clone / ".venv/bin").mkdir(parents=True)
    for name in ("ruff", "mypy", "codespell", "shellcheck", "python"):
        machine.script(str(in_venv / name), notes(name))
    machine.script(os.path.relpath(machine.clone / "ros2course", machine.bin), notes("ros2course"))
    return machine


def test_it_sets_up_then_lints_then_tests(checks: Machine) -> None:
    assert run(checks, "run-tests", "-m", "not slow").returncode == 0
    assert checks.calls() == [
        "ros2course --setup-only test",
        "ruff check .",
        "mypy ",
        "codespell ./*.md bench chapters course docs extras graders solutions underlay",
        "codespell --builtin en-GB_to_en-US tests",
        "shellcheck ros2course run-tests .ci/run course/report/gradebook/scripts/*",  # none in this copy
        f"{PYTEST} -m not slow",
    ]


def test_without_arguments_there_are_some_proofs_and_the_quick_tests(checks: Machine) -> None:
    assert run(checks, "run-tests").returncode == 0
    proofs, tests = checks.calls()[-2:]
    assert tests == f"{PYTEST} -m not slow"
    command, *wanted = proofs.removeprefix("ros2course ").split()
    exercises = [open_course(REPO).exercise(name) for name in wanted]
    assert command == "validate"
    assert {proof.kind for proof in proofs_of(exercises)} == set(ProofKind)


def test_all_is_every_proof_and_every_test(checks: Machine) -> None:
    assert run(checks, "run-tests", "--all").returncode == 0
    assert checks.calls()[-2:] == ["ros2course validate", PYTEST]


@pytest.mark.parametrize("args", [[], ["--all"]])
def test_what_is_not_proven_fails_it_after_the_tests(checks: Machine, args: list[str]) -> None:
    launcher = os.path.relpath(checks.clone / "ros2course", checks.bin)
    checks.script(launcher, notes("ros2course") + '\n[ "$1" != validate ] || exit 1')
    assert run(checks, "run-tests", *args).returncode == 1
    assert checks.calls()[-1].startswith(PYTEST)


def test_ci_calls_all_of_it_without_a_terminal(checks: Machine) -> None:
    checks.script(os.path.relpath(checks.clone / ".venv/bin/python", checks.bin), "read -r line || exit 7")
    assert run(checks, ".ci/run").returncode == 7  # pytest's exit code, and an empty standard input
    assert checks.calls()[0] == "ros2course --setup-only test"
    assert checks.calls()[-1] == "ros2course validate"


@pytest.mark.parametrize("fails", ["ros2course", ".venv/bin/ruff", ".venv/bin/mypy", ".venv/bin/python"])
def test_whatever_fails_fails_it(checks: Machine, fails: str) -> None:
    checks.script(os.path.relpath(checks.clone / fails, checks.bin), "exit 3")
    assert run(checks, "run-tests").returncode == 3


@pytest.mark.parametrize("command", PACKAGES)
def test_root_gets_what_is_missing(checks: Machine, command: str) -> None:
    checks.script("id", "echo 0")
    (checks.bin / command).unlink()
    assert run(checks, "run-tests").returncode == 0
    installs = [call for call in checks.calls("apt-get") if " install " in call]
    assert installs == [f"apt-get install -y -qq --no-install-recommends {PACKAGES[command]}"]


@pytest.mark.parametrize("apt", [True, False])
def test_others_are_told_what_is_missing(checks: Machine, apt: bool) -> None:
    (checks.bin / "bwrap").unlink()
    checks.script("python3", "case $2 in *Python.h*) exit 1 ;; esac")
    if not apt:
        checks.script("id", "echo 0")
        (checks.bin / "apt-get").unlink()
    result = run(checks, "run-tests")
    assert result.returncode == 4
    assert "sudo apt-get install bubblewrap python3-dev" in result.stderr
    assert checks.calls() == []


def notes(name: str) -> str:
    return f'echo "{name} $*" >>"$FAKE/calls"' if name else ":"


def run(machine: Machine, script: str, *args: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [machine.clone / script, *args], cwd="/", env=machine.environment({}), text=True, timeout=GUARD,
        input="typed ahead\n", capture_output=True, check=False,
    )  # fmt: skip
