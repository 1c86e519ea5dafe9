"""Texts that are only known when the launch runs."""

from __future__ import annotations

from launch._lazy import lazily

_NAMES = {
    "AllSubstitution": "boolean_substitution",
    "AndSubstitution": "boolean_substitution",
    "AnonName": "anon_name",
    "AnySubstitution": "boolean_substitution",
    "Command": "command",
    "EnvironmentVariable": "environment_variable",
    "EqualsSubstitution": "equals_substitution",
    "FileContent": "file_content",
    "FindExecutable": "find_executable",
    "ForEachVar": "for_substitutions",
    "ForLoopIndex": "for_substitutions",
    "IfElseSubstitution": "if_else_substitution",
    "LaunchConfiguration": "launch_configuration",
    "LaunchLogDir": "launch_log_dir",
    "LocalSubstitution": "local_substitution",
    "NotEqualsSubstitution": "equals_substitution",
    "NotSubstitution": "boolean_substitution",
    "OrSubstitution": "boolean_substitution",
    "PathJoinSubstitution": "path_join_substitution",
    "PathSubstitution": "path_join_substitution",
    "PythonExpression": "python_expression",
    "StringJoinSubstitution": "string_join_substitution",
    "SubstitutionFailure": "substitution_failure",
    "TextSubstitution": "text_substitution",
    "ThisLaunchFile": "this_launch_file",
    "ThisLaunchFileDir": "this_launch_file_dir",
}
__all__ = list(_NAMES)
__getattr__ = lazily(__name__, _NAMES)
