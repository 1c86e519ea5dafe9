"""Launch files in XML. What reads them is part of `launch`; here are the names that it goes by."""

from launch.frontend.xml_entity import XmlEntity as Entity

__all__ = ["Entity"]
