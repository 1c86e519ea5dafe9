"""What is built, what is taken from the store, and what happens when things go wrong. colcon is replaced."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable
from contextlib import AbstractContextManager
from pathlib import Path

import pytest

from course.build import BuildOutcome, Interrupted, Store, Workspace, build, builder, package_build
from course.build import package_sources as sources
from course.build.colcon import Machine
from course.errors import MissingHere, StorageError, UsageError
from course.explain.package_xml import ManifestFault
from course.rosenv import Ros
from tests.build.conftest import WORKSPACE, called_off
from tests.build.packages import edit, make_package
from tests.processes import none_stays

Built = Callable[..., BuildOutcome]
Runs = Callable[[], list[str]]


def test_an_unchanged_package_is_built_once(built: Built, runs: Runs, src: Path) -> None:
    first, second = built("small_node"), built("small_node")
    assert runs() == ["small_node"]
    assert first.prefixes == second.prefixes
    assert not first.packages[0].cached
    assert second.packages[0].cached
    assert first.packages[0].source == "ros2_tutorial_workspace/src/small_node"
    assert (first.prefixes[0] / "share/ament_index/resource_index/packages/small_node").exists()


def test_a_change_builds_it_and_what_depends_on_it(built: Built, runs: Runs, src: Path) -> None:
    for name, needed in (("bottom", []), ("top", ["bottom"]), ("aside", [])):
        make_package(src, name, *needed)
    built("top", "aside")
    assert sorted(runs()) == ["aside", "bottom", "top"]
    (src / "bottom/new.txt").touch()
    outcome = built("top", "aside")
    assert runs()[3:] == ["bottom", "top"]
    assert [package.name for package in outcome.packages] == ["bottom", "top", "aside"]
    assert [package.cached for package in outcome.packages] == [False, False, True]


def test_an_earlier_content_is_still_there(built: Built, runs: Runs, src: Path) -> None:
    built("small_node")
    edit(src / "small_node/setup.py", "0.1.0", "0.2.0")
    built("small_node")
    edit(src / "small_node/setup.py", "0.2.0", "0.1.0")
    assert built("small_node").packages[0].cached
    assert len(runs()) == 2


def test_only_cpp_that_python_does_not_load_gets_a_sanitizer(built: Built, runs: Runs, src: Path) -> None:
    edit(make_package(src, "arm") / "package.xml", "ament_python", "ament_cmake")
    names = ("small_node", "small_interfaces", "arm")
    built(*names)
    sanitized = built(*names, sanitized=True)
    assert [package.cached for package in sanitized.packages] == [True, True, False]
    assert runs() == [*runs()[:3], "arm"]
    assert built(*names).prefixes[2] != sanitized.prefixes[2]


def test_only_declared_dependencies_are_offered(built: Built, runs: Runs, src: Path, tmp_path: Path) -> None:
    for name, needed in (("base", []), ("middle", ["base"]), ("user", ["middle"]), ("stranger", [])):
        make_package(src, name, *needed)
        (src / name / "quick.py").write_text(
            "import os\n"
            f"pathlib.Path({str(tmp_path)!r}, name + '.seen').write_text(os.environ['AMENT_PREFIX_PATH'])\n"
        )
    outcome = built("stranger", "user")
    prefixes = {package.name: str(package.prefix) for package in outcome.packages}
    seen = (tmp_path / "user.seen").read_text().split(":")
    assert seen[:2] == [prefixes["middle"], prefixes["base"]]
    assert prefixes["stranger"] not in seen


def test_sources_are_left_alone(built: Built, runs: Runs, home: Path) -> None:
    before = {path: path.stat().st_mtime_ns for path in home.rglob("*")}
    built("small_node")
    assert {path: path.stat().st_mtime_ns for path in home.rglob("*")} == before


def test_the_users_settings_do_not_count(
    built: Built, runs: Runs, src: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CXXFLAGS", "-Wrong")
    monkeypatch.setenv("PYTHONPATH", "/nowhere")
    monkeypatch.setenv("LANG", "de_DE.UTF-8")
    code = f"import os\npathlib.Path({str(tmp_path)!r}, 'seen').write_text(repr(dict(os.environ)))\n"
    (src / "small_node/quick.py").write_text(code)
    built("small_node")
    seen = (tmp_path / "seen").read_text()
    assert "-Wrong" not in seen
    assert "/nowhere" not in seen
    assert "de_DE" not in seen
    assert os.environ["HOME"] not in seen


def test_a_failure_stops_what_depends_on_it(built: Built, runs: Runs, src: Path) -> None:
    make_package(src, "broken")
    (src / "broken/quick.py").write_text("sys.exit('it broke: no such thing')")
    (src / "broken/setup.py").write_text("from setuptools import setup\nsetup(name='broken')\n")
    make_package(src, "top", "broken")
    outcome = built("small_node", "top")
    assert outcome.failure is not None
    assert outcome.failure.package == "broken"
    assert outcome.failure.log is not None
    assert "it broke" in outcome.failure.log.read_text()
    assert "it broke: no such thing" in outcome.failure.feedback.details
    assert [package.name for package in outcome.packages] == ["small_node"]
    assert "top" not in runs()


@pytest.mark.slow
def test_a_failure_is_tried_again(built: Built, runs: Runs, src: Path) -> None:
    (src / "small_node/quick.py").write_text("sys.exit(1)")
    assert built("small_node").failure
    assert built("small_node").failure
    assert runs() == ["small_node", "small_node"]


def test_without_a_marker_nothing_is_found(built: Built, runs: Runs, src: Path) -> None:
    (src / "small_node/quick.py").write_text("sys.exit(0)")
    failure = built("small_node").failure
    assert failure is not None
    assert failure.kind == "not-installed"


def test_two_packages_are_built_side_by_side(built: Built, runs: Runs, src: Path, tmp_path: Path) -> None:
    for name, other in (("one", "two"), ("two", "one")):
        make_package(src, name)
        (src / name / "quick.py").write_text(
            f"import time\npathlib.Path({str(tmp_path)!r}, name).touch()\n"
            f"while not pathlib.Path({str(tmp_path)!r}, {other!r}).exists(): time.sleep(0.01)\n"
        )
    assert len(built("one", "two", time_limit=20).packages) == 2


@pytest.mark.slow
def test_two_checks_at_once_build_once(built: Built, runs: Runs, src: Path, store: Store) -> None:
    waits = store.root.with_name("the other waits")
    (src / "small_node/quick.py").write_text(
        f"import time\nwhile not pathlib.Path({str(waits)!r}).exists(): time.sleep(0.01)\n"
    )
    said: list[str] = []
    outcomes: list[BuildOutcome] = []

    def say(text: str) -> None:
        said.append(text)
        if text.startswith("Waiting"):
            waits.touch()

    def check() -> None:
        outcomes.append(built("small_node", on_progress=say))

    threads = [threading.Thread(target=check) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join(30)
    assert runs() == ["small_node"]
    assert sorted(outcome.packages[0].cached for outcome in outcomes) == [False, True]
    assert sorted(said) == ["Building small_node", "Waiting for small_node, which is already being built"]


@pytest.mark.slow
def test_too_long_says_so(built: Built, runs: Runs, src: Path) -> None:
    (src / "small_node/quick.py").write_text("print('one', flush=True)\nimport time; time.sleep(300)")
    failure = built("small_node", time_limit=5.0).failure
    assert failure is not None
    assert failure.kind == "time-limit"
    assert "longer than 5 seconds" in failure.feedback.summary
    assert failure.feedback.details == ("one",)
    assert [str(place) for place in failure.feedback.where] == [
        "ros2_tutorial_workspace/src/small_node/setup.py"
    ]


def test_printing_without_end_says_so(
    built: Built, runs: Runs, src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("course.build.runner.MOST_OUTPUT", 100_000)
    (src / "small_node/quick.py").write_text("while True: print('y' * 1000)")
    failure = built("small_node").failure
    assert failure is not None
    assert failure.kind == "output-limit"


@pytest.mark.slow
def test_calling_off_leaves_nothing(built: Built, runs: Runs, src: Path, store: Store) -> None:
    (src / "small_node/quick.py").write_text("import time; time.sleep(300)")
    with none_stays(), called_off(runs) as interrupt, pytest.raises(Interrupted):
        built("small_node", interrupt=interrupt)
    assert {path.suffix for path in store.root.iterdir()} == {".lock", ".used"}


def test_a_fault_of_ours_in_one_calls_off_the_other(
    built: Built, runs: Runs, src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    make_package(src, "endless")
    (src / "endless/quick.py").write_text("import time; time.sleep(300)")
    make_package(src, "unlucky")
    real = package_build.require_tools

    def require(package: package_build.Package, env: dict[str, str]) -> None:
        if package.name == "unlucky":
            raise MissingHere("no compiler", "install one")
        real(package, env)

    monkeypatch.setattr(package_build, "require_tools", require)
    with pytest.raises(MissingHere):
        built("endless", "unlucky")


def test_a_save_during_the_build_starts_it_anew(
    built: Built, runs: Runs, src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = sources.copy_sources
    saves = iter(["0.2.0"])

    def copy(folder: Path, home: Path, to: Path) -> None:
        for version in saves:
            edit(src / "small_node/setup.py", "0.1.0", version)
        real(folder, home, to)

    monkeypatch.setattr(package_build, "copy_sources", copy)
    outcome = built("small_node")
    assert outcome.failure is None
    assert "0.2.0" in (outcome.prefixes[0].parents[1] / "src/setup.py").read_text()


def test_saving_without_end_is_given_up(
    built: Built, runs: Runs, src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = sources.copy_sources

    def copy(folder: Path, home: Path, to: Path) -> None:
        with (src / "small_node/setup.py").open("a") as file:
            file.write("\n")
        real(folder, home, to)

    monkeypatch.setattr(package_build, "copy_sources", copy)
    with pytest.raises(UsageError, match="keep changing"):
        built("small_node")


def test_what_colcon_would_refuse_is_refused(built: Built, runs: Runs, src: Path) -> None:
    edit(src / "small_node/package.xml", "<license>MIT</license>", "")
    failure = built("small_node").failure
    assert failure is not None
    assert failure.kind == "package-xml"
    assert failure.feedback.summary == "package.xml of `small_node` is not right: it has no <license>."
    assert runs() == []


def test_a_strict_look_is_only_for_what_is_built(
    built: Built, runs: Runs, monkeypatch: pytest.MonkeyPatch
) -> None:
    built("small_node")

    def slow(file: Path) -> ManifestFault | None:
        raise AssertionError("this import takes longer than a check with nothing to build may")

    monkeypatch.setattr(package_build, "strict_fault", slow)
    assert built("small_node").failure is None


def test_too_many_files_are_refused(
    built: Built, runs: Runs, src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sources, "MOST_FILES", 20)
    (src / "small_node/my_venv").mkdir()
    for number in range(20):
        (src / f"small_node/my_venv/{number}").touch()
    failure = built("small_node").failure
    assert failure is not None
    assert failure.kind == "package-size"
    assert [str(place) for place in failure.feedback.where] == [
        "ros2_tutorial_workspace/src/small_node/my_venv"
    ]


def test_a_full_disk_during_the_build_is_not_the_learners(
    built: Built, runs: Runs, src: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (src / "small_node/quick.py").write_text("sys.exit('error: [Errno 28] No space left on device')")
    outcome = built("small_node")
    assert outcome.failure is not None, "anybody can print that"
    monkeypatch.setattr(Machine, "is_full", lambda _: True)
    with pytest.raises(StorageError, match="disk is full"):
        built("small_node")


def test_a_store_that_cannot_be_written_is_not_the_learners(
    runs: Runs,
    home: Path,
    ros: Ros,
    open_folder: Path,
    read_only: Callable[[Path], AbstractContextManager[None]],
) -> None:
    workspace = Workspace.scan(home / WORKSPACE)
    # A user who may not write here must still be able to read the sources.
    for folder in (home, *home.parents):
        if folder.stat().st_uid == os.geteuid():
            folder.chmod(folder.stat().st_mode | 0o055)
    (open_folder / "cache").mkdir()
    with read_only(open_folder / "cache"), pytest.raises(StorageError):
        build(workspace, ["small_node"], ros, Store(open_folder / "cache/builds"))


def test_a_missing_tool_is_named(
    built: Built, runs: Runs, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(MissingHere) as caught:
        built("small_interfaces")
    assert "which this machine lacks" in caught.value.what
    assert str(caught.value.next_step).startswith("sudo apt install ")


def test_progress_is_told(built: Built, runs: Runs) -> None:
    said: list[str] = []
    built("small_node", on_progress=said.append)
    built("small_node", on_progress=said.append)
    assert said == ["Building small_node"]


def test_the_default_limit_is_generous() -> None:
    assert builder.TIME_LIMIT == 300.0
