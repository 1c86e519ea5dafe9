"""Fake ROS prefixes for tests: pip wheels in a virtual environment, and ROS 2 as from apt."""

from __future__ import annotations

from pathlib import Path

from course.rosenv.find import find_ros
from course.rosenv.host import Host
from course.rosenv.ros import Ros

VERSION = (3, 11)
BUILD_PYTHON = "/opt/python/cp311-cp311/include/python3.11"
BUILD_NUMPY = "/opt/python/cp311-cp311/lib/python3.11/site-packages/numpy/_core/include"
EXPORT = f"""\
set_target_properties(p::p PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "{BUILD_PYTHON};{BUILD_NUMPY}"
  INTERFACE_LINK_LIBRARIES "rosidl_runtime_c;Python3::NumPy"
)
"""
FASTRTPS = (
    'INTERFACE_LINK_LIBRARIES "fastcdr;-lpthread;dl;/usr/lib64/libtinyxml2.so;\\$<\\$<BOOL:1>:ssl>;rt"\n'
)


def wheels(prefix: Path) -> Host:
    """A virtual environment with just enough of the ROS wheels, and the host whose Python it is."""
    packages = prefix / "lib/python3.11/site-packages"
    for folder in ("rclpy", "numpy/_core/include", "ros_rcl.libs", "ros_fastrtps.libs"):
        (packages / folder).mkdir(parents=True)
    for wheel in ("ros_rclpy-7.1.6", "ros_rmw_fastrtps_cpp-8.4.3", "numpy-2.4.6"):
        (packages / f"{wheel}.dist-info").mkdir()
    for name in ("geometry_msgs", "std_msgs"):
        write(export(prefix, name), EXPORT)
    write(prefix / "share/fastrtps/cmake/fastrtps-shared-targets.cmake", FASTRTPS)
    register(prefix, "rclpy")
    write(prefix / "pyvenv.cfg", "")
    python(prefix, "python3")
    return Host(prefix / "bin/python3", prefix, packages, VERSION, installed=prefix.parent / "nothing/here")


def installed(prefix: Path, version: str = "3.11") -> None:
    """ROS 2 as apt installs it, whose setup.bash notes each time that it is sourced."""
    (prefix / f"lib/python{version}/site-packages/rclpy").mkdir(parents=True)
    register(prefix, "rclpy")
    register(prefix, "std_msgs")
    python(prefix, f"python{version}")
    script = f"""\
        echo once >> '{prefix}/sourced'
        echo 'some words' ; [ -z "$FORBIDDEN" ] || exit 1
        export AMENT_PREFIX_PATH='{prefix}' PYTHONPATH='{prefix}/lib/python{version}/site-packages'
        export LD_LIBRARY_PATH='{prefix}/lib' ROS_DISTRO=jazzy GZ_PATH='two
lines' PATH='{prefix}/bin':"$PATH"
        false
    """
    write(prefix / "setup.bash", script)


def no_wheels(root: Path) -> Host:
    """A Python 3.11 without ROS packages, on a machine without an installed ROS."""
    packages = root / "plain/lib/python3.11/site-packages"
    packages.mkdir(parents=True)
    return Host(
        root / "plain/bin/python3", root / "plain", packages, VERSION, installed=root / "opt/ros/jazzy"
    )


def workspace(root: Path, *names: str) -> list[Path]:
    """A colcon workspace's install folder, one prefix for each package; returns the prefixes."""
    write(root / ".colcon_install_layout", "isolated\n")
    for name in names:
        for folder in ("lib/python3.11/site-packages", f"lib/{name}", "lib/pkgconfig", "bin"):
            (root / name / folder).mkdir(parents=True)
        register(root / name, name)
    return [root / name for name in names]


def register(prefix: Path, name: str) -> None:
    """Enter a package into the index of its prefix."""
    write(prefix / "share/ament_index/resource_index/packages" / name, "")
    write(prefix / "share" / name / "package.xml", "<package/>")


def export(prefix: Path, name: str) -> Path:
    """The CMake file of an interface package that the build machine's paths are in."""
    return prefix / f"share/{name}/cmake/export_{name}__rosidl_generator_pyExport.cmake"


def python(prefix: Path, name: str) -> None:
    """An executable file in place of a prefix's Python."""
    write(prefix / "bin" / name, "#!/bin/sh\n")
    (prefix / "bin" / name).chmod(0o755)


def write(path: Path, text: str) -> None:
    """A file with this text, in a folder that may have to be made."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def underlay(ros: Ros) -> Path:
    """Where the packages that the course itself brings are offered for these wheels."""
    return ros.prefix / "share/ros2course/underlay"


def pip_ros(host: Host) -> Ros:
    """The wheels of this host, found without looking at the environment of the test."""
    return find_ros({}, host)
