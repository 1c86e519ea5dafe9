"""A build that is made from a similar package's build is what colcon would make."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from course.build import BuildFailure, BuildOutcome, Store, Workspace, build
from course.build.package_build import PackageBuild
from course.rosenv import Ros, node_environment
from tests.build.conftest import WORKSPACE
from tests.build.packages import edit

pytestmark = pytest.mark.slow

Built = Callable[..., BuildOutcome]
LAUNCH = (
    "        (os.path.join('share', package_name, 'launch'), glob('launch/*')),\n    ],\n    install_requires"
)


@pytest.fixture
def package(src: Path) -> Path:
    """With modules of one name and content, a launch file, and a test."""
    package = src / "small_node"
    edit(package / "setup.py", "    ],\n    install_requires", LAUNCH)
    edit(package / "setup.py", "data_files=[", "data_files=[('share/empty', []), ")
    edit(package / "setup.py", "from setuptools", "import os\nfrom glob import glob\nfrom setuptools")
    for name in ("small_node/inner/__init__.py", "launch/talker.py", "test/test_talker.py"):
        (package / name).parent.mkdir(exist_ok=True)
        (package / name).write_text("")
    shutil.copy(package / "small_node/talker.py", package / "small_node/inner/talker.py")
    return package


@pytest.fixture
def real(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Names of the packages that colcon was run for."""
    ran: list[str] = []
    run = PackageBuild._run

    def recorded(build: PackageBuild, like: str | None) -> BuildFailure | None:
        ran.append(build.package.name)
        return run(build, like)

    monkeypatch.setattr(PackageBuild, "_run", recorded)
    return ran


def tree(entry: Path) -> dict[str, object]:
    """All that is installed, with what colcon wrote of the entry's own place told as such."""
    found: dict[str, object] = {}
    for file in sorted((entry / "install").rglob("*")):
        name = file.relative_to(entry).as_posix()
        if "__pycache__" in name:  # Python creates what is missing there
            continue
        found[name] = file.stat().st_mode & 0o777
        if file.is_file():
            content = file.read_bytes().replace(bytes(entry), b"ENTRY")
            if name.endswith("SOURCES.txt"):  # in the order in which the disk lists files
                content = b"\n".join(sorted(content.split(b"\n")))
            found[name] = (content, found[name])
    return found


def same_as_colcon(home: Path, ros: Ros, outcome: BuildOutcome, elsewhere: Path) -> None:
    anew = build(Workspace.scan(home / WORKSPACE), ["small_node"], ros, Store(elsewhere))
    assert outcome.failure is None and anew.failure is None
    renewed, made = (entry_of(each) for each in (outcome, anew))
    assert tree(renewed) == tree(made)
    assert {file.name for file in renewed.iterdir()} == {file.name for file in made.iterdir()}


def entry_of(outcome: BuildOutcome) -> Path:
    return outcome.packages[-1].prefix.parents[1]


@pytest.mark.parametrize(
    "changed",
    [
        ("small_node/talker.py",),
        ("small_node/inner/talker.py",),
        ("small_node/__init__.py",),
        ("small_node/inner/__init__.py", "test/test_talker.py"),
        ("launch/talker.py",),
        ("small_node/talker.py", "small_node/inner/talker.py", "launch/talker.py"),
    ],
    ids=" ".join,
)
def test_the_same_as_colcon(
    built: Built,
    real: list[str],
    package: Path,
    home: Path,
    ros: Ros,
    tmp_path: Path,
    changed: tuple[str, ...],
) -> None:
    assert built("small_node").failure is None
    for name in changed:
        (package / name).write_text("print('changed')\nthis is no Python\n")
    outcome = built("small_node")
    assert real == ["small_node"]
    assert not outcome.packages[0].cached and outcome.packages[0].seconds > 0
    same_as_colcon(home, ros, outcome, tmp_path / "elsewhere")


def test_what_runs_is_the_new_one(built: Built, real: list[str], package: Path, ros: Ros) -> None:
    for number in range(3):
        (package / "small_node/talker.py").write_text(f"def main():\n    print('talk {number}')\n")
        outcome = built("small_node")
        done = subprocess.run(
            [outcome.prefixes[0] / "lib/small_node/small_talker"],
            # As in the arena, where no program writes into the store.
            env={**node_environment(ros, outcome.prefixes), "PYTHONDONTWRITEBYTECODE": "1"},
            capture_output=True, text=True, check=False,
        )  # fmt: skip
        assert (done.stdout, done.stderr) == (f"talk {number}\n", "")
    assert real == ["small_node"]
    assert built("small_node").packages[0].cached


@pytest.mark.parametrize(
    "change",
    [
        lambda package: edit(package / "package.xml", "<description>", "<description>Another "),
        lambda package: edit(package / "setup.py", 'version="0.1.0"', 'version="0.1.1"'),
        lambda package: (package / "small_node/third.py").write_text(""),
        lambda package: (package / "launch/talker.py").unlink(),
        lambda package: (package / "launch/talker.py").chmod(0o755),
        lambda package: (package / "launch/talker.py").rename(package / "launch/speaker.py"),
        lambda package: (package / "resource/more").write_text(""),
    ],
)
def test_any_other_change_is_built(
    built: Built, real: list[str], package: Path, change: Callable[[Path], object]
) -> None:
    assert built("small_node").failure is None
    change(package)
    assert built("small_node").failure is None
    assert real == ["small_node", "small_node"]


def test_a_setup_py_that_reads_a_module_is_built(built: Built, real: list[str], package: Path) -> None:
    edit(package / "setup.py", 'version="0.1.0"', "version=open('small_node/listener.py').read()[2:7]")
    for version in ("1.2.3", "4.5.6"):
        (package / "small_node/listener.py").write_text(f"# {version}\n")
        outcome = built("small_node")
        assert outcome.failure is None
        assert list(outcome.prefixes[0].rglob(f"small_node-{version}*"))
    assert len(real) == 2


def spoil_source(entry: Path) -> None:
    (entry / "src/small_node/talker.py").write_text("print('not what was built')\n")


def spoil_install(entry: Path) -> None:
    next((entry / "install").rglob("inner/talker.py")).write_text("print('not what was built')\n")


def spoil_both_but_for_the_marker(entry: Path) -> None:
    spoil_source(entry)
    spoil_install(entry)


def half_made(entry: Path) -> None:
    (entry / "complete").unlink()


def rubbish(entry: Path) -> None:
    for file in entry.parent.glob("*.like"):
        file.write_text("../" * 8)


@pytest.mark.parametrize(
    "spoil",
    [spoil_source, spoil_install, spoil_both_but_for_the_marker, half_made, rubbish, shutil.rmtree],
)
def test_an_earlier_one_that_is_not_what_was_built(
    built: Built, real: list[str], package: Path, home: Path, ros: Ros, tmp_path: Path,
    spoil: Callable[[Path], None],
) -> None:  # fmt: skip
    spoil(entry_of(built("small_node")))
    (package / "small_node/talker.py").write_text("print('mine')\n")
    outcome = built("small_node")
    assert len(real) == 2
    same_as_colcon(home, ros, outcome, tmp_path / "elsewhere")


def test_a_copy_that_fails_is_built(
    built: Built, real: list[str], package: Path, home: Path, ros: Ros, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    assert built("small_node").failure is None
    (package / "small_node/talker.py").write_text("print('mine')\n")
    write = Path.write_bytes

    def full(file: Path, data: bytes) -> int:
        if file.name == "talker.py":
            raise OSError(28, "No space left on device")
        return write(file, data)

    with monkeypatch.context() as patched:
        patched.setattr(Path, "write_bytes", full)
        outcome = built("small_node")
    assert len(real) == 2
    same_as_colcon(home, ros, outcome, tmp_path / "elsewhere")


def test_another_ros_is_another_build(
    built: Built, package: Path, store: Store, home: Path, ros: Ros
) -> None:
    """Packages are similar only if they were built with the same ROS and the same packages below."""
    assert built("small_node").failure is None
    assert len(list(store.root.glob("*.like"))) == 1
    edit(package / "package.xml", "<depend>", "<depend>small_interfaces</depend><depend>")
    (package / "small_node/talker.py").write_text("print('mine')\n")
    assert built("small_node").failure is None
    assert len(list(store.root.glob("*.like"))) == 2


def test_pruning_forgets_what_is_gone(built: Built, store: Store, package: Path) -> None:
    entry = entry_of(built("small_node"))
    store.prune()
    assert len(list(store.root.glob("*.like"))) == 1
    os.utime(entry / "complete", (1, 1))
    noted = json.loads((entry / "complete").read_text())["bytes"]
    Store(store.root, keep_bytes=noted - 1).prune()
    assert not entry.exists()
    assert not list(store.root.glob("*.like"))
