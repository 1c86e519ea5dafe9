"""Sends values to the node that logs them; it does what sas::DataloggerClient does in C++."""

from __future__ import annotations

from array import array
from numbers import Real
from typing import Any

import numpy as np
from rclpy.node import Node
from sas_common import quiet_after_shutdown
from sas_msgs.msg import LogDatum


class DataloggerClient:
    """Publishes on /sas_datalogger/log. Values of one name become one variable of the file, in order."""

    def __init__(self, node: Node, queue_size: int = 100) -> None:
        self._node = node
        self._publisher = node.create_publisher(LogDatum, "/sas_datalogger/log", queue_size)

    def is_enabled(self, server_count: int = 1) -> bool:
        """Whether that many nodes log; what is logged before is lost."""
        return bool(self._publisher.get_subscription_count() >= server_count)

    def log(self, name: str, value: Any) -> None:
        """A string, a number, a list of numbers, or an array of numpy. Raise TypeError for anything else."""
        with quiet_after_shutdown(self._node):
            self._publisher.publish(LogDatum(name=name, **_fields(value)))


def _fields(value: Any) -> dict[str, Any]:
    """A vector of numpy is logged as a column, as by the real one; a list is logged as it is."""
    if isinstance(value, str):
        return {"strvalue": value}
    if isinstance(value, Real):
        return {"value": _doubles(np.array([value]))}
    matrix = np.asarray(value)
    if matrix.dtype.kind not in "biuf" or matrix.ndim not in (1, 2):
        raise TypeError(
            f"DataloggerClient: a string, a number, a vector or a matrix can be logged, not {value!r}."
        )
    if matrix.ndim == 1 and not isinstance(value, np.ndarray):
        return {"value": _doubles(matrix)}
    rows, columns = matrix.shape if matrix.ndim == 2 else (matrix.size, 1)
    return {"layout": [rows, columns], "value": _doubles(matrix.ravel())}


def _doubles(values: np.ndarray[Any, Any]) -> array[float]:
    return array("d", values.astype(np.float64).tobytes())
