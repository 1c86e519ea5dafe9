# ruff: noqa: F401
"""Names that tutorials and packages import; what is absent does no harm where it is not used."""

import launch
import launch.actions
import launch.conditions
import launch.event_handlers
import launch.events
import launch.events.process
import launch.frontend
import launch.launch_description_sources
import launch.substitutions
import launch_ros
import launch_ros.actions
import launch_ros.descriptions
import launch_ros.event_handlers
import launch_ros.events
import launch_ros.events.lifecycle
import launch_ros.substitutions
from launch import LaunchContext, LaunchDescription, LaunchService, SomeSubstitutionsType, Substitution
from launch.action import Action
from launch.actions import ExecuteLocal, LogInfo, OpaqueCoroutine, SetLaunchConfiguration
from launch.conditions import IfCondition
from launch.descriptions import Executable
from launch.event_handlers import OnIncludeLaunchDescription
from launch.frontend import Entity, Parser, expose_action, expose_substitution
from launch.launch_description_sources import (
    AnyLaunchDescriptionSource,
    FrontendLaunchDescriptionSource,
    PythonLaunchDescriptionSource,
)
from launch.substitutions import FileContent, ThisLaunchFile
from launch.utilities import is_a, normalize_to_list_of_substitutions, perform_substitutions
from launch.utilities.type_utils import normalize_typed_substitution, perform_typed_substitution
from launch_ros.actions import (
    ComposableNodeContainer,
    LifecycleNode,
    LoadComposableNodes,
    Node,
    PushROSNamespace,
    RosTimer,
    SetROSLogDir,
)
from launch_ros.descriptions import ComposableNode, ParameterFile, ParameterValue
from launch_ros.event_handlers import OnStateTransition
from launch_ros.events.lifecycle import ChangeState
from launch_ros.parameter_descriptions import Parameter
from launch_ros.remap_rule_type import SomeRemapRules
from launch_ros.substitutions import ExecutableInPackage, FindPackagePrefix, FindPackageShare
from launch_xml.launch_description_sources import XMLLaunchDescriptionSource
from launch_yaml.launch_description_sources import YAMLLaunchDescriptionSource


class Upper(Substitution):
    """As packages write their own."""

    def __init__(self, text: SomeSubstitutionsType) -> None:
        super().__init__()
        self._text = normalize_to_list_of_substitutions(text)

    def perform(self, context: LaunchContext) -> str:
        return perform_substitutions(context, self._text).upper()


class Said(Action):
    """As packages write their own."""

    def execute(self, context: LaunchContext) -> None:
        launch.logging.get_logger("mine").info("said")


def generate_launch_description():
    composed = launch.substitutions.LaunchConfiguration("composed", default="false")
    return LaunchDescription(
        [
            LogInfo(msg=Upper(["a", "b"])),
            Said(),
            ComposableNodeContainer(
                name="container",
                namespace="",
                package="rclcpp_components",
                executable="component_container",
                composable_node_descriptions=[ComposableNode(package="p", plugin="p::N", name="n")],
                condition=IfCondition(composed),
            ),
            LoadComposableNodes(
                target_container="c", composable_node_descriptions=[], condition=IfCondition(composed)
            ),
            launch_ros.actions.LifecycleNode(
                package="p", executable="e", name="n", namespace="", condition=IfCondition(composed)
            ),
            LogInfo(msg=ExecutableInPackage(package="telling", executable="tell")),
        ]
    )
