"""The arguments of a node that follow `--ros-args`, but for its name."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import Any

from launch.launch_context import LaunchContext
from launch.logging import get_logger
from launch.utilities import perform_substitutions

from launch_ros.utilities.parameter_values import evaluate_parameters
from launch_ros.utilities.parameter_yaml import file_text, rule
from launch_ros.utilities.remap_forms import RemapRule
from launch_ros.utilities.shared_file import SharedFile
from launch_ros.utilities.temporary_files import temporary_file


class NodeArguments:
    """What SetParameter and SetRemap said for all nodes comes first, so that the node's own wins."""

    def __init__(
        self,
        context: LaunchContext,
        node_name: str | None,
        parameters: Iterable[Any],
        remappings: Iterable[RemapRule],
    ) -> None:
        self._context = context
        self._node_name = node_name or "/**"
        own = evaluate_parameters(context, parameters)
        everyones = context.launch_configurations.get("global_params", [])
        self.remappings = self._rules(remappings)
        words = [word for each in [*everyones, *own] for word in self._parameter(each)]
        self.words = words + [word for rule in self.remappings for word in ("-r", ":=".join(rule))]

    def _rules(self, remappings: Iterable[RemapRule]) -> list[tuple[str, str]]:
        own = [
            (perform_substitutions(self._context, src), perform_substitutions(self._context, dst))
            for src, dst in remappings
        ]
        return [*self._context.launch_configurations.get("ros_remaps", []), *own]

    def _parameter(self, given: Any) -> list[str]:
        if isinstance(given, tuple):
            return ["-p", rule(*given)]
        if isinstance(given, SharedFile):
            return self._file(Path(given.path)) if given.is_for(self._node_name) else []
        if isinstance(given, dict):
            given = temporary_file(file_text(self._node_name, given))
        return self._file(Path(given))

    def _file(self, path: Path) -> list[str]:
        if path.is_file():
            return ["--params-file", str(path)]
        get_logger("launch_ros").warning(f"Parameter file path is not a file: {path}")
        return []
