"""Which setup.py is known only to copy modules, and which might do anything."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pytest

from course.build.reuse import is_plain
from tests.build.conftest import HOME, SRC

PLAIN = """\
from glob import glob
import os
from setuptools import find_packages, setup

package_name = 'small_node'

setup(
    name=package_name,
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/' + package_name, ['package.xml']),
        (os.path.join('share', package_name, 'launch'), glob('launch/*.launch.py')),
    ],
    entry_points={'console_scripts': [f'talk = {package_name}.talker:main']},
)
"""
CONFIG = "[develop]\nscript_dir=$base/lib/small_node\n[install]\ninstall_scripts=$base/lib/small_node\n"


@pytest.fixture
def package(tmp_path: Path) -> Path:
    write(tmp_path, {"setup.py": PLAIN, "setup.cfg": CONFIG, "small_node/__init__.py": "", "package.xml": ""})
    return tmp_path


def write(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)


def plain(folder: Path) -> bool:
    return is_plain(folder, names(folder))


def names(folder: Path) -> Iterable[str]:
    return [str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()]


def test_what_ros2_pkg_create_writes() -> None:
    assert plain(HOME / SRC / "small_node")


def test_what_tutorials_add(package: Path) -> None:
    assert plain(package)
    write(
        package,
        {"launch/talk.launch.py": "", "test/__init__.py": "", "test/test_talk.py": "", "config/a.yaml": ""},
    )
    assert plain(package)


@pytest.mark.parametrize(
    "added",
    [
        "import small_node",
        "from small_node import __version__",
        "from . import talker",
        "from setuptools.command.install import install",
        "import subprocess",
        "import setuptools as glob",
        "version = open('small_node/__init__.py').read()",
        "version = __import__('small_node').__version__",
        "version = glob('small_node/*.py')[0]",
        "version = os.environ['HOME']",
        "version = (lambda: 1)()",
        "version = [part for part in 'ab']",
        "os.path.join = print",
        "glob += 'a'",
        "for part in 'ab': pass",
        "if True: setup()",
        "def version(): pass",
        "print(package_name)",
        "exec(package_name)",
        "glob('small_node/*.py')",
        "setup(cmdclass={})",
        "setup(scripts=['small_node/talker.py'])",
        "setup(ext_modules=[])",
        "setup(**{'cmdclass': 1})",
        "setup({'cmdclass': 1})",
        "setup(version=exec('1'))",
        "setup(packages=find_packages(where=open('a').name))",
        "assert True",
        "this is no Python",
    ],
)
def test_what_might_do_anything(package: Path, added: str) -> None:
    (package / "setup.py").write_text(f"{PLAIN}\n{added}\n")
    assert not plain(package)


@pytest.mark.parametrize(
    "file",
    [
        "setuptools.py",
        "helper.py",
        "conftest.py",
        "pyproject.toml",
        "MANIFEST.in",
        "email/__init__.py",
        "setuptools/__init__.py",
        "packaging/__init__.py",
        "__main__/__init__.py",
        "not-a-name/__init__.py",
    ],
)
def test_files_that_setuptools_could_come_upon(package: Path, file: str) -> None:
    write(package, {file: ""})
    assert not plain(package)


@pytest.mark.parametrize(
    "config",
    [
        "[metadata]\nversion = attr: small_node.VERSION\n",
        "[options]\npackages = find:\n",
        "[install]\nprefix=/tmp\n",
        "[DEFAULT]\nprefix=/tmp\n[install]\n",
        "[aliases]\ninstall = build\n",
        "no section at all\n",
        "[install]\n[install]\n",
    ],
)
def test_other_settings(package: Path, config: str) -> None:
    (package / "setup.cfg").write_text(config)
    assert not plain(package)


def test_without_what_it_takes(package: Path) -> None:
    (package / "setup.cfg").unlink()
    assert plain(package)
    (package / "setup.py").unlink()
    assert not plain(package)
