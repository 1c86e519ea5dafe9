"""Chapters 18 and 19: publishers, subscribers, and looking at topics."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests.underlay.tutorial.room import Room
from tests.underlay.tutorial.terminal import Terminal, in_order

PACKAGE = "python_package_that_uses_the_messages"
PUBLISHER, SUBSCRIBER = "amazing_quote_publisher_node", "amazing_quote_subscriber_node"
TYPE = "package_with_interfaces/msg/AmazingQuote"
QUOTE = r"id: \d+\r\nquote: .+\r\nphilosopher_name: .+\r\n---\r\n"


@pytest.fixture
def publisher(room: Room) -> Terminal:
    """A window in which the publisher runs."""
    terminal = room.terminal()
    terminal.begin(f"ros2 run {PACKAGE} {PUBLISHER}")
    return terminal


def _once(terminal: Terminal, topic: str = "/amazing_quote") -> str:
    """One message, of a topic that may not be there yet."""
    return terminal.run(f"ros2 topic echo --once {topic} {TYPE}").text


def test_publisher_and_subscriber(room: Room) -> None:
    speaker, listener = room.terminal(), room.terminal()
    listener.begin(f"ros2 run {PACKAGE} {SUBSCRIBER}")
    speaker.begin(f"ros2 run {PACKAGE} {PUBLISHER}")
    listener.see(rf"\[{SUBSCRIBER}\]: ", rf"\[{SUBSCRIBER}\]: ", rf"\[{SUBSCRIBER}\]: ")
    assert "Traceback" not in speaker.ctrl_c(code=0)
    assert "Traceback" not in listener.ctrl_c(code=0)


def test_the_graph_with_both(room: Room, publisher: Terminal) -> None:
    listener, terminal = room.terminal(), room.terminal()
    listener.begin(f"ros2 run {PACKAGE} {SUBSCRIBER}")
    listener.see(SUBSCRIBER)
    assert terminal.run("ros2 node list").text == f"/{PUBLISHER}\n/{SUBSCRIBER}\n"
    assert terminal.run("ros2 topic list").text == "/amazing_quote\n/parameter_events\n/rosout\n"
    assert terminal.run("ros2 topic list -t").lines[0] == f"/amazing_quote [{TYPE}]"
    assert terminal.run("ros2 topic list -c").text == "3\n"
    assert in_order(
        terminal.run("ros2 topic list -v").text,
        f"Published topics:\n * /amazing_quote [{TYPE}] 1 publisher\n",
        f"\nSubscribed topics:\n * /amazing_quote [{TYPE}] 1 subscriber\n",
    )
    assert terminal.run("ros2 topic info /amazing_quote").text == (
        f"Type: {TYPE}\nPublisher count: 1\nSubscription count: 1\n"
    )
    assert in_order(
        terminal.run("ros2 topic info -v /amazing_quote").text,
        f"Type: {TYPE}\n\nPublisher count: 1\n\nNode name: {PUBLISHER}\nNode namespace: /\n",
        "Topic type hash: RIHS01_",
        "Endpoint type: PUBLISHER\n",
        "  Reliability: RELIABLE\n",
        f"\nSubscription count: 1\n\nNode name: {SUBSCRIBER}\n",
        "Endpoint type: SUBSCRIPTION\n",
    )
    assert in_order(
        terminal.run(f"ros2 node info /{SUBSCRIBER}").text,
        f"/{SUBSCRIBER}\n  Subscribers:\n    /amazing_quote: {TYPE}\n",
        "  Publishers:\n",
        "  Service Servers:\n",
        "  Action Clients:\n",
    )
    assert terminal.run("ros2 topic type /amazing_quote").text == f"{TYPE}\n"
    assert terminal.run(f"ros2 topic find {TYPE}").text == "/amazing_quote\n"
    publisher.ctrl_c(code=0)
    assert terminal.run("ros2 node list").text == f"/{SUBSCRIBER}\n"
    listener.ctrl_c(code=0)


def test_echo(room: Room, publisher: Terminal) -> None:
    terminal = room.terminal()
    _once(terminal)
    terminal.begin("ros2 topic echo /amazing_quote")
    terminal.see(QUOTE, QUOTE)
    assert terminal.ctrl_c(code=2).ends_at_ctrl_c
    assert re.fullmatch(r"\d+\n---\n", terminal.run("ros2 topic echo --once --field id /amazing_quote").text)
    answer = terminal.run("ros2 topic echo --once --field ide /amazing_quote", code=1)
    assert answer.text == "Invalid field 'ide': 'AmazingQuote' object has no attribute 'ide'\n"
    assert re.fullmatch(r"\d+,.+,.+\n", terminal.run("ros2 topic echo --once --csv /amazing_quote").text)
    publisher.ctrl_c(code=0)


def test_echo_into_pipes_and_files(room: Room, publisher: Terminal, tmp_path: Path) -> None:
    terminal, second = room.terminal(), room.terminal()
    terminal.run(f"cd {tmp_path}")
    _once(terminal)
    terminal.begin("ros2 topic echo /amazing_quote --field philosopher_name > heard.txt")
    second.begin("ros2 topic echo /amazing_quote | grep --line-buffered id:")
    second.see(r"id: \d+\r\n", r"id: \d+\r\n")
    second.ctrl_c(code=130)
    second.run(f"cd {tmp_path}")
    second.run("until [ $(grep -c -e --- heard.txt) -ge 2 ]; do sleep 0.1; done")
    assert terminal.ctrl_c(code=2).ends_at_ctrl_c
    assert in_order(terminal.run("cat heard.txt").text, "\n---\n", "\n---\n")
    head = terminal.run("ros2 topic echo /amazing_quote | head -n 4")
    assert in_order(head.text, "id: ", "\nquote: ", "\nphilosopher_name: ", "\n---\n")
    assert len(head.lines) == 4
    publisher.ctrl_c(code=0)


def test_rates(room: Room, publisher: Terminal) -> None:
    hz, bw, delay = room.terminal(), room.terminal(), room.terminal()
    _once(hz)
    hz.begin("ros2 topic hz /amazing_quote")
    bw.begin("ros2 topic bw /amazing_quote")
    assert delay.run("ros2 topic delay /amazing_quote", code=1).text == "msg does not have header\n"
    # Two a second: an average of many, as the first ones are of few.
    hz.see(r"average rate: (1\.[5-9]|2\.)\d*\r\n\tmin: [\d.]+s max: [\d.]+s std dev: [\d.]+s window: \d+\r\n")
    bw.see(
        r"Subscribed to \[/amazing_quote\]", r"\d+ B/s from \d+ messages\r\n\tMessage size mean: \d+ B min"
    )
    for terminal in (hz, bw):
        assert terminal.ctrl_c(code=2).ends_at_ctrl_c
    publisher.ctrl_c(code=0)


def test_pub(room: Room) -> None:
    listener, terminal = room.terminal(), room.terminal()
    listener.begin(f"ros2 run {PACKAGE} {SUBSCRIBER}")
    published = terminal.run(
        f"ros2 topic pub --once /amazing_quote {TYPE} '{{id: 1994, quote: Hello there}}'"
    )
    assert in_order(
        published.text,
        "publisher: beginning loop\n",
        "publishing #1: package_with_interfaces.msg.AmazingQuote"
        "(id=1994, quote='Hello there', philosopher_name='')\n",
    )
    listener.see("Hello there")
    terminal.begin(f"ros2 topic pub -r 10 /amazing_quote {TYPE} \"quote: 'Ten per second'\"")
    terminal.see("publishing #1: ", "publishing #2: ", "publishing #12: ")
    assert "Traceback" not in terminal.ctrl_c(code=2)
    listener.see("Ten per second")
    thrice = terminal.run(f"ros2 topic pub -t 3 -r 20 /amazing_quote {TYPE} '{{quote: Thrice}}'")
    assert in_order(thrice.text, "#1: ", "#2: ", "#3: ") and "#4" not in thrice
    listener.see("Thrice", "Thrice", "Thrice")
    listener.ctrl_c(code=0)


def test_pub_over_several_lines(room: Room) -> None:
    """As Tab fills it in: the prototype, line by line."""
    listener, terminal = room.terminal(), room.terminal()
    # Before anyone publishes, `echo` asks for best effort: then a message that comes too early is lost.
    listener.begin(f"ros2 topic echo --once --qos-reliability reliable /amazing_quote {TYPE}")
    terminal.press(f"ros2 topic pub --once /amazing_quote {TYPE} \"id: 5\rquote: 'It is late'\r")
    terminal.run('philosopher_name: Nobody"')
    assert listener.end().text == "id: 5\nquote: It is late\nphilosopher_name: Nobody\n---\n"


MISTYPED = {
    f"pub --once /amazing_quote {TYPE} '{{ide: 1}}'": "object has no attribute 'ide'",
    f"pub --once /amazing_quote {TYPE} '{{id: one}}'": "invalid literal for int() with base 10: 'one'",
    f"pub --once /amazing_quote {TYPE} 5": "The passed value needs to be a dictionary in YAML format",
    "pub --once /amazing_quote package_with_interfaces/msg/AmazingQuotes '{}'": "message type is invalid",
    "pub --once /amazing_quote package_with_interface/msg/AmazingQuote '{}'": "message type is invalid",
    "echo /amazing_quotes": "Could not determine the type for the passed topic",
    "info amazing_quote": "Unknown topic 'amazing_quote'",
    "type /amazing_quotes": "",
}


def test_mistyped(room: Room) -> None:
    listener, terminal = room.terminal(), room.terminal()
    listener.begin(f"ros2 topic echo /amazing_quote {TYPE}")
    for words, answer in MISTYPED.items():
        told = terminal.run(f"ros2 topic {words}", code=1)
        assert answer in told and "Traceback" not in told
    for words, answer in {
        "ech /amazing_quote": "invalid choice: 'ech'",
        "echo": "the following arguments are required: topic_name",
        "pub --once /amazing_quote": "the following arguments are required: message_type",
        "list --typ0": "unrecognized arguments: --typ0",
    }.items():
        assert answer in terminal.run(f"ros2 topic {words}", code=2)
    assert listener.ctrl_c(code=2).ends_at_ctrl_c


def test_waiting_commands_and_ctrl_c(room: Room) -> None:
    """Nobody publishes: everything that waits for that ends when it is told to."""
    terminal = room.terminal()
    for words, waits in {
        "hz /amazing_quote": r"WARNING: topic \[/amazing_quote\] does not appear to be published yet",
        "bw /amazing_quote": "WARNING",
        f"pub --once /amazing_quote {TYPE}": r"Waiting for at least 1 matching subscription",
    }.items():
        terminal.begin(f"ros2 topic {words}")
        terminal.see(waits)
        assert "Traceback" not in terminal.ctrl_c(code=2)


def test_a_topic_under_another_name(room: Room) -> None:
    speaker, terminal = room.terminal(), room.terminal()
    speaker.begin(f"ros2 run {PACKAGE} {PUBLISHER} --ros-args -r amazing_quote:=dull_quote -r __node:=dull")
    assert re.fullmatch(r"id: \d+\nquote: .+\nphilosopher_name: .+\n---\n", _once(terminal, "/dull_quote"))
    assert terminal.run("ros2 node list").text == "/dull\n"
    assert "/amazing_quote" not in terminal.run("ros2 topic list")
    speaker.ctrl_c(code=0)


def test_delay(room: Room) -> None:
    speaker, terminal = room.terminal(), room.terminal()
    speaker.begin(
        "ros2 topic pub -r 20 /here geometry_msgs/msg/PointStamped '{header: auto, point: {x: 1.5}}'"
    )
    terminal.begin("ros2 topic delay /here")
    terminal.see(r"average delay: [\d.]+\r\n\tmin: [\d.]+s max: [\d.]+s std dev: [\d.]+s window: \d+\r\n")
    for one in (terminal, speaker):
        assert one.ctrl_c(code=2).ends_at_ctrl_c


def test_what_was_published_before(room: Room) -> None:
    """A latched topic, and quotes in all languages."""
    speaker, terminal = room.terminal(), room.terminal()
    latched = "--qos-durability transient_local"
    speaker.begin(
        f"ros2 topic pub -w 0 {latched} -r 0.01 /amazing_quote {TYPE} '{{quote: \"«Ça va?» 日本\"}}'"
    )
    speaker.see("publishing #1")
    for qos in ("", f"{latched} --qos-reliability reliable "):
        heard = terminal.run(f"ros2 topic echo --once {qos}--field quote /amazing_quote")
        assert heard.text == "«Ça va?» 日本\n---\n"
    assert "  Durability: TRANSIENT_LOCAL\n" in terminal.run("ros2 topic info -v /amazing_quote")
    assert speaker.ctrl_c(code=2).ends_at_ctrl_c


def test_two_publishers_of_one_topic(room: Room, publisher: Terminal) -> None:
    second, terminal = room.terminal(), room.terminal()
    second.begin(f"ros2 run {PACKAGE} {PUBLISHER} --ros-args -r __ns:=/night -r /amazing_quote:=/late_quote")
    _once(terminal)
    _once(terminal, "/late_quote")
    assert terminal.run("ros2 node list").text == f"/{PUBLISHER}\n/night/{PUBLISHER}\n"
    second.ctrl_c(code=0)
    second.begin(f"ros2 topic pub -r 10 /amazing_quote {TYPE} '{{quote: Me too}}'")
    second.see("publishing #2")
    assert "Publisher count: 2\n" in terminal.run("ros2 topic info /amazing_quote")
    assert terminal.run("ros2 topic list -c").text == "3\n"
    second.ctrl_c(code=2)
    publisher.ctrl_c(code=0)
