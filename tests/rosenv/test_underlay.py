"""A small fake underlay: a command, a node, and a package of interfaces."""

from __future__ import annotations

import shutil
import signal
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from course.rosenv.ros import Ros
from course.rosenv.underlay import (
    Builder,
    add_build,
    cmake_standin,
    fingerprint,
    is_built,
    packages_in,
    program_standin,
    python_standin,
    write_prefix,
)
from tests.rosenv.made_up import pip_ros, wheels, write

SETUP = 'setup(entry_points={{"console_scripts": ["{script} = {module}.main:run"]}})\n'


def underlay(root: Path) -> Path:
    """The workspace `root` with three packages; returns it."""
    _python(root, "ros2cli", "ros2", "[install]\ninstall_scripts=$base/bin\n")
    _python(root, "demo", "talker", "[install]\ninstall_scripts=$base/lib/demo\n")
    interfaces = root / "src/words"
    write(interfaces / "package.xml", "<package/>")
    write(interfaces / "CMakeLists.txt", "project(words)\n")
    write(interfaces / "msg/Word.msg", "string text\n")
    write(interfaces / "srv/Say.srv", "---\n")
    return root


def offer(prefix: Path, root: Path, ros: Ros) -> Path:
    """The prefix for the underlay `root`."""
    setup = prefix.parent / "local_setup.sh"
    write_prefix(prefix, packages_in(root), ros, setup=setup, cache=prefix.parent / "cache")
    return prefix


def built(prefix: Path) -> Path:
    """What a build of `words` installs."""
    for file in (
        "lib/libwords__c.so",
        "lib/python3.11/site-packages/words/__init__.py",
        "include/words/words/word.h",
        "share/words/cmake/wordsConfig.cmake",
        "share/words/msg/Word.idl",
        "share/words/package.xml",
        "share/ament_index/resource_index/rosidl_interfaces/words",
        "share/colcon-core/packages/words",
        "local_setup.bash",
    ):
        write(prefix / file, "REAL = True\n")
    return prefix


def _python(root: Path, name: str, script: str, config: str) -> None:
    folder = root / "src" / name
    write(folder / "package.xml", "<package/>")
    write(folder / "setup.py", SETUP.format(script=script, module=name))
    write(folder / "setup.cfg", config)
    write(folder / name / "__init__.py", "")
    write(
        folder / name / "main.py",
        f"import sys\n\ndef run():\n    print('{script}', *sys.argv[1:])\n    return 7\n",
    )


SITE = "lib/python3.11/site-packages"


@pytest.fixture
def ros(tmp_path: Path) -> Ros:
    """Wheels whose Python is a real one."""
    return replace(pip_ros(wheels(tmp_path / "venv")), python=Path(sys.executable))


@pytest.fixture
def root(tmp_path: Path) -> Path:
    return underlay(tmp_path / "it's $HERE" / "underlay")


@pytest.fixture
def prefix(tmp_path: Path, root: Path, ros: Ros) -> Path:
    return offer(tmp_path / "a place" / "underlay", root, ros)


def run(*command: str | Path, path: Path) -> subprocess.CompletedProcess[str]:
    environment = {"PYTHONPATH": str(path), "PATH": "/usr/bin:/bin"}
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=60, check=False)


@pytest.mark.parametrize(("script", "name"), [("bin/ros2", "ros2"), ("lib/demo/talker", "talker")])
def test_scripts_run_with_their_arguments_and_end_with_their_code(
    prefix: Path, script: str, name: str
) -> None:
    done = run(prefix / script, "two words", "'", path=prefix / SITE)
    assert (done.returncode, done.stdout, done.stderr) == (7, f"{name} two words '\n", "")


KILL = "import os, signal\nos.kill(os.getpid(), signal.SIGINT)\n"
RUN = "def run():\n    try:\n        {body}\n    except KeyboardInterrupt:\n        print('heard')\n"


def test_ctrl_c_while_a_script_loads_ends_it_without_a_word(prefix: Path, root: Path) -> None:
    main = root / "src/demo/demo/main.py"
    write(main, KILL + RUN.format(body="pass"))
    done = run(prefix / "lib/demo/talker", path=prefix / SITE)
    assert (done.returncode, done.stdout, done.stderr) == (-signal.SIGINT, "", "")
    write(main, RUN.format(body="import os, signal; os.kill(os.getpid(), signal.SIGINT)"))
    assert run(prefix / "lib/demo/talker", path=prefix / SITE).stdout == "heard\n"


def test_a_script_that_is_to_ignore_ctrl_c_does(prefix: Path, root: Path) -> None:
    write(
        root / "src/demo/demo/main.py",
        f"{KILL}def run():\n    {KILL.splitlines()[1]}\n    print('goes on')\n",
    )
    ignoring = ("sh", "-c", 'trap "" INT; exec "$1"', "sh")
    assert run(*ignoring, prefix / "lib/demo/talker", path=prefix / SITE).stdout == "goes on\n"


def test_python_packages_are_those_of_the_source_folder(prefix: Path, root: Path) -> None:
    write(root / "src/demo/demo/main.py", "def run():\n    print('edited')\n")
    assert run(prefix / "lib/demo/talker", path=prefix / SITE).stdout == "edited\n"


def test_the_python_of_a_package_that_must_be_built_is_there_before(
    tmp_path: Path, root: Path, ros: Ros
) -> None:
    write(root / "src/words/words_helpers/__init__.py", "print('here')\n")
    prefix = offer(tmp_path / "another place" / "underlay", root, ros)
    assert run(ros.python, "-c", "import words_helpers", path=prefix / SITE).stdout == "here\n"
    assert not is_built(prefix, "words")


def test_the_index_knows_packages_and_their_interfaces(prefix: Path) -> None:
    index = prefix / "share/ament_index/resource_index"
    assert sorted(file.name for file in (index / "packages").iterdir()) == ["demo", "ros2cli", "words"]
    assert (index / "rosidl_interfaces/words").read_text().split() == ["msg/Word.msg", "srv/Say.srv"]
    assert (prefix / "share/words/msg/Word.msg").read_text() == "string text\n"
    assert (prefix / "share/words/package.xml").is_file()


def test_what_must_be_built_is_not_there_until_it_was_added(prefix: Path, tmp_path: Path) -> None:
    assert not is_built(prefix, "words")
    add_build(prefix, built(tmp_path / "install"))
    assert is_built(prefix, "words")
    assert run(sys.executable, "-c", "import words; print(words.REAL)", path=prefix / SITE).stdout == "True\n"
    for file in ("lib/libwords__c.so", "include/words/words/word.h", "share/words/msg/Word.idl"):
        assert (prefix / file).is_file(), file
    assert not (prefix / "share/colcon-core").exists()
    assert (prefix / "local_setup.bash").read_text() != "REAL = True\n", "the prefix's own was replaced"


def test_a_build_that_was_removed_is_missing_again(prefix: Path, tmp_path: Path) -> None:
    install = built(tmp_path / "install")
    add_build(prefix, install)
    install.rename(tmp_path / "gone")
    assert not is_built(prefix, "words")


def test_two_packages_share_their_folders(prefix: Path, tmp_path: Path) -> None:
    write(tmp_path / "other/include/other/x.h", "")
    write(tmp_path / "other/lib/libother.so", "")
    add_build(prefix, built(tmp_path / "install"))
    add_build(prefix, tmp_path / "other")
    assert (prefix / "include/words/words/word.h").is_file()
    assert (prefix / "include/other/x.h").is_file()


def test_writing_it_anew_leaves_nothing_of_the_old_one(prefix: Path, root: Path, ros: Ros) -> None:
    before = prefix.resolve()
    (root / "src/demo/package.xml").unlink()
    offer(prefix, root, ros)
    assert not (prefix / "lib/demo").exists()
    assert not before.exists()
    assert [path.name for path in prefix.parent.iterdir() if path.name.startswith("underlay.")] == [
        prefix.resolve().name
    ]


def test_an_arena_builds_nothing(prefix: Path) -> None:
    command = [sys.executable, "-c", "import words"]
    environment = {"PYTHONPATH": str(prefix / SITE), "ROS2COURSE_ARENA": "1"}
    done = subprocess.run(command, env=environment, capture_output=True, text=True, check=False)
    assert "words was not built before it was needed" in done.stderr


def test_the_fingerprint_changes_with_what_is_laid_out_or_compiled(root: Path) -> None:
    seen = {fingerprint(packages_in(root))}
    for file, text in (
        ("words/msg/Word.msg", "int32 number\n"),
        ("demo/setup.py", "setup()"),
        ("demo/more/__init__.py", ""),
        ("new/package.xml", "<package/>"),
        ("new/CMakeLists.txt", ""),
    ):
        write(root / "src" / file, text)
        if (root / "src/new/CMakeLists.txt").exists() or "new" not in file:
            seen.add(fingerprint(packages_in(root)))
    assert len(seen) == 5


def test_code_that_is_used_as_it_stands_does_not_change_the_fingerprint(root: Path) -> None:
    write(root / "src/words/words_helpers/__init__.py", "")
    before = fingerprint(packages_in(root))
    write(root / "src/demo/demo/main.py", "")
    write(root / "src/words/words_helpers/__init__.py", "edited = True")
    write(root / "src/words/words_helpers/__pycache__/__init__.pyc", "x")
    compiled = root / "src/words/__pycache__/setup.pyc"
    compiled.parent.mkdir()
    compiled.write_bytes(b"\xa7")  # pip compiles every file of an installed course
    assert fingerprint(packages_in(root)) == before


def test_a_file_of_a_package_to_be_built_may_be_in_any_encoding(root: Path) -> None:
    before = fingerprint(packages_in(root))
    (root / "src/words/msg/Old.msg").write_bytes(b"# caf\xe9\n")
    assert fingerprint(packages_in(root)) != before


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
    text = python_standin("words", link, builder(tmp_path, link, real, works=works))
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


@pytest.mark.parametrize("works", [True, False])
def test_running_a_program_builds_its_package_and_becomes_it(tmp_path: Path, works: bool) -> None:
    found, own, real = tmp_path / "p/lib/words", tmp_path / "a place/lib", tmp_path / "real"
    write(real / "say", '#!/bin/sh\necho "$@"\n')
    made = builder(tmp_path, found, real, works=works)
    write(own / "say", program_standin("words", own, found / "say", made))
    for script in (real / "say", own / "say"):
        script.chmod(0o755)
    found.parent.mkdir(parents=True)
    found.symlink_to(own)
    runs = [
        subprocess.run([found / "say", "a b"], capture_output=True, text=True, timeout=60, check=False)
        for _ in range(2)
    ]
    if works:
        assert [(run.returncode, run.stdout) for run in runs] == [(0, "a b\n")] * 2
        assert (tmp_path / "log").read_text() == f"words {tmp_path}/cache\n"
    else:
        assert (runs[0].returncode, runs[0].stdout) == (1, "")
        assert "no compiler" in runs[0].stderr


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
    write(own / "wordsConfig.cmake", cmake_standin("words", own, found, made))
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
