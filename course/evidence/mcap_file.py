"""Recordings as MCAP files, which Foxglove, PlotJuggler and rosbags open too.

ROS messages are kept as they came over the wire, one channel a topic (and one more for what
the arena sent there); every other event is a text of JSON on one channel, in a message
type that the file defines: so whoever reads ROS messages can read all of it. The learner's files and
what was built are attachments.
"""

from __future__ import annotations

import contextlib
import json
import os
import struct
from collections.abc import Iterator, Mapping
from dataclasses import asdict
from io import BytesIO
from pathlib import Path
from typing import Any

from course.errors import StorageError
from course.evidence import event_json
from course.evidence.events import Event, MessageSeen, MessageSent
from course.evidence.home_files import HomeEntry
from course.evidence.packages import packages_from_dict
from course.evidence.recording import Recording
from course.evidence.sources import Sources

EVENTS = "/ros2course/events"
_NAME = "ros2course"
_VERSION = "1"
_ROS = "ros2msg"
_EVENT = "ros2course/msg/Event"
_EVENT_FIELDS = "string json\n"
_CDR = b"\0\1\0\0"  # little endian
_NANO = 1_000_000_000


class BadRecording(ValueError):
    """The file is no recording of the course, or a damaged one."""


class OtherFormat(BadRecording):
    """The file is whole, and a recording, but not as this version of the course writes them."""


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
        with contextlib.suppress(OSError):
            beside.unlink()
        raise StorageError(f"The recording could not be kept: {error.strerror}.") from error


def load(file: Path) -> Recording:
    """Read a recording back.

    Raises BadRecording when it is none, OtherFormat when it is of another version, StorageError when it
    cannot be read.
    """
    try:
        data = file.read_bytes()
    except OSError as error:
        raise StorageError(f"The recording {file} could not be read: {error.strerror}.") from error
    try:
        records = tuple(_records(data))
        about = _about(records)
    except Exception as error:
        # The libraries below raise whatever their parsing of a damaged file ran into.
        raise BadRecording(f"{file}: {error}") from error
    try:
        return _unpacked(records, about)
    except Exception as error:  # the checksums are right, so what is not understood was written otherwise
        raise OtherFormat(f"{file}: {type(error).__name__}: {error}") from error


def _packed(recording: Recording, began_ns: int) -> bytes:
    from mcap.writer import Writer

    buffer = BytesIO()
    writer = Writer(buffer, enable_data_crcs=True)
    writer.start(profile="ros2", library=_NAME)
    about = {"exercise": recording.exercise, "began": str(began_ns), "scenario": recording.scenario}
    writer.add_metadata(_NAME, {"version": _VERSION, **about})
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
        "home.json": [asdict(entry) for entry in recording.looked_at],
        "recording.json": {"duration": recording.duration, "local": recording.local},
    }


class _Channels:
    """Registers a channel the first time that an event needs it."""

    def __init__(self, writer: Any, recording: Recording) -> None:
        self._writer = writer
        self._schemas = {
            name: writer.register_schema(name, _ROS, text.encode())
            for name, text in recording.definitions.items()
        }
        self._known: dict[tuple[str, str, bool], int] = {}
        self._events: int | None = None

    def of(self, event: Event) -> tuple[int, bytes]:
        """The channel for this event, and its bytes there."""
        if isinstance(event, MessageSeen | MessageSent):
            return self._ros(event.topic, event.type, isinstance(event, MessageSent)), event.data
        if self._events is None:
            schema = self._writer.register_schema(_EVENT, _ROS, _EVENT_FIELDS.encode())
            self._events = self._writer.register_channel(EVENTS, "cdr", schema)
        return self._events, _text(json.dumps(event_json.to_dict(event), allow_nan=False))

    def _ros(self, topic: str, type_name: str, sent: bool) -> int:
        key = (topic, type_name, sent)
        if key not in self._known:
            about = {_NAME: "sent" if sent else "seen"}
            schema = self._schemas[type_name]
            self._known[key] = self._writer.register_channel(topic, "cdr", schema, about)
        return self._known[key]


def _text(text: str) -> bytes:
    """A message with one string in it."""
    data = text.encode() + b"\0"
    return _CDR + struct.pack("<I", len(data)) + data


def _records(data: bytes) -> Iterator[Any]:
    """The file's records in their order, all covered by checksums; without the index at its end."""
    from mcap.records import DataEnd
    from mcap.stream_reader import StreamReader

    for record in StreamReader(BytesIO(data), validate_crcs=True).records:
        if isinstance(record, DataEnd):
            return
        yield record
    raise ValueError("the end of the data is missing")


def _about(records: tuple[Any, ...]) -> dict[str, str]:
    from mcap.records import Metadata

    found = (r.metadata for r in records if isinstance(r, Metadata) and r.name == _NAME)
    about: dict[str, str] | None = next(found, None)
    if about is None:
        raise ValueError("this is no recording of the course")
    return about


def _unpacked(records: tuple[Any, ...], about: Mapping[str, str]) -> Recording:
    from mcap.records import Attachment, Schema

    if about["version"] != _VERSION:
        raise ValueError(f"version {about['version']} of recordings is not known here")
    parts = {r.name: json.loads(r.data) for r in records if isinstance(r, Attachment)}
    schemas = [r for r in records if isinstance(r, Schema)]
    return Recording(
        exercise=about["exercise"],
        events=tuple(_events(records, {schema.id: schema.name for schema in schemas}, int(about["began"]))),
        definitions={schema.name: schema.data.decode() for schema in schemas if _is_ros(schema)},
        sources=Sources(parts["sources.json"]["files"], tuple(parts["sources.json"]["others"])),
        packages=packages_from_dict(parts["packages.json"]),
        duration=parts["recording.json"]["duration"],
        looked_at=tuple(HomeEntry(**entry) for entry in parts["home.json"]),
        local=parts["recording.json"]["local"],
        scenario=about.get("scenario", ""),  # recordings of before have none
    )


def _is_ros(schema: Any) -> bool:
    return bool(schema.encoding == _ROS and schema.name != _EVENT)


def _events(records: tuple[Any, ...], types: Mapping[int, str], began: int) -> Iterator[Event]:
    from mcap.records import Channel, Message

    channels = {record.id: record for record in records if isinstance(record, Channel)}
    for message in records:
        if isinstance(message, Message):
            yield _event(message, channels[message.channel_id], types, began)


def _event(message: Any, channel: Any, types: Mapping[int, str], began: int) -> Event:
    if channel.topic == EVENTS:
        # In recordings of before they are JSON itself.
        plain = message.data if channel.message_encoding == "json" else message.data[len(_CDR) + 4 : -1]
        return event_json.from_dict(json.loads(plain))
    kind = MessageSent if channel.metadata.get(_NAME) == "sent" else MessageSeen
    return kind((message.log_time - began) / _NANO, channel.topic, types[channel.schema_id], message.data)
