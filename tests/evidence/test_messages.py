"""Definitions as text, and bytes back into fields: the same fields that ROS itself reads."""

from __future__ import annotations

import random
import struct
import time
from operator import attrgetter
from pathlib import Path
from typing import Any

import pytest

from course.evidence.messages import SEPARATOR, Decoder, Undecodable, UnknownType, full_definition

from .conftest import Sample

SOON = 20.0
HEADER = b"\0\1\0\0"


def plain(value: Any) -> Any:
    if isinstance(value, bytes | list | tuple):
        return [plain(item) for item in value]
    if hasattr(value, "_type"):
        return {name: plain(getattr(value, name)) for name in value.__slots__}
    return value


def prefix(folder: Path, **definitions: str) -> Path:
    """An install prefix with message definitions: `talk__Word="string text"`."""
    for name, text in definitions.items():
        package, _, short = name.partition("__")
        file = folder / "share" / package / "msg" / f"{short}.msg"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
    return folder


def decode(definition: str, data: bytes) -> Any:
    return Decoder({"talk/msg/Word": definition}).decode("talk/msg/Word", HEADER + data)


# definitions


def test_a_definition_without_others(tmp_path: Path) -> None:
    found = full_definition("talk/msg/Word", [prefix(tmp_path, talk__Word="string text\n")])
    assert found == "string text\n"


def test_all_types_inside_follow_each_once(tmp_path: Path) -> None:
    root = prefix(
        tmp_path,
        talk__Talk="Word first\nWord[] more\nword/Other[<=3] others\nHeader header\n",
        talk__Word="string<=10 text\nword/msg/Other other\n",
        word__Other="int32[3] numbers\n",
        std_msgs__Header="builtin_interfaces/Time stamp\nstring frame_id\n",
        builtin_interfaces__Time="int32 sec\nuint32 nanosec\n",
    )
    own, *parts = full_definition("talk/msg/Talk", [root]).split(f"{SEPARATOR}\n")
    assert own.startswith("Word first")
    assert [part.splitlines()[0] for part in parts] == [
        "MSG: talk/Word",
        "MSG: word/Other",
        "MSG: std_msgs/Header",
        "MSG: builtin_interfaces/Time",
    ]


def test_constants_defaults_and_comments_name_no_types(tmp_path: Path) -> None:
    text = '# Comment\nint32 MOST=5\nstring NAME="a # b"\nint32 count 3\nwstring<=4 w\n \nbyte b # Type\n'
    assert full_definition("talk/msg/Word", [prefix(tmp_path, talk__Word=text)]) == text


def test_the_first_prefix_that_has_it_counts(tmp_path: Path) -> None:
    one, other = prefix(tmp_path / "1", talk__Word="int8 a"), prefix(tmp_path / "2", talk__Word="int8 b")
    assert full_definition("talk/msg/Word", [tmp_path / "0", one, other]) == "int8 a"


def test_both_halves_of_a_service(tmp_path: Path) -> None:
    root = prefix(tmp_path, talk__Word="string text\n")
    file = root / "share" / "talk" / "srv" / "Say.srv"
    file.parent.mkdir()
    file.write_text("Word word\nstring line  # --- no\n---\nbool heard\n")
    request = full_definition("talk/srv/Say_Request", [root])
    assert request.startswith("Word word\nstring line")
    assert f"{SEPARATOR}\nMSG: talk/Word\nstring text" in request
    assert "heard" not in request
    assert full_definition("talk/srv/Say_Response", [root]) == "bool heard\n"
    file.write_text("---\n")
    assert [full_definition(f"talk/srv/Say_{half}", [root]) for half in ("Request", "Response")] == ["", ""]


ACTION = "Word word\nint32 most\n---\nbool heard\n---\nint8 part\n"
UUID, TIME = "uint8[16] uuid\n", "int32 sec\nuint32 nanosec\n"


@pytest.mark.parametrize(
    ("part", "data", "field", "value"),
    [
        ("SendGoal_Request", bytes(16) + b"\2\0\0\0a\0\0\0\5\0\0\0", "goal.most", 5),
        ("SendGoal_Response", b"\1" + bytes(11), "accepted", True),
        ("GetResult_Response", b"\4\1", "result.heard", True),
        ("FeedbackMessage", bytes(16) + b"\7", "feedback.part", 7),
    ],
)
def test_an_action_is_made_of_services_and_a_topic(
    tmp_path: Path, part: str, data: bytes, field: str, value: object
) -> None:
    names = {"our_talk__Word": "string text\n", "builtin_interfaces__Time": TIME}
    root = prefix(tmp_path, unique_identifier_msgs__UUID=UUID, **names)
    (root / "share/our_talk/action").mkdir()
    (root / "share/our_talk/action/Say.action").write_text(ACTION)
    name = f"our_talk/action/Say_{part}"
    decoded = Decoder({name: full_definition(name, [root])}).decode(name, HEADER + data)
    assert attrgetter(field)(decoded) == value
    with pytest.raises(UnknownType):
        full_definition("our_talk/action/Say_Other", [root])


@pytest.mark.parametrize("missing", ["talk/msg/Word", "talk/msg/Other"])
def test_an_unknown_type_is_named(tmp_path: Path, missing: str) -> None:
    root = prefix(tmp_path, talk__Talk="Word w\n", talk__Word="Other o\n")
    if missing == "talk/msg/Word":
        (root / "share/talk/msg/Word.msg").unlink()
    with pytest.raises(UnknownType, match=missing):
        full_definition("talk/msg/Talk", [root])


# as ROS reads them


def test_every_message_is_read_as_ros_reads_it(samples: dict[str, Sample]) -> None:
    wrong = {}
    for name, sample in samples.items():
        found = plain(Decoder({sample.type: sample.definition}).decode(sample.type, sample.data))
        if found != sample.fields:
            wrong[name] = (found, sample.fields)
    assert wrong == {}
    assert len(samples) > 20


def test_one_decoder_serves_many_types(samples: dict[str, Sample]) -> None:
    decoder = Decoder({sample.type: sample.definition for sample in samples.values()})
    for name in ("text", "joints", "text"):
        sample = samples[name]
        assert plain(decoder.decode(sample.type, sample.data)) == sample.fields


def test_big_endian_is_read_too() -> None:
    message = Decoder({"talk/msg/Word": "int32 count"}).decode("talk/msg/Word", b"\0\0\0\0\0\0\0\5")
    assert message.count == 5


# what is not a message


def is_refused(decoder: Decoder, type_name: str, data: bytes) -> bool:
    """Whether it is Undecodable; any other exception passes through."""
    try:
        decoder.decode(type_name, data)
    except Undecodable as error:
        assert type_name in str(error)
        return True
    return False


def test_truncated_messages_are_refused(samples: dict[str, Sample]) -> None:
    """Only padding may be missing: then all fields are there."""
    began = time.monotonic()
    for sample in samples.values():
        decoder = Decoder({sample.type: sample.definition})
        cut = (sample.data[:length] for length in range(len(sample.data)))
        accepted = [data for data in cut if not is_refused(decoder, sample.type, data)]
        assert min(map(len, accepted), default=5) >= 5, sample.type
        assert all(plain(decoder.decode(sample.type, data)) == sample.fields for data in accepted)
    assert time.monotonic() - began < SOON


def test_random_bytes_raise_nothing_else(samples: dict[str, Sample]) -> None:
    """They do not take long either."""
    chance = random.Random(18)
    began = time.monotonic()
    refused = 0
    for sample in samples.values():
        decoder = Decoder({sample.type: sample.definition})
        for _ in range(40):
            data = bytearray(sample.data + chance.randbytes(4))
            for _ in range(chance.randint(1, 8)):
                data[chance.randrange(4, len(data))] = chance.choice((0, 1, 127, 128, 255))
            refused += is_refused(decoder, sample.type, bytes(data))
            is_refused(decoder, sample.type, HEADER + chance.randbytes(chance.randint(0, 200)))
    assert refused > 20
    assert time.monotonic() - began < SOON


@pytest.mark.parametrize(
    "definition",
    [
        "string text",
        "uint8[] data",
        "bool[] data",
        "int64[] data",
        "float64[] data",
        "string[] data",
        f"Empty[] data\n{SEPARATOR}\nMSG: talk/Empty\n",
        f"Bytes[] data\n{SEPARATOR}\nMSG: talk/Bytes\nuint8[] data",
    ],
)
@pytest.mark.parametrize("length", [0xFFFFFFFF, 0x7FFFFFFF, 1000])
def test_a_length_beyond_the_bytes_is_refused_at_once(definition: str, length: int) -> None:
    began = time.monotonic()
    with pytest.raises(Undecodable):
        decode(definition, struct.pack("<I", length) + bytes(40))
    assert time.monotonic() - began < SOON


@pytest.mark.parametrize("data", [b"", b"\0", b"\0\1\0"])
def test_less_than_a_header_is_refused(data: bytes) -> None:
    with pytest.raises(Undecodable):
        Decoder({"talk/msg/Word": "int8 a"}).decode("talk/msg/Word", data)


def test_text_that_is_not_utf8_is_refused() -> None:
    with pytest.raises(Undecodable):
        decode("string text", struct.pack("<I", 3) + b"\xff\xfe\0")


def test_wide_text_cannot_be_read() -> None:
    with pytest.raises(Undecodable):
        decode("wstring text", struct.pack("<I", 1) + b"\0\0\0\0")
