"""A launch file in XML as a source."""

from launch.launch_description_sources.frontend_launch_description_source import XMLLaunchDescriptionSource

__all__ = ["XMLLaunchDescriptionSource"]
