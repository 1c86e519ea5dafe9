"""Numbers as messages, and back."""

from __future__ import annotations

from sas_msgs.msg import Float64


def double_to_std_msgs_float64(double: float) -> Float64:
    return Float64(data=double)


def std_msgs_float64_to_double(ros_float64: Float64) -> float:
    return float(ros_float64.data)
