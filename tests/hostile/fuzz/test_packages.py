"""Packages of strangers until they are built, and the logs of their builds."""

from __future__ import annotations

import shutil
from pathlib import Path

from hypothesis import strategies as st

from course.build import Workspace
from course.build.builder import Unbuildable, build_order
from course.build.package_sources import TooMuch, content_key, source_files
from course.build.reuse import is_plain
from course.build.workspace import Package
from course.evidence.packages import BuiltPackage, BuiltPackages
from course.evidence.sources import Sources
from course.explain.build_errors import explain_build
from course.explain.builds import Build, read_copy, readable
from course.explain.launch_files import launch_file_cause, not_installed
from course.explain.package_xml import strict_fault
from tests.hostile.fuzz.conftest import fuzzed, soon
from tests.hostile.fuzz.inputs import TEXTS, mangled, names

SOLUTIONS = Path(__file__).parents[3] / "solutions"
_SRC = "ros2_tutorial_workspace/src"
PYTHON = SOLUTIONS / "18-publishers-and-subscribers" / _SRC / "python_package_that_uses_the_messages"
CPP = SOLUTIONS / "17-a-package-for-interfaces" / _SRC / "package_with_interfaces"
LAUNCHES = (
    SOLUTIONS
    / "22-parameters-and-launch-files"
    / _SRC
    / "python_package_that_uses_parameters_and_launch_files"
)
LAUNCH = "launch/peanut_butter_falcon_quote_publisher_launch.py"
FILES = ("package.xml", "setup.py", "setup.cfg", "CMakeLists.txt", "msg/AmazingQuote.msg")
SAMPLES = {
    name: [(top / name).read_bytes() for top in (PYTHON, CPP) if (top / name).exists()] for name in FILES
}
PRINTED = tuple(text.encode("utf-8", "replace") for text in TEXTS)


# One file of a package, mangled.
FILE = st.one_of(*(st.tuples(st.just(name), mangled(every)) for name, every in SAMPLES.items()))


@fuzzed(st.tuples(FILE, st.booleans(), names), cases=250)
def test_a_package(case: tuple[tuple[str, bytes], bool, str], tmp_path: Path) -> None:
    """Found, planned, given its key, and recognized as plain or not, whatever its files say."""
    file, in_python, extra = case
    with soon():
        package = lay(tmp_path, file, in_python, extra)
        home = package.parents[2]
        workspace = Workspace.scan(home / "ros2_tutorial_workspace", home)
        for found in workspace.packages:
            found.name.encode()
            try:
                build_order(workspace, [found.name])
                content_key(found.folder, home, (), "ros")
                is_plain(found.folder, (file.name for file in source_files(found.folder, home)))
            except (Unbuildable, TooMuch):
                pass
            strict_fault(found.folder / "package.xml")


@fuzzed(st.tuples(FILE, st.booleans(), mangled(PRINTED)), cases=250)
def test_the_log_of_a_build(case: tuple[tuple[str, bytes], bool, bytes], tmp_path: Path) -> None:
    """A failed build is explained, whatever its output and its sources."""
    file, in_python, printed = case
    with soon():
        package = lay(tmp_path, file, in_python, "")
        home = package.parents[2]
        workspace = Workspace.scan(home / "ros2_tutorial_workspace", home)
        for found in workspace.packages:
            told = explain_build(failed(found, printed, tmp_path)).feedback
            assert told.summary
            str(told).encode()


@fuzzed(
    st.tuples(*(mangled([(LAUNCHES / name).read_bytes()]) for name in (LAUNCH, "setup.py")), names), cases=150
)
def test_a_launch_file(case: tuple[bytes, bytes, str]) -> None:
    """Its errors, and those of its setup.py, are reported, whatever they contain."""
    launch, setup, extra = case
    texts = {"a/" + LAUNCH: launch, "a/setup.py": setup, f"a/launch/{extra}": launch}
    sources = Sources({name: text.decode("utf-8", "replace") for name, text in texts.items()})
    packages = BuiltPackages((BuiltPackage(LAUNCHES.name, "a", "/nowhere", ("node",)),))
    with soon():
        for file in (Path(LAUNCH).name, extra, "absent_launch.py"):
            cause = launch_file_cause(sources, packages, file)
            told = not_installed(sources, "a", file)
            assert told.summary and (cause is None or cause.text)
            f"{told} {cause}".encode("utf-8", "surrogatepass")


def failed(package: Package, printed: bytes, store: Path) -> Build:
    text = printed.decode("utf-8", "replace").replace("/x", f"{package.folder}/setup.py")
    return Build(
        sources=read_copy(package.folder, package.source),
        folder=package.source,
        name=package.name,
        build_type=package.build_type,
        manifest=package.manifest,
        copy=package.folder,
        lines=readable(text, store, package.folder, package.source),
        neighbors={},
        prefixes=(),
        ask_setup_py=tuple,
    )


def lay(top: Path, file: tuple[str, bytes], in_python: bool, extra: str) -> Path:
    shutil.rmtree(top / "home", ignore_errors=True)
    package = top / "home" / _SRC / "strange"
    shutil.copytree(PYTHON if in_python else CPP, package)
    (package / file[0]).parent.mkdir(exist_ok=True)
    (package / file[0]).write_bytes(file[1])
    if extra and "/" not in extra and "\0" not in extra and extra not in (".", "..") and len(extra) < 80:
        (package / extra.encode("utf-8", "replace").decode()).touch()
    return package
