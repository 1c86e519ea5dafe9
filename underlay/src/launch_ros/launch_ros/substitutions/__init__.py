"""Texts about ROS packages and parameters."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "ExecutableInPackage": "executable_in_package",
    "FindPackage": "find_package",
    "FindPackagePrefix": "find_package",
    "FindPackageShare": "find_package",
    "Parameter": "parameter",
}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES)
