"""This machine's own ROS 2: building for it, sourcing it, and nodes that find each other."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from course.rosenv import Ros, find_ros, node_environment, prepare, setup_script
from tests.rosenv.made_up import write

pytestmark = pytest.mark.slow

INTERFACES = {
    "package.xml": """\
<?xml version="1.0"?>
<package format="3">
  <name>lighthouse_interfaces</name><version>0.1.0</version><description>Lighthouses</description>
  <maintainer email="keeper@example.com">Keeper</maintainer><license>MIT</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  <depend>geometry_msgs</depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>
  <export><build_type>ament_cmake</build_type></export>
</package>
""",
    "CMakeLists.txt": """\
cmake_minimum_required(VERSION 3.8)
project(lighthouse_interfaces)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(geometry_msgs REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Lighthouse.msg" DEPENDENCIES geometry_msgs)
ament_package()
""",
    "msg/Lighthouse.msg": "string name\ngeometry_msgs/Point place\n",
}
NODE = {
    "package.xml": """\
<?xml version="1.0"?>
<package format="3">
  <name>lighthouse</name><version>0.1.0</version><description>A lighthouse</description>
  <maintainer email="keeper@example.com">Keeper</maintainer><license>MIT</license>
  <depend>rclpy</depend>
  <export><build_type>ament_python</build_type></export>
</package>
""",
    "setup.cfg": """\
[develop]
script_dir=$base/lib/lighthouse
[install]
install_scripts=$base/lib/lighthouse
""",
    "setup.py": """\
from setuptools import setup
setup(
    name="lighthouse", version="0.1.0", packages=["lighthouse"],
    data_files=[("share/ament_index/resource_index/packages", ["resource/lighthouse"]),
                ("share/lighthouse", ["package.xml"])],
    entry_points={"console_scripts": ["shine = lighthouse.shine:main"]},
)
""",
    "resource/lighthouse": "",
    "lighthouse/__init__.py": "",
    "lighthouse/shine.py": """\
import rclpy
from ament_index_python import get_package_prefix

def main():
    rclpy.init()
    node = rclpy.create_node("lighthouse")
    print(node.get_name(), "shines from", get_package_prefix("lighthouse"))
    node.destroy_node()
    rclpy.shutdown()
""",
}
LISTEN = """
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("listener")
heard = []
node.create_subscription(String, "rosenv_test", heard.append, 10)
while not heard:
    rclpy.spin_once(node, timeout_sec=1.0)
print(heard[0].data)
"""
SPEAK = """
import rclpy
from std_msgs.msg import String
rclpy.init()
node = rclpy.create_node("speaker")
publisher = node.create_publisher(String, "rosenv_test", 10)
node.create_timer(0.05, lambda: publisher.publish(String(data="good evening")))
rclpy.spin(node)
"""


@pytest.fixture
def outer(tmp_path: Path) -> dict[str, str]:
    """A clean environment, with a home of its own."""
    return {"PATH": "/usr/local/bin:/usr/bin:/bin", "HOME": str(tmp_path / "home"), "LANG": "C.UTF-8"}


@pytest.fixture
def ros(outer: dict[str, str]) -> Ros:
    ros = find_ros()
    prepare(ros, outer)
    return ros


def lay(folder: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        write(folder / name, text)


def test_a_package_with_messages_is_built_and_used(ros: Ros, outer: dict[str, str], tmp_path: Path) -> None:
    lay(tmp_path / "ws/src/lighthouse_interfaces", INTERFACES)
    command = [str(ros.python), "-m", "colcon", "build"]
    environ = node_environment(ros, environ=outer)
    done = subprocess.run(command, cwd=tmp_path / "ws", env=environ, capture_output=True, text=True)
    assert (done.returncode, done.stderr) == (0, ""), done.stdout

    overlay = tmp_path / "ws/install/lighthouse_interfaces"
    code = "from lighthouse_interfaces.msg import Lighthouse as L; import rclpy.type_support as t;"
    code += "t.check_for_type_support(L); print(L(name='Eddystone').place.x)"
    environ = node_environment(ros, [overlay], outer)
    done = subprocess.run([str(ros.python), "-c", code], env=environ, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("0.0\n", "")


def test_a_learner_sources_builds_sources_and_runs(ros: Ros, outer: dict[str, str], tmp_path: Path) -> None:
    """As in the lessons: source ROS and build in one shell; source the workspace and run in a new one."""
    lay(tmp_path / "ws/src/lighthouse", NODE)
    (tmp_path / "home").mkdir()
    built = bash('. "$1" && colcon build', setup_script(ros, outer), tmp_path / "ws", outer)
    assert (built.returncode, built.stderr) == (0, ""), built.stdout
    install = tmp_path / "ws/install"
    run = bash('. "$1" && lighthouse/lib/lighthouse/shine', install / "setup.bash", install, outer)
    assert (run.stdout, run.stderr) == (f"lighthouse shines from {install}/lighthouse\n", "")


@pytest.mark.parametrize("python", ["python3", "/usr/bin/python3"])
def test_bash_imports_rclpy_after_setup_bash(
    ros: Ros, outer: dict[str, str], tmp_path: Path, python: str
) -> None:
    done = bash(f'. "$1" && {python} --version', setup_script(ros, outer), tmp_path, outer)
    if done.stdout.rpartition(".")[0].split()[-1:] != [
        ros.python_packages.parent.name.removeprefix("python")
    ]:
        pytest.skip(f"{python} is not of the version that ROS is here for")
    code = "import rclpy; rclpy.init(); print(rclpy.create_node(str('n')).get_name())"
    done = bash(f'. "$1" && {python} -c "{code}"', setup_script(ros, outer), tmp_path, outer)
    assert (done.stdout, done.stderr) == ("n\n", "")


def test_nodes_in_two_processes_find_each_other(ros: Ros, outer: dict[str, str]) -> None:
    environ = node_environment(ros, environ=outer)
    # A domain that a run beside this one is unlikely to have.
    environ |= {"ROS_DOMAIN_ID": str(1 + os.getpid() % 100), "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    with program(ros, SPEAK, environ), program(ros, LISTEN, environ) as listener:
        assert listener.communicate(timeout=60)[0] == "good evening\n"


def bash(script: str, path: Path, cwd: Path, environ: dict[str, str]) -> subprocess.CompletedProcess[str]:
    command = ["bash", "--norc", "--noprofile", "-c", script, "bash", str(path)]
    return subprocess.run(command, cwd=cwd, env=environ, capture_output=True, text=True)


@contextmanager
def program(ros: Ros, code: str, environ: dict[str, str]) -> Iterator[subprocess.Popen[str]]:
    command = [str(ros.python), "-c", code]
    with subprocess.Popen(command, env=environ, stdout=subprocess.PIPE, text=True) as process:
        try:
            yield process
        finally:
            process.kill()
