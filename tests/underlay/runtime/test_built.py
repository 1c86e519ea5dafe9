"""What colcon makes of the underlay's packages, and of packages that `ros2 pkg create` made.

Of example_interfaces only a few definitions are compiled here, for all of them take minutes; that the
others are well-formed and complete is looked up without a compiler.
"""

from __future__ import annotations

import shutil
import subprocess
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from course.isolation.levels import isolated
from course.rosenv import find_ros, node_environment
from tests.shared import made_once
from tests.underlay.runtime.captured import capture
from tests.underlay.runtime.colcon import EXAMPLES, colcon_build, copy_interfaces, definitions
from tests.underlay.runtime.command import PACKAGES, Ros2, ros2_command


def test_example_interfaces_offers_what_the_real_one_does() -> None:
    ours = {f"{file.parent.name}/{file.stem}" for file in definitions()}
    real = {
        line.strip().removeprefix("example_interfaces/")
        for line in capture("interface_list").stdout.splitlines()
        if line.strip().startswith("example_interfaces/")
    }
    assert ours == real


def test_every_definition_is_compiled_and_well_formed(tmp_path: Path) -> None:
    adapter = pytest.importorskip("rosidl_adapter.parser", reason="needs ROS 2 from pip")
    parse = {
        ".msg": adapter.parse_message_file,
        ".srv": adapter.parse_service_file,
        ".action": adapter.parse_action_file,
    }
    listed = (EXAMPLES / "CMakeLists.txt").read_text()
    for file in definitions():
        assert f'"{file.parent.name}/{file.name}"' in listed
        assert parse[file.suffix]("example_interfaces", str(file))


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A workspace with packages of the underlay, of the course and new ones, after `colcon build`."""
    return made_once(tmp_path_factory, "built", _build)


def _build(workspace: Path) -> None:
    source = workspace / "src"
    for name in ("ament_lint_auto", "ament_lint_common", "demo_nodes_py", "ros2cli", "rosidl_runtime_py"):
        shutil.copytree(PACKAGES / name, source / name, ignore=shutil.ignore_patterns("__pycache__"))
    copy_interfaces(source)
    _create_packages(source)
    colcon_build(workspace)


@pytest.fixture
def ros2(built: Path, tmp_path: Path) -> Iterator[Ros2]:
    """The command with the built packages, where nobody else is heard."""
    base = ros2_command(tmp_path, built)
    ros = find_ros()
    sourced = node_environment(ros, sorted((built / "install").glob("*/")))
    with isolated(namespaces=False) as place:
        variables = {"PYTHONPATH": f"{sourced['PYTHONPATH']}:{base.environment['PYTHONPATH']}"}
        yield replace(base, environment={**sourced, **variables, **place.environment, "COLUMNS": "80"})


@pytest.mark.slow
def test_a_created_cpp_package_with_its_test_block_builds_and_runs(ros2: Ros2) -> None:
    assert ros2("run", "cpp_with_both", "my_node").code == 0
    plain = (
        ros2.workspace / "install/cpp_plain/lib/cpp_plain/hello"
    )  # not in the index: it does without ament
    said = subprocess.run([plain], capture_output=True, text=True, check=True)
    assert said.stdout == "hello world cpp_plain package\n"


@pytest.mark.slow
def test_the_command_itself_is_complete_when_built(ros2: Ros2) -> None:
    prefix = ros2.workspace / "install/ros2cli"
    assert ros2.environment["PYTHONPATH"].startswith(str(ros2.workspace))
    create = [prefix / "bin/ros2", "pkg", "create", "licensed", "--license", "BSD-2.0"]
    done = subprocess.run(
        create, cwd=ros2.cwd, env=ros2.environment, capture_output=True, text=True, check=True
    )
    assert done.stdout.startswith("going to create a new package\n")
    assert "Redistributions in binary form" in (ros2.cwd / "licensed/LICENSE").read_text()
    assert len(list((prefix / "share/ros2cli/environment").iterdir())) == 2


@pytest.mark.slow
def test_a_created_python_package_builds_and_runs(ros2: Ros2) -> None:
    assert ros2("pkg", "executables", "py_with_both").stdout == "py_with_both my_node\n"
    assert ros2("run", "py_with_both", "my_node").stdout == "Hi from py_with_both.\n"


@pytest.mark.slow
@pytest.mark.parametrize("name", ["interface_show_action", "interface_proto_msg", "interface_proto_srv"])
def test_interfaces_as_the_real_one(name: str, ros2: Ros2) -> None:
    case = capture(name)
    answer = ros2(*case.arguments)
    assert (answer.code, answer.stdout, answer.stderr) == (case.code, case.stdout, case.stderr)


@pytest.mark.slow
def test_the_prototype_of_an_action_is_its_goal(ros2: Ros2) -> None:
    assert ros2("interface", "proto", "example_interfaces/action/Fibonacci").stdout == '"order: 0\n"\n'


@pytest.mark.slow
@pytest.mark.parametrize("client", ["add_two_ints_client", "add_two_ints_client_async"])
def test_the_demo_service(client: str, ros2: Ros2) -> None:
    with ros2.started("run", "demo_nodes_py", "add_two_ints_server"):
        answer = ros2("run", "demo_nodes_py", client)
    assert (answer.code, answer.stdout) == (0, "")
    assert answer.stderr.endswith(f"[{client}]: Result of add_two_ints: 5\n")


@pytest.mark.slow
def test_the_demo_topic(ros2: Ros2) -> None:
    listening = ros2.started("run", "demo_nodes_py", "listener")
    talking = ros2.started("run", "demo_nodes_py", "talker")
    with listening as listener, talking as talker:
        assert talker.stdout
        assert listener.stdout
        assert '[talker]: Publishing: "Hello World: 0"' in talker.stdout.readline()
        assert "[listener]: I heard: [Hello World: " in listener.stdout.readline()


def _create_packages(source: Path) -> None:
    nothing = source.parent / "install" / "nothing"
    nothing.mkdir(parents=True)
    create = ros2_command(source, source.parent)
    both = ("--node-name", "my_node", "--library-name", "my_library")
    create("pkg", "create", "cpp_with_both", *both, "--dependencies", "std_msgs")
    create("pkg", "create", "cpp_plain", "--build-type", "cmake", "--node-name", "hello")
    create("pkg", "create", "py_with_both", "--build-type", "ament_python", *both)
    nothing.rmdir()
