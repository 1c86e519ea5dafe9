""""""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from course.rosenv.ros import identity_of_prefixes, identity_of_wheels
from tests.rosenv.made_up import installed, register, wheels


def test_wheels_have_the_same_identity_each_time(tmp_path: Path) -> None:
    host = wheels(tmp_path / "venv")
    assert identity_of_wheels(host.prefix, host.site_packages) == identity_of_wheels(
        host.prefix, host.site_packages
    )


def test_a_reinstalled_an_upgraded_and_a_new_wheel_change_it(tmp_path: Path) -> None:
    host = wheels(tmp_path / "venv")
    seen = {identity_of_wheels(host.prefix, host.site_packages)}
    rclpy = host.site_packages / "ros_rclpy-7.1.6.dist-info"
    os.utime(rclpy, (1, 1))
    seen.add(identity_of_wheels(host.prefix, host.site_packages))
    rclpy.rename(host.site_packages / "ros_rclpy-7.1.7.dist-info")
    seen.add(identity_of_wheels(host.prefix, host.site_packages))
    (host.site_packages / "ros_extra-1.0.dist-info").mkdir()
    seen.add(identity_of_wheels(host.prefix, host.site_packages))
    assert len(seen) == 4


def test_a_package_that_has_nothing_to_do_with_ros_does_not_change_it(tmp_path: Path) -> None:
    host = wheels(tmp_path / "venv")
    before = identity_of_wheels(host.prefix, host.site_packages)
    (host.site_packages / "rich-14.0.dist-info").mkdir()
    assert identity_of_wheels(host.prefix, host.site_packages) == before


def test_another_prefix_has_another_identity(tmp_path: Path) -> None:
    one, other = wheels(tmp_path / "one"), wheels(tmp_path / "other")
    assert identity_of_wheels(one.prefix, one.site_packages) != identity_of_wheels(
        other.prefix, one.site_packages
    )


def test_installed_packages_change_it(tmp_path: Path) -> None:
    installed(tmp_path)
    seen = {identity_of_prefixes([tmp_path], "python3.11"), identity_of_prefixes([tmp_path], "python3.12")}
    os.utime(tmp_path / "share/rclpy/package.xml", (1, 1))
    seen.add(identity_of_prefixes([tmp_path], "python3.11"))
    register(tmp_path, "nav_msgs")
    seen.add(identity_of_prefixes([tmp_path], "python3.11"))
    assert len(seen) == 4


def test_the_room_is_light_to_import() -> None:
    """Every command imports it; rclpy alone would take a tenth of a second, and numpy another one."""
    code = "import sys, course.rosenv; print(*sys.modules)"
    environ = {**os.environ, "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1"}
    command = [sys.executable, "-c", code]
    root = Path(__file__).parents[2]
    loaded = subprocess.run(command, env=environ, cwd=root, capture_output=True, check=True, text=True).stdout
    assert "course.rosenv.find" in loaded.split()
    assert {"rclpy", "numpy", "yaml", "rich", "typer", "pydantic", "importlib.metadata"}.isdisjoint(
        loaded.split()
    )
