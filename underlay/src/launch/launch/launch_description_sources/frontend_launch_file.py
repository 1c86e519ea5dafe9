"""Launch files in XML and YAML."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from launch.absent import NotOfferedError
from launch.frontend.entity import Entity
from launch.frontend.parser import load_description
from launch.frontend.xml_entity import load_xml
from launch.frontend.yaml_entity import load_yaml
from launch.invalid_launch_file_error import InvalidLaunchFileError
from launch.launch_description import LaunchDescription

_Loader = Callable[[Path], Entity]
_BY_SUFFIX: dict[str, _Loader] = {".xml": load_xml, ".yaml": load_yaml, ".yml": load_yaml}


def get_launch_description_from_frontend_launch_file(launch_file_path: str) -> LaunchDescription:
    """Raises InvalidLaunchFileError."""
    return loaded(by_name, launch_file_path)


def loaded(load: _Loader, launch_file_path: str) -> LaunchDescription:
    """What the file describes, read in a certain way. Raises InvalidLaunchFileError."""
    try:
        return load_description(load, launch_file_path)
    except NotOfferedError:
        raise
    except Exception as error:
        suffix = Path(launch_file_path).suffix[1:]
        raise InvalidLaunchFileError(suffix or "launch", likely_errors=[error]) from error


def by_name(path: Path) -> Entity:
    """A file whose name tells neither is read as XML if it looks like it, else as YAML."""
    if path.suffix in _BY_SUFFIX:
        return _BY_SUFFIX[path.suffix](path)
    load = load_xml if path.read_bytes().lstrip().startswith(b"<") else load_yaml
    return load(path)
