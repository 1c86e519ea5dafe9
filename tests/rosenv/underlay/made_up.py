"""A small underlay that tests make up: a command, a node, and a package of interfaces."""

from __future__ import annotations

from pathlib import Path

from course.rosenv.model import Ros
from course.rosenv.underlay import packages_in, write_prefix
from tests.rosenv.made_up import write

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
