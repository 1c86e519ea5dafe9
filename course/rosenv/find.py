"""Finds the one ROS 2 that the course uses: a sourced one, /opt/ros/jazzy, or the pip wheels; never two."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from course.errors import MissingHere
from course.model import replace
from course.rosenv.host import Host, why_no_wheels
from course.rosenv.paths import has_rclpy, sourced_prefixes, split
from course.rosenv.ros import Origin, Ros, digest, identity_of_prefixes, identity_of_wheels, python_folders
from course.rosenv.underlay import fingerprint, packages_in, source_root
from course.rosenv.variables import DISTRO

_SET_UP = (
    "Let the course install ROS 2: ./ros2course next (in the course's folder), or, in an environment of your "
    "own: pip install '.[jazzy]'. If a ROS 2 is installed elsewhere, source its setup.bash first."
)


def find_ros(environ: Mapping[str, str] | None = None, host: Host | None = None) -> Ros:
    """The ROS 2 to use here. Raises MissingHere, with advice, if there is none or it does not fit."""
    environ = os.environ if environ is None else environ
    host = host or Host.here()
    ros = _sourced(environ, host) or _installed(environ, host) or _pip(host)
    if ros is None:
        raise why_no_wheels(host) or MissingHere("There is no ROS 2 on this machine yet.", _SET_UP)
    return ros


def _sourced(environ: Mapping[str, str], host: Host) -> Ros | None:
    sourced, distro = sourced_prefixes(environ), environ.get("ROS_DISTRO")
    if sourced is None or not distro:
        return None
    if _holds_wheels(sourced.rclpy):
        # Our own setup.bash was sourced, or one from another copy of the course: nobody chose that ROS.
        return _pip(host)
    packages = _rclpy_folder(sourced.rclpy, host)
    if packages is None:
        return None
    if not _fits(packages, host):
        raise _misfit(sourced.rclpy, packages, host)
    ros = _at(sourced.rclpy, "sourced", packages, sourced.kept, environ)
    return replace(ros, distro=distro, notes=_notes(distro))


def _installed(environ: Mapping[str, str], host: Host) -> Ros | None:
    prefix = host.installed
    packages = _rclpy_folder(prefix, host)
    if packages is None or not has_rclpy(prefix) or not (prefix / "setup.bash").exists():
        return None
    if _fits(packages, host):
        return _at(prefix, "installed", packages, (prefix,), environ)
    # The course was set up with pip before this ROS was installed, and must keep working.
    if wheels := _pip(host):
        note = f"{prefix} is not used: it is for {_version(packages)}, this is Python {host.python_version}."
        return replace(wheels, notes=(note,))
    raise _misfit(prefix, packages, host)


def _pip(host: Host) -> Ros | None:
    if not _has_wheel(host.site_packages, "ros_rclpy"):
        return None
    if not _has_wheel(host.site_packages, "ros_rmw_fastrtps_cpp"):
        raise MissingHere(
            f"ROS 2 in {host.prefix} has no middleware, so its nodes cannot talk.",
            f"Run: {host.executable} -m pip install 'ros-rclpy[fastrtps]==7.1.6'",
        )
    own, root = host.prefix / "bin" / "python3", source_root()
    packages = packages_in(root) if root else ()
    compiled = fingerprint(package for package in packages if package.compiled) if packages else ""
    return Ros(
        origin="pip",
        distro=DISTRO,
        prefix=host.prefix,
        python=own if own.exists() else host.executable,
        identity=identity_of_wheels(host.prefix, host.site_packages, compiled),
        site_packages=host.site_packages,
        underlay=digest([compiled, fingerprint(package for package in packages if not package.compiled)]),
    )


def _at(
    prefix: Path, origin: Origin, packages: Path, prefixes: tuple[Path, ...], environ: Mapping[str, str]
) -> Ros:
    return Ros(
        origin=origin,
        distro=DISTRO,
        prefix=prefix,
        python=_interpreter(prefix, _version(packages), environ),
        identity=identity_of_prefixes(prefixes, _version(packages)),
        site_packages=packages,
    )


def _rclpy_folder(prefix: Path, host: Host) -> Path | None:
    """The folder of the prefix from which rclpy is imported, preferably one for this Python."""
    folders = [folder for folder in python_folders(prefix) if (folder / "rclpy").exists()]
    return next((folder for folder in folders if _fits(folder, host)), folders[0] if folders else None)


def _version(packages: Path) -> str:
    """`python3.12` for `.../lib/python3.12/site-packages`."""
    return packages.parent.name


def _fits(packages: Path, host: Host) -> bool:
    return _version(packages) == f"python{host.python_version}"


def _interpreter(prefix: Path, name: str, environ: Mapping[str, str]) -> Path:
    """The Python for nodes: ROS's own (conda has one), else the system's, else one on the PATH."""
    folders = [str(prefix / "bin"), "/usr/bin", *split(environ.get("PATH"))]
    candidates = (Path(folder) / name for folder in folders)
    found = next((path for path in candidates if os.access(path, os.X_OK) and path.is_file()), None)
    if found is None:
        what = f"ROS 2 in {prefix} needs {name}, which is not on this machine."
        raise MissingHere(what, f"Run: sudo apt install {name}")
    return found


def _has_wheel(site_packages: Path, name: str) -> bool:
    return next(site_packages.glob(f"{name}-*.dist-info"), None) is not None


def _holds_wheels(prefix: Path) -> bool:
    return any(_has_wheel(folder, "ros_rclpy") for folder in python_folders(prefix))


def _notes(distro: str) -> tuple[str, ...]:
    if distro == DISTRO:
        return ()
    return (f"The ROS 2 that is sourced is {distro}; the course is made for {DISTRO}.",)


def _misfit(prefix: Path, packages: Path, host: Host) -> MissingHere:
    return MissingHere(
        f"ROS 2 in {prefix} is for {_version(packages)}; the course runs on Python {host.python_version}.",
        f"Set the course up again for {_version(packages)}: in the course's folder, remove .venv, "
        "then run ./ros2course next",
    )
