"""Stands in for the recorder where an exercise has nothing to do with ROS: no middleware is started."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NoReturn

from course.errors import OurFault
from course.evidence.graph import Graph
from course.evidence.timeline import Timeline


@dataclass(frozen=True)
class NoRos:
    """A recorder that hears nothing."""

    timeline: Timeline
    graph: Graph = field(default_factory=Graph)
    definitions: dict[str, str] = field(default_factory=dict)

    def __getattr__(self, name: str) -> NoReturn:
        if name.startswith("__"):
            raise AttributeError(name)
        raise OurFault(f"a scenario without ROS (`ros=False`) asks for `{name}`")
