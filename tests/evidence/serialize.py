"""Runs with ROS: prints messages as rclpy serializes them, with their fields, as JSON."""

import array
import json
import os
from pathlib import Path
from typing import Any

import numpy
from builtin_interfaces.msg import Duration, Time
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus, KeyValue
from geometry_msgs.msg import Point, PoseWithCovariance
from rcl_interfaces.msg import FloatingPointRange, Log, ParameterDescriptor, ParameterValue
from rclpy.serialization import serialize_message
from sensor_msgs.msg import CompressedImage, JointState
from std_msgs.msg import (
    Bool,
    Byte,
    ByteMultiArray,
    Char,
    Empty,
    Float32,
    Header,
    Int64,
    Int64MultiArray,
    MultiArrayDimension,
    MultiArrayLayout,
    String,
    UInt8MultiArray,
    UInt64,
)
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint
from type_description_interfaces.msg import FieldType, IndividualTypeDescription

from course.evidence.messages import full_definition

STAMP = Time(sec=-5, nanosec=999_999_999)
HEADER = Header(stamp=STAMP, frame_id="häufig")
MESSAGES = {
    "empty": Empty(),
    "text": String(data="hello"),
    "no text": String(),
    "unicode": String(data='çà et là, 日本語 ✓ \n\t"quotes"'),
    "true": Bool(data=True),
    "byte": Byte(data=b"\xfe"),
    "char": Char(data=200),
    "float": Float32(data=0.5),
    "negative": Int64(data=-(2**63)),
    "unsigned": UInt64(data=2**64 - 1),
    "point": Point(x=1.5, y=-2.25, z=1e300),
    "header": HEADER,
    "fixed array": PoseWithCovariance(covariance=[float(n) for n in range(36)]),
    "joints": JointState(
        header=HEADER, name=["a", "", "çà"], position=[0.1, 0.2, 0.3], velocity=[], effort=[1.0]
    ),
    "no joints": JointState(),
    "bytes": UInt8MultiArray(data=[0, 127, 255]),
    "byte array": ByteMultiArray(data=[b"\x00", b"\xff"]),
    "picture": CompressedImage(header=HEADER, format="png", data=bytes(range(256))),
    "nested": Int64MultiArray(
        layout=MultiArrayLayout(dim=[MultiArrayDimension(label="rows", size=2, stride=4)], data_offset=1),
        data=[1, -1],
    ),
    "deeply nested": JointTrajectory(
        joint_names=["a"],
        points=[
            JointTrajectoryPoint(positions=[1.0], time_from_start=Duration(sec=-1, nanosec=5)),
            JointTrajectoryPoint(),
        ],
    ),
    "constants": DiagnosticArray(
        status=[
            DiagnosticStatus(level=DiagnosticStatus.ERROR, name="arm", values=[KeyValue(key="k", value="v")])
        ]
    ),
    "log": Log(
        stamp=STAMP, level=Log.WARN, name="talker", msg="hello", file="f", function="g", line=2**32 - 1
    ),
    "defaults and bounded array": ParameterDescriptor(
        name="speed", floating_point_range=[FloatingPointRange(from_value=0.5, to_value=1.0)]
    ),
    "all arrays": ParameterValue(
        type=1,
        byte_array_value=[b"\x01"],
        bool_array_value=[True, False],
        integer_array_value=[1, -1],
        double_array_value=[0.5],
        string_array_value=["a", "b"],
    ),
    "bounded strings": IndividualTypeDescription(type_name="x" * 255),
    "field type": FieldType(type_id=1, capacity=2**63, string_capacity=3, nested_type_name="a/msg/B"),
}


def plain(value: Any) -> Any:
    if hasattr(value, "get_fields_and_field_types"):
        return {name: plain(getattr(value, name)) for name in value.get_fields_and_field_types()}
    if isinstance(value, numpy.ndarray):
        return value.tolist()
    if isinstance(value, bytes):
        return value[0]  # `byte` is bytes of length one
    if isinstance(value, list | tuple | array.array):
        return [plain(item) for item in value]
    return value


def type_of(message: Any) -> str:
    package, kind, *_ = type(message).__module__.split(".")
    return f"{package}/{kind}/{type(message).__name__}"


prefixes = [Path(part) for part in os.environ["AMENT_PREFIX_PATH"].split(os.pathsep)]
print(
    json.dumps(
        {
            name: {
                "type": type_of(message),
                "data": serialize_message(message).hex(),
                "definition": full_definition(type_of(message), prefixes),
                "fields": plain(message),
            }
            for name, message in MESSAGES.items()
        }
    )
)
