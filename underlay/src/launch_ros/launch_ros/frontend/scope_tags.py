"""Tags about what all nodes that follow have in common."""

from __future__ import annotations

from typing import Any

from launch.frontend.entity import Entity

from launch_ros import actions
from launch_ros.frontend.node_tag import value_of


def _push_ros_namespace(entity: Entity, parser: Any) -> Any:
    namespace = parser.parse_substitution(entity.get_attr("namespace"))
    return actions.PushROSNamespace, {"namespace": namespace}


def _set_parameter(entity: Entity, parser: Any) -> Any:
    name = parser.parse_substitution(entity.get_attr("name"))
    return actions.SetParameter, {"name": tuple(name), "value": value_of(entity, parser)}


def _set_parameters_from_file(entity: Entity, parser: Any) -> Any:
    node = entity.get_attr("node_name", optional=True)
    return actions.SetParametersFromFile, {
        "filename": parser.parse_substitution(entity.get_attr("filename")),
        "node_name": None if node is None else parser.parse_substitution(node),
    }


def _set_remap(entity: Entity, parser: Any) -> Any:
    return actions.SetRemap, {
        "src": parser.parse_substitution(entity.get_attr("from")),
        "dst": parser.parse_substitution(entity.get_attr("to")),
    }


def _set_use_sim_time(entity: Entity, parser: Any) -> Any:
    return actions.SetUseSimTime, {"value": value_of(entity, parser)}


def _set_ros_log_dir(entity: Entity, parser: Any) -> Any:
    return actions.SetROSLogDir, {"new_log_dir": parser.parse_substitution(entity.get_attr("new_log_dir"))}


SCOPE_TAGS = {
    "push-ros-namespace": _push_ros_namespace,
    "push_ros_namespace": _push_ros_namespace,
    "set_parameter": _set_parameter,
    "set_parameters_from_file": _set_parameters_from_file,
    "set_remap": _set_remap,
    "set_ros_log_dir": _set_ros_log_dir,
    "set_use_sim_time": _set_use_sim_time,
}
