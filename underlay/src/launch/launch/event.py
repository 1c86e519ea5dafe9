"""Something that happened."""

from __future__ import annotations


class Event:
    """Events are told apart by their class; `name` is for people."""

    name = "launch.Event"
