"""Recordings as MCAP files, which Foxglove, PlotJuggler and rosbag2 open too.

ROS messages are kept as they came over the wire, one channel a topic (and one more for what
the arena sent there); all other events are JSON on one channel. The learner's files and what
was built are attachments.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from dataclasses import asdict
from io import BytesIO
from pathlib import Path
from typing import Any

from course.errors import StorageError
from course.evidence import event_json
from course.evidence.events import Event, MessageSeen, MessageSent
from course.evidence.packages import BuiltPackages, packages_from_dict
from course.evidence.recording import Recording
from course.evidence.sources import Sources

EVENTS = "/ros2course/events"
_NAME = "ros2course"
_VERSION = "1"
_NANO = 1_000_000_000


class BadRecording(ValueError):
    """The file is no recording of the course, or a damaged one."""


def save(recording: Recording, file: Path, *, began_ns: int) -> None:
    """Write `file` (beside it first, then renamed).

    began_ns: wall-clock time of the recording's start, in ns since 1970; readers of MCAP want
    dates. Raises StorageError when the file cannot be written.
    """
    beside = file.with_name(f".{file.name}.{os.getpid()}")
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        beside.write_bytes(_packed(recording, began_ns))
        beside.replace(file)
    except OSError as error:
        beside.unlink(missing_ok=True)
        raise StorageError(f"The recording could not be kept: {error.strerror}.") from error


def load(file: Path) -> Recording:
    """Read a recording back. Raises BadRecording when it is none."""
    from mcap.exceptions import McapError
    from mcap.reader import make_reader

    try:
        with file.open("rb") as stream:
            return _unpacked(make_reader(stream))
    except (McapError, KeyError, TypeError, ValueError) as error:
        raise BadRecording(f"{file}: {error}") from error


def _packed(recording: Recording, began_ns: int) -> bytes:
    from mcap.writer import Writer

    buffer = BytesIO()
    writer = Writer(buffer)
    writer.start(profile="ros2", library=_NAME)
    writer.add_metadata(_NAME, {"version": _VERSION, "exercise": recording.exercise, "began": str(began_ns)})
    for name, data in _attachments(recording).items():
        writer.add_attachment(began_ns, began_ns, name, "application/json", json.dumps(data).encode())
    channels = _Channels(writer, recording)
    for event in recording.events:
        at = began_ns + round(event.t * _NANO)
        channel, data = channels.of(event)
        writer.add_message(channel, at, data, at)
    writer.finish()  # type: ignore[no-untyped-call]
    return buffer.getvalue()


def _attachments(recording: Recording) -> dict[str, Any]:
    return {
        "sources.json": asdict(recording.sources),
        "packages.json": asdict(recording.packages),
        "recording.json": {"duration": recording.duration},
    }


class _Channels:
    """Registers a channel the first time that an event needs it."""

    def __init__(self, writer: Any, recording: Recording) -> None:
        self._writer = writer
        self._definitions = recording.definitions
        self._known: dict[tuple[str, str, bool], int] = {}
        self._events: int | None = None

    def of(self, event: Event) -> tuple[int, bytes]:
        """The channel for this event, and its bytes there."""
        if isinstance(event, MessageSeen | MessageSent):
            return self._ros(event.topic, event.type, isinstance(event, MessageSent)), event.data
        if self._events is None:
            schema = self._writer.register_schema("ros2course.Event", "jsonschema", b'{"type": "object"}')
            self._events = self._writer.register_channel(EVENTS, "json", schema)
        return self._events, json.dumps(event_json.to_dict(event)).encode()

    def _ros(self, topic: str, type_name: str, sent: bool) -> int:
        key = (topic, type_name, sent)
        if key not in self._known:
            schema = self._writer.register_schema(type_name, "ros2msg", self._definitions[type_name].encode())
            about = {_NAME: "sent" if sent else "seen"}
            self._known[key] = self._writer.register_channel(topic, "cdr", schema, about)
        return self._known[key]


def _unpacked(reader: Any) -> Recording:
    about = {item.name: item.metadata for item in reader.iter_metadata()}[_NAME]
    if about["version"] != _VERSION:
        raise ValueError(f"version {about['version']} of recordings is not known here")
    parts = {item.name: json.loads(item.data) for item in reader.iter_attachments()}
    began = int(about["began"])
    definitions: dict[str, str] = {}
    events = tuple(_events(reader, began, definitions))
    sources = Sources(parts["sources.json"]["files"], tuple(parts["sources.json"]["others"]))
    packages: BuiltPackages = packages_from_dict(parts["packages.json"])
    return Recording(
        about["exercise"], events, definitions, sources, packages, parts["recording.json"]["duration"]
    )


def _events(reader: Any, began: int, definitions: dict[str, str]) -> Iterator[Event]:
    for schema, channel, message in reader.iter_messages():
        if channel.topic == EVENTS:
            yield event_json.from_dict(json.loads(message.data))
            continue
        definitions[schema.name] = schema.data.decode()
        kind = MessageSent if channel.metadata.get(_NAME) == "sent" else MessageSeen
        yield kind((message.log_time - began) / _NANO, channel.topic, schema.name, message.data)
