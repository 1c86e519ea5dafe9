"""What builds leave behind in installed files, sources, and logs."""

from __future__ import annotations

import os
import stat
from pathlib import Path

import pytest

from course.build.colcon import Machine
from course.report import sanitize
from tests.hostile.builds.conftest import (
    NAME,
    PACKAGE,
    BuildIt,
    Package,
    attack,
    cmake_package,
    python_package,
)
from tests.hostile.world import SECRET, World

pytestmark = pytest.mark.slow

# Beside the marker that setup.py installs when the attack has been made.
THERE = """
import os, socket
os.makedirs('../install/strange/share', exist_ok=True)
os.chdir('../install/strange')
"""
BACK = "\nos.chdir('../../src')\n"
FLAWS = (
    ("os.path.lexists('share/a') or os.symlink('/etc/passwd', 'share/a')", "link", "share/a"),
    ("os.path.lexists('share/b') or os.symlink('../' * 30 + 'etc', 'share/b')", "link", "share/b"),
    ("os.path.lexists('c') or os.symlink('c', 'c')", "link", "strange/c"),
    ("os.path.lexists('share/d') or os.symlink('/proc/self/environ', 'share/d')", "link", "share/d"),
    ("os.path.lexists('share/e') or os.symlink('/dev/zero', 'share/e')", "link", "share/e"),
    ("os.path.lexists('share/f') or os.mkfifo('share/f')", "kind", "share/f"),
    ("os.path.lexists('share/g') or socket.socket(socket.AF_UNIX).bind('share/g')", "kind", "share/g"),
)


@pytest.mark.parametrize(("act", "why", "name"), FLAWS, ids=[name for _, _, name in FLAWS])
def test_what_must_not_be_installed_is_named(build_it: BuildIt, act: str, why: str, name: str) -> None:
    built = build_it(python_package(f"{THERE}{act}{BACK}"), guarantee="what is installed leads nobody astray")
    assert built.failure.kind == f"installed-{why}"
    assert name in built.failure.feedback.summary
    assert not built.install.exists()


def test_modes_and_owners_are_made_ours(build_it: BuildIt) -> None:
    """Setuid programs, files that nobody can read, and files that everyone can write."""
    act = """
for mode in (0o6755, 0o7777, 0o000, 0o666, 0o200):
    with open(f'share/{mode}', 'w') as file:
        os.fchmod(file.fileno(), mode)
os.makedirs('share/shut/inner', exist_ok=True)
os.path.exists('share/twin') or os.link(f'share/{0o6755}', 'share/twin')
os.chmod('share/shut', 0)
"""
    program = f"{THERE}\nos.path.exists('share/shut') and os.chmod('share/shut', 0o755)\n"
    program += "for name in os.listdir('share'): os.chmod('share/' + name, 0o755)\n"
    built = build_it(python_package(program + act + BACK), guarantee="what is installed is ours")
    assert built.outcome.failure is None, built.words
    modes = {0o755, 0o644}
    for path in built.install.rglob("*"):
        status = path.lstat()
        assert (status.st_uid, status.st_gid) == (os.geteuid(), os.getegid()), path
        assert stat.S_IMODE(status.st_mode) in modes, path
    assert (built.install / "share/shut/inner").is_dir()


def test_ten_thousand_files_are_no_harm(build_it: BuildIt) -> None:
    act = "for number in range(10_000): open(f'share/{number}', 'w').close()"
    built = build_it(python_package(f"{THERE}{act}{BACK}"), guarantee="many files are sealed, too")
    assert built.outcome.failure is None, built.words
    assert all(path.stat().st_uid == os.geteuid() for path in built.install.joinpath("share").iterdir())


def test_names_that_are_no_text(build_it: BuildIt) -> None:
    names = ["new\\nline", "\\x1b]8;;http://evil\\x07link", "\\u202egnp.exe", "b" * 255]
    act = f"for name in {names}: os.path.lexists(name) or os.mkfifo(name)\n"
    act = act.replace("\\\\", "\\") + "os.path.lexists(b'\\xff\\xfe') or os.mkfifo(b'\\xff\\xfe')"
    built = build_it(python_package(f"{THERE}{act}{BACK}"), guarantee="names of files do no harm")
    assert built.failure.kind == "installed-kind"
    shown = sanitize.paragraph(built.failure.feedback.summary)
    assert not {"\n", "\x1b", "\x07", "\u202e"} & set(shown)
    assert shown.encode()


LINKS = """
import os, sys
for name in ('setup.py', 'setup.cfg', 'package.xml', 'resource/strange', 'CMakeLists.txt'):
    if os.path.exists(name):
        os.unlink(name)
        os.symlink(PRIVATE, name)
print('  File "' + os.getcwd() + '/setup.py", line 1, in <module>', file=sys.stderr)
print('CMake Error at ' + os.getcwd() + '/CMakeLists.txt:1 (message):\\n  Parse error.\\n', file=sys.stderr)
print('CMake Error at ' + '../' * 40 + PRIVATE + ':1 (message):\\n  Parse error.\\n', file=sys.stderr)
print(os.getcwd() + '/setup.py:1:1: error: breach', file=sys.stderr)
print('../' * 40 + PRIVATE[1:] + ':1:1: error: breach', file=sys.stderr)
sys.exit('configparser.ParsingError: setup.cfg\\', line: 1')
"""


@pytest.mark.parametrize("package", [python_package, cmake_package])
def test_nothing_private_comes_up_in_the_words(
    build_it: BuildIt, package: Package, course_copy: Path
) -> None:
    """Sources become links to private files, and the log claims that the errors are there."""
    private = course_copy / "solutions" / f"{SECRET}.txt"
    program = f"PRIVATE = {str(private)!r}\n{LINKS}"
    built = build_it(package(program), guarantee="what is told of a build comes from its own sources")
    hidden = built.words.replace(str(private), "").replace(private.name, "")
    assert SECRET not in hidden


def test_links_in_what_is_handed_in_stay_links(build_it: BuildIt, course_copy: Path) -> None:
    private = course_copy / "solutions" / f"{SECRET}.txt"

    def lay(world: World) -> None:
        (world.home / PACKAGE / "setup.py").unlink()
        (world.home / PACKAGE / "setup.py").symlink_to(private)

    built = build_it(python_package(""), guarantee="links out of a package are not followed", prepare=lay)
    assert SECRET not in built.words.replace(private.name, "")
    assert built.failure.kind == "setup-py"
    assert "is a link to a file outside the course home" in built.failure.feedback.summary


FORGED = (
    "error: [Errno 28] No space left on device",
    "OSError: [Errno 122] Disk quota exceeded",
    "c++: fatal error: Killed signal terminated program cc1plus",
    "virtual memory exhausted: Cannot allocate memory",
    "  Could NOT find Python3 (missing: Python3_INCLUDE_DIRS Development)",
    "fatal error: Python.h: No such file or directory",
    "  No CMAKE_CXX_COMPILER could be found.",
)


@pytest.mark.parametrize("package", [python_package, cmake_package])
def test_our_error_cannot_be_claimed(build_it: BuildIt, package: Package) -> None:
    lines = "\n".join(FORGED)
    program = f"import sys\nprint({lines!r}, file=sys.stderr)\nsys.exit(1)"
    built = build_it(package(program), guarantee="only a fault of the machine is our error")
    assert built.log.count("Errno 28") >= 1
    assert built.failure.package == NAME


def test_a_fault_of_the_machine_is_ours(build_it: BuildIt, monkeypatch: pytest.MonkeyPatch) -> None:
    from course.errors import StorageError

    monkeypatch.setattr(Machine, "is_full", lambda _: True)
    program = f"import sys\nprint({FORGED[0]!r}, file=sys.stderr)\nsys.exit(2)"
    with pytest.raises(StorageError, match="disk is full"):
        build_it(python_package(program), guarantee="only a fault of the machine is our error")


def test_a_log_that_takes_long_to_read_is_read_in_part(build_it: BuildIt) -> None:
    """Lines that look like errors, each of which takes time to examine."""
    program = """
import sys
for _ in range(20000):
    print('CMake Error at CMakeLists.txt:1 (message):', file=sys.stderr)
    print('  Error processing ' + "'a' of '/b': " * 20, file=sys.stderr)
    print('\\x1b]' * 50, file=sys.stderr)
sys.exit(1)
"""
    built = build_it(cmake_package(program), guarantee="no log keeps us busy")
    assert built.failure.package == NAME
    assert built.outcome.seconds < 30
    assert all(len(line) <= 2000 for line in built.failure.feedback.details)


def test_sources_that_python_cannot_parse(build_it: BuildIt) -> None:
    texts = ("-" * 100_000 + "1", "a" + ".b" * 50_000, "(" * 100_000, "'" + "\\N{" * 1000)
    for text in texts:
        built = build_it(python_package(text), guarantee="no source brings our reading of it down")
        assert built.failure.package == NAME


def test_a_build_reads_its_own_program(build_it: BuildIt) -> None:
    """It prints what it should, which shows that the attacks above really ran."""
    built = build_it(python_package(attack("build_rights") + "\nsys.exit(3)"), guarantee="attempts are made")
    assert built.failure.package == NAME
    assert "rights" in built.held
