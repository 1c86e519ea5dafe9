"""Start a ROS node."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.action import texts
from launch.actions import ExecuteProcess
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.logging import get_logger
from launch.substitution import Substitution
from launch.substitutions.local_substitution import LocalSubstitution
from launch.utilities import perform_substitutions

from launch_ros.parameter_descriptions import ParameterFile
from launch_ros.substitutions.executable_in_package import ExecutableInPackage
from launch_ros.utilities.interpreter import interpreter_for
from launch_ros.utilities.names import absolute_namespace, full_name, joined_namespace
from launch_ros.utilities.node_arguments import NodeArguments
from launch_ros.utilities.node_count import count_node
from launch_ros.utilities.parameter_forms import normalize_parameters
from launch_ros.utilities.remap_forms import normalize_remap_rules

_NAME = LocalSubstitution("ros_specific_arguments['name']", description="node name")
_NAMESPACE = LocalSubstitution("ros_specific_arguments['ns']", description="node namespace")


class Node(ExecuteProcess):
    """`package` and `executable`, or a program's path as `executable` alone."""

    UNSPECIFIED_NODE_NAME = "<node_name_unspecified>"
    UNSPECIFIED_NODE_NAMESPACE = ""

    def __init__(
        self,
        *,
        executable: object,
        package: object | None = None,
        name: object | None = None,
        namespace: object | None = None,
        exec_name: object | None = None,
        parameters: Iterable[Any] | None = None,
        remappings: Iterable[Any] | None = None,
        ros_arguments: Iterable[object] | None = None,
        arguments: Iterable[object] | None = None,
        **kwargs: Any,
    ) -> None:
        self.__package = package
        self.__node_executable = executable
        self.__node_name = None if name is None else texts(name)
        self.__node_namespace = None if namespace is None else texts(namespace)
        self.__parameters = normalize_parameters(_listed(parameters)) if parameters is not None else ()
        self.__remappings = normalize_remap_rules(remappings) if remappings is not None else ()
        self.__expanded_name: str | None = None
        self.__expanded_namespace: str | None = None
        self.__final: NodeArguments | None = None
        program = _program(package, executable)
        cmd = [program, *(arguments or ()), "--ros-args", *(ros_arguments or ()), *self._name_arguments()]
        super().__init__(cmd=cmd, name=exec_name, **kwargs)

    def _name_arguments(self) -> list[object]:
        named: list[object] = [] if self.__node_name is None else ["-r", _NAME]
        return named if self.__node_namespace is None else [*named, "-r", _NAMESPACE]

    # -- what others may ask ---------------------------------------------------------------------------

    @property
    def node_package(self) -> object | None:
        return self.__package

    @property
    def node_executable(self) -> object:
        return self.__node_executable

    @property
    def node_name(self) -> str:
        """Namespace and name, once they are known."""
        namespace = self.__expanded_namespace or self.UNSPECIFIED_NODE_NAMESPACE
        name = self.__expanded_name or self.UNSPECIFIED_NODE_NAME
        return full_name(namespace, name)

    @property
    def expanded_node_namespace(self) -> str | None:
        return self.__expanded_namespace

    @property
    def expanded_remapping_rules(self) -> list[tuple[str, str]]:
        return [] if self.__final is None else self.__final.remappings

    def is_node_name_fully_specified(self) -> bool:
        return self.__expanded_name is not None and self.__expanded_namespace is not None

    # -- start -----------------------------------------------------------------------------------------

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Find out the names, write the parameters to a file, then start the process."""
        self._expand_names(context)
        full = self.node_name if self.__expanded_name is not None else None
        self.__final = NodeArguments(context, full, self.__parameters, self.__remappings)
        self._complete_command_line(context)
        if self.is_node_name_fully_specified() and not context.is_shutdown:
            self._warn_of_twins(context)
        return super().execute(context)

    def prepare(self, context: LaunchContext) -> None:
        super().prepare(context)
        description = self.process_description
        if self.__package is None:
            return
        interpreter = interpreter_for(description.program)
        description.interpreter = list(interpreter.command)
        if interpreter.told:
            get_logger(self.name).info(interpreter.told)

    def _expand_names(self, context: LaunchContext) -> None:
        own = self.__node_namespace
        namespace = joined_namespace(
            context.launch_configurations.get("ros_namespace"),
            None if own is None else perform_substitutions(context, own),
        )
        if self.__node_name is not None:
            self.__expanded_name = perform_substitutions(context, self.__node_name)
            _require_plain(self.__expanded_name)
        self.__expanded_namespace = absolute_namespace(namespace) if namespace else ""
        context.extend_locals(
            {
                "ros_specific_arguments": {
                    "name": f"__node:={self.__expanded_name}",
                    "ns": f"__ns:={self.__expanded_namespace or '/'}",
                }
            }
        )

    def _complete_command_line(self, context: LaunchContext) -> None:
        assert self.__final is not None
        pushed: list[str] = []
        if self.__expanded_namespace and self.__node_namespace is None:
            pushed = ["-r", f"__ns:={self.__expanded_namespace}"]
        self.process_description.cmd.extend(texts(part) for part in [*pushed, *self.__final.words])

    def _warn_of_twins(self, context: LaunchContext) -> None:
        count = count_node(context, self.node_name)
        if count > 1:
            get_logger("launch_ros").warning(
                f"there are now at least {count} nodes with the name {self.node_name} created within this "
                "launch context"
            )


def _program(package: object | None, executable: object) -> object:
    return executable if package is None else ExecutableInPackage(executable=executable, package=package)


def _listed(parameters: Any) -> list[Any]:
    """A single one is a mistake that reads well: it is told, as the real one does."""
    if isinstance(parameters, str | dict | Substitution | ParameterFile):
        raise TypeError(f"Expecting list of parameters, got {parameters!r}")
    return list(parameters)


def _require_plain(name: str) -> None:
    if "/" in name:
        raise RuntimeError(f"the node name '{name}' must not contain a slash: that is what namespace= is for")
