"""rosidl_runtime_py: messages as text and back, interfaces by name."""

from __future__ import annotations

import importlib
import math
import random
from collections.abc import Iterator
from typing import Any

import pytest
import yaml

from tests.underlay.runtime.command import PACKAGES

pytest.importorskip("rosidl_parser", reason="needs ROS 2 from pip")
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Point32, Polygon, PoseStamped, PoseWithCovariance
from sensor_msgs.msg import Image, JointState
from std_msgs.msg import Bool, Byte, ByteMultiArray, Empty, Float64, Header, Int32, String
from std_srvs.srv import SetBool


@pytest.fixture(scope="module")
def runtime() -> Iterator[Any]:
    """The underlay's package, whatever else is installed."""
    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.syspath_prepend(str(PACKAGES / "rosidl_runtime_py"))
        yield importlib.import_module("rosidl_runtime_py")


@pytest.fixture
def joints() -> JointState:
    return JointState(
        header=Header(stamp=Time(sec=1, nanosec=2), frame_id="base"),
        name=["a", "b"],
        position=[1.0, 2.5],
        velocity=[],
    )


# ------------------------------------------------------------------------------------------- to text


def test_yaml_of_nested_messages_and_arrays(runtime: Any, joints: JointState) -> None:
    assert runtime.message_to_yaml(joints) == (
        "header:\n  stamp:\n    sec: 1\n    nanosec: 2\n  frame_id: base\n"
        "name:\n- a\n- b\nposition:\n- 1.0\n- 2.5\nvelocity: []\neffort: []\n"
    )


def test_flow_style_concerns_arrays_only(runtime: Any, joints: JointState) -> None:
    text = runtime.message_to_yaml(joints, flow_style=True)
    assert text.endswith("  frame_id: base\nname: [a, b]\nposition: [1.0, 2.5]\nvelocity: []\neffort: []\n")
    polygon = Polygon(points=[Point32(x=1.0)])
    assert runtime.message_to_yaml(polygon, flow_style=True) == "points: [{x: 1.0, y: 0.0, z: 0.0}]\n"


def test_arrays_of_messages(runtime: Any) -> None:
    polygon = Polygon(points=[Point32(x=1.0), Point32(y=2.0)])
    text = "points:\n- x: 1.0\n  y: 0.0\n  z: 0.0\n- x: 0.0\n  y: 2.0\n  z: 0.0\n"
    assert runtime.message_to_yaml(polygon) == text


def test_without_arrays(runtime: Any, joints: JointState) -> None:
    text = runtime.message_to_yaml(joints, no_arr=True)
    assert (
        "name: '<sequence type: string, length: 2>'\nposition: '<sequence type: double, length: 2>'" in text
    )
    assert "'<array type: double[36]>'" in runtime.message_to_yaml(PoseWithCovariance(), no_arr=True)
    polygon = runtime.message_to_csv(Polygon(points=[Point32()]), no_arr=True)
    assert polygon == "<sequence type: geometry_msgs/Point32, length: 1>"


def test_without_strings(runtime: Any) -> None:
    assert runtime.message_to_yaml(String(data="hello"), no_str=True) == "data: '<string length: <5>>'\n"
    assert runtime.message_to_csv(String(data="hello"), no_str=True) == "<string length: <5>>"


def test_truncated(runtime: Any, joints: JointState) -> None:
    assert runtime.message_to_yaml(String(data="hello"), truncate_length=3) == "data: hel...\n"
    assert runtime.message_to_yaml(String(data="hello"), truncate_length=5) == "data: hello\n"
    assert "name:\n- a\n- '...'\nposition:\n- 1.0\n- '...'\n" in runtime.message_to_yaml(
        joints, truncate_length=1
    )
    assert runtime.message_to_csv(joints, truncate_length=1) == "1,2,b...,a,...,1.0,...,,"


def test_csv(runtime: Any, joints: JointState) -> None:
    assert runtime.message_to_csv(joints) == "1,2,base,a,b,1.0,2.5,,"
    assert runtime.message_to_csv(Bool(data=True)) == "True"


def test_numbers_of_numpy_and_arrays_become_plain(runtime: Any) -> None:
    image = Image(height=1, width=2, data=[1, 2])
    assert runtime.message_to_ordereddict(image)["data"] == [1, 2]
    covariance = runtime.message_to_ordereddict(PoseWithCovariance())["covariance"]
    assert covariance == [0.0] * 36
    assert type(covariance[0]) is float
    assert yaml.safe_load(runtime.message_to_yaml(PoseWithCovariance()))["covariance"] == covariance


def test_a_message_without_fields_and_a_byte(runtime: Any) -> None:
    assert runtime.message_to_yaml(Empty()) == "{}\n"
    assert runtime.message_to_yaml(Byte(data=b"\x05")) == 'data: "\\x05"\n'


@pytest.mark.parametrize(
    "text",
    ["", " ", "yes", "null", "1", "-", "a: b", "a #b", "a:", "é", "x\ny", "'", "*a", "{}", "~", "=", "1e5"],
)
def test_any_text_comes_back_from_yaml(text: str, runtime: Any) -> None:
    assert yaml.safe_load(runtime.message_to_yaml(String(data=text))) == {"data": text}


def test_the_quick_writer_agrees_with_the_full_one(runtime: Any) -> None:
    convert = importlib.import_module("rosidl_runtime_py.convert")
    plainly = importlib.import_module("rosidl_runtime_py.plain_yaml").dump_plainly
    dice, quick = random.Random(1), 0
    for _ in range(3000):
        data = _anything(dice)
        text = plainly(data)
        quick += text is not None
        assert text is None or text == convert._dump(data, flow_style=False)
    assert quick > 300


def test_the_quick_writer_is_used_for_the_usual(runtime: Any, joints: JointState) -> None:
    plainly = importlib.import_module("rosidl_runtime_py.plain_yaml").dump_plainly
    for message in (joints, PoseStamped(), String(data="Use the force, Pikachu!"), Float64(data=math.inf)):
        assert plainly(runtime.message_to_ordereddict(message)) is not None


def _anything(dice: random.Random) -> dict[str, Any]:
    letters = "aby rue:-_#'\"{}[],.!%&*|>@~=<01\n\té"
    text = "".join(dice.choice(letters) for _ in range(dice.randint(0, 5)))
    number = dice.choice([dice.uniform(-1, 1) * 10 ** dice.randint(-30, 30), 1e16, 1e22, math.nan, -math.inf])
    inner = {"y": number, "l": [{"x": 1, "m": [True]}, {"x": -2, "m": []}]}
    return {"t": dice.choice([text, "abc", "yes"]), "n": inner, "u": [number, dice.choice(["b", text])]}


# ----------------------------------------------------------------------------------------- from text


def test_nested_fields_are_set_and_the_others_kept(runtime: Any) -> None:
    pose = PoseStamped(header=Header(frame_id="base"))
    runtime.set_message_fields(pose, {"pose": {"position": {"x": 1}}, "header": {"stamp": {"sec": "3"}}})
    assert (pose.pose.position.x, pose.pose.orientation.w) == (1.0, 1.0)
    assert (pose.header.stamp.sec, pose.header.frame_id) == (3, "base")


def test_arrays_are_set(runtime: Any) -> None:
    polygon, joints, covariance, octets = Polygon(), JointState(), PoseWithCovariance(), ByteMultiArray()
    runtime.set_message_fields(polygon, {"points": [{"x": 1.0}, {"y": 2}]})
    runtime.set_message_fields(joints, {"name": ["a"], "position": [1, 2]})
    runtime.set_message_fields(covariance, {"covariance": [1.0] * 36})
    runtime.set_message_fields(octets, {"data": [1, "a"]})
    assert polygon.points == [Point32(x=1.0), Point32(y=2.0)]
    assert (joints.name, list(joints.position)) == (["a"], [1.0, 2.0])
    assert list(covariance.covariance) == [1.0] * 36
    assert octets.data == [b"\x01", b"a"]


def test_what_yaml_shows_can_be_set_again(runtime: Any, joints: JointState) -> None:
    for message in (joints, Byte(data=b"\xff"), Polygon(points=[Point32(z=3.0)]), String(data="é\n")):
        again = type(message)()
        runtime.set_message_fields(again, yaml.safe_load(runtime.message_to_yaml(message)))
        assert again == message


@pytest.mark.parametrize(
    ("message", "values", "kind", "text"),
    [
        (String, {"nosuch": 1}, AttributeError, "'String' object has no attribute 'nosuch'"),
        (String, {"SLOT_TYPES": 1}, AttributeError, "'String' object has no attribute 'SLOT_TYPES'"),
        (Int32, {"data": "hello"}, ValueError, "invalid literal for int() with base 10: 'hello'"),
        (Float64, {"data": "x"}, ValueError, "could not convert string to float: 'x'"),
        (String, 5, TypeError, "Value '5' is expected to be a dictionary but is a int"),
        (
            PoseStamped,
            {"pose": None},
            TypeError,
            "Value 'None' is expected to be a dictionary but is a NoneType",
        ),
        (Polygon, {"points": [7]}, TypeError, "Value '7' is expected to be a dictionary but is a int"),
        (PoseWithCovariance, {"covariance": [1]}, ValueError, "expected 36 values, got 1"),
    ],
)
def test_what_does_not_fit(message: Any, values: Any, kind: type[Exception], text: str, runtime: Any) -> None:
    with pytest.raises(kind) as caught:
        runtime.set_message_fields(message(), values)
    assert str(caught.value) == text


def test_stamps_are_set_when_the_time_has_come(runtime: Any) -> None:
    pose, header = PoseStamped(), Header()
    setters = runtime.set_message_fields(pose, {"header": "auto"}, expand_header_auto=True)
    setters += runtime.set_message_fields(header, {"stamp": "now"}, expand_time_now=True)
    for set_stamp in setters:
        set_stamp(Time(sec=7))
    assert (len(setters), pose.header.stamp.sec, header.stamp.sec) == (2, 7, 7)
    with pytest.raises(TypeError):
        runtime.set_message_fields(pose, {"header": "auto"})


# ------------------------------------------------------------------------------------------- by name


def test_classes_by_name(runtime: Any) -> None:
    utilities = importlib.import_module("rosidl_runtime_py.utilities")
    assert utilities.get_message("std_msgs/msg/String") is utilities.get_message("std_msgs/String") is String
    assert utilities.get_service("std_srvs/srv/SetBool") is utilities.get_interface("std_srvs/srv/SetBool")
    assert utilities.get_service("std_srvs/SetBool") is SetBool
    assert utilities.get_namespaced_type("std_msgs/msg/String").namespaces == ["std_msgs", "msg"]


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("std_srvs/srv/SetBool", ValueError),
        ("String", ValueError),
        ("", ValueError),
        ("a/b/c/d", ValueError),
        ("os/path/join", ValueError),
        ("nosuch/msg/Nosuch", ModuleNotFoundError),
        ("std_msgs/msg/Nosuch", AttributeError),
    ],
)
def test_names_of_no_message(name: str, kind: type[Exception], runtime: Any) -> None:
    with pytest.raises(kind):
        importlib.import_module("rosidl_runtime_py.utilities").get_message(name)


def test_the_function_wins_over_the_module_of_its_name(runtime: Any) -> None:
    importlib.import_module("rosidl_runtime_py.get_interfaces")
    assert callable(runtime.get_interfaces)
    assert {*runtime.__all__} <= {*dir(runtime)}
