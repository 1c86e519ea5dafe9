"""What stands in for a package that was not built yet: in Python, and in CMake."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from course.rosenv.underlay import standins
from course.rosenv.underlay.standins import Builder
from tests.rosenv.made_up import write

# Takes the place of the course: puts the real package where the stand-in is looked for.
_BUILD = """
import os, pathlib, sys
link, real = {link!r}, {real!r}
pathlib.Path({log!r}).open("a").write(f"{{sys.argv[-1]}} {{os.environ['ROS2COURSE_CACHE']}}\\n")
if {works}:
    os.unlink(link)
    os.symlink(real, link)
else:
    sys.exit("no compiler")
"""


class Made(Builder):
    """A builder that runs `program` in place of the course."""

    program: str = ""

    def words(self, package: str) -> list[str]:
        return [str(self.python), "-I", "-c", self.program, package]


def builder(tmp_path: Path, link: Path, real: Path, *, works: bool = True) -> Builder:
    made = Made(Path(sys.executable), tmp_path / "cache")
    log = str(tmp_path / "log")
    program = _BUILD.format(link=str(link), real=str(real), log=log, works=works)
    object.__setattr__(made, "program", program)
    return made


def lay(tmp_path: Path, name: str, *, works: bool) -> Path:
    """A stand-in for `words` at tmp_path/site/words; returns the folder for PYTHONPATH."""
    link, real = tmp_path / "site/words", tmp_path / "real"
    write(real / "__init__.py", "from words.sub import TWO\nONE = 1\n")
    write(real / "sub.py", "TWO = 2\n")
    text = standins.python("words", link, builder(tmp_path, link, real, works=works))
    write(tmp_path / name / "__init__.py", text)
    link.parent.mkdir()
    link.symlink_to(tmp_path / name)
    return link.parent


def python(code: str, path: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", code]
    environment = {"PYTHONPATH": str(path), "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60, check=False)


def test_an_import_builds_the_package_once_and_gets_it(tmp_path: Path) -> None:
    path = lay(tmp_path, "standin", works=True)
    code = "import words; from words.sub import TWO; print(words.ONE, words.TWO, TWO, words.__file__)"
    expected = f"1 2 2 {tmp_path}/site/words/__init__.py\n"
    assert [python(code, path).stdout for _ in range(2)] == [expected] * 2
    assert (tmp_path / "log").read_text() == f"words {tmp_path}/cache\n"


def test_a_build_that_fails_is_an_import_error_with_the_reason_before_it(tmp_path: Path) -> None:
    done = python("import words", lay(tmp_path, "standin", works=False))
    assert "no compiler" in done.stderr
    assert done.stderr.splitlines()[-1].startswith("ImportError: words could not be built")


CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(user NONE)
find_package(words REQUIRED)
message(STATUS "got ${WORDS_IS} in ${words_DIR}")
"""


@pytest.mark.skipif(shutil.which("cmake") is None, reason="cmake is not installed")
@pytest.mark.parametrize("works", [True, False])
def test_find_package_builds_it_and_goes_on_with_the_real_one(tmp_path: Path, works: bool) -> None:
    found, own, real = tmp_path / "p/share/words/cmake", tmp_path / "a place/cmake", tmp_path / "real"
    write(real / "wordsConfig.cmake", "include(${words_DIR}/more.cmake)\n")
    write(real / "more.cmake", "set(WORDS_IS real)\n")
    made = builder(tmp_path, found, real, works=works)
    write(own / "wordsConfig.cmake", standins.cmake("words", own, found, made))
    found.parent.mkdir(parents=True)
    found.symlink_to(own)
    write(tmp_path / "user/CMakeLists.txt", CMAKE)
    command = ["cmake", "-S", str(tmp_path / "user"), "-B", str(tmp_path / "build")]
    command += [f"-DCMAKE_PREFIX_PATH={tmp_path}/p"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    if works:
        assert f"got real in {found}" in done.stdout
    else:
        assert "no compiler" in done.stderr
        assert "words could not be built" in done.stderr
    assert (done.returncode == 0) is works
