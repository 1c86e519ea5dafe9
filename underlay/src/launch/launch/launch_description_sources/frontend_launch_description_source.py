"""A launch file in XML or YAML as a source."""

from __future__ import annotations

from launch.frontend.xml_entity import load_xml
from launch.frontend.yaml_entity import load_yaml
from launch.launch_description import LaunchDescription
from launch.launch_description_source import LaunchDescriptionSource
from launch.launch_description_sources.frontend_launch_file import by_name, loaded


class FrontendLaunchDescriptionSource(LaunchDescriptionSource):
    """The file's name, or else its looks, tell which of them."""

    _load = staticmethod(by_name)

    def __init__(self, launch_file_path: object) -> None:
        super().__init__(None, launch_file_path, "interpreted frontend launch file")

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return loaded(self._load, location)


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """Read as XML, whatever the file is called."""

    _load = staticmethod(load_xml)


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """Read as YAML, whatever the file is called."""

    _load = staticmethod(load_yaml)
