"""The variables that a process needs to use ROS; our children and setup.bash use the same list for wheels."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from course.rosenv.ros import Ros
from course.rosenv.underlay import site_packages

PROFILE = Path(__file__).with_name("fastdds_profile.xml")


def discovery_values(profile: Path) -> dict[str, str]:
    """Variables for Fast DDS; `profile` is the file with our discovery settings.

    Shared memory is left out: it loses messages between processes that see different /dev/shm, such as one
    in a sandbox and one outside.
    """
    return {"FASTDDS_BUILTIN_TRANSPORTS": "UDPv4", "FASTRTPS_DEFAULT_PROFILES_FILE": str(profile)}


DISTRO = "jazzy"

# The path variables that make up a ROS environment. Everything else that a setup script sets is left out.
PREFIXES = ("AMENT_PREFIX_PATH", "CMAKE_PREFIX_PATH")
LISTS = (*PREFIXES, "LD_LIBRARY_PATH", "PATH", "PKG_CONFIG_PATH", "PYTHONPATH")


@dataclass(frozen=True)
class Variables:
    """`lists` are path variables, to put in front of existing entries; `values` replace existing ones."""

    lists: Mapping[str, tuple[str, ...]]
    values: Mapping[str, str]


def wheel_variables(ros: Ros, underlay: Path) -> Variables:
    """The variables for the wheels' prefix and, on top of it, the prefix that offers our own packages."""
    prefix, packages = str(ros.prefix), ros.python_packages
    # The wheels' own site-packages are needed only by a Python outside their environment.
    foreign = (str(packages),) if _serves_system_python(packages) else ()
    lists = {
        "AMENT_PREFIX_PATH": (str(underlay), prefix),
        "CMAKE_PREFIX_PATH": (str(underlay), prefix),
        "LD_LIBRARY_PATH": (f"{underlay}/lib", f"{prefix}/lib", *_bundled_libraries(packages)),
        "PATH": (f"{underlay}/bin", f"{prefix}/bin"),
        "PYTHONPATH": (str(site_packages(underlay, ros)), *foreign),
    }
    # CMake looks for Python in $VIRTUAL_ENV first, and the caller may be in another one.
    is_virtual = (ros.prefix / "pyvenv.cfg").exists()
    return Variables(lists, {**ros_values(ros.distro), **({"VIRTUAL_ENV": prefix} if is_virtual else {})})


def ros_values(distro: str) -> dict[str, str]:
    """What every ROS 2 sets, and a variable that keeps a Python with ROS wheels from starting twice."""
    return {
        "ROS_DISTRO": distro,
        "ROS_VERSION": "2",
        "ROS_PYTHON_VERSION": "3",
        "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1",
    }


def _bundled_libraries(packages: Path) -> tuple[str, ...]:
    # The wheels' own startup code lists these in an order that varies from run to run; ours must not.
    return tuple(str(folder) for folder in sorted(packages.glob("ros_*.libs")))


def _serves_system_python(packages: Path) -> bool:
    """Whether /usr/bin/python3, which scripts may use, has the version that these packages are made for."""
    return Path("/usr/bin/python3").resolve().name == packages.parent.name
