"""`ros2 pkg create`: what it says, the files it makes, and that they work."""

from __future__ import annotations

import ast
import configparser
import subprocess
from pathlib import Path
from xml.etree import ElementTree

import pytest

from tests.underlay.runtime.captured import capture
from tests.underlay.runtime.command import Ros2

CASES = [
    "pkg_create_ament_python",
    "pkg_create_ament_python_library",
    "pkg_create_ament_python_node",
    "pkg_create_bad_build_type",
    "pkg_create_bad_name",
    "pkg_create_exists",
    "pkg_create_known_license",
    "pkg_create_license_list",
    "pkg_create_named_test",
]


@pytest.fixture
def create(ros2: Ros2) -> Ros2:
    """The command in the folder `create`, as in the captures, where nobody has told git an address."""
    folder = ros2.cwd / "create"
    folder.mkdir()
    environment = {**ros2.environment, "GIT_CONFIG_NOSYSTEM": "1", "GIT_CONFIG_GLOBAL": "/dev/null"}
    return Ros2(ros2.python, environment, folder, ros2.workspace)


@pytest.mark.parametrize("name", CASES)
def test_as_the_real_one(name: str, create: Ros2) -> None:
    case = capture(name)
    if name == "pkg_create_exists":
        (create.cwd / "already").mkdir()
    answer = create(*case.arguments)
    assert answer.stdout.replace(str(create.cwd.parent), "<cwd>") == case.stdout
    assert _unquoted(answer.stderr) == _unquoted(case.stderr)
    assert answer.code == case.code
    assert _files(create.cwd) == case.files


def test_the_manifest_says_what_was_asked_for(create: Ros2) -> None:
    create(
        *("pkg", "create", "p", "--build-type", "ament_python", "--dependencies", "rclpy", "std_msgs"),
        *("--description", 'A < B & "C\'s"', "--maintainer-name", "Ada L", "--maintainer-email", "a@b.org"),
        *("--license", "MIT"),
    )
    root = ElementTree.parse(create.cwd / "p/package.xml").getroot()
    assert [element.text for element in root.iter("depend")] == ["rclpy", "std_msgs"]
    assert root.findtext("description") == 'A < B & "C\'s"'
    assert root.find("maintainer").attrib == {"email": "a@b.org"}  # type: ignore[union-attr]
    assert (root.findtext("license"), root.findtext("export/build_type")) == ("MIT", "ament_python")
    setup = _setup_arguments(create.cwd / "p/setup.py")
    assert (setup["description"], setup["license"], setup["maintainer"]) == ('A < B & "C\'s"', "MIT", "Ada L")
    assert "Ada L" in (create.cwd / "p/LICENSE").read_text()


def test_the_node_runs_and_scripts_go_where_ros2_run_looks(create: Ros2) -> None:
    create("pkg", "create", "p", "--build-type", "ament_python", "--node-name", "n")
    setup = _setup_arguments(create.cwd / "p/setup.py")
    assert setup["entry_points"] == {"console_scripts": ["n = p.n:main"]}
    config = configparser.ConfigParser()
    config.read(create.cwd / "p/setup.cfg")
    assert config["install"]["install_scripts"] == config["develop"]["script_dir"] == "$base/lib/p"
    said = subprocess.run(
        [create.python, create.cwd / "p/p/n.py"], capture_output=True, text=True, check=True
    )
    assert said.stdout == capture("run_ok_terminates").stdout.replace("python_package_with_a_node", "p")


@pytest.mark.slow
def test_every_listed_license_has_a_text(create: Ros2) -> None:
    for name in capture("pkg_create_license_list").stdout.splitlines()[1:]:
        create("pkg", "create", f"p_{name[0]}", "--license", name, "--destination-directory", name)
        text = (create.cwd / name / f"p_{name[0]}" / "LICENSE").read_text()
        assert len(text) > 700
        assert "{copyright}" not in text


def test_a_cpp_package(create: Ros2) -> None:
    arguments = ("--node-name", "my_node", "--library-name", "my_library", "--dependencies", "std_msgs")
    answer = create("pkg", "create", "p", *arguments)
    assert _files(create.cwd) == tuple(
        f"p/{name}"
        for name in (
            "CMakeLists.txt",
            "include/p/my_library.hpp",
            "include/p/visibility_control.h",
            "package.xml",
            "src/my_library.cpp",
            "src/my_node.cpp",
        )
    )
    assert "build type: ament_cmake\ndependencies: ['std_msgs']\n" in answer.stdout
    assert "creating source and include folder\ncreating folder ./p/src\n" in answer.stdout
    root = ElementTree.parse(create.cwd / "p/package.xml").getroot()
    assert root.findtext("buildtool_depend") == "ament_cmake_ros"
    create("pkg", "create", "q", "--node-name", "my_node")
    root = ElementTree.parse(create.cwd / "q/package.xml").getroot()
    assert root.findtext("buildtool_depend") == "ament_cmake"


def test_a_node_named_as_its_library_gets_another_name(create: Ros2) -> None:
    arguments = ("--build-type", "ament_python", "--node-name", "same", "--library-name", "same")
    answer = create("pkg", "create", "p", *arguments)
    assert answer.code == 0
    assert "node_name: same_node\n" in answer.stdout
    assert "renaming node to same_node" in answer.stderr
    assert (create.cwd / "p/p/same_node.py").exists()


def test_a_folder_that_cannot_be_made_is_one_line(create: Ros2) -> None:
    (create.cwd / "file").touch()
    answer = create("pkg", "create", "p", "--destination-directory", "file")
    assert answer.code == 1
    assert answer.stderr == "Unable to create file/p: Not a directory\n"


@pytest.mark.slow
@pytest.mark.parametrize("linter", ["copyright", "flake8", "pep257"])
def test_the_lint_tests_are_skipped_without_the_linter(linter: str, create: Ros2) -> None:
    create("pkg", "create", "p", "--build-type", "ament_python")
    command = [create.python, "-m", "pytest", "-q", "-p", "no:cacheprovider", f"test/test_{linter}.py"]
    done = subprocess.run(
        command, cwd=create.cwd / "p", env=create.environment, capture_output=True, text=True, check=False
    )
    assert "1 skipped" in done.stdout, done.stdout
    assert "arning" not in done.stdout


def _files(folder: Path) -> tuple[str, ...]:
    return tuple(sorted(str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()))


def _unquoted(text: str) -> str:
    """Pythons differ in whether they put the choices of an option in quotes."""
    return text.replace("'", "")


def _setup_arguments(file: Path) -> dict[str, object]:
    """The arguments of setup() that are plain values."""
    calls = (node for node in ast.walk(ast.parse(file.read_text())) if isinstance(node, ast.Call))
    (setup,) = (call for call in calls if isinstance(call.func, ast.Name) and call.func.id == "setup")
    plain = (ast.Constant, ast.Dict)
    return {
        str(word.arg): ast.literal_eval(word.value)
        for word in setup.keywords
        if isinstance(word.value, plain)
    }
