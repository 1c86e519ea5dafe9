"""Messages without rclpy: the text definition of a type, and CDR bytes back into fields.

Recordings keep messages as the bytes that came over the wire together with the type's text
definition, in the form that MCAP and rosbag2 use. So they can be judged again anywhere.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import Any

SEPARATOR = "=" * 80
_FIELD = re.compile(r"^\s*([A-Za-z][\w/]*)")
# mcap_ros2 reads it as signed; in ROS 2 it is a uint8.
_CHAR = re.compile(r"^(\s*)char(?=[\s\[])", re.MULTILINE)
_HALVES = re.compile(r"^---.*\n?", re.MULTILINE)
_PRIMITIVES = frozenset(
    "bool byte char float32 float64 int8 uint8 int16 uint16 int32 uint32 int64 uint64 string wstring".split()
)


class UnknownType(LookupError):
    """No definition of this message type is in any of the given prefixes."""


class Undecodable(ValueError):
    """The bytes do not hold a message of the type they were received as."""


def full_definition(type_name: str, prefixes: Iterable[Path]) -> str:
    """The definition of `pkg/msg/Type` with those of all types inside it, as rosbag2 writes it.

    `pkg/srv/Type_Request` and `pkg/srv/Type_Response` are the two halves of a service.

    Raises UnknownType when a definition is in none of the install prefixes.
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
    service, _, half = short.rpartition("_")
    name = f"{service}.srv" if kind == "srv" else f"{short}.msg"
    for prefix in prefixes:
        file = prefix / "share" / package / kind / name
        if file.is_file():
            text = file.read_text(encoding="utf-8")
            return _half(text, half) if kind == "srv" else text
    raise UnknownType(type_name)


def _half(service: str, which: str) -> str:
    """The request or the response out of a service's definition."""
    request, response = _HALVES.split(service, maxsplit=1)
    return request if which == "Request" else response


def _inner_types(definition: str, owner: str) -> list[str]:
    """Full names of the message types that fields of this definition have."""
    names = []
    for line in definition.splitlines():
        match = _FIELD.match(line.split("#", 1)[0])
        if match and match[1] not in _PRIMITIVES:
            names.append(_full_name(match[1], owner))
    return names


def _full_name(name: str, owner: str) -> str:
    package, _, short = name.rpartition("/")
    package = package.split("/")[0] or ("std_msgs" if short == "Header" else owner.split("/")[0])
    return f"{package}/msg/{short}"


class Decoder:
    """Turns CDR bytes into objects whose attributes are the message's fields.

    definitions: type name to text, as `full_definition` gives.
    """

    def __init__(self, definitions: Mapping[str, str]) -> None:
        self._definitions = definitions
        self._decoders: dict[str, Callable[[bytes], Any]] = {}

    def decode(self, type_name: str, data: bytes) -> Any:
        """Raises Undecodable when the bytes do not fit the type."""
        if type_name not in self._decoders:
            self._decoders[type_name] = _make_decoder(type_name, self._definitions[type_name])
        try:
            return self._decoders[type_name](_Whole(data))
        except Exception as error:  # the library raises whatever its parsing ran into
            raise Undecodable(f"{type_name}: {error}") from error


class _Whole(bytes):
    """Bytes that refuse a slice beyond their end, where a plain slice would quietly give less."""

    def __getitem__(self, key: Any) -> Any:
        if isinstance(key, slice) and key.stop > len(self):
            raise IndexError(f"{key.stop} bytes are needed, there are {len(self)}")
        return super().__getitem__(key)


def _make_decoder(type_name: str, definition: str) -> Callable[[bytes], Any]:
    # Imported late: only a recording with messages needs it.
    from mcap.records import Schema
    from mcap.well_known import MessageEncoding, SchemaEncoding
    from mcap_ros2.decoder import DecoderFactory

    plain = _CHAR.sub(r"\1uint8", definition)
    schema = Schema(id=1, name=type_name, encoding=SchemaEncoding.ROS2, data=plain.encode())
    decoder = DecoderFactory().decoder_for(MessageEncoding.CDR, schema)
    if decoder is None:
        raise UnknownType(type_name)
    return decoder
