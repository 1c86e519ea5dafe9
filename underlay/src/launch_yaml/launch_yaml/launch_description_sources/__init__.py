"""A launch file in YAML as a source."""

from launch.launch_description_sources.frontend_launch_description_source import YAMLLaunchDescriptionSource

__all__ = ["YAMLLaunchDescriptionSource"]
