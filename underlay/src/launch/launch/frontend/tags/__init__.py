"""The tags of launch files in XML and YAML, and what each of them stands for."""

from __future__ import annotations

from launch.frontend.tags import control, processes, values

TAGS = {**control.TAGS, **processes.TAGS, **values.TAGS}
