"""The Gradescope bundle: complete, and its scripts do what they say. Commands are stood in for."""

from __future__ import annotations

import io
import os
import subprocess
import zipfile
from collections.abc import Mapping
from pathlib import Path

import pytest

from course.errors import UsageError
from course.report.gradebook import gradescope

WHEEL = "ros2course-0.1.0-py3-none-any.whl"
RECORDER = '#!/bin/sh\nprintf "%s\\n" "$(basename "$0")" "$@" >>"$CALLS"\n'
PYTHON = RECORDER + 'case "$*" in\n"-m venv "*) for last; do :; done; mkdir -p "$last/bin"\n'
PYTHON += 'cp "$0" "$last/bin/python"; printf "%s" "$COURSE" >"$last/bin/ros2course"\n'
PYTHON += 'chmod +x "$last/bin/ros2course";; esac\n'
COURSE = RECORDER + '[ -z "$RESULT" ] || printf "%s" "$RESULT" >"$AUTOGRADER_ROOT/results/results.json"\n'
COURSE += 'exit "${STATUS:-0}"\n'


def small_wheel() -> bytes:
    target = io.BytesIO()
    with zipfile.ZipFile(target, "w") as archive:
        archive.writestr("course/__init__.py", "")
    return target.getvalue()


def unpack(root: Path, packed: tuple[gradescope.Packed, ...]) -> None:
    """As Gradescope does it."""
    for file in packed:
        target = root / "source" / file.path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(file.content)
        target.chmod(0o755 if file.executable else 0o644)
    (root / "submission").mkdir()
    commands = root / "bin"
    commands.mkdir()
    for name, text in (("apt-get", RECORDER), ("python3", PYTHON)):
        (commands / name).write_text(text)
        (commands / name).chmod(0o755)


def run(root: Path, script: str, **more: str) -> tuple[int, list[str]]:
    """Its exit code, and the words of every command that it called."""
    calls = root / "calls"
    environment = {
        "PATH": f"{root / 'bin'}:{os.environ['PATH']}",
        "AUTOGRADER_ROOT": str(root),
        "CALLS": str(calls),
        "COURSE": COURSE,
        "RESULT": "",
    }
    done = subprocess.run(
        [root / "source" / script], cwd=root, env={**environment, **more}, check=False, timeout=60
    )
    words = calls.read_text().splitlines() if calls.exists() else []
    calls.unlink(missing_ok=True)
    return done.returncode, words


@pytest.fixture
def root(tmp_path: Path) -> Path:
    unpack(tmp_path, gradescope.bundle(WHEEL, small_wheel(), ["18-publisher", "20"]))
    assert run(tmp_path, "setup.sh")[0] == 0
    return tmp_path


def test_the_zip_holds_all_with_modes_and_is_the_same_each_time() -> None:
    packed = gradescope.bundle(WHEEL, small_wheel(), ["18"], {"chapters/18-x/lesson.yaml": b"chapter: 18"})
    archive = zipfile.ZipFile(io.BytesIO(gradescope.zipped(packed)))
    modes = {entry.filename: oct(entry.external_attr >> 16) for entry in archive.infolist()}
    assert modes == {
        "setup.sh": "0o100755",
        "run_autograder": "0o100755",
        WHEEL: "0o100644",
        "exercises.txt": "0o100644",
        "course/chapters/18-x/lesson.yaml": "0o100644",
    }
    assert archive.read(WHEEL) == small_wheel() and archive.read("exercises.txt") == b"18"
    assert archive.read("setup.sh").startswith(b"#!/usr/bin/env bash\n")
    assert gradescope.zipped(packed) == gradescope.zipped(packed)


@pytest.mark.parametrize(
    ("name", "content"),
    [("other-1.0-py3-none-any.whl", small_wheel()), (WHEEL, b"no zip"), (f"../{WHEEL}", small_wheel())],
)
def test_only_our_own_wheel_will_do(name: str, content: bytes) -> None:
    with pytest.raises(UsageError) as caught:
        gradescope.bundle(name, content, [])
    assert "pip wheel" in str(caught.value.next_step)


def test_the_setup_installs_packages_then_the_wheel_then_looks(tmp_path: Path) -> None:
    unpack(tmp_path, gradescope.bundle(WHEEL, small_wheel(), []))
    code, words = run(tmp_path, "setup.sh")
    assert code == 0
    assert words[:2] == ["apt-get", "update"] and "bubblewrap" in words and "python3-venv" in words
    assert words.index("venv") > words.index("bubblewrap")
    extra = "" if Path("/opt/ros/jazzy/setup.bash").exists() else "[jazzy]"
    assert words.index(f"{tmp_path}/source/{WHEEL}{extra}") > words.index("venv")
    assert words[-2:] == ["ros2course", "doctor"]


def test_the_setup_fails_with_what_fails(tmp_path: Path) -> None:
    unpack(tmp_path, gradescope.bundle(WHEEL, small_wheel(), []))
    assert run(tmp_path, "setup.sh", COURSE="#!/bin/sh\nexit 4\n")[0] == 4
    (tmp_path / "source" / WHEEL).unlink()
    assert run(tmp_path, "setup.sh")[0] == 4
    (tmp_path / "bin/apt-get").write_text("#!/bin/sh\nexit 100\n")
    assert run(tmp_path, "setup.sh")[0] == 100


def test_a_submission_is_graded_into_results(root: Path) -> None:
    code, words = run(root, "run_autograder", RESULT="{}")
    assert code == 0
    assert words == [
        *("ros2course", "grade", f"{root}/submission", "--single"),
        *("--gradescope", f"{root}/results/results.json", "--exercises", "18-publisher,20"),
    ]


def test_not_passed_is_no_failure_of_the_autograder(root: Path) -> None:
    assert run(root, "run_autograder", RESULT="{}", STATUS="1")[0] == 0


@pytest.mark.parametrize(("status", "code"), [("3", 3), ("0", 3), ("4", 4)])
def test_without_results_it_fails_and_leaves_no_old_ones(root: Path, status: str, code: int) -> None:
    (root / "results").mkdir()
    (root / "results/results.json").write_text("old")
    assert run(root, "run_autograder", STATUS=status)[0] == code
    assert not (root / "results/results.json").exists()


def test_all_exercises_and_another_course(tmp_path: Path) -> None:
    other: Mapping[str, bytes] = {"chapters/01-x/lesson.yaml": b""}
    unpack(tmp_path, gradescope.bundle(WHEEL, small_wheel(), [], other))
    run(tmp_path, "setup.sh")
    _, words = run(tmp_path, "run_autograder", RESULT="{}")
    assert words[:4] == ["ros2course", "--course", f"{tmp_path}/source/course", "grade"]
    assert "--exercises" not in words


def test_the_scripts_are_clean() -> None:
    scripts = Path(gradescope.__file__).parent / "scripts"
    for script in ("setup.sh", "run_autograder"):
        subprocess.run(["bash", "-n", scripts / script], check=True)
