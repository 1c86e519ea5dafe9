"""Parts of what launch files describe."""

from __future__ import annotations

from launch._lazy import lazily

_INSTEAD = "components are C++; install ROS 2 (sudo apt install ros-jazzy-launch-ros)"
_NAMES: dict[str, str] = {}
_ABSENT = {"ComposableNode": _INSTEAD}
__all__: list[str] = []
_find = lazily(__name__, _NAMES, _ABSENT)


def __getattr__(name: str) -> object:
    if name in ("Parameter", "ParameterFile", "ParameterValue"):
        from launch_ros import parameter_descriptions

        return getattr(parameter_descriptions, name)
    return _find(name)
