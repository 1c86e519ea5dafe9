"""sas_msgs: messages that Python and C++ programs of the SmartArmStack exchange."""

from __future__ import annotations

import json

import pytest

from tests.underlay.sas.built import output_of
from tests.underlay.sas.place import python

pytestmark = pytest.mark.slow

MESSAGES = {
    "Bool": {"data": "boolean"},
    "Float64": {"data": "double"},
    "InformationFromMaster": {
        "header": "std_msgs/Header",
        "packet_version": "int32",
        "pose": "geometry_msgs/Pose",
        "twist": "geometry_msgs/Twist",
        "sender_ip": "string",
        "sender_port": "int32",
        "label": "string",
        "clutch": "boolean",
        "additional_keys": "sequence<boolean>",
        "motion_scaling": "double",
        "button": "double",
        "gripper": "double",
    },
    "InformationToMaster": {"header": "std_msgs/Header", "wrench": "geometry_msgs/Wrench"},
    "LogDatum": {
        "name": "string",
        "layout": "sequence<int32>",
        "value": "sequence<double>",
        "strvalue": "string",
    },
    "String": {"data": "string"},
    "WatchdogTrigger": {
        "header": "std_msgs/Header",
        "status": "boolean",
        "period_in_seconds": "double",
        "maximum_acceptable_delay_in_seconds": "double",
    },
}


def test_every_message_has_its_fields() -> None:
    assert json.loads(output_of(*python("messages.py"))) == MESSAGES
