"""Messages without rclpy: the text definition of a type, and CDR bytes back into fields.

Recordings keep messages as the bytes that were received, together with the type's text definition, in the
form that MCAP and rosbag2 use. So they can be judged again anywhere.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

from course.errors import OurFault
from course.model.feedback import Failure, Feedback

SEPARATOR = "=" * 80
_FIELD = re.compile(r"^\s*([A-Za-z][\w/]*)")
# mcap_ros2 reads it as signed, but in ROS 2 it is a uint8.
_CHAR = re.compile(r"^(\s*)char(?=[\s\[])", re.MULTILINE)
_HALVES = re.compile(r"^---.*\n?", re.MULTILINE)
_SECTIONS = {"srv": ("Request", "Response"), "action": ("Goal", "Result", "Feedback")}
_WRAPPED = {
    "SendGoal_Request": "unique_identifier_msgs/UUID goal_id\n{}_Goal goal\n",
    "SendGoal_Response": "bool accepted\nbuiltin_interfaces/Time stamp\n",
    "GetResult_Request": "unique_identifier_msgs/UUID goal_id\n",
    "GetResult_Response": "int8 status\n{}_Result result\n",
    "FeedbackMessage": "unique_identifier_msgs/UUID goal_id\n{}_Feedback feedback\n",
}
_PRIMITIVES = frozenset(
    "bool byte char float32 float64 int8 uint8 int16 uint16 int32 uint32 int64 uint64 string wstring".split()
)


class UnknownType(LookupError):
    """None of the given prefixes has a definition of this message type."""


class Undecodable(ValueError):
    """The bytes are not a valid message of the type with which they were received."""


def full_definition(type_name: str, prefixes: Iterable[Path]) -> str:
    """The definition of `pkg/msg/Type` and of all types inside it, as rosbag2 writes it.

    `pkg/srv/Type_Request` and `pkg/srv/Type_Response` are the two halves of a service. An action is made of
    two services and a topic: `pkg/action/Type_SendGoal`, `Type_GetResult` and `Type_FeedbackMessage`.

    Raises UnknownType if a definition is in none of the install prefixes.
    """
    roots = tuple(prefixes)
    own = _read(type_name, roots)
    seen, waiting, parts = {type_name}, _inner_types(own, type_name), [own]
    while waiting:
        name = waiting.pop(0)
        if name in seen:
            continue
        seen.add(name)
        text = _read(name, roots)
        package, _, short = name.split("/")
        parts.append(f"{SEPARATOR}\nMSG: {package}/{short}\n{text}")
        waiting += _inner_types(text, name)
    return "\n".join(parts)


def _read(type_name: str, prefixes: tuple[Path, ...]) -> str:
    package, kind, short = type_name.split("/")
    name, _, part = (short, "", "") if kind == "msg" else short.partition("_")
    for prefix in prefixes:
        file = prefix / "share" / package / kind / f"{name}.{kind}"
        if file.is_file():
            text = file.read_text(encoding="utf-8")
            found = _part(text, kind, name, part) if part else text
            if found is not None:
                return found
    raise UnknownType(type_name)


def _part(definition: str, kind: str, name: str, part: str) -> str | None:
    """One section of a service or action definition, or what ROS wraps around those of an action."""
    sections = dict(zip(_SECTIONS[kind], _HALVES.split(definition), strict=False))
    wrapped = {part: text.format(name) for part, text in _WRAPPED.items()}
    return {**wrapped, **sections}.get(part)


def _inner_types(definition: str, owner: str) -> list[str]:
    """Full names of the message types used by the fields of this definition."""
    names = []
    for line in definition.splitlines():
        match = _FIELD.match(line.split("#", 1)[0])
        if match and match[1] not in _PRIMITIVES:
            names.append(_full_name(match[1], owner))
    return names


def _full_name(name: str, owner: str) -> str:
    package, _, short = name.rpartition("/")
    package = package.split("/")[0] or ("std_msgs" if short == "Header" else owner.split("/")[0])
    return f"{package}/{'action' if '_' in short else 'msg'}/{short}"


class Decoder:
    """Turns CDR bytes into objects whose attributes are the message's fields.

    definitions: type name to text, as `full_definition` returns it.
    """

    def __init__(self, definitions: Mapping[str, str]) -> None:
        self._definitions = definitions
        self._decoders: dict[str, Callable[[bytes], Any]] = {}

    def decode(self, type_name: str, data: bytes) -> Any:
        """Return the message. Raises Undecodable if the bytes do not match the type."""
        if type_name not in self._decoders:
            self._decoders[type_name] = _make_decoder(type_name, self._definitions[type_name])
        try:
            return self._decoders[type_name](_Whole(data))
        except Exception as error:  # the library raises all kinds of errors
            raise Undecodable(f"{type_name}: {error}") from error


class _Whole(bytes):
    """Bytes that refuse a slice beyond their end, where plain bytes would silently return less."""

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, slice) and key.stop > len(self):
            raise IndexError(f"{key.stop} bytes are needed, there are {len(self)}")
        return super().__getitem__(key)


def _make_decoder(type_name: str, definition: str) -> Callable[[bytes], Any]:
    # Imported late because only recordings with messages need it.
    from mcap.records import Schema
    from mcap.well_known import MessageEncoding, SchemaEncoding
    from mcap_ros2.decoder import DecoderFactory

    plain = _CHAR.sub(r"\1uint8", definition)
    package, slash, short = type_name.rpartition("/")
    name = f"{package}{slash}{short.replace('_', '')}"  # mcap_ros2 refuses `Say_SendGoal_Request`
    schema = Schema(id=1, name=name, encoding=SchemaEncoding.ROS2, data=plain.encode())
    decoder = DecoderFactory().decoder_for(MessageEncoding.CDR, schema)
    if decoder is None:
        raise UnknownType(type_name)
    return decoder


class Unreadable:
    """Replaces the fields of an unreadable message; reading one of them raises the learner's Failure.

    It is false, while a message is true. source: the topic or service that it came from.
    """

    def __init__(self, source: str, type_name: str, error: Undecodable) -> None:
        self._feedback = _feedback(source, type_name, error)

    def __bool__(self) -> bool:
        return False

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Unreadable) and other._feedback == self._feedback

    def __hash__(self) -> int:
        return hash(self._feedback)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):  # asked by Python itself, for example by copy
            raise AttributeError(name)
        raise Failure(self._feedback)


def decoded(source: str, type_name: str, data: bytes, decoder: Decoder) -> Any:
    """The message's fields as attributes, or an `Unreadable` if the bytes are not a message of that type.

    Raises OurFault for a type that our own decoder does not support.
    """
    try:
        return decoder.decode(type_name, data)
    except Undecodable as error:
        if isinstance(error.__cause__, NotImplementedError):
            raise OurFault(f"{type_name} cannot be decoded here: {error.__cause__}") from error
        return Unreadable(source, type_name, error)


def _feedback(source: str, type_name: str, error: Undecodable) -> Feedback:
    if isinstance(error.__cause__, UnicodeDecodeError):
        return Feedback(
            summary=f"A string in a message on `{source}` is not valid UTF-8, so no node can read it.",
            expected="text in UTF-8",
            seen=f"other bytes: {error.__cause__.reason}",
            advice="Put text into string fields unchanged: do not encode it or cut its bytes.",
        )
    return Feedback(
        summary=f"A message on `{source}` cannot be read as `{type_name}`.",
        expected=f"the fields of {type_name}, in order",
        seen=f"other bytes: {error}",
        advice=f"Does the program use a `{type_name}` with different fields? Build its package again.",
    )
