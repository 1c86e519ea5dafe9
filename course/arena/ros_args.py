"""Arguments after `--ros-args`: parameters, remappings and a node's name, quoted as ROS reads them."""

from __future__ import annotations

import json
from collections.abc import Mapping
from math import isinf, isnan

Scalar = bool | int | float | str
ParameterValue = Scalar | list[bool] | list[int] | list[float] | list[str]


def ros_args(
    params: Mapping[str, ParameterValue] | None = None,
    remaps: Mapping[str, str] | None = None,
    node_name: str | None = None,
) -> tuple[str, ...]:
    """`--ros-args -p name:=value -r from:=to -r __node:=name`; nothing when nothing is given."""
    given = [("-p", f"{name}:={parameter_text(value)}") for name, value in (params or {}).items()]
    given += [("-r", f"{old}:={new}") for old, new in (remaps or {}).items()]
    given += [("-r", f"__node:={node_name}")] if node_name else []
    return ("--ros-args", *(word for pair in given for word in pair)) if given else ()


def parameter_text(value: ParameterValue) -> str:
    """A value in the YAML that rcl reads. A string stays one, whatever it looks like."""
    if isinstance(value, list):
        return f"[{', '.join(map(_scalar, value))}]"
    return _scalar(value)


def _scalar(value: Scalar) -> str:
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)  # a string in double quotes means the same in YAML
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float) and (isnan(value) or isinf(value)):
        return ".nan" if isnan(value) else "-.inf" if value < 0 else ".inf"
    return repr(value)
