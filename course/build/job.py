"""One package's build, as it is handed to whoever carries it out."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from course.build.store import Store
from course.build.workspace import Package, Workspace
from course.rosenv import Ros


class SourcesChanged(Exception):
    """What was copied is not what was hashed: someone saved a file in between."""


@dataclass(frozen=True)
class Job:
    """All that one build needs. `needed` and `overlays`: keys and prefixes of the packages it depends on."""

    package: Package
    workspace: Workspace
    key: str
    needed: tuple[str, ...]
    overlays: tuple[Path, ...]
    ros: Ros
    store: Store
    time_limit: float
    on_progress: Callable[[str], None]
