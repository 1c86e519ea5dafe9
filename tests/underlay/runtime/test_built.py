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

from course.arena.enclosure import enclosure
from course.rosenv import find_ros, node_environment, prepare
from tests.underlay.runtime.captured import capture
from tests.underlay.runtime.command import PACKAGES, SOLUTIONS, Ros2, ros2_command

EXAMPLES = PACKAGES / "example_interfaces"
COMPILED = ("msg/String.msg", "srv/AddTwoInts.srv", "action/Fibonacci.action")
BUILD_TIMEOUT = 600.0


def test_example_interfaces_offers_what_the_real_one_does() -> None:
    ours = {f"{file.parent.name}/{file.stem}" for file in _definitions()}
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
    for file in _definitions():
        assert f'"{file.parent.name}/{file.name}"' in listed
        assert parse[file.suffix]("example_interfaces", str(file))


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A workspace with packages of the underlay, of the course and new ones, after `colcon build`."""
    workspace = tmp_path_factory.mktemp("built")
    source = workspace / "src"
    for name in ("ament_lint_auto", "ament_lint_common", "demo_nodes_py", "rosidl_runtime_py"):
        shutil.copytree(PACKAGES / name, source / name, ignore=shutil.ignore_patterns("__pycache__"))
    _copy_some_examples(source / "example_interfaces")
    (interfaces,) = SOLUTIONS.glob("*/ros2_tutorial_workspace/src/package_with_interfaces")
    shutil.copytree(interfaces, source / interfaces.name)
    _create_packages(source)
    _colcon_build(workspace)
    return workspace


@pytest.fixture
def ros2(built: Path, tmp_path: Path) -> Iterator[Ros2]:
    """The command with the built packages, where nobody else is heard."""
    base = ros2_command(tmp_path, built)
    ros = find_ros()
    sourced = node_environment(ros, sorted((built / "install").glob("*/")))
    with enclosure(namespaces=False) as place:
        variables = {"PYTHONPATH": f"{base.environment['PYTHONPATH']}:{sourced['PYTHONPATH']}"}
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


def _definitions() -> list[Path]:
    return sorted(file for kind in ("msg", "srv", "action") for file in (EXAMPLES / kind).iterdir())


def _copy_some_examples(folder: Path) -> None:
    for name in ("package.xml", *COMPILED):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(EXAMPLES / name, folder / name)
    others = {f'  "{file.parent.name}/{file.name}"' for file in _definitions()} - {
        f'  "{name}"' for name in COMPILED
    }
    lines = (EXAMPLES / "CMakeLists.txt").read_text().splitlines()
    (folder / "CMakeLists.txt").write_text("\n".join(line for line in lines if line not in others))


def _create_packages(source: Path) -> None:
    nothing = source.parent / "install" / "nothing"
    nothing.mkdir(parents=True)
    create = ros2_command(source, source.parent)
    both = ("--node-name", "my_node", "--library-name", "my_library")
    create("pkg", "create", "cpp_with_both", *both, "--dependencies", "std_msgs")
    create("pkg", "create", "cpp_plain", "--build-type", "cmake", "--node-name", "hello")
    create("pkg", "create", "py_with_both", "--build-type", "ament_python", *both)
    nothing.rmdir()


def _colcon_build(workspace: Path) -> None:
    ros = find_ros()
    prepare(ros)
    command = [ros.python, "-m", "colcon", "build", "--cmake-args", f"-DPython3_EXECUTABLE={ros.python}"]
    environment = {**node_environment(ros), "COLCON_LOG_LEVEL": "error"}
    done = subprocess.run(
        command,
        cwd=workspace,
        env=environment,
        capture_output=True,
        text=True,
        timeout=BUILD_TIMEOUT,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
