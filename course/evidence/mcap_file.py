"""Recordings as MCAP files, which Foxglove, PlotJuggler and rosbag2 can open, too.

ROS messages are stored as they were received, one channel per topic (and a second one for messages that the
arena sent there). Every other event is a JSON text on one channel, in a message type that the file defines,
so any reader of ROS messages can read it. The learner's files and what was built are attachments.
"""

from __future__ import annotations

import re
import shutil
import struct
from collections.abc import Iterator, Mapping
from io import BytesIO
from pathlib import Path
from typing import IO, Any

from msgspec import Struct

from course.errors import StorageError
from course.evidence.home_files import HomeEntry
from course.evidence.packages import BuiltPackages
from course.evidence.recording import Recording
from course.evidence.sources import Sources
from course.files import replacing
from course.model import codec
from course.model.events import AnyEvent, Event, MessageSeen, MessageSent

EVENTS = "/ros2course/events"
_NAME = "ros2course"
_VERSION = "2"
# In version 1 an event's bytes were inside an object, and the deadline of an endpoint without one was null.
# No text can look like either, because quotes in texts are escaped.
_OLD_BYTES = re.compile(rb'\{"base64": ("[^"]*")\}')
_OLD_DEADLINE = re.compile(rb'"deadline": null')
_ROS = "ros2msg"
_EVENT = "ros2course/msg/Event"
_EVENT_FIELDS = "string json\n"
_CDR = b"\0\1\0\0"  # little endian
_NANO = 1_000_000_000


class BadRecording(ValueError):
    """The file is not a recording of the course, or it is damaged."""


class OtherFormat(BadRecording):
    """The file is an intact recording, but in the format of another version of the course."""


def save(recording: Recording, file: Path, *, began_ns: int) -> None:
    """Write `file` (to a temporary name, then renamed).

    began_ns: wall-clock time of the recording's start, in ns since 1970, because readers of MCAP need
    dates. Raises StorageError if the file cannot be written.
    """
    with BytesIO() as stream:
        write(recording, stream, began_ns=began_ns)
        keep(stream, file)


def keep(stream: IO[bytes], file: Path) -> None:
    """Copy a whole stream to `file`, as `save` writes it. Raises StorageError, too."""
    try:
        stream.seek(0)
        with replacing(file) as part, part.open("wb") as copy:
            shutil.copyfileobj(stream, copy)
    except OSError as error:
        raise StorageError(f"The recording could not be kept: {error.strerror}.") from error


def write(recording: Recording, stream: IO[bytes], *, began_ns: int) -> None:
    """Like `save`, but to a stream."""
    from mcap.writer import Writer

    # Not directly to the stream, because MCAP writes a few bytes at a time.
    buffer = BytesIO()
    writer = Writer(buffer, enable_data_crcs=True)
    writer.start(profile="ros2", library=_NAME)
    about = {"exercise": recording.exercise, "began": str(began_ns), "scenario": recording.scenario}
    writer.add_metadata(_NAME, {"version": _VERSION, **about})
    for name, data in _attachments(recording).items():
        writer.add_attachment(began_ns, began_ns, name, "application/json", codec.to_json(data))
    channels = _Channels(writer, recording)
    for event in recording.events:
        at = began_ns + round(event.t * _NANO)
        channel, data = channels.of(event)
        writer.add_message(channel, at, data, at)
    writer.finish()  # type: ignore[no-untyped-call]
    stream.write(buffer.getbuffer())


def load(file: Path) -> Recording:
    """Read a recording back.

    Raises BadRecording if it is not a recording, OtherFormat if it is from another version, and StorageError
    if it cannot be read.
    """
    try:
        data = file.read_bytes()
    except OSError as error:
        raise StorageError(f"The recording {file} could not be read: {error.strerror}.") from error
    return read(data, file)


def read(data: bytes, file: Path | str) -> Recording:
    """Like `load`, but from the bytes of `file`."""
    try:
        records = tuple(_records(data))
        about = _about(records)
    except Exception as error:
        # The libraries below raise all kinds of errors when they parse a damaged file.
        raise BadRecording(f"{file}: {error}") from error
    try:
        return _unpacked(records, about)
    except Exception as error:  # the checksums match, so the file has another format
        raise OtherFormat(f"{file}: {type(error).__name__}: {error}") from error


def _attachments(recording: Recording) -> dict[str, Any]:
    return {
        "sources.json": recording.sources,
        "packages.json": recording.packages,
        "home.json": recording.looked_at,
        "recording.json": _Scene(recording.duration, recording.local),
    }


class _Scene(Struct):
    """What else is known about the scenario."""

    duration: float
    local: bool


class _Channels:
    """Registers a channel when an event first needs it."""

    def __init__(self, writer: Any, recording: Recording) -> None:
        self._writer = writer
        self._schemas = {
            name: writer.register_schema(name, _ROS, text.encode())
            for name, text in recording.definitions.items()
        }
        self._known: dict[tuple[str, str, bool], int] = {}
        self._events: int | None = None

    def of(self, event: Event) -> tuple[int, bytes]:
        """The channel for this event, and the event's bytes on it."""
        if isinstance(event, MessageSeen | MessageSent):
            return self._ros(event.topic, event.type, isinstance(event, MessageSent)), event.data
        if self._events is None:
            schema = self._writer.register_schema(_EVENT, _ROS, _EVENT_FIELDS.encode())
            self._events = self._writer.register_channel(EVENTS, "cdr", schema)
        return self._events, _text(codec.to_json(event))

    def _ros(self, topic: str, type_name: str, sent: bool) -> int:
        key = (topic, type_name, sent)
        if key not in self._known:
            about = {_NAME: "sent" if sent else "seen"}
            schema = self._schemas[type_name]
            self._known[key] = self._writer.register_channel(topic, "cdr", schema, about)
        return self._known[key]


def _text(text: bytes) -> bytes:
    """A message with one string field."""
    data = text + b"\0"
    return _CDR + struct.pack("<I", len(data)) + data


def _records(data: bytes) -> Iterator[Any]:
    """The file's records in order, all covered by checksums; without the index at the end."""
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
        raise ValueError("this is not a recording of the course")
    return about


def _unpacked(records: tuple[Any, ...], about: Mapping[str, str]) -> Recording:
    from mcap.records import Attachment, Schema

    if about["version"] not in ("1", _VERSION):
        raise ValueError(f"version {about['version']} of recordings is not known here")
    parts = {r.name: r.data for r in records if isinstance(r, Attachment)}
    scene = codec.from_json(parts["recording.json"], _Scene, "recording.json")
    schemas = [r for r in records if isinstance(r, Schema)]
    return Recording(
        exercise=about["exercise"],
        events=tuple(_events(records, {schema.id: schema.name for schema in schemas}, int(about["began"]))),
        definitions={schema.name: schema.data.decode() for schema in schemas if _is_ros(schema)},
        sources=codec.from_json(parts["sources.json"], Sources, "sources.json"),
        packages=codec.from_json(parts["packages.json"], BuiltPackages, "packages.json"),
        duration=scene.duration,
        looked_at=codec.from_json(parts["home.json"], tuple[HomeEntry, ...], "home.json"),
        local=scene.local,
        scenario=about.get("scenario", ""),  # older recordings have none
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
        # In older recordings they are JSON values.
        plain = message.data if channel.message_encoding == "json" else message.data[len(_CDR) + 4 : -1]
        plain = _OLD_DEADLINE.sub(rb'"deadline": 0.0', _OLD_BYTES.sub(rb"\1", plain))
        event: Event = codec.from_json(plain, AnyEvent, "an event")
        return event
    kind = MessageSent if channel.metadata.get(_NAME) == "sent" else MessageSeen
    return kind((message.log_time - began) / _NANO, channel.topic, types[channel.schema_id], message.data)
