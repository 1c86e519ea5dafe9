"""Files that launch descriptions come from."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "AnyLaunchDescriptionSource": "any_launch_description_source",
    "FrontendLaunchDescriptionSource": "frontend_launch_description_source",
    "InvalidPythonLaunchFileError": "python_launch_file",
    "PythonLaunchDescriptionSource": "python_launch_description_source",
    "get_launch_description_from_any_launch_file": "any_launch_file",
    "get_launch_description_from_frontend_launch_file": "frontend_launch_file",
    "get_launch_description_from_python_launch_file": "python_launch_file",
    "load_python_launch_file_as_module": "python_launch_file",
}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES)
