"""Chapters 16, 17, 20 and 21: interfaces, services, and looking at them."""

from __future__ import annotations

import re

import pytest

from tests.underlay.tutorial.room import Room
from tests.underlay.tutorial.terminal import Terminal, in_order

INTERFACES = "package_with_interfaces"
QUOTE, POINT = f"{INTERFACES}/msg/AmazingQuote", f"{INTERFACES}/srv/WhatIsThePoint"
PACKAGE = "python_package_that_uses_the_services"
SERVER, CLIENT = "what_is_the_point_service_server", "what_is_the_point_service_client"
REQUEST = "'{quote: {id: 1979, quote: I wonder about life, philosopher_name: Deep Thought}}'"
ANSWER = (
    r"response:\r?\n.*WhatIsThePoint_Response\(point=geometry_msgs\.msg\.Point\(x=(\S+), y=(\S+), z=(\S+)\)\)"
)


@pytest.fixture
def server(room: Room) -> Terminal:
    """A window in which the server runs."""
    terminal = room.terminal()
    terminal.begin(f"ros2 run {PACKAGE} {SERVER}_node")
    return terminal


def test_interfaces_of_all_packages(room: Room) -> None:
    terminal = room.terminal()
    assert in_order(
        terminal.run("ros2 interface list").text,
        "Messages:\n",
        "    geometry_msgs/msg/Point\n",
        f"    {QUOTE}\n",
        "Services:\n",
        "    example_interfaces/srv/AddTwoInts\n",
        f"    {POINT}\n",
        "Actions:\n",
        "    example_interfaces/action/Fibonacci\n",
    )
    assert "srv/" not in terminal.run("ros2 interface list -m")
    packages = terminal.run("ros2 interface packages").lines
    assert packages == sorted(packages) and {"example_interfaces", "geometry_msgs", INTERFACES} <= {*packages}
    assert INTERFACES not in terminal.run("ros2 interface packages -a")
    assert terminal.run(f"ros2 interface package {INTERFACES}").text == f"{QUOTE}\n{POINT}\n"
    assert terminal.run("ros2 interface list | head -n 1").text == "Messages:\n"


def test_one_interface(room: Room) -> None:
    terminal = room.terminal()
    show = "ros2 interface show"
    assert in_order(
        terminal.run(f"{show} {QUOTE}").text, "int32 id\n", "string quote\n", "string philosopher_name\n"
    )
    assert in_order(
        terminal.run(f"{show} {POINT}").text,
        "AmazingQuote quote\n\tint32 id\n\tstring quote\n\tstring philosopher_name\n---\n",
        "geometry_msgs/Point point\n\tfloat64 x\n\tfloat64 y\n\tfloat64 z\n",
    )
    assert in_order(
        terminal.run(f"{show} example_interfaces/srv/AddTwoInts").text,
        "int64 a\nint64 b\n---\nint64 sum\n",
    )
    assert terminal.run(f"{show} --no-comments {QUOTE}").lines == [
        "int32 id",
        "string quote",
        "string philosopher_name",
    ]
    assert in_order(
        terminal.run(f"ros2 interface proto {QUOTE}").text,
        '"id: 0\n',
        "quote: ''\n",
        "philosopher_name: ''\n",
    )
    assert terminal.run(f"ros2 interface proto {POINT}").text.startswith('"quote:\n  id: 0\n')


def test_interfaces_mistyped(room: Room) -> None:
    terminal = room.terminal()
    for words, answer in {
        f"show {INTERFACES}/msg/AmazingQuotes": "Could not find the interface",
        "show package_with_interface/msg/AmazingQuote": "Unknown package 'package_with_interface'",
        f"show {INTERFACES}/AmazingQuote": "Expected three parts separated by '/'",
        "package package_with_interface": "Unknown package 'package_with_interface'",
        f"proto {INTERFACES}/msg/AmazingQuotes": "",
    }.items():
        told = terminal.run(f"ros2 interface {words}", code=1)
        assert answer in told and "Traceback" not in told
    assert "invalid choice: 'shwo'" in terminal.run("ros2 interface shwo", code=2)


def test_types_in_python(room: Room) -> None:
    terminal = room.terminal()
    for code, printed in {
        "from package_with_interfaces.msg import AmazingQuote; print(AmazingQuote(id=7))": (
            "package_with_interfaces.msg.AmazingQuote(id=7, quote='', philosopher_name='')\n"
        ),
        "from example_interfaces.srv import AddTwoInts; print(AddTwoInts.Request(a=1, b=2))": (
            "example_interfaces.srv.AddTwoInts_Request(a=1, b=2)\n"
        ),
    }.items():
        # Something may have to be built before, and says so.
        assert terminal.run(f'python3 -c "{code}"').text.endswith(printed)


def test_server_and_client(room: Room) -> None:
    server, client = room.terminal(), room.terminal()
    client.begin(f"ros2 run {PACKAGE} {CLIENT}_node")
    client.see(rf"\[{CLIENT}\]: ")  # that it waits
    server.begin(f"ros2 run {PACKAGE} {SERVER}_node")
    server.see(rf"\[{SERVER}\]: ", rf"\[{SERVER}\]: ")
    client.see(r"\d\.\d+\D+\d+\.\d+\D+\d+\.\d+", r"\d\.\d+\D+\d+\.\d+\D+\d+\.\d+")
    for terminal in (client, server):
        assert "Traceback" not in terminal.ctrl_c(code=0)


def test_service_call(room: Room, server: Terminal) -> None:
    terminal = room.terminal()
    called = terminal.run(f"ros2 service call /what_is_the_point {POINT} {REQUEST}")
    assert in_order(
        called.text,
        "requester: making request: package_with_interfaces.srv.WhatIsThePoint_Request(",
        "quote=package_with_interfaces.msg.AmazingQuote(id=1979, quote='I wonder about life', ",
        "philosopher_name='Deep Thought'))\n\nresponse:\n",
    )
    found = re.search(ANSWER, called.text)
    assert found and sum(map(float, found.groups())) == pytest.approx(42)
    assert re.search(ANSWER, terminal.run(f"ros2 service call /what_is_the_point {POINT}").text)
    server.see(rf"\[{SERVER}\]: ", rf"\[{SERVER}\]: ")
    terminal.begin(f"ros2 service call -r 5 /what_is_the_point {POINT} {REQUEST}")
    terminal.see(ANSWER, ANSWER, ANSWER)
    assert "Traceback" not in terminal.ctrl_c(code=2)
    server.ctrl_c(code=0)


def test_looking_at_services(room: Room, server: Terminal) -> None:
    terminal = room.terminal()
    terminal.run(f"ros2 service call /what_is_the_point {POINT}")
    listed = terminal.run("ros2 service list")
    assert listed.lines[0] == "/what_is_the_point" and f"/{SERVER}/get_parameters" in listed
    assert terminal.run("ros2 service list -t").lines[0] == f"/what_is_the_point [{POINT}]"
    assert terminal.run("ros2 service list --show-types").lines[0] == f"/what_is_the_point [{POINT}]"
    assert terminal.run("ros2 service type /what_is_the_point").text == f"{POINT}\n"
    assert terminal.run(f"ros2 service find {POINT}").text == "/what_is_the_point\n"
    assert terminal.run("ros2 service info /what_is_the_point").text == (
        f"Type: {POINT}\nClients count: 0\nServices count: 1\n"
    )
    assert f"    /what_is_the_point: {POINT}" in terminal.run(f"ros2 node info /{SERVER}")
    server.ctrl_c(code=0)
    assert "/what_is_the_point" not in terminal.run("ros2 service list")


def test_services_mistyped(room: Room, server: Terminal) -> None:
    terminal = room.terminal()
    terminal.run(f"ros2 service call /what_is_the_point {POINT}")
    for words, answer in {
        f"call /what_is_the_point {POINT} '{{quot: {{}}}}'": "object has no attribute 'quot'",
        f"call /what_is_the_point {POINT} '{{quote: {{id: one}}}}'": "invalid literal for int()",
        f"call /what_is_the_point {POINT} 5": "expected to be a dictionary",
        f"call /what_is_the_point {POINT}s '{{}}'": "The passed service type is invalid",
        f"call /what_is_the_point {POINT} '{{quote: ['": "",
        "info /what_is_the_points": "Unknown service '/what_is_the_points'",
        "type /what_is_the_points": "",
    }.items():
        told = terminal.run(f"ros2 service {words}", code=1)
        assert answer in told and "Traceback" not in told
    server.ctrl_c(code=0)


def test_a_call_that_nobody_answers(room: Room) -> None:
    terminal = room.terminal()
    terminal.begin(f"ros2 service call /what_is_the_point {POINT}")
    terminal.see(r"waiting for service to become available\.\.\.")
    assert terminal.ctrl_c(code=2).ends_at_ctrl_c


def test_add_two_ints(room: Room) -> None:
    server, terminal = room.terminal(), room.terminal()
    server.begin("ros2 run demo_nodes_py add_two_ints_server")
    called = terminal.run(
        "ros2 service call /add_two_ints example_interfaces/srv/AddTwoInts '{a: 19, b: 23}'"
    )
    assert in_order(
        called.text, "AddTwoInts_Request(a=19, b=23)\n\nresponse:\n", "AddTwoInts_Response(sum=42)\n"
    )
    server.ctrl_c(code=0)
