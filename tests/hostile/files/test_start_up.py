"""Files that some program reads automatically when it starts: none may affect the grading process."""

from __future__ import annotations

import sys

import pytest

from course.build import Store, Workspace, build
from course.content import open_course
from course.model.result import Verdict
from course.rosenv import find_ros
from tests.hostile.builds.conftest import python_package
from tests.hostile.files.conftest import GradeHome
from tests.hostile.world import NODE, PACKAGE, SRC, World

pytestmark = pytest.mark.slow
ROOT = f"{SRC}/{PACKAGE}"
WORKSPACE = "ros2_tutorial_workspace"
SITE = f"lib/python3.{sys.version_info.minor}/site-packages"

# Ends whatever process of ours it gets into, which could then give no verdict. In a submission's own
# programs, it tells that it was read.
CANARY = """
import os as _os
with open('/proc/self/cmdline', 'rb') as _file:
    _words = _file.read()
if b'course.grading' in _words or 'PYTEST_CURRENT_TEST' in _os.environ:
    _os._exit(99)
print('CANARY', __name__, flush=True)
"""
# Of setup.py: what it installs beside the rest, where Python looks when it starts.
SETUP = f"""
import glob, os
os.makedirs('evil', exist_ok=True)
with open('evil/evil.pth', 'w') as file:
    file.write("import os; os._exit(99) if b'course.grading' in open('/proc/self/cmdline', 'rb').read() ")
    file.write('else 0\\n')
for name in ('sitecustomize', 'usercustomize', 'evil_plugin', 'conftest'):
    with open(f'evil/{{name}}.py', 'w') as file:
        file.write({CANARY!r})
MODULES = ('course', 'pytest', '_pytest', 'yaml', 'psutil', 'mcap', 'pluggy')
for name in MODULES:
    os.makedirs(f'evil/{{name}}', exist_ok=True)
    with open(f'evil/{{name}}/__init__.py', 'w') as file:
        file.write({CANARY!r})
from setuptools import setup
_real = setup
def setup(**given):
    given['data_files'] += [('{SITE}', glob.glob('evil/*.p*'))]
    given['data_files'] += [(f'{SITE}/{{name}}', [f'evil/{{name}}/__init__.py']) for name in MODULES]
    given['entry_points']['pytest11'] = ['evil = evil_plugin']
    given['entry_points']['colcon_core.verb'] = ['evil = evil_plugin:Verb']
    _real(**given)
"""
INI = "[pytest]\naddopts = -p evil_plugin --exitfirst -k nothing\npython_files = *.py\n"
TOML = '[tool.pytest.ini_options]\naddopts = "-p evil_plugin -k nothing"\n'
BASHRC = """
export PYTEST_ADDOPTS='-p evil_plugin' PYTHONSTARTUP=$HOME/conftest.py PYTHONPATH=$HOME
export LD_PRELOAD=$HOME/evil.so
alias ros2=true colcon=true pytest=true
exit 99
"""


def everywhere() -> dict[str, str]:
    """Canaries under all the names that Python, pytest and shells look for."""
    files = {".bashrc": BASHRC, ".bash_profile": BASHRC, ".profile": BASHRC, ".pythonrc.py": CANARY}
    for folder in ("", f"{WORKSPACE}/", f"{SRC}/", f"{ROOT}/", f"{ROOT}/{PACKAGE}/", f"{ROOT}/test/"):
        for name in ("conftest", "sitecustomize", "usercustomize", "evil_plugin", "test_all"):
            files[f"{folder}{name}.py"] = CANARY
        files |= {
            f"{folder}pytest.ini": INI,
            f"{folder}tox.ini": INI,
            f"{folder}evil.pth": "import evil_plugin",
        }
        if not folder.startswith(ROOT):
            files |= {f"{folder}setup.cfg": INI.replace("[pytest]", "[tool:pytest]")}
            files |= {f"{folder}pyproject.toml": TOML}
    local = f".local/lib/python3.{sys.version_info.minor}/site-packages"
    return files | {f"{local}/usercustomize.py": CANARY, f"{local}/evil.pth": "import os; os._exit(99)"}


def solution_text(name: str) -> str:
    found = sorted(open_course().exercise("18-publisher").solution.parent.glob(f"*/{name}"))
    return found[-1].read_text(encoding="utf-8")


def test_none_of_them_takes_part_in_the_verdict(grade_home: GradeHome) -> None:
    graded = grade_home(everywhere(), guarantee="no file of a submission is run by the grading process")
    assert graded.result.verdict is Verdict.PASSED, graded.result


def test_none_that_is_installed_does(grade_home: GradeHome) -> None:
    """They run only in the submission's own programs, as their notes show."""
    setup = solution_text(f"{ROOT}/setup.py").replace(
        "from setuptools import", "from setuptools import find_packages #"
    )
    files = {f"{ROOT}/setup.py": f"{SETUP}\nfrom setuptools import find_packages\n{setup}"}
    graded = grade_home(files, guarantee="nothing that a submission installs is run by the grading process")
    assert graded.result.verdict is Verdict.PASSED, graded.failed
    assert any(line.startswith("CANARY sitecustomize") for line in graded.printed)


def test_a_wrong_program_gets_no_better_by_them(grade_home: GradeHome) -> None:
    """The same for a submission that should fail: nothing makes it pass."""
    wrong = solution_text(NODE).replace("0.5", "0.1")
    graded = grade_home(
        {**everywhere(), NODE: wrong}, guarantee="no file of a submission changes the verdict"
    )
    assert graded.failed == ("rate",)


def of_name(name: str, module: str) -> dict[str, str]:
    files = python_package("").items()
    return {file.replace("strange", name): text.replace("strange", name) for file, text in files} | {
        f"{SRC}/{name}/{name}/__init__.py": module,
        f"{SRC}/{name}/setup.py": f"""
from setuptools import setup
setup(name='{name}', version='0.0.0', packages=['{name}'], data_files=[
    ('share/ament_index/resource_index/packages', ['resource/{name}']), ('share/{name}', ['package.xml'])])
""",
    }


@pytest.mark.parametrize("name", ["rclpy", "std_msgs"])
def test_a_package_that_stands_in_for_ros(grade_home: GradeHome, name: str) -> None:
    """A package that depends on it gets it instead of the real one; the grading process does not."""
    manifest = solution_text(f"{ROOT}/package.xml")
    if f">{name}<" not in manifest:
        manifest = manifest.replace("<license>", f"<depend>{name}</depend>\n<license>", 1)
    files = {**of_name(name, CANARY), f"{ROOT}/package.xml": manifest}
    graded = grade_home(files, guarantee=f"a submission's own {name} is its own alone")
    assert graded.result.fault is None
    if name == "rclpy":
        assert graded.failed == ("starts",)
        assert any(line.startswith(f"CANARY {name}") for line in graded.printed)
        assert name in graded.words("starts")
    else:
        assert graded.result.verdict is Verdict.PASSED, graded.failed


def test_an_executable_in_another_packages_place(grade_home: GradeHome) -> None:
    """A dependency that installs a program, and the mark of the index, under the graded package's name."""
    helper = of_name("helper", "def main():\n    print('CANARY helper')")
    name = "amazing_quote_publisher_node"
    helper[f"{SRC}/helper/setup.cfg"] = f"[install]\ninstall_scripts=$base/lib/{PACKAGE}\n"
    helper[f"{SRC}/helper/resource/{PACKAGE}"] = ""
    helper[f"{SRC}/helper/setup.py"] = f"""
from setuptools import setup
setup(name='helper', version='0.0.0', packages=['helper'], data_files=[
    ('share/ament_index/resource_index/packages', ['resource/helper', 'resource/{PACKAGE}']),
    ('share/helper', ['package.xml'])], entry_points={{'console_scripts': ['{name} = helper:main']}})
"""
    manifest = solution_text(f"{ROOT}/package.xml")
    manifest = manifest.replace("<license>", "<depend>helper</depend>\n<license>", 1)
    graded = grade_home(
        {**helper, f"{ROOT}/package.xml": manifest}, guarantee="each package runs its own programs"
    )
    assert graded.result.verdict is Verdict.PASSED, graded.result
    assert not any("CANARY" in line for line in graded.printed)


def test_a_message_with_the_right_name_and_other_fields(grade_home: GradeHome) -> None:
    interfaces = f"{SRC}/package_with_interfaces/msg/AmazingQuote.msg"
    text = solution_text(interfaces)
    lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
    other = "\n".join(lines[::-1]) + "\n"
    assert other != text

    def build_first(world: World) -> None:
        """This takes time on a busy machine, which must not be part of the time for a verdict."""
        workspace = Workspace.scan(world.home / WORKSPACE, world.home)
        build(workspace, ["package_with_interfaces"], find_ros(), Store(world.store))

    graded = grade_home(
        {interfaces: other}, guarantee="a type is judged by its definition", change=build_first
    )
    assert "right_type" in graded.failed
    assert "AmazingQuote" in graded.words("right_type")
