"""Launch files in YAML. What reads them is part of `launch`; here are the names that it goes by."""

from launch.frontend.yaml_entity import YamlEntity as Entity

__all__ = ["Entity"]
