"""Tags and substitutions about ROS in launch files in XML and YAML."""

from __future__ import annotations

from launch.substitution import Substitution

from launch_ros import substitutions as kinds
from launch_ros.frontend.absent_tags import ABSENT_TAGS
from launch_ros.frontend.node_tag import node
from launch_ros.frontend.scope_tags import SCOPE_TAGS

__all__ = ["SUBSTITUTIONS", "TAGS"]

_Text = list[Substitution]


def _executable(executable: _Text, package: _Text) -> Substitution:
    return kinds.ExecutableInPackage(executable=executable, package=package)


SUBSTITUTIONS = {
    "exec-in-pkg": _executable,
    "find-pkg-prefix": lambda package: kinds.FindPackagePrefix(package),
    "find-pkg-share": lambda package: kinds.FindPackageShare(package),
    "param": lambda name, default=None: kinds.Parameter(name, default=default),
}
TAGS = {**ABSENT_TAGS, **SCOPE_TAGS, "node": node}
