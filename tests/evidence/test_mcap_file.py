"""Recordings as files: loading returns what was saved, and a damaged file is never partly accepted."""

from __future__ import annotations

import errno
import json
from pathlib import Path
from typing import IO, Union

import pytest
from mcap.reader import make_reader
from mcap.writer import Writer
from mcap_ros2.decoder import DecoderFactory
from rosbags.highlevel import AnyReader

from course.errors import StorageError
from course.evidence.mcap_file import EVENTS, BadRecording, OtherFormat, _attachments, load, save
from course.evidence.recording import Recording
from course.model import codec, replace
from course.model.events import Event, Marked, MessageSeen, OutputLine

from .conftest import HELLO, NUMBER, STRING

BEGAN = 1_700_000_000_123_456_789


@pytest.fixture
def file(tmp_path: Path, recording: Recording) -> Path:
    file = tmp_path / "evidence" / "18-publisher.mcap"
    save(recording, file, began_ns=BEGAN)
    return file


def test_what_is_loaded_is_what_was_saved(file: Path, recording: Recording) -> None:
    assert load(file) == recording


def test_an_empty_recording(tmp_path: Path) -> None:
    save(Recording("x"), tmp_path / "x", began_ns=BEGAN)
    assert load(tmp_path / "x") == Recording("x")


def test_checks_see_the_same(file: Path, recording: Recording) -> None:
    loaded = load(file)
    for topic in ("/talk", "/other"):
        assert loaded.topic(topic).times == recording.topic(topic).times
        assert loaded.lost(topic) == recording.lost(topic)
        assert len(loaded.sent(topic)) == len(recording.sent(topic))
    assert loaded.messages("/talk")[0].data.data == "hello"
    assert loaded.messages("/other")[0].type == NUMBER
    assert loaded.process("talker") == recording.process("talker")
    assert loaded.seen_graph() == recording.seen_graph()
    assert loaded.kept("notes.txt") == "one\ntwo\n"


def test_many_events_keep_their_order(tmp_path: Path) -> None:
    events = tuple(
        MessageSeen(n // 3 / 1e9, f"/t{n % 2}", STRING, HELLO)
        if n % 3
        else OutputLine(n // 3 / 1e9, "p", str(n))
        for n in range(3000)
    )
    recording = Recording("x", events, {STRING: "string data"})
    save(recording, tmp_path / "x", began_ns=BEGAN)
    assert load(tmp_path / "x").events == events


def test_a_recording_is_saved_over_an_older_one(file: Path, recording: Recording) -> None:
    newer = replace(recording, exercise="18-subscriber")
    save(newer, file, began_ns=BEGAN)
    assert load(file) == newer
    assert list(file.parent.iterdir()) == [file]


# other readers


def test_the_library_s_own_reader_reads_it(file: Path) -> None:
    with file.open("rb") as stream:
        reader = make_reader(stream, validate_crcs=True, decoder_factories=[DecoderFactory()])
        header, summary = reader.get_header(), reader.get_summary()
        decoded = [
            (channel.topic, message.log_time, data.data)
            for _, channel, message, data in reader.iter_decoded_messages(topics=["/talk"])
        ]
    assert header.profile == "ros2"
    names = {schema.name for schema in summary.schemas.values()}
    assert names == {STRING, NUMBER, "a/msg/Unused", "ros2course/msg/Event"}
    assert decoded == [("/talk", BEGAN + 300_000_000, "hello")] * 2


def test_other_events_are_json_for_every_reader(file: Path) -> None:
    def refuse(name: str) -> None:
        raise AssertionError(f"{name} is no JSON")

    with file.open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        texts = [data.json for _, _, _, data in reader.iter_decoded_messages(topics=[EVENTS])]
    kinds = [json.loads(text, parse_constant=refuse)["kind"] for text in texts]
    assert kinds.count("GraphSeen") == 2


def test_rosbags_reads_all_of_it(file: Path) -> None:
    with AnyReader([file]) as reader:
        found = [
            (connection.topic, connection.msgtype, reader.deserialize(data, connection.msgtype))
            for connection, _, data in reader.messages()
            if data
        ]
    assert [message.data for topic, _, message in found if topic == "/talk"] == ["hello"] * 2
    told = [json.loads(message.json) for topic, _, message in found if topic == EVENTS]
    assert {"GraphSeen", "ProcessExited"} <= {event["kind"] for event in told}


def test_events_of_recordings_of_before_are_read(tmp_path: Path) -> None:
    """They were JSON, on a channel that says so."""
    event = OutputLine(0.5, "talker", "hello")
    with (tmp_path / "old.mcap").open("wb") as stream:
        writer = Writer(stream)
        writer.start(profile="ros2", library="ros2course")
        writer.add_metadata("ros2course", {"version": "1", "exercise": "x", "began": str(BEGAN)})
        for name, data in _attachments(Recording("x", duration=2.0)).items():
            writer.add_attachment(BEGAN, BEGAN, name, "application/json", codec.to_json(data))
        schema = writer.register_schema("ros2course.Event", "jsonschema", b'{"type": "object"}')
        channel = writer.register_channel(EVENTS, "json", schema)
        writer.add_message(channel, BEGAN, codec.to_json(event), BEGAN)
        writer.finish()
    assert load(tmp_path / "old.mcap") == Recording("x", (event,), duration=2.0)


def test_a_recording_of_version_1_is_read(recording: Recording) -> None:
    """The file is what the last release before version 2 wrote of this recording."""
    assert load(Path(__file__).with_name("version_1.mcap")) == recording


def test_what_we_sent_is_a_channel_of_its_own(file: Path) -> None:
    with file.open("rb") as stream:
        summary = make_reader(stream).get_summary()
    found = sorted((c.topic, c.metadata.get("ros2course")) for c in summary.channels.values())
    assert found == [("/other", "seen"), (EVENTS, None), ("/talk", "seen"), ("/talk", "sent")]


# damage


def damaged(file: Path, recording: Recording, data: bytes) -> bool:
    """Whether a file with these bytes is refused; it must not be loaded as another recording."""
    other = file.with_name("damaged")
    other.write_bytes(data)
    try:
        assert load(other) == recording
    except BadRecording as error:
        assert str(other) in str(error)
        assert not isinstance(error, OtherFormat)
        return True
    return False


def test_a_file_cut_short_is_refused(file: Path, recording: Recording) -> None:
    data = file.read_bytes()
    lengths = (*range(0, 50), *range(50, len(data), 53))
    cut = [damaged(file, recording, data[:length]) for length in lengths]
    assert sum(cut) > len(cut) / 2  # after the data comes an index, which is not needed


def test_a_changed_byte_is_noticed_or_does_not_matter(file: Path, recording: Recording) -> None:
    """Any of the file's roughly three thousand bytes."""
    data = file.read_bytes()
    noticed = 0
    for place in range(0, len(data), 11):
        changed = bytes([data[place] ^ (1 if place % 2 else 0xFF)])
        noticed += damaged(file, recording, data[:place] + changed + data[place + 1 :])
    assert noticed > 100


@pytest.mark.parametrize("content", [b"", b"x", b"not an mcap file at all" * 100, bytes(10_000)])
def test_another_file_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "x").write_bytes(content)
    with pytest.raises(BadRecording):
        load(tmp_path / "x")


def test_an_mcap_file_of_another_program_is_refused(tmp_path: Path) -> None:
    from mcap.writer import Writer

    with (tmp_path / "x").open("wb") as stream:
        writer = Writer(stream)
        writer.start("ros2", "another")
        writer.finish()
    with pytest.raises(BadRecording):
        load(tmp_path / "x")


def test_a_later_version_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with monkeypatch.context() as patch:
        patch.setattr("course.evidence.mcap_file._VERSION", "3")
        save(Recording("x"), tmp_path / "x", began_ns=BEGAN)
    with pytest.raises(OtherFormat, match="version 3"):
        load(tmp_path / "x")


def test_an_event_that_is_not_known_here_is_no_damage(
    file: Path, recording: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    others = [kind for kind in Event.__subclasses__() if kind is not Marked]
    monkeypatch.setattr("course.evidence.mcap_file.AnyEvent", Union[tuple(others)])  # noqa: UP007 - of a list
    with pytest.raises(OtherFormat, match="Marked"):
        load(file)


def test_a_recording_from_before_scenarios_were_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from mcap.writer import Writer

    def as_before(writer: Writer, name: str, data: dict[str, str]) -> None:
        add(writer, name, {key: value for key, value in data.items() if key != "scenario"})

    add = Writer.add_metadata
    monkeypatch.setattr(Writer, "add_metadata", as_before)
    save(Recording("x", scenario="abc"), tmp_path / "x", began_ns=BEGAN)
    assert load(tmp_path / "x") == Recording("x")


# storage


def test_a_full_disk_leaves_the_older_file_and_nothing_else(
    file: Path, recording: Recording, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(stream: IO[bytes], copy: IO[bytes]) -> None:
        copy.write(stream.read(100))
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("shutil.copyfileobj", full)
    with pytest.raises(StorageError, match="No space left on device"):
        save(replace(recording, exercise="other"), file, began_ns=BEGAN)
    monkeypatch.undo()
    assert list(file.parent.iterdir()) == [file]
    assert load(file) == recording


def test_a_folder_that_cannot_be_made_is_told(file: Path, recording: Recording) -> None:
    with pytest.raises(StorageError):
        save(recording, file / "below" / "x.mcap", began_ns=BEGAN)


def test_a_file_that_is_not_there_is_told(tmp_path: Path) -> None:
    with pytest.raises(StorageError, match="No such file"):
        load(tmp_path / "nothing.mcap")
