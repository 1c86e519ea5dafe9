"""A parameter file that several nodes are given."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class SharedFile:
    """For nodes of a name, or for all if that is None."""

    path: str
    node_name: str | None

    def is_for(self, full_name: str) -> bool:
        """`full_name` is `/namespace/name`, or `/**` for a node whose name the launch file does not say."""
        return self.node_name in (None, full_name, full_name.rpartition("/")[2])
