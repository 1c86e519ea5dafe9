"""Files that launch descriptions come from."""

from __future__ import annotations

from launch._lazy import lazily

_INSTEAD = "launch files in XML and YAML are not; write it in Python, or install ROS 2 (ros-jazzy-launch-xml)"
_NAMES = {
    "AnyLaunchDescriptionSource": "any_launch_description_source",
    "InvalidPythonLaunchFileError": "python_launch_file",
    "PythonLaunchDescriptionSource": "python_launch_description_source",
    "get_launch_description_from_any_launch_file": "any_launch_file",
    "get_launch_description_from_python_launch_file": "python_launch_file",
    "load_python_launch_file_as_module": "python_launch_file",
}
_ABSENT = {
    name: _INSTEAD
    for name in (
        "FrontendLaunchDescriptionSource",
        "XMLLaunchDescriptionSource",
        "YAMLLaunchDescriptionSource",
    )
}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES, _ABSENT)
